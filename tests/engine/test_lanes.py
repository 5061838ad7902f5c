"""The solver's inner loops as machine code: several lanes in one instruction."""

import platform
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from tamias2d.kernels import Engine
from tamias2d.kernels.arrays import FloatRows, Floats, PlaceRows
from tamias2d.stepped import solver

_TYPES = {
    "rows": FloatRows, "lanes": PlaceRows, "motion": FloatRows, "bench": Floats,
    "blocks": int, "first": int, "last": int,
}  # fmt: skip
_ARITHMETIC = r"\bv?(?:add|sub|mul|div){}\b"


@pytest.mark.skipif(platform.machine() != "x86_64", reason="looks at x86-64 machine code")
@pytest.mark.parametrize("part", [solver.warm, solver.sweep, solver.relax, solver.bounce])
def test_blocks_are_worked_on_by_packed_arithmetic(
    part: Callable[..., Any], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Compiled twice, for lanes in one go and one by one where arrays might overlap: not once."""
    monkeypatch.setenv("TAMIAS2D_HOME", str(tmp_path))  # cached code cannot be looked at
    names = [name for name in part.__annotations__ if name != "return"]
    types = {name: _TYPES.get(name, float) for name in names}
    monkeypatch.setattr(part, "__annotations__", types)
    compiled = getattr(Engine(f"solver's {part.__name__}", (part,)).compiled(), part.__name__)
    (assembly,) = compiled.inspect_asm().values()
    packed, single = (len(re.findall(_ARITHMETIC.format(kind), assembly)) for kind in ("pd", "sd"))
    assert packed >= single > 0, f"{packed} instructions are packed, {single} are not"
