"""What built-in functions return is found once, and numba is left as it was."""

import numba
import pytest
from numba.core.types.functions import BaseFunction

from tamias2d.kernels.known_calls import known_calls


def _sums(x):
    total = x + x
    for _ in range(3):
        total = total + x
        total = total + x
    return total


def test_the_same_call_is_resolved_once(monkeypatch):
    asked = []
    resolve = BaseFunction.get_call_type

    def counted(function, context, args, kws):
        asked.append((function, tuple(args)))
        return resolve(function, context, args, kws)

    monkeypatch.setattr(BaseFunction, "get_call_type", counted)
    with known_calls():
        compiled = numba.njit("float64(float64)")(_sums)
    assert len(asked) == len(set(asked)) > 0
    assert compiled(1.5) == _sums(1.5)


def test_numba_is_left_as_it_was_when_something_fails():
    before = BaseFunction.get_call_type
    with pytest.raises(ZeroDivisionError), known_calls():
        raise ZeroDivisionError
    assert BaseFunction.get_call_type is before
