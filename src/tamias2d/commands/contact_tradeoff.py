"""A study of stepped contacts as tables for people."""

from tamias2d.commands.failures import print_failures
from tamias2d.commands.output import error_text, figure, print_table, say
from tamias2d.study.contact_study import ContactPoint, ContactStudy


def print_contacts(found: ContactStudy, name: str, tolerance: float | None) -> None:
    """Print the points of a study, its fronts, and how runs end."""
    say(f"{name}: {figure(found.duration)} s, medians over {found.phases} starts next to another")
    say(f"Contacts are stepped: {found.reason}.")
    say(
        f"Places are compared with {found.truth}, up to the horizon of {figure(found.horizon)} s: "
        f"until then runs of short steps agree. Errors of places below {found.floor:.0e} say "
        "nothing."
    )
    heads = ["front", "method", "setting", "places", "centre", "contact times", "missed", "extra"]
    heads += ["overlap", "energy", "momentum", "hang", "rest", "seconds"]
    if tolerance is not None:
        heads.append(f"within {tolerance:g}")
    say()
    print_table(heads, (_row(found, k, tolerance) for k in range(len(found.points))))
    _print_statistics(found)
    print_failures(found)
    say(
        "\nfront: nothing is both cheaper and better: in places by seconds (s) and by passes "
        "through the contacts (p), in overlap and energy by seconds (q). Seconds are those of the "
        "processor, medians of runs in turns without reading anything, and differ each time."
    )


def _row(found: ContactStudy, k: int, tolerance: float | None) -> list[str]:
    point, error = found.points[k], found.points[k].error
    if error is None:
        return ["", point.method, point.setting, "none"]
    marks = (("s", found.fastest), ("p", found.leanest), ("q", found.soundest))
    front = "".join(mark for mark, places in marks if k in places)
    places = error_text(error.position)
    cells = [front, point.method, point.setting]
    cells.append(places if error.position > found.floor else f"<= {found.floor:.0e}")
    cells += [_measure(error.centre), _measure(error.event_time)]
    cells += ["-" if n is None else f"{n:g}" for n in (error.missed, error.extra)]
    shares = (error.overlap, error.energy, error.momentum, error.hang, error.rest)
    cells += [_measure(value) for value in shares]
    cells.append(f"{point.seconds.median:.2g}" if point.seconds else "-")
    if tolerance is not None:
        cells.append("yes" if error.position <= tolerance else "no")
    return cells


def _print_statistics(found: ContactStudy) -> None:
    """Print how runs end: all that can be said of them after the horizon."""
    say(f"\nAt {figure(found.duration)} s: means and 95 % intervals over {found.phases} starts")
    rows = [("answer", found.truth, *_means(found.statistics))]
    rows += [(p.method, p.setting, *_means(p.statistics)) for p in _cheap(found)]
    heads = ("method", "setting", "height of centre, m", "extent, m", "kinetic energy, J")
    print_table(heads, rows)


def _cheap(found: ContactStudy) -> list[ContactPoint]:
    """Return the points whose ends are printed: one of each method, at most, of 60 steps a second.

    All are in the JSON.
    """
    usual = [p for p in found.points if p.statistics]
    chosen: dict[str, ContactPoint] = {}
    for point in usual:
        if point.steps <= 60 * found.duration + 1:
            chosen[point.method] = point
    return list(chosen.values())


def _means(statistics: dict[str, tuple[float, float]] | None) -> list[str]:
    found = statistics or {}
    return [f"{mean:.5g} +- {half:.1g}" for mean, half in found.values()]


def _measure(value: float | None) -> str:
    return "-" if value is None else error_text(value)
