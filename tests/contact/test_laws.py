"""Laws that every impact obeys, tried on thousands of random pairs."""

import math

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings, strategies as st

import tamias2d as t2
from tamias2d.contact import LastingContactError, UndecidedContactError
from tests.contact.meetings import Meeting, Shape, meetings, sizes, thrown


def regular(corners: int, radius: float) -> t2.Polygon:
    angles = 2 * math.pi * np.arange(corners) / corners
    return t2.Polygon(vertices=[(radius * math.cos(a), radius * math.sin(a)) for a in angles])


shapes = st.one_of(
    st.builds(lambda r: t2.Disc(radius=r), sizes),
    st.builds(lambda w, h: t2.Box(width=w, height=h), sizes, sizes),
    st.builds(regular, st.integers(3, 8), sizes),
)
bodies = thrown(shapes, st.floats(-6, 6).map(lambda power: 10.0**power))


def world_points(shape: Shape, position, angle: float) -> np.ndarray:
    c, s = math.cos(angle), math.sin(angle)
    return np.array(shape.vertices or [(0, 0)]) @ [[c, s], [-s, c]] + position


def separation(first, second) -> float:
    """Return the largest gap along the normals of all sides and the line of nearest corners."""
    (shape_a, points_a), (shape_b, points_b) = first, second
    radius = sum(shape.radius for shape in (shape_a, shape_b) if isinstance(shape, t2.Disc))
    axes = [points_b[j] - points_a[i] for i in range(len(points_a)) for j in range(len(points_b))]
    for points in (points_a, points_b):
        sides = np.roll(points, -1, axis=0) - points
        axes += [sign * np.array((y, -x)) for x, y in sides for sign in (1, -1) if len(points) > 1]
    gaps = [
        (points_b @ u).min() - (points_a @ u).max()
        for u in (axis / np.hypot(*axis) for axis in axes if np.hypot(*axis))
    ]
    return max(gaps) - radius


@settings(
    max_examples=2000, deadline=None, derandomize=True, suppress_health_check=list(HealthCheck)
)
@given(meetings(bodies, bodies, aside=1.5, speeds=st.floats(0.1, 10)), st.floats(0, 1))
def test_pairs(meeting: Meeting, restitution: float):
    """Momentum stays to rounding, energy never rises, nothing overlaps."""
    scene, reach, speed = meeting.scene(restitution=restitution), meeting.reach, meeting.speed
    mass = meeting.second.mass
    try:
        times = np.linspace(0, 3 * reach / speed, 12)
        run = t2.simulate(scene, duration=3 * reach / speed, times=times, method=t2.ClosedForm())
    except (LastingContactError, UndecidedContactError) as refusal:
        run = refusal.run  # what was computed until then obeys the laws just as well
    assert np.abs(run.momentum - run.momentum[0]).max() <= 1e-12 * mass * speed
    assert (np.diff(run.energy) <= 1e-12 * run.energy[0]).all()
    turning = run.angular_momentum - run.angular_momentum[0]
    assert np.abs(turning).max() <= 1e-12 * (
        mass * speed * 10 * reach + np.abs(run.angular_momentum[0])
    ) * (1 + len(run.impacts))
    for position, orientation in zip(run.position, run.orientation, strict=True):
        placed = [
            (shape, world_points(shape, position[i], orientation[i]))
            for i, shape in enumerate((meeting.first.shape, meeting.second.shape))
        ]
        assert separation(*placed) > -1e-11 * reach


def test_mirrored_scene_has_the_mirrored_answer():
    """X10: three discs in a symmetric V; to the bit."""
    scene = t2.Scene(gravity=(0, 0))
    disc = t2.Disc(radius=0.5)
    for side in (-1, 1):
        scene.add_body(disc, mass=2, position=(3, side * 2), velocity=(-1, 0), restitution=0.9)
        scene.add_static(t2.Box(width=1, height=1), position=(-2, side * 1.7), orientation=side)
    run = t2.simulate(scene, duration=20.0)
    assert len(run.impacts) >= 2
    assert np.array_equal(run.position[:, 0] * (1, -1), run.position[:, 2])


def test_order_of_bodies_does_not_matter():
    """Metamorphic: bodies added in another order end in the same places."""

    def ends(order: list[int]) -> np.ndarray:
        scene = t2.Scene(gravity=(0, -9.81))
        scene.add_static(t2.HalfPlane(normal=(0, 1), offset=0))
        for k in order:
            scene.add_body(
                t2.Disc(radius=0.3 + 0.05 * k),
                mass=1 + k,
                position=(1.1 * k, 1 + 0.3 * k),
                velocity=(1 - 0.7 * k, 0),
                restitution=0.9,
                name=str(k),
            )
        run = t2.simulate(scene, duration=1.5)
        assert len(run.impacts) > 4
        return run.position[-1, [scene.index(str(k)) for k in range(4)]]

    np.testing.assert_allclose(ends([0, 1, 2, 3]), ends([2, 3, 0, 1]), rtol=0, atol=1e-11)


def test_same_bits_twice():
    scene = t2.Scene(gravity=(0, -9.81))
    for normal, offset in (((1, 0), 0), ((-1, 0), -8), ((0, 1), 0)):
        scene.add_static(t2.HalfPlane(normal=normal, offset=offset))
    for k in range(6):
        scene.add_body(
            t2.Box(width=0.5, height=0.3),
            mass=1,
            position=(1 + k, 1 + k % 3),
            angular_velocity=k,
            velocity=(k - 3, 0),
            restitution=1,
        )
    first, second = (t2.simulate(scene, duration=2.0) for _ in range(2))
    assert len(first.impacts) > 20
    assert first.digest() == second.digest()
    assert first.energy == pytest.approx(first.energy[0], rel=1e-12)
