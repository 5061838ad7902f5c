"""Which bodies may touch at all: category, mask and group (R3).

A category and a mask are whole numbers whose bits stand for kinds of bodies. Two bodies may touch
if each one's category shares a bit with the other's mask. Two of the same group, if that is not 0,
do not look at that: they always touch where the group is positive, and never where it is negative.
"""

from numbers import Integral
from typing import Protocol

from tamias2d.scene.rules import RuleError, checked_flag, shown

ALL = 2**63 - 1
"""The mask that shares a bit with every category."""
_WHOLE = {
    "category": (0, ALL, "Give a sum of powers of 2, e.g. 4, or 1 for the usual."),
    "mask": (0, ALL, "Give a sum of powers of 2, or leave it out to meet all."),
    "group": (-(2**63), ALL, "Give a whole number, or 0 for no group."),
}


class Filtered(Protocol):
    """Whatever has the three numbers."""

    @property
    def category(self) -> int:
        """Bits of the kinds that it is."""

    @property
    def mask(self) -> int:
        """Bits of the kinds that it may touch."""

    @property
    def group(self) -> int:
        """Its group, or 0."""


def may_touch(a: Filtered, b: Filtered) -> bool:
    """Whether two bodies may touch, by their groups, categories and masks."""
    if a.group == b.group != 0:
        return a.group > 0
    return bool(a.category & b.mask) and bool(b.category & a.mask)


def filters(body: Filtered) -> bool:
    """Whether a body does anything but touch all bodies that are like it."""
    return (body.category, body.mask, body.group) != (1, ALL, 0)


def checked_whole(value: object, key: str, of: str) -> int:
    """Return a category, a mask or a group, or raise `RuleError`."""
    low, high, remedy = _WHOLE[key]
    if type(value) is not int and (isinstance(value, bool) or not isinstance(value, Integral)):
        raise RuleError(
            f"{key} of {of}: found {shown(value)}: must be a whole number (R3). {remedy}", key
        )
    whole = int(value)
    if not low <= whole <= high:
        raise RuleError(
            f"{key} {shown(whole)} of {of}: must be from {low} to {high} (R3). {remedy}", key
        )
    return whole


def checked_mask(value: object, of: str) -> int:
    """Return a mask, that of all where it is None, or raise `RuleError`."""
    return ALL if value is None else checked_whole(value, "mask", of)


def checked_sensor(value: object, of: str) -> bool:
    """Return whether a body is a sensor, or raise `RuleError`."""
    return checked_flag(value, "sensor", of, rule="R3")
