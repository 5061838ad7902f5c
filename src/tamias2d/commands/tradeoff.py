"""`tamias2d tradeoff`: the accuracy and the cost of every method on a scene."""

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from tamias2d.commands.contact_tradeoff import print_contacts
from tamias2d.commands.failures import print_failures
from tamias2d.commands.names import find_scene, seconds
from tamias2d.commands.output import error_text, figure, print_json, print_table, say
from tamias2d.commands.step_warnings import untold
from tamias2d.errors import InputError
from tamias2d.scene import Scene
from tamias2d.study.contact_study import ContactStudy, contact_study
from tamias2d.study.report import as_json as report, contacts_as_json
from tamias2d.study.stepped_plan import stepped_because
from tamias2d.study.work_precision import ProgressHook, Study, study


def show_tradeoff(
    name: str,
    *,
    duration: str | None,
    tolerance: float | None,
    plot: Path | None,
    phases: int,
    as_json: bool,
) -> bool:
    """Do what `tamias2d tradeoff` promises; return whether it was not stopped.

    Raises:
        InputError: a tolerance or a number of phases breaks a rule, or there is no duration.
        SceneError, SimulationError: there is nothing to compare with.
    """
    scene = find_scene(name)
    time = seconds(duration, option="--duration", symbol="duration") or scene.duration
    if time is None:
        raise InputError(
            f"--duration: found none: must be stated here or in the scene '{name}' (R2). "
            "Give it, for example --duration '4 s'."
        )
    if tolerance is not None and not 0 < tolerance < 1:
        raise InputError(
            f"--tolerance: {tolerance!r}: must lie between 0 and 1, it is a relative error. "
            "Give one such as 1e-6."
        )
    if plot is not None:
        from tamias2d.record.plot import refuse_picture

        refuse_picture(plot)
    if not any(body.dynamic for body in scene.bodies):
        raise InputError(
            f"SCENE: {name!r}: no body can move, so that nothing can be measured (R5). "
            "Add a dynamic body."
        )
    found = _studied(scene, time, phases)
    if as_json:
        print_json(_as_json(found, tolerance))
    elif isinstance(found, ContactStudy):
        print_contacts(found, name, tolerance)
    else:
        _print(found, name, tolerance)
    if plot is not None:
        from tamias2d.study.plot import plot as draw

        draw(found, plot, tolerance=tolerance)
        print(f"Plot: {plot}", file=sys.stderr)
    if not found.complete:
        print(f"Interrupted: the {len(found.points)} points so far are shown.", file=sys.stderr)
    return found.complete


def _studied(scene: Scene, time: float, phases: int) -> Study | ContactStudy:
    """Return the study that suits a scene: of located impacts, or of stepped contacts."""
    try:
        with _progress() as told, untold():
            if reason := stepped_because(scene, time):
                return contact_study(
                    scene, duration=time, reason=reason, phases_asked=phases, told=told
                )
            return study(scene, duration=time, phases_asked=phases, told=told)
    except KeyboardInterrupt:
        raise KeyboardInterrupt(
            "Interrupted before the first point: nothing was measured yet."
        ) from None


def _as_json(found: Study | ContactStudy, tolerance: float | None) -> dict[str, Any]:
    if isinstance(found, ContactStudy):
        return contacts_as_json(found, tolerance=tolerance)
    return report(found, tolerance=tolerance)


@contextmanager
def _progress() -> Iterator[ProgressHook]:
    """Show on standard error which point is being computed, where somebody looks."""
    if not sys.stderr.isatty():
        yield lambda of, done, what: None  # noqa: ARG005
        return
    from rich.console import Console
    from rich.progress import Progress

    with Progress(console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task("looking for the truth", total=None)
        yield lambda of, done, what: bar.update(task, total=of, completed=done, description=what)


def _print(found: Study, name: str, tolerance: float | None) -> None:
    over = f", medians over {found.phases} phases" if found.phases > 1 else ""
    say(f"{name}: {figure(found.duration)} s, {found.impacts} impacts{over}")
    say(f"Errors are relative, against {found.truth}; below {found.floor:.0e} they say nothing.")
    heads = ["front", "method", "setting", "error"]
    if found.impacts:
        heads += ["positions", "event times", "event states", "missed", "extra", "graph"]
    heads += ["drift", "steps", "forces", "impacts", "seconds"]
    if tolerance is not None:
        heads.append(f"within {tolerance:g}")
    say()
    print_table(heads, (_row(found, k, tolerance) for k in range(len(found.points))))
    print_failures(found)
    say(
        "\nfront: nothing is both cheaper and better, by seconds (s) and by force evaluations (f). "
        "Seconds are the shortest of some runs, and differ each time. Forces that vary are "
        "computed for Pymunk by the scene's laws, which takes most of its seconds then."
    )


def _row(found: Study, k: int, tolerance: float | None) -> list[str]:
    point = found.points[k]
    front = ("s" if k in found.fastest else "") + ("f" if k in found.leanest else "")
    if point.error is None:
        return ["", point.method, point.setting, "none"]
    error = point.error
    cells = [front, point.method, point.setting, _known(error.size, found.floor)]
    if found.impacts:
        measured = (error.position, error.event_time, error.event_state)
        cells += [_measure(value) for value in measured]
        cells += ["-" if n is None else f"{n:g}" for n in (error.missed, error.extra)]
        cells.append(_measure(error.graph))
    cells.append(_measure(error.drift))
    cost = point.cost
    cells += (
        [f"{n}" for n in (cost.steps, cost.force_evaluations, cost.impacts)] if cost else ["-"] * 3
    )
    cells.append(f"{point.seconds.minimum:.2g}" if point.seconds else "-")
    if tolerance is not None:
        cells.append("yes" if error.size <= tolerance else "no")
    return cells


def _known(error: float, floor: float) -> str:
    return error_text(error) if error > floor else f"<= {floor:.0e}"


def _measure(value: float | None) -> str:
    return "-" if value is None else error_text(value)
