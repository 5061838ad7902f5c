"""Which mechanisms are trees of hinges, and in which order their bodies hang on each other.

Cost: a visit to each joint, once as joints come or go.
"""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from tamias2d.engine.joints.joint_row import JointRow
from tamias2d.engine.tables import KEPT

HINGE = "revolute"


class HingeTree(NamedTuple):
    """Bodies of a mechanism, each after the one on which it hangs."""

    bodies: list[int]
    """Their rows; the first is the root."""
    hinges: list[int | None]
    """Of each body the joint by which it hangs; None for a root that nothing ties."""
    joints: list[int]
    """These joints, and then the further ties to what does not move."""


def hinge_tree(moving: Sequence[int], rows: Mapping[int, JointRow]) -> HingeTree | None:
    """Return the tree that hinges make of bodies that move; None if they make none, or others do.

    Its root is the first body that is tied to what does not move, if there is one.
    """
    if any(row.kind != HINGE or row.law != KEPT for row in rows.values()):
        return None
    around: dict[int, list[tuple[int, int]]] = {body: [] for body in moving}
    ties: list[tuple[int, int]] = []
    for k, row in rows.items():
        ends = [body for body in row.ends if body in around]
        if len(ends) == 1:
            ties.append((k, ends[0]))
        else:
            one, other = ends
            around[one].append((k, other))
            around[other].append((k, one))
    if len(rows) - len(ties) != len(moving) - 1:
        return None
    bodies, hinges = [ties[0][1] if ties else moving[0]], [ties[0][0] if ties else None]
    found = set(bodies)
    for body in bodies:
        for k, other in around[body]:
            if other not in found:
                found.add(other)
                bodies.append(other)
                hinges.append(k)
    held = [k for k in hinges if k is not None]
    return HingeTree(bodies, hinges, held + [k for k, _ in ties[1:]])
