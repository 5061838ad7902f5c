"""Work and precision where contacts are stepped: steps and passes of this engine and of others.

The answer that places are compared with comes from ever shorter steps, and ends at the horizon.
Overlap and energy are judged all along, and means over an ensemble at the end. Runs are timed in
turns, in seconds of the processor, each after one that is not counted, and nothing is read.
"""

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from statistics import median
from time import thread_time

import numpy as np

from tamias2d.errors import TamiasError
from tamias2d.scene import Scene
from tamias2d.state import History
from tamias2d.study.companion import RefusedError
from tamias2d.study.contact_candidates import RATES, ContactCandidate, contact_candidates, follow
from tamias2d.study.contact_errors import NAMES, Answer, ContactErrors, contact_errors, statistics
from tamias2d.study.engines.own import Own
from tamias2d.study.engines.refusal import PeerError
from tamias2d.study.front import front
from tamias2d.study.refined import SUBSTEPS, Refined, nudged, refinements, stepped, work_of
from tamias2d.study.refusal import ToleranceError
from tamias2d.study.stepped_plan import aligned_step, ends_of_steps
from tamias2d.study.work_precision import ProgressHook, Seconds

_AGREED = 1e-3
"""Of the length: so well agree the runs that an answer comes from, up to the horizon."""
_WORK = 2e7  # substeps of one body that the answer may take; all candidates together take more
_DEAREST = 3e7  # the same for one candidate
_PHASES = 3e8  # the same for all runs of an ensemble
_FEWEST = 4  # runs of an ensemble, where as many are asked for
_NUDGE = 1e-6  # of the largest radius: by how much starts of an ensemble differ
_HEARD = 2000  # steps at most of a run that is asked for its contacts
_ROUNDS = 5
_LONG = 0.5  # s: what the timing of a point may take, but for its first run
_LOST = 1.0


@dataclass(frozen=True, kw_only=True)
class ContactPoint:
    """One engine with one setting on a scene."""

    method: str
    setting: str
    peer: bool
    steps: int
    passes: int
    """Of each step through the contacts: substeps, or iterations."""
    error: ContactErrors | None = None
    """The median of each measure over the phases; None if the candidate failed."""
    worst: ContactErrors | None = None
    statistics: dict[str, tuple[float, float]] | None = None
    """At the end, over the phases: means, and half the widths of their 95 % intervals."""
    seconds: Seconds | None = None
    failure: str | None = None

    @property
    def valid(self) -> bool:
        """Whether it has an error that says something."""
        return self.error is not None and self.error.size <= _LOST

    @property
    def sweeps(self) -> int:
        """How often the contacts are gone through."""
        return self.steps * self.passes


@dataclass(frozen=True)
class ContactStudy:
    """All points of a scene, as far as they were computed."""

    scene: str
    duration: float
    reason: str
    """Why contacts are stepped."""
    truth: str
    """What places are compared with."""
    floor: float
    """No error of places below it means anything."""
    horizon: float
    """s: up to there the runs that the answer comes from agree."""
    phases: int
    statistics: dict[str, tuple[float, float]]
    """At the end, of the answer's ensemble: means, and half the widths of their 95 % intervals."""
    points: tuple[ContactPoint, ...]
    complete: bool
    """Whether nobody stopped it."""

    @property
    def fastest(self) -> list[int]:
        """The points on the front of seconds and places, from cheap to dear."""
        return self._front(_seconds, lambda e: max(e.size, self.floor))

    @property
    def leanest(self) -> list[int]:
        """The points on the front of passes and places: the same on every machine."""
        return self._front(lambda p: float(p.sweeps), lambda e: max(e.size, self.floor))

    @property
    def soundest(self) -> list[int]:
        """The points on the front of seconds and quality: overlap and energy."""
        return self._front(_seconds, lambda e: e.quality)

    def _front(
        self, cost: Callable[[ContactPoint], float], size: Callable[[ContactErrors], float]
    ) -> list[int]:
        own = {
            k: (cost(point), size(point.error))
            for k, point in enumerate(self.points)
            if point.error is not None and not point.peer and cost(point) < math.inf
        }
        places = list(own)
        return [places[k] for k in front(list(own.values()))]


@dataclass(frozen=True)
class _Known:
    """The answer of each phase, and what is known of it."""

    refined: Refined
    scenes: tuple[Scene, ...]
    answers: tuple[Answer, ...]


def contact_study(
    scene: Scene,
    *,
    duration: float,
    reason: str,
    phases_asked: int,
    rates: Sequence[int] = RATES,
    told: ProgressHook = lambda of, done, what: None,  # noqa: ARG005
    timed: bool = True,
) -> ContactStudy:
    """Compare engines and settings on a scene whose contacts are stepped, over a duration in s.

    `rates` are those of steps in a second, where a run is long enough for them. Ctrl-C ends it
    early; the points that are there by then are returned, if there are any.

    Raises:
        ToleranceError: a run by short steps is refused, so that there is nothing to compare with.
        KeyboardInterrupt: it was stopped before its first point.
    """
    step = aligned_step(duration, np.array([duration]))
    tried = list(contact_candidates(scene, duration, coarsest=2 * step, most=_DEAREST, rates=rates))
    known = _known(scene, duration, step, _affordable(scene, duration, tried, phases_asked))
    points = [_located(reason)]
    complete = True
    try:
        for point in _points(tried, known, told):
            points.append(point)
        if timed:
            points[1:] = _timed(tried, points[1:], scene, duration, told)
    except KeyboardInterrupt:
        if len(points) == 1:
            raise
        complete = False
    first, refined = known.answers[0], known.refined
    within = first.times <= first.horizon
    return ContactStudy(
        scene=scene.name,
        duration=duration,
        reason=reason,
        truth=f"steps of {refined.time_step:.2g} s",
        floor=float(refined.doubt[within].max()) / first.length,
        horizon=first.horizon,
        phases=len(known.scenes),
        statistics=statistics(scene, [answer.history for answer in known.answers]),
        points=tuple(points),
        complete=complete,
    )


def _affordable(
    scene: Scene, duration: float, tried: Sequence[ContactCandidate], asked: int
) -> int:
    each = sum(work_of(scene, duration, one.time_step, one.passes) for one in tried)
    return min(asked, max(_FEWEST, int(_PHASES / (each + _WORK / 4))))


def _located(reason: str) -> ContactPoint:
    """Return the point of what cannot be done here, with the reason."""
    return ContactPoint(method="Located", setting="", peer=False, steps=0, passes=0, failure=reason)


def _known(scene: Scene, duration: float, step: float, phases: int) -> _Known:
    """Return what candidates are compared with, in each phase, at ends of steps, s.

    That are the shortest steps, and the horizon is theirs: where longer ones agreed for longer and
    these do not, the longer ones agreed by chance.
    """
    times = ends_of_steps(duration, step)
    try:
        *_, finest = refinements(scene, duration=duration, times=times, time_step=step, work=_WORK)
    except RefusedError as fault:
        raise ToleranceError(f"tradeoff: a run by short steps was refused: {fault}") from fault
    scenes = (scene, *(nudged(scene, k, _NUDGE) for k in range(1, phases)))
    last = _last_agreed(finest)
    horizon, length = float(times[last]), float(finest.length[last])
    step = finest.time_step
    histories = [finest.finest]
    histories += [stepped(other, duration, times, step, 2 * SUBSTEPS) for other in scenes[1:]]
    met = _first_contacts(scene, duration, max(step, duration / (2 * _HEARD)))
    answers = (Answer(history, times, horizon, length, met) for history in histories)
    return _Known(finest, scenes, tuple(answers))


def _last_agreed(found: Refined) -> int:
    """Return the last sample at which runs agree."""
    lost = np.flatnonzero(~(found.doubt <= _AGREED * found.length))
    return max(int(lost[0]) - 1, 1) if len(lost) else len(found.times) - 1


def _first_contacts(scene: Scene, duration: float, step: float) -> dict[tuple[int, int], float]:
    engine = Own(scene, step, 2 * SUBSTEPS, listens=True)
    engine.step(math.ceil(duration / step))
    return engine.met


def _points(
    tried: Sequence[ContactCandidate], known: _Known, told: ProgressHook
) -> Iterator[ContactPoint]:
    refused: dict[str, str] = {}
    for done, candidate in enumerate(tried):
        told(len(tried), done, f"{candidate.method} {candidate.setting}")
        duration = float(known.answers[0].times[-1])
        bare = ContactPoint(
            method=candidate.method,
            setting=candidate.setting,
            peer=candidate.peer,
            steps=candidate.steps(duration),
            passes=candidate.passes,
        )
        if candidate.method in refused:
            yield replace(bare, failure=refused[candidate.method])
            continue
        try:
            yield _point(bare, candidate, known)
        except PeerError as fault:
            refused[candidate.method] = str(fault)
            yield replace(bare, failure=str(fault))
        except (TamiasError, ArithmeticError) as fault:
            yield replace(bare, failure=str(fault))


def _point(bare: ContactPoint, candidate: ContactCandidate, known: _Known) -> ContactPoint:
    """Run a candidate in all phases; contacts and overlaps are looked at in the first."""
    found: list[ContactErrors] = []
    histories: list[History] = []
    for k, (scene, answer) in enumerate(zip(known.scenes, known.answers, strict=True)):
        with np.errstate(all="ignore"):
            seen = follow(
                candidate,
                scene,
                answer.times,
                listens=k == 0 and bare.steps <= _HEARD,
                looks=k == 0,
            )
            histories.append(seen.history)
            errors = contact_errors(scene, seen, answer)
            found.append(errors if k == 0 else replace(errors, overlap=found[0].overlap))
    return replace(
        bare,
        error=_over(found, median),
        worst=_over(found, max),
        statistics=statistics(known.scenes[0], histories),
    )


def _over(found: Sequence[ContactErrors], what: Callable[[list[float]], float]) -> ContactErrors:
    """Return each measure over the phases; None where it applies in none."""
    values = {}
    for name in NAMES:
        each = [value for one in found if (value := getattr(one, name)) is not None]
        values[name] = what(each) if each else None
    return ContactErrors(**values)  # type: ignore[arg-type]


def _timed(
    tried: Sequence[ContactCandidate],
    points: Sequence[ContactPoint],
    scene: Scene,
    duration: float,
    told: ProgressHook,
) -> list[ContactPoint]:
    """Time all candidates in turns: what slows the machine for a while slows all of them."""
    spent: list[list[float]] = [[] for _ in tried]
    for turn in range(_ROUNDS):
        told(_ROUNDS, turn, "timing, in turns")
        for candidate, point, times in zip(tried, points, spent, strict=True):
            if point.error is None or sum(times) > _LONG:
                continue
            engine = candidate.make(scene, candidate.time_step, candidate.passes)
            count = candidate.steps(duration)
            began = thread_time()
            engine.step(count)
            times.append(thread_time() - began)
    return [
        replace(point, seconds=Seconds(median(times), min(times), len(times)) if times else None)
        for point, times in zip(points, spent, strict=True)
    ]


def _seconds(point: ContactPoint) -> float:
    return point.seconds.median if point.seconds else math.inf
