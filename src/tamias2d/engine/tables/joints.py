"""Joints: a mechanism is what joints connect, through bodies that move freely."""

from typing import Annotated, NamedTuple

from tamias2d.engine.tables.declarations import Columns, Rewritten, Sized
from tamias2d.engine.tables.direct import factor_columns, sparse_columns
from tamias2d.engine.tables.hinges import hinge_columns, link_columns
from tamias2d.engine.tables.tree_lanes import (
    block_lane_columns,
    tree_block_columns,
    tree_lane_columns,
)
from tamias2d.kernels.arrays import FloatRows, Floats, PlaceRows, RankRows, Ranks
from tamias2d.kernels.lanes import LANES
from tamias2d.spec.row_program import OUTPUTS

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
M_FIRM = _mechanisms()  # 1 unless all its joints only rub: give at most a maximum, for a rate
M_CHOOSING = _mechanisms()  # 1 if it has limits, motors, or springs with a maximum
M_BOUNCING = _mechanisms()  # 1 if it has limits that bounce
M_TOUCHED = _mechanisms()  # 1 if contacts touch it
M_HINGED = _mechanisms()  # 1 if it is a net or a tree of hinges; of a tree nodes come after those
# above them, and joints that are no hinges of nodes last
M_IN_BLOCK = _mechanisms()  # 1 if it is a tree that is solved in a lane of a block
M_WRITTEN = _mechanisms()  # 1 if its rows are those of its places and masses
M_HALF = _mechanisms()  # 1 in the first substep of a step whose forces came half before it
# status: those of the second kind have no limits, motors and springs, those of the third have some
# and contacts touch those of the fourth; they strike those of the last, while that is answered
ASLEEP, FREE_OF_CONTACTS, GOVERNED_ALONE, IN_CONTACT, STRUCK = range(5)

_joint = Columns()  # whole numbers of a joint
J_KIND = _joint()  # by the number in `generated.joint_rows`
J_ROWS = _joint()  # how many of them
J_MEMBER = _joint(3)  # of its bodies A, B and C; 0 for the plane
J_NODE = _joint(3)  # their nodes, or one of those below
J_EDGE = _joint(3)  # of the pairs AB, AC and BC, or -1 where one does not move
J_LAW = _joint()  # what governs its row, one of those below
J_STATE = _joint()  # whether a limit or a motor holds, one of those below
J_STATE_BEFORE = _joint()  # the same, before its mechanism was struck
J_EQUATION = _joint()  # its equation, or -1 where it is one of a kind
J_PAIR = _joint()  # of the spring of a target: its other row, or one of those below

KEPT, LOWER_LIMIT, UPPER_LIMIT, MOTOR, SPRING = range(5)  # at zero; one row if not KEPT
HOLDS, FREE_ROW, AT_MOST, AT_LEAST = range(4)  # a motor gives the most forwards, or backwards
NO_PAIR, OF_PAIR = -1, -2  # a row by itself; the second row of a target

_laws = Columns()  # numbers of a law
LAW_RATE = _laws()  # m/s or rad/s, of a motor, or of what an equation keeps
LAW_MOST = _laws()  # N or N m, of a motor or a spring; endless where there is no maximum
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
POINTS_OF_MEMBER = 4  # that are answered together where a mechanism is struck, on the average
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
J_PULLED = _joint_numbers()  # likewise: substeps in which it is pulled, by hand or back
J_OPENED = (
    _joint_numbers()
)  # m/s, likewise: the fastest that what ties it has moved since it yielded
J_FIRMEST = _joint_numbers(3)  # kg, of each row while its mechanism yields, else 0
J_SCALE = _joint_numbers()  # J, likewise: the most of motion and springs lately
J_APART = _joint_numbers(3)  # m or rad, by how much each row was apart at most, until it is asked
J_TURNED = _joint_numbers()  # 1 if its first row turned too far in a substep, until it is asked
J_GAINED = _joint_numbers()  # 1 if J_GAIN was in a part, until it is asked
J_TOTAL = _joint_numbers(9)  # N s, N s, N m s, impulses on A, B and C over this part
J_PULL = _joint_numbers(3)  # N s, impulse of each row over this part
J_GIVEN = _joint_numbers(3)  # N s, of each row over this substep; of a spring less what was left
J_DRIVEN = _joint_numbers()  # m/s, likewise: at which what ties it parts its rows in this substep
J_MOST = _joint_numbers()  # J, likewise: of motion that a solution may lead to in this substep
J_ENERGY = _joint_numbers()  # J, likewise: of springs, as a part begins
J_RESERVE_LATER = _joint_numbers()  # J, as it ends
J_MOTION_LATER = _joint_numbers()  # J, as it ends
J_SCALE_LATER = _joint_numbers()  # J, as it ends
J_MOMENT = _joint_numbers()  # N m s, likewise: that joints have given it in this part
J_GAIN = _joint_numbers()  # likewise: 1 if energy was made in this part, with what touches it
J_LEFT = _joint_numbers()  # N s, that a spring has left to give where bodies have moved to
J_SLIGHT = _joint_numbers(3)  # m or rad, by how much each row may be apart without being looked at
J_VALUE_START = _joint_numbers()  # m or rad, of a limit as a substep begins
J_RATE_START = _joint_numbers()  # m/s or rad/s, likewise
J_STRUCK = _joint_numbers()  # m/s or rad/s, rate as it was struck in this part, 0 if it was not
J_ARM = _joint_numbers(3)  # m, at which an angle counts as a length; 1 for a length
J_PUSHED_BEFORE = _joint_numbers()  # the same of the step before
J_STRUCK_AT = _joint_numbers()  # the number of the step in which it was struck last
J_STRIKE = _joint_numbers()  # N s or N m s, its impulse over that step
J_LEFT_AT = _joint_numbers()  # the number of the step in which it was left last
J_IMPULSE = _joint_numbers(3)  # N s, of each row by the last solution
J_RESIDUAL = _joint_numbers(3)  # m/s, what is left of its error
J_OFFSET = _joint_numbers(3)  # m or rad, to which a substep leads each row, less its rate's way
J_SEARCH = _joint_numbers(3)  # N s, direction of conjugate gradients
J_TRIED = _joint_numbers(3)  # N s, residual over the matrix, about
J_EXERTED = _joint_numbers()  # share of its stiffness and damping with which a spring counts
J_SOFTNESS = _joint_numbers()  # one over the share that was tried before, 0 if none was
J_SPARE = _joint_numbers()  # the most of such a spring, over what it would have given then

_joined = Columns()  # members: the plane, the nodes, then static and then kinematic bodies
JOINED_BODY = _joined()  # row of the body
JOINED_SLOT = _joined()  # its slot in this step
JOINED_ABOVE = _joined()  # member on which it hangs in a tree of hinges; 0 for the plane
JOINED_HINGE = _joined()  # the joint by which it hangs, or -1
JOINED_MECHANISM = _joined()  # of a node
JOINED_SPRING = _joined()  # the spring of the angle of that, of a tree in a block, or -1

_places = Columns()  # of a member, as generated code takes it
PLACE_X = _places()  # m
PLACE_Y = _places()  # m
PLACE_ANGLE = _places()  # rad
PLACE_COSINE = _places()
PLACE_SINE = _places()
LEANING = _places()  # N m, of joints that pull at the arms of the body
SLOWED_INVERSE_MASS = _places()  # 1/kg, with which it counts in joints, as drag slows it
HELD_INVERSE_INERTIA = _places()  # 1/(kg m^2), likewise

_impact_points = Columns()  # of a point of a mechanism that is struck
STRUCK_PLACE = _impact_points()  # two for each lane of each block
STRUCK_ALLOWED = _impact_points()  # m/s, at which it may close
STRUCK_RATE = _impact_points()  # m/s, along one of its lines, that is to be taken away
STRUCK_STEP = _impact_points()  # N s, that is tried along it
STRUCK_LEFT = _impact_points()  # N s, of what was tried before, that is still to be given
STRUCK_NORMAL = _impact_points()  # N s, so far
STRUCK_TANGENT = _impact_points()  # N s, so far


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
    hinges: Annotated[FloatRows, Sized("joined", hinge_columns.width)]
    tree_blocks: Annotated[RankRows, Sized("tree_blocks", tree_block_columns.width)]
    block_lanes: Annotated[FloatRows, Sized("tree_blocks", block_lane_columns.width)]
    tree_above: Annotated[Ranks, Sized("tree_rows")]  # of a row that on which its nodes hang
    tree_slots: Annotated[PlaceRows, Sized("tree_rows", LANES)]
    tree_lanes: Annotated[FloatRows, Sized("tree_rows", tree_lane_columns.width)]
    links: Annotated[FloatRows, Sized("joints", link_columns.width)]
    net_nodes: Annotated[FloatRows, Sized("joined", 8)]
    impact_points: Annotated[FloatRows, Sized("impact_points", _impact_points.width), Rewritten()]
    bends: Annotated[Floats, Sized(9)]  # m, second derivatives of the rows of a joint
    equations: Annotated[RankRows, Sized("equations", _equations.width)]
    operations: Annotated[RankRows, Sized("operations", 3)]  # what is done to which scalars
    scalars: Annotated[Floats, Sized("scalars")]
    clock: Annotated[Floats, Sized(2)]
    # as those of the direct solver, a node for each body that moves
    sparse: Annotated[RankRows, Sized("joint_sparse", sparse_columns.width)]
    factors: Annotated[FloatRows, Sized("joint_sparse", factor_columns.width)]
    # bodies that joints keep from touching: of each pair, by the body with the lower row
    apart_first: Annotated[Ranks, Sized("apart_bodies")]  # where those of a row begin
    apart: Annotated[Ranks, Sized("apart")]  # the other rows
