"""Which engines there are to compile; no scene ever needs another.

Serves: the world, and `tamias2d warm`. Hides: nothing.
"""

from tamias2d.kernels import Engine
from tamias2d.stepped.coast import coast, know_course
from tamias2d.stepped.ray_cast import cast
from tamias2d.stepped.region_query import gather, survey
from tamias2d.stepped.step import step

CONTACT = Engine("contact engine", (step, coast, know_course))
QUERY = Engine("queries", (survey, cast, gather))
MENU: tuple[Engine, ...] = (CONTACT, QUERY)
