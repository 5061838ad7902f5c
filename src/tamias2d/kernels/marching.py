"""Steps of smooth motion by kernels: all forces of a group of bodies, by any generated scheme.

Serves: `solve`, which lets a motion step by it. Hides: the rows of numbers that kernels take, and
whether they are compiled.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import astuple
from functools import cache, cached_property
from typing import Any

import numpy as np

from tamias2d.generated.schemes import FACTS
from tamias2d.kernels.choice import kernel
from tamias2d.kernels.error_call import followed
from tamias2d.kernels.error_source import error_equation
from tamias2d.kernels.force_demand import ForceDemand, Tables, forces_on
from tamias2d.kernels.force_source import arguments
from tamias2d.kernels.held_marching import held_marching
from tamias2d.kernels.jointing import joint_code
from tamias2d.kernels.march_call import MarchCall
from tamias2d.kernels.march_source import alone, march
from tamias2d.motion import Method
from tamias2d.motion.integrated import IntegratedMotion
from tamias2d.motion.loads import Loads
from tamias2d.motion.marching import Control, Error, Marching, Rule, Start, Steps
from tamias2d.motion.motion import Motion
from tamias2d.scene import Scene
from tamias2d.scene.acting import felt_velocity
from tamias2d.state import Array

_HEAVY = 150  # numbers of forces, from which NumPy is faster than plain Python
_GENERALLY = 4e-5, 5e-8  # s, of a term and of each number, by NumPy
_LIKELY = 1000  # accelerations are asked for by those who cannot say how often they will


def march_by_kernels(motion: Motion, scene: Scene) -> None:
    """Let a motion take its steps by kernels, or find the reactions of joints by them."""
    if not isinstance(motion, IntegratedMotion):
        return
    if scene.joints:
        motion.take_joint_codes(joint_code, _makers(scene), held_marching(scene))
    else:
        motion.marching = _makers(scene)


def march_source(scene: Scene, method: Method) -> str | None:
    """Return the source by which all bodies of a scene are stepped, if there is one."""
    found = forces_on(scene, [k for k, body in enumerate(scene.bodies) if body.dynamic])
    made = None if found is None else march(method.scheme or "", found[0])
    return None if made is None else made.text


def _makers(scene: Scene) -> Callable[[Sequence[int]], Marching | None]:
    felt = bool(Loads(scene).varying) and felt_velocity(scene)

    @cache
    def of(bodies: tuple[int, ...]) -> Marching | None:
        found = forces_on(scene, bodies) if bodies else None
        return None if found is None else KernelMarching(*found, felt=felt)

    return lambda bodies: of(tuple(bodies))


class KernelMarching:
    """Steps of some bodies by kernels (`Marching`)."""

    def __init__(self, demand: ForceDemand, tables: Tables, *, felt: bool) -> None:
        self.demand = demand
        self.axes = demand.axes
        self.tables = [tables[name] for name in arguments(demand)]
        self.felt = felt
        work = sum(len(table) for table in self.tables)
        if demand.attraction:
            work += len(tables["mass"]) ** 2
        self._heavy = work > _HEAVY
        self._pace = _GENERALLY[0] * max(demand.terms, 1) + _GENERALLY[1] * work

    @cached_property
    def lists(self) -> list[list[Any]]:
        """The tables as plain Python takes them."""
        return [table.tolist() for table in self.tables]

    def accelerations(self, time: float, position: Array, velocity: Array) -> Array | None:
        """Return the accelerations (n, 3), or None where one is not finite."""
        code = kernel(*alone(self.demand), "accelerations")
        compiled = code.compiled(_LIKELY)
        if compiled is None and self._heavy:
            code.otherwise(1, self._pace)
            return None
        axes, count = self.demand.axes, len(position)
        states = [part[:, :axes].T.ravel() for part in (position, velocity)]
        rate = np.zeros(axes * count)
        if compiled is not None:
            good = compiled(time, *states, rate, *self.tables)
        else:
            row = rate.tolist()
            try:
                good = code.plain(time, *(part.tolist() for part in states), row, *self.lists)
            except (ArithmeticError, ValueError):
                return None
            rate = np.array(row)
        rows = np.zeros((count, 3))
        rows[:, :axes] = rate.reshape(axes, count).T
        return rows if good else None

    def fixed(
        self, scheme: str, times: Sequence[float], start: Start, ahead: float
    ) -> Steps | None:
        """Step from each of the times to the next."""
        call = self._call(scheme, start, len(times) - 1, ahead)
        if call is None:
            return None
        call.rows[0][:] = times[: call.most + 1]
        count = call.go()
        return call.steps(count, finished=count == call.most)

    def adaptive(
        self, scheme: str, time: float, limit: float, most: int, start: Start, control: Control
    ) -> Steps | None:
        """Take at most some steps towards a limit."""
        call = self._call(scheme, start, most, (limit - time) / control.step)
        return None if call is None else call.adaptive(time, limit, control)

    def along(self, scheme: str, times: Sequence[float], start: Start) -> Steps | None:
        """Step from each of the times to the next, as nothing is too large an error."""
        call = self._call(scheme, start, len(times) - 1, len(times))
        if call is None:
            return None
        call.rows[0][0] = times[0]
        control = Control(math.inf, 1.0, 0.0, math.inf, math.inf, power=1.0, damping=0.0)
        ends = list(times[1 : call.most + 1])
        count = call.go(call.array(ends), control=call.array(list(astuple(control))))
        found = call.steps(count, finished=count == call.most)
        return found if found.times[1:] == ends[:count] else None

    def follow(
        self, times: Sequence[float], paths: Array, rule: Rule, sweeps: int, error: Error
    ) -> bool | None:
        """Integrate the error of steps along their paths (k, 3, m, n, 3)."""
        turned = not self.demand.rotation and (
            paths[:, 1, :, :, 2].any() or error.state[:, :, 2].any()
        )
        if turned:
            return None
        code = kernel(*error_equation(self.demand), "follow")
        compiled = code.compiled(len(times))
        if compiled is None and self._heavy:
            code.otherwise(len(times) - 1, sweeps * len(rule.nodes) * self._pace)
            return None
        done = followed(self, code, compiled, times, paths, rule, sweeps, error)
        return bool(done == len(times) - 1)

    def _call(self, scheme: str, start: Start, most: int, ahead: float) -> MarchCall | None:
        """Return what is to be called; None where it is unknown, or the general code is faster."""
        found = march(scheme, self.demand)
        turned = not self.demand.rotation and start.velocity[:, 2].any()
        if found is None or turned:  # what turns it is unknown here
            return None
        code = kernel(found.text, found.plain, "advance")
        compiled = code.compiled(ahead)
        if compiled is None and self._heavy:
            code.otherwise(most, FACTS[scheme].evaluations * self._pace)
            return None
        return MarchCall(self, found, code, compiled, start, most, felt=self.felt)
