"""Engines: plain functions and what is compiled from them agree, and nothing stale is run."""

import ast
import gc
import os
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from hypothesis import given, strategies as st

import tamias2d as t2
from tamias2d.commands import warm
from tamias2d.kernels import Library, library
from tamias2d.kernels.arrays import Floats
from tamias2d.kernels.assembled import assembled
from tamias2d.kernels.compiled import loaded
from tamias2d.kernels.groups import addresses
from tamias2d.spec.functions import largest, least, total
from tests.kernels import plain_parts

NUMBER = st.floats(width=64)


def as_engine(function: Callable[..., Any]) -> Callable[..., Any]:
    """A function as if it were in a module of the package, which others are not assembled from."""
    function.__module__ = "tamias2d.engine.test"
    return function


def forget() -> None:
    """What is compiled is on disk only, as for a process that has just started."""
    loaded.cache_clear()
    library._compiled.__wrapped__.cache_clear()


PARTS = (
    *(plain_parts.halved, plain_parts.clamped, plain_parts.pushed, plain_parts.fallen),
    plain_parts.heaped,
)
for part in PARTS:
    as_engine(part)
LIBRARY = Library("library of the tests", (plain_parts.pushed, plain_parts.fallen))
OF_MANY = Library("library of many", (plain_parts.heaped,))


def test_compiled_and_plain_libraries_have_the_same_bits() -> None:
    rows = np.random.default_rng(1).normal(size=(7, 48))
    with np.errstate(all="ignore"):
        results = []
        for made in (LIBRARY.plain(), LIBRARY.compiled()):
            work = rows.copy()
            value = made.pushed(work, 7)
            made.fallen(work, 0.3)
            results.append((value, work.tobytes()))
    assert results[0] == results[1]


def test_one_call_works_on_many_groups() -> None:
    heaps = [plain_parts.Heap(np.zeros((size, 2))) for size in (1, 3, 2)]
    tables, results = np.stack([addresses(heap) for heap in heaps]), np.zeros(3, dtype=np.int64)
    assert OF_MANY.compiled().heaped(tables, results, 5) == 2
    assert results.tolist() == [1, 3, 2]
    assert all((heap.rows == (5.0, 0.0)).all() for heap in heaps)
    assert OF_MANY.plain().heaped(heaps[1], -5) == 3
    assert not heaps[1].rows.any()


def test_the_collector_of_the_process_keeps_its_pace_after_compiling() -> None:
    before = gc.get_threshold()
    gc.set_threshold(701, 11, 12)
    try:
        forget()
        LIBRARY.compiled()
        assert gc.get_threshold() == (701, 11, 12)
    finally:
        gc.set_threshold(*before)


def unassembled() -> float:
    """What uses a function of another package."""
    return float(np.sin(1.0))


def test_a_library_that_cannot_be_assembled_is_tried_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """Each of thousands of tests tried again, for ten seconds or more, and seemed to hang."""
    tried: list[Library] = []
    assemble = Library.source

    def counted(made: Library) -> str:
        tried.append(made)
        return assemble(made)

    monkeypatch.setattr(Library, "source", counted)
    broken = Library("broken library", (as_engine(unassembled),))
    said = []
    for _ in range(3):
        with pytest.raises(TypeError, match=r"test\.unassembled: 'np\.sin' is ") as refused:
            broken.compiled()
        said.append((str(refused.value), len(refused.traceback)))
    assert tried == [broken]
    assert said[1] == said[2]  # no longer each time
    assert said[0][0] == said[1][0]


def test_a_library_that_is_not_compiled_is_tried_once(monkeypatch: pytest.MonkeyPatch) -> None:
    tried: list[str] = []

    def refused(text: str) -> ModuleType:
        tried.append(text)
        raise ValueError("the compiler refuses")

    monkeypatch.setattr(library, "loaded", refused)
    broken = Library("refused library", (plain_parts.pushed,))
    for _ in range(3):
        with pytest.raises(ValueError, match="the compiler refuses"):
            broken.compiled()
    assert len(tried) == 1


@pytest.mark.parametrize("fault", [OSError("no space"), t2.InputError("others may write")])
def test_what_may_be_mended_meanwhile_is_tried_again(
    fault: Exception, monkeypatch: pytest.MonkeyPatch
) -> None:
    made = Library(f"library in want of {type(fault).__name__}", (plain_parts.pushed,))

    def refused(_text: str) -> ModuleType:
        raise fault

    with monkeypatch.context() as without:
        without.setattr(library, "loaded", refused)
        with pytest.raises(type(fault), match=str(fault)):
            made.compiled()
    assert made.compiled().pushed is not None


def lesser(first: float, second: float) -> float:
    return least(first, second)


def greater(first: float, second: float) -> float:
    return largest(first, second)


EXTREMES = Library("extremes", (as_engine(lesser), as_engine(greater)))


@given(NUMBER, NUMBER)
def test_least_and_largest_agree_on_zeros_and_on_what_is_no_number(
    first: float, second: float
) -> None:
    for pair in [(first, second), (first, -first), (0.0, -0.0), (-0.0, 0.0)]:
        for name in ("lesser", "greater"):
            plain, compiled = (
                np.float64(getattr(made, name)(*pair)).tobytes()
                for made in (EXTREMES.plain(), EXTREMES.compiled())
            )
            assert plain == compiled, (name, pair)


def test_a_source_stands_alone_and_reads_in_order() -> None:
    text = LIBRARY.source()
    tree = ast.parse(text)
    heads = [node for node in tree.body if isinstance(node, ast.FunctionDef)]
    assert [head.name for head in heads] == [
        "halved", "impact_impulse", "clamped", "pushed", "translation_acceleration", "fallen",
    ]  # fmt: skip
    modules = {node.module for node in tree.body if isinstance(node, ast.ImportFrom)}
    assert modules == {"math", "numba"}
    assert "a comment stays" in text
    assert "Source: IM3, srs/models/impact.md:" in text
    assert "not copied" not in text
    assert not re.search(r"Scalar|: float|-> |@inlined|@separate", text)
    assert re.findall(r"forceinline=True\)\ndef (\w+)", text) == ["clamped"]
    assert re.findall(r'inline="never"\)\ndef (\w+)', text) == ["halved"]
    assert {"LANES = 16", "HALF = 0.5"} <= set(text.splitlines())


def test_what_is_marked_so_is_a_function_of_its_own_in_machine_code(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("TAMIAS2D_HOME", str(tmp_path))
    forget()
    code = "".join(LIBRARY.compiled().pushed.inspect_asm().values())
    made = re.findall(r"^\w*?\d(halved|clamped|impact_impulse)\w*:", code, re.MULTILINE)
    assert made == ["halved"]
    forget()


NUMBERS = """
from tamias2d.kernels.arrays import Floats, Indices, Places
def chosen(rows: Floats, k: int, half: bool) -> float:
    return 0.5 * rows[k] if half else rows[k]
def summed(rows: Floats, narrow: Indices, places: Places, half: bool) -> float:
    found = chosen(rows, 0, False) + chosen(rows, 1, True) + chosen(rows, len(rows) - 1, half)
    return found + chosen(rows, narrow[0], half) + chosen(rows, places[0], not half)
"""


def test_a_function_is_compiled_once_whatever_whole_numbers_it_takes(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("TAMIAS2D_HOME", str(tmp_path))
    made = Library("numbers", (module("numbers", NUMBERS).summed,))
    arrays = np.array([1.0, 2.0, 4.0]), np.array([-1], np.int32), np.array([2], np.uint32)
    assert made.compiled().summed(*arrays, True) == made.plain().summed(*arrays, True) == 10.0
    assert len(loaded(made.source()).chosen.signatures) == 1


def module(name: str, text: str) -> ModuleType:
    """A module of the package, from a text that can be looked up."""
    import linecache

    made = ModuleType(f"tamias2d.engine.{name}")
    file = f"<{name} {abs(hash(text))}>"
    linecache.cache[file] = (len(text), None, text.splitlines(keepends=True), file)
    sys.modules[made.__name__] = made
    exec(compile(text, file, "exec"), made.__dict__)
    return made


HELPER = "def factor(x: float) -> float:\n    return {} * x\n"
CALLER = """
from tamias2d.engine.helper import factor
def twice(x: float) -> float:
    return factor(x)
"""


def test_a_changed_helper_in_another_module_is_compiled_anew(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("TAMIAS2D_HOME", str(tmp_path))
    answers = []
    for number in ("2.0", "4.0"):
        module("helper", HELPER.format(number))
        made = module("caller", CALLER)
        answers.append(Library("caller", (made.twice,)).compiled().twice(1.0))
    assert answers == [2.0, 4.0]
    assert len(list((tmp_path / "kernels").iterdir())) == 2


def unknown(x: float) -> float:
    return x + missing  # type: ignore[name-defined]  # noqa: F821


def array_function(x: Floats) -> float:
    return float(np.sum(x))


def summed(x: Floats) -> float:
    return float(total(x))


def shadowed(x: float) -> float:
    LANES = plain_parts.LANES  # noqa: N806
    return x + LANES


def untyped(x: np.ndarray[Any, Any]) -> float:
    return float(x[0])


HALF = 2


def two_halves(x: float) -> float:
    return x + HALF + plain_parts.HALF


@pytest.mark.parametrize(
    ("function", "says"),
    [
        (unknown, r"engine\.test\.unknown: 'missing' is not known"),
        (
            array_function,
            r"array_function: 'np.sum' is .*: must be a function of this package",
        ),
        (summed, r"functions\.total: 'np.sum' is"),
        (shadowed, "'LANES' is also a variable"),
        (untyped, "argument 'x': an entry of a kernel takes"),
        (two_halves, r"two_halves: 'HALF' has another meaning in tamias2d\.\w+\.test\.two_halves"),
    ],
    ids=lambda case: getattr(case, "__name__", ""),
)
def test_what_cannot_be_compiled_is_refused_by_name(
    function: Callable[..., Any], says: str
) -> None:
    with pytest.raises(TypeError, match=says):
        assembled(as_engine(function), says="Refused.")


def test_who_waits_is_told_and_only_then(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("TAMIAS2D_HOME", str(tmp_path))
    forget()
    LIBRARY.compiled()
    told = capsys.readouterr()
    assert told.out == ""
    seconds = f"{LIBRARY.time_of_compiling():.0f} s of processor time"
    assert f"Compiling the library of the tests: 6 functions, about {seconds}" in told.err
    forget()
    LIBRARY.compiled()
    assert capsys.readouterr().err == ""
    forget()


def test_warming_up_compiles_what_is_on_the_menu(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("TAMIAS2D_HOME", str(tmp_path))
    monkeypatch.setattr(warm, "MENU", (LIBRARY, EXTREMES))
    forget()
    warm.warm_up()
    told = capsys.readouterr()
    assert told.err.count("Compiling") == 2
    assert re.fullmatch(
        r"library of the tests: ready after [\d.]+ s\nextremes: ready after [\d.]+ s\n"
        rf"Compiled code is kept in {re.escape(str(tmp_path))}.kernels\.\n",
        told.out,
    )
    forget()


TWICE = """
import numpy as np
from tests.kernels.test_library import LIBRARY
made = LIBRARY.compiled()
print(made.pushed(np.ones((1, 48)), 1), len(made.pushed.stats.cache_hits))
"""


def run(home: Path) -> subprocess.Popen[str]:
    environment = {"TAMIAS2D_HOME": str(home), "PATH": "", "PYTHONPATH": ":".join(sys.path)}
    return subprocess.Popen(
        [sys.executable, "-c", TWICE],
        env=environment,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        cwd=Path(__file__).parents[2],
    )


def test_two_processes_compile_at_once_and_a_third_finds_it(tmp_path: Path) -> None:
    both = [run(tmp_path), run(tmp_path)]
    said = [process.communicate()[0].split() for process in both]
    third, told = run(tmp_path).communicate()
    assert said[0][0] == said[1][0] == third.split()[0]
    assert third.split()[1] == "1"
    assert told == ""


@pytest.mark.skipif(os.name != "posix", reason="directories without leave to write")
def test_kernels_that_cannot_be_written_are_compiled_all_the_same(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("TAMIAS2D_HOME", str(tmp_path))
    (tmp_path / "kernels").write_text("in the way")  # a directory without leave stops no superuser
    forget()
    made = LIBRARY.compiled()
    assert made.pushed(np.ones((1, 48)), 1) == LIBRARY.plain().pushed(np.ones((1, 48)), 1)
    forget()


@pytest.mark.skipif(not hasattr(os, "fork"), reason="processes that fork")
def test_a_forked_process_goes_on_with_what_was_compiled() -> None:
    made = LIBRARY.compiled()
    child = os.fork()
    if child == 0:
        os._exit(0 if made.pushed(np.ones((1, 48)), 1) >= 0 else 1)
    assert os.waitpid(child, 0)[1] == 0
