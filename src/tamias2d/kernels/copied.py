"""A function's own text, ready for a source that stands alone.

Serves: the makers of sources. Hides: how types, most of the docstring and the names of other
modules are cut out of a text whose layout and comments stay.
"""

import ast
import inspect
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from functools import cache
from typing import Any

Function = Callable[..., Any]
Edit = tuple[int, int, str]  # from, to (bytes of the source), and what stands there then

_left_out: ContextVar[frozenset[Function]] = ContextVar("left_out", default=frozenset())


def function_of(function: Function) -> ast.FunctionDef:
    """Return the syntax tree of a module-level function."""
    tree = ast.parse(_source(function)).body[0]
    if not isinstance(tree, ast.FunctionDef):
        raise TypeError(function)
    return tree


@contextmanager
def leaving_out(functions: Collection[Function]) -> Iterator[None]:
    """Meanwhile, let sources be without the statements that only call some functions.

    These are calls by themselves, and `x = f(x, ...)`; any other use of the functions stays.
    """
    token = _left_out.set(frozenset(functions))
    try:
        yield
    finally:
        _left_out.reset(token)


def _source(function: Function) -> str:
    return _source_without(function, _left_out.get())


@cache
def _source_without(function: Function, left_out: frozenset[Function]) -> str:
    source = inspect.getsource(function)
    if not left_out:
        return source
    lines = source.splitlines(keepends=True)
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.stmt) and _called_alone(node, function) in left_out:
            first, last = node.lineno - 1, node.end_lineno or node.lineno
            lines[first:last] = [""] * (last - first)
    return "".join(lines)


def _called_alone(node: ast.stmt, function: Function) -> Function | None:
    """Return the function that a statement does nothing else than call, or None."""
    value = node.value if isinstance(node, ast.Expr | ast.Assign) else None
    if not isinstance(value, ast.Call) or not isinstance(value.func, ast.Name):
        return None
    if isinstance(node, ast.Assign):
        kept = ast.unparse(value.args[0]) if value.args else None
        if [ast.unparse(target) for target in node.targets] != [kept]:
            return None
    found: Function | None = function.__globals__.get(value.func.id)
    return found if callable(found) else None


def references(function: Function) -> Iterator[ast.Name | ast.Attribute]:
    """Yield the names that a function reads and does not set, types and marks apart.

    A dotted name is yielded as a whole.
    """
    own = set(function.__code__.co_varnames)
    yield from _read(function_of(function), own)


def text_of(function: Function) -> "Text":
    """Return where the parts of a function lie in its source."""
    return Text(_source(function).encode())


def copied(
    function: Function,
    names: Mapping[str, str],
    more: Iterable[Edit] = (),
    whole: Collection[str] = (),
) -> str:
    """Return the text of a function without types and marks, with other names for what it reads.

    Of its docstring the first line and the source stay. Further edits are made, too; they replace
    the parameters that are named as a whole.
    """
    source = _source(function).encode()
    tree = function_of(function)
    text = Text(source)
    edits = [
        (0, text.starts[tree.lineno - 1], ""),
        *more,
        *_signature(tree, text, whole),
        *_docstring(tree, text),
        *_typed(tree, text),
    ]
    for node in references(function):
        old = ast.unparse(node)
        if names.get(old, old) != old:
            edits.append((*text.span(node), names[old]))
    for first, last, new in sorted(edits, reverse=True):
        source = source[:first] + new.encode() + source[last:]
    return source.decode().rstrip()


def _read(node: ast.AST, own: set[str]) -> Iterator[ast.Name | ast.Attribute]:
    if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
        if node.value.id not in own:
            yield node
        return
    if isinstance(node, ast.Name):
        if node.id not in own:
            yield node
        return
    for name, value in ast.iter_fields(node):
        if name in ("annotation", "returns", "decorator_list"):
            continue
        for child in value if isinstance(value, list) else [value]:
            if isinstance(child, ast.AST):
                yield from _read(child, own)


class Text:
    """Where the nodes of a tree lie in its source."""

    def __init__(self, source: bytes) -> None:
        self.source = source
        self.starts = [0]
        for line in source.splitlines(keepends=True):
            self.starts.append(self.starts[-1] + len(line))

    def start(self, node: ast.expr | ast.stmt | ast.arg) -> int:
        """Return where a node begins, in bytes."""
        return self.starts[node.lineno - 1] + node.col_offset

    def end(self, node: ast.expr | ast.stmt | ast.arg) -> int:
        """Return where a node ends, in bytes."""
        if node.end_lineno is None or node.end_col_offset is None:
            raise TypeError(node)
        return self.starts[node.end_lineno - 1] + node.end_col_offset

    def span(self, node: ast.expr | ast.stmt) -> tuple[int, int]:
        """Return where a node begins and ends, in bytes."""
        return self.start(node), self.end(node)


def _signature(tree: ast.FunctionDef, text: Text, whole: Collection[str]) -> Iterator[Edit]:
    for argument in tree.args.args:
        if argument.annotation is not None and argument.arg not in whole:
            name_end = text.start(argument) + len(argument.arg.encode())
            yield name_end, text.end(argument.annotation), ""
    if tree.returns is not None:
        arrow = text.source.rindex(b" ->", 0, text.start(tree.returns))
        yield arrow, text.end(tree.returns), ""


def _docstring(tree: ast.FunctionDef, text: Text) -> Iterator[Edit]:
    says = (ast.get_docstring(tree) or "").splitlines()
    if not says:
        return
    sources = [line for line in says if line.startswith("Source: ")]
    origin = [f"\n\n    {line}\n    " for line in sources]
    yield (*text.span(tree.body[0]), f'"""{says[0]}{"".join(origin)}"""')


def _typed(tree: ast.FunctionDef, text: Text) -> Iterator[Edit]:
    """Without the types of variables."""
    for node in ast.walk(tree):
        if isinstance(node, ast.AnnAssign):
            yield text.end(node.target), text.end(node.annotation), ""
