"""The least combination of rows of which some only push, or only so hard (GD21, GD22)."""

import numpy as np
from numpy.typing import NDArray

from tamias2d.state import Array

_LEAST = 1e-6
"""The weight of the shares themselves: of all that add up to the same, the least are found."""


def bounded_shares(
    rows: Array, wanted: Array, lower: Array, upper: Array
) -> tuple[Array, NDArray[np.intp]]:
    """Return weights (m,) of rows (m, n) within bounds, and which bounds (m,) they are at.

    What the weighted rows add up to, x, is as near as it can be to the least x with `rows` times x
    equal to what is `wanted` (m,). A weight is at its lower bound (-1), its upper (1) or between.
    """
    from scipy.optimize import lsq_linear

    if not len(rows):
        return np.zeros(0), np.zeros(0, np.intp)
    sizes = np.sqrt(np.einsum("ij,ij->i", rows, rows))
    scale = np.divide(1.0, sizes, out=np.zeros_like(sizes), where=sizes > 0)
    scaled = rows * scale[:, None]
    aim = np.linalg.lstsq(scaled, wanted * scale, rcond=1e-12)[0]
    if not np.isfinite(lower).any() and not np.isfinite(upper).any():
        found = np.linalg.lstsq(scaled.T, aim, rcond=1e-12)[0]
        return found * scale, np.zeros(len(rows), np.intp)
    with np.errstate(invalid="ignore"):
        bounds = (
            np.where(lower == 0, 0.0, lower * sizes),
            np.where(upper == 0, 0.0, upper * sizes),
        )
    tall = np.vstack([scaled.T, _LEAST * np.eye(len(rows))])
    far = np.concatenate([aim, np.zeros(len(rows))])
    best = lsq_linear(tall, far, bounds, method="bvls", tol=1e-14, max_iter=100 * len(rows))
    return best.x * scale, best.active_mask.astype(np.intp)


def bounded_sum(rows: Array, inverse: Array, wanted: Array, lower: Array) -> tuple[Array, Array]:
    """Return the changes (n, 3) that rows (m, 3 n) make, and their shares (m,), at least `lower`.

    `inverse` (n, 3) are inverse masses and inertias; `lower` is 0 or without end. With those that
    are not 0 the changes are computed to rounding.
    """
    weights = np.sqrt(inverse).ravel()
    weighed = rows * weights
    shares, at = bounded_shares(weighed, wanted, lower, np.full(len(rows), np.inf))
    pushing = at == 0
    total = np.linalg.lstsq(weighed[pushing], wanted[pushing], rcond=1e-12)[0]
    shares = np.zeros(len(rows))
    shares[pushing] = np.linalg.lstsq(weighed[pushing].T, total, rcond=1e-12)[0]
    return (weights * total).reshape(inverse.shape), shares
