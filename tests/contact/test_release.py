"""Contacts that last under loads that vary: they end when the push vanishes, or are refused."""

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from tamias2d.contact import UndecidedContactError
from tamias2d.motion import Dop853, Reference
from tamias2d.scene import Box, Disc, HalfPlane, Scene
from tamias2d.simulate import simulate

FLOOR = HalfPlane(normal=(0, 1), offset=0)


def on_the_floor(shape: Disc | Box, **loads: object) -> Scene:
    scene = Scene(gravity=(0, -10))
    scene.add_body(shape, mass=2, position=(0, 0.5), restitution=0, **loads)  # type: ignore[arg-type]
    scene.add_static(FLOOR)
    return scene


def test_a_rising_force_lifts_a_ball_when_it_exceeds_the_weight() -> None:
    """A weight of 20 N against 8 N/s: at 2.5 s; then y = 0.5 + 4 (t - 2.5)^3/6."""
    run = simulate(on_the_floor(Disc(radius=0.5), force=(0, "8[N/s]*time")), duration=4)
    t = run.times
    lifted = np.maximum(t - 2.5, 0)
    np.testing.assert_allclose(run.position[:, 0, 1], 0.5 + 4 * lifted**3 / 6, rtol=1e-12)
    assert np.all(run.velocity[t < 2.5, 0, 1] == 0)


def test_a_force_that_swings_lifts_and_drops_a_ball() -> None:
    """From the push that vanishes to the ground: scipy's event on the flight, worked out here."""
    run = simulate(
        on_the_floor(Disc(radius=0.5), force=(0, "30[N]*sin(1[rad/s]*time)")), duration=6
    )
    lifts = math.asin(20 / 30)

    def down(_t: float, y: np.ndarray) -> float:
        return y[0]

    down.terminal, down.direction = True, -1  # type: ignore[attr-defined]
    flight = solve_ivp(
        lambda t, y: (y[1], 15 * math.sin(t) - 10), (lifts, 9), (1e-18, 0), events=down,
        method="DOP853", rtol=1e-13, atol=1e-15,
    )  # fmt: skip
    lands = flight.t_events[0][0]
    assert len(run.impacts) == 1
    assert run.impacts.time[0] == pytest.approx(lands, abs=1e-10)
    assert np.all(run.position[run.times > lands, 0, 1] == pytest.approx(0.5, abs=1e-12))


def test_a_ball_that_slides_into_an_updraught_is_lifted_there() -> None:
    """The draught bears its 20 N where 30 N exp(-x^2) does; then scipy flies it."""
    scene = Scene(gravity=(0, -10))
    scene.add_body(Disc(radius=0.5), mass=2, position=(-3, 0.5), velocity=(2, 0), restitution=0)
    scene.add_static(FLOOR)
    scene.add_field(force=(0, "30[N]*exp(-x(position)**2/1[m^2])"))
    run = simulate(scene, duration=2)
    lifts = (3 - math.sqrt(math.log(1.5))) / 2
    flight = solve_ivp(
        lambda t, y: (y[1], 15 * math.exp(-((2 * t - 3) ** 2)) - 10), (lifts, 2), (0.5, 0),
        method="DOP853", rtol=1e-13, atol=1e-14,
    )  # fmt: skip
    assert np.all(run.position[run.times < lifts, 0, 1] == 0.5)
    assert run.position[-1, 0, 1] == pytest.approx(flight.y[0, -1], rel=1e-10)
    assert run.position[-1, 0, 1] > 0.55


def test_a_hit_elsewhere_frees_a_ball_through_a_damper() -> None:
    """At 0.3 s the upper ball is struck to 5 m/s: its damper pulls the lower one, of 10 N, up."""
    scene = Scene(gravity=(0, 0))
    ball, strike = Disc(radius=0.5), {"velocity": (0, 5), "restitution": 1}
    scene.add_body(ball, mass=1, position=(0, 0.5), force=(0, -10), restitution=0)
    scene.add_body(ball, mass=1, position=(0, 4), restitution=1)
    scene.add_body(Disc(radius=0.25), mass=1, position=(0, 1.75), **strike)  # type: ignore[arg-type]
    scene.add_static(FLOOR)
    scene.add_spring(0, 1, stiffness=3, rest_length=3.5, damping=4)
    run = simulate(scene, duration=0.5)

    def rate(_t: float, y: np.ndarray) -> tuple[float, ...]:
        pull = 3 * (y[1] - y[0] - 3.5) + 4 * (y[3] - y[2])
        return y[2], y[3], pull - 10, -pull

    state = (0.5, 4, 0, 5)
    true = solve_ivp(rate, (0.3, 0.5), state, method="DOP853", rtol=1e-12, atol=1e-14).y[:, -1]
    assert run.impacts.time == pytest.approx([0.3], abs=1e-12)
    assert np.all(run.position[run.times < 0.3, 0, 1] == 0.5)
    found = (*run.position[-1, :2, 1], *run.velocity[-1, :2, 1])
    np.testing.assert_allclose(found, true, rtol=1e-9)


@pytest.mark.parametrize("friction", [None, 0.5])
def test_a_box_is_lifted_off_another_where_a_force_that_varies_bears_it(
    friction: float | None,
) -> None:
    """Where 14 N sin(2 t) is its weight of 10 N; the other stays, and so do both before."""
    scene, cube = Scene(gravity=(0, -10)), Box(width=1, height=1)
    rubs = {} if friction is None else {"friction": friction}
    scene.add_body(cube, mass=1, position=(0, 0.5), restitution=0, **rubs)
    scene.add_body(cube, mass=1, position=(0, 1.5), restitution=0, name="upper", **rubs)
    scene.add_field(force=(0, "14[N]*sin(2[rad/s]*time)"), bodies=["upper"])
    scene.add_static(FLOOR, **rubs)
    lifts = math.asin(10 / 14) / 2
    run = simulate(scene, duration=1, times=[lifts, 1], method=Reference())
    np.testing.assert_allclose(run.position[:, 0], [(0, 0.5)] * 2, rtol=0, atol=1e-13)
    assert run.position[0, 1, 1] == pytest.approx(1.5, abs=1e-13)
    flight = solve_ivp(
        lambda t, y: (y[1], 14 * math.sin(2 * t) - 10), (lifts, 1), (1.5, 0),
        method="DOP853", rtol=1e-13, atol=1e-15,
    )  # fmt: skip
    assert run.position[1, 1, 1] == pytest.approx(flight.y[0, -1], abs=1e-11)


def test_a_stack_at_rest_in_the_air_stands() -> None:
    """Drag varies with the velocity, and there is none."""
    scene = Scene(gravity=(0, -10))
    for y in (0.5, 1.5, 2.5):
        scene.add_body(
            Box(width=1, height=1), mass=1, position=(0, y), restitution=0, quadratic_drag=0.3
        )
    scene.add_static(FLOOR)
    run = simulate(scene, duration=2)
    assert np.all(run.position == run.position[0])
    assert np.all(run.velocity == 0)


def test_a_box_that_a_growing_torque_tips_is_refused_when_it_tips() -> None:
    """The weight of 20 N acts 0.5 m inside the corner: it holds 10 N m, which 4 N m/s reach."""
    scene = on_the_floor(Box(width=1, height=1), torque="4[N*m/s]*time")
    with pytest.raises(UndecidedContactError, match="contacts last or open") as caught:
        simulate(scene, duration=4, method=Reference())
    assert caught.value.time == pytest.approx(2.5, abs=1e-9)


@pytest.mark.parametrize("method", [Reference(), Dop853(rtol=1e-8)])
def test_a_box_that_a_spring_pulls_off_a_free_disc_leaves_it_where_nothing_presses(
    method: Reference | Dop853,
) -> None:
    """Along the line of both the spring presses as long as it is longer than at rest.

    Together they are 2 kg on it from 0.25 m: the contact opens after a quarter of the period.
    """
    scene = Scene(gravity=(0, 0))
    scene.add_body(Disc(radius=0.5), mass=1, position=(0, 0), restitution=0)
    scene.add_body(Box(width=0.5, height=0.2), mass=1, position=(0, 0.6), restitution=0)
    scene.add_spring(1, (0.0, -1.0), stiffness=10, rest_length=1.35)
    opens = math.pi / 2 / math.sqrt(10 / 2)
    run = simulate(scene, duration=1.2, times=[0.0, opens, 1.2], method=method)
    speed = 0.25 * math.sqrt(10 / 2)
    turn = math.sqrt(10) * (1.2 - opens)
    assert run.velocity[1, :, 1] == pytest.approx([-speed, -speed], rel=1e-8)
    assert run.velocity[2, :, 1] == pytest.approx([-speed, -speed * math.cos(turn)], abs=1e-8)
    height = 0.35 - speed / math.sqrt(10) * math.sin(turn)
    assert run.position[2, 1, 1] == pytest.approx(height, abs=1e-8)
