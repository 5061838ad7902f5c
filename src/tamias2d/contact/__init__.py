"""Located contacts: impacts to rounding, and the contacts that last after them.

Serves: `solve`, which makes a run of the paths and impulses. Hides: how an impact is found
(conservative advancement along separating axes), and in which order one instant is resolved.
"""

from tamias2d.contact.instant import ContactImpulse
from tamias2d.contact.located import Located
from tamias2d.contact.overlap import refuse_contact
from tamias2d.contact.refusal import (
    FrictionError,
    LastingContactError,
    OverlapError,
    RangeError,
    Refusal,
    SimultaneousImpactsError,
    UndecidedContactError,
    UnlocatedContactError,
)
from tamias2d.contact.stepping_choice import MEANT_TO_TOUCH, steps_because

__all__ = [
    "MEANT_TO_TOUCH",
    "ContactImpulse",
    "FrictionError",
    "LastingContactError",
    "Located",
    "OverlapError",
    "RangeError",
    "Refusal",
    "SimultaneousImpactsError",
    "UndecidedContactError",
    "UnlocatedContactError",
    "refuse_contact",
    "steps_because",
]
