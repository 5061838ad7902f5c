"""Rerun's own program: the viewer, and a check of files."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

from tamias2d.errors import RecordingError


def program() -> Path:
    """Return the program itself; `rerun` on the path is a script that cannot be stopped well.

    Raises:
        RecordingError: it is not installed.
    """
    spec = find_spec("rerun_cli")
    if spec is None or not spec.submodule_search_locations:
        raise RecordingError(
            'rerun: its viewer is not installed. Install it by `pip install "tamias2d[record]"`.'
        )
    name = "rerun.exe" if sys.platform == "win32" else "rerun"
    return Path(spec.submodule_search_locations[0], name)


def verify(path: Path) -> bool:
    """Say whether the program finds the file whole: of a cut one a reader may just find less."""
    return _run("rrd", "verify", str(path.absolute())).returncode == 0


def view(path: Path, *, named: Path) -> None:
    """Open the viewer, without a port open to the network, and wait until it is closed.

    `named` is the user's file, for messages.
    """
    done = _run(str(path.absolute()), "--bind", "127.0.0.1")
    if done.returncode:
        raise RecordingError(
            f"{named}: the viewer ended with code {done.returncode}{_why(done.stderr)}. It needs a "
            "screen and a graphics driver; `tamias2d replay --check` needs neither."
        )


def _why(said: str) -> str:
    """The end of the viewer's first complaint: before it stand places in rerun's own source."""
    plain = re.sub(r"\x1b\[[0-9;]*m", "", said)
    complaint = next((line for line in plain.splitlines() if "rror" in line), "")
    end = re.split(r"\.rs:\d+: ", complaint)[-1].strip().rstrip(".")
    return f": {end}" if end else ""


def _run(*arguments: str) -> subprocess.CompletedProcess[str]:
    """Run it; in CI, as it then believes to be, it neither collects nor sends usage statistics."""
    return subprocess.run(
        [str(program()), *arguments],
        env={**os.environ, "CI": "true"},
        capture_output=True,
        encoding="utf-8",
        errors="replace",
        check=False,
    )
