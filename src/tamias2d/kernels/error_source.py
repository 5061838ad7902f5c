"""The source of the error of a path, integrated beside it, for the forces of one demand.

Serves: the makers of kernels. Hides: the loops over steps and nodes. The equation is that of
`motion.error_equation`, with its bits.
"""

from functools import cache

from tamias2d.kernels.force_demand import ForceDemand
from tamias2d.kernels.held_source import HeldDemand, held_tables
from tamias2d.kernels.joined import joined
from tamias2d.kernels.march_source import HEAD, ROWS, functions, tables_of

_ERROR = '''def follow(
    times, paths, nodes, early, whole, sweeps, error, largest, work_0, work_1, {ends}{tables}
):
    """Integrate the error of a path over its steps; return over how many.

    It ends before, where a force has no value beside the path.
    """
    ahead, rate, pull = error[0], error[1], error[2]
    lacking, place, speed, turn, bend = work_0, work_1[0], work_1[1], work_1[2], work_1[3]
    for k in range(len(times) - 1):
        time, step = times[k], times[k + 1] - times[k]
        path, velocity, rates = paths[k][0], paths[k][1], paths[k][2]
        for j in range(len(ahead)):
            lacking[0][j] = pull[j] - rates[0][j]
        for sweep in range(sweeps):
            for i in range(1, len(nodes)):
                weights = whole if sweep > 0 else early
                last = len(nodes) if sweep > 0 else i
                summed(weights[0][i], last, lacking, turn)
                summed(weights[1][i], last, lacking, bend)
                for j in range(len(ahead)):
                    way = ahead[j] + step * nodes[i] * rate[j] + step * step * bend[j]
                    place[j] = path[i][j] + way
                    speed[j] = velocity[i][j] + (rate[j] + step * turn[j])
                if not {accelerations}(time + step * nodes[i], place, speed, pull, {tables}):
                    return k
                for j in range(len(ahead)):
                    lacking[i][j] = pull[j] - rates[i][j]
        for i in range(1, len(nodes)):
            summed(whole[0][i], len(nodes), lacking, turn)
            summed(whole[1][i], len(nodes), lacking, bend)
            for j in range(len(ahead)):
                place[j] = ahead[j] + step * nodes[i] * rate[j] + step * step * bend[j]
                largest[j] = max(largest[j], abs(place[j]))
        copy(place, ahead)
        moved(rate, step, turn, rate){back}
    return len(times) - 1
'''
_RETURN = """
        for j in range(len(ahead)):
            place[j] = ends[k][0][j] + ahead[j]
            speed[j] = ends[k][1][j] + rate[j]
        if not fitted(times[k + 1], place, speed, {held}):
            return k
        for j in range(len(ahead)):
            ahead[j] = place[j] - ends[k][0][j]
            rate[j] = speed[j] - ends[k][1][j]"""
_SUMMED = '''def summed(weights, last, rows, total):
    """Set a row to the weighted sum of the first of some rows."""
    for j in range(len(total)):
        total[j] = weights[0] * rows[0][j]
    for n in range(1, last):
        for j in range(len(total)):
            total[j] = total[j] + weights[n] * rows[n][j]'''


@cache
def error_equation(demand: ForceDemand | HeldDemand) -> tuple[str, str]:
    """Return the source that integrates the error of paths: for the compiler, and plain.

    Where joints hold, they move exact motion beside the end of each step, too.
    """
    names = {"accelerations": "accelerations", "ends": "", "back": ""}
    if isinstance(demand, HeldDemand):
        back = _RETURN.format(held=", ".join(held_tables(demand)))
        names = {"accelerations": "held_accelerations", "ends": "ends, ", "back": back}
    text = _ERROR.format(tables=", ".join(tables_of(demand)), **names).rstrip()
    helpers, imports = functions(demand)
    helpers += [part for part in ROWS.split("\n\n\n") if part.startswith(("def copy", "def moved"))]
    head = HEAD.replace("Steps", "Errors of steps").format(family="their equation", demand=demand)
    return joined(head, imports, [*helpers, _SUMMED], text)
