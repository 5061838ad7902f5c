"""What is asked of each world: how it is solved, and which numbers of it are kept."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np

from tamias2d.errors import InputError
from tamias2d.motion import Method
from tamias2d.record.dataset import AXES, BODIES, DIMENSIONS, TIMES
from tamias2d.run import Run
from tamias2d.scene import Scene
from tamias2d.scene.rules import RuleError, sequence, shown
from tamias2d.solve import planned
from tamias2d.state import Array
from tamias2d.suggestions import nearest
from tamias2d.work_limit import WORK_LIMIT

Quantity: TypeAlias = Callable[[Run], float]
"""A number of a run."""

STATE = ("position", "orientation", "velocity", "angular_velocity")


@dataclass(frozen=True, kw_only=True)
class Request:
    """What each world is asked for."""

    duration: float
    """s"""
    method: Method | None
    time_step: float | None
    """s"""
    tolerance: float | None
    times: tuple[float, ...]
    """Of what is kept, s."""
    usual: bool
    """Whether runs have the samples of `simulate`, for quantities; the end is what is kept."""
    names: tuple[str, ...]
    """Of the bodies of the scene."""
    bodies: tuple[int, ...]
    """Which of them are kept."""
    keep: tuple[str, ...]
    quantities: Mapping[str, Quantity]
    work_limit: int

    def shape(self, name: str) -> tuple[int, ...]:
        """Return the shape of what is kept of one world under a name."""
        lengths = {TIMES: len(self.times), BODIES: len(self.bodies), AXES: 2}
        return tuple(lengths[axis] for axis in DIMENSIONS.get(name, ()))

    @property
    def kept(self) -> tuple[str, ...]:
        """The names of all that is kept."""
        return (*self.keep, *self.quantities)

    @property
    def size(self) -> int:
        """Bytes that one world takes."""
        return sum(8 * int(np.prod(self.shape(name))) for name in self.kept)

    def arguments(self) -> dict[str, Any]:
        """Return the arguments of `simulate` but for the scene."""
        names = ("duration", "method", "time_step", "tolerance", "work_limit")
        times = None if self.usual else self.times
        return {name: getattr(self, name) for name in names} | {"times": times}


def request_of(
    scene: Scene,
    *,
    duration: float,
    method: Method | None = None,
    time_step: float | None = None,
    tolerance: float | None = None,
    times: Iterable[float] | None = None,
    keep: Sequence[str] = STATE,
    bodies: Sequence[int | str] | None = None,
    quantities: Mapping[str, Quantity] | None = None,
    work_limit: int = WORK_LIMIT,
) -> Request:
    """Return a request that has been checked with one of the scenes.

    Without times the end is kept; quantities then see runs with the samples of `simulate`.

    Raises:
        InputError: an argument breaks a rule.
    """
    usual = times is None and bool(quantities)
    asked = (duration,) if times is None and not usual else times
    plan = planned(scene, duration, method, time_step, asked, work_limit)
    if tolerance is not None and method is not None:
        raise InputError(
            f"tolerance {tolerance!r}: found method {method} beside it: the method follows from "
            "the tolerance (R5). Give one of the two."
        )
    request = Request(
        duration=plan.duration,
        method=method,
        time_step=time_step,
        tolerance=tolerance,
        times=(plan.duration,) if usual else tuple(plan.times.tolist()),
        usual=usual,
        names=tuple(body.name for body in scene.bodies),
        bodies=_bodies(scene, bodies),
        keep=_kept(keep),
        quantities=_quantities(quantities or {}),
        work_limit=work_limit,
    )
    if not request.kept:
        raise RuleError(
            "keep: found nothing: must name what is kept (R5). Give some of "
            f"{', '.join(DIMENSIONS)}, or `quantities`.",
            "keep",
        )
    return request


def kept_of(run: Run, request: Request) -> dict[str, Array]:
    """Return what is kept of a run."""
    bodies = list(request.bodies)
    found = {}
    for name in request.keep:
        values: Array = getattr(run, name)[-len(request.times) :]
        found[name] = values[:, bodies] if BODIES in DIMENSIONS[name] else values
    for name, quantity in request.quantities.items():
        found[name] = _number(quantity(run), name)
    return found


def _number(value: object, name: str) -> Array:
    try:
        return np.array(float(value))  # type: ignore[arg-type]
    except (TypeError, ValueError):
        raise RuleError(
            f"quantity {name!r}: found {shown(value)}: must be a number (R5). Let the function "
            "return one.",
            "quantities",
        ) from None


def _bodies(scene: Scene, chosen: Sequence[int | str] | None) -> tuple[int, ...]:
    """Return the indices of bodies, those that move unless some are chosen."""
    if chosen is None:
        return tuple(k for k, body in enumerate(scene.bodies) if not body.static)
    remedy = "Name some bodies of the scene."
    given: Any = sequence(chosen, "the ensemble", remedy, at=("bodies",))
    return tuple(dict.fromkeys(scene.index(body) for body in given))


def _kept(keep: Sequence[str]) -> tuple[str, ...]:
    names = sequence(keep, "the ensemble", "Give a list of names.", at=("keep",))
    for name in names:
        if name not in DIMENSIONS:
            near = nearest(str(name), DIMENSIONS)
            hint = f"Did you mean {near!r}?" if near else f"Take some of {', '.join(DIMENSIONS)}."
            raise RuleError(f"keep {name!r}: a run has no such values (R5). {hint}", "keep")
    return tuple(dict.fromkeys(str(name) for name in names))


def _quantities(quantities: Mapping[str, Quantity]) -> dict[str, Quantity]:
    for name, function in quantities.items():
        if not isinstance(name, str) or not callable(function):
            raise RuleError(
                f"quantity {name!r}: found {shown(function)}: must be a function of a run, under a "
                "name (R5). Give one, such as {'peak': lambda run: run.position[:, 1, 1].max()}.",
                "quantities",
            )
    return dict(quantities)
