"""`tamias2d recommend`: which method and step meet a tolerance, and why the others lost."""

import math
from typing import Any

from tamias2d.commands.names import find_scene, share, span_of
from tamias2d.commands.output import command, print_json, print_table, say
from tamias2d.study.pilot import Estimate
from tamias2d.study.recommend import Recommendation, recommend


def recommend_method(name: str, *, tolerance: str, duration: str | None, as_json: bool) -> None:
    """Print the plan for a scene of the catalogue or in a file."""
    scene = find_scene(name)
    asked = share(tolerance, option="--tolerance")
    span = span_of(scene, name, duration)
    plan = recommend(scene, duration=span, tolerance=asked or 0.0)
    if as_json:
        print_json(_as_json(name, plan))
        return
    say(f"{name}, within {plan.tolerance:g}: {_method(plan.choice)}")
    print_table(
        ("method", "step, s", "force evaluations", "observed order", "why"),
        (
            (
                str(one.method),
                "-" if one.time_step is None else f"{one.time_step:.4g}",
                f"{one.force_evaluations:.0f}" if math.isfinite(one.force_evaluations) else "-",
                "-" if one.observed_order is None else f"{one.observed_order:.2f}",
                one.why,
            )
            for one in plan.estimates
        ),
    )
    say(_spent(plan))
    step = f", time_step={plan.choice.time_step!r}" if plan.choice.time_step else ""
    say(f"Run it: t2.simulate(scene, duration={span!r}, method=t2.{plan.choice.method}{step})")
    say(
        f"`{command()} run {name} --tolerance {plan.tolerance:g}` certifies a run within it: the "
        "first one that holds, often by another setting. It weighs methods only if none does."
    )


def _method(one: Estimate) -> str:
    return f"{one.method}" + (f", steps of {one.time_step:.4g} s" if one.time_step else "")


def _spent(plan: Recommendation) -> str:
    own = plan.choice.force_evaluations
    times = f", {plan.pilot / own:.2g} times as many as the run needs" if own else ""
    return f"Finding this took {plan.pilot} force evaluations of pilot runs{times}."


def _as_json(name: str, plan: Recommendation) -> dict[str, Any]:
    return {
        "scene": name,
        "tolerance": plan.tolerance,
        "pilot_force_evaluations": plan.pilot,
        "force_evaluations_with_pilot": plan.pilot + plan.choice.force_evaluations,
        "estimates": [
            {
                "method": str(one.method),
                "time_step": one.time_step,
                "force_evaluations": _finite(one.force_evaluations),
                "error": _finite(one.error),
                "observed_order": one.observed_order,
                "why": one.why,
            }
            for one in plan.estimates
        ],
    }


def _finite(value: float) -> float | None:
    return value if math.isfinite(value) else None
