"""What joints exert, as it follows from the states of a run (TM7, GD17)."""

from dataclasses import dataclass

import numpy as np

from tamias2d.generated import definitions
from tamias2d.motion.joint_code import JointCodes
from tamias2d.motion.joint_events import JointEvents
from tamias2d.motion.joint_instant import Now
from tamias2d.motion.joint_loads import Exerted, add_exerted
from tamias2d.motion.limited_mechanism import LimitedMechanism
from tamias2d.motion.loads import Loads
from tamias2d.motion.mechanism import Mechanism
from tamias2d.scene import Scene
from tamias2d.scene.joint_start import apart
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
    """(k, j), which a motor puts in, or a joint that moves with time, W; zero for all others"""
    speed: Array
    """(k, j), of what a motor drives, rad/s or m/s; zero for joints without one"""
    separation: Array
    """(k, j), by how much the joint is apart after the return to it (GD18), m"""
    angular_separation: Array
    """(k, j), by how much it is turned against what it keeps, likewise, rad"""

    def index(self, name: str) -> int:
        """Return the place of a joint; raise `ValueError` if there is none of that name."""
        return self.names.index(name)


def reactions_of(
    scene: Scene,
    times: Array,
    history: History,
    events: JointEvents | None = None,
    codes: JointCodes | None = None,
    *,
    pushed: Array | None = None,
) -> Reactions:
    """Return the reactions at states that fit the joints, at times (k,), s, between events.

    `pushed` (k, n, 3) is what contacts exert on the bodies, N and N m.
    """
    moving = [k for k, body in enumerate(scene.bodies) if body.dynamic]
    loads = Loads(scene, codes)
    loads.timeline.events += events or ()
    free = loads.free_field(moving)
    shape = (len(times), len(scene.joints))
    found = Reactions(
        names=tuple(joint.name for joint in scene.joints),
        force=np.zeros((*shape, len(ENDS), 2)),
        torque=np.zeros((*shape, len(ENDS))),
        power=np.zeros(shape),
        speed=np.zeros(shape),
        separation=np.zeros(shape),
        angular_separation=np.zeros(shape),
    )
    place = {joint.name: k for k, joint in enumerate(scene.joints)}
    for k, time in enumerate(times.tolist()):
        q = np.column_stack((history.position[k], history.orientation[k]))
        rate = np.column_stack((history.velocity[k], history.angular_velocity[k]))
        pull = free(time, q[moving], rate[moving])
        if pushed is not None:
            pull = pull + loads.inverse[moving] * pushed[k, moving]
        for own, mechanism in loads.mechanisms(moving):
            bodies = list(mechanism.bodies)
            state = (time, q[bodies], rate[bodies])
            if isinstance(mechanism, LimitedMechanism):
                now, mode = Now(*state, pull[own]), mechanism.mode(time)
                _write(found, k, mechanism.exerted(now, mode))
                _drive(found, k, mechanism, now)
                kept, numbers = mechanism.parts(mode)
                multipliers = mechanism.multipliers(now, mode)
            else:
                kept, numbers = mechanism, [place[joint.name] for joint in mechanism.joints]
                multipliers = mechanism.multipliers(*state, pull[own])
                _write(found, k, _exerted(kept, numbers, multipliers, time, q))
            _hold(found, k, numbers, kept, multipliers, *state)
    return found


def _exerted(
    mechanism: Mechanism, numbers: list[int], multipliers: Array, time: float, q: Array
) -> Exerted:
    found: Exerted = {}
    joints = dict(zip(numbers, mechanism.joints, strict=True))
    turns = dict(enumerate(q[:, 2].tolist()))
    own = q[list(mechanism.bodies)]
    add_exerted(found, mechanism.rows, numbers, joints, multipliers, time, own, turns)
    return found


def _write(found: Reactions, sample: int, exerted: Exerted) -> None:
    """Write down forces and torques at one sample."""
    for joint, (forces, torques) in exerted.items():
        found.force[sample, joint] = forces
        found.torque[sample, joint] = torques


def _drive(found: Reactions, sample: int, mechanism: LimitedMechanism, now: Now) -> None:
    """Write down speed and power of motors at one sample."""
    rates = mechanism.measures.rates(*now[:3])
    shares = mechanism.shares(now, mechanism.mode(now.time))
    for of, row in mechanism.row.items():
        if ("motor", of) in shares:
            found.speed[sample, of[0]] = rates[row]
            power = definitions.motor_power(shares["motor", of], rates[row])
            found.power[sample, of[0]] += power


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
    values = mechanism.rows.values(time, position) * mechanism.placed
    slopes = mechanism.rows.slopes(time, position)
    drift = mechanism.rows.rates(time, position, velocity)
    drift = drift - np.einsum("ijk,jk->i", slopes, velocity)
    ends = mechanism.rows.end_slopes(time, position)
    for place, rows, units in mechanism.rows.of_joints():
        joint, k = mechanism.joints[place], numbers[place]
        found.power[sample, k] -= multipliers[rows] @ drift[rows]
        if joint.equations:
            held = [end for end, body in zip(ENDS, joint.ends, strict=True) if body is not None]
            way, turn = apart(values[rows], [ends[end][rows] for end in held])
        else:
            kinds = np.array(units)
            way, turn = (float(np.linalg.norm(values[rows][kinds == unit])) for unit in "m1")
        for told, by in ((found.separation, way), (found.angular_separation, turn)):
            told[sample, k] = np.hypot(told[sample, k], by)
