"""Loads that vary with time or state: evaluated at the start of each step, and held through it.

Laws, springs, attraction, fields and quadratic drag vary. What is held over a step makes the answer
one of first order in the time step. The engine itself has constant loads, gravity and linear drag.
"""

from collections.abc import Sequence

import numpy as np

from tamias2d.engine.engine import Engine
from tamias2d.errors import SimulationError
from tamias2d.generated import drag
from tamias2d.motion.terms import Attraction, Drag, LawTerm, Springs, Term
from tamias2d.scene import Scene
from tamias2d.scene.acting import varying_laws
from tamias2d.state import Array


class VaryingLoads:
    """The loads on the bodies of a scene that are still there, given by rows in some order."""

    def __init__(self, scene: Scene, rows: Sequence[int]) -> None:
        """Take those that are there, in canonical order, so that no sum depends on another one."""
        rows = sorted(rows, key=lambda row: not scene.bodies[row].dynamic)  # those that move first
        self._scene = scene
        self._rows = np.array(rows, dtype=np.int64)
        self._terms = _terms(scene, rows)

    @property
    def empty(self) -> bool:
        """Whether no load varies."""
        return not self._terms

    def loads(self, engine: Engine, time: float) -> Array:
        """Return the forces and torques (n, 3) on the bodies of an engine at a time, s.

        Raises:
            SimulationError: a force is not finite; names it and a body.
        """
        place, rate = engine.pose[self._rows], engine.velocity[self._rows]
        held = np.zeros_like(place)
        with np.errstate(all="ignore"):
            for term in self._terms:
                term.add(time, place, rate, held)
                if not (good := np.isfinite(held).all(axis=1)).all():
                    name = self._scene.bodies[int(self._rows[np.argmin(good)])].name
                    raise SimulationError(
                        f"{term.says.replace('_', ' ')} at {time!r} s: no finite force on "
                        f"'{name}' (R4): bodies are at one place, or float64 cannot hold it. "
                        "Move it, or change the scene."
                    )
        loads = np.zeros_like(engine.load)
        loads[self._rows] = held
        return loads


def _terms(scene: Scene, rows: Sequence[int]) -> list[Term]:
    """Return the terms of the loads; a spring is there while its bodies are."""
    dynamic = [row for row in rows if scene.bodies[row].dynamic]
    place = {row: k for k, row in enumerate(rows)}
    found: list[Term] = [
        LawTerm(scene, rows, component, law, bodies)
        for (component, law), bodies in varying_laws(scene, rows).items()
    ]
    if any(scene.bodies[row].quadratic_drag for row in dynamic):
        found.append(Drag(scene, rows, "quadratic_drag", drag.quadratic_drag_force))
    springs = [spring for spring in scene.springs if place.keys() >= set(spring.bodies)]
    springs.sort(
        key=lambda s: ([place[row] for row in s.bodies], s.point, s.stiffness, s.rest_length)
    )
    if springs:
        found.append(Springs(scene, springs, place))
    if scene.attraction is not None and len(dynamic) > 1:
        found.append(Attraction(scene, dynamic))
    return found
