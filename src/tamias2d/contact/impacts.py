"""The impulses of one instant: pair by pair, and in rounds where they act on one another (A18)."""

from collections.abc import Collection, Mapping, Sequence

from tamias2d.contact.frictional_impact import after_frictional_impulse, frictional_impulses
from tamias2d.contact.inelastic_impact import closing_impulses
from tamias2d.contact.instant_inputs import InstantInputs
from tamias2d.contact.jointed_impact import change_by_unit, changed, impulses as jointed_impulses
from tamias2d.contact.manifold import Contact, normal_velocity, tangent_of
from tamias2d.contact.mobility import with_mechanisms
from tamias2d.contact.modes import Patch
from tamias2d.contact.refusal import UndecidedContactError, named
from tamias2d.contact.response import after_impulse, coupling, impulses
from tamias2d.contact.simultaneous_impact import Meeting, apply, simultaneous_impulses
from tamias2d.contact.touching import ContactImpulse, PairOf, TouchingPair
from tamias2d.state import State

_MAX_IMPULSES = (
    10_000  # impulses of one pair at one instant; their speeds fall as a geometric series
)
_MAX_ROUNDS = 1000
_LEFT = 1e-9
"""Of the first approach: what is left of it when rounds end."""


class Impacts:
    """The impulses of all pairs that approach at one instant; it changes the states of bodies."""

    def __init__(
        self,
        time: float,
        world: InstantInputs,
        states: dict[int, State],
        touching_pairs: Mapping[PairOf, TouchingPair],
    ) -> None:
        self._time = time
        self._world = world
        self._states = states
        self._touching = touching_pairs
        self.impulses: list[ContactImpulse] = []
        self.changed: set[int] = set()
        """Bodies whose velocities have changed."""
        self.ruled: set[int] = set()
        """Bodies whose impacts acted on one another, so that a rule decided what follows (A18)."""

    def resolve(self) -> None:
        """Answer all impacts of the instant.

        Raises:
            UndecidedContactError: the corners of a pair meet in turn without end.
        """
        approaching = self._approaching()
        self._answer(approaching)
        if not (again := self._approaching()):
            return
        quieten(self._touching.values())
        self.ruled |= {i for touch in approaching for i in self._moving(touch)}
        limit = _LEFT * max((-one.normal_velocity for one in self.impulses), default=0.0)
        for _ in range(_MAX_ROUNDS):
            again = self._approaching()
            self.ruled |= {i for touch in again for i in self._moving(touch)}
            if all(self.rate(c) >= -limit for touch in again for c in touch.striking):
                break
            self._answer(again)
        if again:
            self._close()

    def rate(self, contact: Contact) -> float:
        """Return the normal velocity of a contact now, m/s."""
        return normal_velocity(contact, self._states[contact.a], self._states[contact.b])

    def _approaching(self) -> list[TouchingPair]:
        return [touch for touch in self._touching.values() if self._approaches(touch)]

    def _approaches(self, touch: TouchingPair) -> bool:
        return any(self.rate(contact) < -touch.noise for contact in touch.striking)

    def _answer(self, approaching: Sequence[TouchingPair]) -> None:
        """Let the pairs that approach answer: together those that act on each other."""
        for group in self._coupled_groups(approaching):
            if len(group) == 1:
                self._resolve_alone(group[0])
            else:
                self._resolve_together(group)
            self.changed |= {i for touch in group for i in self._moving(touch)}

    def _moving(self, touch: TouchingPair) -> list[int]:
        reached = with_mechanisms(self._world.cores, touch.pair)
        return [i for i in reached if self._world.cores[i].dynamic]

    def _coupled_groups(self, approaching: Sequence[TouchingPair]) -> list[list[TouchingPair]]:
        groups: list[list[TouchingPair]] = []
        for touch in approaching:
            near = [group for group in groups if any(self._act(touch, other) for other in group)]
            for group in near:
                groups.remove(group)
            groups.append([*(one for group in near for one in group), touch])
        return groups

    def _act(self, first: TouchingPair, second: TouchingPair) -> bool:
        """Whether an impulse of one pair changes the normal velocity of the other."""
        if self._joined(first, second):
            return True
        if not set(first.pair) & set(second.pair):
            return False
        others = self._impulse_directions(second)
        return any(
            self._coupled(one, other) for one in self._impulse_directions(first) for other in others
        )

    def _joined(self, first: TouchingPair, second: TouchingPair) -> bool:
        """Whether joints carry an impulse from one pair to another."""
        cores = self._world.cores
        return any(
            cores[i].jointed and j in cores[i].group for i in first.pair for j in second.pair
        )

    def _impulse_directions(self, touch: TouchingPair) -> list[Contact]:
        """Return the contacts of a pair, once for each direction of their impulses."""
        frictional = self._world.friction(*touch.pair) > 0
        return touch.striking + [tangent_of(contact) for contact in touch.striking if frictional]

    def _coupled(self, first: Contact, second: Contact) -> bool:
        cores = self._world.cores
        both = coupling(cores, first, second)
        own = coupling(cores, first, first) * coupling(cores, second, second)
        return both * both > 1e-24 * own

    def _resolve_alone(self, touch: TouchingPair) -> None:
        count = 0
        while self._approaches(touch):
            self._resolve_pair(touch)
            if (count := count + 1) > _MAX_IMPULSES:
                raise UndecidedContactError(
                    f"{self._names(touch)} at {self._time!r} s: their corners meet in turn "
                    "without end (IM3). End the run before, or change the scene a little.",
                    time=self._time,
                )

    def _resolve_together(self, group: Sequence[TouchingPair]) -> None:
        """Answer the contacts of several pairs that approach at the same time (DD67, DD68)."""
        self.ruled |= {i for touch in group for i in self._moving(touch)}
        meetings = [
            Meeting(
                [contact for contact in touch.striking if self.rate(contact) <= touch.noise],
                self._world.restitution(*touch.pair),
                self._world.friction(*touch.pair),
            )
            for touch in group
        ]
        self._push(simultaneous_impulses(self._world.mobility, meetings, self._states))

    def _close(self) -> None:
        """Take what is left of all approach, without restitution (DD68)."""
        patches = [
            Patch(tuple(touch.striking), self._world.friction(*touch.pair), 0)
            for touch in self._touching.values()
            if touch.striking
        ]
        self._push(closing_impulses(self._world.mobility, patches, self._states))

    def _push(self, found: Sequence[tuple[Contact, float, float]]) -> None:
        self.impulses += [
            ContactImpulse(contact, impulse, self.rate(contact))
            for contact, impulse, _ in found
            if impulse > 0
        ]
        apply(self._world.mobility, found, self._states)
        pushed = {i for contact, impulse, _ in found if impulse > 0 for i in (contact.a, contact.b)}
        self.changed |= {i for i in pushed if self._world.cores[i].dynamic}

    def _resolve_pair(self, touch: TouchingPair) -> None:
        """Resolve together the contacts that do not separate yet.

        A separating one is left out: if the others drive it together, it is resolved in turn.
        """
        cores, states, (a, b) = self._world.cores, self._states, touch.pair
        approaching = [contact for contact in touch.striking if self.rate(contact) <= touch.noise]
        restitution = self._world.restitution(a, b)
        if cores[a].jointed or cores[b].jointed:
            self._resolve_jointed_pair(touch, approaching, restitution)
            return
        if coefficient := self._world.friction(a, b):
            self._resolve_frictional_pair(touch.pair, approaching, restitution, coefficient)
            return
        found = impulses(cores, approaching, states[a], states[b], restitution)
        contact_impulses = [
            ContactImpulse(contact, impulse, self.rate(contact))
            for contact, impulse in zip(approaching, found, strict=True)
            if impulse > 0
        ]
        for impulse in contact_impulses:
            states[a], states[b] = after_impulse(
                cores, impulse.contact, impulse.impulse, states[a], states[b]
            )
        self.impulses += contact_impulses

    def _resolve_jointed_pair(
        self, touch: TouchingPair, approaching: Sequence[Contact], restitution: float
    ) -> None:
        """Resolve the contacts of a pair together with the joints that hold it (GD20).

        Without friction a limit that holds answers as it may: it is pressed, or left.
        """
        cores, states = self._world.cores, self._states
        coefficient = self._world.friction(*touch.pair)
        if coefficient:
            meeting = Meeting(approaching, restitution, coefficient)
            self._push(simultaneous_impulses(self._world.mobility, [meeting], states))
            return
        changes = [change_by_unit(cores, contact, self._world.struck) for contact in approaching]
        found = jointed_impulses(approaching, changes, states.__getitem__, restitution)
        self.impulses += [
            ContactImpulse(contact, impulse, self.rate(contact))
            for contact, impulse in zip(approaching, found, strict=True)
            if impulse > 0
        ]
        for change, impulse in zip(changes, found, strict=True):
            for body, by_unit in change.items():
                states[body] = changed(states[body], by_unit, impulse)

    def _resolve_frictional_pair(
        self, pair: PairOf, approaching: Sequence[Contact], restitution: float, coefficient: float
    ) -> None:
        """Resolve the contacts of a pair with friction (IM9)."""
        cores, states, (a, b) = self._world.cores, self._states, pair
        found = frictional_impulses(
            cores, approaching, states[a], states[b], restitution, coefficient
        )
        found_pairs = [
            (ContactImpulse(contact, both[0], self.rate(contact)), both)
            for contact, both in zip(approaching, found, strict=True)
            if both[0] > 0
        ]
        for impulse, both in found_pairs:
            states[a], states[b] = after_frictional_impulse(
                cores, impulse.contact, both, states[a], states[b]
            )
        self.impulses += [impulse for impulse, _ in found_pairs]

    def _names(self, touch: TouchingPair) -> str:
        return named(*(self._world.cores[i].name for i in touch.pair))


def quieten(touching: Collection[TouchingPair]) -> None:
    """Take rounding for what it is at the speeds of all bodies that push each other."""
    loudest = max(touch.speed for touch in touching)
    for touch in touching:
        touch.speed = loudest
        touch.noise = max(touch.noise, touch.rounding * loudest)
