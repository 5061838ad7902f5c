"""The plot shows the run, and is refused in one line where it cannot be made."""

import subprocess
import sys
import textwrap
from pathlib import Path

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.record.drawing import PALETTE
from tamias2d.record.plot import plot

from .conftest import with_impacts

pytest.importorskip("matplotlib")


def pixels(path: Path) -> np.ndarray:
    from PIL import Image

    with Image.open(path) as image:
        return np.asarray(image.convert("RGB")).astype(int)


def shown(picture: np.ndarray, index: int) -> int:
    """How many pixels have the colour of a moving body."""
    return int((np.abs(picture - PALETTE[index]).max(axis=-1) < 30).sum())


def test_the_picture_shows_the_bodies(run: t2.Run, tmp_path: Path) -> None:
    path = tmp_path / "plot.png"
    plot(with_impacts(run), path)
    picture = pixels(path)
    assert picture.shape[1] >= 1000
    for index in range(4):  # the moving bodies; the last one is a particle
        assert shown(picture, index) > 30, index
    assert list(tmp_path.iterdir()) == [path]


def test_words_and_units_stand_on_the_axes(run: t2.Run, tmp_path: Path) -> None:
    plot(run, tmp_path / "plot.svg")
    text = (tmp_path / "plot.svg").read_text()
    for words in ("x, m", "y, m", "time, s", "height y of the centre, m", "energy, J", "throw"):
        assert f"<!-- {words}" in text, words


@pytest.mark.parametrize("scene", ["tc2", "tc8", "billiard", "spinning-square"])
def test_scenes_of_the_catalogue(tmp_path: Path, scene: str) -> None:
    plot(t2.simulate(t2.catalogue.load(scene), duration=0.3), tmp_path / "plot.png")
    assert pixels(tmp_path / "plot.png").std() > 5


def test_one_sample_is_enough(tmp_path: Path) -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(t2.Disc(radius=1.0), mass=1.0, position=(5.0, 5.0))
    path = tmp_path / "plot.png"
    plot(t2.simulate(scene, duration=1.0, times=[0.0]), path)
    picture = pixels(path)
    world = picture[:, : picture.shape[1] // 2]  # without the curves, which have its colour too
    assert shown(world, 0) > 30


def test_a_suffix_that_is_no_picture(run: t2.Run, tmp_path: Path) -> None:
    with pytest.raises(t2.InputError, match=r"suffix '\.mp3': a picture is one of .*png"):
        plot(run, tmp_path / "plot.mp3")


@pytest.mark.parametrize("suffix", [".jpg", ".eps", ""])
def test_only_those_pictures_are_drawn_that_are_promised(
    run: t2.Run, tmp_path: Path, suffix: str
) -> None:
    with pytest.raises(t2.InputError, match=r"one of \.png, \.svg, \.pdf, \.gif\. Give"):
        plot(run, tmp_path / f"plot{suffix}")


def test_a_place_that_is_not_there(run: t2.Run, tmp_path: Path) -> None:
    with pytest.raises(t2.RecordingError, match="there is no directory"):
        plot(run, tmp_path / "missing" / "plot.png")


def test_without_matplotlib(tmp_path: Path) -> None:
    code = f"""
        import sys
        sys.modules["matplotlib"] = None
        import tamias2d as t2
        from tamias2d.record.plot import plot
        run = t2.simulate(t2.catalogue.load("tc2"), duration=1.0)
        try:
            plot(run, {str(tmp_path / "plot.png")!r})
        except t2.RecordingError as fault:
            print(fault)
    """
    done = subprocess.run(
        [sys.executable, "-c", textwrap.dedent(code)], capture_output=True, text=True, check=False
    )
    assert '`pip install "tamias2d[plot]"`' in done.stdout, done.stderr


def test_a_chain_is_a_line_and_no_area(tmp_path: Path) -> None:
    """What a valley encloses is air; a fill would colour a quarter of the picture."""
    scene, path = t2.Scene(gravity=(0.0, 0.0)), tmp_path / "plot.png"
    scene.add_static(t2.Chain(vertices=[(-3, 4), (-3, 0), (3, 0), (3, 4)]), restitution=1.0)
    scene.add_body(
        t2.Disc(radius=0.1), mass=1.0, position=(0.0, 2.0), velocity=(1.0, 0.0), restitution=1.0
    )
    plot(t2.simulate(scene, duration=1.0), path)
    assert (pixels(path).min(axis=-1) < 250).mean() < 0.1
