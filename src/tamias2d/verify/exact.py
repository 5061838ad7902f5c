"""Compare a history, or its end, or some moments of it, with exact answers."""

from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

from tamias2d.motion.methods import Reference
from tamias2d.run import Run
from tamias2d.simulate import simulate
from tamias2d.state import Array
from tamias2d.verify.case import Case
from tamias2d.verify.formula import Bodies, distance, history, instant
from tamias2d.verify.outcome import Outcome


def compare_history(case: Case, given: Mapping[str, Any]) -> Iterator[Outcome]:
    """Every sample of the run, as one relative error for each body and quantity.

    With a tolerance for the `reference`, its run is compared as well.
    """
    for answer in answers(case.run, given["bodies"], slice(None)):
        yield case.outcome(given, answer.label, distance(answer.found, answer.exact))
    if "reference" in given:
        run = simulate(case.scene, duration=case.duration, method=Reference())
        own = {**given, "tolerance": given["reference"]}
        for answer in answers(run, given["bodies"], slice(None)):
            error = distance(answer.found, answer.exact)
            yield case.outcome(own, f"{answer.label} by the reference", error)


def compare_final(case: Case, given: Mapping[str, Any]) -> Iterator[Outcome]:
    """The state at the end of the run."""
    for answer in answers(case.run, given["bodies"], slice(-1, None)):
        error = distance(answer.found, answer.exact)
        yield case.outcome(given, f"{answer.label} at the end", error)


def compare_moments(case: Case, given: Mapping[str, Any]) -> Iterator[Outcome]:
    """The states at chosen times: the worst of them for each body and quantity."""
    times = [instant(state["at"]) for state in given["states"]]
    run = simulate(case.scene, duration=case.duration, times=times)
    worst: dict[str, float] = {}
    for k, state in enumerate(given["states"]):
        for answer in answers(run, state["bodies"], slice(k, k + 1)):
            error = distance(answer.found, answer.exact)
            worst[answer.label] = max(worst.get(answer.label, 0.0), error)
    for label, error in worst.items():
        yield case.outcome(given, f"{label} at {len(times)} moments", error)


class Answer(NamedTuple):
    """What was found for a quantity of a body, (k,) or (k, 2), and what it should be."""

    body: str
    quantity: str
    found: Array
    exact: Array

    @property
    def label(self) -> str:
        """For reports: `velocity of striker`."""
        quantity = self.quantity.replace("_", " ")
        return quantity if self.body == "body" else f"{quantity} of {self.body}"


def answers(run: Run, bodies: Bodies, samples: slice) -> Iterator[Answer]:
    """Yield the answer for each body and quantity, at some samples of a run."""
    for body, quantities in bodies.items():
        index = run.scene.index(body)
        for quantity, text in quantities.items():
            found: Array = getattr(run, quantity)[samples, index]
            yield Answer(body, quantity, found, history(text, quantity, run.times[samples]))
