"""The least solution of linear equations, with a decision on which of them depend on others.

Serves: the joints of a mechanism. Hides: how the rows are factorised, and that the dependent ones
are looked for only where the factors hint at them.
"""

import numpy as np

from tamias2d.state import Array

DEPENDENT = 1e-8
"""Of the largest; shorter combinations of rows, each of length one, count as none (GD19)."""
_DOUBTFUL = 1e-4
"""Of one; a smaller pivot asks for a decision on the rank."""


class LeastSolution:
    """x of least length with `rows` (m, n) times x equal to what is wanted."""

    def __init__(self, rows: Array) -> None:
        length = np.sqrt(np.einsum("ij,ij->i", rows, rows))
        self._scale = np.divide(1.0, length, out=np.zeros_like(length), where=length > 0)
        self._rows = rows * self._scale[:, None]
        self._regular = len(rows) <= rows.shape[1] and bool(length.all())
        if self._regular:
            self._basis, self._triangle = np.linalg.qr(self._rows.T)
            self._regular = bool(np.abs(np.diagonal(self._triangle)).min(initial=1.0) > _DOUBTFUL)
        if not self._regular:
            left, sizes, right = np.linalg.svd(self._rows, full_matrices=False)
            kept = sizes > DEPENDENT * sizes.max(initial=0.0)
            self._left, self._sizes, self._right = left[:, kept], sizes[kept], right[kept]

    @property
    def rank(self) -> int:
        """How many rows do not depend on others."""
        return len(self._rows) if self._regular else len(self._sizes)

    def __call__(self, wanted: Array) -> Array:
        """Return x (n,)."""
        scaled = self._scale * wanted
        if self._regular:
            x: Array = self._basis @ np.linalg.solve(self._triangle.T, scaled)
        else:
            x = self._right.T @ ((self._left.T @ scaled) / self._sizes)
        return x

    def shares(self, x: Array) -> Array:
        """Return the least weights (m,) with which the rows add up to a solution x."""
        if self._regular:
            found = np.linalg.solve(self._triangle, self._basis.T @ x)
        else:
            found = self._left @ ((self._right @ x) / self._sizes)
        shares: Array = self._scale * found
        return shares

    def missed(self, wanted: Array, x: Array) -> float:
        """Return by how much x misses what is wanted of rows of length one."""
        left = self._scale * wanted - self._rows @ x
        return float(np.abs(left).max(initial=0.0))

    def size(self, wanted: Array) -> float:
        """Return the largest that is wanted of rows of length one."""
        return float(np.abs(self._scale * wanted).max(initial=0.0))

    def dependent_rows(self) -> list[int]:
        """Return the rows of which a combination counts as none."""
        if self.rank == len(self._rows):
            return []
        left, sizes, _ = np.linalg.svd(self._rows)
        kept = int((sizes > DEPENDENT * sizes.max(initial=0.0)).sum())
        return np.flatnonzero(np.abs(left[:, kept:]).max(axis=1) > DEPENDENT**0.5).tolist()
