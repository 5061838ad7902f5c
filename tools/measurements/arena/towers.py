"""How many substeps it takes for a tower to stand.

Serves: the measurement of contacts. Hides: what standing means.

Where contacts give way like springs a tower bends under its weight like a rod, and buckles if it is
too high or too heavy; more substeps are stiffer springs.
"""

import numpy as np

from tamias2d.scene import Scene
from tamias2d.study.engines.own import Own
from tools.measurements.arena.race import TIME_STEP
from tools.measurements.arena.scenes import column, heavy_column

TOWERS = {
    "Ten boxes, of which the highest has 100 times the mass of others,": heavy_column(10, 100.0),
    "Ten boxes, of which the highest has 1000 times the mass of others,": heavy_column(10, 1000.0),
    "A hundred boxes": column(100),
}
_SUBSTEPS = (4, 8, 16, 32, 64, 128)
_STEPS = 600
_STILL = 1e-2  # m/s
_ASIDE = 0.1  # m, of unit boxes
_ABOVE = 0.5  # m, from a box to the next


def substeps_to_stand() -> dict[str, int | None]:
    """Return with how few substeps each tower stands, by what it is; None if it never does.

    It stands if after 10 s nothing moves and each box is above the one below it.
    """
    return {
        name: next((count for count in _SUBSTEPS if _stands(tower, count)), None)
        for name, tower in TOWERS.items()
    }


def _stands(tower: Scene, substeps: int) -> bool:
    engine = Own(tower, TIME_STEP, substeps)
    for _ in range(_STEPS):
        engine.step()
    boxes = engine.state()[1:]
    still = np.hypot(boxes[:, 3], boxes[:, 4]).max() < _STILL
    straight = np.abs(boxes[:, 0]).max() < _ASIDE and (np.diff(boxes[:, 1]) > _ABOVE).all()
    return bool(still and straight)
