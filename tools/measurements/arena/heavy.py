"""How many substeps it takes to carry a weight on a stack.

Serves: the measurement of contacts. Hides: what standing means.
"""

import numpy as np

from tools.measurements.arena.own import Own
from tools.measurements.arena.race import TIME_STEP
from tools.measurements.arena.scenes import heavy_column

RATIOS = (100.0, 1000.0)
_BOXES = 10
_SUBSTEPS = (4, 8, 16, 32, 64, 128)
_STEPS = 600
_STILL = 1e-2  # m/s
_ASIDE = 0.1  # m, of unit boxes


def substeps_to_stand() -> dict[str, int | None]:
    """Return, by the mass of the top box over the others', with how few substeps ten boxes stand.

    They stand if after 10 s nothing moves and each is above the one below it; None: they never
    do.
    """
    return {
        f"{ratio:g}": next((count for count in _SUBSTEPS if _stands(ratio, count)), None)
        for ratio in RATIOS
    }


def _stands(ratio: float, substeps: int) -> bool:
    engine = Own(heavy_column(_BOXES, ratio), TIME_STEP, substeps)
    for _ in range(_STEPS):
        engine.step()
    boxes = engine.state()[1:]
    still = np.hypot(boxes[:, 3], boxes[:, 4]).max() < _STILL
    return bool(still and np.abs(boxes[:, 0]).max() < _ASIDE and (np.diff(boxes[:, 1]) > 0.5).all())
