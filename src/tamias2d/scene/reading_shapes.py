"""The shape of a body in a scene file."""

from collections.abc import Callable
from typing import Any

from tamias2d.scene.chain import Chain
from tamias2d.scene.compound import Compound, Part, Shape
from tamias2d.scene.forms import likely, listed, mapping, within
from tamias2d.scene.quantities import read_value, scalar_text
from tamias2d.scene.rules import RuleError, shown
from tamias2d.scene.shapes import Box, Capsule, Disc, HalfPlane, Polygon, Segment

_KEYS: dict[str, tuple[str, ...]] = {
    "disc": ("radius",),
    "box": ("width", "height"),
    "polygon": ("vertices",),
    "capsule": ("length", "radius"),
    "segment": ("length",),
    "compound": ("parts",),
    "chain": ("vertices",),
    "half-plane": ("normal", "offset"),
    "none": (),
}
_MAY = {"chain": ("loop", "one_sided")}
_OF_PART = ("position", "orientation", "restitution", "friction")
_SHAPES: dict[str, Callable[..., Shape]] = {
    "disc": Disc,
    "box": Box,
    "polygon": Polygon,
    "capsule": Capsule,
    "segment": Segment,
    "compound": Compound,
    "chain": Chain,
    "half-plane": HalfPlane,
}


def shape_keys(raw: object, what: str) -> tuple[str, ...]:
    """Return which keys the shape of a body, or of a part, must have beside it."""
    return _KEYS[_form(raw, what)]


def optional_shape_keys(raw: object, what: str) -> tuple[str, ...]:
    """Return which keys the shape of a body may have beside it."""
    return _MAY.get(_form(raw, what), ())


def read_shape(raw: dict[str, object], what: str) -> Shape | None:
    """Return the shape of a body or a part whose keys are those that it must have."""
    form = _form(raw, what)
    values: dict[str, Any] = {
        key: _parts(raw[key]) if key == "parts" else read_value(raw[key], key, (key,))
        for key in (*_KEYS[form], *_MAY.get(form, ()))
        if key in raw
    }
    return _SHAPES[form](**values) if form in _SHAPES else None


def _form(raw: object, what: str) -> str:
    form = scalar_text(mapping(raw, what, must=("shape",))["shape"], ("shape",))
    if form not in _KEYS:
        raise RuleError(
            f"shape of {what}: found {shown(form)}{likely(form, _KEYS)}: "
            f"must be one of {', '.join(_KEYS)} (R2). Correct the word.",
            "shape",
        )
    return form


def _parts(raw: object) -> list[Part]:
    return [_part(entry, k) for k, entry in enumerate(listed(raw, "parts"))]


def _part(raw: object, k: int) -> Part:
    what = f"part {k}"
    with within("parts", k):
        keys = shape_keys(raw, what)
        part = mapping(raw, what, must=("shape", *keys), may=_OF_PART)
        values: dict[str, Any] = {
            key: read_value(part[key], key, (key,)) for key in _OF_PART if key in part
        }
        return Part(shape=read_shape(part, what), **values)  # type: ignore[arg-type]  # it checks
