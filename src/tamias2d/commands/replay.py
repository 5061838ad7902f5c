"""`tamias2d replay`: look at a recording, or compute it again and compare its numbers."""

import sys
from pathlib import Path

from tamias2d import replay
from tamias2d.commands.output import say

_LARGE = 5_000_000  # bytes: what takes longer than the viewer itself


def replay_file(file: Path, *, check: bool) -> int:
    """Open the viewer, or say whether the run is identical; return the exit code, 1 if not."""
    if file.is_file() and (size := file.stat().st_size) > _LARGE:
        print(f"{file}: reading {size / 1e6:.0f} MB ...", file=sys.stderr)
    if not check:
        replay.replay(file)
        return 0
    answer = replay.check(file)
    say(answer.says)
    return 0 if answer.identical else 1
