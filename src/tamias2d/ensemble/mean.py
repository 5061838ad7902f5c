"""The mean of a quantity over worlds, within a tolerance, by multilevel Monte Carlo.

Many worlds are solved in coarse steps, and few in fine ones. Level 0 has steps of the length that
is given, each further one half of those before; it estimates by how much its steps change the
quantity, from worlds that are solved in both. The sum over the levels is the mean at the finest
steps. How many worlds each level has follows from its variance and its cost; what few worlds, or
ones that are all alike, may not have shown is in `confidence`.

Source: Giles, Multilevel Monte Carlo path simulation, Operations Research 56 (2008) 607-617.
"""

import hashlib
import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import pairwise
from typing import Any, Protocol

import numpy as np

from tamias2d.ensemble.confidence import (
    CONFIDENCE,
    QUANTILE,
    is_one_value,
    most_others,
    variance_for,
)
from tamias2d.ensemble.execution import Executors, done, executors_of
from tamias2d.ensemble.finite import refuse_no_numbers
from tamias2d.ensemble.request import Quantity, Request, request_of
from tamias2d.ensemble.sampling import checked_seed, inverse_of, sampled
from tamias2d.ensemble.solving import solved_block
from tamias2d.ensemble.worlds import VariedWorlds
from tamias2d.errors import SimulationError
from tamias2d.motion import Method
from tamias2d.scene import Scene
from tamias2d.scene.rules import RuleError, is_number, shown
from tamias2d.state import Array
from tamias2d.suggestions import suggests
from tamias2d.work_limit import WORK_LIMIT

_FIRST = 100  # worlds of level 0, from which its variance is estimated
_FIRST_FINER = 32  # worlds of a finer level, each of which costs more
_ALIKE = 1600  # worlds, after which a quantity that is the same in all of them is taken for one
_LEVELS = 12  # at most: the finest step is 1/2048 of the first one
_LEAST_ORDER = 0.5  # of the discretisation error, that is believed; impacts may spoil a higher one
_NOISE = 1.0  # standard deviations by which changes may be off where an order is judged
_TINY = 1e-300
_BLOCK = 64  # worlds that are solved together


@dataclass(frozen=True)
class Level:
    """What was found at one level."""

    time_step: float | None
    """s"""
    worlds: int
    mean: float
    """Of the quantity at level 0, and of its change by halving the step at all others."""
    variance: float
    """Of the same."""
    cost: float
    """Steps of one world."""


@dataclass(frozen=True, kw_only=True)
class Mean:
    """A mean over worlds, with its errors."""

    value: float
    statistical: float
    """The mean of finitely many worlds is off by no more, with `confidence`."""
    discretisation: float
    """Finite steps change it by about this, judged from how much halving them did; 0: exact."""
    confidence: float
    tolerance: float
    levels: tuple[Level, ...]

    @property
    def bound(self) -> float:
        """The sum of both errors."""
        return self.statistical + self.discretisation

    @property
    def cost(self) -> float:
        """Steps of all worlds."""
        return sum(level.worlds * level.cost for level in self.levels)

    @property
    def plain_cost(self) -> float:
        """Steps that worlds in the finest steps alone would take for the same bound, about."""
        finest = self.levels[0].cost * float(2 ** (len(self.levels) - 1))
        if not self.statistical:
            return finest
        return finest * QUANTILE**2 * self.levels[0].variance / self.statistical**2

    def __str__(self) -> str:
        worlds = ", ".join(f"{level.worlds}" for level in self.levels)
        return (
            f"Mean: {self.value:.6g} +- {self.bound:.2g}: {self.statistical:.2g} by chance "
            f"({self.confidence:.0%}), {self.discretisation:.2g} by steps; worlds by level: "
            f"{worlds}{self._alike}"
        )

    @property
    def _alike(self) -> str:
        """What is to be said where all worlds of level 0 gave the same."""
        first = self.levels[0]
        if first.variance:
            return ""
        return f"; {first.mean:g} in all of level 0, which is taken for a share of worlds"


@suggests
def ensemble_mean(
    scene: Scene,
    quantity: Quantity,
    *,
    duration: float,
    vary: Mapping[str, Any],
    tolerance: float,
    seed: int,
    method: Method | None = None,
    time_step: float | None = None,
    times: Iterable[float] | None = None,
    work_limit: int = WORK_LIMIT,
    workers: int | None = None,
    client: Any = None,
) -> Mean:
    """Return the mean of a quantity over worlds that are drawn, within an absolute tolerance.

    `vary` has distributions, as for `ensemble`; `quantity` is a function from a run to a number.
    The run has its samples at `times`, s, and without these all that `simulate` gives; for a
    quantity that looks at the end alone, ``times=(duration,)`` saves time.

    With a method of fixed steps, `time_step` (s) is the coarsest one, and finer ones are taken as
    far as the tolerance demands. Any other method is taken as it is: its own error is not in the
    result, but what `certify` says of single runs.

    Raises:
        InputError: an argument breaks a rule.
        SceneError, SimulationError: a world is refused, as by `simulate`; its quantity is not
            finite; the quantity is the same in 1600 worlds, and neither 0 nor 1, so that no bound
            follows; or the tolerance is not met by steps 2048 times as fine as the first, and the
            message says what is.
    """
    _refuse_no_tolerance(tolerance)
    sampler = _WorldSampler(
        scene,
        vary,
        checked_seed(seed),
        request_of(
            scene,
            duration=duration,
            method=method,
            time_step=time_step,
            times=times,
            keep=(),
            quantities={"quantity": quantity},
            work_limit=work_limit,
        ),
        executors_of(workers, client),
    )
    return Estimate(sampler, tolerance).run()


def _refuse_no_tolerance(tolerance: object) -> None:
    if not (is_number(tolerance) and 0 < tolerance < math.inf):
        raise RuleError(
            f"tolerance {shown(tolerance)} of the mean: must be a number > 0 (R10). Give an error "
            "that you can live with, in the unit of the quantity.",
            "tolerance",
        )


class _WorldSampler:
    """Draws worlds of a level, and solves each in the steps of this level and of the one before."""

    def __init__(
        self,
        scene: Scene,
        vary: Mapping[str, Any],
        seed: int,
        request: Request,
        executors: Executors | None,
    ) -> None:
        self._scene, self._vary, self._seed = scene, vary, seed
        self._request, self._executors = request, executors
        for path, given in vary.items():
            if inverse_of(given) is None:
                raise RuleError(
                    f"vary {path!r}: a mean is over worlds that are drawn (R2). Give a "
                    "distribution of scipy.stats.",
                    "vary",
                )

    @property
    def stepped(self) -> bool:
        """Whether there are levels at all."""
        return self._request.time_step is not None

    def time_step(self, level: int) -> float | None:
        """Return the time step of a level, s."""
        step = self._request.time_step
        return None if step is None else step / 2**level

    def cost(self, level: int) -> float:
        """Return how many steps a world of a level takes; 1 where the method chooses them."""
        step = self._request.time_step
        if step is None:
            return 1.0
        steps = math.ceil(self._request.duration / step) * 2.0**level
        return steps if level == 0 else 1.5 * steps

    def values(self, level: int, first: int, last: int) -> Array:
        """Return the quantity of some worlds of a level, or its change from the level before."""
        key = hashlib.sha256(f"{self._seed} level {level}".encode()).digest()
        values = sampled(self._scene, self._vary, last, int.from_bytes(key[:8]) // 2, None)
        worlds = VariedWorlds(self._scene, values, last)
        steps = [level] if level == 0 else [level, level - 1]
        requests = [replace(self._request, time_step=self.time_step(each)) for each in steps]
        starts = range(first, last, _BLOCK)
        tasks = [
            partial(_task, worlds, requests, start, min(start + _BLOCK, last)) for start in starts
        ]
        found = np.empty(last - first)
        for start, part in done(tasks, self._executors):
            found[start - first : start - first + len(part)] = part
        return found


def _task(
    worlds: VariedWorlds, requests: Sequence[Request], first: int, last: int
) -> Callable[[], tuple[int, Array]]:
    return partial(_changes, worlds.part(first, last), requests, first, last)


def _changes(
    worlds: VariedWorlds, requests: Sequence[Request], first: int, last: int
) -> tuple[int, Array]:
    blocks = [solved_block(worlds, request, first, last) for request in requests]
    for block in blocks:
        if block.refusal is not None:
            raise block.refusal
    values = [block.arrays["quantity"] for block in blocks]
    varied = {place.path: of_worlds for place, of_worlds in worlds.values.items()}
    for some in values:
        refuse_no_numbers(some, varied, "mean")
    return first, values[0] - values[1] if len(values) == 2 else values[0]


class Sampler(Protocol):
    """Whoever gives values of levels."""

    @property
    def stepped(self) -> bool:
        """Whether there are levels at all."""

    def time_step(self, level: int) -> float | None:
        """Return the time step of a level, s."""

    def cost(self, level: int) -> float:
        """Return how many steps a world of a level takes."""

    def values(self, level: int, first: int, last: int) -> Array:
        """Return the quantity of some worlds of a level, or its change from the level before."""


class Estimate:
    """The levels as they grow, until both errors are within the tolerance."""

    def __init__(self, sampler: Sampler, tolerance: float) -> None:
        self._sampler = sampler
        self._tolerance = tolerance
        self._share = 0.5 if sampler.stepped else 1.0  # of the tolerance, for chance
        self._values: list[Array] = []

    def run(self) -> Mean:
        """Return the mean; raise `SimulationError` if no steps are fine enough."""
        for _ in range(3 if self._sampler.stepped else 1):
            self._add_level()
        while True:
            while self._more():
                pass
            found = self._mean()
            if found.discretisation <= (1 - self._share) * self._tolerance:
                return found
            if len(self._values) == _LEVELS:
                raise SimulationError(
                    f"mean: found {found.value:.6g}, of which steps of "
                    f"{found.levels[-1].time_step:.3g} s change {found.discretisation:.2g}: must "
                    f"be within half of the tolerance of {self._tolerance:g} (R10). Give a larger "
                    "tolerance, or a method of higher order."
                )
            self._add_level()

    def _add_level(self) -> None:
        level = len(self._values)
        first = _FIRST if level == 0 else _FIRST_FINER
        self._values.append(self._sampler.values(level, 0, first))

    def _more(self) -> bool:
        """Add the worlds that the variances ask for; return whether there were any."""
        self._refuse_one_value()
        costs = self._costs()
        deviations = [
            math.sqrt(v) * QUANTILE / (self._share * self._tolerance) for v in self._variances()
        ]
        total = sum(s * math.sqrt(c) for s, c in zip(deviations, costs, strict=True))
        added = False
        for level, (deviation, cost) in enumerate(zip(deviations, costs, strict=True)):
            have = len(self._values[level])
            need = math.ceil(min(total * deviation / math.sqrt(cost), 4.0 * have))  # guesses first
            if need > have:
                more = self._sampler.values(level, have, need)
                self._values[level] = np.concatenate((self._values[level], more))
                added = True
        return added

    def _refuse_one_value(self) -> None:
        """Add worlds while all of level 0 give the same, neither 0 nor 1; refuse if all do."""
        while is_one_value(self._values[0]) and self._values[0][0] not in (0.0, 1.0):
            have = len(self._values[0])
            if have >= _ALIKE:
                raise SimulationError(
                    f"mean: found {self._values[0][0]:.6g} in all of {have} worlds: fewer than "
                    f"{most_others(have):.2%} give another value ({CONFIDENCE:.0%}), but how far "
                    "off is not known, so that no bound follows (R10). Take this value if nothing "
                    "that varies can change it; or ask how many worlds give another one, by a "
                    "quantity that is 0 or 1."
                )
            more = self._sampler.values(0, have, 4 * have)
            self._values[0] = np.concatenate((self._values[0], more))

    def _variances(self) -> list[float]:
        """Return the variances of the levels; few worlds do not make one much smaller than before.

        Halving a step at least halves the variance of a change that is worth a level; where the
        sample says much less, it may have missed the rare worlds that make it up. Where no world
        of a level is changed, one that is may go from end to end of what level 0 gave.
        """
        unseen = float(np.ptp(self._values[0])) or 1.0
        found = [variance_for(values, unseen) for values in self._values]
        for level in range(2, len(found)):
            found[level] = max(found[level], found[level - 1] / 8)
        return found

    def _costs(self) -> list[float]:
        return [self._sampler.cost(level) for level in range(len(self._values))]

    def _mean(self) -> Mean:
        levels = tuple(
            Level(
                self._sampler.time_step(k),
                len(values),
                float(values.mean()),
                0.0 if is_one_value(values) else float(np.var(values, ddof=1)),
                cost,
            )
            for k, (values, cost) in enumerate(zip(self._values, self._costs(), strict=True))
        )
        errors = [v / level.worlds for v, level in zip(self._variances(), levels, strict=True)]
        return Mean(
            value=sum(level.mean for level in levels),
            statistical=QUANTILE * math.sqrt(sum(errors)),
            discretisation=self._discretisation(levels, errors) if self._sampler.stepped else 0.0,
            confidence=CONFIDENCE,
            tolerance=self._tolerance,
            levels=levels,
        )

    def _discretisation(self, levels: Sequence[Level], errors: Sequence[float]) -> float:
        """Return by how much finer steps would still change the mean.

        Changes fall with the step to the power of the order: the least that two changes show, and
        not believed to be higher than 2 or lower than 1/2. The last change may be small by
        accident, so that the one before speaks, too. Each may be off by what chance does to it.
        """
        changes = [
            (abs(level.mean), math.sqrt(error))
            for level, error in zip(levels[1:], errors[1:], strict=True)
        ]
        orders = [
            math.log2(max(before - _NOISE * off, _TINY) / (after + _NOISE * doubt))
            for (before, off), (after, doubt) in pairwise(changes)
            if after > 0 or doubt > 0
        ]
        order = min(max(min(orders, default=2.0), _LEAST_ORDER), 2.0)
        (before, off), (after, doubt) = changes[-2:]
        last = max(after + _NOISE * doubt, (before + _NOISE * off) / 2**order)
        return last / (2**order - 1)
