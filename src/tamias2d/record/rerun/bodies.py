"""Bodies as the viewer draws them: parts of one kind of all bodies are one entity.

An entity appears with all that it holds. A body for itself would be shown as soon as its shape is
loaded, wherever that is, and of a thousand bodies the viewer shows the last after a minute.
"""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
import rerun as rr

from tamias2d.record import drawing
from tamias2d.record.rerun import exact, layout

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

    from numpy.typing import NDArray

    from tamias2d.record.drawing import Colour, View
    from tamias2d.record.drawn import Drawn
    from tamias2d.run_data import RunData

    Times = Callable[[slice], list[rr.TimeColumn]]

CROWD = 100
"""More bodies than this are drawn in a way that loads quickly."""
_CORE = 0.94  # of a disc is filled, the rest is its rim
_ORDER = {"rims": 20.0, "areas": 21.0, "lines": 22.0}  # what is later covers what is before


@dataclass
class Batch:
    """Parts with v points each, in the frames of their bodies; v is 1 for discs."""

    points: list[Any] = field(default_factory=list)
    bodies: list[int] = field(default_factory=list)
    radii: list[float] = field(default_factory=list)
    """m; below 0 in points of the screen"""
    colours: list[Colour] = field(default_factory=list)

    def add(self, points: Any, body: int, radius: float, colour: Colour) -> None:
        """Add one part of a body."""
        self.points.append(points)
        self.bodies.append(body)
        self.radii.append(radius)
        self.colours.append(colour)


Key = tuple[bool, str, int]  # whether it stands still, its layer, and its number of points


def draw(stream: rr.RecordingStream, run: RunData, view: View, times: Times) -> None:
    """Send all bodies of a run: those that stand still once, the others at each sample."""
    found = layers(run, view, drawing.colours(run), balls=is_crowd(run))
    for key, batch in sorted(found.items()):
        stream.log(entity(key), look(key, batch, run), static=True)
        still = key[0]
        send(stream, key, batch, run, (lambda _: []) if still else times)


def is_crowd(drawn: Drawn) -> bool:
    """Whether so many bodies move that they are drawn in a way that loads quickly."""
    return sum(not body.static for body in drawn.scene.bodies) > CROWD


def layers(drawn: Drawn, view: View, colours: Sequence[Colour], *, balls: bool) -> dict[Key, Batch]:
    """Return the parts of all bodies, each with its colour, by the entities that show them."""
    crowd = is_crowd(drawn)
    found: dict[Key, Batch] = defaultdict(Batch)
    for k, (body, colour) in enumerate(zip(drawn.scene.bodies, colours, strict=True)):
        shade = tuple(channel // 2 for channel in colour)
        width = -1.0 if body.static else -0.5 if crowd else -1.5
        for layer, points, radius in _parts(
            drawing.look(body, view, balls=balls, coarse=crowd), width
        ):
            key = (body.static, layer, len(points))
            found[key].add(points, k, radius, shade if layer == "areas" else colour)  # type: ignore[arg-type]
    return dict(found)


def entity(key: Key) -> str:
    """Return the path of what shows the parts of a key."""
    still, layer, size = key
    return f"{layout.BODIES}/{'static' if still else 'moving'}/{layer}{size}"


def look(key: Key, batch: Batch, drawn: Drawn) -> Any:
    """Return what of parts does not change from sample to sample."""
    still, layer, _ = key
    return _kind(key).from_fields(
        radii=batch.radii,
        colors=batch.colours,
        labels=[drawn.scene.bodies[k].name for k in batch.bodies],
        show_labels=False,
        draw_order=_ORDER[layer] - 10.0 * still,
    )


def send(stream: rr.RecordingStream, key: Key, batch: Batch, drawn: Drawn, times: Times) -> None:
    """Send where parts are at each sample, or at the first one if they stand still."""
    still, _, size = key
    points = np.array(batch.points, dtype=np.float64)
    for part in [slice(1)] if still else exact.blocks(len(drawn.times), 8 * points.size):
        seen = _placed(drawn, batch, points, part).astype(np.float32)
        rows = seen.reshape(-1, 2) if size == 1 else seen.reshape(-1, size, 2)
        columns = _kind(key).columns(**{"positions" if size == 1 else "strips": rows})
        lengths = [len(points)] * len(seen)
        stream.send_columns(entity(key), times(part), columns.partition(lengths))


def _kind(key: Key) -> Any:
    return rr.Points2D if key[2] == 1 else rr.LineStrips2D


def _placed(drawn: Drawn, batch: Batch, points: NDArray[Any], part: slice) -> NDArray[Any]:
    """World coordinates (samples, parts, v, 2) of a batch, in m."""
    angle = drawn.orientation[part, batch.bodies][..., None]
    x, y = points[..., 0], points[..., 1]
    turned = np.stack(
        [np.cos(angle) * x - np.sin(angle) * y, np.sin(angle) * x + np.cos(angle) * y], axis=-1
    )
    return np.asarray(turned + drawn.position[part, batch.bodies][:, :, None, :])


def _parts(seen: drawing.Look, width: float) -> Iterator[tuple[str, Any, float]]:
    """Layer, points (v, 2) and half-width of each part of a body; lines have the width given."""
    for center, radius in seen.discs:
        yield "rims", [center], radius
        yield "areas", [center], _CORE * radius
    for line, half in seen.bands:
        yield "rims", line, half
        yield "areas", line, _CORE * half
    for lines, half in seen.areas:
        for line in lines:
            yield "areas", line, half
    for line in seen.lines:
        yield "lines", line, width
