"""Bodies are altered in place between steps: what they weigh, what slows them, their shapes (R2).

Serves: games, whose characters crouch and grow, and whose ships burn fuel. Hides: that the engine
holds rates of drag, inverse masses, and shapes in rows of their own.
"""

from collections.abc import Sequence
from functools import partial
from typing import NamedTuple, cast

import numpy as np

from tamias2d.engine.tables import DYNAMIC, KINEMATIC, STATIC
from tamias2d.generated import definitions
from tamias2d.scene.checks import checked_inertia, refuse_shape
from tamias2d.scene.compound import Compound, Shape
from tamias2d.scene.rules import RuleError
from tamias2d.scene.scene import Scene
from tamias2d.scene.shapes import Single
from tamias2d.simulator.acting_scene import steady_loads, with_masses
from tamias2d.simulator.adding import listed_shapes
from tamias2d.simulator.body_now import shape_now
from tamias2d.simulator.columns import numbers, stated
from tamias2d.simulator.constitution import DRAGS, masses, refuse_tiny, stated_inertias
from tamias2d.simulator.exclusive import exclusive
from tamias2d.simulator.masses import Masses, Weights, masses_now, weights
from tamias2d.simulator.missing_restitution import refuse_reshaped
from tamias2d.simulator.selection import Bodies
from tamias2d.simulator.stepping import Change, Stepping
from tamias2d.state import Array, IntArray
from tamias2d.suggestions import suggests

Solid = Single | Compound
_OF = "the bodies"
_ROUNDED = 1e-9  # by which an inertia may differ from that of its shape, which is found again


class _Weighing(NamedTuple):
    """What changes where k bodies weigh other numbers; nothing is set yet."""

    rows: IntArray
    weights: Weights | None
    """None if all stay"""
    load: Array | None
    """(k, 3), N and N m, which comes to theirs; None if nothing depends on their masses"""
    scene: Scene | None
    """the one that acts on them then"""


@suggests
class Altering(Stepping):
    """Bodies get other masses, drags and shapes."""

    __slots__ = ()

    @exclusive
    def set_mass(self, bodies: Bodies, *, mass: object, inertia: object = None) -> None:
        """Change what bodies that can be pushed weigh, from the next step on (R2).

        `mass` is a number in kg for all of k bodies, or an array (k,); so is `inertia` in kg m^2,
        which changes in proportion to the mass where it is left out, whether it followed from the
        shape or was stated (DD92). Velocities stay, so that momentum changes, and so do the
        coefficients of drag, whose rates follow; but with an inertia of ``math.inf``, with which
        nothing turns a body, its angular velocity and angular drag end. What sleeps wakes where
        something changes. Loads that depend on the mass follow it, those of fields that stand in
        `force` too.

        Raises:
            InputError: a body is not there or cannot be pushed, or a value breaks a rule (R4).
        """
        self._to_set_mass(bodies, mass, inertia)()

    def _to_set_mass(self, bodies: Bodies, mass: object, inertia: object) -> Change:
        rows = self._rows(bodies)
        self._refuse_unpushed(rows, "mass")
        now, heavy = masses_now(self._engine, rows), masses(mass, _OF, len(rows))
        turned = _inertias(inertia, now, heavy)
        still = rows[np.isinf(turned)] if inertia is not None else rows[:0]
        new = now._replace(mass=heavy, inertia=turned)
        return partial(self._set_mass, self._weighing(rows, now, new), still)

    def _set_mass(self, weighing: _Weighing, still: IntArray) -> None:
        """Let bodies weigh other numbers; some of them are turned no more."""
        self._weigh(weighing)
        self._engine.velocity[still, 2] = 0.0

    @exclusive
    def set_drag(
        self, bodies: Bodies, *, linear_drag: object = None, angular_drag: object = None
    ) -> None:
        """Change how drag slows bodies that can be pushed, from the next step on (R2, IM6).

        `linear_drag` is a number in kg/s for all of k bodies, or an array (k,), and `angular_drag`
        one in kg m^2/s; what is left out stays.

        Raises:
            InputError: a body is not there or cannot be pushed, or a value breaks a rule (R4).
        """
        self._to_set_drag(bodies, linear_drag, angular_drag)()

    def _to_set_drag(self, bodies: Bodies, linear_drag: object, angular_drag: object) -> Change:
        rows, said = self._rows(bodies), {"linear_drag": linear_drag, "angular_drag": angular_drag}
        given = {
            key: numbers(value, key, _OF, DRAGS[key], count=len(rows), symbol=key)
            for key, value in stated(said, _OF, rule="R2").items()
        }
        self._refuse_unpushed(rows, next(iter(given)))
        now = masses_now(self._engine, rows)
        return partial(self._weigh, self._weighing(rows, now, now._replace(**given)))

    @exclusive
    def set_shape(
        self,
        bodies: Bodies,
        shape: Shape | Sequence[Shape],
        *,
        mass: object = None,
        inertia: object = None,
    ) -> None:
        """Give bodies other shapes, from the next step on; all else of them stays (R2).

        `shape` is one for all of k bodies, or a list of k. It is about the centre of mass, whose
        `position` stays, and so do velocities, names, joints, springs, filters and surfaces, but
        for what parts of a compound state themselves: that is what the new one says. The mass stays
        where `mass` does not say another one, as for `set_mass`. The inertia is that of the new
        shape; one that was stated stays as it is, in proportion to the mass, where `inertia` does
        not say another one.

        A pair that pushed each other in the step before, and do so in the next one, does not begin
        anew; one that does not is told in `ended`, though it may still meet. What overlaps then is
        pushed apart as bodies are that were moved by hand. The bodies wake, with what touches them.
        It takes about a millisecond, and the next step looks for pairs.

        Raises:
            InputError: a body is not there, has no shape, may not have such a one, or a value
                breaks a rule (R4).
            SceneError: bodies can meet now for which no restitution is stated.
        """
        self._to_set_shape(bodies, shape, mass, inertia)()

    def _to_set_shape(self, bodies: Bodies, shape: object, mass: object, inertia: object) -> Change:
        rows = self._rows(bodies)
        given = listed_shapes(shape, len(rows), _OF)
        self._refuse_shapes(rows, given)
        refuse_reshaped(self._engine, rows, given, self._name_of, self._joints)
        for key, value in (("mass", mass), ("inertia", inertia)):
            if value is not None:
                self._refuse_unpushed(rows, key)
        now = masses_now(self._engine, rows)
        heavy = now.mass if mass is None else masses(mass, _OF, len(rows))
        turned = _inertias(inertia, now, heavy)
        if inertia is None:
            turned = self._with_shapes(rows, given, now, heavy, turned)
        new = now._replace(mass=heavy, inertia=turned)
        weighing = self._weighing(rows, now, new)
        self._report()  # of what touched in shapes that go
        self._settle_between()
        last = dict(zip(rows.tolist(), given, strict=True))
        return partial(self._set_shape, last, weighing)

    def _set_shape(self, shapes: dict[int, Shape], weighing: _Weighing) -> None:
        """Give bodies shapes, by their rows; all is settled."""
        self._engine.set_shapes(np.array(list(shapes), dtype=np.int64), list(shapes.values()))
        self._weigh(weighing)
        self._joints.renew(set(shapes))
        self._unsettled = True

    def _with_shapes(
        self, rows: IntArray, shapes: Sequence[Shape], now: Masses, mass: Array, inertia: Array
    ) -> Array:
        """Return the inertias (k,) of bodies in shapes, kg m^2; `inertia` where it was stated."""
        found = inertia.copy()
        for k in np.flatnonzero(self._engine.kind[rows] == DYNAMIC).tolist():
            own = cast(Solid, shape_now(self._engine, int(rows[k]))).inertia(float(now.mass[k]))
            if abs(own - now.inertia[k]) <= _ROUNDED * own:
                found[k] = checked_inertia(None, float(mass[k]), shapes[k], _OF)
        return found

    def _refuse_unpushed(self, rows: IntArray, key: str) -> None:
        still = rows[self._engine.kind[rows] != DYNAMIC]
        if len(still):
            raise RuleError(
                f"{key.replace('_', ' ')} of {self._name_of(int(still[0]))}: nothing can push it, "
                "so that it has none (R2). Name bodies that can be pushed.",
                key,
            )

    def _refuse_shapes(self, rows: IntArray, shapes: Sequence[Shape]) -> None:
        """Refuse shapes that bodies may not have, and bodies that have none."""
        kinds = self._engine.kind[rows].tolist()
        for kind, shape in zip(kinds, shapes, strict=True):
            refuse_shape(shape, _OF, static=kind == STATIC, told=kind == KINEMATIC)
        shaped = np.isin(rows, self._engine.world.state.body_of_shape)
        if not shaped.all():
            raise RuleError(
                f"shape of {self._name_of(int(rows[~shaped][0]))}: it is a particle, which has no "
                "surface and no filters to keep (R3). Remove it, and add a body with a shape.",
                "shape",
            )

    def _weighing(self, rows: IntArray, now: Masses, new: Masses) -> _Weighing:
        """Return what changes where bodies weigh other numbers, or raise `InputError`."""
        told = weights(self._engine, rows, now, new)
        if self._scene is None or np.array_equal(now.mass, new.mass):
            return _Weighing(rows, told, None, self._scene)
        own, listed = self._staying, rows.tolist()
        was = steady_loads(self._scene, own, listed, now.mass)
        load = steady_loads(self._scene, own, listed, new.mass) - was
        return _Weighing(rows, told, load, with_masses(self._scene, own, listed, new.mass))

    def _weigh(self, weighing: _Weighing) -> None:
        """Let bodies weigh other numbers, and loads that depend on their masses follow."""
        rows, told, load, scene = weighing
        if told is not None:
            self._engine.set_masses(rows, *told)
        self._joints.note_masses()
        if load is not None:
            self._engine.load[rows] += load
            self._scene, self._unsettled = scene, True


def _inertias(inertia: object, now: Masses, mass: Array) -> Array:
    """Return inertias (k,), kg m^2: those that are stated, or in proportion to masses (k,), kg."""
    if inertia is not None:
        return stated_inertias(inertia, _OF, len(mass))
    with np.errstate(all="ignore"):
        later = definitions.inertia_later(now.inertia, now.mass, mass)
    later[np.isinf(later) & np.isfinite(now.inertia)] = np.nan  # beyond float64
    found: Array = np.where(mass == now.mass, now.inertia, later)
    refuse_tiny(found, "inertia", _OF)
    return found
