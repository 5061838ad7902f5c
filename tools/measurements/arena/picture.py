"""Speed and quality of each engine side by side, as a picture for the docs.

Serves: the measurement of contacts. Hides: matplotlib.
"""

import io
from pathlib import Path
from typing import Any

from tamias2d.storage import write_aside

_COLOURS = {"Tamias2D": "#8a3d0f", "Pymunk": "#9a9a9a", "pyb2d3": "#0b5c82"}
_BAR = 0.26
_LEAST, _MOST = 1e-4, 1.0  # of a radius: a scale by powers of ten has no zero, and what is deeper
# than a whole radius is through


def draw(found: dict[str, Any], folder: Path) -> None:
    """Write `contacts.png`, and `contacts-growth.png` if that was measured.

    Raises:
        OSError: a file cannot be written.
    """
    scenes = list(found["engines"])
    figure = _figure(11, 0.55 * len(scenes) + 1.4)
    speed, depth = figure.subplots(1, 2, sharey=True)
    for k, name in enumerate(_COLOURS):
        heights = [place + (k - 1) * _BAR for place in range(len(scenes))]
        rows = [found["engines"][scene][name] for scene in scenes]
        longer = [_times(found, scene, name) - 1 for scene in scenes]
        _bars(speed, heights, longer, name, left=1.0)
        _bars(depth, heights, [_shown(row["relative_penetration"]) for row in rows], name)
    speed.set(
        title="Time of a step over that of Tamias2D",
        xlabel="to the right of 1 it is slower than Tamias2D",
    )
    depth.set(
        title="Deepest overlap, of a radius",
        xlabel="to the right is worse; what is deeper than 100% is cut off",
    )
    speed.axvline(1, color=_COLOURS["Tamias2D"], linewidth=3)
    speed.set_yticks(range(len(scenes)), scenes)
    speed.invert_yaxis()
    for axes, form in ((speed, "{x:g}"), (depth, _percent)):
        axes.set_xscale("log")
        _plain(axes)
        axes.minorticks_off()
        axes.xaxis.set_major_formatter(form)
    _ticks(speed)
    figure.legend(*depth.get_legend_handles_labels(), loc="outside upper center", ncols=3)
    _save(figure, folder / "contacts.png")
    if "growth" in found:
        _draw_growth(found["growth"], folder / "contacts-growth.png")


def _ticks(axes: Any) -> None:
    """Mark 1, 2 and 5 of each power of ten that is in sight."""
    low, high = axes.get_xlim()
    marks = [digit * 10.0**power for power in range(-3, 5) for digit in (1, 2, 5)]
    axes.set_xticks([mark for mark in marks if low <= mark <= high])


def _draw_growth(rows: list[dict[str, Any]], path: Path) -> None:
    figure = _figure(6, 4)
    axes = figure.subplots()
    bodies = [row["bodies"] for row in rows]
    for name, colour in _COLOURS.items():
        times = [row["seconds"][name] * 1e3 for row in rows]
        axes.plot(bodies, times, "o-", color=colour, label=name)
    axes.set(xscale="log", yscale="log", xlabel="falling discs", ylabel="ms of a step")
    axes.set_xticks(bodies, [f"{number:,}" for number in bodies])
    axes.minorticks_off()
    _plain(axes)
    axes.legend()
    _save(figure, path)


def _figure(width: float, height: float) -> Any:
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=(width, height), layout="constrained")
    FigureCanvasAgg(figure)
    return figure


def _plain(axes: Any) -> None:
    axes.grid(axis="both" if axes.get_ylabel() else "x", which="major", linewidth=0.4)
    axes.set_axisbelow(True)
    axes.spines[["top", "right"]].set_visible(False)


def _save(figure: Any, path: Path) -> None:
    drawn = io.BytesIO()
    figure.savefig(drawn, format="png", dpi=110)
    write_aside(path, drawn.getvalue())


def _percent(share: float, _: object) -> str:
    return f"{100 * share:g}%"


def _shown(share: float) -> float:
    return min(max(share, _LEAST), _MOST)


def _times(found: dict[str, Any], scene: str, name: str) -> float:
    return float(found["scenes"][scene].get(f"ratio_to_{name.lower()}", 1.0))


def _bars(
    axes: Any, heights: list[float], widths: list[float], name: str, *, left: float = 0.0
) -> None:
    colour = _COLOURS[name]
    axes.barh(heights, widths, height=_BAR, left=left, color=colour, label=name)
