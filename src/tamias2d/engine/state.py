"""What users see and set, brought to the slots of the engine and back."""

from tamias2d.engine.tables import (
    DX,
    GRAVITY_X,
    GRAVITY_Y,
    STATIC,
    Bodies,
    BodyState,
    Control,
)


def gather_state(control: Control, state: BodyState, bodies: Bodies) -> bool:
    """Bring what users can set to the slots of the bodies; return whether some of it looks odd.

    It does where a sum is not finite, or a static body moves.
    """
    total = control.settings[GRAVITY_X] + control.settings[GRAVITY_Y]
    odd = 0 if total - total == 0.0 else 1
    for i in range(len(state.body_of_slot)):
        k = state.body_of_slot[i]
        at, speed, by = state.pose[k], state.velocity[k], state.load[k]
        for n in range(3):
            bodies.pose[i, n], bodies.motion[i, n], bodies.load[i, n] = at[n], speed[n], by[n]
            total = at[n] + speed[n] + by[n]
            odd += 0 if total - total == 0.0 else 1
        moves = abs(speed[0]) + abs(speed[1]) + abs(speed[2]) > 0.0
        odd += 1 if moves & (bodies.kind[i] == STATIC) else 0
    return odd > 0


def all_valid(control: Control, bodies: Bodies) -> bool:
    """Return whether all that users can set is finite, and static bodies stand still."""
    x, y = control.settings[GRAVITY_X], control.settings[GRAVITY_Y]
    bad = 0 if x - x == 0.0 and y - y == 0.0 else 1
    for i in range(len(bodies.pose)):
        mobile = bodies.kind[i] != STATIC
        for n in range(3):
            at, by, speed = bodies.pose[i, n], bodies.load[i, n], bodies.motion[i, n]
            finite = (at - at == 0.0) & (by - by == 0.0) & (speed - speed == 0.0)
            bad += 0 if finite & (mobile | (speed == 0.0)) else 1
    return bad == 0


def scatter_state(state: BodyState, bodies: Bodies) -> None:
    """Put all bodies at the ends of their paths, and show users where they are and how they move."""
    for i in range(len(state.body_of_slot)):
        k = state.body_of_slot[i]
        for n in range(3):
            to = bodies.pose[i, n] + bodies.motion[i, DX + n]
            bodies.pose[i, n], bodies.motion[i, DX + n] = to, 0.0
            state.pose[k, n], state.velocity[k, n] = to, bodies.motion[i, n]
