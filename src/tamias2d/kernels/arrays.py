"""Types of a kernel's arguments, for readers, for the type checker and for the compiler.

Serves: the entry functions of kernels. Hides: what the compiler calls them. All arrays are
contiguous, with the last axis fastest.
"""

import typing
from collections.abc import Callable
from typing import Annotated, Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from tamias2d.kernels.groups import array_type, is_group

Floats: TypeAlias = Annotated[NDArray[np.float64], "float64[::1]"]
FloatRows: TypeAlias = Annotated[NDArray[np.float64], "float64[:, ::1]"]
FloatBlocks: TypeAlias = Annotated[NDArray[np.float64], "float64[:, :, ::1]"]
Bytes: TypeAlias = Annotated[NDArray[np.int8], "int8[::1]"]
Indices: TypeAlias = Annotated[NDArray[np.int32], "int32[::1]"]
IndexRows: TypeAlias = Annotated[NDArray[np.int32], "int32[:, ::1]"]
IndexBlocks: TypeAlias = Annotated[NDArray[np.int32], "int32[:, :, ::1]"]
Places: TypeAlias = Annotated[NDArray[np.uint32], "uint32[::1]"]
PlaceRows: TypeAlias = Annotated[NDArray[np.uint32], "uint32[:, ::1]"]
PlaceBlocks: TypeAlias = Annotated[NDArray[np.uint32], "uint32[:, :, ::1]"]
Ranks: TypeAlias = Annotated[NDArray[np.int64], "int64[::1]"]
RankRows: TypeAlias = Annotated[NDArray[np.int64], "int64[:, ::1]"]

_SCALARS = {float: "float64", int: "int64", bool: "boolean"}


def signature(function: Callable[..., Any], *, for_each: bool = False) -> str:
    """Return what the compiler calls the types of a function's arguments, in brackets.

    A group that comes first is a table of addresses; of what is called for each of many, it is
    their tables, and an array for the results. Raises TypeError, which names the argument, for a
    type that is none of this module.
    """
    found = []
    for place, (name, hint) in enumerate(_hints(function).items()):
        named = _SCALARS.get(hint) or array_type(hint)
        if place == 0 and is_group(hint):
            named = "int64[:, :, ::1], int64[::1]" if for_each else "int64[:, ::1]"
        if named is None:
            raise TypeError(
                f"{function.__module__}.{function.__name__}: argument '{name}': an entry of a "
                f"kernel takes float, int, bool or the arrays of {__name__}, and a group of these "
                "first. Give it one of them."
            )
        found.append(named)
    return f"({', '.join(found)},)" if len(found) == 1 else f"({', '.join(found)})"


def _hints(function: Callable[..., Any]) -> dict[str, Any]:
    hints = typing.get_type_hints(function, include_extras=True)
    hints.pop("return", None)
    return hints
