"""A body at rest overlaps the ground by what the model of the soft contact states, at any scale."""

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.generated import soft_contact
from tamias2d.scene import catalogue
from tamias2d.simulator import Simulator

GRAVITY = 9.81
FIRMER = 2.0
"""Times the frequency of other contacts is that of one with what does not move, as is specified."""


def overlap(body: t2.Disc | t2.Box, mass: float, height: float, substeps: int) -> float:
    """How far a body has sunk in after it has come to rest, m; a disc on a half-plane does not."""
    scene = t2.Scene(gravity=(0.0, -GRAVITY))
    ground = t2.Box(width=4 * height, height=4 * height)
    scene.add_static(ground, position=(0.0, -2 * height), restitution=0.0)
    scene.add_body(body, mass=mass, position=(0.0, height))
    sim = Simulator(scene, substeps=substeps)
    sim.step(6000)
    assert abs(sim.velocity[1]).max() < 1e-15 * GRAVITY  # at rest, but for rounding
    return height - float(sim.position[1, 1])


def stated(push: float, row_mass: float, substeps: int) -> float:
    """The overlap of a contact that carries a push, N s in each substep, on what does not move."""
    substep = 1 / 60 / substeps
    frequency = FIRMER / substep
    return -soft_contact.separation_rest(push, row_mass, frequency, substep)


@pytest.mark.parametrize(
    ("radius", "mass", "substeps"), [(0.5, 1.0, 4), (0.5, 7.0, 4), (5e-3, 1e-3, 8), (300.0, 1e6, 2)]
)
def test_a_disc_overlaps_by_what_is_stated(radius: float, mass: float, substeps: int) -> None:
    found = overlap(t2.Disc(radius=radius), mass, radius, substeps)
    weight = mass * GRAVITY / 60 / substeps
    # positions are rounded to 1e-16 of the radius
    expected = stated(weight, mass, substeps)
    assert found == pytest.approx(expected, rel=1e-9, abs=1e-15 * radius)


def test_the_two_contacts_of_a_box_share_its_weight() -> None:
    found = overlap(t2.Box(width=1.0, height=1.0), 3.0, 0.5, 4)
    inverse_mass, inverse_inertia = 1 / 3.0, 6 / 3.0
    row_mass = soft_contact.row_mass(0.0, 0.0, 0.0, inverse_mass, inverse_inertia, 0.5)
    expected = stated(3.0 * GRAVITY / 240 / 2, row_mass, 4)
    assert found == pytest.approx(expected, rel=1e-9)


def test_a_deep_pile_rests_with_little_overlap() -> None:
    """Forty layers of discs: 2 % of a radius are asked, and without preload it is 5 %."""
    scene = catalogue.load("disc-pile")
    discs = [k for k, body in enumerate(scene.bodies) if isinstance(body.shape, t2.Disc)]
    radii = np.array([scene.bodies[k].shape.radius for k in discs])
    sim = Simulator(scene)
    sim.step(1200)
    assert len(discs) == 1000
    deepest, fastest = [], []
    for _ in range(5):  # now and then some of it still slips a little
        centres = sim.position[discs]
        apart = np.linalg.norm(centres[:, None] - centres, axis=2)
        apart += np.diag(np.full(len(discs), 9.0))
        depth = (radii[:, None] + radii - apart) / np.minimum(radii[:, None], radii)
        deepest.append(depth.max())
        fastest.append(np.abs(sim.velocity).max())
        sim.step(50)
    assert min(deepest) < 0.02
    assert min(fastest) < 1e-2
