"""What a user probably meant by a name that does not exist."""

import difflib
import functools
import inspect
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, TypeVar

from tamias2d.errors import ArgumentError

_Target = TypeVar("_Target", bound=Callable[..., Any])

_SYNONYMS = {
    "angle": "orientation",
    "ball": "disc",
    "bounciness": "restitution",
    "circle": "disc",
    "dopri5": "dormandprince5",
    "dt": "timestep",
    "edge": "segment",
    "elasticity": "restitution",
    "euler": "expliciteuler",
    "ground": "halfplane",
    "leapfrog": "velocityverlet",
    "line": "segment",
    "moment": "inertia",
    "omega": "angularvelocity",
    "plane": "halfplane",
    "points": "vertices",
    "pos": "position",
    "rect": "box",
    "rectangle": "box",
    "rk4": "rungekutta4",
    "rk45": "dormandprince5",
    "rotation": "orientation",
    "space": "scene",
    "spin": "angularvelocity",
    "square": "box",
    "symplecticeuler": "semiimpliciteuler",
    "vel": "velocity",
    "verlet": "velocityverlet",
    "world": "scene",
}
"""What other engines and textbooks call things, and what they are called here, both `_plain`."""
_MISTYPED = 0.9
"""How much alike words are of which one is the other with a letter too many or too few."""
_MADE_BY = {
    "Body": "Scene.add_body(shape, mass=..., position=...)",
    "ForceField": "Scene.add_field(force=...)",
    "Spring": "Scene.add_spring(first, second, stiffness=..., rest_length=...)",
}


def nearest(word: str, known: Iterable[str]) -> str | None:
    """Return the known name that a word most probably means, or None if none is near."""
    names = list(known)
    if close := difflib.get_close_matches(word, names, n=1, cutoff=_MISTYPED):
        return close[0]
    plain = {_plain(name): name for name in names}
    synonym = _SYNONYMS.get(_plain(word))
    if synonym in plain:
        return plain[synonym]
    if close := difflib.get_close_matches(word, names, n=1):
        return close[0]
    close = difflib.get_close_matches(_plain(word), plain, n=1)
    return plain[close[0]] if close else None


def meant_by(names: Iterable[str]) -> dict[str, str]:
    """Return what other engines and textbooks call names that are known here, with these."""
    plain = {_plain(name): name for name in names}
    return {word: plain[here] for word, here in _SYNONYMS.items() if here in plain}


def _plain(name: str) -> str:
    return name.lower().replace("_", "").replace("-", "")


def suggests(target: _Target) -> _Target:
    """Let a function, or a class with its public methods, say what a wrong argument was meant for.

    A call that Python refuses for its arguments raises `ArgumentError`; any other costs a tenth of
    a microsecond more. Methods without arguments stay as they are.
    """
    if not isinstance(target, type):
        return _told(target, target.__name__)  # type: ignore[return-value]
    for name, method in list(vars(target).items()):
        if name == "__init__":
            target.__init__ = _told(method, target.__name__, own=1)  # type: ignore[misc]
        elif inspect.isfunction(method) and not name.startswith("_") and _arguments(method) > 0:
            setattr(target, name, _told(method, name, own=1))
    return target


def _arguments(method: Callable[..., Any]) -> int:
    code = inspect.unwrap(method).__code__
    count: int = code.co_argcount + code.co_kwonlyargcount - 1
    return count


def _told(function: Callable[..., Any], name: str, *, own: int = 0) -> Callable[..., Any]:
    """Wrap a function whose first `own` arguments a caller does not write."""

    @functools.wraps(function)
    def call(*args: Any, **kwargs: Any) -> Any:
        try:
            return function(*args, **kwargs)
        except TypeError:
            signature = inspect.signature(function)
            try:
                signature.bind(*args, **kwargs)
            except TypeError as refusal:
                parameters = list(signature.parameters.values())[own:]
                fault = _fault(name, parameters, args[own:], kwargs)
                raise ArgumentError(fault or f"{name}(): {refusal}.") from None
            raise  # from inside the function, which takes these arguments

    return call


def _fault(
    name: str,
    parameters: Sequence[inspect.Parameter],
    args: tuple[object, ...],
    kwargs: Mapping[str, object],
) -> str | None:
    """Return what is wrong with the arguments of a call, or None if Python says it as well."""
    if name in _MADE_BY:
        return f"{name}(): a scene makes it; write {_MADE_BY[name]}."
    names = [parameter.name for parameter in parameters]
    takes = f"it takes {', '.join(names) or 'none'}."
    for key in kwargs:
        if key not in names:
            near = nearest(key, names)
            return f"{name}(): unknown argument {key!r}; " + (
                f"did you mean {near!r}?" if near else takes
            )
    placed = [p.name for p in parameters if p.kind is p.POSITIONAL_OR_KEYWORD]
    if set(placed[: len(args)]) & kwargs.keys():
        return None
    free = [key for key in names[len(placed) :] if key not in kwargs]
    if len(args) > len(placed) + len(free):
        return f"{name}(): found {len(args)} arguments without a name; {takes}"
    bare = [_short(value) for value in args]
    if len(args) > len(placed):
        more = ["..."] * bool(kwargs)
        named = [f"{key}={value}" for key, value in zip(free, bare[len(placed) :], strict=False)]
        found, meant = ", ".join([*bare, *more]), ", ".join([*bare[: len(placed)], *named, *more])
        return f"{name}({found}): arguments have names; write {name}({meant})."
    given = {*placed[: len(args)], *kwargs}
    missing = [p.name for p in parameters if p.default is p.empty and p.name not in given]
    if missing:
        call = ", ".join(f"{key}=..." for key in missing)
        return f"{name}(): argument {missing[0]!r} is missing; add {call}"
    return None


def _short(value: object) -> str:
    text = " ".join(repr(value).split())
    return text if len(text) <= 40 and "<" not in text else "..."
