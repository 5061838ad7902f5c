"""Two bodies at hand, as they stand at an instant: `contact.core.Placed` as rows of tables."""

from math import cos, inf, sin

from tamias2d.event_driven.approach import EPSILON, state_at
from tamias2d.event_driven.tables import (
    AX,
    AY,
    BEGIN,
    BOUND,
    CORNER_X,
    CORNER_Y,
    CORNERS,
    OFFSET,
    PLACED_NORMAL_X,
    PLACED_NORMAL_Y,
    PLACED_X,
    PLACED_Y,
    PLANE,
    RADIUS,
    ROUND,
    ROUND_STAND,
    ROUNDING,
    SHAPE_COLUMNS,
    SIDE_X,
    SIDE_Y,
    SIDES,
    SIZE,
    SPIN,
    STAND_COLUMNS,
    START,
    START_SPIN,
    TURN,
    TURNING,
    VX,
    VY,
    World,
    X,
    Y,
)


def stand(place: int, k: int, time: float, world: World) -> None:
    """Put a body at hand, without its corners, as it is at a time, s."""
    row, path, body = world.hulls.stands[place], world.paths[k], world.bodies[k]
    row[X], row[Y], row[TURN], row[VX], row[VY], row[SPIN] = state_at(k, time, world.paths)
    row[AX], row[AY], row[TURNING], row[START] = path[AX], path[AY], path[TURNING], path[START]
    row[START_SPIN], row[ROUND] = path[SPIN], body[ROUNDING]
    plane = world.kinds[k] == PLANE
    row[BOUND] = inf if plane else body[RADIUS]
    row[SIZE] = abs(body[OFFSET]) if plane else body[RADIUS]
    for column in range(SHAPE_COLUMNS):
        world.hulls.forms[place, column] = world.hulls.shapes[k, column]


def turn(place: int, world: World) -> None:
    """Turn the corners and sides of a body at hand to where they are."""
    angle, form = world.hulls.stands[place, TURN], world.hulls.forms[place]
    straight = angle == 0.0 or form[CORNERS] == 1
    c, s = (1.0, 0.0) if straight else (cos(angle), sin(angle))
    for k in range(max(form[CORNERS], form[SIDES])):
        row, local = world.hulls.placed[place, k], world.hulls.outline[form[BEGIN] + k]
        x, y, nx, ny = local[CORNER_X], local[CORNER_Y], local[SIDE_X], local[SIDE_Y]
        row[PLACED_X] = x if straight else c * x - s * y
        row[PLACED_Y] = y if straight else s * x + c * y
        row[PLACED_NORMAL_X], row[PLACED_NORMAL_Y] = c * nx - s * ny, s * nx + c * ny


def round_off(place: int, world: World) -> None:
    """Put at hand the disc around a body at hand."""
    row, body = world.hulls.stands[ROUND_STAND], world.hulls.stands[place]
    for column in range(STAND_COLUMNS):
        row[column] = body[column]
    row[ROUND] = row[BOUND]
    form, corner = world.hulls.forms[ROUND_STAND], world.hulls.placed[ROUND_STAND, 0]
    form[BEGIN], form[CORNERS], form[SIDES] = 0, 1, 0
    corner[PLACED_X] = corner[PLACED_Y] = 0.0


def resolution_of(a: int, b: int, time: float, world: World) -> float:
    """Return the gap in m between two bodies at hand that float64 cannot tell from 0."""
    p, q = world.hulls.stands[a], world.hulls.stands[b]
    length = abs(p[X]) + abs(p[Y]) + abs(q[X]) + abs(q[Y]) + p[SIZE] + q[SIZE]
    speed = abs(q[VX] - p[VX]) + abs(q[VY] - p[VY])
    if world.hulls.forms[a, SIDES] > 0:
        speed += abs(p[SPIN]) * p[SIZE]
    if world.hulls.forms[b, SIDES] > 0:
        speed += abs(q[SPIN]) * q[SIZE]
    return float(EPSILON * (16 * length + 4 * speed * time))
