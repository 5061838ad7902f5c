"""Views that were taken before bodies were added, which may have put the arrays elsewhere.

Reading such a view tells what was; what is written into it, or into a part of it, is lost. NumPy
cannot refuse that: a part that was taken before stays writable, whatever becomes of its whole. So
it is looked for as steps are asked for. Cost: nothing where nobody holds an earlier view.
"""

from collections.abc import Sequence
from itertools import compress

import numpy as np

from tamias2d.scene.rules import RuleError
from tamias2d.simulator.lent import which_are_held
from tamias2d.state import Array


class EarlierViews:
    """The earlier views that somebody holds, by the names of what they were views of."""

    def __init__(self, names: Sequence[str]) -> None:
        """Begin with none; each time there is a view for each name."""
        self._names = names
        self._of: list[int] = []  # places of their names
        self._arrays: list[Array] = []
        self._left: list[Array | None] = []  # what they held as the arrays went elsewhere

    def __bool__(self) -> bool:
        return len(self._arrays) > 0

    def add(self, views: tuple[Array, ...], later: tuple[Array, ...]) -> None:
        """Add views that others replace, if somebody holds them."""
        held = which_are_held(views)
        for k in np.flatnonzero(held).tolist():
            self._of.append(k)
            self._arrays.append(views[k])
            self._left.append(None)
        for k, of in enumerate(self._of):
            if self._left[k] is None and not np.may_share_memory(self._arrays[k], later[of]):
                self._left[k] = self._arrays[k].copy()

    def look(self) -> None:
        """Raise `RuleError` if what was written into one is lost; forget what nobody holds."""
        self._refuse_lost()
        held = which_are_held(self._arrays)
        self._of = list(compress(self._of, held))
        self._arrays = list(compress(self._arrays, held))
        self._left = list(compress(self._left, held))

    def _refuse_lost(self) -> None:
        for of, array, left in zip(self._of, self._arrays, self._left, strict=True):
            if left is None:
                continue
            written = np.argwhere(array.view(np.int64) != left.view(np.int64))
            if len(written):
                left[...] = array
                raise _lost(self._names[of], int(written[0, 0]))


def _lost(name: str, row: int) -> RuleError:
    return RuleError(
        f"{name}[{row}] of the simulator: found a value in a view that was taken before bodies "
        f"were added: it is lost (R4). Take sim.{name} anew after adding, and write into that.",
        name,
    )
