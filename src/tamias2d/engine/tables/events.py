"""Continuous collision: the paths of bodies, and where they meet."""

from typing import Annotated, NamedTuple

from tamias2d.engine.tables.contacts import MANIFOLD
from tamias2d.engine.tables.declarations import Columns, Rewritten, Sized
from tamias2d.kernels.arrays import FloatRows, Floats, IndexRows, Indices, Places, Ranks

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
M_SURFACE_SPEED = _met_point()  # m/s, of both surfaces
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
