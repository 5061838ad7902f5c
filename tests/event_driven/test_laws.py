"""Many discs obey the laws: conservation, reversal, kinetic theory, and no order of bodies."""

import math

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.contact.core import cores_of, place as placed
from tamias2d.contact.gap import axes
from tamias2d.state import State
from tests.event_driven.conftest import Solving
from tests.event_driven.scenes import shape_of
from tools.measurements.impacts import gas, polygon_gas


def reversed_at(run: t2.Run, scene: t2.Scene) -> t2.Scene:
    """The scene in the last state of a run, with all velocities turned round."""
    turned = t2.Scene(gravity=scene.gravity)
    for k, body in enumerate(scene.bodies):
        if not body.dynamic:
            turned.add_static(body.shape, restitution=body.restitution)
            continue
        turned.add_body(
            body.shape,
            mass=body.mass,
            position=tuple(run.position[-1, k].tolist()),
            velocity=tuple((-run.velocity[-1, k]).tolist()),
            restitution=body.restitution,
        )
    return turned


def keeps_momentum(run: t2.Run, bodies: int) -> None:
    """So many bodies keep their momenta, at the 7 instants of a run, and gain no energy."""
    size = bodies * 2.0  # about the sum of masses times speeds, kg m/s
    np.testing.assert_allclose(run.momentum, run.momentum[:1].repeat(7, 0), atol=1e-13 * size)
    np.testing.assert_allclose(
        run.angular_momentum, run.angular_momentum[0].repeat(7), atol=1e-13 * size
    )
    assert (np.diff(run.energy) <= 1e-13 * run.energy[0]).all()


def test_energy_is_kept_to_rounding_over_a_long_run() -> None:
    scene = gas(200)
    run = t2.simulate(scene, duration=4.0, times=[0.0, 4.0], work_limit=10**6)
    assert run.notes[0].startswith("ClosedForm()")
    assert len(run.impacts) > 12_000
    # each impact rounds the energy of its bodies by a few units of 2e-16: a walk of 2e4 steps
    assert run.energy[1] == pytest.approx(run.energy[0], rel=1e-13)


def test_polygons_keep_energy_and_do_not_overlap() -> None:
    """A tenth of a box, for so long that each polygon meets some 200 others."""
    scene, times = polygon_gas(100, seed=3), np.linspace(0.0, 5.0, 400)
    run = t2.simulate(scene, duration=5.0, times=times)
    assert run.notes[0].startswith("ClosedForm()")
    assert len(run.impacts) > 5000
    # as above, a walk of 1e4 steps
    np.testing.assert_allclose(run.energy, run.energy[0], rtol=1e-13)
    assert least_gap(run, scene) > -1e-12  # places of 1 m and times of 5 s, to rounding


def least_gap(run: t2.Run, scene: t2.Scene) -> float:
    """Return the least gap of all pairs at all samples, m."""
    cores, found = cores_of(scene), math.inf
    reach = np.array([core.bounding_radius for core in cores])
    for k, place_of in enumerate(run.position):
        bodies = [
            placed(core, State(tuple(at), turn, (0.0, 0.0), 0.0))
            for core, at, turn in zip(cores, place_of.tolist(), run.orientation[k], strict=True)
        ]
        apart = np.hypot(*(place_of[:, None] - place_of).transpose(2, 0, 1))
        for i, j in np.argwhere(np.triu(apart < reach[:, None] + reach, 1)).tolist():
            if cores[i].dynamic or cores[j].dynamic:
                found = min(found, max(axis.gap for axis in axes(bodies[i], bodies[j])))
    return found


def test_energy_is_shared_alike_by_all_freedoms() -> None:
    """Equipartition: smooth polygons turn with a third of the energy, however they began."""
    scene = polygon_gas(150, seed=2)
    times = np.linspace(2.0, 6.0, 80)  # after some 50 impacts of each
    run = t2.simulate(scene, duration=6.0, times=times, work_limit=10**6)
    inertia = np.array([body.inertia if body.dynamic else 0.0 for body in scene.bodies])
    turning = (inertia * run.angular_velocity**2).sum(axis=1) / 2
    # 80 looks at 150 bodies: the mean of 1/3 is off by some 0.5 %
    assert (turning / run.energy).mean() == pytest.approx(1 / 3, rel=0.03)


def test_shapes_without_walls_keep_momentum() -> None:
    """A cloud of all convex shapes that collapses and flies apart, with friction."""
    scene, chance = t2.Scene(gravity=(0.0, 0.0)), np.random.default_rng(7)
    for k in chance.permutation(225)[:120].tolist():
        at = np.array(divmod(k, 15)) * 0.2 - 1.4
        going = tuple((-at + 0.1 * chance.normal(size=2)).tolist())
        scene.add_body(
            shape_of(chance, chance.uniform(0.02, 0.09)), mass=chance.uniform(0.5, 2.0),
            position=tuple(at.tolist()), velocity=going, restitution=0.8, friction=0.4,
            angular_velocity=chance.normal(0, 5), orientation=chance.normal(),
        )  # fmt: skip
    run = t2.simulate(scene, duration=3.0, times=np.linspace(0, 3, 7))
    assert run.notes[0].startswith("ClosedForm()")
    assert len(run.impacts) > 150
    keeps_momentum(run, 120)


def test_discs_without_walls_keep_momentum() -> None:
    """A cloud that collapses and flies apart: no outer impulse at all."""
    scene, chance = t2.Scene(gravity=(0.0, 0.0)), np.random.default_rng(5)
    for place in chance.permutation(400)[:150].tolist():
        position = np.array(divmod(place, 20)) * 0.1 - 0.95
        velocity = -position + 0.1 * chance.normal(size=2)
        disc, mass = t2.Disc(radius=chance.uniform(0.01, 0.04)), chance.uniform(0.5, 2.0)
        scene.add_body(
            disc, mass=mass, position=tuple(position), velocity=tuple(velocity), restitution=1.0,
            friction=0.4, angular_velocity=chance.normal(),
        )  # fmt: skip
    run = t2.simulate(scene, duration=3.0, times=np.linspace(0, 3, 7))
    assert len(run.impacts) > 250
    keeps_momentum(run, 150)


def test_a_gas_goes_back_to_where_it_came_from() -> None:
    """Within the horizon: an error grows by about 20 with each of a disc's impacts."""
    scene = gas(1000, seed=2)
    there = t2.simulate(scene, duration=0.06, times=[0.0, 0.06])
    assert len(there.impacts) > 700  # 1.5 of each disc, and more of the fastest
    back = t2.simulate(reversed_at(there, scene), duration=0.06, times=[0.06])
    assert len(back.impacts) == len(there.impacts)
    # of the fastest disc some 6 impacts: 20^6 * 1e-16 is 6e-9
    assert np.abs(back.position[-1] - there.position[0]).max() < 1e-8
    np.testing.assert_allclose(-back.velocity[-1], there.velocity[0], atol=1e-5)


def test_the_order_of_the_bodies_changes_nothing() -> None:
    scene = gas(150, seed=4)
    order = np.random.default_rng(1).permutation(len(scene))
    mixed = t2.Scene(gravity=(0.0, 0.0))
    for k in order.tolist():
        body = scene.bodies[k]
        if body.dynamic:
            mixed.add_body(
                body.shape, mass=1.0, position=body.position, velocity=body.velocity,
                restitution=1.0,
            )  # fmt: skip
        else:
            mixed.add_static(body.shape, restitution=1.0)
    runs = [t2.simulate(each, duration=0.05, times=[0.0, 0.05]) for each in (scene, mixed)]
    assert len(runs[0].impacts) == len(runs[1].impacts) > 100
    back = np.argsort(order)
    # as for the way back: what differs are roundings of the first impacts
    np.testing.assert_allclose(runs[1].position[:, back], runs[0].position, atol=1e-9)


def test_the_pressure_is_that_of_hard_discs() -> None:
    """Henderson's equation of state (Mol. Phys. 30, 971 (1975)), from the virial of all impacts.

    The discs' centres have the box less a rim of one radius; its surface counts for less than 1 %.
    """
    count, share, duration = 1600, 0.1, 2.5
    scene = gas(count, share=share, seed=6)
    run = t2.simulate(scene, duration=duration, times=[0.0, duration], work_limit=10**6)
    walls = sum(not body.dynamic for body in scene.bodies)
    met = (run.impacts.bodies >= walls).all(axis=1)
    assert met.sum() > 50_000  # the statistical error is some 1/sqrt of that, 0.4 %
    diameter = 2 * 0.01
    virial = float(run.impacts.impulse[met].sum()) * diameter / duration
    found = 1 + virial / (2 * run.energy[0])
    density = share * (1 + 2 * 0.01 / math.sqrt(count * math.pi * 0.01**2 / share))
    henderson = (1 + density**2 / 8) / (1 - density) ** 2
    print(found, henderson, found / henderson - 1)
    assert found == pytest.approx(henderson, rel=0.02)


def test_the_impacts_of_two_blocks_count_the_digits_of_pi(solving: Solving) -> None:
    """Galperin (2003): a light disc between a wall and one of 100^k times its mass."""
    for k, count in enumerate((3, 31, 314, 3141, 31415)):
        scene = t2.Scene(gravity=(0.0, 0.0))
        scene.add_static(t2.HalfPlane(normal=(1.0, 0.0), offset=0.0), restitution=1.0)
        for mass, x, speed in ((1.0, 1.0, 0.0), (100.0**k, 2.0, -1.0)):
            scene.add_body(
                t2.Disc(radius=0.1), mass=mass, position=(x, 0.0), velocity=(speed, 0.0),
                restitution=1.0,
            )  # fmt: skip
        run, why = solving(scene, "compiled", 30.0, times=[30.0])
        assert not why
        assert len(run.impacts) == count


def test_every_touching_pair_is_near(solving: Solving) -> None:
    """Discs of very different sizes, some of them far from all others: none passes another."""
    chance, scene = np.random.default_rng(8), t2.Scene(gravity=(0.0, -1.0))
    for normal, offset in (((0.0, 1.0), -3.0), ((1.0, 0.0), -3.0), ((-1.0, 0.0), -3.0)):
        scene.add_static(t2.HalfPlane(normal=normal, offset=offset), restitution=1.0)
    for place in chance.permutation(400)[:90].tolist():
        x, y = np.array(divmod(place, 20)) * 0.3 - 2.85
        radius = chance.choice([0.01, 0.05, 0.14])
        velocity = tuple(chance.normal(0, 2, 2))
        scene.add_body(
            t2.Disc(radius=radius), mass=radius, position=(x, y), velocity=velocity, restitution=1.0
        )
    scene.add_body(
        t2.Disc(radius=2.0), mass=5.0, position=(0.0, 9.0), velocity=(0.0, -9.0), restitution=1.0
    )
    scene.add_body(t2.Disc(radius=0.1), mass=5.0, position=(0.0, 1e7), restitution=1.0)
    times = np.linspace(0.0, 2.0, 400)
    run, why = solving(scene, "compiled", 2.0, times=times)
    assert not why
    assert len(run.impacts) > 500
    radii = np.array([getattr(body.shape, "radius", 0.0) for body in scene.bodies])[3:]
    apart = np.triu_indices(len(radii), 1)
    for positions in run.position[:, 3:]:
        way = np.hypot(*(positions[apart[0]] - positions[apart[1]]).T)
        assert (way - (radii[apart[0]] + radii[apart[1]])).min() > -1e-8  # places of 1e7 m
        assert (positions[:, 1] + 3.0 - radii).min() > -1e-8
