"""Ballistic motion, in chunks of bodies."""

from typing import Annotated, NamedTuple

from tamias2d.engine.tables.declarations import Columns, Rewritten, Sized
from tamias2d.kernels.arrays import FloatRows, RankRows

CHUNK = 16  # bodies whose coordinates are a row
CHUNK_LANES = 3 * CHUNK  # x, y and angle of a body, and of the next

_course = Columns(CHUNK_LANES)  # of a chunk
L_LOW = _course()  # where it may be
L_HIGH = _course()
L_AT = _course()  # where it was as the call began, or where a mixed one is
L_SPEED = _course()  # how it moved or moves
UNIFORM = _course(1)  # 1 if its bodies are alike
PLAIN = _course(1)  # 1 if it is plain now

_stream = Columns(CHUNK_LANES)  # of each mixed chunk; the last row is that of all plain ones
L_BY = _stream()  # acceleration of its lanes
L_DECAY = _stream()  # propagator of its lanes
L_GAIN = _stream()
L_LIFT = _stream()
L_BEFORE = _stream()  # the frame before a step
L_AFTER = _stream()  # the frame after it

_asleep = Columns(CHUNK_LANES)  # of each chunk; the last row begins with gravity
POSES_ASLEEP = _asleep()
VELOCITIES_ASLEEP = _asleep()
LOADS_ASLEEP = _asleep()


class Chunks(NamedTuple):
    """What users see, a row for each chunk; read by ballistic motion, and where all sleep."""

    poses: FloatRows  # views of what users see
    velocities: FloatRows
    loads: FloatRows
    load_bits: RankRows
    course: Annotated[FloatRows, Sized("chunks", 200), Rewritten()]  # whole cache lines
    stream: Annotated[FloatRows, Sized("streams", _stream.width), Rewritten()]
    asleep: Annotated[FloatRows, Sized("streams", _asleep.width), Rewritten()]  # as all fell asleep
