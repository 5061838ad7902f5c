"""Crowds of fast bodies beside Pymunk and Box2D v3 (pyb2d3): do they go where their velocities say?

All engines take steps of 1/60 s of the same crowd, one after the other in turns, in one process on
one thread. The share that hangs is that of moving body-steps (faster than 0.3 m/s before and after,
in the same direction) which end less than a fifth of speed times step from where they began. A body
that goes to and fro in the parts of a step is among them: asked for ways, the steps of this library
in which bodies hang are taken again, and the way of each is added up part by part. The centre of
mass of a crowd that nothing outside pushes is compared with momentum/mass times time, as a share of
the mean way of its bodies. The scenes without joints of Box2D's own benchmark are among the crowds.
Stop it by Ctrl-C, and it tells what it has found so far.
"""

from argparse import ArgumentParser
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from tamias2d.scene import Scene
from tamias2d.study.engines.box2d import Box2D
from tamias2d.study.engines.chipmunk import Chipmunk
from tamias2d.study.engines.engine import Maker
from tamias2d.study.engines.own import Own
from tools.measurements.arena import box2d_scenes, crowd_scenes
from tools.measurements.arena.followed import Followed
from tools.measurements.arena.race import TIME_STEP
from tools.measurements.arena.ways import ways
from tools.measurements.columns import Columns
from tools.measurements.progress import each, until_stopped

_ENGINES: tuple[Maker, ...] = (Own, Chipmunk, Box2D)
_BODIES = 500  # in each crowd that is not Box2D's

CROWDS: dict[str, tuple[Callable[[int], Scene], int]] = {
    **{name: (make, _BODIES) for name, make in crowd_scenes.SCENES.items()},
    **box2d_scenes.FULL,
}
"""Makers of crowds by name, and how many bodies they get if nothing else is asked."""


def options(parser: ArgumentParser) -> None:
    """Add what can be chosen."""
    parser.add_argument(
        "--crowds", nargs="+", choices=CROWDS, metavar="CROWD",
        help=f"these alone, of {', '.join(CROWDS)}",
    )  # fmt: skip
    parser.add_argument(
        "--bodies", type=int, help=f"in each crowd ({_BODIES}, and what Box2D takes in its scenes)"
    )
    parser.add_argument("--steps", type=int, default=120, help="of each engine (120)")
    parser.add_argument(
        "--by-way", action="store_true",
        help="also tell which share hangs by its way through the parts of a step (slow)",
    )  # fmt: skip


def measure(
    crowds: list[str] | None = None,
    bodies: int | None = None,
    steps: int = 120,
    by_way: bool = False,
) -> dict[str, Any]:
    """Return a row for each crowd and engine."""
    rows: list[dict[str, Any]] = []
    with until_stopped():
        for name in each(crowds or list(CROWDS), "Crowds"):
            make, full = CROWDS[name]
            scene, drive = make(bodies or full), crowd_scenes.DRIVES.get(name)
            rows += _crowd(name, scene, steps, drive, by_way=by_way)
    return {"bodies": bodies, "steps": steps, "rows": rows}


COLUMNS: Columns = {
    "crowd": "{crowd}",
    "bodies": "{bodies}",
    "engine": "{engine}",
    "ms a step": lambda row: f"{1e3 * row['seconds']:.2f}",
    "worst/median": lambda row: f"{row['worst'] / row['seconds']:.0f}",
    "hang": "{hang:.2%}",
    "by way": lambda row: "" if row.get("by_way") is None else f"{row['by_way']:.3%}",
    "centre": lambda row: "" if row["centre"] is None else f"{row['centre']:.0e}",
    "overlap": "{overlap:.0%}",
    "gain": lambda row: "" if row["gain"] is None else f"{row['gain']:.0e}",
}


def notes(_: dict[str, Any]) -> list[str]:
    """Return what the columns mean."""
    return [
        "overlap: the deepest at the end, of the largest circle in the smaller body; "
        "gain: the most that energy rises in a step, of that at the start, if nothing drives it"
    ]


_Drive = Callable[[float], tuple[float, float]] | None


def _crowd(
    name: str, scene: Scene, steps: int, drive: _Drive, *, by_way: bool
) -> list[dict[str, Any]]:
    followed = [Followed(make, scene) for make in _ENGINES]
    for k in range(steps):
        for one in followed:
            if drive is not None:
                one.engine.drive(0, drive((k + 0.5) * TIME_STEP))
            one.step()
    moving = sum(body.dynamic for body in scene.bodies)
    rows = [{"crowd": name, "bodies": moving} | one.row() for one in followed]
    if by_way:
        rows[0]["by_way"] = followed[0].share(_hanging_by_way(scene, drive, followed[0]))
    return rows


def _hanging_by_way(scene: Scene, drive: _Drive, followed: Followed) -> int:
    """Return how many body-steps of this library hang by their ways through parts, too."""
    again, taken, count = Own(scene, TIME_STEP), 0, 0
    with TemporaryDirectory() as folder:
        saved = Path(folder) / "step.npz"
        for step, bodies, least in followed.hanging:
            for k in range(taken, step + 1):
                if drive is not None:
                    again.drive(0, drive((k + 0.5) * TIME_STEP))
                if k == step:
                    again.simulator.save(saved)
                again.step()
            taken = step + 1
            count += int((ways(saved)[bodies] < least).sum())
    return count
