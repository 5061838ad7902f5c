"""How bodies rub and part, said so that every engine mixes the same for a pair.

Serves: the peers' worlds. Hides: how they mix. Ours takes the root of the product of two frictions,
and so does Box2D; Pymunk takes the product. Of two restitutions Box2D takes the larger one, and
Pymunk the product.
"""

from tamias2d.scene import Scene
from tamias2d.scene.surfaces import SurfaceKey, surface_values
from tamias2d.study.engines.refusal import PeerError


def friction(scene: Scene) -> list[tuple[float, ...]]:
    """Return the friction of each body's parts, where what one alone states is also the other's.

    Raises:
        PeerError: a mix of a pair depends on who meets whom, which no peer can say.
    """
    if scene.friction_of_pairs:
        raise PeerError("peers: friction: is set for pairs. Leave the peers out.")
    return _filled(scene, "friction")


def restitution(scene: Scene) -> list[tuple[float, ...]]:
    """Return that of each body's parts, all the same; raise `PeerError` if they are not."""
    filled = _filled(scene, "restitution")
    if scene.restitution_of_pairs or len({value for own in filled for value in own}) > 1:
        raise PeerError("peers: restitution: differs from pair to pair. Leave the peers out.")
    return filled


def _filled(scene: Scene, what: SurfaceKey) -> list[tuple[float, ...]]:
    found = [surface_values(body, what) for body in scene.bodies]
    stated = {value for own in found for value in own if value is not None}
    silent = [body for body, own in zip(scene.bodies, found, strict=True) if None in own]
    if stated and silent and (len(stated) > 1 or any(body.dynamic for body in silent)):
        raise PeerError(f"peers: {what}: stated by some bodies only. State it for all of them.")
    usual = stated.pop() if stated else 0.0
    return [tuple(usual if value is None else value for value in own) for own in found]
