"""Many bodies are located where compiled code decides all of it, and stepped where it does not."""

from collections.abc import Callable

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.event_driven import follower
from tamias2d.solve import Interrupted
from tools.measurements.impacts import gas, polygon_gas


def row(count: int, restitution: float, gravity: float = 0.0) -> t2.Scene:
    """Discs over a floor, apart from each other."""
    scene = t2.Scene(gravity=(0.0, -gravity))
    floor = t2.HalfPlane(normal=(0.0, 1.0), offset=0.0)
    scene.add_static(floor, restitution=restitution, name="floor")
    for k in range(count):
        scene.add_body(
            t2.Disc(radius=0.1), mass=1.0, position=(1.0 * k, 0.2), restitution=restitution,
            name=f"disc{k}",
        )  # fmt: skip
    return scene


@pytest.mark.parametrize("made", [gas, polygon_gas])
def test_a_gas_of_any_number_is_located(made: Callable[..., t2.Scene]) -> None:
    run = t2.simulate(made(150), duration=0.02, times=[0.02])
    assert run.notes == ("ClosedForm(): every force and torque is constant",)
    assert len(run.impacts) > 10


def test_many_that_settle_are_stepped() -> None:
    run = t2.simulate(row(101, 0.5, gravity=9.81), duration=0.3)
    assert run.notes[0].endswith("101 moving bodies can meet, more than 100")
    bouncing = t2.simulate(row(101, 1.0, gravity=9.81), duration=0.5)
    assert bouncing.method == t2.ClosedForm()
    assert len(bouncing.impacts) >= 101


def test_many_are_located_where_it_is_asked_for() -> None:
    """Each comes to rest by itself, which is told, and known to the code that goes on."""
    run = t2.simulate(row(101, 0.0, gravity=9.81), duration=0.5, method=t2.ClosedForm())
    assert len(run.notes) == 102
    np.testing.assert_array_equal(run.position[-1, 1:, 1], 0.1)
    assert not run.velocity[-1].any()


def test_many_of_which_some_stay_together_are_stepped_instead() -> None:
    scene = row(120, 0.0)
    scene.add_body(
        t2.Disc(radius=0.1), mass=1.0, position=(-1.0, 0.2), velocity=(9.0, 0.0), name="bullet",
        restitution=0.0,
    )  # fmt: skip
    run = t2.simulate(scene, duration=0.2)
    assert "impacts could be located up to 0.08" in run.notes[0]
    assert "impacts alone are located (R12)" in run.notes[0]


def test_many_whose_impacts_are_too_much_work_are_stepped_instead() -> None:
    scene = gas(120)
    run = t2.simulate(scene, duration=1.0, work_limit=1000, times=[1.0])
    assert "locating the impacts would be too much work" in run.notes[0]
    with pytest.raises(t2.SimulationError, match="work_limit"):
        t2.simulate(scene, duration=1.0, work_limit=1000, method=t2.ClosedForm())


def test_ctrl_c_leaves_the_history_up_to_there(monkeypatch: pytest.MonkeyPatch) -> None:
    scene, times = gas(150, seed=3), np.linspace(0.0, 0.1, 21)
    whole = t2.simulate(scene, duration=0.1, times=times)
    code, calls = follower.compiled_code(), iter(range(3))

    def stopping() -> object:
        def stopped(world: follower.World) -> int:
            world.numbers[follower.tables.LIMIT] = 0.02 * (next(calls, 3) + 1)
            status = code(world)
            if world.numbers[follower.tables.NOW] > 0.05:
                raise KeyboardInterrupt
            return status

        return stopped

    monkeypatch.setattr(follower, "compiled_code", stopping)
    with pytest.raises(Interrupted) as stop:
        t2.simulate(scene, duration=0.1, times=times)
    run = stop.value.run
    assert run.times[-1] == pytest.approx(0.06)
    np.testing.assert_array_equal(run.position, whole.position[: len(run.times)])
    assert (run.impacts.time == whole.impacts.time[: len(run.impacts)]).all()
    assert whole.impacts.time[len(run.impacts)] > 0.06
