"""Reading an `.rrd` in a process of its own, which hands over what an `.npz` would hold.

Rerun's reader aborts at some damaged files and takes its process along.
"""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING

from tamias2d.errors import FrameLoopError, RecordingError
from tamias2d.record import history
from tamias2d.record.rerun.messages import whole
from tamias2d.record.rerun.program import verify

if TYPE_CHECKING:
    from tamias2d.record.header import Header
    from tamias2d.record.history import Arrays

UNPACKING = "tamias2d.record.rerun.unpacking"
REFUSED, FRAME_LOOP = 3, 4
"""With these codes the other process ends when it has said what is wrong, and of frame loops."""


def read(path: Path) -> tuple[Header, Arrays]:
    """Read header and arrays; raise `RecordingError` if the file is damaged or not one of ours.

    Of a frame loop, which raises `FrameLoopError`, only the beginning is read.
    """
    with TemporaryDirectory(prefix="tamias2d-") as folder, whole(path) as intact:
        exact = Path(folder, "exact.npz")
        # -P: what lies where the user happens to be is not imported
        done = subprocess.run(
            [sys.executable, "-P", "-m", UNPACKING, str(intact), str(exact)],
            capture_output=True,
            encoding="utf-8",
            errors="replace",
            check=False,
        )
        if done.returncode == FRAME_LOOP:
            raise FrameLoopError(
                f"{path}: records a frame loop: what the program did between its steps is not in "
                f"it, so that it cannot be computed again. Look at it by `tamias2d replay {path}`."
            )
        if not verify(path):
            raise _damaged(path)
        if done.returncode == REFUSED:
            raise RecordingError(done.stdout)
        if done.returncode:
            raise _damaged(path)
        return history.read(exact)


def _damaged(path: Path) -> RecordingError:
    """Say that a file cannot be read, and what can be done."""
    return RecordingError(
        f"{path}: cannot be read as .rrd: it is cut, damaged or of another kind. What is left of a "
        "cut one: `rerun rrd merge --continue-on-error CUT.rrd -o REST.rrd`."
    )
