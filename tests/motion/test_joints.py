"""Mechanisms against answers known from outside: benchmarks, statics, small oscillations.

The long answers are those of the multibody community: problems A01 to A03 of the IFToMM library of
benchmarks, and the slider and crank of SUNDIALS. Statics and oscillations are worked out by hand.
"""

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import tamias2d as t2
from tamias2d.contact import steps_because
from tamias2d.run import Run
from tamias2d.scene import Scene, catalogue
from tools.measurements.joints import four_bars

G = 9.81
TIGHT = t2.Dop853(rtol=1e-13)


def final(scene: Scene, duration: float, method: t2.Dop853 = TIGHT) -> Run:
    return t2.simulate(scene, duration=duration, method=method, times=[0.0, duration])


def rod(scene: Scene, name: str, middle: tuple[float, float], turn: float = 0.0) -> None:
    """A uniform rod of 1 kg and 1 m, which touches nothing; it points along x at first."""
    scene.add_body(None, mass=1, inertia=1 / 12, position=middle, orientation=turn, name=name)


def chain(links: int, mass: float = 1.0) -> Scene:
    """Point masses on rods without mass, hanging at rest."""
    scene = Scene(gravity=(0, -G))
    for k in range(links):
        scene.add_body(None, mass=mass, position=(0, -1.0 - k), name=f"m{k}")
        scene.add_joint(t2.Distance(length=1), f"m{k}", f"m{k - 1}" if k else (0, 0), name=f"l{k}")
    return scene


def test_a01_a_pendulum_is_where_elliptic_functions_put_it() -> None:
    run = final(catalogue.load("pendulum-a01"), 10.0)
    assert run.position[-1, 0] == pytest.approx((0.275087462576117, -0.961419205099125), abs=1e-12)
    assert run.energy[-1] == pytest.approx(run.energy[0], abs=1e-11)


@pytest.mark.parametrize(
    ("method", "steps", "order"),
    [
        (t2.ExplicitEuler(), 400, 1),
        (t2.SemiImplicitEuler(), 400, 1),
        (t2.VelocityVerlet(), 100, 2),
        (t2.RungeKutta4(), 30, 4),
    ],
)
def test_each_scheme_keeps_its_order_on_a_double_pendulum(
    method: t2.VelocityVerlet, steps: int, order: int
) -> None:
    scene = double_pendulum()
    errors = []
    for count in (steps, 2 * steps, 4 * steps):
        run = t2.simulate(scene, duration=1.0, method=method, time_step=1 / count, times=[1.0])
        errors.append(np.abs(run.orientation[-1] - (-1.2077162381906, -0.8143910230913)).max())
    assert math.log2(errors[1] / errors[2]) == pytest.approx(order, abs=0.35)


def double_pendulum() -> Scene:
    scene = Scene(gravity=(0, -G))
    rod(scene, "upper", (0.5, 0.0), math.pi / 2)
    rod(scene, "lower", (1.5, 0.0), math.pi / 2)
    scene.add_joint(t2.Revolute(), "upper", (0, 0), anchor=(0, 0.5))
    scene.add_joint(t2.Revolute(), "upper", "lower", anchor=(0, -0.5), other_anchor=(0, 0.5))
    return scene


def test_a_double_pendulum_of_rods_from_horizontal() -> None:
    run = t2.simulate(double_pendulum(), duration=2.0, method=TIGHT, times=[1.0, 2.0])
    assert run.orientation[0] == pytest.approx((-1.2077162381906, -0.8143910230913), abs=1e-12)
    assert run.orientation[1] == pytest.approx((-0.08275830682, 0.40736207491), abs=1e-11)


def test_the_slider_and_crank_of_sundials() -> None:
    run = t2.simulate(
        catalogue.load("slider-crank"), duration=10.0, method=TIGHT, times=[1.0, 10.0]
    )
    assert run.orientation[0, 0] == pytest.approx(1.3154205708817, abs=1e-13)
    assert run.position[0, 1, 0] == pytest.approx(1.0014918072308, abs=1e-13)
    assert run.orientation[1] == pytest.approx((1.275675848650, -0.498813049183), abs=1e-12)
    assert run.position[1, 1, 0] == pytest.approx(1.023578558980, abs=1e-12)


def test_a02_two_four_bars_pass_the_place_where_they_could_part() -> None:
    """Where all bars lie on one line, at 0.714 s; energy before and after says they went on.

    By the closed form all cranks turn alike: (N+1)/3 + N = 3 kg m^2, and (N+1)/2 + N = 3.5 kg m of
    weight, which gives the rate at each angle.
    """
    run = final(four_bars(2), 0.8, t2.Dop853(rtol=1e-11))
    turns, spins = run.orientation[-1, :3], run.angular_velocity[-1, :3]
    assert turns[0] < -math.pi / 2  # beyond
    assert np.ptp(turns) < 1e-9
    assert np.abs(run.orientation[-1, 3:]).max() < 1e-9
    fallen = 2 * 3.5 * G * (1 - math.cos(turns[0])) / 3
    assert spins[0] ** 2 == pytest.approx(1 + fallen, rel=1e-9)


def test_a02_ten_four_bars_pass_their_flat_places_in_few_steps() -> None:
    """An abrupt end of reactions takes tens of thousands of evaluations for each (GD19)."""
    run = final(four_bars(10), 1.5, t2.Dop853(rtol=1e-12))
    weight, inertia = 5.5 + 10, 11 / 3 + 10  # of the closed form, for angles from upright
    path = solve_ivp(
        lambda _, y: (y[1], weight / inertia * G * math.sin(y[0])),
        (0.0, 1.5),
        (0.0, 1.0),
        method="DOP853",
        rtol=3e-14,
        atol=1e-15,
    )
    assert -run.orientation[-1, :11] == pytest.approx(np.full(11, path.y[0, -1]), abs=1e-9)
    assert run.cost is not None
    assert run.cost.force_evaluations < 10_000


def test_a_chain_swings_with_the_roots_of_laguerre() -> None:
    """Five links: omega^2 = (g/l) x with the lowest root of the Laguerre polynomial L_5.

    A mode is started with an amplitude of 1e-4, of which the square, 1e-8, is left out.
    """
    x = 0.2635603197181
    mode = np.polynomial.laguerre.lagval(x, np.eye(6)[::-1].T)  # L_5(x) = 0 at the support, L_4...
    scene = Scene(gravity=(0, -G))
    before, small = (0.0, 0.0), 1e-4
    for k in range(5):
        side = small * float(mode[k + 1])
        reach = side - before[0]
        place = (side, before[1] - math.sqrt(1 - reach * reach))
        scene.add_body(None, mass=1, position=place, name=f"m{k}")
        scene.add_joint(t2.Distance(length=1), f"m{k}", f"m{k - 1}" if k else (0, 0))
        before = place
    period = 2 * math.pi / math.sqrt(G * x)
    run = t2.simulate(scene, duration=period, times=[period / 2, period])
    start = np.array([body.position for body in scene.bodies])
    assert run.position[1, :, 0] == pytest.approx(start[:, 0], rel=1e-8)
    assert run.position[0, :, 0] == pytest.approx(-start[:, 0], rel=1e-8)


def test_a_hanging_chain_bears_the_weight_below() -> None:
    run = t2.simulate(chain(7, mass=2.0), duration=0.1, times=[0.0, 0.1])
    pull = run.reactions.force[:, :, 0]
    below = [2.0 * G * (7 - k) for k in range(7)]
    assert pull[..., 1] == pytest.approx(np.array([below, below]), rel=1e-13)
    assert np.abs(pull[..., 0]).max() < 1e-12


def test_a_cantilever_bears_weight_and_moment_at_its_weld() -> None:
    scene = Scene(gravity=(0, -G))
    for k in range(4):
        rod(scene, f"r{k}", (k + 0.5, 0))
        other = f"r{k - 1}" if k else (0, 0)
        scene.add_joint(
            t2.Weld(), f"r{k}", other, anchor=(-0.5, 0), other_anchor=(0.5, 0) if k else (0, 0)
        )
    found = t2.simulate(scene, duration=0.5, times=[0.5]).reactions
    assert found.force[0, :, 0, 1] == pytest.approx([4 * G, 3 * G, 2 * G, G], rel=1e-12)
    moments = [G * n * n / 2 for n in (4, 3, 2, 1)]
    assert found.torque[0, :, 0] == pytest.approx(moments, rel=1e-12)


@pytest.mark.parametrize("ratio", [1.0, 2.0])
def test_atwoods_machine(ratio: float) -> None:
    """a = g (m1 - m2)/(m1 + m2), and with a tackle m1 beside m2/2 and m2/4."""
    scene = Scene(gravity=(0, -G))
    scene.add_body(None, mass=3, position=(0, -5), name="one")
    scene.add_body(None, mass=1, position=(1, -5), name="other")
    scene.add_joint(t2.Pulley(posts=[(0, 0), (1, 0)], ratio=ratio), "one", "other")
    run = final(scene, 1.0)
    fall = -G * (3 - 1 / ratio) / (3 + 1 / ratio**2)
    assert run.position[-1, 0, 1] + 5 == pytest.approx(fall / 2, rel=1e-12)
    assert run.position[-1, 1, 1] + 5 == pytest.approx(-fall / 2 / ratio, rel=1e-12)
    assert run.reactions.force[0, 0, 0, 1] == pytest.approx(3 * (G + fall), rel=1e-12)


def test_a_planetary_gear_turns_its_carrier() -> None:
    """Sun and ring of 12 and 36 teeth, the ring held: the carrier turns a quarter of the sun.

    A torque T on the sun accelerates what the inertias make, reduced to the sun.
    """
    scene = Scene(gravity=(0, 0))
    scene.add_body(None, mass=1, inertia=2, position=(0, 0), torque=3, name="sun")
    scene.add_body(None, mass=1, inertia=5, position=(0, 0), name="carrier")
    scene.add_body(None, mass=1, inertia=0.5, position=(2, 0), name="planet")
    for name in ("sun", "carrier"):
        scene.add_joint(t2.Revolute(), name, (0, 0))
    scene.add_joint(t2.Revolute(), "carrier", "planet", anchor=(2, 0))
    scene.add_joint(t2.Gear(ratio=-1), "sun", "planet", third="carrier")
    scene.add_joint(t2.Gear(ratio=36 / 12), (0, 0), "planet", third="carrier")  # in the ring
    run = final(scene, 1.0)
    sun, carrier, planet = run.orientation[-1]
    assert carrier == pytest.approx(sun / 4, rel=1e-12)
    assert planet == pytest.approx(-2 * carrier, rel=1e-12)
    inertia = 2 + (5 + 1 * 2**2) / 16 + 0.5 / 4
    assert sun == pytest.approx(3 / inertia / 2, rel=1e-12)


def test_a_drive_turns_as_its_equation_says_and_its_power_lifts() -> None:
    scene = Scene(gravity=(0, -G))
    scene.add_body(
        None,
        mass=1,
        inertia=1 / 12,
        position=(0.5, 0),
        velocity=(0, 1),
        angular_velocity=2,
        name="arm",
    )
    scene.add_joint(t2.Revolute(), "arm", (0, 0), anchor=(-0.5, 0))
    scene.add_joint(t2.Equation("orientation_a - 2[rad/s]*time"), "arm", name="drive")
    times = np.linspace(0, 3, 7)
    run = t2.simulate(scene, duration=3.0, times=times)
    assert run.orientation[:, 0] == pytest.approx(2 * times, abs=1e-12)
    power = run.reactions.power
    assert power[:, 1] == pytest.approx(G * np.cos(2 * times), abs=1e-10)  # m g times the rise
    assert np.abs(power[:, 0]).max() < 1e-12


def test_bodies_welded_twice_move_as_one_and_the_run_says_what_is_left_open() -> None:
    scene = Scene(gravity=(0, -G))
    rod(scene, "one", (0, 0))
    rod(scene, "other", (1, 0))
    scene.add_joint(t2.Weld(), "one", "other", anchor=(0.5, 0), other_anchor=(-0.5, 0), name="left")
    scene.add_joint(
        t2.Weld(), "one", "other", anchor=(0.4, 0), other_anchor=(-0.6, 0), name="right"
    )
    scene.add_joint(t2.Revolute(), "one", (-0.5, 0), anchor=(-0.5, 0))
    run = final(scene, 1.0)
    assert run.energy[-1] == pytest.approx(run.energy[0], abs=1e-10)
    assert run.reactions.separation.max() < 1e-14
    assert any("'left', 'right'" in note for note in run.notes)


def test_a_windmill_of_four_welds_stays_at_rest() -> None:
    scene = Scene(gravity=(0, 0))
    scene.add_body(None, mass=1, inertia=1, position=(0, 0), name="hub")
    for k, (x, y) in enumerate(((2, 0), (0, 2), (-2, 0), (0, -2))):
        scene.add_body(None, mass=1, inertia=1, position=(x, y), name=f"sail{k}")
        scene.add_joint(t2.Weld(), "hub", f"sail{k}", other_anchor=(-x, -y))
    run = final(scene, 10.0)
    assert np.array_equal(run.position[-1], run.position[0])
    assert not run.orientation[-1].any()


def test_a_heavy_ball_on_a_light_chain_hangs_straight() -> None:
    """672 to 1, as in the benchmark of game engines: nothing moves, and the top bears it all."""
    scene = chain(20)
    scene.add_body(None, mass=672, position=(0, -21), name="ball")
    scene.add_joint(t2.Distance(length=1), "ball", "m19")
    run = final(scene, 1.0, t2.Dop853(rtol=1e-10))
    assert np.abs(run.position[-1] - run.position[0]).max() < 1e-12
    assert run.reactions.force[-1, 0, 0, 1] == pytest.approx(692 * G, rel=1e-12)


def test_a_taut_bridge_has_no_finite_tension() -> None:
    scene = Scene(gravity=(0, -G))
    for k in range(4):
        rod(scene, f"plank{k}", (k + 0.5, 0))
        other = f"plank{k - 1}" if k else (0, 0)
        scene.add_joint(
            t2.Revolute(),
            f"plank{k}",
            other,
            anchor=(-0.5, 0),
            other_anchor=(0.5, 0) if k else (0, 0),
        )
    scene.add_joint(t2.Revolute(), "plank3", (4, 0), anchor=(0.5, 0), name="end")
    with pytest.raises(t2.JointError, match=r"'end' at 0.0 s: no finite .* taut"):
        t2.simulate(scene, duration=1.0)


def test_bodies_that_a_joint_holds_pass_through_each_other_unless_they_collide() -> None:
    def scene(**collide: bool) -> Scene:
        made = Scene(gravity=(0, 0))
        made.add_static(t2.Disc(radius=1), name="wheel", restitution=1)
        made.add_body(t2.Disc(radius=0.5), mass=1, position=(3, 0), velocity=(-1, 0), name="ball")
        made.add_joint(t2.Groove(axis=(1, 0)), "wheel", "ball", **collide)
        return made

    run = final(scene(), 3.0)
    assert run.position[-1, 1] == pytest.approx((0, 0), abs=1e-12)
    bounced = final(scene(collide=True), 3.0)
    assert bounced.impacts.time == pytest.approx([1.5])
    assert bounced.velocity[-1, 1] == pytest.approx((1, 0), abs=1e-12)


def struck_rod(distance: float, restitution: float, *, pivot: bool = True) -> Run:
    """A rod of 1 kg and 1 m, hit by a ball of 1 kg at 1 m/s, so far from the pivot at its end."""
    scene = Scene(gravity=(0, 0))
    scene.add_body(
        t2.Box(width=0.02, height=1), mass=1, inertia=1 / 12, position=(0, -0.5), name="rod",
        restitution=restitution,
    )  # fmt: skip
    if pivot:
        scene.add_joint(t2.Revolute(), "rod", (0, 0), anchor=(0, 0.5))
    scene.add_body(
        t2.Disc(radius=0.01), mass=1, position=(-1, -distance), velocity=(1, 0), name="ball",
        restitution=restitution,
    )  # fmt: skip
    return final(scene, 1.1)


@pytest.mark.parametrize("restitution", [1.0, 0.5])
@pytest.mark.parametrize("distance", [0.5, 0.8])
def test_a_rod_on_a_pivot_takes_the_angular_momentum_of_a_ball(
    distance: float, restitution: float
) -> None:
    """I w + m d v = m d about the pivot, I = 1/3, and w d - v = restitution."""
    run = struck_rod(distance, restitution)
    spin = (1 + restitution) * distance / (1 / 3 + distance**2)
    assert run.angular_velocity[-1, 0] == pytest.approx(spin, rel=1e-13)
    assert run.velocity[-1, 1] == pytest.approx((spin * distance - restitution, 0), abs=1e-13)
    assert run.impacts.impulse == pytest.approx([1 - spin * distance + restitution], rel=1e-13)


def test_at_the_centre_of_percussion_the_pivot_feels_nothing() -> None:
    held, free = struck_rod(2 / 3, 1.0), struck_rod(2 / 3, 1.0, pivot=False)
    assert held.angular_velocity[-1, 0] == pytest.approx(free.angular_velocity[-1, 0], rel=1e-13)


def test_a_chain_of_rods_bounces_without_gaining_energy_and_without_tearing() -> None:
    scene = Scene(gravity=(0, -G))
    scene.add_static(t2.HalfPlane(normal=(0, 1), offset=-1.2), name="floor")
    for k in range(2):
        scene.add_body(
            t2.Box(width=1, height=0.05),
            mass=1,
            position=(k + 0.5, 0),
            name=f"r{k}",
            restitution=0.7,
        )
        anchors = {"anchor": (-0.5, 0), "other_anchor": (0.5, 0)} if k else {"anchor": (-0.5, 0)}
        scene.add_joint(t2.Revolute(), f"r{k}", f"r{k - 1}" if k else (0, 0), **anchors)  # type: ignore[arg-type]
    run = t2.simulate(scene, duration=0.8)
    assert len(run.impacts) > 0
    assert np.diff(run.energy).max() < 1e-11
    assert run.energy[-1] < run.energy[0] - 1
    assert run.reactions.separation.max() < 1e-14


def test_a_jointed_body_comes_to_rest_on_the_floor() -> None:
    scene = Scene(gravity=(0, -G))
    scene.add_static(t2.HalfPlane(normal=(0, 1), offset=0), restitution=0, name="floor")
    scene.add_body(t2.Disc(radius=0.5), mass=1, position=(0, 1), name="ball")
    scene.add_joint(t2.Groove(axis=(0, 1)), (0, 0), "ball")
    run = t2.simulate(scene, duration=1.0, method=t2.Reference())
    np.testing.assert_allclose(run.position[-1, 1], (0, 0.5), rtol=0, atol=1e-14)
    np.testing.assert_allclose(run.velocity[-1, 1], 0, atol=1e-14)
    assert "joint" in str(steps_because(scene, 1.0))  # what is taken where nothing else is asked


@pytest.mark.parametrize("method", [t2.Legacy2018(), t2.ExponentialDrag(), t2.ClosedForm()])
def test_a_method_that_knows_no_joints_says_so(method: t2.Legacy2018) -> None:
    step = 0.01 if method.fixed_step else None
    with pytest.raises(t2.InputError, match=r"joint"):
        t2.simulate(chain(2), duration=1.0, method=method, time_step=step)


@pytest.mark.parametrize("place", [(1.0, 1.0), (1e-3, 1e-6), (30.0, 900.0)])
def test_a_bead_stays_on_a_wire_that_a_scene_states(place: tuple[float, float]) -> None:
    """One body, held at its centre: nothing but its place says how large the mechanism is."""
    scene = Scene(gravity=(0, -G))
    scene.add_body(None, mass=1, position=place, name="bead")
    scene.add_joint(t2.Equation("y(position_a)*1[m] - x(position_a)**2"), "bead")
    run = t2.simulate(scene, duration=1.0, times=[0.0, 0.5, 1.0])
    x, y = run.position[:, 0].T
    assert np.abs(y - x * x).max() <= 4 * np.spacing(place[1])
    assert run.energy[-1] == pytest.approx(run.energy[0], rel=1e-10)


def test_a_bob_whose_thread_breaks_bounces_on_a_floor_until_it_lies() -> None:
    """A joint that might break kept contacts from lasting, and the run ended there."""
    scene = Scene(gravity=(0, -G))
    scene.add_static(t2.HalfPlane(normal=(0, 1), offset=-2), restitution=0.2, name="floor")
    bob = scene.add_body(t2.Disc(radius=0.1), mass=2, position=(1, 0), name="bob")
    scene.add_joint(t2.Distance(), (0, 0), "bob", name="thread", break_force=30.0)
    run = t2.simulate(scene, duration=2.0)
    assert isinstance(run.method, t2.Reference)
    assert run.joint_events.words == ("breaks",)
    assert run.position[-1, bob, 1] == pytest.approx(-1.9, abs=1e-12)
    assert run.velocity[-1, bob, 1] == pytest.approx(0.0, abs=1e-12)
