"""The expression language: what it reads, what it refuses, and that its printers agree."""

import math
import pickle
from collections.abc import Iterator, Mapping
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import example, given, settings, strategies as st

from tamias2d.spec.derivative import differentiate
from tamias2d.spec.evaluate import Program, evaluate
from tamias2d.spec.expression import ARITY, Node, names, parse
from tamias2d.spec.messages import Code, SpecFault
from tamias2d.spec.symbols import table_from
from tamias2d.spec.tex import plain, tex

HOSTILE = [
    "__import__('os').system('true')",
    "().__class__",
    "lambda: 0",
    "[x for x in y]",
    "a if b else c",
    "open('f')",
    "f'{a}'",
    "a.b",
    "a[0]",
    "sin(*a)",
    "sin(x=a)",
    "a or b",
    "not a",
    "a := 1",
    "a @ b",
    "a // b",
    "a % b",
    "a << b",
    "~a",
    "a != b",
    "a < b < c",
    "True",
    "None",
    "1j",
    "0x10",
    "1_000",
    "'text'",
    "b'text'",
    "...",
    "eval('1')",
    "9**999999",
    "a**b",
    "exec",
]


@pytest.mark.parametrize("text", HOSTILE)
def test_hostile_text_is_refused_or_a_mere_name(text: str) -> None:
    if text == "exec":
        assert names(parse(text)) == ("exec",)
        return
    with pytest.raises(SpecFault):
        parse(text)


@given(st.text(max_size=60))
def test_any_text_is_read_or_refused(text: str) -> None:
    try:
        parse(text)
    except SpecFault as fault:
        assert isinstance(fault.code, Code)
        assert 0 <= fault.offset <= len(text) + 1


@given(
    st.lists(
        st.sampled_from([*ARITY, "a", "1", "(", ")", "+", "*", "**", ",", "[m]", " "]), max_size=25
    )
)
def test_any_words_are_read_or_refused(words: list[str]) -> None:
    try:
        tree = parse("".join(words))
    except SpecFault:
        return
    assert parse(plain(tree)) == tree


@pytest.mark.parametrize(
    "text", ["(" * 900 + "a", "-" * 900 + "a", "a" * 5000, "1e400", "1e-400", "9" * 60]
)
def test_excess_is_refused(text: str) -> None:
    with pytest.raises(SpecFault):
        parse(text)


def leaves() -> st.SearchStrategy[str]:
    return st.sampled_from(["a", "b", "2", "0.5", "(a + 1)"])


expressions = st.recursive(
    leaves(),
    lambda inner: st.one_of(
        st.tuples(inner, st.sampled_from("+-*/"), inner).map(lambda t: f"({t[0]} {t[1]} {t[2]})"),
        inner.map(lambda t: f"-({t})"),
        inner.map(lambda t: f"({t})**2"),
        inner.map(lambda t: f"sin({t})"),
    ),
    max_leaves=8,
)


def test_a_leading_plus_changes_nothing() -> None:
    assert parse("+1[N]*a - +2[N]") == parse("1[N]*a - 2[N]")


@given(expressions)
def test_plain_text_reads_back_as_the_same_tree(text: str) -> None:
    assert parse(plain(parse(text))) == parse(text)


@given(expressions, st.floats(0.2, 3), st.floats(0.2, 3))
def test_evaluation_is_what_python_computes(text: str, a: float, b: float) -> None:
    names_of_python = {"a": a, "b": b, "sin": math.sin, "__builtins__": {}}
    try:
        wanted = eval(text, names_of_python)
    except (ZeroDivisionError, OverflowError):
        return
    if abs(wanted) < 1e6:
        assert evaluate(parse(text), {"a": a, "b": b}) == pytest.approx(wanted, rel=1e-9, abs=1e-9)


@pytest.mark.parametrize(
    "text",
    [
        "a*a*b",
        "sin(a*b)",
        "a/(b + a)",
        "(a + b)**3",
        "exp(-a)*cos(b*a)",
        "sqrt(a + b)",
        "log(a)/a",
        "phi1(-a*b)",
        "a*phi2(-3*a)",
    ],
)
def test_derivative_is_the_slope(text: str) -> None:
    tree, at, h = parse(text), {"a": 1.3, "b": 0.7}, 1e-6
    ahead, behind = (evaluate(tree, {**at, "a": 1.3 + s * h}) for s in (1, -1))
    # central differences err by h^2 and by rounding over h: about 1e-10
    assert evaluate(differentiate(tree, "a"), at) == pytest.approx(
        (ahead - behind) / (2 * h), rel=1e-8
    )


def test_vectors() -> None:
    values = {"a": (1.0, 2.0), "b": (3.0, -4.0), "w": 2.0}
    wanted = {
        "dot(a, b)": -5.0,
        "cross(a, b)": -10.0,
        "cross(w, a)": (-4.0, 2.0),
        "perp(a)": (-2.0, 1.0),
        "norm(b)": 5.0,
        "w*a - b": (-1.0, 8.0),
        "vector(x(a), y(b))": (1.0, -4.0),
    }
    assert {text: evaluate(parse(text), values) for text in wanted} == wanted


def test_arrays_give_the_same_bits_as_floats() -> None:
    tree = parse("sin(a)*b**3/(a + 2) - sqrt(b)")
    a, b = np.linspace(0.1, 5, 200), np.linspace(1, 9, 200)
    many = evaluate(tree, {"a": a, "b": b})
    single = [evaluate(tree, {"a": float(p), "b": float(q)}) for p, q in zip(a, b, strict=True)]
    assert many.tolist() == single


class _Counted(Mapping[str, float]):
    """A value for each name, and how often it was asked for."""

    asked = 0

    def __getitem__(self, name: str) -> float:
        self.asked += 1
        return float(len(name))

    def __iter__(self) -> Iterator[str]:
        return iter(())

    def __len__(self) -> int:
        return 0


def test_what_is_written_twice_is_computed_once() -> None:
    program, values = Program(parse("sin(time)*sin(time) + cos(time)/sin(time)")), _Counted()
    s, c = math.sin(4.0), math.cos(4.0)
    assert program(values) == s * s + c / s
    assert values.asked == 1
    assert pickle.loads(pickle.dumps(program))(values) == s * s + c / s  # scenes are copied


@settings(deadline=None)  # sums of fractions
@given(st.integers(-20 * 2**20, 20 * 2**20).map(lambda n: n / 2**20))
@example(0.0)
@example(-1e-9)
@example(-1.0)
def test_phi_functions_are_the_integrals_of_the_exponential(z: float) -> None:
    # phi_k(z) = sum of z^n/(n + k)!, summed here without rounding
    exact = Fraction(z)
    for name, k in (("phi1", 1), ("phi2", 2)):
        total, term = Fraction(0), Fraction(1, math.factorial(k))
        for n in range(110):
            total += term
            term *= exact / (n + 1 + k)
        wanted = pytest.approx(float(total), rel=2e-15)
        assert evaluate(parse(f"{name}(z)"), {"z": z}) == wanted
        assert evaluate(parse(f"{name}(z)"), {"z": np.array([z])})[0] == wanted


def test_a_measure_is_in_si_units() -> None:
    assert evaluate(parse("90[deg]"), {}) == pytest.approx(math.pi / 2, rel=1e-15)
    assert evaluate(parse("3[km]/1.5[min]"), {}) == pytest.approx(3000 / 90, rel=1e-15)


@pytest.mark.parametrize(
    ("text", "wanted"),
    [("0.5", "0.5"), ("1e-150", "10^{-150}"), ("2.5e-8", r"2.5 \cdot 10^{-8}"), ("12", "12")],
)
def test_small_numbers_are_powers_of_ten_in_tex(text: str, wanted: str) -> None:
    assert tex(parse(text), table_from({})) == wanted


def test_offsets_point_at_the_place() -> None:
    with pytest.raises(SpecFault) as caught:
        parse("  a + b.c")
    assert caught.value.offset == 6
    tree: Node = parse("  a + b")
    assert tree.offset == 2


@pytest.mark.parametrize(
    ("text", "offset", "remedy"),
    [
        ("dot(velocity, velocity)^2", 23, r"Write '\*\*'"),
        ("a == 3[m/s^2]*(b + c) ^ 2", 22, r"Write '\*\*'"),
        ("2 cubic_drag_force", 2, r"between '2' and 'cubic_drag_force'.*Write '\*'"),
        ("a == 2velocity", 6, r"between '2' and 'velocity'.*Write '\*'"),
        ("(a + b) c and d > 0", 8, r"between '\)' and 'c'.*Write '\*'"),
        ("a + 2e-3(b + c)", 4, r"products need '\*'"),
    ],
)
def test_likely_mistakes_name_the_remedy(text: str, offset: int, remedy: str) -> None:
    with pytest.raises(SpecFault, match=remedy) as caught:
        parse(text)
    assert caught.value.offset == offset


@pytest.mark.parametrize("text", ["a and", "a == * b", "a > 0 and b +", "a > 0 and and b > 0"])
def test_other_mistakes_promise_no_remedy(text: str) -> None:
    with pytest.raises(SpecFault, match="Correct the expression"):
        parse(text)
