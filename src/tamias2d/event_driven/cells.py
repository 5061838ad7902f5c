"""Who is near to a body: a grid of cells, in each of which its bodies are listed.

A body belongs to a cell until its centre has left it by a little more than a side (`SLACK`), so
that none goes back and forth along a side. Cells are so large that bodies that touch are in one, or
in neighbours; those at the rim have no end outwards. What is larger, and a half-plane, is near to
all.
"""

from math import floor, inf

from tamias2d.event_driven.approach import root, state_at
from tamias2d.event_driven.tables import (
    ACROSS,
    AX,
    AY,
    BEFORE,
    CELL,
    NEXT,
    NORMAL_X,
    NORMAL_Y,
    OFFSET,
    ORIGIN_X,
    ORIGIN_Y,
    PLANE,
    RADIUS,
    SLACK,
    UP,
    World,
    X,
    Y,
)
from tamias2d.kernels.assembled import inlined


def gather(k: int, world: World) -> int:
    """List the bodies that are near to one; return how many."""
    count = 0
    if world.notes[k, ACROSS] < 0:
        for other in range(len(world.kinds)):
            if other != k:
                world.near[count] = other
                count += 1
        return count
    for other in world.everywhere:
        if world.kinds[other] != PLANE or reaches(k, other, world):
            world.near[count] = other
            count += 1
    across, up = world.cells.shape
    left, low = world.notes[k, ACROSS], world.notes[k, UP]
    for column in range(max(left - 1, 0), min(left + 2, across)):
        for row in range(max(low - 1, 0), min(low + 2, up)):
            other = world.cells[column, row] - 1
            while other >= 0:
                if other != k:
                    world.near[count] = other
                    count += 1
                other = world.notes[other, NEXT] - 1
    return count


@inlined
def reaches(k: int, plane: int, world: World) -> bool:
    """Return whether a body may reach a half-plane from its cell."""
    across, up = world.cells.shape
    column, row = world.notes[k, ACROSS], world.notes[k, UP]
    if column == 0 or row == 0 or column == across - 1 or row == up - 1:
        return True
    half = world.numbers[CELL] / 2.0
    x = world.numbers[ORIGIN_X] + world.numbers[CELL] * column + half
    y = world.numbers[ORIGIN_Y] + world.numbers[CELL] * row + half
    body, wall = world.bodies[k], world.bodies[plane]
    ux, uy = wall[NORMAL_X], wall[NORMAL_Y]
    reach = (half + 2.0 * world.numbers[SLACK]) * (abs(ux) + abs(uy)) + body[RADIUS]
    away = ux * (x - world.paths[plane, X]) + uy * (y - world.paths[plane, Y]) - wall[OFFSET]
    return bool(away <= reach)


@inlined
def enter(k: int, time: float, world: World) -> None:
    """Put a body into the cell in which it is, and find when it leaves it."""
    state = state_at(k, time, world.paths)
    across, up = world.cells.shape
    column = cell_of(state[0] - world.numbers[ORIGIN_X], across, world.numbers[CELL])
    row = cell_of(state[1] - world.numbers[ORIGIN_Y], up, world.numbers[CELL])
    note = world.notes[k]
    note[ACROSS], note[UP], note[BEFORE] = column, row, 0
    note[NEXT] = world.cells[column, row]
    if note[NEXT] > 0:
        world.notes[note[NEXT] - 1, BEFORE] = k + 1
    world.cells[column, row] = k + 1


@inlined
def leave(k: int, world: World) -> None:
    """Take a body out of its cell."""
    note = world.notes[k]
    if note[BEFORE] > 0:
        world.notes[note[BEFORE] - 1, NEXT] = note[NEXT]
    else:
        world.cells[note[ACROSS], note[UP]] = note[NEXT]
    if note[NEXT] > 0:
        world.notes[note[NEXT] - 1, BEFORE] = note[BEFORE]


def cell_of(distance: float, count: int, size: float) -> int:
    """Return the number of a cell in a row of them; of the outermost one for what is beyond."""
    return floor(min(max(distance / size, 0.0), count - 1.0))


@inlined
def time_of_leaving(k: int, time: float, world: World) -> float:
    """Return when a body leaves its cell, s, if nothing happens to it; infinity if never."""
    if world.notes[k, ACROSS] < 0:
        return inf
    x, y, _, u, v, _ = state_at(k, time, world.paths)
    across, up = world.cells.shape
    path, numbers = world.paths[k], world.numbers
    column, row = world.notes[k, ACROSS], world.notes[k, UP]
    first = time_of_crossing(
        x - numbers[ORIGIN_X], u, path[AX], column, across, numbers[CELL], numbers[SLACK]
    )
    second = time_of_crossing(
        y - numbers[ORIGIN_Y], v, path[AY], row, up, numbers[CELL], numbers[SLACK]
    )
    return time + min(first, second)


def time_of_crossing(
    place: float,
    speed: float,
    acceleration: float,
    cell: int,
    count: int,
    size: float,
    slack: float,
) -> float:
    """Return how long a body stays between two sides of a cell, s, where it has neighbours."""
    found = inf
    if cell > 0:
        gap = place - (cell * size - slack)
        found = root(max(gap, 0.0), speed, acceleration)
    if cell < count - 1:
        gap = (cell + 1) * size + slack - place
        found = min(found, root(max(gap, 0.0), -speed, -acceleration))
    return found
