"""Lines over time beside the world, and the bar in it that shows a length."""

from __future__ import annotations

from typing import TYPE_CHECKING

import rerun as rr

from tamias2d.record import drawing
from tamias2d.record.rerun import layout

if TYPE_CHECKING:
    from collections.abc import Sequence

    import numpy as np
    from numpy.typing import NDArray

    from tamias2d.record.drawing import Colour, View


def plot(
    stream: rr.RecordingStream,
    path: str,
    names: Sequence[str],
    colours: Sequence[Colour],
    times: list[rr.TimeColumn],
    values: NDArray[np.float64],
) -> None:
    """Send the lines of a plot, one for each name."""
    lines(stream, path, names, colours)
    stream.send_columns(path, times, rr.Scalars.columns(scalars=values))


def lines(
    stream: rr.RecordingStream, path: str, names: Sequence[str], colours: Sequence[Colour]
) -> None:
    """Send the names and colours of the lines of a plot."""
    look = rr.SeriesLines(names=list(names), colors=colours, widths=[1.5] * len(names))
    stream.log(path, look, static=True)


def scale_bar(stream: rr.RecordingStream, view: View) -> None:
    """Draw a bar of a round length in the upper left corner of the view, with its length."""
    length = drawing.round_length(view.half[0] / 3)
    x, y = view.center[0] - 0.95 * view.half[0], view.center[1] + 0.9 * view.half[1]
    bar = rr.LineStrips2D(
        [[(x, y), (x + length, y)]],
        colors=[drawing.STATIC_COLOUR],
        radii=rr.Radius.ui_points(1.5),
        labels=[f"{length:g} m"],
        show_labels=True,
        draw_order=30.0,
    )
    stream.log(f"{layout.WORLD}/scale", bar, static=True)
