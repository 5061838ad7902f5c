"""The length that errors of places are relative to: how far the bodies go that forces move.

What is kinematic moves as it is told and has no error, so that its way sets no length: the error of
a parcel is not small because a tram passes by.
"""

import math
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from tamias2d.generated import definitions
from tamias2d.run import Run
from tamias2d.scene import Body, Scene
from tamias2d.state import Array
from tamias2d.study.looks import looked_at

_ACROSS = 2.0  # times its distance from the centre a point gets by turning, at most
_STILL = 2.0**-40  # of the size of a body
_ROUNDING = 2.0**-46  # of a place: what solutions of a structure that stands leave
_SUNK = 1e-2  # of the size: what goes farther moves
_SINKS = 2.0
"""Times less, at least, what rests sinks in by steps half as long: single bodies by the square of
the substep, a house of cards two to three times. A way to which steps add what is of first order in
them is never so much less."""


class Placed(Protocol):
    """Whatever says where bodies are: a run, or a history."""

    @property
    def position(self) -> Array:
        """(k, n, 2), m"""

    @property
    def orientation(self) -> Array:
        """(k, n), rad"""


class Length(NamedTuple):
    """What errors of a motion are divided by."""

    metres: float
    moves: bool
    """Whether some body goes so far; else it is a size, in place of a way that there is not."""


def scale(run: Run) -> float:
    """Return the length that errors of a run are relative to, m."""
    return length_of(run).metres


def length_of(run: Run) -> Length:
    """Return how far the body goes that goes farthest, of those that forces move.

    It is the same whatever samples a run has, as long as it has those at which it is looked at.
    Where nothing moves but by rounding, it is the size of the largest body, and of particles 1 m.
    """
    moving = [body.dynamic for body in run.scene.bodies]
    rows = looked_at(run)
    seen: slice | NDArray[np.int64] = slice(None) if rows is None else rows
    states = np.concatenate((run.position[seen], run.orientation[seen, :, None]), axis=-1)
    place = float(np.abs(run.position[seen][:, moving]).max(initial=0.0))
    return _length(run.scene, float(farthest(run.scene, np.ptp(states, axis=0))), place)


def scale_of(scene: Scene, far: float, place: float) -> float:
    """Return the same, m, of a motion that goes `far`, m; its largest coordinate is `place`, m."""
    return _length(scene, far, place).metres


def ways(scene: Scene, longer: Placed, shorter: Placed) -> tuple[Array, NDArray[np.bool_]]:
    """Return (k,), m: how far the farthest body goes up to each time, and whether it only sinks in.

    Both are of runs by steps through contacts, and one has steps twice as long. What rests sinks
    into what holds it, and less by shorter steps: it goes nowhere if that is less than a hundredth
    of the size, and no more than half of what it is by the longer ones.
    """
    far, sunk = (_ways(scene, history) for history in (shorter, longer))
    moving = [body.dynamic for body in scene.bodies]
    place = float(np.abs(shorter.position[:, moving]).max(initial=0.0))
    sinks = (far <= _SUNK * size(scene)) & (_SINKS * far <= sunk)
    return far, sinks | (far <= _least(scene, place))


def farthest(scene: Scene, extent: Array) -> Array:
    """Return (...,), m: how far the body goes that goes farthest, by extents (..., n, 3).

    These are of coordinates, m, m and rad, of all bodies or of those that are dynamic. The way is
    the diagonal of the box around the path, and how far the outermost point gets by turning.
    """
    reach = reach_of(scene, extent.shape[-2])
    ways = np.hypot(extent[..., 0], extent[..., 1])
    ways = ways + np.minimum(np.abs(extent[..., 2]), _ACROSS) * reach
    if len(reach) == len(scene.bodies):
        ways = ways[..., [body.dynamic for body in scene.bodies]]
    found: Array = ways.max(axis=-1, initial=0.0)
    return found


def radii(scene: Scene) -> Array:
    """Return (n,), m: how far each body that moves reaches from its centre; 0 for a particle.

    Of one without a shape that can turn it is the radius of gyration.
    """
    return np.array([_radius(body) if body.dynamic else 0.0 for body in scene.bodies])


def reach_of(scene: Scene, count: int) -> Array:
    """Return (count,), m: the radii of all bodies, or of those that are dynamic."""
    reach = radii(scene)
    return reach if count == len(reach) else reach[[body.dynamic for body in scene.bodies]]


def _radius(body: Body) -> float:
    if body.shape is not None:
        return body.shape.bounding_radius
    if not math.isfinite(body.inertia):
        return 0.0
    return float(definitions.gyration_radius(1 / body.mass, 1 / body.inertia))


def _ways(scene: Scene, history: Placed) -> Array:
    """Return (k,), m: how far the farthest body has come up to each time."""
    states = np.concatenate((history.position, history.orientation[..., None]), axis=-1)
    low, high = (of.accumulate(states, axis=0) for of in (np.minimum, np.maximum))
    return farthest(scene, high - low)


def _length(scene: Scene, far: float, place: float) -> Length:
    moves = far > _least(scene, place)
    return Length(far if moves else size(scene), moves)


def _least(scene: Scene, place: float) -> float:
    """Return how far what stands seems to go by rounding, m."""
    return max(_STILL * float(radii(scene).max(initial=0.0)), _ROUNDING * place)


def size(scene: Scene) -> float:
    """Return how far the largest body reaches, m; 1 m if all are particles."""
    return float(radii(scene).max(initial=0.0)) or 1.0
