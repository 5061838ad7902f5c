"""Which of the things that vary matter: Sobol indices of a quantity, with their confidence.

Source: Saltelli et al., Variance based sensitivity analysis of model output, Computer Physics
Communications 181 (2010) 259-270, as scipy.stats.sobol_indices has it.
"""

import warnings
from collections.abc import Iterable, Mapping, Sequence
from functools import partial
from numbers import Real
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import numpy as np

from tamias2d.ensemble.finite import refuse_no_numbers
from tamias2d.ensemble.request import Quantity
from tamias2d.ensemble.run_ensemble import ensemble
from tamias2d.ensemble.sampling import checked_seed, inverse_of
from tamias2d.ensemble.solving import REFUSED
from tamias2d.errors import SimulationError
from tamias2d.generated import definitions
from tamias2d.motion import Method
from tamias2d.record.dataset import extra
from tamias2d.scene import Scene
from tamias2d.scene.rules import RuleError, checked_count, sequence, shown
from tamias2d.state import Array
from tamias2d.suggestions import suggests

if TYPE_CHECKING:
    from xarray import Dataset

_PLACES = "place"
_REMEDY = "Give sorted times in s, from 0 to the duration."
_RESAMPLES = 999  # of the bootstrap


@suggests
def sensitivities(
    scene: Scene,
    quantity: Quantity,
    *,
    duration: float,
    vary: Mapping[str, Any],
    worlds: int,
    seed: int,
    confidence: float = 0.95,
    method: Method | None = None,
    time_step: float | None = None,
    tolerance: float | None = None,
    times: Iterable[float] | None = None,
    workers: int | None = None,
    client: Any = None,
) -> "Dataset":
    """Return the Sobol indices of a quantity, by the places that vary, as an `xarray.Dataset`.

    `first_order` is the share of the quantity's variance that a place alone makes, `total_order`
    its share with all that it does together with others; `_low` and `_high` are the ends of
    intervals that hold each with a `confidence`, found by bootstrap. This takes worlds for drawn
    one by one, though Sobol's sequence spreads them evenly: for smooth quantities the intervals are
    wider than need be. Where so few worlds differ that some resample has no variance, the interval
    is from 0 to 1: nothing is known. Where a place changed the quantity in no world, it says how
    much it may do in worlds that were not seen, by no more than what all worlds differ by. `vary`
    has a distribution for
    each place; the base sample has `worlds` worlds, a power of 2, and (places + 2) times as many
    are simulated, as by `ensemble`. The run that `quantity` gets has its samples at `times`, s, and
    without these all that `simulate` gives; for a quantity that looks at the end alone,
    ``times=(duration,)`` saves time.

    Raises:
        InputError: an argument breaks a rule.
        SceneError, SimulationError: a world is refused, or its quantity is not finite, or the
            quantity is the same in all worlds.
    """
    from scipy.stats import sobol_indices

    count = _power_of_two(worlds)
    _refuse_no_share(confidence)
    dists = _distributions(vary)
    ask = partial(
        _quantities,
        scene,
        tuple(vary),
        duration=duration,
        method=method,
        time_step=time_step,
        tolerance=tolerance,
        times=None if times is None else sequence(times, "the run", _REMEDY, at=("times",)),
        quantities={"quantity": quantity},
        workers=workers,
        client=client,
    )
    seeds = np.random.default_rng(checked_seed(seed))
    samples: list[tuple[Array, ...]] = []

    def estimated(f_A: Array, f_B: Array, f_AB: Array) -> tuple[Array, Array]:  # noqa: N803
        samples.append((f_A, f_B, f_AB))
        return _shares(f_A, f_B, f_AB)

    found = sobol_indices(func=ask, n=count, dists=dists, method=estimated, rng=seeds)
    known = np.stack([np.ravel(found.first_order), np.ravel(found.total_order)])
    if not np.isfinite(known).all():
        raise SimulationError(
            "sensitivities: the quantity is the same in all worlds: there is no variance to share "
            "(R8). Take another quantity."
        )
    ends = _intervals(known, samples[0], confidence, seeds)
    shares: Dataset = _dataset(known, ends, list(vary), confidence)
    return shares


def _intervals(
    known: Array, samples: tuple[Array, ...], confidence: float, seeds: np.random.Generator
) -> tuple[Array, Array]:
    """Return the lower and upper ends (2, places) of intervals of the known shares.

    Each holds something from 0 to 1: no share lies beyond, though what is known of it may.
    """
    f_a, _, f_ab = samples
    ends = _bootstrapped(samples, confidence, seeds)
    unknown = np.isnan(ends.low) | np.isnan(ends.high)
    low = np.where(unknown, np.minimum(known, 0.0), np.minimum(ends.low, 1.0))
    high = np.where(unknown, np.maximum(known, 1.0), np.maximum(ends.high, 0.0))
    idle = (f_ab == f_a).all(axis=(-2, -1))
    return np.where(idle, 0.0, low), np.where(idle, _unseen_share(samples, confidence), high)


def _unseen_share(samples: tuple[Array, ...], confidence: float) -> float:
    """Return the share that a place may have, with a confidence, if it changed no world (DD115)."""
    f_a, f_b, _ = samples
    changed = definitions.unseen_share(confidence, f_a.size)
    largest = float(np.ptp(np.concatenate([sample.ravel() for sample in samples])))
    return float(definitions.total_order_most(changed, largest, float(np.var([f_a, f_b]))))


def _bootstrapped(samples: tuple[Array, ...], confidence: float, seeds: np.random.Generator) -> Any:
    """Return the ends of intervals of the shares, `low` and `high`, each (2, places).

    They are no numbers where a resample has no variance, or all resamples are the same.
    """
    from scipy.stats import bootstrap

    def again(rows: Array) -> Array:
        return np.concatenate(_shares(*(sample[..., rows] for sample in samples)))

    with warnings.catch_warnings():  # of what has no spread
        warnings.simplefilter("ignore")
        return bootstrap(
            [np.arange(samples[0].shape[-1])],
            again,
            vectorized=False,
            n_resamples=_RESAMPLES,
            confidence_level=confidence,
            rng=seeds,
        ).confidence_interval


def _shares(f_a: Array, f_b: Array, f_ab: Array) -> tuple[Array, Array]:
    """Return shares of first and of total order (1, places); (2, 1, n), (places, 1, n)."""
    variance = np.var([f_a, f_b], axis=(0, -1))
    with np.errstate(divide="ignore", invalid="ignore"):  # nan, which is refused later
        first = np.mean(f_b * (f_ab - f_a), axis=-1) / variance
        total = 0.5 * np.mean((f_a - f_ab) ** 2, axis=-1) / variance
    return first.T, total.T


def _power_of_two(worlds: int) -> int:
    count = checked_count(worlds, "worlds", 2)
    if count & (count - 1):
        raise RuleError(
            f"worlds {count}: must be a power of 2, as Sobol's sequence has it (R5). Give one such "
            f"as {2 ** count.bit_length()}.",
            "worlds",
        )
    return count


def _refuse_no_share(confidence: object) -> None:
    if not (isinstance(confidence, Real) and 0 < float(confidence) < 1):
        raise RuleError(
            f"confidence {shown(confidence)}: must lie between 0 and 1 (R5). Give one such as "
            "0.95.",
            "confidence",
        )


def _distributions(vary: Mapping[str, Any]) -> list[Any]:
    """Return distributions of the older kind of scipy, which has `ppf`."""
    if not isinstance(vary, Mapping) or len(vary) < 2:  # of one, all of the variance is
        raise RuleError(
            f"vary: found {shown(vary)}: must name two places at least, for them to have shares "
            "(R2). Vary another one as well.",
            "vary",
        )
    for path, given in vary.items():
        if inverse_of(given) is None:
            raise RuleError(
                f"vary {path!r}: found {shown(given)}: must be a distribution, of which the shares "
                "are taken (R2). Give one of scipy.stats.",
                "vary",
            )
    return [SimpleNamespace(ppf=inverse_of(given)) for given in vary.values()]


def _quantities(scene: Scene, paths: Sequence[str], values: Array, **arguments: Any) -> Array:
    """Return the quantity (1, k) for the values (places, k) of worlds."""
    vary = dict(zip(paths, values, strict=True))
    found = ensemble(scene, vary=vary, keep=(), **arguments)
    numbers: Array = found["quantity"].values
    if refused := int(np.count_nonzero(found["outcome"].values == REFUSED)):
        raise SimulationError(
            f"sensitivities: {refused} of {len(numbers)} worlds were refused, so that shares "
            "of the variance are not known (R8). Narrow the distributions."
        )
    refuse_no_numbers(numbers, vary, "sensitivities")
    return numbers[None]


def _dataset(known: Array, ends: tuple[Array, Array], paths: list[str], confidence: float) -> Any:
    """Return the dataset of shares (2, places), by their order, with the ends of intervals."""
    with extra():
        from xarray import Dataset

    variables = {}
    for order, name in enumerate(("first_order", "total_order")):
        variables[name] = ((_PLACES,), known[order], {"units": "1"})
        for suffix, end in zip(("_low", "_high"), ends, strict=True):
            variables[name + suffix] = ((_PLACES,), end[order], {"units": "1"})
    return Dataset(variables, {_PLACES: paths}, {"confidence": confidence})
