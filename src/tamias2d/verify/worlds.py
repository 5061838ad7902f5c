"""Check many worlds: their mean is within its bound, and each has the bits that it has alone."""

import math
from collections.abc import Iterator, Mapping
from functools import partial
from typing import Any

import numpy as np

from tamias2d.ensemble import ensemble, ensemble_mean, world_scene
from tamias2d.ensemble.request import STATE
from tamias2d.run import Run
from tamias2d.simulate import simulate
from tamias2d.spec.units import parse_quantity
from tamias2d.state import Array
from tamias2d.verify.case import Case
from tamias2d.verify.formula import history, measure
from tamias2d.verify.outcome import Outcome
from tamias2d.verify.schemes import METHODS

_SEED = 1
_SAMPLES = 5  # of each world that is compared


def compare(case: Case, given: Mapping[str, Any]) -> Iterator[Outcome]:
    """What varies is drawn evenly between two values; the exact answers are means at the end."""
    vary = {place: _even(low, high) for place, (low, high) in given["vary"].items()}
    solver: dict[str, Any] = {"duration": case.duration}
    if "scheme" in given:
        solver["method"] = METHODS[given["scheme"]]
        solver["time_step"] = float(measure(given["time_step"], "time_step"))
    for body, quantities in given["bodies"].items():
        for name, text in quantities.items():
            exact = history(text, name, np.array([case.duration]))[0]
            for place in np.ndindex(exact.shape):
                of = partial(_final, case.scene.index(body), name, place)
                mean = ensemble_mean(
                    case.scene,
                    of,
                    vary=vary,
                    tolerance=float(given["within"]),
                    times=(case.duration,),
                    seed=_SEED,
                    workers=1,
                    **solver,
                )
                error = abs(mean.value - float(exact[place]))
                share = error / mean.bound if error else 0.0
                what = f"mean of {name}{list(place) or ''} of {body}: error over bound"
                yield case.outcome(given, what, share, str(mean))
    unlike = _unlike(case, vary, int(given["worlds"]), solver)
    note = f"{unlike} worlds have other bits" if unlike else ""
    yield case.outcome(given, "bits of worlds alone", math.inf if unlike else 0.0, note)


def _even(low: str, high: str) -> Any:
    """Return the even distribution between two quantities."""
    from scipy.stats import uniform

    first, last = parse_quantity(low).value, parse_quantity(high).value
    return uniform(first, last - first)


def _final(body: int, name: str, place: tuple[int, ...], run: Run) -> float:
    values: Array = getattr(run, name)
    return float(values[(-1, body, *place)])


def _unlike(case: Case, vary: Mapping[str, Any], count: int, solver: Mapping[str, Any]) -> int:
    """Return how many worlds of an ensemble have other bits than their scenes alone."""
    times = np.linspace(0.0, case.duration, _SAMPLES)
    found = ensemble(
        case.scene, vary=vary, worlds=count, seed=_SEED, times=times, workers=1, **solver
    )
    bodies = [case.scene.index(name) for name in found["body"].values.tolist()]
    runs = (simulate(world_scene(found, k), times=times, **solver) for k in range(count))
    return sum(
        not all(
            np.array_equal(found[name].values[k], getattr(run, name)[:, bodies]) for name in STATE
        )
        for k, run in enumerate(runs)
    )
