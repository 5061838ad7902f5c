"""How bodies rub and part, said so that every engine mixes the same for a pair.

Serves: the peers' worlds. Hides: how they mix. Ours takes the root of the product of two frictions,
and so does Box2D; Pymunk takes the product. Of two restitutions Box2D takes the larger one, and
Pymunk the product.
"""

from collections.abc import Callable

from tamias2d.scene import Body, Scene
from tamias2d.study.engines.refusal import PeerError


def friction(scene: Scene) -> list[float]:
    """Return each body's friction, where what one alone states is also the other's.

    Raises:
        PeerError: a mix of a pair depends on who meets whom, which no peer can say.
    """
    if scene.friction_of_pairs:
        raise PeerError("peers: friction: is set for pairs. Leave the peers out.")
    return _filled(scene, "friction", lambda body: body.friction)


def restitution(scene: Scene) -> list[float]:
    """Return each body's restitution, all the same; raise `PeerError` if they are not."""
    filled = _filled(scene, "restitution", lambda body: body.restitution)
    if scene.restitution_of_pairs or len(set(filled)) > 1:
        raise PeerError("peers: restitution: differs from pair to pair. Leave the peers out.")
    return filled


def _filled(scene: Scene, what: str, of: Callable[[Body], float | None]) -> list[float]:
    stated = {value for body in scene.bodies if (value := of(body)) is not None}
    silent = [body for body in scene.bodies if of(body) is None and body.shape is not None]
    if stated and silent and (len(stated) > 1 or any(body.dynamic for body in silent)):
        raise PeerError(f"peers: {what}: stated by some bodies only. State it for all of them.")
    usual = stated.pop() if stated else 0.0
    return [usual if (value := of(body)) is None else value for body in scene.bodies]
