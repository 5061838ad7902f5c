"""Compiled code on disk: nothing but what was compiled here is run, and damage mends itself."""

import io
import os
import pickle
import re
import stat
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np
import platformdirs
import pytest
import rich.console

from tamias2d import storage
from tamias2d.errors import InputError
from tamias2d.kernels import Library, cache, compiled, kept_files, progress, source
from tamias2d.kernels.compiled import loaded
from tamias2d.kernels.demand import Demand
from tests.kernels import plain_parts
from tests.kernels.test_library import LIBRARY, forget

SMALL = Library("small library", (plain_parts.pushed,))


@pytest.fixture
def kernels(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Where compiled code will be."""
    monkeypatch.setenv("TAMIAS2D_HOME", str(tmp_path))
    kept_files._say_not_kept.cache_clear()
    return tmp_path / "kernels"


def answer(library: Library = SMALL) -> tuple[float, bool]:
    """What a new process would find: the value, and whether the code was found on disk."""
    forget()
    made = library.compiled()
    found = made.pushed(np.ones((1, 48)), 1), bool(made.pushed.stats.cache_hits)
    forget()
    return found


RIGHT = SMALL.plain().pushed(np.ones((1, 48)), 1)


def flip(place: float) -> Callable[[bytes], bytes]:
    def flipped(content: bytes) -> bytes:
        k = int(place * (len(content) - 1))
        return content[:k] + bytes([content[k] ^ 1]) + content[k + 1 :]

    return flipped


class Bomb:
    """Its pickle makes a file when it is loaded."""

    def __reduce__(self) -> tuple[Callable[[str], None], tuple[str]]:
        return os.mkdir, (os.environ["TAMIAS2D_HOME"] + "/exploded",)


DAMAGES: dict[str, Callable[[bytes], bytes]] = {
    "empty": lambda _: b"",
    "cut in the digest": lambda content: content[:20],
    "cut after the digest": lambda content: content[:32],
    "cut": lambda content: content[: len(content) // 2],
    "longer": lambda content: content + b"0",
    "flip at the start": flip(0.0),
    "flip in the middle": flip(0.5),
    "flip at the end": flip(1.0),
    "zeros": lambda content: bytes(len(content)),
    "another pickle": lambda content: content[:32] + pickle.dumps(Bomb()),
    "a bare pickle": lambda _: pickle.dumps(Bomb()),
}


@pytest.mark.parametrize("damage", DAMAGES)
def test_damaged_code_is_compiled_again_and_replaced(
    kernels: Path, damage: str, caplog: pytest.LogCaptureFixture
) -> None:
    assert answer() == (RIGHT, False)
    (file,) = kernels.iterdir()
    whole = file.read_bytes()
    file.write_bytes(DAMAGES[damage](whole))
    assert answer() == (RIGHT, False)
    assert answer() == (RIGHT, True)
    assert list(kernels.iterdir()) == [file]
    assert not (kernels.parent / "exploded").exists()
    assert not caplog.messages


def test_the_code_of_another_function_is_not_run(kernels: Path) -> None:
    forget()
    LIBRARY.compiled()
    first, second = sorted(kernels.iterdir())
    kept = first.read_bytes(), second.read_bytes()
    first.write_bytes(kept[1])
    second.write_bytes(kept[0])
    assert answer(LIBRARY) == (RIGHT, False)
    forget()


@pytest.mark.skipif(os.name != "posix", reason="links and pipes")
def test_a_link_or_a_pipe_in_the_place_of_a_file_is_replaced(kernels: Path) -> None:
    assert answer() == (RIGHT, False)
    (file,) = kernels.iterdir()
    elsewhere = kernels.parent / "elsewhere"
    elsewhere.write_bytes(b"of somebody else")
    for place in (lambda: file.symlink_to(elsewhere), lambda: os.mkfifo(file), file.mkdir):
        file.unlink()
        place()
        assert answer() == (RIGHT, False)
        assert answer() == (RIGHT, True)
        assert file.is_file()
        assert not file.is_symlink()
    assert elsewhere.read_bytes() == b"of somebody else"


def test_a_source_that_lies_there_is_not_run(kernels: Path) -> None:
    kernels.mkdir()
    forget()
    name = f"{cache.KernelCache('pushed', SMALL.source())._name.partition('.')[0]}.py"
    (kernels / name).write_text("raise SystemExit('run')")
    assert answer() == (RIGHT, False)


@pytest.mark.skipif(os.name != "posix", reason="modes")
@pytest.mark.parametrize("mode", [0o777, 0o720, 0o702, 0o1777])
def test_a_directory_that_others_may_write_is_refused(kernels: Path, mode: int) -> None:
    kernels.mkdir()
    kernels.chmod(mode)
    with pytest.raises(InputError, match=rf"kernels: has mode {mode:04o}: .*chmod go-w"):
        answer()
    kernels.chmod(0o755)
    assert answer() == (RIGHT, False)


@pytest.mark.skipif(os.name != "posix", reason="owners")
def test_a_directory_of_another_user_is_refused(
    kernels: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    answer()
    if os.getuid() == 0:
        os.chown(kernels, 12345, -1)
    else:
        monkeypatch.setattr(os, "geteuid", lambda: 12345)
    with pytest.raises(InputError, match=r"kernels: belongs to user \d+: .*TAMIAS2D_HOME"):
        answer()


@pytest.mark.skipif(os.name != "posix", reason="modes")
@pytest.mark.parametrize(("is_root", "mode"), [(False, 0o700), (True, 0o755)])
def test_nobody_else_can_write_what_is_made(
    kernels: Path, monkeypatch: pytest.MonkeyPatch, is_root: bool, mode: int
) -> None:
    monkeypatch.setattr(storage, "_is_root", lambda: is_root)
    before = os.umask(0)
    try:
        answer()
    finally:
        os.umask(before)
    assert stat.S_IMODE(kernels.stat().st_mode) == mode
    assert [stat.S_IMODE(file.stat().st_mode) for file in kernels.iterdir()] == [0o644]
    assert answer() == (RIGHT, True)


@contextmanager
def another_user() -> Iterator[None]:
    os.setreuid(12345, 0)
    os.seteuid(12345)
    try:
        yield
    finally:
        os.seteuid(0)
        os.setreuid(0, 0)


AS_ROOT = pytest.mark.skipif(os.name != "posix" or os.geteuid() != 0, reason="only root may be two")


@AS_ROOT
def test_what_root_compiled_serves_others(
    monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    with tempfile.TemporaryDirectory() as place:
        os.chmod(place, 0o755)
        monkeypatch.setenv("TAMIAS2D_HOME", f"{place}/home")
        assert answer() == (RIGHT, False)
        with another_user():
            assert answer() == (RIGHT, True)
    assert not caplog.messages


@AS_ROOT
def test_a_home_of_somebody_else_costs_no_answer_and_is_said_once(
    kernels: Path, caplog: pytest.LogCaptureFixture
) -> None:
    assert answer() == (RIGHT, False)
    kernels.parent.chmod(0o700)
    with another_user():
        assert answer() == answer(LIBRARY) == (RIGHT, False)
    (said,) = caplog.messages
    assert said.startswith(f"Compiled code cannot be found or kept in {kernels}: Permission denied")


def test_a_home_that_cannot_be_named_costs_no_answer_and_is_said_once(
    kernels: Path, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    home = kernels.parent / ("x" * 300)
    monkeypatch.setenv("TAMIAS2D_HOME", str(home))
    assert answer() == answer(LIBRARY) == (RIGHT, False)
    (said,) = caplog.messages
    assert said.startswith(
        f"Compiled code cannot be found or kept in {home}/kernels: File name too"
    )


def test_a_full_disk_costs_no_answer_and_is_said_once(
    kernels: Path, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    def full(*_: object, **__: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(kept_files.storage, "write_aside", full)
    assert answer() == answer(LIBRARY) == (RIGHT, False)
    (said,) = caplog.messages
    assert said.startswith(f"Compiled code cannot be kept in {kernels}: No space left on device.")


def test_a_home_that_cannot_be_written_is_said_once_and_leaves_nothing(
    kernels: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    caplog: pytest.LogCaptureFixture,
) -> None:
    monkeypatch.delenv("TAMIAS2D_HOME")
    (tmp_path / "file").write_text("in the way")
    (tmp_path / "tmp").mkdir()
    monkeypatch.setattr(platformdirs, "user_cache_path", lambda *_, **__: tmp_path / "file")
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path / "tmp"))
    assert answer() == answer() == (RIGHT, False)
    assert len(caplog.messages) == 1
    assert list((tmp_path / "tmp").iterdir()) == []
    assert not kernels.exists()


def test_nothing_else_is_kept_than_what_is_checked(kernels: Path) -> None:
    """Not by numba itself: neither for libraries nor for kernels that are compiled when called."""
    answer()
    loaded.cache_clear()
    kernel = compiled.__wrapped__(Demand("explicit_euler"))
    kernel(np.array([0.0, 1.0]), *np.zeros((4, 3)), 0.0, -9.81)
    names = sorted(path.name.split(".")[1] for path in kernels.rglob("*"))
    assert names == ["advance", "pushed"]
    assert "cache=True" in source(Demand("explicit_euler"))


def test_a_terminal_has_a_bar_that_vanishes(kernels: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    shown = io.StringIO()
    screen = rich.console.Console(file=shown, force_terminal=True, width=200)
    monkeypatch.setattr(rich.console, "Console", lambda **_: screen)
    text = SMALL.source()
    with progress.progress("small library", text):
        loaded.cache_clear()
        loaded(text)
    count = text.count("\ndef ")
    assert f"Compiling the small library: {count} functions" in shown.getvalue()
    assert f"{count}/{count}" in shown.getvalue()
    assert "\x1b[2K" in shown.getvalue()  # erased
    assert re.search(r"Compiled in [\d.]+ s\.$", shown.getvalue())
    assert kernels.exists()
