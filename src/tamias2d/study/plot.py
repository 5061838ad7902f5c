"""A picture of a study: error against cost, in seconds and in force evaluations.

Each method is a line and the front is marked. Other engines are grey; candidates whose error is
off the scale are crosses on the rim, and methods of which nothing was measured stand in the legend.
Only this module of `study` draws.
"""

import io
import math
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import Any

from tamias2d.float64 import EPSILON
from tamias2d.record.plot import figure_for
from tamias2d.storage import write_aside
from tamias2d.study.contact_errors import ContactErrors
from tamias2d.study.contact_study import ContactPoint, ContactStudy
from tamias2d.study.work_precision import Point, Study

_COLOURS = {
    "ClosedForm": "#111111",
    "ExplicitEuler": "#d62728",
    "SemiImplicitEuler": "#e67828",
    "VelocityVerlet": "#bcaa22",
    "ExponentialDrag": "#8c564b",
    "RungeKutta4": "#3c8cdc",
    "Yoshida4": "#46aa64",
    "DormandPrince5": "#966ed2",
    "Dop853": "#c85082",
    "Reference": "#28a5af",
    "pyb2d3": "#555555",
}
_GREY = "#999999"
_MARKS = {"ClosedForm": "D", "Pymunk": "s", "pyb2d3": "^"}
_PEERS = {"Pymunk": "s", "pyb2d3": "^"}
_PASSES = {
    ("Stepped", 1): "#e67828",
    ("Stepped", 4): "#3c8cdc",
    ("Stepped", 16): "#46aa64",
    ("Pymunk", 40): "#666666",
    ("pyb2d3", 4): "#bbbbbb",
    ("pyb2d3", 16): "#777777",
}
_FEW_POWERS = 2  # of ten on an axis: fewer are no scale
_PASSED = "passes through the contacts (seconds were not measured)"
CostOf = Callable[[Point], float | None]
CostOfContacts = Callable[[ContactPoint], float | None]


def plot(study: Study | ContactStudy, path: str | Path, *, tolerance: float | None) -> None:
    """Draw a study; the kind of picture follows from the suffix: `.png`, `.svg`, `.pdf`.

    Raises:
        InputError: no kind of picture has this suffix.
        RecordingError: matplotlib is not installed.
        OSError: the file cannot be written.
    """
    path = Path(path)
    figure = figure_for(path)
    figure.set(size_inches=(12, 6), layout_engine="constrained")
    draw = _draw_contacts if isinstance(study, ContactStudy) else _draw_study
    draw(figure, study, tolerance)  # type: ignore[arg-type]
    drawn = io.BytesIO()
    figure.savefig(drawn, format=path.suffix[1:], dpi=120)
    write_aside(path, drawn.getvalue())


def _draw_study(figure: Any, study: Study, tolerance: float | None) -> None:
    left, right = figure.subplots(1, 2, sharex=True)
    _draw(left, study, _seconds, study.fastest, "seconds, shortest of the runs")
    _draw(right, study, _evaluations, study.leanest, "force evaluations, with 1 for none")
    _rim(right, study, _evaluations)
    for axes in (left, right):
        _limits(axes, study, tolerance)
    _rim(left, study, _seconds)
    _mark(left, right)
    _texts(figure, (left, right), study)


def _draw_contacts(figure: Any, study: ContactStudy, tolerance: float | None) -> None:
    """Draw what runs cost against the error of places, and against overlap and energy.

    That are seconds, or passes through the contacts where the study was stopped before its timing.
    """
    left, right = figure.subplots(1, 2)
    timed = any(point.seconds for point in study.points)
    cost, label = (_median, "seconds, median of runs in turns") if timed else (_sweeps, _PASSED)
    for axes, size, floor, chosen in (
        (left, _place, study.floor, study.fastest if timed else study.leanest),
        (right, _quality, 0.0, study.soundest),
    ):
        errors = {
            k: max(size(point.error), floor)
            for k, point in enumerate(study.points)
            if point.error and cost(point) is not None
        }
        errors = {k: error for k, error in errors.items() if 0 < error < math.inf}
        _lines(axes, study, errors, cost)
        _worst(axes, study, errors, size, cost)
        front = [k for k in chosen if k in errors]
        _front(axes, [errors[k] for k in front], [cost(study.points[k]) for k in front])
        axes.set(xscale="log", yscale="log", ylabel=f"cost: {label}")
        axes.grid(visible=True, which="major", alpha=0.25)
        if not errors:
            axes.set(xlim=(EPSILON, 1.0), ylim=(1.0, 10.0))  # there is nothing to show
    if study.floor > 0:
        left.set_xlim(left=study.floor / 2)
        left.axvspan(study.floor / 2, study.floor, color=_GREY, alpha=0.15, linewidth=0)
    _mark(left, right)
    left.set_xlabel(
        f"places up to the horizon of {study.horizon:.3g} s, against {study.truth},\n"
        "relative to the way of the farthest body;\n"
        f"median of {study.phases} starts, bars to the worst; grey: nothing is known"
    )
    right.set_xlabel("overlap, relative to the smaller body's radius,\nor energy from nothing")
    if tolerance is not None:
        left.axvline(tolerance, color="black", linewidth=1.2, linestyle="--")
    figure.suptitle(f"{study.scene}, {study.duration:g} s: what accuracy costs", fontsize="x-large")
    measured = {point.method for point in study.points if point.error and cost(point) is not None}
    _legend(figure, (left,), _others(study.points, measured))


def _others(points: Sequence[Point | ContactPoint], measured: set[str]) -> list[str]:
    """Return the methods of which nothing was measured."""
    return [each for each in dict.fromkeys(p.method for p in points) if each not in measured]


def _legend(figure: Any, every: Iterable[Any], others: list[str]) -> None:
    """Name what is drawn, and what cannot be."""
    from matplotlib.lines import Line2D

    named: dict[str, Any] = {}
    for axes in every:
        for handle, label in zip(*axes.get_legend_handles_labels(), strict=True):
            named.setdefault(label, handle)
    for method in others:
        named[f"{method}: nothing was measured"] = Line2D([], [], linestyle="none")
    figure.legend(
        named.values(), named.keys(), loc="outside right upper", frameon=False, fontsize="small"
    )


def _median(point: ContactPoint) -> float | None:
    return point.seconds.median if point.seconds else None


def _sweeps(point: ContactPoint) -> float | None:
    return float(point.sweeps)


def _place(error: ContactErrors) -> float:
    return error.size


def _quality(error: ContactErrors) -> float:
    return error.quality


def _lines(axes: Any, study: ContactStudy, errors: dict[int, float], cost: CostOfContacts) -> None:
    """Draw a line for each engine and number of passes, from long to short steps."""
    lines: dict[tuple[str, int], list[int]] = {}
    for k in errors:
        point = study.points[k]
        lines.setdefault((point.method, point.passes), []).append(k)
    for (method, passes), places in lines.items():
        axes.plot(
            [errors[k] for k in places],
            [cost(study.points[k]) for k in places],
            marker=_PEERS.get(method, "o"),
            markersize=4.5,
            linewidth=1.1,
            color=_PASSES.get((method, passes), _GREY),
            zorder=1 if method in _PEERS else 2,
            label=f"{method} x {passes}",
        )


def _worst(
    axes: Any,
    study: ContactStudy,
    errors: dict[int, float],
    size: Callable[[ContactErrors], float],
    cost: CostOfContacts,
) -> None:
    """Draw from the median to the worst of the starts."""
    for k, error in errors.items():
        point = study.points[k]
        worst = size(point.worst) if point.worst else math.inf
        if error < worst < math.inf:
            colour = _PASSES.get((point.method, point.passes), _GREY)
            height = [cost(point)] * 2
            axes.plot([error, worst], height, color=colour, linewidth=2.5, alpha=0.25, zorder=1)


def _front(axes: Any, errors: list[float], costs: list[float | None]) -> None:
    axes.plot(
        errors,
        costs,
        drawstyle="steps-pre",
        marker="o",
        markersize=10,
        markerfacecolor="none",
        color="black",
        linewidth=0.8,
        linestyle=":",
        zorder=3,
        label="front: nothing is both cheaper and better",
    )


def _seconds(point: Point) -> float | None:
    return point.seconds.minimum if point.seconds else None


def _evaluations(point: Point) -> float | None:
    return max(point.cost.force_evaluations, 1) if point.cost else None


def _draw(axes: Any, study: Study, cost: CostOf, front: list[int], label: str) -> None:
    for method in dict.fromkeys(point.method for point in study.points):
        own = [point for point in study.points if point.method == method and _placed(point, cost)]
        if not own:
            continue
        peer = any(point.peer for point in own)
        axes.plot(
            [_error(point, study) for point in own],
            [cost(point) for point in own],
            marker=_MARKS.get(method, "o"),
            markersize=4.5,
            linewidth=1.1,
            color=_COLOURS.get(method, _GREY),
            zorder=1 if peer else 2,
            label=method,
        )
        if study.phases > 1:
            _spread(axes, own, study, cost, _COLOURS.get(method, _GREY))
    chosen = [point for k in front if _placed(point := study.points[k], cost)]
    _front(axes, [_error(point, study) for point in chosen], [cost(point) for point in chosen])
    if not any(_placed(point, cost) for point in study.points):
        axes.set_ylim(1.0, 10.0)  # there is only the rim
    axes.set(xscale="log", yscale="log", ylabel=f"cost: {label}")
    axes.grid(visible=True, which="major", alpha=0.25)


def _spread(axes: Any, own: list[Point], study: Study, cost: CostOf, colour: str) -> None:
    """Draw from the median to the worst of the phases."""
    for point in own:
        worst = point.worst.size if point.worst else math.inf
        if math.isfinite(worst):
            ends = [_error(point, study), max(worst, study.floor)]
            axes.plot(ends, [cost(point)] * 2, color=colour, linewidth=2.5, alpha=0.25, zorder=1)


def _placed(point: Point, cost: CostOf) -> bool:
    return point.valid and cost(point) is not None


def _error(point: Point, study: Study) -> float:
    size = point.error.size if point.error else math.inf
    return max(size, study.floor)


def _limits(axes: Any, study: Study, tolerance: float | None) -> None:
    axes.set_xlim(study.floor / 3, 3.0)
    axes.axvspan(study.floor / 3, study.floor, color=_GREY, alpha=0.15, linewidth=0)
    if tolerance is not None:
        axes.axvline(tolerance, color="black", linewidth=1.2, linestyle="--")
        axes.annotate(
            f"tolerance {tolerance:g}",
            (tolerance, 1.01),  # above: within it would lie over lines
            xycoords=("data", "axes fraction"),
            ha="center",
            va="bottom",
            fontsize="small",
        )


def _mark(*every: Any) -> None:
    """Label powers of ten; and twos and fives between, where an axis has hardly a power of ten."""
    from matplotlib.ticker import LogFormatterSciNotation, LogLocator, NullFormatter

    for axes in every:
        for axis, (low, high) in ((axes.xaxis, axes.get_xlim()), (axes.yaxis, axes.get_ylim())):
            powers = math.floor(math.log10(high)) - math.ceil(math.log10(low)) + 1
            narrow = powers < _FEW_POWERS
            axis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0) if narrow else (1.0,)))
            shown = (math.inf, math.inf) if narrow else None
            axis.set_major_formatter(LogFormatterSciNotation(minor_thresholds=shown))
            axis.set_minor_formatter(NullFormatter())


def _rim(axes: Any, study: Study, cost: CostOf) -> None:
    """Put on the right rim what has a cost, and an error that says nothing."""
    for point in study.points:
        if not point.valid and (value := cost(point)) is not None:
            axes.plot(
                2.2,
                value,
                marker="x",
                markersize=7,
                markeredgewidth=1.6,
                color=_GREY if point.peer else _COLOURS.get(point.method, _GREY),
                clip_on=False,
                zorder=4,
            )


def _texts(figure: Any, every: Iterable[Any], study: Study) -> None:
    over = f"median of {study.phases} phases, bars to the worst" if study.phases > 1 else "one run"
    measure = "positions, times and states of impacts" if study.impacts else "positions"
    figure.suptitle(f"{study.scene}, {study.duration:g} s: what accuracy costs", fontsize="x-large")
    figure.supxlabel(
        f"relative error of {measure}: {over}, against {study.truth}\n"
        f"grey, below {study.floor:.0e}: the truth is not known so well; "
        "crosses: wrong by more than the whole motion",
        fontsize="medium",
    )
    measured = {point.method for point in study.points if point.cost or point.seconds}
    _legend(figure, every, _others(study.points, measured))
