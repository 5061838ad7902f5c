"""What a kernel must be able to do: the scheme, and the terms that a scene has.

Serves: the maker of sources. Hides: which scenes a kernel can be made for.
"""

from collections.abc import Iterable
from dataclasses import dataclass

from tamias2d.motion import Method
from tamias2d.scene import Scene
from tamias2d.scene.acting import groups, steady_load, varying_laws
from tamias2d.spec.expression import Call, Node, Power, walk
from tamias2d.spec.tex import plain

TURNING = 2  # the component of a load that turns
_SAME_BITS = {"dot", "cross", "perp", "norm", "vector", "x", "y", "sqrt", "abs"}
"""What compiled code and NumPy round alike; NumPy's sine and exponential are its own."""


@dataclass(frozen=True)
class Demand:
    """What one kernel is made for; scenes with equal demands share it."""

    scheme: str
    """A step of `generated.schemes`."""
    rotation: bool = False
    """Whether orientation and angular velocity change."""
    forces: bool = False
    """Whether a constant force or torque acts on any body, besides gravity."""
    laws: tuple[tuple[int, str], ...] = ()
    """Expressions of time and state that act on all bodies, each with its component: x, y, turn."""
    linear_drag: bool = False
    quadratic_drag: bool = False

    @property
    def steady(self) -> bool:
        """Whether the accelerations stay what they are."""
        return not (self.laws or self.linear_drag or self.quadratic_drag)

    def __str__(self) -> str:
        """What it does, in words."""
        terms = {
            "constant forces": self.forces,
            "laws of time and state": bool(self.laws),
            "linear drag": self.linear_drag,
            "quadratic drag": self.quadratic_drag,
        }
        steady = "gravity (0 where a scene has none)"
        acting = ", ".join([steady, *(name for name, there in terms.items() if there)])
        return f"{self.scheme}: {acting}; {'with' if self.rotation else 'without'} rotation"


def demand_of(scene: Scene, method: Method) -> Demand | None:
    """Return what a scene asks of a kernel, or None where none can be made.

    None for a method without a fixed step, for bodies that act on each other, for angular drag, and
    for laws that only some bodies feel or that compiled code would round otherwise than NumPy does.
    """
    scheme = getattr(method, "scheme", None)
    moving = [k for k, body in enumerate(scene.bodies) if body.dynamic]
    acting = scene.springs or scene.joints or len(groups(scene)) != len(moving)
    if scheme is None or not moving or acting:
        return None
    laws = varying_laws(scene, moving)
    shared = all(len(rows) == len(moving) for rows in laws.values())
    if not (shared and all(_rounds_alike(law.node) for _, law in laws)):
        return None
    bodies = [scene.bodies[k] for k in moving]
    if any(body.angular_drag for body in bodies):
        return None
    loads = [steady_load(scene, k) for k in moving]
    turned = any(body.angular_velocity for body in bodies) or any(load[TURNING] for load in loads)
    return Demand(
        scheme=scheme,
        rotation=turned or any(component == TURNING for component, _ in laws),
        forces=any(any(load) for load in loads),
        laws=tuple((component, plain(law.node)) for component, law in laws),
        linear_drag=any(body.linear_drag for body in bodies),
        quadratic_drag=any(body.quadratic_drag for body in bodies),
    )


def _rounds_alike(node: Node) -> bool:
    parts: Iterable[Node] = list(walk(node))
    calls = {part.function for part in parts if isinstance(part, Call)}
    roots = [part for part in parts if isinstance(part, Power) and part.exponent <= 0]
    return calls <= _SAME_BITS and not roots
