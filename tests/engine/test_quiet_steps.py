"""Quiet steps leave what ordinary steps leave: the same bits, and the same contacts, ever after."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.engine import step as engine_step, tables as tb
from tamias2d.engine.motion.quiet import take_quiet_steps
from tamias2d.engine.tables import World
from tamias2d.simulator import Simulator

pytestmark = pytest.mark.filterwarnings("ignore::tamias2d.StepWarning")  # bodies start overlapping

LEGS = (6, 1, 1, 7, 1, 1, 6, 1, 7, *[1] * 16)  # steps, one after the other
PUSH = (0.01, 0.0)  # N; a disc that nothing pushes takes hard steps
SHAPES = (t2.Disc(radius=0.2), t2.Box(width=0.5, height=0.25), t2.Capsule(length=0.3, radius=0.1))


@contextmanager
def ordinary() -> Iterator[None]:
    """Let plain steps be no quiet ones within this."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(engine_step, "may_be_quiet", lambda _: False)
        yield


def world(seed: int) -> t2.Scene:
    """A few bodies of all kinds in a wide box; some are filtered, and some only sense."""
    random = np.random.default_rng(seed)
    scene = t2.Scene(gravity=(0.0, random.choice((0.0, -9.81))), name=f"world{seed}")
    rough, sides = float(random.choice((0.0, 0.4))), ((0, 1, 0.0), (1, 0, 0.0), (-1, 0, -8.0))
    for x, y, offset in sides:
        scene.add_static(t2.HalfPlane(normal=(x, y), offset=offset), restitution=0.9,
                         friction=rough)  # fmt: skip
    if seed % 3 == 0:
        scene.add_static(SHAPES[1], position=(2.5, 1.5), orientation=0.4, restitution=0.3,
                         friction=rough)  # fmt: skip
    if seed % 4 == 1:
        scene.add_kinematic(SHAPES[1], position=(1.0, 0.6), angular_velocity=3.0,
                            velocity=(0.4, 0.0), restitution=0.8, friction=rough)  # fmt: skip
    if seed % 5 == 2:
        points = [(0.0, 1.0), (1.0, 0.6), (2.5, 0.9)]
        scene.add_static(t2.Chain(vertices=points), restitution=0.5, friction=rough)
    kinds = 1 if seed % 2 else 3  # discs alone, or all
    for k in range(int(random.integers(1, 5))):
        scene.add_body(
            SHAPES[k % kinds], mass=1.0 + k, position=random.uniform((0.4, 0.4), (7.6, 3.0)),
            velocity=random.normal(0.0, 5.0, 2), angular_velocity=random.normal(0.0, 4.0),
            restitution=float(random.choice((0.0, 0.5, 1.0))), friction=rough,
            linear_drag=0.2 * (k == 1), force=random.normal(0.0, 0.5, 2),
            mask=0xFFFF if seed % 7 else 0xFFFD, category=1 + k % 2,
            sensor=seed % 8 == 3 and k == 0, name=f"free{k}",
        )  # fmt: skip
    return scene


def disturb(sim: Simulator, leg: int, random: np.random.Generator) -> None:
    """Do between steps what users do: push, move, add and remove."""
    kind = sim._engine.kind
    if leg == 3:
        sim.add(SHAPES[0], mass=0.5, position=random.uniform((0.5, 3.0), (4.5, 5.0)),
                restitution=0.7, friction=0.1)  # fmt: skip
    moving = np.flatnonzero(kind == tb.DYNAMIC)
    if leg % 2 and len(moving):
        k = int(random.choice(moving))
        sim.velocity[k] += random.normal(0.0, 2.0, 2)
        sim.force[k] = random.normal(0.0, 2.0, 2)
        sim.apply_force(k, random.normal(0.0, 5.0, 2))
    if leg == 6:
        sim.position[0] += (0.0, 0.1)  # the floor
        sim.orientation[np.flatnonzero(kind == tb.STATIC)[3:]] += 0.7
    if leg == 8:
        sim.orientation[0] = random.uniform(-0.3, 0.3)
    if leg == 7 and len(moving) > 1:
        sim.remove(int(moving[-1]))


def told(sim: Simulator) -> list[bytes]:
    """Return all that users can see of the last step."""
    found, began = sim.contacts, sim.began
    values = (sim.position, sim.orientation, sim.velocity, sim.angular_velocity, sim.ended)
    contacts = (found.bodies, found.point, found.normal, found.impulse, found.separation)
    return [np.array(v).tobytes() for v in (*values, *contacts, began.bodies, began.impulse)]


def followed(sim: Simulator, seed: int, path: Path | None = None) -> Iterator[list[bytes]]:
    """Yield what is seen leg by leg; with a path, it is saved and restored on the way."""
    random = np.random.default_rng(1000 + seed)
    for leg, steps in enumerate(LEGS):
        disturb(sim, leg, random)
        sim.step(steps)
        if path is not None and leg in (2, 5):
            sim.save(path)
            sim = Simulator.restore(path, compiled=False)
        yield told(sim)


@pytest.mark.parametrize("seed", range(16))
def test_quiet_steps_have_the_bits_of_ordinary_ones(seed: int, tmp_path: Path) -> None:
    settings: dict[str, Any] = {"sleeping": seed % 6 == 5, "time_step": 1 / 60}
    quick = list(followed(Simulator(world(seed), **settings), seed))
    with ordinary():
        slow = list(followed(Simulator(world(seed), compiled=False, **settings), seed))
    assert quick == slow
    restored = Simulator(world(seed), compiled=False, **settings)
    assert list(followed(restored, seed, tmp_path / "some.npz")) == slow


def dropped_again() -> Iterator[list[bytes]]:
    """Lift a disc off its floor into the margin within which points are sought, and throw it up."""
    scene = t2.Scene(gravity=(0.0, -9.81))
    surface: dict[str, Any] = {"restitution": 0.0, "friction": 0.5}
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **surface)
    scene.add_body(t2.Disc(radius=0.3), mass=1.0, position=(0.0, 0.3), force=PUSH, **surface)
    sim = Simulator(scene, compiled=False)
    sim.step(10)
    sim.position[1, 1] += 0.045
    sim.velocity[1] = 1.0, 2.7
    for _ in range(45):
        sim.step()
        yield told(sim)


def test_a_half_plane_forgets_what_it_bore_before_a_flight() -> None:
    """Else the disc would land with the impulse under which it lay, as its only feature is back."""
    quick = list(dropped_again())
    with ordinary():
        assert list(dropped_again()) == quick


def turned_floor(angle: float) -> Iterator[list[bytes]]:
    """Turn a floor by hand under a disc that flies over it, and look on."""
    scene = t2.Scene(gravity=(0.0, -9.81))
    surface: dict[str, Any] = {"restitution": 0.0, "friction": 0.5}
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **surface)
    scene.add_body(t2.Disc(radius=0.3), mass=1.0, position=(2.0, 1.5), force=PUSH, **surface)
    sim = Simulator(scene, compiled=False)
    sim.step(3)
    sim.orientation[0] = angle
    for _ in range(20):
        sim.step()
        yield told(sim)


@pytest.mark.parametrize("angle", [0.4, -0.4])
def test_a_floor_that_was_turned_is_where_it_is(angle: float) -> None:
    quick = list(turned_floor(angle))
    with ordinary():
        assert list(turned_floor(angle)) == quick


@pytest.mark.parametrize(("discs", "least"), [(1, 0.8), (2, 0.6), (4, 0.2)])
def test_discs_in_a_wide_box_take_quiet_steps(
    discs: int, least: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    taken = []

    def counted(state: World) -> bool:
        before = int(state.control.counts[tb.STEPS_LEFT])
        valid = take_quiet_steps(state)
        taken.append(before - int(state.control.counts[tb.STEPS_LEFT]))
        return valid

    monkeypatch.setattr(engine_step, "take_quiet_steps", counted)
    scene = t2.Scene(gravity=(0.0, -9.81))
    for x, y, offset in ((0, 1, 0.0), (1, 0, 0.0), (-1, 0, -6.0)):
        scene.add_static(t2.HalfPlane(normal=(x, y), offset=offset), restitution=1.0, friction=0.0)
    for k in range(discs):
        scene.add_body(t2.Disc(radius=0.15), mass=1.0, position=(0.5 + k, 1.0 + 0.5 * k),
                       velocity=(1.5 - k, 0.5), restitution=1.0, friction=0.0,
                       linear_drag=1e-3)  # fmt: skip
    sim = Simulator(scene, compiled=False)  # without drag, steps are those of hard discs
    sim.step(60)
    assert sum(taken) > least * 60
