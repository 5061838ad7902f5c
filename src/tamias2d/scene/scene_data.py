"""The data of a scene: bodies, what acts on them, and how they part when they meet (R1 to R3).

`Scene` adds to it.
"""

from collections.abc import Iterator
from numbers import Integral
from typing import TypeAlias

from tamias2d.errors import SceneError
from tamias2d.generated import definitions
from tamias2d.scene.bodies import Body
from tamias2d.scene.fields import ForceField
from tamias2d.scene.filters import may_touch
from tamias2d.scene.joints import Joint, kept_apart
from tamias2d.scene.rules import RuleError, Vector, shown
from tamias2d.scene.springs import Spring
from tamias2d.scene.surfaces import SurfaceKey, surface_value
from tamias2d.suggestions import suggests

PairOfParts: TypeAlias = tuple[int | None, int | None]
"""Numbers of parts of two bodies, in the order of their compounds; None for the body as one."""


@suggests
class SceneData:
    """The bodies of a scene, and all that is stated of them, in SI units throughout."""

    def __init__(self, gravity: Vector, name: str, says: str, duration: float | None) -> None:
        """Start with no bodies; the values have been checked."""
        self._gravity = gravity
        self._name = name
        self._says = says
        self._duration = duration
        self._bodies: list[Body] = []
        self._shown: tuple[Body, ...] = ()  # the same, as they were last asked for
        self._index: dict[str, int] = {}
        self._of_pairs: dict[tuple[int, int], float] = {}
        self._friction_of_pairs: dict[tuple[int, int], float] = {}
        self._springs: list[Spring] = []
        self._attraction: float | None = None
        self._fields: list[ForceField] = []
        self._joints: list[Joint] = []
        self._joint_names: set[str] = set()

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

    @property
    def joints(self) -> tuple[Joint, ...]:
        """All joints, in the order of adding."""
        return tuple(self._joints)

    @property
    def kept_apart(self) -> frozenset[tuple[int, int]]:
        """The pairs of bodies, the lower index first, that do not touch because a joint says so."""
        return kept_apart(self._joints)

    def restitution(self, i: int, j: int, *, parts: PairOfParts = (None, None)) -> float:
        """Return the restitution with which bodies i and j part.

        It is what was set for the pair, else what their own make of it (`pair_restitution`), else
        the one that only one of them states. Of compounds name the `parts` that touch, by their
        numbers: for None what the body states is taken, not what any part of it does.

        Raises:
            SceneError: nothing states it (R3).
            InputError: there is no such part.
        """
        if (set_for_pair := self._of_pairs.get((min(i, j), max(i, j)))) is not None:
            return set_for_pair
        stated = [x for x in self._stated((i, j), parts, "restitution") if x is not None]
        if not stated:
            raise SceneError(
                f"{self.place_of(i, j)}restitution of the pair {self._pair(i, j)}: not stated, and "
                "they can meet (R3). "
                "Give one of them a restitution, or set it for the pair."
            )
        return float(definitions.pair_restitution(stated[0], stated[-1]))

    def friction(self, i: int, j: int, *, parts: PairOfParts = (None, None)) -> float:
        """Return the coefficient of friction between bodies i and j.

        It is what was set for the pair, else what their own make of it (`pair_friction`), else the
        one that only one of them states, and 0 where nothing does. `parts` are as in `restitution`.

        Raises:
            InputError: there is no such part.
        """
        if (set_for_pair := self._friction_of_pairs.get((min(i, j), max(i, j)))) is not None:
            return set_for_pair
        first, second = self._stated((i, j), parts, "friction")
        if first is None or second is None:
            return first or second or 0.0
        return float(definitions.pair_friction(first, second))

    def collides(self, i: int, j: int) -> bool:
        """Return whether bodies i and j may touch, by their groups, categories, masks and joints.

        Two of the same group, if that is not 0, do where it is positive and do not where it is
        negative. Any others do if each one's category shares a bit with the other's mask. Those
        that a joint holds do not, unless it says that they `collide`.
        """
        if not may_touch(self._bodies[i], self._bodies[j]):
            return False
        return (min(i, j), max(i, j)) not in self.kept_apart

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

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, SceneData):
            return False
        return self.bodies == other.bodies and vars(self) == vars(other)  # asking sets `_shown`

    __hash__ = None  # type: ignore[assignment]  # bodies can still be added

    def __len__(self) -> int:
        return len(self._bodies)

    def __iter__(self) -> Iterator[Body]:
        return iter(self.bodies)

    def __repr__(self) -> str:
        return f"<Scene {self.name!r} of {len(self)} bodies>"

    def place_of(self, *bodies: int) -> str:
        """Return where a file has the first of some bodies that it has, as messages begin."""
        places = (self._bodies[k].where for k in bodies)
        return next((f"{where}: " for where in places if where), "")

    def _stated(
        self, pair: tuple[int, int], parts: PairOfParts, key: SurfaceKey
    ) -> list[float | None]:
        """Return what two bodies state, or the parts of them that are named."""
        if not isinstance(parts, tuple | list) or len(parts) != len(pair):
            what = f"parts: found {shown(parts)}: must be two, of which each may be None (R3). "
            raise RuleError(
                f"{what}Give the number of the part of each body, as in (0, None).", "parts"
            )
        given = zip(pair, parts, strict=True)
        return [surface_value(self._bodies[k], part, key) for k, part in given]

    def _pair(self, i: int, j: int) -> str:
        return f"'{self._bodies[i].name}' and '{self._bodies[j].name}'"


def checked_scene(value: object) -> SceneData:
    """Return what is a scene, or raise `RuleError`."""
    if not isinstance(value, SceneData):
        raise RuleError(
            f"scene: found {shown(value)}: must be a Scene (R1). Make one, or load one.", "scene"
        )
    return value
