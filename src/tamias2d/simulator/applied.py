"""Impulses and forces that are applied at points, as changes of a body's row (IM2, IM3)."""

import numpy as np

from tamias2d.engine.engine import Engine
from tamias2d.engine.tables import DYNAMIC
from tamias2d.generated import definitions, impact
from tamias2d.scene.rules import RuleError
from tamias2d.simulator.columns import vectors
from tamias2d.state import Array, IntArray

_OF = "the bodies"


def velocity_changes(engine: Engine, rows: IntArray, impulse: object, at: object) -> Array:
    """Return the changes of velocity and angular velocity (k, 3) by impulses, N s, at points."""
    remedy = "Give (x, y) in N s."
    given = vectors(impulse, "impulse", _OF, remedy, count=len(rows), symbol="impulse_vector")
    push = _pair(given)
    changes = np.zeros((len(rows), 3))
    arms = _arms(engine, rows, at)
    with np.errstate(all="ignore"):  # what overflows is refused
        changes[:, 0], changes[:, 1] = impact.velocity_b_after(
            (0.0, 0.0), 1.0, push, engine.inverse_mass[rows]
        )
        changes[:, 2] = impact.angular_velocity_b_after(
            0.0, 1.0, arms, push, engine.inverse_inertia[rows]
        )
    return changes


def applied_loads(engine: Engine, rows: IntArray, force: object, at: object) -> Array:
    """Return the loads (k, 3), N and N m, by forces at points; 0 of what nothing can push."""
    push = vectors(force, "force", _OF, "Give (x, y) in N.", count=len(rows), symbol="force")
    arms = _arms(engine, rows, at)
    with np.errstate(all="ignore"):
        loads = np.column_stack((push, definitions.torque(arms, _pair(push))))
    loads[engine.kind[rows] != DYNAMIC] = 0.0
    return loads


def add_rows(values: Array, rows: IntArray, changes: Array, what: str) -> None:
    """Add changes (k, 3) to rows, one after another where a row is meant twice.

    Raises:
        InputError: float64 cannot hold what comes out; then nothing is added.
    """
    before = values[rows]
    with np.errstate(all="ignore"):
        for column, change in zip(values.T, changes.T, strict=True):  # faster than all at once
            np.add.at(column, rows, change)
    good = np.isfinite(values[rows]).all(axis=1)
    if not good.all():
        values[rows] = before
        raise RuleError(
            f"{what}[{int(np.argmin(good))}] of {_OF}: what it does is beyond what float64 holds, "
            "about 1e308 (R4). Give a smaller one, or a nearer point.",
            what,
        )


def _arms(engine: Engine, rows: IntArray, at: object) -> tuple[Array, Array]:
    """Return the arms from centres of mass to points, m; 0 where no point is given."""
    if at is None:
        return np.zeros(len(rows)), np.zeros(len(rows))
    remedy = "Give points of the world (x, y) in m."
    points = vectors(at, "at", _OF, remedy, count=len(rows), symbol="position")
    return _pair(points - engine.pose[rows, :2])


def _pair(rows: Array) -> tuple[Array, Array]:
    return rows[:, 0], rows[:, 1]
