"""The broad phase: bounds of bodies, and pairs that may touch."""

from typing import Annotated, NamedTuple

from tamias2d.engine.tables.control import MOST_LEVEL
from tamias2d.engine.tables.declarations import Columns, Saved, Sized
from tamias2d.kernels.arrays import Bytes, FloatRows, Floats, PlaceRows, Places, Ranks

_broad_phase = Columns()
CONTACTS = _broad_phase()  # on the list
BUFFER = _broad_phase()  # which of the two buffers holds the list
HORIZON = _broad_phase()  # steps for which the list is made
STEPS_SINCE = _broad_phase()  # steps since it was made
LIST_HOLDS = _broad_phase()  # 1 if it holds all pairs that may touch
FIRST_RUN = _broad_phase()  # contacts of the first sorted run
NEXT_LEVEL = _broad_phase()  # that the part which begins has at least
UPDATED = _broad_phase()  # bodies whose bounds were updated since the list was made

_frame = Columns()
FRAME_VX = _frame()  # m/s, mean velocity of the bodies
FRAME_VY = _frame()  # m/s
FRAME_X = _frame()  # m
FRAME_Y = _frame()  # m
FRAME_MOVES = _frame()  # 1 if the frame moves
FRAME_AX = _frame()  # m/s^2, mean acceleration
FRAME_AY = _frame()  # m/s^2
FRAME_PROPAGATOR = _frame(3)  # mean propagator through a step

_fat_bounds = Columns()
LOW_X = _fat_bounds()  # m, in the comoving frame: where the centre of the body may be
LOW_Y = _fat_bounds()
HIGH_X = _fat_bounds()
HIGH_Y = _fat_bounds()
BASE_ANGLE = _fat_bounds()  # rad, at which the shapes were fattened
ANGLE_MARGIN = _fat_bounds()  # rad, by which the body may turn from there

SHAPE_OF_RANK, RANK = range(2)  # rows of canonical


class BroadPhase(NamedTuple):
    """Which shapes may touch; read by the broad phase, its bounds by continuous collision."""

    counts: Annotated[
        Ranks,
        Sized(_broad_phase.width),
        Saved({**dict.fromkeys(range(_broad_phase.width), 2**62), NEXT_LEVEL: MOST_LEVEL + 1}),
    ]
    frame: Annotated[Floats, Sized(_frame.width), Saved()]
    fat_bounds: Annotated[FloatRows, Sized("slots", _fat_bounds.width), Saved(numbers="infinite")]
    left: Annotated[Bytes, Sized("slots")]  # 1 if the body has left its bounds
    canonical: Annotated[PlaceRows, Sized(2, "shapes")]  # shapes in canonical order; their ranks
    leaf_pairs: Annotated[PlaceRows, Sized("candidates", 2)]  # leaves whose boxes overlap
    # pairs of ranks, the lower one first; saved for its length, which decides when all are sought
    candidates: Annotated[PlaceRows, Sized("candidates", 2), Saved(2**32)]
    sorting: Annotated[PlaceRows, Sized("candidates", 2)]  # candidates between passes of the sort
    rank_counts: Annotated[Places, Sized("ranks")]  # bins of that sort
    first_of_rank: Annotated[Places, Sized("ranks")]  # contact of the first run
