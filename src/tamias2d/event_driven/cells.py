"""Who is near to a body: a grid of cells, in each of which its bodies are listed.

A body belongs to a cell until its centre has left it by a little more than a side (`SLACK`), so
that none goes back and forth along a side. Cells are so large that bodies that touch are in one, or
in neighbours; those at the rim have no end outwards. What is larger, and a half-plane, is near to
all.
"""

from math import floor, inf

from tamias2d.event_driven import tables as tb
from tamias2d.event_driven.approach import root, state_at
from tamias2d.event_driven.tables import World
from tamias2d.kernels.assembled import inlined


def gather(k: int, world: World) -> int:
    """List the bodies that are near to one; return how many."""
    count = 0
    if world.notes[k, tb.ACROSS] < 0:
        for other in range(len(world.kinds)):
            if other != k:
                world.near[count] = other
                count += 1
        return count
    for other in world.everywhere:
        if world.kinds[other] != tb.PLANE or reaches(k, other, world):
            world.near[count] = other
            count += 1
    across, up = world.cells.shape
    left, low = world.notes[k, tb.ACROSS], world.notes[k, tb.UP]
    for column in range(max(left - 1, 0), min(left + 2, across)):
        for row in range(max(low - 1, 0), min(low + 2, up)):
            other = world.cells[column, row] - 1
            while other >= 0:
                if other != k:
                    world.near[count] = other
                    count += 1
                other = world.notes[other, tb.NEXT] - 1
    return count


@inlined
def reaches(k: int, plane: int, world: World) -> bool:
    """Return whether a body may reach a half-plane from its cell."""
    across, up = world.cells.shape
    column, row = world.notes[k, tb.ACROSS], world.notes[k, tb.UP]
    if column == 0 or row == 0 or column == across - 1 or row == up - 1:
        return True
    half = world.numbers[tb.CELL] / 2.0
    x = world.numbers[tb.ORIGIN_X] + world.numbers[tb.CELL] * column + half
    y = world.numbers[tb.ORIGIN_Y] + world.numbers[tb.CELL] * row + half
    body, wall = world.bodies[k], world.bodies[plane]
    ux, uy = wall[tb.NORMAL_X], wall[tb.NORMAL_Y]
    reach = (half + 2.0 * world.numbers[tb.SLACK]) * (abs(ux) + abs(uy)) + body[tb.RADIUS]
    away = (
        ux * (x - world.paths[plane, tb.X]) + uy * (y - world.paths[plane, tb.Y]) - wall[tb.OFFSET]
    )
    return bool(away <= reach)


@inlined
def enter(k: int, time: float, world: World) -> None:
    """Put a body into the cell in which it is, and find when it leaves it."""
    state = state_at(k, time, world.paths)
    across, up = world.cells.shape
    column = cell_of(state[0] - world.numbers[tb.ORIGIN_X], across, world.numbers[tb.CELL])
    row = cell_of(state[1] - world.numbers[tb.ORIGIN_Y], up, world.numbers[tb.CELL])
    note = world.notes[k]
    note[tb.ACROSS], note[tb.UP], note[tb.BEFORE] = column, row, 0
    note[tb.NEXT] = world.cells[column, row]
    if note[tb.NEXT] > 0:
        world.notes[note[tb.NEXT] - 1, tb.BEFORE] = k + 1
    world.cells[column, row] = k + 1


@inlined
def leave(k: int, world: World) -> None:
    """Take a body out of its cell."""
    note = world.notes[k]
    if note[tb.BEFORE] > 0:
        world.notes[note[tb.BEFORE] - 1, tb.NEXT] = note[tb.NEXT]
    else:
        world.cells[note[tb.ACROSS], note[tb.UP]] = note[tb.NEXT]
    if note[tb.NEXT] > 0:
        world.notes[note[tb.NEXT] - 1, tb.BEFORE] = note[tb.BEFORE]


def cell_of(distance: float, count: int, size: float) -> int:
    """Return the number of a cell in a row of them; of the outermost one for what is beyond."""
    return floor(min(max(distance / size, 0.0), count - 1.0))


@inlined
def time_of_leaving(k: int, time: float, world: World) -> float:
    """Return when a body leaves its cell, s, if nothing happens to it; infinity if never."""
    if world.notes[k, tb.ACROSS] < 0:
        return inf
    x, y, _, u, v, _ = state_at(k, time, world.paths)
    across, up = world.cells.shape
    path, numbers = world.paths[k], world.numbers
    column, row = world.notes[k, tb.ACROSS], world.notes[k, tb.UP]
    first = time_of_crossing(
        x - numbers[tb.ORIGIN_X],
        u,
        path[tb.AX],
        column,
        across,
        numbers[tb.CELL],
        numbers[tb.SLACK],
    )
    second = time_of_crossing(
        y - numbers[tb.ORIGIN_Y], v, path[tb.AY], row, up, numbers[tb.CELL], numbers[tb.SLACK]
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
