"""All engines are told the same scene: places, masses, surfaces; no time is looked at."""

import math

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.study.engines.box2d import Box2D
from tamias2d.study.engines.chipmunk import Chipmunk
from tamias2d.study.engines.own import Own
from tamias2d.study.engines.refusal import PeerError

DT = 1 / 60
SINGLE = 1e-6  # Box2D computes in single precision
ENGINES = [Own, Chipmunk, Box2D]
PEERS = [Chipmunk, Box2D]


def zoo():
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=-50.0), restitution=0.0)
    ell = t2.Compound(
        parts=[
            t2.Part(shape=t2.Box(width=2.0, height=0.5), position=(0.0, 0.0)),
            t2.Part(shape=t2.Capsule(length=1.0, radius=0.2), position=(1.0, 1.0), orientation=1.0),
        ]
    )
    triangle = t2.Polygon(vertices=[(0.0, 0.0), (1.0, 0.0), (0.2, 0.7)])
    shapes = [t2.Disc(radius=0.3), t2.Box(width=1.0, height=0.5), triangle, ell]
    shapes += [t2.Capsule(length=1.0, radius=0.25)]
    for k, shape in enumerate(shapes):
        scene.add_body(
            shape, mass=1.0 + k, position=(5.0 * k, 1.0 - k), velocity=(0.5, k),
            orientation=0.3 * k, angular_velocity=0.1 * k, restitution=0.0,
        )  # fmt: skip
    scene.add_static(
        t2.Segment(length=3.0), position=(-7.0, -7.0), orientation=0.5, restitution=0.0
    )
    scene.add_kinematic(
        ell, position=(-20.0, 0.0), velocity=(-1.0, 2.0), angular_velocity=0.25, restitution=0.0
    )
    return scene


@pytest.mark.parametrize("engine", ENGINES)
def test_all_start_where_the_scene_says(engine):
    scene = zoo()
    told = np.array(
        [(*b.position, b.orientation, *b.velocity, b.angular_velocity) for b in scene.bodies]
    )
    assert engine(scene, DT).state() == pytest.approx(told, rel=SINGLE, abs=SINGLE)


@pytest.mark.parametrize("engine", ENGINES)
def test_all_fly_alike_and_what_is_driven_keeps_going(engine):
    scene = zoo()
    world = engine(scene, DT)
    for _ in range(60):
        world.step()
    state = world.state()
    for k, body in enumerate(scene.bodies):
        x, y = np.add(body.position, body.velocity)
        reached = (x, y, body.orientation + body.angular_velocity)
        assert state[k, :3] == pytest.approx(reached, abs=1e-4), body.name  # 60 single steps


@pytest.mark.parametrize("engine", PEERS)
def test_masses_and_inertias_are_those_of_the_scene(engine):
    scene = zoo()
    masses = engine(scene, DT).masses()
    for row, body in zip(masses, scene.bodies, strict=True):
        if body.dynamic:
            assert row == pytest.approx((body.mass, body.inertia), rel=SINGLE)


@pytest.mark.parametrize("engine", ENGINES)
def test_all_read_back_what_moves(engine):
    scene = zoo()
    world = engine(scene, DT)
    read = {(round(x, 3), round(y, 3)) for x, y in world.read().tolist()}
    for body in scene.bodies:
        if body.dynamic:
            assert tuple(round(value, 3) for value in body.position) in read


@pytest.mark.parametrize("engine", ENGINES)
def test_a_pair_rubs_by_the_root_of_the_product(engine):
    """A box of 2 m/s that slides to rest: v^2/(2 mu g) with mu = sqrt(0.9 * 0.4) = 0.6."""
    scene = t2.Scene(gravity=(0.0, -10.0))
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), friction=0.9, restitution=0.0)
    box = t2.Box(width=1.0, height=0.2)
    scene.add_body(
        box, mass=1.0, position=(0.0, 0.1), velocity=(2.0, 0.0), friction=0.4, restitution=0.0
    )
    world = engine(scene, DT)
    for _ in range(120):
        world.step()
    # a step more or less of 1/60 s at 2 m/s, and how the box settles
    assert world.state()[1, 0] == pytest.approx(4.0 / 12.0, abs=0.04)


@pytest.mark.parametrize("engine", ENGINES)
def test_discs_part_by_the_restitution_of_the_scene(engine):
    scene = t2.Scene(gravity=(0.0, 0.0))
    for x in (-2.0, 2.0):
        scene.add_body(
            t2.Disc(radius=0.5), mass=1.0, position=(x, 0.0), velocity=(-2 * x, 0.0),
            friction=0.5, restitution=0.5,
        )  # fmt: skip
    world = engine(scene, DT)
    for _ in range(60):
        world.step()
    assert world.state()[:, 3] == pytest.approx((-2.0, 2.0), rel=1e-3)


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize("turn", [0.0, 0.4, 2.0, -1.0])
def test_a_half_plane_is_solid_on_its_own_side(engine, turn):
    normal = (math.cos(turn), math.sin(turn))
    scene = t2.Scene(gravity=(-10.0 * normal[0], -10.0 * normal[1]))
    scene.add_static(t2.HalfPlane(normal=normal, offset=3.0), friction=0.5, restitution=0.0)
    disc, start = t2.Disc(radius=0.5), (4.0 * normal[0], 4.0 * normal[1])
    scene.add_body(disc, mass=1.0, position=start, friction=0.5, restitution=0.0)
    world = engine(scene, DT)
    for _ in range(120):
        world.step()
    assert np.dot(world.state()[1, :2], normal) == pytest.approx(3.5, abs=0.01)


def test_what_no_peer_can_mix_is_refused():
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(t2.Disc(radius=0.5), mass=1.0, position=(0.0, 0.0), friction=0.5)
    scene.add_body(t2.Disc(radius=0.5), mass=1.0, position=(2.0, 0.0))
    with pytest.raises(PeerError, match="friction"):
        Box2D(scene, DT)
    scene = t2.Scene(gravity=(0.0, 0.0))
    for x, bounce in ((0.0, 0.2), (2.0, 0.9)):
        scene.add_body(t2.Disc(radius=0.5), mass=1.0, position=(x, 0.0), restitution=bounce)
    with pytest.raises(PeerError, match="restitution"):
        Chipmunk(scene, DT)
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(t2.Disc(radius=0.5), mass=1.0, position=(0.0, 1.0), friction=0.5)
    scene.add_static(t2.Box(width=2.0, height=1.0), surface_speed=1.0, friction=0.5)
    for engine in (Box2D, Chipmunk):
        with pytest.raises(PeerError, match="surfaces that run"):
            engine(scene, DT)


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize("turn", [0.0, math.pi])
def test_a_part_rubs_as_it_states(engine, turn):
    """The same with a runner of 0.4 below a body of 0.1: 0.6 there, 0.3 with its back down."""
    scene = t2.Scene(gravity=(0.0, -10.0))
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), friction=0.9, restitution=0.0)
    board = t2.Box(width=1.0, height=0.1)
    parts = [
        t2.Part(shape=board, position=(0.0, -0.05), friction=0.4),
        t2.Part(shape=board, position=(0.0, 0.05)),
    ]
    scene.add_body(
        t2.Compound(parts=parts), mass=1.0, position=(0.0, 0.1), velocity=(2.0, 0.0),
        orientation=turn, friction=0.1, restitution=0.0,
    )  # fmt: skip
    world = engine(scene, DT)
    for _ in range(120):
        world.step()
    braked = 10.0 * (0.3 if turn else 0.6)
    assert world.state()[1, 0] == pytest.approx(4.0 / (2 * braked), abs=0.05)


@pytest.mark.parametrize("engine", PEERS)
def test_parts_that_bounce_otherwise_are_refused(engine):
    scene = t2.Scene(gravity=(0.0, 0.0))
    ends = [
        t2.Part(shape=t2.Disc(radius=0.5), position=(x, 0.0), restitution=value)
        for x, value in ((-1.0, 0.5), (1.0, None))
    ]
    scene.add_body(t2.Compound(parts=ends), mass=1.0, position=(0.0, 0.0), restitution=0.0)
    with pytest.raises(PeerError, match="restitution: differs from pair to pair"):
        engine(scene, DT)
