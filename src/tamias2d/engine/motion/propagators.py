"""Propagators of drag (DD41): one row stands for all bodies that drag slows alike."""

from collections.abc import Sequence
from itertools import count

import numpy as np

from tamias2d.engine import tables as tb
from tamias2d.engine.arrays.store import Store
from tamias2d.engine.parts import part_substeps
from tamias2d.generated import drag
from tamias2d.generated.definitions import slowed_share
from tamias2d.generated.joint_step import half_decay, slowed_mean
from tamias2d.state import Array, IntArray

_ONE, _OTHER, _NONE = (1.0, 0.0), (0.0, 1.0), (0.0, 0.0)
_FEW = 2  # rows, of which one is always used: twice as many as that


class Propagators:
    """The rows of propagators of an engine, by their rates of drag."""

    def __init__(self, store: Store) -> None:
        """Compute the rows for the rates that a store holds: zeros where it is new."""
        self._store = store
        self._set(store.world.state.drag_rates.copy())
        self._note_rows()

    def assign(self, rows: IntArray, rates: Array) -> None:
        """Let bodies slow down at their rates (k, 2), 1/s: of the velocity, and of the spin."""
        found = self.rows_of([*map(tuple, rates.tolist())])
        self._store.world.state.properties[rows, tb.PROPAGATOR] = found

    def rows_of(self, wanted: Sequence[tuple[float, float]]) -> list[int]:
        """Return the rows of propagators for pairs of rates, 1/s, after adding new ones."""
        if new := sorted(set(wanted).difference(self._row)):
            self._row.update(zip(new, count(len(self._row)), strict=False))
            known = self._store.world.state.drag_rates
            self._set(np.concatenate((known, np.array(new))))
        return [self._row[rate] for rate in wanted]

    def forget_unused(self) -> None:
        """Give up the rows that no body uses, where these are most."""
        if len(self._row) <= _FEW:
            return
        state, bodies = self._store.world.state, self._store.world.bodies
        used, which = np.unique(
            state.properties[:, tb.PROPAGATOR].astype(np.int64), return_inverse=True
        )
        if len(self._row) > 2 * len(used):
            state.properties[:, tb.PROPAGATOR] = which.ravel()
            bodies.properties[state.slot_of_body, tb.PROPAGATOR] = state.properties[
                :, tb.PROPAGATOR
            ]
            self._set(state.drag_rates[used])
            self._note_rows()

    def _set(self, rates: Array) -> None:
        """Let row k be the propagator for rates (k, 2), 1/s."""
        self._store.resize(propagators=len(rates))
        world = self._store.world
        world.state.drag_rates[:] = rates
        settings, counts = world.control.settings, world.control.counts
        levels = range(tb.MOST_LEVEL + 1)
        times = settings[tb.TIME_STEP] / 2.0 ** np.array(levels)
        substeps = [part_substeps(int(counts[tb.SUBSTEPS]), level) for level in levels]
        world.bodies.propagators_of_level[:] = propagators(rates, times, np.array(substeps))
        world.bodies.propagators[:] = world.bodies.propagators_of_level[0]

    def _note_rows(self) -> None:
        rates = self._store.world.state.drag_rates.tolist()
        self._row = {tuple(pair): k for k, pair in enumerate(rates)}


def propagators(rates: Array, times: Array, substeps: IntArray) -> Array:
    """Return (l, k, 20), how bodies move in times (l,), s, and in a substep of each.

    Rates are (k, 2). All are computed at once: of few bodies, calls cost more than numbers.
    """
    lengths = np.stack((times, times / substeps), axis=-1)[:, None, :, None]
    slowed = rates[:, None, :]
    decay = drag.velocity(_ONE, _NONE, slowed, lengths)[0]
    gain, lift = drag.position(_NONE, _ONE, _OTHER, slowed, lengths)
    left = slowed_share(gain, lengths)
    mean = slowed_mean(left, half_decay(decay), substeps[:, None, None, None])
    columns = np.stack((decay, gain, lift, left, mean), axis=-1)
    return columns.reshape(len(times), len(rates), 20)
