"""Work and precision: the error and the cost of each candidate.

A candidate that fails or refuses is a point too, with its reason. Where there are impacts, errors
are medians over an ensemble of phases, with the worst beside them.
"""

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from statistics import median
from time import thread_time

import numpy as np

from tamias2d.cost import Cost
from tamias2d.errors import TamiasError
from tamias2d.motion import ClosedForm
from tamias2d.scene import Scene
from tamias2d.scene.reach import pairs_that_can_meet
from tamias2d.solve.located import are_many
from tamias2d.study.candidates import Candidate, candidates
from tamias2d.study.event_errors import Errors, errors
from tamias2d.study.front import front
from tamias2d.study.phases import LEAST, over_phases, phases
from tamias2d.study.sampled import sampled
from tamias2d.study.schedule import DEAREST, Schedule
from tamias2d.study.truth import Truth, affordable_phases, common_times, floor_of, truth_of

_FIRST = 16  # steps
_RUNGS, _RUNGS_OF_IMPACTS = 9, 7  # each of twice the steps of the one before
_PARTS = 1 / 64, 1 / 16  # of the duration, which tell what the whole takes
_REPEATS = 5
_LONG = 0.5  # s: what the timing of a point may take, but for its first run
_ROUNDING = 1e-12  # relative: where errors get there, a finer setting can only cost more
_LOST = 1.0  # relative: an error beyond it says only that the run is wrong


@dataclass(frozen=True)
class Seconds:
    """Of the processor for one run, after one that is not counted. They differ each time."""

    median: float
    minimum: float
    repeats: int


@dataclass(frozen=True, kw_only=True)
class Point:
    """One method with one setting on a scene."""

    method: str
    setting: str
    peer: bool
    """Whether it is another engine: shown, but not on the front."""
    error: Errors | None = None
    """The median of each measure over the phases; None if the candidate failed."""
    worst: Errors | None = None
    """The largest of each measure over the phases."""
    cost: Cost | None = None
    seconds: Seconds | None = None
    failure: str | None = None
    """Why there is no error."""

    @property
    def valid(self) -> bool:
        """Whether it has an error that says something."""
        return self.error is not None and self.error.size <= _LOST


@dataclass(frozen=True)
class Study:
    """All points of a scene, as far as they were computed."""

    scene: str
    duration: float
    truth: str
    """What errors are against."""
    floor: float
    """No error below it means anything."""
    phases: int
    impacts: int
    points: tuple[Point, ...]
    complete: bool
    """Whether nobody stopped it."""

    @property
    def fastest(self) -> list[int]:
        """The points on the front of seconds and error, from cheap to dear."""
        return self._front(lambda point: point.seconds.minimum if point.seconds else math.inf)

    @property
    def leanest(self) -> list[int]:
        """The points on the front of force evaluations and error: the same on every machine."""
        return self._front(
            lambda point: float(point.cost.force_evaluations) if point.cost else math.inf
        )

    def _front(self, cost: Callable[[Point], float]) -> list[int]:
        own = [k for k, point in enumerate(self.points) if point.valid and not point.peer]
        pairs = [(cost(self.points[k]), max(_size(self.points[k]), self.floor)) for k in own]
        return [own[k] for k in front(pairs)]


ProgressHook = Callable[[int, int, str], None]
"""Hears how many points there are, how many are done, and which comes next."""


def study(
    scene: Scene,
    *,
    duration: float,
    phases_asked: int = LEAST,
    told: ProgressHook = lambda of, done, what: None,  # noqa: ARG005
    timed: bool = True,
) -> Study:
    """Compare all methods and settings on a scene over a duration in s.

    Fewer phases than are asked for are studied where these would take minutes. Ctrl-C ends it
    early; the points that are there by then are returned, if there are any.

    Raises:
        InputError: the number of phases is not 1 or more.
        SceneError, SimulationError: nothing is known to compare with, and why.
        ToleranceError: to know it would take minutes; it says for how short a run it would not.
        KeyboardInterrupt: it was stopped before its first point.
    """
    most = phases_asked if pairs_that_can_meet(scene, duration) else 1
    most = affordable_phases(scene, duration, most)
    first = truth_of(scene, duration)
    impacts = first.history.run.impacts
    floor = floor_of(first)
    count = most if len(impacts) else 1
    start = float(impacts.time[0]) if len(impacts) else 0.0
    scenes = phases(scene, duration, count, first_impact=start)
    truths = [first]
    points: dict[int, Point] = {}
    complete = True
    try:
        truths += [truth_of(other, duration) for other in scenes[1:]]
        for place, point in _points(scenes, truths, floor, told, timed):
            points[place] = point
    except KeyboardInterrupt:
        if not points:
            raise
        complete = False
    return Study(
        scene=scene.name,
        duration=duration,
        truth=first.how,
        floor=floor,
        phases=len(scenes),
        impacts=len(impacts),
        points=tuple(points[place] for place in sorted(points)),
        complete=complete,
    )


def _points(
    scenes: Sequence[Scene], truths: Sequence[Truth], floor: float, told: ProgressHook, timed: bool
) -> Iterator[tuple[int, Point]]:
    """Yield points, and where they belong: in the order of the candidates."""
    rungs = _RUNGS_OF_IMPACTS if len(truths[0].history.run.impacts) else _RUNGS
    tried = list(candidates(scenes[0], rungs=[_FIRST * 2**k for k in range(rungs)]))
    schedule = Schedule(tried)
    begun: set[str] = set()
    for done, (place, refused) in enumerate(schedule):
        candidate = tried[place]
        told(len(tried), done, f"{candidate.name} {candidate.setting}".strip())
        if refused is None and candidate.name not in begun:
            begun.add(candidate.name)
            if refused := _too_long(candidate, scenes[0], truths[0], len(scenes)):
                schedule.leave(place)
        if refused is not None:
            yield place, replace(_bare(candidate), failure=refused)
            continue
        began = thread_time()
        point = point_of(candidate, scenes, truths, timed=timed)
        schedule.took(place, thread_time() - began, failed=point.failure is not None)
        if point.worst and point.worst.size <= max(10 * floor, _ROUNDING):
            schedule.leave(place)
        yield place, point


def _too_long(candidate: Candidate, scene: Scene, truth: Truth, phases: int) -> str | None:
    """Return why a method is not run, if parts of a run tell that one point would take too long."""
    duration = truth.history.run.duration
    followed = candidate.peer or candidate.name == ClosedForm.__name__
    if not followed and are_many(scene) and pairs_that_can_meet(scene, duration):
        return "not run: so many bodies that may meet are followed by the closed form only"
    runs = 2 * phases + 1
    took: list[float] = []
    for part in _PARTS:
        began = thread_time()
        try:
            candidate.run(scene, part * duration, [part * duration])
        except (TamiasError, ArithmeticError):
            return None  # the point tells of that
        took.append(thread_time() - began)
        if took[-1] / part * runs <= DEAREST:
            return None
    each = took[0] + (took[1] - took[0]) / (
        _PARTS[1] - _PARTS[0]
    )  # what steps alone take is no more
    if runs * each <= DEAREST:
        return None
    return (
        f"not run: it would take about {runs * each:.2g} s or more, and a point at most "
        f"{DEAREST:g} s"
    )


def _bare(candidate: Candidate) -> Point:
    return Point(method=candidate.name, setting=candidate.setting, peer=candidate.peer)


def point_of(
    candidate: Candidate, scenes: Sequence[Scene], truths: Sequence[Truth], *, timed: bool
) -> Point:
    """Run one candidate on all phases of a scene, and time it on the first."""
    duration = truths[0].history.run.duration
    bare = _bare(candidate)
    try:
        with np.errstate(all="ignore"):  # what leaves float64 is a failure with its reason
            looked = [
                _look(candidate, scene, truth) for scene, truth in zip(scenes, truths, strict=True)
            ]
            seconds = _timed(candidate, scenes[0], duration) if timed else None
    except (TamiasError, ArithmeticError) as fault:
        return replace(bare, failure=str(fault))
    found = [errors for errors, _ in looked]
    return replace(
        bare,
        error=over_phases(found, median),
        worst=over_phases(found, max),
        cost=looked[0][1],
        seconds=seconds,
    )


def _look(candidate: Candidate, scene: Scene, truth: Truth) -> tuple[Errors, Cost | None]:
    duration = truth.history.run.duration
    first = candidate.run(scene, duration, [duration])
    run = sampled(
        lambda times: candidate.run(scene, duration, times), common_times(duration), first.impacts
    )
    return errors(run, truth.history), first.cost


def _timed(candidate: Candidate, scene: Scene, duration: float) -> Seconds:
    """Time runs that are sampled at their end only; the errors have warmed them up."""
    times: list[float] = []
    while len(times) < _REPEATS and sum(times) < _LONG:
        began = thread_time()
        candidate.run(scene, duration, [duration])
        times.append(thread_time() - began)
    return Seconds(median(times), min(times), len(times))


def _size(point: Point) -> float:
    return point.error.size if point.error else math.inf
