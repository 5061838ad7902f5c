"""What a built-in function returns for some types is found once in a compilation, not at each call.

By itself numba tries all implementations of an operator anew for each place where it stands: a
seventh of the time to compile. This uses internals of numba, so its version is bounded.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from numba.core.types.functions import BaseFunction


@contextmanager
def known_calls() -> Iterator[None]:
    """Keep what calls of built-in functions return until all is compiled."""
    found: dict[tuple[Any, tuple[Any, ...]], Any] = {}
    numbas: Any = BaseFunction  # numba states no types
    resolve = numbas.get_call_type

    def known(function: BaseFunction, context: Any, args: Any, kws: Any) -> Any:
        if kws:
            return resolve(function, context, args, kws)
        call = function, tuple(args)
        if call not in found:
            found[call] = resolve(function, context, args, kws)
        return found[call]

    numbas.get_call_type = known
    try:
        yield
    finally:
        numbas.get_call_type = resolve
