"""What a user probably meant by an attribute that an object has not."""

from collections.abc import Callable, Mapping
from typing import Any, TypeVar

from tamias2d.suggestions import meant_by, nearest

_Class = TypeVar("_Class", bound=type)


def suggests_attributes(elsewhere: Mapping[str, str] | None = None) -> Callable[[_Class], _Class]:
    """Let objects of a class say what an unknown attribute was meant for.

    `elsewhere` tells by names what to write for what is not an attribute of theirs. The error is
    `AttributeError`, as ever. Attributes that are there take some 25 ns more each.
    """
    places = dict(elsewhere or {})

    def decorate(target: _Class) -> _Class:
        """Return the class, whose objects do so."""

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


def names_elsewhere(elsewhere: Mapping[str, str]) -> Callable[[_Class], _Class]:
    """Let objects of a class say where attributes are that they have not; others cost no more.

    `elsewhere` tells by names what to write; so do the names that other engines have for attributes
    of theirs. What is misspelt is left to Python, which suggests attributes where it tells errors.
    """

    def decorate(target: _Class) -> _Class:
        """Return the class, whose objects do so."""
        own = [name for name in dir(target) if not name.startswith("_")]
        places = {**meant_by(own), **elsewhere}
        absent = {name: hint for name, hint in places.items() if name not in own}

        def there(self: Any) -> list[str]:
            return [name for name in object.__dir__(self) if name not in absent]

        for name, hint in absent.items():
            setattr(target, name, _Absent(name, hint))
        target.__dir__ = there  # type: ignore[assignment]
        return target

    return decorate


class _Absent:
    """An attribute that objects have not, and by which they say where it is."""

    def __init__(self, name: str, hint: str) -> None:
        self._name, self._hint = name, hint

    def __get__(self, owner: object, kind: type) -> Any:
        raise AttributeError(
            f"{kind.__name__!r} object has no attribute {self._name!r}; did you mean "
            f"{self._hint!r}?",
            name=self._name,
        )
