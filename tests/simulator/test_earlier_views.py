"""What is written into a view that adding has made an earlier one is not lost in silence."""

from typing import Any

import numpy as np
import pytest

import tamias2d as t2

BALL = t2.Disc(radius=0.1)


def balls(count: int, **settings: Any) -> t2.Simulator:
    sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)), **settings)
    more(sim, count)
    return sim


def more(sim: t2.Simulator, count: int) -> None:
    """Add balls beside each other, far from all that are there."""
    place = [(float(k), 3.0 * len(sim)) for k in range(count)]
    sim.add(BALL, mass=1.0, position=place, restitution=0.0)


WAYS: dict[str, Any] = {
    "whole": lambda view: view.__setitem__(3, 1.0),
    "part": lambda view: view[2:5].__setitem__(1, 1.0),
    "in place": lambda view: np.add(view[3:4], 1.0, out=view[3:4]),
    "NaN": lambda view: view.__setitem__(3, np.nan),
}


@pytest.mark.parametrize("name", ["position", "orientation", "velocity", "torque"])
@pytest.mark.parametrize("way", WAYS)
def test_a_value_that_would_be_lost_is_told_by_the_next_step(name: str, way: str) -> None:
    sim = balls(5)
    view = getattr(sim, name)
    more(sim, 1000)
    sim.step()
    WAYS[way](view)
    with pytest.raises(t2.InputError, match=rf"{name}\[3\] .*lost \(R4\). Take sim.{name} anew"):
        sim.step()
    assert sim.time == sim.time_step
    sim.step()  # it is told once
    view[4] = 2.0
    with pytest.raises(t2.InputError, match=rf"{name}\[4\]"):
        sim.step()


def test_a_row_that_was_taken_before_is_told_too() -> None:
    sim = balls(5)
    hero = sim.velocity[2]
    more(sim, 1000)
    hero[0] = 5.0
    with pytest.raises(t2.InputError, match=r"velocity\[2\]"):
        sim.step()


def test_one_that_was_taken_two_additions_ago_is_told() -> None:
    """The first one leaves the arrays where they are."""
    sim = balls(5)
    view = sim.velocity
    more(sim, 1)
    assert np.shares_memory(view, sim.velocity)
    view[0] = 1.0, 0.0
    sim.step()
    assert sim.velocity[0].tolist() == [1.0, 0.0]
    more(sim, 1000)
    view[1] = 1.0, 0.0
    with pytest.raises(t2.InputError, match=r"velocity\[1\]"):
        sim.step()


def test_reading_goes_on_and_what_nobody_holds_is_forgotten() -> None:
    sim = balls(5)
    view, before = sim.position, sim.position.copy()
    more(sim, 1000)
    sim.step(10)
    assert (view == before).all()
    assert sim._earlier
    del view
    sim.step()
    assert not sim._earlier


def test_what_is_written_before_bodies_are_added_counts() -> None:
    sim = balls(5)
    view = sim.velocity
    view[1] = 1.0, 0.0
    more(sim, 1000)
    sim.step()
    assert sim.velocity[1].tolist() == [1.0, 0.0]


def test_what_sleeps_wakes_by_an_earlier_view_of_the_same_arrays() -> None:
    sim = balls(5, sleeping=True)
    view = sim.velocity
    more(sim, 1)
    sim.step(100)
    assert sim.asleep.all()
    sim.step()
    view[2] = 1.0, 0.0
    sim.step()
    assert sim.position[2, 0] > 2.0
