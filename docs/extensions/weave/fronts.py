"""What accuracy costs on scenes of all kinds, drawn from what was measured.

Serves: `{front}` and `{fastest}`. Hides: where measurements are stored, and which pictures of them
are still good: those in build/fronts whose names hold what they were drawn from.
"""

import hashlib
import json
import math
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx

from weave.chapter import WovenDirective
from weave.markdown import fence, table

TOLERANCES = (1e-2, 1e-4, 1e-6, 1e-8)
_ENGINES = ("Tamias2D", "Pymunk", "pyb2d3")


def on_builder_inited(app: Sphinx) -> None:
    """Draw the studies whose pictures are missing or out of date."""
    docs = Path(app.srcdir)
    folder = _folder(docs)
    folder.mkdir(parents=True, exist_ok=True)
    wanted = {_picture(docs, path.stem): path for path in sorted(_stored(docs).glob("*.json"))}
    for old in folder.iterdir():
        if old not in wanted:
            old.unlink()
    if find_spec("matplotlib"):
        for picture, path in wanted.items():
            if not picture.is_file():
                _draw(json.loads(path.read_text("utf-8")), picture)


def _stored(docs: Path) -> Path:
    return docs / "measured/fronts"


def _folder(docs: Path) -> Path:
    return docs.parent / "build/fronts"


def _picture(docs: Path, name: str) -> Path:
    """The picture's name holds what it is drawn from."""
    from tamias2d.study import plot, stored

    sources = [_stored(docs) / f"{name}.json", *(Path(m.__file__ or "") for m in (plot, stored))]
    content = b"".join(path.read_bytes() for path in sources)
    return _folder(docs) / f"{name}-{hashlib.sha256(content).hexdigest()[:8]}.png"


def _draw(data: dict[str, Any], picture: Path) -> None:
    from tamias2d.study.plot import plot
    from tamias2d.study.stored import study_from_json

    plot(study_from_json(data), picture, tolerance=data["tolerance"])


class FrontDirective(WovenDirective):
    """The picture of a scene's study."""

    def run(self) -> list[nodes.Node]:
        name = self.arguments[0]
        picture = _picture(Path(str(self.env.srcdir)), name)
        if not picture.is_file():
            return []
        box = nodes.container(classes=["srs-wide"])
        alt = f"error against cost of all methods on the scene {name}"
        image = fence("image", f"/../build/fronts/{picture.name}", "", alt=alt, class_="front plot")
        self.parse(image.replace(":class-:", ":class:"), box)
        return [box]


class FastestDirective(WovenDirective):
    """The fastest way of each engine within each tolerance, for each of the scenes named."""

    required_arguments = 1
    optional_arguments = 0  # with more, a parser splits the names between the arguments

    def run(self) -> list[nodes.Node]:
        stored = _stored(Path(str(self.env.srcdir)))
        box = nodes.container(classes=["srs-wide"])
        rows = (fastest_row(stored, name) for name in self.arguments[0].split())
        head = ["scene", *(f"within {tolerance:g}" for tolerance in TOLERANCES)]
        self.parse(table(head, rows), box)
        return [box]


def fastest_row(stored: Path, name: str) -> list[str]:
    """The cells of a scene: within each tolerance the fastest way of each engine."""
    study = json.loads((stored / f"{name}.json").read_text("utf-8"))
    label = f"`{name}`, {study['duration']:g} s"
    return [label, *("<br>".join(_fastest(study, most)) for most in TOLERANCES)]


def _fastest(study: dict[str, Any], tolerance: float) -> Iterator[str]:
    for engine in _ENGINES:
        own = [
            point
            for point in study["points"]
            if (point["method"] if point["peer"] else _ENGINES[0]) == engine
            and point["seconds"]
            and _error(point) <= tolerance
        ]
        if not own:
            yield f"{engine}: -"
            continue
        best = min(own, key=_seconds)
        way = best["setting"] if best["peer"] else f"{best['method']} {best['setting']}".strip()
        yield f"{engine}: **{_seconds(best) * 1e3:.2g} ms**, {way}"


def _error(point: dict[str, Any]) -> float:
    """Return that of places, and of impacts where these are located."""
    error = point["error"] or {}
    size = error.get("size", error.get("position"))
    return math.inf if size is None else float(size)


def _seconds(point: dict[str, Any]) -> float:
    return float(point["seconds"]["median"])
