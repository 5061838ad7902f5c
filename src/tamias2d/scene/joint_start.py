"""A joint as it is at the start: whether it holds, and by how much it is off."""

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tamias2d.scene.joints import Joint
from tamias2d.scene.placed_bodies import PlacedBodies, PlacedBody
from tamias2d.spec.constraint import ENDS
from tamias2d.spec.constraint_functions import Formula

_SMALLEST = 1e-150  # m: float64 cannot square what is shorter


class Start:
    """A joint as it is at the start: its rows, their slopes and rates."""

    def __init__(self, joint: Joint, bodies: PlacedBodies, time: float = 0.0) -> None:
        """Look at a joint at a time, s."""
        self.joint = joint
        values: dict[str, Any] = {"time": time, **joint.given}
        held = [None if k is None else bodies[k] for k in joint.ends]
        for end, body in zip(ENDS, held, strict=True):
            values[f"position_{end}"] = body.position if body else (0.0, 0.0)
            values[f"orientation_{end}"] = body.orientation if body else 0.0
            values[f"velocity_{end}"] = body.velocity if body else (0.0, 0.0)
            values[f"angular_velocity_{end}"] = body.angular_velocity if body else 0.0
        functions = joint.functions
        count = len(functions.units)
        self.rows = numbers_of(functions.constraint, values, count)
        self.rates = numbers_of(functions.rate, values, count)
        self.convective = numbers_of(functions.convective, values, count)
        self.slopes = {
            end: numbers_of(functions.slopes[end], values, 3 * count).reshape(-1, 3)
            for end in functions.bodies
        }
        self._held = {end: body for end, body in zip(ENDS, held, strict=True) if body}

    @property
    def turned(self) -> list[PlacedBody]:
        """The bodies that the joint turns, by some slope."""
        return [
            self._held[end]
            for end, slopes in self.slopes.items()
            if end in self._held and np.any(slopes[:, 2])
        ]

    @property
    def moves(self) -> bool:
        """Whether it can move a body that it holds, or turn one that can be turned."""
        return any(
            bool(np.any(slopes[:, : 2 if self._held[end].inertia == math.inf else 3]))
            for end, slopes in self.slopes.items()
            if end in self._held and self._held[end].dynamic
        )

    @property
    def steepness(self) -> tuple[tuple[float, float], ...]:
        """By how much each row changes for each m, and for each rad, of the bodies it holds."""
        moved, turned = steepness([self.slopes[end] for end in self._held if end in self.slopes])
        return tuple(zip(moved.tolist(), turned.tolist(), strict=True))

    @property
    def size(self) -> float:
        """A length that is not small in it, m."""
        places = [body.position for body in self._held.values()]
        reach = [
            math.hypot(*at)
            for k, at in enumerate(self.joint.anchors)
            if self.joint.ends[k] is not None
        ]
        reach += [math.dist(one, other) for one in places for other in places]
        reach += [body.shape.bounding_radius for body in self._held.values() if body.shape]
        reach += [
            abs(value)
            for name, value in self.joint.parameters
            if name == "joint_length" and isinstance(value, float)
        ]
        return max((one for one in reach if _SMALLEST < one < math.inf), default=1.0)

    @property
    def speed(self) -> float:
        """The largest speed of the bodies that it holds, by their turning too, m/s."""
        size = self.size
        bodies = self._held.values()
        return max(math.hypot(*b.velocity) + abs(b.angular_velocity) * size for b in bodies)

    def way(self, rows: NDArray[np.float64]) -> float:
        """Return the least way, m, by which bodies that move can make some rows zero."""
        size = self.size
        moving = [
            slopes * (1.0, 1.0, 1 / size)
            for end, slopes in self.slopes.items()
            if end in self._held and self._held[end].dynamic
        ]
        slopes = np.hstack(moving)
        way, *_ = np.linalg.lstsq(slopes, rows, rcond=1e-12)
        left = np.abs(slopes @ way - rows).max()
        small = 1e-9 * (np.abs(rows).max() + np.abs(slopes).max() * size)
        return math.hypot(*way) if left <= small else math.inf

    def worst(self, rows: NDArray[np.float64], per: str = "") -> str:
        """Return the largest of some rows with its unit."""
        k = int(np.argmax(np.abs(rows)))
        unit = self.joint.functions.units[k]
        if unit == "1":
            moved, _ = self.steepness[k]
            unit = "rad" if moved == 0.0 else ""
        return f"{rows[k]:g} {unit}".rstrip() + per


def steepness(slopes: Sequence[NDArray[np.float64]]) -> NDArray[np.float64]:
    """Return by how much rows (r,) change for each m, and for each rad: (2, r).

    The slopes of each body are (r, 3), by x, y and orientation.
    """
    rows = np.stack(slopes)
    moved = np.hypot.reduce(np.hypot(rows[:, :, 0], rows[:, :, 1]), axis=0)
    return np.stack([moved, np.hypot.reduce(rows[:, :, 2], axis=0)])


def apart(rows: NDArray[np.float64], slopes: Sequence[NDArray[np.float64]]) -> tuple[float, float]:
    """Return by how much a joint with equations of its own is apart, m, and turned, rad.

    It is the way on which a row (r,) would change by what it is, whatever its unit; the turn, if
    its bodies are only turned. The slopes of each body are (r, 3); nan where a row has none.
    """
    with np.errstate(all="ignore"):
        moved, turned = steepness(slopes)
        by = np.where(rows == 0.0, 0.0, rows / np.where(moved == 0.0, turned, moved))
    return math.hypot(*by[moved != 0.0]), math.hypot(*by[moved == 0.0])


def numbers_of(formula: Formula, values: Mapping[str, Any], count: int) -> NDArray[np.float64]:
    """Return so many numbers that a formula says of a joint; nan where it has no value."""
    with np.errstate(all="ignore"):
        try:
            return np.array(formula(values), dtype=np.float64)
        except (ArithmeticError, ValueError, TypeError):
            return np.full(count, math.nan)
