"""The springs of a scene as rows for the engine."""

from collections.abc import Sequence

from tamias2d.engine.springs.rows import SpringRow
from tamias2d.scene import Scene


def spring_rows(scene: Scene, rows: Sequence[int]) -> list[SpringRow]:
    """Return the springs whose bodies are there, given by rows in canonical order, in such, too."""
    place = {row: k for k, row in enumerate(rows)}
    springs = [spring for spring in scene.springs if place.keys() >= set(spring.bodies)]
    found = [
        SpringRow(
            first=spring.first,
            second=spring.second,
            stiffness=spring.stiffness,
            rest_length=spring.rest_length,
            damping=spring.damping,
            anchor=spring.anchor,
            other_anchor=spring.point if spring.second is None else spring.other_anchor,
        )
        for spring in springs
    ]
    return sorted(found, key=lambda row: (_places(row, place), row[2:]))


def _places(row: SpringRow, place: dict[int, int]) -> tuple[int, int]:
    return place[row.first], -1 if row.second is None else place[row.second]
