"""Whether something would notice a wrong statement: ties of equations to what is checked.

Serves: the reader. Hides: what ties an equation. One does that the item derives or computes, that
a test in random crowds judges, or from which a derivation or the rate of a state of another item
follows. What nothing ties says so in its item, by `unchecked`.
"""

from collections.abc import Iterator, Mapping
from typing import Any

from tamias2d.spec import expression as ex
from tamias2d.spec.chapter import Item
from tamias2d.spec.derivation import cited, leads, own_equations, rates, statements
from tamias2d.spec.equations import Report
from tamias2d.spec.expression import Node, names, parse, substituted
from tamias2d.spec.implication import implies, same
from tamias2d.spec.messages import Code
from tamias2d.spec.symbols import SymbolTable
from tamias2d.spec.tex import plain

_DEEPEST = 8  # substitutions within substitutions


def check_ties(item: Item, items: Mapping[str, Item], table: SymbolTable, report: Report) -> None:
    """Report what an item states, nothing ties, and it does not say so; and the reverse."""
    loose = list(_loose(item, items, table))
    if loose and "unchecked" not in item.data:
        text = "nothing would notice if this were wrong. Derive it, or say why in 'unchecked'"
        report(item.diagnostic(Code.UNCHECKED, text, *loose[0]))
    if not loose and "unchecked" in item.data:
        text = "all that the item states is checked. Leave 'unchecked' out"
        report(item.diagnostic(Code.UNCHECKED, text, "unchecked", "key"))


def _loose(item: Item, items: Mapping[str, Item], table: SymbolTable) -> Iterator[tuple[str, ...]]:
    """Where an item states what nothing ties."""
    if "equation" in item.data and not _is_tied(item, items, table):
        yield ("equation",)
    for rate in rates(item, _faultless):
        if not _follows(rate, item, items, table):
            assert isinstance(rate.left, ex.Call)  # d(state, time)
            yield "states", plain(rate.left.arguments[0])


def _is_tied(item: Item, items: Mapping[str, Item], table: SymbolTable) -> bool:
    stated = _relation(item.data["equation"])
    if "crowd" in item.data or _is_derived(stated, item, table) or _computes(stated, item, table):
        return True
    if item.data.get("equations"):
        return False  # what is executed must agree, whatever others make of the statement
    return any(_leads_to(stated, item.id, other, table) for other in items.values())


def _is_derived(stated: ex.Relation, item: Item, table: SymbolTable) -> bool:
    """Whether an equation is a step of its item's derivation, or follows from one."""
    own = dict(own_equations(item, _faultless))
    steps = [_relation(step["equation"]) for step in item.data.get("derivation", ())]
    return any(
        implies(step, stated, own, table) or implies(stated, step, {}, table) for step in steps
    )


def _computes(stated: ex.Relation, item: Item, table: SymbolTable) -> bool:
    """Whether an equation holds for all that the item's functions give."""
    own = dict(own_equations(item, _faultless))
    sides: list[Node] = [stated.left, stated.right]
    for _ in range(_DEEPEST):
        sides = [substituted(side, own) for side in sides]
    put_in = sides != [stated.left, stated.right]
    return put_in and _is_without_derivative(sides) and same(sides[0], sides[1], table)


def _is_without_derivative(sides: list[Node]) -> bool:
    return not any(
        isinstance(part, ex.Call) and part.function in ("d", "integral")
        for side in sides
        for part in ex.walk(side)
    )


def _leads_to(stated: ex.Relation, id: str, other: Item, table: SymbolTable) -> bool:
    """Whether something checked of another item follows from an equation."""
    for number, step in enumerate(other.data.get("derivation", ())):
        if cited(other, number) == id and _gives(stated, step, table):
            return True
    if other.kind == "case" or id not in other.data.get("uses", ()):
        return False
    judged = "crowd" in other.data and _relation(other.data["equation"]) == stated
    return judged or any(implies(stated, rate, {}, table) for rate in rates(other, _faultless))


def _gives(stated: ex.Relation, step: Mapping[str, Any], table: SymbolTable) -> bool:
    """Whether a step follows from an equation, or what it puts in does."""
    put_in = [(parse(key), parse(text)) for key, text in step.get("where", {}).items()]
    given = {plain(key): node for key, node in put_in}
    return leads(stated, _relation(step["equation"]), given, table) or any(
        leads(stated, ex.Relation("==", key, node), _with_indices(stated, key, node), table)
        for key, node in put_in
    )


def _with_indices(stated: ex.Relation, key: Node, node: Node) -> dict[str, Node]:
    """For names of an equation the ones of the same quantities of a body, as they are put in."""
    found = (*names(key), *names(node))
    return {
        name: ex.Name(other)
        for name in names(stated)
        for other in found
        if name not in found and other.startswith(f"{name}_")
    }


def _follows(rate: ex.Relation, item: Item, items: Mapping[str, Item], table: SymbolTable) -> bool:
    """Whether the rate of a state is derived, or follows from an item that its own one uses."""
    if _is_derived(rate, item, table):
        return True
    used = [items[id] for id in item.data.get("uses", ())]
    return any(
        implies(each, rate, {}, table) for source in used for each in statements(source, table)
    )


def _relation(text: str) -> ex.Relation:
    found = parse(text)
    assert isinstance(found, ex.Relation)  # it was checked
    return found


def _faultless(_fault: object) -> None:
    """What is wrong with an item was said before."""
