"""Recordings of a run: to look at (`.rrd`), exact (`.npz`), and plotted.

Serves: `Run.save`, `run.load`, replay. Hides: the kinds of file.
"""

from tamias2d.record.files import load, save

__all__ = ["load", "save"]
