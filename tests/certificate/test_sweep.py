"""Boxes that are swept find every pair that comes near, in crowds too."""

from dataclasses import replace

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.solve import sampler
from tamias2d.study import penetration
from tamias2d.study.penetration import penetrations
from tamias2d.study.separation import hulls_of
from tamias2d.study.sweep import beside, meeting, standing_box, swept_boxes


def boxes(seed: int) -> tuple[np.ndarray, np.ndarray]:
    random = np.random.default_rng(seed)
    low = random.uniform(0, 10, (30, 7, 2))
    return low, low + random.exponential(1.0, low.shape)


@pytest.mark.parametrize("seed", range(5))
def test_pairs_of_boxes_are_those_of_a_search_through_all(seed: int) -> None:
    low, high = boxes(seed)
    low[3, 2], high[3, 2] = low[5, 2], high[5, 2]  # equal ones meet
    low[8, 0] = high[9, 0]  # those that touch meet
    high[8, 0] = low[8, 0] + 1.0
    found = meeting(low, high)
    for a in range(30):
        for b in range(a + 1, 30):
            meet = ((low[a] <= high[b]) & (low[b] <= high[a])).all(axis=-1)
            assert (found[a, b] == meet).all() if meet.any() else (a, b) not in found


def test_a_box_holds_the_parabola_between_its_marks() -> None:
    """Thrown up and caught again: at both ends it is at the same height."""
    times = np.linspace(0.0, 2.0, 5)
    place = np.stack((0 * times, 9.81 * times - 9.81 * times**2 / 2), axis=1)
    speed = np.stack((0 * times, 9.81 - 9.81 * times), axis=1)
    low, high = swept_boxes(np.array([0.0, 2.0]), times, place, speed, 0.1)
    assert high[0, 1] >= 9.81 / 2 + 0.1
    assert low[0, 1] <= -0.1


def test_a_half_plane_is_reached_from_its_side() -> None:
    low, high = np.array([[[0.0, 1.0]], [[0.0, -1.0]]]), np.array([[[1.0, 2.0]], [[1.0, 2.0]]])
    floor = t2.HalfPlane(normal=(0.0, 1.0), offset=0.0)
    assert beside(floor, low, high).tolist() == [[False], [True]]


def test_a_body_that_stands_is_in_its_box() -> None:
    scene = t2.Scene(gravity=(0, 0))
    scene.add_static(t2.Box(width=2, height=0.2), position=(1, 2), orientation=np.pi / 2)
    low, high = standing_box(scene.bodies[0], hulls_of(0, scene.bodies[0]))
    np.testing.assert_allclose(low, [[0.9, 1.0]])
    np.testing.assert_allclose(high, [[1.1, 3.0]])


def gas(side: int) -> t2.Scene:
    """Discs on a grid, which go in all directions between four walls."""
    random = np.random.default_rng(side)
    scene = t2.Scene(gravity=(0, 0))
    for k in range(side**2):
        scene.add_body(
            t2.Disc(radius=0.1),
            mass=1.0,
            position=(0.5 * (k % side) + 0.25, 0.5 * (k // side) + 0.25),
            velocity=tuple(random.normal(size=2)),
            restitution=1.0,
        )
    for axis in ((1, 0), (0, 1)):
        for sign, offset in ((1, 0.0), (-1, -0.5 * side)):
            normal = (sign * axis[0], sign * axis[1])
            scene.add_static(t2.HalfPlane(normal=normal, offset=offset), restitution=1.0)
    return scene


def test_a_crowd_with_an_exact_bound_was_looked_at(monkeypatch: pytest.MonkeyPatch) -> None:
    scene = gas(11)
    run = t2.simulate(scene, duration=0.4)
    assert len(run.impacts) > 20
    certificate = t2.certify(run).certificate
    assert certificate is not None
    assert certificate.kind == "exact"
    assert not any("so many" in said for said in certificate.does_not_claim)
    sample = sampler(run)

    def through(times, bodies):
        """The first disc goes to the place of the second one."""
        history = sample(times, bodies)
        place = history.position.copy()
        for column, body in enumerate(bodies):
            if body == 0:
                place[:, column, 0] += 0.5 * times / run.duration
        return history._replace(position=place)

    monkeypatch.setattr(penetration, "sampler", lambda _: through)
    assert any(0 in found.bodies for found in penetrations(run))
    certificate = t2.certify(replace(run, certificate=None)).certificate
    assert certificate is not None
    assert (certificate.kind, certificate.bound) == ("none", None)
