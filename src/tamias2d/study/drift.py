"""Energy over very many steps: whether it only swings, or drifts.

Measured are a planet on an ellipse and a disc that bounces without loss. The planet is pulled by a
law of the user's own, so that its potential energy is not in the run. Its energy swings within each
round, so the trend is that of a straight line through the means of rounds. There is no trend if it
is small beside the first swing and no later value goes far beyond that, or if all of it is no more
than the random walk of rounding.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from tamias2d.balance import kinetic_energy, uniform_potential_energy
from tamias2d.float64 import EPSILON
from tamias2d.generated import gravitation
from tamias2d.motion import Method
from tamias2d.run import Run
from tamias2d.scene import Disc, HalfPlane, Scene
from tamias2d.solve import solve
from tamias2d.state import Array
from tamias2d.study.phases import started

_ROUNDS = 200  # that are looked at
_ROUND = 1000  # steps
_APART = 20  # steps between samples of a round
_STEPS_OF_BOUNCE = 100.0  # in a second
_CHUNK = 10_000  # steps of the bounce that are kept at once
_SHARE, _BEYOND, _WALK = 0.1, 2.0, 10.0


@dataclass(frozen=True, kw_only=True)
class Drift:
    """What became of the energy of one scene by one method; all relative to the energy."""

    scene: str
    method: str
    steps: int
    impacts: int
    swing: float
    """The largest departure within the first round, or the first hundredth of the run."""
    largest: float
    """The largest departure of all."""
    trend: float
    """How much a straight line through the means over rounds rises from start to end."""

    @property
    def trendless(self) -> bool:
        """Whether the trend is nothing beside the swing, or beside what rounding does at random."""
        walk = _WALK * EPSILON * np.sqrt(self.steps)
        small = abs(self.trend) <= max(_SHARE * self.swing, walk)
        return bool(small and self.largest <= max(_BEYOND * self.swing, walk))


def orbit_drift(method: Method, steps: int) -> Drift:
    """Follow a planet of eccentricity 0.6 by a stepped method, 1000 steps a round."""
    scene = Scene(gravity=(0.0, 0.0), name="orbit")
    pull = "-1[m^3/s^2]*mass*{}(position)/norm(position)**3"
    scene.add_body(None, mass=1.0, position=(0.4, 0.0), velocity=(0.0, 2.0), name="planet")
    scene.add_field(force=(pull.format("x"), pull.format("y")))
    step = 2 * np.pi / _ROUND
    grid = np.arange(steps + 1) * step  # as `simulate` lays it
    starts = np.linspace(0, steps - _ROUND, min(_ROUNDS, steps // _ROUND)).astype(int)
    rows = starts[:, None] + np.arange(0, _ROUND, _APART)
    duration = float(grid[-1])
    run = solve(scene, duration=duration, method=method, time_step=step, times=grid[rows.ravel()])
    x, y = run.position[:, 0].T
    bound = gravitation.gravitational_energy(1.0, 1.0, 1.0, (0.0, 0.0), (x, y))
    energy = kinetic_energy(scene, run.velocity, run.angular_velocity) + bound
    off = (energy / energy[0] - 1).reshape(rows.shape)
    return _drift("orbit", method, steps, 0, starts / steps, off)


def bounce_drift(method: Method, steps: int) -> Drift:
    """Follow a disc that bounces without loss, in as much time as the steps take.

    A method that is not stepped goes through the same time.
    """
    scene = Scene(gravity=(0.0, -9.81), name="bounce")
    disc = Disc(radius=0.5)
    scene.add_body(disc, mass=1.0, position=(0.0, 1.5), restitution=1.0, name="disc")
    scene.add_static(HalfPlane(normal=(0.0, 1.0), offset=0.0), name="floor")
    height = uniform_potential_energy(scene, np.array([[b.position for b in scene.bodies]]))
    times, energy, impacts = [0.0], [float(height.sum())], 0
    for run in _chunks(scene, method, steps):
        times.append(times[-1] + run.duration)
        energy.append(float(run.energy[-1]))
        impacts += len(run.impacts)
    off = (np.array(energy) / energy[0] - 1)[:, None]
    first = max(len(off) // 100, 2)
    off = np.concatenate((off[:first].T, np.broadcast_to(off[first:], (len(off) - first, first))))
    share = np.array([0.0, *times[first:]]) / times[-1]
    return _drift("bounce", method, steps, impacts, share, off)


def _chunks(scene: Scene, method: Method, steps: int) -> Iterator[Run]:
    """Run on and on from where the last run ended, so that no history grows without limit."""
    for first in range(0, steps, _CHUNK):
        duration = min(_CHUNK, steps - first) / _STEPS_OF_BOUNCE
        step = 1 / _STEPS_OF_BOUNCE if method.fixed_step else None
        run = solve(scene, duration=duration, method=method, time_step=step, times=[duration])
        yield run
        scene = started(run, -1)


def _drift(scene: str, method: Method, steps: int, impacts: int, share: Array, off: Array) -> Drift:
    """Judge departures (rounds, samples) of the energy, at shares (rounds,) of the time."""
    return Drift(
        scene=scene,
        method=f"{method}",
        steps=steps,
        impacts=impacts,
        swing=float(np.abs(off[0]).max()),
        largest=float(np.abs(off).max()),
        trend=float(np.polyfit(share, off.mean(axis=1), 1)[0]),
    )
