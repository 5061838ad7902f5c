"""Writing a run as `.rrd`: static things once, then each body's history in blocks of samples.

Serves: `Run.save`. Hides: which archetypes draw what, and the size of a block.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import pyarrow as pa
import rerun as rr

from tamias2d.errors import RecordingError
from tamias2d.record import document, drawing, header as headers, history
from tamias2d.record.aside import aside, refuse_place
from tamias2d.record.kinetic import kinetic_energy
from tamias2d.record.rerun import layout
from tamias2d.scene import scene_text

if TYPE_CHECKING:
    from pathlib import Path

    from numpy.typing import NDArray

    from tamias2d.record.drawing import Colour, View
    from tamias2d.run import Run
    from tamias2d.scene import Body

BLOCK = 4096
"""Samples of a body that are sent, and later loaded, at once."""
IMPACT_COLOUR: Colour = (235, 200, 60)
LONGEST_ARROW = 0.25
"""Of the largest impulse, as a part of the view's reach."""


def write(run: Run, path: Path) -> None:
    """Write a run as `.rrd`; raise `RecordingError` if that cannot be done.

    While it is written it takes about ten times the memory of its positions and velocities.
    """
    refuse_place(path)  # before rerun holds data: dropping them it prints a warning
    clock = _nanoseconds(run.times, path)
    timeline = layout.TIME if np.all(np.diff(clock) > 0) else layout.STEP
    rr.set_strict_mode(True)  # else a bad shape is only a warning, and the data are gone
    view = drawing.view_of(run)
    stream = rr.RecordingStream("tamias2d", recording_id=run.digest()[:32])
    if rr.get_application_id(stream) is None:
        raise RecordingError(f"{path}: rerun records nothing: the environment says RERUN=off.")
    encoded = rr.binary_stream(stream)
    stream.send_blueprint(layout.blueprint(run, view, timeline=timeline), make_active=False)
    stream.send_recording_name(run.scene.name or "tamias2d")
    _texts(stream, run)
    stream.flush()  # the header is first in the file: of a cut one it is left
    _world(stream, run, view)
    for start in range(0, len(run.times), BLOCK):
        _block(stream, run, clock, slice(start, start + BLOCK))
    _impacts(stream, run, view)
    # Written by us: rerun's own writer can wait for ever for a disk that is full.
    with aside(path) as draft:
        draft.write_bytes(encoded.read() or b"")


def _nanoseconds(times: NDArray[np.float64], path: Path) -> NDArray[np.int64]:
    """Round times in s to the viewer's clock, which counts nanoseconds in 64 bits."""
    if times[-1] > 9e9:
        raise RecordingError(
            f"{path}: a run of {times[-1]:g} s is beyond the viewer's clock, which ends at 9e9 s. "
            "Save it as .npz."
        )
    return np.rint(times * 1e9).astype(np.int64)


def _texts(stream: rr.RecordingStream, run: Run) -> None:
    header = rr.DynamicArchetype(
        layout.HEADER, components={"header": headers.header_of(run).dumps()}
    )
    stream.log(layout.RECORDING, header, static=True)
    scene = f"```yaml\n{scene_text(run.scene)}```"
    texts = {
        layout.ABOUT: document.about(run),
        layout.MODELS: document.models(),
        layout.SCENE: scene,
    }
    for path, text in texts.items():
        stream.log(path, rr.TextDocument(text, media_type=rr.MediaType.MARKDOWN), static=True)


def _world(stream: rr.RecordingStream, run: Run, view: View) -> None:
    """Shapes in their own frames, colours of plots, and the flip: in the viewer's 2D y is down."""
    stream.log(layout.WORLD, rr.Transform3D(scale=[1, -1, 1]), static=True)
    colours = drawing.colours(run)
    for index, (body, colour) in enumerate(zip(run.scene.bodies, colours, strict=True)):
        path = layout.body_path(body.name)
        stream.log(path, _lines(body, view, colour), static=True)
        if body.dynamic:
            name = rr.SeriesLines(colors=[colour], names=[body.name], widths=[1.5])
            stream.log(layout.speed_path(body.name), name, static=True)
        if body.static:
            here = slice(0, 1)
            columns = [*_pose(run, index, here), *_state(run, index, here)]
            stream.send_columns(path, [], columns)
    _scale_bar(stream, view)
    for path, names in layout.SERIES.items():
        series = rr.SeriesLines(
            names=names, colors=drawing.PALETTE[: len(names)], widths=[1.5] * len(names)
        )
        stream.log(path, series, static=True)


def _lines(body: Body, view: View, colour: Colour) -> rr.LineStrips2D:
    """A body in its own frame: its outline, a spoke that shows how it is turned, and its area."""
    lines = drawing.strokes(body, view)
    filled = drawing.fillings(body)
    area = [line for lines_, _ in filled for line in lines_]
    shade = tuple(channel // 2 for channel in colour)
    edge = rr.Radius.ui_points(1.0 if body.static else 1.5)
    radii: list[Any] = [half for lines_, half in filled for _ in lines_] + [edge] * len(lines)
    return rr.LineStrips2D(
        [*area, *lines],
        colors=[shade] * len(area) + [colour] * len(lines),
        radii=radii,
        labels=[body.name],
        show_labels=False,
        draw_order=20.0 if body.dynamic else 10.0,
    )


def _scale_bar(stream: rr.RecordingStream, view: View) -> None:
    """A bar of a round length in the upper left corner of the view, with its length."""
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


def _block(stream: rr.RecordingStream, run: Run, clock: NDArray[np.int64], part: slice) -> None:
    """Send one block of samples: the bodies' poses and states, and the plots."""
    steps = np.arange(len(clock))[part]
    times = _times(clock[part], steps)
    for index, body in enumerate(run.scene.bodies):
        if not body.static:
            columns = [*_pose(run, index, part), *_state(run, index, part)]
            stream.send_columns(layout.body_path(body.name), times, columns)
        if body.dynamic:
            speed = np.hypot(*run.velocity[part, index].T)
            _plot(stream, layout.speed_path(body.name), times, speed)
    kinetic = kinetic_energy(run, part)
    energies = np.column_stack([run.energy[part], kinetic, run.energy[part] - kinetic])
    _plot(stream, layout.ENERGY, times, energies)
    _plot(stream, layout.MOMENTUM, times, run.momentum[part])
    _plot(stream, layout.SPIN, times, run.angular_momentum[part])
    exact = {name: _column(getattr(run, name)[part]) for name in ("times", *history.TOTALS)}
    numbers = rr.DynamicArchetype.columns(layout.SAMPLE, components=exact)
    stream.send_columns(layout.RECORDING, times, numbers)


def _times(clock: NDArray[np.int64], steps: NDArray[np.int64]) -> list[rr.TimeColumn]:
    return [
        rr.TimeColumn(layout.TIME, duration=clock.astype("timedelta64[ns]")),
        rr.TimeColumn(layout.STEP, sequence=steps),
    ]


def _plot(
    stream: rr.RecordingStream, path: str, times: list[rr.TimeColumn], values: NDArray[np.float64]
) -> None:
    stream.send_columns(path, times, rr.Scalars.columns(scalars=values))


def _pose(run: Run, index: int, part: slice) -> Any:
    """What the viewer draws: float32."""
    position, half = run.position[part, index], run.orientation[part, index] / 2
    none = np.zeros(len(half))
    return rr.Transform3D.columns(
        translation=np.column_stack([position, none]),
        quaternion=np.column_stack([none, none, np.sin(half), np.cos(half)]),
    )


def _state(run: Run, index: int, part: slice) -> Any:
    """What a recomputation is compared with: float64."""
    values = {name: _column(getattr(run, name)[part, index]) for name in history.OF_BODIES}
    return rr.DynamicArchetype.columns(layout.STATE, components=values)


def _column(values: NDArray[Any]) -> Any:
    """A row for each value; rerun takes vectors only as lists of fixed length."""
    if values.ndim == 1:
        return values
    return pa.FixedSizeListArray.from_arrays(pa.array(values.ravel()), values.shape[1])


def _impacts(stream: rr.RecordingStream, run: Run, view: View) -> None:
    """An arrow for each impact, from where the bodies meet along the impulse.

    It is the impulse on body B or, where that is static, its opposite on body A.
    """
    impacts = run.impacts
    if not len(impacts.time):
        return
    clock = np.rint(impacts.time * 1e9).astype(np.int64)
    times = _times(clock, np.searchsorted(run.times, impacts.time))
    longest = float(impacts.impulse.max()) or 1.0
    moved = np.array([body.dynamic for body in run.scene.bodies])[impacts.bodies[:, 1]]
    length = np.where(moved, 1, -1) * LONGEST_ARROW * view.reach * impacts.impulse / longest
    texts = [document.impact_line(run, k) for k in range(len(impacts.time))]
    stream.send_columns(layout.IMPACT_LOG, times, rr.TextLog.columns(text=texts))
    look = rr.Arrows2D.from_fields(
        radii=rr.Radius.ui_points(2.0), colors=[IMPACT_COLOUR], draw_order=40.0, show_labels=False
    )
    stream.log(layout.IMPACTS, look, static=True)
    exact = {name: _column(getattr(impacts, name)) for name in history.OF_IMPACTS}
    arrows = rr.Arrows2D.columns(origins=impacts.point, vectors=impacts.normal * length[:, None])
    numbers = rr.DynamicArchetype.columns(layout.IMPACT, components=exact)
    stream.send_columns(layout.IMPACTS, times, [*arrows, *numbers])
