"""The constraints of contacts, in blocks of lanes and in slabs."""

from typing import Annotated, NamedTuple

from tamias2d.engine.tables.declarations import Columns, Rewritten, Sized
from tamias2d.kernels.arrays import FloatRows, Floats, Indices, PlaceRows, RankRows, Ranks
from tamias2d.kernels.lanes import LANES

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
R_SURFACE_SPEED = _block()  # m/s, of both surfaces
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
P_TOTAL_FRICTION = _point()  # N s, along the tangent, likewise
P_APPROACH = _point()  # m/s, normal velocity before the step; 0 if that makes no impact
P_GAP_NOW = _point()  # m
POINT_SIZE = _point.width
FIRST_POINT, SECOND_POINT = _block(POINT_SIZE), _block(POINT_SIZE)
FIRST_RESTITUTION, SECOND_RESTITUTION = _block(), _block()  # N s, impulses of restitution
FIRST_REBOUND_DRAG, SECOND_REBOUND_DRAG = _block(), _block()  # N s, what friction adds then
TO_REBOUND_DRAG = FIRST_REBOUND_DRAG - FIRST_RESTITUTION

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
REBOUNDING = _energy_sums()  # place of the one point that rebounds on a jointed body, or -1
REBOUND_MOST = _energy_sums()  # J, of what is jointed and rebounds: more is made by turns in vain
REBOUND_LOST = _energy_sums()  # m/s, of its velocity, by joints in the last turn

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
RUNNING = _constraints()  # contacts with surfaces that run
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
