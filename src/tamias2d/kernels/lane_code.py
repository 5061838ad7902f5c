"""Intrinsics of `lanes`: the same in vectors of eight numbers, as the compiler is given it.

Hides: LLVM. A machine whose vectors are shorter takes several instructions for each.
"""

from collections.abc import Callable
from typing import Any

from llvmlite import ir
from numba import types
from numba.extending import intrinsic

from tamias2d.kernels.lanes import HALF, LANES, ROW, USED

_NUMBER, _PLACE = ir.DoubleType(), ir.IntType(64)
_EIGHT = ir.VectorType(_NUMBER, ROW)
_NUMBER_BYTES = 8
Generator = Callable[..., Any]


@intrinsic
def load_half(_: Any, places: Any, first: Any, rows: Any, lanes: Any, to: Any) -> Any:
    """See `lanes.load_half`."""
    return types.void(places, first, rows, lanes, to), _loading(HALF)


@intrinsic
def load_rows(_: Any, places: Any, first: Any, rows: Any, lanes: Any, to: Any) -> Any:
    """See `lanes.load_rows`."""
    return types.void(places, first, rows, lanes, to), _loading(ROW)


@intrinsic
def load_part(_: Any, places: Any, first: Any, rows: Any, column: Any, lanes: Any, to: Any) -> Any:
    """See `lanes.load_part`."""
    return types.void(places, first, rows, column, lanes, to), _load_part


@intrinsic
def store_half(_: Any, places: Any, first: Any, rows: Any, lanes: Any, to: Any) -> Any:
    """See `lanes.store_half`."""
    return types.void(places, first, rows, lanes, to), _store


@intrinsic
def both_above(_: Any, row: Any, a: Any, least_a: Any, b: Any, least_b: Any) -> Any:
    """See `lanes.both_above`."""
    return types.boolean(row, a, least_a, b, least_b), _compare


class _Code:
    """What is written for one call: arrays and numbers by their order in it."""

    def __init__(self, context: Any, builder: Any, signature: Any, values: Any) -> None:
        self.builder = builder
        self._context, self._types, self._values = context, signature.args, values

    def array(self, n: int) -> Any:
        return self._context.make_array(self._types[n])(
            self._context, self.builder, self._values[n]
        )

    def place(self, n: int) -> Any:
        return self._context.cast(self.builder, self._values[n], self._types[n], types.intp)

    def eight(self, n: int, first: Any, offset: int) -> Any:
        """Return the address of eight numbers of an array."""
        at = self.builder.add(first, _PLACE(offset))
        return self._as_vector(self.builder.gep(self.array(n).data, [at]), _EIGHT)

    def row(self, n: int, place: Any, width: int, column: Any = None) -> Any:
        """Return the address of numbers of a row: the first ones, or those from a column on."""
        rows = self.array(n)
        first = rows.data if column is None else self.builder.gep(rows.data, [column])
        bytes_before = self.builder.mul(place, self.builder.extract_value(rows.strides, 0))
        at = self.builder.add(self.builder.ptrtoint(first, _PLACE), bytes_before)
        return self.builder.inttoptr(at, ir.VectorType(_NUMBER, width).as_pointer())

    def places(self, n: int, first: Any, offset: int) -> list[Any]:
        """Return eight whole numbers of an array, without a sign."""
        start = self.builder.gep(self.array(n).data, [self.builder.add(first, _PLACE(offset))])
        each = [self.builder.gep(start, [_PLACE(m)]) for m in range(ROW)]
        return [self.builder.zext(self.builder.load(at), _PLACE) for at in each]

    def load(self, address: Any) -> Any:
        return self.builder.load(address, align=_NUMBER_BYTES)

    def store(self, vector: Any, address: Any) -> None:
        self.builder.store(vector, address, align=_NUMBER_BYTES)

    def chosen(self, a: Any, b: Any, numbers: list[int]) -> Any:
        """Return a vector of numbers of two, which are counted through both."""
        mask = ir.Constant(ir.VectorType(ir.IntType(32), len(numbers)), numbers)
        return self.builder.shuffle_vector(a, b, mask)

    def _as_vector(self, address: Any, vector: Any) -> Any:
        return self.builder.bitcast(address, vector.as_pointer())


def _loading(width: int) -> Generator:
    def load(context: Any, builder: Any, signature: Any, values: Any) -> Any:
        code = _Code(context, builder, signature, values)
        first, to = code.place(1), code.place(4)
        for m in range(0, LANES, ROW):
            places = code.places(0, first, m)
            vectors = [code.load(code.row(2, place, width)) for place in places]
            columns = _columns(code, vectors, width)
            for n, column in enumerate(columns[k] for k in range(width) if k % HALF < USED):
                code.store(column, code.eight(3, to, LANES * n + m))
        return context.get_dummy_value()

    return load


def _load_part(context: Any, builder: Any, signature: Any, values: Any) -> Any:
    code = _Code(context, builder, signature, values)
    first, column, to = code.place(1), code.place(3), code.place(5)
    for m in range(0, LANES, ROW):
        places = code.places(0, first, m)
        vectors = [code.load(code.row(2, place, ROW, column)) for place in places]
        for n, loaded in enumerate(_columns(code, vectors, ROW)):
            code.store(loaded, code.eight(4, to, LANES * n + m))
    return context.get_dummy_value()


def _store(context: Any, builder: Any, signature: Any, values: Any) -> Any:
    code = _Code(context, builder, signature, values)
    first, to = code.place(1), code.place(4)
    for m in range(0, LANES, ROW):
        columns = [code.load(code.eight(3, to, LANES * n + m)) for n in range(USED)]
        rows = _rows(code, [*columns, ir.Constant(_EIGHT, [0.0] * ROW)])
        for place, row in zip(code.places(0, first, m), rows, strict=True):
            code.store(row, code.row(2, place, HALF))
    return context.get_dummy_value()


def _compare(context: Any, builder: Any, signature: Any, values: Any) -> Any:
    code = _Code(context, builder, signature, values)
    found = None
    for m in range(0, LANES, ROW):
        a = _above(code, code.load(code.eight(0, code.place(1), m)), values[2])
        b = _above(code, code.load(code.eight(0, code.place(3), m)), values[4])
        both = builder.and_(a, b)
        found = both if found is None else builder.or_(found, both)
    bits = builder.bitcast(found, ir.IntType(ROW))
    return builder.icmp_unsigned("!=", bits, ir.IntType(ROW)(0))


def _above(code: _Code, vector: Any, least: Any) -> Any:
    one = code.builder.insert_element(ir.Constant(_EIGHT, ir.Undefined), least, ir.IntType(32)(0))
    return code.builder.fcmp_ordered(">", vector, code.chosen(one, one, [0] * ROW))


def _columns(code: _Code, rows: list[Any], width: int) -> list[Any]:
    """Return the columns of eight rows.

    Numbers change places between rows that are one apart, then two; then halves are put together.
    """
    pairs = _exchanged(code, rows, 1, width)
    quads = _exchanged(code, pairs, 2, width)
    if width == ROW:
        return _exchanged(code, quads, 4, width)
    return [code.chosen(quads[n], quads[n + HALF], list(range(ROW))) for n in range(HALF)]


def _rows(code: _Code, columns: list[Any]) -> list[Any]:
    """Return the eight rows of four columns."""
    halves = []
    for start in (0, HALF):
        numbers = list(range(start, start + HALF))
        parts = [code.chosen(column, column, numbers) for column in columns]
        halves += _exchanged(code, _exchanged(code, parts, 1, HALF), 2, HALF)
    return halves


def _exchanged(code: _Code, vectors: list[Any], apart: int, width: int) -> list[Any]:
    """Return vectors of which those some places apart have exchanged every other group of numbers.

    With groups of 1, 2 and 4, each for vectors as far apart, a square of vectors is transposed.
    """
    low = [n if n & apart == 0 else width + n - apart for n in range(width)]
    high = [n + apart if n & apart == 0 else width + n for n in range(width)]
    result = list(vectors)
    for k in range(len(vectors)):
        if k & apart == 0:
            a, b = vectors[k], vectors[k + apart]
            result[k], result[k + apart] = code.chosen(a, b, low), code.chosen(a, b, high)
    return result
