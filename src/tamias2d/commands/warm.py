"""`tamias2d warm`: compile ahead what runs would otherwise wait for."""

import time

from tamias2d.commands.output import say
from tamias2d.engine.menu import MENU
from tamias2d.kernels.cache import folder


def warm_up() -> None:
    """Compile every engine on the menu, or find it compiled, and say how long that took."""
    for engine in MENU:
        start = time.perf_counter()
        engine.compiled()
        say(f"{engine.name}: ready after {time.perf_counter() - start:.1f} s")
    say(f"Compiled code is kept in {folder()}.")
