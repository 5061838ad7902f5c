"""A moving picture of a run: its bodies and joints, at the pace at which they moved."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from tamias2d.record import drawing, joint_drawing
from tamias2d.recording_file import aside

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from numpy.typing import NDArray

    from tamias2d.record.drawing import Points, View
    from tamias2d.run_data import RunData

_FRAME = 0.04  # s; a GIF counts in hundredths of a second
_WIDTH, _DPI = 6.4, 100  # inches
_SHADE = 0.3


def animate(run: RunData, figure: Any, path: Path) -> None:
    """Write a run as a GIF, drawn on an empty figure: 25 pictures for each second, for ever again.

    Raises:
        RecordingError: the file cannot be written.
    """
    draw = _stage(figure, run)
    first, *others = (_picture(figure, draw, k) for k in _shown(run.times))
    with aside(path) as draft:
        first.save(
            draft,
            format="GIF",
            save_all=True,
            append_images=others,
            duration=round(1000 * _FRAME),
            loop=0,
        )


def _shown(times: NDArray[np.float64]) -> NDArray[np.int64]:
    """Return the samples that are nearest to the times of the pictures."""
    wanted = np.arange(times[0], times[-1] + _FRAME / 2, _FRAME)
    middles = (times[1:] + times[:-1]) / 2
    return np.searchsorted(middles, wanted)


def _picture(figure: Any, draw: Callable[[int], None], k: int) -> Any:
    """Return sample k as an image of 256 colours."""
    from PIL import Image

    draw(k)
    figure.canvas.draw()
    return Image.fromarray(np.asarray(figure.canvas.buffer_rgba())[..., :3]).quantize()


def _stage(figure: Any, run: RunData) -> Callable[[int], None]:
    """Set up a figure for a run; return what draws one of its samples."""
    from matplotlib.collections import LineCollection, PolyCollection

    view = drawing.view_of(run)
    (x, y), (width, height) = view.center, view.half
    figure.set_size_inches(_WIDTH, _WIDTH * np.clip(height / width, 0.4, 1.2))
    figure.set_dpi(_DPI)
    axes = figure.add_subplot()
    axes.set(xlim=(x - width, x + width), ylim=(y - height, y + height), aspect="equal")
    axes.set(xlabel="x, m", ylabel="y, m")
    areas = axes.add_collection(PolyCollection([], linewidths=0))
    lines = axes.add_collection(LineCollection([], linewidths=1.0))
    title = axes.set_title(" ", fontsize="medium")
    figure.canvas.draw()
    figure.set_layout_engine("none")  # the axes stay where they are
    rims, shades = _rims(run)
    strokes, colours = _strokes(run, view)
    joints = list(joint_drawing.lines(run, view))
    areas.set_facecolor(shades)
    lines.set_color([*colours, *(joint_drawing.on_white(joint.kind) for joint in joints)])

    def draw(k: int) -> None:
        areas.set_verts([_placed(run, k, rim) for rim in rims])
        moved = [_placed(run, k, stroke) for stroke in strokes]
        lines.set_segments([*moved, *(joint.points[k] for joint in joints)])
        title.set_text(drawing.titled(run, f"{run.times[k]:.2f} s"))

    return draw


_Part: TypeAlias = "tuple[int, Points]"  # of a body, by its index, in its own frame


def _rims(run: RunData) -> tuple[list[_Part], list[Any]]:
    """Return the outlines of what is filled, and their colours."""
    colours = drawing.colours(run)
    rims = [
        (index, outline)
        for index, body in enumerate(run.scene.bodies)
        if not drawing.is_hollow(body)
        for outline in drawing.outlines(body)
    ]
    return rims, [(*_unit(colours[index]), _SHADE) for index, _ in rims]


def _strokes(run: RunData, view: View) -> tuple[list[_Part], list[Any]]:
    """Return the lines of all bodies, and their colours."""
    colours = drawing.colours(run)
    strokes = [
        (index, stroke)
        for index, body in enumerate(run.scene.bodies)
        for stroke in drawing.strokes(body, view)
    ]
    return strokes, [_unit(colours[index]) for index, _ in strokes]


def _placed(run: RunData, k: int, part: _Part) -> Points:
    """Return a part of a body where it was at sample k."""
    index, points = part
    return drawing.placed(points, run.position[k, index], float(run.orientation[k, index]))


def _unit(colour: drawing.Colour) -> tuple[float, ...]:
    """Red, green and blue, 0 to 1."""
    return tuple(channel / 255 for channel in colour)
