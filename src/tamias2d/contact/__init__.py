"""Located contacts: impacts to rounding, and the contacts that last after them.

Serves: `solve`, which makes a run of the paths and impulses. Hides: how an impact is found
(conservative advancement along separating axes), and in which order one instant is resolved.
"""

from tamias2d.contact.event_driven_scenes import (
    has_thin_pair,
    is_event_driven,
    is_known,
    thin_bodies,
)
from tamias2d.contact.located import Located
from tamias2d.contact.overlap import refuse_contact
from tamias2d.contact.refusal import (
    FrictionError,
    JointedContactError,
    LastingContactError,
    OverlapError,
    RangeError,
    Refusal,
    UndecidedContactError,
    UnlocatedContactError,
)
from tamias2d.contact.ruled_instants import MOST_RULED
from tamias2d.contact.saltation import Passing, SingleImpact, after_impact
from tamias2d.contact.stepping_choice import MANY, MEANT_TO_TOUCH, steps_because

__all__ = [
    "MANY",
    "MEANT_TO_TOUCH",
    "MOST_RULED",
    "FrictionError",
    "JointedContactError",
    "LastingContactError",
    "Located",
    "OverlapError",
    "Passing",
    "RangeError",
    "Refusal",
    "SingleImpact",
    "UndecidedContactError",
    "UnlocatedContactError",
    "after_impact",
    "has_thin_pair",
    "is_event_driven",
    "is_known",
    "refuse_contact",
    "steps_because",
    "thin_bodies",
]
