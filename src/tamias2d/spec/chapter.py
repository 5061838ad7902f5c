"""A chapter of srs/: Markdown prose with typed fences.

Serves: the reader. Hides: the Markdown parser and how fences carry YAML.
"""

import keyword
import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from markdown_it import MarkdownIt

from tamias2d.spec.fences import HEADING, lost, unclosed
from tamias2d.spec.kinds import KINDS
from tamias2d.spec.markup import MarkupError, Path as KeyPath, Place, compose
from tamias2d.spec.messages import Code, Diagnostic

_FILE = re.compile(r"[a-z0-9_]+\.md")  # a module of code is named after it
_ROLE = re.compile(r"\{srs\}`([^`]*)`")
_PROSE_DIRECTIVES = ("note", "math")
_TITLE = "a chapter begins with its title. Write '# ' and the title before all else"


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
    lines: list[str] = field(repr=False, compare=False)

    def at(self, *path: str | int) -> Place:
        """Line and column of the value at a path, or of the fence."""
        return self.marks.get(path, (self.line, 1)) if path else (self.line, 1)

    def diagnostic(
        self, code: Code, message: str, *path: str | int, offset: int | None = None
    ) -> Diagnostic:
        """A fault in this item, at the value under a path, or inside it at an offset."""
        place = self.at(*path)
        if offset is not None:
            place = _inside(self.lines, place, offset)
        name = f"{self.id}: " if self.id else ""
        return Diagnostic(self.file, *place, code.code, f"{name}{message}")


def _inside(lines: list[str], place: Place, offset: int) -> Place:
    """Where a character of a scalar stands that may be quoted, or folded over several lines."""
    line, column = place
    rest = lines[line - 1][column - 1 :].rstrip()
    if rest[:1] in ("'", '"'):
        column, rest = column + 1, rest[1:]
    elif rest[:1] in (">", "|"):
        rest, offset = "", offset + 1
    while offset > len(rest) and line < len(lines):
        offset -= len(rest) + 1
        line += 1
        rest = lines[line - 1].strip()
        column = lines[line - 1].find(rest) + 1
    return line, column + offset


@dataclass(frozen=True)
class Role:
    """A link to an item in the prose, or in the words of an item."""

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
        text = _text(path, file)
    except MarkupError as error:
        chapter.faults.append(error.diagnostic)
        return chapter
    if not _FILE.fullmatch(path.name):
        reason = f"'{path.name}' is no name of a chapter: must be like 'friction.md'. Rename it"
        chapter.faults.append(Diagnostic(file, 1, 1, Code.BAD_NAME.code, reason))
    lines = text.splitlines()
    code: set[int] = set()
    tokens = MarkdownIt("commonmark").parse(f"{text}\n")  # a last line without end is one, too
    for token in tokens:
        if token.type == "heading_open" and token.tag == "h1" and token.map and not chapter.title:
            chapter.title = lines[token.map[0]].lstrip("# ").strip()
        if token.type == "fence" and token.map:
            if not HEADING.fullmatch(token.info.strip()):
                code.update(range(*token.map))
            _read_fence(chapter, token, lines)
    if not chapter.title:
        reason = f"found {'no title' if text.strip() else 'nothing'}: {_TITLE}"
        chapter.faults.append(Diagnostic(file, 1, 1, Code.BAD_HEADING.code, reason))
    chapter.faults += lost(file, lines, tokens)
    chapter.roles = list(_roles(file, lines, code))
    return chapter


def _text(path: Path, file: str) -> str:
    """The text of a file, without the mark of byte order that some editors put before it."""
    place = (1, 1)
    try:
        return path.read_bytes().decode().removeprefix("\ufeff")
    except IsADirectoryError:
        reason = "a directory: a chapter is a file. Rename it, without '.md'"
    except OSError as error:
        reason = f"{error.strerror}: must be a file that can be read. Correct it"
    except UnicodeDecodeError as error:
        before = error.object[: error.start].decode()
        place = before.count("\n") + 1, len(before) - before.rfind("\n")
        found = f"0x{error.object[error.start]:02x}"
        reason = f"found byte {found}: must be UTF-8. Save the file in UTF-8"
    raise MarkupError(Diagnostic(file, *place, Code.UNREADABLE.code, reason))


def _read_fence(chapter: Chapter, token: Any, lines: list[str]) -> None:
    start = token.map[0]
    if reason := unclosed(token, lines):
        chapter.faults.append(Diagnostic(chapter.file, start + 1, 1, Code.YAML.code, reason))
        return
    heading = HEADING.fullmatch(token.info.strip())
    if heading is None or heading.group(1) in _PROSE_DIRECTIVES:
        return
    name, _, title = heading.group(2).strip().partition(" ")
    fault = _heading_fault(heading.group(1), name, title.strip())
    if fault:
        chapter.faults.append(Diagnostic(chapter.file, start + 1, 1, fault[0].code, fault[1]))
        return
    try:
        data, marks = compose(token.content, file=chapter.file, first_line=start + 2)
    except MarkupError as error:
        chapter.faults.append(error.diagnostic)
        return
    kind = heading.group(1)
    item = Item(kind, name, title.strip(), chapter.file, start + 1, data, marks, lines)
    if isinstance(data, dict):
        chapter.items.append(item)
    else:
        text = f"a {item.kind} needs keys with values. Write 'key: value' lines"
        chapter.faults.append(item.diagnostic(Code.BAD_VALUE, text))


def _heading_fault(kind: str, name: str, title: str) -> tuple[Code, str] | None:
    """What is wrong with the first line of a fence, if anything."""
    if keyword.iskeyword(name):
        return Code.BAD_HEADING, f"'{name}' is a word of Python. Give another id"
    if kind not in KINDS:
        known = ", ".join(KINDS)
        return Code.UNKNOWN_KIND, f"'{kind}' is no kind of item: must be one of {known}. Correct it"
    ids = KINDS[kind].ids
    if ids is None and name:
        text = f"a table of {kind} has neither id nor title. Remove '{name}'"
        return Code.BAD_HEADING, text
    if ids is not None and not (KINDS[kind].takes_id(name) and title):
        text = f"'{name} {title}': a {kind} needs an id like {ids} and a title. Give both"
        return Code.BAD_HEADING, text
    return None


def _roles(file: str, lines: list[str], code: set[int]) -> Iterator[Role]:
    for number, line in enumerate(lines):
        if number not in code:
            for match in _ROLE.finditer(line):
                yield Role(match.group(1), file, number + 1, match.start(1) + 1)
