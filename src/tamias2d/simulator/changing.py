"""Bodies come and go between steps (R2)."""

from typing import Any

import numpy as np

from tamias2d.engine.bodies.batch import Batch
from tamias2d.engine.tables import DYNAMIC, KINEMATIC, STATIC
from tamias2d.simulator.acting_scene import with_steady_loads
from tamias2d.simulator.adding import Shapes, added_batch, count_of
from tamias2d.simulator.exclusive import exclusive
from tamias2d.simulator.missing_restitution import refuse_missing_restitution
from tamias2d.simulator.selection import Bodies
from tamias2d.simulator.stepping import Stepping
from tamias2d.suggestions import suggests


@suggests
class Changing(Stepping):
    """Bodies are added and removed."""

    __slots__ = ()

    @exclusive
    def add(
        self,
        shape: Shapes,
        *,
        mass: object,
        position: object,
        velocity: object = (0.0, 0.0),
        orientation: object = 0.0,
        angular_velocity: object = 0.0,
        force: object = (0.0, 0.0),
        torque: object = 0.0,
        linear_drag: object = 0.0,
        angular_drag: object = 0.0,
        inertia: object = None,
        restitution: object = None,
        friction: object = None,
        category: object = 1,
        mask: object = None,
        group: object = 0,
        sensor: bool = False,
        name: object = None,
    ) -> Any:
        """Add bodies that move, and return their indices (R2).

        One body where `position` is (2,), with its index; k bodies where it is (k, 2), with an
        array of indices. Of all else, one value serves all, or there is an array with a row for
        each. `shape` is one, or a list of k, and so is `name`, by which bodies are found and
        told of, if they are given names; the words are those of `Scene.add_body`. Attraction and
        fields of the scene that are for all bodies that move act on them, too.

        Raises:
            InputError: a value breaks a rule (R4), or a field has no finite value where a body is;
                the message names it and its place.
        """
        batch = added_batch(DYNAMIC, locals())
        if self._scene is not None:
            batch = with_steady_loads(self._scene, batch, self.time)
        return self._add(batch, position, name)

    @exclusive
    def add_static(
        self,
        shape: Shapes,
        *,
        position: object = (0.0, 0.0),
        orientation: object = 0.0,
        restitution: object = None,
        friction: object = None,
        surface_speed: object = 0.0,
        category: object = 1,
        mask: object = None,
        group: object = 0,
        sensor: bool = False,
        name: object = None,
    ) -> Any:
        """Add bodies that nothing moves, and return their indices, as `add` does.

        What runs along their surfaces, as a belt, `Scene.add_static` says.
        """
        return self._add(added_batch(STATIC, locals()), position, name)

    @exclusive
    def add_kinematic(
        self,
        shape: Shapes,
        *,
        position: object,
        velocity: object = (0.0, 0.0),
        orientation: object = 0.0,
        angular_velocity: object = 0.0,
        restitution: object = None,
        friction: object = None,
        surface_speed: object = 0.0,
        category: object = 1,
        mask: object = None,
        group: object = 0,
        sensor: bool = False,
        name: object = None,
    ) -> Any:
        """Add bodies that move as they are told, and return their indices, as `add` does."""
        return self._add(added_batch(KINEMATIC, locals()), position, name)

    def _add(self, batch: Batch, position: object, name: object) -> Any:
        names = self._names.checked(name, len(batch))
        refuse_missing_restitution(self._engine, batch, self._name_of)
        rows = self._engine.add(batch)
        self._names.give(rows.tolist() if names else (), names)
        self._look_anew()
        self._unsettled = True
        one = len(rows) == 1 and count_of(position) is None
        return int(rows[0]) if one else rows

    @exclusive
    def remove(self, bodies: Bodies) -> None:
        """Take bodies out; the indices of all others stay; springs and joints that held them go.

        Raises:
            InputError: a body is not there.
        """
        rows = self._rows(bodies)
        rows = np.unique(rows) if len(rows) > 1 else rows
        gone = set(rows.tolist())
        self._engine.wake(np.array(self._joints.drop_bodies(gone), dtype=np.int64))
        self._engine.remove(rows)
        self._parted = [pair for pair in self._parted if gone.isdisjoint(pair)]
        if self._pushed is not None:
            self._pushed[rows[rows < len(self._pushed)]] = 0.0
        self._names.forget(gone)
        self._staying -= gone
        self._unsettled = True
