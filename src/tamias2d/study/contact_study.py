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
from tamias2d.study.contact_errors import Answer, ContactErrors, contact_errors, statistics
from tamias2d.study.engines.own import Own
from tamias2d.study.engines.refusal import PeerError
from tamias2d.study.front import front
from tamias2d.study.looks import ends_of_steps
from tamias2d.study.phases import over_phases
from tamias2d.study.refined import SUBSTEPS, Refined, nudged, refinements, stepped, work_of
from tamias2d.study.refusal import ToleranceError, sooner
from tamias2d.study.schedule import Schedule
from tamias2d.study.stepped_plan import aligned_step
from tamias2d.study.work_precision import ProgressHook, Seconds

_AGREED = 1e-3
"""Of the length: so well agree the runs that an answer comes from, up to the horizon."""
_WORK = 2e7  # substeps of one body that the answer may take; all candidates together take more
_DEAREST = 3e7  # the same for one candidate: what is dearer is likely left out
_PHASES = 3e8  # the same for all runs of an ensemble
_ANSWER = 20.0  # runs by the longest steps cost as much as the least that an answer takes
_LONGEST = 120.0  # s of the processor that this may be
_TRIED = 4  # steps that tell it
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
    early; the points that are there by then are returned, if there are any. Settings that would
    take long are points with that as a reason, and finer ones are left out.

    Raises:
        ToleranceError: a run by short steps is refused, so that there is nothing to compare with,
            or takes too long; it says for how short a run it would not.
        KeyboardInterrupt: it was stopped before its first point.
    """
    step = aligned_step(duration, np.array([duration]))
    tried = list(contact_candidates(duration, coarsest=2 * step, rates=rates))
    _refuse_long(scene, duration, step)
    known = _known(scene, duration, step, _affordable(scene, duration, tried, phases_asked))
    found: dict[int, ContactPoint] = {}
    complete = True
    try:
        for place, point in _points(tried, known, told):
            found[place] = point
        if timed:
            _time(tried, found, scene, told)
    except KeyboardInterrupt:
        if not found:
            raise
        complete = False
    points = [_located(reason), *(found[place] for place in sorted(found))]
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
    works = [work_of(scene, duration, one.time_step, one.passes) for one in tried]
    each = sum(work for work in works if work <= _DEAREST)
    return min(asked, max(_FEWEST, int(_PHASES / (each + _WORK / 4))))


def _refuse_long(scene: Scene, duration: float, step: float) -> None:
    """Refuse what takes too long by the time of the first steps."""
    engine = Own(scene, step, SUBSTEPS)
    engine.step()  # its code is loaded
    began = thread_time()
    engine.step(_TRIED)
    coming = _ANSWER * duration / step * (thread_time() - began) / _TRIED
    if coming > _LONGEST:
        raise ToleranceError(
            f"tradeoff: what others are compared with would take about {coming:.2g} s of the "
            f"processor for {duration:g} s, and may take {_LONGEST:g} s (R4).",
            until=sooner(duration * _LONGEST / coming),
            otherwise="ask for a quality",
        )


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
    return max(found.agreed(_AGREED), 1)


def _first_contacts(scene: Scene, duration: float, step: float) -> dict[tuple[int, int], float]:
    engine = Own(scene, step, 2 * SUBSTEPS, listens=True)
    engine.step(math.ceil(duration / step))
    return engine.met


def _points(
    tried: Sequence[ContactCandidate], known: _Known, told: ProgressHook
) -> Iterator[tuple[int, ContactPoint]]:
    """Yield points, and where they belong; of settings that are left out, the cheapest of each."""
    absent: dict[str, str] = {}
    schedule = Schedule(tried)
    for done, (place, left_out) in enumerate(schedule):
        candidate = tried[place]
        told(len(tried), done, f"{candidate.method} {candidate.setting}")
        bare = ContactPoint(
            method=candidate.method,
            setting=candidate.setting,
            peer=candidate.peer,
            steps=candidate.steps,
            passes=candidate.passes,
        )
        if left_out is not None:
            schedule.leave(place)
            yield place, replace(bare, failure=left_out)
            continue
        if candidate.method in absent:
            yield place, replace(bare, failure=absent[candidate.method])
            continue
        began = thread_time()
        try:
            point = _point(bare, candidate, known)
        except PeerError as fault:
            absent[candidate.method] = str(fault)
            point = replace(bare, failure=str(fault))
        except (TamiasError, ArithmeticError) as fault:
            point = replace(bare, failure=str(fault))
        schedule.took(place, thread_time() - began, failed=point.failure is not None)
        yield place, point


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
        error=over_phases(found, median),
        worst=over_phases(found, max),
        statistics=statistics(known.scenes[0], histories),
    )


def _time(
    tried: Sequence[ContactCandidate],
    points: dict[int, ContactPoint],
    scene: Scene,
    told: ProgressHook,
) -> None:
    """Time all points in turns: what slows the machine for a while slows all of them."""
    spent: dict[int, list[float]] = {k: [] for k, p in points.items() if p.error is not None}
    for turn in range(_ROUNDS):
        told(_ROUNDS, turn, "timing, in turns")
        for place, times in spent.items():
            if sum(times) > _LONG:
                continue
            candidate = tried[place]
            engine = candidate.make(scene, candidate.time_step, candidate.passes)
            began = thread_time()
            engine.step(candidate.steps)
            times.append(thread_time() - began)
    for place, times in spent.items():
        seconds = Seconds(median(times), min(times), len(times))
        points[place] = replace(points[place], seconds=seconds)


def _seconds(point: ContactPoint) -> float:
    return point.seconds.median if point.seconds else math.inf
