"""Recordings of a run: to look at (`.rrd`), exact (`.npz`), replayed, checked and plotted.

Serves: `Run.save`, the commands. Hides: the kinds of file.
"""

from tamias2d.record.files import load, save
from tamias2d.record.replay import Check, check, replay

__all__ = ["Check", "check", "load", "replay", "save"]
