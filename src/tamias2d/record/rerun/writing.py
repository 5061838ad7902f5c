"""Writing a run as `.rrd`: words first, then what is drawn, then the exact history."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import rerun as rr

from tamias2d.errors import RecordingError
from tamias2d.record import document, drawing, header as headers, history
from tamias2d.record.energies import energies
from tamias2d.record.rerun import (
    bodies,
    exact,
    impacts,
    joint_events,
    joints,
    layout,
    plots,
    timelines,
)
from tamias2d.recording_file import aside, refuse_place
from tamias2d.scene import scene_text

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from numpy.typing import NDArray

    from tamias2d.run_data import RunData

NAMED = 12
"""So many bodies have lines of their own in the plot of speeds; of more, two lines tell."""


def write(run: RunData, path: Path) -> None:
    """Write a run as `.rrd`; raise `RecordingError` if that cannot be done.

    While it is written it takes about ten times the memory of its positions and velocities.
    """
    refuse_place(path)  # before rerun holds data: dropping them it prints a warning
    clock = timelines.nanoseconds(run.times, path, "Save it as .npz.")
    timeline = layout.TIME if np.all(np.diff(clock) > 0) else layout.STEP
    rr.set_strict_mode(True)  # else a bad shape is only a warning, and the data are gone
    view = drawing.view_of(run)
    header = headers.header_of(run)
    # The viewer keeps one layout for an application, and takes recordings of one id for one.
    name = run.scene.name or "tamias2d"
    stream = rr.RecordingStream(f"{name} {header.digest[:8]}", recording_id=header.digest[:32])
    if rr.get_application_id(stream) is None:
        raise RecordingError(f"{path}: rerun records nothing: the environment says RERUN=off.")
    encoded = rr.binary_stream(stream)
    stream.send_blueprint(layout.blueprint(run, view, timeline=timeline), make_active=False)
    stream.send_recording_name(name)
    _texts(stream, run, header)
    stream.flush()  # the header is first in the file: of a cut one it is left

    def times(part: slice) -> list[rr.TimeColumn]:
        return timelines.columns(clock[part], np.arange(len(clock))[part])

    stream.log(layout.WORLD, rr.Transform3D(scale=[1, -1, 1]), static=True)  # y is down there
    bodies.draw(stream, run, view, times)
    joints.draw(stream, run, view, times)
    plots.scale_bar(stream, view)
    _plots(stream, run, times(slice(None)))
    _history(stream, run, times)
    if len(run.impacts):
        instants = np.rint(run.impacts.time * 1e9).astype(np.int64)
        samples = np.searchsorted(run.times, run.impacts.time)
        impacts.draw(stream, run, view, timelines.columns(instants, samples))
    if len(run.joint_events):
        instants = np.rint(run.joint_events.time * 1e9).astype(np.int64)
        samples = np.searchsorted(run.times, run.joint_events.time)
        joint_events.draw(stream, run, timelines.columns(instants, samples))
    # Written by us: rerun's own writer can wait for ever for a disk that is full.
    with aside(path) as draft:
        draft.write_bytes(encoded.read() or b"")


def _texts(stream: rr.RecordingStream, run: RunData, header: headers.Header) -> None:
    line = rr.DynamicArchetype(layout.HEADER, components={"header": header.dumps()})
    stream.log(layout.RECORDING, line, static=True)
    scene = f"```yaml\n{scene_text(run.scene)}```"
    texts = {
        layout.ABOUT: document.about(run),
        layout.MODELS: document.models(),
        layout.SCENE: scene,
    }
    for path, text in texts.items():
        stream.log(path, rr.TextDocument(text, media_type=rr.MediaType.MARKDOWN), static=True)


def _plots(stream: rr.RecordingStream, run: RunData, times: list[rr.TimeColumn]) -> None:
    energy = energies(run)
    shown = {
        layout.ENERGY: (list(energy), np.column_stack([*energy.values()])),
        layout.MOMENTUM: (["x", "y"], run.momentum),
        layout.SPIN: (["angular momentum"], run.angular_momentum),
    }
    for path, (names, values) in shown.items():
        plots.plot(stream, path, names, drawing.PALETTE[: len(names)], times, values)
    moving = [k for k, body in enumerate(run.scene.bodies) if body.dynamic]
    speeds = np.hypot(*np.moveaxis(run.velocity[:, moving], -1, 0))
    if 0 < len(moving) <= NAMED:
        colours = drawing.colours(run)
        for k, speed in zip(moving, speeds.T, strict=True):
            name = run.scene.bodies[k].name
            plots.plot(stream, layout.speed_path(name), [name], [colours[k]], times, speed)
    elif moving:
        extremes = np.column_stack([speeds.max(axis=1), speeds.mean(axis=1)])
        plots.plot(stream, layout.SPEED, ["fastest", "mean"], drawing.PALETTE[:2], times, extremes)


def _history(stream: rr.RecordingStream, run: RunData, times: bodies.Times) -> None:
    """What a recomputation is compared with: float64."""
    totals = {name: exact.column(getattr(run, name)) for name in ("times", *history.TOTALS)}
    columns = rr.DynamicArchetype.columns(layout.SAMPLE, components=totals)
    stream.send_columns(layout.RECORDING, times(slice(None)), columns)
    static = np.array([body.static for body in run.scene.bodies])
    still = {name: getattr(run, name)[:1, static] for name in history.OF_BODIES}
    moving = {name: getattr(run, name)[:, ~static] for name in history.OF_BODIES}
    _send(stream, layout.STILL, still | {"bodies": np.flatnonzero(static)[None]})
    for part in exact.blocks(len(run.times), 3 * moving["position"][:1].nbytes):
        _send(stream, layout.STATE, {k: v[part] for k, v in moving.items()}, times(part))
    if run.contact_force is None:
        return
    exerted = {name: getattr(run, name) for name in history.OF_CONTACTS}
    for part in exact.blocks(len(run.times), 2 * run.contact_force[:1].nbytes):
        _send(stream, layout.CONTACTS, {k: v[part] for k, v in exerted.items()}, times(part))


def _send(
    stream: rr.RecordingStream,
    group: str,
    values: dict[str, NDArray[Any]],
    times: Sequence[rr.TimeColumn] = (),
) -> None:
    """Send values (rows, bodies) or (rows, bodies, 2)."""
    rows, count = next(iter(values.values())).shape[:2]
    flat = {name: v.reshape(rows * count, *v.shape[2:]) for name, v in values.items()}
    components = {name: exact.column(v) for name, v in flat.items()}
    if count:
        columns = rr.DynamicArchetype.columns(group, components=components).partition(
            [count] * rows
        )
        stream.send_columns(layout.RECORDING, times, columns)
