"""The two pictures of the README: `python -m tools.pictures` makes them anew in docs/pictures/.

The viewer's picture needs a Vulkan driver (on Debian: mesa-vulkan-drivers), but no screen.
"""

from __future__ import annotations

import os
import socket
import tempfile
import time
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

import tamias2d as t2
from tamias2d.record.plot import plot

if TYPE_CHECKING:
    from collections.abc import Iterator

PICTURES = Path(__file__).parent.parent / "docs" / "pictures"
SCENE = "showcase"
INSTANT = 1.1
"""s; just after the discs have met the floor."""
WIDTH = 1320
"""Pixels of the viewer's picture."""
PATIENCE = 60.0
"""s that the viewer may take to load a recording."""
SETTLED = 1.0
"""s that the viewer is given to draw everything."""


@contextmanager
def headless_viewer() -> Iterator[Any]:
    """Start a viewer without a window; gives its client, and ends it.

    Raises:
        ConnectionError: the viewer does not start: there is no Vulkan driver.
    """
    from rerun.experimental import ViewerClient

    from tamias2d.record.rerun.program import program

    before = os.environ.get("CI")
    os.environ["CI"] = "true"  # so that it neither collects nor sends usage statistics
    try:
        client = ViewerClient.spawn(
            headless=True, port=_free_port(), executable_path=str(program())
        )
    finally:
        os.environ.pop("CI") if before is None else os.environ.update(CI=before)
    try:
        time.sleep(SETTLED)
        client.get_state()  # without a driver it has gone by now
        yield client
    finally:
        client.quit()


def look(client: Any, recording: Path) -> None:
    """Open a recording, and wait until it is loaded; raise `TimeoutError` if it never is."""
    client.open(str(recording.absolute()))
    until = time.monotonic() + PATIENCE
    while not client.get_state().views:
        if time.monotonic() > until:
            raise TimeoutError(f"{recording}: the viewer does not show it.")
        time.sleep(0.1)
    time.sleep(SETTLED)


def show(client: Any, instant: float) -> None:
    """Set the time, in s, and wait until it is drawn."""
    moment = np.timedelta64(round(instant * 1e9), "ns")
    client.set_time("sim_time", duration=moment, play_state="paused")
    time.sleep(SETTLED)


def _free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])


def _crop(picture: Path) -> None:
    """Cut off the bars of the program, and keep a size that a page can carry."""
    from PIL import Image

    with Image.open(picture) as image:
        inner = image.convert("RGB").crop((0, 36, image.width, image.height - 30))
        height = round(WIDTH * inner.height / inner.width)
        small = inner.resize((WIDTH, height), Image.Resampling.LANCZOS)
    small.save(picture, optimize=True)


def main() -> None:
    """Make both pictures."""
    PICTURES.mkdir(parents=True, exist_ok=True)
    scene = t2.catalogue.load(SCENE)
    run = t2.simulate(scene, duration=scene.duration or 1.0)
    plot(run, PICTURES / "plot.png")
    with tempfile.TemporaryDirectory() as folder:
        recording = Path(folder, f"{SCENE}.rrd")
        run.save(recording)
        with headless_viewer() as client:
            look(client, recording)
            show(client, INSTANT)
            client.save_screenshot(str(PICTURES / "viewer.png"))
    _crop(PICTURES / "viewer.png")


if __name__ == "__main__":
    main()
