"""Runs to record: of every kind of body, with impacts, and of the ways that need more inputs."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

import tamias2d as t2


def scene() -> t2.Scene:
    """A throw, with names that no path or file name would like."""
    scene = t2.Scene(gravity=(0.0, -9.81), name="throw", says="Things in the air.")
    scene.add_body(
        t2.Disc(radius=0.3),
        mass=1.0,
        position=(-2.0, 3.0),
        velocity=(1 / 3, 2.0),
        angular_velocity=3.0,
        restitution=0.8,
        name="red ball / 1",
    )
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=-9.0), name="floor")
    scene.add_body(
        t2.Box(width=1.0, height=0.5),
        mass=2.0,
        position=(0.1, 4.0),
        restitution=1.0,
        name="Kiste ü",
    )
    triangle = t2.Polygon(vertices=[(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)])
    scene.add_body(triangle, mass=0.5, position=(3.0, 4.0), orientation=0.7, restitution=1.0)
    scene.add_body(None, mass=1e-3, position=(1.0, 6.0), velocity=(-0.1, 0.0), name="speck")
    scene.add_static(t2.Disc(radius=0.2), position=(5.0, 5.0), name="lamp")
    return scene


def shapes() -> t2.Scene:
    """A capsule, a segment, filters and friction."""
    scene = t2.Scene(gravity=(0.0, -9.81), name="shapes")
    scene.add_body(t2.Capsule(length=1.0, radius=0.2), mass=1.0, position=(0.0, 1.0), category=6)
    scene.add_body(
        t2.Segment(length=2.0), mass=0.5, position=(3.0, 4.0), angular_velocity=1.0, friction=0.5
    )
    scene.add_static(t2.Segment(length=9.0), position=(0.0, -9.0), mask=1, group=-4)
    return scene


def with_impacts(run: t2.Run) -> t2.Run:
    """The run with impacts made up, two of them at one instant."""
    none = np.zeros((3, 2))
    return replace(
        run,
        impacts=t2.Impacts(
            time=np.array([0.1, 0.1, 0.2]) / 3,
            bodies=np.array([[0, 1], [0, 2], [3, 2]]),
            point=none + 1 / 3,
            normal=np.tile((0.6, 0.8), (3, 1)),
            impulse=np.array([1.0, 2.0, 1e-300]),
            normal_velocity=np.array([-1.0, -0.1, -3.0]),
        ),
    )


@pytest.fixture(scope="session")
def run() -> t2.Run:
    return t2.simulate(scene(), duration=0.5)


def _driven() -> t2.Run:
    scene = t2.Scene(gravity=(0.0, 0.0))
    push = ("10[N]*sin(2[rad/s]*time)", 0.0)
    scene.add_body(None, mass=1.0, position=(0.0, 0.0), force=push)
    return t2.simulate(scene, duration=0.3, method=t2.Reference(rtol=1e-9))


RUNS: dict[str, Callable[[], t2.Run]] = {
    "closed form": lambda: t2.simulate(scene(), duration=0.5),
    "stepped": lambda: t2.simulate(
        scene(), duration=0.5, method=t2.VelocityVerlet(), time_step=1 / 240
    ),
    "legacy": lambda: t2.simulate(
        t2.catalogue.load("tc1"), duration=1.0, method=t2.Legacy2018(), time_step=0.1
    ),
    "reference": _driven,
    "own times": lambda: t2.simulate(scene(), duration=0.5, times=[0.0, 0.1, 1 / 3]),
    "all shapes": lambda: t2.simulate(shapes(), duration=0.5),
    "impacts made up": lambda: with_impacts(t2.simulate(scene(), duration=0.5)),
}


@pytest.fixture(params=RUNS)
def any_run(request: Any) -> t2.Run:
    return RUNS[request.param]()
