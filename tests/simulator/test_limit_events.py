"""Limits that are struck and left in the frame loop, beside the instants that `simulate` finds."""

from pathlib import Path

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.engine import tables as tb
from tamias2d.simulator.joint_events import LimitEvents

STEP = 1 / 240


def door(restitution: float) -> t2.Scene:
    """A bar that falls from the horizontal about its end, and strikes a stop."""
    scene = t2.Scene(gravity=(0.0, -9.81))
    bar = scene.add_body(None, mass=1.0, inertia=0.1, position=(1.0, 0.0))
    stops = t2.Limits(lower=-1.0, upper=1.0, restitution=restitution)
    hinge = t2.Revolute(limits=stops)
    scene.add_joint(hinge, (0.0, 0.0), bar, other_anchor=(-1.0, 0.0), name="hinge")
    return scene


def told(sim: t2.Simulator, steps: int, count: int = 1) -> list[tuple[float, str, str, float]]:
    """Return time, joint, words and value of all events in some steps, taken so many at once."""
    found = []
    for _ in range(0, steps, count):
        sim.step(count)
        found += [(one.time, one.joint, one.words, one.value) for one in sim.joint_events]
    return found


def test_strikes_are_those_of_exact_motion() -> None:
    """Each within a step, and its impulse within what gravity gives in a step, m g r dt = 0.04."""
    events = told(t2.Simulator(door(0.4), time_step=STEP), 320)
    exact = t2.simulate(door(0.4), duration=320 * STEP).joint_events
    struck = [one for one in events if one[2].startswith("strikes")]
    assert [one[2] for one in events[:6]] == [
        f"{word} its lower limit" for word in 3 * ("strikes", "leaves")
    ]
    assert [one[0] for one in struck[:3]] == pytest.approx(exact.time[:3], abs=1.5 * STEP)
    assert [one[3] for one in struck[:3]] == pytest.approx(exact.value[:3], abs=0.04)


def test_a_limit_that_is_leant_on_is_struck_once_and_left_as_it_is_pushed_away() -> None:
    sim = t2.Simulator(door(0.0), time_step=STEP)
    (event,) = told(sim, 480)
    assert event[1:3] == ("hinge", "strikes its lower limit")
    assert not told(sim, 240)
    sim.angular_velocity[0] = 3.0
    sim.velocity[0] = (3.0 * np.sin(1.0), 3.0 * np.cos(1.0))
    (event,) = told(sim, 5)
    assert event[1:] == ("hinge", "leaves its lower limit", 0.0)


@pytest.mark.parametrize("restitution", [0.0, 0.4])
def test_many_steps_at_once_tell_the_last_of_each_kind(restitution: float) -> None:
    one = told(t2.Simulator(door(restitution), time_step=STEP), 300)
    many = told(t2.Simulator(door(restitution), time_step=STEP), 300, count=300)
    assert (
        many
        == [
            next(event for event in reversed(one) if event[2] == words)
            for words in dict.fromkeys(event[2] for event in reversed(one))
        ][::-1]
    )


def test_plain_code_and_restored_simulators_tell_the_same(tmp_path: Path) -> None:
    sim = t2.Simulator(door(0.4), time_step=STEP)
    plain = t2.Simulator(door(0.4), time_step=STEP, compiled=False)
    before = told(sim, 116)  # the first strike ends this
    assert told(plain, 116) == before
    assert before[-1][2].startswith("strikes")
    sim.save(tmp_path / "door.npz")
    again = t2.Simulator.restore(tmp_path / "door.npz")
    assert told(again, 180) == told(sim, 180)


def test_ropes_and_rails_tell_from_which_side_they_are_limited() -> None:
    scene = t2.Scene(gravity=(0.0, -9.81))
    bob = scene.add_body(None, mass=2.0, inertia=1.0, position=(0.0, -0.5))
    rope = t2.Distance(limits=t2.Limits(upper=1.0, restitution=0.0))
    scene.add_joint(rope, (0.0, 0.0), bob, name="rope")
    cart = scene.add_body(None, mass=1.0, inertia=1.0, position=(3.0, 0.0), velocity=(-1.0, 0.0))
    rail = t2.Prismatic(axis=(1.0, 0.0), limits=t2.Limits(lower=-0.5, upper=0.5, restitution=1.0))
    scene.add_joint(rail, (3.0, 0.0), cart, name="rail")
    events = told(t2.Simulator(scene, time_step=STEP), 400)
    found = {(joint, words): value for _, joint, words, value in reversed(events)}
    assert found["rail", "strikes its lower limit"] == pytest.approx(2.0, rel=1e-3)
    assert found["rail", "strikes its upper limit"] == pytest.approx(2.0, rel=1e-3)
    assert found["rope", "strikes its upper limit"] == pytest.approx(2 * 9.81**0.5, abs=0.09)
    assert {words for joint, words in found if joint == "rope"} == {"strikes its upper limit"}


def test_runs_by_steps_tell_them_too() -> None:
    run = t2.simulate(door(0.4), duration=1.0, method=t2.Stepped(), time_step=STEP)
    words = run.joint_events.words
    assert words[:2] == ("strikes its lower limit", "leaves its lower limit")


def test_where_a_step_leaves_one_end_and_strikes_the_other_it_leaves_first() -> None:
    sim = t2.Simulator(door(0.0), time_step=STEP)
    sim.step(200)
    layout = sim._joints.layout
    lower, upper = layout.places[1:]  # the first row keeps the hinge
    layout.numbers[lower, tb.J_STRUCK_AT] = layout.numbers[upper, tb.J_LEFT_AT] = 201
    words = [event.words for event in LimitEvents(layout, {}).after(200, STEP)]
    assert words == ["leaves its upper limit", "strikes its lower limit"]


def test_a_limit_that_is_leant_on_is_not_struck_as_other_joints_come_and_go() -> None:
    sim = t2.Simulator(door(0.0), time_step=STEP)
    assert len(told(sim, 480)) == 1
    other = sim.add(None, mass=1.0, inertia=1.0, position=(9.0, 0.0))
    sim.add_joint(t2.Weld(), other, (9.0, 0.0), name="held")
    assert not told(sim, 2)
    sim.remove_joint("held")
    assert not told(sim, 2)
    sim.remove(other)
    assert not told(sim, 2)


def test_a_joint_that_is_added_anew_under_its_name_strikes() -> None:
    sim = t2.Simulator(door(0.0), time_step=STEP)
    sim.step(480)
    sim.remove_joint("hinge")
    hinge = t2.Revolute(limits=t2.Limits(lower=-1.0, restitution=0.0))
    sim.add_joint(hinge, (0.0, 0.0), 0, other_anchor=(-1.0, 0.0), name="hinge")
    ((_, joint, words, _),) = told(sim, 3)
    assert (joint, words) == ("hinge", "strikes its lower limit")


@pytest.mark.filterwarnings("ignore::tamias2d.errors.StepWarning")
@pytest.mark.parametrize("height", [0.02, 0.05, 0.07])
def test_a_step_in_parts_tells_its_whole_blow_once(height: float) -> None:
    """A crowd falls so fast that steps are taken in parts, beside a slide that bounces."""
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -9.81)), time_step=1 / 30)
    load = sim.add(t2.Disc(radius=0.1), mass=2.0, position=(0.0, 0.0), restitution=0.0)
    rail = t2.Prismatic(axis=(0.0, 1.0), limits=t2.Limits(lower=-height, restitution=0.3))
    sim.add_joint(rail, (0.0, 0.0), load, name="rail")
    floor = t2.HalfPlane(normal=(0.0, 1.0), offset=-5.0)
    sim.add_static(floor, restitution=0.5, friction=0.3)
    places = [(5 + 0.025 * (k % 10), -4.5 + 0.025 * (k // 10)) for k in range(200)]
    rain = {"mass": 0.01, "velocity": (3.0, -20.0), "restitution": 0.9, "friction": 0.3}
    sim.add(t2.Disc(radius=0.01), position=places, **rain)
    words, parts = [], 1
    for _ in range(15):
        sim.step()
        for event in sim.joint_events:
            words.append(event.words.split()[0])
            if words[-1] == "strikes":
                parts = max(parts, sim.parts)
                whole = float(np.hypot(*sim.reactions.impulse[0, 1]))
                assert event.value == pytest.approx(whole, rel=1e-9)
    assert parts > 1
    assert words == [("strikes", "leaves")[k % 2] for k in range(len(words))]


def test_as_many_events_after_a_joint_was_added_are_told() -> None:
    sim = t2.Simulator(door(0.4), time_step=STEP)
    sim.step(130)
    assert len(sim.joint_events) == 2
    other = sim.add(None, mass=1.0, inertia=1.0, position=(9.0, 0.0))
    sim.add_joint(t2.Weld(), other, (9.0, 0.0), name="held")
    sim.step(130)
    assert len(sim.joint_events) == 2
