"""Springs and dampers in the frame loop: they gain nothing, at any stiffness, with contacts too."""

import math
import pickle

import numpy as np
import pytest
from hypothesis import example, given, settings, strategies as st

import tamias2d as t2
from tamias2d.simulator import Simulator
from tests.simulator.networks import Network, scene_of, totals

SURFACE = {"friction": 0.5, "restitution": 0.0}


def oscillator(stiffness: float, damping: float = 0.0) -> t2.Scene:
    scene = t2.Scene(gravity=(0.0, 0.0))
    body = scene.add_body(t2.Disc(radius=0.1), mass=1.0, position=(1.0, 0.0), **SURFACE)
    point = (0.0, 0.0)
    scene.add_spring(body, point, stiffness=stiffness, rest_length=0.0, damping=damping)
    return scene


@pytest.mark.parametrize("stiffness", [100.0, 1e4, 1e8])
def test_an_undamped_spring_keeps_its_energy(stiffness: float) -> None:
    """1e5 steps at 60 Hz; the solution of each step leaves 1e-14, about."""
    scene = oscillator(stiffness)
    sim = Simulator(scene)
    first = totals(scene, sim).energy
    for _ in range(10):
        sim.step(10_000)
        assert totals(scene, sim).energy == pytest.approx(first, rel=1e-9)


def test_a_damped_spring_decays_as_it_does() -> None:
    """x = exp(-t/2) (cos wt + sin wt/(2 w)) for k = 100, c = 1, m = 1 (taylor2005)."""
    scene = oscillator(100.0, 1.0)
    sim = Simulator(scene)
    pulse = math.sqrt(100.0 - 0.25)
    for _ in range(10):
        sim.step(60)
        t = sim.time
        decay, cosine, sine = math.exp(-t / 2), math.cos(pulse * t), math.sin(pulse * t)
        x = decay * (cosine + sine / (2 * pulse))
        v = -decay * sine * (pulse + 1 / (4 * pulse))
        exact = 0.5 * v * v + 50.0 * x * x
        assert totals(scene, sim).energy == pytest.approx(exact, rel=0.05)


@pytest.mark.parametrize("damping", [1.0, 1e2, 1e4, 1e8])
def test_no_damper_turns_a_velocity_round(damping: float) -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    body = scene.add_body(
        t2.Disc(radius=0.1), mass=1.0, position=(1.0, 0.0), velocity=(1.0, 0.0), **SURFACE
    )
    scene.add_spring(body, (0.0, 0.0), stiffness=1e-9, rest_length=1.0, damping=damping)
    sim = Simulator(scene)
    before = 1.0
    for _ in range(10):
        sim.step()
        assert -1e-12 <= sim.velocity[0, 0] <= max(before, 1e-12)  # the rest is rounding
        before = sim.velocity[0, 0]


def test_a_steady_pull_stretches_a_stiff_spring_as_hooke_says() -> None:
    """The equilibrium of a hung body with some damping: m g / k below the rest length."""
    scene = t2.Scene(gravity=(0.0, -9.81))
    body = scene.add_body(t2.Disc(radius=0.1), mass=2.0, position=(0.0, -1.0), **SURFACE)
    scene.add_spring(body, (0.0, 0.0), stiffness=1e5, rest_length=1.0, damping=1e3)
    sim = Simulator(scene)
    sim.step(600)
    assert sim.position[0, 1] == pytest.approx(-1.0 - 2.0 * 9.81 / 1e5, abs=1e-9)
    assert abs(sim.velocity[0, 1]) < 1e-6


NETWORKS = st.builds(
    Network,
    seed=st.integers(0, 2**32 - 1),
    bodies=st.integers(2, 6),
    stiffest=st.sampled_from([1e2, 1e4, 1e6, 1e8]),
    mass_ratio=st.sampled_from([1.0, 1e2, 1e4]),
    loose=st.booleans(),
    damping=st.sampled_from([0.0, 1.0, 100.0]),
)


@settings(max_examples=60, deadline=None)
@given(NETWORKS)
@example(Network(seed=9874, bodies=6, stiffest=1e8, mass_ratio=1.0))
@example(Network(seed=1, bodies=3, stiffest=1e8, mass_ratio=1.0, damping=1.0, loose=True))
@example(Network(seed=4294967295, bodies=2, stiffest=1e8, mass_ratio=1.0))
def test_networks_held_at_centres_conserve_what_they_must(network: Network) -> None:
    """Momentum and angular momentum to rounding; energy to what the solution leaves.

    A network that could not be solved in the shortest parts went through substeps, which is warned
    of, and does not keep its energy.
    """
    scene = scene_of(network)
    sim = Simulator(scene)
    first = totals(scene, sim)
    heavy = sum(body.mass for body in scene.bodies)
    momentum = math.sqrt(2.0 * heavy * first.energy)
    fastest = math.sqrt(2.0 * first.energy / min(body.mass for body in scene.bodies))
    way = fastest * sim.time_step
    far = max(10.0 * network.bodies, way)  # springs of 1e8 N/m throw them so
    pulls = len(scene.springs) * math.sqrt(2.0 * network.stiffest * first.energy)
    before = first.energy
    for _ in range(30):
        sim.step()
        now = totals(scene, sim)
        assert np.abs(now.momentum - first.momentum).max() <= 1e-11 * momentum
        if sim.warnings:
            return
        # each of up to 64 parts of a step is solved to 1e-11 of the way that bodies go in it
        assert abs(now.angular_momentum - first.angular_momentum) <= 1e-9 * momentum * far
        if network.damping == 0.0:
            assert now.energy == pytest.approx(first.energy, rel=1e-7)
        # N m: each spring pulls along that share of the way, and by its stiffness errs in its pull
        errs = 0.5 * len(scene.springs) * network.stiffest * way
        left = 1e-11 * sim.parts * way * (pulls + errs)
        assert now.energy <= before * (1.0 + 1e-12) + left
        before = now.energy


@settings(max_examples=60, deadline=None)
@given(NETWORKS)
def test_networks_with_anchors_gain_no_energy(network: Network) -> None:
    """Where arms turn too far for a step it is taken in parts; what is beyond is warned of."""
    scene = scene_of(Network(**(vars(network) | {"anchored": True})))
    sim = Simulator(scene)
    first = totals(scene, sim)
    momentum = math.sqrt(2.0 * sum(body.mass for body in scene.bodies) * first.energy)
    for _ in range(30):
        sim.step()
        now = totals(scene, sim)
        assert np.abs(now.momentum - first.momentum).max() <= 1e-11 * momentum
        if sim.warnings:
            return
        # solutions to 1e-11 of a way, through up to 64 parts of each step
        assert now.energy <= first.energy * (1.0 + 1e-5)


def test_angular_momentum_with_anchors_is_kept_to_second_order() -> None:
    """Half the step, a quarter of the error, within a tenth."""
    errors = []
    for shorter in (1, 2):
        scene = scene_of(Network(seed=5, bodies=3, stiffest=20.0, mass_ratio=2.0, anchored=True))
        sim = Simulator(scene, time_step=1 / (60 * shorter))
        first = totals(scene, sim).angular_momentum
        sim.step(30 * shorter)
        errors.append(totals(scene, sim).angular_momentum - first)
    assert abs(errors[0]) < 1e-3
    assert errors[0] / errors[1] == pytest.approx(4.0, rel=0.1)


def test_the_order_is_two() -> None:
    """Against the reference of `simulate`, to 1e-12."""
    scene = scene_of(Network(seed=7, bodies=4, stiffest=50.0, mass_ratio=4.0, anchored=True))
    exact = t2.simulate(scene, duration=1.0, method=t2.Reference(), times=[1.0])
    errors = []
    for steps in (240, 480, 960):
        sim = Simulator(scene, time_step=1 / steps)
        sim.step(steps)
        errors.append(float(np.abs(sim.position - exact.position[-1]).max()))
    assert errors[0] / errors[1] == pytest.approx(4.0, rel=0.2)
    assert errors[1] / errors[2] == pytest.approx(4.0, rel=0.1)


# -- with contacts


def on_a_floor(stiffness: float, mass: float) -> t2.Scene:
    """Two discs on one spring that fall upon a floor, the upper one of some mass."""
    scene = t2.Scene(gravity=(0.0, -9.81))
    thrown = {"velocity": (0.0, -2.0), **SURFACE}
    lower = scene.add_body(t2.Disc(radius=0.2), mass=1.0, position=(0.0, 0.5), **thrown)
    upper = scene.add_body(t2.Disc(radius=0.2), mass=mass, position=(0.1, 1.5), **thrown)
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **SURFACE)
    scene.add_spring(lower, upper, stiffness=stiffness, rest_length=math.hypot(0.1, 1.0))
    return scene


@pytest.mark.parametrize("mass", [1e-4, 1.0, 1e4])
@pytest.mark.parametrize("stiffness", [1e2, 1e4, 1e6, 1e8])
def test_what_lands_on_a_spring_gains_nothing(stiffness: float, mass: float) -> None:
    """A soft network in substeps swings about its energy by half a substep's phase, 2 to 25 %."""
    scene = on_a_floor(stiffness, mass)
    sim = Simulator(scene)
    first = totals(scene, sim).energy
    for _ in range(300):
        sim.step()
        assert totals(scene, sim).energy <= first * (1.0 + 1e-9)
    assert (sim.position[:2, 1] > 0.19).all()


def test_a_crate_on_a_spring_lands_and_stays() -> None:
    """The floor carries what the spring does not: m g - k (3 - 2 - 1/2)."""
    scene = t2.Scene(gravity=(0.0, -9.81))
    crate = scene.add_body(
        t2.Box(width=1.0, height=1.0), mass=10.0, position=(0.0, 1.0), velocity=(0.0, -2.0),
        **SURFACE,
    )  # fmt: skip
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **SURFACE)
    scene.add_spring(crate, (0.0, 3.0), stiffness=40.0, rest_length=2.0)
    sim = Simulator(scene)
    sim.step(600)
    assert sim.position[0] == pytest.approx((0.0, 0.5), abs=0.01)
    assert np.abs(sim.velocity[0]).max() < 1e-6
    pushed = sim.contacts.impulse.sum() / sim.time_step
    assert pushed == pytest.approx(10.0 * 9.81 - 40.0 * 0.5, rel=0.01)


def test_a_soft_network_with_a_contact_swings_on() -> None:
    """A bob that floats swings on a spring at a block that lies on a floor, held by friction."""
    scene = t2.Scene(gravity=(0.0, -9.81))
    block = scene.add_body(t2.Box(width=1.0, height=1.0), mass=20.0, position=(0.0, 0.5), **SURFACE)
    bob = scene.add_body(
        t2.Disc(radius=0.1), mass=1.0, position=(2.2, 0.5), force=(0.0, 9.81), **SURFACE
    )
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **SURFACE)
    scene.add_spring(block, bob, stiffness=40.0, rest_length=2.0)
    sim = Simulator(scene)
    ways = []
    for _ in range(1000):
        sim.step()
        ways.append(sim.position[bob, 0])
    early, late = np.ptp(ways[:200]), np.ptp(ways[-200:])
    assert early == pytest.approx(0.4, rel=0.05)
    assert late == pytest.approx(early, rel=0.05)
    assert len(sim.contacts) > 0


@pytest.mark.parametrize("rest", [3.0, 2.97])
def test_bodies_of_a_network_sleep_and_wake_together(rest: float) -> None:
    """Also under tension; what a spring holds wakes when the other end is pulled."""
    scene = t2.Scene(gravity=(0.0, -9.81))
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **SURFACE)
    for x in (0.0, 3.0):
        box = t2.Box(width=1.0, height=1.0)
        scene.add_body(box, mass=1.0, position=(x, 0.5), name=f"at {x}", **SURFACE)
    scene.add_spring("at 0.0", "at 3.0", stiffness=50.0, rest_length=rest)
    sim = Simulator(scene, sleeping=True)
    sim.step(300)
    assert sim.asleep[1:].all()
    sim.position[2] = (3.5, 0.5)
    sim.step(2)
    assert not sim.asleep[1:].any()


def test_what_a_spring_holds_wakes_as_its_end_goes_away() -> None:
    scene = t2.Scene(gravity=(0.0, -9.81))
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **SURFACE)
    box = t2.Box(width=1.0, height=1.0)
    scene.add_body(box, mass=1.0, position=(0.0, 0.5), **SURFACE)
    far = t2.Disc(radius=0.1)
    scene.add_kinematic(far, position=(3.0, 0.5), velocity=(0.0, 0.0), **SURFACE)
    scene.add_spring(1, 2, stiffness=50.0, rest_length=2.97)
    sim = Simulator(scene, sleeping=True)
    sim.step(60)
    assert sim.asleep[1]
    sim.velocity[2] = (0.5, 0.0)
    sim.step(30)
    assert not sim.asleep[1]
    assert sim.velocity[1, 0] > 0.1


def test_springs_go_with_their_bodies() -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    for x in (0.0, 2.0):
        scene.add_body(t2.Disc(radius=0.1), mass=1.0, position=(x, 0.0), **SURFACE)
    scene.add_spring(0, 1, stiffness=50.0, rest_length=1.0)
    sim = Simulator(scene)
    sim.step(10)
    sim.remove(1)
    speed = sim.velocity[0, 0]
    sim.step(10)
    assert speed > 0.1
    assert sim.velocity[0, 0] == speed


@pytest.mark.parametrize("lands", [False, True])
def test_compiled_and_plain_have_the_same_bits(lands: bool) -> None:
    if lands:
        scene = on_a_floor(1e6, 3.0)
    else:
        scene = scene_of(
            Network(seed=3, bodies=5, stiffest=1e6, mass_ratio=1e3, anchored=True, damping=1.0)
        )
    one, other = Simulator(scene), Simulator(scene, compiled=False)
    for _ in range(30):
        one.step()
        other.step()
    assert one.digest() == other.digest()


def test_a_copy_goes_on_with_the_same_bits() -> None:
    scene = on_a_floor(1e3, 2.0)
    sim = Simulator(scene)
    sim.step(40)
    other = pickle.loads(pickle.dumps(sim))
    sim.step(40)
    other.step(40)
    assert sim.digest() == other.digest()


def test_networks_do_not_change_each_other() -> None:
    """The bits of one network are the same with and without another one beside it.

    Nothing collides: crowds of fast bodies share the length of the parts of a step.
    """
    alone, both = t2.Scene(gravity=(0.0, 0.0)), t2.Scene(gravity=(0.0, 0.0))
    for scene, count in ((alone, 1), (both, 2)):
        for k in range(count):
            for x in (0.0, 1.5, 3.3):
                place = (x + 100.0 * k, 0.1 * x * x)
                scene.add_body(
                    t2.Disc(radius=0.1), mass=1.0 + x, position=place, group=-1, **SURFACE
                )
            for first in (3 * k, 3 * k + 1):
                scene.add_spring(first, first + 1, stiffness=1e5, rest_length=1.0)
    one, two = Simulator(alone), Simulator(both)
    for _ in range(50):
        one.step()
        two.step()
    assert one.position.tobytes() == two.position[:3].tobytes()
