"""Mistakes in the fences of a chapter: those that are not closed, and lines that open none.

Serves: the chapters. Hides: how a mistyped fence is told from prose and code. Without this check
an item whose fence Markdown does not see would be left out in silence.
"""

import re
from collections.abc import Iterable, Iterator
from typing import Any

from tamias2d.spec.kinds import KINDS
from tamias2d.spec.messages import Code, Diagnostic

HEADING = re.compile(r"\{(\w[\w-]*)\}\s*(.*)")
"""What follows the backticks of an item: its kind, and the id and title."""
_OPENING = re.compile(r"[^`~\w]*(?P<mark>[`~]{2,})\s*(?P<brace>\{?)\s*(?P<kind>\w+)(?P<rest>[^`]*)")


def unclosed(token: Any, lines: list[str]) -> str | None:
    """What is wrong with a fence that nothing closes, or only the end of a later one."""
    start, end = token.map
    remedy = f"Close it with '{token.markup}'"
    for number, line in enumerate(lines[start + 1 : end], start + 2):
        if token.markup in line and _meant(line):
            return f"the fence is not closed before line {number}, which opens one. {remedy}"
    if token.content.count("\n") > end - start - 2:
        return f"the fence is not closed. {remedy}"
    return None


def lost(file: str, lines: list[str], tokens: Iterable[Any]) -> Iterator[Diagnostic]:
    """A fault for each line that was meant to open an item, and does not."""
    taken = {number for token in tokens if token.map for number in _taken(token)}
    for number, line in enumerate(lines):
        match = None if number in taken else _meant(line)
        if match:
            right = f"```{{{match['kind']}}} {match['rest'].lstrip(' }')}".strip()
            text = (
                f"'{line.rstrip()}' opens no item: a fence has three backticks at the start of a "
                f"line, and its kind in braces. Write '{right}'"
            )
            place = number + 1, match.start("mark") + 1
            yield Diagnostic(file, *place, Code.BAD_HEADING.code, text)


def _meant(line: str) -> re.Match[str] | None:
    """The parts of a line that looks like the first one of an item."""
    match = _OPENING.fullmatch(line)
    return match if match and (match["brace"] or match["kind"].lower() in KINDS) else None


def _taken(token: Any) -> Iterable[int]:
    """The lines that open nothing: what a fence or a comment holds, and the first of an item."""
    start, end = token.map
    if token.type == "fence":
        return range(start if HEADING.fullmatch(token.info.strip()) else start + 1, end)
    comment = token.type == "html_block" and token.content.lstrip().startswith("<!--")
    return range(start, end) if comment else ()
