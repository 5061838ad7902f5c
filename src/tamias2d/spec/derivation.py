"""Whether each step of a derivation follows from the one before, and a closed form solves.

Serves: the reader. Hides: what a first step may follow from. Where its reason begins with the id of
an item that has equations, it must follow from one of them, with what `where` puts in for its
names. A later step whose reason begins so may begin another derivation.
"""

import re
from collections.abc import Iterator, Mapping

from tamias2d.spec import expression as ex
from tamias2d.spec.chapter import Item
from tamias2d.spec.check import infer
from tamias2d.spec.derivative import differentiate
from tamias2d.spec.equations import Report, parsed, placed, relation, typed
from tamias2d.spec.expression import Node, rebuilt, substituted
from tamias2d.spec.implication import implies, same
from tamias2d.spec.messages import Code, SpecFault
from tamias2d.spec.symbols import SymbolTable
from tamias2d.spec.tex import plain

_DEEPEST = 8  # substitutions within substitutions
_CITED = re.compile(r"(TM|GD|DD|IM|P)[0-9]+")


def check_derivation(
    item: Item, items: Mapping[str, Item], table: SymbolTable, report: Report
) -> None:
    """Report each step that does not follow, and a last step that is not the item's equation.

    The items are all of the specification, by their ids.
    """
    before: ex.Relation | None = None
    for number, step in enumerate(item.data.get("derivation", [])):
        where = ("derivation", number)
        now = relation(item, step["equation"], table, report, *where, "equation")
        own = before is not None
        given = _substitutions(item, step.get("where", {}), own, table, report, where)
        if now is None or given is None:
            return
        if before is not None and not implies(before, now, given, table):
            if not begins(item, number, now, given, items, table):
                steps = f"'{plain(now)}' does not follow from '{plain(before)}'"
                text = f"{steps}. Correct it, or say in 'where' what is put in"
                report(item.diagnostic(Code.DERIVATION_GAP, text, *where, "equation"))
                return
            _check_end(item, before, table, report)
        elif before is None and begins(item, number, now, given, items, table) is False:
            text = f"the first step '{plain(now)}' does not follow from {cited(item, number)}. "
            text += "Correct it, or say in 'where' what stands for the names of that item"
            report(item.diagnostic(Code.DERIVATION_GAP, text, *where, "equation"))
        before = now
    if before is not None:
        _check_end(item, before, table, report)


def begins(
    item: Item,
    number: int,
    first: ex.Relation,
    given: dict[str, Node],
    items: Mapping[str, Item],
    table: SymbolTable,
) -> bool | None:
    """Whether a step follows from the item that its reason cites; None if that has no equations."""
    source = items.get(cited(item, number))
    equations = list(statements(source, table)) if source else []
    if not equations:
        return None
    return any(leads(each, first, given, table) for each in equations)


def cited(item: Item, number: int) -> str:
    """The id with which the reason of a step begins."""
    found = _CITED.match(item.data["derivation"][number]["by"])
    return found.group() if found else ""


def leads(
    source: ex.Relation, step: ex.Relation, given: dict[str, Node], table: SymbolTable
) -> bool:
    """Whether a step follows from an equation with what is put in for names of the latter."""
    start = (
        rebuilt(side, lambda part: given.get(plain(part))) for side in (source.left, source.right)
    )
    return implies(ex.Relation("==", *start), step, {}, table)


def statements(item: Item, table: SymbolTable) -> Iterator[ex.Relation]:
    """All that an item says by equations, with its own intermediate quantities put in or not."""

    def faultless(_fault: object) -> None:
        """What is wrong with that item is said where it is read."""

    if text := item.data.get("equation"):
        stated = relation(item, text, table, faultless, "equation")
        yield from [stated] if stated else []
    own = dict(own_equations(item, faultless))
    for name, tree in own.items():
        yield ex.Relation("==", ex.Name(name), tree)
        expanded = tree
        for _ in range(_DEEPEST):
            expanded = substituted(expanded, {key: own[key] for key in own if key != name})
        yield ex.Relation("==", ex.Name(name), expanded)
    yield from rates(item, faultless)


def _substitutions(
    item: Item,
    where: dict[str, str],
    own: bool,
    table: SymbolTable,
    report: Report,
    path: tuple[str | int, ...],
) -> dict[str, Node] | None:
    found: dict[str, Node] = {}
    for name, text in where.items():
        key = parsed(item, name, report, *path, "where", name, "key")
        node = parsed(item, text, report, *path, "where", name)
        if key is None or node is None:
            return None
        if typed(item, ex.Relation("==", key, node), table, report, *path, "where", name) is None:
            return None
        if own and not _is_own(item, key, node, table, report):
            text = f"'{name}' is not put in as the item defines it. Make them agree"
            report(item.diagnostic(Code.DERIVATION_GAP, text, *path, "where", name))
            return None
        found[plain(key)] = node
    return found


def _is_own(item: Item, key: Node, node: Node, table: SymbolTable, report: Report) -> bool:
    """Whether a quantity that the item itself defines is put in as defined."""
    own = dict(own_equations(item, report)).get(plain(key))
    return own is None or implies(
        ex.Relation("==", key, own), ex.Relation("==", key, node), {}, table
    )


def _check_end(item: Item, last: ex.Relation, table: SymbolTable, report: Report) -> None:
    targets = [ex.Relation("==", ex.Name(name), tree) for name, tree in own_equations(item, report)]
    targets += rates(item, report)
    if text := item.data.get("equation"):
        own = relation(item, text, table, report, "equation")
        targets += [own] if own else []
    if targets and not any(implies(last, target, {}, table) for target in targets):
        text = f"the last step '{plain(last)}' is not the item's equation. Finish it"
        report(item.diagnostic(Code.DERIVATION_GAP, text, "derivation"))


def rates(item: Item, report: Report) -> Iterator[ex.Relation]:
    """What an item says of the rates of its states, as equations."""
    for name, text in item.data.get("states", {}).items():
        rate = parsed(item, text, report, "states", name)
        if rate is not None:
            yield ex.Relation("==", ex.Call("d", (ex.Name(name), ex.Name("time"))), rate)


def own_equations(item: Item, report: Report) -> Iterator[tuple[str, Node]]:
    """The executable equations of an item by name, without its conditions."""
    for name, text in item.data.get("equations", {}).items():
        node = parsed(item, text, report, "equations", name)
        if node is not None and not isinstance(node, (ex.Relation, ex.Both)):
            yield name, node


def check_closed_form(item: Item, table: SymbolTable, report: Report) -> None:
    """Report a closed form whose time derivative or start is not the state's."""
    forms = {
        name: node
        for name, text in item.data.get("closed_form", {}).items()
        if name != "when" and (node := parsed(item, text, report, "closed_form", name)) is not None
    }
    for name, form in forms.items():
        if name not in item.data.get("arguments", {}):
            text = f"closed form of {name}: no function of it could be tested. Add its 'arguments'"
            report(item.diagnostic(Code.BAD_KEY, text, "closed_form", name))
        rate = parsed(item, item.data.get("states", {}).get(name, "0"), report, "states", name)
        if rate is None:
            continue
        try:
            infer(form, table)
            solves = same(differentiate(form, "time"), substituted(rate, forms), table)
            starts = same(form, ex.Name(f"{name}_start"), table, time=0.0)
        except SpecFault as fault:
            report(placed(item, fault, "closed_form", name))
            continue
        except ValueError:
            solves = starts = False
        if not (solves and starts):
            what = (
                "its time derivative is not the rate of the state"
                if starts
                else f"at time 0 it is not {name}_start"
            )
            report(
                item.diagnostic(
                    Code.CLOSED_FORM,
                    f"closed form of {name}: {what}. Correct it",
                    "closed_form",
                    name,
                )
            )
