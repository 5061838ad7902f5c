"""What the columns of the engine's arrays hold.

Serves: all modules of the stepped way. Hides: nothing; these are the names of places.

Bodies, shapes and pairs are rows of wide arrays, because a kernel is called with each array at a
price. Body arrays have one row more than there are bodies, the idle one, all zeros: lanes of a
block that have no contact work on it.
"""

# pose (n+1, 3): m, m, rad
X, Y, TURN = 0, 1, 2

# motion (n+1, 8): velocity m/s, spin rad/s, and what has been moved since the step began
VX, VY, SPIN = 0, 1, 2
DX, DY, DTURN = 4, 5, 6

# kind (n+1,)
ABSENT, STATIC, KINEMATIC, DYNAMIC = 0, 1, 2, 3

# shape_kind (m,)
DISC, CAPSULE, POLYGON, HALF_PLANE = 0, 1, 2, 3

# touch (p, 16): normal from a to b; two points from the centre of body A, m, with their
# separations, m, and accumulated impulses, N s; then the cache of the narrow phase
NX, NY = 0, 1
PX, PY, GAP = 2, 3, 4
POINT = 3  # columns from a point to the next
PUSH, RUB = 8, 9
IMPULSE = 2  # columns from a point's impulses to the next one's
CACHE = 12

# trace (p, 6)
COUNT, FEATURE, TOUCHED, HINT = 0, 1, 3, 4
