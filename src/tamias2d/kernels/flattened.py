"""Groups taken apart: a function that takes groups becomes one that takes the arrays it uses.

In the assembled source `bodies.pose` is `bodies_pose`, and a call hands over what the called
function, and all that it calls, reads of a group, and no more. So groups cost neither time to
compile nor time to run.
"""

import ast
import typing
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

from tamias2d.kernels.copied import Edit, Function, Text, function_of
from tamias2d.kernels.groups import fields_of, is_group, lines_of_entry, paths_of

Path = tuple[str, ...]  # from a parameter to a field, such as ('world', 'bodies', 'pose')


@dataclass
class Flat:
    """What a function uses of its groups."""

    groups: dict[str, type]
    """its parameters that are groups"""
    used: dict[str, list[Path]] = field(default_factory=dict)
    """the fields that it uses of each, in the order of their declaration"""

    def names(self, parameter: str) -> list[str]:
        """Return the parameters that take the place of a group."""
        return ["_".join(path) for path in self.used[parameter]]


def flattened(
    function: Function,
    text: Text,
    called: Mapping[str, tuple[Function, Flat]],
    *,
    entry: bool = False,
) -> tuple[Flat, list[Edit]]:
    """Return what a function uses of its groups, and the edits that take them apart.

    `called` holds the functions that it calls, by the names by which it does. An entry finds the
    fields of its group by their addresses, which is its first argument.

    Raises:
        TypeError: a group is used in a way that leaves it whole; says where.
    """
    work = _Work(function, text, called)
    for statement in function_of(function).body:
        work.visit(statement)
    work.finish(entry=entry)
    return work.flat, work.edits


class _Work(ast.NodeVisitor):
    """The edits of one function."""

    def __init__(
        self, function: Function, text: Text, called: Mapping[str, tuple[Function, Flat]]
    ) -> None:
        self.function, self.text, self.called = function, text, called
        hints = typing.get_type_hints(function)
        self.tree = function_of(function)
        names = [argument.arg for argument in self.tree.args.args]
        self.flat = Flat({name: hints[name] for name in names if is_group(hints.get(name))})
        self.known: dict[str, Path] = {name: (name,) for name in self.flat.groups}
        self.local: dict[str, type] = {}
        self.edits: list[Edit] = []
        self.found: set[Path] = set()

    # -- what a name stands for

    def type_of(self, path: Path) -> Any:
        """Return the type at the end of a path."""
        hint: Any = self.flat.groups[path[0]]
        for name in path[1:]:
            hint = fields_of(hint)[name]
        return hint

    def path_of(self, node: ast.AST) -> Path | None:
        """Return the path that an expression stands for, or None if it starts at no parameter."""
        if isinstance(node, ast.Name):
            return self.known.get(node.id)
        if isinstance(node, ast.Attribute) and (start := self.path_of(node.value)):
            return (*start, node.attr) if is_group(self.type_of(start)) else None
        return None

    def group_of(self, node: ast.AST) -> type | None:
        """Return the group that an expression of local names or a call makes, or None."""
        if isinstance(node, ast.Name):
            return self.local.get(node.id)
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
            value = self.function.__globals__.get(node.func.id)
            made = (
                value
                if is_group(value)
                else typing.get_type_hints(value).get("return")
                if (callable(value) and node.func.id in self.called)
                else None
            )
            return made if is_group(made) else None
        return None

    # -- statements and expressions

    def visit_Assign(self, node: ast.Assign) -> None:
        """Leave out what only gives a part of a parameter another name; note local groups."""
        (target,) = node.targets if len(node.targets) == 1 else (None,)
        targets = target.elts if isinstance(target, ast.Tuple) else [target]
        values = node.value.elts if isinstance(node.value, ast.Tuple) else [node.value]
        paths = [self.path_of(value) for value in values]
        whole = [path is not None and is_group(self.type_of(path)) for path in paths]
        if len(targets) == len(values) and all(whole):
            for name, path in zip(targets, paths, strict=True):
                if isinstance(name, ast.Name) and path is not None:
                    self.known[name.id] = path
            self.edits.append((*self.text.span(node), "pass"))
            return
        for name, value in zip(targets, values, strict=False):
            if isinstance(name, ast.Name) and (made := self.group_of(value)):
                self.local[name.id] = made
        self.generic_visit(node)

    def visit_Name(self, node: ast.Name) -> None:
        """Refuse a group that is left whole."""
        if node.id in self.known:
            raise self.refusal(node)

    def visit_Attribute(self, node: ast.Attribute) -> None:
        """Write a field of a group by its own name."""
        path = self.path_of(node)
        if path is None:
            self.generic_visit(node)
        elif is_group(self.type_of(path)):
            raise self.refusal(node)
        else:
            self.found.add(path)
            self.edits.append((*self.text.span(node), "_".join(path)))

    def visit_Call(self, node: ast.Call) -> None:
        """Hand over what a function uses of each group."""
        name = node.func.id if isinstance(node.func, ast.Name) else ""
        if name not in self.called or not self.called[name][1].groups:
            self.generic_visit(node)
            return
        callee, flat = self.called[name]
        parameters = [argument.arg for argument in function_of(callee).args.args]
        if len(parameters) != len(node.args) or node.keywords:
            raise self.refusal(node)
        lists: list[str | None] = []
        for parameter, argument in zip(parameters, node.args, strict=True):
            if parameter in flat.groups:
                lists.append(", ".join(self.handed_over(argument, flat.used[parameter])))
            else:
                lists.append(None)
                self.visit(argument)
        self.edits += _spread(node.args, lists, self.text)

    def handed_over(self, argument: ast.expr, fields: list[Path]) -> Iterator[str]:
        """Yield what is written for the fields of a group."""
        path = self.path_of(argument)
        for rest in fields:
            if path is not None:
                self.found.add((*path, *rest[1:]))
                yield "_".join((*path, *rest[1:]))
            elif self.group_of(argument) and isinstance(argument, ast.Name):
                yield ".".join((argument.id, *rest[1:]))
            else:
                raise self.refusal(argument)

    def finish(self, *, entry: bool) -> None:
        """Order what was found, and write the parameters."""
        for name, group in self.flat.groups.items():
            paths = [(name, *path) for path in paths_of(group)]
            self.flat.used[name] = [path for path in paths if path in self.found]
        arguments = self.tree.args.args
        lists = [
            None if a.arg not in self.flat.groups else self._parameters(a.arg, entry=entry)
            for a in arguments
        ]
        self.edits += _spread(arguments, lists, self.text)
        own = set(self.function.__code__.co_varnames)
        for path in self.found:
            if "_".join(path) in own:
                raise self.refusal(self.tree, f"'{'_'.join(path)}' is also a variable")

    def _parameters(self, name: str, *, entry: bool) -> str:
        """Return what stands for a group among the parameters; an entry begins by finding it."""
        if not entry:
            return ", ".join(self.flat.names(name))
        found = lines_of_entry(self.flat.groups[name], self.flat.used[name])
        place = self.text.end(self.tree.body[0])  # after the docstring
        self.edits.append((place, place, "".join(f"\n    {line}" for line in found)))
        return "addresses"

    def refusal(self, node: ast.AST, why: str = "a group must be taken apart") -> TypeError:
        line = getattr(node, "lineno", 1) + self.function.__code__.co_firstlineno - 1
        return TypeError(
            f"{self.function.__module__}.{self.function.__name__}: line {line}: {why}. Use its "
            "fields, or hand it over to a function as it is."
        )


def _spread(
    nodes: "list[ast.expr] | list[ast.arg]", lists: "list[str | None]", text: Text
) -> Iterator[Edit]:
    """Yield the edits that put lists in the place of arguments; an empty one leaves no comma."""
    spans = [(text.start(node), text.end(node)) for node in nodes]
    for k, names in enumerate(lists):
        first, last = spans[k]
        if names:
            yield first, last, names
        elif names == "":
            if k + 1 < len(spans):
                yield first, spans[k + 1][0], ""
            elif k > 0 and lists[k - 1] != "":
                yield spans[k - 1][1], last, ""
            else:
                yield first, last, ""
