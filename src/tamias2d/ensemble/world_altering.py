"""Bodies are altered in many worlds between steps: masses, drags, surfaces, filters and shapes.

Serves: whoever draws what differs between episodes anew as each begins. Hides: that all worlds are
judged before any is altered.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np

from tamias2d.ensemble.controls import Controls
from tamias2d.scene.compound import Shape
from tamias2d.scene.rules import RuleError
from tamias2d.simulator.exclusive import exclusive
from tamias2d.simulator.selection import Bodies
from tamias2d.suggestions import suggests

_LISTS = (Sequence, np.ndarray)


@suggests
class WorldAltering(Controls):
    """Worlds whose bodies get other masses, drags, surfaces, filters and shapes.

    Each call alters k bodies in all worlds, as the call of that name alters those of a `Simulator`.
    """

    __slots__ = ()

    @exclusive
    def set_mass(self, bodies: Bodies, *, mass: object, inertia: object = None) -> None:
        """Change what k bodies weigh in all worlds, as `Simulator.set_mass` does (R2).

        `mass`, kg, and `inertia`, kg m^2, are one for all, (k,) or (worlds, k); for one body, given
        by its index or name, one for all or (worlds,). It takes some 100 microseconds a world, and
        counts until it is changed or the world is reset.

        Raises:
            InputError: a body is not there or cannot be pushed, or a value breaks a rule (R4);
                nothing is set in any world then.
        """
        given = self._given(bodies, mass=mass, inertia=inertia)
        self._in_all(lambda w, sim: sim._to_set_mass(bodies, **given[w]))

    @exclusive
    def set_drag(
        self, bodies: Bodies, *, linear_drag: object = None, angular_drag: object = None
    ) -> None:
        """Change how drag slows k bodies in all worlds, as `Simulator.set_drag` does (R2, IM6).

        `linear_drag`, kg/s, and `angular_drag`, kg m^2/s, have the shapes of `set_mass`; what is
        left out stays. It takes some 600 microseconds a world.

        Raises:
            InputError: a body is not there or cannot be pushed, or a value breaks a rule (R4);
                nothing is set in any world then.
        """
        given = self._given(bodies, linear_drag=linear_drag, angular_drag=angular_drag)
        self._in_all(lambda w, sim: sim._to_set_drag(bodies, **given[w]))

    @exclusive
    def set_surface(
        self,
        bodies: Bodies,
        *,
        friction: object = None,
        restitution: object = None,
        surface_speed: object = None,
        part: object = None,
    ) -> None:
        """Change the surfaces of k bodies in all worlds, as `Simulator.set_surface` does (R3).

        All have the shapes of `set_mass`; `part` is a whole number. What is left out stays. It
        takes some 50 microseconds a world.

        Raises:
            InputError: a body or a part is not there, or a value breaks a rule (R4); nothing is
                set in any world then.
        """
        said = {"friction": friction, "restitution": restitution, "surface_speed": surface_speed}
        given = self._given(bodies, part=part, **said)
        self._in_all(lambda w, sim: sim._to_set_surface(bodies, **given[w]))

    @exclusive
    def set_filters(
        self,
        bodies: Bodies,
        *,
        category: object = None,
        mask: object = None,
        group: object = None,
    ) -> None:
        """Change whom k bodies may touch in all worlds, as `Simulator.set_filters` does (R3).

        All are whole numbers, in the shapes of `set_mass`; what is left out stays. It takes some
        70 microseconds a world.

        Raises:
            InputError: a body is not there, or a value breaks a rule (R4); nothing is set in any
                world then.
            SceneError: bodies can meet in a world for which no restitution is stated; likewise.
        """
        given = self._given(bodies, category=category, mask=mask, group=group)
        self._in_all(lambda w, sim: sim._to_set_filters(bodies, **given[w]))

    @exclusive
    def set_shape(
        self,
        bodies: Bodies,
        shape: Shape | Sequence[Shape] | Sequence[Sequence[Shape]],
        *,
        mass: object = None,
        inertia: object = None,
    ) -> None:
        """Give k bodies other shapes in all worlds, as `Simulator.set_shape` does (R2).

        `shape` is one for all, a list of k, or a list of such lists, one for each world; for one
        body, given by its index or name, one for all or a list of one for each world. `mass` and
        `inertia` are those of `set_mass`. It takes some 700 microseconds a world.

        Raises:
            InputError: a body is not there, has no shape, may not have such a one, or a value
                breaks a rule (R4); nothing is set in any world then.
            SceneError: bodies can meet in a world for which no restitution is stated; likewise.
        """
        given = self._given(bodies, mass=mass, inertia=inertia)
        shapes = self._shapes(bodies, shape)
        self._in_all(lambda w, sim: sim._to_set_shape(bodies, shapes[w], **given[w]))

    def _given(self, bodies: Bodies, **said: object) -> list[dict[str, object]]:
        """Return of each world what is said of k bodies, each (k,), or None where left out."""
        columns = {
            key: [None] * len(self._sims)
            if value is None
            else self._of_bodies(bodies, value, key, "Give one for all, or as many.")
            for key, value in said.items()
        }
        return [{key: c[w] for key, c in columns.items()} for w in range(len(self._sims))]

    def _shapes(self, bodies: Bodies, shape: object) -> Sequence[Any]:
        """Return of each world a shape for all of its bodies, or a list of theirs."""
        worlds, one = len(self._sims), np.ndim(bodies) == 0
        if not isinstance(shape, _LISTS):
            return [shape] * worlds
        by_world = one or any(isinstance(each, _LISTS) for each in shape)
        if by_world and len(shape) != worlds:
            raise RuleError(
                f"shape of the worlds: found {len(shape)} for {worlds} worlds: must be as many "
                "(R4). Give one shape, or one for each world.",
                "shape",
            )
        return list(shape) if by_world else [shape] * worlds
