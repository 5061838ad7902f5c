"""The state of the engine: groups of arrays, and what each column of them holds.

Allocation, growth, saving and the entries of compiled code follow from these declarations. Each
column has a line with its name, unit and meaning; a new one is a new line. The groups by slot hold
bodies in canonical order, so that bodies that are near in the world are near in memory; the last
slot is an idle body, all zeros, for lanes of a block that have no contact. The engine imports the
groups by their names, and this module as `tb` for all else: `pose[slot, tb.ANGLE]`.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated, Any, NamedTuple, TypeAlias

from numpy.typing import NDArray

from tamias2d.kernels.arrays import (
    Bytes,
    FloatBlocks,
    FloatRows,
    Floats,
    IndexBlocks,
    IndexRows,
    Indices,
    PlaceBlocks,
    PlaceRows,
    Places,
    RankRows,
    Ranks,
)
from tamias2d.kernels.lanes import LANES
from tamias2d.spec.row_program import OUTPUTS

Integers: TypeAlias = NDArray[Any]
"""An array of whole numbers of any width."""


class Columns:
    """The columns of an array: each call returns the next one, or the first of several."""

    def __init__(self, each: int = 1) -> None:
        """Begin with none; each is so many numbers wide, unless a call says otherwise."""
        self.width, self.each = 0, each

    def __call__(self, width: int = 0) -> int:
        """Return the first number of the next column."""
        first = self.width
        self.width += width or self.each
        return first


@dataclass(frozen=True)
class Sized:
    """The length of an array along each axis: a number, or the name of a capacity in `world`."""

    shape: tuple[int | str, ...]

    def __init__(self, *shape: int | str) -> None:
        object.__setattr__(self, "shape", shape)


@dataclass(frozen=True)
class Saved:
    """Marks an array of the saved state; all others follow from these, or hold nothing for long.

    Whole numbers are from 0 on and less than `below`: a number, or the capacity whose rows they
    index. Where that is so in some columns only, `below` has the bound of each. Other numbers are
    finite, unless they may be infinite, or may be anything because each step looks at them first.
    """

    below: int | str | Mapping[int, int | str] | None = None
    numbers: str = "finite"  # or "infinite", "any"


class Rewritten:
    """Marks an array in which no step reads what it has not written since contacts were arranged.

    A world that begins anew needs nothing in it.
    """


# -- control of a step

_settings = Columns()
GRAVITY_X = _settings()  # m/s^2
GRAVITY_Y = _settings()  # m/s^2
TIME_STEP = _settings()  # s, of a whole step
SUBSTEP = _settings()  # s, of the last part that was solved

_control = Columns()
SUBSTEPS = _control()  # of a step
STEPS_LEFT = _control()  # steps of this call that are still to be taken
STAGE = _control()  # at which the step continues, one of those below
ROWS_NEEDED = _control()  # by the array that was too short
STEPS_TAKEN = _control()  # since the start
TICK = _control()  # at which a part of the step begins; a step has 2**MOST_LEVEL of them
LEVEL = _control()  # a part is this power of a half of the step
GOES_FAR = _control()  # 1 if a body goes farther in this part than a fraction of its width
START_NOTED = _control()  # 1 if the part can be taken again, as shorter ones
DISAGREE = _control()  # 1 if joints and contacts made much energy in this part
RETAKEN = _control()  # 1 if the part was begun before, and was too long
LEAST_LEVEL = _control()  # of the parts of this step: longer ones had too many impacts
FINEST = _control()  # level of the shortest part of the last step
PART_SUBSTEPS = _control()  # of a part
SUNK_A = _control()  # slot, plus 1, of a body that another sinks into; 0 for none so far
SUNK_B = _control()  # of the other one
OUTWEIGHED = _control()  # slot, plus 1, of a body of an island of masses too different to be solved
LIMITS = _control()  # how often something was found to tell: of these two, or of joints
LOADS_VARY = _control()  # 1 if loads vary, and are put right as the step ends
ALL_ASLEEP = _control()  # 1 if no body was awake in the last step, and nobody came or went since
AT_START, PAIRS_STALE, PAIRS_KNOWN, MANIFOLDS_KNOWN, OUT_OF_BOUNDS, IN_FLIGHT, ARRIVING = range(7)

MOST_LEVEL = 10  # a step has up to 1024 parts

_progress = Columns()
FLOWN = _progress()  # fraction of the step that continuous collision has done
UPDATES_LEFT = _progress()  # updates of the contact list that continuous collision may still make
DEPTH_SHARE = _progress()  # of the allowed depth, up to which impacts are not looked for
PART_TIME = _progress()  # s, of a part of the step
IMPULSE_RATIO = _progress()  # of the length of a substep to that of the part before

# status of a step: done, an array that is too short, a value that is not valid, done with no
# contact on the list, done though a body has numbers that are not finite, or a part to be taken
# again
(
    DONE,
    MORE_CANDIDATES,
    MORE_CONTACTS,
    MORE_BLOCKS,
    INVALID,
    MORE_SPARSE,
    CLEAR,
    OVERFLOWED,
    AGAIN,
) = range(9)


class Control(NamedTuple):
    """What a step is asked to do, and how far it is; read by all stages."""

    settings: Annotated[Floats, Sized(_settings.width), Saved(numbers="any")]
    counts: Annotated[Ranks, Sized(_control.width)]
    progress: Annotated[Floats, Sized(_progress.width)]
    wanted: Annotated[Ranks, Sized(MOST_LEVEL + 1)]  # pairs that want a part of each level


# -- bodies

ABSENT, STATIC, KINEMATIC, DYNAMIC = range(4)  # kind

_pose = Columns()
X = _pose()  # m
Y = _pose()  # m
ANGLE = _pose()  # rad

_motion = Columns()
VX = _motion()  # m/s; these three are also the columns of a velocity alone
VY = _motion()  # m/s
SPIN = _motion()  # rad/s
_motion()  # unused: a half of a cache line is four numbers (`kernels.lanes`)
DX = _motion()  # m, displacement since the step began
DY = _motion()  # m
DANGLE = _motion()  # rad
_motion()  # unused, too

_properties = Columns()
INVERSE_MASS = _properties()  # 1/kg
INVERSE_INERTIA = _properties()  # 1/(kg m^2)
BOUNDING_RADIUS = _properties()  # m, of the circle around the body
MIN_EXTENT = _properties()  # m, half of its least width
CORE_RADIUS = _properties()  # m, distance of its farthest vertex from its centre
PROPAGATOR = _properties()  # row of its propagator
JOINED = _properties()  # 1 if a joint holds it

# propagators (DD41): v' = DECAY v + GAIN a, x' = x + GAIN v + LIFT a
DECAY, GAIN, LIFT = range(3)  # 1, s, s^2
_propagators = Columns(3)
WHOLE_STEP = _propagators()  # of the velocity
ANGULAR = _propagators()  # of the angular velocity; from ONE_SUBSTEP, too, so many columns on
ONE_SUBSTEP = _propagators()
_propagators()

_substep_state = Columns(3)  # m/s, m/s, rad/s; factors 1
CONTACT_CHANGE = _substep_state()  # change of velocity by contacts in this step
SUBSTEP_START = _substep_state()  # velocity as the substep began
DRAG_FACTOR = _substep_state()  # factor of the velocity by drag in a substep
INCREMENT = _substep_state()  # of the velocity by forces in a substep
STEP_START = _substep_state()  # velocity as the step began

_flight = Columns()
FORCE_GAIN = _flight(3)  # m/s, m/s, rad/s, velocity gained by forces in this step
# 1 if the path was redirected; more if the body follows one that cannot stop
REDIRECTED = _flight()
# 1 if the body had contacts under gravity: its velocity says little of its way
SUPPORTED = _flight()
PATH_LENGTH = _flight()  # m, that some point of the body goes
PATH_START = _flight()  # s, of a hard disc: when its path begins in the step
RESTED_ON = _flight()  # one more than the pair with the half-plane it has rested on in the step

_path = Columns()  # of a hard disc
PATH_BY = _path(3)  # m/s^2, m/s^2, rad/s^2, acceleration on its path
RESTS_ON = _path()  # one more than the pair with the half-plane it rests on; 0 in flight
SLIDES = _path()  # in which sense it slides there: 1, -1; 0 where it rolls
REST_FORCE = _path()  # N, along the normal
REST_START = _path()  # s, from when on that has to be added in this step
REST_PUSH = _path()  # N s, what it has given in this step until then


# moved: by the solver, or sleep; with contacts that change nothing; and pressed by overlaps
UNMOVED, MOVED, UNTOUCHED = range(3)
# columns of early: by which share of half a part, or step, loads act before its middle
SHARE_OF_PART, SHARE_OF_STEP = range(2)


class BodyState(NamedTuple):
    """Bodies as users see and set them, in the order of adding; read as a batch of steps begins."""

    pose: Annotated[FloatRows, Sized("slots", _pose.width), Saved(numbers="any")]
    velocity: Annotated[FloatRows, Sized("slots", 3), Saved(numbers="any")]  # m/s, m/s, rad/s
    load: Annotated[FloatRows, Sized("slots", 3), Saved(numbers="any")]  # N, N, N m
    # a cache line
    properties: Annotated[
        FloatRows, Sized("slots", 8), Saved({PROPAGATOR: "propagators"}, "infinite")
    ]
    kind: Annotated[Bytes, Sized("slots"), Saved(4)]
    slot_of_body: Annotated[Places, Sized("slots"), Saved("slots")]
    body_of_slot: Annotated[Places, Sized("slots")]
    drag_rates: Annotated[FloatRows, Sized("propagators", 2), Saved()]  # 1/s, of velocity and spin
    body_of_shape: Annotated[Places, Sized("shapes"), Saved("slots")]


class Bodies(NamedTuple):
    """Bodies by slot; read by all stages."""

    pose: Annotated[FloatRows, Sized("slots", _pose.width)]
    motion: Annotated[FloatRows, Sized("slots", _motion.width)]  # a cache line
    load: Annotated[FloatRows, Sized("slots", 3)]  # N, N, N m
    properties: Annotated[FloatRows, Sized("slots", 8)]  # a cache line
    kind: Annotated[Bytes, Sized("slots")]
    propagators: Annotated[FloatRows, Sized("propagators", _propagators.width)]
    # of each level of parts
    propagators_of_level: Annotated[
        FloatBlocks, Sized(MOST_LEVEL + 1, "propagators", _propagators.width)
    ]
    substep_state: Annotated[FloatRows, Sized("slots", 16)]  # two cache lines; read by the solver
    start: Annotated[FloatRows, Sized("slots", 6)]  # pose and velocity as a part of the step began
    flight: Annotated[FloatRows, Sized("slots", 8)]  # a cache line; read by continuous collision
    path: Annotated[FloatRows, Sized("slots", _path.width), Rewritten()]  # of hard discs
    # motion as the step ends if nothing is near
    ahead: Annotated[FloatRows, Sized("slots", _motion.width)]
    moved: Annotated[Bytes, Sized("slots")]  # by the solver, or sleep, in this step: see above
    early: Annotated[FloatRows, Sized("slots", 2)]  # where loads vary: see above


# -- shapes

# kind; thin shapes are next to nothing across, and pieces of chains solid from both sides, or one
(
    DISC, CAPSULE, POLYGON, HALF_PLANE, THIN_CAPSULE, THIN_POLYGON, PIECE, ONE_SIDED_PIECE,
) = range(8)  # fmt: skip
THINNEST = 2.0**-8  # of the length: shapes of a smaller width are thin

_material = Columns()
FRICTION = _material()  # -1 where not stated
RESTITUTION = _material()  # -1 where not stated
SHAPE_RADIUS = _material()  # m, of the circle around the shape from the centre of its body
SHAPE_INRADIUS = _material()  # m, least distance of its sides from there; -inf if that is outside
START_COSINE = _material()  # of a piece of a chain: the corner at its start; 0 of other shapes
START_SINE = _material()
END_COSINE = _material()  # the corner at its end
END_SINE = _material()

CATEGORY, MASK, GROUP, SENSOR = range(4)  # filters

_shape_boxes = Columns()  # around a shape as a part begins, where the contact list is long
BOX_LOW_X = _shape_boxes()  # m
BOX_LOW_Y = _shape_boxes()
BOX_HIGH_X = _shape_boxes()
BOX_HIGH_Y = _shape_boxes()
BOX_WAY_X = _shape_boxes()  # m, that its body goes in the part
BOX_WAY_Y = _shape_boxes()
BOX_CLOSE = _shape_boxes()  # m, below which a gap counts as a contact


class Shapes(NamedTuple):
    """Convex shapes: vertices grown by a radius; read by the broad and the narrow phase."""

    slot: Annotated[Places, Sized("shapes")]  # of the body
    kind: Annotated[Indices, Sized("shapes"), Saved(8)]
    first: Annotated[Indices, Sized("shapes"), Saved("vertices")]  # vertex
    vertex_count: Annotated[Indices, Sized("shapes"), Saved(2**31)]  # of vertices
    radius: Annotated[Floats, Sized("shapes"), Saved()]  # m
    material: Annotated[FloatRows, Sized("shapes", _material.width), Saved(numbers="infinite")]
    filters: Annotated[RankRows, Sized("shapes", 4), Saved({SENSOR: 2})]
    # vertex, m; normal of its side
    local_vertices: Annotated[FloatRows, Sized("vertices", 4), Saved()]
    world_vertices: Annotated[FloatRows, Sized("vertices", 4), Saved()]  # the same, turned
    boxes: Annotated[FloatRows, Sized("shapes", 8)]  # a cache line
    # shapes, friction, restitution
    pair_overrides: Annotated[FloatRows, Sized("overrides", 4), Saved({0: "shapes", 1: "shapes"})]


# -- bounding volume hierarchy

_tree = Columns()
LEAVES = _tree()  # bounded shapes, the leaves of the tree
PLANES = _tree()  # half-planes, which follow the leaves in `morton`; queries only

_boxes = Columns(4)  # low x, low y, high x, high y, m
LEAF_BOX = _boxes()  # of the k-th leaf
FAT = _boxes()  # of shape k

_centres = Columns()  # m, of a leaf, from which circles are compared
CENTRE_X = _centres()  # middle of the fat bounds of its body
CENTRE_Y = _centres()
HALF_WIDTH = _centres()  # how far the body may be from there
HALF_HEIGHT = _centres()
CENTRE_RADIUS = _centres()  # of the shape

LEAF, KEY = range(2)  # rows of morton and of sorting: the shape of each leaf, its Morton code


class Tree(NamedTuple):
    """A bounding volume hierarchy over shapes; read by the broad phase and by queries."""

    counts: Annotated[Ranks, Sized(_tree.width)]
    boxes: Annotated[FloatRows, Sized("shapes", _boxes.width), Saved(numbers="infinite")]
    # boxes, m; node k holds 2k and 2k + 1
    nodes: Annotated[FloatRows, Sized("nodes", 4), Saved(numbers="infinite")]
    # category, mask and group that the shapes under a node have in common
    filters: Annotated[RankRows, Sized("nodes", 3)]
    centres: Annotated[FloatRows, Sized("shapes", 8), Saved(numbers="infinite")]
    morton: Annotated[PlaceRows, Sized(2, "shapes")]  # in Morton order
    leaf_of_shape: Annotated[Places, Sized("shapes"), Saved("shapes")]
    sorting: Annotated[PlaceRows, Sized(2, "shapes")]  # between passes of the radix sort
    bins: Annotated[Places, Sized(256)]  # of the radix sort


# -- broad phase

_broad_phase = Columns()
CONTACTS = _broad_phase()  # on the list
BUFFER = _broad_phase()  # which of the two buffers holds the list
HORIZON = _broad_phase()  # steps for which the list is made
STEPS_SINCE = _broad_phase()  # steps since it was made
LIST_HOLDS = _broad_phase()  # 1 if it holds all pairs that may touch
FIRST_RUN = _broad_phase()  # contacts of the first sorted run
NEXT_LEVEL = _broad_phase()  # that the part which begins has at least
UPDATED = _broad_phase()  # bodies whose bounds were updated since the list was made

_frame = Columns()
FRAME_VX = _frame()  # m/s, mean velocity of the bodies
FRAME_VY = _frame()  # m/s
FRAME_X = _frame()  # m
FRAME_Y = _frame()  # m
FRAME_MOVES = _frame()  # 1 if the frame moves
FRAME_AX = _frame()  # m/s^2, mean acceleration
FRAME_AY = _frame()  # m/s^2
FRAME_PROPAGATOR = _frame(3)  # mean propagator through a step

_fat_bounds = Columns()
LOW_X = _fat_bounds()  # m, in the comoving frame: where the centre of the body may be
LOW_Y = _fat_bounds()
HIGH_X = _fat_bounds()
HIGH_Y = _fat_bounds()
BASE_ANGLE = _fat_bounds()  # rad, at which the shapes were fattened
ANGLE_MARGIN = _fat_bounds()  # rad, by which the body may turn from there

SHAPE_OF_RANK, RANK = range(2)  # rows of canonical


class BroadPhase(NamedTuple):
    """Which shapes may touch; read by the broad phase, its bounds by continuous collision."""

    counts: Annotated[
        Ranks,
        Sized(_broad_phase.width),
        Saved({**dict.fromkeys(range(_broad_phase.width), 2**62), NEXT_LEVEL: MOST_LEVEL + 1}),
    ]
    frame: Annotated[Floats, Sized(_frame.width), Saved()]
    fat_bounds: Annotated[FloatRows, Sized("slots", _fat_bounds.width), Saved(numbers="infinite")]
    left: Annotated[Bytes, Sized("slots")]  # 1 if the body has left its bounds
    canonical: Annotated[PlaceRows, Sized(2, "shapes")]  # shapes in canonical order; their ranks
    leaf_pairs: Annotated[PlaceRows, Sized("candidates", 2)]  # leaves whose boxes overlap
    # pairs of ranks, the lower one first; saved for its length, which decides when all are sought
    candidates: Annotated[PlaceRows, Sized("candidates", 2), Saved(2**32)]
    sorting: Annotated[PlaceRows, Sized("candidates", 2)]  # candidates between passes of the sort
    rank_counts: Annotated[Places, Sized("ranks")]  # bins of that sort
    first_of_rank: Annotated[Places, Sized("ranks")]  # contact of the first run


# -- contacts

SLOT_A, SLOT_B = 2, 3  # of pairs, after two shapes: the slots of their bodies

_manifolds = Columns()  # a contact with one point takes half of its four cache lines
NX = _manifolds()  # normal from A to B
NY = _manifolds()
PX = _manifolds()  # m, of a point: its place from the centre of A
PY = _manifolds()  # m
GAP = _manifolds()  # m
NORMAL_IMPULSE = _manifolds()  # N s, of the last substep
TANGENT_IMPULSE = _manifolds()  # N s
PRELOAD = _manifolds()  # m
TOTAL_IMPULSE = _manifolds()  # N s, of a point along the normal in the last step
WORLD_POINT = _manifolds(2)  # m, where it was
_manifolds(4)  # unused: each point has two cache lines
FORESEEN = _manifolds()  # s, until shapes meet whose manifold is that of this instant; 0 else
POINT = 16  # columns from a point to the next
# of two points, where no shape is thin: where B was from A when gaps were found, m, angles of both,
# rad, and how far the surfaces have moved against each other since the manifold was found, m
KNOWN_X, KNOWN_Y, KNOWN_ANGLE_A, KNOWN_ANGLE_B, KNOWN_WAY = 16, 17, 27, 28, 29
SIDE_NORMAL = 28  # of the side of a piece on which the other shape is, two columns
IMPACT_NORMAL = 30  # of an impact in flight, two columns
# N s: a pair that met in flight or in parts of a step is told one impulse, as a vector: that of the
# part that runs, where those of two points stand else, and of parts that have ended, two columns
PART_PUSH_X, PART_PUSH_Y = TOTAL_IMPULSE, TOTAL_IMPULSE + POINT
PUSH = WORLD_POINT + POINT
MANIFOLD = 32

# the cached separating axis stands apart: of most pairs on the list nothing else is read
_axes = Columns()
CACHED_ALONG = _axes()  # m, place of B in the axes of A as the axis was found
CACHED_ACROSS = _axes()
CACHED_TURN = _axes()  # sine or cosine of the turn of B
CACHED_WAY = _axes()  # m, by which the place may change while the axis holds

_flags = Columns()
POINT_COUNT = _flags()
FEATURE = _flags(2)  # names of both points
TOUCHES = _flags()  # bits below
CACHED_AXIS = _flags(2)
SENSES = _flags()  # 1 if one of the shapes is a sensor
KNOWN_SIDE = _flags()  # 1 if it is known on which side of a piece the other shape is
LOCATED = _flags()  # impacts whose instants continuous collision may still find in this part
MOST_LOCATED = 12  # LOCATED of a contact that meets in this part
SECONDARY = 14  # LOCATED of a contact that others may bring about, until it is on a list or not
SPENT = 15  # LOCATED of a contact that has had its share of these impacts
BOUNCED = _flags()  # 1 if restitution has parted it in the last part of a step
# bits of TOUCHES: in this step and in the last one; in flight in this step and in the last one
IS_TOUCHING, WAS_TOUCHING, MET_IN_FLIGHT, HAD_MET_IN_FLIGHT = 1, 2, 4, 8


class ContactBuffers(NamedTuple):
    """Pairs of shapes that may touch, twice: a new list is made from the old one."""

    pairs: Annotated[PlaceBlocks, Sized(2, "contacts", 4)]
    manifolds: Annotated[FloatBlocks, Sized(2, "contacts", MANIFOLD)]
    axes: Annotated[FloatBlocks, Sized(2, "contacts", _axes.width)]
    flags: Annotated[IndexBlocks, Sized(2, "contacts", _flags.width)]


class Contacts(NamedTuple):
    """Pairs of shapes that may touch, in two runs, each in canonical order; one of the buffers."""

    pairs: Annotated[
        PlaceRows, Sized("contacts", 4), Saved({0: "shapes", 1: "shapes", 2: "slots", 3: "slots"})
    ]
    manifolds: Annotated[FloatRows, Sized("contacts", MANIFOLD), Saved()]
    axes: Annotated[FloatRows, Sized("contacts", _axes.width), Saved()]
    flags: Annotated[
        IndexRows,
        Sized("contacts", _flags.width),
        Saved(
            {
                POINT_COUNT: 3,
                TOUCHES: 16,
                CACHED_AXIS: 2**31,
                SENSES: 2,
                KNOWN_SIDE: 2,
                LOCATED: 16,
                BOUNCED: 2,
            }
        ),
    ]


_touching = Columns()
TOUCHING = _touching()  # contacts that touch
ARRANGED = _touching()  # 1 if slabs, blocks and trees are those of these contacts
ISLANDS_KNOWN = _touching()  # 1 if islands are
MEETING = _touching()  # contacts that meet, or move much against each other
NEW_STATIC = _touching()  # contacts with static shapes that had no impulse
PRESSED_DEEP = _touching()  # 1 if there is a deep overlap
IMPACTS = _touching()  # 1 if the solver is given contacts that come about in this part
LOCATED_PAIRS = _touching()  # contacts whose impacts are left to continuous collision
BOXED = _touching()  # 1 if boxes of shapes are known, since the list is long


RIGHT_LOW, RIGHT_HIGH, LEFT_LOW, LEFT_HIGH = range(4)  # columns of sides: see chain_sides
# columns of near: contacts that touch or will, those with an impulse, those with what stands that
# are to come in this part
ALL, HOLDING, COMING = range(3)


class Touching(NamedTuple):
    """The contacts that touch, in canonical order; read by the solvers and by sleep."""

    counts: Annotated[Ranks, Sized(_touching.width), Saved(2**62)]
    near: Annotated[IndexRows, Sized("slots", 3)]  # numbers of contacts of each body, see above
    sides: Annotated[IndexRows, Sized("shapes", 4)]  # pieces that a shape touches, plus 1
    approach: Annotated[Floats, Sized("slots")]  # m/s, at which each body approaches others
    contact: Annotated[Places, Sized("contacts")]  # on the contact list
    body_a: Annotated[Places, Sized("contacts")]  # slot
    body_b: Annotated[Places, Sized("contacts")]  # slot
    colour: Annotated[Places, Sized("contacts")]  # twice that, plus the number of points less one
    lane: Annotated[Places, Sized("contacts")]  # counted through all blocks
    by_slab: Annotated[Places, Sized("contacts")]  # touching contacts, slab by slab
    active: Annotated[Places, Sized("pair_bodies")]  # moving bodies in the order of touching
    active_by_slab: Annotated[Places, Sized("pair_bodies")]  # the same, slab by slab


# -- constraints

COLOURS = 60

_lanes = Columns(LANES)
BODY_A = _lanes()  # slot of the body of each lane
BODY_B = _lanes()
LANE_CONTACT = _lanes()  # on the contact list; 0 of a lane without
FILLED = _lanes(1)  # lanes that hold a contact
POINTS = _lanes(1)  # of each contact of the block

_block = Columns(LANES)  # what both points of a contact share
R_NX = _block()  # normal from A to B
R_NY = _block()
R_MASS_A = _block()  # 1/kg, inverse
R_INERTIA_A = _block()  # 1/(kg m^2), inverse
R_MASS_B = _block()
R_INERTIA_B = _block()
R_FRICTION = _block()
R_RADIUS_A = _block()  # m, by which the vertices of the shape are grown
R_RADIUS_B = _block()
R_BIAS_LEAST = _block()  # m/s, the fastest that an overlap is pushed apart
R_RESTITUTION = _block()
R_BIAS_RATE = _block()  # 1/s, at which an overlap is pushed apart
R_MASS_SHARE = _block()  # of the effective mass by softness
R_IMPULSE_SHARE = _block()  # of the impulse that softness takes back
R_SMALLER_RADIUS = _block()  # m, of the smaller bounding circle
R_ALLOWED = _block()  # m, overlap for which no preload is learnt
SHARED = _block.width

_point = Columns(LANES)  # then, of each point
P_NORMAL_ARM_A = _point()  # m, by which an impulse along the normal turns A
P_NORMAL_ARM_B = _point()
P_TANGENT_ARM_A = _point()
P_TANGENT_ARM_B = _point()
P_NORMAL_MASS = _point()  # kg, effective
P_TANGENT_MASS = _point()
P_GAP = _point()  # m, as the step began
P_NORMAL_IMPULSE = _point()  # N s, of a substep
P_TANGENT_IMPULSE = _point()
P_TOTAL_IMPULSE = _point()  # N s, along the normal over the substeps so far
P_APPROACH = _point()  # m/s, normal velocity before the step
P_GAP_NOW = _point()  # m
POINT_SIZE = _point.width
FIRST_POINT, SECOND_POINT = _block(POINT_SIZE), _block(POINT_SIZE)
FIRST_RESTITUTION, SECOND_RESTITUTION = _block(), _block()  # N s, impulses of restitution

_scratch = Columns(LANES)  # the motion of the bodies of a block, of each the columns in use
B_VX_A = _scratch()  # m/s
B_VY_A = _scratch()
B_SPIN_A = _scratch()  # rad/s
B_DX_A = _scratch()  # m, since the step began
B_DY_A = _scratch()
B_ANGLE_A = _scratch()  # rad
B_VX_B = _scratch()
B_VY_B = _scratch()
B_SPIN_B = _scratch()
B_DX_B = _scratch()
B_DY_B = _scratch()
B_ANGLE_B = _scratch()
F_NX = _scratch()  # eight columns as in `manifolds`, from the first one on
F_NY = _scratch()
F_FIRST_POINT = _scratch(6 * LANES)
_scratch(2 * LANES)  # the same from the column `POINT` on
F_SECOND_POINT = _scratch(6 * LANES)
F_SPAN_X = _scratch()  # m, from the centre of A to that of B
F_SPAN_Y = _scratch()
# columns of a point from F_FIRST_POINT or F_SECOND_POINT on
F_X, F_Y, F_GAP, F_NORMAL_IMPULSE, F_TANGENT_IMPULSE, F_PRELOAD = range(0, 6 * LANES, LANES)
B_UNSETTLED = _scratch()  # N s, by which restitution changes more than counts
PREFETCHED = _scratch(1)  # a sum that nothing reads: the compiler would leave out loads without use

_energy_sums = Columns()  # J, over all bodies with contacts
TOTAL_ENERGY_START = _energy_sums()  # kinetic energy as the step began
TOTAL_ENERGY_NOW = _energy_sums()
TOTAL_WORK = _energy_sums()  # of gravity and forces in this step

_slabs = Columns()  # where its part of each list begins
S_CONTACT = _slabs()  # of touching.by_slab
S_BLOCK = _slabs()
S_BODY = _slabs()  # of touching.active_by_slab
S_TREE = _slabs()  # of the islands that are solved directly
MOST_SLABS = 256

COLOUR_SIZE, NEXT_LANE = range(2)  # rows of colour_counts: contacts of a colour in a slab

_constraints = Columns()
ACTIVE = _constraints()  # moving bodies with contacts
BLOCKS = _constraints()
BOUNCING = _constraints()  # contacts with restitution
SWEEPS = _constraints()  # over the contacts in each stage of this part
LANES_FILLED = _constraints()  # 1 if lanes hold what stays while the arrangement does
SLABS = _constraints()
FREE_ISLANDS = _constraints()  # islands that touch nothing but themselves


class Constraints(NamedTuple):
    """Contact constraints in blocks of lanes; read by the solver."""

    counts: Annotated[Ranks, Sized(_constraints.width)]
    blocks: Annotated[FloatRows, Sized("blocks", _block.width), Rewritten()]
    lanes: Annotated[PlaceRows, Sized("blocks", _lanes.width)]
    late_impulses: Annotated[FloatRows, Sized("blocks", LANES)]  # N s, where loads vary
    scratch: Annotated[Floats, Sized(_scratch.width), Rewritten()]
    energy: Annotated[Floats, Sized(_energy_sums.width)]
    slabs: Annotated[RankRows, Sized(MOST_SLABS + 2, _slabs.width)]
    slab_of_body: Annotated[Indices, Sized("slots")]  # of active bodies, if there are several slabs
    colour_counts: Annotated[RankRows, Sized(2, 2 * COLOURS + 2), Rewritten()]
    body_colours: Annotated[Ranks, Sized("slots")]  # colours of its contacts, bit by bit


# -- islands and sleep

_links = Columns()
ROOT = _links()  # the body of its island that touches first
SLOW_STEPS = _links()  # steps for which the body has been slow; 1 if it is not dynamic and known
SLEEP_ID = _links()  # under which its island sleeps, 0 if it is awake
AWAKE = _links()  # 1 if the body may wake others
SUPPORT_KIND = _links()  # what it touches, one of those in `sleep`
ISLAND_SLOW_STEPS = _links()  # of a root: steps for which all of the island have been slow
FIRST_CONTACT = _links()  # place of its first contact among those that touch

_rest = Columns()
REST_POSE = _rest(3)  # m, m, rad, with which the body fell asleep
REST_LOAD = _rest(3)  # N, N, N m
REST_GRAVITY = _rest(2)  # m/s^2

_energy = Columns()
BEFORE_RESTITUTION = _energy(3)  # m/s, m/s, rad/s, of each body: its velocity
VELOCITY_GIVEN = _energy(2)  # m/s, of each body, as the next two: what contacts have given it
ANGULAR_VELOCITY_GIVEN = _energy()  # rad/s, in all substeps
MOMENT_AHEAD = _energy()  # m^2/s, about where it was as the step began
REFERENCE = _energy(3)  # m/s, m/s, rad/s, of a root, as all below: the rigid motion, at the root,
# from which the island is seen, and towards which its motion is damped
SUPPORT = _energy()  # how many motions support it, one of those in `solver.energy`
ENERGY_START = _energy()  # J, kinetic, as the step began
WORK = _energy()  # J, of gravity and forces
LIFT_WORK = _energy()  # J, which overlaps of an island with joints may give back
ENERGY_GIVEN_ALL = _energy()  # J, by contacts to the bodies that got some
ENERGY_BEFORE = _energy()  # J, before restitution
ENERGY_AFTER = _energy()  # J, after it
ENERGY_OF_CHANGE = _energy()  # J, of the change of velocities by it alone
KEPT_SHARE = _energy()  # of restitution
ENERGY_KEPT = _energy()  # J, with that share
ENERGY_BOUND = _energy()  # J, that may stay
ENERGY_SURPLUS = _energy()  # J, that its bodies have too much for what is lifted
ENERGY_LEAST = _energy()  # J, of the motion as one, of an island that is damped
ISLAND_MASS = _energy()  # kg
MOMENTUM_X = _energy()  # kg m/s
MOMENTUM_Y = _energy()
ANGULAR_MOMENTUM = _energy()  # kg m^2/s, around the root
MOMENT_X = _energy()  # kg m, of the mass
MOMENT_Y = _energy()
MOMENT_OF_INERTIA = _energy()  # kg m^2
DAMPED_SHARE = _energy()  # of the motion that differs from REFERENCE; 1 where none is taken
ANGULAR_MOMENTUM_GIVEN = _energy()  # kg m^2/s, by contacts, to an island that nothing holds
ENERGY_PUSHED = _energy()  # J, of its bodies that contacts have pushed
DRIVEN_RATE = _energy()  # m/s, at which its supports move against each other, at most
DRIVEN_ENERGY = _energy()  # J, that what carries its mechanisms is likely to give it; 0 if none is
KEPT_WAY = _energy()  # share of its way in this step that an island with joints keeps

_islands = Columns()
SLEEP_STEPS = _islands()  # slow steps until an island sleeps, 0 for never
SLEEPING = _islands()  # bodies that sleep
ROOTS = _islands()  # islands that have contacts


class Islands(NamedTuple):
    """Bodies that touch each other; read by sleep and by the bound on energy."""

    counts: Annotated[Ranks, Sized(_islands.width), Saved(2**31)]
    links: Annotated[
        IndexRows,
        Sized("slots", _links.width),
        Saved({ROOT: "slots", SLOW_STEPS: 2**31, SLEEP_ID: "slots"}),
    ]
    rest: Annotated[FloatRows, Sized("slots", _rest.width), Saved(numbers="any")]
    energy: Annotated[FloatRows, Sized("slots", _energy.width), Rewritten()]
    # of a body with contacts: 1 if its island touches what does not move freely, or cannot turn
    held: Annotated[Bytes, Sized("slots")]
    roots: Annotated[Indices, Sized("slots")]  # of the islands that have contacts
    given: Annotated[Floats, Sized("slots")]  # J, by contacts in this step, to each body


# -- direct solver: nodes are the moving bodies of tree-like islands, edges the pairs that touch

_trees = Columns()
DEGREE = _trees()  # contacts of the body with moving ones that are left
INCIDENT = _trees()  # these contacts, joined by exclusive or
TREE = _trees()  # root of its tree, or -1
NODE = _trees()  # of the body, or -1
TREE_BODIES = _trees()  # of a root: bodies of its tree
GROUNDED = _trees()  # of a root: contacts of its tree with bodies that do not move freely
TREE_NUMBER = _trees()  # of a root: number among the islands that are solved directly, or -1

_sparse = Columns()  # lists that share nothing but their rows
N_BODY = _sparse()  # of a node: slot
N_HEAD = _sparse()  # first half-edge, or -1; an edge e is the half-edges 2e and 2e + 1
N_DEGREE = _sparse()  # edges to nodes that are not eliminated
N_PIVOT = _sparse()  # place in the order of elimination, or -1
E_NODE_A = _sparse()  # of an edge: its nodes; once ordered, A is eliminated first
E_NODE_B = _sparse()
E_NEXT = _sparse(2)  # next half-edges at both nodes
PIVOT_NODE = _sparse()  # of a pivot
PIVOT_FIRST = _sparse()  # where its edges begin on the fill list
PIVOT_COUNT = _sparse()  # its edges
C_BLOCK = _sparse()  # of a contact
C_LANE = _sparse()
C_NODE_A = _sparse()  # nodes of its bodies, or -1
C_NODE_B = _sparse()
C_EDGE = _sparse()  # between them, or -1
C_STATE = _sparse()  # in the active set, bits in `direct.active_set`
C_FACTORED = _sparse()  # the state with which it is in the matrix
FILL = _sparse()  # the fill list: of each pivot its edges, then the edges that change by it
I_NODE = _sparse()  # of an island: where its nodes and pivots begin
I_CONTACT = _sparse()  # where its contacts begin
I_NEXT_NODE = _sparse()  # place of its next node, while they are listed
I_NEXT_CONTACT = _sparse()
I_STATUS = _sparse()  # whether its matrix is factored, one of those in `direct.solve`
LEAF_NODE = _sparse()  # a stack: nodes with at most one neighbour
PASS_NODE = _sparse()  # a stack: nodes with two

_factors = Columns()  # numbers beside the columns of sparse
DIAGONAL = _factors(6)  # of a node: lower triangle of its block
CHANGE = _factors(3)  # residual momentum, N s and N m s; solved in place: change of velocity
VELOCITY_START = _factors(3)  # m/s, m/s, rad/s, before the island was solved
NODE_MASS = _factors()  # kg
NODE_INERTIA = _factors()  # kg m^2
OFF_DIAGONAL = _factors(9)  # of an edge: rows of the later node, columns of the earlier one
BIAS = _factors(2)  # of a contact: m/s, of each point
SPEED_ERROR = _factors(2)  # m/s, normal velocity and bias as the solve began
NEW_NORMAL = _factors(2)  # N s, normal impulses that are proposed
NEW_TANGENT = _factors(2)  # N s
SOFTNESS = _factors(3)  # bias rate, mass share and impulse share of the soft constraint
FRICTION_SHARE = _factors()  # of the first of two points
FIRM_MASS = _factors()  # of an island: kg, with which contacts resist velocity
IMPULSE_SCALE = _factors()  # N s
LARGEST_MASS = _factors()  # kg

_direct = Columns()
TREES = _direct()  # islands that are solved directly
TREE_CONTACTS = _direct()  # their contacts
EDGES = _direct()  # so far, while nodes are ordered, as all below
FILL_LENGTH = _direct()  # of the fill list
LEAF_NODES = _direct()  # size of the stack in LEAF_NODE
PASS_NODES = _direct()  # size of the stack in PASS_NODE
UNSOLVED = _direct()  # slot, plus 1, of a body of an unsolved island of very different masses


class Direct(NamedTuple):
    """Tree-like islands, whose contacts are solved at once; read by the direct solver."""

    counts: Annotated[Ranks, Sized(_direct.width)]
    trees: Annotated[IndexRows, Sized("slots", 8)]
    sparse: Annotated[RankRows, Sized("sparse", _sparse.width)]
    factors: Annotated[FloatRows, Sized("sparse", _factors.width)]
    contacts: Annotated[Places, Sized("contacts")]  # touching contacts of these islands
    leaves: Annotated[Places, Sized("pair_bodies")]  # bodies that were taken off, in order
    taken_off: Annotated[Places, Sized("pair_bodies")]  # the bodies off which they were taken


# -- springs: a network is what springs connect, through bodies that move freely

_spring_counts = Columns()
SPRINGS = _spring_counts()
NETWORKS = _spring_counts()
NETWORKS_TOUCHED = _spring_counts()  # in this step

_networks = Columns()
N_MEMBER = _networks()  # where its members begin
N_SPRING = _networks()  # where its springs begin
N_STATUS = _networks()  # whether contacts act on it, and how it is solved, one of those below
N_UNSOLVED = _networks()  # 1 if no loads were found that can be held in this part of a step
N_LOSES = _networks()  # 1 if that was so in any part so far: the network has lost energy
ALONE, TOUCHED, TOUCHED_SOFT, TOUCHED_STIFF = range(4)

MEMBER_A, MEMBER_B = range(2)  # ends of a spring; of B, -1 for a point of the plane

_spring = Columns()
STIFFNESS = _spring()  # N/m
REST_LENGTH = _spring()  # m
DAMPER = _spring()  # kg/s
ANCHOR_A = _spring(2)  # m, in the axes of the body
ANCHOR_B = _spring(2)  # m, in the axes of the body, or of the plane
SPAN_X = _spring()  # m, as the step began
SPAN_Y = _spring()  # m
LENGTH = _spring()  # m
DAMPER_HELD = _spring()  # kg/s
ARM_A = _spring(2)  # m, by which forces turn
ARM_B = _spring(2)  # m
AXIS_X = _spring()
AXIS_Y = _spring()
ALONG = _spring()  # resistance to a change of the span along the axis
ACROSS = _spring()  # resistance to a change across it
FORCE_X = _spring()  # N or N s, on A
FORCE_Y = _spring()

_members = Columns(3)  # m, m, rad; N, N, N m; N s, N s, N m s; of a body in a network
FREE_SHIFT = _members()  # displacement in this step without springs
SHIFT = _members()  # displacement in this step, or velocity in this substep
PULL = _members()  # of all springs
GIVEN = _members()  # of all springs, by which velocities have changed in this substep
BASE_LOAD = _members()  # what acts besides springs
HELD_LOAD = _members()  # with springs, through the step
RESISTANCE = _members()  # to a displacement or to a change of velocity; 0 where nothing moves
STIFFENING = _members(1)  # resistance to turning, of arms along which springs pull
MATRIX_DIAGONAL = _members()  # of the network
RESIDUAL = _members()
SOLUTION = _members()
SEARCH = _members()  # direction
PRODUCT = _members()  # of the matrix with it


class Springs(NamedTuple):
    """Springs and the bodies that they hold; read by the springs' own stages."""

    counts: Annotated[Ranks, Sized(_spring_counts.width)]
    networks: Annotated[RankRows, Sized("networks", _networks.width)]
    ends: Annotated[RankRows, Sized("springs", 2)]  # members
    springs: Annotated[FloatRows, Sized("springs", _spring.width)]
    body: Annotated[Ranks, Sized("members")]  # of a member: its row
    slot: Annotated[Ranks, Sized("members")]  # of its body in this step
    members: Annotated[FloatRows, Sized("members", _members.width)]


# -- joints: a mechanism is what joints connect, through bodies that move freely

_joint_counts = Columns()
JOINTS = _joint_counts()
MECHANISMS = _joint_counts()
MECHANISMS_AWAKE = _joint_counts()  # in this step
MECHANISMS_TOUCHED = _joint_counts()  # of these, by contacts, or governed
TREE_BLOCKS = _joint_counts()
FIRST_KINEMATIC = _joint_counts()  # member: it and all after it move as they are told
PLACED = _joint_counts()  # 1 if members are where the last step, or its first part, placed them
JOINTS_APART = _joint_counts()  # 1 if a joint was more than slightly apart, until it is asked
JOINTS_TURNED = _joint_counts()  # 1 if a joint turned too far in a substep, until it is asked
JOINTS_GAINED = _joint_counts()  # 1 if joints and contacts made energy, until it is asked
LIMIT_CHANGES = _joint_counts()  # how often limits were struck or left

_mechanisms = Columns()
M_JOINT = _mechanisms()  # where its joints begin; its members are its nodes, one place on
M_STATUS = _mechanisms()  # one of those below
M_MESHED = _mechanisms()  # 1 if it has so many loops that it is solved by iteration; with the last
# column it is a net of hinges
M_TIED = _mechanisms()  # 1 if a joint ties it to what nothing pushes
M_TURNED_BY_MOTOR = _mechanisms()  # 1 if a motor that does not stand still may give it energy
M_TIMED = _mechanisms()  # 1 if an equation that changes with time drives it
M_CARRIED = _mechanisms()  # 1 if that, or some of it, moves as it is told
M_DRIVEN = _mechanisms()  # 1 if a spring, or what changes with time, may give it energy
M_GOVERNED = _mechanisms()  # 1 if it has limits, motors or springs
M_CHOOSING = _mechanisms()  # 1 if it has limits or motors
M_BOUNCING = _mechanisms()  # 1 if it has limits that bounce
M_NEAR = _mechanisms()  # 1 if it may reach a limit in this part
M_TOUCHED = _mechanisms()  # 1 if contacts touch it
M_HINGED = _mechanisms()  # 1 if it is a net or a tree of hinges; of a tree nodes come after those
# above them, and joints that are no hinges of nodes last
M_IN_BLOCK = _mechanisms()  # 1 if it is a tree that is solved in a lane of a block
M_WRITTEN = _mechanisms()  # 1 if its rows are those of its places and masses
M_HALF = _mechanisms()  # 1 in the first substep of a step whose forces came half before it
# status: those of the second kind have no limits, motors and springs, those of the third have some,
# and are far from limits
ASLEEP, FREE_OF_CONTACTS, GOVERNED_ALONE, IN_CONTACT = range(4)

_joint = Columns()  # whole numbers of a joint
J_KIND = _joint()  # by the number in `generated.joint_rows`
J_ROWS = _joint()  # how many of them
J_MEMBER = _joint(3)  # of its bodies A, B and C; 0 for the plane
J_NODE = _joint(3)  # their nodes, or one of those below
J_EDGE = _joint(3)  # of the pairs AB, AC and BC, or -1 where one does not move
J_LAW = _joint()  # what governs its row, one of those below
J_STATE = _joint()  # whether a limit or a motor holds, one of those below
J_EQUATION = _joint()  # its equation, or -1 where it is one of a kind

KEPT, LOWER_LIMIT, UPPER_LIMIT, MOTOR, SPRING = range(5)  # at zero; one row if not KEPT
HOLDS, FREE_ROW, AT_MOST, AT_LEAST = range(4)  # a motor gives the most forwards, or backwards

_laws = Columns()  # numbers of a law
LAW_RATE = _laws()  # m/s or rad/s, of a motor, or of what an equation keeps
LAW_MOST = _laws()  # N or N m, of a motor
LAW_STIFFNESS = _laws()  # N/m or N m/rad
LAW_DAMPING = _laws()  # kg/s or N m s
LAW_RESTITUTION = _laws()  # of a limit

_equations = Columns()  # of a joint, as a program (`spec.row_program`)
Q_INPUT = _equations()  # the first of its scalars: inputs, then what its operations yield
Q_OPERATION = _equations()  # the first of these
Q_COUNT = _equations(3)  # how many find its value; that and its slopes; these and its bends
Q_BOUND = _equations()  # 1 if it is bound to the plane
Q_OUTPUT = _equations(OUTPUTS)  # the scalars that are these

CLOCK_NOW, CLOCK_AHEAD = range(2)  # s: the instant where bodies are, and how far ahead of it they
# are placed

ENDS_OF_JOINT = 3
NOT_PUSHED, UNUSED = -1, -2  # instead of a node: nothing pushes what is there, or none is asked for

_joint_numbers = Columns()
J_ROW = _joint_numbers(30)  # value and slopes of each row
J_FIRMNESS = _joint_numbers(3)  # kg, of each row
J_AIM = _joint_numbers(3)  # m or rad, to which a substep brings each row; of a spring as it begins
J_SHARE = _joint_numbers()  # of a substep's way after which its spring answers
J_ERROR = _joint_numbers(3)  # m/s or rad/s, rate of each row beyond what is wanted
J_STEP_TOTAL = _joint_numbers(9)  # N s, N s, N m s, impulses on A, B and C over the step
J_FORCE = _joint_numbers(3)  # N, of each row in the last part of a step
J_WARM = _joint_numbers(3)  # N s, impulse of each row in the last substep; of meshes only
J_LEFT_BEFORE = _joint_numbers()  # N s, that a spring has left to give as a part begins
J_PUSHED = _joint_numbers()  # N s or N m s, impulse of a limit over the step, 0 if it did not push
J_RESERVE = _joint_numbers()  # J, of its mechanism, in its first joint, as a part begins
J_MOTION = _joint_numbers()  # J, likewise: of motion as the last part ended
J_PULLED = _joint_numbers()  # likewise: substeps in which it follows what was moved by hand
J_OPENED = (
    _joint_numbers()
)  # m/s, likewise: the fastest that what ties it has moved since it yielded
J_FIRMEST = _joint_numbers(3)  # kg, of each row while its mechanism yields, else 0
J_SCALE = _joint_numbers()  # J, likewise: the most of motion and springs lately
J_TOTAL = _joint_numbers(9)  # N s, N s, N m s, impulses on A, B and C over this part
J_PULL = _joint_numbers(3)  # N s, impulse of each row over this part
J_GIVEN = _joint_numbers(3)  # N s, of each row over this substep; of a spring less what was left
J_DRIVEN = _joint_numbers()  # m/s, likewise: at which what ties it parts its rows in this substep
J_ENERGY = _joint_numbers()  # J, likewise: of springs, as a part begins
J_RESERVE_LATER = _joint_numbers()  # J, as it ends
J_MOTION_LATER = _joint_numbers()  # J, as it ends
J_SCALE_LATER = _joint_numbers()  # J, as it ends
J_MOMENT = _joint_numbers()  # N m s, likewise: that joints have given it in this part
J_GAIN = _joint_numbers()  # likewise: 1 if energy was made in this part, with what touches it
J_LEFT = _joint_numbers()  # N s, that a spring has left to give where bodies have moved to
J_APART = _joint_numbers(3)  # m or rad, by how much each row was apart at most, until it is asked
J_SLIGHT = _joint_numbers(3)  # m or rad, by how much each row may be apart without being looked at
J_VALUE_START = _joint_numbers()  # m or rad, of a limit as a substep begins
J_RATE_START = _joint_numbers()  # m/s or rad/s, likewise
J_STRUCK = _joint_numbers()  # m/s or rad/s, rate as it was struck in this part, 0 if it was not
J_ARM = _joint_numbers(3)  # m, at which an angle counts as a length; 1 for a length
J_TURNED = _joint_numbers()  # 1 if its first row turned too far in a substep, until it is asked
J_GAINED = _joint_numbers()  # 1 if J_GAIN was in a part, until it is asked
J_PUSHED_BEFORE = _joint_numbers()  # the same of the step before
J_STRUCK_AT = _joint_numbers()  # the number of the step in which it was struck last
J_STRIKE = _joint_numbers()  # N s or N m s, its impulse over that step
J_LEFT_AT = _joint_numbers()  # the number of the step in which it was left last
J_IMPULSE = _joint_numbers(3)  # N s, of each row by the last solution
J_RESIDUAL = _joint_numbers(3)  # m/s, what is left of its error
J_OFFSET = _joint_numbers(3)  # m or rad, to which a substep leads each row, less its rate's way
J_SEARCH = _joint_numbers(3)  # N s, direction of conjugate gradients
J_TRIED = _joint_numbers(3)  # N s, residual over the matrix, about

_joined = Columns()  # members: the plane, the nodes, then static and then kinematic bodies
JOINED_BODY = _joined()  # row of the body
JOINED_SLOT = _joined()  # its slot in this step
JOINED_ABOVE = _joined()  # member on which it hangs in a tree of hinges; 0 for the plane
JOINED_HINGE = _joined()  # the joint by which it hangs, or -1
JOINED_SPRING = _joined()  # the spring of the angle of that, of a tree in a block, or -1

_places = Columns()  # of a member, as generated code takes it
PLACE_X = _places()  # m
PLACE_Y = _places()  # m
PLACE_ANGLE = _places()  # rad
PLACE_COSINE = _places()
PLACE_SINE = _places()
LEANING = _places()  # N m, of joints that pull at the arms of the body
HELD_INVERSE_INERTIA = _places()  # 1/(kg m^2), with which it counts in joints

_hinges = Columns()  # of a member that hangs on a hinge, or is the root of a tree
H_ANCHOR = _hinges(2)  # m, in its own axes
H_FAR_ANCHOR = _hinges(2)  # m, in the axes of the body above
H_SIDE = _hinges()  # 1 if it is body B of the joint, -1 if it is A
H_ARM = _hinges(2)  # m, to the hinge
H_FAR_ARM = _hinges(2)  # m, to the hinge from the body above
H_GAP = _hinges(2)  # m, by which the hinge is apart as a substep begins
H_AIM = _hinges(2)  # m, to which the substep brings it
H_ERROR = _hinges(2)  # m/s, rate that it has too much
H_NODE_MASS = _hinges(3)  # kg, of the node: by x along x, by y along x, by y along y
H_NODE_MOMENT = _hinges(2)  # kg m
H_NODE_INERTIA = _hinges()  # kg m^2
H_MOMENT = _hinges(2)  # kg m, of the node about its hinge
H_INERTIA = _hinges()  # kg m^2, likewise
H_MASS = _hinges(3)  # kg, of what hangs on the hinge
H_LEVER = _hinges(2)  # 1/m
H_YIELD = _hinges()  # 1/(kg m^2), of turning; 0 if the body does not turn
H_FIRM = _hinges()  # kg m^2, of laws that govern its angle
H_SHARE = _hinges()  # of the turning of the body above that these pass on
H_LAW = _hinges()  # N m s, that these ask for
H_OWED = _hinges(3)  # N s, N s, N m s
H_OFFSET = _hinges(2)  # m, to which a substep leads it, less the way of the rate at which it parts
H_CHANGE = _hinges(3)  # m/s, m/s, rad/s
H_IMPULSE = _hinges(2)  # N s, through the hinge by the last solution
H_GIVEN = _hinges(2)  # N s, through the hinge since rows were written
H_PULL = _hinges(2)  # N s, through the hinge over this part, before that
H_TURN = _hinges()  # N m s, likewise, about the body
H_FAR_TURN = _hinges()  # N m s, likewise, about the body above
H_APART = _hinges(2)  # m, by how much the hinge was apart at most in this part
H_SLIGHT = _hinges()  # rad^2, of a root: how much turning is not looked at again in its tree

_tree_blocks = Columns()  # of equal trees of hinges
T_FIRST = _tree_blocks()  # row of what their roots hang on; those of nodes follow
T_TIED = _tree_blocks()  # 1 if that is something
T_SPRUNG = _tree_blocks()  # 1 if springs govern the angles of hinges
T_WRITTEN = _tree_blocks()  # 1 if its hinges are those of the places and masses of its lanes
T_MECHANISM = _tree_blocks(LANES)  # the tree of each lane, or -1

_block_lanes = Columns(LANES)  # of a block
T_ACTIVE = _block_lanes()  # 1 if it is being solved
T_AGAIN = _block_lanes()  # 1 if it is solved with the hinges of the end, as errors stay large
T_BACK = _block_lanes()  # 1 if its last solution is to be taken back
T_EACH = _block_lanes()  # 1
T_SIZE = _block_lanes()  # m^2/s^2, sum of squares of errors
T_BEFORE = _block_lanes()  # the same, before the last solution
T_SIZE_FIRST = _block_lanes()  # the same, as the substep is first looked at
T_LARGEST = _block_lanes()  # 1/s^2, as `solve_hinges` returns it
T_SLIGHT = _block_lanes()  # rad^2, how much turning is not looked at again

_tree_lanes = Columns(LANES)  # of a node of the trees of a block; else as those of hinges
T_ANCHOR_X = _tree_lanes()
T_ANCHOR_Y = _tree_lanes()
T_FAR_ANCHOR_X = _tree_lanes()
T_FAR_ANCHOR_Y = _tree_lanes()
T_MASS = _tree_lanes()  # kg, of the body
T_INERTIA = _tree_lanes()  # kg m^2, with which it counts in joints
T_INVERSE_MASS = _tree_lanes()
T_HELD_INVERSE_INERTIA = _tree_lanes()
T_POSE_X = _tree_lanes()  # as the part began
T_POSE_Y = _tree_lanes()
T_POSE_ANGLE = _tree_lanes()
T_VX = _tree_lanes()  # these six as `load_rows` writes them
T_VY = _tree_lanes()
T_SPIN = _tree_lanes()
T_DX = _tree_lanes()
T_DY = _tree_lanes()
T_DANGLE = _tree_lanes()
T_START_X = _tree_lanes()  # velocity as the substep began
T_START_Y = _tree_lanes()
T_START_SPIN = _tree_lanes()
_tree_lanes(5 * LANES)  # unused: `load_part` writes eight
T_JOINT_ANGLE = _tree_lanes()  # rad, at which a spring is at rest
T_STIFFNESS = _tree_lanes()  # N m/rad, of the spring; 0 if there is none
T_DAMPING = _tree_lanes()  # N m s
T_LAW_SIDE = _tree_lanes()  # 1 if the body is B of the spring, -1 if it is A, 0 if there is none
T_TURNING = _tree_lanes()  # turning slope of the spring at the body
T_FAR_TURNING = _tree_lanes()  # the same at the body above
T_FIRMNESS = _tree_lanes()  # kg m^2, of the spring
T_LAW_START = _tree_lanes()  # rad, of the spring as a substep begins
T_LAW_SHARE = _tree_lanes()  # of a substep's way after which it answers
T_LAW_ERROR = _tree_lanes()  # rad/s, that it has not answered yet
T_LAW_IMPULSE = _tree_lanes()  # N m s, of the spring by the last solution
T_LAW_GIVEN = _tree_lanes()  # N m s, of the spring over this substep, less what was left
T_LAW_LEFT = _tree_lanes()  # N m s, that it has left to give
T_X = _tree_lanes()  # where the body is placed
T_Y = _tree_lanes()
T_ANGLE = _tree_lanes()
T_COSINE = _tree_lanes()
T_SINE = _tree_lanes()
T_ARM_X = _tree_lanes()
T_ARM_Y = _tree_lanes()
T_FAR_ARM_X = _tree_lanes()
T_FAR_ARM_Y = _tree_lanes()
T_GAP_X = _tree_lanes()
T_GAP_Y = _tree_lanes()
T_AIM_X = _tree_lanes()
T_AIM_Y = _tree_lanes()
T_ERROR_X = _tree_lanes()
T_ERROR_Y = _tree_lanes()
T_NODE_XX = _tree_lanes()
T_NODE_YY = _tree_lanes()
T_NODE_XY = _tree_lanes()
T_NODE_MOMENT_X = _tree_lanes()
T_NODE_MOMENT_Y = _tree_lanes()
T_NODE_INERTIA = _tree_lanes()
T_MOMENT_X = _tree_lanes()
T_MOMENT_Y = _tree_lanes()
T_HUNG_XX = _tree_lanes()
T_HUNG_XY = _tree_lanes()
T_HUNG_YY = _tree_lanes()
T_LEVER_X = _tree_lanes()
T_LEVER_Y = _tree_lanes()
T_YIELD = _tree_lanes()
T_FIRM = _tree_lanes()
T_SHARE = _tree_lanes()
T_LAW = _tree_lanes()
T_OWED_X = _tree_lanes()
T_OWED_Y = _tree_lanes()
T_OWED_TURN = _tree_lanes()
T_PASSED_X = _tree_lanes()  # what the node above gets of it
T_PASSED_Y = _tree_lanes()
T_PASSED_TURN = _tree_lanes()
T_CHANGE_X = _tree_lanes()
T_CHANGE_Y = _tree_lanes()
T_CHANGE_SPIN = _tree_lanes()
T_IMPULSE_X = _tree_lanes()
T_IMPULSE_Y = _tree_lanes()
T_GIVEN_X = _tree_lanes()
T_GIVEN_Y = _tree_lanes()
T_PULL_X = _tree_lanes()  # these from here on are sums over a part
T_PULL_Y = _tree_lanes()
T_TURN = _tree_lanes()
T_FAR_TURN = _tree_lanes()
T_APART_X = _tree_lanes()
T_APART_Y = _tree_lanes()
T_LAW_PULL = _tree_lanes()  # N m s, of the spring

_links = Columns(2)  # of a hinge in a net
# what each substep reads and writes stands first, line by line of the cache
L_ARM_A = _links()  # m
L_ARM_B = _links()  # m
L_GAP = _links()  # m, by which it is apart as a substep begins
L_GIVEN = _links()  # N s, since rows were written
L_IMPULSE = _links()  # N s
L_WARM = _links()  # N s, in the last substep
L_ERROR = _links()  # m/s, rate that it has too much
L_RATE = _links()  # m/s, by which links that come later change it
L_PULL = _links()  # N s, over this part, before rows were written
L_TURN_A = _links(1)  # N m s, over this part, before rows were written
L_TURN_B = _links(1)  # N m s
L_APART = _links()  # m, by how much it was apart at most in this part
L_SLIGHT = _links(1)  # m, by how much any may be apart without being looked at; in the first
L_MASS = _links(3)  # kg, the inverse of its yield
L_YIELD = _links(3)  # 1/kg, by x along x, by y along x, by y along y
L_MADE = _links()  # N s, what a sweep makes of the direction
L_LEFT = _links()  # N s, what a sweep makes of the error that is left
L_SEARCH = _links()  # m/s, direction of conjugate gradients, before a sweep back
L_TRIED = _links()  # N s, that direction

_net_nodes = Columns()  # of a member of a net; nothing moves what stands still
N_CHANGE = _net_nodes(3)  # m/s, m/s, rad/s
N_INVERSE_MASS = _net_nodes()  # 1/kg
N_INVERSE_INERTIA = _net_nodes()  # 1/(kg m^2)


class Joints(NamedTuple):
    """Joints and the bodies that they hold; read by the joints' own stages."""

    counts: Annotated[Ranks, Sized(_joint_counts.width)]
    mechanisms: Annotated[RankRows, Sized("mechanisms", _mechanisms.width)]
    joints: Annotated[RankRows, Sized("joints", _joint.width)]
    given: Annotated[FloatRows, Sized("joints", 10)]  # parameters
    laws: Annotated[FloatRows, Sized("joints", _laws.width)]
    numbers: Annotated[FloatRows, Sized("joints", _joint_numbers.width)]
    members: Annotated[RankRows, Sized("joined", _joined.width)]
    places: Annotated[FloatRows, Sized("joined", _places.width)]
    turns: Annotated[FloatRows, Sized(3, "turned")]  # angle, rad, its cosine and sine, for lanes
    hinges: Annotated[FloatRows, Sized("joined", _hinges.width)]
    tree_blocks: Annotated[RankRows, Sized("tree_blocks", _tree_blocks.width)]
    block_lanes: Annotated[FloatRows, Sized("tree_blocks", _block_lanes.width)]
    tree_above: Annotated[Ranks, Sized("tree_rows")]  # of a row that on which its nodes hang
    tree_slots: Annotated[PlaceRows, Sized("tree_rows", LANES)]
    tree_lanes: Annotated[FloatRows, Sized("tree_rows", _tree_lanes.width)]
    links: Annotated[FloatRows, Sized("joints", _links.width)]
    net_nodes: Annotated[FloatRows, Sized("joined", 8)]
    bends: Annotated[Floats, Sized(9)]  # m, second derivatives of the rows of a joint
    equations: Annotated[RankRows, Sized("equations", _equations.width)]
    operations: Annotated[RankRows, Sized("operations", 3)]  # what is done to which scalars
    scalars: Annotated[Floats, Sized("scalars")]
    clock: Annotated[Floats, Sized(2)]
    # as those of the direct solver, a node for each body that moves
    sparse: Annotated[RankRows, Sized("joint_sparse", _sparse.width)]
    factors: Annotated[FloatRows, Sized("joint_sparse", _factors.width)]
    # bodies that joints keep from touching: of each pair, by the body with the lower row
    apart_first: Annotated[Ranks, Sized("apart_bodies")]  # where those of a row begin
    apart: Annotated[Ranks, Sized("apart")]  # the other rows


# -- continuous collision

FIRST_OF_BODY, CONTACT_OF_BODY, WAITING, PLACE = range(4)  # rows of queue


_grounds = Columns()
G_NX = _grounds()  # normal of the side, towards the body
G_NY = _grounds()
G_HEIGHT = _grounds()  # m, of the side along its normal
G_AHEAD = _grounds()  # m^2/s, how far ahead of the body's centre it holds, times its speed
G_SHAPE = _grounds()  # one more than the shape; 0 for none
G_LOW = _grounds()  # m, from where to where the ground is level, across the normal
G_HIGH = _grounds()


MOST_AT_ONCE = 16  # pairs that meet at one instant and are treated together

_met = Columns()  # of such a pair
MET_CONTACT = _met()
MET_A = _met()  # bodies, as `core_of` needs them: A is no half-plane
MET_B = _met()
MET_TURNED = _met()  # 1 if A is the second one of the pair

_met_point = Columns()  # of each of two points of it
M_ARM_A = _met_point(2)  # m, from the centres of both bodies
M_ARM_B = _met_point(2)
M_NORMAL = _met_point(2)  # from A to B; (0, 0) if there is no such point
M_APPROACH = _met_point()  # m/s, its normal velocity before, at most 0
M_PUSH = _met_point()  # N s, along the normal, of the impact
M_BOUNCE = _met_point()  # N s, the part of it that restitution adds
M_DRAG = _met_point()  # N s, along the tangent
M_HELD = _met_point()  # N s, along the normal, that holds the paths in what is left of the step
M_LASTING = _met_point()  # N s, the same for the velocities as it ends
M_GRIP = _met_point()  # N s, along the tangent, that friction adds then
M_FRICTION = _met_point()
M_RESTITUTION = _met_point()
M_PLACE = _met_point(2)  # m, of hard discs: where they meet

# rows of ahead, of some gaps: m, m/s, m/s^2, and after how many steps of a call they may close
GAP_AHEAD, RATE_AHEAD, BY_AHEAD, DUE_AHEAD = range(4)
MOST_OF_BODY = 64  # pairs of a body among so few that all are listed

PARTNER, PARTNER_SIDE = range(2)  # columns of partners: a body, and its side or -1
MOST_PARTNERS = 256  # of all bodies among so few


class Events(NamedTuple):
    """When bodies leave their bounds and pairs meet; read by continuous collision."""

    times: Annotated[Floats, Sized("events")]  # as a fraction of the step; of hard discs in s
    # where the contacts of each body begin; these contacts; how many events wait, and a heap of
    # them; the place of each there
    queue: Annotated[IndexRows, Sized(4, "queue")]
    # a manifold, vertices of two shapes
    scratch: Annotated[FloatRows, Sized("clip", MANIFOLD), Rewritten()]
    together: Annotated[Places, Sized("slots")]  # the next of the bodies that go on together
    ground: Annotated[FloatRows, Sized("slots", _grounds.width)]  # static side that holds a body
    met: Annotated[IndexRows, Sized(MOST_AT_ONCE, _met.width)]
    met_sides: Annotated[FloatRows, Sized(MOST_AT_ONCE, 2)]  # normals before pairs meet
    met_points: Annotated[FloatRows, Sized(2 * MOST_AT_ONCE, _met_point.width), Rewritten()]
    # of hard discs: after how many steps of a call a pair may meet; pairs that lately touched
    due: Annotated[Ranks, Sized("contacts"), Rewritten()]
    touched: Annotated[Indices, Sized("contacts"), Rewritten()]
    ahead: Annotated[FloatRows, Sized(4, MOST_OF_BODY), Rewritten()]  # gaps of one of them
    # whom the contacts of each body are with, and at which distance of centre and other, m
    partners: Annotated[IndexRows, Sized(MOST_PARTNERS, 2), Rewritten()]
    reaches: Annotated[Floats, Sized(MOST_PARTNERS), Rewritten()]


# -- ballistic motion

CHUNK = 16  # bodies whose coordinates are a row
CHUNK_LANES = 3 * CHUNK  # x, y and angle of a body, and of the next

_course = Columns(CHUNK_LANES)  # of a chunk
L_LOW = _course()  # where it may be
L_HIGH = _course()
L_AT = _course()  # where it was as the call began, or where a mixed one is
L_SPEED = _course()  # how it moved or moves
UNIFORM = _course(1)  # 1 if its bodies are alike
PLAIN = _course(1)  # 1 if it is plain now

_stream = Columns(CHUNK_LANES)  # of each mixed chunk; the last row is that of all plain ones
L_BY = _stream()  # acceleration of its lanes
L_DECAY = _stream()  # propagator of its lanes
L_GAIN = _stream()
L_LIFT = _stream()
L_BEFORE = _stream()  # the frame before a step
L_AFTER = _stream()  # the frame after it

_asleep = Columns(CHUNK_LANES)  # of each chunk; the last row begins with gravity
POSES_ASLEEP = _asleep()
VELOCITIES_ASLEEP = _asleep()
LOADS_ASLEEP = _asleep()


class Chunks(NamedTuple):
    """What users see, a row for each chunk; read by ballistic motion, and where all sleep."""

    poses: FloatRows  # views of what users see
    velocities: FloatRows
    loads: FloatRows
    load_bits: RankRows
    course: Annotated[FloatRows, Sized("chunks", 200), Rewritten()]  # whole cache lines
    stream: Annotated[FloatRows, Sized("streams", _stream.width), Rewritten()]
    asleep: Annotated[FloatRows, Sized("streams", _asleep.width), Rewritten()]  # as all fell asleep


class World(NamedTuple):
    """All of it; only stages take the world, functions the groups that they read."""

    control: Control
    state: BodyState
    bodies: Bodies
    shapes: Shapes
    tree: Tree
    broad_phase: BroadPhase
    buffers: ContactBuffers
    touching: Touching
    constraints: Constraints
    islands: Islands
    direct: Direct
    springs: Springs
    events: Events
    chunks: Chunks
    joints: Joints
