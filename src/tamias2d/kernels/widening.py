"""Whole numbers and truth values that are arguments have one type each, as they have in Python.

By itself numba compiles a function anew for each width of whole numbers, and for each constant that
is passed: a third more functions than there are. Columns of lanes stay constants: without them,
compiled code takes lanes one by one.
"""

from typing import Any

from numba import types

from tamias2d.kernels.lanes import LANES

_unliteral: Any = types.unliteral  # numba states no types


def compile_once(dispatcher: Any) -> None:
    """Let a function that others call be compiled for the widest types of its numbers."""
    folded = dispatcher._compiler.fold_argument_types

    def widened(args: Any, kws: Any) -> tuple[Any, tuple[Any, ...]]:
        signature, given = folded(args, kws)
        return signature, tuple(map(_widest, given))

    dispatcher._compiler.fold_argument_types = widened


def _widest(given: Any) -> Any:
    """Return the type that an argument is taken for."""
    if isinstance(given, types.IntegerLiteral) and given.literal_value >= LANES:
        return given
    kind = _unliteral(given)
    whole = isinstance(kind, types.Integer)
    widest: Any = types.intp
    return widest if whole and (kind.signed or kind.bitwidth < widest.bitwidth) else kind
