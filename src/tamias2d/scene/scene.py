"""A scene: the bodies, the gravity, and what they do when they meet (R1, R2, R3)."""

import hashlib
import math
from collections.abc import Iterator
from itertools import count

from tamias2d.errors import SceneError
from tamias2d.generated import definitions
from tamias2d.scene.bodies import Body
from tamias2d.scene.law import Law, checked_law
from tamias2d.scene.rules import RuleError, Vector, number, pair, shown, vector
from tamias2d.scene.shapes import Box, Disc, HalfPlane, Polygon, Shape

_MAX_NAME = 100


class Scene:
    """The space in which bodies move and meet (R1). SI units throughout, y counter-clockwise of x.

    `duration` is how long it is worth looking at, s; `says` what is to be seen.
    """

    def __init__(
        self,
        *,
        gravity: object,
        name: str = "",
        says: str = "",
        duration: float | None = None,
    ) -> None:
        """Start an empty scene; raise `InputError` if a value breaks a rule."""
        remedy = "Give (x, y) in m/s^2, (0, 0) for none."
        self.gravity: Vector = vector(gravity, "gravity", "the scene", remedy, at=("gravity",))
        self.name = _text(name, "name")
        self.says = _text(" ".join(says.split()) if isinstance(says, str) else says, "says")
        self.duration = None if duration is None else _duration(duration)
        self._bodies: list[Body] = []
        self._index: dict[str, int] = {}
        self._of_pairs: dict[tuple[int, int], float] = {}

    @property
    def bodies(self) -> tuple[Body, ...]:
        """All bodies, static ones too, in the order of adding."""
        return tuple(self._bodies)

    @property
    def restitution_of_pairs(self) -> dict[tuple[int, int], float]:
        """The restitutions that were set for pairs, by index, the lower one first, in order."""
        return dict(sorted(self._of_pairs.items()))

    def add_body(
        self,
        shape: Shape | None,
        *,
        mass: object,
        position: object,
        velocity: object = (0.0, 0.0),
        orientation: object = 0.0,
        angular_velocity: object = 0.0,
        force: object = (0.0, 0.0),
        torque: object = 0.0,
        inertia: object = None,
        restitution: object = None,
        name: str | None = None,
    ) -> int:
        """Add a body that moves, and return its index (R2).

        `shape` None makes a particle that touches nothing. Force components and torque are numbers
        in N and N m, or expressions of `time`: ``("10[N]*sin(2[rad/s]*time)", 0)``. The inertia in
        kg m^2 follows from mass and shape unless it is stated.

        Raises:
            InputError: a value breaks a rule (R4); the message names it.
        """
        name = self._free_name(name)
        of = f"body '{name}'"
        _refuse_shape(shape, of, static=False)
        checked_mass = _mass(mass, of)
        body = Body(
            name=name,
            shape=shape,
            dynamic=True,
            mass=checked_mass,
            inertia=_inertia(inertia, checked_mass, shape, of),
            inertia_stated=inertia is not None,
            position=vector(position, "position", of, "Give (x, y) in m.", at=("position",)),
            orientation=_angle(orientation, of),
            velocity=vector(velocity, "velocity", of, "Give (x, y) in m/s.", at=("velocity",)),
            angular_velocity=number(
                angular_velocity,
                "angular_velocity",
                of,
                "Give it in rad/s.",
                at=("angular_velocity",),
            ),
            force=_force(force, of),
            torque=checked_law(torque, "torque", of, at=("torque",)),
            restitution=_optional_restitution(restitution, of),
        )
        _refuse_turning_particle(body)
        return self._append(body)

    def add_static(
        self,
        shape: Shape,
        *,
        position: object = (0.0, 0.0),
        orientation: object = 0.0,
        restitution: object = None,
        name: str | None = None,
    ) -> int:
        """Add a body that nothing moves, and return its index.

        A half-plane says where it is by itself: it takes neither position nor orientation.

        Raises:
            InputError: a value breaks a rule (R4); the message names it.
        """
        name = self._free_name(name)
        of = f"static body '{name}'"
        _refuse_shape(shape, of, static=True)
        body = Body(
            name=name,
            shape=shape,
            dynamic=False,
            position=vector(position, "position", of, "Give (x, y) in m.", at=("position",)),
            orientation=_angle(orientation, of),
            restitution=_optional_restitution(restitution, of),
        )
        if isinstance(shape, HalfPlane) and (body.position != (0, 0) or body.orientation != 0):
            key = "position" if body.position != (0, 0) else "orientation"
            raise RuleError(
                f"{key} of {of}: a half-plane has none (R4). "
                "Say where it is by its normal and offset.",
                key,
            )
        return self._append(body)

    def set_restitution(self, first: int | str, second: int | str, value: object) -> None:
        """Set the restitution of one pair of bodies, given by index or name (R3)."""
        i, j = sorted((self.index(first), self.index(second)))
        if i == j:
            raise RuleError(
                f"pair of '{self._bodies[i].name}' with itself (R3). Name two bodies.", "bodies"
            )
        self._of_pairs[i, j] = _restitution(value, f"the pair {self._pair(i, j)}")

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

    def index(self, body: int | str) -> int:
        """Return the index of a body given by its index or name; raise `InputError` if none."""
        if isinstance(body, str):
            if body in self._index:
                return self._index[body]
        elif not isinstance(body, bool) and hasattr(body, "__index__"):
            k = body.__index__()
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
        return isinstance(other, Scene) and vars(self) == vars(other)

    __hash__ = None  # type: ignore[assignment]  # bodies can still be added

    def __len__(self) -> int:
        return len(self._bodies)

    def __iter__(self) -> Iterator[Body]:
        return iter(self.bodies)

    def __repr__(self) -> str:
        return f"<Scene {self.name!r} of {len(self)} bodies>"

    def _pair(self, i: int, j: int) -> str:
        return f"'{self._bodies[i].name}' and '{self._bodies[j].name}'"

    def _append(self, body: Body) -> int:
        self._index[body.name] = len(self._bodies)
        self._bodies.append(body)
        return self._index[body.name]

    def _free_name(self, name: object) -> str:
        if name is None:
            name = next(free for k in count(len(self)) if (free := f"body{k}") not in self._index)
        name = _text(name, "name")
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


def _text(value: object, key: str) -> str:
    if not isinstance(value, str) or not value.isprintable():
        raise RuleError(
            f"{key}: found {shown(value)}: must be text of printable characters (R1). Rewrite it.",
            key,
        )
    return value


def _duration(value: object) -> float:
    return number(
        value, "duration", "the scene", "Give a positive duration in s.", at=("duration",)
    )


def _angle(value: object, of: str) -> float:
    return number(value, "orientation", of, "Give it in rad.", at=("orientation",))


def _restitution(value: object, of: str) -> float:
    return number(value, "restitution", of, "Give a number from 0 to 1.", at=("restitution",))


def _optional_restitution(value: object, of: str) -> float | None:
    return None if value is None else _restitution(value, of)


def _force(value: object, of: str) -> tuple[Law, Law]:
    x, y = pair(value, of, "Give (x, y) in N.", at=("force",))
    return (
        checked_law(x, "force", of, at=("force", 0)),
        checked_law(y, "force", of, at=("force", 1)),
    )


def _mass(value: object, of: str) -> float:
    remedy = "Give a positive mass, or make the body static."
    mass = number(value, "mass", of, remedy, at=("mass",))
    return _invertible(mass, "mass", "kg", of)


def _inertia(value: object, mass: float, shape: Shape | None, of: str) -> float:
    if value is not None:
        remedy = "Give a positive inertia in kg m^2, or leave it out."
        inertia = number(value, "inertia", of, remedy, at=("inertia",))
    elif shape is None or isinstance(shape, HalfPlane):
        return math.inf
    else:
        inertia = shape.inertia(mass)
    return _invertible(inertia, "inertia", "kg m^2", of)


def _invertible(value: float, key: str, unit: str, of: str) -> float:
    """Refuse a value whose inverse float64 cannot hold."""
    if not 1 / math.inf < value < math.inf or not math.isfinite(1 / value):
        raise RuleError(
            f"{key} {value:g} {unit} of {of}: float64 cannot hold its inverse (R4). "
            "Choose units in which it is nearer to 1.",
            key,
        )
    return value


def _refuse_shape(shape: object, of: str, *, static: bool) -> None:
    known = (Disc, Box, Polygon, HalfPlane)
    if isinstance(shape, HalfPlane) and not static:
        raise RuleError(
            f"shape of {of}: found a half-plane: it cannot move (R4). Add it as a static body.",
            "shape",
        )
    if not (isinstance(shape, known) or (shape is None and not static)):
        raise RuleError(
            f"shape of {of}: found {shown(shape)}: must be a shape (R4). "
            "Give a Disc, Box, Polygon or, for a static body, a HalfPlane.",
            "shape",
        )


def _refuse_turning_particle(body: Body) -> None:
    turned = body.angular_velocity != 0 or body.torque != 0.0
    if turned and body.inertia == math.inf:
        key = "torque" if body.torque != 0.0 else "angular_velocity"
        raise RuleError(
            f"inertia of body '{body.name}': found none, though its {key} is not 0 (R2, IM2). "
            "State the inertia in kg m^2, or give the body a shape.",
            "inertia",
        )
