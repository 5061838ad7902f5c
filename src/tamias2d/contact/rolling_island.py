"""The island of one disc that slides or rolls on a half-plane (DD85)."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from tamias2d.contact import rolling_disc
from tamias2d.contact.constrained_acceleration import Constant
from tamias2d.contact.core import Core, Placed
from tamias2d.contact.lasting_contact import Island
from tamias2d.contact.manifold import Contact
from tamias2d.contact.pair_friction import PairFriction
from tamias2d.contact.rolling_disc import Motion
from tamias2d.path import PathPiece
from tamias2d.state import Acceleration, Constraint, State, Vector


def rolls(
    cores: Sequence[Core], contacts: Sequence[Contact], free: Mapping[int, Acceleration]
) -> bool:
    """Whether contacts are one of a disc that constant loads press on a half-plane."""
    if len(contacts) > 1 or contacts[0].axis.side is None:
        return False
    body, arm, normal = _of_disc(contacts[0])
    (support,) = {contacts[0].a, contacts[0].b} - {body}
    disc = len(cores[body].corners) == 1 and cores[body].dynamic and cores[body].steady
    pressed = disc and rolling_disc.is_pressed(free[body], arm, normal)
    return pressed and cores[support].endless


class RollingDisc(Island):
    """One disc on a half-plane, with friction."""

    def __init__(
        self,
        cores: Sequence[Core],
        placed: Mapping[int, Placed],
        contacts: Sequence[Contact],
        free: Mapping[int, Acceleration],
        slight: float,
        pair_friction: PairFriction,
    ) -> None:
        """Take the one contact (`rolls`), and the friction of all pairs."""
        super().__init__(cores, placed, contacts, free, slight)
        (contact,) = self.lasting = list(contacts)
        body, self._arm, self._normal = _of_disc(contact)
        self._coefficient, self._loads = pair_friction.of(contact.a, contact.b), free[body]
        self._inverses = cores[body].inverse_mass, cores[body].inverse_inertia
        sense = rolling_disc.sense_of(
            _motion(placed[body].state),
            self._loads,
            self._arm,
            self._normal,
            self._inverses,
            self._coefficient,
            pair_friction.unseen(contact),
            pair_friction.time,
        )
        *by, self._sense = rolling_disc.held(
            self._loads, self._arm, self._normal, self._inverses, self._coefficient, sense
        )
        self.accelerations = {body: (by[0], by[1], by[2])}
        self.senses[contact.a, contact.b] = self._sense

    def crept(
        self, states: Mapping[int, State], restitution: Callable[[int, int], float]
    ) -> Mapping[int, State]:
        """Return the states where the bounces that are left have brought what sticks (DD78)."""
        if self._sense:
            return states
        (body,), (contact,) = self.bodies, self.lasting
        state = states[body]
        x, y, turn = rolling_disc.crept(
            (*state.position, state.orientation),
            _motion(state),
            self._loads,
            self._arm,
            self._normal,
            self._inverses,
            restitution(contact.a, contact.b),
        )
        return {**states, body: state._replace(position=(x, y), orientation=turn)}

    def projected(self, states: Mapping[int, State]) -> dict[int, State]:
        """Return the states without what the last bounces have left of them."""
        (body,) = self.bodies
        u, v, spin = rolling_disc.settled(
            _motion(states[body]),
            self._arm,
            self._normal,
            self._inverses,
            self._coefficient,
            self._sense,
        )
        return {body: states[body]._replace(velocity=(u, v), angular_velocity=spin)}

    def constraints(self, states: Mapping[int, State], time: float) -> dict[int, Constraint]:  # noqa: ARG002
        """Return the constraint of the disc."""
        (body,) = self.bodies
        by = self.accelerations[body]
        return {body: RollingConstraint(by, self._arm, self._normal, self._sense)}


@dataclass(frozen=True)
class RollingConstraint(Constant):
    """The acceleration of a disc that slides or rolls on a half-plane."""

    arm: Vector
    normal: Vector
    sense: int
    """In which it slides, or 0"""

    def sliding_end(self, path: PathPiece) -> float | None:
        """Return when the disc does not slide any more on a path, s, or None."""
        motion, by = _motion(path.at(path.start)), path.acceleration(path.start)
        end = rolling_disc.sliding_end(path.start, motion, by, self.arm, self.normal, self.sense)
        return end if end <= path.end else None


def _of_disc(contact: Contact) -> tuple[int, Vector, Vector]:
    """Return the body before a side, its arm, and the normal of the side."""
    swapped, _, normal, _ = contact.axis
    return (contact.a, contact.arm_a, normal) if swapped else (contact.b, contact.arm_b, normal)


def _motion(state: State) -> Motion:
    return (*state.velocity, state.angular_velocity)
