"""How joints form mechanisms: which of them are connected through bodies that move freely."""

from collections.abc import Iterable, Sequence
from itertools import combinations

from tamias2d.engine import tables as tb
from tamias2d.engine.arrays.store import Store
from tamias2d.engine.joints.elimination import Elimination, eliminated
from tamias2d.engine.joints.joint_row import JointRow

LOOPED, FEW = 24, 1000  # entries of the fill list, for each joint and besides: more is a mesh


def mechanisms_of(store: Store, rows: Sequence[JointRow]) -> list[list[int]]:
    """Return the joints of each mechanism by their places, in the order of their first ones."""
    kind = store.world.state.kind
    of_body: dict[int, list[int]] = {}
    for k, row in enumerate(rows):
        moving = [body for body in row.ends if body is not None and kind[body] == tb.DYNAMIC]
        joined = {id(own): own for body in moving if (own := of_body.get(body)) is not None}
        first, *others = joined.values() or [[]]
        for other in others:
            first += other
            of_body.update((body, first) for body, own in of_body.items() if own is other)
        first.append(k)
        of_body.update((body, first) for body in moving)
    found = {id(own): sorted(own) for own in of_body.values()}
    return sorted(found.values())


def moving_bodies(store: Store, rows: Iterable[JointRow]) -> list[int]:
    """Return the bodies that move, in the order in which joints name them."""
    bodies = (body for row in rows for body in row.ends if body is not None)
    return [body for body in dict.fromkeys(bodies) if store.world.state.kind[body] == tb.DYNAMIC]


def still_bodies(store: Store, rows: Iterable[JointRow]) -> list[int]:
    """Return the bodies that joints hold, and that nothing pushes: static ones, then kinematic."""
    bodies = dict.fromkeys(body for row in rows for body in row.ends if body is not None)
    kind = store.world.state.kind
    return [body for own in (tb.STATIC, tb.KINEMATIC) for body in bodies if kind[body] == own]


def _pairs(
    store: Store, rows: Iterable[JointRow], member: dict[int, int]
) -> Iterable[tuple[int, int]]:
    """Yield the pairs of nodes that joints connect."""
    for row in rows:
        moving = [b for b in row.ends if b is not None and store.world.state.kind[b] == tb.DYNAMIC]
        yield from combinations([member[body] - 1 for body in moving], 2)


def pairs_of(row: JointRow) -> Iterable[tuple[int, int]]:
    """Return the pairs of bodies of a joint, the lower row first."""
    return combinations(sorted(body for body in row.ends if body is not None), 2)


def plan_of(
    store: Store, nodes: list[int], rows: Sequence[JointRow], member: dict[int, int]
) -> Elimination:
    """Return how a mechanism is eliminated; a mesh is not, and its plan has no edges."""
    found = eliminated(nodes, _pairs(store, rows, member), LOOPED * len(rows) + FEW)
    return found or unconnected(nodes)


def unconnected(nodes: list[int]) -> Elimination:
    """Return nodes in their order, without edges."""
    return Elimination(nodes, {}, [[] for _ in nodes], [0] * len(nodes))
