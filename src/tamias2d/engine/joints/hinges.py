"""Which mechanisms are trees of hinges, and in which order their bodies hang on each other.

Cost: a visit to each joint, once as joints come or go.
"""

from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

from tamias2d.engine.joints.joint_row import JointRow
from tamias2d.engine.tables import KEPT

HINGE, ANGLE = "revolute", "angle"


class HingeTree(NamedTuple):
    """Bodies of a mechanism, each after the one on which it hangs."""

    bodies: list[int]
    """Their rows; the first is the root."""
    hinges: list[int | None]
    """Of each body the joint by which it hangs; None for a root that nothing ties."""
    joints: list[int]
    """These joints, further ties to what does not move, and laws in the order of the bodies."""


def hinge_tree(moving: Sequence[int], rows: Mapping[int, JointRow]) -> HingeTree | None:
    """Return the tree that hinges make of bodies that move; None if they make none, or others do.

    What ties a single body to what does not move may be of any kind, but no equation of its own;
    laws may govern the angles of hinges. The root is the first body that a hinge ties, if there is
    one.
    """
    around: dict[int, list[tuple[int, int]]] = {body: [] for body in moving}
    ties: list[tuple[int, int]] = []
    more: list[int] = []
    angles: set[frozenset[int]] = set()
    for k, row in rows.items():
        ends = [body for body in row.ends if body in around]
        hinge = row.kind == HINGE and row.law == KEPT
        if len(ends) == 1 and hinge:
            ties.append((k, ends[0]))
        elif len(ends) == 2 and hinge:
            one, other = ends
            around[one].append((k, other))
            around[other].append((k, one))
        elif row.program is None and (len(ends) == 1 or row.kind == ANGLE):
            more.append(k)
            angles |= {frozenset(ends)} if len(ends) == 2 else set()
        else:
            return None
    edges = [frozenset((one, other)) for one, found in around.items() for _, other in found]
    if len(edges) != 2 * (len(moving) - 1) or not angles <= set(edges):
        return None
    bodies, hinges = [ties[0][1] if ties else moving[0]], [ties[0][0] if ties else None]
    found = set(bodies)
    for body in bodies:
        for k, other in around[body]:
            if other not in found:
                found.add(other)
                bodies.append(other)
                hinges.append(k)
    if len(bodies) < len(moving):  # two hinges between two bodies, and none to another
        return None
    held = [k for k in hinges if k is not None]
    place: dict[int | None, int] = {body: k for k, body in enumerate(bodies)}
    more.sort(key=lambda k: max(place.get(body, 0) for body in rows[k].ends))
    return HingeTree(bodies, hinges, [*held, *(k for k, _ in ties[1:]), *more])


def is_net(rows: Iterable[JointRow]) -> bool:
    """Whether all joints are hinges that nothing governs."""
    return all(row.kind == HINGE and row.law == KEPT for row in rows)


def by_level(joints: Sequence[int], rows: Sequence[JointRow]) -> list[int]:
    """Return joints in an order that a sweep cannot tell from theirs, but that is faster.

    Each comes after those before it that share a body with it, and neighbours seldom share one.
    """
    level: dict[int, int] = {}
    found = []
    for k in joints:
        ends = [body for body in rows[k].ends if body is not None]
        own = 1 + max(level.get(body, 0) for body in ends)
        level.update(dict.fromkeys(ends, own))
        found.append((own, k))
    return [k for _, k in sorted(found, key=lambda each: each[0])]
