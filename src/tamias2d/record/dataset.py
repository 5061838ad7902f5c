"""Runs as labelled arrays of xarray and tables of pandas, with units: for what others analyse.

The libraries are an extra, and loaded when they are first used.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any

from tamias2d.errors import MissingExtraError

if TYPE_CHECKING:
    from tamias2d.run_data import RunData

_LIBRARIES = ("xarray", "zarr", "dask", "loky")
TIMES, BODIES, AXES = "time", "body", "axis"
DIMENSIONS: dict[str, tuple[str, ...]] = {
    "position": (TIMES, BODIES, AXES),
    "orientation": (TIMES, BODIES),
    "velocity": (TIMES, BODIES, AXES),
    "angular_velocity": (TIMES, BODIES),
    "energy": (TIMES,),
    "momentum": (TIMES, AXES),
    "angular_momentum": (TIMES,),
}
"""The axes of the values of a run."""
_UNITS = {
    "position": "m",
    "orientation": "rad",
    "velocity": "m/s",
    "angular_velocity": "rad/s",
    "energy": "J",
    "momentum": "kg m/s",
    "angular_momentum": "kg m^2/s",
    "time": "s",
}


def attributes(name: str) -> dict[str, str]:
    """Return the attributes of a variable: its unit."""
    return {"units": _UNITS[name]} if name in _UNITS else {}


@contextmanager
def extra() -> Iterator[None]:
    """Import a library of the extra `ensemble` within this.

    Raises:
        MissingExtraError: it is not installed.
    """
    try:
        yield
    except ImportError as fault:
        raise MissingExtraError(
            f"{fault.name}: is needed for labelled arrays, and not installed ({fault}). "
            'Install it by `pip install "tamias2d[ensemble]"`.',
            extra="ensemble",
        ) from fault


def refuse_missing_extra() -> None:
    """Raise `MissingExtraError` if a library of the extra `ensemble` is missing; import none."""
    with extra():
        for name in _LIBRARIES:
            if find_spec(name) is None:
                raise ModuleNotFoundError(f"No module named {name!r}", name=name)


def to_xarray(run: RunData) -> Any:
    """Return the run as an `xarray.Dataset` over time, body and axis."""
    with extra():
        import xarray
    variables = {
        name: (axes, getattr(run, name).copy(), attributes(name))
        for name, axes in DIMENSIONS.items()
    }
    certificate = {} if run.certificate is None else {"certificate": run.certificate.to_json()}
    return xarray.Dataset(
        variables,
        coords={
            TIMES: (TIMES, run.times.copy(), attributes(TIMES)),
            BODIES: (BODIES, [body.name for body in run.scene.bodies]),
            AXES: (AXES, ["x", "y"]),
        },
        attrs={
            "title": run.scene.name,
            "method": str(run.method),
            "duration": run.duration,
            "notes": list(run.notes),
            "digest": run.digest(),
            **certificate,
        },
    )


def to_dataframe(run: RunData) -> Any:
    """Return the run as a `pandas.DataFrame`: a row for each time and body, vectors in columns."""
    with extra():
        import pandas
    columns: dict[str, Any] = {}
    for name, axes in DIMENSIONS.items():
        values = getattr(run, name)
        if axes == (TIMES, BODIES, AXES):
            columns[f"{name}_x"], columns[f"{name}_y"] = (
                values[..., 0].ravel(),
                values[..., 1].ravel(),
            )
        elif axes == (TIMES, BODIES):
            columns[name] = values.ravel()
    names = [body.name for body in run.scene.bodies]
    index = pandas.MultiIndex.from_product([run.times, names], names=[TIMES, BODIES])
    table = pandas.DataFrame(columns, index=index)
    table.attrs["units"] = {
        column: _UNITS[column.removesuffix("_x").removesuffix("_y")] for column in columns
    }
    return table
