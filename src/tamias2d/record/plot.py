"""A picture of a run: the paths of its bodies, their heights, and the energy over time."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from tamias2d.errors import InputError, RecordingError, path_text
from tamias2d.record import drawing, joint_drawing
from tamias2d.record.animation import animate
from tamias2d.record.energies import energies
from tamias2d.recording_file import aside, checked_path, refuse_place
from tamias2d.scene import HalfPlane

if TYPE_CHECKING:
    from tamias2d.record.drawing import View
    from tamias2d.run_data import RunData

STILL = (".png", ".svg", ".pdf")
"""Kinds of picture, by their suffixes."""
MOVING = ".gif"
OF_RUNS = (*STILL, MOVING)
INSTANTS = 6
"""How many times each body is drawn, the last one strongest."""
NAMED = 10
"""So many bodies have their names in the legend; more would hide the picture."""


def plot(run: RunData, path: str | Path) -> None:
    """Draw a run: paths and bodies at a few instants, heights over time, and energy over time.

    The kind of picture follows from the suffix: `.png`, `.svg`, `.pdf`; one in `.gif` moves, and
    shows the bodies alone.

    Raises:
        InputError: no kind of picture has this suffix.
        RecordingError: matplotlib is not installed, or the file cannot be written.
    """
    path = checked_path(path)
    figure = figure_for(path, OF_RUNS)
    if path.suffix == MOVING:
        animate(run, figure, path)
        return
    grid = figure.add_gridspec(2, 2, width_ratios=[3, 2])
    draw_world(figure.add_subplot(grid[:, 0]), run)
    _heights(figure.add_subplot(grid[0, 1]), run)
    _energy(figure.add_subplot(grid[1, 1]), run)
    save_figure(figure, path)


def save_figure(figure: Any, path: Path) -> None:
    """Write a figure that was made for a path; raises `RecordingError` if that cannot be done."""
    with aside(path) as draft:
        figure.savefig(draft, format=path.suffix[1:], dpi=120)


def refuse_picture(path: Path, kinds: tuple[str, ...] = STILL) -> None:
    """Raise as `plot` would, where that can be known before there is a run."""
    figure_for(path, kinds)
    refuse_place(path)


def figure_for(path: Path, kinds: tuple[str, ...] = STILL) -> Any:
    """Return an empty figure for a picture of one of these kinds; raises as `plot` does."""
    figure = _figure(path)
    if path.suffix not in kinds:
        raise InputError(
            f"{path_text(path)}: suffix {path.suffix!r}: a picture is one of "
            f"{', '.join(kinds)}. Give it such a name, .png for one."
        )
    return figure


def _figure(path: Path) -> Any:
    """A figure without a window: it belongs to no backend but Agg's canvas."""
    try:
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure
        from matplotlib.layout_engine import ConstrainedLayoutEngine
    except ImportError as fault:
        raise RecordingError(
            f"{path}: a plot needs matplotlib, which is not installed ({fault}). "
            'Install it by `pip install "tamias2d[plot]"`.'
        ) from fault
    figure = Figure(figsize=(10, 5.6), layout=ConstrainedLayoutEngine(w_pad=0.1, h_pad=0.1))
    FigureCanvasAgg(figure)
    return figure


def draw_world(axes: Any, run: RunData) -> None:
    """Draw paths, the bodies at a few instants, and where they met."""
    view = drawing.view_of(run)
    (x, y), (width, height) = view.center, view.half
    instants = np.unique(np.linspace(0, len(run.times) - 1, INSTANTS).round().astype(int))
    for index, colour in enumerate(_colours(run)):
        body = run.scene.bodies[index]
        if isinstance(body.shape, HalfPlane):
            _ground(axes, run, index, view)
            continue
        if not body.static:
            axes.plot(*run.position[:, index].T, color=colour, linewidth=0.8, alpha=0.6)
        for k in instants[:1] if body.static else instants:
            strength = 1.0 if k == instants[-1] or body.static else 0.35
            _body(axes, run, int(k), index, view, colour, strength)
    for line in joint_drawing.lines(run, view):
        colour = joint_drawing.on_white(line.kind)
        axes.plot(*line.points[instants[-1]].T, color=colour, linewidth=0.9)
    axes.plot(*run.impacts.point.T, "x", color="black", markersize=4, markeredgewidth=0.8)
    axes.set(xlim=(x - width, x + width), ylim=(y - height, y + height), aspect="equal")
    shown = ", ".join(f"{run.times[k]:.3g}" for k in instants)
    met = "; × where they met" if len(run.impacts) else ""
    title = drawing.titled(run, f"bodies at {shown} s{met}")
    axes.set(xlabel="x, m", ylabel="y, m", title=title)
    axes.title.set_fontsize("medium")


def _body(
    axes: Any, run: RunData, k: int, index: int, view: View, colour: Any, strength: float
) -> None:
    """Draw a body at sample k; earlier ones are paler."""
    body = run.scene.bodies[index]
    position, orientation = run.position[k, index], float(run.orientation[k, index])
    for outline in drawing.outlines(body):
        rim = drawing.placed(outline, position, orientation)
        shade = 0.0 if drawing.is_hollow(body) else 0.3 * strength
        axes.fill(*rim.T, color=colour, alpha=shade, linewidth=0)
    for stroke in drawing.strokes(body, view):
        line = drawing.placed(stroke, position, orientation)
        axes.plot(*line.T, color=colour, alpha=strength, linewidth=1.0)


def _ground(axes: Any, run: RunData, index: int, view: View) -> None:
    body = run.scene.bodies[index]
    for stroke in drawing.strokes(body, view):
        axes.plot(*stroke.T, color=_colours(run)[index], linewidth=0.8)


def _heights(axes: Any, run: RunData) -> None:
    for index, colour in enumerate(_colours(run)):
        body = run.scene.bodies[index]
        if body.dynamic:
            axes.plot(
                run.times, run.position[:, index, 1], color=colour, linewidth=1.2, label=body.name
            )
    axes.set(xlabel="time, s", ylabel="height y of the centre, m")
    axes.margins(x=0)
    if sum(body.dynamic for body in run.scene.bodies) <= NAMED:
        axes.legend(frameon=False, fontsize="small")


def _energy(axes: Any, run: RunData) -> None:
    for (name, values), colour in zip(energies(run).items(), drawing.PALETTE, strict=False):
        axes.plot(run.times, values, label=name, color=_unit(colour), linewidth=1.2)
    axes.set(xlabel="time, s", ylabel="energy, J")
    axes.margins(x=0)
    axes.legend(frameon=False, fontsize="small")


def _colours(run: RunData) -> list[tuple[float, ...]]:
    return [_unit(colour) for colour in drawing.colours(run)]


def _unit(colour: drawing.Colour) -> tuple[float, ...]:
    """Red, green and blue, 0 to 1."""
    return tuple(channel / 255 for channel in colour)
