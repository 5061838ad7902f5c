"""Small scenes for ensembles."""

import tamias2d as t2


def bouncing() -> t2.Scene:
    """A ball that falls onto a floor, and a spring on a particle beside it."""
    scene = t2.Scene(gravity=(0.0, -9.81), name="bouncing")
    floor = t2.HalfPlane(normal=(0.0, 1.0), offset=0.0)
    scene.add_static(floor, restitution=0.5, name="floor")
    disc = t2.Disc(radius=0.25)
    scene.add_body(disc, mass=1.0, position=(0.0, 1.0), restitution=0.5, name="ball")
    scene.add_body(None, mass=2.0, position=(5.0, 1.0), name="bob")
    scene.add_spring("bob", (5.0, 3.0), stiffness=30.0, rest_length=1.0)
    return scene


def stack() -> t2.Scene:
    """Two boxes on a floor."""
    scene = t2.Scene(gravity=(0.0, -9.81))
    floor = t2.HalfPlane(normal=(0.0, 1.0), offset=0.0)
    scene.add_static(floor, restitution=0.0, friction=0.5, name="floor")
    box = t2.Box(width=1.0, height=0.5)
    for k in range(2):
        place = (0.1 * k, 0.3 + 0.6 * k)
        scene.add_body(box, mass=1.0, position=place, restitution=0.1, friction=0.5, name=f"box{k}")
    return scene


def sliding(world: int, stream: object) -> t2.Scene:
    """A puck of random speed, made by a function."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    speed = stream.normal(1.0, 0.1) + world  # type: ignore[attr-defined]
    scene.add_body(None, mass=1.0, position=(0.0, 0.0), velocity=(speed, 0.0), name="puck")
    return scene
