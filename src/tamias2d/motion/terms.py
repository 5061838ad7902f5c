"""The forces that follow from the state of the bodies, each a term of the sum GD6.

A term knows the rows of its bodies in the arrays, and adds its forces, N, and torques, N m, to the
loads (n, 3) of all of them at once. All equations are the generated ones.
"""

from collections.abc import Callable, Sequence
from typing import Any, Protocol, TypeAlias

import numpy as np
from numpy.typing import NDArray

from tamias2d.generated import definitions, drag, gravitation, spring
from tamias2d.scene import Scene, Spring
from tamias2d.scene.acting import varying_laws
from tamias2d.scene.law import StateLaw
from tamias2d.scene.springs import arm
from tamias2d.state import Array

Rows: TypeAlias = NDArray[np.intp]
Components: TypeAlias = tuple[Any, Any]
"""A vector: two floats or two arrays."""
_DRAGS: dict[str, Callable[[Any, Components], Components]] = {
    "linear_drag": drag.linear_drag_force,
    "quadratic_drag": drag.quadratic_drag_force,
}


class Term(Protocol):
    """One kind of force."""

    says: str
    """What it is, for messages."""

    def add(self, time: float, position: Array, velocity: Array, loads: Array) -> None:
        """Add what it does at a time in s, from coordinates and rates (n, 3), to loads (n, 3)."""


def terms(scene: Scene, bodies: Sequence[int]) -> list[Term]:
    """Return the terms that some bodies feel, given by their indices; no others, so none is idle.

    Who acts on one of the bodies is among them too, or does not move (`groups`).
    """
    row_of = {body: row for row, body in enumerate(bodies)}
    found: list[Term] = [
        LawTerm(scene, bodies, component, law, rows)
        for (component, law), rows in varying_laws(scene, bodies).items()
    ]
    found += [
        Drag(scene, bodies, kind, force)
        for kind, force in _DRAGS.items()
        if any(getattr(scene.bodies[body], kind) for body in bodies)
    ]
    if any(scene.bodies[body].angular_drag for body in bodies):
        found.append(AngularDrag(scene, bodies))
    springs = [s for s in scene.springs if any(body in row_of for body in s.bodies)]
    if springs:
        found.append(Springs(scene, springs, row_of))
    if scene.attraction is not None and len(bodies) > 1:
        found.append(Attraction(scene, bodies))
    return found


class LawTerm:
    """A law of a user's own for one component, and all bodies that share it (IM8)."""

    def __init__(
        self,
        scene: Scene,
        bodies: Sequence[int],
        component: int,
        law: StateLaw,
        rows: Sequence[int],
    ) -> None:
        self.says = law.what
        self.names = law.names
        self._law = law
        self._component = component
        self._rows = np.array(rows)
        self._mass = np.array([scene.bodies[bodies[row]].mass for row in rows])

    def add(self, time: float, position: Array, velocity: Array, loads: Array) -> None:
        """Add the law's value for each body."""
        q, rate = position[self._rows], velocity[self._rows]
        value = self._law(
            {
                "time": time,
                "position": _vector(q),
                "velocity": _vector(rate),
                "orientation": q[:, 2],
                "angular_velocity": rate[:, 2],
                "mass": self._mass,
            }
        )
        np.add.at(loads[:, self._component], self._rows, value)


class Drag:
    """Drag of one kind, `linear_drag` or `quadratic_drag` (IM6)."""

    def __init__(
        self,
        scene: Scene,
        bodies: Sequence[int],
        says: str,
        force: Callable[[Any, Components], Components],
    ) -> None:
        self.says = says
        drags = np.array([getattr(scene.bodies[body], says) for body in bodies])
        self._rows = np.flatnonzero(drags)
        self._drags = drags[self._rows]
        self._force = force

    def add(self, time: float, position: Array, velocity: Array, loads: Array) -> None:  # noqa: ARG002
        """Add the drag of each body that has one."""
        force = self._force(self._drags, _vector(velocity[self._rows]))
        loads[self._rows, :2] += np.stack(force, axis=-1)


class AngularDrag:
    """Drag of the turning (IM6)."""

    says = "angular_drag"

    def __init__(self, scene: Scene, bodies: Sequence[int]) -> None:
        self._drags = np.array([scene.bodies[body].angular_drag for body in bodies])

    def add(self, time: float, position: Array, velocity: Array, loads: Array) -> None:  # noqa: ARG002
        """Add the torque on each body."""
        loads[:, 2] += drag.angular_drag_torque(self._drags, velocity[:, 2])


class Springs:
    """All springs and dampers (IM7). Ends that do not move stand in rows of their own."""

    says = "springs"

    def __init__(self, scene: Scene, springs: Sequence[Spring], row_of: dict[int, int]) -> None:
        self._stiffness = np.array([s.stiffness for s in springs])
        self._rest_length = np.array([s.rest_length for s in springs])
        self._damping = np.array([s.damping for s in springs])
        self._anchors = tuple(
            _vector(np.array(anchors)) if anchored(springs) else None
            for anchors in ([s.anchor for s in springs], [s.other_anchor for s in springs])
        )
        fixed: list[tuple[float, float, float]] = []
        self._ends = tuple(
            np.array([end_row(scene, body, point, row_of, fixed) for body, point in ends])
            for ends in (
                [(s.first, s.point) for s in springs],
                [(s.second, s.point) for s in springs],
            )
        )
        self._fixed = np.array(fixed).reshape(-1, 3)
        self._still = np.zeros_like(self._fixed)

    def add(self, time: float, position: Array, velocity: Array, loads: Array) -> None:  # noqa: ARG002
        """Add the pull at both ends of each spring, and its torques."""
        q = np.concatenate((position, self._fixed))
        rate = np.concatenate((velocity, self._still))
        arms, points, speeds = zip(
            *(
                _end(q[rows], rate[rows], anchor)
                for rows, anchor in zip(self._ends, self._anchors, strict=True)
            ),
            strict=True,
        )
        pull = spring.spring_force(
            self._stiffness,
            self._rest_length,
            self._damping,
            points[0],
            speeds[0],
            points[1],
            speeds[1],
        )
        rows = np.zeros((len(self._stiffness), 2, 3))  # of each spring, its first end first
        for k, force in enumerate((pull, (-pull[0], -pull[1]))):
            rows[:, k, 0], rows[:, k, 1] = force
            if arms[k] is not None:
                rows[:, k, 2] = definitions.torque(arms[k], force)
        columns = 3 if arms[0] is not None else 2
        ends = np.stack(self._ends, axis=-1)
        moving = ends < len(position)
        np.add.at(loads[:, :columns], ends[moving], rows[moving][:, :columns])


class Attraction:
    """Gravitation between all pairs of the bodies (IM5)."""

    says = "attraction between bodies"
    names = frozenset({"position"})

    def __init__(self, scene: Scene, bodies: Sequence[int]) -> None:
        mass = np.array([scene.bodies[body].mass for body in bodies])
        self._constant = scene.attraction
        self.first, self.second = np.triu_indices(len(bodies), k=1)
        """(p,), of each pair its bodies"""
        self._masses = mass[self.first], mass[self.second]

    def add(self, time: float, position: Array, velocity: Array, loads: Array) -> None:  # noqa: ARG002
        """Add to each body of a pair the pull of the other, exactly opposite."""
        rows = self.pulls(position)
        ends = np.stack((self.first, self.second), axis=-1)
        np.add.at(loads[:, :2], ends, np.stack((rows, -rows), axis=1))

    def pulls(self, position: Array) -> Array:
        """Return the forces (p, 2) on the first bodies of all pairs, N."""
        force = gravitation.attraction(
            self._constant,
            *self._masses,
            _vector(position[self.first]),
            _vector(position[self.second]),
        )
        return np.stack(force, axis=-1)


def end_row(
    scene: Scene,
    body: int | None,
    point: tuple[float, float],
    row_of: dict[int, int],
    fixed: list[tuple[float, float, float]],
) -> int:
    """Return the row of a spring's end; one that does not move gets a new one, with its place."""
    if body in row_of:
        return row_of[body]
    still = None if body is None else scene.bodies[body]
    fixed.append((*still.position, still.orientation) if still else (*point, 0.0))
    return len(row_of) + len(fixed) - 1


def anchored(springs: Sequence[Spring]) -> bool:
    """Whether any of some springs holds a body beside its centre."""
    return any(any(anchor) for spring in springs for _, anchor in spring.ends)


def _end(
    q: Array, rate: Array, anchor: Components | None
) -> tuple[Components | None, Components, Components]:
    """Return arm, place and velocity of the points at which springs hold bodies."""
    if anchor is None:
        return None, _vector(q), _vector(rate)
    reach = arm(anchor, q[:, 2])
    place = (q[:, 0] + reach[0], q[:, 1] + reach[1])
    return reach, place, definitions.point_velocity(_vector(rate), rate[:, 2], reach)


def _vector(rows: Array) -> Components:
    """Return the first two columns as a vector of arrays."""
    return rows[:, 0], rows[:, 1]
