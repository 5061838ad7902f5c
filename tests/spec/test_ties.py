"""Statements are tied to what is executed, and those that are not are few and say so."""

from pathlib import Path

import pytest

from tamias2d.spec.reader import read
from tools.mutate_statements import Mutant, is_noticed, mutants

SPECIFICATION = read(Path(__file__).parents[2] / "srs")
UNCHECKED = {
    *("DD2", "DD5", "DD19", "DD46", "DD67", "DD68", "GD3", "GD4", "GD6"),
    *("P3", "P7", "P8", "P9", "P12"),
}
"""None may come to these: whoever writes a statement ties it."""
TIED = [
    mutant
    for mutant in mutants(SPECIFICATION, each=1, seed=4)
    if mutant.path[0] in ("equation", "states") and not {"unchecked", "crowd"} & {*mutant.item.data}
][::6]


def test_what_nothing_checks_is_listed() -> None:
    marked = {id for id, item in SPECIFICATION.items.items() if "unchecked" in item.data}
    assert marked == UNCHECKED


@pytest.mark.parametrize("mutant", TIED, ids=lambda mutant: f"{mutant.item.id}-{mutant.path[-1]}")
def test_a_slip_in_a_statement_is_noticed(mutant: Mutant) -> None:
    assert is_noticed(mutant, SPECIFICATION), mutant
