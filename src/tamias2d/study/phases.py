"""An ensemble of one scene: the same motion, started at instants spread over its first flight.

How a step falls about an impact is chance; one run says little. A later start shifts heights and
velocities of all bodies together, so that they neither overlap nor meet in another order.
"""

from collections.abc import Callable, Sequence
from dataclasses import fields, replace
from typing import TypeVar

import numpy as np

from tamias2d.errors import InputError
from tamias2d.run import Run
from tamias2d.scene import Scene
from tamias2d.scene.acting import timed_loads
from tamias2d.scene.other_bodies import with_bodies
from tamias2d.solve import solve
from tamias2d.state import State
from tamias2d.study.contact_errors import ContactErrors
from tamias2d.study.event_errors import Errors

LEAST = 32  # phases that the measure of a scene with impacts rests on
_GOLDEN = (5**0.5 - 1) / 2
_E = TypeVar("_E", Errors, ContactErrors)


def phases(scene: Scene, duration: float, count: int, *, first_impact: float) -> list[Scene]:
    """Return scenes that start at 0 s and at up to half of the time of the first impact, s.

    There is only the scene itself where it starts with an impact, or where loads follow the clock.
    """
    if count < 1:
        raise InputError(
            f"phases {count}: must be 1 or more. Give {LEAST} for scenes with impacts."
        )
    if count == 1 or timed_loads(scene) or not first_impact > 0:
        return [scene]
    shares = np.sort((np.arange(1, count) * _GOLDEN) % 1)
    starts = np.concatenate(([0.0], shares * min(first_impact, duration) / 2))
    run = solve(scene, duration=duration, times=starts)
    return [scene, *(started(run, k) for k in range(1, count))]


def started(run: Run, k: int) -> Scene:
    """Return the scene of a run, started in the state of its sample k."""
    bodies = []
    for i, body in enumerate(run.scene.bodies):
        x, y = run.position[k, i].tolist()
        u, v = run.velocity[k, i].tolist()
        state = State(
            (x, y), float(run.orientation[k, i]), (u, v), float(run.angular_velocity[k, i])
        )
        bodies.append(replace(body, **state._asdict()) if body.dynamic else body)
    return with_bodies(run.scene, bodies)


def over_phases(found: Sequence[_E], what: Callable[[list[float]], float]) -> _E:
    """Return each measure over the phases; None where it applies in none."""
    values = {}
    for name in (field.name for field in fields(found[0])):
        known = [value for one in found if (value := getattr(one, name)) is not None]
        values[name] = what(known) if known else None
    return type(found[0])(**values)  # type: ignore[arg-type]
