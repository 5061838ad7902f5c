"""A plank that lands on one corner comes down on the other one in time, however thin (DD72)."""

import math

import pytest

import tamias2d as t2

pytestmark = pytest.mark.filterwarnings("ignore::tamias2d.StepWarning")  # it is told, too

GRAVITY = 9.81
LENGTH = 0.28
CLOSE = LENGTH / 2**13  # how near a located impact brings bodies


def deepest(
    thickness: float, time_step: float, *, high: float, tilt: float, v: float, spin: float
) -> float:
    """Return how deep a plank gets into the floor that is dropped from a height, m."""
    scene = t2.Scene(gravity=(0.0, -GRAVITY))
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), restitution=0.0, friction=0.3)
    scene.add_body(
        t2.Box(width=LENGTH, height=thickness),
        mass=1.0,
        position=(0.0, thickness / 2 + LENGTH / 2 * abs(math.sin(tilt)) + high),
        velocity=(v, 0.0),
        orientation=tilt,
        angular_velocity=spin,
        restitution=0.0,
        friction=0.3,
    )
    sim = t2.Simulator(scene, time_step=time_step)
    deep = 0.0
    while sim.time < 0.8:
        sim.step()
        turn, y = float(sim.orientation[1]), float(sim.position[1, 1])
        across = LENGTH * abs(math.sin(turn)) + thickness * abs(math.cos(turn))
        deep = max(deep, across / 2 - y)
    return deep


def allowed(time_step: float) -> float:
    """Return what a contact may yield in a substep, in which gravity acts on it, m."""
    return GRAVITY * (time_step / 4) ** 2 + 2 * CLOSE


@pytest.mark.parametrize("tilt", [0.001, 0.002, 0.005, 0.01, 0.02, -0.01])
@pytest.mark.parametrize("ratio", [0.05, 0.02, 0.005, 0.001])
@pytest.mark.parametrize("time_step", [1 / 30, 1 / 60])
def test_a_plank_on_one_corner_comes_down_on_the_other(
    time_step: float, ratio: float, tilt: float
) -> None:
    """Its other end has a contact before gravity brings it down."""
    deep = deepest(ratio * LENGTH, time_step, high=1e-5, tilt=tilt, v=0.0, spin=0.0)
    assert deep < allowed(time_step)


@pytest.mark.parametrize(
    ("ratio", "time_step", "high", "tilt", "v", "spin"),
    [
        (0.005, 1 / 60, 0.32433160028777874, 0.10134776693990315, 0.0, 2.1861985868754843),
        (1e-4, 1 / 240, 0.19785637852422322, -0.11731315387188021, -0.625233321174826, 0.0),
    ],
)
def test_a_plank_that_has_bounced_off_one_corner_comes_down_on_the_other(
    ratio: float, time_step: float, high: float, tilt: float, v: float, spin: float
) -> None:
    """It turns fast after the impact, and is close to the floor, but does not touch it."""
    deep = deepest(ratio * LENGTH, time_step, high=high, tilt=tilt, v=v, spin=spin)
    assert deep < allowed(time_step)


@pytest.mark.parametrize(
    ("time_step", "high", "tilt", "v", "spin"),
    [
        (1 / 240, 0.4177255667133762, 0.008689730967733757, 2.2393929163375184, 0.0),
        (1 / 60, 0.06545062051228023, -0.010539716363564764, -0.516032679347, -1.8863790491838421),
        (1 / 30, 0.4031076655135218, -0.0005138841236405141, 0.0, 1.1910719419098648),
    ],
)
def test_impacts_of_a_step_are_not_spent_on_what_friction_leaves(
    time_step: float, high: float, tilt: float, v: float, spin: float
) -> None:
    """Friction at a corner presses it down again, by a fortieth: later impacts still count."""
    deep = deepest(0.1 * LENGTH, time_step, high=high, tilt=tilt, v=v, spin=spin)
    assert deep < allowed(time_step)


def test_a_fast_plank_does_not_rock_into_the_floor() -> None:
    """It slides by nearly three times its radius a step: impacts hold it, one end in each step."""
    deep = deepest(0.02 * LENGTH, 1 / 30, high=1e-5, tilt=0.00088, v=11.36, spin=0.0)
    assert deep < 2 * allowed(1 / 30)
