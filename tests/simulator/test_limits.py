"""Values that float64 cannot carry through a step; threads; Ctrl-C; what is told and not taken."""

import _thread
import copy
import pickle
import signal
import threading
import warnings
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.simulator.told_only import REMEDIES
from tests.simulator.crowd import crowd


def ground(*, compiled: bool = True) -> t2.Simulator:
    scene = t2.Scene(gravity=(0.0, -10.0))
    floor = t2.HalfPlane(normal=(0.0, 1.0), offset=0.0)
    scene.add_static(floor, friction=0.5, restitution=0.3)
    scene.add_body(
        t2.Disc(radius=0.5), mass=1.0, position=(0.0, 5.0), restitution=0.3, friction=0.5
    )
    return t2.Simulator(scene, compiled=compiled)


def assert_finite(sim: t2.Simulator) -> None:
    for values in (sim.position, sim.orientation, sim.velocity, sim.angular_velocity):
        assert np.isfinite(values).all()


def test_a_spin_beyond_float64_is_told_by_a_batch_of_steps() -> None:
    sim = ground()
    sim.add(t2.Disc(radius=0.1), mass=1.0, position=(3, 3), angular_velocity=1e160, restitution=0.0)
    with pytest.raises(t2.InputError, match=r"angular_velocity\[2\] of body 2: found 1e\+160"):
        sim.step(65)
    assert_finite(sim)
    sim.angular_velocity[2] = 1.0
    sim.step(65)
    assert sim.position[1, 1] > 0.45


@pytest.mark.parametrize(
    ("view", "value", "says"),
    [
        ("velocity", 1e307, "must be at most 1.2e"),
        ("torque", 1e154, "must be at most"),
        ("force", 1e200, "must be at most"),
        ("position", 1e16, "must be within 1.1e"),
        ("orientation", np.inf, "must be finite"),
    ],
)
def test_values_are_refused_before_a_step(view: str, value: float, says: str) -> None:
    sim = ground()
    getattr(sim, view)[1] = value
    before = sim.position.copy()
    with pytest.raises(t2.InputError, match=rf"{view}\[1\] of body 'body1'.*{says}"):
        sim.step(65)
    assert (sim.position == before).all()


def test_a_batch_ends_where_steps_one_by_one_would() -> None:
    """A body that flies out of reach is refused by the step after, in a batch, too."""
    batch, single = ground(), ground()
    for sim in (batch, single):
        sim.position[1] = 0.0, 0.5
        sim.velocity[1] = 0.0, 0.0
        fast = {"position": (3, 3), "velocity": (1e19, 0.0), "restitution": 0.0}
        sim.add(t2.Disc(radius=0.1), mass=1.0, **fast)
    single.step()
    for sim in (single, batch):
        with pytest.raises(t2.InputError, match=r"position\[2\] of body 2: .* must be within 1.1e"):
            sim.step(20)
    assert (batch.position == single.position).all()


@pytest.mark.parametrize(
    ("view", "value"),
    [("angular_velocity", 1e90), ("torque", 1e90), ("velocity", 1e90), ("force", 1e100)],
)
def test_a_body_in_free_flight_is_refused_at_once(view: str, value: float) -> None:
    scene = t2.Scene(gravity=(0.0, -10.0))
    for x in (0.0, 5.0):
        scene.add_body(t2.Disc(radius=0.5), mass=1.0, position=(x, 0.0), restitution=0.3)
    sim = t2.Simulator(scene, compiled=False)
    sim.step(3)
    before = sim.orientation.copy(), sim.position.copy()
    getattr(sim, view)[1] = value
    with pytest.raises(t2.InputError, match=rf"{view}\[1\] of body 'body1': .* must be at most"):
        sim.step()
    assert (sim.orientation == before[0]).all()
    assert (sim.position == before[1]).all()


@pytest.mark.parametrize("compiled", [True, False])
@pytest.mark.parametrize("mass", [1e-300, 1e-240])
def test_what_overflows_within_a_step_leaves_no_state_that_is_not_finite(
    mass: float, compiled: bool
) -> None:
    sim = ground(compiled=compiled)
    light = sim.add(t2.Disc(radius=0.1), mass=mass, position=(3.0, 0.2), restitution=1.0)
    sim.force[light] = 1e70, -1e70
    with pytest.raises(t2.InputError, match=rf"velocity\[{light}\] of body {light}: .*cannot hold"):
        sim.step(65)
    assert_finite(sim)
    sim.force[light] = 0.0
    sim.step(65)
    assert_finite(sim)
    assert sim.position[1, 1] > 0.45


def test_one_thread_at_a_time() -> None:
    sim = t2.Simulator(crowd(60, seed=1))
    sim.step()
    with ThreadPoolExecutor(4) as threads:
        calls = [threads.submit(sim.step, 200) for _ in range(8)]
        faults = [fault for call in calls if (fault := call.exception()) is not None]
    assert all(isinstance(fault, t2.SimulationError) for fault in faults)
    assert all("one thread at a time" in str(fault) for fault in faults)
    twin = t2.Simulator(crowd(60, seed=1))
    twin.step(1 + 200 * (len(calls) - len(faults)))
    assert sim.digest() == twin.digest()
    with sim._lock:
        for call in (sim.step, lambda: sim.contacts, lambda: sim.wake(3), sim.digest):
            with pytest.raises(t2.SimulationError, match="another call has not returned"):
                call()


VIEWS = ("gravity", "position", "orientation", "velocity", "angular_velocity", "force", "torque")


@pytest.mark.parametrize("name", VIEWS)
def test_no_view_is_taken_or_set_while_another_call_runs(name: str) -> None:
    sim = ground()
    with sim._lock:
        for call in (lambda: getattr(sim, name), lambda: setattr(sim, name, 0.0)):
            with pytest.raises(t2.SimulationError, match=f"^{name} of the simulator: another call"):
                call()
    setattr(sim, name, getattr(sim, name).copy())


@pytest.fixture
def heard() -> Iterator[None]:
    """A process that was started in the background ignores Ctrl-C; here it is heard."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@pytest.mark.usefixtures("heard")
def test_many_steps_hear_ctrl_c() -> None:
    sim = t2.Simulator(crowd(30, seed=1))
    sim.step(3)
    timer = threading.Timer(0.3, _thread.interrupt_main)
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        sim.step(10**12)  # which takes years
    timer.join()
    steps = round(sim.time * 60)
    twin = t2.Simulator(crowd(30, seed=1))
    twin.step(steps)
    assert twin.digest() == sim.digest()


@pytest.mark.parametrize("name", ["mass", "present", "dynamic", "asleep"])
def test_what_is_written_into_a_copy_is_refused_by_name(name: str) -> None:
    values = getattr(ground(), name)
    lost = rf"^{name} of the simulator: .* a copy: it would be lost \(R4\)\. \w"
    with pytest.raises(t2.InputError, match=lost):
        values[0] = 1
    with pytest.raises(t2.InputError, match=lost):
        values[:][...] = 1
    with pytest.raises(t2.InputError, match=lost):
        np.logical_or(values, values, out=values)
    with pytest.raises(t2.InputError, match=lost):
        np.add.at(values, [0], values[0])
    for change in (values.fill, lambda _: values.sort()):
        with pytest.raises(t2.InputError, match=lost):
            change(1)


def test_what_is_made_of_a_copy_is_an_array_like_any_other() -> None:
    mass = ground().mass
    for made in (2 * mass, np.array(mass), pickle.loads(pickle.dumps(mass)), np.sqrt(mass)):
        assert type(made) is np.ndarray
        made[0] = 1.0
    for made in (mass.copy(), mass[[0, 1]], copy.deepcopy(mass)):
        made[0] = 1.0
        made += 1.0
        assert made[0] == 2.0
    assert mass.sum() == np.asarray(mass).sum()


@pytest.mark.parametrize("name", sorted(REMEDIES))
def test_what_is_told_cannot_be_assigned(name: str) -> None:
    with pytest.raises(t2.InputError, match=r"it is told, and cannot be set \(R4\)\. \w"):
        setattr(ground(), name, 1)


def test_reports_cannot_be_written() -> None:
    sim = ground()
    sim.step(90)
    for values in (sim.contacts.impulse, sim.began.bodies, sim.ended):
        with pytest.raises(t2.InputError, match=r"a copy: it would be lost \(R4\)"):
            values[...] = 0


@pytest.mark.parametrize("pull", [1e12, 9e18])
def test_gravity_that_outruns_the_shortest_parts_of_a_step_is_told(pull: float) -> None:
    scene = t2.Scene(gravity=(0.0, -pull))
    scene.add_body(t2.Disc(radius=0.5), mass=1.0, position=(0.0, 1.0), restitution=0.0)
    sim = t2.Simulator(scene, compiled=False)
    with pytest.warns(t2.StepWarning, match=r"gravity of .* time step of at most"):
        sim.step()
    most = float(sim.warnings[0].rpartition("at most ")[2].removesuffix(" s."))
    calm = t2.Simulator(scene, time_step=most, compiled=False)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        calm.step()


def test_a_sensor_stays_one_after_a_step_that_was_refused() -> None:
    sim = ground()
    sim.gravity = 0.0, 0.0
    gate = t2.Box(width=1.0, height=1.0)
    sim.add_static(gate, position=(0.0, 15.0), sensor=True, restitution=0.5)
    ball = sim.add(t2.Disc(radius=0.2), mass=1.0, position=(-0.6, 15.0), restitution=0.5)
    light = sim.add(t2.Disc(radius=0.1), mass=1e-300, position=(3.0, 0.2), restitution=1.0)
    sim.velocity[ball] = 1.0, 0.0
    sim.step(3)
    sim.force[light] = 1e70, -1e70
    with pytest.raises(t2.InputError, match="cannot hold"):
        sim.step()
    sim.force[light] = 0.0
    sim.step(60)
    assert sim.velocity[ball].tolist() == [1.0, 0.0]
