"""How a file is replaced whole: written beside it, then renamed."""

import errno
import os
import secrets
import stat
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from itertools import count
from pathlib import Path

try:
    import fcntl
except ImportError:  # Windows
    fcntl = None  # type: ignore[assignment]

_PREFIX = ".tamias2d-draft-"
_DAY = 86_400.0  # s


@contextmanager
def aside(path: Path, *, mode: int = 0o666) -> Iterator[Path]:
    """Give a path to write to, which takes the place of `path` when the block ends well.

    A reader sees the old content or the new one, whole, even where the power fails. A link stays a
    link, and a file keeps its mode; a new one has of `mode` what the umask lets. Raises OSError as
    `open` does; the file at `path` is then as it was.
    """
    target, before = _target(path)
    _remove_abandoned(target.parent)
    draft, held = _draft(target.parent, mode if before is None else 0o600)
    try:
        yield draft
        _finish(draft, before)
        draft.replace(target)
    finally:
        draft.unlink(missing_ok=True)
        if held is not None:
            os.close(held)


@contextmanager
def growing(path: Path) -> Iterator[Path]:
    """Likewise for what is written bit by bit: its draft is kept where the block does not end well.

    Its name tells what it is part of: of `session.rrd` it is `session.part.rrd`, or
    `session.part2.rrd` where there is one from before. An empty one is not kept.
    """
    target, before = _target(path)
    draft = _part(target, 0o666 if before is None else 0o600)
    try:
        yield draft
        _finish(draft, before)
        draft.replace(target)
    except BaseException:
        if not draft.stat().st_size:
            draft.unlink()
        raise


def write_aside(path: Path, content: bytes, *, mode: int = 0o666) -> None:
    """Replace the content of the file at `path` in one step; raises as `aside` does."""
    with aside(path, mode=mode) as draft:
        draft.write_bytes(content)


def _target(path: Path) -> tuple[Path, int | None]:
    """The file that a path leads to, and its mode if there is one; raises OSError."""
    try:
        target = Path(os.path.realpath(path))
        mode = target.stat().st_mode
    except FileNotFoundError:
        return target, None
    except ValueError as fault:  # a null byte, or half a character
        raise OSError(errno.EINVAL, os.strerror(errno.EINVAL), str(path)) from fault
    if not stat.S_ISREG(mode):
        raise OSError(errno.EEXIST, "It is no regular file", str(path))
    return target, stat.S_IMODE(mode)


def _draft(folder: Path, mode: int) -> tuple[Path, int | None]:
    """Make an empty file, and hold it so that nobody takes it for abandoned; return both."""
    while True:
        draft = folder / f"{_PREFIX}{secrets.token_hex(8)}"
        held = os.open(draft, os.O_RDWR | os.O_CREAT | os.O_EXCL, mode)
        if fcntl is None:
            os.close(held)  # what is open cannot be renamed there
            return draft, None
        with suppress(OSError):  # a file system without locks
            fcntl.flock(held, fcntl.LOCK_EX)
        if draft.exists():  # it was not removed before it was held
            return draft, held
        os.close(held)


def _part(target: Path, mode: int) -> Path:
    """Make an empty file beside another one, with a name that tells so; raises OSError."""
    for number in count(1):
        draft = target.with_suffix(f".part{number if number > 1 else ''}{target.suffix}")
        with suppress(FileExistsError):
            os.close(os.open(draft, os.O_RDWR | os.O_CREAT | os.O_EXCL, mode))
            return draft
    raise AssertionError


def _finish(draft: Path, mode: int | None) -> None:
    """Wait until the content is on the disk, else the name may be there before it."""
    file = os.open(draft, os.O_RDWR)
    try:
        os.fsync(file)
    finally:
        os.close(file)
    if mode is not None:
        draft.chmod(mode)


def _remove_abandoned(folder: Path) -> None:
    """Remove the user's drafts whose writers are no more."""
    for draft in folder.glob(f"{_PREFIX}*"):
        with suppress(OSError):
            found = draft.lstat()
            if fcntl is None:
                if time.time() - found.st_mtime > _DAY:
                    draft.unlink(missing_ok=True)
            elif stat.S_ISREG(found.st_mode) and found.st_uid == os.geteuid():
                _remove_unless_held(draft)


def _remove_unless_held(draft: Path) -> None:
    """Remove a draft; raise OSError if its writer holds it."""
    file = os.open(draft, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK)
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        draft.unlink(missing_ok=True)
    finally:
        os.close(file)
