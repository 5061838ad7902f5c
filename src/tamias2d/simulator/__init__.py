"""The frame loop: bodies in arrays that can be read and changed between steps.

Serves: games. Hides: which file holds which concept.
"""

from tamias2d.simulator.invalid_state import NoValueError
from tamias2d.simulator.queries import Hits
from tamias2d.simulator.restart import Restart
from tamias2d.simulator.simulator import Simulator
from tamias2d.simulator.stepper import Overlap, Sampling, Stepper, states_at, states_of

__all__ = [
    "Hits", "NoValueError", "Overlap", "Restart", "Sampling", "Simulator", "Stepper", "states_at",
    "states_of",
]  # fmt: skip
