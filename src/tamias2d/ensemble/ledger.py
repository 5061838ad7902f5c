"""Which files of a store were written whole: the digests of what they held when they were.

Serves: stores of ensembles. Hides: where the digests lie, and how they are compared. They lie with
the outcomes, in a folder that readers of Zarr pass over, and each entry appears whole or not at
all.
"""

import hashlib
import json
from collections.abc import Iterable
from pathlib import Path

from tamias2d.replacement import write_aside

_FOLDER = "outcome/.ledger"


class Ledger:
    """The entries of a store, each with the SHA-256 of some of its files."""

    def __init__(self, store: Path) -> None:
        self._store = store
        self._folder = store / _FOLDER

    def __contains__(self, entry: str) -> bool:
        return (self._folder / entry).is_file()

    def enter(self, entry: str, files: Iterable[str]) -> None:
        """Enter files, by their paths in the store, as they are now; also that one is not there.

        Raises:
            OSError: it cannot be written.
        """
        text = json.dumps({file: self._digest(file) for file in files})
        self._folder.mkdir(exist_ok=True)
        write_aside(self._folder / entry, text.encode())

    def damaged(self, entry: str) -> str | None:
        """Return the first file that is not what was entered, or None if all are."""
        try:
            entered = json.loads((self._folder / entry).read_text(encoding="utf-8"))
            files = entered.items()
        except (OSError, ValueError, AttributeError):
            return f"{_FOLDER}/{entry}"
        return next((file for file, digest in files if self._digest(file) != digest), None)

    def _digest(self, file: str) -> str | None:
        """Return the SHA-256 of a file, None if there is none to be read."""
        try:
            with (self._store / file).open("rb") as read:
                return hashlib.file_digest(read, "sha256").hexdigest()
        except OSError:
            return None
