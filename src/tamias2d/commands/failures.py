"""Why points of a study have no error."""

from itertools import groupby

from tamias2d.commands.output import say
from tamias2d.study.contact_study import ContactStudy
from tamias2d.study.work_precision import Study


def print_failures(found: Study | ContactStudy) -> None:
    """Print why there is no error, once where that is the same for settings in a row."""
    failed = (point for point in found.points if point.failure)
    for (method, why), points in groupby(failed, key=lambda point: (point.method, point.failure)):
        first, *more = (point.setting for point in points)
        settings = f"{first} to {more[-1]}" if more else first
        say(f"\n{f'{method} {settings}'.strip()}: {why}")
