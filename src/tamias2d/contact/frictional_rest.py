"""Frictional lasting contacts: which of them stick, slide or roll (GD8)."""

from collections.abc import Callable, Mapping, Sequence

import numpy as np

from tamias2d.contact.constrained_acceleration import (
    constrained_accelerations,
    contact_acceleration,
    opening_acceleration,
    without_normal_velocity,
)
from tamias2d.contact.core import Core, Placed
from tamias2d.contact.coupled_island import CoupledIsland
from tamias2d.contact.friction_constraint import (
    FrictionConstraint,
    TurningFrictionConstraint,
    jacobian_row,
    unit_response,
)
from tamias2d.contact.lasting_contact import Island, scale_of, unseen_opening
from tamias2d.contact.manifold import (
    Contact,
    normal_velocity,
    tangent_of,
    tangential_acceleration,
)
from tamias2d.contact.mobility import Mobility
from tamias2d.contact.modes import (
    Mode,
    Part,
    Patch,
    closed,
    closed_directions,
    cone_edges,
    effects,
    force_directions,
    forces,
    modes,
)
from tamias2d.contact.pair_friction import PairFriction
from tamias2d.contact.refusal import FrictionError, named
from tamias2d.contact.response import coupling
from tamias2d.contact.rolling_island import RollingDisc, rolls
from tamias2d.generated import friction
from tamias2d.state import Acceleration, Constraint, State

_SAME = 1e-8
"""Of the loads: by how much two equal answers may differ."""


def island_of(
    cores: Sequence[Core],
    placed: Mapping[int, Placed],
    contacts: Sequence[Contact],
    free: Mapping[int, Acceleration],
    slight: float,
    pair_friction: PairFriction,
    mobility: Mobility,
) -> Island:
    """Return the island of bodies that contacts connect, with friction or without.

    Bodies that move together, or are held by joints, have forces that depend on each other (IM18).
    One body alone on what stands still is simpler: where it stays at rest, nothing moves to the
    bit.
    """
    moving = {i for c in contacts for i in (c.a, c.b) if cores[i].dynamic}
    if len(moving) > 1 or any(cores[i].jointed for i in moving):
        return CoupledIsland(mobility, placed, contacts, free, slight, pair_friction)
    if any(pair_friction.of(contact.a, contact.b) for contact in contacts):
        if rolls(cores, contacts, free):
            return RollingDisc(cores, placed, contacts, free, slight, pair_friction)
        return FrictionalIsland(cores, placed, contacts, free, slight, pair_friction)
    return Island(cores, placed, contacts, free, slight)


def slides_on(
    cores: Sequence[Core],
    placed: Mapping[int, Placed],
    contact: Contact,
    free: Mapping[int, Acceleration],
    slight: float,
    pair_friction: PairFriction,
) -> int:
    """Return the sense in which the one contact of a body is sure to slide, or 0.

    Loads press it, so that it may not open, and friction does not press what it brakes: it is the
    only mode. What is closer to another one is for an island to decide.
    """
    (patch,) = pair_friction.patches([contact], placed, free)
    if not patch.sense:
        return 0
    (edge,) = cone_edges((Part(patch, patch.contacts, patch.sense),))
    load = opening_acceleration(contact, placed, free)
    pressed = load < -unseen_opening(scale_of([*free.values()], [load]), slight)
    return patch.sense if pressed and coupling(cores, contact, edge) > 0 else 0


class FrictionalIsland(Island):
    """One moving body, of whose contacts some have friction."""

    def __init__(
        self,
        cores: Sequence[Core],
        placed: Mapping[int, Placed],
        contacts: Sequence[Contact],
        free: Mapping[int, Acceleration],
        slight: float,
        pair_friction: PairFriction,
    ) -> None:
        """Take contacts without normal velocity.

        Raises:
            FrictionError: Coulomb's law has no answer, or several.
            LastingContactError: several bodies move on with friction between them.
        """
        super().__init__(cores, placed, contacts, free, slight)
        self._states = {i: body.state for i, body in placed.items()}
        self._free = free
        self._mode: Mode = ()
        patches = pair_friction.patches(contacts, placed, free)
        self._find_mode(patches, contacts, free, pair_friction.time)
        self.senses.update(_senses(self._mode))

    def crept(
        self, states: Mapping[int, State], restitution: Callable[[int, int], float]
    ) -> Mapping[int, State]:
        """Return the states where the bounces that are left have brought what sticks (DD78).

        It is a disc, or lies flat, on one other body; of what turns in a flight it is not known.
        """
        (body,), turns = self.bodies, self._angular()
        if len(self._mode) != 1 or not self._mode[0].sticks:
            return states
        if turns and (not self._flat() or self._free[body][2]):
            return states
        contact, *_ = pressed = self._mode[0].pressed
        bounce = restitution(contact.a, contact.b)
        load = self._contact_acceleration(contact, False, self._free)
        if not load * (1 - bounce) < 0:
            return states
        rate = normal_velocity(contact, states[contact.a], states[contact.b])
        along = self._contact_acceleration(contact, True, self._free)
        way = friction.creep(rate, load, along, bounce)
        tangent = tangent_of(contact)
        push = unit_response(self._cores[body], body, tangent)
        moved = constrained_accelerations(self._cores, [body], pressed, {body: push})[body]
        share = way / float(np.dot(jacobian_row(body, tangent), moved))
        (x, y), (u, v, spin) = states[body].position, moved
        turn = states[body].orientation + share * spin
        place = (x + share * u, y + share * v)
        return {**states, body: states[body]._replace(position=place, orientation=turn)}

    def projected(self, states: Mapping[int, State]) -> dict[int, State]:
        """Return the states projected on the velocities that the contacts allow."""
        if not self._pressing:
            return super().projected(states)
        (body,) = self.bodies
        edges = force_directions(self._mode)
        settled = without_normal_velocity(self._cores, self._closed, states, edges)[body]
        if self._moves_on(states):
            return {body: settled}
        x, y, spin = self._projected((*settled.velocity, settled.angular_velocity))
        return {body: settled._replace(velocity=(x, y), angular_velocity=spin)}

    def constraints(self, states: Mapping[int, State], time: float) -> dict[int, Constraint]:
        """Return the constraint of each body by its lasting contacts.

        Raises:
            LastingContactError: located contacts do not cover it.
        """
        if not self._pressing:
            return super().constraints(states, time)
        (body,) = self.bodies
        moving = self._moves_on(states)
        if not moving:
            return {body: FrictionConstraint(self._cores, body, self._mode, self._projected)}
        self._refuse_coupled(body, moving, time)
        placed = {i: self._placed[i] for c in self.lasting for i in (c.a, c.b)}
        return {body: TurningFrictionConstraint(self._cores, body, self._mode, placed)}

    @property
    def _pressing(self) -> bool:
        """Whether some contact presses, so that friction acts."""
        return any(part.pressed for part in self._mode)

    @property
    def _closed(self) -> list[Contact]:
        return closed_directions(closed(self._mode))

    def _projected(self, motion: Acceleration) -> Acceleration:
        """Return a body's velocity or acceleration, projected on what the closed contacts allow."""
        (body,) = self.bodies
        return constrained_accelerations(self._cores, [body], self._closed, {body: motion})[body]

    def _find_mode(
        self,
        patches: Sequence[Patch],
        contacts: Sequence[Contact],
        free: Mapping[int, Acceleration],
        time: float,
    ) -> None:
        """Find the one mode, and the acceleration of the body in it."""
        (body,) = self.bodies
        answers: list[tuple[Mode, Acceleration]] = []
        for mode in modes(patches):
            found = self._acceleration_in(mode, free)
            if found is not None and not any(self._same(found, other) for _, other in answers):
                answers.append((mode, found))
        if len(answers) != 1:
            what = "several motions" if answers else "no motion"
            names = named(*dict.fromkeys(self._cores[i].name for c in contacts for i in (c.a, c.b)))
            raise FrictionError(
                f"{names} at {time!r} s: Coulomb's law allows {what} (GD8), as it may where "
                "friction presses what it brakes. Take less friction, or end the run before.",
                time=time,
            )
        ((self._mode, acceleration),) = answers
        self.accelerations = {body: acceleration}
        self._pressed = [contact for part in self._mode for contact in part.pressed]
        self.lasting = [
            contact
            for contact in contacts
            if contact in self._pressed
            or opening_acceleration(contact, self._placed, self.accelerations) <= self._unseen
        ]
        if self._pressing and not self._moves_on(self._states):
            self.accelerations = {body: self._projected(acceleration)}

    def _same(self, first: Acceleration, second: Acceleration) -> bool:
        (body,) = self.bodies
        size = (1.0, 1.0, self._cores[body].size)
        apart = max(abs(x - y) * w for x, y, w in zip(first, second, size, strict=True))
        return apart <= _SAME * self._scale + self._unseen

    def _acceleration_in(self, mode: Mode, free: Mapping[int, Acceleration]) -> Acceleration | None:
        """Return the acceleration of the body in a mode, or None if it breaks Coulomb's law."""
        (body,) = self.bodies
        rows, columns = closed(mode), cone_edges(mode)
        by = dict(free)
        if rows:
            loads = np.array(
                [self._contact_acceleration(contact, along, free) for contact, along in rows]
            )
            found = forces(effects(self._cores, rows, columns), loads)
            if found is None:
                return None
            by = self._with_forces(columns, found, free)
        for part in mode:
            for contact in part.patch.contacts:
                if (
                    contact not in part.pressed
                    and self._contact_acceleration(contact, False, by) < -self._unseen
                ):
                    return None
            begins = part.pressed and part.sense and not part.patch.sense
            if (
                begins
                and part.sense * self._contact_acceleration(part.pressed[0], True, by)
                < -self._unseen
            ):
                return None
        return by[body]

    def _contact_acceleration(
        self, contact: Contact, along: bool, by: Mapping[int, Acceleration]
    ) -> float:
        """Return the normal or tangential acceleration of a contact, m/s^2."""
        return contact_acceleration(contact, along, self._placed, by, tangential_acceleration)


def _senses(mode: Mode) -> dict[tuple[int, int], int]:
    pressing = [part for part in mode if part.pressed]
    return {(part.pressed[0].a, part.pressed[0].b): part.sense for part in pressing}
