"""The forms of the parts of a scene file: mappings with known keys, lists, pairs of names."""

from collections.abc import Iterable, Iterator
from contextlib import contextmanager

from tamias2d.scene.rules import RuleError, shown
from tamias2d.suggestions import nearest

SECTIONS = ("bodies", "kinematics", "statics")
"""Where the bodies of a scene file stand, in the order in which they are added."""


@contextmanager
def within(*path: str | int) -> Iterator[None]:
    """Put a path before that of a rule broken inside."""
    try:
        yield
    except RuleError as error:
        error.path = (*path, *error.path)
        raise


def two_names(raw: object, what: str) -> tuple[str, str]:
    """Return the two names of a list, or raise `RuleError`."""
    match raw:
        case [str(first), str(second)]:
            return first, second
    raise RuleError(
        f"bodies of {what}: found {shown(raw)}: must be two names (R1). Write [one, other].",
        "bodies",
    )


def listed(raw: object, key: str) -> list[object]:
    """Return a list, or raise `RuleError`."""
    if not isinstance(raw, list):
        raise RuleError(
            f"{key}: found {shown(raw)}: must be a list (R2). Write it in brackets [ ].", key
        )
    return raw


def mapping(
    raw: object, what: str, *, must: tuple[str, ...] = (), may: tuple[str, ...] | None = None
) -> dict[str, object]:
    """Return a mapping that has all keys it must have, and no others than it may have."""
    known = (*must, *(may or ()))
    if not isinstance(raw, dict):
        found = "nothing" if raw in (None, "") else shown(raw)
        first = known[0] if known else "key"
        raise RuleError(
            f"{what}: found {found}: must be a mapping (R2). Write '{first}: value' lines."
        )
    for key in raw if may is not None else ():
        if key not in known:
            raise RuleError(
                f"key '{key}' of {what}: unknown{likely(key, known)} (R2). "
                f"Take one of {', '.join(known)}.",
                *(key, "key"),
            )
    for key in must:
        if key not in raw:
            raise RuleError(f"{what}: key '{key}' is missing (R2). State it.", key)
    return raw


def likely(word: str, known: Iterable[str]) -> str:
    """Return the part of a message that suggests the known word nearest to one, if one is near."""
    near = nearest(word, known)
    return f", did you mean '{near}'?" if near else ""
