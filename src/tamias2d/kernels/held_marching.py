"""Steps of bodies that joints hold by kernels: all forces, reactions, and the return to joints.

Serves: the steps of jointed bodies. Hides: how the tables of mechanisms are put beside those of
forces, and when it pays to compile both as one.
"""

import math
from collections.abc import Callable, Sequence
from functools import cache, cached_property
from typing import Any, TypeAlias

import numpy as np

from tamias2d.generated.schemes import FACTS
from tamias2d.kernels.choice import kernel
from tamias2d.kernels.error_call import followed
from tamias2d.kernels.error_source import error_equation
from tamias2d.kernels.force_demand import forces_on
from tamias2d.kernels.force_source import arguments
from tamias2d.kernels.held_source import HeldDemand
from tamias2d.kernels.jointing import KernelJoints
from tamias2d.kernels.march_call import MarchCall
from tamias2d.kernels.march_source import march
from tamias2d.motion.joint_code import JointCode
from tamias2d.motion.marching import Control, Error, HeldMarching, Kick, Rule, Start, Steps
from tamias2d.scene import Scene
from tamias2d.scene.acting import loads_feel_velocity
from tamias2d.state import Array

_MOST = 4  # mechanisms in one source
_LONGEST_WAIT = 255  # calls; rows that are in doubt everywhere cost one trial in so many steps
_LIKELY = 1000  # steps whose errors are asked for by those who cannot say how many follow
_FEW = 16  # steps
_GENERALLY = 6e-5  # s, of reactions or of a return, one by one by compiled code

Placed: TypeAlias = tuple[Sequence[int], JointCode]
"""The places of a mechanism's bodies among all, and its code."""


def held_marching(
    scene: Scene,
) -> Callable[[Sequence[int], Sequence[Placed]], HeldMarching | None]:
    """Return what makes the steps of some bodies of a scene, and of mechanisms among them."""
    felt = loads_feel_velocity(scene)

    @cache
    def of(bodies: tuple[int, ...], placed: tuple[Placed, ...]) -> HeldMarching | None:
        """Return what makes them; None for mechanisms of several demands, or of too many."""
        codes = [code for _, code in placed if isinstance(code, KernelJoints)]
        if len(codes) < len(placed) or len(codes) > _MOST:
            return None
        joints = codes[0].demand
        if any(code.demand != joints for code in codes):
            return None
        found = forces_on(scene, bodies, turned=True)
        if found is None:
            return None
        forces, tables = found
        demand = HeldDemand(forces, joints, len(codes))
        given = [tables[name] for name in arguments(forces)]
        held = [(own, code) for (own, _), code in zip(placed, codes, strict=True)]
        return KernelHeldMarching(demand, given, len(bodies), held, felt=felt)

    def begun(bodies: Sequence[int], placed: Sequence[Placed]) -> HeldMarching | None:
        if not all(isinstance(code, KernelJoints) and code.begun for _, code in placed):
            return None  # its tables may change yet
        return of(tuple(bodies), tuple((tuple(own), code) for own, code in placed))

    return begun


class KernelHeldMarching:
    """Steps of some bodies that joints hold by kernels (`HeldMarching`)."""

    axes = 3

    def __init__(
        self,
        demand: HeldDemand,
        forces: list[Array],
        bodies: int,
        held: Sequence[tuple[Sequence[int], KernelJoints]],
        *,
        felt: bool,
    ) -> None:
        """Take the tables of forces, and mechanisms with the places of their bodies."""
        self._demand = demand
        self._felt = felt
        self._asked = self._left_out = self._waited = 0
        self._codes = [code for _, code in held]
        self.tables: list[Any] = [*forces]
        for own, code in held:
            columns = [axis * bodies + k for axis in range(self.axes) for k in own]
            rows = [np.zeros(len(columns)) for _ in range(3)]
            self.tables += [np.array(columns, dtype=np.int64), *rows, np.zeros(code.count)]
            self.tables += code.tables

    @cached_property
    def lists(self) -> list[list[Any]]:
        """The tables as plain Python takes them."""
        return [table.tolist() for table in self.tables]

    def fixed(
        self, scheme: str, times: Sequence[float], start: Start, ahead: float
    ) -> Steps | None:
        """Step from each of the times to the next."""
        call = self._call(scheme, start, len(times) - 1, ahead)
        if call is None:
            return None
        call.rows[0][:] = times[: call.most + 1]
        count = call.go()
        return self._heard(call.steps(count, finished=count == call.most))

    def kicked(
        self, scheme: str, times: Sequence[float], start: Start, kick: Kick | None, ahead: float
    ) -> tuple[Steps, Kick | None] | None:
        """Step from each of the times to the next."""
        call = self._call(scheme, start, len(times) - 1, ahead, felt=self._felt)
        if call is None:
            return None
        call.rows[0][:] = times[: call.most + 1]
        last, before, moments = call.work
        moments[0][:2] = call.array([math.nan, math.nan] if kick is None else [kick.time] * 2)
        if kick is not None:
            parts = kick.acceleration, kick.position, kick.velocity
            for row, part in zip(last, parts, strict=True):
                row[:] = call.row(part)
        count = call.go()
        finished = count == call.most
        steps = call.steps(count, finished=finished)
        moment = float(moments[0][0 if finished else 1])
        self._heard(steps)
        if math.isnan(moment):
            return steps, None
        rows = last if finished else before
        pull, place, speed = (call.bodies(np.array(row)) for row in rows)
        return steps, Kick(moment, place, speed, pull)

    def adaptive(
        self, scheme: str, time: float, limit: float, most: int, start: Start, control: Control
    ) -> Steps | None:
        """Take at most some steps towards a limit."""
        call = self._call(scheme, start, most, (limit - time) / control.step)
        return None if call is None else self._heard(call.adaptive(time, limit, control))

    def follow(
        self,
        times: Sequence[float],
        paths: Array,
        ends: Array,
        rule: Rule,
        sweeps: int,
        error: Error,
    ) -> bool:
        """Integrate the error of steps along their paths, and return with it to joints."""
        code = kernel(*error_equation(self._demand), "follow")
        compiled = code.compiled(_LIKELY)
        if compiled is None and any(each.is_compiled for each in self._codes):
            code.otherwise(len(times) - 1, (sweeps * len(rule.nodes) + 1) * _GENERALLY)
            return False
        done = followed(self, code, compiled, times, paths, rule, sweeps, error, ends=ends)
        return done == len(times) - 1

    def _heard(self, steps: Steps) -> Steps:
        """Wait ever longer with the next call while none takes a step."""
        taken = len(steps.times) > 1
        self._left_out = self._waited = 0 if taken else min(2 * self._waited + 1, _LONGEST_WAIT)
        return steps

    def _call(
        self, scheme: str, start: Start, most: int, ahead: float, *, felt: bool = True
    ) -> MarchCall | None:
        """Return what is to be called; None where it is unknown, or one by one is faster."""
        self._asked += most
        if self._asked < _FEW and ahead < _FEW:  # in which making a source does not pay
            return None
        found = march(scheme, self._demand)
        if found is None or self._left_out:
            self._left_out = max(self._left_out - 1, 0)
            return None
        code = kernel(found.text, found.plain, "advance")
        compiled = code.compiled(ahead)
        if compiled is None and any(each.is_compiled for each in self._codes):
            code.otherwise(1, (FACTS[scheme].evaluations + 1) * _GENERALLY)
            return None
        return MarchCall(self, found, code, compiled, start, most, felt=felt)
