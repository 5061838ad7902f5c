"""How a body goes on a new path, and what pulls it there."""

from math import inf

from tamias2d.event_driven import tables as tb
from tamias2d.event_driven.approach import EPSILON, state_at
from tamias2d.event_driven.kinds import is_pushed
from tamias2d.event_driven.tables import Moving, World
from tamias2d.kernels.arrays import FloatRows
from tamias2d.state import Array

MOST_REPEATS = 32  # new paths of a body that do not advance in time


def pull_of(k: int, world: World) -> float:
    """Return how large the acceleration of a body by its loads is at most, m/s^2."""
    on = pull_on(k, world)
    return abs(on[0]) + abs(on[1])


def pull_on(k: int, world: World) -> tuple[float, float, float]:
    """Return the acceleration of a body by its loads, m/s^2 and rad/s^2."""
    if not is_pushed(k, world):
        return 0.0, 0.0, 0.0
    body = world.bodies[k]
    return body[tb.AX], body[tb.AY], body[tb.TURNING]


def depart(k: int, time: float, state: Moving, world: World) -> None:
    """Set the path of a body, if it is one that is pushed."""
    if not is_pushed(k, world):
        return
    tell(k, time, world)
    path, body, note = world.paths[k], world.bodies[k], world.notes[k]
    stalled = path[tb.START] >= time * (1 - 4 * EPSILON)
    note[tb.STALLED] = note[tb.STALLED] + 1 if stalled else 0
    note[tb.VERSION] += 1
    path[tb.X], path[tb.Y], path[tb.TURN], path[tb.VX], path[tb.VY], path[tb.SPIN] = state
    path[tb.AX], path[tb.AY], path[tb.TURNING] = body[tb.AX], body[tb.AY], body[tb.TURNING]
    path[tb.START], world.sliding[k] = time, inf
    if len(world.departures) > 0:
        note_departure(k, world.paths, world.departures[world.counts[tb.DEPARTURES]])
        world.counts[tb.DEPARTURES] += 1


def note_departure(k: int, paths: FloatRows, row: Array) -> None:
    """Record the new path of a body."""
    row[0] = k
    for column in range(tb.PATH_COLUMNS):
        row[1 + column] = paths[k, column]


def tell(k: int, until: float, world: World) -> None:
    """Write down the states of a body on its path at all samples before a time, s."""
    note, count = world.notes[k], len(world.kinds)
    while note[tb.TOLD] < len(world.times) and world.times[note[tb.TOLD]] < until:
        x, y, turn, u, v, spin = state_at(k, world.times[note[tb.TOLD]], world.paths)
        row = world.samples[count * note[tb.TOLD] + k]
        row[0], row[1], row[2], row[3], row[4], row[5] = x, y, turn, u, v, spin
        note[tb.TOLD] += 1
