"""The energy of all bodies with contacts, and what forces give them in a step (DD36).

It is a cheap test, and nearly always all that is needed where there is no restitution.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.tables import Bodies, Control, Touching
from tamias2d.generated.definitions import coordinate_velocity_later, kinetic_energy
from tamias2d.generated.island_energy import kinetic_energy_most, work
from tamias2d.generated.soft_contact import turn_later
from tamias2d.state import Array

GRACE = 1e-12  # of the energy, that rounding may add; one impact alone never takes more
UNTOUCHED_WITHIN = 2.0**-44  # of velocities and ways, that rounding may change in a step
UNLIMITED = 1e300  # J, that a body which is driven may give


def sum_step_energy(
    first: int, last: int, control: Control, bodies: Bodies, touching: Touching, energy: Array
) -> None:
    """Add the energies of some bodies, then and now, and the work of forces on them, J."""
    gravity = (control.settings[tb.GRAVITY_X], control.settings[tb.GRAVITY_Y])
    for k in range(first, last):
        i = touching.active_by_slab[k]
        then, now, load = bodies.substep_state[i], bodies.motion[i], bodies.load[i]
        for n in range(3):
            bodies.flight[i, tb.FORCE_GAIN + n] = 0.0
        if bodies.kind[i] != tb.DYNAMIC:
            if moves_on(now):
                energy[tb.TOTAL_ENERGY_NOW] = 2.0 * UNLIMITED  # each island is looked at
            continue
        if bodies.moved[i] == tb.MOVED and unchanged_by_contacts(i, control, bodies):
            bodies.moved[i] = tb.UNTOUCHED
        mass, inertia = mass_and_inertia(i, bodies.properties)
        velocity = (then[tb.STEP_START], then[tb.STEP_START + 1])
        energy[tb.TOTAL_ENERGY_START] += kinetic_energy(
            mass, velocity, inertia, then[tb.STEP_START + 2]
        )
        velocity = (now[tb.VX], now[tb.VY])
        energy[tb.TOTAL_ENERGY_NOW] += kinetic_energy(mass, velocity, inertia, now[tb.SPIN])
        force, shift = (load[0], load[1]), (now[tb.DX], now[tb.DY])
        energy[tb.TOTAL_WORK] += work(mass, gravity, force, load[2], shift, now[tb.DANGLE])


def moves_on(motion: Array) -> bool:
    """Return whether a body that nothing pushes moves."""
    return bool(abs(motion[tb.VX]) + abs(motion[tb.VY]) + abs(motion[tb.SPIN]) > 0.0)


def unchanged_by_contacts(i: int, control: Control, bodies: Bodies) -> bool:
    """Return whether contacts have changed the motion of a body by no more than rounding does."""
    state, now, time = bodies.substep_state[i], bodies.motion[i], control.progress[tb.PART_TIME]
    radius = bodies.properties[i, tb.BOUNDING_RADIUS]
    reach_of_turn = radius if radius > 0.0 else 1.0
    changed = speed = 0.0
    for n in range(3):
        reach = reach_of_turn if n == 2 else 1.0
        last = state[tb.CONTACT_CHANGE + n] + (now[n] - state[tb.SUBSTEP_START + n])
        changed += abs(last) * reach
        speed += (abs(state[tb.STEP_START + n]) + abs(now[n])) * reach
    for n in range(3 if changed <= UNTOUCHED_WITHIN * speed else 0):
        free, way = state[tb.STEP_START + n], 0.0
        for _ in range(control.counts[tb.PART_SUBSTEPS]):
            free = coordinate_velocity_later(
                state[tb.DRAG_FACTOR + n], free, state[tb.INCREMENT + n]
            )
            way = turn_later(way, free, control.settings[tb.SUBSTEP])
        other = abs(now[n] - free) + abs(now[tb.DX + n] - way) / time
        changed += other * (reach_of_turn if n == 2 else 1.0)
    return bool(changed <= UNTOUCHED_WITHIN * speed)


def makes_energy(energy: Array) -> bool:
    """Return whether contacts have made energy in all, or driven bodies could have."""
    most = kinetic_energy_most(energy[tb.TOTAL_ENERGY_START], energy[tb.TOTAL_WORK])
    return bool(energy[tb.TOTAL_ENERGY_NOW] > most * (1.0 + GRACE))


def mass_and_inertia(i: int, properties: Array) -> tuple[float, float]:
    """Return both of a dynamic body; an inertia of zero stands for one that cannot turn."""
    inertia = 1.0 / properties[i, tb.INVERSE_INERTIA] if can_be_turned(i, properties) else 0.0
    return 1.0 / properties[i, tb.INVERSE_MASS], inertia


def can_be_turned(i: int, properties: Array) -> bool:
    """Return whether anything turns a dynamic body."""
    return bool(properties[i, tb.INVERSE_INERTIA] > 0.0)
