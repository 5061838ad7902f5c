"""What drag does stands once for all bodies with the same rates, and only while one has them."""

import pickle

import numpy as np

import tamias2d as t2
from tamias2d.simulator import Simulator


def space() -> Simulator:
    return Simulator(t2.Scene(gravity=(0.0, 0.0)), time_step=0.1)


def add(sim: Simulator, drag: float, place: float) -> int:
    return sim.add(
        t2.Disc(radius=0.1), mass=1.0, position=(place, 0.0), velocity=(0.0, 1.0),
        linear_drag=drag, friction=0.0, restitution=0.0,
    )  # fmt: skip


def test_each_body_slows_at_its_own_rate() -> None:
    """One after the other with other rates, and some of them alike: v = exp(-c t / m)."""
    sim = space()
    drags = [0.0, 0.5, 2.0, 0.5, 0.0, 0.125, 2.0]
    for k, drag in enumerate(drags):
        add(sim, drag, float(k))
        sim.step()
    sim.velocity[:] = (0.0, 1.0)
    sim.step(30)
    np.testing.assert_allclose(sim.velocity[:, 1], np.exp(-3.0 * np.array(drags)), rtol=1e-12)
    assert len(sim._engine.world.bodies.propagators) == 4  # of 0, 0.5, 2 and 0.125


def test_what_nobody_has_is_given_up() -> None:
    """Bodies that come and go, each with a drag of its own, leave nothing behind."""
    sim = space()
    stays = add(sim, 0.75, -1.0)
    for k in range(40):
        goes = add(sim, 1.0 + k, 1.0)
        sim.step()
        sim.remove(goes)
    sim.step()
    assert len(sim._engine.world.bodies.propagators) == len(sim._engine.world.state.drag_rates) <= 6
    sim.velocity[stays] = (0.0, 1.0)
    sim.step(10)
    np.testing.assert_allclose(sim.velocity[stays, 1], np.exp(-0.75), rtol=1e-12)


def test_a_restored_simulator_knows_the_rates() -> None:
    sim = space()
    add(sim, 0.5, 0.0)
    sim.step()
    again = pickle.loads(pickle.dumps(sim))
    for one in (sim, again):
        add(one, 0.5, 1.0)
        add(one, 0.25, 2.0)
        one.step(5)
    assert len(again._engine.world.bodies.propagators) == 3
    assert again.velocity.tobytes() == sim.velocity.tobytes()
