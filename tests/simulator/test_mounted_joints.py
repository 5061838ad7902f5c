"""Joints to kinematic bodies: what they hold is driven by a motion that is given.

Expected values come from the equations of a pendulum whose support moves, in angles, solved by
scipy; from the same mechanism at rest, as another observer sees it; and from laws.
"""

import copy
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

from tamias2d import (
    Box,
    Disc,
    Distance,
    Gear,
    HalfPlane,
    InputError,
    JointSpring,
    Limits,
    Motor,
    Prismatic,
    Pulley,
    Revolute,
    Rotary,
    Scene,
    Simulator,
    Weld,
    Wheel,
    simulate,
)
from tests.engine.scenes import plain

G, LENGTH = 9.81, 1.0
ROD = Box(width=0.05, height=LENGTH)
INERTIA = (0.05**2 + LENGTH**2) / 12
SURFACE: dict[str, Any] = {"restitution": 0.0, "friction": 0.0}
Array = NDArray[np.float64]
Support = Callable[[float], tuple[float, float]]


def pendulum(links: int, angle: float, velocity: tuple[float, float], step: float) -> Simulator:
    """Return rods of 1 kg, one under the other at an angle from hanging, on a trolley."""
    scene = Scene(gravity=(0.0, -G))
    cart = Box(width=0.5, height=0.2)
    upper: int = scene.add_kinematic(cart, position=(0.0, 0.0), velocity=velocity, **SURFACE)
    at, along = np.zeros(2), np.array([math.sin(angle), -math.cos(angle)])
    for k in range(links):
        place = (at + LENGTH / 2 * along).tolist()
        rod = scene.add_body(
            ROD, mass=1.0, position=place, orientation=angle, velocity=velocity, group=-1, **SURFACE
        )
        ends = {"anchor": (0.0, -LENGTH / 2 * (k > 0)), "other_anchor": (0.0, LENGTH / 2)}
        scene.add_joint(Revolute(), upper, rod, **ends)
        at, upper = at + LENGTH * along, rod
    return Simulator(scene, time_step=step, compiled=False)


def angles_of(links: int, angle: float, pull: Support, duration: float) -> Any:
    """Return the angles of such rods by their own equations, as the support is accelerated."""
    reach = LENGTH * (np.tri(links, k=-1) + 0.5 * np.eye(links))
    masses, moments = reach.T @ reach, reach.sum(axis=0)

    def slope(time: float, state: Array) -> Array:
        turns, rates = np.split(state, 2)
        apart = turns[:, None] - turns
        x, y = pull(time)
        asked = -(masses * np.sin(apart)) @ rates**2
        asked -= moments * (x * np.cos(turns) + (y + G) * np.sin(turns))
        answer = np.linalg.solve(masses * np.cos(apart) + INERTIA * np.eye(links), asked)
        return np.concatenate((rates, answer))

    start = np.concatenate((np.full(links, angle), np.zeros(links)))
    return solve_ivp(slope, (0, duration), start, rtol=1e-10, atol=1e-11, dense_output=True).sol


def evenly(time: float) -> Array:
    return np.array([0.7 * time, 0.2 * time])


def swinging(time: float) -> Array:
    return np.array([0.3 * math.sin(3 * time), 0.1 * math.cos(6 * time) - 0.1])


def swung(time: float) -> tuple[float, float]:
    return -2.7 * math.sin(3 * time), -3.6 * math.cos(6 * time)


WAYS: dict[str, Any] = {
    "evenly": (evenly, lambda _: (0.0, 0.0), (0.7, 0.2)),
    "swinging": (swinging, swung, (0.9, 0.0)),
}


def error_of(links: int, way: str, step: float, duration: float) -> tuple[float, float]:
    """Return how far rods on a trolley are from where they should be at most, m, and apart, m."""
    place, pull, first = WAYS[way]
    right = angles_of(links, 0.5, pull, duration)
    sim = pendulum(links, 0.5, first, step)
    worst = apart = 0.0
    for k in range(round(duration / step)):
        sim.velocity[0] = (place((k + 1) * step) - place(k * step)) / step
        sim.step()
        turns = right((k + 1) * step)[:links]
        along = LENGTH * np.column_stack((np.sin(turns), -np.cos(turns)))
        expected = place((k + 1) * step) + np.cumsum(along, axis=0) - along / 2
        worst = max(worst, float(np.abs(sim.position[1:] - expected).max()))
        apart = max(apart, float(sim.reactions.separation.max()))
    return worst, apart


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("links", [1, 2, 5])
def test_pendulum_on_a_trolley_converges_with_order_two(links: int, way: str) -> None:
    steps = np.array([1 / 60, 1 / 120, 1 / 240])
    errors, apart = np.array([error_of(links, way, step, 0.5) for step in steps]).T
    assert errors[0] < 1e-4
    assert apart.max() < 1e-5  # of a rod: it may be 1e-3
    orders = np.log2(errors[:-1] / errors[1:])
    assert orders == pytest.approx(2.0, abs=0.1)


def mounted(
    kind: Any,
    velocity: tuple[float, float],
    spin: float,
    *,
    moving: bool = True,
    compiled: bool = False,
) -> Simulator:
    """Return two rods, the first of which a joint ties to a disc; all begin as one body."""
    scene = Scene(gravity=(0.0, -G))
    told = {"velocity": velocity, "angular_velocity": spin}

    def at(x: float) -> dict[str, Any]:
        own = {"position": (x, 0.0), "velocity": (velocity[0], velocity[1] + spin * x)}
        return {**own, "angular_velocity": spin, "mass": 1.0, "group": -1, **SURFACE}

    add: Any = scene.add_kinematic if moving else scene.add_static
    disc = add(Disc(radius=0.1), position=(0.0, 0.0), **(told if moving else {}), **SURFACE)
    rod = Box(width=1.0, height=0.1)
    first = scene.add_body(rod, **at(1.0))
    last = scene.add_body(rod, **at(2.0))
    scene.add_joint(Revolute(), first, last, anchor=(0.5, 0.0), other_anchor=(-0.5, 0.0))
    if isinstance(kind, Pulley):
        scene.add_joint(kind, scene.add_body(rod, **at(-1.0)), first, third=disc)
    elif isinstance(kind, Gear):
        other = scene.add_body(rod, **at(-1.0))
        inner = {"anchor": (-0.5, 0.0), "other_anchor": (0.5, 0.0)}
        scene.add_joint(Revolute(), disc, other, **inner)
        inner = {"anchor": (0.5, 0.0), "other_anchor": (-0.5, 0.0)}
        scene.add_joint(Revolute(), disc, first, **inner)
        scene.add_joint(kind, other, first, third=disc)
    else:
        slides = isinstance(kind, Prismatic | Wheel | Rotary)
        ends = {"anchor": (1.0, 0.0)} if slides else {"anchor": (0.5, 0.0)}
        scene.add_joint(kind, disc, first, other_anchor=(0.0 if slides else -0.5, 0.0), **ends)
    return Simulator(scene, time_step=1 / 64, compiled=compiled)


SPRING = JointSpring(stiffness=50.0, damping=1.0)
KINDS: dict[str, Any] = {
    "hinge": Revolute(),
    "hinge with a spring": Revolute(spring=JointSpring(stiffness=5.0, damping=0.1)),
    "hinge with limits": Revolute(limits=Limits(lower=-0.3, upper=0.3, restitution=0.0)),
    "hinge with a motor": Revolute(motor=Motor(speed=2.0)),
    "hinge with a weak motor": Revolute(motor=Motor(speed=2.0, maximum=1.0)),
    "weld": Weld(),
    "slide": Prismatic(axis=(0.0, 1.0)),
    "slide with a spring": Prismatic(axis=(0.0, 1.0), spring=SPRING),
    "wheel": Wheel(axis=(0.0, 1.0), spring=SPRING, motor=Motor(speed=3.0, maximum=2.0)),
    "motor": Rotary(motor=Motor(speed=1.0)),
    "gear": Gear(ratio=2.0),
    "pulley": Pulley(posts=((-1.0, 2.0), (1.0, 2.0))),
}


@pytest.mark.parametrize("kind", KINDS)
def test_what_hangs_on_an_even_motion_moves_as_it_would_at_rest(kind: str) -> None:
    velocity = (1.25, -0.5)
    moving, still = (
        mounted(KINDS[kind], velocity, 0.0),
        mounted(KINDS[kind], (0, 0), 0.0, moving=False),
    )
    for k in range(40):
        moving.step()
        still.step()
        carried = np.array(velocity) * (k + 1) / 64
        assert np.abs(moving.position - carried - still.position).max() < 1e-10
        apart = np.abs(moving.reactions.force - still.reactions.force).max()
        assert apart < 1e-6  # N: a solution ends where 1e-7 of what it began with is left


@pytest.mark.parametrize("kind", KINDS)
def test_joints_hold_on_a_disc_that_turns(kind: str) -> None:
    sim = mounted(KINDS[kind], (0.5, 0.0), 2.0)
    for _ in range(40):
        sim.step()
        told = sim.reactions
        assert told.separation.max() < 1e-3
        assert told.angular_separation.max() < 1e-3
    assert sim.orientation[0] == pytest.approx(2.0 * 40 / 64)


def test_door_on_a_disc_that_turns() -> None:
    """Its hinge goes around: seen from there, a pull outwards of the square of the rate."""
    rate, radius, step = 3.0, 0.6, 1 / 240

    def slope(time: float, state: Array) -> tuple[float, float]:
        away = state[0] - rate * time
        turn = -(rate**2) * radius * (LENGTH / 2) * math.sin(away) / (INERTIA + LENGTH**2 / 4)
        return state[1], turn

    scene = Scene(gravity=(0.0, 0.0))
    disc = scene.add_kinematic(
        Disc(radius=0.5), position=(0.0, 0.0), angular_velocity=rate, **SURFACE
    )
    door = scene.add_body(
        Box(width=LENGTH, height=0.05),
        mass=1.0,
        position=(radius, LENGTH / 2),
        orientation=math.pi / 2,
        velocity=(0.0, rate * radius),
        **SURFACE,
    )
    scene.add_joint(Revolute(), disc, door, anchor=(radius, 0.0), other_anchor=(-LENGTH / 2, 0.0))
    sim = Simulator(scene, time_step=step, compiled=False)
    right = solve_ivp(slope, (0, 1), (math.pi / 2, 0.0), rtol=1e-11, atol=1e-12, dense_output=True)
    for k in range(240):
        sim.step()
        assert sim.orientation[door] == pytest.approx(right.sol((k + 1) * step)[0], abs=2e-4)
    assert sim.reactions.separation.max() < 1e-5


def test_heavy_load_on_a_light_rope_below_a_hook_that_goes_to_and_fro() -> None:
    scene = Scene(gravity=(0.0, -G))
    hook = scene.add_kinematic(Disc(radius=0.1), position=(0.0, 0.0), **SURFACE)
    upper, links = hook, 10
    for k in range(links + 1):
        last = k == links
        link = Disc(radius=0.5) if last else Box(width=0.02, height=0.2)
        y = -0.2 * k - (0.5 if last else 0.1)
        body = scene.add_body(
            link, mass=672.0 if last else 1.0, position=(0.0, y), group=-1, **SURFACE
        )
        ends = {"anchor": (0.0, -0.1 * (k > 0)), "other_anchor": (0.0, 0.5 if last else 0.1)}
        scene.add_joint(Revolute(), upper, body, **ends)
        upper = body
    sim = plain(scene)
    longest, pushed = 0.0, np.zeros(2)
    for k in range(120):
        sim.velocity[hook] = (2.0 * math.sin(k / 20), 0.5 * math.sin(k / 10))
        sim.step()
        longest = max(longest, float(np.hypot(*(sim.position[upper] - sim.position[hook]))))
        pushed += sim.reactions.impulse[0, 1]
        assert sim.reactions.separation.max() < 1e-3 * 0.2
    assert longest < 2.5 * (1 + 1e-5)  # whole length, drawn straight
    masses = np.append(np.ones(links), 672.0)
    gained = masses @ sim.velocity[1:]
    assert pushed == pytest.approx(gained + np.array((0.0, masses.sum() * G * 2)), abs=1e-3)  # N s


def test_trolley_takes_what_its_load_gives() -> None:
    """It goes on as it is told, and what it exerts is what the momentum of the load shows."""
    sim = pendulum(2, 0.5, (0.7, 0.0), 1 / 60)
    for _ in range(60):
        before = sim.velocity[1:].sum(axis=0)
        sim.step()
        gained = sim.velocity[1:].sum(axis=0) - before
        impulse = sim.reactions.impulse[0]
        assert impulse[1] + (0.0, -2 * G / 60) == pytest.approx(gained, abs=1e-9)
        assert impulse[0] == pytest.approx(-impulse[1], abs=1e-9)
        assert sim.velocity[0].tolist() == [0.7, 0.0]
    assert sim.position[0] == pytest.approx((0.7, 0.0))


def carried(sim: Simulator, y: float, mass: float, velocity: tuple[float, float]) -> list[int]:
    """Hinge two planks of a mass each, kg, in a row to a hook that moves at a velocity, m/s."""
    planks: list[int] = []
    upper = sim.add_kinematic(
        Disc(radius=0.05), position=(0.0, y), velocity=velocity, restitution=0.0, mask=0
    )
    for k in range(2):
        plank = sim.add(Box(width=0.9, height=0.4), mass=mass, position=(0.5 + k, y), **SURFACE)
        sim.add_joint(
            Revolute(), upper, plank, anchor=(0.5 * (k > 0), 0.0), other_anchor=(-0.5, 0.0)
        )
        planks.append(plank)
        upper = plank
    return planks


@pytest.mark.parametrize("heavy", [100.0, 1e4])
@pytest.mark.parametrize("first", [0, 1])
def test_what_is_carried_over_another_mechanism_goes_with_its_hook(
    heavy: float, first: int
) -> None:
    """The bound was that of the first one's mass: 1e4 kg was told to go at 0.08 of 2 m/s."""
    sim = Simulator(Scene(gravity=(0.0, 0.0)), compiled=False)
    rows = [(0.0, 1.0, (0.0, 0.0)), (0.4, heavy, (2.0, -0.01))]
    planks = [carried(sim, *row) for row in (rows[::-1] if first else rows)]
    sim.step(10)
    np.testing.assert_allclose(sim.velocity[planks[1 - first], 0], 2.0, rtol=1e-3)


@pytest.mark.parametrize("mass", [10.0, 100.0])
def test_a_light_blade_that_is_carried_pushes_a_heavy_crate(mass: float) -> None:
    """It went along at 0.4 m/s, and 1 m/s was told of its hook alone."""
    rough: dict[str, Any] = {"restitution": 0.0, "friction": 0.5}
    scene = Scene(gravity=(0.0, -G))
    scene.add_static(HalfPlane(normal=(0.0, 1.0), offset=0.0), **rough)
    sim = plain(scene)
    crate = sim.add(Box(width=1.0, height=1.0), mass=mass, position=(1.12, 0.5), **rough)
    blade = sim.add(Box(width=0.2, height=0.8), mass=1.0, position=(0.5, 0.5), **rough)
    hook = sim.add_kinematic(
        Disc(radius=0.05), position=(0.5, 0.5), velocity=(1.0, 0.0), restitution=0.0, mask=0
    )
    sim.add_joint(Weld(), hook, blade)
    sim.step(60)
    start = sim.position[crate, 0]
    sim.step(60)
    assert sim.velocity[blade, 0] == pytest.approx(1.0, rel=1e-6)
    assert sim.position[crate, 0] - start == pytest.approx(1.0, rel=0.2)  # it goes in small leaps


def test_load_on_an_even_motion_gains_no_energy_as_seen_from_there() -> None:
    sim = pendulum(3, 1.5, (3.0, 0.0), 1 / 60)

    def energy() -> float:
        moving = ((sim.velocity[1:] - (3.0, 0.0)) ** 2).sum() + INERTIA * (
            sim.angular_velocity[1:] ** 2
        ).sum()
        return float(moving / 2 + G * sim.position[1:, 1].sum())

    start = energy()
    for _ in range(300):
        sim.step()
        assert energy() < start + 1e-9


def test_net_and_equal_trees_follow_their_supports() -> None:
    """A net of many loops is iterated, and equal trees are solved side by side."""
    scene = Scene(gravity=(0.0, -G))
    bar = scene.add_kinematic(Box(width=9.0, height=0.1), position=(4.0, 0.5), **SURFACE)
    disc = Disc(radius=0.4)
    held = {}
    for i in range(9):
        for j in range(9):
            held[i, j] = scene.add_body(
                disc, mass=1.0, position=(float(i), -float(j)), group=-1, **SURFACE
            )
            if j == 0:
                ends = {"anchor": (i - 4.0, 0.0), "other_anchor": (0.0, 0.5)}
                scene.add_joint(Revolute(), bar, held[i, j], **ends)
            else:
                ends = {"anchor": (0.0, -0.5), "other_anchor": (0.0, 0.5)}
                scene.add_joint(Revolute(), held[i, j - 1], held[i, j], **ends)
            if i:
                ends = {"anchor": (0.5, 0.0), "other_anchor": (-0.5, 0.0)}
                scene.add_joint(Revolute(), held[i - 1, j], held[i, j], **ends)
    rail = scene.add_kinematic(Box(width=9.0, height=0.1), position=(104.0, 0.5), **SURFACE)
    for i in range(9):
        upper = rail
        for j in range(3):
            ends = {"anchor": (i - 4.0, 0.0) if j == 0 else (0.0, -0.5), "other_anchor": (0.0, 0.5)}
            link = scene.add_body(
                disc, mass=1.0, position=(100.0 + i, -float(j)), group=-1, **SURFACE
            )
            scene.add_joint(Revolute(), upper, link, **ends)
            upper = link
    sim = plain(scene)
    for k in range(20):
        sim.velocity[[bar, rail]] = (0.5 * math.cos(k / 5), 0.0)
        sim.step()
        assert sim.reactions.separation.max() < 1e-3
    chains = sim.position[rail + 1 :].reshape(9, 3, 2) - sim.position[rail]
    assert np.abs(np.diff(chains[:, :, 0], axis=0) - 1.0).max() < 1e-9  # each as its neighbour


def test_chain_between_two_hooks_that_move_against_each_other() -> None:
    scene = Scene(gravity=(0.0, -G))
    hooks = [scene.add_kinematic(Disc(radius=0.1), position=(x, 0.0), **SURFACE) for x in (0, 3)]
    upper, links = hooks[0], 8
    for k in range(links):  # there is half as much again of it as it needs
        turn = 0.8411 * (-1) ** (k < links // 2)
        along = np.array((math.cos(turn), math.sin(turn))) * 3 / (links * math.cos(turn))
        start = along * k if k < links // 2 else np.array((3.0, 0.0)) - along * (links - k)
        link = scene.add_body(
            Box(width=0.5, height=0.05),
            mass=1.0,
            position=tuple((start + along / 2).tolist()),
            orientation=turn,
            group=-1,
            **SURFACE,
        )
        half = float(np.hypot(*along)) / 2
        ends = {"anchor": (half * (k > 0), 0.0), "other_anchor": (-half, 0.0)}
        scene.add_joint(Revolute(), upper, link, **ends)
        upper = link
    scene.add_joint(Revolute(), upper, hooks[1], anchor=(half, 0.0))
    sim = plain(scene)
    for k in range(60):
        sim.velocity[hooks] = [(0.8 * math.sin(k / 9), 0.2), (-0.8 * math.sin(k / 9), 0.0)]
        sim.step()
        assert sim.reactions.separation.max() < 2e-4
    assert np.abs(sim.velocity).max() < 10


def asleep_on(kind: str) -> tuple[Simulator, int, int]:
    """A bob that has fallen asleep below a hook of a kind; both bodies."""
    scene = Scene(gravity=(0.0, -G))
    add = scene.add_kinematic if kind == "kinematic" else scene.add_static
    hook = add(Disc(radius=0.1), position=(0.0, 0.0), **SURFACE)
    bob = scene.add_body(Disc(radius=0.1), mass=1.0, position=(0.0, -1.0), **SURFACE)
    scene.add_joint(Revolute(), hook, bob, other_anchor=(0.0, 1.0))
    sim = Simulator(scene, sleeping=True, compiled=False)
    sim.step(90)
    assert sim.asleep[bob]
    return sim, hook, bob


def test_mechanism_sleeps_on_a_support_at_rest_only() -> None:
    sim, hook, bob = asleep_on("kinematic")
    sim.velocity[hook] = (0.5, 0.0)
    sim.step()
    assert not sim.asleep[bob]
    sim.step(120)  # without damping it would swing for ever
    assert not sim.asleep[bob]
    assert sim.reactions.separation[0] < 1e-6


@pytest.mark.parametrize("kind", ["hinge", "weld", "wheel", "gear", "pulley"])
def test_compiled_code_gives_the_same_bits(kind: str) -> None:
    plainly, compiled = (mounted(KINDS[kind], (0.5, 0.0), 2.0, compiled=c) for c in (False, True))
    for k in range(20):
        for one in (plainly, compiled):
            one.velocity[0] = (0.5, 0.1 * k)
            one.position[0, 0] += 0.01 * (k == 10)
            one.step()
        assert plainly.digest() == compiled.digest()


def test_saved_and_copied_in_motion_it_goes_on_with_the_same_bits(tmp_path: Path) -> None:
    sim = pendulum(3, 0.5, (0.7, 0.0), 1 / 60)
    sim.step(10)
    sim.save(tmp_path / "crane.npz")
    others = [copy.copy(sim), Simulator.restore(tmp_path / "crane.npz", compiled=False)]
    for one in (sim, *others):
        one.velocity[0] = (-0.5, 0.2)
        one.step(10)
    assert len({one.digest() for one in (sim, *others)}) == 1


def test_stepped_runs_take_them_and_tell_reactions() -> None:
    scene = Scene(gravity=(0.0, -G))
    hook = scene.add_kinematic(
        Disc(radius=0.1), position=(0.0, 0.0), velocity=(1.0, 0.5), **SURFACE
    )
    bob = scene.add_body(None, mass=2.0, position=(0.0, -1.0), velocity=(1.0, 0.5))
    scene.add_joint(Distance(), hook, bob, name="rope")
    run = simulate(scene, duration=0.5)  # it is stepped, because a body is kinematic
    assert run.reactions.separation.max() < 1e-6
    assert run.reactions.force[:, 0, 1] == pytest.approx(np.array([[0.0, 2 * G]] * len(run.times)))
    assert run.reactions.power[:, 0] == pytest.approx(2 * G * 0.5)  # lifted at 0.5 m/s


def test_what_only_holds_what_moves_as_told_is_refused() -> None:
    scene = Scene(gravity=(0.0, -G))
    hook = scene.add_kinematic(Disc(radius=0.1), position=(0.0, 0.0), name="hook", **SURFACE)
    with pytest.raises(InputError, match="holds no body that moves"):
        Simulator(scene, compiled=False).add_joint(Revolute(), hook, (0.0, 0.0))


# -- moved by hand: what writes a pose gives no velocity, and joints follow within some steps


def moved_by_hand(kind: str, joint: Any, *, turn: float = 0.0, steps: int = 120) -> Simulator:
    """Return a bob on a body that was moved by 2 m, a bit before each of so many steps."""
    sim = plain(Scene(gravity=(0.0, -G)))
    add: Any = sim.add_static if kind == "static" else sim.add_kinematic
    hook = add(Disc(radius=0.1), position=(0.0, 0.0), restitution=0.0)
    bob = sim.add(Disc(radius=0.1), mass=1.0, position=(0.0, -1.0), restitution=0.0)
    sim.add_joint(joint, hook, bob, other_anchor=(0.0, 1.0), name="held")
    for _ in range(steps):
        sim.position[hook] += np.array((1.0, 1.0)) * math.sqrt(2) / steps
        sim.orientation[hook] += turn / steps
        sim.step()
    return sim


@pytest.mark.parametrize("kind", ["static", "kinematic"])
def test_joint_follows_what_is_moved_by_hand(kind: str) -> None:
    sim = moved_by_hand(kind, Revolute())
    assert sim.reactions.separation[0] < 0.02  # 1/60 m a step, of which a step leaves 0.8**4
    sim.step(10)
    assert sim.reactions.separation[0] < 1e-5
    assert sim.position[1] == pytest.approx(sim.position[0] + (0.0, -1.0), abs=0.3)


def test_weld_turns_with_what_is_turned_by_hand() -> None:
    sim = moved_by_hand("static", Weld(), turn=math.pi / 2)
    sim.step(30)
    assert sim.orientation[1] == pytest.approx(math.pi / 2, abs=1e-5)
    assert sim.position[1] == pytest.approx(sim.position[0] + (1.0, 0.0), abs=1e-5)


@pytest.mark.parametrize("lift", [0.5, 2.0])
def test_moved_at_once_it_comes_to_rest_there(lift: float) -> None:
    """It is lifted for nothing, though it stood still; then it has its energy, and no more."""
    sim = moved_by_hand("static", Revolute(), steps=0)
    sim.position[0] = (0.0, lift)
    sim.step(20)
    assert sim.position[1] == pytest.approx((0.0, lift - 1.0), abs=1e-6)
    assert np.abs(sim.velocity[1]).max() < 1e-6
    sim.step(300)
    assert sim.position[1] == pytest.approx((0.0, lift - 1.0), abs=1e-9)


def test_sleeping_load_wakes_as_its_hook_is_moved() -> None:
    sim, hook, bob = asleep_on("static")
    sim.position[hook] = (0.5, 0.0)
    sim.step(20)
    assert not sim.asleep[bob]
    assert sim.reactions.separation[0] < 1e-5


@pytest.mark.parametrize("stepped", [0, 3])
def test_saved_between_the_hand_and_the_step_it_follows_with_the_same_bits(
    tmp_path: Path, stepped: int
) -> None:
    sim = moved_by_hand("static", Revolute(), steps=0)
    last = sim.add(Disc(radius=0.1), mass=1.0, position=(0.0, -2.0), restitution=0.0)
    sim.add_joint(Revolute(), 1, last, other_anchor=(0.0, 1.0))
    sim.step(stepped)
    sim.position[0] = (0.2, 0.4)
    for _ in range(2):  # the second time it has followed already
        sim.save(tmp_path / "hook.npz")
        others = [copy.copy(sim), Simulator.restore(tmp_path / "hook.npz", compiled=False)]
        for one in (sim, *others):
            one.step(40)
        assert len({one.digest() for one in (sim, *others)}) == 1
    assert sim.reactions.separation.max() < 1e-4  # it swings on two hinges
