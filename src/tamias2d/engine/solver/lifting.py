"""Bodies that are lifted out of overlaps pay for it with their motion (DD87).

Contacts push overlaps apart, also against gravity and forces. What that takes is missing from the
motion of those bodies to which contacts have given energy: otherwise a heap would swing up and down
on its overlaps. A support that turns lifts what lies on it, since its way bends: there, nothing is
taken. Cost: a visit to each body, where something is lifted.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.solver.energy import GRACE, mass_and_inertia
from tamias2d.engine.solver.support import SUPPORTED_BY_ONE, is_root, reference_at
from tamias2d.engine.tables import Bodies, Constraints, Islands, Touching
from tamias2d.generated.definitions import kinetic_energy
from tamias2d.generated.island_energy import (
    angular_velocity_damped,
    angular_velocity_seen,
    damped_share,
    kinetic_energy_charged,
    kinetic_energy_most,
    velocity_damped,
    velocity_seen,
)
from tamias2d.state import Array


def charge_lifted(
    bodies: Bodies, touching: Touching, constraints: Constraints, islands: Islands
) -> None:
    """Take from lifted bodies what their islands have too much for it, as far as they move."""
    some = False
    for k in range(constraints.counts[tb.ACTIVE]):
        i = touching.active[k]
        if is_root(i, bodies, islands):
            row = islands.energy[i]
            row[tb.ENERGY_SURPLUS] = surplus_of_lift(row)
            some = some or row[tb.ENERGY_SURPLUS] > 0.0
    for k in range(constraints.counts[tb.ACTIVE] if some else 0):
        i = touching.active[k]
        if bodies.kind[i] == tb.DYNAMIC and islands.energy[i, tb.ENERGY_GIVEN] > 0.0:
            row = islands.energy[islands.links[i, tb.ROOT]]
            if row[tb.ENERGY_SURPLUS] > 0.0:
                charge(i, row, bodies, islands)


def surplus_of_lift(row: Array) -> float:
    """Return what an island on a steady support has too much for what it lifts, J."""
    steady = row[tb.SUPPORT] == SUPPORTED_BY_ONE and row[tb.REFERENCE + 2] == 0.0
    if not steady or row[tb.WORK] >= 0.0:
        return 0.0
    kept = min(row[tb.ENERGY_KEPT], row[tb.ENERGY_BOUND])
    surplus = kept - kinetic_energy_most(row[tb.ENERGY_START], row[tb.WORK])
    return float(surplus) if surplus > GRACE * kept else 0.0


def charge(i: int, row: Array, bodies: Bodies, islands: Islands) -> None:
    """Take from a body its part of what its island has too much."""
    velocity, spin = reference_at(i, bodies, islands)
    mass, inertia = mass_and_inertia(i, bodies.properties)
    now = bodies.motion[i]
    seen = velocity_seen((now[tb.VX], now[tb.VY]), velocity)
    energy = kinetic_energy(mass, seen, inertia, angular_velocity_seen(now[tb.SPIN], spin))
    given = islands.energy[i, tb.ENERGY_GIVEN]
    left = kinetic_energy_charged(energy, row[tb.ENERGY_SURPLUS], given, row[tb.ENERGY_GIVEN_ALL])
    if energy > left:
        share = damped_share(energy, left, 0.0)
        now[tb.VX], now[tb.VY] = velocity_damped((now[tb.VX], now[tb.VY]), velocity, share)
        now[tb.SPIN] = angular_velocity_damped(now[tb.SPIN], spin, share)
