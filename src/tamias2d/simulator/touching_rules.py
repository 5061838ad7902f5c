"""What bodies touch, and how, is changed between steps: filters and surfaces (R3)."""

from collections.abc import Mapping
from functools import partial

import numpy as np

from tamias2d.engine.tables import (
    CATEGORY,
    DYNAMIC,
    FRICTION,
    GROUP,
    MASK,
    RESTITUTION,
    SURFACE_SPEED,
)
from tamias2d.scene.filters import checked_whole
from tamias2d.scene.rules import RuleError, checked_count
from tamias2d.scene.surfaces import fault_of_part
from tamias2d.simulator.columns import numbers, stated, wholes
from tamias2d.simulator.constitution import SURFACE
from tamias2d.simulator.exclusive import exclusive
from tamias2d.simulator.missing_restitution import refuse_refiltered
from tamias2d.simulator.selection import Bodies
from tamias2d.simulator.stepping import Change, Stepping
from tamias2d.state import IntArray
from tamias2d.suggestions import suggests

_OF = "the bodies"
_FILTERS = {"category": CATEGORY, "mask": MASK, "group": GROUP}
_MATERIAL = {"friction": FRICTION, "restitution": RESTITUTION, "surface_speed": SURFACE_SPEED}


@suggests
class TouchingRules(Stepping):
    """Bodies get other filters and surfaces."""

    __slots__ = ()

    @exclusive
    def set_filters(
        self,
        bodies: Bodies,
        *,
        category: object = None,
        mask: object = None,
        group: object = None,
    ) -> None:
        """Change which others bodies may touch, from the next step on; what is left out stays (R3).

        Each is a whole number for all of k bodies, or an array (k,); a mask of 2**63 - 1 meets all.
        What touched and may no longer leaves `contacts`, and is told in `ended` by the next step;
        what overlaps and may touch now is pushed apart as bodies are that were moved by hand. What
        sleeps wakes where something changes. It takes some 100 microseconds, and the next step
        looks for pairs.

        Raises:
            InputError: a body is not there, or a value breaks a rule (R4).
            SceneError: bodies can meet now for which no restitution is stated.
        """
        self._to_set_filters(bodies, category=category, mask=mask, group=group)()

    def _to_set_filters(self, bodies: Bodies, **said: object) -> Change:
        rows = self._rows(bodies)
        columns = {
            _FILTERS[key]: wholes(value, key, _OF, count=len(rows), check=checked_whole)
            for key, value in stated(said, _OF, rule="R3").items()
        }
        refuse_refiltered(self._engine, rows, columns, self._name_of, self._joints)
        return partial(self._set_filters, rows, columns)

    def _set_filters(self, rows: IntArray, columns: Mapping[int, IntArray]) -> None:
        self._unsettled |= self._engine.set_filters(rows, columns)

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
        """Change friction, restitution and surface speed of bodies, from the next step on (R3).

        Each is a number for all of k bodies, or an array (k,); what is left out stays, and so does
        what is set for a pair. With `part`, a whole number or an array (k,), it is what one part of
        each body states, by its number in the compound; without, it is what the bodies state, which
        counts for the parts that state none. What sleeps on a surface that changes wakes. It takes
        some 60 microseconds, and the next step looks for pairs.

        Raises:
            InputError: a body or a part is not there, or a value breaks a rule (R4).
        """
        said = {"friction": friction, "restitution": restitution, "surface_speed": surface_speed}
        self._to_set_surface(bodies, part, **said)()

    def _to_set_surface(self, bodies: Bodies, part: object, **said: object) -> Change:
        rows = self._rows(bodies)
        columns = {
            _MATERIAL[key]: numbers(value, key, _OF, SURFACE[key], count=len(rows), symbol=key)
            for key, value in stated(said, _OF, rule="R3").items()
        }
        if said["surface_speed"] is not None:
            self._refuse_running(rows)
            self._refuse_part_that_runs(part)
        if part is None:
            return partial(self._engine.set_surfaces, rows, columns)
        self._settle_between()
        parts = self._checked_parts(rows, part)
        return partial(self._engine.set_part_surfaces, rows, parts, columns)

    def _checked_parts(self, rows: IntArray, part: object) -> IntArray:
        """Return the number of a part of each body (k,), or raise `RuleError`."""
        given = wholes(part, "part", _OF, count=len(rows), check=_checked_part)
        counts = self._engine.count_parts(rows)
        wrong = np.flatnonzero(given >= counts)
        if len(wrong):
            row, found, count = (int(of[wrong[0]]) for of in (rows, given, counts))
            raise RuleError(fault_of_part(self._name_of(row), found, count), "part")
        return given

    def _refuse_part_that_runs(self, part: object) -> None:
        if part is not None:
            raise RuleError(
                "surface_speed of a part: the surface of a body runs as one (DD97). Leave `part` "
                "out.",
                "part",
            )

    def _refuse_running(self, rows: IntArray) -> None:
        """Refuse a surface that runs on bodies that move freely (DD97)."""
        free = rows[self._engine.world.state.kind[rows] == DYNAMIC]
        if len(free):
            raise RuleError(
                f"surface_speed of {self._name_of(int(free[0]))}: only static and kinematic bodies "
                "have surfaces that run (DD97). Drive a wheel by a motor of its joint.",
                "surface_speed",
            )


def _checked_part(value: object, key: str, of: str) -> int:  # noqa: ARG001
    return checked_count(value, key, 0, remedy="Give the number of a part.")
