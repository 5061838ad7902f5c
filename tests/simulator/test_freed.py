"""A simulator is freed, with its arrays, as its last user lets go of it, without the collector."""

import gc
import weakref
from collections.abc import Iterator

import pytest

import tamias2d as t2


@pytest.fixture(autouse=True)
def _without_collector() -> Iterator[None]:
    gc.disable()
    yield
    gc.enable()


@pytest.mark.parametrize(
    "name", ["bouncing-disc", "spring-chain", "quadratic-drag", "pendulum-a01"]
)
def test_a_simulator_is_freed_at_once(name: str) -> None:
    sim = t2.Simulator(t2.catalogue.load(name))
    sim.step()
    added = sim.add(t2.Disc(radius=0.1), mass=1.0, position=(50.0, 50.0), restitution=0, friction=0)
    sim.step()
    sim.remove(added)
    sim.step()
    sim.ray_cast((-100.0, 0.5), (100.0, 0.5))
    sim.restore_state(sim.copy_state())
    parts = [weakref.ref(part) for part in (sim, sim._engine, sim._engine.queries)]
    del sim
    assert [part() for part in parts] == [None, None, None]


def test_what_was_looked_at_outlives_its_simulator() -> None:
    sim = t2.Simulator(t2.catalogue.load("bouncing-disc"))
    position = sim.position
    before = position.copy()
    del sim
    assert (position == before).all()


def test_many_simulators_are_freed_at_once() -> None:
    sims = t2.Simulators(t2.catalogue.load("bouncing-disc"), worlds=3)
    sims.step()
    parts = [weakref.ref(sims), *(weakref.ref(sim._engine) for sim in sims._sims)]
    del sims
    assert [part() for part in parts] == [None] * 4
