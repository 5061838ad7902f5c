"""Directories on this machine: for results, and for compiled code that nobody else can write."""

import hashlib
import logging
import os
import stat
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

import platformdirs

from tamias2d.errors import InputError
from tamias2d.replacement import aside, growing, write_aside

__all__ = ["aside", "growing", "home", "home_path", "make_own", "refuse_shared", "results_path",
           "write_aside"]  # fmt: skip

_OTHERS = stat.S_IWGRP | stat.S_IWOTH


def home_path() -> Path:
    """The directory for results and compiled code, whether or not it can be written.

    TAMIAS2D_HOME if it is set, else the user's cache directory. Raises InputError if TAMIAS2D_HOME
    names no place.
    """
    chosen = os.environ.get("TAMIAS2D_HOME")
    if not chosen:
        return platformdirs.user_cache_path("tamias2d", appauthor=False)
    try:
        return Path(chosen).expanduser().absolute()
    except (RuntimeError, OSError) as fault:  # ~nosuchuser; a working directory that is gone
        raise _unusable(Path(chosen)) from fault


def home() -> Path:
    """The directory for results, made if need be.

    That of `home_path` or, where the user's cache directory cannot be written, a temporary one for
    this process. Raises InputError if TAMIAS2D_HOME cannot be written.
    """
    path = home_path()
    if _writable(path):
        return path
    if os.environ.get("TAMIAS2D_HOME"):
        raise _unusable(path)
    return Path(_temporary(path).name)


def results_path() -> Path:
    """The file of verification results; one for each installed copy, so that none misleads."""
    copy = hashlib.sha256(os.fsencode(Path(__file__).resolve().parent)).hexdigest()[:12]
    return home() / f"results-{copy}.json"


def make_own(path: Path) -> None:
    """Make a directory that nobody else can write, and its parents; raises OSError.

    Nobody else can enter it either, unless root makes it, who may compile for all users.
    """
    if not path.parent.exists():
        make_own(path.parent)
    path.mkdir(mode=0o755 if _is_root() else 0o700, exist_ok=True)


def refuse_shared(path: Path) -> None:
    """Raise InputError if somebody else may write into a directory; on Windows, never."""
    try:
        found = path.stat()
    except OSError:
        return
    if os.name != "posix":
        return
    if found.st_uid not in (os.geteuid(), 0):  # root may write anywhere
        fault, remedy = f"belongs to user {found.st_uid}", "Name a directory of your own"
    elif found.st_mode & _OTHERS:
        fault = f"has mode {stat.S_IMODE(found.st_mode):04o}: others may write to it"
        remedy = f"Delete it, or if you trust what is in it `chmod go-w {path}`, or name another"
    else:
        return
    raise InputError(
        f"{path}: {fault}: compiled code is run only from a directory that nobody else can write. "
        f"{remedy} by TAMIAS2D_HOME."
    )


def _is_root() -> bool:
    return os.name == "posix" and os.geteuid() == 0


def _unusable(path: Path) -> InputError:
    return InputError(
        f"TAMIAS2D_HOME: {path}: must be a directory that can be written. "
        "Make it writable, or unset the variable."
    )


def _writable(path: Path) -> bool:
    try:
        make_own(path)
    except (OSError, ValueError):  # a name with a null byte
        return False
    return os.access(path, os.W_OK | os.X_OK)


@cache
def _temporary(instead_of: Path) -> "TemporaryDirectory[str]":
    """A directory that lasts as long as this process."""
    logging.getLogger("tamias2d").warning(
        "%s cannot be written: results are kept only until this program ends. "
        "Set TAMIAS2D_HOME to a directory that can be.",
        instead_of,
    )
    return TemporaryDirectory(prefix="tamias2d-", ignore_cleanup_errors=True)
