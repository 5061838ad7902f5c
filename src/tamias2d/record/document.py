"""The text of a recording: the run, and the equations that it rests on, as Markdown."""

from __future__ import annotations

import json
from importlib import resources
from typing import TYPE_CHECKING, Any

from tamias2d.record import header as headers

if TYPE_CHECKING:
    from tamias2d.motion.joint_events import JointEvent
    from tamias2d.run_data import RunData
    from tamias2d.simulator import Simulator


def about(run: RunData) -> str:
    """Return what was run and how: the scene, the way that was taken, bodies and versions."""
    scene = run.scene
    step = "" if run.time_step is None else f", time step {run.time_step:g} s"
    lines = [
        f"# {scene.name or 'A scene without a name'}",
        scene.says,
        f"**{run.method}**, {run.duration:g} s{step}, {len(run.times)} samples, "
        f"{len(run.impacts)} impacts{_joint_events(run)}. "
        f"Gravity ({scene.gravity[0]:g}, {scene.gravity[1]:g}) m/s².",
        "\n".join(f"- {note}" for note in run.notes),
        _certificate(run),
        _bodies(run),
        "The exact float64 states are in the component `tamias2d.State` of `/recording`. "
        "`tamias2d replay --check` computes this recording again.",
        ", ".join(f"{name} {version}" for name, version in headers.versions().items()),
    ]
    return "\n\n".join(line for line in lines if line)


def _joint_events(run: RunData) -> str:
    return f", {len(run.joint_events)} events of joints" if len(run.joint_events) else ""


def about_frames(sim: Simulator) -> str:
    """Return what a recording of a frame loop is, and how it was stepped."""
    x, y = sim.gravity.tolist()
    lines = [
        "# A frame loop",
        f"Steps of {sim.time_step:g} s in {sim.substeps} substeps. Gravity ({x:g}, {y:g}) m/s².",
        "Bodies and joints come and go as the program let them. What it did between steps is not "
        "in here, so that this cannot be computed again; positions are float32, to be looked at.",
        ", ".join(f"{name} {version}" for name, version in headers.versions().items()),
    ]
    return "\n\n".join(lines)


def _certificate(run: RunData) -> str:
    if run.certificate is None:
        return "No certificate: `tamias2d run --tolerance` or `--certify` gives one."
    claims = [f"- claims {text}" for text in run.certificate.claims]
    claims += [f"- does not claim {text}" for text in run.certificate.does_not_claim]
    return "\n".join([f"{run.certificate}", f"Measured: {run.certificate.measure}.", "", *claims])


def _bodies(run: RunData) -> str:
    rows = ["| body | shape | mass | inertia |", "| --- | --- | --- | --- |"]
    for body in run.scene.bodies:
        shape = type(body.shape).__name__ if body.shape else "particle"
        still = ("kinematic" if body.kinematic else "static",) * 2
        of_body = (f"{body.mass:g} kg", f"{body.inertia:g} kg m²") if body.dynamic else still
        rows.append(f"| {body.name} | {shape} | {' | '.join(of_body)} |")
    return "\n".join(rows)


def models() -> str:
    """Return the models of the specification, with their equations in words and their symbols."""
    items = json.loads(_generated("srs.json"))["items"]
    found = sorted((item for item in items if item["kind"] == "model"), key=lambda item: item["id"])
    return "\n\n".join(["# Models", *map(_model, found)])


def _model(item: dict[str, Any]) -> str:
    data = item["data"]
    closed = {k: v for k, v in data.get("closed_form", {}).items() if k != "when"}
    parts = [f"## {item['id']} {item['title']}", data["says"], _equations(data["equations"])]
    if closed:
        parts += [f"In closed form, when {data['closed_form']['when']}:", _equations(closed)]
    parts.append(f"{item['file']}, line {item['line']}")
    return "\n\n".join(parts)


def _equations(equations: dict[str, str]) -> str:
    lines = "\n".join(f"{name} = {value}" for name, value in equations.items())
    return f"```\n{lines}\n```"


def impact_line(run: RunData, k: int) -> str:
    """Return one impact as a line of text."""
    impacts = run.impacts
    a, b = (run.scene.bodies[i].name for i in impacts.bodies[k])
    x, y = impacts.point[k]
    return (
        f"{impacts.time[k]:.6g} s: {a} meets {b} at ({x:.4g}, {y:.4g}) m, approaching at "
        f"{-impacts.normal_velocity[k]:.4g} m/s, impulse {impacts.impulse[k]:.4g} N s"
    )


def _generated(name: str) -> str:
    return resources.files("tamias2d.generated").joinpath(name).read_text("utf-8")


def joint_line(joint: str, event: JointEvent[Any]) -> str:
    """One event of a joint with a name in one line."""
    value = f", {event.value:.4g}" if event.value and event.words != "breaks" else ""
    unit = "" if not value else " rad" if event.words == "clicks" else " N s or N m s"
    return f"{event.time:.6g} s: joint {joint} {event.words}{value}{unit}"
