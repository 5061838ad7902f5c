"""The recording as the viewer draws it: the bodies in their colours, where they are, y up."""

import io
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.record.drawing import PALETTE
from tools.pictures import headless_viewer, look, show

pytestmark = pytest.mark.viewer

RADIUS = 0.8
SPEED = 4.0


@pytest.fixture(scope="module")
def client() -> Iterator[Any]:
    pytest.importorskip("rerun")
    try:
        with headless_viewer() as client:
            yield client
    except ConnectionError as fault:
        pytest.skip(f"the viewer does not start, most likely without a Vulkan driver: {fault}")


@pytest.fixture(scope="module")
def viewer(client: Any, tmp_path_factory: pytest.TempPathFactory) -> Any:
    """Two discs that stay give the scale of the picture; a third goes up, a box turns about."""
    scene = t2.Scene(gravity=(0.0, 0.0), name="viewer test")
    for place, velocity in (((-4.0, -1.0), 0.0), ((4.0, -1.0), 0.0), ((-1.0, -1.0), SPEED)):
        disc = t2.Disc(radius=RADIUS)
        scene.add_body(disc, mass=1.0, position=place, velocity=(0.0, velocity), restitution=1.0)
    box = t2.Box(width=2.0, height=0.5)
    scene.add_body(box, mass=1.0, position=(1.5, 1.0), angular_velocity=np.pi, restitution=1.0)
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=-2.0), name="floor")
    path = tmp_path_factory.mktemp("viewer") / "run.rrd"
    t2.simulate(scene, duration=1.0).save(path)
    look(client, path)
    return client


def world(client: Any, instant: float) -> np.ndarray[Any, Any]:
    """Pixels (height, width, 3) of the view of the world, at a time in s."""
    from PIL import Image

    show(client, instant)
    (view,) = [view for view in client.get_state().views if view.view_class == "2D"]
    before = b""
    while (picture := client.take_screenshot(view.view_id)) != before:  # until nothing moves
        before = picture
    return np.asarray(Image.open(io.BytesIO(picture)).convert("RGB"))


def found(picture: np.ndarray[Any, Any], index: int) -> tuple[np.ndarray[Any, Any], ...]:
    """Lower and upper corner (x, y) of all pixels in the colour of a body; y down."""
    near = np.abs(picture.astype(int) - PALETTE[index]).max(axis=-1) < 12
    assert near.sum() > 50, f"body {index} is not in the picture"
    y, x = np.nonzero(near)
    return np.array([x.min(), y.min()]), np.array([x.max(), y.max()])


def center(picture: np.ndarray[Any, Any], index: int) -> np.ndarray[Any, Any]:
    low, high = found(picture, index)
    return (low + high) / 2


def scale(picture: np.ndarray[Any, Any]) -> float:
    """Pixels per metre, from the two discs that stay 8 m apart."""
    across = center(picture, 1) - center(picture, 0)
    assert abs(across[1]) <= 1
    return float(across[0] / 8.0)


@pytest.mark.parametrize("instant", [0.0, 0.25, 0.75])
def test_bodies_are_where_the_run_says(viewer: Any, instant: float) -> None:
    picture = world(viewer, instant)
    pixels = scale(picture)
    expected = center(picture, 0) + pixels * np.array([3.0, -SPEED * instant])
    assert center(picture, 2) == pytest.approx(expected, abs=0.04 * pixels)
    low, high = found(picture, 2)
    assert high - low == pytest.approx(2 * RADIUS * pixels, abs=0.1 * pixels)


def test_a_body_is_turned_as_the_run_says(viewer: Any) -> None:
    sizes = {}
    for instant in (0.0, 0.5):  # a quarter turn apart
        picture = world(viewer, instant)
        low, high = found(picture, 3)
        sizes[instant] = (high - low) / scale(picture)
    assert sizes[0.0] == pytest.approx((2.0, 0.5), abs=0.1)
    assert sizes[0.5] == pytest.approx((0.5, 2.0), abs=0.1)


def test_the_ground_is_below(viewer: Any) -> None:
    picture = world(viewer, 0.0)
    floor = center(picture, 0)[1] + 1.0 * scale(picture)
    row = picture[round(floor) - 2 : round(floor) + 3].astype(int)
    assert (np.abs(row - (130, 135, 140)).max(axis=-1) < 25).any(axis=0).mean() > 0.9


def test_no_view_reports_an_error(viewer: Any) -> None:
    views = viewer.get_state().views
    assert {view.view_class for view in views} >= {"2D", "TimeSeries", "TextDocument", "TextLog"}
    assert not [(view.name, view.reports) for view in views if view.reports]
    assert not [entry for entry in viewer.get_logs() if entry.level == "ERROR"]
