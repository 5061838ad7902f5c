"""How the worlds of an ensemble spread: shares of their values, in numbers and as a picture."""

from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from tamias2d.ensemble.dataset import WORLDS
from tamias2d.errors import SimulationError
from tamias2d.record import drawing
from tamias2d.record.dataset import BODIES, TIMES
from tamias2d.record.plot import NAMED, figure_for, save_figure
from tamias2d.state import Array

SHARES = (0.05, 0.25, 0.5, 0.75, 0.95)
"""Of the worlds that are below a line of the picture."""
_DRAWN = 20_000  # worlds: more would not be seen
_BINS = 50


class Spread(NamedTuple):
    """How one coordinate of one body spreads over the worlds at the end."""

    body: str
    axis: str
    mean: float
    deviation: float
    """Standard deviation."""
    low: float
    """Below which 5 % of the worlds are."""
    median: float
    high: float
    """Below which 95 % of the worlds are."""


def spreads(dataset: Any) -> list[Spread]:
    """Return how the positions at the end spread, m; NaN where no world has an answer."""
    last = dataset.position.isel({TIMES: -1})
    found = []
    for k, name in enumerate(dataset[BODIES].values.tolist()):
        rows = last.isel({BODIES: k}).values
        rows = rows[np.isfinite(rows).all(axis=1)]
        for axis, values in zip("xy", rows.T, strict=True):
            if not len(values):
                found.append(Spread(name, axis, *[float("nan")] * 5))
                continue
            low, _, median, _, high = np.quantile(values, SHARES).tolist()
            mean, deviation = float(values.mean()), float(values.std())
            found.append(Spread(name, axis, mean, deviation, low, median, high))
    return found


def plot(dataset: Any, path: str | Path) -> None:
    """Draw the bands in which the positions of the first bodies lie, and where they end.

    The kind of picture follows from the suffix: `.png`, `.svg`, `.pdf`.

    Raises:
        InputError: no kind of picture has this suffix.
        RecordingError: matplotlib is not installed, or the file cannot be written.
        SimulationError: all worlds were refused.
    """
    path = Path(path)
    figure = figure_for(path)
    names = dataset[BODIES].values.tolist()[:NAMED]
    some = dataset.position.isel({WORLDS: slice(_DRAWN), BODIES: slice(len(names))}).values
    some = some[np.isfinite(some).all(axis=(1, 2, 3))]
    if not len(some):
        raise SimulationError(
            f"{path}: no world has an answer, so that there is nothing to draw (R8). Look at "
            "`outcome`."
        )
    panels = figure.subplots(2, 2, width_ratios=[3, 2], sharey="row")
    for axis, (bands, ends) in enumerate(panels):
        for k, name in enumerate(names):
            _bands(bands, dataset[TIMES].values, some[:, :, k, axis], _colour(k), name)
        last, (lowest, highest) = some[:, -1, :, axis], bands.get_ylim()
        bins = np.linspace(min(lowest, last.min()), max(highest, last.max()), _BINS + 1)
        for k in range(len(names)):
            style = {"alpha": 0.6, "orientation": "horizontal", "color": _colour(k)}
            ends.hist(last[:, k], bins=bins, **style)
        ends.locator_params(axis="x", integer=True)
        bands.set(ylabel=f"{'xy'[axis]}, m")
        bands.margins(x=0)
    panels[0, 0].set_title(f"90 % and half of {len(some)} worlds, and their median", size="medium")
    panels[0, 1].set_title(f"worlds at {dataset[TIMES].values[-1]:.4g} s", size="medium")
    panels[1, 0].set(xlabel="time, s")
    panels[1, 1].set(xlabel="worlds")
    panels[0, 0].legend(frameon=False, fontsize="small")
    save_figure(figure, path)


def _colour(k: int) -> tuple[float, ...]:
    return tuple(channel / 255 for channel in drawing.PALETTE[k % len(drawing.PALETTE)])


def _bands(axes: Any, times: Array, values: Array, colour: Any, name: str) -> None:
    lowest, low, median, high, highest = np.quantile(values, SHARES, axis=0)
    axes.fill_between(times, lowest, highest, color=colour, alpha=0.2, linewidth=0)
    axes.fill_between(times, low, high, color=colour, alpha=0.3, linewidth=0)
    axes.plot(times, median, color=colour, linewidth=1.2, label=name)
