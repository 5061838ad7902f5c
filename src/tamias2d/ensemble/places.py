"""Places in a scene by their paths, such as `bodies.ball.restitution` or `gravity.y`.

Serves: whoever varies a scene. Hides: how a path is read, what it can mean, and how a value is put
there.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from tamias2d.ensemble.joint_values import numbers_in
from tamias2d.ensemble.outline import Outline
from tamias2d.generated.symbols import SYMBOLS
from tamias2d.scene.forms import SECTIONS
from tamias2d.scene.rules import RuleError
from tamias2d.spec.symbols import Symbol
from tamias2d.suggestions import nearest

_SYMBOLS = {"anchor": "arm", "other_anchor": "arm", "point": "position"}
_NOT_NUMBERS = ("category", "mask", "group", "sensor", "first", "second", "parts")
_PAIRS = ("restitution_of_pairs", "friction_of_pairs")
_AXES = ("x", "y")


@dataclass(frozen=True)
class Place:
    """A number or a vector of a scene that can be varied."""

    path: str
    """As users write it."""
    keys: tuple[Any, ...]
    """Which lead to it in an outline."""
    symbol: Symbol

    @property
    def vector(self) -> bool:
        """Whether its value is a pair."""
        return self.symbol.shape == "vector" and self.keys[-1] not in (0, 1)

    def put(self, outline: Outline, value: Any) -> Outline:
        """Return an outline with another value here; all else is shared."""
        changed: Outline = _put(outline, self.keys, value)
        return changed


def place_at(path: str, outline: Outline) -> Place:
    """Return the place that a path names.

    Raises:
        RuleError: there is none in the scene; the message suggests one that is near.
    """
    if not isinstance(path, str):
        raise _unknown(path, outline)
    for keys, symbol in _places(path, outline):
        return Place(path, keys, symbol)
    raise _unknown(path, outline)


def _places(path: str, outline: Outline) -> Iterator[tuple[tuple[Any, ...], Symbol]]:
    """Yield the keys and the symbol of what a path names, at most one."""
    section, _, rest = path.partition(".")
    if section == "gravity":
        yield from _ended(("gravity",), "gravity", rest)
    elif section in SECTIONS:
        for name, values in _of_section(section, outline).items():
            if rest.startswith(f"{name}."):
                yield from _among(("bodies", name), values, rest[len(name) + 1 :])
    elif section in _PAIRS:
        key = section.removesuffix("_of_pairs")
        for pair in _pairs(outline):
            if rest == ".".join(pair):
                known = outline[section]
                yield (section, pair[::-1] if pair[::-1] in known else pair), SYMBOLS[key]
                return
    elif section == "springs":
        number, _, rest = rest.partition(".")
        for k, values in enumerate(outline["springs"]):
            if number == str(k):
                yield from _among(("springs", k), values, rest)
    elif section == "joints":
        yield from (found[1:] for found in _of_joints(outline) if found[0] == path)
    elif section == "attraction":
        yield from _among(("attraction",), outline["attraction"], rest)


def _of_section(section: str, outline: Outline) -> dict[str, Any]:
    """Return the bodies that a section of a scene file has, by name; "bodies" may mean any."""
    if section == "bodies":
        return dict(outline["bodies"])
    moves = section == "kinematics"
    return {
        name: values
        for name, values in outline["bodies"].items()
        if "mass" not in values and ("velocity" in values) == moves
    }


def _among(
    owner: tuple[Any, ...], values: Mapping[str, Any], rest: str
) -> Iterator[tuple[tuple[Any, ...], Symbol]]:
    key, _, component = rest.partition(".")
    if key == "parts" and key in values:
        number, _, rest = component.partition(".")
        for k, own in enumerate(values[key]):
            if number == str(k):
                yield from _among((*owner, key, k), own, rest)
    elif key in values and key not in _NOT_NUMBERS:
        yield from _ended((*owner, key), _SYMBOLS.get(key, key), component)


def _ended(
    keys: tuple[Any, ...], symbol: str, component: str
) -> Iterator[tuple[tuple[Any, ...], Symbol]]:
    if not component:
        yield keys, SYMBOLS[symbol]
    elif SYMBOLS[symbol].shape == "vector" and component in _AXES:
        yield (*keys, _AXES.index(component)), SYMBOLS[symbol]


def _of_joints(outline: Outline) -> Iterator[tuple[str, tuple[Any, ...], Symbol]]:
    """Yield the path, the keys and the symbol of each number of a joint."""
    for name, values in outline["joints"].items():
        for keys, symbol in numbers_in(values):
            yield ".".join(("joints", name, *keys)), ("joints", name, *keys), SYMBOLS[symbol]


def _pairs(outline: Outline) -> Iterator[tuple[str, str]]:
    names = list(outline["bodies"])
    return ((a, b) for a in names for b in names if a != b)


def _unknown(path: object, outline: Outline) -> RuleError:
    near = _near(str(path), outline)
    placed = [name for name, values in outline["bodies"].items() if "position" in values]
    known = ", ".join(["gravity", *(f"bodies.{name}.position" for name in placed)][:4])
    hint = f"Did you mean {near!r}?" if near else f"There are, for example, {known}."
    return RuleError(f"vary {path!r}: the scene has no such place (R2). {hint}", "vary")


def _near(path: str, outline: Outline) -> str | None:
    """Return the path that was probably meant: word by word, as far as there are words alike."""
    section, _, rest = path.partition(".")
    section = nearest(section, (*outline, *SECTIONS)) or ""
    if section == "gravity":
        return f"gravity.{nearest(rest, _AXES) or 'y'}"
    if section in _PAIRS:
        return nearest(f"{section}.{rest}", (f"{section}.{a}.{b}" for a, b in _pairs(outline)))
    if section == "joints":
        return nearest(f"{section}.{rest}", (found[0] for found in _of_joints(outline)))
    if section == "attraction":
        return _near_key(section, outline[section], rest)
    owners = (
        _of_section(section, outline) if section in SECTIONS else _numbered(outline.get(section))
    )
    name, _, rest = rest.partition(".")
    if not (owner := nearest(name, owners)):
        return None
    return _near_key(f"{section}.{owner}", owners[owner], rest)


def _near_key(owner: str, values: Mapping[str, Any], rest: str) -> str | None:
    key, _, component = rest.partition(".")
    if key == "parts" and key in values:
        number, _, rest = component.partition(".")
        parts = _numbered(values[key])
        return _near_key(f"{owner}.parts.{number}", parts.get(number, {}), rest)
    near = nearest(key, [known for known in values if known not in _NOT_NUMBERS])
    if near and component and SYMBOLS[_SYMBOLS.get(near, near)].shape == "vector":
        return f"{owner}.{near}.{nearest(component, _AXES) or 'x'}"
    return f"{owner}.{near}" if near else None


def _numbered(owners: Sequence[Any] | None) -> dict[str, Any]:
    """Return springs, or parts of a compound, by number."""
    return {str(k): values for k, values in enumerate(owners or ())}


def _put(node: Any, keys: tuple[Any, ...], value: Any) -> Any:
    """Return a dictionary, list or pair with another value at the end of some keys."""
    first, *others = keys
    inner = _put(node[first], tuple(others), value) if others else value
    if isinstance(node, dict):
        return {**node, first: inner}
    changed = list(node)
    changed[first] = inner
    return type(node)(changed)
