"""One call of a kernel that integrates the error of a path.

Serves: the steps of smooth motion, of free bodies and of those that joints hold. Hides: the rows of
numbers that kernels take.
"""

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from tamias2d.kernels.choice import Kernel
from tamias2d.kernels.march_call import Marched
from tamias2d.motion.marching import Error, Rule
from tamias2d.state import Array


def followed(
    owner: Marched,
    code: Kernel,
    compiled: Callable[..., int] | None,
    times: Sequence[float],
    paths: Array,
    rule: Rule,
    sweeps: int,
    error: Error,
    *,
    ends: Array | None = None,
) -> int:
    """Integrate an error over steps along their paths (k, 3, m, n, 3); return over how many.

    What joints hold is at the ends (k, 2, n, 3) of steps. Where these are not all, the error stays
    as it was, or is of no use.
    """
    axes, bodies = owner.axes, paths.shape[-2]

    def rows(part: Array) -> Array:
        return part[..., :axes].swapaxes(-1, -2).reshape(*part.shape[:-2], -1)

    state, largest = rows(error.state), rows(error.largest)
    work = np.zeros((len(rule.nodes), axes * bodies)), np.zeros((4, axes * bodies))
    numbers: list[Any] = [np.array(times), rows(paths), rule.nodes, rule.early, rule.whole]
    inputs: list[Any] = [*numbers, sweeps, state, largest, *work]
    inputs += [] if ends is None else [rows(ends)]
    if compiled is not None:
        done = compiled(*inputs, *owner.tables)
    else:
        inputs = [part if isinstance(part, int) else part.tolist() for part in inputs]
        try:
            done = code.plain(*inputs, *owner.lists)
        except (ArithmeticError, ValueError):
            return 0
        state, largest = np.array(inputs[6]), np.array(inputs[7])
    if ends is None or done == len(times) - 1:
        for whole, found in ((error.state, state), (error.largest, largest)):
            whole[..., :axes] = found.reshape(*found.shape[:-1], axes, bodies).swapaxes(-1, -2)
    return int(done)
