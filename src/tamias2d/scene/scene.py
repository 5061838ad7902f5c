"""A scene: the bodies, what acts on them, and what they do when they meet (R1, R2, R3).

Serves: users who build scenes in Python. Hides: how bodies and pairs are stored and named.
"""

import hashlib
from collections.abc import Iterator, Sequence
from itertools import count
from numbers import Integral
from typing import Any

from tamias2d.errors import SceneError
from tamias2d.generated import definitions
from tamias2d.scene.acting import varying_loads
from tamias2d.scene.bodies import Body
from tamias2d.scene.checks import (
    checked_angle,
    checked_drag,
    checked_duration,
    checked_friction,
    checked_inertia,
    checked_mass,
    checked_restitution,
    checked_spin,
    checked_text,
    checked_velocity,
    optional_friction,
    optional_restitution,
    refuse_placed_half_plane,
    refuse_shape,
    refuse_turning_particle,
    refuse_undefined_law,
)
from tamias2d.scene.compound import Shape
from tamias2d.scene.fields import ForceField, checked_field, refuse_field
from tamias2d.scene.filters import checked_mask, checked_sensor, checked_whole, may_touch
from tamias2d.scene.law import checked_force, checked_law
from tamias2d.scene.rules import RuleError, Vector, VectorLike, number, sequence, shown, vector
from tamias2d.scene.springs import Spring, checked_spring, refuse_spring
from tamias2d.suggestions import suggests

_MAX_NAME = 100


@suggests
class Scene:
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
        self._gravity = vector(gravity, "gravity", "the scene", remedy, at=("gravity",))
        self._name = checked_text(name, "name")
        self._says = checked_text(" ".join(says.split()) if isinstance(says, str) else says, "says")
        self._duration = None if duration is None else checked_duration(duration)
        self._bodies: list[Body] = []
        self._shown: tuple[Body, ...] = ()  # the same, as they were last asked for
        self._index: dict[str, int] = {}
        self._of_pairs: dict[tuple[int, int], float] = {}
        self._friction_of_pairs: dict[tuple[int, int], float] = {}
        self._springs: list[Spring] = []
        self._attraction: float | None = None
        self._fields: list[ForceField] = []

    @property
    def gravity(self) -> Vector:
        """The same for all bodies, m/s^2."""
        return self._gravity

    @property
    def name(self) -> str:
        """What it is called; empty if nothing."""
        return self._name

    @property
    def says(self) -> str:
        """What is to be seen in it, on one line."""
        return self._says

    @property
    def duration(self) -> float | None:
        """How long it is worth looking at, s."""
        return self._duration

    @property
    def bodies(self) -> tuple[Body, ...]:
        """All bodies, static ones too, in the order of adding."""
        if len(self._shown) != len(self._bodies):
            self._shown = tuple(self._bodies)
        return self._shown

    @property
    def restitution_of_pairs(self) -> dict[tuple[int, int], float]:
        """The restitutions that were set for pairs, by index, the lower one first, in order."""
        return dict(sorted(self._of_pairs.items()))

    @property
    def friction_of_pairs(self) -> dict[tuple[int, int], float]:
        """The coefficients of friction that were set for pairs, likewise."""
        return dict(sorted(self._friction_of_pairs.items()))

    @property
    def springs(self) -> tuple[Spring, ...]:
        """All springs, in the order of adding."""
        return tuple(self._springs)

    @property
    def attraction(self) -> float | None:
        """The gravitational constant if the bodies attract each other, m^3/(kg s^2)."""
        return self._attraction

    @property
    def fields(self) -> tuple[ForceField, ...]:
        """All force fields, in the order of adding."""
        return tuple(self._fields)

    def loads_constant(self, body: int) -> bool:
        """Whether all that acts on a body, given by its index, is the same at all times."""
        return body not in varying_loads(self)

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
        from mass and shape unless it is stated.

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
        refuse_turning_particle(body)
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
        category: int = 1,
        mask: int | None = None,
        group: int = 0,
        sensor: bool = False,
        name: str | None = None,
    ) -> int:
        """Add a body that nothing moves, and return its index.

        A half-plane says where it is by itself: it takes neither position nor orientation. The rest
        is as in `add_body`.

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
        category: int = 1,
        mask: int | None = None,
        group: int = 0,
        sensor: bool = False,
        name: str | None = None,
    ) -> int:
        """Add a body that moves as it is told, whatever it meets, and return its index.

        Its velocity in m/s and angular velocity in rad/s stay as they are: a lift, or a drum that
        turns. The rest is as in `add_body`.

        Raises:
            InputError: a value breaks a rule (R4); the message names it.
        """
        name = self._free_name(name)
        of = f"kinematic body '{name}'"
        refuse_shape(shape, of)
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
                **_surface(of, restitution, friction, category, mask, group, sensor),
            )
        )

    def set_restitution(self, first: int | str, second: int | str, value: float) -> None:
        """Set the restitution of one pair of bodies, given by index or name (R3)."""
        i, j = self._two(first, second)
        self._of_pairs[i, j] = checked_restitution(value, f"the pair {self._pair(i, j)}")

    def set_friction(self, first: int | str, second: int | str, value: float) -> None:
        """Set the coefficient of friction of one pair of bodies, given by index or name (R3)."""
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

    def restitution(self, i: int, j: int) -> float:
        """Return the restitution with which bodies i and j part.

        It is what was set for the pair, else what their own make of it (`pair_restitution`), else
        the one that only one of them states.

        Raises:
            SceneError: nothing states it (R3).
        """
        if (set_for_pair := self._of_pairs.get((min(i, j), max(i, j)))) is not None:
            return set_for_pair
        own = (self._bodies[i].restitution, self._bodies[j].restitution)
        stated = [value for value in own if value is not None]
        if not stated:
            raise SceneError(
                f"restitution of the pair {self._pair(i, j)}: not stated, and they can meet (R3). "
                "Give one of them a restitution, or set it for the pair."
            )
        return float(definitions.pair_restitution(stated[0], stated[-1]))

    def friction(self, i: int, j: int) -> float:
        """Return the coefficient of friction between bodies i and j.

        It is what was set for the pair, else what their own make of it (`pair_friction`), else the
        one that only one of them states, and 0 where nothing does.
        """
        if (set_for_pair := self._friction_of_pairs.get((min(i, j), max(i, j)))) is not None:
            return set_for_pair
        first, second = self._bodies[i].friction, self._bodies[j].friction
        if first is None or second is None:
            return first or second or 0.0
        return float(definitions.pair_friction(first, second))

    def collides(self, i: int, j: int) -> bool:
        """Return whether bodies i and j may touch, by their groups, categories and masks.

        Two of the same group, if that is not 0, do where it is positive and do not where it is
        negative. Any others do if each one's category shares a bit with the other's mask.
        """
        return may_touch(self._bodies[i], self._bodies[j])

    def index(self, body: int | str) -> int:
        """Return the index of a body given by its index or name; raise `InputError` if none."""
        if isinstance(body, str):
            if body in self._index:
                return self._index[body]
        elif isinstance(body, Integral) and not isinstance(body, bool):
            k = int(body)
            if 0 <= k < len(self._bodies):
                return k
        names = shown(list(self._index))
        raise RuleError(
            f"body {shown(body)}: the scene has none such (R1). Name one of {names}.", "bodies"
        )

    def digest(self) -> str:
        """Return the SHA-256 of the scene's text: equal scenes have equal digests."""
        from tamias2d.scene.writing import scene_text

        return hashlib.sha256(scene_text(self).encode()).hexdigest()

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Scene):
            return False
        return self.bodies == other.bodies and vars(self) == vars(other)  # asking sets `_shown`

    __hash__ = None  # type: ignore[assignment]  # bodies can still be added

    def __len__(self) -> int:
        return len(self._bodies)

    def __iter__(self) -> Iterator[Body]:
        return iter(self.bodies)

    def __repr__(self) -> str:
        return f"<Scene {self.name!r} of {len(self)} bodies>"

    def _two(self, first: int | str, second: int | str) -> tuple[int, int]:
        """Return the indices of two bodies, the lower one first."""
        i, j = sorted((self.index(first), self.index(second)))
        if i == j:
            raise RuleError(
                f"pair of '{self._bodies[i].name}' with itself (R3). Name two bodies.", "bodies"
            )
        return i, j

    def _pair(self, i: int, j: int) -> str:
        return f"'{self._bodies[i].name}' and '{self._bodies[j].name}'"

    def _append(self, body: Body) -> int:
        self._index[body.name] = len(self._bodies)
        self._bodies.append(body)
        return self._index[body.name]

    def _free_name(self, name: object) -> str:
        if name is None:
            name = next(free for k in count(len(self)) if (free := f"body{k}") not in self._index)
        name = checked_text(name, "name")
        if not name.strip() or len(name) > _MAX_NAME:
            raise RuleError(
                f"name {shown(name)} of a body: must have 1 to {_MAX_NAME} characters (R1). "
                "Give a word.",
                "name",
            )
        if name in self._index:
            raise RuleError(
                f"name '{name}': another body has it (R1). Give each body a name of its own.",
                "name",
            )
        return name


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


def checked_scene(value: object) -> Scene:
    """Return what is a scene, or raise `RuleError`."""
    if not isinstance(value, Scene):
        raise RuleError(
            f"scene: found {shown(value)}: must be a Scene (R1). Make one, or load one.", "scene"
        )
    return value
