"""Normal forces and impulses, never negative: the linear complementarity problem."""

import numpy as np

from tamias2d.state import Array


def complementarity(a: list[list[float]], b: list[float]) -> list[float]:
    """Return x >= 0 with w = a x + b >= 0, and x w = 0 item by item.

    `a` is symmetric and positive semidefinite, as couplings are, and b in reach of a x; what x does
    to the bodies is then unique, even where x is not. Equal items of the problem have equal answers
    to the bit, for one or two. An item that nothing moves, as where joints hold it, is 0.
    """
    if len(moved := [k for k in range(len(b)) if a[k][k]]) < len(b):
        found = dict(zip(moved, complementarity(_of(a, moved), [b[k] for k in moved]), strict=True))
        return [found.get(k, 0.0) for k in range(len(b))]
    if not b:
        return []
    if len(b) == 1:
        return [max(-b[0] / a[0][0], 0.0)]
    if len(b) == 2:
        return _two(a, b)
    matrix = np.array(a)
    size = np.sqrt(np.diag(matrix))  # so that light and heavy bodies count alike
    scaled = _active_set(matrix / np.outer(size, size), np.array(b) / size)
    return [float(x) for x in scaled / size]


def _of(a: list[list[float]], chosen: list[int]) -> list[list[float]]:
    return [[a[k][m] for m in chosen] for k in chosen]


def _two(a: list[list[float]], b: list[float]) -> list[float]:
    (a11, a12), (_, a22) = a
    b1, b2 = b
    if b1 >= 0 and b2 >= 0:
        return [0.0, 0.0]
    scale = a11 * a22
    determinant = scale - a12 * a12
    if determinant > 1e-14 * scale:
        x1, x2 = (a12 * b2 - a22 * b1) / determinant, (a12 * b1 - a11 * b2) / determinant
        if x1 >= 0 and x2 >= 0:
            return [x1, x2]
    elif b1 == b2 and a11 == a22:  # both do the same: half each
        return [-b1 / (a11 + a12), -b1 / (a11 + a12)]
    if b1 < 0 and (b2 >= 0 or b2 - a12 * b1 / a11 >= -1e-15 * abs(b2)):
        return [-b1 / a11, 0.0]
    return [0.0, -b2 / a22]


def _active_set(a: Array, b: Array) -> Array:
    """Solve as non-negative least squares, one contact at a time (Lawson and Hanson)."""
    x = np.zeros_like(b)
    active = np.zeros(len(b), dtype=bool)
    small = 1e-13 * np.abs(b).max(initial=0.0)
    for _ in range(8 * len(b)):
        force = np.where(active, -np.inf, -(a @ x + b))
        if force.max() <= small:
            break
        active[int(force.argmax())] = True
        while active.any():
            trial = np.zeros_like(b)
            trial[active] = np.linalg.lstsq(a[np.ix_(active, active)], -b[active])[0]
            falling = active & (trial <= 0)
            if not falling.any():
                x = trial
                break
            step = np.min(x[falling] / (x[falling] - trial[falling]))
            x = x + step * (trial - x)
            active &= x > 0
            x[~active] = 0.0
    return x
