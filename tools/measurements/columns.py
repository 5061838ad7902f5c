"""Columns of a table: each head beside what stands below it."""

from collections.abc import Callable, Iterable, Mapping
from typing import Any, TypeAlias

Row: TypeAlias = Mapping[str, Any]
Columns: TypeAlias = Mapping[str, str | Callable[[Row], str]]
"""By heads: a format of what a row holds, such as "{seconds:.1f}", or a function of the row."""
Table: TypeAlias = tuple[tuple[str, ...], list[tuple[str, ...]]]
"""Heads and rows."""


def table_of(columns: Columns, rows: Iterable[Row]) -> Table:
    """Return heads and rows for people."""
    cells = columns.values()
    return tuple(columns), [
        tuple(cell.format_map(row) if isinstance(cell, str) else cell(row) for cell in cells)
        for row in rows
    ]
