"""Programs that step a scene with hinges: Tamias2D, Box2D and Pymunk."""

import math
from copy import deepcopy
from dataclasses import replace
from typing import Any

import numpy as np

from tamias2d.scene import Joint, Scene
from tamias2d.scene.freedoms import Freedom
from tamias2d.simulator import Simulator
from tamias2d.state import Array
from tamias2d.study.engines.box2d import Box2D
from tamias2d.study.engines.chipmunk import Chipmunk
from tools.measurements.mechanisms.scenes import inertia_between


class Own:
    """Our own frame loop."""

    def __init__(self, scene: Scene, time_step: float, substeps: int = 4) -> None:
        self._sim = Simulator(scene, time_step=time_step, substeps=substeps)
        self.name = f"Tamias2D, {substeps} substeps"

    def step(self, count: int) -> None:
        """Go so many time steps ahead, one by one."""
        for _ in range(count):
            self._sim.step()

    def state(self) -> Array:
        """Return (n, 6): positions, orientations and their rates."""
        sim = self._sim
        return np.column_stack((sim.position, sim.orientation, rates_of(sim)))


def rates_of(sim: Simulator) -> Array:
    """Return (n, 3): velocities, m/s, and angular velocities, rad/s."""
    return np.column_stack((sim.velocity, sim.angular_velocity))


def _bare(scene: Scene) -> Scene:
    """Return the bodies of a scene without joints and groups, which its engines are told apart."""
    bare = deepcopy(scene)
    bare._joints.clear()
    bare._bodies[:] = [replace(body, group=0) for body in bare._bodies]
    bare._shown = ()
    return bare


class JointedBox2D(Box2D):
    """Box2D with hinges."""

    def __init__(self, scene: Scene, time_step: float) -> None:
        super().__init__(_bare(scene), time_step)
        import pyb2d3

        for body, own in zip(scene.bodies, self.bodies, strict=True):
            for shape in own.shapes:
                shape.filter = pyb2d3.make_filter(group_index=body.group)
        ground = self._world.create_body()
        for joint in hinges_of(scene):
            a, b = (ground if k is None else self.bodies[k] for k in joint.ends[:2])
            ends = {"local_anchor_a": joint.anchors[0], "local_anchor_b": joint.anchors[1]}
            self._world.create_revolute_joint(a, b, **ends, **_laws(scene, joint))


def hinges_of(scene: Scene) -> list[Joint]:
    """Return the joints of a scene that are hinges; others are laws of their angles."""
    return [joint for joint in scene.joints if joint.rigid]


def _freedoms(scene: Scene, hinge: Joint) -> list[Freedom]:
    """Return what is said of the angle of a hinge, by itself or by another joint."""
    return [law for joint in scene.joints if joint.ends == hinge.ends for law in joint.freedoms]


def _laws(scene: Scene, joint: Joint) -> dict[str, Any]:
    """Return the motor and the spring of a hinge as Box2D takes them."""
    found: dict[str, Any] = {}
    inertia = inertia_between(scene, joint)
    for law in _freedoms(scene, joint):
        if law.motor:
            found |= {"enable_motor": True, "motor_speed": law.motor.speed}
            found |= {"max_motor_torque": law.motor.maximum}
        if law.spring:
            pace = math.sqrt(law.spring.stiffness / inertia)
            ratio = law.spring.damping / (2 * pace * inertia)
            found |= {"enable_spring": True, "hertz": pace / (2 * math.pi), "damping_ratio": ratio}
    return found


class JointedChipmunk(Chipmunk):
    """Pymunk with hinges."""

    def __init__(self, scene: Scene, time_step: float) -> None:
        import pymunk

        super().__init__(_bare(scene), time_step)
        for body, own in zip(scene.bodies, self.bodies, strict=True):
            for shape in own.shapes:
                shape.filter = pymunk.ShapeFilter(group=-body.group)
        for joint in hinges_of(scene):
            a, b = (
                self._space.static_body if k is None else self.bodies[k] for k in joint.ends[:2]
            )
            hinge = pymunk.PivotJoint(a, b, joint.anchors[0], joint.anchors[1])
            hinge.collide_bodies = False
            self._space.add(hinge)
            for law in _freedoms(scene, joint):
                if law.motor:
                    motor = pymunk.SimpleMotor(a, b, -law.motor.speed)
                    most = law.motor.maximum
                    motor.max_force = math.inf if most is None else most
                    self._space.add(motor)
                if law.spring:
                    own = (0.0, law.spring.stiffness, law.spring.damping)
                    self._space.add(pymunk.DampedRotarySpring(a, b, *own))
