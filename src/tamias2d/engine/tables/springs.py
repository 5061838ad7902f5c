"""Springs: a network is what springs connect, through bodies that move freely."""

from typing import Annotated, NamedTuple

from tamias2d.engine.tables.declarations import Columns, Sized
from tamias2d.kernels.arrays import FloatRows, RankRows, Ranks

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
START_POSE = _members()  # as the part began
TURNED = _members(1)  # 1 if a spring holds it off its centre
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
