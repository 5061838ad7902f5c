"""What contacts that last exert on bodies, at the samples of a run."""

from collections.abc import Callable, Sequence

import numpy as np

from tamias2d.contact.active_contacts import ActiveContacts
from tamias2d.contact.core import Core
from tamias2d.generated import definitions
from tamias2d.path import Paths
from tamias2d.state import Acceleration, Array, Constraint, ExertingConstraint, History, State


def contact_loads(
    cores: Sequence[Core], active: ActiveContacts, motion: Paths, times: Array, history: History
) -> Array:
    """Return the forces and torques (k, n, 3) on n bodies, N and N m, in their states at times."""
    found = np.zeros((*history.orientation.shape, 3))
    for sample, time in enumerate(times.tolist()):
        at = _at_sample(history, sample)
        for bodies, constraint in _held(active, time, found.shape[1]):
            free = np.array([motion.free(body, time, at) for body in bodies])
            if isinstance(constraint, ExertingConstraint):
                states = [at(body) for body in bodies]
                found[sample, bodies] = constraint.exerted(time, free, states)
            else:
                x, y, turn = free[0].tolist()
                constrained = constraint((x, y, turn), at(bodies[0]))
                found[sample, bodies[0]] = _reaction(cores[bodies[0]], (x, y, turn), constrained)
    return found


def _reaction(
    core: Core, free: Acceleration, constrained: Acceleration
) -> tuple[float, float, float]:
    """Return what holds a body, N, N and N m, by its accelerations without and with it (DD111).

    The torque on a body that nothing turns is not told: it is zero.
    """
    force = definitions.reaction_force(constrained[:2], free[:2], core.inverse_mass)
    if core.inverse_inertia == 0.0:
        return (*force, 0.0)
    torque = definitions.reaction_torque(constrained[2], free[2], core.inverse_inertia)
    return (*force, float(torque))


def _held(active: ActiveContacts, time: float, count: int) -> list[tuple[list[int], Constraint]]:
    """Return the constraints on bodies at a time, s, each with the bodies that it holds."""
    found: dict[int, tuple[list[int], Constraint]] = {}
    for body in range(count):
        constraint = active.constraint_at(body, time)
        if isinstance(constraint, ExertingConstraint):
            found[id(constraint)] = [*constraint.bodies], constraint
        elif constraint is not None:
            found[body] = [body], constraint
    return [*found.values()]


def _at_sample(history: History, sample: int) -> Callable[[int], State]:
    """Return the states of bodies at one sample."""
    rows = [part[sample].tolist() for part in history]
    return lambda body: State(
        tuple(rows[0][body]), rows[1][body], tuple(rows[2][body]), rows[3][body]
    )
