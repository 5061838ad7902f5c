"""Many worlds, one after another in the arrays of one: each is put where it starts, and stepped.

So a small world costs its steps, and no call. Each has the bits that it has alone.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.step import step
from tamias2d.engine.tables import Columns, World
from tamias2d.kernels.arrays import FloatBlocks, FloatRows, Ranks
from tamias2d.state import Array

# how a world starts: gravity, m/s^2, then of each body, by rows
GRAVITY = 2
_start = Columns()
START_POSE = _start(3)  # m, m, rad
START_VELOCITY = _start(3)  # m/s, m/s, rad/s
START_LOAD = _start(3)  # N, N, N m
START_INVERSE = _start(2)  # 1/kg, 1/(kg m^2)
START_SURFACE = _start(2)  # friction and restitution
START = _start.width


def step_worlds(
    world: World, memory: Ranks, start: Ranks, given: FloatRows, stops: Ranks, states: FloatBlocks
) -> int:
    """Step worlds until one of them needs to be looked at; return how many are done.

    `memory` holds all arrays of the world, `start` what its first part holds before the first step,
    `given` (k, 2 + 13 n) how each world starts. At the sorted `stops` (s,), in steps, coordinates
    and velocities are written to `states` (k, s, 6 n), row after row.
    """
    done = 0
    while done < len(given):
        for k in range(len(start)):
            memory[k] = start[k]
        begin_world(given[done], world)
        if not step_to_stops(stops, states[done], world):
            return done
        done += 1
    return done


def begin_world(given: Array, world: World) -> None:
    """Put the values of a world where they belong."""
    state, bodies = world.state, world.bodies
    settings = world.control.settings
    settings[tb.GRAVITY_X], settings[tb.GRAVITY_Y] = given[0], given[1]
    size = (len(given) - GRAVITY) // START
    for b in range(size):
        own, slot = given[GRAVITY + START * b :], state.slot_of_body[b]
        for n in range(3):
            state.pose[b, n] = own[START_POSE + n]
            state.velocity[b, n] = own[START_VELOCITY + n]
            state.load[b, n] = own[START_LOAD + n]
        for n in range(2):
            state.properties[b, tb.INVERSE_MASS + n] = own[START_INVERSE + n]
            bodies.properties[slot, tb.INVERSE_MASS + n] = own[START_INVERSE + n]
    material = world.shapes.material
    for s in range(len(material)):
        b = state.body_of_shape[s]
        if b < size:
            own = given[GRAVITY + START * b :]
            for n in range(2):
                material[s, tb.FRICTION + n] = own[START_SURFACE + n]


def step_to_stops(stops: Ranks, states: Array, world: World) -> bool:
    """Step a world to all stops; return whether it got there, and there is nothing to tell."""
    counts = world.control.counts
    for k in range(len(stops)):
        while counts[tb.STEPS_TAKEN] < stops[k]:
            status = step(world, stops[k] - counts[tb.STEPS_TAKEN])
            if status != tb.DONE and status != tb.CLEAR:
                return False
        note_state(states[k], world)
    return bool(counts[tb.LIMITS] == 0)


def note_state(states: Array, world: World) -> None:
    """Note the coordinates and velocities of all bodies, row after row."""
    pose, velocity = world.state.pose, world.state.velocity
    size = len(states) // 6
    for n in range(3):
        for b in range(size):
            states[n * size + b] = pose[b, n]
            states[(3 + n) * size + b] = velocity[b, n]
