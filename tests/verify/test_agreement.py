"""Located impacts against the event search, on scenes that nobody chose."""

import numpy as np
import pytest
from hypothesis import given, reject, settings, strategies as st

from tamias2d.errors import InputError, SimulationError
from tamias2d.scene import Box, Disc, HalfPlane, Scene
from tamias2d.simulate import simulate
from tamias2d.verify.events import Events, simulate_by_events

SPEED = st.floats(-3.0, 3.0)
RESTITUTION = st.floats(0.6, 1.0)
AT_END = 1e-8  # s, ten times what instants may differ by
FLOOR = HalfPlane(normal=(0.0, 1.0), offset=0.0)


def agree(scene: Scene, duration: float) -> Events:
    try:
        events = simulate_by_events(scene, duration=duration)
        run = simulate(scene, duration=duration)
    except (InputError, SimulationError):  # it came to rest, or met twice at one instant
        reject()
    if max([0.0, *events.time, *run.impacts.time]) > duration - AT_END:
        reject()  # rounding tells whether it is in the run
    assert run.impacts.time == pytest.approx(events.time, abs=1e-9)
    assert run.impacts.bodies.tolist() == [list(pair) for pair in events.bodies]
    assert run.position[-1] == pytest.approx(events.state[:, :2], abs=1e-9)
    assert run.orientation[-1] == pytest.approx(events.state[:, 2], abs=1e-9)
    assert run.velocity[-1] == pytest.approx(events.state[:, 3:5], abs=1e-8)
    assert run.angular_velocity[-1] == pytest.approx(events.state[:, 5], abs=1e-8)
    return events


@settings(max_examples=25, deadline=None)
@given(st.lists(st.tuples(SPEED, SPEED, st.floats(0.1, 10.0)), min_size=3, max_size=3), RESTITUTION)
def test_discs_in_a_corner(bodies: list[tuple[float, float, float]], restitution: float) -> None:
    scene = Scene(gravity=(0.3, -1.0))
    for k, (vx, vy, mass) in enumerate(bodies):
        scene.add_body(
            Disc(radius=0.4), mass=mass, position=(-1.5 - 1.1 * k, 1.0 + 0.3 * k),
            velocity=(vx, vy), restitution=restitution,
        )  # fmt: skip
    scene.add_static(FLOOR)
    scene.add_static(HalfPlane(normal=(-1.0, 0.0), offset=0.0))
    agree(scene, 1.0)


@settings(max_examples=25, deadline=None)
@given(SPEED, st.floats(-10.0, 10.0), st.floats(0.0, 6.0), RESTITUTION)
def test_a_spinning_box_on_a_floor(
    speed: float, spin: float, orientation: float, restitution: float
) -> None:
    scene = Scene(gravity=(0.0, -9.81))
    scene.add_body(
        Box(width=1.0, height=0.6), mass=2.0, position=(0.0, 1.5), velocity=(speed, 0.0),
        orientation=orientation, angular_velocity=spin, restitution=restitution,
    )  # fmt: skip
    scene.add_static(FLOOR)
    agree(scene, 0.6)


def test_a_disc_whose_force_varies_with_time() -> None:
    scene = Scene(gravity=(0.0, -2.0))
    scene.add_body(
        Disc(radius=0.5), mass=2.0, position=(0.0, 1.0), velocity=(0.5, 0.0),
        force=("1[N]*cos(3[rad/s]*time)", "-2[N]*sin(5[rad/s]*time)"), restitution=0.7,
    )  # fmt: skip
    scene.add_static(FLOOR)
    assert len(agree(scene, 2.0).time) >= 2


def test_a_box_whose_torque_varies_with_time() -> None:
    scene = Scene(gravity=(0.0, -2.0))
    scene.add_body(
        Box(width=1.0, height=0.5), mass=1.0, position=(3.0, 1.0), orientation=0.3,
        torque="0.2[N*m]*sin(2[rad/s]*time)", restitution=0.6,
    )  # fmt: skip
    scene.add_static(FLOOR)
    assert len(agree(scene, 1.2).time) >= 2


def test_energy_and_momentum_by_an_independent_sum() -> None:
    scene = Scene(gravity=(0.0, 0.0))
    for x, mass, speed in ((0.0, 2.0, 1.0), (2.0, 5.0, -0.4), (4.0, 1.0, -2.0)):
        scene.add_body(
            Disc(radius=0.3), mass=mass, position=(x, 0.1 * x), velocity=(speed, 0.0),
            restitution=1.0,
        )  # fmt: skip
    agree(scene, 3.0)
    run = simulate(scene, duration=3.0)
    mass = np.array([body.mass for body in scene.bodies])
    assert run.momentum == pytest.approx((mass[:, None] * run.velocity).sum(axis=1), abs=1e-14)
    kinetic = (0.5 * mass * (run.velocity**2).sum(axis=2)).sum(axis=1)
    assert run.energy == pytest.approx(kinetic, abs=1e-14)
    assert run.energy == pytest.approx(run.energy[0])
