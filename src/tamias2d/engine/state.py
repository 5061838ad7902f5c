"""The state that users see and set, brought to the slots of the engine and back."""

from tamias2d.engine import tables as tb
from tamias2d.engine.tables import Bodies, BodyState, Control
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array

LARGEST = 2.0**256
"""The fourth root of the largest float64, 1.2e77: products of four such numbers are finite."""
RESOLVED = 2.0**50
"""Radii of a body from the origin, 1e15: farther off float64 does not tell its parts apart."""


def gather_state(control: Control, state: BodyState, bodies: Bodies) -> bool:
    """Bring what users can set to the slots of the bodies; return whether all of it is valid.

    Numbers are finite and not too large, and of each body only those differ from 0 that it has:
    what cannot be turned has no spin.
    """
    bad = (
        0
        if abs(control.settings[tb.GRAVITY_X]) + abs(control.settings[tb.GRAVITY_Y]) <= LARGEST
        else 1
    )
    for i in range(len(state.body_of_slot)):
        k = state.body_of_slot[i]
        at, speed, by = state.pose[k], state.velocity[k], state.load[k]
        for n in range(3):
            bodies.pose[i, n], bodies.motion[i, n], bodies.load[i, n] = at[n], speed[n], by[n]
        bad += 0 if is_valid_state(at, speed, by, bodies.properties[i, tb.BOUNDING_RADIUS]) else 1
        bad += 0 if suits_kind(bodies.kind[i], at, speed, by) else 1
        spins = (bodies.kind[i] == tb.DYNAMIC) & (speed[2] != 0.0)
        bad += 1 if spins & (bodies.properties[i, tb.INVERSE_INERTIA] == 0.0) else 0
    return bad == 0


@inlined
def is_valid_state(at: Array, speed: Array, by: Array, radius: float) -> bool:
    """Return whether pose, velocity and load of a body of some radius, m, are not too large."""
    fast = abs(speed[0]) + abs(speed[1]) + abs(speed[2])
    slow = fast + (abs(by[0]) + abs(by[1]) + abs(by[2])) <= LARGEST
    most = RESOLVED * radius if radius > 0.0 else LARGEST
    near = (abs(at[tb.X]) + abs(at[tb.Y]) <= most) & (at[tb.ANGLE] - at[tb.ANGLE] == 0.0)
    return bool(slow & near)


@inlined
def suits_kind(kind: int, at: Array, speed: Array, by: Array) -> bool:
    """Return whether nothing pushes what is not dynamic, or moves what is static.

    An absent body has no place either.
    """
    placed = abs(at[0]) + abs(at[1]) + abs(at[2])
    moves = abs(speed[0]) + abs(speed[1]) + abs(speed[2])
    pushed = abs(by[0]) + abs(by[1]) + abs(by[2])
    return bool(
        ((pushed == 0.0) | (kind == tb.DYNAMIC))
        & ((moves == 0.0) | (kind >= tb.KINEMATIC))
        & ((placed == 0.0) | (kind != tb.ABSENT))
    )


def scatter_state(state: BodyState, bodies: Bodies) -> bool:
    """Put all bodies at the ends of their paths, and show users where they are and how they move.

    A body whose numbers are not finite stays as it was. Return whether there is none.
    """
    bad = 0
    for i in range(len(state.body_of_slot)):
        k = state.body_of_slot[i]
        total = 0.0
        for n in range(3):
            to = bodies.pose[i, n] + bodies.motion[i, tb.DX + n]
            bodies.pose[i, n], bodies.motion[i, tb.DX + n] = to, 0.0
            total += to + bodies.motion[i, n]
        if total - total == 0.0:
            for n in range(3):
                state.pose[k, n], state.velocity[k, n] = bodies.pose[i, n], bodies.motion[i, n]
        else:
            bad += 1
    return bad == 0
