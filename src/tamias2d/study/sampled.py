"""A run sampled at the times that comparisons need: common ones, and its own impacts."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TypeAlias

import numpy as np

from tamias2d.run import Impacts, Run
from tamias2d.state import Array

Sampler: TypeAlias = Callable[[Iterable[float]], Run]
"""Simulates, and samples at some sorted times, s."""


@dataclass(frozen=True)
class Sampled:
    """A run with all its samples, and which of them are the common ones."""

    run: Run
    shared: Array
    """(k,), s"""

    @cached_property
    def common(self) -> Run:
        """The same run at the common times only."""
        rows = np.searchsorted(self.run.times, self.shared)
        columns = ("times", "position", "orientation", "velocity", "angular_velocity")
        balance: tuple[str, ...] = ("energy", "momentum", "angular_momentum")
        if self.run.contact_force is not None:
            balance += "contact_force", "contact_torque"
        return replace(
            self.run, **{name: getattr(self.run, name)[rows] for name in columns + balance}
        )

    @cached_property
    def events(self) -> dict[tuple[int, int], list[int]]:
        """For each pair that meets, the samples just after its impacts, in order."""
        found: dict[tuple[int, int], list[int]] = {}
        for time, a, b in sorted(_instants(self.run.impacts)):
            row = int(np.searchsorted(self.run.times, time))
            found.setdefault((min(a, b), max(a, b)), []).append(row)
        return found


def sampled(simulate_at: Sampler, shared: Array, impacts: Impacts) -> Sampled:
    """Run again, at common times and around the impacts that are known from a first run."""
    after = impacts.time[impacts.time <= shared[-1]]
    before = np.nextafter(after, -np.inf)
    times = np.unique(np.concatenate((shared, after, before[before >= 0])))
    return Sampled(simulate_at(times), shared)


def _instants(impacts: Impacts) -> set[tuple[float, int, int]]:
    """Return impacts once, where a pair met with a whole side."""
    pairs = zip(impacts.time.tolist(), *impacts.bodies.T.tolist(), strict=True)
    return set(pairs)
