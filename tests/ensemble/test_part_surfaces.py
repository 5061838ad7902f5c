"""Worlds in which parts of a compound have other surfaces: each is what it is alone (R3)."""

from typing import Any

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.ensemble.outline import outline_of, scene_of
from tamias2d.ensemble.places import place_at
from tamias2d.ensemble.request import request_of
from tamias2d.ensemble.stepped import stepped
from tamias2d.ensemble.worlds import worlds_of

G = 10.0
BOARD = t2.Box(width=2.0, height=0.1)
METHOD: dict[str, Any] = {"duration": 0.5, "method": t2.Stepped(), "time_step": 1 / 60}
RUNNER = "bodies.sledge.parts.0.friction"


def sledge(**runner: float) -> t2.Scene:
    """Return a body that slides on its runner, at 4 m/s, on ground with a friction of 0.16."""
    scene = t2.Scene(gravity=(0.0, -G))
    ground = t2.HalfPlane(normal=(0.0, 1.0), offset=0.0)
    scene.add_static(ground, friction=0.16, restitution=0.0, name="ground")
    parts = [
        t2.Part(shape=BOARD, position=(0.0, -0.05), **runner),
        t2.Part(shape=BOARD, position=(0.0, 0.05)),
    ]
    place: Any = {"position": (0.0, 0.1), "velocity": (4.0, 0.0), "friction": 1.0}
    scene.add_body(t2.Compound(parts=parts), mass=2.0, name="sledge", **place)
    return scene


@pytest.mark.parametrize("runner", [{}, {"friction": 0.9}])
def test_the_friction_of_a_part_varies(runner: dict[str, float]) -> None:
    """With the ground's 0.16 the values make 0.1, 0.2 and 0.4 (DD23); none stated may vary, too."""
    values = np.array([0.0625, 0.25, 1.0])
    scene = sledge(**runner)
    ran = t2.ensemble(scene, vary={RUNNER: values}, keep=("velocity",), **METHOD)
    velocity = ran.velocity.values[:, -1, 0, 0]
    assert velocity == pytest.approx(4.0 - np.sqrt(0.16 * values) * G * 0.5, abs=1e-6)
    for k, value in enumerate(values.tolist()):
        alone = t2.simulate(sledge(friction=value), times=(0.5,), **METHOD)
        assert alone.velocity[-1, 1, 0] == velocity[k]
    sims = t2.Simulators(scene, vary={RUNNER: values})
    sims.step(30)
    assert sims.velocity[:, 1, 0].tolist() == velocity.tolist()


def test_worlds_that_share_a_simulator_leave_parts_what_they_state() -> None:
    """What varies of the body is what its silent parts have."""
    for runner, friction in ((0.25, (0.2, 0.2)), (None, (0.1, 0.4))):
        scene = sledge(**({} if runner is None else {"friction": runner}))
        vary = {"bodies.sledge.friction": [0.0625, 1.0], "bodies.ground.restitution": [0.0, 0.1]}
        worlds = worlds_of(scene, vary, None, None, None)
        found = stepped(worlds, request_of(scene, bodies=range(2), **METHOD), 0, 2)
        assert found is not None
        assert found.done.all()
        wanted = 4.0 - np.array(friction) * G * 0.5
        assert found.arrays["velocity"][:, -1, 1, 0] == pytest.approx(wanted, abs=1e-6)
        for world in (0, 1):
            run = t2.simulate(worlds.scene(world), times=(0.5,), **METHOD)
            assert found.arrays["velocity"][world].tobytes() == run.velocity.tobytes()


def test_a_scene_taken_apart_is_the_same_again() -> None:
    scene = sledge(friction=0.3)
    outline = outline_of(scene)
    again = scene_of(outline, scene)
    assert again == scene
    assert again.bodies[1].shape is scene.bodies[1].shape
    place = place_at("bodies.sledge.parts.1.restitution", outline)
    changed = scene_of(place.put(outline, 0.5), scene).bodies[1].shape
    assert isinstance(changed, t2.Compound)
    assert [(part.restitution, part.friction) for part in changed.parts] == [
        (None, 0.3),
        (0.5, None),
    ]


@pytest.mark.parametrize(
    ("path", "hint"),
    [
        ("bodies.sledge.parts.0.fricton", "Did you mean 'bodies.sledge.parts.0.friction'"),
        ("bodies.sledge.parts.2.friction", "no such place"),
        ("bodies.sledge.parts.0", "no such place"),
        ("bodies.sledge.parts", "no such place"),
        ("bodies.ground.parts.0.friction", "no such place"),
    ],
)
def test_a_part_that_is_not_there_cannot_vary(path: str, hint: str) -> None:
    with pytest.raises(t2.InputError, match=hint):
        place_at(path, outline_of(sledge()))


def test_values_of_parts_obey_their_rules() -> None:
    with pytest.raises(t2.InputError, match=r"found -1\.0 for world 1: must be >= 0"):
        t2.Simulators(sledge(), vary={RUNNER: [0.5, -1.0]})
