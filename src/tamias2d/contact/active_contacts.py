"""The contacts that last (the active set), and the constraints on bodies that follow from them."""

from bisect import bisect_right
from collections.abc import Collection, Iterable, Sequence

from tamias2d.contact.core import Core
from tamias2d.contact.instant import Instant
from tamias2d.contact.manifold import Contact
from tamias2d.contact.refusal import named
from tamias2d.contact.rest_time import RestTimes
from tamias2d.contact.touching import PairOf
from tamias2d.state import Constraint


class ActiveContacts:
    """The contacts of a run that last now."""

    def __init__(self, cores: Sequence[Core]) -> None:
        self._cores = cores
        self.of: dict[PairOf, list[Contact]] = {}
        """Of each pair that has some."""
        self.senses: dict[PairOf, int] = {}
        """Of pairs with friction: 0 if they stick, else the sense in which they slide."""
        self.constraints: list[Constraint | None] = [None for _ in cores]
        """Of each body."""
        self.rest_times = RestTimes()
        self.notes: tuple[str, ...] = ()
        """Which bodies came to rest on which."""
        self._since: list[list[tuple[float, Constraint | None]]] = [[] for _ in cores]
        self.on_joints = False
        """Whether contacts have lasted of what joints hold."""

    def update(self, instant: Instant) -> None:
        """Replace contacts by those of an instant, and note the new ones."""
        self.rest_times.update(instant)
        before = {self._named(pair) for pair in self.of}
        for pair in instant.parted:
            self._drop(pair)
        for pair, touch in instant.touching_pairs.items():
            names = self._named(pair)
            if touch.staying and names not in before:
                before.add(names)  # a chain may have more pieces that it touches
                since = self.rest_times.time_of(pair, instant)
                self.notes += (f"rest: {names} stay in contact from {since:.15g} s",)
                self.on_joints |= any(self._cores[i].jointed for i in pair)
            self._drop(pair)
            if touch.staying:
                self.of[pair] = touch.staying
        self.senses.update(instant.senses)

    def constrain(self, bodies: Iterable[int], instant: Instant) -> None:
        """Replace the constraints on bodies by those of an instant."""
        for body in bodies:
            self.constraints[body] = instant.constraints.get(body)
            self._since[body].append((instant.time, self.constraints[body]))

    def constraint_at(self, body: int, time: float) -> Constraint | None:
        """Return the constraint that a body had at a time, s; at an instant the one after it."""
        since = self._since[body]
        k = bisect_right(since, time, key=lambda entry: entry[0])
        return since[k - 1][1] if k else None

    def on(self, bodies: Collection[int]) -> list[Contact]:
        """Return the contacts of all pairs with one of the bodies."""
        return [c for pair, own in self.of.items() if not set(bodies).isdisjoint(pair) for c in own]

    @property
    def sticking(self) -> list[PairOf]:
        """The pairs that stick."""
        return [pair for pair, sense in self.senses.items() if not sense]

    @property
    def supports(self) -> dict[int, int]:
        """On which body that stands still others rest."""
        return {
            i: j
            for pair in self.of
            for i, j in (pair, pair[::-1])
            if self._cores[i].dynamic and not self._cores[j].dynamic
        }

    def are_simple(self) -> bool:
        """Whether they are of single bodies, each on one that stands still."""
        held = [i for pair in self.of for i in pair if self._cores[i].dynamic]
        single = len(held) == len(self.of) == len(set(held))
        return single and not any(self.state_dependent(pair) for pair in self.of)

    def state_dependent(self, pair: PairOf) -> bool:
        """Whether a constraint on one of a pair depends on its state."""
        return any((each := self.constraints[i]) and each.state_dependent for i in pair)

    def _drop(self, pair: PairOf) -> None:
        self.of.pop(pair, None)
        self.senses.pop(pair, None)

    def _named(self, pair: PairOf) -> str:
        return named(*(self._cores[i].name for i in pair))
