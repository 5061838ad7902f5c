"""Islands, what bounds their energy, and sleep."""

from typing import Annotated, NamedTuple

from tamias2d.engine.tables.declarations import Columns, Rewritten, Saved, Sized
from tamias2d.kernels.arrays import Bytes, FloatRows, Floats, IndexRows, Indices, Ranks

_links = Columns()
ROOT = _links()  # the body of its island that touches first
SLOW_STEPS = _links()  # steps for which the body has been slow; 1 if it is not dynamic and known
SLEEP_ID = _links()  # under which its island sleeps, 0 if it is awake
AWAKE = _links()  # 1 if the body may wake others
SUPPORT_KIND = _links()  # what it touches, one of those in `waking`
ISLAND_SLOW_STEPS = _links()  # of a root: steps for which all of the island have been slow
FIRST_CONTACT = _links()  # place of its first contact among those that touch

_rest = Columns()
REST_POSE = _rest(3)  # m, m, rad, with which the body fell asleep
REST_LOAD = _rest(3)  # N, N, N m
REST_GRAVITY = _rest(2)  # m/s^2
REST_PULL = _rest(3)  # N, N, N m, of springs, noted in the next step

_energy = Columns()
BEFORE_RESTITUTION = _energy(3)  # m/s, m/s, rad/s, of each body: its velocity
VELOCITY_GIVEN = _energy(2)  # m/s, of each body, as the next two: what contacts have given it
ANGULAR_VELOCITY_GIVEN = _energy()  # rad/s, in all substeps
MOMENT_AHEAD = _energy()  # m^2/s, about where it was as the step began
CHANGE_ENERGY = _energy()  # J, of that change of velocities alone; of a mechanism, of all
GIVEN_PRODUCT = _energy()  # J, of the motion and that change; of a mechanism likewise
ENERGY_OWN = _energy()  # J, of each body: what it had and got by forces, which it keeps
TIED = _energy()  # 1 of a body that joints have pushed in this part
TOTAL_PRESS = _energy()  # N s, as all to ANGULAR_IMPULSE of bodies that nothing turns (DD108)
PRESSED_ARM = _energy(2)  # m, to where contacts press it in the mean
IMPULSE_GOT = _energy(2)  # N s, by all contacts
ANGULAR_IMPULSE = _energy()  # kg m^2/s, about its centre of mass
REFERENCE = _energy(3)  # m/s, m/s, rad/s, of a root, as all below: the rigid motion, at the root,
# from which the island is seen, and towards which its motion is damped
SUPPORT = _energy()  # how many motions support it, one of those in `solver.support`
SUPPORTS_DIFFER = _energy()  # 1 if contacts with things that move against each other support it
ENERGY_START = _energy()  # J, kinetic, as the step began
WORK = _energy()  # J, of gravity and forces
LIFT_WORK = _energy()  # J, which overlaps of an island with joints may give back
LIFT_BEYOND_MOTION = _energy()  # J, of bodies that no joint pushed: lifted beyond what they had
ACTING = _energy()  # 1 if joints push bodies of it
ENERGY_GIVEN_ALL = _energy()  # J, by contacts to the bodies that got some
ENERGY_BEFORE = _energy()  # J, before restitution
ENERGY_AFTER = _energy()  # J, after it
ENERGY_OF_CHANGE = _energy()  # J, of the change of velocities by it alone
KEPT_SHARE = _energy()  # of restitution
ENERGY_KEPT = _energy()  # J, with that share
ENERGY_BOUND = _energy()  # J, that may stay
ENERGY_SURPLUS = _energy()  # J, that its bodies have too much
ENERGY_LEAST = _energy()  # J, of the motion as one, of an island that is damped
ENERGY_APART = _energy()  # J, of what contacts have not pushed, and of spins they have not changed
ALL_COUNT = _energy()  # 1 if there is too much without these
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
DISSIPABLE_ENERGY = _energy()  # J, that the bodies chosen now can lose
DISSIPATED_SHARE = _energy()  # of that
DRIVEN_RATE = _energy()  # m/s, at which its supports move against each other, at most
DRIVEN_ENERGY = _energy()  # J, that what carries its mechanisms is likely to give it; 0 if none is
ISLAND_LOAD = _energy()  # N, sum of the forces on its bodies
OVERLAP_IMPULSE = _energy()  # N s, of all its contacts
OVERLAP_IMPULSE_WAY = _energy()  # N s m, of each times the way by which it became less deep
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
