"""The specification as data: items, symbols, and how they hang together.

Serves: generator, docs, traceability. Hides: how hashes are made.
"""

import hashlib
import json
import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

from tamias2d.spec.chapter import Item, Role
from tamias2d.spec.kinds import LINKS
from tamias2d.spec.symbols import SymbolTable

_WORD = re.compile(r"[a-z][a-z0-9_]*")


@dataclass
class Specification:
    """All items of srs/ by id, the symbol table, and the files they came from."""

    items: dict[str, Item]
    table: SymbolTable
    titles: dict[str, str] = field(default_factory=dict)
    roles: list[Role] = field(default_factory=list)

    def of_kind(self, *kinds: str) -> list[Item]:
        """The items of some kinds, in reading order."""
        return [item for item in self.items.values() if item.kind in kinds]

    def links(self, item: Item) -> dict[str, list[str]]:
        """The ids that an item names, by key."""
        return {key: item.data[key] for key in LINKS if item.data.get(key)}

    def linked(self, item: Item) -> tuple[str, ...]:
        """All ids that an item names, each once."""
        return tuple(dict.fromkeys(id for ids in self.links(item).values() for id in ids))

    def symbols_in(self, item: Item) -> tuple[str, ...]:
        """The symbols that an item's formal parts name, each once."""
        return tuple(dict.fromkeys(self._symbol_names(item.data)))

    def _symbol_names(self, value: Any) -> Iterator[str]:
        if isinstance(value, dict):
            for key, inner in value.items():
                if key not in ("says", "because", "by", "found", "now", "source", "unchecked"):
                    yield from self._symbol_names(key)
                    yield from self._symbol_names(inner)
        elif isinstance(value, list):
            for inner in value:
                yield from self._symbol_names(inner)
        else:
            for word in _WORD.findall(value):
                if any(word == name or word.startswith(f"{name}_") for name in self._by_length):
                    yield from (
                        (self.table.resolve(word).symbol.name,) if self._resolves(word) else ()
                    )

    @cached_property
    def _by_length(self) -> list[str]:
        return sorted(self.table.symbols, key=len, reverse=True)

    def _resolves(self, word: str) -> bool:
        from tamias2d.spec.messages import SpecFault

        try:
            self.table.resolve(word)
        except SpecFault:
            return False
        return True

    def closure(self, item: Item) -> list[str]:
        """The item and everything that it uses, directly or not, sorted."""
        seen: set[str] = set()
        todo = [item.id]
        while todo:
            current = todo.pop()
            if current in seen:
                continue
            seen.add(current)
            todo.extend(self.linked(self.items[current]))
        return sorted(seen)

    @cached_property
    def _own_hashes(self) -> dict[str, str]:
        return {id: _digest(self._own(item)) for id, item in self.items.items()}

    def _own(self, item: Item) -> list[Any]:
        symbols = [self.table.symbols[name] for name in self.symbols_in(item)]
        facts = [
            (s.name, s.unit, s.shape, s.range.text) for s in sorted(symbols, key=lambda s: s.name)
        ]
        return [item.kind, item.id, item.data, facts]

    def hash(self, item: Item) -> str:
        """Twelve hex digits that change when the item or anything that it uses changes."""
        return _digest([self._own_hashes[id] for id in self.closure(item)])


def _digest(value: Any) -> str:
    text = json.dumps(value, sort_keys=True, ensure_ascii=True)
    return hashlib.sha256(text.encode()).hexdigest()[:12]
