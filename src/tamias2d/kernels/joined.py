"""Functions joined to a source that stands alone, with marks for the compiler or without.

Serves: the makers of sources. Hides: which functions of a source are called from outside.
"""

from collections.abc import Sequence

HELPER = '@njit(error_model="numpy", no_cpython_wrapper=True, no_cfunc_wrapper=True)'
ENTRY = '@njit(cache=True, error_model="numpy", nogil=True, no_cfunc_wrapper=True)'


def joined(
    head: str, imports: Sequence[str], helpers: Sequence[str], entry: str
) -> tuple[str, str]:
    """Return a source of helpers and an entry for the compiler, and without its marks."""
    if imports:
        head += f"\nfrom math import {', '.join(sorted(set(imports)))}"
    marked = (f"{HELPER}\n{each}" for each in helpers)
    compiled = "\n\n\n".join([f"{head}\nfrom numba import njit", *marked, f"{ENTRY}\n{entry}"])
    return compiled + "\n", "\n\n\n".join([head, *helpers, entry]) + "\n"
