"""Traceability: from a requirement to models, code, cases and their last results, and back.

The verdict of an item is the worst of the cases that name it; that of a demand counts all that
the demand rests on, too, through any number of links, so far as cases name it. So a requirement or
a goal passes only if no case fails that names anything it rests on. Assumptions do not count: what
fails may rest on the same ones.
"""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import asdict, dataclass
from functools import cached_property
from typing import Any

from tamias2d.errors import InputError
from tamias2d.suggestions import suggests
from tamias2d.verify import results
from tamias2d.verify.items import Item, fingerprint, items, label_order, links, meant
from tamias2d.verify.outcome import FAIL, MANUAL, NOT_RUN, PASS, Outcome

STALE = "stale"
"""The specification, or the scene, changed after the last result."""
UNCOVERED = "uncovered"
"""No case checks the item."""
NONE = "not judged"
"""An item that nothing can verify: a change, an erratum."""
WORST_FIRST = (FAIL, STALE, UNCOVERED, NOT_RUN, MANUAL, PASS, NONE)
OPEN = (FAIL, STALE, UNCOVERED, NOT_RUN)
_DEMANDS = ("goal", "requirement")
_UNJUDGED = ("change", "erratum")
_COUNTED = (*("constraint", "model", "definition", "property", "requirement", "scheme", "theory"),)


@dataclass(frozen=True)
class Traced:
    """One item, and what is known about it."""

    id: str
    kind: str
    title: str
    file: str
    line: int
    links: tuple[str, ...]
    """The items that it names."""
    code: tuple[Mapping[str, Any], ...]
    """The functions generated from it: module, function, file and line."""
    cases: tuple[str, ...]
    """Those that name it; where none does, those that rest on it through others."""
    verdict: str

    def as_json(self) -> dict[str, Any]:
        """Return the fields as JSON holds them."""
        return asdict(self) | {"code": [dict(function) for function in self.code]}


@dataclass(frozen=True)
class Neighbourhood:
    """An item, what it rests on, and what depends on it, through any number of links."""

    item: Traced
    rests_on: tuple[Traced, ...]
    depended_on_by: tuple[Traced, ...]


@suggests
def trace(id: str | None = None) -> list[Traced]:
    """Return all items in reading order; with an id, that item and all that hang together with it.

    Raises:
        InputError: the id is unknown.
    """
    graph = Graph(items(), results.read())
    if id is None:
        return [graph.traced(each) for each in graph.items]
    near = neighbourhood(id)
    return [near.item, *near.rests_on, *near.depended_on_by]


def neighbourhood(id: str) -> Neighbourhood:
    """Return an item between what it rests on and what depends on it. Raises: InputError."""
    graph = Graph(items(), results.read())
    if id not in graph.items:
        close = meant(id)
        hint = f"Did you mean '{close}'?" if close else "Without an id all items are listed."
        raise InputError(f"trace: '{id}' is no item of the specification. {hint}")
    return Neighbourhood(
        graph.traced(id),
        tuple(map(graph.traced, graph.reach(id, graph.forward))),
        tuple(map(graph.traced, graph.dependents(id))),
    )


def unrun(id: str) -> list[str]:
    """Return the ids to give to `verify`, so that all cases of an item's verdict were run."""
    return Graph(items(), results.read()).unrun(id)


def never_run() -> bool:
    """Return whether some case was never run."""
    judged = results.read()
    return any(item["kind"] == "case" and id not in judged for id, item in items().items())


def lacking() -> dict[str, str]:
    """Return the cases that could not be run where `verify` was called, and what each needs."""
    return {
        id: outcome.note
        for id, outcomes in results.read().items()
        for outcome in outcomes
        if outcome.verdict == NOT_RUN
    }


def exit_code(rows: Iterable[Traced]) -> int:
    """Return 1 if an item failed, is stale, uncovered or not run, of whatever kind; else 0.

    What only people can judge, and have not yet, is shown but is no fault of the program.
    """
    return int(any(row.verdict in OPEN for row in rows))


def plan_table() -> tuple[list[str], list[tuple[str, str, list[bool]]]]:
    """Return the plan's Table 1, corrected: the columns, and for each case id, title and marks."""
    ids = sorted((id for id in items() if id.startswith("TC")), key=label_order)
    cases = [items()[id] for id in ids]
    named = {item["id"]: [id for id in links(item) if _in_plan(id)] for item in cases}
    columns = [id for id in items() if any(id in ids for ids in named.values())]
    columns.sort(key=lambda id: (("IM", "R", "NFR").index(id.rstrip("0123456789")), id))
    return columns, [
        (item["id"], item["title"], [column in named[item["id"]] for column in columns])
        for item in cases
    ]


def _in_plan(id: str) -> bool:
    return id.rstrip("0123456789") in ("IM", "R", "NFR")


class Graph:
    """The items with their links in both directions, and the last results."""

    def __init__(
        self,
        specification: Mapping[str, Item],
        outcomes: Mapping[str, list[Outcome]],
        fingerprint: Callable[[Item], str] = fingerprint,
    ) -> None:
        self.items = specification
        self.fingerprint = fingerprint
        self.outcomes = outcomes
        self.forward = {id: links(item) for id, item in specification.items()}
        self._verdicts: dict[str, str] = {}

    @cached_property
    def backward(self) -> dict[str, tuple[str, ...]]:
        """The items that name an item."""
        found: dict[str, list[str]] = {id: [] for id in self.items}
        for id, targets in self.forward.items():
            for target in targets:
                found[target].append(id)
        return {id: tuple(sources) for id, sources in found.items()}

    @cached_property
    def _rested_on(self) -> dict[str, tuple[str, ...]]:
        """What an item names, but for what people judge, whose verdict is theirs."""
        judged = (id for id, item in self.items.items() if "judged" in item["data"])
        return self.forward | dict.fromkeys(judged, ())

    @cached_property
    def _named(self) -> frozenset[str]:
        """The items that cases name."""
        return frozenset(id for id in self.items if self._only_cases(self.backward[id]))

    def counted(self, id: str) -> list[str]:
        """Return the items whose verdicts count for an item: for a demand, what it rests on.

        What no case names counts only where a demand uses it itself: its cases are those of others.
        """
        if self.items[id]["kind"] not in _DEMANDS:
            return []
        reached = self.reach(id, self._rested_on)
        demands = (id, *(each for each in reached if self.items[each]["kind"] in _DEMANDS))
        judged = self._named.union(*(self._rested_on[each] for each in demands))
        return [each for each in reached if each in judged and self.items[each]["kind"] in _COUNTED]

    def reach(
        self, id: str, step: Mapping[str, tuple[str, ...]], *, ends: tuple[str, ...] = ()
    ) -> list[str]:
        """Return all items that links lead to, in reading order, without the one to start from.

        From items of the kinds `ends` no links are followed.
        """
        seen = {id}
        todo = [id]
        while todo:
            new = [target for target in step[todo.pop()] if target not in seen]
            seen.update(new)
            todo += [each for each in new if self.items[each]["kind"] not in ends]
        return [each for each in self.items if each in seen and each != id]

    def dependents(self, id: str) -> list[str]:
        """Return what rests on an item. A change or an erratum counts only where it names it."""
        return [
            each
            for each in self.reach(id, self.backward)
            if self.items[each]["kind"] not in _UNJUDGED or id in self.forward[each]
        ]

    def traced(self, id: str) -> Traced:
        """Return an item with its cases and verdict."""
        item = self.items[id]
        return Traced(
            id, item["kind"], item["title"], item["file"], item["line"], self.forward[id],
            tuple(item["code"]), tuple(self.cases(id)), self.verdict(id),
        )  # fmt: skip

    def cases(self, id: str) -> list[str]:
        """Return the cases that name an item, or else rest on it; a case has none but itself."""
        if self.items[id]["kind"] in ("case", *_UNJUDGED):
            return []
        named = self._only_cases(self.backward[id])
        if named or self.items[id]["kind"] in _DEMANDS:
            return named
        return self._only_cases(self.reach(id, self.backward, ends=_DEMANDS))

    def _only_cases(self, ids: Iterable[str]) -> list[str]:
        return sorted((id for id in ids if self.items[id]["kind"] == "case"), key=label_order)

    def verdict(self, id: str) -> str:
        """Return the worst verdict of an item's cases; a demand takes those of what it rests on."""
        if id not in self._verdicts:
            self._verdicts[id] = UNCOVERED  # ends a circle of links
            self._verdicts[id] = self._rolled_up(self.items[id])
        return self._verdicts[id]

    def unrun(self, id: str) -> list[str]:
        """Return the items to verify before a verdict is known: the item, or what it rests on.

        The item comes first, then those with most cases; none whose open cases all belong to ones
        before it.
        """
        open_ = {each: self._open_cases(each) for each in self.counted(id)}
        found: list[str] = []
        covered: set[str] = set()
        for each in (id, *sorted(open_, key=lambda each: -len(open_[each]))):
            missing = self._open_cases(each) - covered
            found += [each] if missing else []
            covered |= missing
        return found

    def _open_cases(self, id: str) -> set[str]:
        cases = [id] if self.items[id]["kind"] == "case" else self.cases(id)
        return {case for case in cases if not self.outcomes.get(case)}

    def _rolled_up(self, item: Item) -> str:
        id, kind = item["id"], item["kind"]
        if kind in _UNJUDGED:
            return NONE
        if kind == "case":
            return self._of_case(item)
        verdicts = [self.verdict(case) for case in self.cases(id)]
        if "judged" in item["data"]:
            return worst([MANUAL, *verdicts])
        if kind == "requirement" and not verdicts:
            return UNCOVERED
        return worst([*verdicts, *(self.verdict(each) for each in self.counted(id))])

    def _of_case(self, item: Item) -> str:
        outcomes = self.outcomes.get(item["id"], [])
        if not outcomes:
            return NOT_RUN
        if any(outcome.hash != self.fingerprint(item) for outcome in outcomes):
            return STALE
        return worst(outcome.verdict for outcome in outcomes)


def worst(verdicts: Iterable[str]) -> str:
    """Return the worst of some verdicts; uncovered if there is none."""
    return min(verdicts, key=WORST_FIRST.index, default=UNCOVERED)
