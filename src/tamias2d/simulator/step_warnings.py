"""What steps cannot hold: springs, gravity, weights, masses, joints and open corners, in words.

Serves: the simulator, which tells each once. Each text comes with the name under which it is kept.
"""

import math
from collections.abc import Callable, Collection, Iterable, Iterator

import numpy as np

from tamias2d.engine.engine import Engine
from tamias2d.engine.tables import KINEMATIC
from tamias2d.scene.joints import Joint
from tamias2d.simulator.hand_placed import beyond_limits
from tamias2d.simulator.joint_faults import apart, gained, too_stiff, turned
from tamias2d.simulator.joint_layout import APART, JointLayout
from tamias2d.simulator.moved_limits import Passed
from tamias2d.simulator.warned import Told

SPRINGS = "springs"
_SHORTEST = 2.0**-10  # of a step: its shortest part


def too_long_for_springs(of: str, time: float, time_step: float) -> Told:
    """Return the warning of springs of a body, before a time, s, that are not solved (IM14)."""
    return SPRINGS, (
        f"springs of {of}, before {time:.6g} s: in the shortest parts "
        f"of a time step of {time_step:.6g} s, too, they turn too far to be solved, "
        "and their energy is not kept (IM14). Give a shorter step."
    )


def too_long_for_contacts(
    engine: Engine, name_of: Callable[[int], str], time: float, time_step: float, substeps: int
) -> Iterator[Told]:
    """Yield what contacts could not hold before a time, s: weights (IM10) and masses (GD12)."""
    when, step = f"before {time:.6g} s", f"steps of {time_step:.6g} s in {substeps} substeps"
    if (pair := engine.sunk) is not None:
        first, second = map(name_of, pair)
        if (driver := _driver(engine, pair)) is None:
            what, remedy = "what weighs on them", "Give a shorter step or more substeps."
        else:
            what = f"{name_of(driver)}, which goes on whatever it meets"
            remedy = "Move it by a velocity, not by its position, and stop it where it cannot go."
        text = (
            f"{first} and {second}, {when}: they overlap by more than a quarter of the "
            f"thinner one's width, or of the length of what is thin, and ever more; {step} do not "
            f"hold {what} (IM10). {remedy}"
        )
        yield "overlap", text
    if (pair := engine.pressed) is not None:
        first, second = map(name_of, pair)
        text = (
            f"{first} and {second}, {when}: what presses them together moves one of them by more "
            f"than its width in a substep; {step} do not hold that, and they may pass each other "
            "(IM10). Give a shorter step or more substeps."
        )
        yield "pressed", text
    if (row := engine.outweighed) >= 0:
        text = (
            f"{name_of(row)}, {when}: it touches or is joined to masses so different from its own "
            f"that {step} do not solve what bears it (GD12, IM15). Give more substeps, a shorter "
            "step or masses less different."
        )
        yield "masses", text


def _driver(engine: Engine, pair: tuple[int, int]) -> int | None:
    """Return the kinematic body among a pair or what pushes one of it, if there is one."""
    meet = engine.contact_report().bodies
    near = {*pair, *meet[np.isin(meet, pair).any(axis=1)].ravel().tolist()}
    return next((row for row in sorted(near) if engine.kind[row] == KINEMATIC), None)


_REMEDIES = {
    "yields": "It cannot hold, and yields (DD86): bring what drives it back into its reach, or "
    "drive it by a Target.",
    "overloaded": "Nothing drives it, but what falls on it or pulls at it is more than it can "
    "hold, and it yields (DD86): give what hangs between points that stand some slack, or give a "
    "shorter step.",
    "by hand": "It follows what was moved by hand within some steps: move that in smaller ones, or "
    "give a kinematic body a velocity.",
    "placed": "A body that it holds was put elsewhere by hand. It comes back within some steps, "
    "but lifts nothing for that: put all that hangs together where its joints fit.",
    "": "Give a shorter step or more substeps.",
}


def held_beyond_limits(joints: Iterable[Joint], engine: Engine, time: float) -> Iterator[Told]:
    """Yield joints that were put beyond a limit by hand before a time, s (GD21).

    What is less than `APART`, in rad or of the size of a joint, is not told.
    """
    for joint, side, much in beyond_limits(joints, engine):
        text = (
            f"joint '{joint.name}' ({joint.kind}), at {time:.6g} s: it was put {much:.2g} (m or "
            f"rad) beyond its {side} limit by hand (GD21). It comes back within some steps, but "
            "lifts nothing for that: put its bodies where its limits allow."
        )
        yield f"{side} limit of {joint.name}", text


def jumped_past(joint: Joint, passed: Iterable[Passed], time: float) -> Iterator[Told]:
    """Yield the limits that jumped past a joint at a time, s (GD21)."""
    for each in passed:
        if each.is_far:
            text = (
                f"joint '{joint.name}' ({joint.kind}), at {time:.6g} s: its {each.side} limit "
                f"jumped past it by {each.moved:.2g} (m or rad) (GD21). It comes back within some "
                "steps, and gets no speed of that: move a limit by less in a step, and it takes "
                "the joint along."
            )
            yield f"jump of the {each.side} limit of {joint.name}", text


def too_long_for_joints(
    layout: JointLayout, placed: Collection[str], time: float, time_step: float
) -> Iterator[Told]:
    """Yield joints that were apart before a time, s (R13), turned far, or made energy (IM15).

    Of some a body was placed by hand before the last steps.
    """
    if (found := apart(layout)) is not None:
        joint, much, why = found
        why = why or ("placed" if joint.name in placed else "")
        remedy = _REMEDIES[why]
        text = (
            f"joint '{joint.name}' ({joint.kind}), before {time:.6g} s: it was {much:.2g} "
            f"apart (m or rad) in a step of {time_step:.6g} s, more than {APART:g} of "
            f"its size (R13). {remedy}"
        )
        yield f"joint {joint.name} {why}", text
    whirled = turned(layout)
    if whirled is not None and whirled.name not in placed:  # what is put elsewhere has not turned
        text = (
            f"joint '{whirled.name}' ({whirled.kind}), before {time:.6g} s: what it holds turned "
            f"by more than half a radian in a substep of a step of {time_step:.6g} s, which costs "
            "energy (IM15). Give a shorter step or more substeps."
        )
        yield f"turn of {whirled.name}", text
    if (driven := gained(layout)) is not None:
        text = (
            f"joint '{driven.name}' ({driven.kind}), before {time:.6g} s: in steps of "
            f"{time_step:.6g} s what it holds and what touches that got energy, more than "
            "0.001 of theirs (IM15). Give a shorter step, more substeps or masses less different."
        )
        yield f"energy of {driven.name}", text


def too_stiff_for_steps(
    joints: Iterable[Joint], engine: Engine, time_step: float
) -> Iterator[Told]:
    """Yield a joint with a spring that float64 does not solve (R13)."""
    if (found := too_stiff(joints, engine, time_step)) is not None:
        joint, stiffness = found
        text = (
            f"joint '{joint.name}' ({joint.kind}): its spring of stiffness {stiffness:.3g} (N/m or "
            f"N m/rad) moves so little in a time step of {time_step:.6g} s that rounding gives it "
            "energy (R13). Give a softer one, a shorter step, or a joint without this freedom."
        )
        yield f"stiffness of {joint.name}", text


def too_long_for_gravity(engine: Engine, time_step: float) -> Iterator[Told]:
    """Yield that gravity moves even the largest body too far in the shortest part of a step (IM12).

    Then each step takes as many parts as there may be, and none of them is short enough.
    """
    size, pull = engine.largest_radius, math.hypot(*engine.gravity.tolist())
    if pull > _strongest_gravity(size, time_step):
        text = (
            f"gravity of {pull:.6g} m/s^2: in 1/1024 of a time step of {time_step:.6g} s, its "
            f"shortest part, it moves bodies farther than any is wide ({size:.6g} m): each step "
            "costs up to 1024 times as much, and contacts give way (IM12). Give a time step of "
            f"at most {math.sqrt(size / pull):.3g} s."
        )
        yield "gravity", text


def strongest_gravity(engine: Engine, time_step: float) -> float:
    """Return the gravity, m/s^2, that moves the largest body by its radius in the shortest part."""
    return _strongest_gravity(engine.largest_radius, time_step)


def _strongest_gravity(size: float, time_step: float) -> float:
    """Return that for the radius of the largest body, m."""
    shortest = _SHORTEST * time_step
    return size / shortest / shortest if size > 0.0 else math.inf


def too_thin_for_corners(engine: Engine, name_of: Callable[[int], str]) -> Iterator[Told]:
    """Yield that walls only just meet, where something thin moves (IM10)."""
    if (found := engine.open_corner()) is not None:
        first, second, body = map(name_of, found)
        walls = f"{first} and {second}" if first != second else f"two parts of {first}"
        text = (
            f"{walls}: they only just meet, and contacts may yield by more than {body} is "
            "thick (IM10): pressed along one of them, it may pass the end of the other. Let them "
            "overlap, or make one Chain of them."
        )
        yield "corners", text
