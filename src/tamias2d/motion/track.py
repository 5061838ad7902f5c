"""The whole path of each body, sampled from its pieces."""

from collections.abc import Sequence

import numpy as np

from tamias2d.path import PathPiece
from tamias2d.state import Array, History, State


def sample(tracks: Sequence[Sequence[PathPiece]], times: Array) -> History:
    """Return the states of n bodies at sorted times (k,), s, from their pieces in order of time.

    At the instant at which one piece gives way to the next, the next one speaks.
    """
    rows = np.empty((len(times), len(tracks), 6))
    for body, pieces in enumerate(tracks):
        rows[:, body] = _along(pieces, times)
    return History(
        rows[..., :2].copy(), rows[..., 2].copy(), rows[..., 3:5].copy(), rows[..., 5].copy()
    )


def columns(state: State, times: Array) -> Array:
    """Return (k, 6) from a state whose quantities are numbers or arrays (k,), for k times."""
    position, orientation, velocity, angular_velocity = state
    values = (*position, orientation, *velocity, angular_velocity)
    return np.stack([np.broadcast_to(value, times.shape) for value in values], axis=-1)


def _along(pieces: Sequence[PathPiece], times: Array) -> Array:
    starts = np.array([piece.start for piece in pieces])
    which = np.searchsorted(starts, times, side="right") - 1
    rows = np.empty((len(times), 6))
    edges = np.flatnonzero(np.diff(which)) + 1
    for chosen in np.split(np.arange(len(times)), edges):
        if len(chosen):
            rows[chosen] = pieces[which[chosen[0]]].sample(times[chosen])
    return rows
