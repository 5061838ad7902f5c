"""Random sequences of calls of a simulator with joints: added, moved, removed, broken, restored."""

import math
import pickle
from typing import Any

import numpy as np

import tamias2d as t2
from tools.fuzz.sequences import Fuzz, refused_of


class JointedFuzz(Fuzz):
    """A simulator, and what is done to it and its joints at random."""

    def act(self) -> None:
        """Do something at random."""
        match self.chance.randrange(14):
            case 0 | 1 | 2:
                self.tie()
            case 3 if self.sim.joints:
                self.sim.remove_joint(self.chance.choice(self.sim.joints))
            case 4 if self.sim.joints:
                self.sim.set_target(self.chance.choice(self.sim.joints), self.pair())
            case 5:
                self.restore()
            case _:
                super().act()

    def tie(self) -> None:
        """Add a joint where bodies are, or one that does not fit."""
        ends: list[Any] = self.some()[:2]
        at = self.pair()
        while len(ends) < 2:
            ends.insert(self.chance.randint(0, 1), at)
        held = at if self.chance.random() < 0.9 else self.pair()
        anchors = [self.anchor(ends[0], at), self.anchor(ends[1], held)]
        breaks = self.chance.random() < 0.3
        self.sim.add_joint(
            self.kind(),
            ends[0],
            ends[1],
            anchor=anchors[0],
            other_anchor=anchors[1],
            collide=self.chance.random() < 0.3,
            break_force=abs(self.number(0.0, 200.0)) if breaks else None,
        )

    def anchor(self, end: Any, at: tuple[float, float]) -> tuple[float, float]:
        """Return a place in the axes of a body, or of the plane."""
        if isinstance(end, tuple):
            return 0.0, 0.0
        with np.errstate(all="ignore"):
            x, y = np.array(at) - self.sim.position[end]
            turn = float(self.sim.orientation[end])
            turn = turn if math.isfinite(turn) else 0.0
            found = (
                math.cos(turn) * x + math.sin(turn) * y,
                math.cos(turn) * y - math.sin(turn) * x,
            )
        return float(found[0]), float(found[1])

    def kind(self) -> Any:
        """Return what kind of joint it is."""
        chance = self.chance
        governed: dict[str, Any] = {}
        if chance.random() < 0.3:
            governed["limits"] = t2.Limits(
                lower=self.number(-1.0, 0.0), upper=self.number(0.0, 1.0), restitution=0.0
            )
        if chance.random() < 0.2:
            governed["motor"] = t2.Motor(speed=self.number(), maximum=abs(self.number(0.0, 50.0)))
        if chance.random() < 0.2:
            governed["spring"] = self.spring()
        axis = self.pair()
        match chance.randrange(9):
            case 0 | 1 | 2:
                return t2.Revolute(**governed)
            case 3:
                return t2.Distance(**governed)
            case 4:
                return t2.Weld()
            case 5:
                return t2.Prismatic(axis=axis, **governed)
            case 6:
                return t2.Wheel(axis=axis, spring=self.spring())
            case 7:
                return t2.Target(spring=self.spring())
            case _:
                return t2.Ratchet(pitch=abs(self.number(0.05, 1.0)), restitution=0.0)

    def spring(self) -> t2.JointSpring:
        """Return a spring, stiff or not."""
        stiffness = 10.0 ** self.chance.uniform(0.0, 6.0)
        return t2.JointSpring(stiffness=stiffness, damping=abs(self.number(0.0, 20.0)))

    def restore(self) -> None:
        """Go on with what is restored, which has the same bits after some steps."""
        again = pickle.loads(pickle.dumps(self.sim))
        for sim in (self.sim, again):
            sim.step(2)
        assert again.digest() == self.sim.digest(), "another simulator was restored"
        assert again.joint_events == self.sim.joint_events, "other joints broke"
        self.sim = again


def case(seed: int) -> str:
    """Run a sequence; return what came of it."""
    return "refused" if refused_of(JointedFuzz(seed)) else "done"
