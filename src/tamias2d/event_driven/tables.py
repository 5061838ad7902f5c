"""The tables of bodies that are followed from impact to impact.

Every number that the compiled code reads or writes is in a group of arrays; each column has a name
here, which the modules around read as `tb.NAME`.
"""

from typing import NamedTuple, TypeAlias

from tamias2d.kernels.arrays import FloatBlocks, FloatRows, Floats, IndexRows, Indices, Ranks

Moving: TypeAlias = tuple[float, float, float, float, float, float]
"""x, y, m; orientation, rad; velocity, m/s; angular velocity, rad/s"""
Pair: TypeAlias = tuple[float, float]
Point: TypeAlias = tuple[float, float, float, float, float, float]
"""Where a pair touches: the axis from P to Q, the corners of Q and of P, m; (0, 0) for a side"""

# of a body: its start and what acts on it, then what it is
X, Y, TURN, VX, VY, SPIN, AX, AY, TURNING, INVERSE_MASS, INVERSE_INERTIA, RADIUS = range(12)
NORMAL_X, NORMAL_Y, OFFSET = range(12, 15)
RESTITUTION, FRICTION = range(15, 17)  # its own; below 0 where it states none
ROUNDING = 17  # how far it reaches beyond its corners, m; `RADIUS` is how far beyond its centre
COLUMNS = 18
START = 9  # of a path, after its state and its acceleration, s
PATH_COLUMNS = 10
# kinds of bodies: a hull has corners; from PLANE on they are solid, from DISC on they are pushed
PARTICLE, MOVING_PARTICLE, PLANE, FIXED_DISC, FIXED_HULL, DISC, HULL = range(7)

# of a body's outline: where it begins, how many corners and sides it has
BEGIN, CORNERS, SIDES = range(3)
SHAPE_COLUMNS = 3
# of a corner and the side after it, about the body's centre and in its axes
CORNER_X, CORNER_Y, REACH, SIDE_X, SIDE_Y, SIDE_OFFSET, LOW, HIGH = range(8)
OUTLINE_COLUMNS = 8
PLACED_X, PLACED_Y, PLACED_NORMAL_X, PLACED_NORMAL_Y = range(4)  # of these, in the world's axes
PLACED_COLUMNS = 4
# of a body that is looked at, after its state, its acceleration and when its path starts, s: the
# angular velocity there, and how far it reaches
START_SPIN, BOUND, ROUND, SIZE = range(10, 14)
STAND_COLUMNS = 14
FIRST_STAND, SECOND_STAND, ROUND_STAND, STANDS = range(4)
# of an axis: its direction from P to Q, the least gap along it, m; then whether P is the second
# of the pair, and the side of P, below 0 if it has none
AXIS_X, AXIS_Y, AXIS_GAP = range(3)
AXIS_COLUMNS = 3
SWAPPED, SIDE = range(2)
OWNER_COLUMNS = 2
# of a gap: its size, m, and rate, m/s; how far off the corners are; the corners of Q and P
GAP, RATE, REACH_P, REACH_Q, Q_X, Q_Y, P_X, P_Y = range(8)
GAP_COLUMNS = 8
# of a search: the direction in which the pair was last apart, whether there is one, whether it
# touches now; the distance of the centres, m
SEEN_X, SEEN_Y, IS_SEEN, TOUCHES, DISTANCE = range(5)
SEARCH_COLUMNS = 5

# of a body, as it is followed: samples written, support + 1, paths without advance, paths so far;
# its cell, 0 to the right and upwards, and its neighbours in the list of the cell, each + 1
TOLD, HELD_BY, STALLED, VERSION, ACROSS, UP, NEXT, BEFORE = range(8)
# at an instant: whether it was struck, and the touching pair + 1 in which it stays
STRUCK, SUPPORT = range(8, 10)
NOTE_COLUMNS = 10
WITH, LAST, BEST, DOUBT = range(4)  # of a body that bounces: the other + 1, when the bounces end, s
SEVERAL = -1.0  # of a body that bounces on more than one other, instead of the other + 1
FIRST, SECOND, FIRST_VERSION, SECOND_VERSION = range(4)  # of an event; one body twice: it leaves
EVENT_COLUMNS = 4
# of a departure: the body, its path from then on
DEPARTURE_COLUMNS = 1 + PATH_COLUMNS
# of a touching pair: its bodies (`FIRST`, `SECOND`), whether it has lasted, whether it approaches
LASTS, COMES = range(2, 4)
TOUCHING_COLUMNS = 4
# the normal from the first to the second, against that from P to Q; arms, m; which velocity is
# none, and the speed by which that is judged, m/s; which gap is none, m
NORMAL, SIGN, ARM_A, ARM_B, NOISE, SPEED, TOLERANCE = 0, 2, 3, 5, 7, 8, 9
CORNER_Q, CORNER_P, SIDED = 10, 12, 14  # of the point, m, and whether P has a side there
CONTACT_COLUMNS = 15
MOST_TOUCHING = 32  # pairs of one instant
# of an impact
TIME, A, B, POINT_X, POINT_Y, ALONG_X, ALONG_Y, IMPULSE, NORMAL_VELOCITY = range(9)
IMPACT_COLUMNS = 9

# numbers of a run: how far it is, how far to go now and at most, s; how it is divided into cells, m
NOW, LIMIT, END, CELL, SLACK, ORIGIN_X, ORIGIN_Y = range(7)
NUMBERS = 7
(
    EVENTS, IMPACTS, DEPARTURES, CHANGED, MEETING, OTHER, SETTLES, AT_START, LOOKED_AT, RULED,
    STAYED, CLUSTER, TOUCHINGS,
) = range(13)  # fmt: skip
COUNTS = 13

NOWHERE = -1.0  # of a body that is in no cell yet, instead of when it leaves it

LANES = 16
# of bodies as lanes, one column after the other: path, outline; how far off the numbers are, m
(
    LANE_X, LANE_Y, LANE_U, LANE_V, LANE_AX, LANE_AY, LANE_START, LANE_PLANE, LANE_NX, LANE_NY,
    LANE_OFFSET, LANE_RADIUS, LANE_FAR,
) = range(0, 13 * LANES, LANES)  # fmt: skip
LANE_COLUMNS = 13
# of these now: where they are, how fast, how far off all numbers are; then, as one body sees them,
# how far away, and for how long they do not meet it, s
NOW_X, NOW_Y, NOW_U, NOW_V, NOW_FAR, NOW_GAP, NOW_TIME = range(0, 7 * LANES, LANES)
NOW_COLUMNS = 7
BLUR = -1e300  # instead of how far, where float64 cannot tell
UNLIKE = -1.0  # instead of that time, of a disc that is accelerated otherwise

DONE, FULL, CROWDED, INSTANT, SEARCH = range(5)
"""Why it ends: the limit is reached; the records are full; the queue is; an instant or a search is
not decided."""


class Hulls(NamedTuple):
    """The outlines of n bodies, and where a search has two of them at hand (`stand`)."""

    shapes: IndexRows
    """(n, 3)"""
    outline: FloatRows
    """(c, 8): the corners and sides of all"""
    stands: FloatRows
    """(3, 14): both bodies of a pair, and the disc around one"""
    forms: IndexRows
    """(3, 3): their rows of `shapes`"""
    placed: FloatBlocks
    """(3, m, 4): their corners and sides"""
    axes: FloatRows
    """(2 m, 3)"""
    owners: IndexRows
    """(2 m, 2)"""
    gaps: FloatRows
    """(m m, 8): along one axis"""
    search: Floats
    """(5,)"""


class World(NamedTuple):
    """n bodies, what is known of them, and what is recorded."""

    numbers: Floats
    counts: Ranks
    kinds: Indices
    """(n,)"""
    bodies: FloatRows
    """(n, 18)"""
    hulls: Hulls
    pairs: Ranks
    """(p,): n times the first body plus the second, in order, of pairs with laws of their own"""
    laws: FloatRows
    """(p, 2): restitution and friction of these, below 0 where it is not theirs"""
    paths: FloatRows
    """(n, 10)"""
    notes: IndexRows
    """(n, 10)"""
    bounces: FloatRows
    """(n, 4)"""
    leaving: Floats
    """(n,): when a body leaves its cell, s"""
    sliding: Floats
    """(n,): until when a disc slides that stays on a half-plane, s; infinite where none does"""
    cells: IndexRows
    """(across, up): the first body of a cell + 1"""
    everywhere: Indices
    """The bodies that are in no cell, and near to all: half-planes and the largest bodies."""
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
    standing: FloatRows
    """(n, 6): the states of bodies at an instant"""
    cluster: Indices
    """(n,): the pushed ones that touch there"""
    touchings: IndexRows
    """(32, 4): the pairs that touch there"""
    contacts: FloatRows
    """(32, 15): how they touch"""


class Few(NamedTuple):
    """A table of pairs of few bodies, instead of a queue and cells."""

    bodies: Floats
    """(13 * 16,): what the bodies are, as lanes"""
    now: Floats
    """(7 * 16,): where they are now"""
    times: FloatRows
    """(16, 16): when a pair meets, or before when it does not, s"""
    exact: IndexRows
    """(16, 16): 1 where it is the first of these"""
    least: Floats
    """(16,): the least time of a row, s"""
    partner: Indices
    """(16,): whose it is"""


class Worlds(NamedTuple):
    """Worlds of the same bodies: what they start with, and what comes out."""

    world: World
    """The one that is being followed."""
    few: Few
    """For bodies that are few and without corners."""
    bodies: FloatBlocks
    """(w, n, 18)"""
    laws: FloatBlocks
    """(w, p, 2)"""
    samples: FloatBlocks
    """(w, k n, 6)"""
    status: Indices
    """(w,): 1 where a world was followed to the end"""
