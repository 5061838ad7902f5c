"""Scenes in which bodies stand on each other: pyramids, columns, cards, stones and a wall.

All bodies touch their neighbours at the start, or stand a little apart from them.
"""

import math

from tamias2d.scene.compound import Shape
from tamias2d.scene.rules import Vector
from tamias2d.scene.scene import Scene
from tamias2d.scene.shapes import Box, Disc, HalfPlane, Polygon, Segment

GRAVITY = (0.0, -9.81)
FRICTION = 0.6
_DIGITS = 9  # so that sines of other machines do not make other scenes


def pyramid(name: str, *, rows: int) -> Scene:
    """Return a pyramid of unit boxes on a floor."""
    boxes = rows * (rows + 1) // 2
    scene = on_floor(name, f"pyramid of {boxes} unit boxes, {rows} high", duration=5.0)
    for row in range(rows):
        for k in range(rows - row):
            x = round(1.05 * (k - (rows - row - 1) / 2), _DIGITS)
            add(scene, Box(width=1.0, height=1.0), mass=1.0, at=(x, row + 0.5))
    return scene


def heavy_column(name: str) -> Scene:
    """Return ten boxes, of which the highest is a hundred times heavier than each other."""
    scene = on_floor(name, "ten unit boxes, the highest of 100 times the mass", duration=10.0)
    for k in range(10):
        mass = 100.0 if k == 9 else 1.0
        add(scene, Box(width=1.0, height=1.0), mass=mass, at=(0.0, k + 0.5))
    return scene


def dominoes(name: str) -> Scene:
    """Return a row of which the first falls over."""
    scene = on_floor(
        name, "a row of fifteen dominoes, of which the first falls on the next", duration=4.0
    )
    width, height, spin = 0.1, 1.0, -1.5
    for k in range(15):
        first = k == 0
        add(
            scene,
            Box(width=width, height=height),
            mass=1.0,
            at=(0.5 * k, height / 2),
            velocity=(-spin * height / 2, -spin * width / 2) if first else (0.0, 0.0),
            spin=spin if first else 0.0,
        )
    return scene


def card_house(name: str) -> Scene:
    """Return five levels of tents of two cards, with cards laid from tent to tent."""
    scene = on_floor(name, "a house of cards of five levels, 40 cm times 2 mm each", duration=5.0)
    long, thick, lean, pitch = 0.4, 0.002, math.radians(25), 0.4002
    card = Box(width=thick, height=long)
    aside = (long * math.sin(lean) + thick * math.cos(lean)) / 2
    high = (long * math.cos(lean) + thick * math.sin(lean)) / 2
    for level in range(5):
        floor = level * (2 * high + thick)
        for tent in range(5 - level):
            middle = pitch * (tent + level / 2)
            for side in (-1, 1):
                at = (middle + side * aside, floor + high)
                add(scene, card, mass=0.01, at=at, turn=side * lean, friction=0.7)
            if tent < 4 - level:
                at = (middle + pitch / 2, floor + 2 * high + thick / 2)
                add(scene, card, mass=0.01, at=at, turn=math.pi / 2, friction=0.7)
    return scene


def arch(name: str) -> Scene:
    """Return a round arch of wedges that carries a column."""
    scene = on_floor(name, "an arch of 17 stones that carries four boxes", duration=5.0)
    inner, outer, stones = 4.0, 5.0, 17
    for k in range(stones):
        ends = [math.pi * (k + end) / stones for end in (0, 1)]
        corners = [_around(inner, ends[0]), _around(outer, ends[0])]
        stone = Polygon(vertices=[*corners, _around(outer, ends[1]), _around(inner, ends[1])])
        add(scene, stone, mass=round(stone.area, _DIGITS), at=stone.centroid)
    top = outer * math.cos(math.pi / stones / 2)
    for k in range(4):
        add(scene, Box(width=0.8, height=0.4), mass=0.32, at=(0.0, top + 0.4 * k + 0.2))
    return scene


def bullet_wall(name: str) -> Scene:
    """Return a wall of bricks, a fast disc before it and a line behind it."""
    scene = on_floor(
        name, "a bullet of 400 m/s, a wall of thin bricks, and behind it a line", duration=2.0
    )
    for row in range(12):
        at = (0.0, 0.1 * row + 0.05)
        add(scene, Box(width=0.02, height=0.1), mass=0.2, at=at)
    scene.add_static(
        Segment(length=4.0),
        position=(2.0, 2.0),
        orientation=math.pi / 2,
        friction=FRICTION,
        restitution=0.0,
    )
    add(scene, Disc(radius=0.02), mass=0.05, at=(-20.0, 0.62), velocity=(400.0, 0.0))
    return scene


def incline(name: str) -> Scene:
    """Return boxes of five frictions on a slope that three of them hold."""
    turn = -0.25
    scene = Scene(
        gravity=GRAVITY,
        name=name,
        says="boxes on a slope of 0.25 rad, of which the two smoothest slide",
        duration=4.0,
    )
    up = (round(-math.sin(turn), _DIGITS), round(math.cos(turn), _DIGITS))
    ground = HalfPlane(normal=up, offset=0.0)
    scene.add_static(ground, restitution=0.0, name="slope")
    (x, y) = ground.normal
    for k, friction in enumerate((0.0, 0.1, 0.35, 0.5, 0.75)):
        along = 8.0 - 4.0 * k
        at = (y * along + 0.5 * x, -x * along + 0.5 * y)
        box = Box(width=1.0, height=1.0)
        add(scene, box, mass=1.0, at=at, turn=math.atan2(-x, y), friction=friction)
    return scene


def on_floor(name: str, says: str, *, duration: float) -> Scene:
    """Return a scene with nothing but a floor at a height of 0."""
    scene = Scene(gravity=GRAVITY, name=name, says=says, duration=duration)
    floor = HalfPlane(normal=(0.0, 1.0), offset=0.0)
    scene.add_static(floor, friction=FRICTION, restitution=0.0, name="floor")
    return scene


def add(
    scene: Scene,
    shape: Shape,
    *,
    mass: float,
    at: Vector,
    turn: float = 0.0,
    velocity: Vector = (0.0, 0.0),
    spin: float = 0.0,
    friction: float = FRICTION,
) -> None:
    """Add a body that does not bounce."""
    scene.add_body(
        shape,
        mass=mass,
        position=(round(at[0], _DIGITS), round(at[1], _DIGITS)),
        orientation=round(turn, _DIGITS),
        velocity=velocity,
        angular_velocity=spin,
        friction=friction,
        restitution=0.0,
    )


def _around(radius: float, angle: float) -> Vector:
    return round(radius * math.cos(angle), _DIGITS), round(radius * math.sin(angle), _DIGITS)
