"""A joint to a point of the plane that is moved between steps, as by a mouse.

Expected values come from the closed form of a spring with its damper, and from what is the same.
"""

import copy
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tamias2d import (
    Box,
    Disc,
    Distance,
    Gear,
    InputError,
    JointSpring,
    Limits,
    Reference,
    Revolute,
    Scene,
    Simulator,
    Target,
    Wheel,
    simulate,
)
from tests.engine.scenes import plain

G = 9.81
SOFT = JointSpring(stiffness=400.0, damping=10.0)


def dragged(kind: Any, *, gravity: float = 0.0, **settings: Any) -> Simulator:
    """Return a box of 1 kg at (0.5, 3), held at its middle by a joint to the plane there."""
    sim = plain(Scene(gravity=(0.0, -gravity)), **settings)
    box = sim.add(Box(width=1.0, height=1.0), mass=1.0, position=(0.5, 3.0), restitution=0.0)
    sim.add_joint(kind, (0.5, 3.0), box, name="mouse")
    return sim


def test_target_pulls_as_a_spring_with_its_damper_does() -> None:
    """A box at rest that is pulled from where it is to a point 0.5 m away, by closed form."""
    sim = dragged(Target(spring=SOFT), time_step=1 / 240)
    sim.set_target("mouse", (0.9, 3.3))
    rate = math.sqrt(400.0 - 25.0)
    for k in range(120):
        sim.step()
        at = (k + 1) / 240
        left = math.exp(-5 * at) * (math.cos(rate * at) + 5 / rate * math.sin(rate * at))
        assert sim.position[0] == pytest.approx((0.9 - 0.4 * left, 3.3 - 0.3 * left), abs=2e-3)
    assert sim.orientation[0] == pytest.approx(0.0, abs=1e-12)  # held at its middle


def test_target_in_the_exact_way() -> None:
    scene = Scene(gravity=(0.0, 0.0))
    scene.add_body(None, mass=1.0, position=(0.5, 3.0))
    scene.add_joint(Target(spring=SOFT), (0.9, 3.3), 0)
    run = simulate(scene, duration=0.5, times=[0.5], method=Reference())
    rate, at = math.sqrt(400.0 - 25.0), 0.5
    left = math.exp(-5 * at) * (math.cos(rate * at) + 5 / rate * math.sin(rate * at))
    assert run.position[0, 0] == pytest.approx((0.9 - 0.4 * left, 3.3 - 0.3 * left), abs=1e-10)


@pytest.mark.parametrize(
    "kind",
    [
        Target(spring=SOFT),
        Revolute(),
        Wheel(axis=(1.0, 0.0), spring=SOFT),
        Distance(spring=JointSpring(stiffness=400.0, damping=40.0, rest=0.5)),
        Distance(limits=Limits(upper=0.1, restitution=0.0)),
    ],
    ids=["target", "hinge", "wheel", "spring", "rope"],
)
def test_what_a_joint_ties_follows_its_target(kind: Any) -> None:
    sim = plain(Scene(gravity=(0.0, 0.0)))
    start = (0.5, 3.5) if isinstance(kind, Distance) and kind.spring else (0.5, 3.0)
    shift = (0.05, 0.0) if isinstance(kind, Distance) and kind.limits else (0.0, 0.0)
    place = (start[0] + shift[0], start[1])
    box = sim.add(Box(width=1.0, height=1.0), mass=1.0, position=place, restitution=0.0)
    sim.add_joint(kind, (0.5, 3.0), box, name="mouse")
    for k in range(120):
        sim.set_target("mouse", (0.5 + k / 120, 3.0 + k / 60))
        sim.step()
    sim.step(240)
    reach = math.hypot(*(sim.position[box] - (0.5 + 119 / 120, 3.0 + 119 / 60)))
    most = {"target": 1e-3, "hinge": 1e-5, "wheel": 1e-2}
    if isinstance(kind, Distance):
        assert reach < 0.51 if kind.spring else reach < 0.1 + 1e-4
    else:
        assert reach < most[{Target: "target", Revolute: "hinge", Wheel: "wheel"}[type(kind)]]


def test_mouse_lifts_what_rests_and_sleeps() -> None:
    scene = Scene(gravity=(0.0, -G))
    bob = scene.add_body(Disc(radius=0.2), mass=1.0, position=(0.0, -1.0), restitution=0.0)
    scene.add_joint(Revolute(), (0.0, 0.0), bob, other_anchor=(0.0, 1.0), name="mouse")
    sim = Simulator(scene, sleeping=True, compiled=False)
    sim.step(90)
    assert sim.asleep[bob]
    sim.set_target("mouse", (0.0, 0.5))
    sim.step(20)
    assert sim.position[bob] == pytest.approx((0.0, -0.5), abs=1e-5)


@pytest.mark.parametrize("spring", [SOFT, JointSpring(stiffness=400.0, damping=40.0)])
def test_target_may_be_on_the_anchor(spring: JointSpring) -> None:
    """Where a distance of none has no direction, two travels have one each."""
    sim = dragged(Target(spring=spring))
    for _ in range(60):
        sim.set_target("mouse", sim.position[0])
        sim.step()
    assert sim.position[0].tolist() == [0.5, 3.0]


def test_target_takes_no_more_than_its_distance_gives() -> None:
    """What limits a spring's force is how far away its point is put."""
    sim = dragged(Target(spring=SOFT), gravity=G)
    strongest = 20.0  # N
    for _ in range(120):
        away = np.array((5.0, 9.0)) - sim.position[0]
        reach = strongest / SOFT.stiffness
        away *= min(1.0, reach / float(np.hypot(*away)))
        sim.set_target("mouse", sim.position[0] + away)
        velocity = sim.velocity[0].copy()
        sim.step()
        pulled = sim.reactions.force[0, 1] + SOFT.damping * velocity
        assert np.hypot(*pulled) < strongest * 1.3  # it moves on within a step


def test_targets_of_equal_trees_are_each_their_own() -> None:
    """Nine equal pendulums are solved side by side; their points are moved apart."""
    scene = Scene(gravity=(0.0, -G))
    for k in range(9):
        scene.add_body(Disc(radius=0.1), mass=1.0, position=(float(k), -1.0), restitution=0.0)
        scene.add_joint(Revolute(), (float(k), 0.0), k, other_anchor=(0.0, 1.0), name=f"hand {k}")
    sim = plain(scene)
    for step in range(60):
        for k in range(9):
            sim.set_target(f"hand {k}", (float(k), 0.01 * k * step / 60))
        sim.step()
    sim.step(30)
    heights = 0.01 * np.arange(9) * 59 / 60 - 1.0
    assert sim.position[:, 1] == pytest.approx(heights, abs=1e-7)
    assert sim.reactions.separation.max() < 1e-7


def test_saved_with_a_new_target_it_goes_on_with_the_same_bits(tmp_path: Path) -> None:
    sim = dragged(Target(spring=SOFT), gravity=G)
    sim.add_joint(Target(spring=SOFT), (0.5, 3.0), 0, name="other hand")
    for k in range(30):
        sim.set_target("mouse", (0.5 + k / 30, 3.0))
        sim.set_target("other hand", (1.5 - k / 30, 3.0))  # they pass each other
        sim.step()
    sim.set_target("mouse", (0.0, 4.0))
    sim.save(tmp_path / "mouse.npz")
    others = [copy.copy(sim), Simulator.restore(tmp_path / "mouse.npz", compiled=False)]
    for one in (sim, *others):
        one.step(30)
    assert len({one.digest() for one in (sim, *others)}) == 1


def test_what_is_no_target_is_refused_by_name() -> None:
    sim = dragged(Target(spring=SOFT))
    wheel = sim.add(Disc(radius=0.1), mass=1.0, position=(3.0, 0.0), restitution=0.0)
    sim.add_joint(Revolute(), 0, wheel, anchor=(2.5, -3.0), name="hinge")
    sim.add_joint(Gear(ratio=2.0), 0, wheel, name="gear")
    with pytest.raises(InputError, match="joint 'rope': the simulator has none such"):
        sim.set_target("rope", (0.0, 0.0))
    for name in ("hinge", "gear"):
        with pytest.raises(InputError, match=f"joint '{name}'.*holds no point of the plane"):
            sim.set_target(name, (0.0, 0.0))
    with pytest.raises(InputError, match=r"point\[0\] of a target: .*must be finite"):
        sim.set_target("mouse", (math.nan, 0.0))
    with pytest.raises(InputError, match=r"rest 1 m: it pulls to the point itself"):
        sim.add_joint(Target(spring=JointSpring(stiffness=1.0, rest=1.0)), (0.0, 0.0), wheel)
    unsprung: Any = None
    with pytest.raises(InputError, match=r"spring of joint 'pull': found None.*Give JointSpring"):
        sim.add_joint(Target(spring=unsprung), (0.0, 0.0), wheel, name="pull")


def test_a_target_too_far_away_for_float64_is_refused() -> None:
    """It exerted nothing at 1e300 m, as its force was no number."""
    sim = dragged(Target(spring=SOFT))
    with pytest.raises(InputError, match=r"point \(1e\+300, 0.0\) .*: must be within 1.2e"):
        sim.set_target("mouse", (1e300, 0.0))
    sim.step()
    assert sim.position[0] == pytest.approx((0.5, 3.0), abs=1e-12)
