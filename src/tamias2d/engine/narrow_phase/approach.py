"""How fast the points of a contact come together, and whether they meet in a part of a step."""

from tamias2d.engine import tables as tb
from tamias2d.engine.tables import Bodies, Contacts, Control
from tamias2d.generated.soft_contact import row_velocity, turning_arm
from tamias2d.state import Array

GRAZE = 2.0**-12  # the overlap of bodies that have just met


def will_meet(
    p: int,
    i: int,
    j: int,
    count: int,
    smaller: float,
    control: Control,
    bodies: Bodies,
    contacts: Contacts,
) -> bool:
    """Return whether two bodies that are apart meet in this part, faster than gravity lets them."""
    manifold, time = contacts.manifolds[p], control.progress[tb.PART_TIME]
    seen = time + time / control.counts[tb.PART_SUBSTEPS]  # relaxing looks a substep ahead
    pull = 0.0
    if bodies.kind[i] != bodies.kind[j]:
        pull = time * (abs(control.settings[tb.GRAVITY_X]) + abs(control.settings[tb.GRAVITY_Y]))
    meets = False
    for n in range(count):
        gap = manifold[tb.GAP + n * tb.POINT]
        if gap <= -GRAZE * smaller:
            return False
        speed = opening_speed(n, i, j, bodies, manifold)
        meets = meets | ((speed < -2.0 * pull) & (gap + (speed - pull) * seen < 0.0))
    return bool(meets)


def goes_slowly(margin: float, i: int, j: int, bodies: Bodies) -> bool:
    """Return whether bodies go less far in a part than the thinner one is thick.

    Those that have parted and meet again are left to the solver then, else to the search on paths.
    """
    return bool(
        margin <= min(bodies.properties[i, tb.MIN_EXTENT], bodies.properties[j, tb.MIN_EXTENT])
    )


def opening_speed(n: int, i: int, j: int, bodies: Bodies, manifold: Array) -> float:
    """Return how fast the gap of a point opens, m/s."""
    return opening(n, i, j, tb.VX, bodies, manifold)


def opening(n: int, i: int, j: int, first: int, bodies: Bodies, manifold: Array) -> float:
    """Return how fast the gap of a point opens, m/s; or how far, m, where `first` is `DX`."""
    x, y = manifold[tb.PX + n * tb.POINT], manifold[tb.PY + n * tb.POINT]
    span_x, span_y = (
        bodies.pose[j, tb.X] - bodies.pose[i, tb.X],
        bodies.pose[j, tb.Y] - bodies.pose[i, tb.Y],
    )
    normal, a, b = (manifold[tb.NX], manifold[tb.NY]), bodies.motion[i], bodies.motion[j]
    return row_velocity(
        (a[first], a[first + 1]), a[first + 2], turning_arm((x, y), normal),
        (b[first], b[first + 1]), b[first + 2],
        turning_arm((x - span_x, y - span_y), normal), normal,
    )  # fmt: skip
