"""The first number, to the last bit, in which two histories of one run differ."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from tamias2d.generated.symbols import SYMBOLS
from tamias2d.record import history

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from tamias2d.run_data import RunData

_SYMBOL_OF = {"point": "position", "contact_force": "force", "contact_torque": "torque"}
"""Of quantities that have no symbol of their own."""


@dataclass(frozen=True)
class Difference:
    """One number that a recomputation gives otherwise than it was recorded."""

    time: float
    """s"""
    of: str
    """Whose it is: ``body 'ball'``, ``the impact of 'ball' and 'floor'``, ``the scene``."""
    quantity: str
    """With its component: ``velocity y``."""
    recorded: float
    recomputed: float
    unit: str

    def __str__(self) -> str:
        values = f"recorded {self.recorded!r}, recomputed {self.recomputed!r}"
        unit = "" if self.unit == "1" else f" {self.unit}"
        return f"at {self.time!r} s, {self.of}, {self.quantity}: {values}{unit}"


def first_difference(recorded: RunData, recomputed: RunData) -> Difference | None:
    """Return the earliest number that differs, or None if the runs are identical."""
    found = [
        *_of_samples(recorded, recomputed),
        *_of_impacts(recorded, recomputed),
        *_of_joint_events(recorded, recomputed),
    ]
    return min(found, key=lambda difference: difference.time, default=None)


def _of_samples(recorded: RunData, recomputed: RunData) -> Iterator[Difference]:
    names = [body.name for body in recorded.scene.bodies]
    yield from _counts("samples", recorded.times, recomputed.times)
    told = recorded.contact_force is not None and recomputed.contact_force is not None
    contacts = history.OF_CONTACTS if told else {}
    for quantity in ("times", *history.OF_BODIES, *contacts, *history.TOTALS):
        a, b = getattr(recorded, quantity), getattr(recomputed, quantity)
        place = _first(a, b)
        if place is not None:
            in_body = quantity in (*history.OF_BODIES, *contacts)
            of = f"body {names[place[1]]!r}" if in_body else "the scene"
            yield _difference(
                recorded.times[place[0]], of, quantity, place[1 + in_body :], a[place], b[place]
            )


def _of_impacts(recorded: RunData, recomputed: RunData) -> Iterator[Difference]:
    a, b = recorded.impacts, recomputed.impacts
    unseen = len(b) > len(a) and b.time[len(a)] > recorded.times[-1]
    if not unseen:  # as they are to a run that was interrupted
        yield from _counts("impacts", a.time, b.time)
    for quantity in history.OF_IMPACTS:
        ours, theirs = getattr(a, quantity), getattr(b, quantity)
        place = _first(ours, theirs)
        if place is not None:
            pair = " and ".join(repr(recorded.scene.bodies[i].name) for i in a.bodies[place[0]])
            time = float(a.time[place[0]])
            of = f"impact {place[0]} of {pair}"
            yield _difference(time, of, quantity, place[1:], ours[place], theirs[place])


def _of_joint_events(recorded: RunData, recomputed: RunData) -> Iterator[Difference]:
    a, b = recorded.joint_events, recomputed.joint_events
    unseen = len(b) > len(a) and b.time[len(a)] > recorded.times[-1]
    if not unseen:  # as they are to a run that was interrupted
        yield from _counts("events of joints", a.time, b.time)
    for quantity in history.OF_JOINT_EVENTS:
        ours, theirs = getattr(a, quantity), getattr(b, quantity)
        if (place := _first(ours, theirs)) is not None:
            name = recorded.scene.joints[a.joint[place[0]]].name
            of = f"event {place[0]} of joint {name!r}"
            yield _difference(float(a.time[place[0]]), of, quantity, (), ours[place], theirs[place])


def _counts(what: str, a: NDArray[np.float64], b: NDArray[np.float64]) -> Iterator[Difference]:
    """Differ from the first time that only one of two lists of times has."""
    if len(a) != len(b):
        longer, short = (a, len(b)) if len(a) > len(b) else (b, len(a))
        yield Difference(
            float(longer[short]), "the scene", f"number of {what}", len(a), len(b), "1"
        )


def _first(a: NDArray[Any], b: NDArray[Any]) -> tuple[int, ...] | None:
    """Index of the first number whose bits differ, among the rows that both have."""
    rows = min(len(a), len(b))
    a, b = (np.ascontiguousarray(part[:rows]) for part in (a, b))
    differ = a.view(np.int64) != b.view(np.int64)  # so that NaN equals itself, and -0.0 is not 0.0
    if not differ.any():
        return None
    return tuple(int(i) for i in np.unravel_index(differ.argmax(), differ.shape))


def _difference(
    time: float, of: str, quantity: str, component: tuple[int, ...], a: float, b: float
) -> Difference:
    symbol = SYMBOLS.get(_SYMBOL_OF.get(quantity, quantity.removesuffix("s")))
    axes = "AB" if quantity == "bodies" else "xy"
    axis = f" {axes[component[0]]}" if component else ""
    return Difference(
        float(time), of, quantity + axis, float(a), float(b), symbol.unit if symbol else "1"
    )
