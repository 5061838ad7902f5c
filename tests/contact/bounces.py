"""A disc, or a box that lies flat, bounces on a half-plane: one bounce after the other, 60 digits.

The textbook's way: the tangential impulse ends the slip or is the friction coefficient times the
normal one. Nothing is cut before bounces are slower than 1e-32 m/s.
"""

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from mpmath import mp, mpf, sign, sqrt

import tamias2d as t2

_LAST = mpf(10) ** -32  # m/s


@dataclass(frozen=True)
class Piece:
    """Motion under constant accelerations, along the half-plane and away from it."""

    time: Any
    place: Any
    speed: Any
    load: Any
    height: Any
    rise: Any
    pull: Any
    turn: Any
    spin: Any
    twist: Any

    def after(self, span: Any, **changed: Any) -> "Piece":
        """Return what begins after a time span."""
        values = {
            "time": self.time + span,
            "place": self.place + self.speed * span + self.load * span**2 / 2,
            "speed": self.speed + self.load * span,
            "height": self.height + self.rise * span + self.pull * span**2 / 2,
            "rise": self.rise + self.pull * span,
            "turn": self.turn + self.spin * span + self.twist * span**2 / 2,
            "spin": self.spin + self.twist * span,
        }
        return replace(self, **(values | changed))


class Bounces:
    """The pieces of the motion of body 1 on half-plane 0, under gravity."""

    def __init__(self, scene: t2.Scene) -> None:
        with mp.workdps(60):
            plane, body = scene.bodies
            assert isinstance(plane.shape, t2.HalfPlane)
            assert isinstance(body.shape, t2.Disc | t2.Box)
            x, y = map(mpf, plane.shape.normal)
            self._normal = x / sqrt(x * x + y * y), y / sqrt(x * x + y * y)
            disc = isinstance(body.shape, t2.Disc)
            reach = mpf(body.shape.radius if disc else body.shape.height / 2)
            self._arm = reach if disc else mpf(0)  # a box that lies flat does not turn
            self._turning = mpf(body.mass) / mpf(body.inertia) * self._arm
            self._reach = reach + mpf(plane.shape.offset)
            self._friction = mpf(scene.friction(0, 1))
            (along, up), (u, v), (load, pull) = map(
                self._turned, (body.position, body.velocity, scene.gravity)
            )
            height, turn, spin = up - self._reach, mpf(body.orientation), body.angular_velocity
            piece = Piece(mpf(0), along, u, load, height, v, pull, turn, mpf(spin), mpf(0))
            self.pieces = [piece]
            self._bounce(mpf(scene.restitution(0, 1)))
            self.end = float(self.pieces[-1].time)
            """When the bounces end, s."""
            self._rest(load, pull)

    def at(self, time: float) -> list[float]:
        """Return x, y, orientation, velocity and angular velocity at a time, s."""
        with mp.workdps(60):
            last = next(piece for piece in reversed(self.pieces) if piece.time <= time)
            now = last.after(mpf(time) - last.time)
            x, y = self._back(now.place, now.height + self._reach)
            u, v = self._back(now.speed, now.rise)
            return [float(value) for value in (x, y, now.turn, u, v, now.spin)]

    def _turned(self, vector: Any) -> tuple[Any, Any]:
        (x, y), (nx, ny) = map(mpf, vector), self._normal
        return x * ny - y * nx, x * nx + y * ny

    def _back(self, along: Any, up: Any) -> tuple[Any, Any]:
        nx, ny = self._normal
        return along * ny + up * nx, -along * nx + up * ny

    def _slip(self, piece: Piece) -> Any:
        return piece.speed + self._arm * piece.spin

    def _bounce(self, restitution: Any) -> None:
        """Add the flights, and the instant at which the last one ends."""
        yields = 1 + self._turning * self._arm
        while True:
            one = self.pieces[-1]
            span = (one.rise + sqrt(one.rise**2 - 2 * one.pull * one.height)) / -one.pull
            down = one.after(span, height=mpf(0))
            push = -(1 + restitution) * down.rise
            most = self._friction * push
            drag = max(-most, min(most, -self._slip(down) / yields))
            rise = -restitution * down.rise
            speed, spin = down.speed + drag, down.spin + self._turning * drag
            self.pieces.append(replace(down, rise=rise, speed=speed, spin=spin))
            if rise < _LAST:
                return

    def _rest(self, load: Any, pull: Any) -> None:
        """Replace the last flight by what slides until it sticks, and what follows."""
        one = replace(self.pieces.pop(), rise=mpf(0), pull=mpf(0))
        yields, most = 1 + self._turning * self._arm, -self._friction * pull
        slip = self._slip(one)
        if abs(slip) > mpf(10) ** -28:
            drag = -sign(slip) * most
            one = replace(one, load=load + drag, twist=self._turning * drag)
            self.pieces.append(one)
            change = load + drag * yields
            if change * slip >= 0:
                return
            one = one.after(-slip / change)
        drag = max(-most, min(most, -load / yields))
        self.pieces.append(replace(one, load=load + drag, twist=self._turning * drag))


def errors(run: t2.Run) -> tuple[np.ndarray, np.ndarray]:
    """Return how far place and velocity of body 1 are from the exact ones, (k,), m and m/s."""
    exact = Bounces(run.scene)
    found = np.column_stack(
        [
            run.position[:, 1],
            run.orientation[:, 1],
            run.velocity[:, 1],
            run.angular_velocity[:, 1],
        ]
    )
    shape = run.scene.bodies[1].shape
    assert shape is not None
    off = np.abs(found - [exact.at(time) for time in run.times.tolist()])
    off[:, [2, 5]] *= shape.bounding_radius
    return (
        np.hypot(off[:, 0], off[:, 1]) + off[:, 2],
        np.hypot(off[:, 3], off[:, 4]) + off[:, 5],
    )
