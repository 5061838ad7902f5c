"""A recorder of frame loops: what was where at each frame, to look at in the viewer (`.rrd`)."""

from __future__ import annotations

from contextlib import ExitStack, suppress
from pathlib import Path
from typing import TYPE_CHECKING

from tamias2d.errors import InputError, RecordingError
from tamias2d.record import drawing, files
from tamias2d.record.document import about_frames
from tamias2d.record.frame_block import FrameBlock
from tamias2d.recording_file import checked_path, growing, refuse_place
from tamias2d.scene.rules import shown
from tamias2d.simulator import Simulator
from tamias2d.suggestions import suggests

if TYPE_CHECKING:
    from tamias2d.motion.joint_events import JointEvent
    from tamias2d.record.drawing import Colour, View
    from tamias2d.record.drawn import Frames
    from tamias2d.record.frame_block import Key
    from tamias2d.scene import Body

_REACH = 2.0  # times the ground: bodies that are farther away have left the scene


@suggests
class Recorder:
    """Records a frame loop while it runs, for the viewer; bodies and joints may come and go.

    Take a frame whenever the viewer is to show one: after each call of `step`, or less often. The
    file is whole when the recorder is closed, which the end of a `with` block does, also where an
    error ends it. Until then what is written is beside it, in `NAME.part.rrd`, and stays there if
    the program is killed. It cannot be computed again: what a program does between steps is not in
    it.
    """

    def __init__(self, sim: Simulator, path: str | Path) -> None:
        """Record a simulator to a file (.rrd); no frame is taken yet.

        Raises:
            InputError: this is no simulator, or the name has another ending.
            RecordingError: the file cannot be written, or rerun is not installed
                (`pip install "tamias2d[record]"`).
        """
        if not isinstance(sim, Simulator):
            raise InputError(
                f"sim: found {shown(sim)}: must be a Simulator (R5). Record one world; a run of "
                "simulate has run.save(path)."
            )
        self._sim, self._path = sim, checked_path(path)
        if self._path.suffix != ".rrd":
            raise InputError(
                f"{self._path}: found the ending '{self._path.suffix}': a frame loop is recorded "
                "as .rrd (R5). Give the name this ending."
            )
        refuse_place(self._path)
        rerun = files.rerun(self._path, otherwise="keep sim.position in an array")
        with ExitStack() as opened:
            self._draft = opened.enter_context(growing(self._path))
            self._stream = rerun.FrameStream(self._draft, self._path, about_frames(sim))
            opened.callback(self._stream.end)
            self._open = opened.pop_all()
        self._cut = rerun.cut
        self._happened: list[JointEvent[str]] = []
        """Since the last frame; the simulator adds to it."""
        sim._heard = (*sim._heard, self._happened)
        self._block: FrameBlock | None = None  # of frames that are not written yet
        self._known: dict[Key, Body] = {}
        self._forms = 0  # of the simulator as these were asked for
        self._colours: dict[Key, Colour] = {}
        self._view: View | None = None
        self._ground: View  # what the first frames hold, and what stands still
        self._frames = 0
        self._closed = False

    def __enter__(self) -> Recorder:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __len__(self) -> int:
        """How many frames were taken."""
        return self._frames

    def frame(self) -> None:
        """Take a frame: where all bodies and joints are now, and where bodies touch.

        Raises:
            RecordingError: the recorder is closed, or the file cannot be written.
        """
        if self._closed:
            raise RecordingError(
                f"{self._path}: its recorder is closed. Make another one, for another file."
            )
        now = self._sim._snapshot()
        if self._block is not None and not self._block.takes(now):
            self._write()
        if self._block is None:
            known = self._known if now.forms == self._forms else {}
            self._block = FrameBlock(self._sim, now, self._frames, known)
            self._known, self._forms = self._block.bodies, now.forms
        self._block.add(now)
        self._tell_joints()
        self._frames += 1

    def close(self) -> None:
        """Write what is left, and let the file appear under its name; once is enough.

        Raises:
            RecordingError: it cannot be written; what could be is kept, as the error says.
        """
        if self._closed:
            return
        self._tell_joints()
        if self._block is not None:
            self._write()
        if self._view is not None:
            self._stream.view(self._view)  # which may have grown
        self._flush()
        self._end()
        try:
            self._open.close()
        except RecordingError as fault:
            raise self._lost(fault) from fault.__cause__

    def _tell_joints(self) -> None:
        """Write what happened to joints since the last frame, as the next one shows it."""
        if self._happened:
            self._stream.joint_events(self._frames, self._happened)
            self._happened.clear()

    def _write(self) -> None:
        """Write the block of frames; where that cannot be done the recorder is closed."""
        block, self._block = self._block, None
        assert block is not None
        frames = block.frames()
        view = self._look_at(frames)
        colours = [self._colour(body, key) for key, body in block.bodies.items()]
        self._stream.send(frames, block.totals(), block.first, view, colours)
        self._flush()

    def _flush(self) -> None:
        """Let all be in the file; where that cannot be done, keep what is, and close."""
        try:
            self._stream.flush()
        except RecordingError as fault:
            self._end()
            with suppress(RecordingError), self._open:
                raise
            raise self._lost(fault) from fault.__cause__

    def _end(self) -> None:
        """Take nothing any more."""
        self._closed = True
        self._sim._heard = tuple(e for e in self._sim._heard if e is not self._happened)

    def _lost(self, fault: RecordingError) -> RecordingError:
        """Return an error that says, too, what there is of the recording."""
        if self._draft.exists() and self._cut(self._draft):
            kept = f"What could be written is in {self._draft}, for `tamias2d replay`."
        else:
            kept = "Nothing could be written."
        return RecordingError(f"{fault} {kept}")

    def _look_at(self, frames: Frames) -> View:
        """Return the view, which grows with what there is, but not after what is lost for good."""
        if self._view is None:
            self._ground = self._view = drawing.view_of_most(frames)
            self._stream.view(self._view)
        standing = frames.standing()
        if standing.scene.bodies:
            self._ground = drawing.grown(self._ground, drawing.view_of(standing))
        seen = drawing.within(drawing.view_of(frames), self._ground, _REACH)
        self._view = drawing.grown(self._view, seen)
        return self._view

    def _colour(self, body: Body, key: Key) -> Colour:
        """Return the colour of a body, which it keeps; those that move take turns."""
        if not body.dynamic:
            return drawing.KINEMATIC_COLOUR if body.kinematic else drawing.STATIC_COLOUR
        turn = len(self._colours) % len(drawing.PALETTE)
        return self._colours.setdefault(key, drawing.PALETTE[turn])
