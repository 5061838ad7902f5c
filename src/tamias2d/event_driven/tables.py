"""The tables of discs and half-planes that are followed from impact to impact.

Every number that the compiled code reads or writes is in a group of arrays; each column has a name
here.
"""

from typing import NamedTuple, TypeAlias

from tamias2d.kernels.arrays import (
    FloatBlocks,
    FloatRows,
    Floats,
    IndexRows,
    Indices,
    Ranks,
)

Moving: TypeAlias = tuple[float, float, float, float, float, float]
"""x, y, m; orientation, rad; velocity, m/s; angular velocity, rad/s"""
Pair: TypeAlias = tuple[float, float]

# of a body: its start and what acts on it, then what it is
X, Y, TURN, VX, VY, SPIN, AX, AY, TURNING, INVERSE_MASS, INVERSE_INERTIA, RADIUS = range(12)
NORMAL_X, NORMAL_Y, OFFSET = range(12, 15)
RESTITUTION, FRICTION = range(15, 17)  # its own; below 0 where it states none
COLUMNS = 17
START = 9  # of a path, after its state and its acceleration, s
PATH_COLUMNS = 10
PARTICLE, PLANE, FIXED_DISC, DISC = range(4)  # kinds of bodies; only the last one is pushed
MOVING_PARTICLE = 4

# of a body, as it is followed: samples written, support + 1, paths without advance, paths so far;
# its cell, 0 to the right and upwards, and its neighbours in the list of the cell, each + 1
TOLD, HELD_BY, STALLED, VERSION, ACROSS, UP, NEXT, BEFORE = range(8)
NOTE_COLUMNS = 8
WITH, LAST, BEST, DOUBT = range(4)  # of a body that bounces: the other + 1, when the bounces end, s
FIRST, SECOND, FIRST_VERSION, SECOND_VERSION = range(4)  # of an event; one body twice: it leaves
EVENT_COLUMNS = 4
# of a departure: the body, its path from then on
DEPARTURE_COLUMNS = 1 + PATH_COLUMNS
# of an impact
TIME, A, B, POINT_X, POINT_Y, ALONG_X, ALONG_Y, IMPULSE, NORMAL_VELOCITY = range(9)
IMPACT_COLUMNS = 9

# numbers of a run: how far it is, how far to go now and at most, s; how it is divided into cells, m
NOW, LIMIT, END, CELL, SLACK, ORIGIN_X, ORIGIN_Y = range(7)
NUMBERS = 7
EVENTS, IMPACTS, DEPARTURES, CHANGED, MEETING, OTHER, SETTLES, AT_START, LOOKED_AT = range(9)
COUNTS = 9

NOWHERE = -1.0  # of a body that is in no cell yet, instead of when it leaves it

DONE, FULL, CROWDED, INSTANT, SEARCH = range(5)
"""Why it ends: the limit is reached; the records are full; the queue is; an instant or a search is
not decided."""


class World(NamedTuple):
    """n bodies, what is known of them, and what is recorded."""

    numbers: Floats
    counts: Ranks
    kinds: Indices
    """(n,)"""
    bodies: FloatRows
    """(n, 17)"""
    pairs: Ranks
    """(p,): n times the first body plus the second, in order, of pairs with laws of their own"""
    laws: FloatRows
    """(p, 2): restitution and friction of these, below 0 where it is not theirs"""
    paths: FloatRows
    """(n, 10)"""
    notes: IndexRows
    """(n, 8)"""
    bounces: FloatRows
    """(n, 4)"""
    leaving: Floats
    """(n,): when a body leaves its cell, s"""
    cells: IndexRows
    """(across, up): the first body of a cell + 1"""
    everywhere: Indices
    """The bodies that are in no cell, and near to all: half-planes and the largest discs."""
    changed: Indices
    """(n,): the bodies whose paths are new"""
    near: Indices
    """(n,): the bodies that may be near to one"""
    queue: Floats
    """The times of the events, s, as a heap."""
    events: IndexRows
    times: Floats
    """(k,): of samples, s"""
    samples: FloatRows
    """(k n, 6)"""
    impacts: FloatRows
    departures: FloatRows
    """The new paths; without rows, none are recorded."""


class Worlds(NamedTuple):
    """Worlds of the same bodies: what they start with, and what comes out."""

    world: World
    """The one that is being followed."""
    bodies: FloatBlocks
    """(w, n, 17)"""
    laws: FloatBlocks
    """(w, p, 2)"""
    samples: FloatBlocks
    """(w, k n, 6)"""
    status: Indices
    """(w,): 1 where a world was followed to the end"""
