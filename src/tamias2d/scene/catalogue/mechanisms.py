"""Scenes of bodies that joints hold: bridges and chains, a walker, a car, ragdolls, a grid."""

import itertools
import math

from tamias2d.scene.catalogue.stacks import GRAVITY, on_floor
from tamias2d.scene.freedoms import JointSpring, Limits, Motor
from tamias2d.scene.joint_kinds import Revolute, Wheel
from tamias2d.scene.rules import Vector
from tamias2d.scene.scene import Scene
from tamias2d.scene.shapes import Box, Capsule, Disc, Polygon, Segment

_APART = -1  # the group of bodies that touch no others of it


def bridge(name: str) -> Scene:
    """Return planks of 1 m between two banks that are a twentieth nearer than the planks reach."""
    planks, span = 40, 38.0
    scene = Scene(
        gravity=GRAVITY,
        name=name,
        says="forty planks that hang from hinges between two banks, with slack",
        duration=2.0,
    )
    half = _half_angle(planks, span)
    radius = 0.5 / math.sin(half)
    points = [
        _turned((0.0, -radius), half * (2 * k - planks), (0.0, radius * math.cos(planks * half)))
        for k in range(planks + 1)
    ]
    plank = Box(width=1.0, height=0.25)
    before: str | Vector = points[0]
    for k, (left, right) in enumerate(itertools.pairwise(points)):
        middle = ((left[0] + right[0]) / 2, (left[1] + right[1]) / 2)
        turn = math.atan2(right[1] - left[1], right[0] - left[0])
        plank_name = f"plank{k}"
        scene.add_body(
            plank, mass=5.0, position=middle, orientation=turn, group=_APART, name=plank_name
        )
        _hinge(scene, before, plank_name, (0.5, 0.0), (-0.5, 0.0))
        before = plank_name
    _hinge(scene, points[-1], f"plank{planks - 1}", (0.0, 0.0), (0.5, 0.0))
    return scene


def ball_and_chain(name: str) -> Scene:
    """Return a ball on a chain of links that are 672 times lighter, let go from horizontal."""
    links, ball = 40, 8.0
    scene = Scene(
        gravity=GRAVITY,
        name=name,
        says="a ball of 672 times the mass of a link swings down on forty of them",
        duration=4.0,
    )
    before: str | Vector = (0.0, 0.0)
    for k in range(links):
        link = f"link{k}"
        shape = Capsule(length=0.75, radius=0.125)
        scene.add_body(shape, mass=1.0, position=(k + 0.5, 0.0), group=_APART, name=link)
        _hinge(scene, before, link, (0.5, 0.0), (-0.5, 0.0))
        before = link
    scene.add_body(
        Disc(radius=ball), mass=672.0, position=(links + ball, 0.0), group=_APART, name="ball"
    )
    _hinge(scene, before, "ball", (0.5, 0.0), (-ball, 0.0))
    return scene


def walker(name: str) -> Scene:
    """Return a pair of Jansen's legs on a stand: eleven bars each, one crank for both.

    The lengths are Jansen's, in centimetres.
    """
    scene = Scene(
        gravity=GRAVITY,
        name=name,
        says="two of Jansen's legs, on a stand, walk in the air by one crank with a motor",
        duration=6.0,
    )
    tip = (0.15, 0.0)
    crank = Box(width=0.15, height=0.02)
    scene.add_body(crank, mass=0.2, position=(0.075, 0.0), group=_APART, name="crank")
    motor = Motor(speed=-math.tau / 2, maximum=20.0)
    scene.add_joint(
        Revolute(motor=motor), (0.0, 0.0), "crank", other_anchor=(-0.075, 0.0), name="motor"
    )
    for side, word in ((-1.0, "left"), (1.0, "right")):
        _leg(scene, word, side, tip)
    return scene


def car(name: str) -> Scene:
    """Return a car of a chassis and two wheels on springs, driven over a hilly ground."""
    scene = Scene(
        gravity=GRAVITY,
        name=name,
        says="a car drives over hills on two sprung wheels, the hind one driven",
        duration=8.0,
    )
    heights = [0.0, 0.0, 0.0, 0.25, 1.0, 1.2, 0.4, 0.0, 0.5, 0.5, 1.5, 1.0, 0.0, 0.0]
    ground = [(4.0 * k - 4.0, y) for k, y in enumerate(heights)]
    for k, (left, right) in enumerate(itertools.pairwise(ground)):
        scene.add_static(
            Segment(length=math.dist(left, right)),
            position=((left[0] + right[0]) / 2, (left[1] + right[1]) / 2),
            orientation=math.atan2(right[1] - left[1], right[0] - left[0]),
            friction=0.9,
            restitution=0.0,
            name=f"ground{k}",
        )
    scene.add_body(
        Polygon(vertices=[(-1.4, -0.3), (1.4, -0.3), (1.4, 0.0), (0.4, 0.5), (-1.3, 0.4)]),
        mass=900.0,
        position=(0.0, 1.0),
        friction=0.5,
        restitution=0.0,
        name="chassis",
    )
    spring = JointSpring(stiffness=60e3, damping=4e3, rest=0.0)
    stops = Limits(lower=-0.25, upper=0.25, restitution=0.0)
    for word, x, motor in (
        ("hind", -0.9, Motor(speed=-15.0, maximum=1200.0)),
        ("front", 0.9, None),
    ):
        scene.add_body(
            Disc(radius=0.4),
            mass=40.0,
            position=(x, 0.42),
            friction=0.9,
            restitution=0.0,
            name=word,
        )
        kind = Wheel(axis=(0.0, 1.0), spring=spring, limits=stops, motor=motor)
        scene.add_joint(kind, "chassis", word, anchor=(x, -0.58), name=f"{word} axle")
    return scene


def ragdolls(name: str) -> Scene:
    """Return figures of eleven bones that fall onto a floor."""
    scene = on_floor(name, "eight figures of eleven bones fall onto a floor", duration=5.0)
    for k in range(8):
        _figure(scene, f"figure{k}", (1.5 * (k % 4) - 2.25, 2.0 + 2.5 * (k // 4)), -2 - k)
    return scene


def joint_grid(name: str) -> Scene:
    """Return thirty rows of thirty discs, each hinged to its neighbours, hung by seven."""
    return grid_of_joints(name, size=30, held=7)


def grid_of_joints(name: str, *, size: int, held: int) -> Scene:
    """Return a net of discs, the middle ones of whose first row are held; 100 are a benchmark."""
    scene = Scene(
        gravity=GRAVITY,
        name=name,
        says=f"a net of {size} by {size} discs that are hinged to each other, hung by {held}",
        duration=10.0,
    )
    disc, first = Disc(radius=0.4), (size - held) // 2
    for row in range(size):
        for column in range(size):
            here = (float(column), float(-row))
            disc_name = f"disc{row}-{column}"
            if row == 0 and first <= column < first + held:
                scene.add_static(disc, position=here, group=_APART, name=disc_name)
            else:
                scene.add_body(disc, mass=0.5, position=here, group=_APART, name=disc_name)
    for row in range(size):
        for column in range(size):
            for other, side in (((row, column + 1), (0.5, 0.0)), ((row + 1, column), (0.0, -0.5))):
                ends = (row * size + column, other[0] * size + other[1])
                if max(other) < size and not all(scene.bodies[k].static for k in ends):
                    scene.add_joint(
                        Revolute(), *ends, anchor=side, other_anchor=(-side[0], -side[1])
                    )
    return scene


def _hinge(
    scene: Scene, first: str | Vector, second: str, anchor: Vector, other_anchor: Vector
) -> None:
    at = anchor if isinstance(first, str) else (0.0, 0.0)
    scene.add_joint(Revolute(), first, second, anchor=at, other_anchor=other_anchor)


def _half_angle(planks: int, span: float) -> float:
    """Return half the angle of an arc over one plank of 1 m, for an arc with a chord, m."""
    low, high = 1e-9, math.pi / planks
    for _ in range(80):
        middle = (low + high) / 2
        if math.sin(planks * middle) / math.sin(middle) > span:
            low = middle
        else:
            high = middle
    return low


def _turned(point: Vector, angle: float, by: Vector) -> Vector:
    (x, y), c, s = point, math.cos(angle), math.sin(angle)
    return c * x - s * y + by[0], s * x + c * y + by[1]


def _meeting(one: Vector, reach: float, other: Vector, far: float, side: float) -> Vector:
    """Return where two circles meet; at the left of the way from one to the other, or the right."""
    dx, dy = other[0] - one[0], other[1] - one[1]
    gap = math.hypot(dx, dy)
    along = (reach**2 - far**2 + gap**2) / (2 * gap)
    across = side * math.sqrt(reach**2 - along**2)
    ux, uy = dx / gap, dy / gap
    return one[0] + along * ux - across * uy, one[1] + along * uy + across * ux


def _leg(scene: Scene, word: str, side: float, tip: Vector) -> None:
    """Add one of Jansen's legs, at the left (-1) or at the right (1) of the crank."""
    pivot = (side * 0.38, -0.078)
    up = -side  # at the left of the crank what is above is at the left of a way to it
    knee = _meeting(pivot, 0.415, tip, 0.50, up)
    hip = _meeting(pivot, 0.401, knee, 0.558, up)
    low = _meeting(pivot, 0.393, tip, 0.619, -up)
    ankle = _meeting(hip, 0.394, low, 0.367, -up)
    foot = _meeting(ankle, 0.657, low, 0.49, -up)
    for part, corners in (("thigh", (pivot, knee, hip)), ("shin", (low, ankle, foot))):
        plate = Polygon(vertices=list(corners))
        scene.add_body(
            plate, mass=1.0, position=plate.centroid, group=_APART, name=f"{word} {part}"
        )
    rods = {"upper": (tip, knee), "lower": (tip, low), "link": (pivot, low), "tendon": (hip, ankle)}
    for part, (one, other) in rods.items():
        scene.add_body(
            Box(width=math.dist(one, other), height=0.02),
            mass=0.4,
            position=((one[0] + other[0]) / 2, (one[1] + other[1]) / 2),
            orientation=math.atan2(other[1] - one[1], other[0] - one[0]),
            group=_APART,
            name=f"{word} {part}",
        )
    for at, first, second in (
        (pivot, None, "thigh"),
        (pivot, None, "link"),
        (tip, "crank", "upper"),
        (tip, "crank", "lower"),
        (knee, "upper", "thigh"),
        (low, "lower", "shin"),
        (low, "link", "shin"),
        (hip, "thigh", "tendon"),
        (ankle, "tendon", "shin"),
    ):
        if first not in (None, "crank"):
            first = f"{word} {first}"
        _pin(scene, at, first, f"{word} {second}")


def _pin(scene: Scene, at: Vector, first: str | None, second: str) -> None:
    """Hinge two bodies, or one and the plane, at a point of the plane."""
    other = _local(scene, second, at)
    if first is None:
        scene.add_joint(Revolute(), at, second, other_anchor=other)
    else:
        scene.add_joint(
            Revolute(), first, second, anchor=_local(scene, first, at), other_anchor=other
        )


def _local(scene: Scene, name: str, at: Vector) -> Vector:
    """Return a point of the plane in the axes of a body, from its centre of mass."""
    body = scene.bodies[scene.index(name)]
    way = (at[0] - body.position[0], at[1] - body.position[1])
    return _turned(way, -body.orientation, (0.0, 0.0))


def _figure(scene: Scene, word: str, at: Vector, group: int) -> None:
    """Add a figure of eleven bones, whose hips are above a place."""
    _bone(scene, f"{word} hip", (at, (0.0, 0.95)), (0.10, 0.11, 12.0, 0.0), group)
    _bone(scene, f"{word} torso", (at, (0.0, 1.25)), (0.30, 0.12, 25.0, math.pi / 2), group)
    _bone(scene, f"{word} head", (at, (0.0, 1.62)), (0.08, 0.10, 5.0, math.pi / 2), group)
    _limb(scene, word, "hip", "torso", at, (0.0, 1.05), (-0.4, 0.4))
    _limb(scene, word, "torso", "head", at, (0.0, 1.48), (-0.5, 0.5))
    for side, hand in ((-1.0, "left"), (1.0, "right")):
        x, turn = 0.1 * side, math.pi / 2
        _bone(scene, f"{word} {hand} thigh", (at, (x, 0.70)), (0.30, 0.07, 8.0, turn), group)
        _bone(scene, f"{word} {hand} shin", (at, (x, 0.27)), (0.34, 0.05, 4.0, turn), group)
        x = 0.2 * side
        _bone(scene, f"{word} {hand} arm", (at, (x, 1.27)), (0.20, 0.05, 2.5, turn), group)
        _bone(scene, f"{word} {hand} hand", (at, (x, 0.97)), (0.22, 0.04, 1.5, turn), group)
        thigh, arm = f"{hand} thigh", f"{hand} arm"
        _limb(scene, word, "hip", thigh, at, (0.1 * side, 0.87), (-0.8, 0.8))
        _limb(scene, word, thigh, f"{hand} shin", at, (0.1 * side, 0.48), (-1.2, 0.1))
        _limb(scene, word, "torso", arm, at, (0.2 * side, 1.38), (-1.5, 1.5))
        _limb(scene, word, arm, f"{hand} hand", at, (0.2 * side, 1.12), (-0.1, 1.4))


def _bone(
    scene: Scene,
    name: str,
    places: tuple[Vector, Vector],
    build: tuple[float, float, float, float],
    group: int,
) -> None:
    (x, y), (dx, dy) = places
    length, radius, mass, turn = build
    scene.add_body(
        Capsule(length=length, radius=radius),
        mass=mass,
        position=(x + dx, y + dy),
        orientation=turn,
        friction=0.6,
        restitution=0.0,
        group=group,
        name=name,
    )


def _limb(
    scene: Scene, word: str, first: str, second: str, at: Vector, joint: Vector, turns: Vector
) -> None:
    """Hinge two bones; they turn against each other by some angles from how they are drawn."""
    one, other = f"{word} {first}", f"{word} {second}"
    place = (at[0] + joint[0], at[1] + joint[1])
    turn = scene.bodies[scene.index(other)].orientation - scene.bodies[scene.index(one)].orientation
    scene.add_joint(
        Revolute(
            limits=Limits(lower=turn + turns[0], upper=turn + turns[1], restitution=0.0),
            spring=JointSpring(stiffness=20.0, damping=1.0, rest=turn),
        ),
        one,
        other,
        anchor=_local(scene, one, place),
        other_anchor=_local(scene, other, place),
    )
