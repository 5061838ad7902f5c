"""`import tamias2d` costs little, and every public name is there when it is used."""

import ast
import subprocess
import sys
import textwrap
from importlib import metadata
from pathlib import Path

import pytest

import tamias2d

HEAVY = ("rerun", "pyarrow", "numba", "matplotlib", "sphinx", "scipy", "pymunk", "typer", "rich")


def python(code: str) -> str:
    done = subprocess.run(
        [sys.executable, "-c", textwrap.dedent(code)], capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr
    return done.stdout.strip()


def test_import_pulls_in_nothing_heavy() -> None:
    loaded = python("import sys, tamias2d; print(*(m.partition('.')[0] for m in sys.modules))")
    assert not set(loaded.split()) & set(HEAVY)


def test_simulating_pulls_in_neither_viewer_nor_plots() -> None:
    loaded = python(
        """
        import sys
        import tamias2d as t2
        scene = t2.catalogue.load("tc3")
        t2.simulate(scene, duration=1.0)
        print(*sys.modules)
        """
    ).split()
    assert not {name.partition(".")[0] for name in loaded} & (set(HEAVY) - {"scipy"})
    assert "scipy.spatial" not in loaded  # half of the time that simulating takes to load


def test_import_is_quick_because_it_loads_almost_nothing() -> None:
    """Counted, not timed: a clock also tells what else the machine does."""
    code = """
    import sys
    before = set(sys.modules)
    import tamias2d
    print(len(set(sys.modules) - before))
    """
    assert int(python(code)) < 100  # NumPy alone loads 140


@pytest.mark.parametrize("name", sorted(tamias2d._HOME_OF))
def test_every_name_is_there(name: str) -> None:
    assert getattr(tamias2d, name) is not None
    assert name in dir(tamias2d)


def test_the_version_is_that_of_the_distribution() -> None:
    assert tamias2d.__version__ == metadata.version("tamias2d")
    assert "__version__" in dir(tamias2d)


def test_type_checkers_see_the_same_names() -> None:
    tree = ast.parse(Path(tamias2d.__file__).read_text(encoding="utf-8"))
    block = next(node for node in tree.body if isinstance(node, ast.If))
    seen = {
        alias.name: node.module
        for node in block.body
        if isinstance(node, ast.ImportFrom)
        for alias in node.names
    }
    assert seen == {name: f"tamias2d.{home}" for name, home in tamias2d._HOME_OF.items()}


def test_a_function_stays_itself_when_its_module_is_imported() -> None:
    assert python(
        """
        import tamias2d.simulate, tamias2d.verify
        import tamias2d as t2
        print(t2.simulate.__name__, t2.verify.__name__)
        """
    ).split() == ["simulate", "verify"]


@pytest.mark.parametrize(
    ("name", "meant"),
    [
        ("Circle", "; did you mean t2.Disc?"),
        ("Ball", "; did you mean t2.Disc?"),
        ("Poly", "; did you mean t2.Polygon?"),
        ("Rectangle", "; did you mean t2.Box?"),
        ("World", "; did you mean t2.Scene?"),
        ("Space", "; did you mean t2.Scene?"),
        ("half_plane", "; did you mean t2.HalfPlane?"),
        ("Simulater", "; did you mean t2.Simulator?"),
        ("Voxel", ". dir(tamias2d) lists what there is."),
    ],
)
def test_an_unknown_name_is_refused_with_what_was_meant(name: str, meant: str) -> None:
    with pytest.raises(AttributeError) as refusal:
        getattr(tamias2d, name)
    assert str(refusal.value) == f"t2.{name}: unknown{meant}"
