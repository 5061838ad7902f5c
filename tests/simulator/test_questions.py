"""Rays, points and boxes against all shapes, one by one, in NumPy."""

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import tamias2d as t2
from tamias2d.scene.compound import pieces_of
from tests.simulator.crowd import crowd

SAME = 1e-9  # m, of places of about 10 m, along rays that are never nearly parallel to a side


def outline(body: t2.Body, place: np.ndarray, angle: float) -> list[tuple[np.ndarray, float]]:
    """The pieces of a body in the world: corners and what lies around them."""
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    return [
        (place + np.array(piece.core) @ turn.T, piece.shape.rounding)
        for piece in pieces_of(body.shape)
    ]


def distance(corners: np.ndarray, points: np.ndarray) -> np.ndarray:
    """Of points to a convex shape without rounding; 0 inside it."""
    ends = np.roll(corners, -1, axis=0)
    found = np.full(len(points), np.inf)
    inside = np.full(len(points), len(corners) > 2)
    for start, end in zip(corners, ends, strict=True):
        along = end - start
        size = along @ along
        share = np.clip((points - start) @ along / size, 0, 1) if size else np.zeros(len(points))
        gap = points - start - share[:, None] * along
        found = np.minimum(found, np.hypot(*gap.T))
        inside &= along[0] * (points - start)[:, 1] - along[1] * (points - start)[:, 0] >= 0
    return np.where(inside, 0.0, found)


def separation(scene: t2.Scene, sim: t2.Simulator, points: np.ndarray) -> np.ndarray:
    """Of points to each solid body (n, k); not positive within it."""
    rows = []
    for k, body in enumerate(scene.bodies):
        if isinstance(body.shape, t2.HalfPlane):
            rows.append(points @ np.array(body.shape.normal) - body.shape.offset)
        else:
            pieces = outline(body, sim.position[k], sim.orientation[k])
            rows.append(np.min([distance(c, points) - r for c, r in pieces], axis=0))
    return np.array(rows)


@pytest.fixture(scope="module")
def crowded() -> tuple[t2.Scene, t2.Simulator]:
    scene = crowd(60, seed=3)
    return scene, t2.Simulator(scene)


@settings(max_examples=60)
@given(st.integers(0, 2**32 - 1))
def test_a_ray_ends_on_the_surface_that_it_meets_first(
    crowded: tuple[t2.Scene, t2.Simulator], seed: int
) -> None:
    scene, sim = crowded
    chance = np.random.default_rng(seed)
    start, end = chance.uniform(-9, 9, (2, 2))
    hit = sim.ray_cast(start, end)
    path = start + np.linspace(0, 1, 4001)[:, None] * (end - start)
    gaps = separation(scene, sim, path)
    gaps[gaps[:, 0] <= 0] = np.inf  # what it starts in is not met
    met = (gaps <= -1e-6).any(axis=0)
    first = np.argmax(met) / 4000 if met.any() else 1.0
    assert hit.fraction[0] <= first + SAME
    earlier = np.linspace(0, 1, 4001) < hit.fraction[0] - SAME
    assert (gaps[:, earlier] > -SAME).all()
    body = int(hit.body[0])
    if body >= 0:
        assert abs(separation(scene, sim, hit.point)[body, 0]) < SAME
        assert np.hypot(*hit.normal[0]) == pytest.approx(1.0, abs=1e-12)
        assert hit.normal[0] @ (end - start) <= 0
    else:
        assert hit.fraction[0] == 1.0


@settings(max_examples=60)
@given(st.integers(0, 2**32 - 1))
def test_points_and_boxes_find_what_is_there(
    crowded: tuple[t2.Scene, t2.Simulator], seed: int
) -> None:
    scene, sim = crowded
    chance = np.random.default_rng(seed)
    point = chance.uniform(-11, 11, 2)
    gap = separation(scene, sim, point[None])[:, 0]
    found = set(sim.at_point(point).tolist())
    assert found == set(np.flatnonzero(gap <= 0).tolist()) or np.abs(gap).min() < SAME
    low, high = np.sort(chance.uniform(-11, 11, (2, 2)), axis=0)
    grid = np.stack(np.meshgrid(*np.linspace(low, high, 60).T), axis=-1).reshape(-1, 2)
    least = separation(scene, sim, grid).min(axis=1)
    cell = np.hypot(*(high - low) / 59) / 2  # nothing is farther from a point of the grid
    found = set(sim.in_box(low, high).tolist())
    assert found >= set(np.flatnonzero(least < 0).tolist())
    assert found <= set(np.flatnonzero(least <= cell + SAME).tolist())


def test_all_at_once_is_one_by_one() -> None:
    sim = t2.Simulator(crowd(40, seed=5))
    start, end = np.random.default_rng(1).uniform(-9, 9, (2, 50, 2))
    many = sim.ray_cast(start, end)
    for k in range(50):
        one = sim.ray_cast(start[k], end[k])
        assert (one.body[0], one.fraction[0]) == (many.body[k], many.fraction[k])
    assert len(set(many.body.tolist())) > 5


def test_known_answers() -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), name="floor")
    scene.add_static(t2.Segment(length=2.0), position=(0.0, 5.0), name="shelf")
    scene.add_body(
        t2.Disc(radius=1.0), mass=1.0, position=(5.0, 3.0), category=4, name="disc", restitution=0
    )
    scene.add_body(t2.Disc(radius=1.0), mass=1.0, position=(-5.0, 3.0), sensor=True, name="zone")
    sim = t2.Simulator(scene)
    down = sim.ray_cast((0.5, 9.0), (0.5, -1.0))
    assert (down.body[0], down.point[0].tolist()) == (1, [0.5, 5.0])
    assert down.normal[0].tolist() == [0.0, 1.0]
    up = sim.ray_cast((0.5, 3.0), (0.5, 9.0))
    assert (up.body[0], up.normal[0].tolist()) == (1, [0.0, -1.0])
    through = sim.ray_cast((9.0, 3.0), (-9.0, 3.0))
    assert (through.body[0], through.point[0].tolist()) == (2, [6.0, 3.0])
    assert sim.ray_cast((5.0, 3.0), (9.0, 3.0)).body[0] == -1  # it starts within the disc
    assert sim.ray_cast((9.0, 3.0), (-9.0, 3.0), mask=1).body[0] == -1  # the zone is not solid
    assert sim.at_point((5.5, 3.0)).tolist() == [2]
    assert sim.at_point((-5.5, 3.0)).tolist() == []
    assert sim.in_box((-1.0, -1.0), (6.0, 3.0)).tolist() == [0, 2]
    assert sim.in_box((-1.0, -1.0), (6.0, 3.0), mask=4).tolist() == [2]


def aimed(sim: t2.Simulator, points: np.ndarray, eye: np.ndarray) -> np.ndarray:
    """The bodies that rays meet from places (in the axes of the first body) through its points."""
    start = sim.to_world(0, points + eye)
    return sim.ray_cast(start, 2 * sim.to_world(0, points) - start).body


def lone(shape: t2.Chain | t2.Box | t2.Polygon, chance: np.random.Generator) -> t2.Simulator:
    """A shape that stands at a random pose."""
    sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)))
    sim.add_static(shape, position=chance.uniform(-9, 9, 2), orientation=chance.uniform(-4, 4))
    return sim


@pytest.mark.parametrize("far", [1.0, 1e5])
@pytest.mark.parametrize("kind", ["hills", "steps", "loop"])
def test_no_ray_passes_between_two_segments_of_a_chain(kind: str, far: float) -> None:
    """A vertex belongs to both, and rounding decides of each alone on which side a ray is."""
    chance, met = np.random.default_rng(11), []
    for _ in range(40):
        heights = chance.uniform(-0.3, 0.3, 6)
        points = np.column_stack((0.4 * np.arange(6) - 1.0, heights))
        if kind == "steps":
            points = np.column_stack((points[:, 0].repeat(2)[1:-1], heights[:-1].repeat(2)))
        if kind == "loop":
            turn = np.arange(6) * np.pi / 3
            points = (1.0 + heights)[:, None] * np.column_stack((np.cos(turn), np.sin(turn)))
        sim = lone(t2.Chain(vertices=points, loop=kind == "loop"), chance)
        places = points if kind == "loop" else points[1:-1]
        if kind == "loop":
            slanted = places * far  # from outside towards the middle
            down = places
        else:
            down = np.broadcast_to((0.0, 2.0 * far), places.shape)
            slanted = down + chance.uniform(-0.5, 0.5, places.shape) * far
        met += [aimed(sim, places, down), aimed(sim, places, slanted)]
    assert (np.concatenate(met) == 0).all()


def test_rays_down_at_a_turned_terrain_find_it() -> None:
    chance = np.random.default_rng(3)
    points = np.column_stack((0.1 * np.arange(41) - 2.0, chance.uniform(-0.1, 0.1, 41)))
    for far in (2.0, 1e3, 1e7):
        for aside in (0.0, 1e-15, 1e-10):
            sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)))
            angle = chance.uniform(-0.5, 0.5)
            sim.add_static(
                t2.Chain(vertices=points), position=chance.uniform(-3, 3, 2), orientation=angle
            )
            ground = sim.to_world(0, points[1:-1]).repeat(5, axis=0)
            ground[:, 0] += aside * chance.uniform(-1, 1, len(ground))
            hit = sim.ray_cast(ground + np.array((0.0, far)), ground - np.array((0.0, far)))
            assert (hit.body == 0).all(), (far, aside)
            assert np.allclose(hit.point, ground, atol=1e-8 if far < 1e7 else 1e-6)


def test_rays_at_corners_through_the_middle_meet_the_body() -> None:
    chance, met = np.random.default_rng(7), []
    for _ in range(100):
        width, height = chance.uniform(0.1, 2.0, 2)
        box = np.array([(1, 1), (-1, 1), (-1, -1), (1, -1)]) * (width, height) / 2
        met.append(aimed(lone(t2.Box(width=width, height=height), chance), box, 2 * box))
        turn = np.sort(np.linspace(0, 2 * np.pi, 6)[:-1] + chance.uniform(-0.3, 0.3, 5))
        sim = lone(t2.Polygon(vertices=np.column_stack((np.cos(turn), np.sin(turn)))), chance)
        corners = np.array(sim.body(0).shape.vertices)
        met.append(aimed(sim, corners, 2 * corners))
    assert (np.concatenate(met) == 0).all()


@pytest.mark.parametrize("angle", [0.0, 0.7, 2.0, -1.3])
def test_a_ray_along_a_line_meets_its_end(angle: float) -> None:
    """As it would meet a thin box: with the normal against the ray, also if it is turned."""
    for shape in (t2.Segment(length=2.0), t2.Chain(vertices=[(1.0, 0.0), (0.3, 0.0), (-1.0, 0.0)])):
        sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)))
        way = np.array((math.cos(angle), math.sin(angle)))
        sim.add_static(shape, position=3.0 * way, orientation=angle)
        starts, ends = np.outer((0.0, 9.0, 0.0, 0.0), way), np.outer((9.0, 0.0, 1.0, -9.0), way)
        hits = sim.ray_cast(starts, ends)
        assert hits.body.tolist() == [0, 0, -1, -1]
        assert np.allclose(hits.point[:2], np.outer((2.0, 4.0), way), rtol=0, atol=1e-14)
        assert np.allclose(hits.normal[:2], np.outer((-1.0, 1.0), way), rtol=0, atol=1e-14)


@pytest.mark.parametrize("angle", [0.0, 1.1, 3.0])
def test_a_chain_that_is_one_sided_is_met_where_bodies_meet_it(angle: float) -> None:
    """From its solid side, and by what has an extent at its ends; all else passes."""
    sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)))
    roof = [(2.0, 0.0), (0.0, 1.0), (-2.0, 0.0)]
    sim.add_static(t2.Chain(vertices=roof, one_sided=True), orientation=angle)
    disc = t2.Disc(radius=0.2)

    def met(ask: Any, start: tuple[float, float], end: tuple[float, float]) -> float:
        turned = np.array((start, end)) @ [[math.cos(angle), math.sin(angle)],
                                           [-math.sin(angle), math.cos(angle)]]  # fmt: skip
        return float(ask(*turned).fraction[0])

    def cast(start: Any, end: Any) -> Any:
        return sim.shape_cast(disc, start, end)

    for x in (-1.0, 0.0, 0.01, 1.3):
        assert met(sim.ray_cast, (x, 2.0), (x, -2.0)) == pytest.approx((1 + abs(x) / 2) / 4)
        assert met(sim.ray_cast, (x, -2.0), (x, 2.0)) == 1.0
        assert met(cast, (x, 2.0), (x, -2.0)) < 0.6
        assert met(cast, (x, -2.0), (x, 2.0)) == 1.0
    assert met(sim.ray_cast, (3.0, -0.5), (0.0, 1.0)) == 1.0  # along a piece
    assert met(cast, (4.0, 0.1), (2.0, 0.1)) < 1.0  # its end is a point
    assert met(cast, (1.0, 0.6), (1.0, -2.0)) == 0.0  # half through, and deeper
    assert met(cast, (1.0, 0.4), (1.0, -2.0)) == 1.0  # more than half behind
    assert met(cast, (1.0, 0.4), (1.0, 2.0)) == 1.0
    assert sim.in_shape(disc, position=(0.0, 0.0)).tolist() == []
    below = np.array((0.0, 0.9)) @ [[math.cos(angle), math.sin(angle)],
                                    [-math.sin(angle), math.cos(angle)]]  # fmt: skip
    assert sim.in_shape(disc, position=below).tolist() == [0]  # what is there is told


def test_of_what_is_met_at_once_the_first_in_canonical_order_is_told() -> None:
    """Where two boxes meet, a ray meets both; the left one is first, by where it is."""
    for order in ((0, 1), (1, 0)):
        sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)))
        for k in order:
            box = t2.Box(width=1.0 + k, height=1.0)
            sim.add(box, mass=1.0, position=(1.5 * k - 0.5, 0.0), restitution=0.0)
        hit = sim.ray_cast((0.0, 5.0), (0.0, -5.0))
        assert sim.position[hit.body[0]].tolist() == [-0.5, 0.0]


def test_what_was_moved_is_found_where_it_is() -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    ball = scene.add_body(t2.Disc(radius=1.0), mass=1.0, position=(0.0, 0.0), restitution=0)
    sim = t2.Simulator(scene)
    assert sim.at_point((0.0, 0.5)).tolist() == [ball]
    sim.position[ball] = 100.0, 0.0
    assert sim.at_point((0.0, 0.5)).tolist() == []
    assert sim.at_point((100.0, 0.5)).tolist() == [ball]
    other = sim.add(t2.Disc(radius=1.0), mass=1.0, position=(0.0, 0.0), restitution=0)
    assert sim.at_point((0.0, 0.5)).tolist() == [other]
    sim.remove(other)
    assert sim.at_point((0.0, 0.5)).tolist() == []


@pytest.mark.parametrize(
    ("start", "end", "says"),
    [
        ((0, 0), (0, 0), r"end\[0\] of the rays: found the start"),
        ((0, np.nan), (0, 1), r"start\[0\]\[1\] of the rays: found nan"),
        ((0, 0, 0), (0, 1), "start of the rays: found an array of shape"),
        ("here", (0, 1), "start of the rays: found 'here'"),
    ],
)
def test_bad_rays_are_refused(start: object, end: object, says: str) -> None:
    sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)))
    with pytest.raises(t2.InputError, match=says):
        sim.ray_cast(start, end)
    assert sim.ray_cast((0, 0), (1, 1)).body.tolist() == [-1]


@pytest.mark.parametrize("ask", ["ray", "point"])
def test_a_body_that_is_nowhere_cannot_be_asked_for(ask: str) -> None:
    sim = t2.Simulator(crowd(5, seed=0))
    sim.in_box((0.0, 0.0), (1.0, 1.0))
    sim.position[3, 1] = np.nan
    with pytest.raises(t2.InputError, match=r"position or orientation\[3\]: must be finite"):
        sim.ray_cast((0.0, 0.0), (1.0, 0.0)) if ask == "ray" else sim.at_point((0.0, 0.0))


def gap(one: np.ndarray, other: np.ndarray) -> float:
    """Between two convex shapes without rounding, by their sides at many points; 0 if they meet."""
    share = np.linspace(0, 1, 400)[:, None]
    points = np.concatenate(
        [a + share * (b - a) for a, b in zip(other, np.roll(other, -1, axis=0), strict=True)]
    )
    return float(distance(one, points).min())


@settings(max_examples=60)
@given(st.integers(0, 2**32 - 1))
def test_bodies_in_a_shape_are_those_that_come_near_enough(
    crowded: tuple[t2.Scene, t2.Simulator], seed: int
) -> None:
    scene, sim = crowded
    chance = np.random.default_rng(seed)
    size = chance.uniform(0.05, 2.0)
    corners = [(0.0, 0.0), (size, 0.1), (0.3, size)]
    shape: object = [
        t2.Disc(radius=size),
        t2.Box(width=size, height=0.3),
        t2.Capsule(length=size, radius=0.1),
        t2.Polygon(vertices=corners),
        t2.Segment(length=size),
        t2.Compound(
            parts=[t2.Part(shape=t2.Disc(radius=0.2)),
                   t2.Part(shape=t2.Box(width=0.2, height=0.4), position=(size, 0.0))]
        ),
    ][seed % 6]  # fmt: skip
    place, angle = chance.uniform(-9, 9, 2), chance.uniform(-4, 4)
    asked = t2.Scene(gravity=(0.0, 0.0))
    asked.add_body(shape, mass=1.0, position=place, orientation=angle, restitution=0.0)  # type: ignore[arg-type]
    pieces = outline(asked.bodies[0], place, angle)
    found = set(sim.in_shape(shape, position=place, orientation=angle).tolist())  # type: ignore[arg-type]
    for k, body in enumerate(scene.bodies):
        if isinstance(body.shape, t2.HalfPlane):
            apart = min(
                (core @ np.array(body.shape.normal)).min() - body.shape.offset - r
                for core, r in pieces
            )
        else:
            apart = min(
                min(gap(core, other), gap(other, core)) - r - s
                for core, r in pieces
                for other, s in outline(body, sim.position[k], sim.orientation[k])
            )
        if abs(apart) > 0.02 and not body.sensor:  # of which the points on sides can tell
            assert (k in found) == (apart < 0), (k, apart)


def test_a_shape_that_is_asked_for_touches_what_is_just_there() -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(t2.Box(width=2.0, height=2.0), mass=1.0, position=(3.0, 0.0), restitution=0.0)
    scene.add_static(t2.Disc(radius=0.5), position=(0.0, 4.0), restitution=0.0, category=2)
    sim = t2.Simulator(scene)
    disc = t2.Disc(radius=2.0)
    assert sim.in_shape(disc, position=(0.0, 0.0)).tolist() == [0]
    assert sim.in_shape(disc, position=(-1e-9, 0.0)).tolist() == []
    assert sim.in_shape(disc, position=(0.0, 1.5)).tolist() == [1]
    assert sorted(sim.in_shape(t2.Disc(radius=9.0), position=(0.0, 0.0)).tolist()) == [0, 1]
    assert sim.in_shape(t2.Disc(radius=9.0), position=(0.0, 0.0), mask=2).tolist() == [1]
    assert sim.in_shape(t2.Disc(radius=0.1), position=(3.0, 0.0)).tolist() == [0]
    sim.position[0] = (30.0, 0.0)
    assert sim.in_shape(disc, position=(0.0, 0.0)).tolist() == []


@pytest.mark.parametrize(
    ("shape", "given", "says"),
    [
        (t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), {}, r"shape of the question: .*bounded"),
        (None, {}, r"shape of the question: found None"),
        (t2.Disc(radius=1.0), {"position": (np.nan, 0.0)}, "position"),
        (t2.Disc(radius=1.0), {"orientation": "up"}, "orientation"),
        (t2.Disc(radius=1.0), {"mask": 1.5}, "mask"),
    ],
)
def test_a_shape_that_cannot_be_asked_for_is_refused(
    crowded: tuple[t2.Scene, t2.Simulator], shape: object, given: dict[str, object], says: str
) -> None:
    asked: dict[str, object] = {"position": (0.0, 0.0), **given}
    with pytest.raises(t2.InputError, match=says):
        crowded[1].in_shape(shape, **asked)  # type: ignore[arg-type]
