"""Where ever shorter steps lead, in a scene whose contacts are stepped, and how surely.

Steps of different lengths fall differently about impacts, and what several contacts leave open at
once is decided by how often they are gone through, or by less than can be known of the start. So
four runs are compared, which differ in their steps by less than an octave, in their substeps, and
in their starts by next to nothing: as far as they agree the answer has converged. From the horizon
on they do not, and no step is short enough to say where single bodies are.
"""

import math
import warnings
from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from tamias2d.errors import InputError, SimulationError
from tamias2d.scene import Scene
from tamias2d.scene.acting import varying_loads
from tamias2d.scene.other_bodies import with_bodies
from tamias2d.simulator import states_at
from tamias2d.simulator.stepper import SAME_STEP
from tamias2d.state import Array, History
from tamias2d.study.companion import RefusedError
from tamias2d.study.error import distance
from tamias2d.study.scale import Length, radii, size, ways

_RUNS = ((1.0, 1.0), (1.25, 1.5), (1.5, 3.0), (2.0, 2.0))
"""How many steps and substeps they have for one of the first. The last has the shortest steps."""
_TRUSTED = 3.0
"""Times as far as these runs are apart they may be from where ever shorter steps lead: at order 1
the last one is once as far from it as from the first, at order 1/2 two and a half times."""
_NUDGE = 1e-9
"""Of the largest radius: by how much the starts of all runs but the last one are moved."""
SUBSTEPS = 4
_PER_STEP, _PER_LAW = 400.0, 2000.0
"""The same of a whole step, and of one under laws, which are not compiled: all that few bodies
cost."""
_OVERHEAD = 4
"""Substeps that the rest of a step costs as much as, measured on piles and stacks."""


@dataclass(frozen=True)
class Refined:
    """What runs of short steps say of a scene."""

    scene: Scene
    times: Array
    """(k,), s"""
    time_step: float
    """The shortest, s"""
    substeps: int
    """Of these"""
    finest: History
    """With the shortest steps"""
    doubt: Array
    """(k,), m: how far it may be, up to each time, from where ever shorter steps lead"""
    way: Array
    """(k,), m: how far the farthest body goes up to each time"""
    sinks: NDArray[np.bool_]
    """(k,): whether it moves only because steps let it sink in"""
    work: float
    """Of all of them, as `work_of` counts it"""
    steps: int
    """Of all of them"""

    @property
    def length(self) -> Array:
        """(k,), m: what errors up to each time are relative to"""
        return np.where(self.sinks, size(self.scene), self.way)

    @property
    def share(self) -> float:
        """How far the finest may be off over the whole time, relative to the length."""
        return float(self.doubt[-1] / self.length[-1])

    @property
    def whole(self) -> Length:
        """What errors over the whole time are relative to."""
        return Length(float(self.length[-1]), not self.sinks[-1])

    def agreed(self, share: float) -> int:
        """Return the last sample up to which the doubt is no more than a share of the length.

        Before it there may be some at which less has moved, and the same doubt is more.
        """
        return int(np.flatnonzero(self.doubt <= share * self.length).max(initial=0))

    def horizon(self, share: float) -> float | None:
        """Return the time, s, from which on the doubt is more than a share of the length."""
        last = self.agreed(share)
        return float(self.times[last + 1]) if last + 1 < len(self.times) else None

    def after(self, before: "Refined") -> "Refined":
        """Return what is said, trusted no more than the runs of longer steps before it.

        Four runs may agree by chance, as those of a brick whose corners meet the floor one just
        after the other; eight by two lengths of steps hardly do.
        """
        apart = distance(self.scene, self.finest, before.finest)
        doubt = np.maximum(before.doubt, _TRUSTED * np.maximum.accumulate(apart))
        return replace(self, doubt=np.maximum(self.doubt, doubt), sinks=self.sinks & before.sinks)

    def bound(self, history: History) -> float:
        """Return how far a history of the same times may be from where steps lead, m."""
        return float((distance(self.scene, history, self.finest) + self.doubt).max(initial=0.0))


def refined(
    scene: Scene,
    *,
    duration: float,
    times: Array,
    time_step: float,
    grid: float,
    substeps: int = SUBSTEPS,
) -> Refined:
    """Return what runs from a time step, s, to half of it say of a scene at times (k,), s.

    Their steps divide those of a grid, s, so that at times on the grid all of them have ends of
    steps: between these, nothing is known of an impact.

    Raises:
        RefusedError: one of them goes beyond float64.
    """
    parts = [math.ceil(more * grid / time_step - SAME_STEP) for more, _ in _RUNS]
    settings = [
        (grid / many, round(substeps * sub)) for many, (_, sub) in zip(parts, _RUNS, strict=True)
    ]
    starts = [*(nudged(scene, k) for k in range(1, len(_RUNS))), scene]
    found = [
        stepped(start, duration, times, *setting)
        for start, setting in zip(starts, settings, strict=True)
    ]
    apart = np.max([distance(scene, one, other) for one, other in combinations(found, 2)], axis=0)
    return Refined(
        scene,
        times,
        *settings[-1],
        found[-1],
        _TRUSTED * np.maximum.accumulate(apart),
        *ways(scene, found[0], found[-1]),
        sum(work_of(scene, duration, *setting) for setting in settings),
        sum(math.ceil(duration / step) for step, _ in settings),
    )


def refinements(
    scene: Scene,
    *,
    duration: float,
    times: Array,
    time_step: float,
    work: float,
    per_step: float = 0.0,
) -> Iterator[Refined]:
    """Yield what ever shorter steps say, each time half as long, as far as some work goes.

    All of them divide the first time step, s. Besides their substeps of one body, steps may be
    said to cost as many each.

    Raises:
        RefusedError: the first runs go beyond float64.
    """
    grid = time_step
    while True:
        found = refined(scene, duration=duration, times=times, time_step=time_step, grid=grid)
        work -= (effort := found.work + per_step * found.steps)
        yield found
        if work < 2 * effort:
            return
        time_step /= 2


def stepped(
    scene: Scene, duration: float, times: Array, time_step: float, substeps: int
) -> History:
    """Return the states at times (k,), s, without contacts; raise `RefusedError` if there are none.

    What is warned of is told with the run itself.
    """
    with warnings.catch_warnings(), np.errstate(all="ignore"):
        warnings.simplefilter("ignore")
        try:
            return states_at(
                scene, time_step=time_step, substeps=substeps, times=times, duration=duration
            )
        except (InputError, SimulationError) as fault:
            raise RefusedError(str(fault)) from fault


def nudged(scene: Scene, phase: int, share: float = _NUDGE) -> Scene:
    """Return a scene whose bodies start elsewhere by a share of the largest radius."""
    by = share * float(radii(scene).max(initial=0.0))
    bodies = []
    for k, body in enumerate(scene.bodies):
        x, y, turn = (by * math.cos(phase + 2.4 * n + 14.4 * k) for n in range(3))
        place = (body.position[0] + x, body.position[1] + y)
        turned = body.orientation + turn / (by / share or 1.0)
        bodies.append(replace(body, position=place, orientation=turned) if body.dynamic else body)
    return with_bodies(scene, bodies)


def work_of(scene: Scene, duration: float, time_step: float, substeps: int) -> float:
    """Return what a run costs, in substeps of one body."""
    moving = sum(body.dynamic for body in scene.bodies)
    return moving * math.ceil(duration / time_step) * (_OVERHEAD + substeps)


def step_alone(scene: Scene) -> float:
    """Return what a step costs whatever its bodies and substeps, in substeps of one body."""
    return _PER_LAW if varying_loads(scene) else _PER_STEP
