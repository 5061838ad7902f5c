"""A block's contacts one by one, and all its lanes at once: the same bits."""

import pytest

import tamias2d as t2
from tamias2d import Simulator
from tamias2d.engine.solver import lanes


def digest(box: bool) -> str:
    """Step a small pile that lands, rubs and bounces, in plain Python; return what became of it."""
    scene = t2.Scene(gravity=(0.3, -9.81))
    floor = t2.HalfPlane(normal=(0.0, 1.0), offset=0.0)
    scene.add_static(floor, restitution=0.5, friction=0.5)
    for k in range(4):
        shape: t2.Shape = t2.Box(width=0.3, height=0.3) if box else t2.Disc(radius=0.15)
        place = (0.04 * k, 0.16 + 0.31 * k)
        scene.add_body(shape, mass=1.0 + k, position=place, restitution=0.3 * (k % 2), friction=0.5)
    sim = Simulator(scene, time_step=1 / 60, compiled=False)
    sim.step(40)
    assert len(sim.contacts.impulse) > 1
    return sim.digest()


@pytest.mark.parametrize("box", [False, True])
def test_contacts_one_by_one_have_the_bits_of_all_lanes(
    box: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    found = set()
    for few in (0, 2, 16):
        monkeypatch.setattr(lanes, "FEW_LANES", few)
        found.add(digest(box))
    assert len(found) == 1
