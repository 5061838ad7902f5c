"""The balance of energy over a run: all that a certificate can claim past the horizon."""

import math
from itertools import product

import numpy as np

from tamias2d.balance import kinetic_energy, uniform_potential_energy
from tamias2d.float64 import EPSILON
from tamias2d.generated import definitions
from tamias2d.run import Run
from tamias2d.scene import Freedom, Scene
from tamias2d.scene.surfaces import part_numbers, surface_values
from tamias2d.state import Array
from tamias2d.study.scale import radii

_ROUNDINGS = 4.0  # of the largest terms of the energy, in their sum


def energy_drift(run: Run) -> float | None:
    """Return how far the energy strays from what impacts leave of it, relative to the largest
    kinetic energy; None if something else in the scene may give or take energy, or nobody knows
    what impacts did, as where parts of a body bounce otherwise.
    """
    impacts = run.impacts
    if not _conserves_energy(run.scene) or np.isnan(impacts.impulse).any():
        return None
    pairs = [*map(tuple, impacts.bodies.tolist())]
    known = {pair: _restitution(run.scene, *pair) for pair in set(pairs)}
    if None in known.values():
        return None
    restitution = np.array([known[pair] for pair in pairs])
    lost = definitions.energy_loss(restitution, impacts.impulse, impacts.normal_velocity)
    before = np.searchsorted(impacts.time, run.times, side="right")
    left = run.energy[0] - np.concatenate(([0.0], np.cumsum(lost)))[before]
    largest = float(_kinetic(run).max())
    return float(np.abs(run.energy - left).max()) / largest if largest else None


def _restitution(scene: Scene, i: int, j: int) -> float | None:
    """Return the restitution of a pair; None if it differs from part to part."""
    first, second = (part_numbers(scene.bodies[k]) for k in (i, j))
    found = {scene.restitution(i, j, parts=parts) for parts in product(first, second)}
    return found.pop() if len(found) == 1 else None


def energy_rise(run: Run) -> float | None:
    """Return by how much the energy of a run rises above what it was before, as `rise` does."""
    return rise(run.scene, run.energy, _kinetic(run))


def rise(scene: Scene, energy: Array, kinetic: Array) -> float | None:
    """Return by how much energies (k,), J, rise above what was before; None if something gives any.

    It is relative to the largest of the kinetic energies (k,), J, or, where that is more, to the
    energy that lifts all bodies by their radius: what is at rest moves too little to be a measure.
    """
    largest = _measure(scene, kinetic)
    if _gives_energy(scene) or not largest:
        return None
    return float((energy - np.minimum.accumulate(energy)).max()) / largest


def energy_error(scene: Scene, energy: Array, kinetic: Array) -> float | None:
    """Return the change of energies (k,), J, that no impact, friction or joint accounts for.

    It is the rise, and where nothing can take energy, the fall, too; relative as `rise` is.
    """
    risen = rise(scene, energy, kinetic)
    if risen is None or not (_conserves_energy(scene) and _elastic(scene)):
        return risen
    return float(np.abs(energy - energy[0]).max()) / _measure(scene, kinetic)


def _elastic(scene: Scene) -> bool:
    """Whether no impact takes energy."""
    stated = {value for body in scene.bodies for value in surface_values(body, "restitution")}
    return stated | {*scene.restitution_of_pairs.values()} <= {1.0}


def _measure(scene: Scene, kinetic: Array) -> float:
    mass = np.array([body.mass if body.dynamic else 0.0 for body in scene.bodies])
    lift = float((mass * radii(scene)).sum()) * math.hypot(*scene.gravity)
    return max(float(kinetic.max(initial=0.0)), lift)


def energy_rounding(run: Run) -> float:
    """Return how much of what `energy_drift` says may be the rounding of its own terms."""
    uniform = uniform_potential_energy(run.scene, run.position)
    kinetic = _kinetic(run)
    between = run.energy - kinetic - uniform.sum(axis=-1)
    size = kinetic + np.abs(uniform).sum(axis=-1) + np.abs(between)
    largest = float(kinetic.max())
    return _ROUNDINGS * EPSILON * float(size.max()) / largest if largest else 0.0


def _conserves_energy(scene: Scene) -> bool:
    """Whether all forces but those of smooth impacts are gravity, attraction and springs.

    Reactions of joints do no work, unless a freedom takes some.
    """
    slowed = any(b.linear_drag or b.quadratic_drag or b.angular_drag for b in scene.bodies)
    rough = any(any(surface_values(body, "friction")) for body in scene.bodies)
    rough = rough or any(scene.friction_of_pairs.values())
    damped = any(spring.damping for spring in scene.springs)
    braked = any(_takes_energy(each) for joint in scene.joints for each in joint.freedoms)
    return not (slowed or rough or damped or braked or _gives_energy(scene))


def _gives_energy(scene: Scene) -> bool:
    """Whether a force, or a body or a joint that moves as it is told, may do work."""
    pushed = any(law != 0 for body in scene.bodies for law in (*body.force, body.torque))
    driven = any(body.kinematic for body in scene.bodies)
    driven = driven or any(joint.driven for joint in scene.joints)
    motors = (each.motor for joint in scene.joints for each in joint.freedoms)
    driven = driven or any(motor and motor.speed and motor.maximum != 0.0 for motor in motors)
    return bool(pushed or driven or scene.fields)


def _takes_energy(freedom: Freedom) -> bool:
    """Whether a damper, a motor or brake, or what strikes a limit or a tooth may take some."""
    damped = freedom.spring and freedom.spring.damping
    return bool(freedom.motor or damped or (freedom.limits and freedom.limits.restitution < 1.0))


def _kinetic(run: Run) -> Array:
    return kinetic_energy(run.scene, run.velocity, run.angular_velocity)
