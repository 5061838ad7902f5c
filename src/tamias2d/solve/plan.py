"""The inputs of a run, checked: the method, the step, the samples."""

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np

from tamias2d.contact import steps_because
from tamias2d.errors import InputError
from tamias2d.motion import ClosedForm, Method, Reference, Solvable, Stepped
from tamias2d.motion.fixed_steps import grid
from tamias2d.scene import Scene
from tamias2d.scene.acting import varying_loads
from tamias2d.scene.exact import closed_forms
from tamias2d.scene.rules import checked_count, number, sequence
from tamias2d.scene.scene_data import checked_scene
from tamias2d.state import Array
from tamias2d.work_limit import WORK_LIMIT

FRAMES = 60
"""Samples in a second, where nothing else is asked; and steps, where contacts are stepped."""
_FEW, _STEPS_OF_SHORT = 30, 240
_ROUNDED = 1e-9  # of a duration
_MOST = 2**30  # bytes that a history, or the times of all steps, may take


class Plan(NamedTuple):
    """A run before it is run; times (k,), duration and time step in s."""

    scene: Scene
    method: Solvable
    duration: float
    time_step: float | None
    times: Array
    notes: tuple[str, ...]
    work_limit: int = WORK_LIMIT
    stepped_because: str | None = None
    """Why contacts are stepped, where that was not asked for."""

    def by_steps(self, reason: str) -> "Plan":
        """Return the plan of the run stepped through its contacts, for a reason."""
        method, step = Stepped(), usual_step(self.duration)
        told = f"1/{FRAMES} s" if step == 1 / FRAMES else f"{step:.3g} s"
        notes = (f"{method}, {told}: {reason}",)
        return self._replace(method=method, time_step=step, notes=notes, stepped_because=reason)


def usual_step(duration: float) -> float:
    """Return the step in which contacts are taken where none is asked for, s.

    A run in which few of the usual ones fit is about something faster than these.
    """
    return 1 / FRAMES if duration * FRAMES >= _FEW else duration / _STEPS_OF_SHORT


def planned(
    scene: Scene,
    duration: float,
    method: Method | None,
    time_step: float | None,
    times: Iterable[float] | None,
    work_limit: int = WORK_LIMIT,
) -> Plan:
    """Return what to do, where nothing that was asked breaks a rule.

    Raises:
        InputError: an argument does, or the history would take more than 1 GiB.
    """
    checked_scene(scene)
    duration = number(duration, "duration", "the run", "Give it in s.", at=("duration",))
    stepped_because = steps_because(scene, duration) if method is None else None
    chosen, note = _method(scene, method, stepped_because)
    if time_step is None and stepped_because:
        time_step = usual_step(duration)
    if chosen.fixed_step != (time_step is not None):
        need = "needs" if chosen.fixed_step else "chooses its own steps and takes no"
        remedy = "Give time_step in s." if chosen.fixed_step else "Leave time_step out."
        raise InputError(f"time_step {time_step!r}: {chosen} {need} time step (R5). {remedy}")
    if time_step is not None:
        time_step = number(time_step, "time_step", "the run", "Give it in s.", at=("time_step",))
        _refuse_longer(chosen, time_step, duration)
    _refuse_endless(scene, duration, time_step, kept=times is None)
    steps = grid(duration, time_step or 1 / FRAMES) if times is None else _samples(times, duration)
    remedy = "Give how many steps and impacts it may take."
    work_limit = checked_count(work_limit, "work_limit", 1, remedy=remedy)
    return Plan(scene, chosen, duration, time_step, steps, (note,), work_limit, stepped_because)


def _refuse_longer(method: Method, time_step: float, duration: float) -> None:
    """Refuse a step through contacts that ends beyond the run: its middle would not be known."""
    if isinstance(method, Stepped) and time_step > duration * (1 + _ROUNDED):
        raise InputError(
            f"time_step {time_step!r} s of the run: found one longer than the run of {duration!r} "
            "s: what happens within a step through contacts is not followed (R12). Give at most "
            f"the duration, or such as {usual_step(duration):.3g} s."
        )


def _refuse_endless(scene: Scene, duration: float, time_step: float | None, *, kept: bool) -> None:
    """Refuse more steps or samples than memory should be asked for."""
    if time_step is None and not kept:
        return
    count = duration / time_step if time_step else duration * FRAMES
    size = count * 8 * (6 * len(scene.bodies) + 5 if kept else 1)
    if size <= _MOST:
        return
    what = f"time_step {time_step!r} s" if time_step else f"duration {duration!r} s"
    makes = "steps" if time_step else f"samples, {FRAMES} a second"
    remedy = (
        "a larger time_step, `times` of the samples"
        if time_step and kept
        else ("a larger time_step" if time_step else "`times` of the samples")
    )
    raise InputError(
        f"{what} of the run: found {count:.3g} {makes}, which take {size / 2**30:.3g} GiB: must "
        f"take at most {_MOST / 2**30:g} GiB (R5). Give {remedy}, or a shorter duration."
    )


def _method(
    scene: Scene, method: Method | None, stepped_because: str | None
) -> tuple[Solvable, str]:
    """Return the method with the reason for it."""
    if stepped_because:
        return Stepped(), f"{Stepped()}: {stepped_because}"
    if method is None:
        return _located(scene)
    if not isinstance(method, Solvable):
        raise InputError(
            f"method {method!r}: must be a method of motion (R5). Give one such as ClosedForm() "
            "or VelocityVerlet(), with its brackets."
        )
    return method, f"{method}: as asked"


def _located(scene: Scene) -> tuple[Solvable, str]:
    solved = closed_forms(scene)
    for body, why in varying_loads(scene).items():
        if body not in solved:
            return Reference(), f"Reference(): '{scene.bodies[body].name}' is {why}"
    forms = dict.fromkeys(solved.values())
    if list(forms) == ["constant loads"] or not forms:
        return ClosedForm(), "ClosedForm(): every force and torque is constant"
    return ClosedForm(), f"ClosedForm(): every body has one, {', '.join(forms)}"


def _good(times: Array, duration: float) -> bool:
    """Whether an array breaks no rule that samples have; what it breaks is found one by one."""
    if times.dtype != np.float64 or times.ndim != 1 or not len(times):
        return False
    ordered = bool((times[1:] >= times[:-1]).all())
    return ordered and bool(times[0] >= 0) and bool(times[-1] <= duration)


def _samples(times: Iterable[float], duration: float) -> Array:
    remedy = "Give sorted times in s, from 0 to the duration."
    if isinstance(times, np.ndarray) and _good(times, duration):
        return times.copy()
    values = sequence(times, "the run", remedy, at=("times",))
    steps = [
        number(value, "time", "the run", remedy, at=("times", k)) for k, value in enumerate(values)
    ]
    if not steps:
        raise InputError(f"times of the run: found none: must be one or more (R5). {remedy}")
    for k, (before, after) in enumerate(zip(steps, [*steps[1:], duration], strict=True)):
        if after < before:
            raise InputError(
                f"times[{k}] {before!r} s of the run: {after!r} s follows: must be sorted, and "
                f"within the duration of {duration!r} s (R5). {remedy}"
            )
    return np.array(steps)
