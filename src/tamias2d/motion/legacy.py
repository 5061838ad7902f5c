"""The scheme of the 2018 program, kept to reproduce its published tables."""

from dataclasses import dataclass

import numpy as np

from tamias2d.generated import schemes
from tamias2d.motion.fixed_steps import grid
from tamias2d.motion.integrated import history_of
from tamias2d.motion.loads import Loads, coordinates, start_states
from tamias2d.motion.method import Method
from tamias2d.scene import Scene
from tamias2d.scene.joints import refuse_joints
from tamias2d.state import Array, History
from tamias2d.suggestions import suggests


@suggests
@dataclass(frozen=True)
class Legacy2018(Method):
    """What the 2018 program did, wrong as it was: for scenes in which nothing meets.

    Its scheme has no path between the ends of steps, so that no impact can be located.
    """

    fixed_step = True

    def history(self, scene: Scene, duration: float, time_step: float) -> tuple[Array, History]:
        """Return the times (k,) of all steps, s, and the states at them.

        The scheme remembers the acceleration of the step before, which is 0 before the first.
        """
        refuse_joints(scene.joints, f"method {self}", "Take Reference(), or none.")
        times = grid(duration, time_step)
        moving = [i for i, body in enumerate(scene.bodies) if body.dynamic]
        field = Loads(scene).field(moving, [None] * len(moving))
        q, rate = coordinates(start_states(scene))
        rows = np.repeat(np.stack((q, rate))[None], len(times), axis=0)
        q, rate = q[moving], rate[moving]
        before = np.zeros_like(q)
        for k in range(1, len(times)):
            now = field(float(times[k - 1]), q, rate)
            q, rate = _step(float(times[k] - times[k - 1]), q, rate, before, now)
            rows[k, 0, moving], rows[k, 1, moving] = q, rate
            before = now
        return times, history_of(rows)


def _step(h: float, q: Array, rate: Array, before: Array, now: Array) -> tuple[Array, Array]:
    translated = schemes.legacy_2018_translation(
        h, q[:, :2], rate[:, :2], before[:, :2], now[:, :2]
    )
    rotated = schemes.legacy_2018_rotation(h, q[:, 2:], rate[:, 2:], before[:, 2:], now[:, 2:])
    position, velocity = (
        np.concatenate(pair, axis=1) for pair in zip(translated, rotated, strict=True)
    )
    return position, velocity
