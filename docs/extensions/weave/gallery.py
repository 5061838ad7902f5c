"""The scenes of the catalogue, each with its picture.

Serves: `{gallery}`. Hides: which pictures are still good, and that matplotlib draws them.
"""

import hashlib
from concurrent.futures import ProcessPoolExecutor
from importlib.util import find_spec
from pathlib import Path
from warnings import catch_warnings, simplefilter

from docutils import nodes
from sphinx.application import Sphinx

from tamias2d.errors import SimulationError, StepWarning
from tamias2d.run import Run
from tamias2d.scene import Scene, catalogue
from tamias2d.simulate import simulate
from weave.chapter import WovenDirective
from weave.markdown import fence

PICTURES = "_static/scenes"
_CARD = (4.2, 2.7)  # inches of 96 pixels: about what a card shows
_SHARP = 192  # pixels in an inch of the file
_CROWD = 500  # bodies, of which a picture shows little and takes long


def on_builder_inited(app: Sphinx) -> None:
    """Draw the scenes whose picture is missing or out of date."""
    folder = Path(app.srcdir) / PICTURES
    folder.mkdir(parents=True, exist_ok=True)
    names = [name for name in catalogue.names() if len(catalogue.load(name)) < _CROWD]
    wanted = {folder / file for name in names for file in (_file(name), _small(name))}
    for old in set(folder.glob("*.png")) - wanted:
        old.unlink()
    todo = [name for name in names if not (folder / _file(name)).is_file()]
    if todo and find_spec("matplotlib"):
        with ProcessPoolExecutor() as pool:
            list(pool.map(_draw, todo, [folder] * len(todo)))


def _file(name: str) -> str:
    """The picture's name holds what it was drawn from."""
    import tamias2d

    package = Path(tamias2d.__file__).parent
    files = [Path(__file__), *sorted(package.glob("record/*.py"))]
    sources = [path.read_bytes() for path in files]
    content = b"".join([catalogue.text(name).encode(), *sources])
    return f"{name}-{hashlib.sha256(content).hexdigest()[:8]}.png"


def _small(name: str) -> str:
    return _file(name).replace(".png", "-small.png")


def _draw(name: str, folder: Path) -> None:
    from tamias2d.record.plot import plot

    scene = catalogue.load(name)
    try:
        with catch_warnings():
            simplefilter("ignore", StepWarning)  # a card shows what happens, not how well
            run = simulate(scene, duration=scene.duration or 1.0)
    except SimulationError as refusal:  # up to there
        if not isinstance(refusal.run, Run):
            return
        run = refusal.run
    plot(run, folder / _file(name))
    _draw_small(run, folder / _small(name))


def _draw_small(run: Run, picture: Path) -> None:
    """Draw the bodies and their paths alone, with letters that can be read on a card."""
    from matplotlib.figure import Figure

    from tamias2d.record.plot import draw_world

    figure = Figure(figsize=_CARD, layout="constrained")
    axes = figure.add_subplot()
    draw_world(axes, run)
    axes.set(title="")
    figure.savefig(picture, dpi=_SHARP)


class GalleryDirective(WovenDirective):
    """A card for each scene; with an argument those of the plan's cases, without it the others."""

    def run(self) -> list[nodes.Node]:
        box = nodes.container(classes=["srs-wide"])
        wanted = [n for n in catalogue.names() if n.startswith("tc") == bool(self.arguments)]
        wanted.sort(key=lambda name: name != "showcase")
        cards = "\n".join(_card(name, Path(str(self.env.srcdir))) for name in wanted)
        self.parse(fence("grid", "1 1 2 2", cards, depth=5, gutter="3"), box)
        return [box]


def _card(name: str, docs: Path) -> str:
    scene = catalogue.load(name)
    file = f"{PICTURES}/{_file(name)}"
    shown = {
        "img-top": f"/{PICTURES}/{_small(name)}",
        "img-alt": f"the scene {name}: bodies and their paths",
        "class-img-top": "plot",
        "link": file,
    }
    picture = shown if (docs / file).is_file() else {}
    footer = fence("card-footer", "", f"`tamias2d run {name}`: {_contents(scene)}")
    text = f"{_says(scene)}\n\n{footer}"
    return fence("grid-item-card", name, text, depth=4, **picture)


def _says(scene: Scene) -> str:
    return (scene.says or "").rstrip(".") + "."


def _contents(scene: Scene) -> str:
    moving = sum(body.dynamic for body in scene.bodies)
    still = len(scene.bodies) - moving
    time = f", {scene.duration:g} s" if scene.duration else ""
    return f"{moving} moving, {still} static{time}"
