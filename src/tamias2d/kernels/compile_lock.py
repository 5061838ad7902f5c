"""The lock of compiling: one process compiles what others wait for, and then find kept.

Serves: libraries. Hides: the lock. The system lets it go when its holder ends, in whatever way.
"""

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager

from tamias2d import storage

try:
    import fcntl
except ImportError:  # Windows
    fcntl = None  # type: ignore[assignment]


@contextmanager
def compile_lock(name: str, key: str) -> Iterator[None]:
    """Let no other process compile what has this name, for people, and this key.

    Where nothing can be locked, each compiles for itself.
    """
    held = _opened(key) if fcntl else None
    try:
        if held is not None:
            _wait(held, name)
        yield
    finally:
        if held is not None:
            os.close(held)


def _opened(key: str) -> int | None:
    """Open the file that is locked; it stays, since another process may be waiting for it."""
    place = storage.home_path() / "locks"
    try:
        storage.make_own(place)
        return os.open(place / key, os.O_RDWR | os.O_CREAT | os.O_NOFOLLOW, 0o600)
    except OSError:
        return None


def _wait(held: int, name: str) -> None:
    try:
        fcntl.flock(held, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        print(f"Waiting for another process that compiles the {name} ...", file=sys.stderr)
        fcntl.flock(held, fcntl.LOCK_EX)
    except OSError:  # a file system without locks
        return
