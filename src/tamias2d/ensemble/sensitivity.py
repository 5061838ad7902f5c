"""Which of the things that vary matter: Sobol indices of a quantity, with their confidence.

Source: Saltelli et al., Variance based sensitivity analysis of model output, Computer Physics
Communications 181 (2010) 259-270, as scipy.stats.sobol_indices has it.
"""

import warnings
from collections.abc import Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from tamias2d.ensemble.request import Quantity
from tamias2d.ensemble.run_ensemble import ensemble
from tamias2d.ensemble.sampling import checked_seed
from tamias2d.errors import SimulationError
from tamias2d.motion import Method
from tamias2d.record.dataset import extra
from tamias2d.scene import Scene
from tamias2d.scene.rules import RuleError, shown
from tamias2d.simulator.settings import checked_count
from tamias2d.state import Array
from tamias2d.suggestions import suggests

if TYPE_CHECKING:
    from xarray import Dataset

_PLACES = "place"


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
    workers: int | None = None,
    client: Any = None,
) -> "Dataset":
    """Return the Sobol indices of a quantity, by the places that vary, as an `xarray.Dataset`.

    `first_order` is the share of the quantity's variance that a place alone makes, `total_order`
    its share with all that it does together with others; `_low` and `_high` are the ends of
    intervals that hold each with a `confidence`, found by bootstrap. `vary` has a distribution for
    each place; the base sample has `worlds` worlds, a power of 2, and (places + 2) times as many
    are simulated, as by `ensemble`.

    Raises:
        InputError: an argument breaks a rule.
        SceneError, SimulationError: a world is refused, or the quantity is the same in all worlds.
    """
    from scipy.stats import sobol_indices

    count = _power_of_two(worlds)
    _refuse_no_share(confidence)
    _refuse_no_distributions(vary)
    ask = partial(
        _quantities,
        scene,
        tuple(vary),
        duration=duration,
        method=method,
        time_step=time_step,
        tolerance=tolerance,
        quantities={"quantity": quantity},
        workers=workers,
        client=client,
    )
    seeds = np.random.default_rng(checked_seed(seed))
    found = sobol_indices(func=ask, n=count, dists=list(vary.values()), rng=seeds)
    if not np.isfinite(found.first_order).all():
        raise SimulationError(
            "sensitivities: the quantity is the same in all worlds: there is no variance to share "
            "(R8). Take another quantity."
        )
    with warnings.catch_warnings():  # a place without any effect has no spread
        warnings.simplefilter("ignore")
        spread = found.bootstrap(confidence_level=confidence)
    shares: Dataset = _dataset(found, spread, list(vary), confidence)
    return shares


def _power_of_two(worlds: int) -> int:
    count = checked_count(worlds, "worlds", 2)
    if count & (count - 1):
        raise RuleError(
            f"worlds {count}: must be a power of 2, as Sobol's sequence has it (R5). Give one such "
            f"as {2 ** count.bit_length()}.",
            "worlds",
        )
    return count


def _refuse_no_share(confidence: float) -> None:
    if not 0 < confidence < 1:
        raise RuleError(
            f"confidence {confidence!r}: must lie between 0 and 1 (R5). Give one such as 0.95.",
            "confidence",
        )


def _refuse_no_distributions(vary: Mapping[str, Any]) -> None:
    for path, given in vary.items():
        if not hasattr(given, "ppf"):
            raise RuleError(
                f"vary {path!r}: found {shown(given)}: must be a distribution, of which the shares "
                "are taken (R2). Give one of scipy.stats.",
                "vary",
            )


def _quantities(scene: Scene, paths: Sequence[str], values: Array, **arguments: Any) -> Array:
    """Return the quantity (1, k) for the values (places, k) of worlds."""
    vary = dict(zip(paths, values, strict=True))
    found = ensemble(scene, vary=vary, keep=(), **arguments)
    numbers: Array = found["quantity"].values
    refused = int(np.count_nonzero(~np.isfinite(numbers)))
    if refused:
        raise SimulationError(
            f"sensitivities: {refused} of {len(numbers)} worlds were refused, so that shares "
            "of the variance are not known (R8). Narrow the distributions."
        )
    return numbers[None]


def _dataset(found: Any, spread: Any, paths: list[str], confidence: float) -> Any:
    with extra():
        from xarray import Dataset

    variables = {}
    for name in ("first_order", "total_order"):
        interval = getattr(spread, name).confidence_interval
        known = np.ravel(getattr(found, name))
        variables[name] = ((_PLACES,), known, {"units": "1"})
        for suffix, end in (("_low", interval.low), ("_high", interval.high)):
            ends = np.where(np.isnan(end), known, end)  # in all resamples the same
            variables[name + suffix] = ((_PLACES,), np.ravel(ends), {"units": "1"})
    return Dataset(variables, {_PLACES: paths}, {"confidence": confidence})
