"""Manifolds kept while two bodies hardly move against each other: their gaps alone change.

Normal and points are those of the pose in which they were found. The gaps follow the motion of the
surfaces at the points, to first order. Source: Catto, Box2D v3 (2026), contact recycling.
"""

from tamias2d.engine import tables as tb
from tamias2d.generated.soft_contact import row_velocity, turning_arm
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array

NEVER = 1e308  # m: a way for which no manifold is kept


@inlined
def note_pose(
    x: float, y: float, angle_a: float, angle_b: float, way: float, manifold: Array
) -> None:
    """Note the pose for which the gaps of a manifold hold; B is at (x, y) from A, m."""
    manifold[tb.KNOWN_X], manifold[tb.KNOWN_Y] = x, y
    manifold[tb.KNOWN_ANGLE_A], manifold[tb.KNOWN_ANGLE_B] = angle_a, angle_b
    manifold[tb.KNOWN_WAY] = way


@inlined
def move_gaps(
    x: float,
    y: float,
    angle_a: float,
    angle_b: float,
    radii: float,
    most: float,
    manifold: Array,
) -> bool:
    """Let the gaps of two points follow their bodies; return whether the manifold may be kept.

    It may while surfaces within `radii`, m, of both centres have moved by less than `most`, m,
    since it was found.
    """
    dx, dy = x - manifold[tb.KNOWN_X], y - manifold[tb.KNOWN_Y]
    turn_a, turn_b = angle_a - manifold[tb.KNOWN_ANGLE_A], angle_b - manifold[tb.KNOWN_ANGLE_B]
    way = manifold[tb.KNOWN_WAY] + abs(dx) + abs(dy) + (abs(turn_a) + abs(turn_b)) * radii
    if not way <= most or manifold[tb.FORESEEN] != 0.0:
        return False
    normal = (manifold[tb.NX], manifold[tb.NY])
    for at in (0, tb.POINT):
        px, py = manifold[tb.PX + at], manifold[tb.PY + at]
        arm_a = turning_arm((px, py), normal)
        arm_b = turning_arm((px - x, py - y), normal)
        manifold[tb.GAP + at] += row_velocity(
            (0.0, 0.0), turn_a, arm_a, (dx, dy), turn_b, arm_b, normal
        )
    note_pose(x, y, angle_a, angle_b, way, manifold)
    return True
