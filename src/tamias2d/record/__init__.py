"""Recordings of a run: to look at (`.rrd`), exact (`.npz`), and plotted.

Serves: `Run`, replay. Hides: the kinds of file, and the libraries that each needs.
"""

from tamias2d.record.dataset import to_dataframe, to_xarray
from tamias2d.record.files import load, save

__all__ = ["load", "save", "to_dataframe", "to_xarray"]
