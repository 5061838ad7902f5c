"""Joints that cannot hold open and yield (DD86): nothing is thrown, and all closes again.

What drives a mechanism beyond its reach has a speed; four times that, for the mass of all links, is
the energy that yielding rows allow, and one link may have it all. Before rows yielded, what is
driven here at 1 m/s reached 1e3 to 1e36 m/s.
"""

import copy
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from tamias2d import (
    Box,
    Capsule,
    Disc,
    Distance,
    HalfPlane,
    JointSpring,
    Limits,
    Prismatic,
    Revolute,
    Scene,
    Simulator,
    StepWarning,
    Weld,
    Wheel,
)

SURFACE: dict[str, Any] = {"restitution": 0.0, "friction": 0.5}
AMPLIFICATION = 4.0
Array = NDArray[np.float64]
HINGES = {
    "plain": Revolute(),
    "limited": Revolute(limits=Limits(lower=-1.5, upper=1.5, restitution=0.0)),
    "sprung": Revolute(spring=JointSpring(stiffness=100.0, damping=1.0)),
}


def chain(links: int, hinge: Revolute, step: float = 1 / 60, *, compiled: bool = True) -> Simulator:
    """Return links of 1 kg and 1 m in a line, the first of which is held at the origin."""
    scene = Scene(gravity=(0.0, 0.0))
    for k in range(links):
        at = (k + 0.5, 0.0)
        scene.add_body(Capsule(length=0.8, radius=0.1), mass=1.0, position=at, **SURFACE)
        anchor: dict[str, Any] = {"anchor": (0.5, 0.0)} if k else {}
        upper: Any = k - 1 if k else (0.0, 0.0)
        scene.add_joint(hinge, upper, k, other_anchor=(-0.5, 0.0), **anchor)
    return Simulator(scene, time_step=step, compiled=compiled)


def drive(sim: Simulator, driver: str, last: int, end: tuple[float, float]) -> int:
    """Hinge the end of the last link to what drives it; return that, or -1 for a point."""
    disc = Disc(radius=0.1)
    kept: dict[str, Any] = {"restitution": 0.0, "mask": 0}
    hook = -1
    if driver == "kinematic":
        hook = sim.add_kinematic(disc, position=end, **kept)
    elif driver == "static":
        hook = sim.add_static(disc, position=end, **kept)
    held: Any = end if hook < 0 else hook
    sim.add_joint(Revolute(), held, last, other_anchor=(0.5, 0.0), name="hand")
    return hook


def move(sim: Simulator, driver: str, hook: int, at: Array, by: Array) -> None:
    """Drive through a step: from a point, m, by a way."""
    if driver == "kinematic":
        sim.velocity[hook] = by / sim.time_step
    elif driver == "static":
        sim.position[hook] = at + by
    else:
        sim.set_target("hand", tuple((at + by).tolist()))


def speeds_out_and_back(
    sim: Simulator, driver: str, hook: int, end: Array, speed: float
) -> tuple[float, float]:
    """Drive an end by 1.5 m beyond its reach, at a speed, and back.

    Returns the fastest of all bodies on the way, and after it.
    """
    along = np.array([math.cos(0.3), math.sin(0.3)])
    steps = round(1.5 / speed / sim.time_step)
    fastest, at = 0.0, end
    back = steps + steps // 10  # within its reach: what is straight closes to the last bit slowly
    for by in (along,) * steps + (0.0 * along,) * 30 + (-along,) * back:
        move(sim, driver, hook, at, by * speed * sim.time_step)
        at = at + by * speed * sim.time_step
        sim.step()
        fastest = max(fastest, float(np.hypot(*sim.velocity.T).max()))
    after = 0.0
    for _ in range(round(1.0 / sim.time_step)):
        move(sim, driver, hook, at, np.zeros(2))
        sim.step()
        after = max(after, float(np.hypot(*sim.velocity.T).max()))
    return fastest, after


@pytest.mark.filterwarnings("ignore::tamias2d.StepWarning")
@pytest.mark.parametrize("speed", [1.0, 10.0])
@pytest.mark.parametrize("driver", ["kinematic", "point", "static"])
@pytest.mark.parametrize("kind", list(HINGES))
@pytest.mark.parametrize("links", [2, 3, 6])
def test_a_chain_that_is_taken_beyond_its_reach_opens_and_closes_again(
    links: int, kind: str, driver: str, speed: float
) -> None:
    sim = chain(links, HINGES[kind])
    hook = drive(sim, driver, links - 1, (float(links), 0.0))
    end = np.array([float(links), 0.0])
    fastest, after = speeds_out_and_back(sim, driver, hook, end, speed)
    assert fastest < AMPLIFICATION * math.sqrt(links) * speed
    assert after < AMPLIFICATION * math.sqrt(links) * speed
    assert any("'hand'" in str(told) and "yields" in str(told) for told in sim.warnings)
    sim.step(round(4.0 / sim.time_step))
    if kind != "sprung":  # a spring that pulls at rows that yield keeps them apart
        assert sim.reactions.separation.max() < 1e-3


@pytest.mark.filterwarnings("ignore::tamias2d.StepWarning")
def test_a_rope_that_is_taken_beyond_its_reach_is_told() -> None:
    scene = Scene(gravity=(0.0, 0.0))
    for k in range(3):
        scene.add_body(Disc(radius=0.1), mass=1.0, position=(k + 1.0, 0.0), **SURFACE)
        rope = Distance(limits=Limits(upper=1.0, restitution=0.0))
        scene.add_joint(rope, k - 1 if k else (0.0, 0.0), k, name=f"rope {k}")
    sim = Simulator(scene)
    hook = drive(sim, "kinematic", 2, (3.5, 0.0))
    fastest = 0.0
    for _ in range(120):
        sim.velocity[hook] = 0.0, 1.0
        sim.step()
        fastest = max(fastest, float(np.hypot(*sim.velocity.T).max()))
    assert fastest < AMPLIFICATION * math.sqrt(3)
    assert any("yields" in str(told) for told in sim.warnings)


@pytest.mark.filterwarnings("ignore::tamias2d.StepWarning")
@pytest.mark.parametrize("speed", [0.1, 0.3])
@pytest.mark.parametrize("gravity", [0.0, 9.81])
def test_slides_at_their_stops_are_not_thrown_the_faster_the_shorter_steps_are(
    gravity: float, speed: float
) -> None:
    """At most as rows may open, with the mass of all: before, 12 to 56 m/s at 1/960 s."""
    links, rows = 5, 9
    sim = Simulator(Scene(gravity=(0.0, -gravity)), time_step=1 / 960)
    disc = Disc(radius=0.05)
    kept: dict[str, Any] = {"restitution": 0.0, "mask": 0}
    above = sim.add_kinematic(disc, position=(0.0, 0.0), **kept)
    stops = Limits(lower=-0.2, upper=0.2, restitution=0.0)
    for k in range(links):
        plank = Box(width=0.9, height=0.1)
        own = sim.add(plank, mass=1.0, position=(k + 0.5, 0.0), friction=0.3, **kept)
        kind = Prismatic(axis=(1.0, 0.0), limits=stops) if 0 < k < 4 else Revolute()
        sim.add_joint(kind, above, own, anchor=(0.5 * (k > 0), 0.0), other_anchor=(-0.5, 0.0))
        above = own
    hook = sim.add_kinematic(disc, position=(float(links), 0.0), **kept)
    sim.add_joint(Revolute(), above, hook, anchor=(0.5, 0.0))
    fastest = 0.0
    for sign in (1.0, 0.0, -1.0, 0.0):
        sim.velocity[hook] = sign * speed * np.array([math.cos(0.3), math.sin(0.3)])
        for _ in range(round((1.2 / speed if sign else 0.5) / sim.time_step)):
            sim.step()
            fastest = max(fastest, float(np.hypot(*sim.velocity.T).max()))
    freed = math.sqrt(2.0 * gravity * links)  # by all that they may fall
    assert fastest < AMPLIFICATION * math.sqrt(links * rows) * speed + freed
    assert any("yields" in str(told) for told in sim.warnings)
    sim.step(4 * 960)
    assert sim.reactions.separation.max() < 1e-3


@pytest.mark.filterwarnings("ignore::tamias2d.StepWarning")
@pytest.mark.parametrize("slide", [0.0, 1.0])
@pytest.mark.parametrize("friction", [0.0, 0.5, 1.0])
def test_what_hangs_on_a_body_that_is_pressed_into_the_floor_is_not_thrown(
    friction: float, slide: float
) -> None:
    rough: dict[str, Any] = {"restitution": 0.0, "friction": friction}
    scene = Scene(gravity=(0.0, -10.0))
    scene.add_static(HalfPlane(normal=(0.0, 1.0), offset=0.0), **rough)
    scene.add_body(Box(width=0.5, height=0.5), mass=1.0, position=(0.0, 0.3), **rough)
    for k in range(3):
        link = Capsule(length=0.8, radius=0.1)
        scene.add_body(link, mass=1.0, position=(0.75 + k, 0.3), **rough)
        at = (0.5 if k else 0.25, 0.0)
        scene.add_joint(Revolute(), 1 + k, 2 + k, anchor=at, other_anchor=(-0.5, 0.0))
    sim = Simulator(scene)
    press = sim.add_kinematic(Disc(radius=0.1), position=(0.0, 0.3), restitution=0.0, mask=0)
    sim.add_joint(Weld(), press, 1)
    fastest = 0.0
    for step in range(180):
        sim.velocity[press] = slide, -1.0 if step < 60 else 1.0 if step < 120 else 0.0
        sim.step()
        fastest = max(fastest, float(np.hypot(*sim.velocity.T).max()))
    driven = AMPLIFICATION * math.sqrt(4.0 * 3.0) * math.hypot(1.0, slide)
    assert fastest < driven + math.sqrt(2 * 10.0 * 3.0)  # and what they may fall


@pytest.mark.filterwarnings("ignore::tamias2d.StepWarning")
@pytest.mark.parametrize("speed", [1.0, 3.0])
@pytest.mark.parametrize("ratio", [0.02, 1.0, 30.0])
def test_free_bodies_in_a_dead_centre_keep_their_momentum(ratio: float, speed: float) -> None:
    """The line of the wheel is across the arm of the hinge: it holds that by its limits alone."""
    scene = Scene(gravity=(0.0, 0.0))
    for k, mass in enumerate((1.0, ratio)):
        at = (float(k), 0.0)
        scene.add_body(Box(width=1.0, height=0.2), mass=mass, position=at, **SURFACE)
    scene.add_joint(Revolute(), 0, 1, anchor=(0.5, 0.0), other_anchor=(-0.5, 0.0))
    limits = Limits(lower=-0.2, upper=0.2, restitution=0.0)
    line = Wheel(
        axis=(math.sin(1e-3), math.cos(1e-3)),
        limits=limits,
        spring=JointSpring(stiffness=100.0, damping=0.0),
    )
    scene.add_joint(line, 0, 1, anchor=(0.7, 0.0), other_anchor=(-0.3, 0.0))
    sim = Simulator(scene, substeps=2)
    sim.velocity[:], sim.angular_velocity[:] = [[0.0, speed], [speed, -speed]], [speed, -speed]
    masses = np.array([1.0, ratio])
    before, most = masses @ sim.velocity, float(np.hypot(*sim.velocity.T).max())
    energy = 0.5 * masses @ (sim.velocity**2).sum(axis=1) + 0.5 * masses @ (
        1.04 / 12 * sim.angular_velocity**2
    )
    for _ in range(240):
        sim.step()
        most = max(most, float(np.hypot(*sim.velocity.T).max()))
        assert 0.5 * masses @ (sim.velocity**2).sum(axis=1) <= energy * (1 + 1e-9)
    np.testing.assert_allclose(masses @ sim.velocity, before, atol=1e-12 * most * masses.sum())


@pytest.mark.filterwarnings("ignore::tamias2d.StepWarning")
def test_saved_and_copied_while_it_yields_it_goes_on_with_the_same_bits(tmp_path: Path) -> None:
    sim = chain(3, HINGES["limited"])
    hook = drive(sim, "kinematic", 2, (3.0, 0.0))
    sim.velocity[hook] = 1.0, 0.3
    sim.step(30)
    sim.save(tmp_path / "chain.npz")
    others = [copy.copy(sim), Simulator.restore(tmp_path / "chain.npz", compiled=False)]
    for one in (sim, *others):
        one.step(10)
    for other in others:
        np.testing.assert_array_equal(other.velocity, sim.velocity)
        np.testing.assert_array_equal(other.position, sim.position)


def test_the_joint_that_cannot_hold_is_named() -> None:
    sim = chain(2, HINGES["plain"])
    hook = drive(sim, "kinematic", 1, (2.0, 0.0))
    sim.velocity[hook] = 1.0, 0.3
    with pytest.warns(StepWarning, match=r"'hand'.*yields \(DD86\)"):
        sim.step(30)


def take_one_by_one(sim: Simulator, count: int) -> None:
    """Take some steps as a game does: what is told of joints is looked at after each."""
    for _ in range(count):
        sim.step()


def test_a_taut_bridge_that_tears_is_told_to_hang_slack_since_nothing_drives_it() -> None:
    sim = Simulator(Scene(gravity=(0.0, -10.0)))
    for k in range(12):
        plank = Box(width=0.9, height=0.1)
        sim.add(plank, mass=2.0, position=(k + 0.5, 0.0), name=f"p{k}", **SURFACE)
        end = (0.0, 0.0) if k == 0 else f"p{k - 1}"
        anchor = (0.0, 0.0) if k == 0 else (0.5, 0.0)
        sim.add_joint(Revolute(), end, f"p{k}", anchor=anchor, other_anchor=(-0.5, 0.0))
    sim.add_joint(Revolute(), "p11", (12.0, 0.0), anchor=(0.5, 0.0))
    sim.add(Box(width=1.0, height=1.0), mass=30.0, position=(5.0, 3.0), **SURFACE)
    with pytest.warns(StepWarning, match=r"Nothing drives it.*\(DD86\).*some slack"):
        take_one_by_one(sim, 60)
    assert not any("bring what drives it" in text for text in sim.warnings)
