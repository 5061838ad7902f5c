"""How far apart two histories of one scene are: the measure in which errors are stated."""

import math

import numpy as np

from tamias2d.run import Run
from tamias2d.scene import Scene
from tamias2d.state import Array
from tamias2d.study.scale import Placed, radii, scale

MEASURE = "distance of any point of any body from its exact place, at any time of the history"


def apart(run: Run, other: Run) -> Array:
    """Return (k,), m: how far the worst point of all bodies is from its place in another run."""
    return distance(run.scene, run, other)


def distance(scene: Scene, one: Placed, other: Placed) -> Array:
    """Return (k,), m: how far the worst point of all bodies of a scene is from its other place.

    Both have the same times. A point of a body of some radius moves with its centre and turns
    around it.
    """
    moved = np.linalg.norm(one.position - other.position, axis=-1)
    turned = np.abs(one.orientation - other.orientation) * radii(scene)
    result: Array = (moved + turned).max(axis=1, initial=0.0)
    return result


def history_error(run: Run, exact: Run) -> float:
    """Return the error of a whole run, relative to the scale of the exact one."""
    worst = float(apart(run, exact).max())
    return worst / scale(exact) if math.isfinite(worst) else math.inf
