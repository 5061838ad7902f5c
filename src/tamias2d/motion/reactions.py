"""What joints exert, as it follows from the states of a run (TM7, GD17)."""

from dataclasses import dataclass

import numpy as np

from tamias2d.motion.loads import Loads
from tamias2d.motion.mechanism import Mechanism
from tamias2d.scene import Scene
from tamias2d.scene.springs import arm
from tamias2d.spec.constraint import ENDS
from tamias2d.state import Array, History


@dataclass(frozen=True, kw_only=True)
class Reactions:
    """What the j joints of a run exert at its k samples, and how well they hold.

    A force is told as it acts on each of the bodies A, B and C; where there is no such body, on the
    plane. Where joints depend on each other it is the least of all ways to share the load (GD19).
    """

    names: tuple[str, ...]
    """Of the joints, in the scene's order."""
    force: Array
    """(k, j, 3, 2), N"""
    torque: Array
    """(k, j, 3), about the anchor, N m"""
    power: Array
    """(k, j), which a joint puts in that moves with time, W; zero for all others"""
    separation: Array
    """(k, j), by how much the joint is apart after the return to it (GD18), m"""
    angular_separation: Array
    """(k, j), by how much it is turned against what it keeps, likewise, rad"""

    def index(self, name: str) -> int:
        """Return the place of a joint; raise `ValueError` if there is none of that name."""
        return self.names.index(name)


def reactions_of(scene: Scene, times: Array, history: History) -> Reactions:
    """Return the reactions at states that fit the joints, at times (k,), s."""
    moving = [k for k, body in enumerate(scene.bodies) if body.dynamic]
    loads = Loads(scene)
    free = loads.free_field(moving)
    shape = (len(times), len(scene.joints))
    found = Reactions(
        names=tuple(joint.name for joint in scene.joints),
        force=np.zeros((*shape, len(ENDS), 2)),
        torque=np.zeros((*shape, len(ENDS))),
        power=np.zeros(shape),
        separation=np.zeros(shape),
        angular_separation=np.zeros(shape),
    )
    place = {joint.name: k for k, joint in enumerate(scene.joints)}
    for k, time in enumerate(times.tolist()):
        q = np.column_stack((history.position[k], history.orientation[k]))
        rate = np.column_stack((history.velocity[k], history.angular_velocity[k]))
        pull = free(time, q[moving], rate[moving])
        for own, mechanism in loads.mechanisms(moving):
            bodies = list(mechanism.bodies)
            state = (time, q[bodies], rate[bodies])
            multipliers = mechanism.multipliers(*state, pull[own])
            numbers = [place[joint.name] for joint in mechanism.joints]
            _loads(found, k, numbers, mechanism, multipliers, time, q)
            _hold(found, k, numbers, mechanism, multipliers, *state)
    return found


def _loads(
    found: Reactions,
    sample: int,
    numbers: list[int],
    mechanism: Mechanism,
    multipliers: Array,
    time: float,
    q: Array,
) -> None:
    """Write down forces and torques at one sample."""
    slopes = mechanism.rows.end_slopes(time, q[list(mechanism.bodies)])
    for joint, rows, _ in mechanism.rows.of_joints():
        tied = mechanism.joints[joint]
        for i, end in enumerate(ENDS):
            x, y, turn = multipliers[rows] @ slopes[end][rows]
            body = tied.ends[i]
            rx, ry = arm(tied.anchors[i], 0.0 if body is None else float(q[body, 2]))
            found.force[sample, numbers[joint], i] = x, y
            found.torque[sample, numbers[joint], i] = turn - (rx * y - ry * x)


def _hold(
    found: Reactions,
    sample: int,
    numbers: list[int],
    mechanism: Mechanism,
    multipliers: Array,
    time: float,
    position: Array,
    velocity: Array,
) -> None:
    """Write down the power of drives, and how far joints are apart, at one sample."""
    values = mechanism.rows.values(time, position)
    slopes = mechanism.rows.slopes(time, position)
    drift = mechanism.rows.rates(time, position, velocity)
    drift = drift - np.einsum("ijk,jk->i", slopes, velocity)
    for joint, rows, units in mechanism.rows.of_joints():
        kinds = np.array(units)
        k = numbers[joint]
        found.power[sample, k] = -(multipliers[rows] @ drift[rows])
        found.separation[sample, k] = np.linalg.norm(values[rows][kinds == "m"])
        found.angular_separation[sample, k] = np.linalg.norm(values[rows][kinds == "1"])
