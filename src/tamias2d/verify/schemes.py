"""Measure the order of a scheme, and its error constant where that is known.

Service: a problem is stepped with n, 2n, 4n, 8n and 16n steps. Secret: where the problem comes
from, a scene or an equation of motion that the case states.
"""

from collections.abc import Callable, Iterator, Mapping
from itertools import pairwise
from math import inf, log2
from typing import Any

import numpy as np

from tamias2d.generated import schemes
from tamias2d.motion.methods import (
    ExplicitEuler,
    Method,
    RungeKutta4,
    SemiImplicitEuler,
    VelocityVerlet,
)
from tamias2d.simulate import simulate
from tamias2d.spec.evaluate import evaluate
from tamias2d.verify.case import Case
from tamias2d.verify.exact import answers
from tamias2d.verify.formula import Array, distance, history, law, measure
from tamias2d.verify.items import items
from tamias2d.verify.outcome import Outcome

HALVINGS = 4
METHODS: dict[str, Method] = {
    "explicit_euler": ExplicitEuler(),
    "semi_implicit_euler": SemiImplicitEuler(),
    "velocity_verlet": VelocityVerlet(),
    "runge_kutta_4": RungeKutta4(),
}

Errors = dict[tuple[str, str], Array]
"""Body and quantity -> found minus exact, at the end of the run."""
Stepping = Callable[[str, int], Errors]
"""From a scheme and a number of steps to the errors."""


def compare(case: Case, given: Mapping[str, Any]) -> Iterator[Outcome]:
    """The worst of four observed orders against the proven one; errors against constants."""
    stepping = _on_equation(case, given) if "acceleration" in given else _on_scene(case)
    counts = [int(given["steps"]) * 2**k for k in range(HALVINGS + 1)]
    for scheme in given.get("orders", ()):
        yield from _orders(case, given, scheme, [stepping(scheme, n) for n in counts])
    for scheme, constants in given.get("constants", {}).items():
        error = max(_misfit(case, constants, n, stepping(scheme, n)) for n in counts)
        yield case.outcome(given, f"error constant of {scheme}", error)


def _orders(
    case: Case, given: Mapping[str, Any], scheme: str, errors: list[Errors]
) -> Iterator[Outcome]:
    proven = int(items()[scheme]["data"]["order"])
    for body, quantity in errors[0]:
        if "of" not in given or quantity in given["of"].get(body, ()):
            sizes = [float(np.linalg.norm(error[body, quantity])) for error in errors]
            worst = max(_observed(sizes), key=lambda order: abs(order - proven))
            what = f"order of {scheme} in {quantity.replace('_', ' ')}"
            note = f"order {worst:.3f}, proven {proven}"
            yield case.outcome(given, what, abs(worst - proven), note)


def _observed(sizes: list[float]) -> list[float]:
    """Return the order that each halving shows; infinite where there is no error left."""
    return [log2(coarse / fine) if coarse and fine else inf for coarse, fine in pairwise(sizes)]


def _misfit(case: Case, constants: Mapping[str, Any], steps: int, errors: Errors) -> float:
    """Return how far the errors are from what their constants say, the worst of all."""
    end, time_step = np.array([case.duration]), case.duration / steps
    return max(
        distance(errors[body, quantity], history(text, quantity, end, time_step=time_step))
        for body, quantities in constants.items()
        for quantity, text in quantities.items()
    )


def _on_scene(case: Case) -> Stepping:
    exact = case.data["exact"]["bodies"]

    def errors(scheme: str, steps: int) -> Errors:
        run = simulate(
            case.scene,
            duration=case.duration,
            method=METHODS[scheme],
            time_step=case.duration / steps,
        )
        found = answers(run, exact, slice(-1, None))
        return {(one.body, one.quantity): one.found - one.exact for one in found}

    return errors


def _on_equation(case: Case, given: Mapping[str, Any]) -> Stepping:
    tree = law(given["acceleration"], "acceleration")
    end = np.array([case.duration])

    def acceleration(time: float, position: Array, velocity: Array) -> Array:
        value = evaluate(tree, {"time": time, "position": position, "velocity": velocity})
        return np.asarray(value, dtype=float)

    def errors(scheme: str, steps: int) -> Errors:
        step = getattr(schemes, scheme)
        state = {name: np.array(measure(text, name)) for name, text in given["start"].items()}
        position, velocity = state["position"], state["velocity"]
        time_step = case.duration / steps
        for k in range(steps):
            position, velocity = step(k * time_step, time_step, position, velocity, acceleration)
        found = {"position": position, "velocity": velocity}
        return {
            ("body", quantity): found[quantity] - _scalar(text, quantity, end)
            for quantity, text in given["exact"].items()
        }

    return errors


def _scalar(text: str, quantity: str, times: Array) -> Array:
    return np.asarray(evaluate(law(text, quantity), {"time": times}))
