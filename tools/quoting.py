"""Text of a chapter inside a generated docstring: it stays text."""

from collections.abc import Iterable


def quoted(text: str) -> str:
    """Escape what would end a docstring, or what nobody could see in it."""
    shown = "".join(
        character if character.isprintable() else character.encode("unicode_escape").decode()
        for character in text.replace("\\", "\\\\")
    )
    shown = shown.replace('"""', r"\"\"\"")
    return shown[:-1] + r"\"" if shown.endswith('"') else shown


def docstring(lines: Iterable[str]) -> list[str]:
    """Return the lines of a function's docstring, indented, its quotes included."""
    first, *rest = map(quoted, lines)
    made = ['"""' + first, *rest, '"""'] if rest else [f'"""{first}"""']
    return [f"    {line}" if line else "" for line in made]
