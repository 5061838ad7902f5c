"""Joints: what ties up to three bodies, or bodies to the plane, by an equation (TM7)."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import combinations
from typing import TypeAlias, cast

from tamias2d.generated.constraints import CONSTRAINTS
from tamias2d.scene.freedoms import VALUE_OF, Freedom
from tamias2d.scene.joint_equation import read_equations
from tamias2d.scene.rules import RuleError, Vector
from tamias2d.spec.constraint import ENDS, TIME
from tamias2d.spec.constraint_functions import ConstraintFunctions
from tamias2d.suggestions import suggests

End: TypeAlias = int | Vector
"""A body, by its index, or a point of the plane, m."""


@suggests
@dataclass(frozen=True, kw_only=True)
class Joint:
    """One joint of a scene, checked; made by `Scene.add_joint`."""

    name: str
    model: str
    """Its constraint in srs/models/joints.md; "equation" for one of its own."""
    ends: tuple[int | None, int | None, int | None]
    """The indices of bodies A, B and C; None for the plane."""
    anchors: tuple[Vector, Vector, Vector]
    """Where it holds each, in the body's own axes from its centre of mass, or in the plane, m."""
    parameters: tuple[tuple[str, float | Vector], ...] = ()
    """What else it is given, by symbol, SI units."""
    equations: tuple[str, ...] = ()
    """Its own, if it has any."""
    steepness: tuple[tuple[float, float], ...] = ()
    """By how much each row of these changes for each m, and for each rad, where it was added."""
    collide: bool = False
    """Whether the bodies that it holds may touch."""
    rigid: bool = True
    """Whether its constraint is kept; else it is but what its freedoms are measured with."""
    freedoms: tuple[Freedom, ...] = ()
    """What it leaves free and yet limits, drives or springs."""
    break_force: float | None = None
    """The reaction at which it breaks, N (GD23)."""
    break_torque: float | None = None
    """Likewise, N m."""

    @property
    def bodies(self) -> tuple[int, ...]:
        """The bodies that it holds."""
        return tuple(k for k in self.ends if k is not None)

    @cached_property
    def functions(self) -> ConstraintFunctions:
        """Its constraint, and what follows from it."""
        if self.equations:
            return read_equations(self.equations, f"joint '{self.name}'")
        return CONSTRAINTS[self.model]

    @property
    def driven(self) -> bool:
        """Whether its equation changes with time, so that it may do work."""
        return TIME in self.functions.constraint.arguments

    @property
    def kind(self) -> str:
        """The word for its kind in a scene file."""
        if self.model == "travel":
            return "target"
        if self.model == "groove" and self._is_wheel:
            return "wheel"
        if self.model == "angle":
            return "ratchet" if self.pitch else "rotary"
        return self.model

    @property
    def _is_wheel(self) -> bool:
        """Whether a groove has a motor about its point, or a suspension and no motor along it."""
        along = [freedom for freedom in self.freedoms if freedom.measure == "travel"]
        hangs = any(each.spring and not each.motor for each in along)
        return hangs or len(along) < len(self.freedoms)

    @property
    def governed(self) -> bool:
        """Whether it does more than keep its constraint: it limits, drives, springs or breaks."""
        return bool(self.freedoms) or self.breaks

    @property
    def switches(self) -> bool:
        """Whether what it exerts changes at instants: at limits, as a motor slips, as it breaks."""
        return self.breaks or self.limited or any(each.motor for each in self.freedoms)

    @property
    def may_switch(self) -> bool:
        """Whether it does: a motor without a maximum keeps its speed."""
        slips = any(each.motor and each.motor.maximum is not None for each in self.freedoms)
        return self.breaks or self.limited or slips

    @property
    def limited(self) -> bool:
        """Whether it limits a freedom, as the teeth of a ratchet do."""
        return any(each.limits or each.pitch for each in self.freedoms)

    @property
    def breaks(self) -> bool:
        """Whether it bears no more than something."""
        return self.break_force is not None or self.break_torque is not None

    @property
    def pitch(self) -> float:
        """From one tooth to the next, rad, of a ratchet; 0 of what is none."""
        return (self.freedoms[0].pitch or 0.0) if self.freedoms else 0.0

    def measured(self, freedom: Freedom, value: float) -> "Joint":
        """Return the joint that keeps one of its freedoms at a value, rad or m."""
        x, y = cast(Vector, dict(self.parameters).get("guide_a", (0.0, 0.0)))
        turned = (-y, x) if freedom.across else (x, y)
        guide = (("guide_a", turned),) if freedom.measure == "travel" else ()
        return replace(
            self,
            model=freedom.measure,
            parameters=(*guide, (VALUE_OF[freedom.measure], value)),
            rigid=True,
            freedoms=(),
        )

    @cached_property
    def given(self) -> dict[str, float | Vector]:
        """The values of all parameters of its constraint, by symbol."""
        known = dict(self.parameters)
        anchors = {f"anchor_{end}": at for end, at in zip(ENDS, self.anchors, strict=True)}
        return {name: known.get(name, anchors.get(name, 0.0)) for name in self.functions.parameters}


def refuse_joints(joints: Sequence[Joint], what: str, remedy: str) -> None:
    """Raise `RuleError` where there are joints, for something that knows none."""
    if joints:
        raise RuleError(
            f"joint '{joints[0].name}' of the scene: {what} knows no joints (R13). {remedy}",
            "joints",
        )


def kept_apart(joints: Iterable[Joint]) -> frozenset[tuple[int, int]]:
    """Return the pairs of bodies (i, j), i < j, that joints keep from touching."""
    return frozenset(
        pair
        for joint in joints
        if not joint.collide
        for pair in combinations(sorted(joint.bodies), 2)
    )
