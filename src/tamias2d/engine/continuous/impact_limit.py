"""Bodies for which a step has no more impacts: they wait for the next, where nothing is.

Serves: flight. Hides: what goes along with what cannot wait, and that nobody gains by waiting.
"""

from tamias2d.engine.continuous.trajectory import offset_at, redirect_path
from tamias2d.engine.continuous.work import take_energy_back, work_ahead
from tamias2d.engine.tables import (
    DANGLE,
    DX,
    DY,
    DYNAMIC,
    REDIRECTED,
    TIME_STEP,
    Bodies,
    Control,
    Integers,
)
from tamias2d.generated.continuous_collision import inward_share, shift_carried
from tamias2d.state import Array, Vector

ARC = 0.5  # rad: how far a wall turns at most while what it carries on goes along one line
# instead of 1 where a line is bent: as that of what is pushed on, carried on by a wall, or a wall;
# each time that a body is led on it comes nearer to the next of these
CARRIED_BY_BODY, CARRIED_BY_WALL, IMMOVABLE = 2.0, 3.0, 4.0
NEARER, NEARER_TO_WALL = 1.0 / 8.0, 1.0 / 64.0


def freeze_or_carry(i: int, j: int, now: float, control: Control, bodies: Bodies) -> bool:
    """Let two bodies that meet wait for the next step; return whether this changes their lines.

    What has met something that cannot wait, or something that goes along with that, goes along,
    too. What is led on by walls is led on by nothing else, and by these not for ever: it may be
    jammed.
    """
    near_i, near_j = (
        carrier_rank(i, bodies.flight, bodies.kind),
        carrier_rank(j, bodies.flight, bodies.kind),
    )
    if max(near_i, near_j) < CARRIED_BY_BODY:
        freeze(i, now, control, bodies)
        freeze(j, now, control, bodies)
        return True
    if near_i < near_j:
        i, j = j, i
    near, wall = min(near_i, near_j), bodies.kind[i] != DYNAMIC
    if near >= (IMMOVABLE if wall else CARRIED_BY_WALL):
        return False
    way, turn = displacement_along(i, j, now, bodies)
    redirect(j, now, way, turn, control, bodies)
    nearer = (
        max(near + NEARER_TO_WALL, CARRIED_BY_WALL) if wall else max(near + NEARER, CARRIED_BY_BODY)
    )
    bodies.flight[j, REDIRECTED] = nearer
    return True


def carrier_rank(i: int, flight: Array, kind: Integers) -> float:
    """Return how near a body is to something that nothing moves and that leads it on."""
    return float(flight[i, REDIRECTED]) if kind[i] == DYNAMIC else IMMOVABLE


def cannot_freeze(i: int, flight: Array, kind: Integers) -> bool:
    """Return whether a body stays on its line whatever it meets, or goes along with such a one."""
    return carrier_rank(i, flight, kind) >= CARRIED_BY_BODY


def freeze(i: int, now: float, control: Control, bodies: Bodies) -> None:
    """Let a body stay where it is for the rest of the step."""
    if bodies.kind[i] == DYNAMIC:
        redirect(i, now, (0.0, 0.0), 0.0, control, bodies)


def displacement_along(i: int, j: int, now: float, bodies: Bodies) -> tuple[Vector, float]:
    """Return the way of a body j, m and rad, as if it were a part of i, as far as a line can be.

    Along with a wall that turns it begins on the inside of its arc, and cuts that before the wall
    has turned by `ARC`: there both meet again.
    """
    shift, turn = (bodies.motion[i, DX], bodies.motion[i, DY]), bodies.motion[i, DANGLE]
    offset = offset_at(i, j, now, bodies.pose, bodies.motion)
    inwards = inward_share(turn, now, ARC) if bodies.kind[i] != DYNAMIC else 0.0
    return shift_carried(shift, turn, offset, inwards), turn


def redirect(
    i: int, now: float, way: Vector, turn: float, control: Control, bodies: Bodies
) -> None:
    """Lead a body another way, over a whole step, without an impulse: its velocity stays.

    But what forces have given it for the way that it does not go any more is taken back.
    """
    left, time_step = 1.0 - now, control.settings[TIME_STEP]
    before = work_ahead(i, left, control, bodies)
    by = (way[0] - bodies.motion[i, DX], way[1] - bodies.motion[i, DY])
    redirect_path(i, now, by, turn - bodies.motion[i, DANGLE], bodies.pose, bodies.motion)
    undone = before - work_ahead(i, left, control, bodies)
    support = (way[0] / time_step, way[1] / time_step)
    take_energy_back(i, undone, support, turn / time_step, bodies.motion, bodies.properties)
