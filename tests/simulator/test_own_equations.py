"""Joints that a scene states by equations of its own, in the frame loop (TM7, IM15, R13)."""

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.errors import InputError
from tests.engine.scenes import ground, plain

G = 9.81
RATE = 3.0  # rad/s, at which the trolley goes to and fro
WAY = 0.3  # m, by which it does


def bead(speed: float = 0.0) -> t2.Scene:
    """A bead on a wire that is a parabola, y = x^2 in m."""
    scene = t2.Scene(gravity=(0.0, -G))
    velocity = (speed, 2 * speed)
    scene.add_body(None, mass=1.0, position=(1.0, 1.0), velocity=velocity, name="bead")
    scene.add_joint(t2.Equation("y(position_a)*1[m] - x(position_a)**2"), "bead", name="wire")
    return scene


def trolley() -> t2.Scene:
    """A pendulum on a trolley that goes to and fro as its equation says."""
    scene = t2.Scene(gravity=(0.0, -G))
    moving = {"velocity": (WAY * RATE, 0.0), "restitution": 0.0}
    box, disc = t2.Box(width=0.4, height=0.2), t2.Disc(radius=0.1)
    scene.add_body(box, mass=1.0, position=(0.0, 0.0), name="trolley", **moving)
    scene.add_body(disc, mass=2.0, position=(0.0, -1.0), name="bob", **moving)
    drive = [f"x(position_a) - {WAY}[m]*sin({RATE}[rad/s]*time)", "y(position_a)", "orientation_a"]
    scene.add_joint(t2.Equation(drive), "trolley", name="drive")
    scene.add_joint(t2.Revolute(), "trolley", "bob", other_anchor=(0.0, 1.0))
    return scene


@pytest.mark.parametrize("make", [bead, trolley])
def test_steps_converge_to_the_exact_way_with_order_two(make: Any) -> None:
    exact = t2.simulate(make(), duration=0.5, tolerance=1e-9).position[-1]
    errors = []
    for steps in (30, 60, 120):
        sim = plain(make(), time_step=0.5 / steps)
        sim.step(steps)
        errors.append(float(np.abs(sim.position - exact).max()))
        assert sim.reactions.separation.max() < 1e-9
    assert errors[0] / errors[1] == pytest.approx(4, abs=0.3)
    assert errors[1] / errors[2] == pytest.approx(4, abs=0.3)


def test_a_hinge_of_two_differences_keeps_the_momenta_of_what_nothing_ties() -> None:
    """Each of its rows keeps a direction in the plane, but bears nothing of it where both hold."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    rod = t2.Box(width=1.0, height=0.1)
    for k, (mass, spin, up) in enumerate(((1.0, 3.0, 0.2), (100.0, -0.5, 1.45))):
        moving: dict[str, Any] = {"velocity": (0.2, up), "angular_velocity": spin}
        scene.add_body(rod, mass=mass, position=(k + 0.5, 0.0), restitution=0.0, **moving)
    scene.add_joint(
        t2.Equation(["x(point_b - point_a)", "y(point_b - point_a)"]),
        *(0, 1),
        anchor=(0.5, 0.0),
        other_anchor=(-0.5, 0.0),
    )
    sim = plain(scene)
    masses = np.array([body.mass for body in scene.bodies])
    inertias = np.array([body.inertia for body in scene.bodies])

    def momenta() -> np.ndarray[Any, Any]:
        linear = masses @ sim.velocity
        (x, y), (u, v) = sim.position.T, sim.velocity.T
        about = masses @ (x * v - y * u) + inertias @ sim.angular_velocity
        return np.array([*linear, about])

    before = momenta()
    sim.step(30)
    assert momenta() == pytest.approx(before, abs=1e-11)
    assert sim.reactions.separation.max() < 1e-6


def test_velocities_are_those_of_the_drive_as_a_step_ends() -> None:
    sim = plain(trolley())
    for _ in range(60):
        sim.step()
        assert sim.velocity[0, 0] == pytest.approx(WAY * RATE * math.cos(RATE * sim.time), abs=1e-9)


ARMS = {"anchor": (0.2, 0.0), "other_anchor": (-0.3, 0.0)}
POSTS = "norm(point_a - vector(0[m], 2[m])) + 1.5*norm(point_b - vector(1[m], 2[m]))"
KINDS: list[tuple[Any, Any, dict[str, Any]]] = [
    (t2.Distance(), "norm(point_b - point_a) - 0.5[m]", ARMS),
    (
        t2.Weld(),
        ["point_b - point_a", "orientation_b - orientation_a"],
        {"anchor": (0.2, 0.0), "other_anchor": (-0.8, 0.0)},
    ),
    (t2.Gear(ratio=2.0), "orientation_b - 2*orientation_a", {}),
    (
        t2.Pulley(posts=((0.0, 2.0), (1.0, 2.0)), ratio=1.5),
        f"{POSTS} - {math.hypot(0.2, 2.0) + 1.5 * math.hypot(0.3, 2.0)!r}[m]",
        ARMS,
    ),
]


@pytest.mark.parametrize(("kind", "equation", "arms"), KINDS)
def test_a_kind_does_what_its_equation_does(kind: Any, equation: Any, arms: dict[str, Any]) -> None:
    ways = []
    for each in (kind, t2.Equation(equation)):
        scene = t2.Scene(gravity=(0.3, -G))
        for shape, mass, x in ((t2.Box(width=0.4, height=0.2), 1.0, 0.0), (None, 2.0, 1.0)):
            more: Any = {"restitution": 0.0} if shape else {"inertia": 0.1}
            scene.add_body(shape, mass=mass, position=(x, 0.0), **more)
        scene.add_joint(t2.Revolute(), 0, (0.0, 0.3), anchor=(0.0, 0.3))
        scene.add_joint(each, 0, 1, **arms)
        sim = plain(scene, time_step=1 / 120)
        sim.step(120)
        ways.append(np.column_stack((sim.position, sim.orientation)))
    assert ways[1] == pytest.approx(ways[0], abs=1e-11)  # 4e4 roundings of what is about 1


@pytest.mark.parametrize("make", [bead, trolley])
def test_compiled_steps_have_the_bits_of_plain_ones(make: Any) -> None:
    compiled, simple = t2.Simulator(make()), plain(make())
    compiled.step(40)
    simple.step(40)
    assert compiled.position.tobytes() == simple.position.tobytes()
    assert compiled.reactions.force.tobytes() == simple.reactions.force.tobytes()


def test_saved_simulators_go_on_with_the_same_bits(tmp_path: Path) -> None:
    sim = plain(trolley(), time_step=0.07)  # no step begins at a whole multiple of a power of 1/2
    sim.step(13)
    sim.save(tmp_path / "game.npz")
    again = t2.Simulator.restore(tmp_path / "game.npz", compiled=False)
    for one in (sim, again):
        one.step(20)
    assert again.position.tobytes() == sim.position.tobytes()
    assert again.velocity.tobytes() == sim.velocity.tobytes()


def test_worlds_that_are_reset_begin_with_time_zero() -> None:
    worlds = t2.Simulators(trolley(), worlds=2)
    worlds.step(20)
    first = worlds.position.copy()
    worlds.reset([True, False])
    worlds.step(20)
    assert worlds.position[0].tobytes() == first[0].tobytes()
    assert worlds.position[1].tobytes() != first[1].tobytes()


def test_a_drive_that_comes_later_goes_by_the_time_then() -> None:
    scene = t2.Scene(gravity=(0.0, -G))
    scene.add_body(t2.Disc(radius=0.1), mass=1.0, position=(0.0, 0.0), restitution=0.0)
    sim = plain(scene)
    sim.step(30)
    y = float(sim.position[0, 1])
    with pytest.raises(InputError, match="'early': it does not hold at the start: it is off by"):
        sim.add_joint(t2.Equation("x(position_a) - 0.1[m/s]*time"), 0, name="early")
    drive = ["x(position_a) - 0.1[m/s]*(time - 0.5[s])", f"y(position_a) - {y!r}[m]"]
    sim.add_joint(t2.Equation(drive.copy()), 0)
    sim.step(60)
    assert sim.position[0] == pytest.approx((0.1, y), abs=1e-9)
    assert sim.reactions.force[0, 0] == pytest.approx((0.0, G), abs=1e-9)


def test_what_time_drives_does_not_sleep_before_it_moves() -> None:
    """It is slower than what sleeps for more than a second; the other one may sleep."""
    scene = t2.Scene(gravity=(0.0, -G))
    ground(scene, 0.5)
    box = t2.Box(width=0.2, height=0.2)
    for x in (0.0, 1.0):
        scene.add_body(box, mass=1.0, position=(x, 0.1), friction=0.5, restitution=0.0)
    scene.add_joint(t2.Equation("x(position_a) - 1e-3[m/s^4]*time**4"), 1)
    scene.add_joint(t2.Equation("x(position_a) - 1[m]"), 2)
    sim = plain(scene, sleeping=True)
    sim.step(75)
    assert sim.asleep[1:].tolist() == [False, True]
    sim.step(105)
    assert sim.position[1, 0] == pytest.approx(0.081, abs=1e-6)


def test_a_lift_carries_what_stands_on_it() -> None:
    scene = t2.Scene(gravity=(0.0, -G))
    surface: Any = {"friction": 0.5, "restitution": 0.0}
    scene.add_body(t2.Box(width=2.0, height=0.2), mass=1.0, position=(0.0, 0.0), **surface)
    scene.add_body(t2.Box(width=0.5, height=0.5), mass=5.0, position=(0.0, 0.35), **surface)
    lift = ["x(position_a)", "y(position_a) - 0.2[m]*sin(4[rad/s]*time)**2", "orientation_a"]
    scene.add_joint(t2.Equation(lift), 0)
    sim = plain(scene)
    for _ in range(90):
        sim.step()
        height = 0.2 * math.sin(4 * sim.time) ** 2
        assert sim.position[0] == pytest.approx((0.0, height), abs=1e-4)
        assert sim.position[1] == pytest.approx((0.0, height + 0.35), abs=2e-3)


def test_a_bead_gains_no_energy() -> None:
    sim = plain(bead(), time_step=1 / 60)
    least = most = G
    for _ in range(600):
        sim.step()
        energy = G * sim.position[0, 1] + 0.5 * float(sim.velocity[0] @ sim.velocity[0])
        least, most = min(least, energy), max(most, energy)
    assert most <= G * (1 + 1e-12)  # 600 roundings
    assert least > 0.999 * G


def test_an_equation_breaks_as_other_joints_do() -> None:
    """At a speed v at the lowest point of the parabola, the wire bears m (g + 2 v^2 / m)."""
    bears = G + 2.0 * 2 * G
    for force, holds in ((1.01 * bears, True), (0.99 * bears, False)):
        scene = t2.Scene(gravity=(0.0, -G))
        scene.add_body(None, mass=1.0, position=(1.0, 1.0))
        wire = t2.Equation("y(position_a)*1[m] - x(position_a)**2")
        scene.add_joint(wire, 0, name="wire", break_force=force)
        sim = plain(scene, time_step=1 / 480)
        sim.step(480)
        assert (sim.joints == ("wire",)) == holds


def test_separations_are_ways_whatever_the_unit() -> None:
    sim = plain(bead())
    sim.position[0] = 1.0, 1.0 + 1e-6
    sim.add(None, mass=1.0, position=(3.0, 0.0))
    assert sim.reactions.separation[0] == pytest.approx(1e-6 / math.sqrt(5), rel=1e-5)
    assert sim.reactions.angular_separation[0] == 0.0


def test_a_target_moves_the_point_of_an_equation() -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(None, mass=1.0, inertia=1.0, position=(1.0, 0.0))
    scene.add_joint(t2.Equation("norm(point_b - point_a) - 1[m]"), 0, (0.0, 0.0), name="rod")
    sim = plain(scene)
    for k in range(60):
        sim.set_target("rod", (-0.01 * (k + 1), 0.0))
        sim.step()
    sim.step(30)
    assert sim.reactions.separation[0] < 1e-6
    assert abs(np.hypot(*(sim.position[0] - (-0.6, 0.0))) - 1.0) < 1e-6


@pytest.mark.parametrize("compiled", [True, False])
def test_an_equation_without_a_value_is_told_by_name(compiled: bool) -> None:
    scene = t2.Scene(gravity=(-G, 0.0))
    scene.add_body(t2.Disc(radius=0.1), mass=1.0, position=(1.0, 1.0), restitution=0.0)
    scene.add_joint(t2.Equation("y(position_a)/1[m] - sqrt(x(position_a)/1[m])"), 0, name="root")
    sim = t2.Simulator(scene, compiled=compiled)
    with pytest.raises(InputError, match=r"equation of joint 'root' has no value.*\(TM7\)"):
        sim.step(300)
    assert np.isfinite(sim.position).all()


@pytest.mark.parametrize("factor", [1e-3, 1e4])
def test_a_factor_of_an_equation_changes_nothing(factor: float) -> None:
    """Two rods are pulled straight and farther: they yield, and it is said by how much, in m."""
    found = []
    for by in (1.0, factor):
        scene = t2.Scene(gravity=(0.0, 0.0))
        hand = t2.Disc(radius=0.1)
        scene.add_kinematic(hand, position=(1.0, 0.0), restitution=0.0)
        scene.add_body(t2.Disc(radius=0.1), mass=1.0, position=(0.5, 0.6), restitution=0.0)
        length = math.hypot(0.5, 0.6)
        rod = f"{by!r}*(norm(position_b - position_a) - {length!r}[m])"
        scene.add_joint(t2.Equation(rod), 1, (0.0, 0.0), name="near")
        scene.add_joint(t2.Equation(rod), 1, 0, name="far")
        sim = plain(scene)
        sim.velocity[0] = 1.0, 0.0
        with pytest.warns(t2.StepWarning, match=r"'(near|far)' \(equation\).* apart") as told:
            sim.step(60)
        words = [str(each.message).partition(" apart")[0].rpartition(" ")[2] for each in told]
        found.append((*sim.position[1], *sim.velocity[1], *map(float, words)))
    assert found[1] == pytest.approx(found[0], rel=1e-6, abs=1e-9)  # as much as is solved


def test_a_light_body_on_a_long_arm_swings_as_with_a_kind() -> None:
    """What the pull does to the arm, second derivatives, lets it swing slowly enough (DD57)."""
    found = []
    for kind in (t2.Distance(), t2.Equation("norm(point_b - point_a) - 1[m]")):
        scene = t2.Scene(gravity=(0.0, 0.0))
        scene.add_body(None, mass=9.0, inertia=1.0, position=(0.0, 0.0))
        bob: Any = {"position": (0.3, -1.0), "velocity": (5.0, 0.0), "inertia": 1e-6}
        scene.add_body(None, mass=1.0, **bob)
        scene.add_joint(kind, 0, 1, other_anchor=(-0.3, 0.0))
        sim = plain(scene)
        sim.step(20)
        found.append((*sim.position[1], sim.orientation[1], sim.angular_velocity[1]))
    assert found[1] == pytest.approx(found[0], abs=1e-9)


def test_what_nothing_else_bears_keeps_its_momenta() -> None:
    """Two boxes with a rod between them, hit by a third: momentum and angular momentum stay."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    box, surface = t2.Box(width=0.4, height=0.2), {"friction": 0.5, "restitution": 0.3}
    for x, y, vx in ((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.9, 1.0, 0.0), (-1.0, 0.05, 3.0)):
        velocity = (vx, -2.0 if y == 1.0 else 0.0)
        scene.add_body(box, mass=1.0, position=(x, y), velocity=velocity, **surface)
    rod = "norm(point_b - point_a) - 0.8[m]"
    arms: Any = {"anchor": (0.1, 0.0), "other_anchor": (-0.1, 0.0)}
    scene.add_joint(t2.Equation(rod), 0, 1, **arms)
    sim = plain(scene)
    before = momenta_of(sim)
    sim.step(60)
    assert np.abs(sim.velocity[:2]).min() > 0.01
    assert momenta_of(sim) == pytest.approx(before, abs=1e-12)


def momenta_of(sim: t2.Simulator) -> list[float]:
    """Return momentum and angular momentum of bodies of 1 kg."""
    x, y = sim.position.T
    (vx, vy), spin = sim.velocity.T, sim.angular_velocity
    inertia = (0.4**2 + 0.2**2) / 12
    return [vx.sum(), vy.sum(), float(x @ vy - y @ vx + inertia * spin.sum())]
