"""Contacts: pairs whose boxes meet, what each step finds of them, and lists of those that touch."""

from typing import Annotated, NamedTuple

from tamias2d.engine.tables.declarations import Columns, Saved, Sized
from tamias2d.kernels.arrays import (
    FloatBlocks,
    FloatRows,
    Floats,
    IndexBlocks,
    IndexRows,
    PlaceBlocks,
    PlaceRows,
    Places,
    Ranks,
)

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
FRICTION_IMPULSE = _manifolds(2)  # N s, of both points along the tangent in the last step
FRICTION_BEFORE = _manifolds(2)  # N s, of parts of a step that have ended, as a vector
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
PART_FRICTION_X, PART_FRICTION_Y = FRICTION_IMPULSE, FRICTION_IMPULSE + 1
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
IN_PARTS = _flags()  # 1 if what is told of it is of a step in parts
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
                IN_PARTS: 2,
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
IMPULSES_UNKNOWN = _touching()  # 1 if contacts act that did not before, or come in this part
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
