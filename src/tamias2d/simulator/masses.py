"""What bodies weigh, and how drag slows them, as an engine has it and as it is changed."""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from tamias2d.engine import tables as tb
from tamias2d.engine.engine import Engine
from tamias2d.simulator.batch import drag_rates
from tamias2d.state import Array, IntArray


class Masses(NamedTuple):
    """What k bodies weigh, each array (k,); infinite where nothing pushes or turns them."""

    mass: Array
    """kg"""
    inertia: Array
    """kg m^2"""
    linear_drag: Array
    """kg/s"""
    angular_drag: Array
    """kg m^2/s"""


def masses_now(engine: Engine, rows: IntArray | Sequence[int]) -> Masses:
    """Return what bodies weigh."""
    rates = _rates_now(engine, rows)
    with np.errstate(divide="ignore", invalid="ignore"):
        mass, inertia = 1 / engine.inverse_mass[rows], 1 / engine.inverse_inertia[rows]
        drags = np.where(rates > 0.0, rates * np.column_stack((mass, inertia)), 0.0)
    return Masses(mass, inertia, *drags.T)


class Weights(NamedTuple):
    """What an engine is told of k bodies that weigh other numbers, by `Engine.set_masses`."""

    columns: Mapping[int, Array]
    """(k,), of properties"""
    rates: Array
    """(k, 2), of drag, 1/s"""


def weights(engine: Engine, rows: IntArray, now: Masses, new: Masses) -> Weights | None:
    """Return what lets bodies that weigh so much now weigh other numbers, None if all stay.

    What stays the same keeps its bits.

    Raises:
        InputError: float64 cannot hold what drag does.
    """
    heavy, turned = new.mass != now.mass, new.inertia != now.inertia
    slowed = np.column_stack(
        (
            heavy | (new.linear_drag != now.linear_drag),
            turned | (new.angular_drag != now.angular_drag),
        )
    )
    if not slowed.any():
        return None
    rates = np.column_stack(drag_rates(new.linear_drag, new.mass, new.angular_drag, new.inertia))
    columns = {
        tb.INVERSE_MASS: np.where(heavy, 1 / new.mass, engine.inverse_mass[rows]),
        tb.INVERSE_INERTIA: np.where(turned, 1 / new.inertia, engine.inverse_inertia[rows]),
    }
    return Weights(columns, np.where(slowed, rates, _rates_now(engine, rows)))


def _rates_now(engine: Engine, rows: IntArray | Sequence[int]) -> Array:
    """Return the rates (k, 2) at which drag slows bodies, 1/s."""
    state = engine.world.state
    found: Array = state.drag_rates[state.properties[rows, tb.PROPAGATOR].astype(np.int64)]
    return found
