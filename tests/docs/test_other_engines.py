"""What the tables for users of other engines name is there, with the arguments that they give."""

import inspect
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

import tamias2d as t2

PAGE = (Path(__file__).parents[2] / "docs/frame_loop.md").read_text()
_KEYS = re.compile(r"(\w+)=")


def cells() -> Iterator[str]:
    """Yield the code of the right column of all tables of that section."""
    section = PAGE.partition("\n## From Pymunk and Box2D\n")[2]
    for line in section.splitlines():
        if line.startswith("| ") and not line.endswith("| here |"):
            yield from re.findall(r"`([^`]+)`", line.split(" | ", 1)[1])


CODE = sorted(set(cells()))
_KNOWN = {
    key
    for call in (
        *(t2.Simulator, t2.Simulator.add, t2.Simulator.add_kinematic, t2.Simulator.add_static),
        *(t2.Simulator.set_filters, t2.Simulator.apply_force, t2.Simulator.apply_impulse),
        *(t2.Scene, t2.Disc, t2.Box, t2.Polygon, t2.Capsule, t2.Segment, t2.Chain, t2.Compound),
        *(t2.Part, t2.Simulator.shape_cast, t2.Simulator.set_surface),
    )
    for key in inspect.signature(call).parameters
}


def test_there_are_tables() -> None:
    assert len(CODE) > 40


@pytest.mark.parametrize("code", CODE)
def test_all_names_are_there(code: str) -> None:
    for name in re.findall(r"sim\.(\w+)", code):
        assert hasattr(t2.Simulator, name)
    for name in re.findall(r"\b([A-Z]\w+)\(", code):
        assert hasattr(t2, name)
    for name in re.findall(r"\.(?:began|contacts)\.(\w+)", code):
        assert name in t2.Contacts.__dataclass_fields__
    assert set(_KEYS.findall(code)) <= _KNOWN
