"""Files of compiled code in which bytes were changed are compiled again: the answer is the same.

A thousand seeds were tried; some are tried each time.
"""

import random
from pathlib import Path

import pytest

from tests.kernels.test_cache import RIGHT, answer
from tools.fuzz.damage import damaged


def check(seed: int, file: Path, whole: bytes) -> bool:
    """Whether damaged code was compiled again; else nothing was changed in it."""
    content = damaged(whole, random.Random(seed))
    file.write_bytes(content)
    assert answer() == (RIGHT, content == whole)
    assert answer() == (RIGHT, True)  # and kept
    return content != whole


def test_damaged_code_is_never_run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("TAMIAS2D_HOME", str(tmp_path))
    answer()
    (file,) = (tmp_path / "kernels").iterdir()
    whole = file.read_bytes()
    again = [check(seed, file, whole) for seed in range(15)]
    assert sum(again) > 10
