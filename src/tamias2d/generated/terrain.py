"""Terrain: Turn of a chain at a vertex; Room of a normal at a corner; Contact with a piece of a
chain.

Generated from srs/models/terrain.md
by `python -m tools.generate`. Edit the chapter, not this file.
"""

from tamias2d.spec.functions import Scalar, Truth, Vector


def corner_cosine(way_a: Vector, way_b: Vector) -> Scalar:
    """Cosine of the angle by which a chain turns at a vertex (1).

    corner_cosine = dot(way_a, way_b)

    Args:
        way_a: Unit vector along a piece of a chain, from its first vertex to its last; of body
            A, 1
        way_b: Unit vector along a piece of a chain, from its first vertex to its last; of body
            B, 1

    Source: DD73, srs/models/terrain.md:28.
    """
    way_a_x, way_a_y = way_a
    way_b_x, way_b_y = way_b
    return way_a_x * way_b_x + way_a_y * way_b_y


def corner_sine(way_a: Vector, way_b: Vector) -> Scalar:
    """Sine of the angle by which a chain turns at a vertex, positive to the left (1).

    corner_sine = cross(way_a, way_b)

    Args:
        way_a: Unit vector along a piece of a chain, from its first vertex to its last; of body
            A, 1
        way_b: Unit vector along a piece of a chain, from its first vertex to its last; of body
            B, 1

    Source: DD73, srs/models/terrain.md:29.
    """
    way_a_x, way_a_y = way_a
    way_b_x, way_b_y = way_b
    return way_a_x * way_b_y - way_a_y * way_b_x


def corner_room(
    corner_cosine: Scalar, corner_sine: Scalar, normal_part: Scalar, lean: Scalar
) -> Scalar:
    """Sine of how much farther a normal may lean over the end of a piece of a chain (1).

    corner_room = corner_sine*normal_part - corner_cosine*lean

    Args:
        corner_cosine: Cosine of the angle by which a chain turns at a vertex, 1
        corner_sine: Sine of the angle by which a chain turns at a vertex, positive to the left,
            1
        normal_part: Part of a direction along the normal of a piece of a chain, 1
        lean: Part of a direction along a piece of a chain, beyond one of its ends, 1

    Source: DD74, srs/models/terrain.md:45.
    """
    return corner_sine * normal_part - corner_cosine * lean


def admitted(corner_sine: Scalar, corner_room: Scalar) -> Truth:
    """Whether a direction is a normal of a contact with a piece of a chain, true or false (1).

    admitted = corner_sine >= 0 and corner_room >= 0

    Args:
        corner_sine: Sine of the angle by which a chain turns at a vertex, positive to the left,
            1
        corner_room: Sine of how much farther a normal may lean over the end of a piece of a
            chain, 1

    Source: IM16, srs/models/terrain.md:97.
    """
    return (corner_sine >= 0) & (corner_room >= 0)
