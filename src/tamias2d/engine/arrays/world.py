"""The arrays of a world: allocated, made longer, and named, as `tables` declares them."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tamias2d.engine import tables as tb
from tamias2d.engine.arrays.memory import LINE, aligned_zeros
from tamias2d.engine.broad_phase.bvh import first_leaf_node
from tamias2d.engine.tables import BodyState, Contacts, Rewritten, Saved, Sized, World
from tamias2d.kernels.groups import array_type, fields_of, is_group


@dataclass(frozen=True)
class Capacities:
    """Capacities: the lengths of the axes of all arrays follow from these numbers."""

    slots: int = tb.CHUNK  # one more than bodies, whole chunks
    shapes: int = 0
    vertices: int = 0
    propagators: int = 1
    overrides: int = 0
    candidates: int = 16
    contacts: int = 16
    blocks: int = 4
    sparse: int = 2
    springs: int = 0
    members: int = 0  # bodies that springs hold
    networks: int = 1  # one more than networks of springs
    joints: int = 0
    joined: int = 0  # the plane, and bodies that joints hold
    turned: int = 0  # the same, with whole lanes behind the last
    mechanisms: int = 1  # one more than mechanisms
    joint_sparse: int = 0
    tree_blocks: int = 1  # one more than blocks of equal trees
    tree_rows: int = 0
    apart_bodies: int = 1  # one more than rows that joints keep apart from others
    apart: int = 0
    equations: int = 0  # joints that a scene states by equations of its own
    operations: int = 0
    scalars: int = 0
    clip: int = 9  # vertices of two shapes, and one

    def lengths(self) -> dict[str, int]:
        """Return the lengths that `tables` names."""
        events = self.slots + self.contacts
        return {
            **vars(self),
            "ranks": self.shapes + 1,
            "nodes": 2 * first_leaf_node(self.shapes),
            "pair_bodies": 2 * self.contacts + self.members + self.joined,
            "impact_points": tb.POINTS_OF_MEMBER * self.joined,
            "events": events,
            "queue": 2 * events + 2,
            "chunks": self.slots // tb.CHUNK,
            "streams": self.slots // tb.CHUNK + 1,
        }


def allocated(capacities: Capacities) -> World:
    """Return a world of zeros with some capacities."""
    lengths = capacities.lengths()
    return _with_views(_made(World, lengths))


def resized(world: World, before: Capacities, capacities: Capacities) -> World:
    """Return the world with other capacities: arrays keep what they hold, as far as it fits."""
    old, lengths = before.lengths(), capacities.lengths()
    changed = {name: length for name, length in lengths.items() if length != old[name]}
    return _with_views(_fitted(world, changed))


def named_arrays(world: World) -> dict[str, NDArray[Any]]:
    """Return all declared arrays by their names, such as 'bodies.pose'."""
    return dict(_named(world, ""))


def arrays_by_slot(world: World) -> Iterator[NDArray[Any]]:
    """Yield the arrays that have a row for each slot of a body."""
    groups: tuple[Any, ...] = world
    for group in groups:
        own: Any = type(group)
        for name, declared in _declared(own).items():
            by_body = isinstance(group, BodyState)
            if declared is not None and declared[1].shape[0] == "slots" and not by_body:
                yield getattr(group, name)


def gathered(world: World) -> tuple[World, NDArray[np.uint8], int]:
    """Return the world with arrays that lie in one piece of memory, and that memory.

    The last number is how many bytes of it matter to a world that begins anew: they come first.
    """
    arrays = named_arrays(world)
    last = _rewritten()
    arrays = dict(sorted(arrays.items(), key=lambda item: item[0] in last))
    lines = [-(-values.nbytes // LINE) for values in arrays.values()]
    starts = LINE * (np.cumsum(lines) - lines)
    memory = aligned_zeros(LINE * sum(lines), np.uint8)
    moved = {}
    for (name, values), start in zip(arrays.items(), starts.tolist(), strict=True):
        place = memory[start : start + values.nbytes].view(values.dtype).reshape(values.shape)
        place[...] = values
        moved[name] = place
    needed = sum(size for name, size in zip(arrays, lines, strict=True) if name not in last)
    return with_arrays(world, moved), memory, LINE * needed


def lasting_arrays(world: World) -> dict[str, NDArray[Any]]:
    """Return the arrays that hold something from one step to the next, by their names."""
    left_out = _rewritten()
    return {name: values for name, values in _named(world, "") if name not in left_out}


@cache
def _rewritten() -> frozenset[str]:
    """Return the names of the arrays that a world which begins anew does not read before."""
    return frozenset(_rewritten_in(World, ""))


def _rewritten_in(group: type, prefix: str) -> Iterator[str]:
    for name, hint in fields_of(group).items():
        if is_group(hint):
            yield from _rewritten_in(hint, f"{prefix}{name}.")
        elif any(isinstance(m, Rewritten) for m in getattr(hint, "__metadata__", ())):
            yield f"{prefix}{name}"


def in_use(world: World, slots: int) -> World:
    """Return the world as steps see it: of arrays that have a row for each slot, the first ones.

    So a step costs what its bodies cost, whatever the capacity. What users see stays whole: it goes
    into chunks.
    """
    seen: World = _shortened(world, slots)
    return seen


def _shortened(group: Any, slots: int) -> Any:
    kind: Any = type(group)
    cut = {}
    for name, declared in _declared(kind).items():
        if isinstance(declared, type):
            cut[name] = _shortened(getattr(group, name), slots)
        elif _is_shortened(kind, name):
            cut[name] = getattr(group, name)[:slots]
    return group._replace(**cut)


def _is_shortened(group: type, name: str) -> bool:
    declared = _declared(group)[name]
    by_slot = declared is not None and declared[1].shape[0] == "slots"
    return by_slot and (group is not BodyState or name == "body_of_slot")


@cache
def shortened_rows() -> NDArray[np.intp]:
    """Return which arrays of a world `in_use` shortens, counted through all of them."""
    return np.flatnonzero(list(_are_shortened(World)))


def _are_shortened(group: type) -> Iterator[bool]:
    for name, declared in _declared(group).items():
        if isinstance(declared, type):
            yield from _are_shortened(declared)
        else:
            yield _is_shortened(group, name)


def with_arrays(world: World, arrays: Mapping[str, NDArray[Any]]) -> World:
    """Return the world with some arrays, by their names, in the place of its own."""
    for name, values in arrays.items():
        group, _, field = name.partition(".")
        part = getattr(world, group)._replace(**{field: values})
        world = world._replace(**{group: part})
    return _with_views(world)


def _made(group: type, lengths: Mapping[str, int]) -> Any:
    """Return a group of zeros."""
    values: dict[str, Any] = {}
    for name, declared in _declared(group).items():
        values[name] = None
        if isinstance(declared, type):
            values[name] = _made(declared, lengths)
        elif declared is not None:
            kind, sized = declared
            shape = [lengths[n] if isinstance(n, str) else n for n in sized.shape]
            values[name] = aligned_zeros(tuple(shape), kind)
    return group(**values)


def _fitted(group: Any, changed: Mapping[str, int]) -> Any:
    """Return a group some of whose axes have other lengths; arrays without them are the same."""
    kind: Any = type(group)
    values = {}
    for name, declared in _declared(kind).items():
        before = getattr(group, name)
        if isinstance(declared, type):
            values[name] = _fitted(before, changed)
        elif declared is not None and not changed.keys().isdisjoint(declared[1].shape):
            axes = zip(declared[1].shape, before.shape, strict=True)
            values[name] = _copied(before, tuple(changed.get(n, length) for n, length in axes))
    return group._replace(**values)


class SavedField(NamedTuple):
    """An array of the saved state, as `tables` declares it."""

    name: str
    """such as 'state.pose'"""
    dtype: np.dtype[Any]
    shape: tuple[int | str, ...]
    saved: Saved


@cache
def saved_fields() -> tuple[SavedField, ...]:
    """Return the declarations of the saved state; of the contact buffers, of the one in use."""
    return (*_saved_in(World, ""), *_saved_in(Contacts, "contacts."))


def _saved_in(group: type, prefix: str) -> Iterator[SavedField]:
    known = _declared(group)
    for name, hint in fields_of(group).items():
        if is_group(hint):
            yield from _saved_in(hint, f"{prefix}{name}.")
        elif saved := next((m for m in hint.__metadata__ if isinstance(m, Saved)), None):
            dtype, sized = known[name]
            yield SavedField(f"{prefix}{name}", dtype, sized.shape, saved)


@cache
def _declared(group: type) -> dict[str, Any]:
    """Return of each field its group, or its type of number and size; None for a view."""
    found: dict[str, Any] = {}
    for name, hint in fields_of(group).items():
        sized = next((m for m in getattr(hint, "__metadata__", ()) if isinstance(m, Sized)), None)
        kind = (array_type(hint) or "").partition("[")[0]
        found[name] = hint if is_group(hint) else (np.dtype(kind), sized) if sized else None
    return found


def _copied(old: NDArray[Any], shape: tuple[int, ...]) -> NDArray[Any]:
    new = aligned_zeros(shape, old.dtype)
    common = tuple(slice(min(a, b)) for a, b in zip(old.shape, shape, strict=True))
    new[common] = old[common]
    return new


def _with_views(world: World) -> World:
    """Return the world with its chunks, which look at the state of the bodies."""
    state = world.state
    poses, velocities, loads = (
        values.reshape(-1, tb.CHUNK_LANES) for values in (state.pose, state.velocity, state.load)
    )
    chunks = world.chunks._replace(
        poses=poses, velocities=velocities, loads=loads, load_bits=loads.view(np.int64)
    )
    return world._replace(chunks=chunks)


def _named(group: Any, prefix: str) -> Iterator[tuple[str, NDArray[Any]]]:
    kind: Any = type(group)
    for name, declared in _declared(kind).items():
        value = getattr(group, name)
        if isinstance(declared, type):
            yield from _named(value, f"{prefix}{name}.")
        elif declared is not None:
            yield f"{prefix}{name}", value
