"""The saved state of an engine as plain arrays, and an engine that continues from them.

Saved are the arrays that `tables` marks, the contacts in use, and the canonical order; all other
arrays follow from these, or hold nothing from one step to the next.
"""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tamias2d.engine import tables as tb
from tamias2d.engine.arrays.world import named_arrays, saved_fields
from tamias2d.engine.engine import Engine
from tamias2d.engine.saving.saved_checks import check_saved, leaves_of, rows_of
from tamias2d.engine.tables import Contacts, World

Arrays = Mapping[str, NDArray[Any]]
_KNOWN_BY = (
    *("state.body_of_shape", "state.drag_rates"),
    *("shapes.kind", "shapes.first", "shapes.vertex_count", "shapes.radius"),
    "shapes.local_vertices",
)
"""From these follows what an engine knows of bodies besides, as long as the same are there."""


def saved_arrays(engine: Engine) -> dict[str, NDArray[Any]]:
    """Return copies of the state of an engine that has settled, by names such as 'state.pose'."""
    own, counts = named_arrays(engine.world), engine.world.broad_phase.counts
    side, size = int(counts[tb.BUFFER]), int(counts[tb.CONTACTS])
    own |= {f"contacts.{name}": own[f"buffers.{name}"][side] for name in Contacts._fields}
    found = {field.name: own[field.name].copy() for field in saved_fields()}
    for name in ("contacts.pairs", "contacts.manifolds", "contacts.axes", "contacts.flags"):
        found[name][size:] = 0
    found["broad_phase.candidates"][...] = 0
    found["touching.counts"][[tb.ARRANGED, tb.ISLANDS_KNOWN]] = 0
    found["broad_phase.counts"][[tb.BUFFER, tb.CONTACTS]] = 0, size
    return {**found, "rank": engine.rank.copy(), "generation": engine.generation.copy()}


def restored_engine(
    arrays: Arrays, *, time_step: float, substeps: int, steps: int, parts: int, compiled: bool
) -> Engine:
    """Return an engine that continues from arrays with the same bits.

    Anybody may have made the arrays; none is used before all are checked.

    Raises:
        UnfitError: they are not the state of an engine.
    """
    capacities = check_saved(arrays)
    engine = Engine(gravity=(0.0, 0.0), time_step=time_step, substeps=substeps, compiled=compiled)
    engine.resize(**vars(capacities))
    _fill(engine.world, arrays)
    engine.world.control.settings[tb.TIME_STEP] = time_step
    engine.world.control.counts[tb.STEPS_TAKEN] = steps
    engine.world.control.counts[tb.FINEST] = parts.bit_length() - 1
    engine.size = len(arrays["rank"])
    engine.begin(arrays["rank"].copy(), arrays["generation"].copy())
    engine.know_corners()
    if engine.world.broad_phase.counts[tb.LIST_HOLDS]:
        _derive_list(engine.world)
    return engine


def rewind(engine: Engine, start: Arrays) -> None:
    """Bring an engine back to what `saved_arrays` told of it before its first step.

    The arrays of its bodies stay where they are; none may have come or gone since, but they may
    have been altered.
    """
    own = named_arrays(engine.world)
    known = all(np.array_equal(own[name], start[name]) for name in _KNOWN_BY)
    engine.resize(**rows_of(start))  # a list follows from these
    _fill(engine.world, start)
    if not known:
        engine.begin(start["rank"].copy(), start["generation"].copy())
        engine.forms += 1
    engine.start_over()


def _fill(world: World, arrays: Arrays) -> None:
    """Fill all arrays with a saved state, and with what follows from it."""
    own = named_arrays(world)
    for field in saved_fields():
        if field.name in own:
            own[field.name][...] = arrays[field.name]
    _derive(world, arrays)


def _derive(world: World, arrays: Arrays) -> None:
    """Fill the arrays that follow from the saved ones."""
    state, bodies, counts = world.state, world.bodies, world.broad_phase.counts
    slots = state.slot_of_body
    state.body_of_slot[slots] = np.arange(len(slots))
    bodies.properties[slots], bodies.kind[slots] = state.properties, state.kind
    world.shapes.slot[:] = np.minimum(slots[state.body_of_shape], len(arrays["rank"]))
    world.touching.counts[[tb.ARRANGED, tb.ISLANDS_KNOWN]] = counts[tb.BUFFER] = 0
    for name in Contacts._fields:
        getattr(world.buffers, name)[0] = arrays[f"contacts.{name}"]


def _derive_list(world: World) -> None:
    """Fill what is known of a list of pairs that holds."""
    leaf, shapes, state = world.tree.leaf_of_shape, world.shapes, world.state
    leaves = leaves_of(shapes.kind, state.kind, state.body_of_shape)
    world.tree.morton[tb.LEAF, leaf[leaves]] = leaves
    world.tree.counts[tb.LEAVES] = len(leaves)
    broad_phase = world.broad_phase
    firsts = world.buffers.pairs[0, : broad_phase.counts[tb.FIRST_RUN], 0]
    ranks = np.arange(len(broad_phase.first_of_rank))
    broad_phase.first_of_rank[:] = np.searchsorted(broad_phase.canonical[tb.RANK, firsts], ranks)
