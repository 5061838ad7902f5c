"""`tamias2d ensemble`: a scene in many worlds; how they spread, and a record of any of them."""

import re
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from tamias2d.commands.names import find_method, find_scene, share, span_of, step_for
from tamias2d.commands.output import figure, print_json, print_table, say
from tamias2d.ensemble import Grid, ensemble
from tamias2d.ensemble.cluster import client_at
from tamias2d.ensemble.outline import outline_of
from tamias2d.ensemble.places import Place, place_at
from tamias2d.ensemble.solving import OUTCOMES
from tamias2d.ensemble.spread import plot as draw, spreads
from tamias2d.ensemble.worlds import worlds_of
from tamias2d.errors import InputError
from tamias2d.record.files import refuse_file
from tamias2d.record.plot import refuse_picture
from tamias2d.scene import Scene
from tamias2d.scene.quantities import read_quantity
from tamias2d.scene.rules import RuleError
from tamias2d.simulate import simulate

_SAMPLES = 61
_SHOWN = 20  # coordinates
_CALL = re.compile(r"\s*(\w+)\s*\((.*)\)\s*")
_FORMS = "uniform(LOW, HIGH), normal(MEAN, DEVIATION), grid(A, B, ...) or A, B, ..."


def run_ensemble(
    name: str,
    *,
    vary: list[str],
    worlds: int | None,
    seed: int,
    duration: str | None,
    method: str | None,
    time_step: str | None,
    tolerance: str | None,
    out: Path | None,
    plot: Path | None,
    workers: int | None,
    scheduler: str | None,
    as_json: bool,
) -> None:
    """Do what `tamias2d ensemble` promises; raises as `t2.ensemble` does."""
    scene = find_scene(name)
    if plot is not None:
        refuse_picture(plot)
    asked = _asked(scene, name, duration, method, time_step, tolerance)
    times = np.linspace(0.0, asked["duration"], _SAMPLES)
    began = time.perf_counter()
    with client_at(scheduler) as client:
        found = ensemble(
            scene,
            vary=_varied(scene, vary),
            worlds=worlds,
            seed=seed,
            times=times,
            keep=("position", "velocity"),
            out=out,
            workers=workers,
            client=client,
            progress=sys.stderr.isatty(),
            **asked,
        )
        took = time.perf_counter() - began
        about = {"scene": name, "worlds": found.sizes["world"], "outcomes": _outcomes(found)}
        rows = [spread._asdict() for spread in spreads(found)]
        if as_json:
            known = [{k: v if v == v else None for k, v in row.items()} for row in rows]
            print_json({**about, "duration": asked["duration"], "seconds": took, "end": known})
        else:
            _print(about, rows, asked["duration"], took, out)
        if plot is not None:
            draw(found, plot)
            print(f"Plot: {plot}", file=sys.stderr)


def record_world(
    name: str,
    number: int | None,
    record: Path | None,
    *,
    vary: list[str],
    worlds: int | None,
    seed: int,
    duration: str | None,
    method: str | None,
    time_step: str | None,
    tolerance: str | None,
) -> None:
    """Simulate one world of an ensemble again, and save it.

    Raises:
        InputError: the ensemble has no such world, or an argument breaks a rule.
    """
    if number is None or record is None:
        raise InputError(
            "--world and --record: found one without the other (R5). Give both, or neither."
        )
    scene = find_scene(name)
    refuse_file(record)
    made = worlds_of(scene, _varied(scene, vary), worlds, seed, None)
    if not 0 <= number < len(made):
        raise InputError(
            f"--world: {number}: must be from 0 to {len(made) - 1}, the ensemble has {len(made)} "
            "worlds (R5). Give such a number."
        )
    asked = _asked(scene, name, duration, method, time_step, tolerance)
    simulate(made.scene(number), **asked).save(record)
    say(f"World {number} of {len(made)}: {record}")


def _asked(
    scene: Scene,
    name: str,
    duration: str | None,
    method: str | None,
    time_step: str | None,
    tolerance: str | None,
) -> dict[str, Any]:
    way = None if method is None else find_method(method)
    return {
        "duration": span_of(scene, name, duration),
        "method": way,
        "time_step": step_for(way, time_step),
        "tolerance": share(tolerance, option="--tolerance"),
    }


def _varied(scene: Scene, texts: list[str]) -> dict[str, Any]:
    """Return what varies, from texts such as 'bodies.ball.restitution=uniform(0.2, 0.8)'."""
    outline = outline_of(scene)
    found: dict[str, Any] = {}
    for text in texts:
        path, equals, form = (part.strip() for part in text.partition("="))
        if not equals or path in found:
            what = "stands twice" if equals else "must be PLACE=FORM"
            raise InputError(f"--vary: {text!r}: {what} (R2). The form is {_FORMS}.")
        found[path] = _form(form, place_at(path, outline), text)
    return found


def _form(form: str, place: Place, text: str) -> Any:
    from scipy import stats

    call = _CALL.fullmatch(form)
    kind, inside = (call[1], call[2]) if call else ("", form)
    numbers = [_number(item.strip(), place, text) for item in inside.split(",") if item.strip()]
    made: dict[str, Callable[..., Any]] = {
        "uniform": lambda low, high: stats.uniform(low, high - low),
        "normal": stats.norm,
        "grid": Grid,
        "": lambda *values: list(values),
    }
    wrong = kind not in made or not numbers or (kind in ("uniform", "normal") and len(numbers) != 2)
    if wrong:
        raise InputError(f"--vary: {text!r}: cannot be read (R2). The form is {_FORMS}.")
    if kind == "uniform" and not numbers[0] < numbers[1]:
        raise InputError(f"--vary: {text!r}: LOW must be below HIGH (R2). Exchange them.")
    if kind == "normal" and numbers[1] <= 0:
        raise InputError(f"--vary: {text!r}: the deviation must be > 0 (R2). Give such a number.")
    return made[kind](*numbers)


def _number(item: str, place: Place, text: str) -> float:
    try:
        return float(item)
    except ValueError:
        try:
            return read_quantity(item, place.symbol.name, ("value",))
        except RuleError as fault:
            raise InputError(f"--vary: {text!r}: {fault}") from None


def _outcomes(found: Any) -> dict[str, int]:
    counts = np.bincount(found.outcome.values, minlength=len(OUTCOMES)).tolist()
    return {name: count for name, count in zip(OUTCOMES, counts, strict=True) if count}


def _print(
    about: dict[str, Any], rows: list[dict[str, Any]], end: float, took: float, out: Path | None
) -> None:
    outcomes = ", ".join(f"{count} {name}" for name, count in about["outcomes"].items())
    say(f"{about['scene']}: {about['worlds']} worlds in {took:.3g} s: {outcomes}")
    more = f", the first {_SHOWN}" if len(rows) > _SHOWN else ""
    say(f"\nPositions at {figure(end)} s, m{more}")
    heads = ("body", "axis", "mean", "deviation", "5 %", "median", "95 %")
    print_table(
        heads,
        (
            [row["body"], row["axis"], *(f"{value:.6g}" for value in list(row.values())[2:])]
            for row in rows[:_SHOWN]
        ),
    )
    if out is not None:
        say(f"\nStore: {out}")
        say(f'Open it: xarray.open_zarr("{out}", consolidated=False)')
