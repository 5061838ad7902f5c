"""Limits, motors and springs of joints, and their breaking, against answers worked out by hand.

Where nothing is said the reference steps: it errs by some 1e-13 of a value.
"""

import math
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.special import ellipkinc

import tamias2d as t2
from tamias2d.motion.joint_events import WORDS
from tamias2d.run import Run
from tamias2d.scene import Scene

G = 9.81


def wheel(scene: Scene, name: str = "wheel", **given: float) -> None:
    scene.add_body(None, mass=1, inertia=2, position=(0, 0), name=name, **given)


def told(run: Run) -> list[tuple[float, str]]:
    return [(event.time, WORDS[event.what]) for event in run.joint_events]


@pytest.mark.parametrize("restitution", [0.0, 0.5, 1.0])
def test_a_rope_lets_fall_until_it_is_taut(restitution: float) -> None:
    """A fall of 0.5 m, sqrt(2 h/g); back at the share of the speed for twice the share of that."""
    scene = Scene(gravity=(0, -G))
    scene.add_body(None, mass=2, position=(0, 0.5), name="load")
    limits = t2.Limits(upper=1.0, restitution=restitution)
    scene.add_joint(t2.Distance(limits=limits), "load", (0, 1), name="rope")
    run = t2.simulate(scene, duration=1.0, times=[0.0, 1.0])
    fall = math.sqrt(2 * 0.5 / G)
    events = run.joint_events
    assert events.words[0] == "strikes its upper limit"
    assert events.time[0] == pytest.approx(fall, rel=1e-13)
    assert events.value[0] == pytest.approx(2 * (1 + restitution) * G * fall, rel=1e-13)
    if restitution:
        assert events.time[1] == pytest.approx(fall * (1 + 2 * restitution), rel=1e-12)
    else:
        assert events.words[1] == "rests on its upper limit"
        assert run.position[-1, 0] == pytest.approx((0, 0), abs=1e-14)
        assert run.reactions.force[-1, 0, 0] == pytest.approx((0, 2 * G), rel=1e-13)


def test_bounces_on_a_limit_end_when_the_geometric_series_does() -> None:
    scene = Scene(gravity=(0, -G))
    scene.add_body(None, mass=2, position=(0, 0.5), name="load")
    scene.add_joint(t2.Distance(limits=t2.Limits(upper=1.0, restitution=0.5)), "load", (0, 1))
    run = t2.simulate(scene, duration=2.0, times=[0.0, 2.0])
    end = math.sqrt(2 * 0.5 / G) * (1 + 2 * 0.5 / (1 - 0.5))
    when, what = told(run)[-1]
    assert what == "rests on its upper limit"
    below = 2 * math.sqrt(2e-12 / G) / (1 - 0.5)  # s, of bounces below 1e-12 of the length
    assert when == pytest.approx(end, abs=below)
    assert run.position[-1, 0, 1] == pytest.approx(0, abs=1e-14)


def bounced(drop: float, restitution: float, times: np.ndarray) -> np.ndarray:
    """Heights of what falls from rest and bounces on the height 0, by its parabolas."""
    heights = np.zeros(len(times))
    start, speed = -math.sqrt(2 * drop / G), math.sqrt(2 * drop * G)  # as if thrown up before
    while speed > 1e-9:
        end = start + 2 * speed / G
        on = (times >= start) & (times < end)
        heights[on] = (speed - G / 2 * (times[on] - start)) * (times[on] - start)
        start, speed = end, restitution * speed
    return heights


@pytest.mark.parametrize("restitution", [0.0, 0.1, 0.3, 0.6, 0.9])
@pytest.mark.parametrize("drop", [1.0, 1e-6])
def test_a_slide_of_no_length_at_its_limit_comes_to_rest_there(
    drop: float, restitution: float
) -> None:
    """All places of the mechanism are the origin then; the bounces become ever shorter steps."""
    scene = Scene(gravity=(0, -G))
    scene.add_body(None, mass=1, inertia=1, position=(0, drop), name="slider")
    kind = t2.Prismatic(axis=(0, 1), limits=t2.Limits(lower=0.0, restitution=restitution))
    scene.add_joint(kind, (0, 0), "slider")
    fall = math.sqrt(2 * drop / G)
    times = fall * np.linspace(0, 6, 61)
    run = t2.simulate(
        scene, duration=float(times[-1]), tolerance=1e-6, times=times, work_limit=2000
    )
    assert run.certificate is not None
    assert run.certificate.bound is not None
    away = np.abs(run.position[:, 0, 1] - bounced(drop, restitution, times))
    rounded = 1e-12  # of the drop: bounces that are as low count as rest
    assert away.max() <= (run.certificate.bound + rounded) * drop
    if restitution < 0.7:  # else it still bounces
        assert run.joint_events.words[-1] == "rests on its lower limit"


@pytest.mark.parametrize("restitution", [0.1, 0.3, 0.6])
@pytest.mark.parametrize("method", [t2.Dop853(rtol=1e-4), t2.DormandPrince5(rtol=1e-5)])
def test_bounces_that_are_far_shorter_than_the_steps_are_found(
    method: t2.Dop853 | t2.DormandPrince5, restitution: float
) -> None:
    """From 1 um within 10 s: a step of free fall is 500 m long, and its rounding a bounce."""
    scene = Scene(gravity=(0, -G))
    scene.add_body(None, mass=1, inertia=1, position=(0, 1e-6), name="slider")
    kind = t2.Prismatic(axis=(0, 1), limits=t2.Limits(lower=0.0, restitution=restitution))
    scene.add_joint(kind, (0, 0), "slider")
    run = t2.simulate(scene, duration=10.0, method=method, times=[10.0], work_limit=2000)
    speed = math.sqrt(2e-6 * G)
    strikes = [e.value for e in run.joint_events if WORDS[e.what].startswith("strikes")]
    expected = [speed * (1 + restitution) * restitution**k for k in range(4)]
    assert strikes[:4] == pytest.approx(expected, rel=1e-9)
    rounded = 500 * 2.0**-52  # m, of such a step: bounces as low as this are lost in it
    below = 2 * math.sqrt(2 * rounded / G) / (1 - restitution)
    when, what = told(run)[-1]
    assert what == "rests on its lower limit"
    ends = speed / G * (1 + 2 * restitution / (1 - restitution))
    assert when == pytest.approx(ends, abs=below)


@pytest.mark.parametrize("method", [t2.Dop853(rtol=1e-4), t2.Reference()])
def test_a_shortest_distance_is_met_although_steps_pass_through_its_centre(
    method: t2.Dop853 | t2.Reference,
) -> None:
    """Upright, thrown up at 3 m/s between 0.5 m and 1.5 m: parabolas from end to end."""
    scene = Scene(gravity=(0, -G))
    scene.add_body(None, mass=1, position=(0, 1.2), velocity=(0, 3), name="bob")
    limits = t2.Limits(lower=0.5, upper=1.5, restitution=0.1)
    scene.add_joint(t2.Distance(limits=limits), "bob", (0, 0))
    run = t2.simulate(scene, duration=10.0, method=method, times=[10.0], work_limit=2000)
    up = math.sqrt(9 - 2 * G * 0.3)
    down = math.sqrt((0.1 * up) ** 2 + 2 * G)
    first = (3 - up) / G
    second = first + (down - 0.1 * up) / G
    assert run.joint_events.time[:2] == pytest.approx([first, second], rel=1e-12)
    assert min(event.value for event in run.joint_events) >= 0
    assert 0.5 - 1e-12 <= run.position[-1, 0, 1] <= 1.5


@pytest.mark.parametrize("speed", [6.0, 6.1, 6.2, 6.3])
def test_a_rope_is_taut_again_beyond_its_post(speed: float) -> None:
    """Thrown up from 0.5 m below it to 1 m above: at the post the distance has no rate."""
    scene = Scene(gravity=(0, -G))
    scene.add_body(None, mass=1, position=(0, -0.5), velocity=(0, speed), name="bob")
    scene.add_joint(t2.Distance(limits=t2.Limits(upper=1.0, restitution=0.9)), "bob", (0, 0))
    run = t2.simulate(scene, duration=4.0, method=t2.Dop853(rtol=1e-4), times=[4.0])
    taut = (speed - math.sqrt(speed**2 - 2 * G * 1.5)) / G
    assert run.joint_events.time[0] == pytest.approx(taut, rel=1e-13)


def test_a_step_too_coarse_to_locate_its_event_again_still_ends() -> None:
    """Taken anew up to the event it is elsewhere, and a line to the event leads out of it."""
    scene = Scene(gravity=(0, -G))
    scene.add_body(None, mass=1, position=(0, 1.2), velocity=(0, 3), name="bob")
    limits = t2.Limits(lower=0.5, upper=1.5, restitution=0.1)
    scene.add_joint(t2.Distance(limits=limits), "bob", (0, 0))
    for method in (t2.ExplicitEuler(), t2.SemiImplicitEuler()):
        run = t2.simulate(scene, duration=10.0, method=method, time_step=1.25, times=[10.0])
        assert np.isfinite(run.position).all()


def test_a_ball_goes_over_the_top_of_its_rope_and_falls_inwards() -> None:
    """Thrown up from the lowest point at v^2 = 3.5 g l it leaves the circle at sin(angle) = 1/2.

    There the rope is slack: v^2/l = g sin(angle), with v^2 = 3.5 g l - 2 g l (1 + sin(angle)).
    The time to it is the pendulum's, an elliptic integral; on it flies along a parabola.
    """
    scene = Scene(gravity=(0, -G))
    speed = math.sqrt(3.5 * G)
    scene.add_body(None, mass=1, position=(0, -1), velocity=(speed, 0), name="ball")
    scene.add_joint(t2.Distance(limits=t2.Limits(upper=1, restitution=0)), "ball", (0, 0))
    turn = math.radians(90 + 30)  # from hanging
    modulus = math.sqrt(4 * G / speed**2)  # above 1: it does not go around
    leaves = 2 / speed * ellipkinc(math.asin(modulus * math.sin(turn / 2)), modulus**-2) / modulus
    run = t2.simulate(scene, duration=leaves + 0.1, times=[0.0, leaves + 0.1])
    left = [time for time, what in told(run) if what == "leaves its upper limit"]
    assert left == pytest.approx([leaves], rel=1e-11)
    there, fast = (math.cos(math.pi / 6), math.sin(math.pi / 6)), math.sqrt(G / 2)
    after = (there[0] - fast * 0.05, there[1] + fast * there[0] * 0.1 - G * 0.005)
    assert run.position[-1, 0] == pytest.approx(after, abs=1e-11)


def test_a_hinge_comes_to_its_stop_and_leans_on_it() -> None:
    """A rod falls from horizontal to 1 rad below: I w^2/2 = m g sin(1)/2 with I = 1/3."""
    scene = Scene(gravity=(0, -G))
    scene.add_body(None, mass=1, inertia=1 / 12, position=(0.5, 0), name="rod")
    kind = t2.Revolute(limits=t2.Limits(lower=-1, restitution=0))
    scene.add_joint(kind, (0, 0), "rod", other_anchor=(-0.5, 0), name="stop")
    run = t2.simulate(scene, duration=1.0, times=[0.0, 1.0])
    spin = math.sqrt(3 * G * math.sin(1))
    assert run.joint_events.value[0] == pytest.approx(spin / 3, rel=1e-12)
    assert run.orientation[-1, 0] == pytest.approx(-1, abs=1e-14)
    assert run.reactions.torque[-1, 0, 1] == pytest.approx(G / 2 * math.cos(1), rel=1e-12)
    assert run.reactions.separation.max() < 1e-14


def test_a_limit_pushes_and_never_pulls() -> None:
    """A rod that starts at its upper stop falls as one without: I a = m g/2 at first."""
    ends = []
    for limits in (None, t2.Limits(upper=0, restitution=0)):
        scene = Scene(gravity=(0, -G))
        scene.add_body(None, mass=1, inertia=1 / 12, position=(0.5, 0), name="rod")
        scene.add_joint(t2.Revolute(limits=limits), (0, 0), "rod", other_anchor=(-0.5, 0))
        ends.append(t2.simulate(scene, duration=0.5, times=[0.5]))
    assert ends[1].orientation == pytest.approx(ends[0].orientation, rel=1e-12)
    assert not len(ends[1].joint_events)


def test_a_limit_that_is_met_for_a_moment_is_not_missed() -> None:
    """Thrown up at v, the top is v^2/(2 g); 0.1 mm below it a limit is met 9 ms long, if at all."""
    scene = Scene(gravity=(0, -G))
    scene.add_body(None, mass=1, inertia=1, position=(0, 0), velocity=(0, G), name="ball")
    top = G / 2 - 1e-4
    kind = t2.Groove(axis=(0, 1), limits=t2.Limits(upper=top, restitution=1))
    scene.add_joint(kind, (0, 0), "ball")
    run = t2.simulate(scene, duration=1.9, times=[1.9])
    assert run.joint_events.time == pytest.approx([1 - math.sqrt(2e-4 / G)], rel=1e-11)


def test_an_event_is_at_the_end_of_a_step_where_a_method_knows_most() -> None:
    """With coarse steps the limit is met where the ends of steps say, to rounding."""
    scene = Scene(gravity=(0, 0))
    scene.add_body(None, mass=1, position=(0.5, 0), velocity=(1, 3), name="ball")
    scene.add_spring("ball", (0, 0), stiffness=7, rest_length=0.4)
    scene.add_joint(t2.Distance(limits=t2.Limits(upper=1, restitution=1)), "ball", (0, 0))
    method = t2.DormandPrince5(rtol=1e-4)
    first = t2.simulate(scene, duration=1.0, method=method, times=[1.0]).joint_events.time[0]
    run = t2.simulate(scene, duration=1.0, method=method, times=[first])
    assert np.hypot(*run.position[0, 0]) == pytest.approx(1, abs=1e-12)


def test_impulses_of_two_stops_at_one_instant_are_found_together() -> None:
    """Two discs on one slide, thrown at the end of a rope each: momentum and restitution."""
    scene = Scene(gravity=(0, 0))
    for name, place in (("near", 1.0), ("far", 2.0)):
        scene.add_body(None, mass=1, position=(place, 0), velocity=(1, 0), name=name)
    stop = t2.Limits(upper=1.5, restitution=0.5)
    scene.add_joint(t2.Distance(limits=stop), "near", (0, 0))
    scene.add_joint(t2.Distance(limits=stop), "far", (1, 0))
    run = t2.simulate(scene, duration=1.0, times=[1.0])
    assert run.joint_events.time == pytest.approx([0.5, 0.5], rel=1e-14)
    assert run.velocity[-1, :, 0] == pytest.approx([-0.5, -0.5], rel=1e-13)


def test_a_rope_between_two_bodies_shares_its_impulse_by_their_masses() -> None:
    scene = Scene(gravity=(0, 0))
    scene.add_body(None, mass=1, position=(0, 0), velocity=(-1, 0), name="light")
    scene.add_body(None, mass=3, position=(1, 0), velocity=(1, 0), name="heavy")
    scene.add_joint(t2.Distance(limits=t2.Limits(upper=2, restitution=0.25)), "light", "heavy")
    run = t2.simulate(scene, duration=1.0, times=[1.0])
    assert run.joint_events.time == pytest.approx([0.5], rel=1e-14)
    impulse = 1.25 * 2 / (1 + 1 / 3)
    assert run.joint_events.value == pytest.approx([impulse], rel=1e-13)
    assert run.velocity[-1, :, 0] == pytest.approx([-1 + impulse, 1 - impulse / 3], rel=1e-13)


def test_a_motor_pushes_with_its_maximum_and_then_keeps_its_speed() -> None:
    scene = Scene(gravity=(0, 0))
    wheel(scene)
    scene.add_joint(t2.Revolute(motor=t2.Motor(speed=3, maximum=4)), (0, 0), "wheel", name="motor")
    run = t2.simulate(scene, duration=3.0, times=[1.0, 3.0])
    assert told(run)[1] == (pytest.approx(1.5, rel=1e-12), "keeps the speed of its motor")
    assert run.orientation[:, 0] == pytest.approx([1.0, 2.25 + 4.5], rel=1e-12)
    assert run.reactions.power[:, 0] == pytest.approx([8.0, 0.0], abs=1e-11)
    assert run.reactions.speed[:, 0] == pytest.approx([2.0, 3.0], rel=1e-12)


def test_a_motor_gives_way_where_the_load_outgrows_it() -> None:
    """Against a torque of 2 N m/s times time, 4 N m are enough for 2 s; then I a = 4 - 2 t."""
    scene = Scene(gravity=(0, 0))
    wheel(scene, torque="-2[N*m/s]*time", angular_velocity=3.0)
    scene.add_joint(t2.Revolute(motor=t2.Motor(speed=3, maximum=4)), (0, 0), "wheel")
    run = t2.simulate(scene, duration=3.0, times=[1.0, 3.0])
    when, what = told(run)[1]
    assert (when, what) == (pytest.approx(2, rel=1e-12), "pushes with the maximum of its motor")
    assert run.reactions.power[0, 0] == pytest.approx(2 * 3, rel=1e-12)
    assert run.angular_velocity[-1, 0] == pytest.approx(3 - 0.5, rel=1e-12)


def test_a_brake_stops_a_wheel_and_holds_it() -> None:
    """Dry friction: w^2/(2 M/I) from 3 rad/s at 4 N m and 2 kg m^2; a torque below 4 N m waits."""
    scene = Scene(gravity=(0, 0))
    wheel(scene, angular_velocity=3.0, torque=3.0)
    scene.add_joint(t2.Revolute(motor=t2.Motor(speed=0, maximum=4)), (0, 0), "wheel")
    run = t2.simulate(scene, duration=9.0, times=[9.0])
    assert told(run)[1] == (pytest.approx(6, rel=1e-12), "keeps the speed of its motor")
    assert run.orientation[-1, 0] == pytest.approx(9, rel=1e-12)
    assert run.angular_velocity[-1, 0] == pytest.approx(0, abs=1e-14)


def test_what_a_brake_holds_at_rest_stays_there_when_another_mechanism_slips() -> None:
    """At the instant of the other's event their rates are rounding, and no slipping."""
    scene = Scene(gravity=(0, -G))

    def arm(name: str, of: str | None, turn: float, motor: t2.Motor | None) -> None:
        x, y = scene.bodies[0].position if of else (0.0, 0.0)
        start = (2 * x, 2 * y)
        place = (start[0] + 0.4 * math.cos(turn), start[1] + 0.4 * math.sin(turn))
        scene.add_body(None, mass=0.7, inertia=0.05, position=place, orientation=turn, name=name)
        ends = {"anchor": (0.4, 0.0)} if of else {}
        scene.add_joint(t2.Revolute(motor=motor), of or start, name, other_anchor=(-0.4, 0), **ends)

    arm("upper", None, 0.3, None)
    arm("lower", "upper", 0.3, t2.Motor(speed=0.0, maximum=0.3))
    for k in range(8):
        arm(f"still{k}", None, 0.7 * k + 0.31, t2.Motor(speed=0.0, maximum=50.0))
    run = t2.simulate(scene, duration=1.0, times=np.linspace(0, 1, 11))
    later = run.joint_events.time > 0
    assert later.any()
    assert (run.joint_events.joint[later] == 1).all()
    assert np.ptp(run.orientation[:, 2:], axis=0) == pytest.approx(np.zeros(8), abs=1e-13)


def test_a_motor_without_a_maximum_takes_the_power_that_it_needs() -> None:
    scene = Scene(gravity=(0, -G))
    scene.add_body(
        None, mass=1, inertia=1 / 12, position=(0.5, 0), velocity=(0, 1), angular_velocity=2,
        name="arm",
    )  # fmt: skip
    scene.add_joint(
        t2.Revolute(motor=t2.Motor(speed=2)), (0, 0), "arm", other_anchor=(-0.5, 0), name="drive"
    )
    times = np.linspace(0, 3, 7)
    run = t2.simulate(scene, duration=3.0, times=times)
    assert run.orientation[:, 0] == pytest.approx(2 * times, abs=1e-12)
    assert run.reactions.power[:, 0] == pytest.approx(G * np.cos(2 * times), abs=1e-10)


def test_a_rotary_spring_swings_with_its_frequency_and_keeps_its_energy() -> None:
    scene = Scene(gravity=(0, 0))
    wheel(scene, orientation=0.5)
    scene.add_joint(t2.Rotary(spring=t2.JointSpring(stiffness=8, rest=0)), (0, 0), "wheel")
    times = np.linspace(0, 3, 7)
    run = t2.simulate(scene, duration=3.0, times=times)
    assert run.orientation[:, 0] == pytest.approx(0.5 * np.cos(2 * times), abs=1e-11)
    assert run.energy == pytest.approx(np.full(7, 1.0), rel=1e-11)


def test_a_wheel_on_its_suspension_settles_where_its_weight_is_borne() -> None:
    """Static: stretch m g/k. The damped oscillation is x = exp(-d t)(cos w t + d/w sin w t)."""
    scene = Scene(gravity=(0, -G))
    scene.add_body(None, mass=2, inertia=1, position=(0, -1), name="wheel")
    spring = t2.JointSpring(stiffness=200, damping=8, rest=-1.0)
    scene.add_joint(
        t2.Wheel(axis=(0, 1), spring=spring, motor=t2.Motor(speed=5, maximum=10)), (0, 0), "wheel"
    )
    run = t2.simulate(scene, duration=1.0, times=[0.0, 1.0])
    sag, decay = 2 * G / 200, 8 / 2 / 2
    swing = math.sqrt(200 / 2 - decay**2)
    left = math.exp(-decay) * (math.cos(swing) + decay / swing * math.sin(swing))
    assert run.position[-1, 0] == pytest.approx((0, -1 - sag * (1 - left)), abs=1e-12)
    assert run.angular_velocity[-1, 0] == pytest.approx(5, rel=1e-12)
    assert told(run)[1] == (pytest.approx(0.5, rel=1e-12), "keeps the speed of its motor")


def test_a_rod_breaks_at_the_angle_at_which_statics_says_so() -> None:
    """A pendulum from horizontal pulls with 3 m g sin(angle): 1.5 m g at 30 degrees."""
    scene = Scene(gravity=(0, -G))
    scene.add_body(None, mass=1, position=(1, 0), name="bob")
    scene.add_joint(t2.Distance(length=1), "bob", (0, 0), break_force=1.5 * G)
    run = t2.simulate(scene, duration=1.0, times=[0.0, 1.0])
    assert run.joint_events.words == ("breaks",)
    assert run.joint_events.value.tolist() == [1.0]  # of what it bears

    def fall(_: float, y: np.ndarray) -> tuple[float, float]:
        return y[1], G * math.cos(y[0])

    def at(_: float, y: np.ndarray) -> float:
        return y[0] - math.pi / 6

    found = solve_ivp(fall, (0, 1), (0.0, 0.0), rtol=1e-12, atol=1e-14, method="DOP853", events=at)
    breaks = float(found.t_events[0][0])
    assert run.joint_events.time == pytest.approx([breaks], rel=1e-10)
    turn, spin = math.pi / 6, math.sqrt(G)
    u, v, later = -spin * math.sin(turn), -spin * math.cos(turn), 1 - breaks
    place = (math.cos(turn) + u * later, -math.sin(turn) + v * later - G / 2 * later**2)
    assert run.position[-1, 0] == pytest.approx(place, rel=1e-9)
    assert not run.reactions.force[-1].any()


def test_parts_of_a_step_that_go_back_in_time_know_that_a_rod_has_broken() -> None:
    """Those of Yoshida do, and keep its order."""
    scene = Scene(gravity=(0, -G))
    scene.add_body(None, mass=1, inertia=0.1, position=(1, 0), name="bob")
    scene.add_joint(t2.Distance(), (0, 0), "bob", break_force=2 * G)
    true = t2.simulate(scene, duration=0.6, times=[0.6]).position
    off = []
    for count in (32, 64, 128):
        run = t2.simulate(
            scene, duration=0.6, times=[0.6], method=t2.Yoshida4(), time_step=0.6 / count
        )
        off.append(np.abs(run.position - true).max())
    assert off[0] < 1e-5
    assert off[1] < off[0] / 12
    assert off[2] < off[1] / 12


@pytest.mark.parametrize("ratio", [3.0, -0.5])
@pytest.mark.parametrize("order", [1, -1])
def test_a_gear_breaks_by_the_larger_of_its_torques(ratio: float, order: int) -> None:
    """Torque 2 t on A, B of inertia 2: B takes 2 r times the acceleration 2 t/(1 + 2 r²)."""
    scene = Scene(gravity=(0, 0))
    scene.add_body(None, mass=1, inertia=1, position=(0, 0), torque="2[N*m/s]*time", name="a")
    scene.add_body(None, mass=1, inertia=2, position=(3, 0), name="b")
    ends = ("a", "b")[::order]
    scene.add_joint(t2.Gear(ratio=ratio**order), *ends, break_torque=0.4, name="gear")
    run = t2.simulate(scene, duration=3.0)
    largest = 2 * abs(ratio) * max(1, abs(ratio)) * 2 / (1 + 2 * ratio**2)  # for each s
    (event,) = run.joint_events
    assert event.time == pytest.approx(0.4 / largest, rel=1e-12)


@pytest.mark.parametrize("order", [1, -1])
def test_a_pulley_breaks_by_the_larger_of_its_pulls(order: int) -> None:
    """At rest under growing loads: the pull on A is t, that on B thrice it."""
    scene = Scene(gravity=(0, 0))
    scene.add_body(None, mass=1, inertia=1, position=(0, 0), force=(0, "-1[N/s]*time"), name="a")
    scene.add_body(None, mass=1, inertia=1, position=(1, 0), force=(0, "-3[N/s]*time"), name="b")
    ends, posts = ("a", "b")[::order], ((0, 5), (1, 5))[::order]
    pulley = t2.Pulley(posts=posts, ratio=3.0**order)
    scene.add_joint(pulley, *ends, break_force=2.0, name="rope")
    (event,) = t2.simulate(scene, duration=1.0).joint_events
    assert event.time == pytest.approx(2 / 3, rel=1e-12)


def test_what_breaks_at_once_tells_by_how_much_it_was_too_much() -> None:
    scene = Scene(gravity=(0, -G))
    scene.add_body(None, mass=3, inertia=1, position=(0.5, 0), name="sign")
    weld = t2.Weld()
    scene.add_joint(weld, "sign", (0, 0), at=(0, 0), break_force=1.5 * G, break_torque=0.5 * G)
    (event,) = t2.simulate(scene, duration=0.1).joint_events
    assert event.words == "breaks"
    assert event.value == pytest.approx(3.0, rel=1e-12)  # by its torque, 1.5 N m a unit of G


def test_a_ratchet_clicks_forwards_and_holds_backwards() -> None:
    """Thrown at 2 rad/s against 1 N m: 2 rad at 2 s, and back to the last tooth, at 1.8 rad."""
    scene = Scene(gravity=(0, 0))
    scene.add_body(
        None, mass=1, inertia=1, position=(0, 0), angular_velocity=2, torque=-1, name="wheel"
    )
    scene.add_joint(t2.Ratchet(pitch=0.3, restitution=0), (0, 0), "wheel")
    run = t2.simulate(scene, duration=5.0, times=[0.0, 2.0, 5.0])
    clicks = [event.value for event in run.joint_events if WORDS[event.what] == "clicks"]
    assert clicks == pytest.approx([0, 0.3, 0.6, 0.9, 1.2, 1.5, 1.8])
    assert run.orientation[:, 0] == pytest.approx([0, 2, 1.8], abs=1e-12)
    assert run.reactions.torque[-1, 0, 1] == pytest.approx(1, rel=1e-12)


def test_a_body_that_leans_on_a_limit_is_struck_with_all_that_holds_it() -> None:
    """A door at its stop, hit against it: it is as if welded. Hit away from it: it swings free."""
    for side, spin in ((-1.0, 0.0), (1.0, 2 * 0.5 / (1 / 3 + 0.25))):
        scene = Scene(gravity=(0, 0))
        scene.add_body(
            t2.Box(width=1, height=0.02), mass=1, inertia=1 / 12, position=(0.5, 0), name="door",
            restitution=1, torque=-1e-9,
        )  # fmt: skip
        kind = t2.Revolute(limits=t2.Limits(lower=0, restitution=0))
        scene.add_joint(kind, (0, 0), "door", other_anchor=(-0.5, 0))
        scene.add_body(
            t2.Disc(radius=0.01), mass=1, position=(0.5, -side * 0.5), velocity=(0, side),
            name="ball", restitution=1,
        )  # fmt: skip
        run = t2.simulate(scene, duration=0.6, times=[0.6])
        assert run.angular_velocity[-1, 0] == pytest.approx(spin, abs=1e-8)
        assert run.velocity[-1, 1, 1] == pytest.approx(spin * 0.5 - side, abs=1e-8)


@pytest.mark.parametrize(
    ("method", "step"),
    [(t2.VelocityVerlet(), 1e-3), (t2.RungeKutta4(), 0.01), (t2.Dop853(), None)],
)
def test_events_are_located_by_any_scheme(method: t2.Dop853, step: float | None) -> None:
    scene = Scene(gravity=(0, -G))
    scene.add_body(None, mass=2, position=(0, 0.5), name="load")
    scene.add_joint(t2.Distance(limits=t2.Limits(upper=1.0, restitution=0.5)), "load", (0, 1))
    run = t2.simulate(scene, duration=0.7, method=method, time_step=step, times=[0.7])
    fall = math.sqrt(2 * 0.5 / G)
    assert run.joint_events.time[:2] == pytest.approx([fall, 2 * fall], rel=1e-12)


@pytest.mark.parametrize("suffix", [".npz", ".rrd"])
def test_events_are_recorded_and_read_back_to_the_bit(tmp_path: Path, suffix: str) -> None:
    scene = Scene(gravity=(0, -G))
    scene.add_body(None, mass=2, position=(0, 0.5), name="load")
    scene.add_joint(t2.Distance(limits=t2.Limits(upper=1.0, restitution=0.5)), "load", (0, 1))
    run = t2.simulate(scene, duration=0.7, times=[0.0, 0.7])
    run.save(tmp_path / f"run{suffix}")
    back = t2.Run.load(tmp_path / f"run{suffix}")
    assert list(back.joint_events) == list(run.joint_events)
    assert back.digest() == run.digest()


@pytest.mark.parametrize(
    "kind",
    [
        t2.Distance(limits=t2.Limits(upper=1.0, restitution=0.0)),
        t2.Groove(axis=(1, 0), limits=t2.Limits(upper=1.0, restitution=0.0)),
        t2.Prismatic(axis=(1, 0), limits=t2.Limits(upper=1.0, restitution=0.0)),
        t2.Distance(motor=t2.Motor(speed=0.0)),
        t2.Distance(motor=t2.Motor(speed=0.0, maximum=10.0)),
    ],
    ids=["rope", "groove", "slide", "winch", "winch with a maximum"],
)
def test_a_joint_that_broke_as_it_held_by_its_limit_or_motor_holds_no_more(
    kind: t2.Distance | t2.Groove | t2.Prismatic,
) -> None:
    """Pulled by 3 t N it bears 1.5 N until 0.5 s; from there on the load has 3 (t^2 - 1/4) / 2."""
    scene = Scene(gravity=(0, 0))
    scene.add_body(None, mass=1, inertia=1, position=(1, 0), name="load")
    scene.add_field(force=("3[N/s]*time", "0[N]"), bodies=["load"])
    scene.add_joint(kind, (0, 0), "load", break_force=1.5)
    run = t2.simulate(scene, duration=1.0, times=[0.0, 0.25, 1.0])
    assert told(run)[-1] == (pytest.approx(0.5, rel=1e-12), "breaks")
    assert run.velocity[:, 0, 0] == pytest.approx([0.0, 0.0, 1.5 * 0.75], abs=1e-12)
    assert run.reactions.force[:, 0, 0] == pytest.approx(
        np.array([(0, 0), (0.75, 0), (0, 0)]), abs=1e-12
    )
