"""The parabolas of two bodies through a step, on which their first impact is found (DD61)."""

from tamias2d.engine import tables as tb
from tamias2d.engine.continuous.conservative_advancement import MISSED
from tamias2d.engine.continuous.events import manifold_at
from tamias2d.engine.continuous.impact import normal_line
from tamias2d.engine.continuous.impulse import speed_along
from tamias2d.engine.tables import Bodies, Events, Shapes
from tamias2d.generated.continuous_collision import coordinate_bend, coordinate_rest_gain

MOST_BENDS = 12  # of Newton's method
CLOSER = 2.0**-30  # than what counts as meeting on lines: gaps here are positive, too
SETTLED = 2.0**-45  # of the step


def is_first(i: int, j: int, bodies: Bodies) -> bool:
    """Return whether no impact and no contact has changed the paths of two bodies."""
    flight = bodies.flight
    return bool(
        flight[i, tb.REDIRECTED]
        + flight[i, tb.SUPPORTED]
        + flight[j, tb.REDIRECTED]
        + flight[j, tb.SUPPORTED]
        == 0.0
    )


def bend_paths(
    s: int, t: int, chord: float, time_step: float, bodies: Bodies, shapes: Shapes, events: Events
) -> float:
    """Put two bodies that meet on their chords on their parabolas; return when they meet there.

    From then on their paths are the chords of the rest of the step. Where they still approach at
    its end, it is `MISSED`, and nothing is changed: they meet in the next step.
    """
    i, j = shapes.slot[s], shapes.slot[t]
    near = manifold_at(s, t, chord, (0.0, 0.0), bodies, shapes, events)
    side = (events.scratch[0, tb.NX], events.scratch[0, tb.NY])
    start_i = (bodies.pose[i, 0], bodies.pose[i, 1], bodies.pose[i, 2])
    start_j = (bodies.pose[j, 0], bodies.pose[j, 1], bodies.pose[j, 2])
    now, target = chord, CLOSER * near
    for _ in range(MOST_BENDS):
        place_beside(i, start_i, now, time_step, bodies)
        place_beside(j, start_j, now, time_step, bodies)
        gap = manifold_at(s, t, now, side, bodies, shapes, events)
        line = normal_line(i, j, now, events.scratch[0], bodies)
        closing = -time_step * speed_along(line, 1.0 - now, bodies.motion, bodies.flight)
        later = min(max(now + (gap - target) / closing, 0.0), 1.0) if closing > 0.0 else now
        if abs(later - now) <= SETTLED:
            break
        now = later
    late = now == 1.0 and target < gap <= near and closing > 0.0
    if late or not abs(gap) <= near:  # grazing, no iteration ends at the gap
        for n in range(3):
            bodies.pose[i, n], bodies.pose[j, n] = start_i[n], start_j[n]
        return MISSED if late else chord
    take_rest(i, now, time_step, bodies)
    take_rest(j, now, time_step, bodies)
    return now


def put_on_parabola(i: int, now: float, time_step: float, bodies: Bodies) -> None:
    """Put a body on its parabola: from a fraction of the step on its path is the chord of it."""
    place_beside(
        i, (bodies.pose[i, 0], bodies.pose[i, 1], bodies.pose[i, 2]), now, time_step, bodies
    )
    take_rest(i, now, time_step, bodies)


def place_beside(
    i: int, start: tuple[float, float, float], now: float, time_step: float, bodies: Bodies
) -> None:
    """Let the line of a body lead through where it is on its parabola at a fraction of the step."""
    for n in range(3):
        gain = bodies.flight[i, tb.FORCE_GAIN + n] if bodies.kind[i] == tb.DYNAMIC else 0.0
        bodies.pose[i, n] = start[n] + coordinate_bend(gain, time_step, now)


def take_rest(i: int, now: float, time_step: float, bodies: Bodies) -> None:
    """Turn the line of a body into the chord of the rest of its parabola."""
    for n in range(3):
        gain = bodies.flight[i, tb.FORCE_GAIN + n] if bodies.kind[i] == tb.DYNAMIC else 0.0
        more = coordinate_rest_gain(gain, time_step, now)
        bodies.motion[i, tb.DX + n] += more
        bodies.pose[i, n] -= now * more
