"""The check that a model's output follows from its input.

Serves: the reader. Hides: how what an output rests on is found, through the model's own equations
and those of the items that it uses.
"""

from collections.abc import Mapping

from tamias2d.spec.chapter import Item
from tamias2d.spec.equations import Report
from tamias2d.spec.expression import names, parse
from tamias2d.spec.messages import Code

_GIVING = ("equations", "closed_form", "states")


def check_model(item: Item, items: Mapping[str, Item], report: Report) -> None:
    """Report an output that no formula gives, and an input that is needed and missing."""
    used = [items[id] for id in item.data.get("uses", ()) if id in items]
    known = set(item.data["input"]).union(*(_formulas(each) for each in (item, *used)))
    for number, name in enumerate(item.data["output"]):
        if name not in known:
            text = f"output '{name}' is given by no formula, here or in 'uses'. Write it"
            report(item.diagnostic(Code.UNKNOWN_NAME, text, "output", number))
    for name, user in _needed(item).items():
        if name not in known:
            text = f"'{user}' needs '{name}', which is no input, nor given by 'uses'. Add it"
            report(item.diagnostic(Code.UNKNOWN_NAME, text, "input"))


def _formulas(item: Item) -> dict[str, list[str]]:
    """The texts of the formulas that an item has for each name."""
    found: dict[str, list[str]] = {}
    for key in _GIVING:
        for name, text in item.data.get(key, {}).items():
            if name != "when":
                found.setdefault(name, []).append(text)
    return found


def _needed(item: Item) -> dict[str, str]:
    """All names that the outputs rest on, through formulas of the model, each with a user of it."""
    formulas = _formulas(item)
    found: dict[str, str] = {}
    todo = [name for name in item.data["output"] if name not in item.data["input"]]
    while todo:
        user = todo.pop()
        parts = [name for text in formulas.get(user, ()) for name in names(parse(text))]
        new = {name: user for name in parts if name not in found}
        found |= new
        todo += [name for name in new if name not in item.data["input"]]
    return found
