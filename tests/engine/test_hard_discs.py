"""Few discs in steps: from impact to impact, as exactly as located runs go."""

import math
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import tamias2d as t2
from tamias2d.engine import step as engine_step, tables as tb
from tamias2d.simulator import Simulator
from tamias2d.state import Array
from tests.engine.conserved import totals
from tests.engine.hard_steps import STEP, counted

WALLS = ((0, 1, 0.0), (1, 0, 0.0), (-1, 0, -4.0), (0, -1, -4.0))


@contextmanager
def ordinary() -> Iterator[None]:
    """Let plain steps be no hard ones within this."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(engine_step, "may_be_hard", lambda _: False)
        yield


def box_of_discs(
    seed: int, *, discs: int, restitution: float = 1.0, friction: float = 0.0, **settings: Any
) -> t2.Scene:
    """Discs of all sizes in a box of 4 m."""
    random = np.random.default_rng(seed)
    size, speed = settings.pop("size", 1.0), settings.pop("speed", 3.0)
    scene = t2.Scene(gravity=settings.pop("gravity", (0.0, -9.81 * size)), name=f"box{seed}")
    surface: Any = {"restitution": restitution, "friction": friction}
    for x, y, offset in WALLS:
        scene.add_static(t2.HalfPlane(normal=(x, y), offset=offset * size), **surface)
    side = math.ceil(math.sqrt(discs))
    for k in range(discs):
        place = np.array([k % side + 0.5, k // side + 0.5]) * 4.0 / side
        scene.add_body(
            t2.Disc(radius=float(random.uniform(0.3, 1.5)) * size / side),
            mass=float(10 ** random.uniform(-1.0, 1.0)), position=place * size,
            velocity=random.normal(0.0, speed * size, 2),
            angular_velocity=random.normal(0.0, 4.0), name=f"disc{k}", **surface,
        )  # fmt: skip
    return scene


def told(sim: Simulator) -> list[bytes]:
    """Return all that users can see of the last step."""
    found = sim.contacts
    values = (sim.position, sim.orientation, sim.velocity, sim.angular_velocity)
    contacts = (found.bodies, found.point, found.normal, found.impulse, found.separation)
    return [np.array(v).tobytes() for v in (*values, *contacts)]


def events_of(sim: Simulator) -> list[bytes]:
    """Return what began and ceased to touch in the steps of the last call."""
    began = sim.began
    return [np.array(v).tobytes() for v in (began.bodies, began.impulse, sim.ended)]


@pytest.mark.parametrize("restitution", [0.95, 0.8, 0.5])
@pytest.mark.parametrize("step", [1 / 60, 1 / 7])
def test_a_ball_bounces_as_high_as_it_must(restitution: float, step: float) -> None:
    """Height and velocity at the end of each step, from the geometric series of its flights."""
    height, radius, pull = 2.0, 0.1, 9.81
    surface: Any = {"restitution": restitution, "friction": 0.0}
    sim = Simulator(t2.Scene(gravity=(0.0, -pull)), time_step=step)
    sim.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **surface)
    ball = sim.add(t2.Disc(radius=radius), mass=1.0, position=(0.0, radius + height), **surface)
    met, up, k = math.sqrt(2 * height / pull), restitution * math.sqrt(2 * pull * height), 0
    while up > pull * step:
        k += 1
        sim.step()
        while k * step >= met + 2 * up / pull:  # it has met the floor once more
            met, up = met + 2 * up / pull, restitution * up
        flown = k * step - met
        if flown > 0.0:
            rising = (up * flown - pull * flown**2 / 2, up - pull * flown)
            found = (sim.position[ball, 1] - radius, sim.velocity[ball, 1])
            assert found == pytest.approx(rising, abs=1e-11)


@pytest.mark.parametrize("friction", [0.0, 0.4])
@pytest.mark.parametrize(("discs", "duration"), [(2, 4.0), (5, 0.8), (9, 0.4)])
@pytest.mark.parametrize("seed", range(3))
def test_discs_are_where_a_located_run_says(
    seed: int, discs: int, duration: float, friction: float
) -> None:
    """Up to what rounding grows to: a factor of ten or so with each impact."""
    scene = box_of_discs(seed, discs=discs, restitution=0.95, friction=friction)
    steps = round(duration / STEP)
    run = t2.simulate(scene, duration=duration, times=np.arange(steps + 1) * STEP)
    sim = Simulator(scene, time_step=STEP, compiled=False)
    taken: list[int] = []
    with counted(taken):
        for k in range(1, steps + 1):
            sim.step()
            for found, right in (
                (sim.position, run.position), (sim.orientation, run.orientation),
                (sim.velocity, run.velocity), (sim.angular_velocity, run.angular_velocity),
            ):  # fmt: skip
                np.testing.assert_allclose(found, right[k], rtol=0.0, atol=1e-8)
    assert sum(taken) > 0.9 * steps


@settings(max_examples=60)
@given(
    seed=st.integers(0, 10**6),
    discs=st.integers(1, 12),
    restitution=st.sampled_from([0.9, 1.0]),
    friction=st.sampled_from([0.0, 0.5]),
    size=st.sampled_from([0.005, 1.0, 200.0]),
    speed=st.sampled_from([0.3, 3.0, 40.0]),
)
def test_discs_stay_in_their_box_and_gain_no_energy(
    seed: int, discs: int, restitution: float, friction: float, size: float, speed: float
) -> None:
    """With a restitution of 1 and no friction they keep it, as far as all steps are hard."""
    scene = box_of_discs(seed, discs=discs, restitution=restitution, friction=friction, size=size,
                         speed=speed)  # fmt: skip
    sim = Simulator(scene, time_step=STEP, compiled=False)
    free = sim.dynamic
    radius = np.array([b.shape.radius for b in scene.bodies if isinstance(b.shape, t2.Disc)])

    def energy() -> float:
        height = sim.mass[free] * sim.position[free, 1]
        return float(totals(sim)[2] + 9.81 * size * height.sum())

    sim.step()  # which lists all pairs, and is none of the others
    before, all_hard = energy(), True

    def inside() -> Array:
        place = sim.position[free]
        return np.minimum(place, 4.0 * size - place) - radius[:, None]

    for _ in range(40):
        taken: list[int] = []
        most, least = energy() * (1.0 + 1e-13), np.minimum(inside(), 0.0)
        with counted(taken):
            sim.step()
        hard = sum(taken) == 1
        assert energy() <= most or not hard
        all_hard = all_hard and hard
        deepened = inside() < least - 1e-12 * size  # as ordinary contacts may
        assert not deepened.any() or not hard
    if restitution == 1.0 and friction == 0.0 and all_hard:
        assert energy() == pytest.approx(before, rel=1e-12)


@pytest.mark.parametrize("restitution", [0.9, 0.4])
@pytest.mark.parametrize("seed", range(6))
def test_what_is_told_is_what_changed_the_motion(seed: int, restitution: float) -> None:
    """Impulses that contacts tell, and gravity, are all the momentum that a step gives a body."""
    scene = box_of_discs(seed, discs=5, restitution=restitution, friction=0.0, speed=8.0)
    sim = Simulator(scene, time_step=STEP, compiled=False)
    free, met, hard = sim.dynamic, 0, 0
    for _ in range(80):
        before, taken = sim.velocity.copy(), []
        with counted(taken):
            sim.step()
        if sum(taken) == 0:  # an ordinary step, which corrects velocities besides
            continue
        told_of: Array = np.zeros_like(before)
        told_of[free] += STEP * np.array(scene.gravity) * sim.mass[free, None]
        found = sim.contacts
        for (a, b), normal, impulse in zip(found.bodies, found.normal, found.impulse, strict=True):
            told_of[a] -= impulse * normal
            told_of[b] += impulse * normal
        change = sim.mass[free, None] * (sim.velocity - before)[free]
        np.testing.assert_allclose(told_of[free], change, rtol=0.0, atol=1e-11)
        met, hard = met + len(found), hard + 1
        assert {*map(tuple, sim.began.bodies.tolist())} <= {*map(tuple, found.bodies.tolist())}
    assert met > 10
    assert hard > 15


def disturb(sim: Simulator, leg: int, random: np.random.Generator) -> None:
    """Do between steps what users do: push, move, turn, add and remove."""
    moving = np.flatnonzero(sim.dynamic)
    k = int(random.choice(moving))
    if leg % 5 == 1:
        sim.velocity[k] += random.normal(0.0, 2.0, 2)
    if leg % 5 == 2:
        sim.apply_force(k, random.normal(0.0, 5.0, 2))
    if leg == 3:
        sim.add(t2.Disc(radius=0.1), mass=0.5, position=(2.0, 3.8), restitution=0.9, friction=0.1)
    if leg == 6:
        sim.orientation[0] = random.uniform(-0.2, 0.2)  # the floor
    if leg == 8:
        sim.remove(int(moving[-1]))
    if leg == 11:
        sim.position[k] += (0.05, 0.0)


def followed(sim: Simulator, seed: int, one: bool, path: Path | None = None) -> list[list[bytes]]:
    """Return what is seen leg by leg; step by step or not, saved and restored or not."""
    random, seen = np.random.default_rng(1000 + seed), []
    for leg, steps in enumerate((7, 1, 5, 9, 1, 12, 20, 3, 8, 1, 1, 14, 30)):
        disturb(sim, leg, random)
        events: list[bytes] = []
        for _ in range(steps if one else 1):
            sim.step(1 if one else steps)
            events = joined(events, events_of(sim))
        if path is not None and leg % 3 == 2:
            sim.save(path)
            sim = Simulator.restore(path, compiled=False)
        seen.append([*told(sim), *events])
    return seen


def joined(one: list[bytes], other: list[bytes]) -> list[bytes]:
    """Return the events of two calls as those of one."""
    return [a + b for a, b in zip(one, other, strict=True)] if one else other


@pytest.mark.filterwarnings("ignore::tamias2d.StepWarning")  # discs are put into others
@pytest.mark.parametrize("seed", range(16))
def test_bits_depend_on_no_call(seed: int, tmp_path: Path) -> None:
    restitution = 0.9 if seed < 8 else 0.4
    scene = box_of_discs(
        seed, discs=1 + seed % 7, restitution=restitution, friction=0.2 * (seed % 2)
    )
    quick = followed(Simulator(scene, time_step=STEP), seed, one=False)
    assert followed(Simulator(scene, time_step=STEP), seed, one=True) == quick
    plain = Simulator(scene, time_step=STEP, compiled=False)
    assert followed(plain, seed, one=False, path=tmp_path / "some.npz") == quick


def cradle(gap: float) -> t2.Scene:
    """Three discs, one of which comes, and a gap between the other two."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    for k, x in enumerate((-1.0, 0.5, 1.5 + gap)):
        scene.add_body(t2.Disc(radius=0.5), mass=1.0, position=(x, 0.0),
                       velocity=(3.0 * (k == 0), 0.0), restitution=1.0)  # fmt: skip
    return scene


def corner() -> t2.Scene:
    """A disc that meets floor and wall at one instant."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    for normal in ((0.0, 1.0), (1.0, 0.0)):
        scene.add_static(t2.HalfPlane(normal=normal, offset=0.0), restitution=1.0, friction=0.5)
    scene.add_body(t2.Disc(radius=0.5), mass=1.0, position=(1.0, 1.0), velocity=(-3.0, -3.0),
                   restitution=1.0, friction=0.5)  # fmt: skip
    return scene


def leaning() -> t2.Scene:
    """A disc on two others, which lie apart."""
    scene = t2.Scene(gravity=(0.0, -9.81))
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), restitution=0.0, friction=0.5)
    for place in ((0.0, 0.5), (1.2, 0.5), (0.6, 1.31)):
        scene.add_body(t2.Disc(radius=0.5), mass=1.0, position=place, restitution=0.0,
                       friction=0.5)  # fmt: skip
    return scene


@pytest.mark.filterwarnings("ignore::tamias2d.StepWarning")
@pytest.mark.parametrize(
    ("scene", "steps"),
    [
        (cradle(0.0), 20),
        (corner(), 11),
    ],
)
def test_what_is_no_impact_of_two_is_left_to_ordinary_steps(scene: t2.Scene, steps: int) -> None:
    """These steps have the bits of ordinary ones, though hard ones are tried."""
    tried: list[int] = []
    sim = Simulator(scene, time_step=STEP, compiled=False)
    with counted(tried):
        quick = []
        for _ in range(steps):
            sim.step()
            quick.append(told(sim))
    with ordinary():
        sim = Simulator(scene, time_step=STEP, compiled=False)
        for seen in quick:
            sim.step()
            assert told(sim) == seen
    assert 0 in tried


@pytest.mark.filterwarnings("ignore::tamias2d.StepWarning")
def test_discs_that_lean_on_each_other_are_left_to_ordinary_steps() -> None:
    tried: list[int] = []
    sim = Simulator(leaning(), time_step=STEP, compiled=False)
    with counted(tried):
        for _ in range(30):
            sim.step()
    assert sum(tried) < 5
    assert len(tried) < 10  # as long as they lean, hard steps are not even tried


def test_blows_pass_through_discs_that_nearly_touch() -> None:
    """One after the other, as in a located run: what comes stays, and the last one leaves."""
    sim = Simulator(cradle(1e-6), time_step=STEP, compiled=False)
    taken: list[int] = []
    with counted(taken):
        for _ in range(20):
            sim.step()
    assert sim.velocity[:, 0].tolist() == pytest.approx([0.0, 0.0, 3.0], abs=1e-12)
    assert sum(taken) == 20


def alone(**body: Any) -> t2.Scene:
    scene = t2.Scene(gravity=(0.0, -9.81))
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), restitution=0.9, friction=0.0)
    given: Any = {"mass": 1.0, "position": (0.0, 3.0), "restitution": 0.9, "friction": 0.0}
    scene.add_body(**({"shape": t2.Disc(radius=0.5)} | given | body))
    return scene


@pytest.mark.parametrize(
    "body",
    [
        {"force": (0.0, 1.0)},
        {"torque": 0.1},
        {"linear_drag": 0.1},
        {"angular_drag": 0.1},
        {"shape": t2.Box(width=1.0, height=1.0)},
        {"position": (5e4, 3.0)},  # more than 2^16 radii away
        {"velocity": (4e6, 0.0)},  # so far within a step
    ],
)
def test_only_hard_discs_take_hard_steps(body: dict[str, Any]) -> None:
    shape = body.pop("shape", None)
    for extra, hard in (({}, True), (body | ({"shape": shape} if shape else {}), False)):
        taken: list[int] = []
        sim = Simulator(alone(**extra), time_step=STEP, compiled=False)
        with counted(taken):
            sim.step(30)
        assert (sum(taken) > 0) == hard


def test_a_sensor_tells_what_is_in_it() -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(t2.Disc(radius=0.5), mass=1.0, position=(0.0, 0.0), velocity=(6.0, 0.0),
                   restitution=1.0)  # fmt: skip
    scene.add_body(t2.Disc(radius=0.5), mass=1.0, position=(2.0, 0.0), restitution=1.0,
                   sensor=True)  # fmt: skip
    sim = Simulator(scene, time_step=STEP)
    sim.step(11)
    assert sim.began.bodies.tolist() == [[0, 1]]
    assert sim.velocity[0, 0] == 6.0


def test_a_flight_beyond_what_float64_tells_apart_is_refused() -> None:
    scene = alone(velocity=(1e14, 0.0))
    sim = Simulator(scene, time_step=STEP)
    with pytest.raises(t2.InputError, match="radius of the body"):
        sim.step(10**6)


def test_discs_that_were_put_into_each_other_are_pushed_apart() -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    for x in (0.0, 3.0):
        scene.add_body(t2.Disc(radius=0.5), mass=1.0, position=(x, 0.0), restitution=1.0)
    sim = Simulator(scene, time_step=STEP, compiled=False)
    sim.step(2)
    sim.position[1], sim.velocity[1] = (0.4, 0.0), (0.01, 0.0)
    sim.step(60)
    assert sim.position[1, 0] - sim.position[0, 0] > 0.98


@pytest.mark.parametrize(("discs", "all_pairs"), [(12, True), (13, False)])
def test_of_sixteen_hard_discs_and_half_planes_all_pairs_are_listed(
    discs: int, all_pairs: bool
) -> None:
    scene = box_of_discs(1, discs=discs, restitution=0.2)
    sim = Simulator(scene, time_step=STEP, compiled=False)
    sim.step(2)
    listed = int(sim._engine.world.broad_phase.counts[tb.CONTACTS])
    assert (listed == discs * (discs - 1) // 2 + 4 * discs) == all_pairs
