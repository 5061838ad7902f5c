"""Scenes that are quick to study."""

import pytest

from tamias2d.scene import Disc, HalfPlane, Scene
from tamias2d.study import candidates, work_precision
from tamias2d.study.work_precision import Study, study


@pytest.fixture
def bounce() -> Scene:
    scene = Scene(gravity=(0.0, -9.81), name="bounce")
    disc = Disc(radius=0.5)
    scene.add_body(disc, mass=1.0, position=(0.0, 1.5), restitution=0.8, name="disc")
    scene.add_static(HalfPlane(normal=(0.0, 1.0), offset=0.0), name="floor")
    return scene


@pytest.fixture
def spring() -> Scene:
    """Of angular frequency 40/s, which some steps are too long for."""
    scene = Scene(gravity=(0.0, 0.0), name="spring")
    ball = scene.add_body(Disc(radius=0.1), mass=1.0, position=(1.0, 0.0), name="ball")
    scene.add_spring(ball, (0.0, 0.0), stiffness=1600.0, rest_length=0.0)
    return scene


@pytest.fixture
def studied(spring: Scene, monkeypatch: pytest.MonkeyPatch) -> Study:
    monkeypatch.setattr(work_precision, "_RUNGS", 5)
    monkeypatch.setattr(candidates, "TOLERANCES", (1e-4,))
    return study(spring, duration=2.0, timed=False)
