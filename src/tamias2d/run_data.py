"""The numbers of a run: the history of a scene, its impacts and its balance."""

import hashlib
from dataclasses import dataclass, field, fields
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from tamias2d.certificate import Certificate
from tamias2d.cost import Cost
from tamias2d.kernels import joint_code
from tamias2d.motion import JointEvents, Method, Reactions, joint_events, reactions_of
from tamias2d.scene import Scene
from tamias2d.state import Array, History


@dataclass(frozen=True, kw_only=True)
class Impacts:
    """The m impacts of a run, in the order in which they happened.

    A pair that meets with a whole side gives one entry for each end of the side that touches, both
    at the same time.
    """

    time: Array
    """(m,), s"""
    bodies: NDArray[np.int64]
    """(m, 2), indices of bodies A and B"""
    point: Array
    """(m, 2), where they touched, m"""
    normal: Array
    """(m, 2), unit, from A to B"""
    impulse: Array
    """(m,), along the normal, on B, N s"""
    normal_velocity: Array
    """(m,), just before, m/s; negative"""

    def __len__(self) -> int:
        return len(self.time)


@dataclass(frozen=True, kw_only=True)
class RunData:
    """The history of n bodies, static ones too and in the scene's order, at k times. SI units."""

    scene: Scene
    method: Method
    duration: float
    """s"""
    time_step: float | None
    """s; None where the method chooses for itself"""
    times: Array
    """(k,), s; at the instant of an impact the state is the one after it"""
    position: Array
    """(k, n, 2), of the centres of mass, m"""
    orientation: Array
    """(k, n), counter-clockwise, unbounded, rad"""
    velocity: Array
    """(k, n, 2), m/s"""
    angular_velocity: Array
    """(k, n), rad/s"""
    impacts: Impacts
    energy: Array
    """(k,), kinetic, in uniform gravity, in springs and in attraction between bodies, J

    What forces and fields given as laws or numbers could give back is not in it: a law need not
    have a potential.
    """
    momentum: Array
    """(k, 2), kg m/s"""
    angular_momentum: Array
    """(k,), about the origin, kg m^2/s"""
    notes: tuple[str, ...]
    """Which method was taken and why; which bodies came to rest on which, and when."""
    stepped_because: str | None = None
    """Why contacts are stepped, where that was not asked for."""
    ruled: str | None = None
    """What a rule decided that rigid bodies leave open, and when (A18); it is in the notes, too."""
    unresolved: str | None = None
    """What steps that were given miss of a law; it is in the notes, too."""
    cost: Cost | None = None
    """What it cost; None if it was not simulated but read from a recording."""
    joint_events: JointEvents = field(default_factory=joint_events)
    """Limits of joints that were reached, motors that gave way, joints that broke."""
    contact_force: Array | None = None
    """(k, n, 2), what contacts that last exert on each body that moves, N

    It is told where contacts last of bodies that joints hold, and was not stepped; else None.
    """
    contact_torque: Array | None = None
    """(k, n), likewise, about its centre of mass, N m"""
    certificate: Certificate | None = None
    """How wrong it is at most; None until it is certified."""

    @cached_property
    def reactions(self) -> Reactions:
        """What the joints exert at each sample, and how well they hold (TM7)."""
        states = (self.position, self.orientation, self.velocity, self.angular_velocity)
        history = History(*states)
        pushed = None
        if self.contact_force is not None and self.contact_torque is not None:
            pushed = np.dstack((self.contact_force, self.contact_torque))
        return reactions_of(
            self.scene, self.times, history, self.joint_events, joint_code, pushed=pushed
        )

    def digest(self) -> str:
        """Return the SHA-256 of all numbers of the run: equal runs have equal digests."""
        total = hashlib.sha256()
        parts: list[RunData | Impacts | JointEvents] = [self, self.impacts]
        if len(self.joint_events):  # runs without any keep the digest that they had
            parts.append(self.joint_events)
        for part in parts:
            for each in fields(part):
                value = getattr(part, each.name)
                if isinstance(value, np.ndarray):
                    total.update(f"{each.name}{value.shape}".encode())
                    total.update(np.ascontiguousarray(value).tobytes())
        return total.hexdigest()
