"""A scene in which each piece of a chain is a static body of its own, for who looks at pairs."""

import math
from dataclasses import replace

from tamias2d.scene.bodies import Body
from tamias2d.scene.chain import Chain, Piece
from tamias2d.scene.scene import Scene


class ScenePieces(Scene):
    """A scene in pieces, which come last; the bodies whose shape they were have none."""

    owner: list[int]
    """Of each body: the index of the one in the scene to which it belongs."""

    @property
    def kept_apart(self) -> frozenset[tuple[int, int]]:
        """The pairs of bodies, the lower index first, that do not touch because a joint says so."""
        return frozenset(_of_pieces(dict.fromkeys(super().kept_apart, 0.0), self.owner))


def in_pieces(scene: Scene) -> Scene:
    """Return a scene with all chains in pieces; one without a chain is returned as it is."""
    if not any(isinstance(body.shape, Chain) for body in scene.bodies):
        return scene
    apart = ScenePieces.__new__(ScenePieces)
    vars(apart).update(vars(scene))
    bodies, owner = list(scene.bodies), list(range(len(scene)))
    for k, body in enumerate(scene.bodies):
        if isinstance(body.shape, Chain):
            bodies[k] = replace(body, shape=None)
            pieces = _pieces(body, body.shape)
            bodies += pieces
            owner += [k] * len(pieces)
    apart.owner, apart._bodies, apart._shown = owner, bodies, ()
    apart._of_pairs = _of_pieces(scene.restitution_of_pairs, apart.owner)
    apart._friction_of_pairs = _of_pieces(scene.friction_of_pairs, apart.owner)
    return apart


def owners(scene: Scene) -> list[int]:
    """Return to which body of a scene each one belongs that it is in pieces."""
    return scene.owner if isinstance(scene, ScenePieces) else list(range(len(scene)))


def _pieces(body: Body, chain: Chain) -> list[Body]:
    c, s = math.cos(body.orientation), math.sin(body.orientation)
    corners = chain.corners
    found = []
    for ((ax, ay), (bx, by)), start, end in zip(
        chain.segments, corners[:-1], corners[1:], strict=True
    ):
        x, y = ax / 2 + bx / 2, ay / 2 + by / 2
        core = (ax - x, ay - y), (bx - x, by - y)
        piece = Piece(core, start, end, chain.one_sided)
        at = (body.position[0] + (c * x - s * y), body.position[1] + (s * x + c * y))
        found.append(replace(body, shape=piece, position=at))  # type: ignore[arg-type]
    return found


def _of_pieces(
    values: dict[tuple[int, int], float], owner: list[int]
) -> dict[tuple[int, int], float]:
    """Return what is set for pairs of bodies, for all pairs of their pieces."""
    pieces: dict[int, list[int]] = {}
    for k, body in enumerate(owner):
        pieces.setdefault(body, []).append(k)
    return {
        (min(p, q), max(p, q)): value
        for (i, j), value in values.items()
        for p in pieces[i]
        for q in pieces[j]
    }
