"""The links of items: each leads to an item, of a kind that its key may name.

Serves: the reader, and checks of what an item rests on. Hides: which kinds may rest on which.
"""

from collections.abc import Mapping

from tamias2d.spec.chapter import Item
from tamias2d.spec.equations import Report
from tamias2d.spec.kinds import LINKS
from tamias2d.spec.messages import Code

_STATED = ("assumption", "theory", "definition", "model", "scheme", "constraint", "property")
_DEMANDED = ("requirement", "change")
_TARGETS = {
    "uses": _STATED,
    "verifies": ("requirement",),
    "corrects": ("goal", "requirement", "case", *_STATED),
    "affects": ("goal", "requirement", *_STATED),
}


def check_links(item: Item, items: Mapping[str, Item], report: Report) -> None:
    """Report each id that leads to no item, or to one that the key cannot name."""
    for key in LINKS:
        targets = _targets(item.kind, key)
        for number, id in enumerate(item.data.get(key, ())):
            if key == "corrects" and id == "none":
                continue
            if id not in items:
                text = f"'{id}' in '{key}' is no item. Correct the id or write the item"
                report(item.diagnostic(Code.UNKNOWN_ID, text, key, number))
            elif items[id].kind not in targets:
                text = (
                    f"'{id}' in '{key}' is a {items[id].kind}: '{key}' of a {item.kind} names "
                    f"one of {', '.join(targets)}. Correct the id"
                )
                report(item.diagnostic(Code.WRONG_LINK, text, key, number))


def _targets(kind: str, key: str) -> tuple[str, ...]:
    """The kinds that a key names; demands rest on demands, too."""
    demands = kind in ("goal", *_DEMANDED) and key == "uses"
    return (*_TARGETS[key], *(_DEMANDED if demands else ()))


def rests_on(item: Item, items: Mapping[str, Item]) -> set[str]:
    """The ids of all that an item uses, directly or through others, so far as they exist."""
    found: set[str] = set()
    todo = [item.id]
    while todo:
        each = todo.pop()
        new = items[each].data.get("uses", ()) if each in items else ()
        todo += [id for id in new if id not in found]
        found.update(new)
    return found
