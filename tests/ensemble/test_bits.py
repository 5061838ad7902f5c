"""Each world has the bits that it has alone, however its ensemble is computed."""

from typing import Any

import numpy as np
import pytest
from scipy import stats

import tamias2d as t2
from tests.ensemble.scenes import bouncing, sliding, stack

LOCATED = {
    "duration": 1.2,
    "vary": {
        "bodies.ball.restitution": stats.uniform(0.2, 0.6),
        "bodies.ball.position.y": stats.uniform(0.5, 1.0),
        "bodies.ball.velocity.x": stats.norm(0.0, 1.0),
        "springs.0.stiffness": stats.uniform(20.0, 20.0),
        "gravity.y": stats.uniform(-10.0, 2.0),
    },
    "worlds": 9,
    "seed": 3,
    "times": (0.0, 0.5, 1.2),
    "keep": (
        *("position", "orientation", "velocity", "angular_velocity"),
        *("energy", "momentum", "angular_momentum"),
    ),
}
STEPPED = {
    **LOCATED,
    "vary": {
        "bodies.box1.position.x": stats.uniform(0.0, 0.4),
        "bodies.box0.mass": stats.uniform(1.0, 3.0),
        "bodies.box0.width": stats.uniform(0.8, 0.5),
        "friction_of_pairs.box0.floor": stats.uniform(0.0, 1.0),
    },
    "method": t2.Stepped(substeps=3),
    "time_step": 0.01,
    "times": (0.0, 0.0033, 0.5, 0.999, 1.2),
}
CASES = {
    "located": (bouncing, LOCATED),
    "stepped": (stack, STEPPED),
    "stepped by itself": (stack, STEPPED | {"method": None, "time_step": None}),
    "scheme": (bouncing, LOCATED | {"method": t2.VelocityVerlet(), "time_step": 0.01}),
    "tolerance": (
        bouncing,
        LOCATED | {"tolerance": 1e-4, "worlds": 2, "duration": 0.3, "times": (0.3,)},
    ),
}


@pytest.mark.parametrize("case", CASES)
def test_a_world_of_an_ensemble_has_the_bits_of_its_scene_alone(case: str) -> None:
    make, arguments = CASES[case]
    scene = make()
    found = t2.ensemble(scene, workers=1, **arguments)
    moving = [k for k, body in enumerate(scene.bodies) if body.dynamic]
    solver = ("duration", "method", "time_step", "tolerance", "times")
    alone = {key: arguments[key] for key in solver if key in arguments}
    for world in range(arguments["worlds"]):
        run = t2.simulate(t2.world_scene(found, world), **alone)
        assert found.outcome[world] == (2 if isinstance(run.method, t2.Stepped) else 1)
        for name in arguments["keep"]:
            values = getattr(run, name)
            wanted = values[:, moving] if found[name].dims[2:3] == ("body",) else values
            np.testing.assert_array_equal(found[name].values[world], wanted, strict=True)


def test_a_stepped_world_has_the_bits_of_a_simulator() -> None:
    found = t2.ensemble(stack(), workers=1, **STEPPED)
    for world in range(STEPPED["worlds"]):
        sim = t2.Simulator(t2.world_scene(found, world), time_step=0.01, substeps=3)
        start, before, time = sim.position[1:].copy(), sim.velocity[1:].copy(), 0.0033
        sim.step()  # in which velocities change evenly
        gain = (sim.velocity[1:] - before) / 0.01
        between = start + before * time + 0.5 * gain * time**2
        np.testing.assert_allclose(found.position[world, 1], between, rtol=0, atol=1e-12)
        sim.step(49)
        np.testing.assert_array_equal(found.position[world, 2], sim.position[1:])
        sim.step(70)
        np.testing.assert_array_equal(found.velocity[world, 4], sim.velocity[1:])


@pytest.mark.parametrize("case", ["located", "stepped"])
def test_workers_and_chunks_change_no_bit(case: str) -> None:
    make, arguments = CASES[case]
    found = t2.ensemble(make(), workers=1, **arguments)
    for chunk, workers in ((1, 1), (4, 2), (100, 2)):
        other = t2.ensemble(make(), workers=workers, chunk=chunk, **arguments)
        assert found.identical(other)


def test_a_function_makes_the_worlds() -> None:
    found = t2.ensemble(sliding, worlds=5, seed=2, duration=2.0, workers=1)
    for world in range(5):
        run = t2.simulate(sliding(world, t2.random_stream(2, world)), duration=2.0)
        assert found.position[world, 0, 0, 0] == run.position[-1, 0, 0]
    few = t2.ensemble(sliding, worlds=3, seed=2, duration=2.0, workers=2, chunk=1)
    np.testing.assert_array_equal(few.position, found.position[:3])
    with pytest.raises(t2.InputError, match="were made by a function"):
        t2.world_scene(found, 1)


def test_a_quantity_is_a_number_of_the_run() -> None:
    peak = {"peak": lambda run: float(run.position[:, 1, 1].max())}
    arguments: dict[str, Any] = {**LOCATED, "keep": (), "quantities": peak}
    found = t2.ensemble(bouncing(), workers=2, chunk=3, **arguments)
    run = t2.simulate(t2.world_scene(found, 4), duration=1.2, times=arguments["times"])
    assert found.peak[4] == peak["peak"](run)
    assert set(found.data_vars) == {"peak", "outcome"}


@pytest.mark.parametrize("workers", [1, 2])
def test_what_a_function_raises_tells_the_world(workers: int) -> None:
    def fails(run: t2.Run) -> float:
        raise ZeroDivisionError(str(run.duration))

    with pytest.raises(ZeroDivisionError) as raised:
        t2.ensemble(bouncing(), workers=workers, **{**LOCATED, "quantities": {"fails": fails}})
    assert any("in world" in note for note in raised.value.__notes__)


def test_coordinates_and_units_say_what_was_varied() -> None:
    found = t2.ensemble(bouncing(), workers=1, **LOCATED)
    assert found.position.dims == ("world", "time", "body", "axis")
    assert found.position.attrs["units"] == "m"
    assert found["gravity.y"].attrs["units"] == "m/s^2"
    assert found["gravity.y"].dims == ("world",)
    assert found.body.values.tolist() == ["ball", "bob"]
    assert found.time.values.tolist() == [0.0, 0.5, 1.2]


def test_only_the_end_and_what_moves_is_kept_unless_more_is_asked_for() -> None:
    found = t2.ensemble(
        bouncing(), duration=0.5, vary={"gravity.y": [-1.0]}, keep=["position"], bodies=["floor"]
    )
    assert found.position.shape == (1, 1, 1, 2)
    assert found.time.values.tolist() == [0.5]
    assert found.body.values.tolist() == ["floor"]


def test_a_world_that_is_refused_is_told_and_the_others_are_there() -> None:
    vary = {"bodies.ball.position.y": [1.0, 0.1, 2.0]}  # the second is in the floor
    found = t2.ensemble(bouncing(), duration=0.2, vary=vary, workers=1)
    assert found.outcome.values.tolist() == [1, 3, 1]
    assert np.isnan(found.position[1]).all()
    assert np.isfinite(found.position[[0, 2]]).all()
    with pytest.raises(t2.SceneError, match=r"^world 0 of the ensemble: .*overlap"):
        t2.ensemble(bouncing(), duration=0.2, vary={"bodies.ball.position.y": [0.1]}, workers=1)


REFUSED = [
    ({"keep": ["positions"]}, r"keep 'positions': .*Did you mean 'position'\?"),
    ({"keep": []}, r"keep: found nothing"),
    ({"bodies": ["bal"]}, r"body 'bal': the scene has none such \(R1\)"),
    ({"quantities": {"peak": 3}}, "quantity 'peak': found 3: must be a function"),
    ({"quantities": {"peak": lambda _: "high"}}, "quantity 'peak': found 'high': must be a number"),
    ({"workers": 0}, "workers 0: must be a whole number of at least 1"),
    ({"chunk": 0}, "chunk 0: must be a whole number of at least 1"),
    ({"workers": 2, "client": object()}, "workers: found beside a client"),
    ({"client": object()}, "must be a client of dask.distributed"),
    ({"times": [3.0]}, "must be sorted, and within the duration"),
    ({"method": t2.VelocityVerlet()}, r"needs time step \(R5\)"),
    ({"tolerance": 1e-3, "method": t2.ClosedForm()}, "Give one of the two"),
    ({"duration": -1.0}, "duration"),
]


@pytest.mark.parametrize(("more", "message"), REFUSED)
def test_a_bad_request_is_refused(more: dict[str, Any], message: str) -> None:
    given = {"duration": 0.5, "vary": {"gravity.y": [-1.0]}, "workers": 1, **more}
    if "client" in more and "workers" not in more:
        del given["workers"]
    with pytest.raises(t2.InputError, match=message):
        t2.ensemble(bouncing(), **given)


def test_functions_and_what_varies_exclude_each_other() -> None:
    with pytest.raises(t2.InputError, match="found beside a function"):
        t2.ensemble(sliding, duration=1.0, vary={"gravity": [(0, 0)]}, worlds=1, seed=1)
    with pytest.raises(t2.InputError, match="worlds: found none"):
        t2.ensemble(sliding, duration=1.0, seed=1)
    with pytest.raises(t2.InputError, match=r"the function returned 3: must be a Scene"):
        t2.ensemble(lambda world, stream: 3, duration=1.0, seed=1, worlds=2)  # noqa: ARG005
