"""Whether arrays that anybody may have made are the state of an engine.

Compiled code follows an index wherever it leads, so that each is checked: its range by what
`tables` says of the array, and that indices agree with each other.
"""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tamias2d.engine import tables as tb
from tamias2d.engine.arrays.world import Capacities, SavedField, saved_fields
from tamias2d.engine.narrow_phase.axis_cache import SIDES, STATES, TURNS
from tamias2d.engine.shapes.stated_surfaces import effective_surfaces
from tamias2d.engine.tables import Saved
from tamias2d.state import IntArray

Arrays = Mapping[str, NDArray[Any]]
_ROWS = {
    "slots": "state.pose",
    "shapes": "shapes.kind",
    "vertices": "shapes.local_vertices",
    "propagators": "state.drag_rates",
    "overrides": "shapes.pair_overrides",
    "contacts": "contacts.pairs",
    "candidates": "broad_phase.candidates",
}
"""The array that tells how many rows there are of what."""


class UnfitError(ValueError):
    """Arrays are not the state of an engine."""


def rows_of(arrays: Arrays) -> dict[str, int]:
    """Return how many rows there are in a saved state, by the names of `Capacities`."""
    return {axis: len(arrays[name]) for axis, name in _ROWS.items()}


def check_saved(arrays: Arrays) -> Capacities:
    """Return the capacities of a saved state.

    Raises:
        UnfitError: the arrays are not the state of an engine; names the array.
    """
    capacities = _capacities(arrays)
    lengths = capacities.lengths()
    for field in saved_fields():
        _check_field(field, arrays, lengths)
    _check_bodies(arrays)
    _check_shapes(arrays)
    order = _canonical(arrays)
    _check_contacts(arrays, order)
    _check_tree(arrays)
    return capacities


def require(holds: object, name: str, rule: str) -> None:
    """Raise `UnfitError` unless something holds of an array."""
    if not np.all(holds):  # type: ignore[call-overload]
        raise UnfitError(f"{name}: {rule}")


# -- each array alone


def _capacities(arrays: Arrays) -> Capacities:
    for name in _ROWS.values():
        require(name in arrays and arrays[name].ndim > 0, name, "is missing")
    rows = rows_of(arrays)
    fits = rows["slots"] > 0 and rows["slots"] % tb.CHUNK == 0 and rows["propagators"] > 0
    require(fits, "state.pose", "has no rows of an engine")
    require(max(rows.values()) < 2**31, "shapes.kind", "has more rows than an engine")
    return Capacities(**rows)


def _check_field(field: SavedField, arrays: Arrays, lengths: Mapping[str, int]) -> None:
    shape = tuple(lengths[n] if isinstance(n, str) else n for n in field.shape)
    found = arrays.get(field.name)
    if found is None or found.dtype != field.dtype or found.shape != shape:
        what = "nothing" if found is None else f"{found.dtype} of shape {found.shape}"
        raise UnfitError(f"{field.name}: found {what}: must be {field.dtype} of shape {shape}")
    if found.dtype.kind == "f":
        bad = {"any": False, "finite": ~np.isfinite(found), "infinite": np.isnan(found)}
        require(~np.asarray(bad[field.saved.numbers]), field.name, "must be numbers")
    for values, below in _bounded(found, field.saved):
        most = max(lengths[below] if isinstance(below, str) else below, 1)  # rows not in use are 0
        fits = (values >= 0) & (values < most) & (values == np.floor(values))
        require(fits, field.name, f"must be whole numbers from 0 on, below {most}")


def _bounded(found: NDArray[Any], saved: Saved) -> list[tuple[NDArray[Any], int | str]]:
    """Return the whole numbers of an array, each with their bound."""
    if isinstance(saved.below, Mapping):
        return [(found[..., column], below) for column, below in saved.below.items()]
    return [] if saved.below is None else [(found, saved.below)]


# -- arrays beside each other


def _check_bodies(arrays: Arrays) -> None:
    kind, rank = arrays["state.kind"], arrays.get("rank")
    slots = arrays["state.slot_of_body"]
    name = "state.slot_of_body"
    require(np.bincount(slots, minlength=len(slots)) == 1, name, "gives two bodies one slot")
    require(
        slots[-1] == len(slots) - 1 and kind[-1] == tb.ABSENT, name, "the last one must be idle"
    )
    if rank is None or rank.dtype != np.int64 or rank.ndim != 1 or len(rank) >= len(kind):
        raise UnfitError("rank: must be int64, one for each body")
    require(slots[: len(rank)] < len(rank), name, "bodies must have the first slots")
    present = kind != tb.ABSENT
    require(~present[len(rank) :], "state.kind", "has more bodies than there are ranks")
    require((rank >= 0) == present[: len(rank)], "rank", "must be given to bodies alone")
    there = rank[rank >= 0]
    require(rank >= -1, "rank", "must be -1 or more")
    require(rank < 2**62, "rank", "is too large")
    require(len(np.unique(there)) == len(there), "rank", "must differ")
    generation = arrays.get("generation")
    if generation is None or generation.dtype != np.int64 or generation.shape != rank.shape:
        raise UnfitError("generation: must be int64, one for each body")
    require(generation >= present[: len(rank)], "generation", "must count the bodies of a row")
    properties = arrays["state.properties"]
    require(properties[~present] == 0.0, "state.properties", "must be 0 where there is no body")
    inverse = properties[:, [tb.INVERSE_MASS, tb.INVERSE_INERTIA]]
    require(np.isfinite(inverse), "state.properties", "masses must be numbers")
    require(properties >= 0.0, "state.properties", "must not be negative")
    moves = (inverse[:, 0] > 0.0) == (kind == tb.DYNAMIC)
    require(moves, "state.properties", "bodies that move must have masses, and no others")
    turns = (inverse[:, 1] == 0.0) | (kind == tb.DYNAMIC)
    require(turns, "state.properties", "bodies that do not move must have no inertia")
    require(arrays["state.drag_rates"] >= 0.0, "state.drag_rates", "must not be negative")


def _check_shapes(arrays: Arrays) -> None:
    kind, first, count = (
        arrays[f"shapes.{n}"].astype(np.int64) for n in ("kind", "first", "vertex_count")
    )
    name = "shapes.vertex_count"
    taken = count > 0
    require(taken[:-1] >= taken[1:], name, "rows that were never taken must come last")
    lines = (kind == tb.CAPSULE) | (kind == tb.THIN_CAPSULE) | (kind >= tb.PIECE)
    least = np.select([lines, (kind == tb.DISC) | (kind == tb.HALF_PLANE)], [2, 1], 3)
    most = np.where(least == 3, 2**31, least)
    require(~taken | ((count >= least) & (count <= most)), name, "must fit the kinds of shapes")
    require(first + count <= len(arrays["shapes.local_vertices"]), name, "there are no such rows")
    require(count.sum() <= len(arrays["shapes.local_vertices"]), name, "is too large in all")
    owner, idle = arrays["state.body_of_shape"], len(arrays["state.kind"]) - 1
    there = arrays["state.kind"][owner] != tb.ABSENT
    require(there | (owner == idle), "state.body_of_shape", "names a body that is absent")
    require(taken | (owner == idle), "state.body_of_shape", "a body has a shape without vertices")
    require(arrays["shapes.radius"] >= 0.0, "shapes.radius", "must not be negative")
    stated, name = arrays["shapes.stated"], "shapes.stated"
    require(stated >= -1.0, name, "must not be negative")
    restitution = stated[:, [tb.BY_PART + tb.RESTITUTION, tb.BY_BODY + tb.RESTITUTION]]
    require(restitution <= 1.0, name, "restitution must be at most 1")
    surfaces = arrays["shapes.material"][:, : tb.SURFACE_SPEED]
    fits = surfaces == effective_surfaces(stated)
    require(fits, "shapes.material", "must follow from what is stated")
    overrides = arrays["shapes.pair_overrides"]
    require(overrides[:, 0] < overrides[:, 1], "shapes.pair_overrides", "lower shapes come first")
    code = overrides[:, 0] * len(kind) + overrides[:, 1]
    require(np.diff(code) > 0, "shapes.pair_overrides", "must be in the order of shapes")
    require(overrides[:, 3] <= 1.0, "shapes.pair_overrides", "restitution must be at most 1")


def _canonical(arrays: Arrays) -> IntArray:
    """Return the rank of each shape, -1 for one without a body."""
    owner = arrays["state.body_of_shape"]
    rank = np.full(len(arrays["state.kind"]), -1)
    rank[: len(arrays["rank"])] = arrays["rank"]
    ranked = np.flatnonzero(rank[owner] >= 0)
    ranked = ranked[np.argsort(rank[owner[ranked]], kind="stable")]
    order = np.full(len(owner), -1)
    order[ranked] = np.arange(len(ranked))
    return order


def _check_contacts(arrays: Arrays, order: IntArray) -> None:
    counts, pairs = arrays["broad_phase.counts"], arrays["contacts.pairs"]
    fits = counts[tb.FIRST_RUN] <= counts[tb.CONTACTS] <= len(pairs)
    require(fits, "broad_phase.counts", "a run is longer than the list")
    pairs, flags = (
        arrays[f"contacts.{name}"][: counts[tb.CONTACTS]] for name in ("pairs", "flags")
    )
    fits = 1 <= counts[tb.HORIZON] <= 2**20 and counts[tb.LIST_HOLDS] <= 1
    require(fits, "broad_phase.counts", "must be those of a list of pairs")
    require(len(order) > 0 or len(pairs) == 0, "contacts.pairs", "there are no shapes")
    name, shapes = "contacts.pairs", pairs[:, :2].astype(np.int64)
    body = arrays["state.body_of_shape"][shapes]
    slots = arrays["state.slot_of_body"][body]
    require(
        pairs[:, tb.SLOT_A : tb.SLOT_B + 1] == slots, name, "must have the slots of their bodies"
    )
    require(body[:, 0] != body[:, 1], name, "must be of two bodies")
    sensors = (arrays["shapes.filters"][shapes, tb.SENSOR] > 0).any(axis=1)
    fastest = arrays["state.kind"][body].max(axis=1, initial=tb.ABSENT)
    fits = fastest >= np.where(sensors, tb.KINEMATIC, tb.DYNAMIC)
    require(fits, name, "one of the bodies must move, freely unless one is a sensor")
    ranks = order[shapes]
    require((ranks >= 0).all() and (ranks[:, 0] < ranks[:, 1]).all(), name, "must be by rank")
    code = ranks[:, 0] * len(order) + ranks[:, 1]
    require(len(np.unique(code)) == len(code), name, "must differ")
    for run in (code[: counts[tb.FIRST_RUN]], code[counts[tb.FIRST_RUN] :]):
        require(np.diff(run) > 0, name, "must be in canonical order")
    kinds = arrays["shapes.kind"][shapes]
    require((kinds != tb.HALF_PLANE).any(axis=1), name, "two half-planes never meet")
    sides = flags[:, tb.CACHED_AXIS].astype(np.int64) // (STATES * TURNS)
    known = np.column_stack((sides % SIDES, sides // SIDES)) < arrays["shapes.vertex_count"][shapes]
    require(known, "contacts.flags", "names a side that a shape has not")
    require(sensors == flags[:, tb.SENSES], "contacts.flags", "must say which shapes are sensors")


def _check_tree(arrays: Arrays) -> None:
    if arrays["broad_phase.counts"][tb.LIST_HOLDS] == 0:
        return
    leaves = leaves_of(arrays["shapes.kind"], arrays["state.kind"], arrays["state.body_of_shape"])
    places = np.sort(arrays["tree.leaf_of_shape"][leaves])
    require(places == np.arange(len(leaves)), "tree.leaf_of_shape", "must be one for each shape")


def leaves_of(kind: NDArray[Any], body_kind: NDArray[Any], owner: NDArray[Any]) -> IntArray:
    """Return the shapes that are leaves of the tree: the bounded ones of bodies."""
    return np.flatnonzero((kind != tb.HALF_PLANE) & (body_kind[owner] != tb.ABSENT))
