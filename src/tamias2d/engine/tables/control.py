"""What a step is asked to do, and how far it is."""

from typing import Annotated, NamedTuple

from tamias2d.engine.tables.declarations import Columns, Saved, Sized
from tamias2d.kernels.arrays import Floats, Ranks

_settings = Columns()
GRAVITY_X = _settings()  # m/s^2
GRAVITY_Y = _settings()  # m/s^2
TIME_STEP = _settings()  # s, of a whole step
SUBSTEP = _settings()  # s, of the last part that was solved

_control = Columns()
SUBSTEPS = _control()  # of a step
STEPS_LEFT = _control()  # steps of this call that are still to be taken
STAGE = _control()  # at which the step continues, one of those below
ROWS_NEEDED = _control()  # by the array that was too short
STEPS_TAKEN = _control()  # since the start
TICK = _control()  # at which a part of the step begins; a step has 2**MOST_LEVEL of them
LEVEL = _control()  # a part is this power of a half of the step
GOES_FAR = _control()  # 1 if a body goes farther in this part than a fraction of its width
START_NOTED = _control()  # 1 if the part can be taken again, as shorter ones
DISAGREE = _control()  # 1 if joints and contacts made much energy in this part
RETAKEN = _control()  # 1 if the part was begun before, and was too long
LEAST_LEVEL = _control()  # of the parts of this step: longer ones had too many impacts
FINEST = _control()  # level of the shortest part of the last step
PART_SUBSTEPS = _control()  # of a part
SUNK_A = _control()  # slot, plus 1, of a body that another sinks into; 0 for none so far
SUNK_B = _control()  # of the other one
PRESSED_A = _control()  # slot, plus 1, of a body that loads press too hard on another; 0 for none
PRESSED_B = _control()  # of the other one
OUTWEIGHED = _control()  # slot, plus 1, of a body of an island of masses too different to be solved
LIMITS = (
    _control()
)  # how often something was found to tell: of these pairs and this body, or of joints
IMPACTS = _control()  # 1 if a mechanism is struck in this part
LOADS_VARY = _control()  # 1 if loads vary, and are put right as the step ends
ALL_ASLEEP = _control()  # 1 if no body was awake in the last step, and nobody came or went since
EVENTS_TOLD = _control()  # 1 if what begins and ceases to touch in each step is logged
AT_START, PAIRS_STALE, PAIRS_KNOWN, MANIFOLDS_KNOWN, OUT_OF_BOUNDS, IN_FLIGHT, ARRIVING = range(7)

MOST_LEVEL = 10  # a step has up to 1024 parts

_progress = Columns()
FLOWN = _progress()  # fraction of the step that continuous collision has done
UPDATES_LEFT = _progress()  # updates of the contact list that continuous collision may still make
DEPTH_SHARE = _progress()  # of the allowed depth, up to which impacts are not looked for
PART_TIME = _progress()  # s, of a part of the step
IMPULSE_RATIO = _progress()  # of the length of a substep to that of the part before

# status of a step: done, an array that is too short, a value that is not valid, done with no
# contact on the list, done though a body has numbers that are not finite, or a part to be taken
# again
(
    DONE,
    MORE_CANDIDATES,
    MORE_CONTACTS,
    MORE_BLOCKS,
    INVALID,
    MORE_SPARSE,
    CLEAR,
    OVERFLOWED,
    AGAIN,
) = range(9)


class Control(NamedTuple):
    """What a step is asked to do, and how far it is; read by all stages."""

    settings: Annotated[Floats, Sized(_settings.width), Saved(numbers="any")]
    counts: Annotated[Ranks, Sized(_control.width)]
    progress: Annotated[Floats, Sized(_progress.width)]
    wanted: Annotated[Ranks, Sized(MOST_LEVEL + 1)]  # pairs that want a part of each level
