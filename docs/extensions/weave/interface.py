"""Public names with signature and docstring, read from the syntax tree.

Serves: `{interface}`, `{internals}`. Hides: how declarations are laid out and docstrings
become Markdown.
"""

import ast
import re
from collections.abc import Iterable, Iterator, Mapping
from itertools import accumulate

from tamias2d import _HOME_OF
from weave.markdown import as_markdown, bullets, code
from weave.modules import Module

WIDTH = 84  # letters of code beside each other
Named = ast.FunctionDef | ast.ClassDef


def reference(tree: ast.Module) -> Iterator[str]:
    """Declaration and docstring of each public function and class."""
    for node in public(tree):
        yield code("python", signature(node))
        yield described(node) + "\n"
        if isinstance(node, ast.ClassDef):
            yield bullets(_members(node))


def public_name(name: str, every: Iterable[Module]) -> Iterator[str]:
    """Declaration, docstring and members of a name of `tamias2d`, those of its bases too."""
    home = f"tamias2d.{_HOME_OF[name]}"
    inside = [module for module in every if f"{module.name}.".startswith(f"{home}.")]
    for module in inside:
        if module.name == f"{home}.{name}":  # a module is the name itself
            yield f"{module.summary}\n"
            yield from reference(module.tree)
            return
    known = {node.name: node for module in inside for node in _declared(module.tree)}
    node = known[name]
    yield code("python", signature(node))
    yield described(node) + "\n"
    if isinstance(node, ast.ClassDef):
        classes = _with_bases(node, known)
        yield bullets(dict.fromkeys(line for each in classes for line in _members(each)))


def _with_bases(node: ast.ClassDef, known: Mapping[str, Named]) -> Iterator[ast.ClassDef]:
    yield node
    for base in node.bases:
        found = known.get(ast.unparse(base))
        if isinstance(found, ast.ClassDef):
            yield from _with_bases(found, known)


def _declared(tree: ast.Module) -> Iterator[Named]:
    return (node for node in tree.body if isinstance(node, Named))


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
    args = _Bare().visit(node.args)
    returns = f" -> {ast.unparse(node.returns)}" if node.returns else ""
    flat = f"{node.name}({ast.unparse(args)}){returns}"
    if len(flat) <= WIDTH:
        return flat
    arguments = ",\n    ".join(_arguments(args))
    return f"{node.name}(\n    {arguments},\n){returns}"


class _Bare(ast.NodeTransformer):
    """Leaves of `Annotated[type, ...]` the type."""

    def visit_Subscript(self, node: ast.Subscript) -> ast.AST:
        annotated = ast.unparse(node.value) == "Annotated" and isinstance(node.slice, ast.Tuple)
        return node.slice.elts[0] if annotated else node


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
            yield f"`{ast.unparse(field)}`{_field_text(after)}"
    for inner in public(node):
        if ast.get_docstring(inner):
            kind = "property " if _is_property(inner) else ""
            text = described(inner).replace("\n", "\n  ")
            yield f"`{kind}{' '.join(signature(inner).split())}` \\\n  {text}"


def _field_text(after: ast.stmt | None) -> str:
    said = isinstance(after, ast.Expr) and isinstance(after.value, ast.Constant)
    return f": {as_markdown(' '.join(str(after.value.value).split()))}" if said else ""


def _is_property(node: Named) -> bool:
    return any("property" in ast.unparse(decorator) for decorator in node.decorator_list)
