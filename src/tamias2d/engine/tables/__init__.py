"""The state of the engine: groups of arrays, and what each column of them holds.

Allocation, growth, saving and the entries of compiled code follow from these declarations. Each
column has a line with its name, unit and meaning; a new one is a new line. The groups by slot hold
bodies in canonical order, so that bodies that are near in the world are near in memory; the last
slot is an idle body, all zeros, for lanes of a block that have no contact. The engine imports the
groups by their names, and this package as `tb` for all else: `pose[slot, tb.ANGLE]`.
"""

from tamias2d.engine.tables.bodies import *
from tamias2d.engine.tables.broad_phase import *
from tamias2d.engine.tables.chunks import *
from tamias2d.engine.tables.constraints import *
from tamias2d.engine.tables.contact_log import *
from tamias2d.engine.tables.contacts import *
from tamias2d.engine.tables.control import *
from tamias2d.engine.tables.declarations import *
from tamias2d.engine.tables.direct import *
from tamias2d.engine.tables.events import *
from tamias2d.engine.tables.hinges import *
from tamias2d.engine.tables.islands import *
from tamias2d.engine.tables.joints import *
from tamias2d.engine.tables.shapes import *
from tamias2d.engine.tables.springs import *
from tamias2d.engine.tables.tree import *
from tamias2d.engine.tables.tree_lanes import *
from tamias2d.engine.tables.world import *
