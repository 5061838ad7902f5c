"""Bodies: what users see of them, and the slots of the engine."""

from typing import Annotated, NamedTuple

from tamias2d.engine.tables.control import MOST_LEVEL
from tamias2d.engine.tables.declarations import Columns, Rewritten, Saved, Sized
from tamias2d.kernels.arrays import Bytes, FloatBlocks, FloatRows, Places

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
JOINED = _properties()  # its place among the members of joints, 0 where it has none; negative
# where these only rub

# propagators (DD41): v' = DECAY v + GAIN a, x' = x + GAIN v + LIFT a. What is left of impulses is
# SLOWED, or SLOWED_MEAN where the first and the last of a step act through half a substep
DECAY, GAIN, LIFT, SLOWED, SLOWED_MEAN = range(5)  # 1, s, s^2, 1, 1
_propagators = Columns(5)
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
REST_FRICTION = _path()  # N, along the tangent
REST_PUSH = _path()  # N s, what the normal force has given in this step until then
REST_DRAG = _path()  # N s, what friction has


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
