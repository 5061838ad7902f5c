"""Which engines there are to compile; no scene ever needs another.

Serves: `tamias2d warm`. Hides: nothing.
"""

from tamias2d.kernels import Engine

MENU: tuple[Engine, ...] = ()
