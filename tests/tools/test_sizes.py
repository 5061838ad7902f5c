"""Functions that are too long, or take too many parameters, are found and named."""

from pathlib import Path

import pytest

from tools import sizes


def package(folder: Path, **files: str) -> Path:
    for name, text in files.items():
        path = folder / f"{name.replace('__', '/')}.py"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return folder


def function(lines: int, head: str = "def f():") -> str:
    return "\n    ".join([head, *["x = 1"] * (lines - 1)]) + "\n"


def parameters(count: int) -> str:
    return ", ".join(f"p{k}" for k in range(count))


def test_sizes_at_the_limits_are_allowed(tmp_path: Path) -> None:
    ten = f"def g({parameters(10)}, *, key=1):\n    pass\n"
    source = package(tmp_path, long=function(60), wide=ten, other=function(3) * 5)
    assert sizes.faults(sizes.sizes(source)) == []
    assert sizes.main(source) == 0


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (function(61), "a/b.py:f: found 61 lines"),
        (f"def f({parameters(11)}):\n    pass\n", "and 11 positional parameters"),
        (
            f"class C:\n    def f(self, {parameters(11)}): pass\n",
            "a/b.py:C.f: found 1 lines and 11",
        ),
        (
            "def f():\n    " + function(61, "def g():").replace("\n", "\n    "),
            "a/b.py:f.g: found 61",
        ),
    ],
)
def test_one_beyond_a_limit_is_named(
    tmp_path: Path, text: str, said: str, capsys: pytest.CaptureFixture[str]
) -> None:
    source = package(tmp_path, a__b=text)
    assert sizes.main(source) == 1
    assert said in capsys.readouterr().err


def test_docstrings_self_and_generated_code_do_not_count(tmp_path: Path) -> None:
    docstring = '    """One.\n' + "\n" * 70 + '    """\n'
    method = f"class C:\n    def f(self, {parameters(10)}): pass\n"
    source = package(
        tmp_path,
        a__b="def f():\n" + docstring + "    pass\n",
        a__c=method,
        generated__d=function(99),
    )
    assert sizes.faults(sizes.sizes(source)) == []


def test_the_median_of_a_package_is_held(tmp_path: Path) -> None:
    source = package(tmp_path, a__b=function(16) + function(17) + function(2), c=function(2))
    assert sizes.faults(sizes.sizes(source)) == [
        "a: found a median of 16 lines: must be at most 15. Divide its functions."
    ]


def test_an_exception_counts_as_long_as_it_is_needed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    source = package(tmp_path, a__b=function(61), a__c=function(2) * 3)
    monkeypatch.setitem(sizes.EXCEPTIONS, "a/b.py:f", "one list that is read as a whole")
    assert sizes.faults(sizes.sizes(source)) == []
    package(tmp_path, a__b=function(60))
    (fault,) = sizes.faults(sizes.sizes(source))
    assert "a/b.py:f: is within the limits" in fault
