"""The direct solver: nodes are the moving bodies of tree-like islands, edges touching pairs."""

from typing import Annotated, NamedTuple

from tamias2d.engine.tables.declarations import Columns, Sized
from tamias2d.kernels.arrays import FloatRows, IndexRows, Places, RankRows, Ranks

_trees = Columns()
DEGREE = _trees()  # contacts of the body with moving ones that are left
INCIDENT = _trees()  # these contacts, joined by exclusive or
TREE = _trees()  # root of its tree, or -1
NODE = _trees()  # of the body, or -1
TREE_BODIES = _trees()  # of a root: bodies of its tree
GROUNDED = _trees()  # of a root: contacts of its tree with bodies that do not move freely
TREE_NUMBER = _trees()  # of a root: number among the islands that are solved directly, or -1

sparse_columns = Columns()  # lists that share nothing but their rows
N_BODY = sparse_columns()  # of a node: slot
N_HEAD = sparse_columns()  # first half-edge, or -1; an edge e is the half-edges 2e and 2e + 1
N_DEGREE = sparse_columns()  # edges to nodes that are not eliminated
N_PIVOT = sparse_columns()  # place in the order of elimination, or -1
E_NODE_A = sparse_columns()  # of an edge: its nodes; once ordered, A is eliminated first
E_NODE_B = sparse_columns()
E_NEXT = sparse_columns(2)  # next half-edges at both nodes
PIVOT_NODE = sparse_columns()  # of a pivot
PIVOT_FIRST = sparse_columns()  # where its edges begin on the fill list
PIVOT_COUNT = sparse_columns()  # its edges
C_BLOCK = sparse_columns()  # of a contact
C_LANE = sparse_columns()
C_NODE_A = sparse_columns()  # nodes of its bodies, or -1
C_NODE_B = sparse_columns()
C_EDGE = sparse_columns()  # between them, or -1
C_STATE = sparse_columns()  # in the active set, bits in `direct.active_set`
C_FACTORED = sparse_columns()  # the state with which it is in the matrix
FILL = sparse_columns()  # the fill list: of each pivot its edges, then the edges that change by it
I_NODE = sparse_columns()  # of an island: where its nodes and pivots begin
I_CONTACT = sparse_columns()  # where its contacts begin
I_NEXT_NODE = sparse_columns()  # place of its next node, while they are listed
I_NEXT_CONTACT = sparse_columns()
I_STATUS = sparse_columns()  # whether its matrix is factored, one of those in `direct.solve`
LEAF_NODE = sparse_columns()  # a stack: nodes with at most one neighbour
PASS_NODE = sparse_columns()  # a stack: nodes with two

factor_columns = Columns()  # numbers beside the columns of sparse
DIAGONAL = factor_columns(6)  # of a node: lower triangle of its block
CHANGE = factor_columns(3)  # residual momentum, N s and N m s; solved in place: change of velocity
VELOCITY_START = factor_columns(3)  # m/s, m/s, rad/s, before the island was solved
NODE_MASS = factor_columns()  # kg
NODE_INERTIA = factor_columns()  # kg m^2
OFF_DIAGONAL = factor_columns(9)  # of an edge: rows of the later node, columns of the earlier one
BIAS = factor_columns(2)  # of a contact: m/s, of each point
SPEED_ERROR = factor_columns(2)  # m/s, normal velocity and bias as the solve began
NEW_NORMAL = factor_columns(2)  # N s, normal impulses that are proposed
NEW_TANGENT = factor_columns(2)  # N s
SOFTNESS = factor_columns(3)  # bias rate, mass share and impulse share of the soft constraint
FRICTION_SHARE = factor_columns()  # of the first of two points
FIRM_MASS = factor_columns()  # of an island: kg, with which contacts resist velocity
IMPULSE_SCALE = factor_columns()  # N s
LARGEST_MASS = factor_columns()  # kg

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
    sparse: Annotated[RankRows, Sized("sparse", sparse_columns.width)]
    factors: Annotated[FloatRows, Sized("sparse", factor_columns.width)]
    contacts: Annotated[Places, Sized("contacts")]  # touching contacts of these islands
    leaves: Annotated[Places, Sized("pair_bodies")]  # bodies that were taken off, in order
    taken_off: Annotated[Places, Sized("pair_bodies")]  # the bodies off which they were taken
