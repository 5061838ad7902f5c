"""Damping: free islands with too much energy come nearer to moving as one (IM11).

What contacts pushed comes nearer to its rigid motion, with its momentum and angular momentum; so
does a mechanism to the motion of what ties it. Cost: some visits to each body.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.energy.step_energy import GRACE, can_be_turned, mass_and_inertia
from tamias2d.engine.energy.support import FREE, LEAST_SHARE, SUPPORTED_BY_MORE
from tamias2d.engine.joined import or_joined
from tamias2d.engine.tables import Bodies, Constraints, Islands, Touching
from tamias2d.generated.definitions import (
    angular_momentum,
    kinetic_energy,
    momentum,
    point_velocity,
)
from tamias2d.generated.island_energy import (
    angular_velocity_damped,
    angular_velocity_island,
    damped_share,
    inertia_island,
    inertia_origin,
    mass_moment,
    position_island,
    velocity_damped,
    velocity_island,
    velocity_seen,
)
from tamias2d.state import Array, Vector

ROUNDED_TURN = 2.0**-80  # of the energy of a change of velocities: a turn by rounding has less


def choose_islands_to_damp(islands: Islands) -> bool:
    """Choose the islands that still have too much energy; return whether there are any."""
    some = False
    for n in range(islands.counts[tb.ROOTS]):
        row = islands.energy[islands.roots[n]]
        bounded = row[tb.SUPPORT] != SUPPORTED_BY_MORE
        much = bounded and row[tb.ENERGY_KEPT] > row[tb.ENERGY_BOUND] * (1.0 + GRACE)
        row[tb.DAMPED_SHARE] = 0.0 if much else 1.0
        some = some or much
    return some


def sum_island_motions(
    bodies: Bodies, touching: Touching, constraints: Constraints, islands: Islands
) -> None:
    """Find the rigid motion of the chosen islands, and how far they are damped.

    What contacts have not pushed or turned counts where there is too much energy without it.
    """
    for n in range(islands.counts[tb.ROOTS]):
        begin_motion(0.0, islands.energy[islands.roots[n]])
    add_motions_of(0.0, bodies, touching, constraints, islands)
    some = False
    for n in range(islands.counts[tb.ROOTS]):
        row = islands.energy[islands.roots[n]]
        chosen = row[tb.DAMPED_SHARE] != 1.0 and row[tb.SUPPORT] == FREE
        if chosen and energy_as_one(row) > row[tb.ENERGY_BOUND]:
            begin_motion(1.0, row)
            some = True
    if some:
        add_motions_of(1.0, bodies, touching, constraints, islands)
    for n in range(islands.counts[tb.ROOTS]):
        row = islands.energy[islands.roots[n]]
        if row[tb.DAMPED_SHARE] != 1.0 and row[tb.SUPPORT] == FREE:
            find_rigid_motion(row)


def begin_motion(all_count: float, row: Array) -> None:
    """Begin with no body in the motion of an island as one, and with nothing apart from it."""
    row[tb.ALL_COUNT], row[tb.ENERGY_APART] = all_count, 0.0
    for at in range(tb.ISLAND_MASS, tb.MOMENT_OF_INERTIA + 1):
        row[at] = 0.0


def add_motions_of(
    all_count: float,
    bodies: Bodies,
    touching: Touching,
    constraints: Constraints,
    islands: Islands,
) -> None:
    """Add the motions of all bodies to those of islands in which all count, or do not."""
    for k in range(constraints.counts[tb.ACTIVE]):
        i = touching.active[k]
        root = islands.links[i, tb.ROOT]
        if is_damped(i, bodies, islands) and islands.energy[root, tb.ALL_COUNT] == all_count:
            sum_body_motion(i, root, bodies, islands)


def is_damped(i: int, bodies: Bodies, islands: Islands) -> bool:
    """Return whether a body is of a free island that has too much energy."""
    row = islands.energy[islands.links[i, tb.ROOT]]
    free = row[tb.DAMPED_SHARE] != 1.0 and row[tb.SUPPORT] == FREE
    return bool(bodies.kind[i] == tb.DYNAMIC and free)


def sum_body_motion(i: int, root: int, bodies: Bodies, islands: Islands) -> None:
    """Add mass, momentum and moments of a body to those of its island, as seen from the root.

    What contacts have not pushed is apart from it, and so is a spin that they have not changed.
    """
    row = islands.energy[root]
    mass, inertia = mass_and_inertia(i, bodies.properties)
    now, place = bodies.motion[i], place_from(root, i, bodies)
    velocity = velocity_seen((now[tb.VX], now[tb.VY]), (row[tb.REFERENCE], row[tb.REFERENCE + 1]))
    if not is_pushed(i, row, bodies):
        row[tb.ENERGY_APART] += kinetic_energy(mass, velocity, inertia, now[tb.SPIN])
        return
    if row[tb.ALL_COUNT] == 0.0 and not spin_is_changed(i, bodies, islands):
        row[tb.ENERGY_APART] += kinetic_energy(mass, (0.0, 0.0), inertia, now[tb.SPIN])
        inertia = 0.0
    add_to_island(mass, inertia, place, velocity, now[tb.SPIN], row)


def is_pushed(i: int, row: Array, bodies: Bodies) -> bool:
    """Return whether contacts have pushed a body of an island, or all of it counts."""
    return bool(bodies.moved[i] == tb.MOVED or row[tb.ALL_COUNT] == 1.0)


def spin_is_changed(i: int, bodies: Bodies, islands: Islands) -> bool:
    """Return whether the spin of a body has been changed, as far as is known."""
    turned = islands.held[i] != 0 or more_than_rounding(i, bodies, islands.energy[i])
    turned = or_joined(turned, i, bodies)
    return bool(turned)


def more_than_rounding(i: int, bodies: Bodies, given: Array) -> bool:
    """Return whether contacts have turned a body: smooth discs are turned by rounding alone."""
    mass, inertia = mass_and_inertia(i, bodies.properties)
    velocity = (given[tb.VELOCITY_GIVEN], given[tb.VELOCITY_GIVEN + 1])
    turning = kinetic_energy(mass, (0.0, 0.0), inertia, given[tb.ANGULAR_VELOCITY_GIVEN])
    return bool(turning > ROUNDED_TURN * kinetic_energy(mass, velocity, 0.0, 0.0))


def add_to_island(
    mass: float, inertia: float, place: Vector, velocity: Vector, spin: float, row: Array
) -> None:
    """Add mass, momentum and moments of a body to those of its island.

    Its place, m, and velocity, m/s, are as seen from the root; its mass in kg, its inertia in
    kg m^2.
    """
    along, moment = momentum(mass, velocity), mass_moment(mass, place)
    row[tb.ISLAND_MASS] += mass
    row[tb.MOMENTUM_X] += along[0]
    row[tb.MOMENTUM_Y] += along[1]
    row[tb.ANGULAR_MOMENTUM] += angular_momentum(mass, place, velocity, inertia, spin)
    row[tb.MOMENT_X] += moment[0]
    row[tb.MOMENT_Y] += moment[1]
    row[tb.MOMENT_OF_INERTIA] += inertia_origin(mass, place, inertia)


def find_rigid_motion(row: Array) -> None:
    """Make the rigid motion of an island its reference; write the factor of all other motion."""
    least = 0.0
    if row[tb.SUPPORT] == FREE:
        place, velocity, spin = motion_of_all(row)
        least = energy_as_one(row)
        by_x, by_y = point_velocity(velocity, spin, (-place[0], -place[1]))
        row[tb.REFERENCE] += by_x
        row[tb.REFERENCE + 1] += by_y
        row[tb.REFERENCE + 2] = spin
    row[tb.DAMPED_SHARE], row[tb.ENERGY_LEAST] = 0.0, least
    left = min(row[tb.ENERGY_BOUND], row[tb.ENERGY_KEPT]) - least
    if left > LEAST_SHARE * row[tb.ENERGY_KEPT]:
        row[tb.DAMPED_SHARE] = damped_share(row[tb.ENERGY_KEPT], row[tb.ENERGY_BOUND], least)


def motion_of_all(row: Array) -> tuple[Vector, Vector, float]:
    """Return place, m, velocity, m/s, and spin, rad/s, of an island as one."""
    mass = row[tb.ISLAND_MASS]
    if not mass > 0.0:
        return (0.0, 0.0), (0.0, 0.0), 0.0
    place = position_island((row[tb.MOMENT_X], row[tb.MOMENT_Y]), mass)
    velocity = velocity_island((row[tb.MOMENTUM_X], row[tb.MOMENTUM_Y]), mass)
    inertia = inertia_island(row[tb.MOMENT_OF_INERTIA], mass, place)
    spin = 0.0
    if inertia > 0.0:
        spin = angular_velocity_island(row[tb.ANGULAR_MOMENTUM], mass, place, velocity, inertia)
    return place, velocity, spin


def energy_as_one(row: Array) -> float:
    """Return the kinetic energy of an island as one, and of what is apart from it, J."""
    place, velocity, spin = motion_of_all(row)
    mass = row[tb.ISLAND_MASS]
    inertia = inertia_island(row[tb.MOMENT_OF_INERTIA], mass, place) if spin != 0.0 else 0.0
    return kinetic_energy(mass, velocity, inertia, spin) + row[tb.ENERGY_APART]


def damp_islands(
    bodies: Bodies, touching: Touching, constraints: Constraints, islands: Islands
) -> None:
    """Scale the motion of what contacts pushed in free islands relative to their motion as one."""
    for k in range(constraints.counts[tb.ACTIVE]):
        i = touching.active[k]
        root = islands.links[i, tb.ROOT]
        row = islands.energy[root]
        if is_damped(i, bodies, islands) and is_pushed(i, row, bodies):
            spin, share, now = row[tb.REFERENCE + 2], row[tb.DAMPED_SHARE], bodies.motion[i]
            velocity = (row[tb.REFERENCE], row[tb.REFERENCE + 1])
            velocity = point_velocity(velocity, spin, place_from(root, i, bodies))
            now[tb.VX], now[tb.VY] = velocity_damped((now[tb.VX], now[tb.VY]), velocity, share)
            turned = row[tb.ALL_COUNT] == 1.0 or spin_is_changed(i, bodies, islands)
            if turned and can_be_turned(i, bodies.properties):
                now[tb.SPIN] = angular_velocity_damped(now[tb.SPIN], spin, share)


def place_from(root: int, i: int, bodies: Bodies) -> Vector:
    """Return where a body is from another one at the end of the step, m."""
    pose, now = bodies.pose[i], bodies.motion[i]
    origin, moved = bodies.pose[root], bodies.motion[root]
    x, y = pose[tb.X] - origin[tb.X], pose[tb.Y] - origin[tb.Y]
    return x + (now[tb.DX] - moved[tb.DX]), y + (now[tb.DY] - moved[tb.DY])
