"""Friction in located contacts: what sticks, slides and rolls, with answers known from outside."""

import math

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings, strategies as st
from scipy.integrate import solve_ivp

import tamias2d as t2
from tamias2d.contact import FrictionError, Refusal
from tamias2d.contact.core import cores_of, place
from tamias2d.contact.frictional_rest import island_of, slides_on
from tamias2d.contact.manifold import manifold
from tamias2d.contact.pair_friction import PairFriction
from tamias2d.state import State
from tests.contact.meetings import Meeting, angles, meetings, sizes, thrown, without_joints

G = 9.81
boxes = st.builds(lambda w, h: t2.Box(width=w, height=h), sizes, sizes)


def slope(angle: float, shape: t2.Disc | t2.Box, friction: float, **body: object) -> t2.Scene:
    """A body of 2 kg that touches a slope which falls to the right, beside its origin."""
    scene = t2.Scene(gravity=(0, -G))
    normal = math.sin(angle), math.cos(angle)
    scene.add_static(t2.HalfPlane(normal=normal, offset=0), name="slope", restitution=0)
    scene.add_body(
        shape,
        mass=2,
        position=(0.5 * normal[0], 0.5 * normal[1]),
        orientation=-angle,
        friction=friction,
        name="body",
        **body,
    )
    return scene


def way(run: t2.Run, angle: float) -> np.ndarray:
    """Return how far the body has come down the slope, m."""
    return (run.position[:, 1] - run.position[0, 1]) @ (math.cos(angle), -math.sin(angle))


BOX, DISC = t2.Box(width=1, height=1), t2.Disc(radius=0.5)


def test_block_slides_down_a_slope():
    """C1; the closed form is that of constant acceleration."""
    angle = math.radians(30)
    run = t2.simulate(slope(angle, BOX, 0.3), duration=2.0)
    assert way(run, angle)[-1] == pytest.approx(4.712574473324793, rel=1e-14)
    wanted = 0.5 * G * (math.sin(angle) - 0.3 * math.cos(angle)) * run.times**2
    np.testing.assert_allclose(way(run, angle), wanted, rtol=0, atol=1e-14)


def test_block_sticks_to_the_bit():
    """C1; nothing is allowed to creep."""
    run = t2.simulate(slope(math.radians(30), BOX, 0.6), duration=100.0)
    assert (run.position == run.position[0]).all()
    assert (run.orientation == run.orientation[0]).all()
    assert not run.velocity.any()
    assert not run.angular_velocity.any()


@pytest.mark.parametrize("degrees", [5, 20, 30, 45])
def test_angle_of_friction(degrees: float):
    """C1; found by bisection to 1e-9, where 1e-6 is wanted."""
    angle = math.radians(degrees)
    low, high = 0.0, 2.0
    while high - low > 1e-12:
        middle = (low + high) / 2
        sticks = way(t2.simulate(slope(angle, BOX, middle), duration=1.0), angle)[-1] == 0
        low, high = (low, middle) if sticks else (middle, high)
    assert high == pytest.approx(math.tan(angle), abs=1e-9)


def test_block_stops_and_does_not_come_back():
    """C2."""
    run = t2.simulate(slope(0.0, BOX, 0.4, velocity=(5, 0)), duration=3.0)
    assert way(run, 0.0)[-1] == pytest.approx(3.1855249745158, rel=1e-13)
    moving = run.velocity[:, 1, 0]
    np.testing.assert_allclose(moving, np.maximum(5 - 0.4 * G * run.times, 0), rtol=0, atol=1e-14)
    assert (np.diff(moving) <= 0).all()
    assert (moving >= 0).all()
    stopped = run.times > 1.27420998980632
    assert (run.position[stopped] == run.position[-1]).all()


@pytest.mark.parametrize(
    ("friction", "velocity", "spin"),
    [(0.1, (1.46, 2.4), -2.16), (0.5, (4 / 3, 2.4), -8 / 3)],
    ids=["slips", "sticks"],
)
def test_disc_meets_a_floor(friction: float, velocity: tuple[float, float], spin: float):
    """C3."""
    scene = t2.Scene(gravity=(0, 0))
    scene.add_static(t2.HalfPlane(normal=(0, 1), offset=0), friction=friction)
    scene.add_body(DISC, mass=1, position=(0, 1), velocity=(2, -3), restitution=0.8)
    run = t2.simulate(scene, duration=1.0)
    np.testing.assert_allclose(run.velocity[-1, 1], velocity, rtol=1e-15)
    assert run.angular_velocity[-1, 1] == pytest.approx(spin, rel=1e-15)
    if friction == 0.5:
        assert run.velocity[-1, 1, 0] + 0.5 * run.angular_velocity[-1, 1] == pytest.approx(0)


@pytest.mark.parametrize(
    ("inertia", "acceleration", "least"),
    [
        (0.25, 2.2368117373498735, 0.12132341142206744),
        (0.5, 1.6776088030124052, 0.18198511713310117),
    ],
    ids=["disc", "hoop"],
)
def test_rolling(inertia: float, acceleration: float, least: float):
    """C4: rolls above a coefficient, and slips while it rolls below."""
    angle = math.radians(20)
    run = t2.simulate(slope(angle, DISC, 1.001 * least, inertia=inertia), duration=3.0)
    np.testing.assert_allclose(
        way(run, angle), acceleration * run.times**2 / 2, rtol=1e-14, atol=1e-15
    )
    speed = run.velocity[:, 1] @ (math.cos(angle), -math.sin(angle))
    np.testing.assert_allclose(speed, -0.5 * run.angular_velocity[:, 1], rtol=1e-14)
    slips = t2.simulate(slope(angle, DISC, 0.999 * least, inertia=inertia), duration=3.0)
    speed = slips.velocity[1:, 1] @ (math.cos(angle), -math.sin(angle))
    assert (speed > -0.5 * slips.angular_velocity[1:, 1]).all()


def test_bowling_ball_rolls_at_last():
    """Slips for 2 v0/(7 mu g) with a ball's inertia, then rolls with 5/7 of its velocity."""
    ball = slope(0.0, DISC, 0.2, velocity=(3, 0), inertia=0.4 * 2 * 0.25)
    rolls = 2 * 3 / (7 * 0.2 * G)
    run = t2.simulate(ball, duration=3.0, times=[rolls * (1 - 1e-9), rolls * (1 + 1e-9), 3.0])
    assert run.velocity[0, 1, 0] > -0.5 * run.angular_velocity[0, 1]
    assert run.velocity[1:, 1, 0] == pytest.approx(3 * 5 / 7, rel=1e-14)
    assert -0.5 * run.angular_velocity[1:, 1] == pytest.approx(3 * 5 / 7, rel=1e-14)


def test_shaken_block_sticks_and_slides():
    """A force that swings: compared with scipy, which knows Coulomb's law from this test."""
    force, friction = 9.0, 0.3
    scene = t2.Scene(gravity=(0, -G))
    scene.add_static(t2.HalfPlane(normal=(0, 1), offset=0), restitution=0)
    scene.add_body(
        BOX, mass=1, position=(0, 0.5), force=("9[N]*sin(3[rad/s]*time)", 0), friction=friction
    )
    run = t2.simulate(scene, duration=2.0)
    bound = friction * G
    begins = math.asin(bound / force) / 3
    still = run.times < begins
    assert still.sum() > 5
    assert (run.position[still, 1, 0] == 0).all()

    def rate(t: float, y: np.ndarray) -> tuple[float, float]:
        return y[1], force * math.sin(3 * t) - bound

    stops = lambda t, y: y[1] if t > begins + 0.1 else 1.0  # noqa: E731
    stops.terminal = True  # type: ignore[attr-defined]
    found = solve_ivp(
        rate, (begins, 2), (0, 0), events=stops, rtol=1e-12, atol=1e-13, dense_output=True
    )
    slides = (run.times >= begins) & (run.times <= found.t[-1])
    np.testing.assert_allclose(
        run.position[slides, 1, 0], found.sol(run.times[slides])[0], rtol=0, atol=1e-9
    )
    assert slides.sum() > 20


def test_stack_on_a_slope_stays():
    """Several bodies rest on each other below the angle of friction."""

    slab = t2.Box(width=2, height=0.5)

    def stack(friction: float) -> t2.Scene:
        scene = t2.Scene(gravity=(G * math.sin(0.3), -G * math.cos(0.3)))
        scene.add_static(t2.HalfPlane(normal=(0, 1), offset=0), friction=friction, restitution=0)
        for k in range(3):
            scene.add_body(slab, mass=1 + k, position=(0, 0.25 + 0.5 * k), friction=friction)
        return scene

    run = t2.simulate(stack(1.01 * math.tan(0.3)), duration=10.0)
    assert (run.position == run.position[0]).all()


def rod(friction: float, velocity: float) -> t2.Scene:
    """A thin rod at 60 degrees whose lower tip, to the right, touches a floor."""
    tilt, length, width = -math.pi / 3, 1.0, 1e-3
    c, s = math.cos(tilt), math.sin(tilt)
    low = min(s * x + c * y for x in (-length / 2, length / 2) for y in (-width / 2, width / 2))
    scene = t2.Scene(gravity=(0, -G))
    scene.add_static(t2.HalfPlane(normal=(0, 1), offset=0), name="floor", restitution=0)
    scene.add_body(
        t2.Box(width=length, height=width),
        mass=1,
        position=(0, -low),
        orientation=tilt,
        velocity=(velocity, 0),
        friction=friction,
        name="rod",
    )
    return scene


def test_rod_of_painleve():
    """C7: with its tip ahead on a very rough floor no motion obeys Coulomb's law."""
    with pytest.raises(FrictionError, match=r"'floor' and 'rod' at 0\.0 s: .* no motion \(GD8\)"):
        t2.simulate(rod(2.0, 3.0), duration=1.0, method=t2.ClosedForm())
    for friction, velocity in ((2.0, -3.0), (0.3, 3.0)):  # dragged, or on a smoother floor
        run = t2.simulate(rod(friction, velocity), duration=0.2)
        assert (np.diff(run.energy) <= 1e-12 * run.energy[0]).all()


def test_several_motions_are_refused():
    """A box that just fits between two rough walls may fall, or hold itself by any pressure."""
    scene = t2.Scene(gravity=(0, -G))
    for side in (-1, 1):
        scene.add_static(t2.HalfPlane(normal=(-side, 0), offset=-0.5), friction=0.5, restitution=0)
    scene.add_body(BOX, mass=1, position=(0, 0))
    with pytest.raises(FrictionError, match="several motions"):
        t2.simulate(scene, duration=1.0, method=t2.ClosedForm())


def test_what_coulombs_law_leaves_open_is_stepped_where_no_method_is_asked_for():
    """R12: the first note says when, and why."""
    run = t2.simulate(rod(2.0, 3.0), duration=0.2)
    assert isinstance(run.method, t2.Stepped)
    assert "impacts could be located up to 0 s. 'floor' and 'rod' at 0 s: Coulomb" in run.notes[0]
    assert run.energy.max() <= run.energy[0] * (1 + 1e-9)


@settings(
    max_examples=1000, deadline=None, derandomize=True, suppress_health_check=list(HealthCheck)
)
@given(
    meetings(
        thrown(boxes, st.just(1.0)),
        thrown(boxes, st.floats(-6, 6).map(lambda power: 10.0**power)),
        aside=1.0,
        speeds=st.just(3.0),
    ),
    st.floats(0, 1),
    st.floats(0, 3),
)
def test_impacts_keep_momentum_and_gain_no_energy(
    meeting: Meeting, restitution: float, friction: float
):
    """Random boxes that meet, mostly corner on side, where normal and tangent are coupled."""
    scene = meeting.scene(restitution=restitution, friction=friction)
    reach, mass = meeting.reach, meeting.second.mass
    try:
        times = np.linspace(0, reach, 9)
        run = t2.simulate(scene, duration=reach, times=times, method=t2.ClosedForm())
    except Refusal as refusal:
        run = refusal.run  # what was computed until then obeys the laws just as well
    assert np.abs(run.momentum - run.momentum[0]).max() <= 1e-12 * mass * 3
    assert (np.diff(run.energy) <= 1e-12 * run.energy[0]).all()
    turning = np.abs(run.angular_momentum - run.angular_momentum[0]).max()
    assert turning <= 1e-11 * (mass * 3 * 10 * reach + np.abs(run.angular_momentum[0])) * (
        1 + len(run.impacts)
    )


@settings(max_examples=300, deadline=None, derandomize=True)
@given(
    st.floats(0.01, 2),
    st.floats(0.05, 0.95),
    st.floats(0, 1),
    st.floats(-4, 4),
    st.floats(-4, 4),
    angles,
)
def test_energy_that_an_impact_takes(friction, restitution, thin, sliding, spin, angle):
    """P9, from the run alone: what is lost is never less than without friction."""
    box = t2.Box(width=1, height=0.05 + thin)

    def loss(coefficient: float) -> float:
        scene = t2.Scene(gravity=(0, 0))
        scene.add_static(t2.HalfPlane(normal=(0, 1), offset=0), friction=coefficient)
        scene.add_body(
            box,
            mass=1,
            position=(0, 1.5),
            velocity=(sliding, -5),
            angular_velocity=spin,
            orientation=angle,
            restitution=restitution,
        )
        first = float(t2.simulate(scene, duration=1.0).impacts.time[0])
        run = t2.simulate(scene, duration=1.0, times=[0.0, first])
        return float(run.energy[0] - run.energy[1])

    assert loss(friction) >= loss(0.0) - 1e-12


@pytest.mark.parametrize("friction", [5e-324, 1e-200, 1e12, 1e200, 1.7e308])
def test_any_friction_has_an_answer(friction: float):
    """As good as smooth, or as good as glued along the surface."""
    scene = t2.Scene(gravity=(0, -G))
    scene.add_static(t2.HalfPlane(normal=(0, 1), offset=0), restitution=0.5)
    scene.add_body(DISC, mass=1, position=(0, 2), velocity=(3, 0), friction=friction)
    run = t2.simulate(scene, duration=4.0)
    rolls = friction > 1
    assert run.velocity[-1, 1] == pytest.approx((2 if rolls else 3, 0), abs=1e-12)
    assert run.angular_velocity[-1, 1] == pytest.approx(-4 if rolls else 0, abs=1e-12)


def test_friction_in_two_contacts_at_once():
    """A block that lands flat and slides loses mu times the normal impulse of both ends."""
    scene = t2.Scene(gravity=(0, 0))
    scene.add_static(t2.HalfPlane(normal=(0, 1), offset=0), restitution=0.5, friction=0.1)
    scene.add_body(t2.Box(width=4, height=0.2), mass=3, position=(0, 1), velocity=(2, -1))
    run = t2.simulate(scene, duration=1.5)
    np.testing.assert_allclose(run.velocity[-1, 1], (2 - 0.1 * 1.5, 0.5), rtol=0, atol=1e-15)
    assert abs(run.angular_velocity[-1, 1]) < 1e-15
    assert run.impacts.impulse.sum() == pytest.approx(3 * 1.5, rel=1e-15)


def test_no_friction_is_the_same_to_the_bit():
    """A coefficient of zero changes nothing."""

    def digest(friction: float | None) -> str:
        scene = t2.Scene(gravity=(0, -G))
        scene.add_static(t2.HalfPlane(normal=(0, 1), offset=0), restitution=0.5, friction=friction)
        for k in range(3):
            scene.add_body(
                BOX, mass=1, position=(2 * k, 1 + k), angular_velocity=k, velocity=(k, 0)
            )
        return t2.simulate(scene, duration=1.0).digest()

    assert digest(None) == digest(0.0)


def test_rod_falls_about_its_tip():
    """A tip that sticks is a hinge: the fall is that of a pendulum upside down, by scipy."""
    box, tilt = t2.Box(width=0.1, height=1.0), 0.5
    c, s = math.cos(tilt), math.sin(tilt)
    arm = np.array([[c, s], [-s, c]]) @ (-0.05, 0.5)  # from the corner that it stands on
    scene = t2.Scene(gravity=(0, -G))
    scene.add_static(t2.HalfPlane(normal=(0, 1), offset=0), friction=1.0, restitution=0)
    scene.add_body(box, mass=2, position=arm, orientation=-tilt)
    reach = math.hypot(*arm)
    inertia = box.inertia(2.0) + 2 * reach**2
    lean = math.atan2(arm[0], arm[1])
    found = solve_ivp(
        lambda _, y: (y[1], 2 * G * reach * math.sin(y[0]) / inertia),
        (0, 0.3),
        (lean, 0),
        rtol=1e-12,
        atol=1e-14,
        dense_output=True,
    )
    run = t2.simulate(scene, duration=0.3)
    angle = found.sol(run.times)[0]
    wanted = reach * np.stack((np.sin(angle), np.cos(angle)), axis=-1)
    np.testing.assert_allclose(run.position[:, 1], wanted, rtol=0, atol=1e-11)
    np.testing.assert_allclose(run.energy, run.energy[0], rtol=1e-12)


def test_disc_rolls_over_an_edge():
    """Without slip about the edge: (1 + beta) R psi'' = g sin psi, by scipy."""
    radius, beta, speed = 0.5, 0.5, 0.3
    scene = t2.Scene(gravity=(0, -G))
    scene.add_static(t2.Box(width=2, height=2), position=(-1, -1), friction=2.0, restitution=0)
    scene.add_body(
        DISC, mass=3, position=(0, radius), velocity=(speed, 0), angular_velocity=-speed / radius
    )
    found = solve_ivp(
        lambda _, y: (y[1], G * math.sin(y[0]) / (radius * (1 + beta))),
        (0, 0.5),
        (0, speed / radius),
        rtol=1e-12,
        atol=1e-14,
        dense_output=True,
    )
    run = t2.simulate(scene, duration=0.5)
    angle = found.sol(run.times)[0]
    assert angle[-1] > 0.4
    wanted = radius * np.stack((np.sin(angle), np.cos(angle)), axis=-1)
    np.testing.assert_allclose(run.position[:, 1], wanted, rtol=0, atol=1e-11)
    np.testing.assert_allclose(run.orientation[:, 1], -angle, rtol=0, atol=1e-11)


def lowest(shape: t2.Box, position: np.ndarray, orientation: np.ndarray) -> np.ndarray:
    """Return the height of the lowest corner at each time, m."""
    corners = np.array(shape.vertices)
    c, s = np.cos(orientation)[:, None], np.sin(orientation)[:, None]
    return position[:, 1] + (s * corners[:, 0] + c * corners[:, 1]).min(axis=1)


def test_block_that_trips_and_falls_back():
    """Friction lifts its rear while it slides; the rear comes down and meets the floor again."""
    box = t2.Box(width=0.56, height=0.4)
    scene = t2.Scene(gravity=(0, -G))
    scene.add_static(t2.HalfPlane(normal=(0, 1), offset=0), restitution=0)
    scene.add_body(box, mass=1, position=(0, 0.2), velocity=(2, 0), friction=1.5)
    run = t2.simulate(scene, duration=1.0, times=np.linspace(0, 1, 1001))
    assert np.ptp(run.orientation[:, 1]) > 0.05
    assert lowest(box, run.position[:, 1], run.orientation[:, 1]).min() > -1e-14
    assert (np.diff(run.energy) <= 1e-13).all()
    assert run.energy[-1] == pytest.approx(G * 0.2, rel=1e-14)
    assert len(run.impacts) == 3


@settings(
    max_examples=100, deadline=None, derandomize=True, suppress_health_check=list(HealthCheck)
)
@given(
    st.tuples(sizes, sizes),
    st.sampled_from([0.0, 0.1, 0.5, 1.5]),
    st.sampled_from([0.0, 0.4, 1.0]),
    st.floats(-0.4, 0.4),
    st.floats(-3, 3),
    st.floats(-5, 5),
    st.floats(-3, 3),
)
def test_thrown_boxes(size, friction, restitution, slope, angle, spin, speed):
    """They tumble, slide and lie: no energy is gained, and nothing sinks in."""
    box = t2.Box(width=size[0], height=size[1])
    scene = t2.Scene(gravity=(G * math.sin(slope), -G * math.cos(slope)))
    scene.add_static(t2.HalfPlane(normal=(0, 1), offset=0), restitution=restitution)
    scene.add_body(
        box,
        mass=1,
        position=(0, 2),
        orientation=angle,
        velocity=(speed, 0),
        angular_velocity=spin,
        friction=friction,
    )
    try:
        run = t2.simulate(scene, duration=3.0, method=t2.ClosedForm())
    except Refusal as refusal:
        run = refusal.run
    assert (np.diff(run.energy) <= 1e-11 * (1 + np.abs(run.energy).max())).all()
    assert lowest(box, run.position[:, 1], run.orientation[:, 1]).min() > -1e-11


def test_a_corner_that_is_sure_to_slide_does_so_on_its_island():
    """Rods on a corner, some of which jam (Painleve): no other mode, of all that are tried."""
    sure = 0
    for seed in range(300):
        rng = np.random.default_rng(seed)
        tilt, push, spin, friction = rng.uniform((-1.5, -2, -4, 0.1), (1.5, 2, 4, 2.5)).tolist()
        scene = t2.Scene(gravity=(0, -G))
        scene.add_static(t2.HalfPlane(normal=(0, 1), offset=0))
        height = (math.cos(tilt) + 0.1 * abs(math.sin(tilt))) / 2
        scene.add_body(t2.Box(width=0.1, height=1), mass=1, position=(0, height))
        cores = cores_of(scene)
        falls = spin * (math.sin(tilt) - 0.1 * math.copysign(math.cos(tilt), tilt)) / 2
        states = State((0, 0), 0.0, (0, 0), 0.0), State((0, height), tilt, (push, falls), spin)
        placed = {i: place(core, states[i]) for i, core in enumerate(cores)}
        contacts = manifold(placed[0], placed[1], 1e-14, 1.0)
        rough = PairFriction(1.0, lambda *_, mu=friction: mu, lambda _: 1e-13)
        given = cores, placed
        free = {1: (0.0, -G, 0.0)}
        sense = slides_on(*given, contacts[0], free, 0.0, rough)
        if sense:
            island = island_of(*given, contacts, free, 0.0, rough, without_joints(cores))
            assert island.senses == {(0, 1): sense}
            sure += 1
    assert 150 < sure < 300
