"""A chapter of srs/: Markdown prose with typed fences.

Serves: the reader. Hides: the Markdown parser and how fences carry YAML.
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from markdown_it import MarkdownIt

from tamias2d.spec.kinds import KINDS
from tamias2d.spec.markup import MarkupError, Place, compose
from tamias2d.spec.markup import Path as KeyPath
from tamias2d.spec.messages import Code, Diagnostic

_FENCE = re.compile(r"\{(\w[\w-]*)\}\s*(.*)")
_ROLE = re.compile(r"\{srs\}`([^`]*)`")
_PROSE_DIRECTIVES = ("note", "math")


@dataclass
class Item:
    """One fence: its kind, id, title, place and plain data, and where each value stands."""

    kind: str
    id: str
    title: str
    file: str
    line: int
    data: dict[str, Any]
    marks: dict[KeyPath, Place] = field(repr=False, compare=False)

    def at(self, *path: str | int) -> Place:
        """Line and column of the value at a path, or of the fence."""
        return self.marks.get(path, (self.line, 1)) if path else (self.line, 1)

    def diagnostic(self, code: Code, message: str, *path: str | int, offset: int = 0) -> Diagnostic:
        """A fault in this item, at the value under a path."""
        line, column = self.at(*path)
        name = f"{self.id}: " if self.id else ""
        return Diagnostic(self.file, line, column + offset, code.code, f"{name}{message}")


@dataclass(frozen=True)
class Role:
    """A link to an item in the prose."""

    id: str
    file: str
    line: int
    column: int


@dataclass
class Chapter:
    """What one file holds."""

    file: str
    title: str = ""
    items: list[Item] = field(default_factory=list)
    roles: list[Role] = field(default_factory=list)
    faults: list[Diagnostic] = field(default_factory=list)


def read_chapter(path: Path, file: str) -> Chapter:
    """Read one chapter; faults are collected in it, none is raised."""
    chapter = Chapter(file)
    try:
        text = path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        reason = f"{type(error).__name__}: must be readable UTF-8. Save the file so"
        chapter.faults.append(Diagnostic(file, 1, 1, Code.UNREADABLE.code, reason))
        return chapter
    lines = text.splitlines()
    fenced: set[int] = set()
    for token in MarkdownIt("commonmark").parse(text):
        if token.type == "heading_open" and token.tag == "h1" and token.map and not chapter.title:
            chapter.title = lines[token.map[0]].lstrip("# ").strip()
        if token.type == "fence" and token.map:
            fenced.update(range(*token.map))
            _read_fence(chapter, token, lines)
    chapter.roles = list(_roles(file, lines, fenced))
    return chapter


def _read_fence(chapter: Chapter, token: Any, lines: list[str]) -> None:
    start, end = token.map
    heading = _FENCE.fullmatch(token.info.strip())
    if heading is None or heading.group(1) in _PROSE_DIRECTIVES:
        return
    line = start + 1

    def fault(code: Code, message: str) -> None:
        chapter.faults.append(Diagnostic(chapter.file, line, 1, code.code, message))

    if not lines[end - 1].lstrip().startswith(token.markup) or end - 1 == start:
        return fault(Code.YAML, "the fence is not closed. Close it with the same backticks")
    kind = KINDS.get(heading.group(1))
    if kind is None:
        known = ", ".join(KINDS)
        return fault(
            Code.UNKNOWN_KIND,
            f"'{heading.group(1)}' is no kind of item: must be one of {known}. Correct it",
        )
    name, _, title = heading.group(2).strip().partition(" ")
    if kind.ids is None and name:
        return fault(
            Code.BAD_HEADING, f"a table of {kind.name} has neither id nor title. Remove '{name}'"
        )
    if kind.ids is not None and not (kind.takes_id(name) and title.strip()):
        return fault(
            Code.BAD_HEADING,
            f"'{name} {title}': a {kind.name} needs an id like {kind.ids} and a title. Give both",
        )
    try:
        data, marks = compose(token.content, file=chapter.file, first_line=line + 1)
    except MarkupError as error:
        chapter.faults.append(error.diagnostic)
        return None
    if not isinstance(data, dict):
        return fault(
            Code.BAD_VALUE, f"a {kind.name} needs keys with values. Write 'key: value' lines"
        )
    item = Item(kind.name, name, title.strip(), chapter.file, line, data, marks)
    chapter.items.append(item)
    return None


def _roles(file: str, lines: list[str], fenced: set[int]) -> Iterator[Role]:
    for number, line in enumerate(lines):
        if number not in fenced:
            for match in _ROLE.finditer(line):
                yield Role(match.group(1), file, number + 1, match.start(1) + 1)
