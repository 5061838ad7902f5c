"""The coefficients of a scheme, in the tableau in which the literature prints them.

Serves: the page of a scheme. Hides: the families of schemes.
"""

from collections.abc import Iterator
from fractions import Fraction

from tamias2d.spec.chapter import Item
from weave.markdown import display


def parts(item: Item) -> Iterator[str]:
    """Order and coefficients, for a scheme; nothing for any other item."""
    if item.kind != "scheme":
        return
    data = item.data
    order = data["order"]
    proof = "found from the coefficients by exact arithmetic when this page was built"
    yield (
        f"**Order {order}**, {proof}.\n"
        if order != "0"
        else f"**Inconsistent** (order 0), {proof}.\n"
    )
    yield display(_TABLEAUS[data["family"]](data))
    if _is_long(data):
        yield f"Rounded to nine digits and without zeros; `{item.file}` has all of them.\n"
    if constant := data.get("error_constant"):
        yield f"*Error constant:* {' '.join(constant.split())}.\n"
    if stable := data.get("stability"):
        swings = (
            rf"$h < {stable['oscillation']}/\omega$"
            if stable["oscillation"] != "0"
            else "at no step"
        )
        yield (
            f"*Stable* on a free oscillation {swings}, "
            f"on a free decay $h < {stable['decay']}/\\gamma$; found likewise.\n"
        )


_LONG = 12  # letters of a coefficient: with longer ones a tableau is wider than a page
_PER_LINE = 2


def _butcher(data: dict) -> str:
    if _is_long(data):
        return _listed(data)
    rows = [
        " & ".join([c, *row, *[""] * (len(data["b"]) - len(row))])
        for c, row in zip(
            map(_fraction, data["c"]),
            ([_fraction(x) for x in row] for row in data["a"]),
            strict=True,
        )
    ]
    last = " & ".join(["", *map(_fraction, data["b"])])
    columns = "c|" + "c" * len(data["b"])
    return rf"\begin{{array}}{{{columns}}} {_stack(rows)} \\ \hline {last} \end{{array}}"


def _is_long(data: dict) -> bool:
    return any(len(x) > _LONG for row in data.get("a", []) for x in row)


def _listed(data: dict) -> str:
    """The coefficients that are not 0, rounded, some on a line; for many long ones."""
    lines = []
    for k, row in enumerate([*data["a"], data["b"]]):
        name = f"a_{{{k + 1}," if k < len(data["a"]) else "b_{"
        entries = [rf"{name}{j + 1}}} &= {_rounded(x)}" for j, x in enumerate(row) if Fraction(x)]
        start = rf"c_{{{k + 1}}} &= {_rounded(data['c'][k])}" if k < len(data["a"]) else " & "
        for part in range(0, max(len(entries), 1), _PER_LINE):
            lines.append(" & \\quad ".join([start, *entries[part : part + _PER_LINE]]))
            start = " & "
    return rf"\begin{{aligned}} {_stack(lines)} \end{{aligned}}"


def _rounded(text: str) -> str:
    if "/" in text or len(text) < _LONG:
        return _fraction(text)
    return f"{float(text):.9f}"


_KICK = r"\boldsymbol{{v}} &\leftarrow \boldsymbol{{v}} + {step}\, \boldsymbol{{a}}"
_DRIFT = r"\boldsymbol{{p}} &\leftarrow \boldsymbol{{p}} + {step}\, \boldsymbol{{v}}"
_EXACT = r"\boldsymbol{{p}},\, \boldsymbol{{v}} &\leftarrow \text{{exact motion for }} {step}"


def _splitting(data: dict, drift: str = _DRIFT) -> str:
    stages: list[str] = []
    for n in range(max(len(data["kick"]), len(data["drift"]))):
        for key, stage in (("kick", _KICK), ("drift", drift)):
            if n < len(data[key]) and data[key][n] != "0":
                weight = "" if data[key][n] == "1" else _fraction(data[key][n])
                stages.append(stage.format(step=f"{weight} h") + rf" && \text{{({key})}}")
    return rf"\begin{{aligned}} {_stack(stages)} \end{{aligned}}"


def _two_level(data: dict) -> str:
    p, v = data["position"], data["velocity"]
    first = _sum(
        (p["velocity"], r"h\,\boldsymbol{v}_k"),
        (p["previous"], r"h^2\boldsymbol{a}_{k-1}"),
        (p["current"], r"h^2\boldsymbol{a}_k"),
    )
    second = _sum(
        (v["previous"], r"h\,\boldsymbol{a}_{k-1}"), (v["current"], r"h\,\boldsymbol{a}_k")
    )
    lines = [
        rf"\boldsymbol{{p}}_{{k+1}} &= \boldsymbol{{p}}_k {first}",
        rf"\boldsymbol{{v}}_{{k+1}} &= \boldsymbol{{v}}_k {second}",
    ]
    return rf"\begin{{aligned}} {_stack(lines)} \end{{aligned}}"


def _stack(lines: list[str]) -> str:
    return r" \\ ".join(lines)


def _sum(*terms: tuple[str, str]) -> str:
    return " ".join(
        f"+ {'' if weight == '1' else _fraction(weight)} {letter}"
        for weight, letter in terms
        if weight != "0"
    )


def _fraction(text: str) -> str:
    above, _, below = text.partition("/")
    return rf"\tfrac{{{above}}}{{{below}}}" if below else text


_TABLEAUS = {
    "runge_kutta": _butcher,
    "splitting": _splitting,
    "exponential": lambda data: _splitting(data, drift=_EXACT),
    "two_level": _two_level,
}
