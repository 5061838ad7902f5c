"""A verification case: what srs/verification says, with the scene and run that belong to it."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import yaml

from tamias2d.run import Run
from tamias2d.scene import Scene, catalogue, load
from tamias2d.simulate import simulate
from tamias2d.verify.formula import measure
from tamias2d.verify.items import Item, fingerprint
from tamias2d.verify.outcome import FAIL, PASS, Outcome


@dataclass(frozen=True)
class Case:
    """One case of the specification. The run is made once, when it is first asked for.

    The reader of the chapters makes sure that a case which compares a run has scene and duration.
    """

    item: Item

    @property
    def id(self) -> str:
        """Label, such as TC2."""
        return str(self.item["id"])

    @property
    def data(self) -> Mapping[str, Any]:
        """The fence, as text."""
        data: Mapping[str, Any] = self.item["data"]
        return data

    @cached_property
    def scene(self) -> Scene:
        """What is simulated: a scene of the catalogue, or the one that the case holds."""
        return scene_of(self.data["scene"])

    @cached_property
    def duration(self) -> float:
        """In s."""
        return float(measure(self.data["duration"], "duration"))

    @cached_property
    def run(self) -> Run:
        """The run by the method that `simulate` takes by itself, 60 samples a second."""
        return simulate(self.scene, duration=self.duration)

    def outcome(
        self, given: Mapping[str, Any], quantity: str, error: float, note: str = ""
    ) -> Outcome:
        """Judge an error by the tolerance of a comparison."""
        tolerance = float(given["tolerance"])
        verdict = PASS if error <= tolerance else FAIL
        return self.stamped(Outcome(self.id, quantity, float(error), tolerance, verdict, note=note))

    def stamped(self, outcome: Outcome) -> Outcome:
        """Return an outcome with what it was judged on, so that it can be found to be stale."""
        return replace(outcome, hash=fingerprint(self.item))


def scene_of(data: Any) -> Scene:
    """Return the scene that a name of the catalogue, or the content of a scene file, stands for."""
    return catalogue.load(data) if isinstance(data, str) else load(yaml.safe_dump(data) + "\n")
