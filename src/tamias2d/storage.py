"""Where results and caches live on this machine, and how a file is replaced whole.

Serves: a directory that can be written, the path of the verification results, safe writing.
Hides: the order in which places are tried, and how two checkouts are kept apart.
"""

import hashlib
import os
import secrets
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from pathlib import Path

import platformdirs

from tamias2d.errors import InputError


def home() -> Path:
    """The directory for results and caches, made if need be.

    TAMIAS2D_HOME if it is set, else the user's cache directory, else a temporary one for this
    process. Raises InputError if TAMIAS2D_HOME cannot be written.
    """
    chosen = os.environ.get("TAMIAS2D_HOME")
    if chosen:
        path = Path(chosen).expanduser().absolute()
        if not _writable(path):
            raise InputError(
                f"TAMIAS2D_HOME: {path}: must be a directory that can be written. "
                "Make it writable, or unset the variable."
            )
        return path
    path = platformdirs.user_cache_path("tamias2d", appauthor=False)
    return path if _writable(path) else temporary()


def results_path() -> Path:
    """The file of verification results; one for each installed copy, so that none misleads."""
    copy = hashlib.sha256(os.fsencode(Path(__file__).resolve().parent)).hexdigest()[:12]
    return home() / f"results-{copy}.json"


@contextmanager
def aside(path: Path) -> Iterator[Path]:
    """Give a path to write to, which takes the place of `path` when the block ends well.

    A reader sees the old content or the new one, whole. Raises OSError as `open` does; the file at
    `path` is then as it was.
    """
    draft = path.with_name(f".{path.name}.{secrets.token_hex(8)}.tmp")
    try:
        yield draft
        draft.replace(path)
    finally:
        draft.unlink(missing_ok=True)


def write_aside(path: Path, content: bytes) -> None:
    """Replace the content of the file at `path` in one step; raises as `aside` does."""
    with aside(path) as draft:
        draft.write_bytes(content)


def _writable(path: Path) -> bool:
    try:
        path.mkdir(parents=True, exist_ok=True)
    except OSError:
        return False
    return os.access(path, os.W_OK | os.X_OK)


@cache
def temporary() -> Path:
    """A directory that lasts as long as the system lets it, made once for this process."""
    # Not a fixed name: compiled code will be cached here, and another user could have laid it out.
    return Path(tempfile.mkdtemp(prefix="tamias2d-"))
