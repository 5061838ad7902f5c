"""A recording of a frame loop (`.rrd`) that grows while the loop runs.

Between two frames bodies may come and go. Frames with the same bodies are sent together; what is
shown by an entity that they no longer have is cleared.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import rerun as rr

from tamias2d.errors import RecordingError
from tamias2d.record import drawing
from tamias2d.record.document import joint_line
from tamias2d.record.rerun import bodies, joints, layout, messages, plots, timelines

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from tamias2d.motion.joint_events import JointEvent
    from tamias2d.record.drawing import Colour, View
    from tamias2d.record.drawn import Frames
    from tamias2d.record.frame_block import Totals

_CONTACTS = f"{layout.WORLD}/contacts"
_CONTACT_COLOUR: Colour = (235, 200, 60)
_REMEDY = "Begin with a new simulator."
_PATIENCE = 60.0  # s, that the disk may take
_DOT, _ABOVE = 2.5, 40.0  # points of the screen; bodies and joints are drawn below


class FrameStream:
    """What the viewer shows of a loop, on its way to a file."""

    def __init__(self, draft: Path, path: Path, about: str) -> None:
        """Begin a recording in a draft that will be the file at a path, after which it is named."""
        rr.set_strict_mode(True)  # else a bad shape is only a warning, and the data are gone
        self._path, self._name = path, path.stem
        self._stream = rr.RecordingStream(self._name)
        if rr.get_application_id(self._stream) is None:
            raise RecordingError(f"{path}: rerun records nothing: the environment says RERUN=off.")
        self._encoded = rr.binary_stream(self._stream)
        # Written by us: rerun's own writer can wait for ever for a disk that is full.
        self._file = draft.open("wb", buffering=0)
        self._stream.send_recording_name(self._name)
        mark = rr.DynamicArchetype(layout.FRAME_LOOP, components={"path": path.name})
        self._stream.log(layout.RECORDING, mark, static=True)
        text = rr.TextDocument(about, media_type=rr.MediaType.MARKDOWN)
        self._stream.log(layout.ABOUT, text, static=True)
        self._stream.log(layout.WORLD, rr.Transform3D(scale=[1, -1, 1]), static=True)
        for plot, names in layout.FRAME_SERIES.items():
            plots.lines(self._stream, plot, names, drawing.PALETTE[: len(names)])
        dots = rr.Points2D.from_fields(
            radii=rr.Radius.ui_points(_DOT), colors=[_CONTACT_COLOUR], draw_order=_ABOVE
        )
        self._stream.log(_CONTACTS, dots, static=True)
        self._shown: dict[str, bytes] = {}
        """The look of each entity that shows something, as it was sent last."""

    def view(self, view: View) -> None:
        """Let the viewer open with a view."""
        blueprint = layout.frame_blueprint(view, self._name)
        self._stream.send_blueprint(blueprint, make_active=False)
        plots.scale_bar(self._stream, view)

    def send(
        self, frames: Frames, totals: Totals, first: int, view: View, colours: Sequence[Colour]
    ) -> None:
        """Send frames, of which the first one has this number, with the colours of bodies."""
        clock = timelines.nanoseconds(frames.times, self._path, _REMEDY)
        steps = first + np.arange(len(clock))

        def times(part: slice) -> list[rr.TimeColumn]:
            return timelines.columns(clock[part], steps[part])

        stream = self._stream
        stream.set_time(layout.TIME, duration=clock[0].astype("timedelta64[ns]"))
        stream.set_time(layout.STEP, sequence=int(steps[0]))
        layers = bodies.layers(frames, view, colours, balls=True)  # quick for any number of them
        lines = joints.entities(frames, view)
        self._clear({*map(bodies.entity, layers), *lines})
        for key, batch in sorted(layers.items()):
            new = self._is_new(bodies.entity(key), _look_of(batch, frames, placed=key[0]))
            if new:
                stream.log(bodies.entity(key), bodies.look(key, batch, frames))
            if new or not key[0]:
                bodies.send(stream, key, batch, frames, times)
        for path, members in sorted(lines.items()):
            if self._is_new(path, repr([line.name for line in members]).encode()):
                stream.log(path, joints.look(members))
            joints.send(stream, path, members, times)
        self._send_totals(totals, times(slice(None)))

    def joint_events(self, frame: int, events: Sequence[JointEvent[str]]) -> None:
        """Send a line of text for each event of a joint, at its time, before a frame is taken."""
        texts = [joint_line(event.joint, event) for event in events]
        instants = np.array([event.time for event in events])
        clock = timelines.nanoseconds(instants, self._path, _REMEDY)
        times = timelines.columns(clock, np.full(len(texts), frame))
        self._stream.send_columns(layout.JOINT_LOG, times, rr.TextLog.columns(text=texts))

    def flush(self) -> None:
        """Write what was sent; raise `RecordingError` if that cannot be done."""
        try:
            encoded = self._encoded.read(flush_timeout_sec=_PATIENCE)
            left = memoryview(messages.of(encoded or b"", begun=self._file.tell() > 0))
            while left:
                left = left[self._file.write(left) :]
        except (OSError, RuntimeError, ValueError) as fault:
            why = getattr(fault, "strerror", None) or fault
            raise RecordingError(
                f"{self._path}: cannot be written: {why}. Check the disk's space and the "
                "permissions."
            ) from fault

    def end(self) -> None:
        """End the file; nothing can be sent any more."""
        self._stream.disconnect()
        self._file.close()

    def _clear(self, shown: set[str]) -> None:
        """Let entities that show nothing any more vanish."""
        for path in sorted(self._shown.keys() - shown):
            self._stream.log(path, rr.Clear(recursive=False))
            del self._shown[path]

    def _is_new(self, path: str, look: bytes) -> bool:
        """Note how an entity looks from now on, and return whether that is another look."""
        new = self._shown.get(path) != look
        self._shown[path] = look
        return new

    def _send_totals(self, totals: Totals, times: list[rr.TimeColumn]) -> None:
        for path, values in (
            (layout.ENERGY, totals.kinetic_energy),
            (layout.SPEED, totals.speed),
            (layout.COUNT, totals.bodies),
        ):
            self._stream.send_columns(path, times, rr.Scalars.columns(scalars=values))
        points = rr.Points2D.columns(positions=np.concatenate(totals.contact_points))
        counts = [len(each) for each in totals.contact_points]
        self._stream.send_columns(_CONTACTS, times, points.partition(counts))


def _look_of(batch: bodies.Batch, frames: Frames, *, placed: bool) -> bytes:
    """Return bytes that differ where parts look otherwise or, if that counts, are elsewhere."""
    held = [frames.scene.bodies[k] for k in batch.bodies]
    look = [batch.colours, batch.radii, [body.name for body in held]]
    if placed:
        look += [np.array(batch.points).tobytes(), frames.position[0, batch.bodies].tobytes()]
        look += [frames.orientation[0, batch.bodies].tobytes()]
    return repr(look).encode()
