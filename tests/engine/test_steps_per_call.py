"""How many steps one call of compiled code takes."""

import tamias2d as t2
from tamias2d import Simulator


def test_calls_that_end_early_do_not_make_later_ones_longer() -> None:
    scene = t2.Scene(gravity=(0.0, -10.0))
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), restitution=1.0)
    scene.add_body(t2.Disc(radius=0.5), mass=1.0, position=(0.0, 100.0), restitution=1.0)
    for k in range(8):  # of so many shapes not all pairs are listed
        post = t2.Disc(radius=0.1)
        scene.add_static(post, position=(1e3 + k, -9.0), restitution=1.0)
    sim = Simulator(scene)
    sim.step(20_000)  # tens of bounces: the disc is alone after each, which ends a call
    most = 2 * 1000  # no flight and no stay near the ground is longer than 1000 steps
    assert sim._engine._steps_per_call.most < most
    assert sim._engine._ballistic_steps_per_call.most < most
