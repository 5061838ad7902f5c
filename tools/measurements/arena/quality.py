"""How well an engine holds what lies and stands.

Serves: the measurement of contacts. Hides: when and where it is looked at.
"""

from dataclasses import dataclass

import numpy as np

from tamias2d.scene import Scene
from tamias2d.study.engines.engine import Maker
from tamias2d.study.engines.overlap import worst
from tools.measurements.arena.race import TIME_STEP

_EVERY = 10  # steps between two looks at overlaps
_LAST = 60  # steps, in which they are looked at


@dataclass(frozen=True)
class Quality:
    """Of one engine on one scene."""

    sag: float | None
    """How far the highest body is below its place at the start at the end, m."""
    penetration: float
    """The worst in the last second, m."""
    relative_penetration: float
    """The same as a share of the radius of the largest circle in the smaller body."""
    speed_at_end: float
    """The largest, m/s."""


def quality(make: Maker, scene: Scene, *, steps: int, stands: bool) -> Quality:
    """Run a scene and judge its end; `stands` says that its top belongs where it is."""
    engine = make(scene, TIME_STEP)
    depth = share = 0.0
    for step in range(1, steps + 1):
        engine.step()
        if step > steps - _LAST and (steps - step) % _EVERY == 0:
            seen = worst(scene, engine.state())
            depth, share = max(depth, seen.depth), max(share, seen.share)
    state = engine.state()
    moving = np.array([body.dynamic for body in scene.bodies])
    top = max(range(len(scene)), key=lambda k: (moving[k], scene.bodies[k].position[1]))
    return Quality(
        sag=float(scene.bodies[top].position[1] - state[top, 1]) if stands else None,
        penetration=depth,
        relative_penetration=share,
        speed_at_end=float(np.hypot(*state[moving, 3:5].T).max()),
    )
