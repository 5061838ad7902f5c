"""What a user probably meant by an attribute that an object has not."""

from collections.abc import Callable, Mapping
from typing import Any, TypeVar

from tamias2d.suggestions import nearest

_Class = TypeVar("_Class", bound=type)


def suggests_attributes(elsewhere: Mapping[str, str] | None = None) -> Callable[[_Class], _Class]:
    """Let objects of a class say what an unknown attribute was meant for.

    `elsewhere` tells by names what to write for what is not an attribute of theirs. The error is
    `AttributeError`, as ever; attributes that are there cost nothing.
    """
    places = dict(elsewhere or {})

    def decorate(target: _Class) -> _Class:
        def refuse(self: Any, name: str) -> Any:
            if name.startswith("_") or hasattr(type(self), name):  # a property may raise the error
                return object.__getattribute__(self, name)
            own = [each for each in dir(self) if not each.startswith("_")]
            known = {**places, **dict(zip(own, own, strict=True))}
            meant = nearest(name, known)
            hint = f"; did you mean {known[meant]!r}?" if meant else ""
            found = f"{type(self).__name__!r} object has no attribute {name!r}"
            raise AttributeError(found + hint, name=name)

        target.__getattr__ = refuse  # type: ignore[attr-defined] # unseen by type checkers
        return target

    return decorate
