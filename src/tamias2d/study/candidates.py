"""The candidates that a study compares: methods, each with a ladder of settings."""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from typing import TypeAlias

from tamias2d.motion import (
    ClosedForm,
    Dop853,
    DormandPrince5,
    ExplicitEuler,
    ExponentialDrag,
    Method,
    Reference,
    RungeKutta4,
    SemiImplicitEuler,
    VelocityVerlet,
    Yoshida4,
)
from tamias2d.run import Run
from tamias2d.scene import Scene
from tamias2d.scene.exact import closed_forms
from tamias2d.solve import solve
from tamias2d.study.box2d_run import simulate as simulate_by_box2d
from tamias2d.study.engines.refusal import PeerError, refuse_untranslated
from tamias2d.study.peers import simulate as simulate_by_pymunk

Runner: TypeAlias = Callable[[Scene, float, Iterable[float]], Run]
"""From a scene, a duration in s and times of samples, s, to a run."""

FIXED_STEP: tuple[Method, ...] = (
    ExplicitEuler(),
    SemiImplicitEuler(),
    VelocityVerlet(),
    RungeKutta4(),
    Yoshida4(),
)
TOLERANCES = (1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12)


@dataclass(frozen=True)
class Candidate:
    """One method with its setting."""

    name: str
    setting: str
    run: Runner
    steps: int | None = None
    """How many are asked for; None where the method chooses them."""
    peer: bool = False
    """Whether it is another engine, for comparison only."""


def candidates(scene: Scene, *, rungs: Iterable[int]) -> Iterator[Candidate]:
    """Yield what can be tried on a scene; ladders of steps have the given `rungs`."""
    counts = list(rungs)
    moving = [body for body in scene.bodies if body.dynamic]
    if len(closed_forms(scene)) == len(moving):
        yield Candidate("ClosedForm", "", _own(ClosedForm(), None))
    drags = any(body.linear_drag for body in moving) and not scene.joints
    dragged = (ExponentialDrag(),) if drags else ()
    for method in (*FIXED_STEP, *dragged):
        for count in counts:
            yield Candidate(type(method).__name__, f"{count} steps", _own(method, count), count)
    for adaptive in (DormandPrince5(1.0e-3), Dop853(1.0e-3), Reference(1.0e-3)):
        for rtol in TOLERANCES:
            method = replace(adaptive, rtol=rtol)
            yield Candidate(type(method).__name__, f"rtol {rtol:g}", _own(method, None))
    for count in counts:
        yield Candidate(
            "Pymunk", f"{count} steps", _peer(simulate_by_pymunk, count), count, peer=True
        )
    for count in counts if _is_told_to_box2d(scene) else counts[:1]:
        yield Candidate(
            "pyb2d3", f"{count} steps", _peer(simulate_by_box2d, count), count, peer=True
        )


def _own(method: Method, steps: int | None) -> Runner:
    def run(scene: Scene, duration: float, times: Iterable[float]) -> Run:
        step = None if steps is None else duration / steps
        return solve(scene, duration=duration, method=method, time_step=step, times=times)

    return run


def _peer(simulate: Callable[..., Run], steps: int) -> Runner:
    def run(scene: Scene, duration: float, times: Iterable[float]) -> Run:
        return simulate(scene, duration=duration, steps=steps, times=times)

    return run


def _is_told_to_box2d(scene: Scene) -> bool:
    try:
        refuse_untranslated(scene, "pyb2d3")
    except PeerError:
        return False
    return True
