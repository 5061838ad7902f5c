"""All impacts and lasting contacts at one instant.

In this order: find all touching pairs; resolve the impacts of those that approach (IM3), unless
impacts act on each other; keep the contacts that neither approach nor separate (GD3).
"""

import math
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

from tamias2d.contact.constrained_acceleration import opening_acceleration
from tamias2d.contact.core import Core, Placed, place
from tamias2d.contact.frictional_impact import after_frictional_impulse, frictional_impulses
from tamias2d.contact.frictional_rest import LASTING_NOISE, PairFriction, island_of
from tamias2d.contact.gap import EPSILON, axes, either_side, resolution, slight_opening
from tamias2d.contact.jointed_impact import (
    Struck,
    change_by_unit,
    changed,
    impulses as jointed_impulses,
)
from tamias2d.contact.lasting_contact import Island
from tamias2d.contact.manifold import (
    Contact,
    corner_on_corner_error,
    manifold,
    normal_velocity,
    speed_scale,
    tangent_of,
)
from tamias2d.contact.refusal import (
    JointedContactError,
    RangeError,
    SimultaneousImpactsError,
    UndecidedContactError,
    named,
)
from tamias2d.contact.response import after_impulse, coupling, impulses
from tamias2d.contact.terrain import is_behind, normals
from tamias2d.generated import impact, rest
from tamias2d.state import Acceleration, Constraint, State, Vector

PairOf = tuple[int, int]

_MAX_RESOLUTION = 0.01  # of the smaller size: the largest gap that may count as none
_MAX_IMPULSES = (
    10_000  # impulses of one pair at one instant; their speeds fall as a geometric series
)


class InstantInputs(NamedTuple):
    """The state of the simulation that an instant reads."""

    cores: Sequence[Core]
    state: Callable[[int], State]
    """Of a body, now."""
    overlapping: Callable[[int], Iterable[int]]
    """The bodies whose bounding boxes overlap with that of a body."""
    free: Callable[[int, Callable[[int], State]], Acceleration]
    """The acceleration of an unconstrained body, now, for given states."""
    struck: Struck
    """What impulses on jointed bodies change, now."""
    lasting: Mapping[PairOf, Sequence[Contact]]
    """The contacts that have lasted until now."""
    sticking: Collection[PairOf]
    """The pairs of these that stick."""
    separating_direction: Mapping[PairOf, Vector]
    """The directions in which pairs were last apart."""
    restitution: Callable[[int, int], float]
    friction: Callable[[int, int], float]
    until: float
    """When the run ends, s."""


class ContactImpulse(NamedTuple):
    """One impulse at a contact."""

    contact: Contact
    impulse: float
    normal_velocity: float


@dataclass
class TouchingPair:
    """A touching pair."""

    pair: PairOf
    contacts: list[Contact]
    tolerance: float
    """The largest gap that counts as 0, m."""
    speed: float
    """The size of the terms that make up its velocities, m/s."""
    noise: float
    """The largest normal velocity that counts as 0, m/s."""
    staying: list[Contact] = field(default_factory=list)
    rest_at: float = 0.0
    """When its bounces end if they go on as a geometric series of times, s; 0 if they do not."""
    rest_noise: float = 0.0
    """The error of `rest_at` by rounding, s."""


class Instant:
    """One instant: its impulses, and the states and constraints of the bodies after it."""

    def __init__(self, time: float, world: InstantInputs, bodies: Sequence[int]) -> None:
        self.time = time
        self._world = world
        self._placed: dict[int, Placed] = {}
        self.states: dict[int, State] = {}
        """Of the bodies that were examined, after the instant."""
        self.touching_pairs: dict[PairOf, TouchingPair] = {}
        self.contact_impulses: list[ContactImpulse] = []
        self.changed: set[int] = set()
        self.constraints: dict[int, Constraint] = {}
        self.senses: dict[PairOf, int] = {}
        """Of lasting pairs with friction: 0 if they stick, else the sense in which they slide."""
        self.separating: dict[PairOf, float] = {}
        """Pairs that separate without normal velocity, with the second derivative of the gap."""
        self._find_touching(bodies)
        self._resolve_impacts()
        self._keep_lasting()

    def state(self, body: int) -> State:
        """Return the state of a body after the instant, as far as it is known."""
        return self.states[body] if body in self.states else self._world.state(body)

    def _find_touching(self, bodies: Sequence[int]) -> None:
        todo = self._with_mechanisms(bodies)
        seen = set(todo)
        for body in todo:  # grows while it is gone through
            self._place(body)
            for other in self._world.overlapping(body):
                pair = (min(body, other), max(body, other))
                if pair in self.touching_pairs or not (touch := self._touch(pair)):
                    continue
                self.touching_pairs[pair] = touch
                for i in self._with_mechanisms(pair):
                    if i not in seen and self._world.cores[i].dynamic:
                        seen.add(i)
                        todo.append(i)

    def _refuse_jointed(self, contacts: Iterable[Contact], what: str) -> None:
        """Refuse contacts of bodies that a joint holds, which are not within the models."""
        for contact in contacts:
            jointed = [i for i in (contact.a, contact.b) if self._world.cores[i].jointed]
            if jointed:
                name = self._world.cores[jointed[0]].name
                touch = self.touching_pairs[contact.a, contact.b]
                raise JointedContactError(
                    f"{self._names(touch)} at {self.time!r} s: {what}, and a joint holds "
                    f"'{name}': that is not solved yet (R13). End the run before, move one away, "
                    "or let them pass through each other: give them one negative group, or no "
                    "shape.",
                    time=self.time,
                )

    def _with_mechanisms(self, bodies: Iterable[int]) -> list[int]:
        """Return bodies, and those that joints tie to them, which an impulse reaches too."""
        cores = self._world.cores
        found = dict.fromkeys(bodies)
        for body in list(found):
            found |= dict.fromkeys(sorted(cores[body].group) if cores[body].jointed else ())
        return list(found)

    def _place(self, body: int) -> Placed:
        if body not in self._placed:
            self.states[body] = self._world.state(body)
            self._placed[body] = place(self._world.cores[body], self.states[body])
        return self._placed[body]

    def _touch(self, pair: PairOf) -> TouchingPair | None:
        a, b = (self._place(i) for i in pair)
        tolerance = resolution(a, b, self.time)
        lasting = self._world.lasting.get(pair, ())
        if not lasting and (_far(a, b, tolerance) or not _touch(a, b, tolerance)):
            return None
        self._refuse_far(a, b, tolerance)
        separating_direction = self._world.separating_direction.get(
            pair
        ) or self._pressed_direction(a, b, tolerance)
        contacts = manifold(a, b, tolerance, self.time, lasting, separating_direction)
        self._refuse_behind(a, b, contacts)
        speed = max(speed_scale(contact, a.state, b.state) for contact in contacts)
        noise = speed * (LASTING_NOISE if lasting else 64 * EPSILON)
        return TouchingPair(pair, contacts, tolerance, speed, noise)

    def _refuse_far(self, a: Placed, b: Placed, tolerance: float) -> None:
        """Refuse a contact where positions in float64 are coarse beside the size of a body."""
        size = min(a.core.bounding_radius, b.core.bounding_radius)
        if tolerance > _MAX_RESOLUTION * size:
            raise RangeError(
                f"{named(a.core.name, b.core.name)} at {self.time!r} s: where they are, float64 "
                f"tells places no nearer than {tolerance:.3g} m, and the smaller one is {size:.3g} "
                "m large (R4). Place the scene nearer to the origin.",
                time=self.time,
            )

    def _refuse_behind(self, a: Placed, b: Placed, contacts: Sequence[Contact]) -> None:
        """Refuse a body that comes to a chain from the side on which that is not solid."""
        if any(is_behind(a, b, contact.normal) for contact in contacts):
            raise UndecidedContactError(
                f"{named(a.core.name, b.core.name)} at {self.time!r} s: the chain is solid from "
                "one side, and is passed from the other, which located contacts do not cover "
                "(A16). Take method=Stepped(), or none.",
                time=self.time,
            )

    def _pressed_direction(self, a: Placed, b: Placed, tolerance: float) -> Vector | None:
        """Return the direction from A to B in which a thin pair lies of which no gap tells it.

        It is the one against which they move or, if they do not, accelerate: bodies are solid.
        """
        if (thin := either_side(axes(a, b), tolerance)) is None:
            return None
        still, centre = 0.0, (0.0, 0.0)
        v_a, v_b = a.state.velocity, b.state.velocity
        rate = impact.normal_velocity(v_a, still, centre, v_b, still, centre, thin)
        (by_a, by_b), (ux, uy) = (self._pull(a), self._pull(b)), thin
        acceleration = rest.normal_acceleration(by_a, still, centre, by_b, still, centre, thin)
        return (-ux, -uy) if (rate or acceleration) > 0 else thin

    def _pull(self, body: Placed) -> Vector:
        """Return the acceleration of a body without contacts, m/s^2."""
        if not body.core.dynamic:
            return 0.0, 0.0
        return self._world.free(body.core.index, self._world.state)[:2]

    def _slide_noise(self, contact: Contact) -> float:
        pair = contact.a, contact.b
        share = LASTING_NOISE if pair in self._world.sticking else 64 * EPSILON
        return self.touching_pairs[pair].speed * share

    def _approaches(self, touch: TouchingPair) -> bool:
        return any(self._rate(contact) < -touch.noise for contact in touch.contacts)

    def _rate(self, contact: Contact) -> float:
        return normal_velocity(contact, self.states[contact.a], self.states[contact.b])

    def _resolve_impacts(self) -> None:
        approaching = [touch for touch in self.touching_pairs.values() if self._approaches(touch)]
        self._refuse_coupled(approaching)
        for touch in approaching:
            count = 0
            while self._approaches(touch):
                self._resolve_pair(touch)
                if (count := count + 1) > _MAX_IMPULSES:
                    raise UndecidedContactError(
                        f"{self._names(touch)} at {self.time!r} s: their corners meet in turn "
                        "without end (IM3). End the run before, or change the scene a little.",
                        time=self.time,
                    )
            reached = self._with_mechanisms(touch.pair)
            self.changed.update(i for i in reached if self._world.cores[i].dynamic)
        self._refuse_driven_together(approaching)

    def _resolve_pair(self, touch: TouchingPair) -> None:
        """Resolve together the contacts that do not separate yet.

        A separating one is left out: if the others drive it together, it is resolved in turn.
        """
        cores, states, (a, b) = self._world.cores, self.states, touch.pair
        approaching = [contact for contact in touch.contacts if self._rate(contact) <= touch.noise]
        restitution = self._world.restitution(a, b)
        if cores[a].jointed or cores[b].jointed:
            self._resolve_jointed_pair(touch.pair, approaching, restitution)
            return
        if coefficient := self._world.friction(a, b):
            self._resolve_frictional_pair(touch.pair, approaching, restitution, coefficient)
            return
        found = impulses(cores, approaching, states[a], states[b], restitution)
        contact_impulses = [
            ContactImpulse(contact, impulse, self._rate(contact))
            for contact, impulse in zip(approaching, found, strict=True)
            if impulse > 0
        ]
        for impulse in contact_impulses:
            states[a], states[b] = after_impulse(
                cores, impulse.contact, impulse.impulse, states[a], states[b]
            )
        self.contact_impulses += contact_impulses

    def _resolve_jointed_pair(
        self, pair: PairOf, approaching: Sequence[Contact], restitution: float
    ) -> None:
        """Resolve the contacts of a pair together with the joints that hold it (GD20)."""
        if self._world.friction(*pair):
            self._refuse_jointed(approaching, "they meet with friction")
        cores, states = self._world.cores, self.states
        changes = [change_by_unit(cores, contact, self._world.struck) for contact in approaching]
        found = jointed_impulses(approaching, changes, states.__getitem__, restitution)
        self.contact_impulses += [
            ContactImpulse(contact, impulse, self._rate(contact))
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
        cores, states, (a, b) = self._world.cores, self.states, pair
        found = frictional_impulses(
            cores, approaching, states[a], states[b], restitution, coefficient
        )
        found_pairs = [
            (ContactImpulse(contact, both[0], self._rate(contact)), both)
            for contact, both in zip(approaching, found, strict=True)
            if both[0] > 0
        ]
        for impulse, both in found_pairs:
            states[a], states[b] = after_frictional_impulse(
                cores, impulse.contact, both, states[a], states[b]
            )
        self.contact_impulses += [impulse for impulse, _ in found_pairs]

    def _refuse_coupled(self, approaching: Sequence[TouchingPair]) -> None:
        for k, first in enumerate(approaching):
            for second in approaching[k + 1 :]:
                if self._joined(first, second):
                    self._refuse(first, second, "meet")
                directions = self._impulse_directions(first), self._impulse_directions(second)
                if any(
                    self._coupled(one, other) for one in directions[0] for other in directions[1]
                ):
                    self._refuse(first, second, "meet")

    def _joined(self, first: TouchingPair, second: TouchingPair) -> bool:
        """Whether joints carry an impulse from one pair to another."""
        cores = self._world.cores
        return any(
            cores[i].jointed and j in cores[i].group for i in first.pair for j in second.pair
        )

    def _impulse_directions(self, touch: TouchingPair) -> list[Contact]:
        """Return the contacts of a pair, once for each direction of their impulses."""
        frictional = self._world.friction(*touch.pair) > 0
        return touch.contacts + [tangent_of(contact) for contact in touch.contacts if frictional]

    def _coupled(self, first: Contact, second: Contact) -> bool:
        cores = self._world.cores
        both = coupling(cores, first, second)
        own = coupling(cores, first, first) * coupling(cores, second, second)
        return both * both > 1e-24 * own

    def _refuse_driven_together(self, approaching: Sequence[TouchingPair]) -> None:
        """Refuse impacts that drive a touching pair into another impact."""
        for touch in self.touching_pairs.values():
            if approaching and self._approaches(touch):
                by = next((m for m in approaching if set(m.pair) & set(touch.pair)), approaching[0])
                self._refuse(by, touch, "drive together")

    def _refuse(self, first: TouchingPair, second: TouchingPair, what: str) -> None:
        one, other = self._names(first), self._names(second)
        raise SimultaneousImpactsError(
            f"{one} {what} {other} at {self.time!r} s: impacts at one instant act on each other, "
            "and rigid bodies leave open what follows (IM3). Put a small gap between them.",
            time=self.time,
        )

    def _names(self, touch: TouchingPair) -> str:
        return named(*(self._world.cores[i].name for i in touch.pair))

    def _keep_lasting(self) -> None:
        """Keep contacts that neither approach nor separate, or bounce below resolution."""
        staying = [
            contact
            for touch in self.touching_pairs.values()
            for contact in touch.contacts
            if abs(self._rate(contact)) <= touch.noise
        ]
        self._refuse_jointed(staying, "they stay in contact")
        self._refuse_corners(staying)
        islands = self._islands(staying)
        while low := self._unresolved_bounces(islands, staying):
            self._refuse_jointed(low, "they come to rest on each other")
            staying += low
            islands = self._islands(staying)
        lasting = [contact for island in islands for contact in island.lasting]
        self._note_separating(islands, [contact for contact in staying if contact not in lasting])
        for contact in lasting:
            self.touching_pairs[contact.a, contact.b].staying.append(contact)
        for island in islands:
            if island.lasting:
                self._constrain(island)
        constrained = {
            i for pair in self.touching_pairs if pair in self._world.lasting for i in pair
        }
        self.changed |= {i for i in constrained if self._world.cores[i].dynamic}

    def _refuse_corners(self, staying: Sequence[Contact]) -> None:
        for contact in staying:
            a, b = (self._world.cores[i] for i in (contact.a, contact.b))
            sharp = not (a.radius or b.radius) and len(a.corners) > 1 and len(b.corners) > 1
            if sharp and contact.axis.side is None:
                raise corner_on_corner_error(a, b, self.time)

    def _islands(self, contacts: Sequence[Contact]) -> list[Island]:
        """Return the islands that contacts make."""
        cores = self._world.cores
        groups: list[tuple[set[int], list[Contact]]] = []
        for contact in contacts:
            bodies = {i for i in (contact.a, contact.b) if cores[i].dynamic}
            joined = [contact]
            for group in [group for group in groups if group[0] & bodies]:
                groups.remove(group)
                bodies |= group[0]
                joined = group[1] + joined
            groups.append((bodies, joined))
        placed = {i: body._replace(state=self.states[i]) for i, body in self._placed.items()}
        slight = [
            slight_opening(placed[contact.a], placed[contact.b], self.time, self._world.until)
            for contact in contacts
        ]
        pair_friction = PairFriction(self.time, self._world.friction, self._slide_noise)
        return [
            island_of(
                cores,
                placed,
                joined,
                {i: self._free(i) for i in sorted(bodies)},
                min(slight),
                pair_friction,
            )
            for bodies, joined in groups
        ]

    def _free(self, body: int) -> Acceleration:
        return self._world.free(body, self.state)

    def _accelerations(self, islands: Sequence[Island]) -> dict[int, Acceleration]:
        free = {i: self._free(i) for i in self.states if self._world.cores[i].dynamic}
        for island in islands:
            free.update(island.accelerations)
        return free

    def _unresolved_bounces(
        self, islands: Sequence[Island], staying: Sequence[Contact]
    ) -> list[Contact]:
        """Return the contacts whose next bounce is lower than the largest gap that counts as 0."""
        by = self._accelerations(islands)
        placed = {i: body._replace(state=self.states[i]) for i, body in self._placed.items()}
        found = []
        for touch in self.touching_pairs.values():
            for contact in touch.contacts:
                if contact in staying:
                    continue
                acceleration = opening_acceleration(contact, placed, by)
                rate = self._rate(contact)
                if acceleration < 0:
                    self._forecast(touch, rate, acceleration)
                    if rest.bounce_height(rate, acceleration) <= touch.tolerance:
                        found.append(contact)
        return found

    def _forecast(self, touch: TouchingPair, rate: float, acceleration: float) -> None:
        restitution = self._world.restitution(*touch.pair)
        if acceleration * (1 - restitution) < 0:  # it may vanish by rounding
            rest_at = self.time + float(rest.time_to_rest(rate, acceleration, restitution))
            if rest_at > touch.rest_at:
                touch.rest_at = rest_at
                touch.rest_noise = touch.tolerance / rate / (1 - restitution)

    def _note_separating(self, islands: Sequence[Island], contacts: Sequence[Contact]) -> None:
        by = self._accelerations(islands)
        placed = {i: body._replace(state=self.states[i]) for i, body in self._placed.items()}
        for contact in contacts:
            self.separating[contact.a, contact.b] = opening_acceleration(contact, placed, by)

    def _constrain(self, island: Island) -> None:
        self.states.update(island.projected(self.states))
        self.constraints.update(island.constraints(self.states, self.time))
        self.senses.update(island.senses)
        self.changed.update(island.bodies)


def _touch(a: Placed, b: Placed, tolerance: float) -> bool:
    found = axes(a, b)
    return max(axis.gap for axis in found) <= tolerance and bool(normals(a, b, found))


def _far(a: Placed, b: Placed, tolerance: float) -> bool:
    (ax, ay), (bx, by) = a.state.position, b.state.position
    reach = a.core.bounding_radius + b.core.bounding_radius
    return math.hypot(bx - ax, by - ay) > reach + tolerance
