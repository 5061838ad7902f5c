"""What several processes need is compiled by one of them, also if that one is killed."""

import os
import subprocess
import sys
import textwrap
from pathlib import Path

import pytest

TAKEN = """
    import sys
    from tamias2d.kernels.compile_lock import compile_lock
    with compile_lock("engine", "0123"):
        print("mine", flush=True)
        sys.stdin.read()
"""


def taking(home: Path) -> "subprocess.Popen[str]":
    """Start a process that takes the lock, says so, and keeps it until its input ends."""
    return subprocess.Popen(
        [sys.executable, "-c", textwrap.dedent(TAKEN)],
        env={**os.environ, "TAMIAS2D_HOME": str(home)},
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


def line_of(process: "subprocess.Popen[str]", stream: str) -> str:
    return str(getattr(process, stream).readline())


@pytest.mark.skipif(sys.platform == "win32", reason="without locks each compiles for itself")
@pytest.mark.parametrize("killed", [False, True])
def test_another_one_waits_until_the_first_ends(tmp_path: Path, killed: bool) -> None:
    with taking(tmp_path) as first:
        assert line_of(first, "stdout") == "mine\n"
        with taking(tmp_path) as second:
            told = "Waiting for another process that compiles the engine ...\n"
            assert line_of(second, "stderr") == told
            if killed:
                first.kill()
            else:
                first.communicate()
            assert line_of(second, "stdout") == "mine\n"
            second.communicate()


@pytest.mark.skipif(os.name != "posix" or os.geteuid() == 0, reason="root may write anywhere")
def test_where_nothing_can_be_locked_it_goes_on(tmp_path: Path) -> None:
    tmp_path.chmod(0o500)
    with taking(tmp_path) as alone:
        assert line_of(alone, "stdout") == "mine\n"
        alone.communicate()
