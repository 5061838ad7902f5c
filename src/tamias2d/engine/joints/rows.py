"""Joints as rows of the engine's arrays: which bodies they hold, and what governs them."""

from collections.abc import Iterator, Sequence
from itertools import chain, combinations

import numpy as np

from tamias2d.engine import tables as tb
from tamias2d.engine.arrays.store import Store
from tamias2d.engine.joints.elimination import Elimination
from tamias2d.engine.joints.equal_trees import equal_trees, rows_of, write_blocks_of
from tamias2d.engine.joints.grouping import (
    mechanisms_of,
    moving_bodies,
    pairs_of,
    plan_of,
    still_bodies,
    unconnected,
)
from tamias2d.engine.joints.hinges import HingeTree, by_level, hinge_tree, is_net
from tamias2d.engine.joints.joint_row import JointRow
from tamias2d.engine.joints.linearise import TURNED_TOGETHER
from tamias2d.engine.joints.program_tables import lengths_of_programs, write_programs
from tamias2d.spec.constraint import ENDS

CHOOSING = (
    tb.LOWER_LIMIT,
    tb.UPPER_LIMIT,
    tb.MOTOR,
)  # laws of which it is chosen whether they hold


def set_joints(store: Store, rows: Sequence[JointRow]) -> list[int]:
    """Let joints hold, and no others; return of each its place in the arrays."""
    mechanisms = mechanisms_of(store, rows)
    nodes = [moving_bodies(store, [rows[k] for k in mechanism]) for mechanism in mechanisms]
    trees = [
        hinge_tree(own, {k: rows[k] for k in mechanism})
        for own, mechanism in zip(nodes, mechanisms, strict=True)
    ]
    for n, tree in enumerate(trees):
        if tree:
            nodes[n], mechanisms[n] = tree.bodies, tree.joints
    still = still_bodies(store, rows)
    member = {body: 1 + k for k, body in enumerate([*chain(*nodes), *still])}
    numbered = [[member[body] - 1 for body in own] for own in nodes]
    plans = [
        unconnected(own) if tree else plan_of(store, own, [rows[k] for k in mechanism], member)
        for own, mechanism, tree in zip(numbered, mechanisms, trees, strict=True)
    ]
    blocks = equal_trees(trees, rows)
    edges = sum(len(plan.edges) for plan in plans)
    fill = sum(map(len, (own for plan in plans for own in plan.fill)))
    apart = sorted({pair for row in rows if row.apart for pair in pairs_of(row)})
    store.resize(
        joints=len(rows),
        joined=len(member) + 1 if rows else 0,
        turned=len(member) + 1 + TURNED_TOGETHER if rows else 0,
        mechanisms=len(mechanisms) + 1,
        joint_sparse=max(len(member), edges, fill, len(plans)) + 2 if rows else 0,
        tree_blocks=len(blocks) + 1,
        tree_rows=rows_of(blocks),
        **lengths_of_programs(rows),
        apart=len(apart),
        apart_bodies=max((low for low, _ in apart), default=-1) + 2,
    )
    joints = store.world.joints
    joints.counts[:] = 0
    joints.counts[[tb.JOINTS, tb.MECHANISMS]] = len(rows), len(mechanisms)
    told = sum(store.world.state.kind[body] == tb.KINEMATIC for body in still)
    joints.counts[tb.FIRST_KINEMATIC] = len(member) + 1 - told
    joints.mechanisms[:] = 0
    joints.mechanisms[1:, tb.M_JOINT] = np.cumsum([len(own) for own in mechanisms])
    joints.sparse[: len(nodes) + 1, tb.I_NODE] = np.cumsum([0, *map(len, nodes)]) if rows else 0
    if rows:
        joints.members[1:, tb.JOINED_BODY] = list(member)
    _write_plans(store, plans)
    places = _write_joints(store, rows, mechanisms, plans, trees, member)
    for first, second in _targets(rows):
        pair = places[first], places[second]
        joints.joints[pair, tb.J_PAIR] = places[second], tb.OF_PAIR
    write_programs(joints, rows, places)
    _write_trees(store, rows, trees, member, places)
    write_blocks_of(store, blocks)
    joints.apart[:] = [high for _, high in apart]
    lows = [low for low, _ in apart]
    joints.apart_first[:] = np.searchsorted(lows, np.arange(len(joints.apart_first)))
    store.world.touching.counts[[tb.ARRANGED, tb.ISLANDS_KNOWN]] = 0
    return places


def _targets(rows: Sequence[JointRow]) -> Iterator[tuple[int, int]]:
    """Yield both rows of each target whose spring has a maximum; equal ones are interchangeable."""
    found: dict[tuple[object, ...], tuple[list[int], list[int]]] = {}
    for k, row in enumerate(rows):
        if row.bounded and row.across is not None:
            anchors = (row.given[:2], row.given[4:6])
            along, across = found.setdefault((row.ends, anchors, row.numbers), ([], []))
            (across if row.across else along).append(k)
    for along, across in found.values():
        yield from zip(along, across, strict=True)


def kept_apart(store: Store) -> set[tuple[int, int]]:
    """Return the pairs of bodies that joints keep from touching, the lower row first."""
    joints = store.world.joints
    lows = np.repeat(np.arange(len(joints.apart_first) - 1), np.diff(joints.apart_first))
    return set(zip(lows.tolist(), joints.apart.tolist(), strict=True))


def _write_plans(store: Store, plans: Sequence[Elimination]) -> None:
    sparse = store.world.joints.sparse
    pivot = edge = fill = 0
    for plan in plans:
        for node, own, degree in zip(plan.order, plan.fill, plan.degree, strict=True):
            sparse[pivot, [tb.PIVOT_NODE, tb.PIVOT_FIRST, tb.PIVOT_COUNT]] = node, fill, degree
            sparse[fill : fill + len(own), tb.FILL] = np.array(own, dtype=np.int64) + edge
            pivot, fill = pivot + 1, fill + len(own)
        for pair, number in plan.edges.items():
            sparse[edge + number, [tb.E_NODE_A, tb.E_NODE_B]] = pair
        edge += len(plan.edges)


def _write_joints(
    store: Store,
    rows: Sequence[JointRow],
    mechanisms: Sequence[Sequence[int]],
    plans: Sequence[Elimination],
    trees: Sequence[HingeTree | None],
    member: dict[int, int],
) -> list[int]:
    """Write joints mechanism by mechanism; return the place of each."""
    joints, kind = store.world.joints, store.world.state.kind
    joints.numbers[:] = 0.0
    places = [0] * len(rows)
    j = first_edge = 0
    for n, (mechanism, plan) in enumerate(zip(mechanisms, plans, strict=True)):
        meshed = not plan.edges and len(plan.order) > 1 and trees[n] is None
        net = meshed and is_net(rows[k] for k in mechanism)
        joints.mechanisms[n, tb.M_HINGED] = trees[n] is not None or net
        joints.mechanisms[n, tb.M_MESHED] = meshed
        for k in by_level(mechanism, rows) if net else mechanism:
            row = rows[k]
            joints.joints[j, [tb.J_KIND, tb.J_ROWS]] = row.number, row.row_count
            joints.joints[j, [tb.J_EQUATION, tb.J_PAIR]] = -1, tb.NO_PAIR
            joints.numbers[j, tb.J_EXERTED] = 1.0
            own = [0 if body is None else member[body] for body in row.ends]
            nodes = [
                tb.UNUSED
                if end not in row.bodies
                else tb.NOT_PUSHED
                if body is None or kind[body] != tb.DYNAMIC
                else member[body] - 1
                for end, body in zip(ENDS, row.ends, strict=True)
            ]
            joints.mechanisms[n, tb.M_TIED] |= tb.NOT_PUSHED in nodes or row.bound
            held = [body for body in row.ends if body is not None]
            joints.mechanisms[n, tb.M_CARRIED] |= (kind[held] == tb.KINEMATIC).any()
            joints.mechanisms[n, tb.M_DRIVEN] |= row.driven
            joints.mechanisms[n, tb.M_TIMED] |= row.timed
            joints.mechanisms[n, tb.M_TURNED_BY_MOTOR] |= row.turned
            joints.mechanisms[n, tb.M_GOVERNED] |= row.governed
            joints.mechanisms[n, tb.M_FIRM] |= row.firm
            joints.mechanisms[n, tb.M_CHOOSING] |= row.law in CHOOSING or row.bounded
            joints.mechanisms[n, tb.M_BOUNCING] |= row.numbers[tb.LAW_RESTITUTION] > 0.0
            joints.joints[j, [tb.J_LAW, tb.J_STATE]] = row.law, tb.HOLDS
            joints.laws[j] = row.numbers
            joints.joints[j, tb.J_MEMBER : tb.J_MEMBER + 3] = own
            joints.joints[j, tb.J_NODE : tb.J_NODE + 3] = nodes
            joints.joints[j, tb.J_EDGE : tb.J_EDGE + 3] = [
                _edge(plan, one, other, first_edge) for one, other in combinations(nodes, 2)
            ]
            joints.given[j] = 0.0
            joints.given[j, : len(row.given)] = row.given
            places[k] = j
            j += 1
        first_edge += len(plan.edges)
    return places


def _write_trees(
    store: Store,
    rows: Sequence[JointRow],
    trees: Sequence[HingeTree | None],
    member: dict[int, int],
    places: Sequence[int],
) -> None:
    """Write on what each node of a tree of hinges hangs, and where."""
    joints = store.world.joints
    joints.hinges[:] = joints.links[:] = joints.net_nodes[:] = 0.0
    joints.members[:, tb.JOINED_ABOVE], joints.members[:, tb.JOINED_HINGE] = 0, -1
    for tree in trees:
        for body, hinge in zip(tree.bodies, tree.hinges, strict=True) if tree else ():
            if hinge is not None:
                m, (a, b, _) = member[body], rows[hinge].ends
                above, own, far = (a, 2, 0) if body == b else (b, 0, 2)
                joints.members[m, tb.JOINED_ABOVE] = 0 if above is None else member[above]
                joints.members[m, tb.JOINED_HINGE] = places[hinge]
                joints.hinges[m, tb.H_ANCHOR : tb.H_ANCHOR + 2] = rows[hinge].given[own : own + 2]
                joints.hinges[m, tb.H_FAR_ANCHOR : tb.H_FAR_ANCHOR + 2] = rows[hinge].given[
                    far : far + 2
                ]
                joints.hinges[m, tb.H_SIDE] = 1.0 if body == b else -1.0


def _edge(plan: Elimination, one: int, other: int, first: int) -> int:
    """Return the number of the edge between two nodes, or -1."""
    found = plan.edges.get((one, other), plan.edges.get((other, one), -1))
    return found if found < 0 else first + found
