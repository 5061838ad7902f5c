"""Springs of joints with a maximum in the exact way, against an independent solution (DD103).

That is SciPy's DOP853 at 1e-12, from one instant at which the bound is reached to the next.
"""

from collections.abc import Callable

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import tamias2d as t2
from tamias2d.scene import Scene
from tamias2d.state import Array

STIFFNESS, DAMPING, MOST, MASS, INERTIA = 8.0, 0.3, 15.0, 2.0, 0.5
SPRING = t2.JointSpring(stiffness=STIFFNESS, damping=DAMPING, maximum=MOST)
Pull = Callable[[Array], Array]


def solved(pull: Pull, inertia: float, start: list[float], duration: float) -> Array:
    """Return the last state (2 d,) of what is pulled so, with at most the maximum."""

    def beyond(_: float, state: Array, *_args: bool) -> float:
        return float(np.linalg.norm(pull(state))) - MOST

    def rate(_: float, state: Array, bounded: bool) -> Array:
        force = pull(state)
        share = MOST / np.linalg.norm(force) if bounded else 1.0
        return np.concatenate([state[len(force) :], share * force / inertia])

    time, state = 0.0, np.array(start)
    bounded = beyond(0.0, state) > 0
    beyond.terminal = True  # type: ignore[attr-defined]
    while time < duration:
        beyond.direction = -1 if bounded else 1  # type: ignore[attr-defined]
        found = solve_ivp(
            *(rate, (time, duration), state, "DOP853"),
            events=beyond,
            args=(bounded,),
            rtol=1e-12,
            atol=1e-14,
        )
        time, state, bounded = found.t[-1], found.y[:, -1], not bounded
    return state


def dragged(spring: t2.JointSpring = SPRING) -> Scene:
    scene = Scene(gravity=(0, 0))
    scene.add_body(None, mass=MASS, position=(3, 1), velocity=(-1, 2))
    scene.add_joint(t2.Target(spring=spring), (0, 0), 0)
    return scene


def turned() -> Scene:
    scene = Scene(gravity=(0, 0))
    scene.add_body(None, mass=MASS, inertia=INERTIA, position=(0, 0), orientation=2)
    scene.add_joint(t2.Rotary(spring=t2.JointSpring(**{**vars(SPRING), "rest": 0.0})), (0, 0), 0)
    return scene


def test_target_with_a_maximum_goes_as_it_does_by_an_independent_solution() -> None:
    run = t2.simulate(dragged(), duration=10, times=[10], method=t2.Dop853(rtol=1e-9))
    expected = solved(_pull, MASS, [3, 1, -1, 2], 10)
    assert run.position[-1, 0] == pytest.approx(expected[:2], abs=2e-8)
    assert run.velocity[-1, 0] == pytest.approx(expected[2:], abs=1e-7)


def test_spring_of_an_angle_with_a_maximum_does_too() -> None:
    run = t2.simulate(turned(), duration=10, times=[10], method=t2.Dop853(rtol=1e-9))
    expected = solved(lambda s: -STIFFNESS * s[:1] - DAMPING * s[1:], INERTIA, [2, 0], 10)
    assert run.orientation[-1, 0] == pytest.approx(expected[0], abs=2e-8)


def test_fixed_steps_across_the_bound_are_of_order_two() -> None:
    """A derivative of the force jumps there, wherever in a step that is."""
    expected = solved(_pull, MASS, [3, 1, -1, 2], 4)[:2]
    method = t2.RungeKutta4()
    coarse, fine = (
        np.hypot(*(_at(dragged(), 4, method, step) - expected)) for step in (0.02, 0.0025)
    )
    assert coarse < 1e-4
    assert np.log2(coarse / fine) / 3 > 1.8


def _pull(state: Array) -> Array:
    """Return what the target exerts without a maximum."""
    return -STIFFNESS * state[:2] - DAMPING * state[2:]


def _at(scene: Scene, time: float, method: t2.RungeKutta4, step: float) -> Array:
    run = t2.simulate(scene, duration=time, times=[time], method=method, time_step=step)
    place: Array = run.position[-1, 0]
    return place


@pytest.mark.parametrize("tolerance", [1e-4, 1e-8])
def test_certificate_covers_the_bound(tolerance: float) -> None:
    expected = solved(_pull, MASS, [3, 1, -1, 2], 10)[:2]
    run = t2.simulate(dragged(), duration=10, tolerance=tolerance)
    way = np.hypot(*np.ptp(run.position[:, 0], axis=0))
    error = np.hypot(*(run.position[-1, 0] - expected)) / way
    assert run.certificate is not None
    assert run.certificate.bound is not None
    assert error <= run.certificate.bound <= tolerance


def test_pull_is_as_large_as_the_maximum_and_straight_to_the_point() -> None:
    run = t2.simulate(dragged(), duration=9, times=np.linspace(0, 9, 91), method=t2.Dop853())
    force = run.reactions.force[:, 0, 1]
    unbounded = -STIFFNESS * run.position[:, 0] - DAMPING * run.velocity[:, 0]
    size = np.hypot(*unbounded.T)
    expected = unbounded * np.minimum(1, MOST / size)[:, None]
    assert force == pytest.approx(expected, abs=1e-9)
    assert (size > MOST).any()
    assert (size < MOST).any()


def test_energy_is_that_of_what_the_spring_gives_back() -> None:
    scene = dragged(t2.JointSpring(stiffness=STIFFNESS, maximum=MOST))
    run = t2.simulate(scene, duration=10, times=np.linspace(0, 10, 101), method=t2.Reference())
    # where the pull reaches its maximum a step errs by more than its tolerance of 1e-12
    assert run.energy == pytest.approx(run.energy[0], rel=1e-9)
    far = MOST * np.hypot(3, 1) - MOST**2 / (2 * STIFFNESS) + MASS * 5 / 2
    assert run.energy[0] == pytest.approx(far, rel=1e-14)


def test_without_a_maximum_the_bits_are_those_of_a_maximum_that_is_never_reached() -> None:
    spring = t2.JointSpring(stiffness=STIFFNESS, damping=DAMPING)
    runs = [
        t2.simulate(dragged(each), duration=3, times=[3], method=t2.RungeKutta4(), time_step=0.01)
        for each in (spring, t2.JointSpring(**{**vars(spring), "maximum": 1e6}))
    ]
    assert (runs[0].position == runs[1].position).all()
