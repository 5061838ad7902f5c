"""The names of a simulator's bodies: of those of its scene, and of added ones that were given some.

A name belongs to one body, and is free again once that is removed (R1).
"""

from collections.abc import Iterable, Mapping

import numpy as np

from tamias2d.scene.checks import checked_name
from tamias2d.scene.rules import RuleError, sequence

_REMEDY = "Give one text for one body, a list with one for each of many, or none."


class BodyNames:
    """Which body has which name, by its row."""

    def __init__(self, rows: Mapping[str, int]) -> None:
        self.rows = dict(rows)
        """of each name"""
        self.of_row = {row: name for name, row in rows.items()}
        """the name of each body that has one"""

    def copied(self) -> "BodyNames":
        """Return names that do not change with these."""
        return BodyNames(self.rows)

    def described(self, row: int) -> str:
        """Return what a message calls a body."""
        name = self.of_row.get(row)
        return f"body {row}" if name is None else f"body '{name}'"

    def give(self, rows: Iterable[int], names: Iterable[str]) -> None:
        """Give bodies names, which are free."""
        for row, name in zip(rows, names, strict=True):
            self.rows[name], self.of_row[row] = row, name

    def forget(self, rows: Iterable[int]) -> None:
        """Take their names from bodies that have some."""
        for row in rows:
            if (name := self.of_row.pop(row, None)) is not None:
                del self.rows[name]

    def checked(self, names: object, count: int) -> list[str]:
        """Return free names for so many bodies, none if none are given, or raise `RuleError`."""
        if names is None:
            return []
        listed = (names,) if isinstance(names, str) else names
        listed = listed.tolist() if isinstance(listed, np.ndarray) else listed
        given = sequence(listed, "the bodies added", _REMEDY, at=("name",))
        if len(given) != count:
            raise RuleError(
                f"name of the bodies added: found {len(given)} for {count} "
                f"{'body' if count == 1 else 'bodies'} (R1). {_REMEDY}",
                "name",
            )
        taken = set(self.rows)
        found = []
        for name in given:
            found.append(checked_name(name, taken))
            taken.add(found[-1])
        return found
