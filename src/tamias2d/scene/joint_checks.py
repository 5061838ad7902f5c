"""The checks of a joint: it ties bodies that can move, and holds at the start (R4, R13).

What is not given, such as a length, is found from how the bodies stand at the start.
"""

import math
from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from tamias2d.scene.freedoms import at_rest as freedoms_at_rest, refuse_crossed
from tamias2d.scene.joint_kinds import Equation, JointKind
from tamias2d.scene.joint_start import Start
from tamias2d.scene.joints import End, Joint
from tamias2d.scene.placed_bodies import PlacedBodies
from tamias2d.scene.rules import RuleError, Vector, checked_flag, number, shown, vector
from tamias2d.spec.constraint import ENDS

_FITS = 1e-6
"""Of the joint's size, and of the speeds: by so much a joint may be off at the start, as written
numbers are; the run begins with what fits."""
_ROUNDING = 2.0**-46
"""Of the joint's size in a second: speeds below it are what rounding leaves of rest."""

_NO_FORCE = {"angle", "gear"}
_NO_TORQUE = {"revolute", "distance", "pulley"}
"""Constraints, and measures of freedoms, that exert none about the anchor of A."""


def checked_joint(
    kind: object,
    name: str,
    ends: tuple[End, End, End],
    anchors: tuple[object, object, object],
    collide: object,
    bodies: PlacedBodies,
    bears: tuple[object, object] = (None, None),
    *,
    at_rest: bool = False,
    time: float = 0.0,
) -> Joint:
    """Return a joint that ties bodies and holds at the start, or raise `RuleError`.

    That is at a time, s. If it is only asked `at_rest`, the velocities may be such as to tear it.
    """
    of = f"joint '{name}'"
    if not isinstance(kind, JointKind):
        raise RuleError(
            f"kind of {of}: found {shown(kind)}: must be a kind of joint (TM7). Give one such as "
            "Revolute() or Distance(length=1.0), with its brackets.",
            "kind",
        )
    collide = checked_flag(
        collide, "collide", of, rule="TM7", remedy="Say whether the bodies may touch."
    )
    held = [end if isinstance(end, int) else None for end in ends]
    placed = [
        _anchor(end, anchor, of, key)
        for end, anchor, key in zip(
            ends, anchors, ("anchor", "other_anchor", "third_anchor"), strict=True
        )
    ]
    own = tuple(kind.equations) if isinstance(kind, Equation) else ()
    joint = Joint(
        name=name,
        model=kind.model,
        ends=(held[0], held[1], held[2]),
        anchors=(placed[0], placed[1], placed[2]),
        equations=own,
        collide=collide,
        rigid=kind.rigid,
        freedoms=kind.freedoms(of),
        break_force=_bears(bears[0], "joint_force_most", of, "break_force", "N"),
        break_torque=_bears(bears[1], "joint_torque_most", of, "break_torque", "N m"),
    )
    if joint.breaks and any(each.spring for each in joint.freedoms):
        raise RuleError(
            f"{of}: it has a spring and may break, and what becomes of the spring's energy is open "
            "(GD23). Take one joint that breaks and another with the spring.",
            "break_force",
        )
    _refuse_unfelt(joint, of)
    _refuse_idle(joint, bodies, of)
    return _fitted(joint, kind, bodies, of, time, at_rest=at_rest)


def checked_again(joint: Joint, bodies: PlacedBodies) -> Joint:
    """Return a joint that holds at the start of other bodies, too, or raise `RuleError`."""
    of = f"joint '{joint.name}'"
    joint = _checked_start(joint, bodies, of)
    refuse_crossed(joint.freedoms, values_of_freedoms(joint, bodies), of)
    return joint


def _checked_start(
    joint: Joint, bodies: PlacedBodies, of: str, time: float = 0.0, *, at_rest: bool = False
) -> Joint:
    """Return a joint with what it takes from the start, which it has to fit."""
    start = Start(joint, bodies, time)
    _refuse_singular(start, bodies, of)
    if joint.rigid:
        _refuse_unfit(start, of, at_rest=at_rest)
    return replace(joint, steepness=start.steepness) if joint.equations else joint


def _bears(value: object, symbol: str, of: str, key: str, unit: str) -> float | None:
    if value is None:
        return None
    return number(value, symbol, of, f"Give it in {unit}, or leave it out.", at=(key,))


def values_of_freedoms(joint: Joint, bodies: PlacedBodies) -> list[float]:
    """Return where the freedoms of a joint are as its bodies stand, rad or m."""
    return [
        float(Start(joint.measured(each, 0.0), bodies).rows[0]) + 0.0 for each in joint.freedoms
    ]


def _anchor(end: End, anchor: object, of: str, key: str) -> Vector:
    """Return where a joint holds a body; a point of the plane is its own anchor."""
    remedy = "Give (x, y) in m, in the body's axes."
    at = vector(anchor, "anchor", of, remedy, at=(key,))
    if isinstance(end, int):
        return at
    if at != (0, 0):
        raise RuleError(
            f"{key.replace('_', ' ')} of {of}: a point of the plane has none (TM7). Move the point "
            "itself.",
            key,
        )
    return end


def _refuse_unfelt(joint: Joint, of: str) -> None:
    """Refuse a largest force or torque of a joint that never exerts one."""
    exerts = {joint.model} if joint.rigid else set()
    exerts |= {each.measure for each in joint.freedoms}
    for what, most, never, unit in (
        ("force", joint.break_force, _NO_FORCE, "N m"),
        ("torque", joint.break_torque, _NO_TORQUE, "N"),
    ):
        if most is not None and exerts <= never:
            other = "torque" if what == "force" else "force"
            raise RuleError(
                f"break_{what} of {of}: one of kind {joint.kind} exerts no {what} where it holds "
                "its bodies, and never breaks by one (GD23). Leave it out, or give "
                f"break_{other} in {unit}.",
                f"break_{what}",
            )


def _refuse_idle(joint: Joint, bodies: PlacedBodies, of: str) -> None:
    """Refuse a joint that holds a body twice, none that moves, or one whose motion is given."""
    held = joint.bodies
    for k in held:
        if held.count(k) > 1:
            raise RuleError(
                f"{of}: it ties '{bodies[k].name}' to itself (TM7). Name two bodies.", "between"
            )
    if not any(bodies[k].dynamic for k in held):
        raise RuleError(f"{of}: it holds no body that moves (TM7). Name one that does.", "between")


def _fitted(
    joint: Joint, kind: JointKind, bodies: PlacedBodies, of: str, time: float, *, at_rest: bool
) -> Joint:
    """Return the joint with all its parameters; what is not given is as at the start."""
    known = {name: value for name, value in kind.given.items() if value is not None}
    joint = _with(joint, known)
    _refuse_missing(joint, of)
    for name in (name for name, value in kind.given.items() if value is None):
        start = Start(_with(joint, {**known, name: 0.0}), bodies)
        known[name] = float(start.rows[-1]) + 0.0
        joint = _with(joint, known)
    joint = _checked_start(joint, bodies, of, time, at_rest=at_rest)
    return _governed(joint, bodies, of)


def _governed(joint: Joint, bodies: PlacedBodies, of: str) -> Joint:
    """Return the joint with what its freedoms take from the start."""
    for each in joint.freedoms:
        _refuse_singular(Start(joint.measured(each, 0.0), bodies), bodies, of)
    values = values_of_freedoms(joint, bodies)
    refuse_crossed(joint.freedoms, values, of)
    return replace(joint, freedoms=freedoms_at_rest(joint.freedoms, values))


def _with(joint: Joint, known: Mapping[str, float | Vector]) -> Joint:
    return replace(joint, parameters=tuple(known.items()))


def _refuse_missing(joint: Joint, of: str) -> None:
    """Refuse a body that the equation does not ask for, and a body C that is not given.

    Without a third body a gear or a pulley is seen from the plane, as their equations are meant; in
    an equation of one's own a C that is not given is more likely forgotten.
    """
    taken = joint.functions.bodies
    if joint.equations and "c" in taken and joint.ends[2] is None:
        raise RuleError(
            f"{of}: its equation asks where body C is, and no third body is given (TM7). Give "
            "'third', or let the equation do without C: a point of the plane is a number in it.",
            "equations",
        )
    for end, body in zip(ENDS, joint.ends, strict=True):
        if body is not None and end not in taken:
            raise RuleError(
                f"{of}: its equation does not ask where body {end.upper()} is (TM7). Leave that "
                "body out, or let the equation hold it.",
                "third" if end == "c" else "between",
            )


def _refuse_singular(start: Start, bodies: PlacedBodies, of: str) -> None:
    """Refuse a joint without finite value and slopes at the start, or that turns a mere point."""
    parts = (start.rows, start.rates, start.convective, *start.slopes.values())
    if not all(np.isfinite(part).all() for part in parts):
        raise RuleError(
            f"{of}: its equation has no finite derivative at the start (TM7): its ends are at one "
            "place, or it divides by zero there. Move them apart; two points at one place are held "
            "by a Revolute().",
            "between",
        )
    moving = [k for k in start.joint.bodies if bodies[k].dynamic]
    ends = [end for end, k in zip(ENDS, start.joint.ends, strict=True) if k in moving]
    rows = np.hstack([start.slopes[end] for end in ends])
    if not np.abs(rows).max(axis=1).all():
        raise RuleError(
            f"{of}: its equation does not change with any place of a body that moves (TM7): its "
            "slope at the start is 0. Rewrite it, or begin elsewhere.",
            "between",
        )
    for body in start.turned:
        if body.dynamic and body.inertia == math.inf and not body.inertia_stated:
            raise RuleError(
                f"{of}: '{body.name}' has no inertia, and the joint would turn it (IM2, TM7). "
                "State its inertia.",
                "between",
            )
    if not start.moves:
        names = " and ".join(f"'{bodies[k].name}'" for k in moving)
        raise RuleError(
            f"{of}: it would only turn {names}, which nothing turns: the inertia is infinite (TM7, "
            "DD20). Leave out what turns, or give a finite inertia.",
            "between",
        )


def _refuse_unfit(start: Start, of: str, *, at_rest: bool = False) -> None:
    """Refuse a joint that does not hold at the start."""
    if start.way(start.rows) > _FITS * start.size:
        raise RuleError(
            f"{of}: it does not hold at the start: it is off by "
            f"{start.worst(np.abs(start.rows))} (TM7). Move the bodies or the anchors so that it "
            "fits: these are the centres of bodies unless they are stated, and `at` puts all of "
            "them at one place of the world.",
            "between",
        )
    slight = max(_FITS * start.speed, _ROUNDING * start.size)
    if not at_rest and start.way(start.rates) > slight:
        raise RuleError(
            f"{of}: the velocities at the start tear it: it is left at "
            f"{start.worst(start.rates, '/s')} (TM7). Give its bodies velocities that fit.",
            "between",
        )
