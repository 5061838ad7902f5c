"""Two bodies rebound in one point: IM3, IM9 with friction.

It is what `tamias2d.contact` does where a pair alone approaches, operation by operation.
"""

from math import inf

from tamias2d.event_driven import tables as tb
from tamias2d.event_driven.kinds import is_pushed
from tamias2d.event_driven.laws import friction_of
from tamias2d.event_driven.length import hypot
from tamias2d.event_driven.tables import Moving, Pair, Point, World
from tamias2d.generated import friction, impact
from tamias2d.kernels.assembled import inlined

MOST_IMPULSES = 32  # of one pair at one instant


def arms(
    a: Moving, b: Moving, point: Point, swapped: int, i: int, j: int, world: World
) -> tuple[Pair, Pair]:
    """Return the arms of both bodies to where they touch, m."""
    p, q = (b, a) if swapped == 1 else (a, b)
    ux, uy, wx, wy, _, _ = point
    radius = world.bodies[i, tb.ROUNDING] if swapped == 1 else world.bodies[j, tb.ROUNDING]
    arm_q = (wx - radius * ux, wy - radius * uy)
    arm_p = (arm_q[0] + (q[0] - p[0]), arm_q[1] + (q[1] - p[1]))
    return (arm_q, arm_p) if swapped == 1 else (arm_p, arm_q)


def speed_of(a: Moving, b: Moving, arm_a: Pair, arm_b: Pair) -> float:
    """Return the size of the terms that make up the velocity of a contact, m/s."""
    return (
        hypot(a[3], a[4])
        + hypot(b[3], b[4])
        + abs(a[5]) * hypot(arm_a[0], arm_a[1])
        + abs(b[5]) * hypot(arm_b[0], arm_b[1])
    )


@inlined
def rebound(
    a: Moving,
    b: Moving,
    arm_a: Pair,
    arm_b: Pair,
    normal: Pair,
    noise: float,
    restitution: float,
    i: int,
    j: int,
    world: World,
) -> tuple[Moving, Moving, float]:
    """Return both states after the impulses of an impact, and the normal velocity, m/s."""
    rough = friction_of(i, j, world) > 0.0
    rate = normal_velocity(a, b, arm_a, arm_b, normal)
    for _ in range(MOST_IMPULSES):
        if rate >= -noise:
            break
        if rough:
            after_a, after_b, impulse = after_friction(
                a, b, arm_a, arm_b, normal, rate, restitution, i, j, world
            )
        else:
            after_a, after_b, impulse = after_impulse(
                a, b, arm_a, arm_b, normal, rate, restitution, i, j, world
            )
        note_impact(i, j, normal, impulse, rate, world)
        a, b = after_a, after_b
        rate = normal_velocity(a, b, arm_a, arm_b, normal)
    return a, b, rate


def normal_velocity(a: Moving, b: Moving, arm_a: Pair, arm_b: Pair, normal: Pair) -> float:
    """Return how fast a contact opens, m/s."""
    return float(
        impact.normal_velocity((a[3], a[4]), a[5], arm_a, (b[3], b[4]), b[5], arm_b, normal)
    )


@inlined
def inverses(k: int, world: World) -> Pair:
    """Return the inverses of the mass, 1/kg, and of the inertia, 1/(kg m^2), of a body."""
    return world.bodies[k, tb.INVERSE_MASS], world.bodies[k, tb.INVERSE_INERTIA]


@inlined
def smooth_impulse(
    arm_a: Pair,
    arm_b: Pair,
    normal: Pair,
    rate: float,
    restitution: float,
    i: int,
    j: int,
    world: World,
) -> tuple[float, float]:
    """Return the impulse without friction, N s (IM3), and the inverse effective mass, 1/kg."""
    mass_a, turn_a = inverses(i, world)
    mass_b, turn_b = inverses(j, world)
    inverse = impact.inverse_effective_mass(mass_a, turn_a, arm_a, mass_b, turn_b, arm_b, normal)
    return max(impact.impulse(restitution, rate, inverse), 0.0), inverse


@inlined
def after_impulse(
    a: Moving,
    b: Moving,
    arm_a: Pair,
    arm_b: Pair,
    normal: Pair,
    rate: float,
    restitution: float,
    i: int,
    j: int,
    world: World,
) -> tuple[Moving, Moving, float]:
    """Return both states after an impulse without friction, and its size, N s (IM3)."""
    mass_a, turn_a = inverses(i, world)
    mass_b, turn_b = inverses(j, world)
    impulse, _ = smooth_impulse(arm_a, arm_b, normal, rate, restitution, i, j, world)
    if is_pushed(i, world):
        u, v = impact.velocity_a_after((a[3], a[4]), impulse, normal, mass_a)
        spin = impact.angular_velocity_a_after(a[5], impulse, arm_a, normal, turn_a)
        a = (a[0], a[1], a[2], u, v, spin)
    if is_pushed(j, world):
        u, v = impact.velocity_b_after((b[3], b[4]), impulse, normal, mass_b)
        spin = impact.angular_velocity_b_after(b[5], impulse, arm_b, normal, turn_b)
        b = (b[0], b[1], b[2], u, v, spin)
    return a, b, impulse


@inlined
def after_friction(
    a: Moving,
    b: Moving,
    arm_a: Pair,
    arm_b: Pair,
    normal: Pair,
    rate: float,
    restitution: float,
    i: int,
    j: int,
    world: World,
) -> tuple[Moving, Moving, float]:
    """Return both states after an impulse with friction, and its normal part, N s (IM9)."""
    mass_a, turn_a = inverses(i, world)
    mass_b, turn_b = inverses(j, world)
    impulse, inverse = smooth_impulse(arm_a, arm_b, normal, rate, restitution, i, j, world)
    cross = friction.cross_coupling(turn_a, arm_a, turn_b, arm_b, normal)
    sliding = friction.inverse_sliding_mass(mass_a, turn_a, arm_a, mass_b, turn_b, arm_b, inverse)
    slip = friction.tangential_velocity(
        (a[3], a[4]), a[5], arm_a, (b[3], b[4]), b[5], arm_b, normal
    )
    closest = friction.tangential_velocity_closest(slip, cross, rate, inverse)
    sticking = friction.sticking_impulse(closest, sliding)
    change = friction.normal_change(cross, sticking, inverse)
    share = friction.share(friction_of(i, j, world), impulse, sticking, change)
    along = friction.normal_impulse(impulse, share, change)
    vector = friction.impulse_vector(along, friction.tangential_impulse(share, sticking), normal)
    if is_pushed(i, world):
        u, v = friction.velocity_a_after((a[3], a[4]), mass_a, vector)
        a = (a[0], a[1], a[2], u, v, friction.angular_velocity_a_after(a[5], turn_a, arm_a, vector))
    if is_pushed(j, world):
        u, v = friction.velocity_b_after((b[3], b[4]), mass_b, vector)
        b = (b[0], b[1], b[2], u, v, friction.angular_velocity_b_after(b[5], turn_b, arm_b, vector))
    return a, b, along


@inlined
def note_impact(i: int, j: int, normal: Pair, impulse: float, rate: float, world: World) -> None:
    """Record an impulse, but for where it acts."""
    row = world.impacts[world.counts[tb.IMPACTS]]
    world.counts[tb.IMPACTS] += 1
    row[tb.TIME], row[tb.A], row[tb.B] = world.numbers[tb.NOW], i, j
    row[tb.ALONG_X], row[tb.ALONG_Y] = normal
    row[tb.IMPULSE], row[tb.NORMAL_VELOCITY] = impulse, rate


def reach(k: int, world: World) -> float:
    """Return the radius of a body, m; of a half-plane it is infinite."""
    return inf if world.kinds[k] == tb.PLANE else world.bodies[k, tb.RADIUS]
