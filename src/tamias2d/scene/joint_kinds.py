"""The kinds of joints, each a small value with what it is given; `Scene.add_joint` ties bodies.

The equation of each stands in srs/models/joints.md, under the name that `model` gives. What is None
is found from how the bodies stand at the start.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar, TypeAlias

from tamias2d.scene.freedoms import (
    Freedom,
    JointSpring,
    Limits,
    Measure,
    Motor,
    freedom,
    ratchet,
    target,
)
from tamias2d.scene.rules import RuleError, Vector, VectorLike, number, sequence, shown, vector
from tamias2d.suggestions import suggests

Given: TypeAlias = dict[str, float | Vector | None]
"""The parameters of a constraint, by their symbols."""


_TWO_POINTS = "it holds two points apart from each other, not one"
_ANGLES = "it holds angles, and no point"


class _Kind:
    """What all kinds have."""

    model: ClassVar[str]
    free: ClassVar[Measure | None] = None
    """What its `limits`, `motor` and `spring` are of, if it has such fields."""
    no_place: ClassVar[str | None] = None
    """Why it does not hold both bodies at one place, if so."""

    @property
    def rigid(self) -> bool:
        """Whether its constraint is kept."""
        return True

    @property
    def given(self) -> Given:
        """What its constraint has besides the anchors."""
        return {}

    def freedoms(self, of: str) -> tuple[Freedom, ...]:
        """Return what it limits, drives or springs, checked."""
        if self.free is None:
            return ()
        said = {key: getattr(self, key) for key in ("limits", "motor", "spring")}
        return freedom(self.free, of, **said)


@suggests
@dataclass(frozen=True, kw_only=True)
class Revolute(_Kind):
    """A hinge: a point of each body is at one place, and B may turn against A."""

    limits: Limits | None = None
    motor: Motor | None = None
    spring: JointSpring | None = None
    model: ClassVar[str] = "revolute"
    free: ClassVar[Measure] = "angle"


@suggests
@dataclass(frozen=True, kw_only=True)
class Distance(_Kind):
    """A rod without mass: two points keep a `length` in m, that at the start unless given.

    With limits, a motor or a spring it is no rod: a rope is a distance with an upper limit.
    """

    length: float | None = None
    limits: Limits | None = None
    motor: Motor | None = None
    spring: JointSpring | None = None
    model: ClassVar[str] = "distance"
    no_place: ClassVar[str | None] = _TWO_POINTS
    free: ClassVar[Measure] = "distance"

    def __post_init__(self) -> None:
        _set(self, length=_length(self.length, "a distance joint"))
        if self.length is not None and not self.rigid:
            raise RuleError(
                f"length {self.length:g} m of a distance joint: what is kept has no limits, motor "
                "or spring (GD21). Leave one out.",
                "length",
            )

    @property
    def rigid(self) -> bool:
        """Whether the distance is kept."""
        return self.limits is None and self.motor is None and self.spring is None

    @property
    def given(self) -> Given:
        """The length, if it is kept."""
        return {"joint_length": self.length} if self.rigid else {}


@suggests
@dataclass(frozen=True, kw_only=True)
class Weld(_Kind):
    """Two bodies move as one; B is turned against A by `angle`, rad, or as at the start."""

    angle: float | None = None
    model: ClassVar[str] = "weld"

    def __post_init__(self) -> None:
        _set(self, angle=_angle(self.angle, "a weld"))

    @property
    def given(self) -> Given:
        """The angle."""
        return {"joint_angle": self.angle}


@suggests
@dataclass(frozen=True, kw_only=True)
class Prismatic(_Kind):
    """B slides along an `axis` of A, in A's own axes, and keeps its `angle` to A, rad."""

    axis: VectorLike
    angle: float | None = None
    limits: Limits | None = None
    motor: Motor | None = None
    spring: JointSpring | None = None
    model: ClassVar[str] = "prismatic"
    free: ClassVar[Measure] = "travel"

    def __post_init__(self) -> None:
        _set(self, axis=_axis(self.axis, "a prismatic joint"))
        _set(self, angle=_angle(self.angle, "a prismatic joint"))

    @property
    def given(self) -> Given:
        """The axis and the angle."""
        x, y = self.axis
        return {"guide_a": (float(x), float(y)), "joint_angle": self.angle}


@suggests
@dataclass(frozen=True, kw_only=True)
class Groove(_Kind):
    """A point of B stays on a line of A along an `axis` in A's own axes, and B may turn."""

    axis: VectorLike
    limits: Limits | None = None
    motor: Motor | None = None
    spring: JointSpring | None = None
    model: ClassVar[str] = "groove"
    free: ClassVar[Measure] = "travel"

    def __post_init__(self) -> None:
        _set(self, axis=_axis(self.axis, "a groove"))

    @property
    def given(self) -> Given:
        """The axis."""
        x, y = self.axis
        return {"guide_a": (float(x), float(y))}


@suggests
@dataclass(frozen=True, kw_only=True)
class Wheel(_Kind):
    """The axle B of a wheel on a line of A: a `spring`, `limits` along it, a `motor` about it."""

    axis: VectorLike
    spring: JointSpring
    limits: Limits | None = None
    motor: Motor | None = None
    model: ClassVar[str] = "groove"

    def __post_init__(self) -> None:
        _set(self, axis=_axis(self.axis, "a wheel"))

    @property
    def given(self) -> Given:
        """The axis."""
        x, y = self.axis
        return {"guide_a": (float(x), float(y))}

    def freedoms(self, of: str) -> tuple[Freedom, ...]:
        """Return the travel of the suspension, and the angle if a motor turns it."""
        along = freedom("travel", of, limits=self.limits, spring=self.spring)
        return (*along, *freedom("angle", of, motor=self.motor))


@suggests
@dataclass(frozen=True, kw_only=True)
class Target(_Kind):
    """A point of B is pulled to a point of A by a `spring` for each axis, as by a mouse.

    A point of the plane may be moved by `Simulator.set_target`.
    """

    spring: JointSpring
    model: ClassVar[str] = "travel"

    @property
    def rigid(self) -> bool:
        """No place is kept."""
        return False

    @property
    def given(self) -> Given:
        """The axis of the first spring."""
        return {"guide_a": (1.0, 0.0)}

    def freedoms(self, of: str) -> tuple[Freedom, ...]:
        """Return both travels."""
        return target(of, spring=self.spring)


@suggests
@dataclass(frozen=True, kw_only=True)
class Rotary(_Kind):
    """What keeps no place, but limits, drives or springs how far B turns against A."""

    limits: Limits | None = None
    motor: Motor | None = None
    spring: JointSpring | None = None
    model: ClassVar[str] = "angle"
    no_place: ClassVar[str | None] = _ANGLES
    free: ClassVar[Measure] = "angle"

    @property
    def rigid(self) -> bool:
        """The angle is not kept."""
        return False

    def freedoms(self, of: str) -> tuple[Freedom, ...]:
        """Return the angle."""
        found = super().freedoms(of)
        if not found:
            raise RuleError(
                f"{of}: nothing is said of the angle (GD21). Give limits, a motor or a spring.",
                "kind",
            )
        return found


@suggests
@dataclass(frozen=True, kw_only=True)
class Ratchet(_Kind):
    """B turns forwards against A, and not back behind the last tooth; they are `pitch` rad apart.

    The teeth are at multiples of the pitch. It falls back on one with `restitution`.
    """

    pitch: float
    restitution: float
    model: ClassVar[str] = "angle"
    no_place: ClassVar[str | None] = _ANGLES

    @property
    def rigid(self) -> bool:
        """The angle is not kept."""
        return False

    def freedoms(self, of: str) -> tuple[Freedom, ...]:
        """Return the angle, limited by a tooth that moves on."""
        return ratchet(of, pitch=self.pitch, restitution=self.restitution)


@suggests
@dataclass(frozen=True, kw_only=True)
class Gear(_Kind):
    """B turns `ratio` times as far as A, both seen from the third body, or from the plane."""

    ratio: float
    angle: float | None = None
    """How far B is ahead, rad; as at the start unless given."""
    model: ClassVar[str] = "gear"
    no_place: ClassVar[str | None] = _ANGLES

    def __post_init__(self) -> None:
        _set(self, ratio=_ratio(self.ratio, "a gear"), angle=_angle(self.angle, "a gear"))

    @property
    def given(self) -> Given:
        """The ratio and the angle."""
        return {"gear_ratio": self.ratio, "joint_angle": self.angle}


@suggests
@dataclass(frozen=True, kw_only=True)
class Pulley(_Kind):
    """A rope over two wheels at `posts`, m, of the third body or of the plane.

    Its part at A and `ratio` times its part at B have a `length` in m, that at the start unless
    given.
    """

    posts: Sequence[VectorLike]
    ratio: float = 1.0
    length: float | None = None
    model: ClassVar[str] = "pulley"
    no_place: ClassVar[str | None] = _TWO_POINTS

    def __post_init__(self) -> None:
        of, remedy = "a pulley", "Give two places (x, y) in m."
        posts = sequence(self.posts, of, remedy, at=("posts",))
        if len(posts) != 2:
            raise RuleError(
                f"posts of {of}: found {len(posts)}: must be two places (TM7). {remedy}", "posts"
            )
        places = tuple(vector(p, "post", of, remedy, at=("posts", k)) for k, p in enumerate(posts))
        _set(self, posts=places, ratio=_ratio(self.ratio, of), length=_length(self.length, of))

    @property
    def given(self) -> Given:
        """Both posts, the ratio and the length."""
        (ax, ay), (bx, by) = self.posts
        posts: Given = {"post_a": (float(ax), float(ay)), "post_b": (float(bx), float(by))}
        return {**posts, "gear_ratio": self.ratio, "joint_length": self.length}


@suggests
@dataclass(frozen=True)
class Equation(_Kind):
    """A joint of your own: what stays zero, as one expression or several.

    They may use `position_a`, `orientation_a`, the place of the anchor `point_a`, likewise for B
    and for the third body C, and `time`: ``"norm(point_b - point_a) - 2[m]"``.
    """

    equations: str | Sequence[str]
    model: ClassVar[str] = "equation"
    no_place: ClassVar[str | None] = "its equations say themselves what they hold"

    def __post_init__(self) -> None:
        of, remedy = "a joint", "Give text like 'norm(point_b - point_a) - 2[m]'."
        texts = (
            (self.equations,)
            if isinstance(self.equations, str)
            else sequence(self.equations, of, remedy, at=("equations",))
        )
        for k, text in enumerate(texts):
            if not isinstance(text, str) or not text.strip():
                raise RuleError(
                    f"equations[{k}] of {of}: found {shown(text)}: must be text (TM7). {remedy}",
                    *("equations", k),
                )
        if not texts:
            raise RuleError(f"equations of {of}: found none (TM7). {remedy}", "equations")
        _set(self, equations=tuple(" ".join(str(text).split()) for text in texts))


JointKind: TypeAlias = (
    Revolute
    | Distance
    | Weld
    | Prismatic
    | Groove
    | Wheel
    | Target
    | Rotary
    | Ratchet
    | Gear
    | Pulley
    | Equation
)


def _length(value: object, of: str) -> float | None:
    remedy = "Give a positive length in m, or leave it out for that at the start."
    return None if value is None else number(value, "joint_length", of, remedy, at=("length",))


def _angle(value: object, of: str) -> float | None:
    remedy = "Give it in rad, or leave it out for that at the start."
    return None if value is None else number(value, "joint_angle", of, remedy, at=("angle",))


def _ratio(value: object, of: str) -> float:
    remedy = "Give how far B moves for what A moves, negative for wheels that roll on each other."
    ratio = number(value, "gear_ratio", of, remedy, at=("ratio",))
    if ratio == 0:
        raise RuleError(f"ratio 0 of {of}: must not be 0 (TM7). {remedy}", "ratio")
    return ratio


def _axis(value: object, of: str) -> Vector:
    remedy = "Give its direction (x, y), of any length but 0."
    x, y = vector(value, "guide", of, remedy, at=("axis",))
    length = math.hypot(x, y)
    if not 0 < length < math.inf:
        raise RuleError(f"axis ({x:g}, {y:g}) of {of}: has no direction (TM7). {remedy}", "axis")
    if abs(length - 1) < 4e-16:  # of length one already: it is kept to the last bit
        return x, y
    return x / length, y / length


def _set(kind: object, **values: object) -> None:
    for name, value in values.items():
        object.__setattr__(kind, name, value)
