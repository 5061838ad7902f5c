"""Words typed by a user, turned into scenes, methods and times."""

import difflib
import math
import os
from pathlib import Path

from tamias2d import motion
from tamias2d.commands.output import command
from tamias2d.errors import InputError
from tamias2d.method_names import METHOD_NAMES
from tamias2d.scene import Scene, catalogue, load


def find_scene(text: str) -> Scene:
    """The scene of the catalogue with this name, or the one in the file at this path.

    Raises InputError if there is neither, SceneError if the file is at fault.
    """
    names = catalogue.names()
    if text in names:
        return catalogue.load(text)
    if os.path.exists(text) or Path(text).suffix in (".yaml", ".yml"):
        return load(Path(text))
    near = difflib.get_close_matches(text, names, n=3)
    hint = f"Did you mean {' or '.join(near)}? " if near else ""
    raise InputError(
        f"SCENE: {text!r}: must be a name of the catalogue or a file (R1). "
        f"{hint}`{command()} scenes` lists the names."
    )


def find_method(name: str) -> motion.Method:
    """The method with a name such as 'runge-kutta-4', which is the class RungeKutta4."""
    kind: type[motion.Method] = getattr(motion, METHOD_NAMES[name])
    return kind()


def seconds(text: str | None, *, option: str, symbol: str) -> float | None:
    """A time in seconds from '4 s', '250 ms' or '4'; None stays None.

    Raises InputError if it is no time, or outside the range of `symbol` (R4).
    """
    from tamias2d.generated.symbols import SYMBOLS
    from tamias2d.spec.messages import SpecFault
    from tamias2d.spec.units import parse_quantity, parse_unit

    if text is None:
        return None
    rule = f"must be a time such as 4, '4 s' or '250 ms' (symbol {symbol})"
    try:
        value = float(text)
    except ValueError:
        try:
            quantity = parse_quantity(text)
        except SpecFault as fault:
            raise InputError(f"{option}: {text!r}: {rule}. Write it so.") from fault
        if quantity.dimension != parse_unit("s").dimension:
            raise InputError(f"{option}: {text!r}: {rule}. Use a unit of time.") from None
        value = quantity.value
    if not math.isfinite(value):
        raise InputError(f"{option}: {text!r}: must be finite (symbol {symbol}). Give such a time.")
    if not SYMBOLS[symbol].admits(value):
        raise InputError(f"{option}: {text!r}: {SYMBOLS[symbol].rule}. Give such a time.")
    return value


def step_for(method: motion.Method | None, text: str | None) -> float | None:
    """The time step that was typed; InputError if the method needs one, or takes none."""
    step = seconds(text, option="--time-step", symbol="time_step")
    if step is None and method is not None and method.fixed_step:
        raise InputError(
            f"--time-step: found none: {method} needs one (R5). "
            "Give it, for example --time-step 0.01."
        )
    if step is not None and (method is None or not method.fixed_step):
        chosen = "without --method the run" if method is None else str(method)
        raise InputError(
            f"--time-step: {text!r}: {chosen} chooses its own steps and takes no time step (R5). "
            "Leave it out, or choose a stepped --method."
        )
    return step


def share(text: str | None, *, option: str) -> float | None:
    """A relative error from '1e-6' or '0.1'; None stays None; InputError if it is no number."""
    if text is None:
        return None
    try:
        return float(text)
    except ValueError:
        raise InputError(
            f"{option}: {text!r}: must be a number such as 1e-6 (R5). Write it so."
        ) from None


def span_of(scene: Scene, name: str, text: str | None) -> float:
    """The duration in s that was typed, or else the scene's own; InputError if there is none."""
    duration = seconds(text, option="--duration", symbol="duration")
    if duration is None:
        duration = scene.duration
    if duration is None:
        raise InputError(
            f"--duration: found none: must be stated here or in the scene '{name}' (R2). "
            "Give it, for example --duration '4 s'."
        )
    return duration
