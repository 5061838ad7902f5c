"""The state of the engine: groups of arrays, with the unit, the size and the readers of each.

Allocation, growth, saving and the entries of compiled code follow from these declarations. A row
of the groups by slot belongs to a body in canonical order, so that bodies that are near in the
world are near in memory; the last row is idle, all zeros, for lanes of a block without a contact.
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

Integers: TypeAlias = NDArray[Any]
"""An array of whole numbers of any width."""


@dataclass(frozen=True)
class Sized:
    """How long an array is along each axis: a number, or the name of a room in `world`."""

    shape: tuple[int | str, ...]

    def __init__(self, *shape: int | str) -> None:
        object.__setattr__(self, "shape", shape)


@dataclass(frozen=True)
class Saved:
    """Marks an array of the saved state; all others follow from these, or hold nothing for long.

    Whole numbers are from 0 on and less than `below`: a number, or a room whose rows they index.
    Where that is so in some columns only, `below` has the bound of each. Other numbers are finite,
    unless they may be infinite, or may be anything because each step looks at them first.
    """

    below: int | str | Mapping[int, int | str] | None = None
    numbers: str = "finite"  # or "infinite", "any"


# -- what a step is asked to do

# control.settings: m/s^2, m/s^2, s
GRAVITY_X, GRAVITY_Y, TIME_STEP = range(3)
# control.counts: substeps of a step; steps that are left of the call; 1 if the values that users
# can set have been checked; the stage at which the step continues; rows that a full array needs;
# steps taken since the start
SUBSTEPS, STEPS_LEFT, CHECKED, STAGE, ROWS_NEEDED, STEPS_TAKEN = range(6)
# values of counts[STAGE]
AT_START, PAIRS_STALE, PAIRS_KNOWN, MANIFOLDS_KNOWN, OUT_OF_BOUNDS, IN_FLIGHT, ARRIVING = range(7)
# control.progress of continuous collision: fraction of the step that is done; updates of the pair
# list that are left
FLOWN, UPDATES_LEFT = range(2)


class Control(NamedTuple):
    """What a step is asked to do, and how far it is; read by all stages."""

    settings: Annotated[Floats, Sized(3), Saved(numbers="any")]
    counts: Annotated[Ranks, Sized(6)]
    progress: Annotated[Floats, Sized(2)]


# -- bodies

# kind
ABSENT, STATIC, KINEMATIC, DYNAMIC = range(4)
# pose: m, m, rad
X, Y, ANGLE = range(3)
# velocity and the first columns of motion: m/s, m/s, rad/s
VX, VY, SPIN = range(3)
# motion: displacement since the step began, m, m, rad
DX, DY, DANGLE = 4, 5, 6
# properties: 1/kg, 1/(kg m^2); radius of the circle around the body, half of its least width, and
# radius of its farthest vertex, m; row of its propagator. Eight columns are one cache line.
INVERSE_MASS, INVERSE_INERTIA, BOUNDING_RADIUS, MIN_EXTENT, CORE_RADIUS, PROPAGATOR = range(6)
# propagators (DD41): v' = DECAY v + GAIN a, x' = x + GAIN v + LIFT a, through a step and through a
# substep, for the velocity and, ANGULAR columns on, for the angular velocity
WHOLE_STEP, ONE_SUBSTEP, ANGULAR = 0, 6, 3
DECAY, GAIN, LIFT = range(3)
# substep_state, for three coordinates each: change of velocity by contacts in this step; velocity
# as the substep began; factor of drag and increment by forces in a substep; velocity as the step
# began
CONTACT_CHANGE, SUBSTEP_START, DRAG_FACTOR, INCREMENT, STEP_START = 0, 3, 6, 9, 12
# flight, of continuous collision: velocity gained by forces in this step, three coordinates; 1 if
# the path was redirected, and more if it goes along with a body that cannot stop; 1 if the body had
# contacts under gravity, so that its velocity at the end says little of that on its way; how far
# some point of it goes, and by how much that is more than its thickness, m
FORCE_GAIN, REDIRECTED, SUPPORTED, PATH_LENGTH, PATH_EXCESS = 0, 3, 4, 5, 6


class BodyState(NamedTuple):
    """Bodies as users see and set them, in the order of adding; read as a batch of steps begins."""

    pose: Annotated[FloatRows, Sized("slots", 3), Saved(numbers="any")]
    velocity: Annotated[FloatRows, Sized("slots", 3), Saved(numbers="any")]
    load: Annotated[FloatRows, Sized("slots", 3), Saved(numbers="any")]  # N, N, N m
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

    pose: Annotated[FloatRows, Sized("slots", 3)]
    motion: Annotated[FloatRows, Sized("slots", 8)]
    load: Annotated[FloatRows, Sized("slots", 3)]  # N, N, N m
    properties: Annotated[FloatRows, Sized("slots", 8)]
    kind: Annotated[Bytes, Sized("slots")]
    propagators: Annotated[FloatRows, Sized("propagators", 12)]
    substep_state: Annotated[FloatRows, Sized("slots", 16)]
    flight: Annotated[FloatRows, Sized("slots", 8)]
    moved: Annotated[Bytes, Sized("slots")]  # 1 if the solver, or sleep, has moved it in this step


# -- shapes

# kind
DISC, CAPSULE, POLYGON, HALF_PLANE = range(4)
# material: friction and restitution, -1 where not stated; radius of the circle around the shape
# from the centre of its body, m; least distance of its sides from there, m, minus infinity where
# the centre is outside
FRICTION, RESTITUTION, SHAPE_RADIUS, SHAPE_INRADIUS = range(4)
# filters
CATEGORY, MASK, GROUP, SENSOR = range(4)


class Shapes(NamedTuple):
    """Convex shapes: vertices grown by a radius; read by the broad and the narrow phase."""

    slot: Annotated[Places, Sized("shapes")]  # of the body
    kind: Annotated[Indices, Sized("shapes"), Saved(4)]
    first: Annotated[Indices, Sized("shapes"), Saved("vertices")]  # vertex
    count: Annotated[Indices, Sized("shapes"), Saved(2**31)]  # of vertices
    radius: Annotated[Floats, Sized("shapes"), Saved()]  # m
    material: Annotated[FloatRows, Sized("shapes", 4), Saved(numbers="infinite")]
    filters: Annotated[RankRows, Sized("shapes", 4), Saved({SENSOR: 2})]
    # vertex, m; normal of its side
    local_vertices: Annotated[FloatRows, Sized("vertices", 4), Saved()]
    world_vertices: Annotated[FloatRows, Sized("vertices", 4), Saved()]  # the same, turned
    # shapes, friction, restitution
    pair_overrides: Annotated[FloatRows, Sized("overrides", 4), Saved({0: "shapes", 1: "shapes"})]


# -- broad phase

# fat_bounds: where the centre of a body may be until pairs are looked for again, m; the angle at
# which that was found, and how far it may turn from there, rad
LOW_X, LOW_Y, HIGH_X, HIGH_Y, BASE_ANGLE, ANGLE_MARGIN = range(6)
# frame, which moves with the bodies while nothing touches: m/s, m; 1 if it moves; m/s^2; propagator
FRAME_VX, FRAME_VY, FRAME_X, FRAME_Y, FRAME_MOVES, FRAME_AX, FRAME_AY, FRAME_PROPAGATOR = range(8)
# broad_phase.counts: contacts on the list, and which of the two buffers holds them; steps for which
# the list is made, and steps since; 1 if it holds; contacts of the first sorted run; bodies that
# have left their bounds since the list was made
CONTACTS, BUFFER, HORIZON, STEPS_SINCE, LIST_HOLDS, FIRST_RUN, UPDATED = range(7)
# tree.counts: shapes under it, and half-planes, which stand behind them
LEAVES, PLANES = range(2)
# tree.boxes: of the k-th leaf, then from FAT on of shape k: low x, low y, high x, high y, m
FAT = 4
# tree.centres, of a leaf: the middle of where its body may be, and how far it may be from there, m;
# radius of the shape, m
CENTRE_X, CENTRE_Y, HALF_WIDTH, HALF_HEIGHT, CENTRE_RADIUS = range(5)
# tree.morton: leaves in Morton order, their keys; and both once more, for sorting
LEAF, KEY = range(2)
# canonical: shapes in canonical order, and the rank of each
SHAPE_OF_RANK, RANK = range(2)


class Tree(NamedTuple):
    """A bounding volume hierarchy over shapes; read by the broad phase and by queries."""

    counts: Annotated[Ranks, Sized(2)]
    boxes: Annotated[FloatRows, Sized("shapes", 8), Saved(numbers="infinite")]
    nodes: Annotated[FloatRows, Sized("nodes", 4), Saved(numbers="infinite")]
    centres: Annotated[FloatRows, Sized("shapes", 8), Saved(numbers="infinite")]
    morton: Annotated[PlaceRows, Sized(4, "morton")]
    leaf_of_shape: Annotated[Places, Sized("shapes"), Saved("shapes")]


class BroadPhase(NamedTuple):
    """Which shapes may touch; read by the broad phase and by continuous collision."""

    counts: Annotated[Ranks, Sized(7), Saved(2**62)]
    frame: Annotated[Floats, Sized(10), Saved()]
    fat_bounds: Annotated[FloatRows, Sized("slots", 6), Saved(numbers="infinite")]
    left: Annotated[Bytes, Sized("slots")]  # 1 if the body has left its bounds
    canonical: Annotated[PlaceRows, Sized(2, "shapes")]
    # pairs of ranks; room to sort them. Saved, because its length decides when pairs are rebuilt.
    candidates: Annotated[PlaceRows, Sized("candidates", 4), Saved(2**32)]
    first_of_rank: Annotated[Places, Sized("ranks")]  # contact of the first run
    rank_counts: Annotated[Places, Sized("ranks")]


# -- contacts

# pairs: two shapes, then the slots of their bodies
SLOT_A, SLOT_B = 2, 3
# manifolds: normal from A to B; of a point its place from the centre of A, m, its gap, m, impulses
# along normal and tangent, N s, and preload, m; of the last step its impulse, N s, and its place in
# the world, m; the axis cache, 4 columns; then all of the second point; and the normal of an impact
# in flight. A contact with one point takes half of its four cache lines.
NX, NY = 0, 1
PX, PY, GAP, NORMAL_IMPULSE, TANGENT_IMPULSE, PRELOAD = 2, 3, 4, 5, 6, 7
TOTAL_IMPULSE, WORLD_POINT = 8, 9
AXIS_CACHE = 11
POINT = 16  # columns from a point to the next
IMPACT_NORMAL = 30
MANIFOLD = 32
# flags: points; names of both; whether it touches, bit by bit; the cached axis, 2 columns
POINT_COUNT, FEATURE, TOUCHES, CACHED_AXIS = 0, 1, 3, 4
IS_TOUCHING, WAS_TOUCHING = 1, 2  # bits of TOUCHES: in this step, in the last one
# touching.counts: contacts that touch; 1 if blocks, and if islands, are those of these contacts
TOUCHING, ARRANGED, ISLANDS_KNOWN = range(3)


class ContactBuffers(NamedTuple):
    """Pairs of shapes that may touch, twice: a new list is made from the old one."""

    pairs: Annotated[PlaceBlocks, Sized(2, "contacts", 4)]
    manifolds: Annotated[FloatBlocks, Sized(2, "contacts", MANIFOLD)]
    flags: Annotated[IndexBlocks, Sized(2, "contacts", 6)]


class Contacts(NamedTuple):
    """Pairs of shapes that may touch, in two runs, each in canonical order; one of the buffers."""

    pairs: Annotated[
        PlaceRows, Sized("contacts", 4), Saved({0: "shapes", 1: "shapes", 2: "slots", 3: "slots"})
    ]
    manifolds: Annotated[FloatRows, Sized("contacts", MANIFOLD), Saved()]
    flags: Annotated[
        IndexRows, Sized("contacts", 6), Saved({POINT_COUNT: 3, TOUCHES: 4, CACHED_AXIS: 2**31})
    ]


class Touching(NamedTuple):
    """The contacts that touch, in canonical order; read by the solvers and by sleep."""

    counts: Annotated[Ranks, Sized(3), Saved(2**62)]
    contact: Annotated[Places, Sized("contacts")]
    body_a: Annotated[Places, Sized("contacts")]
    body_b: Annotated[Places, Sized("contacts")]
    colour: Annotated[Places, Sized("contacts")]  # twice that, plus the number of points less one
    lane: Annotated[Places, Sized("contacts")]  # counted through all blocks
    by_slab: Annotated[Places, Sized("contacts")]  # of these contacts, slab by slab
    active: Annotated[Places, Sized("pair_bodies")]  # moving bodies in the order of touching
    active_by_slab: Annotated[Places, Sized("pair_bodies")]


# -- solver

LANES = 16
COLOURS = 60
# lanes: bodies of each lane; lanes that are taken, points of each contact
BODY_A, BODY_B, FILLED, POINTS = 0, 16, 32, 33
# blocks, a row for each block of lanes: what the points share
R_NX, R_NY, R_MASS_A, R_INERTIA_A, R_MASS_B, R_INERTIA_B = 0, 16, 32, 48, 64, 80
R_FRICTION, R_ROUND_A, R_ROUND_B, R_LIMIT, R_RESTITUTION = 96, 112, 128, 144, 160
R_BIAS, R_SHARE, R_KEEP, R_RADIUS = 176, 192, 208, 224
SHARED = 240
# then of each point: turning arms of normal and tangent, m; effective masses, kg; gap as the step
# began, m; impulses along normal and tangent, and the sum of the former over substeps, N s; speed
# before the step, m/s; gap now, m
P_ARM_A, P_ARM_B, P_SIDE_A, P_SIDE_B, P_MASS, P_SIDE_MASS = 0, 16, 32, 48, 64, 80
P_GAP, P_NORMAL, P_TANGENT, P_TOTAL, P_APPROACH, P_GAP_NOW = 96, 112, 128, 144, 160, 176
SIZE = 192
FIRST, SECOND = SHARED, SHARED + SIZE
# then of each point its impulse of restitution, N s
FIRST_BOUNCE, SECOND_BOUNCE = SECOND + SIZE, SECOND + SIZE + LANES
BLOCK_WIDTH = SECOND_BOUNCE + LANES
# scratch: velocities and displacements of a block's bodies; sums of energy over all bodies with
# contacts, J: as the step began, now, and the work of forces; a number that nothing reads, because
# a prefetch whose result went nowhere would not be compiled
B_VX_A, B_VY_A, B_SPIN_A, B_VX_B, B_VY_B, B_SPIN_B = 0, 16, 32, 48, 64, 80
B_DX_A, B_DY_A, B_ANGLE_A, B_DX_B, B_DY_B, B_ANGLE_B = 96, 112, 128, 144, 160, 176
ENERGY_FIRST, ENERGY_NOW, ENERGY_GIVEN, PREFETCHED = 192, 193, 194, 195
SCRATCH = 196
# slabs: where contacts, blocks, moving bodies and tree-like islands of each slab begin
S_CONTACT, S_BLOCK, S_BODY, S_TREE = range(4)
MOST_SLABS = 256
# constraints.counts: moving bodies with contacts; blocks; contacts that may bounce; 1 if lanes hold
# what stays while the arrangement does; slabs
ACTIVE, BLOCKS, BOUNCING, LANES_FILLED, SLABS = range(5)


class Constraints(NamedTuple):
    """Contact constraints in blocks of lanes; read by the solver."""

    counts: Annotated[Ranks, Sized(5)]
    blocks: Annotated[FloatRows, Sized("blocks", BLOCK_WIDTH)]
    lanes: Annotated[PlaceRows, Sized("blocks", POINTS + 1)]
    scratch: Annotated[Floats, Sized(SCRATCH)]
    slabs: Annotated[RankRows, Sized(MOST_SLABS + 2, 4)]
    colour_counts: Annotated[RankRows, Sized(2, 128)]  # of a slab: sizes of colours, next places
    body_colours: Annotated[Ranks, Sized("slots")]  # taken colours of a body, bit by bit


# -- islands and sleep

# islands.links: the root, which is the body of the island that touches first; steps for which the
# body has been slow; id under which its island sleeps, 0 if awake; 1 if it may wake others; what it
# touches; of the root, steps for which all have been slow; place of its first contact
ROOT, SLOW_STEPS, SLEEP_ID, AWAKE, SUPPORT_KIND, ISLAND_SLOW_STEPS, FIRST_CONTACT = range(7)
# islands.rest: pose, load and gravity with which a body fell asleep
REST_LOAD, REST_GRAVITY = 3, 6
# islands.energy, of a body: velocity before restitution; of a root: motion of what the island is
# seen from, and whether that supports it; energies, J: as the step began, work of forces, before
# and after restitution, of its change alone; share of restitution that is kept, energy with it,
# most that may stay; mass, momentum and angular momentum as seen from there, moments of the mass;
# factor of the motion that differs from that of the whole
UNBOUNCED, SEEN, SUPPORT = 0, 3, 6
ENERGY_START, WORK, ENERGY_BEFORE, ENERGY_AFTER, ENERGY_OF_CHANGE = 7, 8, 9, 10, 11
KEPT_SHARE, ENERGY_KEPT, ENERGY_MOST = 12, 13, 14
ISLAND_MASS, MOMENTUM_X, MOMENTUM_Y, ANGULAR_MOMENTUM = 15, 16, 17, 18
MOMENT_X, MOMENT_Y, MOMENT_OF_INERTIA, CALM_FACTOR = 19, 20, 21, 22
# islands.counts: steps until sleep, 0 for never; bodies that sleep
SLEEP_STEPS, SLEEPING = range(2)


class Islands(NamedTuple):
    """Bodies that touch each other; read by sleep and by the bound on energy."""

    counts: Annotated[Ranks, Sized(2), Saved(2**31)]
    links: Annotated[
        IndexRows,
        Sized("slots", 7),
        Saved({ROOT: "slots", SLOW_STEPS: 2**31, SLEEP_ID: "slots"}),
    ]
    rest: Annotated[FloatRows, Sized("slots", 8), Saved()]
    energy: Annotated[FloatRows, Sized("slots", 23)]


# -- direct solver

# trees, of a body: its contacts with moving bodies that are left, and these joined by exclusive or;
# the root of its tree, or -1; its node; and of a root: bodies of the tree, its contacts with the
# ground, its number among tree-like islands; slab of the body
DEGREE, INCIDENT, TREE, NODE, TREE_BODIES, GROUNDED, NUMBER, SLAB = range(8)
# sparse: columns of lists that have nothing else to do with each other. Of a node, a moving body
# of a tree-like island: its slot, first edge, edges, pivot
N_BODY, N_HEAD, N_DEGREE, N_PIVOT = 0, 1, 2, 3
E_ONE, E_OTHER, E_NEXT = 4, 5, 6  # of an edge between nodes; the next edges of both, in 6 and 7
V_NODE, V_FIRST, V_COUNT = 8, 9, 10  # of a pivot: its node, and its part of the fill list
C_BLOCK, C_LANE, C_ONE, C_OTHER, C_EDGE, C_STATE = 11, 12, 13, 14, 15, 16  # of a contact
FILL = 17  # of each pivot its edges, and then the edges that change by it
I_NODE, I_CONTACT, I_FACTORED = 18, 19, 20  # where an island begins; 1 if its matrix is factored
LEAF_NODE, PASS_NODE = 21, 22  # nodes with at most one neighbour, and with two, that wait
C_BUILT = 23  # the state with which a contact is in the matrix
SPARSE = 24
# factors, beside the columns of `sparse`: of a node six numbers of a lower triangle, changes of its
# velocity, velocity as it was, mass and inertia
DIAGONAL, CHANGE, START, NODE_MASS, NODE_INERTIA = 0, 6, 9, 12, 13
BESIDE = 14  # of an edge nine numbers: rows of the later node, columns of the earlier
BIAS, ASKED, SOFT, SHARE = 23, 25, 29, 34  # of a contact
FIRM, SCALE, HEAVIEST = 32, 33, 35  # of an island
FACTORS = 36
# direct.counts: tree-like islands, and their contacts
TREES, TREE_CONTACTS = range(2)


class Direct(NamedTuple):
    """Tree-like islands, whose contacts are solved at once; read by the direct solver."""

    counts: Annotated[Ranks, Sized(2)]
    trees: Annotated[IndexRows, Sized("slots", 8)]
    sparse: Annotated[RankRows, Sized("sparse", SPARSE)]
    factors: Annotated[FloatRows, Sized("sparse", FACTORS)]
    contacts: Annotated[Places, Sized("contacts")]  # touching contacts of tree-like islands
    leaves: Annotated[Places, Sized("pair_bodies")]  # bodies that were taken off, in order
    taken_off: Annotated[Places, Sized("pair_bodies")]  # the bodies off which they were taken


# -- continuous collision

# queue: where the contacts of each body begin; these contacts; a tournament tree, winner first
FIRST_OF_BODY, CONTACT_OF_BODY, TOURNAMENT = range(3)
WINNER = 1


class Events(NamedTuple):
    """When bodies leave their bounds and pairs meet; read by continuous collision."""

    times: Annotated[Floats, Sized("events")]  # as a fraction of the step
    queue: Annotated[IndexRows, Sized(3, "queue")]
    scratch: Annotated[FloatRows, Sized("clip", MANIFOLD)]  # a manifold, vertices of two shapes


# -- ballistic motion

CHUNK = 16  # bodies whose coordinates are a row
CHUNK_LANES = 3 * CHUNK  # x, y and angle of a body, and of the next
# course, a row for each chunk: where it may be; where it was and how it moved as the call began, or
# where a mixed one is and how it moves; 1 if its bodies are alike; 1 if it is plain now
L_LOW, L_HIGH, L_AT, L_SPEED = 0, CHUNK_LANES, 2 * CHUNK_LANES, 3 * CHUNK_LANES
UNIFORM, PLAIN = 192, 193
COURSE = 200
# stream, of each mixed chunk: acceleration and propagator of its lanes; the frame before and after
# a step; the last row is that of all plain chunks
L_BY, L_DECAY, L_GAIN, L_LIFT = 0, CHUNK_LANES, 2 * CHUNK_LANES, 3 * CHUNK_LANES
L_BEFORE, L_AFTER = 4 * CHUNK_LANES, 5 * CHUNK_LANES
STREAM = 288


class Chunks(NamedTuple):
    """Bodies that are near nothing, a row for each chunk; read by ballistic motion."""

    poses: FloatRows  # views of what users see
    velocities: FloatRows
    loads: FloatRows
    load_bits: RankRows
    course: Annotated[FloatRows, Sized("chunks", COURSE)]
    stream: Annotated[FloatRows, Sized("streams", STREAM)]


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
    events: Events
    chunks: Chunks
