"""The contacts of one body, seen from it, and what is in a sensor."""

import numpy as np
from numpy.typing import NDArray

from tamias2d.engine import tables as tb
from tamias2d.engine.engine import Engine
from tamias2d.engine.reports.contact_report import NO_CONTACTS, Contacts, contacts_of, sensed_by
from tamias2d.scene.filters import checked_mask
from tamias2d.scene.rules import RuleError
from tamias2d.state import IntArray


def contacts_of_body(engine: Engine, told: Contacts, row: int, mask: object) -> Contacts:
    """Return the contacts of the body in a row with others that are there, with it as body A.

    Raises:
        InputError: the mask breaks a rule (R3).
    """
    wanted = _Wanted(engine, mask, "the contacts")
    bodies, point, normal, impulse, friction, separation = map(np.asarray, vars(told).values())
    is_body = bodies == row
    found = np.flatnonzero(is_body[:, 0] | is_body[:, 1])
    if len(found):
        found = found[wanted.among(bodies[found][~is_body[found]])]
    if len(found) == 0:
        return NO_CONTACTS
    turned = is_body[found, 1]
    pairs, away, drag = bodies[found], normal[found], friction[found]
    pairs[turned] = pairs[turned, ::-1]
    away[turned], drag[turned] = 0.0 - away[turned], 0.0 - drag[turned]  # no negative zeros
    return contacts_of((pairs, point[found], away, impulse[found], drag, separation[found]))


def bodies_inside(engine: Engine, row: int, name: str, mask: object) -> IntArray:
    """Return the bodies (k,) that the sensor in a row met in the last step, by rank.

    Raises:
        InputError: that body is no sensor, or the mask breaks a rule (R3).
    """
    wanted = _Wanted(engine, mask, "the question")
    shapes = engine.world.shapes.filters[engine.world.state.body_of_shape == row]
    if not shapes[:, tb.SENSOR].any():
        raise RuleError(
            f"sensor: {name} is none (R3). Name a body that was added with sensor=True, or ask "
            "`touching` for its contacts.",
            "sensor",
        )
    found = np.unique(sensed_by(engine, row))
    found = found[wanted.among(found)]
    inside: IntArray = found[np.argsort(engine.rank[found])]
    return inside


class _Wanted:
    """Which bodies are asked for: those that are there, of a category if a mask is given."""

    def __init__(self, engine: Engine, mask: object, of: str) -> None:
        self._state, self._filters = engine.world.state, engine.world.shapes.filters
        self._bits = None if mask is None else checked_mask(mask, of)

    def among(self, rows: IntArray) -> NDArray[np.bool_]:
        """Return which of the bodies in some rows (k,) are asked for: (k,)."""
        state = self._state
        there: NDArray[np.bool_] = state.kind[rows] != tb.ABSENT
        if self._bits is not None:
            category = np.zeros(len(state.kind), dtype=np.int64)
            category[state.body_of_shape] = self._filters[:, tb.CATEGORY]
            there &= category[rows] & self._bits != 0
        return there
