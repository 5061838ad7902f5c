"""The solver's inner loops as machine code: several lanes in one instruction."""

import platform
import re
from collections.abc import Callable
from pathlib import Path

import pytest
from llvmlite.binding import get_host_cpu_features

from tamias2d.engine import tables as tb
from tamias2d.engine.solver.lanes import (
    relax_lanes,
    relax_lanes_of_two,
    restitution_lanes,
    soft_lanes,
    soft_lanes_of_two,
    warm_start_lanes,
)
from tamias2d.engine.tables import World
from tamias2d.kernels import Library

_ARITHMETIC = r"\bv?(?:add|sub|mul|div){}\b"


def warm_start_alone(world: World, substep: float) -> None:  # noqa: ARG001
    """An entry: the lanes of a block, warm-started."""
    warm_start_lanes(tb.FIRST_POINT, world.constraints.blocks[0], world.constraints.scratch)


def soften_alone(world: World, substep: float) -> None:
    """An entry: the lanes of a block, solved softly."""
    soft_lanes(world.constraints.blocks[0], world.constraints.scratch, substep)


def soften_two_alone(world: World, substep: float) -> None:
    """An entry: the same with two points in each lane."""
    soft_lanes_of_two(world.constraints.blocks[0], world.constraints.scratch, substep)


def relax_alone(world: World, substep: float) -> None:
    """An entry: the lanes of a block, relaxed."""
    relax_lanes(world.constraints.blocks[0], world.constraints.scratch, substep, 1.0)


def relax_two_alone(world: World, substep: float) -> None:
    """An entry: the same with two points in each lane."""
    relax_lanes_of_two(world.constraints.blocks[0], world.constraints.scratch, substep, 1.0)


def restitution_alone(world: World, substep: float) -> None:  # noqa: ARG001
    """An entry: restitution of the lanes of a block."""
    row, scratch = world.constraints.blocks[0], world.constraints.scratch
    restitution_lanes(tb.FIRST_POINT, tb.FIRST_RESTITUTION, row, scratch)


PARTS = (
    *(warm_start_alone, soften_alone, soften_two_alone),
    *(relax_alone, relax_two_alone, restitution_alone),
)


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
