"""The contacts that last (the active set), and the constraints on bodies that follow from them."""

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
        self._press_joints = False

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
                self._note_jointed(pair, since)
            self._drop(pair)
            if touch.staying:
                self.of[pair] = touch.staying
        self.senses.update(instant.senses)

    def _note_jointed(self, pair: PairOf, since: float) -> None:
        """Note once from when on, s, contacts press joints of which only the states are told."""
        if not self._press_joints and any(self._cores[i].jointed for i in pair):
            self._press_joints = True
            self.notes += (
                f"joints: `reactions` of this run count no contacts that last, as from {since:.15g}"
                " s; those of Simulator(scene).reactions do",
            )

    def constrain(self, bodies: Iterable[int], instant: Instant) -> None:
        """Replace the constraints on bodies by those of an instant."""
        for body in bodies:
            self.constraints[body] = instant.constraints.get(body)

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
