"""The recording to look at (`.rrd`): what the viewer shows, and inside it the exact history.

Serves: recordings that one looks at. Hides: rerun.

Only this package knows rerun, which is an extra, large and slow to import. What the viewer draws is
float32, so the float64 states go beside it, as the component group `tamias2d.State`.
"""

from tamias2d.record.rerun.frames import FrameStream
from tamias2d.record.rerun.messages import cut, whole
from tamias2d.record.rerun.program import view
from tamias2d.record.rerun.reading import read
from tamias2d.record.rerun.writing import write

__all__ = ["FrameStream", "cut", "read", "view", "whole", "write"]
