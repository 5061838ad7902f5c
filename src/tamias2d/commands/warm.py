"""`tamias2d warm`: compile ahead, so that no run has to wait for a compiler."""

import time

from tamias2d.commands.output import say
from tamias2d.engine.menu import MENU as ENGINE
from tamias2d.event_driven import LIBRARY
from tamias2d.kernels.kept_files import folder

MENU = (*ENGINE, LIBRARY)
"""All that scenes share; what is made for one scene is compiled with it."""


def warm_up() -> None:
    """Compile every library on the menu, or find it compiled, and say how long that took."""
    for library in MENU:
        start = time.perf_counter()
        library.compiled()
        say(f"{library.name}: ready after {time.perf_counter() - start:.1f} s")
    say(f"Compiled code is kept in {folder()}.")
