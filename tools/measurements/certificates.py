"""Whether certificates can be believed, and whether the choice for a tolerance is cheap.

Every scene of the catalogue and every held-out one is simulated for tolerances from 1e-2 to 1e-10.
The true error comes from solutions in 40 digits (`exact`) or, where forces have no closed form,
from scipy at 1e-13, whose own doubt is what our order 8 at 1e-14 says otherwise. Effectivity is the
bound over the true error; where that is below rounding (of the largest terms of a place) or below
the doubt, over these. A bound below the doubt is not judged at all. Scenes whose contacts are
stepped have another true answer, and tables of their own (`certified_steps`); those that have none
are named. All scenes take an hour and more. Stop it by Ctrl-C, and what was found is printed.
"""

import math
import time
from argparse import ArgumentParser
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import asdict, dataclass, replace
from statistics import median
from typing import Any, NamedTuple
from unittest.mock import patch

from tamias2d.errors import SceneError, SimulationError
from tamias2d.motion import Dop853, DormandPrince5, Method, Reference, Stepped
from tamias2d.motion.halved import Halving
from tamias2d.run import Run
from tamias2d.scene import Scene, catalogue
from tamias2d.simulate import simulate
from tamias2d.solve import StoppedError, solve, solve_halved, solve_with_error
from tamias2d.state import Array
from tamias2d.study import asked as asking, companion, embedded, path_error, pilot
from tamias2d.study.bound import rounding
from tamias2d.study.error import history_error
from tamias2d.study.recommend import schemes_for, solved
from tamias2d.study.refusal import ToleranceError
from tamias2d.study.scale import scale
from tools.measurements import certified_steps, held_out
from tools.measurements.columns import Table
from tools.measurements.exact import NotCoveredError, exact_history
from tools.measurements.progress import each, until_stopped

TOLERANCES = (1e-2, 1e-4, 1e-6, 1e-8, 1e-10)
_RUNGS = 2**0.5  # of a ladder of steps
_COARSEST = 4
_APART = ("held_out", "left_out", "rows", "stepped", "stepped_rows")


@dataclass(frozen=True)
class Pair:
    """What came of one scene and one tolerance."""

    scene: str
    tolerance: float
    kind: str
    bound: float | None
    error: float | None
    doubt: float
    """Of the true answer, or rounding if that is larger."""
    covered: bool | None
    effectivity: float | None
    first_try: bool
    method: str
    cost: int | None
    """Force evaluations of the run"""
    total: int | None
    """The same with those of pilot runs, of other tries, and of the certificate"""
    regret: float | None
    """The cost over that of the cheapest run of a sweep which is truly within the tolerance"""
    regret_of_all: float | None
    """The same of the total"""
    regret_of_seconds: float | None
    """Seconds of the processor for all, over those of that cheapest run"""


@dataclass(frozen=True)
class _Truth:
    run: Run
    doubt: float


def options(parser: ArgumentParser) -> None:
    """Add what can be chosen."""
    parser.add_argument("--seed", type=int, default=held_out.SEED, help="of the held-out scenes")
    parser.add_argument(
        "--scenes", nargs="+", metavar="SCENE", choices=_names(),
        help="these alone, of the catalogue and of the held-out ones (throw 0)",
    )  # fmt: skip
    parser.add_argument(
        "--tolerances", nargs="+", type=float,
        help="these alone; else 1e-2 to 1e-10, and 1e-1 to 1e-4 where contacts are stepped",
    )  # fmt: skip


def measure(
    seed: int = held_out.SEED,
    scenes: Sequence[str] | None = None,
    tolerances: Sequence[float] | None = None,
) -> dict[str, Any]:
    """Return shares and medians over the catalogue, those over held-out scenes, and all pairs."""
    asked = list(_all(seed, scenes))
    parts = {"catalogue": _Part(), "held out": _Part()}
    with until_stopped():
        for one in each(asked, "Scenes"):
            parts[one.part].add(one, tolerances)
    return {
        **summary(parts["catalogue"].located),
        "held_out": summary(parts["held out"].located),
        "left_out": [name for part in parts.values() for name in part.left_out],
        "stepped": {name: certified_steps.summary(part.stepped) for name, part in parts.items()},
        "stepped_rows": [row for p in parts.values() for row in certified_steps.rows(p.stepped)],
        "rows": [asdict(pair) for part in parts.values() for pair in part.located],
    }


def _names() -> list[str]:
    new = (*held_out.scenes(), *held_out.stepped_scenes())
    return [*catalogue.names("located"), *catalogue.names("stepped"), *(one.name for one in new)]


class _Asked(NamedTuple):
    """A scene of the catalogue, or a held-out one."""

    part: str
    name: str
    scene: Scene
    by_steps: bool


def _all(seed: int, names: Sequence[str] | None = None) -> Iterator[_Asked]:
    """Yield the scenes of some names, or all: those whose contacts are stepped come last."""
    for by_steps in (False, True):
        for name in catalogue.names("stepped" if by_steps else "located"):
            if names is None or name in names:
                yield _Asked("catalogue", name, catalogue.load(name), by_steps)
        for scene in (held_out.stepped_scenes if by_steps else held_out.scenes)(seed):
            if names is None or scene.name in names:
                yield _Asked("held out", scene.name, scene, by_steps)


class _Part:
    """What came of the catalogue, or of the held-out scenes, as far as it was found."""

    def __init__(self) -> None:
        self.located: list[Pair] = []
        self.stepped: list[certified_steps.SteppedPair] = []
        self.left_out: list[str] = []

    def add(self, asked: _Asked, tolerances: Sequence[float] | None) -> None:
        """Find the pairs of one more scene; what was found of it is kept when that is stopped."""
        if asked.by_steps:
            within = tolerances or certified_steps.TOLERANCES
            self.stepped.extend(certified_steps.pairs(asked.name, asked.scene, within))
            return
        before = len(self.located)
        self.located.extend(_pairs(asked.name, asked.scene, tolerances or TOLERANCES))
        if len(self.located) == before:
            self.left_out.append(asked.name)


def table(found: dict[str, Any]) -> Table:
    """Return heads and rows for people: the catalogue, and what was held out."""
    heads = tuple(key for key in found if key not in _APART)
    rows = [
        (name, *("-" if part[key] is None else f"{part[key]:.4g}" for key in heads))
        for name, part in (("catalogue", found), ("held out", found["held_out"]))
    ]
    return ("scenes", *heads), rows


def notes(found: dict[str, Any]) -> list[str]:
    """Return which scenes were left out, and what came of those whose contacts are stepped."""
    names = ", ".join(found["left_out"])
    lines = [f"Without a true answer, so left out: {names}."] if names else []
    for part, said in found["stepped"].items():
        told = ", ".join(f"{key} {value}" for key, value in said.items())
        lines.append(f"Stepped, {part}: {told}.")
    return lines


def summary(pairs: list[Pair]) -> dict[str, Any]:
    """Return how many claims were true, how tight, and how cheap the choices were.

    What nothing is known of is None.
    """
    claims = [pair for pair in pairs if pair.covered is not None]
    tight = [pair.effectivity for pair in claims if pair.effectivity is not None]
    numeric = [p.effectivity for p in claims if p.kind != "exact" and p.effectivity is not None]
    regrets = [pair.regret for pair in pairs if pair.regret is not None]
    dear = [p for p in pairs if p.cost and p.total and p.regret is not None]
    with_all = [p.regret_of_all for p in dear if p.regret_of_all is not None]
    seconds = [p.regret_of_seconds for p in dear if p.regret_of_seconds is not None]
    return {
        "coverage": _share([bool(pair.covered) for pair in claims]),
        "effectivity_median": _median(tight),
        "effectivity_median_not_exact": _median(numeric),
        "met_first_try": _share([pair.first_try for pair in pairs]),
        "regret_median": _median(regrets),
        "regret_largest": max(regrets, default=None),
        "regret_median_not_exact": _median([p.regret for p in dear if p.regret is not None]),
        "total_over_cost_median": _median([p.total / p.cost for p in dear if p.total and p.cost]),
        "regret_of_all_median": _median(with_all),
        "regret_of_all_of_19_in_20": _of_19_in_20(with_all),
        "regret_of_seconds_median": _median(seconds),
        "regret_of_seconds_of_19_in_20": _of_19_in_20(seconds),
        "pairs": len(pairs),
        "claims": len(claims),
    }


def _share(found: list[bool]) -> float | None:
    return sum(found) / len(found) if found else None


def _median(found: list[float]) -> float | None:
    return median(found) if found else None


def _of_19_in_20(found: list[float]) -> float | None:
    return sorted(found)[math.ceil(0.95 * len(found)) - 1] if found else None


def _pairs(name: str, scene: Scene, tolerances: Sequence[float]) -> Iterator[Pair]:
    """Yield what came of all tolerances; nothing where there is no true answer."""
    duration = scene.duration or 1.0
    try:
        start = simulate(scene, duration=duration)
    except (SimulationError, SceneError):
        return
    if isinstance(start.method, Stepped):
        return
    truth = _truth(start)
    sweep = _Sweep(scene, truth)
    for tolerance in tolerances:
        yield _pair(name, scene, tolerance, truth, sweep)


def _pair(name: str, scene: Scene, tolerance: float, truth: _Truth, sweep: "_Sweep") -> Pair:
    duration = truth.run.duration
    times = truth.run.times
    try:
        with _counted() as total:
            run = simulate(scene, duration=duration, tolerance=tolerance, times=times)
    except ToleranceError:
        return Pair(
            name,
            tolerance,
            "refused",
            bound=None,
            error=None,
            doubt=truth.doubt,
            covered=None,
            effectivity=None,
            first_try=False,
            method="",
            cost=None,
            total=None,
            regret=None,
            regret_of_all=None,
            regret_of_seconds=None,
        )
    assert run.certificate is not None
    assert run.certificate.bound is not None
    assert run.cost is not None
    error, bound = history_error(run, truth.run), run.certificate.bound
    floor = max(truth.doubt, rounding(run) / scale(run))
    judged = truth.doubt <= bound
    cost = run.cost.force_evaluations
    least = sweep.least(tolerance) or (cost, run.method, run.time_step)
    own = _seconds(lambda: simulate(scene, duration=duration, tolerance=tolerance, times=times))
    other = _seconds(lambda: _go(scene, duration, *least[1:], times))
    return Pair(
        name,
        tolerance,
        run.certificate.kind,
        bound,
        error,
        floor,
        error <= bound + truth.doubt if judged else None,
        bound / max(error, floor) if judged else None,
        " try" not in run.notes[0] and error <= tolerance + truth.doubt,
        f"{run.method} {run.time_step or ''}",
        cost,
        total(),
        cost / least[0] if cost else 1.0,
        total() / least[0] if cost else 1.0,
        own / other if cost else None,
    )


def _seconds(run: Callable[[], object]) -> float:
    """Return the seconds of the processor that a run takes once all is compiled, the least of 3."""
    spent = []
    for _ in range(4):
        began = time.thread_time()
        run()
        spent.append(time.thread_time() - began)
    return min(spent[1:])


@contextmanager
def _counted() -> Iterator[Callable[[], int]]:
    """Count the force evaluations of all runs that are made."""
    spent: list[int] = []

    def counting(scene: Scene, **inputs: Any) -> Run:
        run = solve(scene, **inputs)
        spent.append(run.cost.force_evaluations if run.cost else 0)
        return run

    def counting_halves(scene: Scene, **inputs: Any) -> tuple[Run, Halving | None]:
        run, halving = solve_halved(scene, **inputs)
        spent.append(run.cost.force_evaluations if run.cost else 0)
        return run, halving

    def counting_errors(scene: Scene, **inputs: Any) -> tuple[Run, Array | None]:
        try:
            run, error = solve_with_error(scene, **inputs)
        except StoppedError as stopped:
            spent.append(stopped.force_evaluations)
            raise
        spent.append(run.cost.force_evaluations if run.cost else 0)
        return run, error

    with ExitStack() as patched:
        for module in (companion, pilot, asking):
            patched.enter_context(patch.object(module, "solve", counting))
        for module in (embedded, asking):
            patched.enter_context(patch.object(module, "solve_halved", counting_halves))
        for module in (path_error, asking):
            patched.enter_context(patch.object(module, "solve_with_error", counting_errors))
        yield lambda: sum(spent)


def _truth(run: Run) -> _Truth:
    if solved(run.scene):
        try:
            position, orientation = exact_history(run.scene, run.times)
            return _Truth(replace(run, position=position, orientation=orientation), 0.0)
        except NotCoveredError:
            pass
    tight = _go(run.scene, run.duration, Reference(1e-13), None, run.times)
    other = _go(run.scene, run.duration, Dop853(1e-14), None, run.times)
    return _Truth(tight, history_error(other, tight))


class _Sweep:
    """Errors and costs of all ways on fine ladders of settings, each run once for a scene."""

    def __init__(self, scene: Scene, truth: _Truth) -> None:
        self._scene = scene
        self._truth = truth
        self._known: dict[tuple[Method, float | None], tuple[float, float]] = {}

    def least(self, tolerance: float) -> tuple[float, Method, float | None] | None:
        """Return the cheapest run within a tolerance: its cost, its method, and its step, s."""
        best: tuple[float, Method, float | None] | None = None
        for ladder in self._ladders():
            for method, step in ladder:
                cost, error = self._point(method, step)
                if cost >= (best[0] if best else math.inf):
                    break
                if error <= tolerance:
                    best = cost, method, step
                    break
        return best

    def _ladders(self) -> Iterator[Iterator[tuple[Method, float | None]]]:
        """Yield the settings of each method, from cheap to dear."""
        for kind in (DormandPrince5, Dop853):
            yield ((kind(10 ** (-k / 2)), None) for k in range(1, 28))
        for method in schemes_for(self._scene):
            yield (
                (method, self._truth.run.duration / round(_COARSEST * _RUNGS**k)) for k in range(60)
            )

    def _point(self, method: Method, step: float | None) -> tuple[float, float]:
        """Return cost and error; of what is refused, the step is too long: nothing, and no use."""
        if (method, step) not in self._known:
            run = self._truth.run
            try:
                found = _go(self._scene, run.duration, method, step, run.times)
            except (SimulationError, SceneError):
                self._known[method, step] = (0.0, math.inf)
            else:
                assert found.cost is not None
                error = history_error(found, run)
                self._known[method, step] = (found.cost.force_evaluations, error)
        return self._known[method, step]


def _go(scene: Scene, duration: float, method: Method, step: float | None, times: Array) -> Run:
    return simulate(scene, duration=duration, method=method, time_step=step, times=times)
