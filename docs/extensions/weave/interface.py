"""Declarations with signature and docstring, read from the syntax tree.

Serves: `{internals}`, and the pieces of `{interface}`. Hides: how declarations are laid out and
docstrings become Markdown.
"""

import ast
import re
from collections.abc import Iterator
from itertools import accumulate

from weave.markdown import as_markdown, bullets, code

WIDTH = 84  # letters of code beside each other
Named = ast.FunctionDef | ast.ClassDef


def reference(tree: ast.Module) -> Iterator[str]:
    """Declaration and docstring of each public function and class."""
    for node in public(tree):
        yield code("python", signature(node))
        yield described(node) + "\n"
        if isinstance(node, ast.ClassDef):
            yield bullets(_members(node))


def public(tree: ast.Module | ast.ClassDef) -> Iterator[Named]:
    """The functions and classes without a leading underscore."""
    for node in tree.body:
        if isinstance(node, Named) and not node.name.startswith("_"):
            yield node


def exported(tree: ast.Module) -> Iterator[tuple[str, list[str]]]:
    """The names that a package takes from its modules, by module."""
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and node.module and node.module.startswith("tamias2d."):
            yield node.module, [name.name for name in node.names]


def signature(node: Named) -> str:
    """How a function or class is declared, on as many lines as it needs."""
    if isinstance(node, ast.ClassDef):
        bases = ", ".join(map(ast.unparse, node.bases))
        return f"class {node.name}({bases})" if bases else f"class {node.name}"
    args = Bare().visit(node.args)
    returns = f" -> {ast.unparse(unquoted(node.returns))}" if node.returns else ""
    flat = f"{node.name}({ast.unparse(args)}){returns}"
    if len(flat) <= WIDTH:
        return flat
    arguments = ",\n    ".join(_arguments(args))
    return f"{node.name}(\n    {arguments},\n){returns}"


class Bare(ast.NodeTransformer):
    """Leaves of `Annotated[type, ...]` the type, and takes quotes from types."""

    def visit_arg(self, node: ast.arg) -> ast.AST:
        node.annotation = node.annotation and unquoted(node.annotation)
        return self.generic_visit(node)

    def visit_Subscript(self, node: ast.Subscript) -> ast.AST:
        annotated = ast.unparse(node.value) == "Annotated" and isinstance(node.slice, ast.Tuple)
        return node.slice.elts[0] if annotated else node


def unquoted(annotation: ast.expr) -> ast.expr:
    """A type without the quotes that let it stand before its declaration."""
    if isinstance(annotation, ast.Constant) and isinstance(annotation.value, str):
        return ast.parse(annotation.value, mode="eval").body
    return annotation


def _arguments(args: ast.arguments) -> Iterator[str]:
    """Each argument as it is written: a comma within brackets separates none."""
    depth, start, text = 0, 0, ast.unparse(args)
    for k, letter in enumerate(text):
        depth += (letter in "[({") - (letter in "])}")
        if letter == "," and depth == 0:
            yield text[start:k].strip()
            start = k + 1
    yield text[start:].strip()


def described(node: Named | ast.Module) -> str:
    """A docstring as Markdown; the lines of a section such as `Raises:` become a list."""
    lines = (ast.get_docstring(node) or "").splitlines()
    marks = accumulate((len(re.findall("`+", line)) for line in lines), initial=0)
    return "\n".join(_line(line, in_code=n % 2 == 1) for line, n in zip(lines, marks, strict=False))


def _line(line: str, *, in_code: bool) -> str:
    if section := re.fullmatch(r"(\w+):", line):
        return f"\n*{section[1]}*\n"
    if entry := re.fullmatch(r" {4}(\w+): (.*)", line):
        return f"* `{entry[1]}`: {as_markdown(entry[2])}"
    if re.match(r" {4}\S", line):
        return line  # a formula, or the like, as it is
    return as_markdown(re.sub(r"^ {5,}", "  ", line), in_code=in_code)


def _members(node: ast.ClassDef) -> Iterator[str]:
    """Fields, properties and methods, each with what it says."""
    for field, after in zip(node.body, [*node.body[1:], None], strict=True):
        if isinstance(field, ast.AnnAssign) and not ast.unparse(field.target).startswith("_"):
            text = said(after)
            yield f"`{ast.unparse(field)}`" + (f": {text}" if text else "")
    for inner in public(node):
        if ast.get_docstring(inner):
            kind = "property " if _is_property(inner) else ""
            text = described(inner).replace("\n", "\n  ")
            yield f"`{kind}{' '.join(signature(inner).split())}` \\\n  {text}"


def said(after: ast.stmt | None) -> str:
    """What the statement after a field says of it; nothing if it is no text."""
    told = isinstance(after, ast.Expr) and isinstance(after.value, ast.Constant)
    return as_markdown(" ".join(str(after.value.value).split())) if told else ""


def _is_property(node: Named) -> bool:
    return any("property" in ast.unparse(decorator) for decorator in node.decorator_list)
