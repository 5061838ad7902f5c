"""Whether bounds of every kind can be believed, those that no choice of a method arrives at too.

A run within a tolerance has a bound by a closed form, by doubled steps or by an embedded pair
(`certificates`). Here are runs by methods of one's own: as tight as float64 allows, whose bounds
come from another program, and lost ones, of which only the energy is bounded, or nothing. The true
places come from formulas in 40 digits, and the true energy from the states of the run, in 40
digits as well. A run without a bound must claim nothing. It takes some minutes.
"""

from collections.abc import Iterator
from dataclasses import replace
from statistics import median
from typing import Any, NamedTuple

import mpmath as mp
import numpy as np

from tamias2d.errors import SceneError, SimulationError
from tamias2d.motion import ClosedForm, Dop853, Method, Reference, RungeKutta4, VelocityVerlet
from tamias2d.run import Run
from tamias2d.scene import Disc, HalfPlane, Scene, catalogue
from tamias2d.simulate import simulate
from tamias2d.state import Array
from tamias2d.study.bound import rounding
from tamias2d.study.certify import certify
from tamias2d.study.error import history_error
from tamias2d.study.recommend import solved
from tamias2d.study.scale import scale
from tools.measurements import held_out
from tools.measurements.columns import Columns
from tools.measurements.exact import NotCoveredError, exact_history

SEED = 1618
_EACH = 6
_STEPS = 64
_TIGHT: tuple[Method, ...] = (Reference(), Dop853(1e-13), RungeKutta4(), VelocityVerlet())


class Claim(NamedTuple):
    """One certificate, and what it should have bounded."""

    kind: str
    bound: float | None
    error: float | None
    floor: float
    """What rounding alone makes of the error."""
    empty: bool
    """Whether nothing is claimed."""

    @property
    def kept(self) -> bool:
        """Whether what is claimed is true."""
        if self.bound is None:
            return self.empty
        return self.error is not None and self.error <= self.bound


def measure() -> dict[str, Any]:
    """Return one row for each kind of bound."""
    claims = [*_of_places(), *_of_orbits(), *_of_energy()]
    return {"rows": [row(kind, claims) for kind in sorted({claim.kind for claim in claims})]}


def row(kind: str, claims: list[Claim]) -> dict[str, Any]:
    """Return how many claims of a kind there are, how many are true, and how tight they are."""
    own = [claim for claim in claims if claim.kind == kind]
    ratios = [c.bound / max(c.error, c.floor) for c in own if c.bound and c.error is not None]
    return {
        "kind": kind,
        "runs": len(own),
        "kept": sum(claim.kept for claim in own),
        "effectivity_median": median(ratios) if ratios else None,
    }


COLUMNS: Columns = {
    "kind of bound": "{kind}",
    "runs": "{runs}",
    "true": "{kept}",
    "bound over error, median": lambda row: (
        "-" if row["effectivity_median"] is None else f"{row['effectivity_median']:.3g}"
    ),
}


def _of_places() -> Iterator[Claim]:
    """Certify runs of scenes that have closed forms, by methods that do not use these."""
    scenes = [catalogue.load(name) for name in catalogue.names("located")]
    for scene in [*scenes, *held_out.scenes()]:
        if not solved(scene):
            continue
        try:
            exact = simulate(scene, duration=scene.duration or 1.0)
            if len(exact.impacts) > _STEPS:
                continue
            position, orientation = exact_history(scene, exact.times)
        except (SimulationError, SceneError, NotCoveredError):
            continue
        yield from _tight(exact, position, orientation)


def _of_orbits() -> Iterator[Claim]:
    """Certify orbits, which have formulas but no closed form here."""
    for scene in held_out.scenes():
        if scene.name.startswith("orbit"):
            run = simulate(scene, duration=scene.duration or 1.0)
            yield from _tight(run, kepler(scene, run.times), run.orientation)


def kepler(scene: Scene, times: Array) -> Array:
    """Return the places (k, n, 2) on ellipses of half axis 1 about the centre of mass, at rest.

    One body about a point, or two about each other; both start closest to each other, GM is 1.
    """
    starts = [body.position[0] for body in scene.bodies]
    near = mp.fsum(abs(mp.mpf(x)) for x in starts)
    e = 1 - near
    rows = []
    for t in map(mp.mpf, times.tolist()):
        anomaly = mp.findroot(lambda a, t=t: a - e * mp.sin(a) - t, t + e * mp.sin(t))
        x, y = mp.cos(anomaly) - e, mp.sqrt(1 - e * e) * mp.sin(anomaly)
        rows.append([(x * s / near, y * s / near) for s in starts])
    return np.array(rows, dtype=np.float64)


def _tight(like: Run, position: Array, orientation: Array) -> Iterator[Claim]:
    for method in _TIGHT:
        step = like.duration / _STEPS if method.fixed_step else None
        try:
            run = simulate(
                like.scene,
                duration=like.duration,
                method=method,
                time_step=step,
                times=like.times,
            )
        except (SimulationError, SceneError):
            continue
        true = replace(like, position=position, orientation=orientation)
        yield _claim(run, history_error(run, true), rounding(run) / scale(run))


def _claim(run: Run, error: float, floor: float) -> Claim:
    found = certify(run).certificate
    assert found is not None
    if found.kind == "invariants":
        error, floor = energy_error(run), 2.0**-52
    return Claim(found.kind, found.bound, error, floor, not found.claims)


def _of_energy() -> Iterator[Claim]:
    """Certify runs in which a small change grows until nobody can tell where bodies are.

    Where a certificate still tells places, there is nothing here to judge it by.
    """
    for k, posts in enumerate(lost()):
        stars, slowed = (_stars(np.random.default_rng(SEED + k), drag) for drag in (0.0, 1e-3))
        runs = [
            _run(posts, ClosedForm(), 20.0),
            _run(posts, VelocityVerlet(), 20.0, 1 / 64),
            _run(stars, Dop853(1e-10), 60.0),
            _run(stars, RungeKutta4(), 60.0, 1 / 64),
            _run(stars, VelocityVerlet(), 60.0, 1 / 64),
            _run(slowed, VelocityVerlet(), 60.0, 1 / 64),
        ]
        claims = [_claim(run, 0.0, 0.0) for run in runs]
        yield from (claim for claim in claims if claim.kind in ("invariants", "none"))


def lost() -> Iterator[Scene]:
    """Yield scenes with one disc between posts, of which nobody can tell where it is after 20 s."""
    random = np.random.default_rng(SEED)
    for k in range(_EACH):
        yield _posts(random, k)


def _run(scene: Scene, method: Method, duration: float, step: float | None = None) -> Run:
    times = np.linspace(0.0, duration, 121)
    return simulate(scene, duration=duration, method=method, time_step=step, times=times)


def _posts(random: np.random.Generator, k: int) -> Scene:
    """Return a disc between round posts in a box, which each hit sends off ten times wider."""
    scene = Scene(gravity=(0.0, -1.0 * (k % 2)), name=f"posts {k}")
    angle = random.uniform(0.2, 1.2)
    scene.add_body(
        Disc(radius=0.1),
        mass=1.0,
        position=(0.0, 0.1),
        velocity=(3 * float(np.cos(angle)), 3 * float(np.sin(angle))),
        restitution=1.0 if k % 3 else 0.99,
    )
    for x in (-1.0, 0.0, 1.0):
        for y in (-1.0, 0.0, 1.0):
            if (x, y) != (0.0, 0.0):
                shift = random.uniform(-0.05, 0.05)
                scene.add_static(Disc(radius=0.25), position=(x + float(shift), y))
    for normal in ((1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)):
        scene.add_static(HalfPlane(normal=normal, offset=-1.5))
    return scene


def _stars(random: np.random.Generator, drag: float) -> Scene:
    """Return three bodies that attract each other."""
    scene = Scene(gravity=(0.0, 0.0), name="stars")
    for k in range(3):
        x, y, u, v = random.uniform(-0.3, 0.3, 4).tolist()
        turn = 2 * np.pi * k / 3
        place = (float(np.cos(turn)) + x, float(np.sin(turn)) + y)
        velocity = (-0.5 * float(np.sin(turn)) + u, 0.5 * float(np.cos(turn)) + v)
        scene.add_body(None, mass=1.0, position=place, velocity=velocity, linear_drag=drag)
    scene.add_attraction(gravitational_constant=1.0)
    return scene


def energy_error(run: Run) -> float:
    """Return how far the energy strays from what impacts leave, over the largest kinetic energy.

    In 40 digits, from the states of the run.
    """
    moving = [i for i, body in enumerate(run.scene.bodies) if body.dynamic]
    lost, taken = [mp.mpf(0)], run.impacts
    for (a, b), impulse, rate in zip(
        taken.bodies.tolist(), taken.impulse.tolist(), taken.normal_velocity.tolist(), strict=True
    ):
        share = 1 - mp.mpf(run.scene.restitution(a, b))
        lost.append(lost[-1] + share * mp.mpf(impulse) * -mp.mpf(rate) / 2)
    after = np.searchsorted(taken.time, run.times, side="right").tolist()
    kinetic, total = [], []
    for k in range(len(run.times)):
        p = {i: [mp.mpf(x) for x in run.position[k, i].tolist()] for i in moving}
        kinetic.append(mp.fsum(_kinetic(run, k, i) for i in moving))
        turned = {i: mp.mpf(float(run.orientation[k, i])) for i in moving}
        springs = _springs(run.scene, p, turned)
        total.append(kinetic[-1] + _potential(run.scene, p) + springs + lost[after[k]])
    return float(max(abs(energy - total[0]) for energy in total) / max(kinetic))


def _kinetic(run: Run, k: int, i: int) -> Any:
    body = run.scene.bodies[i]
    u, v = (mp.mpf(x) for x in run.velocity[k, i].tolist())
    spin = mp.mpf(float(run.angular_velocity[k, i]))
    turning = mp.mpf(body.inertia) * spin * spin if spin else 0
    return (mp.mpf(body.mass) * (u * u + v * v) + turning) / 2


def _potential(scene: Scene, p: dict[int, list[Any]]) -> Any:
    mass = {i: mp.mpf(scene.bodies[i].mass) for i in p}
    gx, gy = (mp.mpf(g) for g in scene.gravity)
    total = -mp.fsum(mass[i] * (gx * x + gy * y) for i, (x, y) in p.items())
    for i in p:
        for j in p:
            if i < j and scene.attraction is not None:
                away = mp.hypot(p[i][0] - p[j][0], p[i][1] - p[j][1])
                total -= mp.mpf(scene.attraction) * mass[i] * mass[j] / away
    return total


def _springs(scene: Scene, p: dict[int, list[Any]], turned: dict[int, Any]) -> Any:
    total = mp.mpf(0)
    for spring in scene.springs:
        ends = []
        for body, anchor in ((spring.first, spring.anchor), (spring.second, spring.other_anchor)):
            x, y = spring.point if body is None else p[body]
            c, s = (mp.cos(turned[body]), mp.sin(turned[body])) if body in turned else (1, 0)
            ax, ay = (0, 0) if body is None else anchor
            ends.append((x + c * ax - s * ay, y + s * ax + c * ay))
        length = mp.hypot(ends[0][0] - ends[1][0], ends[0][1] - ends[1][1])
        total += mp.mpf(spring.stiffness) * (length - mp.mpf(spring.rest_length)) ** 2 / 2
    return total
