"""Bodies as users see and set them, gathered into slots and scattered back."""

from tamias2d.engine.tables import DX, GRAVITY_X, GRAVITY_Y, STATIC, Bodies, BodyState, Control


def gather_state(control: Control, state: BodyState, bodies: Bodies) -> bool:
    """Bring what users can set to the slots; return whether some of it may not be valid.

    That is so where a sum is not finite, or a static body moves.
    """
    total = control.settings[GRAVITY_X] + control.settings[GRAVITY_Y]
    doubtful = 0 if total - total == 0.0 else 1
    for i in range(len(state.body_of_slot)):
        k = state.body_of_slot[i]
        pose, velocity, load = state.pose[k], state.velocity[k], state.load[k]
        for n in range(3):
            bodies.pose[i, n], bodies.motion[i, n], bodies.load[i, n] = (
                pose[n],
                velocity[n],
                load[n],
            )
            total = pose[n] + velocity[n] + load[n]
            doubtful += 0 if total - total == 0.0 else 1
        moves = abs(velocity[0]) + abs(velocity[1]) + abs(velocity[2]) > 0.0
        doubtful += 1 if moves & (bodies.kind[i] == STATIC) else 0
    return doubtful > 0


def all_valid(control: Control, bodies: Bodies) -> bool:
    """Return whether all that users can set is finite, and static bodies stand still."""
    x, y = control.settings[GRAVITY_X], control.settings[GRAVITY_Y]
    invalid = 0 if x - x == 0.0 and y - y == 0.0 else 1
    for i in range(len(bodies.pose)):
        mobile = bodies.kind[i] != STATIC
        for n in range(3):
            place, load, speed = bodies.pose[i, n], bodies.load[i, n], bodies.motion[i, n]
            finite = (place - place == 0.0) & (load - load == 0.0) & (speed - speed == 0.0)
            invalid += 0 if finite & (mobile | (speed == 0.0)) else 1
    return invalid == 0


def scatter_state(state: BodyState, bodies: Bodies) -> None:
    """Put all bodies at the ends of their paths, and write poses and velocities for users."""
    for i in range(len(state.body_of_slot)):
        k = state.body_of_slot[i]
        for n in range(3):
            place = bodies.pose[i, n] + bodies.motion[i, DX + n]
            bodies.pose[i, n], bodies.motion[i, DX + n] = place, 0.0
            state.pose[k, n], state.velocity[k, n] = place, bodies.motion[i, n]
