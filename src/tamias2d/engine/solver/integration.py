"""Velocities and positions of active bodies through a substep: forces, drag, and what contacts did.

Cost: a visit to each body in each half of a substep.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.solver.slowed import slow_carried
from tamias2d.engine.tables import Bodies, Control, Touching
from tamias2d.generated.definitions import (
    acceleration,
    angular_acceleration,
    coordinate_velocity_gain,
    coordinate_velocity_later,
)
from tamias2d.generated.soft_contact import shift_later, turn_later


def begin_step(first: int, last: int, control: Control, bodies: Bodies, touching: Touching) -> None:
    """Note velocities before the warm start, and what gravity, loads and drag do in a substep."""
    gravity = (control.settings[tb.GRAVITY_X], control.settings[tb.GRAVITY_Y])
    for k in range(first, last):
        i = touching.active_by_slab[k]
        state, load, properties = bodies.substep_state[i], bodies.load[i], bodies.properties[i]
        for n in range(3):
            state[tb.CONTACT_CHANGE + n], state[tb.SUBSTEP_START + n] = 0.0, bodies.motion[i, n]
            state[tb.STEP_START + n] = bodies.motion[i, n]
            state[tb.DRAG_FACTOR + n], state[tb.INCREMENT + n] = 1.0, 0.0
        if bodies.kind[i] == tb.DYNAMIC:
            by_x, by_y = acceleration(gravity, (load[0], load[1]), properties[tb.INVERSE_MASS])
            by_angle = angular_acceleration(load[2], properties[tb.INVERSE_INERTIA])
            through = bodies.propagators[int(properties[tb.PROPAGATOR])]
            decay, gain = through[tb.ONE_SUBSTEP + tb.DECAY], through[tb.ONE_SUBSTEP + tb.GAIN]
            state[tb.DRAG_FACTOR] = state[tb.DRAG_FACTOR + 1] = decay
            state[tb.INCREMENT], state[tb.INCREMENT + 1] = (
                coordinate_velocity_gain(gain, by_x),
                coordinate_velocity_gain(gain, by_y),
            )
            gain = through[tb.ONE_SUBSTEP + tb.ANGULAR + tb.GAIN]
            state[tb.DRAG_FACTOR + 2] = through[tb.ONE_SUBSTEP + tb.ANGULAR + tb.DECAY]
            state[tb.INCREMENT + 2] = coordinate_velocity_gain(gain, by_angle)


def apply_forces(again: bool, first: int, last: int, bodies: Bodies, touching: Touching) -> None:
    """Let forces change velocities for a substep, and contacts as they have before.

    The change by contacts so far is carried: impulses add up, so this is what a warm start of each
    contact would do, less what drag takes of it. In the first substep it is the warm start of the
    step, and bodies begin with the velocities that were noted.
    """
    for k in range(first, last):
        i = touching.active_by_slab[k]
        state = bodies.substep_state[i]
        for n in range(3):
            state[tb.CONTACT_CHANGE + n] += bodies.motion[i, n] - state[tb.SUBSTEP_START + n]
            before = bodies.motion[i, n] if again else state[tb.SUBSTEP_START + n]
            free = coordinate_velocity_later(
                state[tb.DRAG_FACTOR + n], before, state[tb.INCREMENT + n]
            )
            bodies.motion[i, n] = free + state[tb.CONTACT_CHANGE + n]
            state[tb.SUBSTEP_START + n] = bodies.motion[i, n]
        if state[tb.DRAG_FACTOR] < 1.0 or state[tb.DRAG_FACTOR + 2] < 1.0:
            slow_carried(i, bodies)


def integrate_positions(
    substep: float, first: int, last: int, bodies: Bodies, touching: Touching
) -> None:
    """Move bodies on for a substep, s."""
    for k in range(first, last):
        i = touching.active_by_slab[k]
        now = bodies.motion[i]
        now[tb.DX], now[tb.DY] = shift_later(
            (now[tb.DX], now[tb.DY]), (now[tb.VX], now[tb.VY]), substep
        )
        now[tb.DANGLE] = turn_later(now[tb.DANGLE], now[tb.SPIN], substep)
