"""The least solution of linear equations, with a decision on which of them depend on others.

Serves: the joints of a mechanism. Hides: how the rows are factorised, and that the dependent ones
are looked for only where the factors hint at them.
"""

import numpy as np

from tamias2d.state import Array

DEPENDENT = 5e-6
"""Of the largest; shorter combinations of rows, each of length one, count as none (GD19)."""
DOUBTFUL = 1e3
"""Rows that can be this much longer than a combination of them ask for a decision on the rank."""


class LeastSolution:
    """x of least length with `rows` (m, n) times `weights` (n,) times x equal to what is wanted.

    Whether rows depend on each other is decided without the weights, but with each column times its
    `reach` (n,): so that heavy bodies beside light ones do not make joints look alike.
    """

    def __init__(self, rows: Array, weights: Array, reach: Array) -> None:
        self._weighted = rows * weights
        self._scale = _inverse_lengths(self._weighted)
        self._count = len(rows)
        self._combinations: Array | None = None
        self.dropped = np.zeros((self._count, 0))
        """Combinations of rows (m, d) that count as none."""
        if not self._factorised(self._weighted * self._scale[:, None]):
            self._decide(rows * reach)

    @property
    def rank(self) -> int:
        """How many rows do not depend on others."""
        return self._count - self.dropped.shape[1]

    def _factorised(self, rows: Array) -> bool:
        """Factorise rows, unless some may depend on others."""
        if len(rows) > rows.shape[1] or not self._scale.all():
            return False
        self._basis, triangle = np.linalg.qr(rows.T)
        if not np.diagonal(triangle).all():
            return False
        self._inverse = np.linalg.inv(triangle)
        return bool(np.einsum("ij,ij->", self._inverse, self._inverse) < DOUBTFUL**2)

    def _decide(self, rows: Array) -> None:
        """Factorise those combinations of rows that do not count as none."""
        self._scale = _inverse_lengths(rows)
        left, sizes, _ = np.linalg.svd(rows * self._scale[:, None])
        kept = int((sizes > DEPENDENT * sizes.max(initial=0.0)).sum())
        self.dropped = left[:, kept:]
        self._combinations = left[:, :kept]
        reduced = self._combinations.T @ (self._weighted * self._scale[:, None])
        self._basis, triangle = np.linalg.qr(reduced.T)
        self._inverse = np.linalg.inv(triangle)

    def __call__(self, wanted: Array) -> Array:
        """Return x (n,)."""
        scaled = self._scale * wanted
        if self._combinations is not None:
            scaled = self._combinations.T @ scaled
        x: Array = self._basis @ (self._inverse.T @ scaled)
        return x

    def within(self, rows: Array, wanted: Array) -> Array:
        """Return the x (n,) made of its own rows that other weighed rows (m, n) map to wanted."""
        shares: Array = np.linalg.lstsq(rows @ self._basis, wanted)[0]
        x: Array = self._basis @ shares
        return x

    def shares(self, x: Array) -> Array:
        """Return the least weights (m,) with which the rows add up to a solution x."""
        found = self._inverse @ (self._basis.T @ x)
        if self._combinations is not None:
            found = self._combinations @ found
        shares: Array = self._scale * found
        return shares

    def missed(self, wanted: Array) -> float:
        """Return the largest that is wanted of combinations that count as none."""
        return float(np.abs(self.dropped.T @ (self._scale * wanted)).max(initial=0.0))

    def size(self, wanted: Array) -> float:
        """Return the largest that is wanted of rows of length one."""
        return float(np.abs(self._scale * wanted).max(initial=0.0))

    @property
    def dependent_rows(self) -> list[int]:
        """The rows that stand in combinations that count as none."""
        share = np.abs(self.dropped).max(axis=1, initial=0.0)
        rows: list[int] = np.flatnonzero(share > 1e-3).tolist()
        return rows


def _inverse_lengths(rows: Array) -> Array:
    """Return one over the length of each row; zero for a row of zeros."""
    length = np.sqrt(np.einsum("ij,ij->i", rows, rows))
    inverse: Array = np.divide(1.0, length, out=np.zeros_like(length), where=length > 0)
    return inverse
