"""The arrays of the engine, and the step that is taken on them.

Serves: the simulator. Hides: how much room the arrays have, and the kernel.
"""

from typing import Any

import numpy as np

from tamias2d.generated import drag
from tamias2d.state import Array
from tamias2d.stepped.layout import (
    ANGULAR,
    ARM,
    DECAY,
    FULL,
    GAIN,
    HALF_PLANE,
    HORIZON,
    INVERSE_INERTIA,
    INVERSE_MASS,
    LIFT,
    NEEDED,
    REACH,
    STILL,
    SUB,
    SUBSTEPS,
    TIME_STEP,
    Whole,
)
from tamias2d.stepped.menu import CONTACT
from tamias2d.stepped.rows import WIDTH
from tamias2d.stepped.solver import BENCH
from tamias2d.stepped.step import DONE, MORE_BLOCKS, MORE_FOUND, MORE_PAIRS

_ORDER = (
    "settings counts pose motion load body home kind used ranked shape_body shape_kind shape_first "
    "shape_count shape_radius surface filters mixed corner turned box curve node found pairs "
    "touches traces hits fill rows lanes bench carried"
).split()
_BODY = ("pose", "motion", "load", "body", "home", "kind", "used", "content")
_SHAPE = (
    "shape_body",
    "shape_kind",
    "shape_first",
    "shape_count",
    "shape_radius",
    "surface",
    "filters",
    "box",
)


class World:
    """n bodies and m shapes in arrays whose columns `layout` names."""

    def __init__(
        self, *, gravity: tuple[float, float], time_step: float, substeps: int, plain: bool = False
    ) -> None:
        """Start an empty world; `plain` takes its steps by the functions as they are."""
        self.size = 0  # rows of bodies in use, absent ones too
        self.pose = np.zeros((1, 3))
        self.motion = np.zeros((1, 8))
        self.load = np.zeros((1, 3))
        self.body = np.zeros((1, 18))
        self.home = np.zeros((1, 6))
        self.carried = np.zeros((1, 6))
        self.kind = np.zeros(1, dtype=np.int8)
        self.used = np.zeros(1, dtype=np.int64)
        self.rank = np.zeros(0, dtype=np.int64)
        self.ranked = np.zeros((2, 0), dtype=np.int64)
        self.shape_body = np.zeros(0, dtype=np.int32)
        self.shape_kind = np.zeros(0, dtype=np.int32)
        self.shape_first = np.zeros(0, dtype=np.int32)
        self.shape_count = np.zeros(0, dtype=np.int32)
        self.shape_radius = np.zeros(0)
        self.surface = np.zeros((0, 3))
        self.filters = np.zeros((0, 4), dtype=np.int64)
        self.mixed = np.zeros((0, 4))
        self.corner = np.zeros((0, 4))
        self.turned = np.zeros((0, 4))
        self.box = np.zeros((0, 8))
        self.curve = np.zeros((4, 256), dtype=np.int64)
        self.node = np.zeros((2, 4))
        self.found = np.zeros((16, 4), dtype=np.int64)
        self.pairs = np.zeros((2, 16, 2), dtype=np.int32)
        self.touches = np.zeros((2, 16, 18))
        self.traces = np.zeros((2, 16, 6), dtype=np.int32)
        self.hits = np.zeros((3, 16), dtype=np.int64)
        self.fill = np.zeros((3, 128), dtype=np.int64)
        self.rows = np.zeros((4, WIDTH))
        self.lanes = np.zeros((4, 50), dtype=np.uint32)
        self.bench = np.zeros(BENCH)
        self.settings = np.array([*gravity, time_step, 0.0, 0.0])
        self.counts = np.zeros(16, dtype=np.int64)
        self.counts[SUBSTEPS], self.counts[HORIZON] = substeps, 4
        self._engine = CONTACT.plain() if plain else CONTACT.compiled()
        self._arguments: tuple[Any, ...] = ()

    def add_bodies(
        self,
        kind: Whole,
        *,
        inverse_mass: Array,
        inverse_inertia: Array,
        pose: Array,
        velocity: Array,
        rate: Array,
        spin_rate: Array,
    ) -> Whole:
        """Add k bodies, and return their rows.

        `pose` and `velocity` (k, 3) are linear and angular; the rates (k,) are those at which drag
        slows velocity and spin down, 1/s.
        """
        count = len(kind)
        first = self.size
        self._make_room(count)
        new = slice(first, first + count)
        self.pose[new] = pose
        self.motion[new, :3] = velocity
        self.load[new] = 0.0
        self.body[new, INVERSE_MASS] = inverse_mass
        self.body[new, INVERSE_INERTIA] = inverse_inertia
        self.kind[new] = kind
        self._flow(new, rate, 0)
        self._flow(new, spin_rate, ANGULAR)
        self.size += count
        self.forget()
        return np.arange(first, first + count)

    def _flow(self, new: slice | Whole, rate: Array, column: int) -> None:
        """Write how velocity and place flow in a step and in a substep under drag (IM1, IM6)."""
        for start, time in (
            (FULL, self.settings[TIME_STEP]),
            (SUB, self.settings[TIME_STEP] / self.counts[SUBSTEPS]),
        ):
            one, none = (1.0, 0.0), (0.0, 0.0)
            at = start + column
            self.body[new, at + DECAY] = drag.velocity(one, none, rate, time)[0]
            self.body[new, at + GAIN] = drag.position(none, one, none, rate, time)[0]
            self.body[new, at + LIFT] = drag.position(none, none, one, rate, time)[0]

    def add_shapes(
        self,
        body: Whole,
        *,
        kind: Whole,
        radius: Array,
        corners: list[Array],
        friction: Array,
        restitution: Array,
        filters: Whole,
    ) -> Whole:
        """Add k shapes to bodies given by rows, and return their rows.

        `corners` are (c, 2) each, in the body's axes; for a half-plane (2, 2) hold offset and
        normal. Surfaces that state nothing have -1. `filters` (k, 4) as in the layout.
        """
        first = len(self.shape_body)
        count = np.array(
            [1 if k == HALF_PLANE else len(c) for k, c in zip(kind, corners, strict=True)]
        )
        start = len(self.corner) + np.cumsum(count) - count
        rows = [_sides(k, c) for k, c in zip(kind, corners, strict=True)]
        reach = np.array(
            [
                np.inf if k == HALF_PLANE else np.hypot(*c.T).max() + r
                for k, c, r in zip(kind, corners, radius, strict=True)
            ]
        )
        self.corner = np.concatenate([self.corner, *rows])
        self.turned = self.corner.copy()
        self.shape_body = _joined(self.shape_body, body)
        self.shape_kind = _joined(self.shape_kind, kind)
        self.shape_first = _joined(self.shape_first, start)
        self.shape_count = _joined(self.shape_count, count)
        self.shape_radius = _joined(self.shape_radius, radius)
        self.surface = np.concatenate([self.surface, np.stack([friction, restitution, reach], 1)])
        self.filters = np.concatenate([self.filters, filters])
        self.box = np.zeros((len(self.shape_body), 8))
        arm = np.array(
            [
                0.0 if k == HALF_PLANE else np.hypot(*c.T).max()
                for k, c in zip(kind, corners, strict=True)
            ]
        )
        finite = np.isfinite(reach)
        np.maximum.at(self.body[:, REACH], np.asarray(body)[finite], reach[finite])
        np.maximum.at(self.body[:, ARM], body, arm)
        self._rank()
        leaves = 4
        while leaves < len(self.shape_body):
            leaves *= 2
        self.node = np.zeros((leaves, 4))
        self.curve = np.zeros((4, len(self.shape_body) + 256), dtype=np.int64)
        self.forget()
        return np.arange(first, len(self.shape_body))

    def forget(self) -> None:
        """Look for pairs anew at the next step."""
        self.counts[STILL] = 0
        self._arguments = ()

    def _rank(self) -> None:
        """Order shapes by what and where their bodies are: not by when they were added."""
        body = self.shape_body
        content = np.concatenate(
            [self.pose, self.motion[:, :3], self.body[:, :2], self.kind[:, None]], axis=1
        )[body]
        radius = np.stack([self.shape_radius, self.shape_count, self.shape_kind], 1)
        corner = self.corner[self.shape_first]
        keys = np.concatenate([corner, radius, content[:, ::-1]], axis=1)
        order = np.lexsort(keys.T)
        self.ranked = np.empty((2, len(order)), dtype=np.int64)
        self.ranked[0] = order
        self.ranked[1, order] = np.arange(len(order))

    def _make_room(self, count: int) -> None:
        if self.size + count < len(self.pose):
            return
        room = max(self.size + count, len(self.pose) * 3 // 2) + 1
        for name in ("pose", "motion", "load", "body", "home", "kind", "used", "carried"):
            old = getattr(self, name)
            new = np.zeros((room, *old.shape[1:]), dtype=old.dtype)
            new[: self.size] = old[: self.size]
            setattr(self, name, new)

    def step(self) -> int:
        """Take one step; return how it ended: done, or what of the state is no number."""
        if not self._arguments:
            self._arguments = tuple(getattr(self, name) for name in _ORDER)
        while (status := self._engine.step(*self._arguments)) != DONE:
            if status == MORE_FOUND:
                self.found = np.zeros((self.counts[NEEDED] * 5 // 4 + 16, 4), dtype=np.int64)
            elif status == MORE_PAIRS:
                self._more_pairs(int(self.counts[NEEDED] * 5 // 4 + 16))
            elif status == MORE_BLOCKS:
                room = int(self.counts[NEEDED] * 5 // 4 + 4)
                self.rows = np.zeros((room, WIDTH))
                self.lanes = np.zeros((room, 50), dtype=np.uint32)
            else:
                self.counts[13] = 0
                return int(status)
            self._arguments = tuple(getattr(self, name) for name in _ORDER)
        return DONE

    def _more_pairs(self, room: int) -> None:
        self.hits = np.zeros((3, room), dtype=np.int64)
        for name in ("pairs", "touches", "traces"):
            old = getattr(self, name)
            new = np.zeros((2, room, old.shape[2]), dtype=old.dtype)
            new[:, : old.shape[1]] = old
            setattr(self, name, new)


def _sides(kind: int, corners: Array) -> Array:
    """Return corners with the outward normals of the sides that start at them, (c, 4)."""
    if kind == HALF_PLANE:
        return np.array([[corners[0, 0], 0.0, *corners[1]]])
    along = np.roll(corners, -1, axis=0) - corners
    length = np.hypot(*along.T)
    length[length == 0.0] = np.inf
    return np.concatenate([corners, np.stack([along[:, 1], -along[:, 0]], 1) / length[:, None]], 1)


def _joined(old: Any, new: Any) -> Any:
    return np.concatenate([old, np.asarray(new)]).astype(old.dtype)
