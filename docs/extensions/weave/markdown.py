"""Small pieces of Markdown, which the directives then hand to the parser.

Serves: tables, links and folded parts. Hides: the fences of MyST and their nesting.
"""

import re
from collections.abc import Iterable, Sequence
from textwrap import indent


def fence(name: str, argument: str, body: str, *, depth: int = 3, **options: str) -> str:
    """A directive; depth is the number of colons, more for an outer one."""
    marks = ":" * depth
    lines = "".join(f":{key.replace('_', '-')}: {value}\n" for key, value in options.items())
    return f"{marks}{{{name}}} {argument}\n{lines}\n{body}\n{marks}\n"


def code(language: str, text: str) -> str:
    """A block of code, fenced so that no line of it can end the block."""
    return f"``````{language}\n{text.rstrip()}\n``````\n"


def display(tex: str) -> str:
    """A formula on its own line."""
    return f"```{{math}}\n{tex}\n```\n"


def table(head: Sequence[str], rows: Iterable[Sequence[str]], *, style: str = "") -> str:
    """A table whose cells are Markdown; `style` adds classes."""
    lines = [_row(head), *map(_row, rows)]
    return fence(
        "list-table", "", "\n".join(lines), depth=4, header_rows="1", class_=f"srs-table {style}"
    ).replace(":class-:", ":class:")


def _row(cells: Sequence[str]) -> str:
    first, *rest = (indent(cell.strip() or " ", "    ").lstrip() for cell in cells)
    return "\n".join([f"* - {first}", *(f"  - {cell}" for cell in rest)])


def bullets(lines: Iterable[str]) -> str:
    """An unnumbered list."""
    return "\n".join(f"* {line}" for line in lines) + "\n"


def as_markdown(text: str, *, in_code: bool = False) -> str:
    """Plain text in which nothing but `code`, in which it may begin, and *emphasis* is markup."""
    pieces = re.split(r"(`+)", text)  # a text, a mark, a code, a mark, a text
    for k in range(2 if in_code else 0, len(pieces), 4):
        pieces[k] = re.sub(r"([_$<>{}\[\]|#])", r"\\\1", pieces[k])
    return "".join(pieces)
