"""The forces that some bodies feel: which terms there are, and the numbers in them.

Serves: the maker of their source, and whoever calls it. Hides: how a scene becomes the arrays of
compiled code. The terms are those of `motion.terms`, in the same order, so that sums are the same
to the bit.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from tamias2d.motion.terms import anchored, end_row
from tamias2d.scene import Scene
from tamias2d.scene.acting import steady_load, varying_laws
from tamias2d.state import Array

TURNING = 2  # the component of a load that turns
_MOST = 16  # laws in one source
_TURNS = ("orientation", "angular_velocity")


@dataclass(frozen=True)
class ForceDemand:
    """What acts on some bodies; those with equal demands share compiled code."""

    rotation: bool
    """Whether orientations and angular velocities change."""
    laws: tuple[tuple[int, str], ...] = ()
    """Shapes of laws, each with its component: x, y, turn."""
    linear_drag: bool = False
    quadratic_drag: bool = False
    angular_drag: bool = False
    springs: bool = False
    anchors: bool = False
    """Whether springs hold bodies beside their centres."""
    attraction: bool = False

    @property
    def terms(self) -> int:
        """How many kinds of terms there are."""
        drags = self.linear_drag + self.quadratic_drag + self.angular_drag
        return len(self.laws) + drags + self.springs + self.attraction

    @property
    def axes(self) -> int:
        """How many coordinates of each body change."""
        return 3 if self.rotation else 2

    def __str__(self) -> str:
        """What acts, in words."""
        there = {
            "laws of time and state": bool(self.laws),
            "linear drag": self.linear_drag,
            "quadratic drag": self.quadratic_drag,
            "angular drag": self.angular_drag,
            "springs": self.springs,
            "attraction": self.attraction,
        }
        acting = ", ".join(
            ["constant loads", *(name for name, is_there in there.items() if is_there)]
        )
        return f"{acting}; {'with' if self.rotation else 'without'} rotation"


Tables = dict[str, Array]
"""The numbers of a demand by the names of its source: floats (k,), and rows of bodies (k,)."""


def forces_on(
    scene: Scene, bodies: Sequence[int], *, turned: bool = False
) -> tuple[ForceDemand, Tables] | None:
    """Return what acts on a group of bodies, which may be turned by something else.

    None where no code is made for it.
    """
    laws = _laws(scene, bodies)
    if laws is None:
        return None
    feeling = [scene.bodies[k] for k in bodies]
    loads = [steady_load(scene, k) for k in bodies]
    springs = [s for s in scene.springs if set(s.bodies) & set(bodies)]
    rotation = (
        turned
        or any(load[TURNING] for load in loads)
        or any(b.angular_velocity or b.angular_drag or b.shape is not None for b in feeling)
        or any(component == TURNING or _turns(shape) for component, shape in laws.shapes)
        or anchored(springs)
    )
    demand = ForceDemand(
        rotation=rotation,
        laws=laws.shapes,
        linear_drag=any(body.linear_drag for body in feeling),
        quadratic_drag=any(body.quadratic_drag for body in feeling),
        angular_drag=any(body.angular_drag for body in feeling),
        springs=bool(springs),
        anchors=anchored(springs),
        attraction=scene.attraction is not None and len(bodies) > 1,
    )
    return demand, _tables(scene, bodies, demand, laws.tables)


@dataclass(frozen=True)
class _Laws:
    shapes: tuple[tuple[int, str], ...]
    tables: Tables


def _laws(scene: Scene, bodies: Sequence[int]) -> _Laws | None:
    """Return the shapes of all laws in the order of their terms, for each component.

    Laws of one shape that follow each other, for different bodies, are one.
    """
    found: list[tuple[int, str, list[int], list[float]]] = []
    by_component = sorted(varying_laws(scene, bodies).items(), key=lambda item: item[0][0])
    for (component, law), rows in by_component:
        shape, values = law.shape
        if found and found[-1][:2] == (component, shape) and not set(found[-1][2]) & set(rows):
            found[-1][2].extend(rows)
            found[-1][3].extend([*values] * len(rows))
        else:
            found.append((component, shape, list(rows), [*values] * len(rows)))
    if len(found) > _MOST:
        return None
    tables: Tables = {}
    for k, (_, _, rows, numbers) in enumerate(found):
        tables[f"law_{k}_rows"] = np.array(rows, dtype=np.int64)
        tables[f"law_{k}_numbers"] = np.array(numbers, dtype=np.float64)
    return _Laws(tuple((component, shape) for component, shape, _, _ in found), tables)


def _turns(shape: str) -> bool:
    return any(name in shape for name in _TURNS)


def _tables(scene: Scene, bodies: Sequence[int], demand: ForceDemand, laws: Tables) -> Tables:
    feeling = [scene.bodies[k] for k in bodies]
    tables: Tables = {
        "gravity": np.array(scene.gravity, dtype=np.float64),
        "steady": np.array([steady_load(scene, k) for k in bodies]).reshape(-1, 3).T.ravel(),
        "mass": np.array([body.mass for body in feeling]),
        **({"inertia": np.array([body.inertia for body in feeling])} if demand.rotation else {}),
        **laws,
    }
    for kind in ("linear_drag", "quadratic_drag"):
        if getattr(demand, kind):
            drags = np.array([getattr(body, kind) for body in feeling])
            tables[f"{kind}_rows"] = np.flatnonzero(drags).astype(np.int64)
            tables[kind] = drags
    if demand.angular_drag:
        tables["angular_drag"] = np.array([body.angular_drag for body in feeling])
    if demand.springs:
        tables |= _springs(scene, bodies, demand)
    if demand.attraction:
        tables["gravitational_constant"] = np.array([scene.attraction], dtype=np.float64)
    return tables


def _springs(scene: Scene, bodies: Sequence[int], demand: ForceDemand) -> Tables:
    """Return the springs; what does not move stands in rows of its own, after all bodies."""
    springs = [s for s in scene.springs if set(s.bodies) & set(bodies)]
    row_of = {body: row for row, body in enumerate(bodies)}
    still: list[tuple[float, float, float]] = []
    first = [end_row(scene, s.first, s.point, row_of, still) for s in springs]
    second = [end_row(scene, s.second, s.point, row_of, still) for s in springs]
    tables: Tables = {
        "first_ends": np.array(first, dtype=np.int64),
        "second_ends": np.array(second, dtype=np.int64),
        "still": np.array(still, dtype=np.float64).reshape(-1, 3).ravel(),
        "stiffness": np.array([s.stiffness for s in springs]),
        "rest_length": np.array([s.rest_length for s in springs]),
        "damping": np.array([s.damping for s in springs]),
    }
    if demand.anchors:
        anchors = [(*s.anchor, *s.other_anchor) for s in springs]
        tables["anchors"] = np.array(anchors, dtype=np.float64).ravel()
    return tables
