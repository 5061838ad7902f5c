"""The frame loop: bodies in arrays that can be read and changed between steps.

Serves: games. Hides: which file holds which concept.
"""

from tamias2d.simulator.asking import Hits
from tamias2d.simulator.contacts import Contacts
from tamias2d.simulator.frames import Frames, Overlap
from tamias2d.simulator.simulator import Simulator

__all__ = ["Contacts", "Frames", "Hits", "Overlap", "Simulator"]
