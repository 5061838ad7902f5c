"""Generated data: the symbols as Python, and the whole specification as JSON."""

import json
from typing import Any

from tamias2d.spec.chapter import Item
from tamias2d.spec.specification import Specification
from tamias2d.spec.symbols import Symbol

Code = dict[str, list[dict[str, Any]]]

HEADER = '''"""Symbols: unit, shape and admissible range of each.

Generated from srs/symbols.md by `python -m tools.generate`. Edit the chapter, not this file.
"""

from tamias2d.spec.symbols import Range, Symbol
'''


def emit_symbols(specification: Specification) -> str:
    """Source of the symbol table, not yet formatted."""
    symbols = specification.table.symbols.values()
    entries = [f"    {symbol.name!r}: {_symbol(symbol)}," for symbol in symbols]
    return "\n".join([HEADER, "SYMBOLS: dict[str, Symbol] = {", *entries, "}", ""])


def _symbol(symbol: Symbol) -> str:
    facts = [repr(symbol.name), repr(symbol.unit), repr(symbol.says)]
    if symbol.shape != "scalar":
        facts.append(f"shape={symbol.shape!r}")
    if symbol.range.text:
        facts.append(f"range={_range(symbol)}")
    facts += [
        f"{key}={getattr(symbol, key)!r}"
        for key in ("tex", "typical", "uncertainty")
        if getattr(symbol, key)
    ]
    facts += [f"file={symbol.file!r}", f"line={symbol.line}"]
    return f"Symbol({', '.join(facts)})"


def _range(symbol: Symbol) -> str:
    limits = symbol.range
    facts = [repr(limits.text)]
    for key, absent in (("low", "-inf"), ("high", "inf")):
        value = repr(getattr(limits, key))
        facts += [] if value == absent else [f"{key}={value}"]
    facts += [f"{key}=False" for key in ("low_open", "high_open") if not getattr(limits, key)]
    return f"Range({', '.join(facts)})"


def emit_json(specification: Specification, code: Code) -> str:
    """All items with their links, hashes and the code that they became."""
    indices = {
        i.name: {"tex": i.tex, "says": i.says, "place": i.place}
        for i in specification.table.indices.values()
    }
    document = {
        "chapters": specification.titles,
        "indices": indices,
        "items": [_item(item, specification, code) for item in specification.items.values()],
    }
    return json.dumps(document, indent=1, ensure_ascii=False) + "\n"


def _item(item: Item, specification: Specification, code: Code) -> dict[str, Any]:
    return {
        "id": item.id,
        "kind": item.kind,
        "title": item.title,
        "file": item.file,
        "line": item.line,
        "hash": specification.hash(item),
        "links": specification.links(item),
        "symbols": list(specification.symbols_in(item)),
        "code": code.get(item.id, []),
        "data": item.data,
    }
