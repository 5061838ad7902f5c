"""Bodies that rise lose the energy of what contacts lift (DD87).

Contacts push overlaps apart, also against gravity and forces. What that takes is missing from the
motion against these of the bodies to which contacts have given energy: otherwise a heap would swing
up and down on its overlaps. A support that turns lifts what lies on it, since its way bends: there,
nothing is taken. Cost: a visit to each body, where something is lifted.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.energy.load_seen import load_seen
from tamias2d.engine.energy.step_energy import GRACE
from tamias2d.engine.energy.support import SUPPORTED_BY_ONE, reference_at
from tamias2d.engine.tables import Bodies, Constraints, Control, Islands, Touching
from tamias2d.generated.definitions import acceleration
from tamias2d.generated.island_energy import (
    damped_share,
    energy_given,
    rising_energy,
    rising_energy_left,
    velocity_rising_reduced,
    velocity_seen,
)
from tamias2d.state import Array


def dissipate_rising(
    control: Control,
    bodies: Bodies,
    touching: Touching,
    constraints: Constraints,
    islands: Islands,
) -> None:
    """Take from bodies that rise what their islands have too much, as far as they have it."""
    some = False
    for n in range(islands.counts[tb.ROOTS]):
        row = islands.energy[islands.roots[n]]
        row[tb.ENERGY_SURPLUS] = surplus_of_lift(row)
        some = some or row[tb.ENERGY_SURPLUS] > 0.0
    for k in range(constraints.counts[tb.ACTIVE] if some else 0):
        i = touching.active[k]
        if bodies.kind[i] == tb.DYNAMIC and islands.given[i] > 0.0:
            row = islands.energy[islands.links[i, tb.ROOT]]
            if row[tb.ENERGY_SURPLUS] > 0.0:
                dissipate_lift(i, row, control, bodies, islands)


def surplus_of_lift(row: Array) -> float:
    """Return what an island on a steady support has too much for what it lifts, J."""
    steady = row[tb.SUPPORT] == SUPPORTED_BY_ONE and row[tb.REFERENCE + 2] == 0.0
    if not steady or row[tb.SUPPORTS_DIFFER] == 1.0 or row[tb.WORK] >= 0.0:
        return 0.0
    kept = min(row[tb.ENERGY_KEPT], row[tb.ENERGY_BOUND])
    surplus = energy_given(kept, row[tb.ENERGY_START], row[tb.WORK])
    return float(surplus) if surplus > GRACE * kept else 0.0


def dissipate_lift(i: int, row: Array, control: Control, bodies: Bodies, islands: Islands) -> None:
    """Take from the motion of a body against the forces on it its part of the surplus."""
    inverse_mass = bodies.properties[i, tb.INVERSE_MASS]
    gravity = (control.settings[tb.GRAVITY_X], control.settings[tb.GRAVITY_Y])
    (by_x, by_y), spin = reference_at(i, bodies, islands)
    force, _ = load_seen(i, (by_x, by_y), spin, bodies)
    x, y = acceleration(gravity, force, inverse_mass)
    now = bodies.motion[i]
    seen = velocity_seen((now[tb.VX], now[tb.VY]), (by_x, by_y))
    if not (seen[0] * x + seen[1] * y < 0.0 and x * x + y * y > 0.0):
        return
    energy = rising_energy(1.0 / inverse_mass, seen, (x, y))
    whole = row[tb.ENERGY_GIVEN_ALL]
    left = rising_energy_left(energy, row[tb.ENERGY_SURPLUS], islands.given[i], whole)
    if energy > left:
        kept = velocity_rising_reduced(seen, (x, y), damped_share(energy, left, 0.0))
        now[tb.VX], now[tb.VY] = by_x + kept[0], by_y + kept[1]
