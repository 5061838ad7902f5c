"""Crowds at random: sizes, masses, shapes, speeds and spins, towards each other or onto a floor."""

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

import tamias2d as t2

Array = NDArray[np.float64]


def shape_of(kind: int, size: float) -> Any:
    """A disc, a box, a pentagon or a capsule that a circle of the size, m, contains."""
    angles = 2 * math.pi / 5 * np.arange(5)
    corners = [(size * math.cos(a), size * math.sin(a)) for a in angles]
    shapes = (
        t2.Disc(radius=size),
        t2.Box(width=1.6 * size, height=0.8 * size),
        t2.Polygon(vertices=corners),
        t2.Capsule(length=size, radius=0.3 * size),
    )
    return shapes[kind]


def imploding(seed: int, count: int = 40) -> tuple[t2.Simulator, NDArray[np.int64]]:
    """Bodies that nothing outside pushes, which fly towards their middle at up to 30 sizes a step.

    Sizes are from 2 mm to 5 m, masses in ratios of up to 1000 for equal sizes.
    """
    chance = np.random.default_rng(seed)
    size = 10 ** chance.uniform(-2.3, 0.7)
    speed = chance.uniform(0.1, 30) * size * 60
    surface: Any = {"friction": chance.uniform(0, 0.8), "restitution": chance.uniform(0, 1)}
    sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)))
    side = math.ceil(count**0.5)
    middle = np.array([side - 1, side - 1]) * 1.1 * size
    rows = []
    for k in range(count):
        own = size * chance.uniform(0.3, 1)
        place = np.array([k % side, k // side]) * 2.2 * size
        inwards = -(place - middle) / size / side * speed
        rows.append(
            sim.add(
                shape_of(int(chance.integers(4)), own),
                mass=float(10 ** chance.uniform(-1, 2) * own**2),
                position=tuple(place),
                orientation=chance.uniform(0, 6),
                velocity=tuple(inwards + chance.normal(size=2) * speed * 0.2),
                angular_velocity=chance.uniform(-20, 20),
                **surface,
            )
        )
    return sim, np.array(rows)


def rain(
    radius: float, fall: float, count: int = 100, *, compiled: bool = True
) -> tuple[t2.Simulator, NDArray[np.int64]]:
    """Discs and boxes in a lattice that reach a floor at the speed of a fall, m."""
    chance = np.random.default_rng(7)
    surface: Any = {"friction": 0.5, "restitution": 0.0}
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -9.81)), compiled=compiled)
    columns = round((count / 1.6) ** 0.5)
    sim.add_static(t2.Box(width=1000 * radius, height=1.0), position=(0.0, -0.5), **surface)
    places = [
        ((k % columns - (columns - 1) / 2) * 3 * radius, 2 * radius + k // columns * 3 * radius)
        for k in range(count)
    ]
    order, half = chance.permutation(count), count // 2
    kind: dict[str, Any] = {"velocity": (0.0, -math.sqrt(2 * 9.81 * fall)), **surface}
    discs = sim.add(
        t2.Disc(radius=radius), mass=radius**2, position=[places[k] for k in order[:half]], **kind
    )
    boxes = sim.add(
        t2.Box(width=1.6 * radius, height=1.2 * radius),
        mass=radius**2,
        position=[places[k] for k in order[half:]],
        orientation=chance.uniform(0, 3, count - half),
        **kind,
    )
    return sim, np.concatenate((discs, boxes))


def centre_of_mass(sim: t2.Simulator, rows: NDArray[np.int64]) -> Array:
    """Of some bodies, m."""
    mass = sim.mass[rows]
    centre: Array = mass @ sim.position[rows] / mass.sum()
    return centre


def standing_share(sim: t2.Simulator, rows: NDArray[np.int64], steps: int) -> float:
    """How many moving body-steps go less than a fifth of their way, though in the same direction.

    A body moves if it is faster than 0.3 m/s before and after the step.
    """
    moving = standing = 0
    for _ in range(steps):
        place, before = sim.position[rows].copy(), sim.velocity[rows].copy()
        sim.step()
        after = sim.velocity[rows]
        way = np.hypot(*(sim.position[rows] - place).T) / sim.time_step
        speed = np.minimum(np.hypot(*before.T), np.hypot(*after.T))
        goes_on = (speed > 0.3) & ((before * after).sum(axis=1) > 0.0)
        moving += int(goes_on.sum())
        standing += int((goes_on & (way < 0.2 * speed)).sum())
    return standing / max(moving, 1)
