"""Groups of arrays: named tuples whose fields are arrays or groups, and how they reach a kernel.

Compiled code takes a group apart at no cost, but a tuple of many arrays is expensive to hand over
from Python. So a kernel gets one table of addresses, and makes the group from it. Cost: 0.16 us
for a call, where 46 arrays take 0.9 us.
"""

import inspect
import typing
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

MOST_AXES = 3
_NO_AXES = (0,) * MOST_AXES
_Row = tuple[int, ...]  # of the table: the address, then the length along each axis


def is_group(hint: Any) -> bool:
    """Return whether a type is a named tuple."""
    return isinstance(hint, type) and issubclass(hint, tuple) and hasattr(hint, "_fields")


def fields_of(group: type) -> dict[str, Any]:
    """Return the types of a group's fields by name, marks included."""
    return typing.get_type_hints(group, include_extras=True)


def array_type(hint: Any) -> str | None:
    """Return what the compiler calls an array type of `tamias2d.kernels.arrays`, or None."""
    marks = getattr(hint, "__metadata__", ())
    return next((mark for mark in marks if isinstance(mark, str)), None)


def leaves(group: Any) -> Iterator[NDArray[Any]]:
    """Yield the arrays of a group in the order of their declaration."""
    for value in group:
        if isinstance(value, tuple):
            yield from leaves(value)
        else:
            yield value


def addresses(group: Any) -> NDArray[np.int64]:
    """Return the table (k, 4) by which a kernel finds the arrays of a group.

    It holds while none of the arrays is freed or replaced. Raises TypeError for an array that is
    not contiguous.
    """
    return Addresses().of(group)


def table_shape(group: Any) -> tuple[int, int]:
    """Return the shape of the table of addresses of a group."""
    return sum(1 for _ in leaves(group)), 1 + MOST_AXES


class Addresses:
    """Tables of addresses, made again and again while some of the arrays are replaced."""

    def __init__(self) -> None:
        self._known: dict[int, tuple[NDArray[Any], _Row]] = {}
        """By the identity of arrays, which holds while they are kept here."""

    def of(self, group: Any) -> NDArray[np.int64]:
        """Return what `addresses` does."""
        known, self._known = self._known, {}
        for array in leaves(group):
            place = id(array)
            self._known[place] = known.get(place) or (array, _row(array, group))
        return np.array([row for _, row in self._known.values()], dtype=np.int64)


def _row(array: NDArray[Any], group: Any) -> _Row:
    if not array.flags.c_contiguous:
        raise TypeError(f"an array of {type(group).__name__} is not contiguous")
    lengths = (*array.shape, *_NO_AXES)[:MOST_AXES]
    return (array.__array_interface__["data"][0], *lengths)


def text_of_classes(group: type) -> Iterator[tuple[type, str]]:
    """Yield the classes of a group and of the groups in it, inner ones first, with their text."""
    for hint in fields_of(group).values():
        if is_group(hint):
            yield from text_of_classes(hint)
    names = " ".join(fields_of(group))
    yield group, f'{group.__name__} = namedtuple("{group.__name__}", "{names}")'


def lines_of_entry(group: type, used: Sequence[tuple[str, ...]]) -> Iterator[str]:
    """Yield the lines by which an entry finds the fields that it uses of a group.

    The paths begin with the name of a parameter.
    """
    rows = {path: k for k, path in enumerate(paths_of(group))}
    for path in used:
        view = _view_of(_type_at(group, path[1:]))
        yield f"{'_'.join(path)} = {view}(addresses, {rows[path[1:]]})"


def paths_of(group: type) -> Iterator[tuple[str, ...]]:
    """Yield the paths to the arrays of a group in the order of their declaration."""
    for name, hint in fields_of(group).items():
        if is_group(hint):
            yield from ((name, *path) for path in paths_of(hint))
        else:
            yield (name,)


def text_of_views(*groups: type) -> str:
    """Return the code that makes arrays from addresses, for all array types of some groups."""
    types = sorted({name for group in groups for name in _types(group)})
    lines = [f"{_view_of(name)} = array_at(types.{name})" for name in types]
    return inspect.getsource(array_at) + "\n\n" + "\n".join(lines)


def array_at(array: Any) -> Any:
    """Return a function for compiled code that makes an array of a type from a row of addresses."""
    from numba.core import types
    from numba.extending import intrinsic
    from numba.np import arrayobj

    numba: Any = arrayobj

    @intrinsic
    def view(_typing: Any, table: Any, row: Any) -> Any:
        """Make an array (numba: type of the call, and what prints its code) from a row."""

        def codegen(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
            """Print the code that reads address and lengths, and strides as of a whole array."""
            found = numba.make_array(signature.args[0])(context, builder, arguments[0])
            width, index = context.get_constant(types.intp, 4), arguments[1]

            def field(k: int) -> Any:
                start = builder.mul(index, width)
                place = builder.add(start, context.get_constant(types.intp, k))
                return builder.load(builder.gep(found.data, [place]))

            size = context.get_constant(types.intp, array.dtype.bitwidth // 8)
            shape = [field(1 + axis) for axis in range(array.ndim)]
            strides = [size]
            for length in reversed(shape[1:]):
                strides.insert(0, builder.mul(strides[0], length))
            pointer = context.get_data_type(array.dtype).as_pointer()
            made = numba.make_array(array)(context, builder)
            data = builder.inttoptr(field(0), pointer)
            numba.populate_array(
                made, data=data, shape=shape, strides=strides, itemsize=size, meminfo=None
            )
            return made._getvalue()

        return array(table, row), codegen

    return view


def _types(group: type) -> Iterator[str]:
    for name, hint in fields_of(group).items():
        if is_group(hint):
            yield from _types(hint)
        elif (found := array_type(hint)) is not None:
            yield found
        else:
            raise TypeError(
                f"{group.__module__}.{group.__name__}.{name}: a field of a group is an array of "
                "tamias2d.kernels.arrays, or a group. Give it one of these types."
            )


def _view_of(array: str) -> str:
    kind, _, axes = array.partition("[")
    return f"{kind}_{axes.count(':') - 1}d"


def _type_at(group: type, path: tuple[str, ...]) -> str:
    hint: Any = group
    for name in path:
        hint = fields_of(hint)[name]
    return array_type(hint) or ""
