"""YAML read as plain text with the place of every value.

Serves: fences of chapters and scene files. Hides: PyYAML. No scalar changes its type (`on`,
`012`, `1e-3` stay text), and anchors, aliases, tags and duplicate keys are refused.
"""

from collections.abc import Iterator
from typing import Any

import yaml

from tamias2d.spec.messages import Code, Diagnostic

Path = tuple[str | int, ...]
Place = tuple[int, int]
_QUICK = getattr(yaml, "CBaseLoader", yaml.BaseLoader)
"""Ten times as fast, but its messages are other ones: what it refuses is read again."""
MAX_SIZE = 1_000_000
MAX_DEPTH = 30


class MarkupError(Exception):
    """The text is at fault; `diagnostic` says where and why."""

    def __init__(self, diagnostic: Diagnostic) -> None:
        super().__init__(str(diagnostic))
        self.diagnostic = diagnostic


class _Composer:
    def __init__(self, file: str, first_line: int) -> None:
        self.file = file
        self.first_line = first_line
        self.marks: dict[Path, Place] = {}

    def place(self, mark: Any) -> Place:
        if mark is None:
            return self.first_line, 1
        return self.first_line + mark.line, 1 + mark.column

    def fault(self, code: Code, message: str, mark: Any) -> MarkupError:
        return MarkupError(Diagnostic(self.file, *self.place(mark), code.code, message))

    def node(self, text: str, loader: Any) -> Any:
        """Return the root node of a text, None for an empty one."""
        self.refuse_features(text, loader)
        return yaml.compose(text, Loader=loader)

    def refuse_features(self, text: str, loader: Any) -> None:
        """Refuse anchors, aliases, tags and depth before anything is built."""
        depth = 0
        for event in yaml.parse(text, Loader=loader):
            if isinstance(event, yaml.AliasEvent) or getattr(event, "anchor", None):
                raise self.fault(
                    Code.YAML_FEATURE,
                    "anchors and aliases are refused. Write the value out",
                    event.start_mark,
                )
            if tag := getattr(event, "tag", None):
                raise self.fault(
                    Code.YAML_FEATURE, f"tag '{tag}' is refused. Remove it", event.start_mark
                )
            depth += isinstance(event, yaml.CollectionStartEvent) - isinstance(
                event, yaml.CollectionEndEvent
            )
            if depth > MAX_DEPTH:
                raise self.fault(
                    Code.TOO_LARGE,
                    f"values may nest {MAX_DEPTH} deep. Flatten them",
                    event.start_mark,
                )

    def plain(self, node: Any, path: Path) -> Any:
        self.marks[path] = self.place(node.start_mark)
        if isinstance(node, yaml.ScalarNode):
            return self.text(node)
        if isinstance(node, yaml.SequenceNode):
            return [self.plain(item, (*path, k)) for k, item in enumerate(node.value)]
        return dict(self.items(node, path))

    def text(self, node: Any) -> str:
        """The text of a scalar; "\\ud800" would be half a character, which no file can hold."""
        value: str = node.value
        if not value.isascii() and any("\ud800" <= character <= "\udfff" for character in value):
            raise self.fault(
                Code.YAML, "half a character (surrogate). Write the whole one", node.start_mark
            )
        return value

    def items(self, node: Any, path: Path) -> Iterator[tuple[str, Any]]:
        """The keys and values of a mapping; a key that stands twice is refused."""
        seen: set[str] = set()
        for key, value in node.value:
            if not isinstance(key, yaml.ScalarNode):
                raise self.fault(
                    Code.YAML, "a key must be a word. Quote it or rewrite it", key.start_mark
                )
            if self.text(key) in seen:
                raise self.fault(
                    Code.DUPLICATE_KEY, f"'{key.value}' stands twice. Remove one", key.start_mark
                )
            seen.add(key.value)
            yield key.value, self.plain(value, (*path, key.value))
            self.marks[(*path, key.value, "key")] = self.place(key.start_mark)


def compose(
    text: str,
    *,
    file: str,
    first_line: int = 1,
    longest: float = MAX_SIZE,
) -> tuple[Any, dict[Path, Place]]:
    """Read YAML of at most `longest` characters into dicts, lists and text.

    Returns the plain tree, None for an empty text, and the place (line, column) of the value at
    each path; the place of a key stands under its path with 'key' added.

    Raises:
        MarkupError: the text is not valid YAML, or uses a feature that is refused.
    """
    composer = _Composer(file, first_line)
    if len(text) > longest:
        raise composer.fault(
            Code.TOO_LARGE, f"a file may have {longest} characters. Split it", None
        )
    try:
        try:
            node = composer.node(text, _QUICK)
        except yaml.YAMLError:
            node = composer.node(text, yaml.BaseLoader)
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        raise composer.fault(
            Code.YAML, f"{error.problem or error.context}. Correct the YAML", mark
        ) from None
    except yaml.reader.ReaderError as error:
        mark = _mark(text, error.position)
        sign = f"character U+{error.character:04X} is none of YAML"
        raise composer.fault(Code.YAML, f"{sign}. Leave it out", mark) from None
    except (yaml.YAMLError, RecursionError) as error:
        reason = str(error).splitlines()[0]
        raise composer.fault(Code.YAML, f"{reason}. Correct the YAML", None) from None
    if node is None:
        return None, composer.marks
    return composer.plain(node, ()), composer.marks


def _mark(text: str, place: int) -> yaml.Mark:
    """Return where in a text a character stands."""
    begin = text.rfind("\n", 0, place) + 1
    return yaml.Mark("", place, text.count("\n", 0, place), place - begin, None, 0)
