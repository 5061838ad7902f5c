"""Located contacts with chains: a straight one is a half-plane; its corners are corners (IM16)."""

import math
from typing import Any

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.contact import UndecidedContactError

LEAN = 0.25
ALONG, UP = (math.cos(LEAN), math.sin(LEAN)), (-math.sin(LEAN), math.cos(LEAN))
FLOOR = t2.HalfPlane(normal=UP, offset=0.0)
STEPS = [t * 0.37 for t in range(15, -16, -1)]
CHAIN = t2.Chain(vertices=[(s * ALONG[0], s * ALONG[1]) for s in STEPS], one_sided=True)


def final(ground: Any, shape: Any, *, height: float, friction: float, **more: Any) -> t2.Run:
    scene = t2.Scene(gravity=(0.0, -9.81))
    surface: Any = {"friction": friction, "restitution": 0.5}
    scene.add_static(ground, name="ground", **surface)
    at = (0.11 * ALONG[0] + height * UP[0], 0.11 * ALONG[1] + height * UP[1])
    scene.add_body(shape, mass=1.0, position=at, name="body", **surface, **more)
    return t2.simulate(scene, duration=1.0, method=t2.ClosedForm())


@pytest.mark.parametrize(
    ("shape", "height", "friction", "more"),
    [
        (t2.Disc(radius=0.2), 0.2, 0.0, {"velocity": ALONG}),
        (t2.Disc(radius=0.2), 0.2, 0.4, {"velocity": ALONG}),
        (t2.Disc(radius=0.2), 0.9, 0.3, {"velocity": (1.0, 0.0), "angular_velocity": 3.0}),
        (t2.Box(width=0.5, height=0.3), 0.15, 0.0, {"velocity": ALONG, "orientation": LEAN}),
    ],
    ids=["disc slides", "disc rolls", "disc bounces", "box slides"],
)
def test_a_straight_chain_is_a_half_plane(
    shape: Any, height: float, friction: float, more: Any
) -> None:
    one, other = (
        final(ground, shape, height=height, friction=friction, **more) for ground in (CHAIN, FLOOR)
    )
    assert len(one.impacts) == len(other.impacts)
    assert one.impacts.time == pytest.approx(other.impacts.time, abs=1e-12)
    assert set(map(tuple, one.impacts.bodies.tolist())) <= {(0, 1), (1, 0)}
    for each in ("position", "velocity", "orientation", "angular_velocity"):
        got, expected = getattr(one, each)[-1], getattr(other, each)[-1]
        assert np.ravel(got) == pytest.approx(np.ravel(expected), abs=2e-10), each
    assert sum("stay in contact" in note for note in one.notes) == sum(
        "stay in contact" in note for note in other.notes
    )


def test_a_disc_leaves_a_corner_that_sticks_out_as_a_projectile() -> None:
    scene = t2.Scene(gravity=(0.0, -9.81))
    ledge = t2.Chain(vertices=[(5.0, 0.0), (1.0, 0.0), (0.0, 0.0), (0.0, -9.0)])
    scene.add_static(ledge, friction=0.0, restitution=0.0)
    disc = t2.Disc(radius=0.2)
    scene.add_body(disc, mass=1.0, position=(1.5, 0.2), velocity=(-2.0, 0.0), friction=0.0)
    run = t2.simulate(scene, duration=1.25, method=t2.ClosedForm())
    # faster than sqrt(g r), it flies off the last vertex at once
    assert run.position[-1, 1] == pytest.approx((-1.0, 0.2 - 9.81 / 2 * 0.25), abs=1e-9)


def test_a_chain_that_is_passed_from_behind_is_refused() -> None:
    level = [(2.0, 0.0), (0.0, 0.0), (-2.0, 0.0)]
    behind = t2.Scene(gravity=(0.0, 0.0))
    behind.add_static(t2.Chain(vertices=level, one_sided=True), restitution=0.5, name="ground")
    behind.add_body(t2.Disc(radius=0.2), mass=1.0, position=(0.3, -1.0), velocity=(0.0, 2.0))
    with pytest.raises(UndecidedContactError, match="solid from one side"):
        t2.simulate(behind, duration=1.0, method=t2.ClosedForm())
