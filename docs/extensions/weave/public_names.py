"""Public names as entries of Sphinx's Python domain: each has an anchor and stands in the index.

Serves: `{interface}`. Hides: from which class of a hierarchy a member comes, and how a
constructor is written down that a dataclass makes.
"""

import ast
import inspect
import json
from collections.abc import Callable, Iterable, Iterator, Mapping
from copy import deepcopy
from types import ModuleType
from typing import Any

import tamias2d
from weave.interface import Bare, Named, described, public, said, unquoted
from weave.markdown import fence
from weave.modules import Module

_CLASS, _MEMBER = 5, 3  # colons of a fence: that of a class holds those of its members
_Field = tuple[ast.AnnAssign, ast.stmt | None]


def public_name(name: str, every: Iterable[Module]) -> str:
    """A function, a class with its members and those of its bases, or a module's functions."""
    value = getattr(tamias2d, name)
    trees = {module.name: module.tree for module in every}
    if isinstance(value, ModuleType):
        return "\n".join(_module(name, trees[value.__name__]))
    if isinstance(value, type):
        return _class(value, [_declared(base, trees) for base in _bases(value)])
    return _function("function", _declared(inspect.unwrap(value), trees), {"module": "t2"})


def _module(name: str, tree: ast.Module) -> Iterator[str]:
    yield f"{described(tree).splitlines()[0]}\n"
    for node in public(tree):
        yield _function("function", node, {"module": f"t2.{name}"})


def _bases(kind: type) -> list[type]:
    """A class and its bases of this package, in the order in which Python looks for a member."""
    return [base for base in kind.__mro__ if base.__module__.partition(".")[0] == "tamias2d"]


def _declared(value: type | Callable[..., Any], trees: Mapping[str, ast.Module]) -> Any:
    """The declaration of a class or a function at the top of its module."""
    nodes = (node for node in trees[value.__module__].body if isinstance(node, Named))
    return next(node for node in nodes if node.name == value.__name__)


def _class(kind: type, nodes: list[ast.ClassDef]) -> str:
    fields = {
        ast.unparse(each[0].target): each for node in reversed(nodes) for each in _fields(node)
    }
    methods = _methods(nodes)
    made = None if issubclass(kind, Exception) else _init(nodes)
    body = [
        described(nodes[0]),
        described(made) if made else "",
        *(_attribute(*each) for name, each in fields.items() if name not in methods),
        *map(_method, methods.values()),
    ]
    arguments = _arguments(made, own=True) if made else _of_fields(kind, fields)
    head = f"{kind.__name__}{arguments}"
    role = "py:exception" if issubclass(kind, Exception) else "py:class"
    return fence(role, head, "\n\n".join(body), depth=_CLASS, module="t2")


def _fields(node: ast.ClassDef) -> Iterator[_Field]:
    """What a class declares to hold, each with the statement after it, which may describe it."""
    for field, after in zip(node.body, [*node.body[1:], None], strict=True):
        if isinstance(field, ast.AnnAssign) and not ast.unparse(field.target).startswith("_"):
            yield field, after


def _methods(nodes: Iterable[ast.ClassDef]) -> dict[str, Named]:
    """Methods and properties that say what they are; that of the nearest class counts."""
    found: dict[str, Named] = {}
    for node in nodes:
        for method in public(node):
            if ast.get_docstring(method):
                found.setdefault(method.name, method)
    return found


def _init(nodes: Iterable[ast.ClassDef]) -> ast.FunctionDef | None:
    """The constructor that is written down in a class or the nearest of its bases."""
    every = (inner for node in nodes for inner in node.body if isinstance(inner, ast.FunctionDef))
    return next((each for each in every if each.name == "__init__"), None)


def _of_fields(kind: type, fields: Mapping[str, _Field]) -> str:
    """The arguments that a dataclass makes of its fields; users raise no exceptions of ours."""
    if issubclass(kind, Exception):
        return ""
    parameters = inspect.signature(kind).parameters.values()
    return str(inspect.Signature([_as_written(each, fields[each.name][0]) for each in parameters]))


class _Written(str):
    """Code that is printed as it is written."""

    __repr__ = str.__str__


def _as_written(parameter: inspect.Parameter, field: ast.AnnAssign) -> inspect.Parameter:
    annotation = _Written(_type(field))
    default = parameter.default
    if default is not parameter.empty and field.value and not isinstance(field.value, ast.Call):
        default = _Written(ast.unparse(field.value))
    elif default is not parameter.empty:
        default = _Written("...")
    return parameter.replace(annotation=annotation, default=default)


def _arguments(node: ast.FunctionDef, *, own: bool) -> str:
    """The arguments in brackets, without the first one where that is the object itself."""
    args = Bare().visit(deepcopy(node.args))
    if own:
        del (args.posonlyargs or args.args)[0]
    return f"({ast.unparse(args)})"


def _function(kind: str, node: Any, options: Mapping[str, str], *, own: bool = False) -> str:
    returns = f" -> {ast.unparse(unquoted(node.returns))}" if node.returns else ""
    head = f"{node.name}{_arguments(node, own=own)}{returns}"
    return fence(f"py:{kind}", head, described(node), depth=_MEMBER, **options)


def _method(node: Any) -> str:
    marks = {ast.unparse(each) for each in node.decorator_list}
    if any("property" in mark for mark in marks):
        told = {"type": json.dumps(ast.unparse(node.returns))} if node.returns else {}
        return fence("py:property", node.name, described(node), depth=_MEMBER, **told)
    options = {mark: "" for mark in ("classmethod", "staticmethod") if mark in marks}
    return _function("method", node, options, own="staticmethod" not in marks)


def _attribute(field: ast.AnnAssign, after: ast.stmt | None) -> str:
    told = {"type": json.dumps(_type(field))}
    return fence("py:attribute", ast.unparse(field.target), said(after), depth=_MEMBER, **told)


def _type(field: ast.AnnAssign) -> str:
    return ast.unparse(Bare().visit(deepcopy(field.annotation)))
