"""The reference motion of islands: that of their support, or of their centre of mass.

The energy of an island is measured as seen from its support, which may give any. Contacts with
supports that move against each other give what they do as seen from the ground (DD90); joints that
tie an island to such may give any. A free island is seen from its centre of mass as that
moved when the step began: there, gravity does no work that contacts could take for theirs.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.energy.step_energy import can_be_turned, mass_and_inertia
from tamias2d.engine.solver.blocks import lane_of, points_of
from tamias2d.engine.tables import Bodies, Constraints, Islands, Touching
from tamias2d.generated.definitions import kinetic_energy, momentum, point_velocity
from tamias2d.generated.island_energy import (
    angular_velocity_damped,
    angular_velocity_seen,
    damped_share,
    velocity_damped,
    velocity_island,
    velocity_seen,
)
from tamias2d.state import Array, Vector

LEAST_SHARE = 2.0**-600  # of the energy: what may keep less ends, before squares underflow
ALIKE = 1e-9  # of their sizes: differences of velocities that are none

FREE, SUPPORTED_BY_ONE, SUPPORTED_BY_MORE = 0.0, 1.0, 2.0  # motions that support an island


def find_references(
    bodies: Bodies, touching: Touching, constraints: Constraints, islands: Islands
) -> None:
    """Write the reference motion of each island at its root."""
    list_roots(bodies, touching, constraints, islands)
    for n in range(islands.counts[tb.ROOTS]):
        row = islands.energy[islands.roots[n]]
        row[tb.SUPPORT], row[tb.DRIVEN_RATE] = FREE, 0.0
        row[tb.ISLAND_MASS] = row[tb.MOMENTUM_X] = row[tb.MOMENTUM_Y] = 0.0
    for k in range(touching.counts[tb.TOUCHING]):
        i, j = touching.body_a[k], touching.body_b[k]
        if bodies.kind[i] != tb.DYNAMIC:
            i, j = j, i
        if bodies.kind[j] != tb.DYNAMIC and supports(k, touching, constraints):
            root = islands.links[i, tb.ROOT]
            support_island(j, root, bodies, islands)
            b, m = lane_of(k, touching)
            if constraints.blocks[b, tb.R_SURFACE_SPEED + m] != 0.0:
                islands.energy[root, tb.SUPPORT] = SUPPORTED_BY_MORE
    for n in range(islands.counts[tb.ROOTS]):
        see_from_ground(islands.energy[islands.roots[n]])
    find_free_references(bodies, touching, constraints, islands)


def supports(k: int, touching: Touching, constraints: Constraints) -> bool:
    """Return whether a touching contact has given an impulse in this part, or lifted an overlap."""
    b, m = lane_of(k, touching)
    row, found = constraints.blocks[b], False
    for n in range(points_of(k, touching)):
        at = tb.SHARED + n * tb.POINT_SIZE + m
        overlaps = min(row[at + tb.P_GAP], row[at + tb.P_GAP_NOW]) < 0.0
        found = found or overlaps or row[at + tb.P_TOTAL_IMPULSE] > 0.0
    return found


def see_from_ground(row: Array) -> None:
    """Let an island be seen from the ground where its supports move against each other (DD90).

    So does a surface that runs, against its body.
    """
    differ = row[tb.SUPPORT] == SUPPORTED_BY_MORE
    row[tb.SUPPORTS_DIFFER] = 1.0 if differ else 0.0
    if differ:
        row[tb.SUPPORT] = SUPPORTED_BY_ONE
        row[tb.REFERENCE] = row[tb.REFERENCE + 1] = row[tb.REFERENCE + 2] = 0.0


def find_free_references(
    bodies: Bodies, touching: Touching, constraints: Constraints, islands: Islands
) -> None:
    """Let islands without support be seen from their centres of mass as the step began."""
    for k in range(constraints.counts[tb.ACTIVE]):
        i = touching.active[k]
        row = islands.energy[islands.links[i, tb.ROOT]]
        if bodies.kind[i] == tb.DYNAMIC and row[tb.SUPPORT] == FREE:
            state, mass = bodies.substep_state[i], 1.0 / bodies.properties[i, tb.INVERSE_MASS]
            x, y = momentum(mass, (state[tb.STEP_START], state[tb.STEP_START + 1]))
            row[tb.MOMENTUM_X] += x
            row[tb.MOMENTUM_Y] += y
            row[tb.ISLAND_MASS] += mass
    for n in range(islands.counts[tb.ROOTS]):
        row = islands.energy[islands.roots[n]]
        if row[tb.SUPPORT] == FREE:
            whole = (row[tb.MOMENTUM_X], row[tb.MOMENTUM_Y])
            row[tb.REFERENCE], row[tb.REFERENCE + 1] = velocity_island(whole, row[tb.ISLAND_MASS])
            row[tb.REFERENCE + 2] = 0.0


def list_roots(
    bodies: Bodies, touching: Touching, constraints: Constraints, islands: Islands
) -> None:
    """List the roots of the islands that have contacts."""
    count = 0
    for k in range(constraints.counts[tb.ACTIVE]):
        i = touching.active[k]
        if is_root(i, bodies, islands):
            islands.roots[count] = i
            count += 1
    islands.counts[tb.ROOTS] = count


def is_root(i: int, bodies: Bodies, islands: Islands) -> bool:
    """Return whether a body is the root of an island."""
    return bool(bodies.kind[i] == tb.DYNAMIC and islands.links[i, tb.ROOT] == i)


def support_island(j: int, root: int, bodies: Bodies, islands: Islands) -> None:
    """Let an island be seen from a body that does not move freely."""
    row, motion, spin = islands.energy[root], bodies.motion[j], bodies.motion[j, tb.SPIN]
    x, y = (
        bodies.pose[root, tb.X] - bodies.pose[j, tb.X],
        bodies.pose[root, tb.Y] - bodies.pose[j, tb.Y],
    )
    by_x, by_y = point_velocity((motion[tb.VX], motion[tb.VY]), spin, (x, y))
    if row[tb.SUPPORT] == FREE:
        row[tb.SUPPORT] = SUPPORTED_BY_ONE
        row[tb.REFERENCE], row[tb.REFERENCE + 1], row[tb.REFERENCE + 2] = by_x, by_y, spin
    apart = abs(row[tb.REFERENCE] - by_x) + abs(row[tb.REFERENCE + 1] - by_y)
    row[tb.DRIVEN_RATE] = max(row[tb.DRIVEN_RATE], apart)
    speed = abs(by_x) + abs(by_y) + abs(motion[tb.VX]) + abs(motion[tb.VY])
    if apart > ALIKE * speed or abs(row[tb.REFERENCE + 2] - spin) > ALIKE * abs(spin):
        row[tb.SUPPORT] = SUPPORTED_BY_MORE


def reference_at(i: int, bodies: Bodies, islands: Islands) -> tuple[Vector, float]:
    """Return the velocity, at a body, and the spin of the reference motion of its island.

    A body that nothing turns is seen from where contacts press it (DD108).
    """
    root = islands.links[i, tb.ROOT]
    row = islands.energy[root]
    x, y = (
        bodies.pose[i, tb.X] - bodies.pose[root, tb.X],
        bodies.pose[i, tb.Y] - bodies.pose[root, tb.Y],
    )
    if not can_be_turned(i, bodies.properties):
        x, y = x + islands.energy[i, tb.PRESSED_ARM], y + islands.energy[i, tb.PRESSED_ARM + 1]
    spin = row[tb.REFERENCE + 2]
    return point_velocity((row[tb.REFERENCE], row[tb.REFERENCE + 1]), spin, (x, y)), spin


def energy_from_support(i: int, bodies: Bodies, islands: Islands) -> float:
    """Return the kinetic energy of a body as seen from its support, J."""
    mass, inertia = mass_and_inertia(i, bodies.properties)
    by, spin = reference_at(i, bodies, islands)
    now = bodies.motion[i]
    velocity = velocity_seen((now[tb.VX], now[tb.VY]), by)
    return kinetic_energy(mass, velocity, inertia, angular_velocity_seen(now[tb.SPIN], spin))


def damp_to_support(i: int, share: float, bodies: Bodies, islands: Islands) -> None:
    """Leave a body a share of its motion as seen from its support."""
    by, spin = reference_at(i, bodies, islands)
    now = bodies.motion[i]
    now[tb.VX], now[tb.VY] = velocity_damped((now[tb.VX], now[tb.VY]), by, share)
    if can_be_turned(i, bodies.properties):
        now[tb.SPIN] = angular_velocity_damped(now[tb.SPIN], spin, share)


def share_left(energy: float, left: float) -> float:
    """Return which share of a motion has an energy that is left, J; slight ones end."""
    return damped_share(energy, left, 0.0) if left > LEAST_SHARE * energy else 0.0
