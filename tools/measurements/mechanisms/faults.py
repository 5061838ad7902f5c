"""What is wrong with steps of a mechanism: energy that it gains, and how far hinges are apart."""

import numpy as np

from tamias2d.scene import Scene
from tamias2d.state import Array
from tools.measurements.mechanisms.programs import hinges_of
from tools.measurements.mechanisms.scenes import G


class Energy:
    """The most that the energy of a scene has risen, as a share of all there was.

    `gain` is what it rose by in a step, `above` by how much it was above the first.

    What does not move has none but by rounding: at least what gravity gives in a millionth of the
    scene's size counts.
    """

    def __init__(self, scene: Scene) -> None:
        moving = [k for k, body in enumerate(scene.bodies) if body.dynamic]
        self._moving = np.array(moving)
        self._mass = np.array([scene.bodies[k].mass for k in moving])
        self._inertia = np.array([scene.bodies[k].inertia for k in moving])
        self._before: float | None = None
        self._start = self._size = self._first = 0.0
        self.gain = self.above = 0.0

    def look(self, places: Array, rates: Array) -> None:
        """Look at the state after a step: places (n, 3) and their rates (n, 3)."""
        places, rates = places[self._moving], rates[self._moving]
        moving = 0.5 * float(
            self._mass @ (rates[:, :2] ** 2).sum(axis=1) + self._inertia @ rates[:, 2] ** 2
        )
        height = G * float(self._mass @ places[:, 1])
        if self._before is None:
            self._before = self._first = moving + height
            self._start = height
            extent = float(np.ptp(places[:, :2], axis=0).max())
            self._size = 1e-6 * G * float(self._mass.sum()) * extent
        self._size = max(self._size, moving, abs(height - self._start))
        rise = moving + height - self._before
        if self._size > 0:
            self.gain = max(self.gain, rise / self._size)
            self.above = max(self.above, (moving + height - self._first) / self._size)
        self._before = moving + height


def apart(scene: Scene, state: Array) -> float:
    """Return by how much the worst hinge is apart, m."""
    poses = np.vstack((state[:, :3], np.zeros((1, 3))))
    hinges = hinges_of(scene)
    ends = np.array([[-1 if k is None else k for k in joint.ends[:2]] for joint in hinges])
    anchors = np.array([joint.anchors[:2] for joint in hinges])
    cosine, sine = np.cos(poses[ends][..., 2]), np.sin(poses[ends][..., 2])
    x = poses[ends][..., 0] + cosine * anchors[..., 0] - sine * anchors[..., 1]
    y = poses[ends][..., 1] + sine * anchors[..., 0] + cosine * anchors[..., 1]
    return float(np.hypot(x[:, 1] - x[:, 0], y[:, 1] - y[:, 0]).max())
