"""Scenes built in Python: bodies and what acts on them are checked and added (R1, R2, R3)."""

import hashlib
from collections.abc import Sequence
from itertools import count
from numbers import Integral
from typing import Any

from tamias2d.attribute_suggestions import suggests_attributes
from tamias2d.scene.bodies import Body
from tamias2d.scene.checks import (
    MAX_NAME,
    checked_angle,
    checked_drag,
    checked_duration,
    checked_inertia,
    checked_mass,
    checked_name,
    checked_spin,
    checked_surface_speed,
    checked_text,
    checked_velocity,
    refuse_placed_half_plane,
    refuse_shape,
    refuse_turned,
    refuse_undefined_law,
)
from tamias2d.scene.compound import Shape
from tamias2d.scene.fields import checked_field, refuse_field
from tamias2d.scene.filters import checked_mask, checked_sensor, checked_whole
from tamias2d.scene.joint_anchors import anchors_of
from tamias2d.scene.joint_checks import checked_again, checked_joint
from tamias2d.scene.joint_kinds import Equation, JointKind
from tamias2d.scene.joints import End, Joint
from tamias2d.scene.law import checked_force, checked_law
from tamias2d.scene.rules import RuleError, VectorLike, number, sequence, shown, vector
from tamias2d.scene.scene_data import SceneData
from tamias2d.scene.springs import checked_spring, refuse_spring
from tamias2d.scene.surface_values import (
    checked_friction,
    checked_restitution,
    optional_friction,
    optional_restitution,
)
from tamias2d.scene.writing import scene_text
from tamias2d.suggestions import suggests

_ADDED_BY = {
    **{
        f"add_{shape.lower()}": f"add_body({shape}(...), ...)"
        for shape in ("Box", "Capsule", "Compound", "Disc", "Polygon", "Segment")
    },
    "add_circle": "add_body(Disc(...), ...)",
    "add_chain": "add_static(Chain(...))",
    "add_half_plane": "add_static(HalfPlane(...))",
    "add_ground": "add_static(HalfPlane(...))",
}
"""What other libraries have a method for, and the call that does it here."""


@suggests_attributes(_ADDED_BY)
@suggests
class Scene(SceneData):
    """The space in which bodies move and meet (R1), in SI units throughout."""

    def __init__(
        self,
        *,
        gravity: VectorLike,
        name: str = "",
        says: str = "",
        duration: float | None = None,
    ) -> None:
        """Start an empty scene; raise `InputError` if a value breaks a rule."""
        remedy = "Give (x, y) in m/s^2, (0, 0) for none."
        super().__init__(
            vector(gravity, "gravity", "the scene", remedy, at=("gravity",)),
            checked_text(name, "name"),
            checked_text(" ".join(says.split()) if isinstance(says, str) else says, "says"),
            None if duration is None else checked_duration(duration),
        )

    def add_body(
        self,
        shape: Shape | None,
        *,
        mass: float,
        position: VectorLike,
        velocity: VectorLike = (0.0, 0.0),
        orientation: float = 0.0,
        angular_velocity: float = 0.0,
        force: VectorLike | Sequence[float | str] = (0.0, 0.0),
        torque: float | str = 0.0,
        linear_drag: float = 0.0,
        quadratic_drag: float = 0.0,
        angular_drag: float = 0.0,
        inertia: float | None = None,
        restitution: float | None = None,
        friction: float | None = None,
        category: int = 1,
        mask: int | None = None,
        group: int = 0,
        sensor: bool = False,
        name: str | None = None,
    ) -> int:
        """Add a body that moves, and return its index (R2).

        `shape` None makes a particle that touches nothing. Force components and torque are numbers
        in N and N m, or expressions like ``"10[N]*sin(2[rad/s]*time)"`` of `time` and of the body's
        `position`, `velocity`, `orientation`, `angular_velocity` and `mass`. Drag slows it down by
        `linear_drag` (kg/s) times its velocity, and by `quadratic_drag` (kg/m) times the square of
        its speed (IM6); `angular_drag` (kg m^2/s) slows its turning. The inertia in kg m^2 follows
        from mass and shape unless it is stated; with ``math.inf`` nothing turns the body (DD20).

        Restitution and friction are those of its surface, see `restitution` and `friction`. Whom it
        may touch, `category`, `mask` (None for all) and `group` say, see `collides`. A `sensor`
        tells what overlaps it and pushes nothing.

        Raises:
            InputError: a value breaks a rule (R4); the message names it.
        """
        name = self._free_name(name)
        of = f"body '{name}'"
        refuse_shape(shape, of, none=True)
        kilograms = checked_mass(mass, of)
        body = Body(
            name=name,
            shape=shape,
            dynamic=True,
            mass=kilograms,
            inertia=checked_inertia(inertia, kilograms, shape, of),
            inertia_stated=inertia is not None,
            position=vector(position, "position", of, "Give (x, y) in m.", at=("position",)),
            orientation=checked_angle(orientation, of),
            velocity=checked_velocity(velocity, of),
            angular_velocity=checked_spin(angular_velocity, of),
            force=checked_force(force, of),
            torque=checked_law(torque, "torque", of, at=("torque",)),
            linear_drag=checked_drag(linear_drag, "linear_drag", of),
            quadratic_drag=checked_drag(quadratic_drag, "quadratic_drag", of),
            angular_drag=checked_drag(angular_drag, "angular_drag", of),
            **_surface(of, restitution, friction, category, mask, group, sensor),
        )
        refuse_turned(body)
        refuse_undefined_law(body)
        return self._append(body)

    def add_static(
        self,
        shape: Shape,
        *,
        position: VectorLike = (0.0, 0.0),
        orientation: float = 0.0,
        restitution: float | None = None,
        friction: float | None = None,
        surface_speed: float = 0.0,
        category: int = 1,
        mask: int | None = None,
        group: int = 0,
        sensor: bool = False,
        name: str | None = None,
    ) -> int:
        """Add a body that nothing moves, and return its index.

        A half-plane says where it is by itself: it takes neither position nor orientation. A
        surface that runs, as a belt, has a `surface_speed` in m/s, counter-clockwise around the
        body, along a chain from its first vertex on, on each side (DD97). The rest is as in
        `add_body`.

        Raises:
            InputError: a value breaks a rule (R4); the message names it.
        """
        name = self._free_name(name)
        of = f"static body '{name}'"
        refuse_shape(shape, of, static=True)
        body = Body(
            name=name,
            shape=shape,
            dynamic=False,
            position=vector(position, "position", of, "Give (x, y) in m.", at=("position",)),
            orientation=checked_angle(orientation, of),
            surface_speed=checked_surface_speed(surface_speed, of),
            **_surface(of, restitution, friction, category, mask, group, sensor),
        )
        refuse_placed_half_plane(body)
        return self._append(body)

    def add_kinematic(
        self,
        shape: Shape,
        *,
        position: VectorLike,
        velocity: VectorLike = (0.0, 0.0),
        orientation: float = 0.0,
        angular_velocity: float = 0.0,
        restitution: float | None = None,
        friction: float | None = None,
        surface_speed: float = 0.0,
        category: int = 1,
        mask: int | None = None,
        group: int = 0,
        sensor: bool = False,
        name: str | None = None,
    ) -> int:
        """Add a body that moves as it is told, whatever it meets, and return its index.

        Its velocity in m/s and angular velocity in rad/s stay as they are: a lift, or a drum that
        turns. The rest is as in `add_static`.

        Raises:
            InputError: a value breaks a rule (R4); the message names it.
        """
        name = self._free_name(name)
        of = f"kinematic body '{name}'"
        refuse_shape(shape, of, told=True)
        return self._append(
            Body(
                name=name,
                shape=shape,
                dynamic=False,
                kinematic=True,
                position=vector(position, "position", of, "Give (x, y) in m.", at=("position",)),
                orientation=checked_angle(orientation, of),
                velocity=checked_velocity(velocity, of),
                angular_velocity=checked_spin(angular_velocity, of),
                surface_speed=checked_surface_speed(surface_speed, of),
                **_surface(of, restitution, friction, category, mask, group, sensor),
            )
        )

    def set_restitution(self, first: int | str, second: int | str, value: float) -> None:
        """Set the restitution, from 0 to 1, of one pair of bodies, given by index or name (R3).

        Raises:
            InputError: a body is not there, both are the same, or the value is out of range.
        """
        i, j = self._two(first, second)
        self._of_pairs[i, j] = checked_restitution(value, f"the pair {self._pair(i, j)}")

    def set_friction(self, first: int | str, second: int | str, value: float) -> None:
        """Set the coefficient of friction of one pair of bodies, given by index or name (R3).

        Raises:
            InputError: a body is not there, both are the same, or the value is negative.
        """
        i, j = self._two(first, second)
        self._friction_of_pairs[i, j] = checked_friction(value, f"the pair {self._pair(i, j)}")

    def add_spring(
        self,
        first: int | str,
        second: int | str | VectorLike,
        *,
        stiffness: float,
        rest_length: float,
        damping: float = 0.0,
        anchor: VectorLike = (0.0, 0.0),
        other_anchor: VectorLike = (0.0, 0.0),
    ) -> int:
        """Add a spring, and return its index (IM7).

        It holds a body, given by index or name, and another one or a point (x, y) in m. It pulls
        with `stiffness` (N/m) times what it is longer than `rest_length` (m), and a damper beside
        it with `damping` (kg/s) times the speed at which it lengthens. It holds a body at an
        anchor (x, y), in m from the centre of mass and in the body's own axes.

        Raises:
            InputError: a value breaks a rule (R4), or it would move nothing; the message says so.
        """
        fixed = not isinstance(second, Integral | str)
        ends = self.index(first), None if fixed else self.index(second)  # type: ignore[arg-type]
        of = f"spring {len(self._springs)} of '{self._bodies[ends[0]].name}'"
        spring = checked_spring(
            ends,
            of,
            point=second if fixed else (0.0, 0.0),
            stiffness=stiffness,
            rest_length=rest_length,
            damping=damping,
            anchor=anchor,
            other_anchor=other_anchor,
        )
        refuse_spring(spring, self._bodies, of)
        self._springs.append(spring)
        return len(self._springs) - 1

    def add_joint(
        self,
        kind: JointKind,
        first: int | str | VectorLike,
        second: int | str | VectorLike | None = None,
        *,
        at: VectorLike | None = None,
        anchor: VectorLike | None = None,
        other_anchor: VectorLike | None = None,
        third: int | str | None = None,
        third_anchor: VectorLike | None = None,
        name: str | None = None,
        collide: bool = False,
        break_force: float | None = None,
        break_torque: float | None = None,
    ) -> int:
        """Tie two bodies, or a body and the plane, and return the joint's index (TM7).

        A and B are bodies, given by index or name, or points (x, y) of the plane in m; a third one,
        C, is what a gear or a pulley is seen from. It holds a body at its centre of mass, or at an
        anchor (x, y), in m from there and in the body's own axes; or all bodies `at` a point (x, y)
        of the world, m, where they are now. Bodies that are tied do not touch, unless they
        `collide`. The joint breaks where its reaction reaches `break_force`, N, or `break_torque`,
        N m (GD23).

        Raises:
            InputError: a value breaks a rule (R4), the joint moves nothing, its equation has no
                derivative, or it does not hold at the start; the message says so.
        """
        name = self._free_joint_name(name)
        if second is None and isinstance(kind, Equation):  # it says itself what it holds
            second = (0.0, 0.0)
        ends = (
            self._end(first, "first", name),
            self._end(second, "second", name),
            (0.0, 0.0) if third is None else self.index(third),
        )
        anchors = anchors_of(kind, ends, (anchor, other_anchor, third_anchor), at, self._bodies)
        joint = checked_joint(
            kind, name, ends, anchors, collide, self._bodies, (break_force, break_torque)
        )
        self._append_joint(joint)
        return len(self._joints) - 1

    def repeat_joint(self, joint: Joint) -> None:
        """Add a joint of a scene whose bodies have the same indices.

        Raises:
            InputError: it does not hold at the start (TM7); the message says so.
        """
        self._append_joint(checked_again(joint, self._bodies))

    def add_attraction(self, *, gravitational_constant: float) -> None:
        """Let all bodies that move attract each other, each pair by its masses (IM5).

        Raises:
            InputError: the constant in m^3/(kg s^2) is not positive, or was given before.
        """
        symbol, remedy = "gravitational_constant", "Give it in m^3/(kg s^2)."
        value = number(gravitational_constant, symbol, "the scene", remedy, at=(symbol,))
        if self._attraction is not None:
            raise RuleError(
                "attraction of the scene: stated twice (IM5). State it once, for all bodies.",
                symbol,
            )
        self._attraction = value

    def add_field(
        self,
        *,
        force: Sequence[float | str] | None = None,
        torque: float | str | None = None,
        bodies: Sequence[int | str] | None = None,
    ) -> int:
        """Add a law of your own for all bodies that move, or for some, and return its index (IM8).

        Force components and torque are as for one body in `add_body`; the state and the mass in
        them are those of each body on which the field acts.

        Raises:
            InputError: a law breaks a rule (R4), or a body does not move; the message says so.
        """
        of = f"field {len(self._fields)}"
        chosen = None
        if bodies is not None:
            names = sequence(bodies, of, "Name some, or leave them out.", at=("bodies",))
            chosen = tuple(self.index(body) for body in names)  # type: ignore[arg-type]
        field = checked_field(force, torque, chosen, of)
        refuse_field(field, self._bodies, of)
        self._fields.append(field)
        return len(self._fields) - 1

    def digest(self) -> str:
        """Return the SHA-256 of the scene's text: equal scenes have equal digests."""
        return hashlib.sha256(scene_text(self).encode()).hexdigest()

    def _two(self, first: int | str, second: int | str) -> tuple[int, int]:
        """Return the indices of two bodies, the lower one first."""
        i, j = sorted((self.index(first), self.index(second)))
        if i == j:
            raise RuleError(
                f"pair of '{self._bodies[i].name}' with itself (R3). Name two bodies.", "bodies"
            )
        return i, j

    def _end(self, value: object, key: str, name: str) -> End:
        """Return a body's index, or a point of the plane, m."""
        if isinstance(value, Integral | str):
            return self.index(value)  # type: ignore[arg-type]
        remedy = "Give the name of a body, or a point (x, y) of the plane in m."
        return vector(value, "point", f"joint '{name}'", remedy, at=(key,))

    def _free_joint_name(self, name: object) -> str:
        taken = self._joint_names
        if name is None:
            name = next(free for k in count(len(taken)) if (free := f"joint{k}") not in taken)
        name = checked_text(name, "name")
        if not name.strip() or len(name) > MAX_NAME or name in taken:
            raise RuleError(
                f"name {shown(name)} of a joint: must have 1 to {MAX_NAME} characters, and be no "
                "other joint's (R1). Give a word of its own.",
                "name",
            )
        return name

    def _append_joint(self, joint: Joint) -> None:
        self._joints.append(joint)
        self._joint_names.add(joint.name)

    def _append(self, body: Body) -> int:
        self._index[body.name] = len(self._bodies)
        self._bodies.append(body)
        return self._index[body.name]

    def _free_name(self, name: object) -> str:
        if name is None:
            name = next(free for k in count(len(self)) if (free := f"body{k}") not in self._index)
        return checked_name(name, self._index)


def _surface(
    of: str,
    restitution: float | None,
    friction: float | None,
    category: int,
    mask: int | None,
    group: int,
    sensor: bool,
) -> dict[str, Any]:
    """Return the checked values of a body that say what happens where it touches another."""
    return {
        "restitution": optional_restitution(restitution, of),
        "friction": optional_friction(friction, of),
        "category": checked_whole(category, "category", of),
        "mask": checked_mask(mask, of),
        "group": checked_whole(group, "group", of),
        "sensor": checked_sensor(sensor, of),
    }
