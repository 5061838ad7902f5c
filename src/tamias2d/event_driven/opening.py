"""How the gap of a touching pair accelerates."""

from tamias2d.event_driven.departure import pull_on
from tamias2d.event_driven.tables import Moving, Pair, Point, World
from tamias2d.generated import friction, rest
from tamias2d.kernels.assembled import inlined


@inlined
def pressing(arm_a: Pair, arm_b: Pair, normal: Pair, i: int, j: int, world: World) -> float:
    """Return the normal acceleration of a contact under the loads alone, m/s^2 (DD19)."""
    on_a, on_b = pull_on(i, world), pull_on(j, world)
    return float(
        rest.normal_acceleration(
            (on_a[0], on_a[1]), on_a[2], arm_a, (on_b[0], on_b[1]), on_b[2], arm_b, normal
        )
    )


@inlined
def opening_acceleration(on_points: float, p: Moving, q: Moving, point: Point, sided: int) -> float:
    """Return the second derivative of a gap of which the points accelerate, m/s^2 (GD15)."""
    ux, uy, wx, wy, vx, vy = point
    u, w, v = (ux, uy), (wx, wy), (vx, vy)
    distance = ux * (q[0] - p[0] + wx - vx) + uy * (q[1] - p[1] + wy - vy)
    slip = friction.tangential_velocity((p[3], p[4]), p[5], v, (q[3], q[4]), q[5], w, u)
    if sided == 1:
        return float(rest.gap_acceleration_side(on_points, p[5], q[5], w, u, slip, distance))
    if distance == 0.0:
        slip, distance = 0.0, 1.0
    return float(rest.gap_acceleration_corner(on_points, p[5], v, q[5], w, u, slip, distance))
