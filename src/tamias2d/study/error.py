"""How far apart two histories of one scene are: the measure in which errors are stated."""

import math
from typing import Protocol

import numpy as np

from tamias2d.generated import definitions
from tamias2d.run import Run
from tamias2d.scene import Body, Scene
from tamias2d.state import Array
from tamias2d.study.looks import looked_at

MEASURE = "distance of any point of any body from its exact place, at any time of the history"


_ACROSS = 2.0  # times its distance from the centre a point gets by turning, at most
_STILL = 2.0**-40  # of the size of a body
_ROUNDING = 2.0**-46  # of a place: what solutions of a structure that stands leave


class Placed(Protocol):
    """Whatever says where bodies are: a run, or a history."""

    @property
    def position(self) -> Array:
        """(k, n, 2), m"""

    @property
    def orientation(self) -> Array:
        """(k, n), rad"""


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


def scale(run: Run) -> float:
    """Return how far the farthest moving body goes during a run, m; errors are relative to it.

    It is the same whatever samples a run has, as long as it has those at which it is looked at.
    Where nothing moves but by rounding, it is the size of the largest body, and of particles 1 m.
    """
    moving = [body.dynamic for body in run.scene.bodies]
    rows = looked_at(run)
    seen = run.position if rows is None else run.position[rows]
    place = float(np.abs(seen[:, moving]).max(initial=0.0))
    return scale_of(run.scene, path_length(run), place)


def scale_of(scene: Scene, far: float, place: float) -> float:
    """Return the scale of a motion that goes `far`, m; its largest coordinate is `place`, m."""
    size = float(radii(scene).max(initial=0.0))
    return far if far > max(_STILL * size, _ROUNDING * place) else size or 1.0


def path_length(run: Run) -> float:
    """Return how far the body goes that goes farthest, m.

    It is the diagonal of the box around its path, and how far its outermost point gets by turning.
    """
    rows = looked_at(run)
    seen = slice(None) if rows is None else rows
    span = np.ptp(run.position[seen], axis=0)
    turned = swung(np.ptp(run.orientation[seen], axis=0), radii(run.scene))
    return float((np.hypot(span[:, 0], span[:, 1]) + turned).max(initial=0.0))


def swung(turned: Array, reach: Array) -> Array:
    """Return how far points get by turning, m: no farther than twice their distance, the reach."""
    ways: Array = np.minimum(turned, _ACROSS) * reach
    return ways


def radii(scene: Scene) -> Array:
    """Return (n,), m: how far each body that moves reaches from its centre; 0 for a particle.

    Of one without a shape that can turn it is the radius of gyration.
    """
    return np.array([_radius(body) if body.dynamic else 0.0 for body in scene.bodies])


def _radius(body: Body) -> float:
    if body.shape is not None:
        return body.shape.bounding_radius
    if not math.isfinite(body.inertia):
        return 0.0
    return float(definitions.gyration_radius(1 / body.mass, 1 / body.inertia))


def history_error(run: Run, exact: Run) -> float:
    """Return the error of a whole run, relative to the scale of the exact one."""
    worst = float(apart(run, exact).max())
    return worst / scale(exact) if math.isfinite(worst) else math.inf
