"""Quantities of worlds see the runs that `simulate` gives, or samples at the times that are asked.

What looks along the history, such as a greatest height, would be wrong of the end alone.
"""

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
import pytest
from scipy import stats

import tamias2d as t2
from tests.ensemble.scenes import bouncing, stack

QUANTITIES: dict[str, Callable[[t2.Run], float]] = {
    "greatest height": lambda run: float(run.position[:, 1, 1].max()),
    "energy lost": lambda run: float(run.energy[0] - run.energy[-1]),
    "displacement": lambda run: float(np.hypot(*(run.position[-1, 1] - run.position[0, 1]))),
    "first velocity": lambda run: float(run.velocity[0, 1, 0]),
    "time average": lambda run: float(np.trapezoid(run.position[:, 1, 1], run.times)),
    "samples": lambda run: len(run.times),
    "last height": lambda run: float(run.position[-1, 1, 1]),
    "impacts": lambda run: len(run.impacts),
}
DURATION = 0.61
WAYS: dict[str, tuple[Callable[[], t2.Scene], dict[str, Any]]] = {
    "located": (bouncing, {}),
    "stepped as it must be": (stack, {}),
    "stepped as asked": (stack, {"method": t2.Stepped(), "time_step": 0.017}),
    "fixed steps": (bouncing, {"method": t2.VelocityVerlet(), "time_step": 0.023}),
    "within a tolerance": (bouncing, {"tolerance": 1e-2}),
}


def speeds(scene: t2.Scene) -> dict[str, Any]:
    return {f"bodies.{scene.bodies[1].name}.velocity.{axis}": stats.norm(0, 0.5) for axis in "xy"}


@pytest.mark.parametrize("way", WAYS)
def test_every_kind_of_quantity_is_that_of_the_run_that_simulate_gives(way: str) -> None:
    """And what is kept is the end, with the bits that it has without quantities."""
    make, solver = WAYS[way]
    arguments = {"duration": DURATION, "worlds": 3, "seed": 1, "workers": 1, **solver}
    arguments |= {"vary": speeds(make()), "keep": ["position", "energy"]}
    found = t2.ensemble(make(), quantities=QUANTITIES, **arguments)
    for world in range(3):
        run = t2.simulate(t2.world_scene(found, world), duration=DURATION, **solver)
        alone = {name: quantity(run) for name, quantity in QUANTITIES.items()}
        assert {name: found[name].values[world] for name in QUANTITIES} == alone
        assert alone["samples"] > 20
    assert found.time.values.tolist() == [DURATION]
    assert t2.ensemble(make(), **arguments).identical(
        found.drop_vars(QUANTITIES).assign_attrs(
            recipe=t2.ensemble(make(), **arguments).attrs["recipe"]
        )
    )


def test_quantities_on_disk_are_the_same_and_an_interrupted_call_goes_on(tmp_path: Any) -> None:
    called: list[int] = []

    def top(run: t2.Run) -> float:
        called.append(len(run.times))
        if len(called) == 3:
            raise KeyboardInterrupt
        return float(run.position[:, 1, 1].max())

    arguments = {"duration": DURATION, "worlds": 4, "seed": 1, "vary": speeds(bouncing())}
    ask = partial(t2.ensemble, bouncing(), workers=1, chunk=2, quantities={"top": top}, **arguments)
    with pytest.raises(KeyboardInterrupt):
        ask(out=tmp_path / "tops.zarr")
    stored = ask(out=tmp_path / "tops.zarr")
    assert called == [38] * 5
    assert stored.compute().identical(ask())


def test_times_that_are_asked_are_those_that_quantities_see_and_that_are_kept() -> None:
    arguments = {"duration": DURATION, "worlds": 2, "seed": 1, "vary": speeds(bouncing())}
    for times in ([DURATION], [0.1, 0.2, 0.6]):
        found = t2.ensemble(
            bouncing(), quantities=QUANTITIES, times=iter(times), workers=1, **arguments
        )
        assert found.time.values.tolist() == times
        for world in range(2):
            run = t2.simulate(t2.world_scene(found, world), duration=DURATION, times=times)
            for name, quantity in QUANTITIES.items():
                assert found[name].values[world] == quantity(run)


def unlike(run: t2.Run, seen: list[int], **solver: Any) -> float:
    """Return the greatest height, m, where a run is that of its scene alone, bit for bit."""
    if "time_step" in solver:
        solver["time_step"] = run.time_step
    alone = t2.simulate(run.scene, duration=DURATION, **solver)
    for name in ("times", "position", "velocity", "energy"):
        assert getattr(run, name).tobytes() == getattr(alone, name).tobytes()
    seen.append(len(run.times))
    return float(run.position[:, 1, 1].max())


@pytest.mark.parametrize("way", ["located", "stepped as asked", "fixed steps"])
def test_the_quantity_of_a_mean_sees_the_run_that_simulate_gives(way: str) -> None:
    """At each level in its own steps."""
    make, solver = WAYS[way]
    seen: list[int] = []
    arguments = {"duration": DURATION, "vary": speeds(make()), "seed": 1, "workers": 1, **solver}
    t2.ensemble_mean(make(), partial(unlike, seen=seen, **solver), tolerance=0.5, **arguments)
    wanted = {"located": {38}, "stepped as asked": {37, 73, 145}, "fixed steps": {28, 55, 108}}
    assert set(seen) == wanted[way]


@pytest.mark.parametrize("times", [None, (DURATION,), (0.1, 0.2)])
def test_means_and_sensitivities_take_times_of_the_samples(times: tuple[float, ...] | None) -> None:
    seen: list[int] = []
    quantity = partial(unlike, seen=seen, times=times)
    arguments: dict[str, Any] = {"duration": DURATION, "vary": speeds(bouncing()), "seed": 1}
    arguments |= {"workers": 1}
    given: Any = times if times is None else iter(times)
    t2.sensitivities(bouncing(), quantity, worlds=2, times=given, **arguments)
    assert seen == [len(times or range(38))] * 8
    given = times if times is None else iter(times)
    t2.ensemble_mean(bouncing(), quantity, tolerance=1.0, times=given, **arguments)
    assert set(seen) == {len(times or range(38))}
    with pytest.raises(t2.InputError, match=r"times of the run: found 0\.1: must be a list"):
        t2.sensitivities(bouncing(), quantity, worlds=2, times=0.1, **arguments)  # type: ignore[arg-type]


def test_the_mean_of_the_greatest_height_of_a_throw_is_that_by_hand() -> None:
    """Within its bound, and what samples 60 times a second miss of a top."""
    scene = t2.Scene(gravity=(0.0, -9.81))
    scene.add_body(None, mass=1.0, position=(0.0, 0.0), name="stone")
    found = t2.ensemble_mean(
        scene,
        lambda run: float(run.position[:, 0, 1].max()),
        duration=DURATION,
        vary={"bodies.stone.velocity.y": stats.uniform(2, 2)},
        tolerance=0.03,
        seed=1,
        workers=1,
    )
    wanted = (4**3 - 2**3) / 3 / 2 / (2 * 9.81)
    assert abs(found.value - wanted) <= found.bound + 9.81 / 8 / 60**2


def test_a_history_too_long_for_memory_is_refused_before_any_world_is_run() -> None:
    """Unless times say which samples are wanted."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(None, mass=1.0, position=(0.0, 0.0), velocity=(1.0, 0.0), name="puck")
    arguments: dict[str, Any] = {"duration": 1e8, "vary": {"bodies.puck.mass": stats.uniform(1, 1)}}
    ask = partial(t2.ensemble_mean, scene, tolerance=1.0, seed=1, workers=1, **arguments)

    def place(run: t2.Run) -> float:
        return float(run.position[-1, 0, 0] + run.scene.bodies[0].mass)

    with pytest.raises(t2.InputError, match=r"at most 1 GiB.*Give `times` of the samples"):
        ask(place)
    assert ask(place, times=(1e8,)).value > 1e8
