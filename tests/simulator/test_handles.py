"""What a row holds: handles that know when they are stale, and bodies as they are now."""

from pathlib import Path

import numpy as np
import pytest

import tamias2d as t2

SHAPES: list[t2.Body | object] = [
    t2.Disc(radius=0.5),
    t2.Box(width=1.0, height=0.3),
    t2.Capsule(length=1.0, radius=0.1),
    t2.Segment(length=2.0),
    None,
]


def empty() -> t2.Simulator:
    return t2.Simulator(t2.Scene(gravity=(0.0, -9.81)))


def test_a_row_counts_the_bodies_that_it_has_held() -> None:
    sim = empty()
    first, second = (
        sim.add(t2.Disc(radius=0.5), mass=1.0, position=(3.0 * k, 0.0), restitution=0.0)
        for k in range(2)
    )
    handle = first, sim.generation[first]
    sim.remove(first)
    sim.step()
    again = sim.add(t2.Disc(radius=0.5), mass=1.0, position=(9.0, 0.0), restitution=0.0)
    assert again == first
    assert sim.generation.tolist() == [2, 1]
    assert sim.generation[handle[0]] != handle[1]
    assert sim.generation[second] == 1


def test_generations_are_saved(tmp_path: Path) -> None:
    sim = empty()
    sim.add(t2.Disc(radius=0.5), mass=1.0, position=(0.0, 0.0), restitution=0.0)
    sim.remove(0)
    sim.step()
    sim.add(t2.Disc(radius=0.5), mass=1.0, position=(0.0, 0.0), restitution=0.0)
    sim.save(tmp_path / "game.npz")
    assert t2.Simulator.restore(tmp_path / "game.npz").generation.tolist() == [2]
    with pytest.raises(t2.InputError, match="it is told, and cannot be set"):
        sim.generation = np.array([1])  # type: ignore[misc]


@pytest.mark.parametrize("shape", SHAPES, ids=repr)
def test_a_body_is_what_was_added(shape: object) -> None:
    sim = empty()
    surface = {} if shape is None else {"friction": 0.25, "restitution": 0.5}
    k = sim.add(
        shape,  # type: ignore[arg-type]
        mass=2.0,
        inertia=0.5,
        position=(1.0, 2.0),
        orientation=0.1,
        velocity=(3.0, 4.0),
        angular_velocity=5.0,
        force=(6.0, 7.0),
        torque=8.0,
        linear_drag=0.5,
        angular_drag=0.25,
        name="it",
        **surface,
    )
    body = sim.body(k)
    assert body == sim.body("it")
    expected = t2.Body(
        name="it",
        shape=shape,  # type: ignore[arg-type]
        dynamic=True,
        mass=2.0,
        inertia=0.5,
        position=(1.0, 2.0),
        orientation=0.1,
        velocity=(3.0, 4.0),
        angular_velocity=5.0,
        force=(6.0, 7.0),
        torque=8.0,
        linear_drag=0.5,
        angular_drag=0.25,
        inertia_stated=True,
        **surface,
    )
    assert body == expected


def test_shapes_with_a_centre_are_told_about_it() -> None:
    sim = empty()
    polygon = t2.Polygon(vertices=[(0.0, 0.0), (2.0, 0.0), (0.3, 1.0)])
    parts = [
        t2.Part(shape=t2.Box(width=1.0, height=0.3)),
        t2.Part(shape=t2.Disc(radius=0.4), position=(1.0, 0.0)),
        t2.Part(shape=t2.Capsule(length=1.0, radius=0.1), orientation=1.0),
    ]
    compound = t2.Compound(parts=parts)
    for k, shape in enumerate((polygon, compound)):
        sim.add(shape, mass=1.0, position=(5.0 * k, 0.0), restitution=0.0)
    found = sim.body(0).shape
    assert isinstance(found, t2.Polygon)
    np.testing.assert_allclose(found.vertices, polygon.vertices, rtol=0.0, atol=1e-15)
    whole = sim.body(1).shape
    assert isinstance(whole, t2.Compound)
    assert whole.inertia(2.0) == pytest.approx(compound.inertia(2.0), rel=1e-12)
    assert whole.bounding_radius == pytest.approx(compound.bounding_radius, rel=1e-12)


@pytest.mark.parametrize(
    "shape",
    [
        t2.HalfPlane(normal=(0.6, 0.8), offset=0.5),
        t2.Chain(vertices=[(0.0, 0.0), (1.0, 0.3), (2.0, 0.0)], one_sided=True),
        t2.Chain(vertices=[(0.0, 0.0), (2.0, 0.0), (1.0, 1.5)], loop=True),
    ],
    ids=repr,
)
def test_ground_is_what_was_added_also_where_rows_are_taken_again(shape: t2.Chain) -> None:
    sim = empty()
    old = sim.add_static(
        t2.Chain(vertices=[(0.0, 0.0), (1.0, 1.0), (2.0, 0.0), (3.0, 1.0)]), friction=0.5
    )
    sim.remove(old)
    sim.step()
    body = sim.body(sim.add_static(shape, friction=0.5))
    assert (body.shape, body.static, body.friction) == (shape, True, 0.5)
