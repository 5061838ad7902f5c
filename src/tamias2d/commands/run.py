"""`tamias2d run`: simulate a scene, print the answer and how wrong it is, keep the run."""

import math
import shlex
import sys
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from tamias2d.commands.exact import KnownError, known_errors
from tamias2d.commands.names import find_method, find_scene, share, span_of, step_for
from tamias2d.commands.output import command, error_text, figure, pair, print_json, print_table, say
from tamias2d.commands.step_warnings import untold
from tamias2d.errors import InputError, SimulationError, TamiasError
from tamias2d.record.energies import energies
from tamias2d.record.files import refuse_file
from tamias2d.run import Run
from tamias2d.scene import Body
from tamias2d.simulate import simulate
from tamias2d.solve import FRAMES, Interrupted
from tamias2d.state import Array

_FEWEST = 240  # samples
_SHOWN = 5  # impacts, and events of joints
_BODIES = 30  # whose states are shown
_ROUNDING = 1e-12  # of a place, relative to the size of a body


@dataclass(frozen=True)
class _Files:
    """Where the user wants the run."""

    record: Path | None
    plot: Path | None

    def check(self) -> None:
        """Refuse what cannot be written, before anything is computed."""
        for option, path in (("--record", self.record), ("--plot", self.plot)):
            if path is not None and not path.name:
                given = "'' or '.'" if path == Path() else repr(str(path))  # paths of one kind
                raise InputError(
                    f"{option}: {given}: names no file (R5). Give one, for example "
                    f"{option} {'run.rrd' if option == '--record' else 'run.png'}."
                )
        if self.record:
            refuse_file(self.record)
        if self.plot:
            from tamias2d.record.plot import OF_RUNS, refuse_picture

            refuse_picture(self.plot, OF_RUNS)

    def write(self, run: Run) -> None:
        if self.record:
            run.save(self.record)
        if self.plot:
            from tamias2d.record.plot import plot

            plot(run, self.plot)


def run_scene(
    name: str,
    *,
    duration: str | None,
    method: str | None,
    time_step: str | None,
    tolerance: str | None,
    quality: str | None,
    certified: bool,
    record: Path | None,
    plot: Path | None,
    as_json: bool,
) -> None:
    """Do what `tamias2d run` promises; raises as `simulate` and `Run.save` do."""
    scene = find_scene(name)
    files = _Files(record, plot)
    files.check()
    chosen = None if method is None else find_method(method)
    step = step_for(chosen, time_step)
    span = span_of(scene, name, duration)
    try:
        with untold():
            run = simulate(
                scene,
                duration=span,
                method=chosen,
                time_step=step,
                times=_times(span) if step is None else None,
                tolerance=share(tolerance, option="--tolerance"),
                quality=share(quality, option="--quality"),
                progress=sys.stderr.isatty(),
            )
    except (SimulationError, Interrupted) as stop:
        _keep(getattr(stop, "run", None), files)
        raise
    if certified and run.certificate is None:
        from tamias2d.study.certify import certify

        with untold():
            run = certify(run)
    errors = known_errors(run, name)
    try:
        if as_json:
            print_json(_as_json(run, name, errors, files))
        else:
            _print(run, name, errors)
    finally:
        files.write(run)  # last: a full disk loses no answer, and a lost answer no file
    if not as_json:
        _print_files(files)


def _times(duration: float) -> Array | None:
    """Return the times of samples, s, where those that a run has by itself are few to look at."""
    count = math.ceil(duration * FRAMES)
    if not 0 < count < _FEWEST:
        return None
    return np.linspace(0.0, duration, count * math.ceil(_FEWEST / count) + 1)


def _keep(run: Run | None, files: _Files) -> None:
    """Save what there is of a run that did not reach its end; the reason is told afterwards."""
    if run is None:
        return
    try:
        files.write(run)
    except TamiasError as fault:
        print(fault, file=sys.stderr)
        return
    for path in filter(None, (files.record, files.plot)):
        print(f"The run up to {figure(run.times[-1])} s is in {path}.", file=sys.stderr)


def _print(run: Run, name: str, errors: list[KnownError]) -> None:
    count = sum(map(_moves, run.scene.bodies))
    say(f"{name}: {figure(run.duration)} s, {count} of {len(run.scene.bodies)} bodies move")
    for note in run.notes:
        say(f"  {note}")
    shown = "" if count <= _BODIES else f", the first {_BODIES} bodies (--json has all)"
    say(f"\nState at {figure(run.times[-1])} s{shown}")
    print_table(
        ("body", "position, m", "orientation, rad", "velocity, m/s", "angular velocity, rad/s"),
        (
            (
                body["name"],
                pair(body["position"]),
                figure(body["orientation"]),
                pair(body["velocity"]),
                figure(body["angular_velocity"]),
            )
            for body in _final(run)[:_BODIES]
        ),
    )
    _print_impacts(run)
    _print_joint_events(run)
    _print_errors(errors)
    if run.certificate is not None:
        say(f"\n{run.certificate}")
        say(f"Measured: {run.certificate.measure}.")


def _print_files(files: _Files) -> None:
    if files.record:
        say(f"\nRecording: {files.record}")
        say("Look at it: " + shlex.join([command(), "replay", str(files.record)]))
    if files.plot:
        say(f"\nPlot: {files.plot}")


def _print_impacts(run: Run) -> None:
    pushed, sensed = _impacts(run)
    count = len(pushed)
    say(f"\nImpacts: {count}" + (f", the first {_SHOWN}:" if count > _SHOWN else ""))
    if count:
        print_table(
            ("time, s", "bodies", "impulse, N s", "point, m"),
            (
                (*_met(run, k), figure(float(run.impacts.impulse[k])), pair(_seen(run, k)))
                for k in pushed[:_SHOWN]
            ),
        )
    if sensed:
        more = f", the first {_SHOWN}" if len(sensed) > _SHOWN else ""
        say(f"\nMet by sensors: {len(sensed)}{more}:")
        print_table(("time, s", "bodies"), (_met(run, k) for k in sensed[:_SHOWN]))


def _impacts(run: Run) -> tuple[list[int], list[int]]:
    """Return the impacts that pushed, and those at which a sensor met a body."""
    bodies = run.scene.bodies
    sensing = [any(bodies[i].sensor for i in two) for two in run.impacts.bodies]
    places = range(len(sensing))
    return [k for k in places if not sensing[k]], [k for k in places if sensing[k]]


def _met(run: Run, k: int) -> tuple[str, str]:
    names = " and ".join(run.scene.bodies[i].name for i in run.impacts.bodies[k])
    return figure(float(run.impacts.time[k])), names


def _print_joint_events(run: Run) -> None:
    events = _joint_events(run)
    if not events:
        return
    more = f", the first {_SHOWN}" if len(events) > _SHOWN else ""
    say(f"\nEvents of joints: {len(events)}{more}:")
    print_table(
        ("time, s", "joint", "what"),
        ((figure(one["time"]), one["joint"], one["what"]) for one in events[:_SHOWN]),
    )


def _seen(run: Run, k: int) -> list[float]:
    """Where the bodies of impact k touched; 0 for what is rounding beside their size."""
    shapes = (run.scene.bodies[i].shape for i in run.impacts.bodies[k])
    sizes = (shape.bounding_radius for shape in shapes if shape is not None)
    return _rounded(run.impacts.point[k], min(filter(math.isfinite, sizes), default=0.0))


def _rounded(values: Iterable[float], size: float) -> list[float]:
    """Return numbers, 0 for what is rounding beside a size."""
    return [0.0 if abs(x) <= _ROUNDING * size else float(x) for x in values]


def _print_errors(errors: list[KnownError]) -> None:
    if not errors:
        say("\nError: no case of the specification gives the exact answer of this run.")
        return
    worst = error_text(max(e.error for e in errors))
    say(f"\nError against the exact answer (relative; absolute where that is 0), at most {worst}:")
    print_table(
        ("case", "quantity", "error"), ((e.case, e.quantity, error_text(e.error)) for e in errors)
    )


def _as_json(run: Run, name: str, errors: list[KnownError], files: _Files) -> dict[str, Any]:
    pushed, sensed = _impacts(run)
    return {
        "scene": name,
        "method": str(run.method),
        "duration": run.duration,
        "time_step": run.time_step,
        "notes": list(run.notes),
        "final": {
            "time": float(run.times[-1]),
            "bodies": _final(run),
            "energy": float(run.energy[-1]),
            "energy_is": "kinetic" if len(energies(run)) == 1 else "kinetic and potential",
            "momentum": run.momentum[-1].tolist(),
            "angular_momentum": float(run.angular_momentum[-1]),
        },
        "impacts": [_impact(run, k) for k in pushed],
        "met_by_sensors": [_impact(run, k) for k in sensed],
        "joint_events": _joint_events(run),
        "errors": [e.as_json() for e in errors],
        "certificate": None if run.certificate is None else run.certificate.as_json(),
        "digest": run.digest(),
        "recording": None if files.record is None else str(files.record),
        "plot": None if files.plot is None else str(files.plot),
    }


def _final(run: Run) -> list[dict[str, Any]]:
    return [
        {
            "name": body.name,
            "position": run.position[-1, i].tolist(),
            "orientation": float(run.orientation[-1, i]),
            "velocity": run.velocity[-1, i].tolist(),
            "angular_velocity": float(run.angular_velocity[-1, i]),
        }
        for i, body in enumerate(run.scene.bodies)
        if _moves(body)
    ]


def _moves(body: Body) -> bool:
    return body.dynamic or body.kinematic


def _joint_events(run: Run) -> list[dict[str, Any]]:
    names = [joint.name for joint in run.scene.joints]
    events = zip(run.joint_events, run.joint_events.words, strict=True)
    return [
        {"time": event.time, "joint": names[event.joint], "what": words, "value": event.value}
        for event, words in events
    ]


def _impact(run: Run, k: int) -> dict[str, Any]:
    impacts = run.impacts
    return {
        "time": float(impacts.time[k]),
        "bodies": [run.scene.bodies[i].name for i in impacts.bodies[k]],
        "point": _seen(run, k),
        "normal": _rounded(impacts.normal[k], 1.0),
        "impulse": float(impacts.impulse[k]),
        "normal_velocity": float(impacts.normal_velocity[k]),
    }
