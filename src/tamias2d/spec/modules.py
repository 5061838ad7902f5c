"""The modules that functions of items stand in: their names are free, and no function is twice.

Serves: the reader. Hides: which modules the generator prints by itself.
"""

import keyword
from collections.abc import Iterable

from tamias2d.spec.chapter import Item
from tamias2d.spec.equations import Report, module_of
from tamias2d.spec.messages import Code

_TAKEN = ("constraints", "joint_rows", "schemes", "symbols")


def check_modules(items: Iterable[Item], report: Report) -> None:
    """Report functions that stand twice in a module, and modules that are no such or another's."""
    found: dict[tuple[str, str], Item] = {}
    for item in items:
        if not item.data.get("arguments"):
            continue
        module = module_of(item)
        if module in _TAKEN or keyword.iskeyword(module):
            text = f"'{module}' is a word of Python or the module of another kind. Rename it"
            report(item.diagnostic(Code.BAD_VALUE, text, "module"))
        for name in item.data["arguments"]:
            first = found.setdefault((module, name), item)
            if first is not item:
                text = f"'{name}' is a function of {first.id} in {module} already. Rename one"
                report(item.diagnostic(Code.DUPLICATE_ID, text, "arguments", name, "key"))
