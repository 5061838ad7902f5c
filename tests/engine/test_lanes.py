"""The solver's inner loops as machine code: several lanes in one instruction."""

import platform
import re
from collections.abc import Callable
from pathlib import Path

import pytest
from llvmlite.binding import get_host_cpu_features

from tamias2d.engine.solver.lanes import apply_restitution, relax, solve_soft, warm_start
from tamias2d.engine.tables import World
from tamias2d.kernels import Library

_ARITHMETIC = r"\bv?(?:add|sub|mul|div){}\b"


def warm_start_alone(world: World, first: int, last: int) -> None:
    """An entry: some blocks through `warm_start`."""
    warm_start(first, last, world.bodies, world.constraints)


def solve_soft_alone(world: World, first: int, last: int, substep: float) -> None:
    """An entry: some blocks through `solve_soft`."""
    solve_soft(first, last, world.bodies, world.constraints, substep)


def relax_alone(world: World, first: int, last: int, substep: float) -> None:
    """An entry: some blocks through `relax`."""
    relax(first, last, world.bodies, world.constraints, substep, True)


def apply_restitution_alone(world: World, again: int, slowest: float) -> None:
    """An entry: all blocks through `apply_restitution`."""
    apply_restitution(again > 0, world.bodies, world.constraints, slowest)


PARTS = (warm_start_alone, solve_soft_alone, relax_alone, apply_restitution_alone)


@pytest.mark.skipif(platform.machine() != "x86_64", reason="looks at x86-64 machine code")
@pytest.mark.parametrize("part", PARTS)
def test_blocks_are_worked_on_by_packed_arithmetic(
    part: Callable[..., None], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Compiled twice, for lanes in one go and one by one where arrays might overlap: not once."""
    monkeypatch.setenv("TAMIAS2D_HOME", str(tmp_path))  # cached code cannot be looked at
    compiled = getattr(Library(part.__name__, (part,)).compiled(), part.__name__)
    (assembly,) = compiled.inspect_asm().values()
    packed, single = (len(re.findall(_ARITHMETIC.format(kind), assembly)) for kind in ("pd", "sd"))
    assert packed >= single > 0, f"{packed} instructions are packed, {single} are not"
    if get_host_cpu_features().get("avx512f"):
        assert re.search(_ARITHMETIC.format("pd") + ".*zmm", assembly), "half of the lanes is idle"
