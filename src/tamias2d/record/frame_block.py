"""Frames of a loop in which no body and no joint comes, goes or changes: they are sent together."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from tamias2d.generated.definitions import kinetic_energy
from tamias2d.motion.joint_events import joint_events
from tamias2d.record.drawn import Frames, FrameScene

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from tamias2d.scene import Body, Joint
    from tamias2d.scene.springs import Spring
    from tamias2d.simulator import Simulator
    from tamias2d.simulator.snapshot import Snapshot
    from tamias2d.state import Array

    Key = tuple[int, int]  # the row of a body, and its generation

_MOST = 256  # frames: what they take of memory, and what is lost where a process is killed


@dataclass(frozen=True, kw_only=True)
class Totals:
    """What k frames are summed up to, and where bodies touch in them."""

    kinetic_energy: Array
    """(k,), J"""
    speed: Array
    """(k, 2), of the fastest body that can be pushed, and of all such on average, m/s"""
    bodies: Array
    """(k,), how many there are"""
    contact_points: Sequence[Array]
    """k arrays (c, 2), m"""


class FrameBlock:
    """Frames with the same bodies."""

    def __init__(
        self, sim: Simulator, first: Snapshot, number: int, known: Mapping[Key, Body]
    ) -> None:
        """Begin with what a simulator shows, as the frame of a number; some bodies are known."""
        self.first = number
        """The number of the first frame."""
        keys = zip(first.rows.tolist(), first.generation.tolist(), strict=True)
        self.bodies = {key: _body(sim, key, known) for key in keys}
        """By their rows and generations."""
        self._taken: list[Snapshot] = []
        self._index = {row: k for k, row in enumerate(first.rows.tolist())}

    def takes(self, frame: Snapshot) -> bool:
        """Return whether a frame has the same bodies and joints, and there is room for it."""
        first = self._taken[0]
        same = first.revision == frame.revision and len(self._taken) < _MOST
        return same and _tied(first) == _tied(frame) and _still(first) == _still(frame)

    def add(self, frame: Snapshot) -> None:
        """Take a frame that fits."""
        self._taken.append(frame)

    def frames(self) -> Frames:
        """Return what is drawn."""
        pose = np.array([frame.pose for frame in self._taken])
        first = self._taken[0]
        scene = FrameScene(
            bodies=list(self.bodies.values()),
            joints=[self._joint(joint) for joint in first.joints],
            springs=[self._spring(spring) for spring in first.springs],
        )
        return Frames(
            scene=scene,
            times=np.array([frame.time for frame in self._taken]),
            position=pose[..., :2],
            orientation=pose[..., 2],
            joint_events=joint_events(),
        )

    def totals(self) -> Totals:
        """Return the sums over all bodies that can be pushed."""
        first = self._taken[0]
        pushed = first.inverse_mass > 0.0
        velocity = np.array([frame.velocity for frame in self._taken])[:, pushed]
        with np.errstate(divide="ignore"):
            mass, inertia = 1 / first.inverse_mass[pushed], 1 / first.inverse_inertia[pushed]
        inertia[np.isinf(inertia)] = 0.0  # nothing turns these
        along = np.moveaxis(velocity[..., :2], -1, 0)
        energy = kinetic_energy(mass, (along[0], along[1]), inertia, velocity[..., 2])
        speed = np.hypot(*along)
        fastest = speed.max(axis=1, initial=0.0)
        mean = speed.sum(axis=1) / max(speed.shape[1], 1)
        return Totals(
            kinetic_energy=np.sum(energy, axis=1),
            speed=np.column_stack([fastest, mean]),
            bodies=np.full(len(self._taken), float(len(self.bodies))),
            contact_points=[frame.contact_points for frame in self._taken],
        )

    def _joint(self, joint: Joint) -> Joint:
        a, b, c = (None if end is None else self._index[end] for end in joint.ends)
        return replace(joint, ends=(a, b, c))

    def _spring(self, spring: Spring) -> Spring:
        second = None if spring.second is None else self._index[spring.second]
        return replace(spring, first=self._index[spring.first], second=second)


def _body(sim: Simulator, key: Key, known: Mapping[Key, Body]) -> Body:
    """Return a body as it was known, unless it stands elsewhere: only so its look may change."""
    row, before = key[0], known.get(key)
    if before is None or (before.static and before.position != tuple(sim.position[row].tolist())):
        return sim.body(row)
    return before


def _tied(frame: Snapshot) -> list[int]:
    """Return what is the same only for the same joints and springs."""
    return [id(tie) for tie in (*frame.joints, *frame.springs)]


def _still(frame: Snapshot) -> bytes:
    """Return what is the same only if static bodies are where they were."""
    places: bytes = frame.pose[frame.static == 1].tobytes()
    return places
