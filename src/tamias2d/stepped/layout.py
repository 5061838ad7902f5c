"""What the columns of the engine's arrays hold.

Serves: all modules of the stepped way. Hides: nothing; these are the names of places.

Bodies, shapes and pairs are rows of wide arrays, because a kernel is called with each array at a
price. Body arrays have one row more than there are bodies, the idle one, all zeros: lanes of a
block that have no contact work on it. The row of a body is its seat, in the canonical order of
those that came together, so that what is near in the world is near in memory.
"""

from typing import Any, TypeAlias

from numpy.typing import NDArray

Whole: TypeAlias = NDArray[Any]
"""An array of whole numbers."""

# settings (13,), as numbers: gravity, m/s^2, and the step, s; velocity of the frame in which the
# list of pairs holds, m/s, and how far it has gone since, m; whether it moves, what moves it,
# m/s^2, and its flow over a step: three numbers
GRAVITY_X, GRAVITY_Y, TIME_STEP = 0, 1, 2
FRAME_VX, FRAME_VY, FRAME_X, FRAME_Y = 3, 4, 5, 6
FRAME_MOVES, FRAME_BY_X, FRAME_BY_Y, FRAME_FLOW = 7, 8, 9, 10

# counts (25,), as whole numbers
SUBSTEPS, PAIRS, SIDE, HORIZON, SINCE, NEEDED, BLOCKS, STILL = range(8)
LEAVES, HITS, ACTIVE, PHASE, BOUNCING, THIN = 8, 9, 10, 11, 12, 13
WANTED, SOUND = 14, 15  # steps that are left of a call, and whether its values have been checked
PATIENCE, DORMANT = 16, 17  # steps of quiet until sleep, 0 for never; how many bodies sleep
SORTED, MENDED = 18, 19  # pairs of the first run of the list; bodies that left since it was made
ARRANGED, ISLANDED = 20, 21  # whether blocks, and islands, are those of what touches now
SEATED = 22  # whether lanes have what stays in them while the arrangement does
SLABS, JOINTS = 23, 24  # how many stretches are solved in turns; touching pairs of thin islands

# hits (10, 2p): pairs that touch, in canonical order, with their colours and places in them; then
# moving bodies that they touch, in the order of touching, and in that of their rows; those of the
# pairs that are in thin islands; and for finding them what is peeled, and off which body; and the
# bodies of the pairs; in the end, in the place of what was peeled, touching pairs slab by slab
HIT, HIT_COLOUR, HIT_PLACE, ACTIVE_BODY, ACTIVE_ROW = 0, 1, 2, 3, 4
HIT_THIN, HIT_PEELED, HIT_PEELED_OFF = 5, 6, 7
HIT_A, HIT_B = 8, 9
HIT_BY_SLAB = HIT_PEELED

# what is known of a step that has begun (PHASE)
BEGUN, STALE, KNOWN, MET, OUTRUN, SWEPT, ARRIVING = 0, 1, 2, 3, 4, 5, 6

# pose (n+1, 3): m, m, rad
X, Y, TURN = 0, 1, 2

# velocity (n+1, 3): m/s, m/s, rad/s; motion (n+1, 8) is what steps work on: velocity m/s, spin
# rad/s, and what has been moved since the step began
VX, VY, SPIN = 0, 1, 2
DX, DY, DTURN = 4, 5, 6

# body (n+1, 8), a line of a cache: what does not change from step to step
INVERSE_MASS, INVERSE_INERTIA = 0, 1
REACH, INNER, ARM = 2, 3, 4  # radius around it, within it, and to its farthest corner, m
FLOW = 5  # which row of the flows is its own: most bodies share one

# flows (k, 12): how velocity and place flow over a step and over a substep, six columns each
FULL, SUB = 0, 6
DECAY, GAIN, LIFT = 0, 1, 2  # of a flow: v' = DECAY v + GAIN a, x' = x + GAIN v + LIFT a
ANGULAR = 3  # columns from the flow of the velocity to that of the spin

# home (n+1, 6): where the centre may be until pairs are looked for again, m; then its turn, rad
LOW_X, LOW_Y, HIGH_X, HIGH_Y, HOME_TURN, TURN_ROOM = 0, 1, 2, 3, 4, 5

# island (n+1, 7), as whole numbers: the root, which is the first in canonical order of those that
# touch each other; for how many steps it has been quiet; by what name its island sleeps, 0 awake;
# whether it may wake others; what it touches; of the root, for how many steps all have been quiet;
# and its turn in the order of touching
ISLAND, QUIET, NIGHT, LIVE, COMPANY, PEACE, TURN_IN = 0, 1, 2, 3, 4, 5, 6

# rest (n+1, 8): pose, load and gravity with which it fell asleep
REST_LOAD, REST_GRAVITY = 3, 6

# energy (n+1, 17): velocities before bouncing; then of the island whose root this is: the motion
# of what it leans on, whether it does, and sums, J
UNBOUNCED, SEEN, LEANS, SUMS = 0, 3, 6, 7
ENERGIES = 17

# carried (n+1, 16), for each coordinate: what contacts have changed in the velocity, the velocity
# as this substep began, what drag and forces make of it, and the velocity as the step began; of
# what is static, zeros. In flight there is what forces add to the velocity, in place of the noted.
CARRIED, NOTED, KEPT_BY_DRAG, GIVEN, EARLIER = 0, 3, 6, 9, 12

# kind (n+1,)
ABSENT, STATIC, KINEMATIC, DYNAMIC = 0, 1, 2, 3

# shape_kind (m,)
DISC, CAPSULE, POLYGON, HALF_PLANE = 0, 1, 2, 3

# surface (m, 4): friction, restitution (-1 where not stated), reach, m, and how near its sides are
# to the centre of its body, m, which says nothing where that is outside, as minus infinity
FRICTION, RESTITUTION, SHAPE_REACH, SHAPE_INNER = 0, 1, 2, 3

# filter (m, 4): which shapes meet at all
CATEGORY, MASK, GROUP, SENSOR = 0, 1, 2, 3

# curve (5, m + 256): the shapes along the tree's curve; where on it each shape is; two for sorting;
# and where in the first run of the list the pairs of each rank begin
PLACE, STARTS = 1, 4

# box (m, 8): low and high corner of what is k-th along the tree's curve; then those of the shape,
# with the room that its body has
FAT = 4

# middle (m, 8), of what is k-th along the tree's curve: the middle of where its body is at home,
# how far from there it may be or is known, and how far the shape reaches, m
MIDDLE_X, MIDDLE_Y, HALF_WIDTH, HALF_HEIGHT, MIDDLE_REACH = 0, 1, 2, 3, 4

# pair (p, 4): two shapes, and their bodies
OF_A, OF_B = 2, 3

# touch (p, 32): normal from a to b; a point from the centre of body A, m, with its separation, m,
# accumulated impulses, N s, and preload, m; what is told of the last step: the point's impulse over
# all of it, N s, and where it was in the world, m; the cache of the narrow phase, 4 columns; then
# all of the second point; and the normal of what met in flight, with one impulse and one place. A
# pair with one point takes half of its four lines of a cache.
TOUCH = 32
NX, NY = 0, 1
PX, PY, GAP, PUSH, RUB, PRELOAD = 2, 3, 4, 5, 6, 7
TOTAL, WHERE = 8, 9
CACHE = 11
POINT = 16  # columns from a point to the next
FLOWN_NORMAL = 30

# trace (p, 6)
COUNT, FEATURE, TOUCHED, HINT = 0, 1, 3, 4
IS, WAS = 1, 2  # bits of `TOUCHED`: in this step, and in the last one
