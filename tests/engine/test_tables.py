"""The columns of the engine's arrays."""

import ast
from collections import Counter
from pathlib import Path

from tamias2d.engine import tables


def test_each_name_stands_for_one_column() -> None:
    """A name that is assigned again would mean the later column in the arrays of both."""
    assigned = Counter(
        name.id
        for file in Path(tables.__file__).parent.glob("*.py")
        for line in ast.parse(file.read_text()).body
        if isinstance(line, ast.Assign)
        for target in line.targets
        for name in ast.walk(target)
        if isinstance(name, ast.Name) and name.id.isupper()
    )
    assert [name for name, times in assigned.items() if times > 1] == []
