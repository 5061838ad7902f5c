"""What a frame loop looks like between two steps: for who draws or records it."""

from dataclasses import dataclass

from tamias2d.scene.joints import Joint
from tamias2d.scene.springs import Spring
from tamias2d.state import Array, IntArray


@dataclass(frozen=True, kw_only=True)
class Snapshot:
    """The m bodies of a simulator at one time, and what ties them; bodies are told by rows."""

    time: float
    """s"""
    revision: int
    """Changes whenever bodies come, go or change."""
    forms: int
    """Changes whenever bodies get other shapes."""
    rows: IntArray
    """(m,), of the bodies that are there"""
    generation: IntArray
    """(m,)"""
    static: IntArray
    """(m,), 1 for what stands still whatever happens"""
    pose: Array
    """(m, 3), position, m, and orientation, rad"""
    velocity: Array
    """(m, 3), m/s and rad/s"""
    inverse_mass: Array
    """(m,), 1/kg"""
    inverse_inertia: Array
    """(m,), 1/(kg m^2)"""
    joints: tuple[Joint, ...]
    springs: tuple[Spring, ...]
    contact_points: Array
    """(c, 2), where bodies pushed each other in the last step, m"""
