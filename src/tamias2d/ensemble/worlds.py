"""The worlds of an ensemble, each by its number.

Serves: whoever runs them, here or elsewhere. Hides: whether they are one scene with other values,
or scenes that a function makes.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, Protocol, TypeAlias

import numpy as np

from tamias2d.ensemble.outline import Outline, outline_of, scene_of
from tamias2d.ensemble.sampling import Design, Values, checked_seed, random_stream, sampled
from tamias2d.errors import InputError
from tamias2d.scene import Body, Scene
from tamias2d.scene.rules import RuleError, checked_count, shown
from tamias2d.scene.scene_data import checked_scene

Maker: TypeAlias = Callable[[int, np.random.Generator], Scene]
"""Makes the scene of a world from its number and from random numbers of its own."""


class Worlds(Protocol):
    """Numbered worlds; `part` of them can be sent elsewhere."""

    def __len__(self) -> int:
        """How many there are."""

    def scene(self, world: int) -> Scene:
        """Return the scene of a world by its number; raise `InputError` if a value is bad."""

    def part(self, first: int, last: int) -> "Worlds":
        """Return the worlds from `first` to before `last`, under the same numbers."""


@dataclass(frozen=True)
class VariedWorlds:
    """One scene, in which some values differ from world to world."""

    base: Scene
    values: Values
    count: int
    first: int = 0
    """The number of the world that the first values are for."""

    def __len__(self) -> int:
        return self.count

    def scene(self, world: int) -> Scene:
        """Return the scene of a world by its number."""
        outline: Outline = outline_of(self.base)
        for place, values in self.values.items():
            value = values[world - self.first].tolist()
            outline = place.put(outline, tuple(value) if place.vector else value)
        try:
            return scene_of(outline, self.base)
        except InputError as fault:
            raise InputError(f"world {world} of the ensemble: {fault}") from fault

    def part(self, first: int, last: int) -> "VariedWorlds":
        """Return the worlds from `first` to before `last`."""
        rows = slice(first - self.first, last - self.first)
        values = {place: array[rows] for place, array in self.values.items()}
        return VariedWorlds(self.base, values, self.count, first)


def value_of(worlds: VariedWorlds, keys: tuple[Any, ...], base: Any) -> Any:
    """Return a number, or the numbers (w,) by which it varies; of a pair by its last key."""
    for place, values in worlds.values.items():
        if place.keys == keys:
            return values
        if place.vector and place.keys == keys[:-1]:
            return values[:, keys[-1]]
    return base


def inertia_of(worlds: VariedWorlds, body: Body) -> Any:
    """Return inertias, kg m^2, that vary, follow from a mass that does, or stay."""
    keys = ("bodies", body.name)
    stated = value_of(worlds, (*keys, "inertia"), body.inertia)
    mass = value_of(worlds, (*keys, "mass"), None)
    if mass is None or body.inertia_stated or stated is not body.inertia or body.shape is None:
        return stated
    shape: Any = body.shape
    return np.array([shape.inertia(one) for one in mass.tolist()])


@dataclass(frozen=True)
class MadeWorlds:
    """Scenes that a function makes."""

    make: Maker
    seed: int
    count: int

    def __len__(self) -> int:
        return self.count

    def scene(self, world: int) -> Scene:
        """Return the scene of a world by its number."""
        made: Any = self.make(world, random_stream(self.seed, world))
        if not isinstance(made, Scene):
            raise RuleError(
                f"world {world} of the ensemble: the function returned {shown(made)}: must be a "
                "Scene (R1). Let it return one.",
                "scene",
            )
        return made

    def part(self, first: int, last: int) -> "MadeWorlds":  # noqa: ARG002
        """Return all of them: nothing is kept for each world."""
        return self


def worlds_of(
    scene: Scene | Maker,
    vary: Mapping[str, Any] | None,
    worlds: int | None,
    seed: int | None,
    design: Design | None,
) -> VariedWorlds | MadeWorlds:
    """Return the worlds that a caller describes, all values checked.

    Raises:
        InputError: the description breaks a rule.
    """
    if callable(scene):
        if vary is not None or design is not None:
            raise RuleError(
                "vary: found beside a function that makes scenes, which says itself what varies "
                "(R2). Give a Scene, or leave `vary` and `design` out.",
                "vary",
            )
        if worlds is None:
            raise RuleError("worlds: found none: a function makes any number (R5). Give one.")
        return MadeWorlds(scene, checked_seed(seed), checked_count(worlds, "worlds", 1))
    checked_scene(scene)
    values = sampled(scene, {} if vary is None else vary, worlds, seed, design)
    count = len(next(iter(values.values())))
    return VariedWorlds(scene, values, count)


def refuse_other_bodies(scene: Scene, world: int, names: tuple[str, ...]) -> None:
    """Raise `RuleError` unless the scene of a world has the bodies of world 0, by their names."""
    found = tuple(body.name for body in scene.bodies)
    if found != names:
        raise RuleError(
            f"world {world} of the ensemble: found the bodies {', '.join(found)}: must be those of "
            f"world 0, {', '.join(names)} (R1). Make scenes of the same bodies.",
            "scene",
        )
