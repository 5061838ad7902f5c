"""The source of many steps of a scheme, for the forces of one demand.

Serves: the makers of kernels. Hides: where the slopes of a step are kept, and when accelerations
are known already. All coefficients are arguments, those that `generated.schemes` has, so that the
schemes of a family share their code. Coordinates and rates of all bodies are rows of numbers.
"""

import re
import textwrap
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

from tamias2d.generated.schemes import RUNGE_KUTTA, SPLITTING, Weighted
from tamias2d.kernels.copied import copied
from tamias2d.kernels.force_demand import ForceDemand
from tamias2d.kernels.force_source import arguments as tables_of_forces, source as forces
from tamias2d.kernels.held_source import HeldDemand, held_tables, source as held
from tamias2d.kernels.joined import joined
from tamias2d.motion import adaptive

EVALUATIONS, REJECTED, KNOWN, DONE, SETTLED = range(5)
"""Places in `told`: accelerations and rejected steps so far; whether the last accelerations are
known (1); steps that are done; accelerations up to the last of them. Rejected ones follow."""
STEP, ERROR, RELATIVE, LENGTH, RATE, POWER, DAMPING = range(7)
"""Places in `control`: what the last step left to the next, and what the user allows."""
_NAMES = {
    "evaluations": EVALUATIONS,
    "rejected": REJECTED,
    "known": KNOWN,
    "done": DONE,
    "settled": SETTLED,
    "step": STEP,
    "last_error": ERROR,
    "relative": RELATIVE,
    "length": LENGTH,
    "rate": RATE,
    "power": POWER,
    "damping": DAMPING,
}
HEAD = '''"""Steps of Tamias2D by {family}: {demand}.

Made from the generated functions and from nothing else; its bits are those of the general code.
"""
'''
ROWS = '''def same(one, other):
    """Whether two rows are equal."""
    for j in range(len(one)):
        if one[j] != other[j]:
            return False
    return True


def copy(row, target):
    """Set a row to another."""
    for j in range(len(row)):
        target[j] = row[j]


def moved(start, factor, slope, target):
    """Set a row to where a slope leads from another."""
    for j in range(len(start)):
        target[j] = start[j] + factor * slope[j]


def weighted(first, last, columns, weights, slopes, total):
    """Set a row to a weighted sum of slopes."""
    slope, weight = slopes[columns[first]], weights[first]
    for j in range(len(total)):
        total[j] = weight * slope[j]
    for k in range(first + 1, last):
        slope, weight = slopes[columns[k]], weights[k]
        for j in range(len(total)):
            total[j] = total[j] + weight * slope[j]'''
_BEGIN = """        time = times[k]
        position, velocity, rate = places[k], speeds[k], rates[k]
        position_end, velocity_end, rate_end = places[k + 1], speeds[k + 1], rates[k + 1]
        told[{done}] = k
        if told[{known}] == 0:
            told[{evaluations}] += 1
            if not {accelerations}(time, position, velocity, rate, {tables}):
                return k
            told[{known}] = 1
        told[{settled}] = told[{evaluations}]
        told[{settled} + 1] = told[{rejected}]"""
_FIXED = '''def advance(times, {states}, {scheme}, {work}, told, felt, {tables}):
    """Step from each time to the next, as long as forces have values; return how many steps."""
{rows}
    for k in range(len(times) - 1):
{begin}
        end = times[k + 1]
        time_step = end - time
{stages}
        if reused:
            copy(asked, rate_end)
        else:
            told[{evaluations}] += 1
            if not {accelerations}(end, position_end, velocity_end, rate_end, {tables}):
                return k{back}
    return len(times) - 1
'''
_ADAPTIVE = '''def advance(
    limits, times, {states}, dense, control, {scheme}, {work}, told, felt, {tables}
):
    """Step towards limits, one each, as far as its error allows; return how many steps.

    Where there are fewer limits than steps, the others go towards the last one.

    It ends before, where a force has no value on the way or where steps get very short.
    """
{rows}
    for k in range(len(times) - 1):
        limit = limits[min(k, len(limits) - 1)]
        if times[k] >= limit:
            return k
{begin}
        time_step = control[{step}]
        rejected = False
        while True:
            end = time + time_step if time_step < limit - time else limit
            time_step = end - time
            if time_step <= 1e-14 * abs(time) + 1e-300:
                return k
{stages}
            error = 0.0
            for r in range(errors):
                row = stages + r
                first, last = starts[row], starts[row + 1]
                weighted(first, last, columns, weights, velocities, place_errors[r])
                weighted(first, last, columns, weights, slopes, speed_errors[r])
            for j in range(len(position)):
                near = max(abs(position[j]), abs(position_end[j]))
                fast = max(abs(velocity[j]), abs(velocity_end[j]))
                allowed = control[{length}] + control[{relative}] * near
                allowed_rate = control[{rate}] + control[{relative}] * fast
                factor = time_step / divisors[stages]
                place_error = factor * place_errors[0][j] / allowed
                speed_error = factor * speed_errors[0][j] / allowed_rate
                place_other, speed_other = 0.0, 0.0
                if errors > 1:
                    factor = time_step / divisors[stages + 1]
                    place_other = factor * place_errors[1][j] / allowed
                    speed_other = factor * speed_errors[1][j] / allowed_rate
                place_error = combined(place_error, place_other)
                speed_error = combined(speed_error, speed_other)
                if not (place_error <= 1e300 and speed_error <= 1e300):
                    error = 1e300
                error = max(error, place_error, speed_error)
            if error <= 1:
                break
            told[{rejected}] += 1
            rejected = True
            time_step *= shrinking(error, control[{power}]){back}
        times[k + 1] = end
        longer = time_step * growth(
            error, control[{last_error}], control[{power}], control[{damping}], rejected
        )
        if end == limit and not rejected:
            longer = max(longer, control[{step}])
        control[{step}] = longer
        control[{last_error}] = max(error, 1e-4)
        for r in range(len(starts) - 1 - stages - errors):
            row = stages + errors + r
            weighted(starts[row], starts[row + 1], columns, weights, slopes, dense[k][r])
        if reused{unmoved}:
            copy(asked, rate_end)
        else:
            told[{known}] = 0
    return len(times) - 1
'''
_RUNGE_KUTTA = """copy(velocity, velocities[0])
copy(rate, slopes[0])
for s in range(1, stages):
    first, last = starts[s - 1], starts[s]
    factor = time_step / divisors[s - 1]
    weighted(first, last, columns, weights, slopes, total)
    moved(velocity, factor, total, velocities[s])
    weighted(first, last, columns, weights, velocities, total)
    moved(position, factor, total, asked_places[s])
    again = moments[2 * s] * moments[2 * s - 1] == moments[2 * s - 2] * moments[2 * s + 1]
    again = again and s > 1 and same(asked_places[s], asked_places[s - 1])
    if again and (not felt or same(velocities[s], velocities[s - 1])):
        copy(slopes[s - 1], slopes[s])
        continue
    told[{evaluations}] += 1
    moment = time + moments[2 * s] * time_step / moments[2 * s + 1]
    if not {accelerations}(moment, asked_places[s], velocities[s], slopes[s], {tables}):
        return k
first, last = starts[stages - 1], starts[stages]
factor = time_step / divisors[stages - 1]
weighted(first, last, columns, weights, velocities, total)
moved(position, factor, total, position_end)
weighted(first, last, columns, weights, slopes, total)
moved(velocity, factor, total, velocity_end)
reused = False
if at_end > 0:
    asked = slopes[at_end]
    moment = time + moments[2 * at_end] * time_step / moments[2 * at_end + 1]
    reused = moment == end and same(asked_places[at_end], position_end)
    reused = reused and (not felt or same(velocities[at_end], velocity_end))
else:
    asked = rate"""
_SPLITTING = """copy(position, position_end)
copy(velocity, velocity_end)
copy(rate, asked)
moment, asked_is_known = time, True
for p in range(len(kicks)):
    factor = parts[4 * p] * time_step / parts[4 * p + 1]
    if kicks[p]:
        if not asked_is_known:
            moment = time + parts[4 * p + 2] * time_step / parts[4 * p + 3]
            told[{evaluations}] += 1
            if not accelerations(moment, position_end, velocity_end, asked, {tables}):
                return k
            copy(position_end, asked_place)
            copy(velocity_end, asked_speed)
        asked_is_known = False
        moved(velocity_end, factor, asked, velocity_end)
    else:
        asked_is_known = False
        moved(position_end, factor, velocity_end, position_end)
reused = moment == end and same(asked_place, position_end)
reused = reused and (not felt or same(asked_speed, velocity_end))"""
_HELD_SPLITTING = """copy(position, position_end)
copy(velocity, velocity_end)
copy(asked, asked_before)
copy(asked_place, place_before)
copy(asked_speed, speed_before)
moments[1] = moments[0]
for p in range(len(kicks)):
    length = parts[4 * p] * time_step / parts[4 * p + 1]
    moment = time + parts[4 * p + 2] * time_step / parts[4 * p + 3]
    if kicks[p]:
        asked_is_known = moment == moments[0] and same(asked_place, position_end)
        if not (asked_is_known and (not felt or same(asked_speed, velocity_end))):
            told[{evaluations}] += 1
            if not accelerations(moment, position_end, velocity_end, asked, {forces}):
                return k
            copy(position_end, asked_place)
            copy(velocity_end, asked_speed)
            moments[0] = moment
        moved(velocity_end, length, asked, velocity_end)
    elif not drifted(moment, length, position_end, velocity_end, {held}):
        return k
if not fitted(time + time_step, position_end, velocity_end, {held}):
    return k
reused = False"""
_RETURN = """
copy(position_end, reached[k][0])
copy(velocity_end, reached[k][1])
copy(rate_end, reached[k][2])
if not fitted(end, position_end, velocity_end, {held}):
    return k
unmoved = same(position_end, reached[k][0]) and same(velocity_end, reached[k][1])"""


@dataclass(frozen=True)
class March:
    """The source of the steps of a scheme, and the numbers and rows that its caller gives it."""

    text: str
    """For the compiler; `plain` is the same without its marks."""
    plain: str
    scheme: tuple[Any, ...]
    """Lists of whole and of real numbers, and whole numbers, in the order of the arguments."""
    work: tuple[int, ...]
    """Blocks of rows that it works on, each row as long as one of `places`."""
    slopes: int
    """Of the velocity in a step, for its path; 0 for steps whose length is given."""
    returns: bool = False
    """Whether each step ends with a return to joints, and where it led before is told."""


@cache
def march(scheme: str, demand: ForceDemand | HeldDemand) -> March | None:
    """Return the source of the steps of a scheme under the forces of a demand, if there is one."""
    if scheme in SPLITTING:
        return _splitting(scheme, demand)
    if scheme not in RUNGE_KUTTA:
        return None
    table = RUNGE_KUTTA[scheme]
    stages, errors = len(table.moments), len(table.errors)
    rows = (*table.stages, table.end, *table.errors, *table.dense)
    arguments = "stages, errors, at_end, starts, columns, divisors, weights, moments"
    places = [
        "slopes, velocities, asked_places, total = work_0, work_1, work_2, work_3[0]",
        *(["place_errors, speed_errors = work_4, work_5"] if errors else []),
    ]
    template, family = (_ADAPTIVE, "embedded slopes") if errors else (_FIXED, "slopes")
    texts = _texts(demand, family, _RUNGE_KUTTA, template, arguments, places)
    at_end = max((s for s, (up, down) in enumerate(table.moments) if s and up == down), default=0)
    lists = _flat(rows, table.moments)
    work_sizes = (stages, stages, stages, 1, *((errors, errors) if errors else ()))
    numbers = (stages, errors, at_end, *lists)
    returns = isinstance(demand, HeldDemand)
    return March(*texts, numbers, work_sizes, len(table.dense), returns)


def _splitting(scheme: str, demand: ForceDemand | HeldDemand) -> March | None:
    """Return the source of kicks and drifts; of springs and motors kicks are not known here."""
    parts = SPLITTING[scheme].parts
    kicks = [int(kick) for kick, *_ in parts]
    numbers = [float(number) for _, *lengths in parts for number in lengths]
    work = ["asked, asked_place, asked_speed = work_0[0], work_0[1], work_0[2]"]
    if isinstance(demand, ForceDemand):
        texts = _texts(demand, "kicks and drifts", _SPLITTING, _FIXED, "kicks, parts", work)
        return March(*texts, (kicks, numbers), (3,), 0)
    if demand.joints.pushed:
        return None
    work += ["asked_before, place_before, speed_before = work_1[0], work_1[1], work_1[2]"]
    work += ["moments = work_2[0]"]
    texts = _texts(demand, "kicks and drifts", _HELD_SPLITTING, _FIXED, "kicks, parts", work)
    return March(*texts, (kicks, numbers), (3, 3, 1), 0)


@cache
def alone(demand: ForceDemand) -> tuple[str, str]:
    """Return the source of the accelerations of a demand: for the compiler, and plain."""
    helpers, imports = forces(demand)
    head = HEAD.replace("Steps", "Accelerations").format(family="all forces", demand=demand)
    return joined(head, imports, helpers[:-1], helpers[-1])


def tables_of(demand: ForceDemand | HeldDemand) -> list[str]:
    """Return the names of the tables that steps take, in order."""
    if isinstance(demand, ForceDemand):
        return tables_of_forces(demand)
    return [*tables_of_forces(demand.forces), *held_tables(demand)]


def _flat(rows: Sequence[Weighted], moments: Sequence[tuple[float, float]]) -> tuple[Any, ...]:
    """Return rows of weights one after the other, and moments: starts, columns, and so on."""
    starts, columns, weights = [0], [], []
    for _, terms in rows:
        columns += [column for column, _ in terms]
        weights += [float(weight) for _, weight in terms]
        starts.append(len(columns))
    divisors = [float(divisor) for divisor, _ in rows]
    return starts, columns, divisors, weights, [float(n) for moment in moments for n in moment]


def functions(
    demand: ForceDemand | HeldDemand, *, drifting: bool = False
) -> tuple[list[str], list[str]]:
    """Return the functions of all accelerations, and of joints, and what they import."""
    if isinstance(demand, ForceDemand):
        return forces(demand)
    return held(demand, drifting=drifting)


def _texts(
    demand: ForceDemand | HeldDemand,
    family: str,
    step: str,
    template: str,
    scheme: str,
    work: Sequence[str],
) -> tuple[str, str]:
    """Return the source for the compiler, and without its marks."""
    blocks = sorted(set(re.findall(r"work_\d", " ".join(work))))
    tables = tables_of(demand)
    names = {**_NAMES, "tables": ", ".join(tables), "scheme": scheme, "work": ", ".join(blocks)}
    names |= {"states": "places, speeds, rates", "accelerations": "accelerations"}
    names |= {"back": "", "unmoved": ""}
    if isinstance(demand, HeldDemand):
        names |= _held_names(demand, template, splits=step is _HELD_SPLITTING)
    deep = 12 if template is _ADAPTIVE else 8
    names["begin"] = _BEGIN.format(**names)
    names["stages"] = textwrap.indent(step.format(**names), " " * deep)
    names["rows"] = "\n".join(f"    {line}" for line in work)
    text = template.format(**names).rstrip()
    helpers, imports = functions(demand, drifting=step is _HELD_SPLITTING)
    helpers += ROWS.split("\n\n\n")
    if template is _ADAPTIVE:
        helpers += _controls()
        imports = [*imports, "sqrt"]
    return joined(HEAD.format(family=family, demand=demand), imports, helpers, text)


def _held_names(demand: HeldDemand, template: str, *, splits: bool) -> dict[str, str]:
    """What stands in a template where joints hold: steps of slopes end with the return to them."""
    tables = ", ".join(held_tables(demand))
    names = {"accelerations": "held_accelerations", "held": tables}
    if splits:
        return names | {"forces": ", ".join(tables_of_forces(demand.forces))}
    back = _RETURN.format(held=tables)
    if template is _FIXED:
        back += "\nif not unmoved:\n    told[{known}] = 0".format(**_NAMES)
    names["back"] = back.replace("\n", "\n        ")
    return names | {"states": "places, speeds, rates, reached", "unmoved": " and unmoved"}


def _controls() -> list[str]:
    """The functions that choose the length of a step."""
    constants = ("SAFETY", "SHORTER", "LONGER", "CORRECTION", "NONE")
    names = {name: repr(getattr(adaptive, name)) for name in constants} | {"largest": "max"}
    return [copied(f, names) for f in (adaptive.combined, adaptive.growth, adaptive.shrinking)]
