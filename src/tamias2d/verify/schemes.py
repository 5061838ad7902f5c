"""Measure the order of a scheme, and its error constant where that is known.

A scene is run with n, 2n, 4n, 8n and 16n steps.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import inf, log2
from typing import Any

import numpy as np

from tamias2d.generated import schemes
from tamias2d.motion.fixed_steps import FixedSteps
from tamias2d.motion.integrated import IntegratedMotion
from tamias2d.motion.methods import (
    ExplicitEuler,
    ExponentialDrag,
    PathMethod,
    RungeKutta4,
    SemiImplicitEuler,
    VelocityVerlet,
    Yoshida4,
)
from tamias2d.motion.motion import Motion
from tamias2d.run import Run
from tamias2d.scene import Scene
from tamias2d.simulate import simulate
from tamias2d.state import Array
from tamias2d.verify.case import Case
from tamias2d.verify.exact import answers
from tamias2d.verify.formula import distance, history, measure
from tamias2d.verify.items import items
from tamias2d.verify.outcome import Outcome

HALVINGS = 4
METHODS: dict[str, PathMethod] = {
    "explicit_euler": ExplicitEuler(),
    "semi_implicit_euler": SemiImplicitEuler(),
    "velocity_verlet": VelocityVerlet(),
    "runge_kutta_4": RungeKutta4(),
    "yoshida_4": Yoshida4(),
    "exponential_verlet": ExponentialDrag(),
}


@dataclass(frozen=True)
class EqualSteps(PathMethod):
    """The step of any scheme of the specification, of one length."""

    item: str
    fixed_step = True

    def motion(self, scene: Scene, duration: float, time_step: float) -> Motion:
        """Return motion by the scheme; what a pair says of its error is not asked for."""
        step = getattr(schemes, self.item)

        def plain(*state: Any) -> tuple[Array, Array]:
            position, velocity = step(*state)[:2]
            return position, velocity

        return IntegratedMotion(scene, duration, FixedSteps(plain, duration, time_step))


EndErrors = dict[tuple[str, str], Array]
"""Body and quantity -> found minus exact, at the end of the run."""
Stepping = Callable[[str, int], EndErrors]
"""From a scheme and a number of steps to the errors."""


def compare(case: Case, given: Mapping[str, Any]) -> Iterator[Outcome]:
    """The worst of the observed orders against the proven one; errors against constants.

    `shows` names orders that schemes show where their proof does not hold.
    """
    stepping = _on_scene(case, given.get("durations", {}))
    proven = {scheme: int(items()[scheme]["data"]["order"]) for scheme in given.get("orders", ())}
    shown = {scheme: int(order) for scheme, order in given.get("shows", {}).items()}
    for scheme, order in [*proven.items(), *shown.items()]:
        errors = [stepping(scheme, n) for n in _counts(given, scheme)]
        word = "proven" if scheme in proven else "expected"
        yield from _orders(case, given, scheme, errors, order, word)
    for scheme, constants in given.get("constants", {}).items():
        counts = _counts(given, scheme)
        error = max(_misfit(case, constants, n, stepping(scheme, n)) for n in counts)
        yield case.outcome(given, f"error constant of {scheme}", error)


def _counts(given: Mapping[str, Any], scheme: str) -> list[int]:
    """Return the numbers of steps, each twice the one before; `steps` says how many come first.

    It is one number for all schemes, or a mapping from each.
    """
    steps = given["steps"]
    first = int(steps[scheme] if isinstance(steps, Mapping) else steps)
    return [first * 2**k for k in range(HALVINGS + 1)]


def _orders(
    case: Case,
    given: Mapping[str, Any],
    scheme: str,
    errors: list[EndErrors],
    expected: int,
    word: str,
) -> Iterator[Outcome]:
    for body, quantity in errors[0]:
        if "of" not in given or quantity in given["of"].get(body, ()):
            sizes = [float(np.linalg.norm(error[body, quantity])) for error in errors]
            worst = max(_observed(sizes), key=lambda order: abs(order - expected))
            whose = "" if body == "body" else f" of {body}"
            what = f"order of {scheme} in {quantity.replace('_', ' ')}{whose}"
            note = f"order {worst:.3f}, {word} {expected}"
            yield case.outcome(given, what, abs(worst - expected), note)


def _observed(sizes: list[float]) -> list[float]:
    """Return the order that each halving shows; infinite where there is no error left."""
    return [log2(coarse / fine) if coarse and fine else inf for coarse, fine in pairwise(sizes)]


def _misfit(case: Case, constants: Mapping[str, Any], steps: int, errors: EndErrors) -> float:
    """Return how far the errors are from what their constants say, the worst of all."""
    end, time_step = np.array([case.duration]), case.duration / steps
    return max(
        distance(errors[body, quantity], history(text, quantity, end, time_step=time_step))
        for body, quantities in constants.items()
        for quantity, text in quantities.items()
    )


def _on_scene(case: Case, durations: Mapping[str, Any]) -> Stepping:
    """Return the errors at the end of the case, or of the duration of its own that a scheme has."""
    exact = case.data["exact" if "exact" in case.data else "final"]["bodies"]

    def errors(scheme: str, steps: int) -> EndErrors:
        own = durations.get(scheme)
        duration = case.duration if own is None else float(measure(own, "duration"))
        run = run_by(case, scheme, steps, duration=duration, times=[duration])
        found = answers(run, exact, slice(-1, None))
        return {(one.body, one.quantity): one.found - one.exact for one in found}

    return errors


def run_by(
    case: Case,
    scheme: str,
    steps: int,
    *,
    duration: float | None = None,
    times: Sequence[float] | None = None,
) -> Run:
    """Return the run of a case's scene by a scheme, in equal steps.

    It lasts as long as the case and is sampled at each step, where nothing else is asked, in s.
    """
    method = METHODS.get(scheme, EqualSteps(scheme))
    duration = duration or case.duration
    step = duration / steps
    return simulate(case.scene, duration=duration, method=method, time_step=step, times=times)
