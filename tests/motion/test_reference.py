"""Steps of the reference whose trials go where no force is finite."""

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.motion.law_resolution import LawResolution
from tamias2d.motion.memoised_field import MemoisedField
from tamias2d.motion.motion import Tally
from tamias2d.motion.reference import ScipyDop853


def slider(duration, method):
    """A box that slides to and fro on a rough floor, and sticks in between."""
    scene = t2.Scene(gravity=(0.0, -9.81))
    scene.add_body(
        t2.Box(width=1.0, height=0.1),
        mass=0.6026732656620009,
        position=(-0.5110669450273762, 0.05),
        velocity=(-0.31988551779880314, 0.0),
        friction=0.429355369473526,
        restitution=0.0,
        linear_drag=0.34046433263986225,
        quadratic_drag=0.17882765128084588,
        force=("10.852766262880031[N]*sin(3.0669480718237914[1/s]*time)", 0.0),
    )
    floor = t2.HalfPlane(normal=(0.0, 1.0), offset=0.0)
    scene.add_static(floor, friction=0.429355369473526, restitution=0.0)
    scene.add_spring(0, (30.0, 0.05), stiffness=30.737233050357773, rest_length=29.39622493711059)
    times = np.linspace(0.0, 5.1, 11)
    return t2.simulate(scene, duration=duration, times=times, method=method)


@pytest.mark.parametrize("method", [t2.Dop853(rtol=1e-10), t2.Reference(rtol=1e-10)])
def test_a_step_from_rest_that_is_too_long_for_drag_is_taken_again(method):
    """The longer the run, the longer is the first trial after the box has stuck."""
    short, long = slider(5.1, method), slider(6.0, method)
    assert long.position == pytest.approx(short.position, abs=1e-8)


def test_forces_are_asked_for_at_times_that_messages_can_tell():
    """Scipy's own times would be told as `np.float64(0.5)`."""
    kinds = set()

    def pull(time, position, velocity):
        kinds.add(type(time))
        return -position - velocity

    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(None, mass=1.0, position=(1.0, 0.0))
    field = MemoisedField(pull, [0], [None], Tally())
    integrator = ScipyDop853(1e-9, (1.0, 1.0), LawResolution(scene, 1.0))
    integrator.step(field, 0.0, 1.0, np.ones((1, 3)), np.zeros((1, 3)))
    assert kinds == {float}
