"""What accuracy costs on a few scenes, measured by the build.

Serves: `{front}` and `{cheapest}`. Hides: which ways are tried, and where results are kept:
in build/fronts, until a source that they rest on changes.
"""

import hashlib
import json
import math
from collections.abc import Iterator, Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx

from tamias2d.scene import catalogue
from weave.chapter import WovenDirective
from weave.markdown import fence, table

SCENES = {"kepler": 10.0, "quadratic-drag": 3.0, "pendulum": 5.0, "bouncing-disc": 1.5}
"""Names of the catalogue, and how long each is simulated, in s."""
CONTACTS = {"incline": 1.0, "dominoes": 1.0, "arch": 1.0}
"""The same of scenes whose contacts are stepped."""
TOLERANCES = (1e-2, 1e-4, 1e-6, 1e-8, 1e-10)
_RUNGS = (16, 64, 256)
_PHASES = 8
_LINE = 1e-6  # the tolerance in the pictures
_RATES = (30, 120, 480)  # steps in a second through contacts
_STARTS = 4  # of such a scene
_LINE_OF_STEPS = 1e-2
_SOURCES = ("study", "study/engines", "motion", "contact", "generated")


def on_builder_inited(app: Sphinx) -> None:
    """Measure the scenes whose results are missing or out of date."""
    folder = _folder(Path(app.srcdir))
    folder.mkdir(parents=True, exist_ok=True)
    every = [*SCENES, *CONTACTS]
    wanted = {folder / _stem(name) for name in every}
    for old in folder.iterdir():
        if old.with_suffix("") not in wanted:
            old.unlink()
    for name in every:
        if not (folder / f"{_stem(name)}.json").is_file():
            _measure(name, folder)


def _folder(docs: Path) -> Path:
    return docs.parent / "build/fronts"


def _stem(name: str) -> str:
    """The files' name holds what they were made from."""
    import tamias2d

    package = Path(tamias2d.__file__).parent
    sources = [Path(__file__)]
    sources += [path for part in _SOURCES for path in sorted((package / part).glob("*.py"))]
    content = b"".join([catalogue.text(name).encode(), *(path.read_bytes() for path in sources)])
    return f"{name}-{hashlib.sha256(content).hexdigest()[:8]}"


def _measure(name: str, folder: Path) -> None:
    from tamias2d.study.plot import plot
    from tamias2d.study.report import as_json, contacts_as_json

    study: Any
    if name in CONTACTS:
        study, line = _contact_study(name), _LINE_OF_STEPS
        said = contacts_as_json(study, tolerance=line)
    else:
        study, line = _study(name), _LINE
        said = as_json(study, tolerance=line)
    if find_spec("matplotlib"):
        plot(study, folder / f"{_stem(name)}.png", tolerance=line)
    text = json.dumps(said)
    (folder / f"{_stem(name)}.json").write_text(text, encoding="utf-8")


def _study(name: str) -> Any:
    from tamias2d.study.phases import phases
    from tamias2d.study.truth import floor_of, truth_of
    from tamias2d.study.work_precision import Study, point_of

    scene, duration = catalogue.load(name), SCENES[name]
    first = truth_of(scene, duration)
    impacts = first.history.run.impacts
    start = float(impacts.time[0]) if len(impacts) else 0.0
    scenes = phases(scene, duration, _PHASES if len(impacts) else 1, first_impact=start)
    truths = [first, *(truth_of(other, duration) for other in scenes[1:])]
    return Study(
        scene=name,
        duration=duration,
        truth=first.how,
        floor=floor_of(first),
        phases=len(scenes),
        impacts=len(impacts),
        points=tuple(point_of(way, scenes, truths, timed=True) for way in _ways(scene)),
        complete=True,
    )


def _contact_study(name: str) -> Any:
    from tamias2d.study.contact_study import contact_study
    from tamias2d.study.stepped_plan import stepped_because

    scene, duration = catalogue.load(name), CONTACTS[name]
    reason = stepped_because(scene, duration) or "as asked"
    return contact_study(
        scene, duration=duration, reason=reason, phases_asked=_STARTS, rates=_RATES
    )


def _ways(scene: Any) -> Iterator[Any]:
    from tamias2d.study.candidates import candidates

    peers = find_spec("pymunk") is not None
    return (way for way in candidates(scene, rungs=_RUNGS) if peers or not way.peer)


class FrontDirective(WovenDirective):
    """The picture of a scene's study."""

    def run(self) -> list[nodes.Node]:
        name = self.arguments[0]
        file = f"{_stem(name)}.png"
        docs = Path(str(self.env.srcdir))
        if not (_folder(docs) / file).is_file():
            return []
        box = nodes.container(classes=["srs-wide"])
        alt = f"error against cost of all methods on the scene {name}"
        image = fence("image", f"/../build/fronts/{file}", "", alt=alt, class_="front plot")
        self.parse(image.replace(":class-:", ":class:"), box)
        return [box]


class CheapestDirective(WovenDirective):
    """For each scene and tolerance, the way within it that computes forces least often."""

    def run(self) -> list[nodes.Node]:
        folder = _folder(Path(str(self.env.srcdir)))
        box = nodes.container(classes=["srs-wide"])
        rows = []
        for name in SCENES:
            found = json.loads((folder / f"{_stem(name)}.json").read_text("utf-8"))
            label = f"`{name}`, {found['duration']:g} s, {found['impacts']} impacts"
            rows.append([label, *(_cheapest(found["points"], most) for most in TOLERANCES)])
        head = ["scene", *(f"within {tolerance:g}" for tolerance in TOLERANCES)]
        self.parse(table(head, rows), box)
        return [box]


def _cheapest(points: Sequence[dict[str, Any]], tolerance: float) -> str:
    own = [point for point in points if not point["peer"] and _error(point) <= tolerance]
    if not own:
        return "none that was tried"
    best = min(own, key=_cost)
    forces = best["cost"]["force_evaluations"]
    way = f"{best['method']} {best['setting']}".strip()
    milliseconds = float(f"{best['seconds']['minimum'] * 1e3:.2g}")
    return f"{way}: {forces}, {milliseconds:g} ms"


def _error(point: dict[str, Any]) -> float:
    size = point["error"] and point["error"]["size"]
    return math.inf if size is None else size


def _cost(point: dict[str, Any]) -> tuple[float, float]:
    return point["cost"]["force_evaluations"], point["seconds"]["minimum"]
