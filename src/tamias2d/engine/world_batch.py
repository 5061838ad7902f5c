"""Many worlds, one after another in the arrays of one: each is put where it starts, and stepped.

So a small world costs its steps, and no call. Each has the bits that it has alone.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.step import step
from tamias2d.engine.tables import Columns, Integers, World
from tamias2d.kernels.arrays import FloatBlocks, FloatRows, RankRows, Ranks
from tamias2d.state import Array

# how a world starts: gravity, m/s^2, then of each body, in the order of the scene
GRAVITY = 2
_start = Columns()
START_POSE = _start(3)  # m, m, rad
START_VELOCITY = _start(3)  # m/s, m/s, rad/s
START_LOAD = _start(3)  # N, N, N m
START_INVERSE = _start(2)  # 1/kg, 1/(kg m^2)
START_SURFACE = _start(3)  # friction, restitution, m/s
START = _start.width


def step_worlds(
    world: World,
    memory: Ranks,
    start: Ranks,
    rows: Ranks,
    given: FloatRows,
    stands_for: RankRows,
    stops: Ranks,
    states: FloatBlocks,
) -> int:
    """Step the worlds of some rows until one needs to be looked at; return how many are done.

    `memory` holds all arrays of the world, `start` what its first part holds before the first step,
    `given` (w, 2 + 13 n) how each world starts, `stands_for` (w, n) for which body of its scene
    each body of the world at hand stands. At the sorted `stops` (s,), in steps, coordinates and
    velocities of the bodies of the scene are written to `states` (w, s, 6 n), row after row.
    """
    done = 0
    while done < len(rows):
        k = rows[done]
        for n in range(len(start)):
            memory[n] = start[n]
        begin_world(given[k], stands_for[k], world)
        if not step_to_stops(stops, stands_for[k], states[k], world):
            return done
        done += 1
    return done


def begin_world(given: Array, stands_for: Integers, world: World) -> None:
    """Put the values of a world where they belong."""
    state, bodies = world.state, world.bodies
    settings = world.control.settings
    settings[tb.GRAVITY_X], settings[tb.GRAVITY_Y] = given[0], given[1]
    size = (len(given) - GRAVITY) // START
    for b in range(size):
        own, slot = given[GRAVITY + START * stands_for[b] :], state.slot_of_body[b]
        for n in range(3):
            state.pose[b, n] = own[START_POSE + n]
            state.velocity[b, n] = own[START_VELOCITY + n]
            state.load[b, n] = own[START_LOAD + n]
        for n in range(2):
            state.properties[b, tb.INVERSE_MASS + n] = own[START_INVERSE + n]
            bodies.properties[slot, tb.INVERSE_MASS + n] = own[START_INVERSE + n]
    material, stated = world.shapes.material, world.shapes.stated
    for s in range(len(material)):
        b = state.body_of_shape[s]
        if b < size:
            own = given[GRAVITY + START * stands_for[b] :]
            for n in (tb.FRICTION, tb.RESTITUTION):
                if stated[s, tb.BY_PART + n] < 0.0:
                    material[s, n] = own[START_SURFACE + n]
            material[s, tb.SURFACE_SPEED] = own[START_SURFACE + tb.SURFACE_SPEED]


def step_to_stops(stops: Ranks, stands_for: Integers, states: Array, world: World) -> bool:
    """Step a world to all stops; return whether it got there, and there is nothing to tell."""
    counts = world.control.counts
    for k in range(len(stops)):
        while counts[tb.STEPS_TAKEN] < stops[k]:
            status = step(world, stops[k] - counts[tb.STEPS_TAKEN])
            if status != tb.DONE and status != tb.CLEAR:
                return False
        note_state(stands_for, states[k], world)
    return bool(counts[tb.LIMITS] == 0)


def note_state(stands_for: Integers, states: Array, world: World) -> None:
    """Note the coordinates and velocities of all bodies of the scene, row after row."""
    pose, velocity = world.state.pose, world.state.velocity
    size = len(stands_for)
    for n in range(3):
        for b in range(size):
            states[n * size + stands_for[b]] = pose[b, n]
            states[(3 + n) * size + stands_for[b]] = velocity[b, n]
