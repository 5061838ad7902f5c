"""What varies, and its value in each world: from values, grids, distributions and designs.

Serves: ensembles. Hides: how numbers are drawn. A value depends on the seed, on what it is for and
on the number of the world, and on nothing else: with more worlds, those that were there stay.
"""

import hashlib
import math
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass
from itertools import product
from typing import Any, TypeAlias

import numpy as np

from tamias2d.ensemble.outline import outline_of
from tamias2d.ensemble.places import Place, place_at
from tamias2d.scene import Scene
from tamias2d.scene.quantities import read_quantity
from tamias2d.scene.rules import RuleError, checked_count, shown
from tamias2d.state import Array
from tamias2d.suggestions import suggests

Design: TypeAlias = Callable[..., Any]
"""A class of `scipy.stats.qmc`, such as `Sobol`: called with `d` and `rng`, it has `random(n)`."""
Values: TypeAlias = dict[Place, Array]
"""Of each place the values (n,) or (n, 2), by world."""

_FORMS = (
    "values for all worlds, a t2.Grid, or a distribution of scipy.stats such as uniform(0.2, 0.6)"
)


@suggests
@dataclass(frozen=True, init=False)
class Grid:
    """Values of which each is combined with each one of every other grid, the last one fastest."""

    values: tuple[Any, ...]

    def __init__(self, *values: Any) -> None:
        """Take the values one by one, or all of them in one list or array."""
        one = values[0] if len(values) == 1 else None
        listed = (
            one if isinstance(one, Sequence | np.ndarray) and not isinstance(one, str) else values
        )
        object.__setattr__(self, "values", tuple(listed))


def sampled(
    scene: Scene,
    vary: Mapping[str, Any],
    worlds: int | None,
    seed: int | None,
    design: Design | None,
) -> Values:
    """Return what varies with its values in all worlds, checked.

    Raises:
        InputError: there is no such place, a value breaks the rule of its symbol, or numbers of
            worlds differ; the message says where.
    """
    if not isinstance(vary, Mapping) or not vary:
        raise RuleError(
            f"vary: found {shown(vary)}: must name what varies (R2). Give a mapping such as "
            "{'bodies.ball.restitution': scipy.stats.uniform(0.2, 0.6)}.",
            "vary",
        )
    outline = outline_of(scene)
    places = {path: place_at(path, outline) for path in vary}
    for path, given in vary.items():
        if not (_listed(given) or isinstance(given, Grid) or inverse_of(given)):
            raise RuleError(
                f"vary {path!r}: found {shown(given)}: must be {_FORMS} (R2). Give one of these.",
                "vary",
            )
    _refuse_overlaps(list(places.values()))
    count = _count(vary, worlds)
    gridded = _gridded(vary, count)
    drawn = {path: inverse for path, given in vary.items() if (inverse := inverse_of(given))}
    shares = _shares(drawn, places, count, seed, design)
    found: Values = {}
    for path, place in places.items():
        if path in gridded:
            given = gridded[path]
        elif path in drawn:
            given = np.asarray(drawn[path](shares[path]), dtype=np.float64)
        else:
            given = vary[path]
        found[place] = checked_values(given, place, count)
    return found


def checked_seed(seed: object) -> int:
    """Return a seed, or raise `RuleError`."""
    if seed is None:
        raise RuleError(
            "seed: found none: must be stated where worlds are drawn, so that each can be made "
            "again (R5). Give a whole number, such as seed=1.",
            "seed",
        )
    return checked_count(seed, "seed", 0)


def _refuse_overlaps(places: Sequence[Place]) -> None:
    for k, one in enumerate(places):
        for other in places[k + 1 :]:
            shorter = min(len(one.keys), len(other.keys))
            if one.keys[:shorter] == other.keys[:shorter]:
                raise RuleError(
                    f"vary {one.path!r} and {other.path!r}: the same value varies twice (R2). "
                    "Leave one out.",
                    "vary",
                )


def _count(vary: Mapping[str, Any], worlds: int | None) -> int:
    """Return how many worlds there are, where all that says it agrees."""
    said = {f"vary {path!r}": len(given) for path, given in vary.items() if _listed(given)}
    grids = [given for given in vary.values() if isinstance(given, Grid)]
    if grids:
        said["the product of the grids"] = math.prod(len(grid.values) for grid in grids)
    if worlds is not None:
        said["worlds"] = checked_count(worlds, "worlds", 1)
    if not said:
        raise RuleError(
            "worlds: found none: must be stated where all that varies is drawn (R5). Give how many "
            "worlds to make, such as worlds=1000.",
            "worlds",
        )
    (first, count), *others = said.items()
    for name, other in others:
        if other != count:
            raise RuleError(
                f"{name}: found {other}, but {first} is {count}: all must tell the same number of "
                "worlds (R5). Give as many values as worlds, or leave `worlds` out.",
                "vary",
            )
    if count == 0:
        raise RuleError(f"{first}: found no value (R5). Give one at least.", "vary")
    return count


def _listed(given: object) -> bool:
    return isinstance(given, Sequence | np.ndarray) and not isinstance(given, str)


def _gridded(vary: Mapping[str, Any], count: int) -> dict[str, list[Any]]:
    grids = {path: given.values for path, given in vary.items() if isinstance(given, Grid)}
    rows = list(product(*grids.values()))
    return {path: [row[k] for row in rows] for k, path in enumerate(grids)} if count else {}


def inverse_of(given: object) -> Callable[[Array], Any] | None:
    """Return the inverse of a distribution function, of either of scipy's kinds."""
    return getattr(given, "ppf", None) or getattr(given, "icdf", None)


def _shares(
    drawn: Collection[str],
    places: Mapping[str, Place],
    count: int,
    seed: int | None,
    design: Design | None,
) -> dict[str, Array]:
    """Return of each distribution the shares (n,), 0 to 1, at which its values are read off."""
    for path in drawn:
        if places[path].vector:
            raise RuleError(
                f"vary {path!r}: a distribution has one number, and this is a vector (R2). Vary "
                f"'{path}.x' and '{path}.y', or give pairs of values.",
                "vary",
            )
    if not drawn:
        return {}
    if design is None:
        return {path: _stream(checked_seed(seed), path).random(count) for path in drawn}
    if not callable(design):
        raise RuleError(
            f"design: found {shown(design)}: must be a class of scipy.stats.qmc, which is given "
            "the number of distributions and the seed's random numbers (R5). Give it without "
            "brackets, such as design=qmc.Sobol, or functools.partial(qmc.Sobol, scramble=False).",
            "design",
        )
    rows = design(d=len(drawn), rng=_stream(checked_seed(seed), "design")).random(count)
    return {path: rows[:, k] for k, path in enumerate(drawn)}


def random_stream(seed: int, world: int) -> np.random.Generator:
    """Return the random numbers of one world."""
    return np.random.default_rng(np.random.SeedSequence(seed, spawn_key=(world,)))


def _stream(seed: int, name: str) -> np.random.Generator:
    key = int.from_bytes(hashlib.sha256(name.encode()).digest()[:8])
    return np.random.default_rng(np.random.SeedSequence([seed, key]))


def checked_values(given: Any, place: Place, count: int) -> Array:
    """Return the values of a place (n,) or (n, 2), or raise `RuleError`."""
    values = _numbers(given, place)
    shape = (count, 2) if place.vector else (count,)
    if values.shape != shape:
        raise RuleError(
            f"vary {place.path!r}: found an array of shape {values.shape}: must be {shape}, "
            f"{'a pair' if place.vector else 'one number'} for each world (R2). Give it so.",
            "vary",
        )
    _refuse_out_of_range(values, place)
    return values + 0.0  # no negative zeros, as in any scene


def _numbers(given: Any, place: Place) -> Array:
    """Return numbers in SI units, also of texts with units."""
    try:
        plain = [_number(item, place) for item in given] if _texts(given) else given
        found = np.asarray(plain)
    except ValueError as fault:
        if isinstance(fault, RuleError):
            raise RuleError(f"vary {place.path!r}: {fault}", "vary") from None
        found = np.array(None)
    if found.dtype.kind not in "fiu":
        raise RuleError(
            f"vary {place.path!r}: found {shown(given)}: must be numbers in "
            f"{place.symbol.unit}, or texts with a unit (R2). Give them.",
            "vary",
        )
    return found.astype(np.float64)


def _texts(given: Any) -> bool:
    if isinstance(given, np.ndarray) and given.dtype.kind in "fiu":
        return False
    return any(isinstance(item, str | list | tuple) for item in given)


def _number(item: Any, place: Place) -> Any:
    if isinstance(item, str):
        return read_quantity(item, place.symbol.name, ("value",))
    return [_number(part, place) for part in item] if isinstance(item, list | tuple) else item


def _refuse_out_of_range(values: Array, place: Place) -> None:
    limits, symbol = place.symbol.range, place.symbol
    good = (values >= limits.least) & (values <= limits.most)  # nan is neither
    if good.all():
        return
    world = int(np.argwhere(~good)[0][0])
    unit = "" if symbol.unit == "1" else f" {symbol.unit}"
    rule = symbol.rule if np.isfinite(values[world]).all() else "must be finite (R4)"
    raise RuleError(
        f"vary {place.path!r}: found {shown(values[world].tolist())}{unit} for world {world}: "
        f"{rule}. Give values, or a distribution, within it.",
        "vary",
    )
