"""Bodies of all convex shapes followed from impact to impact by compiled code, in n log n.

Serves: runs, and ensembles of worlds. Hides: the queue of events, the cells, and what an instant is
that is decided here; what is not is left to `tamias2d.contact`.
"""

from tamias2d.event_driven.follower import LIBRARY, EventDriven

__all__ = ["LIBRARY", "EventDriven"]
