"""All impacts and lasting contacts at one instant.

In this order: find all touching pairs; answer the impacts of those that approach (`Impacts`); keep
the contacts that neither approach nor separate (GD3).
"""

import math
from collections.abc import Sequence

from tamias2d.contact.constrained_acceleration import opening_acceleration
from tamias2d.contact.core import Core, Placed, place
from tamias2d.contact.frictional_rest import island_of
from tamias2d.contact.gap import axes, either_side, resolution, slight_opening
from tamias2d.contact.impacts import Impacts, quieten
from tamias2d.contact.inelastic_impact import JammedError, jam_impulses, without_rates
from tamias2d.contact.instant_inputs import InstantInputs
from tamias2d.contact.lasting_contact import Island
from tamias2d.contact.manifold import (
    LASTING_NOISE,
    Contact,
    corner_on_corner_error,
    manifold,
    normal_velocity,
    speed_scale,
    tangent_of,
    tangential_velocity,
)
from tamias2d.contact.mobility import with_mechanisms
from tamias2d.contact.one_surface import strike_as_one
from tamias2d.contact.pair_friction import PairFriction
from tamias2d.contact.refusal import LastingContactError, RangeError, UndecidedContactError, named
from tamias2d.contact.simultaneous_impact import apply
from tamias2d.contact.terrain import is_behind, normals
from tamias2d.contact.touching import ContactImpulse, PairOf, TouchingPair
from tamias2d.float64 import EPSILON
from tamias2d.generated import definitions, impact, rest
from tamias2d.state import Acceleration, Constraint, State, Vector

_MAX_RESOLUTION = 0.01  # of the smaller size: the largest gap that may count as none
_MAX_JAMS = 8  # of one instant, one after another
_GAIN = 1e-9  # of the kinetic energy: more than rounding adds


class Instant:
    """One instant: its impulses, and the states and constraints of the bodies after it."""

    def __init__(self, time: float, world: InstantInputs, bodies: Sequence[int]) -> None:
        self.time = time
        self._world = world
        self._placed: dict[int, Placed] = {}
        self.states: dict[int, State] = {}
        """Of the bodies that were examined, after the instant."""
        self.touching_pairs: dict[PairOf, TouchingPair] = {}
        self.changed: set[int] = set()
        self.parted: list[PairOf] = []
        """Pairs in lasting contact until now whose corners part."""
        self.constraints: dict[int, Constraint] = {}
        self.senses: dict[PairOf, int] = {}
        """Of lasting pairs with friction: 0 if they stick, else the sense in which they slide."""
        self.separating: dict[PairOf, float] = {}
        """Pairs that separate without normal velocity, with the second derivative of the gap."""
        self._stopped: set[PairOf] = set()  # of which an impulse has ended the sliding
        self._bouncing: list[Contact] = []  # whose bounces are low, and go on
        self._find_touching(bodies)
        if world.again:
            self._hush()
        strike_as_one(self.touching_pairs.values(), world)
        impacts = Impacts(time, world, self.states, self.touching_pairs)
        impacts.resolve()
        self.contact_impulses = impacts.impulses
        self.changed |= impacts.changed
        self.ruled = impacts.ruled
        """Bodies for which a rule decided what rigid bodies leave open (A18)."""
        self._still_mechanisms()
        self._keep_lasting()

    def state(self, body: int) -> State:
        """Return the state of a body after the instant, as far as it is known."""
        return self.states[body] if body in self.states else self._world.state(body)

    def _find_touching(self, bodies: Sequence[int]) -> None:
        todo = with_mechanisms(self._world.cores, bodies)
        seen = set(todo)
        for body in todo:  # grows while it is gone through
            self._place(body)
            for other in self._world.overlapping(body):
                pair = (min(body, other), max(body, other))
                if pair in self.touching_pairs or pair in self.parted:
                    continue
                if touch := self._touch(pair):
                    self.touching_pairs[pair] = touch
                elif pair not in self._world.lasting:  # a pair that parts reaches others, too
                    continue
                for i in with_mechanisms(self._world.cores, pair):
                    if i not in seen and self._world.cores[i].dynamic:
                        seen.add(i)
                        todo.append(i)

    def _hush(self) -> None:
        """Let what moves no more than lasting contacts beside it tremble count as no motion.

        These take up what a slower impact passes on to them, and give it back as an approach.
        """
        lasting = [self.touching_pairs[p] for p in self._world.lasting if p in self.touching_pairs]
        for touch in self.touching_pairs.values():
            beside = [one.noise for one in lasting if self._share_a_body(one.pair, touch.pair)]
            touch.noise = max([touch.noise, *beside])

    @property
    def until(self) -> float:
        """When the run ends, s."""
        return self._world.until

    def _share_a_body(self, one: PairOf, other: PairOf) -> bool:
        return any(self._world.cores[i].dynamic for i in set(one) & set(other))

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
        separating_direction = self._world.separating_direction(pair) or self._pressed_direction(
            a, b, tolerance
        )
        contacts = manifold(a, b, tolerance, self.time, lasting, separating_direction)
        if not contacts:
            self._part(pair)
            return None
        self._refuse_behind(a, b, contacts)
        speed = max(speed_scale(contact, a.state, b.state) for contact in contacts)
        rounding = LASTING_NOISE if a.core.jointed or b.core.jointed else 64 * EPSILON
        noise = speed * (LASTING_NOISE if lasting else rounding)
        if speed <= 64 * EPSILON * self.time * max(math.hypot(*self._pull(x)) for x in (a, b)):
            noise = speed  # nothing but rounding moves them
        return TouchingPair(pair, contacts, tolerance, speed, noise, rounding)

    def _part(self, pair: PairOf) -> None:
        """Let a pair go whose corners have slid off each other."""
        self.parted.append(pair)
        self.changed |= {i for i in pair if self._world.cores[i].dynamic}

    def _refuse_gain(self) -> None:
        """Refuse what a rule decided if it makes energy: as where sliding bodies jam in a row."""
        moving = [i for i in self.states if self._world.cores[i].dynamic]
        before = math.fsum(_energy(self._world.cores[i], self._world.state(i)) for i in moving)
        after = math.fsum(_energy(self._world.cores[i], self.states[i]) for i in moving)
        if after > before * (1 + _GAIN):
            names = named(*(self._world.cores[i].name for i in sorted(self.ruled)))
            raise LastingContactError(
                f"{names} at {self.time!r} s: no impulses between them were found that make no "
                "energy (A18). End the run before, take method=Stepped(), or change the scene.",
                time=self.time,
            )

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

    def _still_mechanisms(self) -> None:
        """Take all velocities of mechanisms' contacts that count as none, at once.

        Taken contact by contact they would come back at others, through the joints.
        """
        still = []
        for touch in self.touching_pairs.values():
            if any(self._world.cores[i].jointed for i in touch.pair):
                own = [c for c in touch.contacts if abs(self._rate(c)) <= touch.noise]
                rough = own and self._world.friction(*touch.pair)
                if rough and abs(self._slip(own[0])) <= self._slide_noise(own[0]):
                    own.append(tangent_of(own[0]))
                still += own
        if still:
            self.states.update(without_rates(self._world.lasting_mobility, still, self.states))

    def _slip(self, contact: Contact) -> float:
        return tangential_velocity(contact, self.states[contact.a], self.states[contact.b])

    def _slide_noise(self, contact: Contact) -> float:
        pair = contact.a, contact.b
        touch = self.touching_pairs[pair]
        return touch.speed * (LASTING_NOISE if pair in self._world.sticking else touch.rounding)

    def _rate(self, contact: Contact) -> float:
        return normal_velocity(contact, self.states[contact.a], self.states[contact.b])

    def _keep_lasting(self) -> None:
        """Keep contacts that neither approach nor separate, or bounce below resolution."""
        staying, islands = self._staying_islands()
        if self.ruled:
            self._refuse_gain()
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
        self.changed |= constrained
        reached = with_mechanisms(self._world.cores, sorted(self.changed))
        self.changed = {i for i in reached if self._world.cores[i].dynamic}

    def _staying_islands(self) -> tuple[list[Contact], list[Island]]:
        """Return the contacts that stay, and their islands, after impulses where contacts jam."""
        for _ in range(_MAX_JAMS):
            try:
                return self._settled()
            except JammedError as jam:
                if not self._resolve_jam(jam):
                    raise
        return self._settled()

    def _settled(self) -> tuple[list[Contact], list[Island]]:
        staying = [
            contact
            for touch in self.touching_pairs.values()
            for contact in touch.contacts
            if abs(self._rate(contact)) <= touch.noise
        ]
        self._refuse_corners(staying)
        islands = self._islands(staying)
        while low := self._unresolved_bounces(islands, staying):
            self._refuse_corners(low)
            if self._end_low_bounces(staying, low):
                staying += low
                islands = self._islands(staying)
            else:
                self._bouncing += low
        return staying, islands

    def _end_low_bounces(self, staying: Sequence[Contact], low: Sequence[Contact]) -> bool:
        """End low bounces and return true, unless other contacts of a mechanism approach by that.

        A corner does so that passes below a hinge beside which the other body lies: it lifts it.
        """
        cores = self._world.cores
        held = [c for c in (*staying, *low) if cores[c.a].jointed or cores[c.b].jointed]
        if not any(contact in held for contact in low):
            return True
        before = dict(self.states)
        self.states.update(without_rates(self._world.lasting_mobility, held, self.states))
        for touch in self.touching_pairs.values():
            noise = 64 * EPSILON * touch.speed
            if any(self._rate(contact) < -noise for contact in touch.contacts):
                self.states.update(before)
                return False
        return True

    def _resolve_jam(self, jam: JammedError) -> bool:
        """Apply the impulses that end the sliding of contacts that jam (DD68), if there are any."""
        found, stopped = jam_impulses(self._world.mobility, jam)
        self._stopped |= stopped
        quieten(self.touching_pairs.values())
        self.contact_impulses += [
            ContactImpulse(contact, push, self._rate(contact))
            for contact, push, _ in found
            if push > 0
        ]
        apply(self._world.mobility, found, self.states)
        bodies = {i for contact, *_ in found for i in (contact.a, contact.b)}
        moving = {i for i in bodies if self._world.cores[i].dynamic}
        self.changed |= moving
        self.ruled |= moving
        return bool(found)

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
            bodies = set(self._world.mobility.reached([contact]))
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
        pair_friction = PairFriction(
            self.time, self._world.friction, self._slide_noise, self._stopped
        )
        found = []
        for bodies, joined in groups:
            free = {i: self._free(i) for i in sorted(bodies)}
            island = island_of(
                cores,
                placed,
                joined,
                free,
                min(slight),
                pair_friction,
                self._world.lasting_mobility,
            )
            self._stopped |= island.stopped  # also of the islands into which it falls
            alone = len(island.bodies) == 1 or len(island.lasting) == len(joined)
            found += [island] if alone else self._islands(island.lasting)
        return found

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
                if contact in staying or contact in self._bouncing:
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
            opening = opening_acceleration(contact, placed, by)
            if opening > 0:
                self.separating[contact.a, contact.b] = opening

    def _constrain(self, island: Island) -> None:
        states = island.crept(self.states, self._world.restitution)
        self.states.update(island.projected(states))
        self.constraints.update(island.constraints(self.states, self.time))
        self.senses.update(island.senses)
        self.changed.update(island.bodies)


def _energy(core: Core, state: State) -> float:
    """Return the kinetic energy of a moving body, J."""
    inertia = 1 / core.inverse_inertia if core.inverse_inertia else 0.0
    energy = definitions.kinetic_energy(
        1 / core.inverse_mass, state.velocity, inertia, state.angular_velocity
    )
    return float(energy)


def _touch(a: Placed, b: Placed, tolerance: float) -> bool:
    found = axes(a, b)
    return max(axis.gap for axis in found) <= tolerance and bool(normals(a, b, found))


def _far(a: Placed, b: Placed, tolerance: float) -> bool:
    (ax, ay), (bx, by) = a.state.position, b.state.position
    reach = a.core.bounding_radius + b.core.bounding_radius
    return math.hypot(bx - ax, by - ay) > reach + tolerance
