from collections.abc import Callable, Iterator

import pytest

from tamias2d.kernels import choice


@pytest.fixture
def at_price(monkeypatch: pytest.MonkeyPatch) -> Iterator[Callable[[float], None]]:
    """Let kernels be compiled at once, or never."""

    def set_price(price: float) -> None:
        choice.kernel.cache_clear()
        monkeypatch.setattr(choice, "_LOAD", price)
        monkeypatch.setattr(choice.Kernel, "_price", lambda _: price)

    yield set_price
    choice.kernel.cache_clear()
