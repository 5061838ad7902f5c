"""Whether every scene of the catalogue answers what may be asked of it, or says what may be.

Asked are the trade of accuracy and cost, a run within a tolerance, and one of a quality, each for
as long as the scene says. What is refused must offer something, and the offer is tried, too. Each
question has a process of its own with a limit of processor time; what takes more is named, and
counts as a fault.
"""

import argparse
import time
from collections import Counter
from collections.abc import Callable
from dataclasses import asdict, dataclass
from typing import Any

from tamias2d import simulate
from tamias2d.errors import TamiasError
from tamias2d.scene import Scene, catalogue
from tamias2d.study.contact_study import contact_study
from tamias2d.study.refusal import ToleranceError
from tamias2d.study.stepped_plan import stepped_because
from tamias2d.study.work_precision import study
from tools.measurements.columns import Table
from tools.measurements.in_time import in_time

TOLERANCE, QUALITY = 1e-2, 1e-2
_PHASES = 4
FAULTS = ("broken offer", "late", "traceback")


@dataclass(frozen=True)
class Answer:
    """What came of one question."""

    scene: str
    asked: str
    outcome: str
    """met; refused, where the offer is met, or none is a number; or one of `FAULTS`"""
    said: str
    seconds: float
    """Of the processor"""


def options(parser: argparse.ArgumentParser) -> None:
    """Take which scenes and questions, and for how long each may be thought about."""
    parser.add_argument("--scenes", nargs="+", default=None, help="of the catalogue; all of them")
    parser.add_argument("--questions", nargs="+", default=sorted(_QUESTIONS), help="all of them")
    parser.add_argument("--limit", type=int, default=300, help="s of the processor for each")


def measure(
    scenes: list[str] | None = None, questions: list[str] | None = None, limit: int = 300
) -> dict[str, Any]:
    """Return how many questions were answered in which way, and all answers."""
    found = [
        _asked(name, question, limit)
        for name in scenes or catalogue.names()
        for question in questions or sorted(_QUESTIONS)
    ]
    return {
        "outcomes": dict(Counter(f"{one.asked}: {one.outcome}" for one in found)),
        "rows": [asdict(one) for one in found],
    }


def table(found: dict[str, Any]) -> Table:
    """Return heads and rows for people: a scene each."""
    asked = list(dict.fromkeys(row["asked"] for row in found["rows"]))
    of = {(row["scene"], row["asked"]): row for row in found["rows"]}
    rows = []
    for scene in dict.fromkeys(row["scene"] for row in found["rows"]):
        each = [of[scene, question] for question in asked]
        rows.append((scene, *(f"{one['outcome']}, {one['seconds']:.1f} s" for one in each)))
    return ("scene", *asked), rows


def notes(found: dict[str, Any]) -> list[str]:
    """Return what was refused or went wrong, and in which words."""
    return [
        f"{row['scene']}, {row['asked']}: {row['outcome']}: {row['said']}"
        for row in found["rows"]
        if row["outcome"] != "met"
    ]


def _asked(name: str, question: str, limit: int) -> Answer:
    late = Answer(name, question, "late", f"more than {limit} s", float(limit))
    found: Answer = in_time(_answer, (name, question), limit) or late
    return found


def _answer(name: str, question: str) -> Answer:
    began = time.process_time()
    try:
        scene = catalogue.load(name)
        outcome, said = _outcome(scene, _QUESTIONS[question])
    except Exception as fault:
        outcome, said = "traceback", f"{type(fault).__name__}: {fault}"
    return Answer(name, question, outcome, said, time.process_time() - began)


def _outcome(scene: Scene, ask: "_Question") -> tuple[str, str]:
    duration = scene.duration or 1.0
    try:
        return "met", ask(scene, duration, None)
    except ToleranceError as refused:
        offers: list[tuple[float, float | None]] = []
        offers += [(refused.until, None)] if refused.until else []
        offers += [(duration, refused.reachable)] if refused.reachable else []
        if not offers:
            return "refused without a number", f"{refused}"
        try:
            taken = [ask(scene, *offer) for offer in offers]
            return "refused", f"{refused} [Taken: {'; '.join(taken)}]"
        except TamiasError as again:
            return "broken offer", f"{refused} [Taken: {again}]"
    except TamiasError as refused:
        return "refused", f"{refused}"


def _tolerance(scene: Scene, duration: float, bound: float | None) -> str:
    run = simulate(scene, duration=duration, tolerance=bound or TOLERANCE)
    assert run.certificate is not None
    return f"{run.method}, bound {run.certificate.bound:.1e}, {run.certificate.kind}"


def _quality(scene: Scene, duration: float, bound: float | None) -> str:
    run = simulate(scene, duration=duration, quality=bound or QUALITY)
    assert run.certificate is not None
    return f"{run.method}, bound {run.certificate.bound:.1e}"


def _trade(scene: Scene, duration: float, _: float | None) -> str:
    if reason := stepped_because(scene, duration):
        steps = contact_study(scene, duration=duration, reason=reason, phases_asked=_PHASES)
        return f"{len(steps.points)} points, horizon {steps.horizon:.3g} s, floor {steps.floor:.0e}"
    found = study(scene, duration=duration, phases_asked=_PHASES)
    return f"{len(found.points)} points, floor {found.floor:.0e}"


_Question = Callable[[Scene, float, float | None], str]
_QUESTIONS: dict[str, _Question] = {
    "quality": _quality,
    "tolerance": _tolerance,
    "trade": _trade,
}
