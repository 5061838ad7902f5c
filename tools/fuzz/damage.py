"""Files in which bytes were changed: refused by name, or what was written."""

import contextlib
import os
import random
import tempfile
from collections.abc import Iterator
from functools import cache
from importlib import import_module
from pathlib import Path
from types import ModuleType

import tamias2d as t2
from tamias2d.scene import Shape


def saved(seed: int) -> str:
    """Restore a damaged file of a saved simulator; return what came of it."""
    content, digest = _saved_simulator()
    with _file(damaged(content, random.Random(seed)), "game.npz") as path:
        try:
            sim = t2.Simulator.restore(path)
        except t2.RecordingError:
            return "refused"
    assert sim.digest() == digest, "another simulator was restored"
    sim.step(2)
    return "done"


def cached(seed: int) -> str:
    """Use a damaged file of compiled code; return what came of it."""
    tests = import_module("tests.kernels.test_damaged_cache")
    path, whole = _compiled_code(tests)
    return "refused" if tests.check(seed, path, whole) else "done"


def damaged(content: bytes, chance: random.Random) -> bytes:
    """Return the content with bits flipped, bytes set or moved, or a stretch cut or cleared."""
    found = bytearray(content)
    for _ in range(chance.choice((1, 1, 1, 2, 5))):
        start = chance.randrange(len(found))
        end = min(start + chance.choice((1, 1, 4, 100, len(found))), len(found))
        match chance.randrange(6):
            case 0:
                found[start] ^= 1 << chance.randrange(8)
            case 1:
                found[start] = chance.choice((0, 1, 127, 128, 255))
            case 2:
                found[start:end] = bytes(end - start)
            case 3:
                found[start:end] = found[start:end] * 2
            case 4 if end - start < len(found):
                del found[start:end]
            case _:
                place = chance.randrange(len(found))
                found[place : place + end - start] = found[start:end][: len(found) - place]
    return bytes(found)


@contextlib.contextmanager
def _file(content: bytes, name: str) -> Iterator[Path]:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / name
        path.write_bytes(content)
        yield path


@cache
def _saved_simulator() -> tuple[bytes, str]:
    """Return the bytes of a file, and the digest of the simulator in it."""
    scene = t2.Scene(gravity=(0.0, -9.81))
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), restitution=0.2, friction=0.4)
    shapes: tuple[Shape, ...] = (t2.Disc(radius=0.4), t2.Box(width=0.8, height=0.5)) * 3
    for k, shape in enumerate(shapes):
        place = (0.3 * k, 0.5 + k)
        scene.add_body(shape, mass=1.0, position=place, restitution=0.1, friction=0.5)
    sim = t2.Simulator(scene)
    sim.step(10)
    with _file(b"", "game.npz") as path:
        sim.save(path)
        return path.read_bytes(), sim.digest()


@cache
def _compiled_code(tests: ModuleType) -> tuple[Path, bytes]:
    """Return the file of a compiled function, and what is in it."""
    os.environ["TAMIAS2D_HOME"] = tempfile.mkdtemp(prefix="tamias2d-fuzz-")
    tests.answer()
    (path,) = (Path(os.environ["TAMIAS2D_HOME"]) / "kernels").iterdir()
    return path, path.read_bytes()
