"""What is known of a mechanism at one time, and why a path ends there."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import NamedTuple

from tamias2d.motion.joint_events import Of
from tamias2d.state import Array

Side = tuple[Of, int]
"""A limit of a freedom: -1 for the lower one, 1 for the upper."""
SLIGHT = 1e-12  # of the mechanism's length, or rad: so near a limit is touched


class Now(NamedTuple):
    """A mechanism at one time: coordinates, rates and accelerations by the loads alone, (n, 3)."""

    time: float
    position: Array
    velocity: Array
    free: Array


@dataclass(frozen=True)
class Cause:
    """Why a path ends at a time, s, and what that says of the next."""

    time: float
    reached: frozenset[Side] = frozenset()
    left: frozenset[Side] = frozenset()
    arrives: frozenset[Of] = frozenset()
    slips: Mapping[Of, int] = field(default_factory=dict)
    clicks: Mapping[Of, float] = field(default_factory=dict)
    breaks: frozenset[int] = frozenset()
