"""What a simulator warned of, each once, at the line that called the library.

Serves: whatever finds that a step cannot hold something. Hides: whether that is told at once or by
who steps many simulators, and how many calls up the caller is.
"""

import sys
from collections.abc import Iterable
from os import sep
from pathlib import Path
from types import FrameType
from typing import TypeAlias
from warnings import warn

from tamias2d.errors import StepWarning

Told: TypeAlias = tuple[str, str]
"""A name under which a warning is kept, and its text."""

_LIBRARY = f"{Path(__file__).parents[1]}{sep}"


class Warned:
    """The warnings of a simulator, by the names under which they are kept."""

    def __init__(self) -> None:
        """Begin without any; each is told at once."""
        self.texts: dict[str, str] = {}
        self._kept_back: list[str] | None = None

    def __contains__(self, name: str) -> bool:
        return name in self.texts

    def tell(self, found: Iterable[Told]) -> None:
        """Warn of what was not warned of before."""
        for name, text in found:
            if name not in self.texts:
                self.texts[name] = text
                if self._kept_back is None:
                    warn_caller(text)
                else:
                    self._kept_back.append(text)

    def keep_back(self) -> None:
        """Tell nothing from now on: whoever steps many simulators takes it, and tells it."""
        self._kept_back = []

    def taken(self) -> list[str]:
        """Return what was kept back since this was called last."""
        taken = self._kept_back or []
        self.keep_back()
        return taken


def warn_caller(text: str) -> None:
    """Warn at the line outside of this library from which it was called."""
    warn(text, StepWarning, stacklevel=_calls_up())


def _calls_up() -> int:
    """Return how many calls above the one that asks the first one is that is not of the library."""
    frame: FrameType | None = sys._getframe(1)
    level = 1
    while frame is not None and frame.f_code.co_filename.startswith(_LIBRARY):
        frame, level = frame.f_back, level + 1
    return level
