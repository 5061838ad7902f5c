"""The contact log: what began or ceased to touch in the steps of a call, until it is told."""

from typing import Annotated, NamedTuple

from tamias2d.engine.tables.contacts import MANIFOLD
from tamias2d.engine.tables.declarations import Columns, Rewritten, Sized
from tamias2d.kernels.arrays import FloatRows, RankRows, Ranks

_log_counts = Columns()
LOGGED = _log_counts()  # rows
LOG_FULL = _log_counts()  # 1 if the events of the last step found no room, until they are taken
STEPS_LOGGED = _log_counts()  # that had events, in this call

_log = Columns()
LOG_STEP = _log()  # which of the steps that had events
LOG_PLACE = _log()  # of the contact on its list
LOG_A = _log()  # row of body A
LOG_B = _log()
LOG_TOUCHES = _log()  # as of a contact, and the next two
LOG_POINTS = _log()
LOG_SENSES = _log()
LOG_SPLIT = _log()  # 1 if its impulses are of a step in parts

LOG_PLACE_A = MANIFOLD  # m, of a manifold that is logged: where body A is, two columns
MOST_LOGGED = 32  # rows: more of them cost memory, fewer cost time


class ContactLog(NamedTuple):
    """All contacts of pairs of bodies of which one began or ceased to touch in a step."""

    counts: Annotated[Ranks, Sized(_log_counts.width)]
    rows: Annotated[RankRows, Sized(MOST_LOGGED, _log.width), Rewritten()]
    manifolds: Annotated[FloatRows, Sized(MOST_LOGGED, MANIFOLD + 2), Rewritten()]
