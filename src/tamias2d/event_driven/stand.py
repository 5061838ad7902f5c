"""Two bodies at hand, as they stand at an instant: `contact.core.Placed` as rows of tables."""

from math import cos, inf, sin

from tamias2d.event_driven import tables as tb
from tamias2d.event_driven.approach import EPSILON, state_at
from tamias2d.event_driven.tables import World


def stand(place: int, k: int, time: float, world: World) -> None:
    """Put a body at hand, without its corners, as it is at a time, s."""
    row, path, body = world.hulls.stands[place], world.paths[k], world.bodies[k]
    row[tb.X], row[tb.Y], row[tb.TURN], row[tb.VX], row[tb.VY], row[tb.SPIN] = state_at(
        k, time, world.paths
    )
    row[tb.AX], row[tb.AY], row[tb.TURNING], row[tb.START] = (
        path[tb.AX],
        path[tb.AY],
        path[tb.TURNING],
        path[tb.START],
    )
    row[tb.START_SPIN], row[tb.ROUND] = path[tb.SPIN], body[tb.ROUNDING]
    plane = world.kinds[k] == tb.PLANE
    row[tb.BOUND] = inf if plane else body[tb.RADIUS]
    row[tb.SIZE] = abs(body[tb.OFFSET]) if plane else body[tb.RADIUS]
    for column in range(tb.SHAPE_COLUMNS):
        world.hulls.forms[place, column] = world.hulls.shapes[k, column]


def turn(place: int, world: World) -> None:
    """Turn the corners and sides of a body at hand to where they are."""
    angle, form = world.hulls.stands[place, tb.TURN], world.hulls.forms[place]
    straight = angle == 0.0 or form[tb.CORNERS] == 1
    c, s = (1.0, 0.0) if straight else (cos(angle), sin(angle))
    for k in range(max(form[tb.CORNERS], form[tb.SIDES])):
        row, local = world.hulls.placed[place, k], world.hulls.outline[form[tb.BEGIN] + k]
        x, y, nx, ny = local[tb.CORNER_X], local[tb.CORNER_Y], local[tb.SIDE_X], local[tb.SIDE_Y]
        row[tb.PLACED_X] = x if straight else c * x - s * y
        row[tb.PLACED_Y] = y if straight else s * x + c * y
        row[tb.PLACED_NORMAL_X], row[tb.PLACED_NORMAL_Y] = c * nx - s * ny, s * nx + c * ny


def round_off(place: int, world: World) -> None:
    """Put at hand the disc around a body at hand."""
    row, body = world.hulls.stands[tb.ROUND_STAND], world.hulls.stands[place]
    for column in range(tb.STAND_COLUMNS):
        row[column] = body[column]
    row[tb.ROUND] = row[tb.BOUND]
    form, corner = world.hulls.forms[tb.ROUND_STAND], world.hulls.placed[tb.ROUND_STAND, 0]
    form[tb.BEGIN], form[tb.CORNERS], form[tb.SIDES] = 0, 1, 0
    corner[tb.PLACED_X] = corner[tb.PLACED_Y] = 0.0


def resolution_of(a: int, b: int, time: float, world: World) -> float:
    """Return the gap in m between two bodies at hand that float64 cannot tell from 0."""
    p, q = world.hulls.stands[a], world.hulls.stands[b]
    length = abs(p[tb.X]) + abs(p[tb.Y]) + abs(q[tb.X]) + abs(q[tb.Y]) + p[tb.SIZE] + q[tb.SIZE]
    speed = abs(q[tb.VX] - p[tb.VX]) + abs(q[tb.VY] - p[tb.VY])
    if world.hulls.forms[a, tb.SIDES] > 0:
        speed += abs(p[tb.SPIN]) * p[tb.SIZE]
    if world.hulls.forms[b, tb.SIDES] > 0:
        speed += abs(q[tb.SPIN]) * q[tb.SIZE]
    return float(EPSILON * (16 * length + 4 * speed * time))
