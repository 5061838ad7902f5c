"""Random sequences of calls in which bodies, filters, surfaces and joints change, too."""

from typing import Any

import tamias2d as t2
from tools.fuzz.jointed_sequences import JointedFuzz
from tools.fuzz.sequences import BODIES, refused_of

_NUMBERS = (0, 1, 2, 3, 6, 2**62, 2**63 - 1)


class ChangedFuzz(JointedFuzz):
    """A simulator with joints, and what is changed at random."""

    def act(self) -> None:
        """Do something at random."""
        match self.chance.randrange(21):
            case 0 | 1:
                self.sim.set_filters(self.some(), **self.said(category=self.bits, mask=self.bits))
            case 2:
                self.sim.set_filters(self.some(), group=self.chance.randint(-2, 2))
            case 3:
                said = self.said(friction=self.share, restitution=self.share)
                self.sim.set_surface(self.some(), **said)
            case 4 | 5 | 6 if self.sim.joints:
                self.govern(self.chance.choice(self.sim.joints))
            case 7:
                self.restore()
            case 8:
                self.add_named()
            case 9:
                self.add_platform()
            case 10 | 11 | 12:
                self.alter(self.some())
            case _:
                super().act()

    def alter(self, bodies: Any) -> None:
        """Let bodies be of other shapes, heavier or slowed, whether they may or not."""
        match self.chance.randrange(3):
            case 0:
                mass = self.said(mass=lambda: abs(self.number(0.1, 9.0)))
                self.sim.set_shape(bodies, self.chance.choice(BODIES), **mass)
            case 1:
                self.sim.set_mass(bodies, mass=abs(self.number(0.1, 9.0)))
            case _:
                self.sim.set_drag(bodies, **self.said(linear_drag=self.share))

    def add_named(self) -> None:
        """Add a body whose name may be taken, and remove the one that has another name."""
        one, other = self.chance.sample(("this", "that", "those"), 2)
        shape, mass = self.chance.choice(BODIES), abs(self.number(0.1, 9.0))
        self.sim.add(shape, mass=mass, position=self.pair(), restitution=0.1, name=one)
        self.sim.remove(other)

    def add_platform(self) -> None:
        """Add a chain that moves."""
        corners = [(2.0, 0.0), (0.5, self.chance.uniform(-0.3, 0.3)), (-2.0, 0.0)]
        self.sim.add_kinematic(
            t2.Chain(vertices=corners, one_sided=self.chance.random() < 0.7),
            position=self.pair(),
            velocity=self.pair(),
            angular_velocity=self.number(),
            friction=0.3,
            restitution=0.1,
        )

    def govern(self, name: str) -> None:
        """Give a joint something else that governs it, whether it has such or not."""
        off = self.chance.random() < 0.2
        match self.chance.randrange(3):
            case 0:
                ends = self.said(
                    lower=lambda: self.number(-1.0, 0.2), upper=lambda: self.number(-0.2, 1.0)
                )
                limits = t2.Limits(restitution=self.share(), **ends)
                self.sim.set_limits(name, None if off else limits)
            case 1:
                motor = t2.Motor(speed=self.number(), maximum=abs(self.number(0.0, 50.0)))
                self.sim.set_motor(name, None if off else motor)
            case _:
                self.sim.set_spring(name, None if off else self.spring())

    def said(self, **values: Any) -> dict[str, Any]:
        """Return some of the values, each made by a call."""
        return {key: value() for key, value in values.items() if self.chance.random() < 0.7}

    def bits(self) -> int:
        """Return a category or a mask."""
        return self.chance.choice(_NUMBERS)

    def share(self) -> float:
        """Return a friction or a restitution."""
        return abs(self.number(0.0, 1.0))


def case(seed: int) -> str:
    """Run a sequence; return what came of it."""
    return "refused" if refused_of(ChangedFuzz(seed)) else "done"
