"""Bodies of infinite inertia, which nothing turns: heroes of games (DD20).

Expected values come from Newton's law without turning, and from bodies of finite, large inertia.
"""

import copy
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.scene.writing import scene_text

SURFACE: Any = {"friction": 0.8, "restitution": 0.0}
HERO = t2.Capsule(length=1.0, radius=0.4)
UPRIGHT: Any = {"mass": 70.0, "orientation": np.pi / 2, "inertia": math.inf}
FLOOR = t2.HalfPlane(normal=(0.0, 1.0), offset=0.0)


def street(*, gravity: float = 25.0, **settings: Any) -> t2.Simulator:
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -gravity)), **settings)
    sim.add_static(FLOOR, name="floor", **SURFACE)
    return sim


def space(**settings: Any) -> t2.Simulator:
    return t2.Simulator(t2.Scene(gravity=(0.0, 0.0)), **settings)


# -- what does not turn them


def test_a_blow_beside_the_centre_does_not_turn_it() -> None:
    sim = space()
    hero = sim.add(HERO, position=(0.0, 0.0), restitution=0.0, **UPRIGHT)
    sim.apply_impulse(hero, (70.0, 0.0), at=(0.0, 0.5))
    sim.apply_force(hero, (70.0 * 60, 0.0), at=(0.0, 0.5))
    sim.step(60)
    assert sim.velocity[hero].tolist() == [pytest.approx(2.0), 0.0]
    assert (sim.orientation[hero], sim.angular_velocity[hero]) == (np.pi / 2, 0.0)


def test_a_torque_does_nothing() -> None:
    sim = space()
    hero = sim.add(HERO, position=(0.0, 0.0), restitution=0.0, **UPRIGHT)
    sim.torque[hero] = 1e6
    sim.step(60)
    assert (sim.orientation[hero], sim.angular_velocity[hero]) == (np.pi / 2, 0.0)


@pytest.mark.parametrize("seed", range(12))
@pytest.mark.parametrize("gravity", [0.0, 10.0])
def test_crowds_do_not_turn_them(seed: int, gravity: float) -> None:
    """Nor what takes energy back from a group that has got too much of it, or carries along."""
    chance = np.random.default_rng(seed)
    sim = street(gravity=gravity, sleeping=bool(seed % 2))
    surface: Any = {"friction": 0.5, "restitution": float(seed % 3) / 2}
    for normal, offset in (((1.0, 0.0), -8.0), ((-1.0, 0.0), -8.0), ((0.0, -1.0), -9.0)):
        sim.add_static(t2.HalfPlane(normal=normal, offset=offset), **surface)
    door = t2.Box(width=4.0, height=0.3)
    sim.add_kinematic(door, position=(0.0, 4.0), angular_velocity=float(seed), **surface)
    shapes = [HERO, t2.Disc(radius=0.5), t2.Box(width=1.0, height=0.5)]
    places = [(3.0 * k - 6.0, 1.0 + 1.5 * j) for k in range(5) for j in range(4)]
    speeds = chance.normal(size=(20, 2)) * 10
    turns = chance.uniform(-3.0, 3.0, 20)
    inertias = np.where(chance.random(20) < 0.6, math.inf, 3.0)
    crowd = sim.add(
        [shapes[k % 3] for k in range(20)],
        mass=chance.uniform(0.5, 5.0, 20),
        inertia=inertias,
        position=places,
        velocity=speeds,
        orientation=turns,
        **surface,
    )
    sim.step(120)
    held = np.isinf(inertias)
    assert np.all(sim.angular_velocity[crowd[held]] == 0.0)
    assert np.array_equal(sim.orientation[crowd[held]], turns[held])
    assert np.all(sim.orientation[crowd[~held]] != turns[~held])


def test_a_door_that_turns_carries_it_along_without_turning_it() -> None:
    sim = space()
    door = t2.Box(width=6.0, height=0.3)
    sim.add_kinematic(door, position=(0.0, 0.0), angular_velocity=3.0, **SURFACE)
    hero = sim.add(HERO, position=(2.0, 0.6), velocity=(0.0, -90.0), **UPRIGHT, **SURFACE)
    sim.step(20)
    assert (sim.orientation[hero], sim.angular_velocity[hero]) == (np.pi / 2, 0.0)


# -- what they do


def test_it_stands_on_an_edge_and_is_held_by_friction() -> None:
    """A box whose centre is beyond the edge of a table would turn over; a push of less than
    friction does not move it, and one of more does by what is more."""
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -10.0)))
    sim.add_static(t2.Box(width=2.0, height=1.0), position=(0.0, -0.5), **SURFACE)
    box = sim.add(
        t2.Box(width=1.0, height=1.0),
        mass=2.0,
        inertia=math.inf,
        position=(1.3, 0.5),
        **SURFACE,
    )
    sim.force[box] = 15.0, 0.0  # of at most 16 N
    sim.step(60)
    assert sim.position[box] == pytest.approx((1.3, 0.5), abs=1e-3)
    assert sim.contacts.impulse.sum() * 60 == pytest.approx(20.0, rel=1e-6)
    sim.force[box] = -20.0, 0.0
    sim.step(30)
    assert sim.velocity[box, 0] == pytest.approx(-(20.0 - 16.0) / 2.0 * 0.5, rel=1e-3)


def test_a_disc_slides_until_it_stands_and_does_not_roll() -> None:
    sim = street(gravity=10.0)
    disc = sim.add(
        t2.Disc(radius=0.5),
        mass=2.0,
        inertia=math.inf,
        position=(0.0, 0.5),
        velocity=(4.0, 0.0),
        **SURFACE,
    )
    sim.step(60)
    assert sim.position[disc, 0] == pytest.approx(4.0**2 / (2 * 0.8 * 10.0), abs=1e-9)
    assert sim.velocity[disc].tolist() == [0.0, 0.0]


def test_a_hero_who_runs_against_a_wall_is_not_shaken() -> None:
    """Held upright by a joint, he was thrown back from walls by up to 0.3 m/s."""
    sim = street()
    sim.add_static(t2.Box(width=1.0, height=10.0), position=(2.5, 5.0), **SURFACE)
    box = t2.Box(width=0.8, height=1.8)
    hero = sim.add(box, mass=70.0, inertia=math.inf, position=(0.0, 0.9), **SURFACE)
    places = []
    for _ in range(300):
        sim.velocity[hero, 0] = 5.0
        sim.step()
        places.append(sim.position[hero].copy())
    assert np.ptp(places[60:], axis=0) == pytest.approx((0.0, 0.0), abs=1e-6)


def test_it_falls_asleep_and_wakes() -> None:
    sim = street(sleeping=True)
    hero = sim.add(HERO, position=(0.0, 0.9), **UPRIGHT, **SURFACE)
    sim.step(120)
    assert sim.asleep[hero]
    sim.apply_impulse(hero, (70.0, 0.0), at=(0.0, 1.8))
    sim.step()
    assert not sim.asleep[hero]
    assert sim.angular_velocity[hero] == 0.0


# -- on what turns

LARGE = 1e6  # kg m^2: an inertia that nothing in these scenes turns
ON_AN_EDGE = t2.Capsule(length=1.0, radius=0.5)


def platform(turning: float, surface: Any, **settings: Any) -> t2.Simulator:
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -9.81)), **settings)
    top = t2.Box(width=8.0, height=1.0)
    sim.add_kinematic(top, position=(0.0, 0.0), angular_velocity=turning, **surface)
    return sim


def told_beside_got(sim: t2.Simulator, body: int) -> tuple[float, float]:
    """Step; return how far what its contacts tell is from what a body got, and its size, N s."""
    before = sim.velocity[body].copy()
    sim.step()
    found = sim.touching(body)
    sign = np.where(found.bodies[:, 1] == body, 1.0, -1.0)[:, None]
    told = (sign * (found.normal * found.impulse[:, None] + found.friction_impulse)).sum(axis=0)
    gained = sim.velocity[body] - before - np.array(sim.gravity) * sim.time_step
    return float(np.hypot(*(told - sim.mass[body] * gained))), float(np.hypot(*told))


def into_platform(sim: t2.Simulator, body: int) -> float:
    """Return how fast a body goes into the platform, the first one, where they touch, m/s."""
    found, most = sim.touching(body), 0.0
    for bodies, point, normal in zip(found.bodies, found.point, found.normal, strict=True):
        apart = (sim.velocity_at(body, point) - sim.velocity_at(0, point)) @ normal
        most = max(most, apart if bodies[0] == body else -apart)
    return float(most)


@pytest.mark.parametrize("rate", [60, 960])
@pytest.mark.parametrize("turning", [0.1, 1.0, -1.0])
@pytest.mark.parametrize("carried", [False, True])
def test_a_hero_on_a_platform_that_turns(turning: float, rate: int, carried: bool) -> None:
    """He went into it at 0.6 m/s after each step, and was told up to 50 times what he got."""
    surface: Any = {"friction": 0.6, "restitution": 0.0}
    ends = []
    for inertia in (math.inf, LARGE):
        sim = platform(turning, surface, time_step=1 / rate)
        place = (-2.0, 1.0)
        held: Any = {"mass": 1.0, "inertia": inertia, "position": place}
        hero = sim.add(ON_AN_EDGE, velocity=sim.velocity_at(0, (-2.0, 0.5)), **held, **surface)
        if carried:
            crate, head = t2.Box(width=0.6, height=0.4), (-2.1, 1.7)
            speed = sim.velocity_at(0, head)
            sim.add(crate, mass=0.3, position=head, velocity=speed, **surface)
        for _ in range(round(0.6 * rate)):
            apart, size = told_beside_got(sim, hero)
            assert apart <= 0.03 * max(size, 9.81 / rate)
            assert carried or into_platform(sim, hero) < 1e-3
        ends.append(sim.position[hero].copy())
    assert ends[0] == pytest.approx(ends[1], abs=2e-3)


@pytest.mark.parametrize("turning", [-1.2, 0.8])
@pytest.mark.parametrize("restitution", [0.0, 0.5])
def test_a_hero_who_falls_on_a_platform_that_turns(turning: float, restitution: float) -> None:
    """Of an impact in flight he was told up to three times as much as he got."""
    surface: Any = {"friction": 1.0, "restitution": restitution}
    ends = []
    for inertia in (math.inf, LARGE):
        sim = platform(turning, surface, time_step=1 / 480)
        box = t2.Box(width=0.6, height=1.6)
        hero = sim.add(box, mass=2.0, inertia=inertia, position=(1.5, 1.4), **surface)
        told = [told_beside_got(sim, hero) for _ in range(240)]
        assert max(apart for apart, _ in told) < 0.02 * max(size for _, size in told)
        ends.append(sim.position[hero].copy())
    assert ends[0] == pytest.approx(ends[1], abs=2e-3)


# -- joints and springs


@pytest.mark.parametrize("large", [False, True])
def test_a_joint_that_holds_it_beside_its_centre(large: bool) -> None:
    """Its centre goes round the pin like a point of its mass: T = 2 pi sqrt(l/g), not turning."""
    sim = space(joints=True)
    sim.gravity[:] = 0.0, -9.81
    angle, length = 0.01, 1.0
    way = length * math.sin(angle), -length * math.cos(angle)
    bob = sim.add(
        t2.Box(width=1.0, height=0.5),
        mass=2.0,
        inertia=1e9 if large else math.inf,
        position=(way[0] - 0.3, way[1] - 0.2),
        restitution=0.0,
    )
    sim.add_joint(t2.Distance(), (0.0, 0.0), bob, other_anchor=(0.3, 0.2))
    quarter = round(math.pi / 2 * math.sqrt(length / 9.81) * 60)
    sim.step(quarter)
    phase = math.sqrt(9.81 / length) * quarter / 60
    assert sim.position[bob, 0] + 0.3 == pytest.approx(way[0] * math.cos(phase), abs=1e-4)
    assert large or (sim.orientation[bob], sim.angular_velocity[bob]) == (0.0, 0.0)


def test_a_weld_to_a_hero_keeps_what_it_holds_from_turning() -> None:
    sim = street()
    hero = sim.add(HERO, position=(0.0, 0.9), **UPRIGHT, **SURFACE)
    lamp = sim.add(t2.Disc(radius=0.1), mass=1.0, position=(0.6, 1.2), restitution=0.0)
    sim.add_joint(t2.Weld(), hero, lamp, at=(0.6, 1.2))
    sim.velocity[[hero, lamp], 1] = 8.0
    sim.step(120)
    assert sim.position[lamp] - sim.position[hero] == pytest.approx((0.6, 0.3), abs=1e-3)
    assert sim.orientation[lamp] == pytest.approx(0.0, abs=1e-3)
    assert (sim.orientation[hero], sim.angular_velocity[hero]) == (np.pi / 2, 0.0)
    assert not sim.warnings


def test_a_spring_beside_its_centre_pulls_it_and_does_not_turn_it() -> None:
    """In the frame loop and located alike; a mass on a spring of 40 N/m, on x alone."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(
        HERO, name="hero", position=(1.0, -0.3), friction=0.0, restitution=0.0, **UPRIGHT
    )
    scene.add_spring("hero", (0.0, 0.0), stiffness=2800.0, rest_length=0.0, anchor=(0.3, 0.0))
    sim = t2.Simulator(scene)
    sim.step(600)
    run = t2.simulate(scene, duration=10.0)
    rate = math.sqrt(2800.0 / 70.0)
    assert run.position[-1, 0] == pytest.approx((math.cos(rate * 10.0), -0.3), abs=1e-6)
    assert math.hypot(sim.position[0, 0], sim.velocity[0, 0] / rate) == pytest.approx(1.0, abs=1e-6)
    assert run.orientation[-1, 0] == sim.orientation[0] == np.pi / 2
    assert run.energy == pytest.approx(1400.0, rel=1e-9)


@pytest.mark.parametrize(
    "kind",
    [
        t2.Rotary(motor=t2.Motor(speed=1.0)),
        t2.Gear(ratio=2.0),
        t2.Revolute(motor=t2.Motor(speed=1.0)),
    ],
)
def test_a_joint_that_could_only_turn_them_is_refused(kind: Any) -> None:
    sim = space()
    scene = t2.Scene(gravity=(0.0, 0.0))
    for each, add in ((sim, sim.add), (scene, scene.add_body)):
        for name in ("a", "b"):
            add(t2.Disc(radius=0.1), name=name, position=(0.0, 0.0), restitution=0.0, **UPRIGHT)
        with pytest.raises(t2.InputError, match=r"only turn 'a' and 'b', which nothing turns.*inf"):
            each.add_joint(kind, "a", "b")


# -- saying so


def test_it_is_told_and_saved_and_recorded(tmp_path: Path) -> None:
    sim = street()
    hero = sim.add(
        HERO, name="hero", position=(0.0, 0.9), velocity=(1.0, 2.0), **UPRIGHT, **SURFACE
    )
    crate = sim.add(t2.Box(width=1.0, height=1.0), mass=1.0, position=(1.0, 0.5), **SURFACE)
    sim.step(10)
    found = sim.body(hero)
    assert (found.inertia, found.inertia_stated, found.inverse_inertia) == (math.inf, True, 0.0)
    sim.save(tmp_path / "game.npz")
    others = [copy.deepcopy(sim), t2.Simulator.restore(tmp_path / "game.npz")]
    state = sim.copy_state()
    with t2.Recorder(sim, tmp_path / "session.rrd") as recorder:
        for _ in range(30):
            sim.step()
            recorder.frame()
    for other in others:
        other.step(30)
        assert other.digest() == sim.digest()
    sim.restore_state(state)
    sim.step(30)
    assert others[0].digest() == sim.digest()
    assert sim.angular_velocity[hero] == 0.0 != sim.angular_velocity[crate]


def test_a_mass_changes_and_an_inertia_comes_and_goes() -> None:
    sim = space()
    body = sim.add(HERO, mass=2.0, inertia=math.inf, position=(0.0, 0.0), restitution=0.0)
    sim.set_mass(body, mass=3.0)
    sim.set_shape(body, t2.Disc(radius=1.0))
    assert (sim.mass[body], sim.body(body).inertia) == (3.0, math.inf)
    sim.set_mass(body, mass=3.0, inertia=1.5)
    sim.apply_impulse(body, (0.0, 1.5), at=(1.0, 0.0))
    sim.step(60)
    assert sim.angular_velocity[body] == pytest.approx(1.0)
    sim.set_mass(body, mass=3.0, inertia=math.inf)
    sim.step(60)
    assert (sim.angular_velocity[body], sim.body(body).inertia) == (0.0, math.inf)
    assert sim.orientation[body] == pytest.approx(1.0)


@pytest.mark.parametrize("compiled", [True, False])
def test_a_spin_that_is_written_is_refused_by_name(compiled: bool) -> None:
    sim = space(compiled=compiled)
    hero = sim.add(HERO, name="hero", position=(0.0, 0.0), restitution=0.0, **UPRIGHT)
    sim.angular_velocity[hero] = 1.0
    message = r"angular_velocity\[0\] of body 'hero': found 1.0: must be 0: its inertia is infinite"
    with pytest.raises(t2.InputError, match=message):
        sim.step()
    sim.angular_velocity[hero] = 0.0
    sim.step()
    assert sim.time == pytest.approx(1 / 60)


@pytest.mark.parametrize("key", ["torque", "angular_velocity"])
def test_what_would_turn_it_at_the_start_is_refused(key: str) -> None:
    scene, sim = t2.Scene(gravity=(0.0, 0.0)), space()
    for add in (scene.add_body, sim.add):
        with pytest.raises(t2.InputError, match=f"found inf, though its {key} is not 0: nothing"):
            add(HERO, position=(0.0, 0.0), restitution=0.0, **UPRIGHT, **{key: 2.0})


# -- located


def located(shape: Any, *, friction: float = 0.8, restitution: float = 0.3) -> t2.Scene:
    scene = t2.Scene(gravity=(0.0, -25.0))
    surface: Any = {"friction": friction, "restitution": restitution}
    scene.add_static(FLOOR, name="floor", **surface)
    state: Any = {"position": (0.0, 1.6), "velocity": (1.0, 0.0), **UPRIGHT, "orientation": 0.4}
    scene.add_body(shape, name="hero", **state, **surface)
    return scene


@pytest.mark.parametrize("shape", [HERO, t2.Disc(radius=0.5), t2.Box(width=1.0, height=0.6)])
@pytest.mark.parametrize("friction", [0.0, 0.8])
def test_a_located_body_bounces_slides_and_stands(shape: Any, friction: float) -> None:
    """As a point does: e of its speed is left, and friction stops it."""
    scene = located(shape, friction=friction)
    run = t2.simulate(scene, duration=3.0)
    assert run.impacts
    assert np.all(run.orientation[:, 1] == 0.4)
    assert np.all(run.angular_velocity[:, 1] == 0.0)
    assert run.velocity[-1, 1] == pytest.approx((1.0 if friction == 0.0 else 0.0, 0.0), abs=1e-12)
    assert np.isfinite(run.energy).all()
    assert np.all(np.diff(run.energy) <= 1e-9)
    sim = t2.Simulator(scene, time_step=1 / 240)
    sim.step(720)
    assert sim.position[1] == pytest.approx(run.position[-1, 1], abs=0.03)


def test_a_certificate_of_a_body_that_does_not_turn() -> None:
    run = t2.simulate(located(HERO, restitution=1.0, friction=0.0), duration=1.0, tolerance=1e-6)
    assert run.certificate is not None
    assert run.energy == pytest.approx(run.energy[0], rel=1e-12)


def test_a_scene_file_says_so() -> None:
    text = """
    gravity: [0 m/s^2, -9.81 m/s^2]
    bodies:
      hero:
        shape: capsule
        length: 1 m
        radius: 0.4 m
        mass: 70 kg
        inertia: inf kg*m^2
        position: [0 m, 1 m]
        restitution: 0
    """
    scene = t2.load(text)
    assert scene.bodies[0].inverse_inertia == 0.0
    again = scene_text(scene)
    assert "inertia: inf kg*m^2" in again
    assert scene_text(t2.load(again)) == again
    with pytest.raises(t2.SceneError, match=r"found 'inf kg', of unit kg: must be in"):
        t2.load(text.replace("inf kg*m^2", "inf kg"))


def test_worlds_of_an_ensemble_keep_it() -> None:
    scene = located(HERO)
    for method, step in ((None, None), (t2.Stepped(), 1 / 60)):
        found = t2.ensemble(
            scene,
            vary={"bodies.hero.mass": [60.0, 70.0], "bodies.hero.velocity.x": [1.0, 2.0]},
            duration=1.0,
            method=method,
            time_step=step,
        )
        assert np.all(np.asarray(found.orientation)[..., -1] == 0.4)


@pytest.mark.parametrize("kick", [1e-6, 1e-3, 1e-2])
@pytest.mark.parametrize("count", [2, 3, 6, 10])
def test_heroes_who_stand_on_each_other_come_to_rest(count: int, kick: float) -> None:
    """Discs that do not turn hold by friction, wherever they touch: a kick shifts them a little."""
    sim = street()
    disc = t2.Disc(radius=0.25)
    for k in range(count):
        place = 0.0, 0.25 + 0.5 * k
        sim.add(disc, mass=1.0, position=place, inertia=math.inf, **SURFACE)
    sim.velocity[-1] = kick, 0.0
    sim.step(60)
    for _ in range(60):
        sim.step()
        assert abs(sim.velocity).max() < 1e-9
    assert abs(sim.position[1:, 0]).max() <= kick / 60
