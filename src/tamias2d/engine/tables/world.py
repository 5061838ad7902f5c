"""All groups of arrays."""

from typing import NamedTuple

from tamias2d.engine.tables.bodies import Bodies, BodyState
from tamias2d.engine.tables.broad_phase import BroadPhase
from tamias2d.engine.tables.chunks import Chunks
from tamias2d.engine.tables.constraints import Constraints
from tamias2d.engine.tables.contact_log import ContactLog
from tamias2d.engine.tables.contacts import ContactBuffers, Touching
from tamias2d.engine.tables.control import Control
from tamias2d.engine.tables.direct import Direct
from tamias2d.engine.tables.events import Events
from tamias2d.engine.tables.islands import Islands
from tamias2d.engine.tables.joints import Joints
from tamias2d.engine.tables.shapes import Shapes
from tamias2d.engine.tables.springs import Springs
from tamias2d.engine.tables.tree import Tree


class World(NamedTuple):
    """All of it; only stages take the world, functions the groups that they read."""

    control: Control
    state: BodyState
    bodies: Bodies
    shapes: Shapes
    tree: Tree
    broad_phase: BroadPhase
    buffers: ContactBuffers
    touching: Touching
    constraints: Constraints
    islands: Islands
    direct: Direct
    springs: Springs
    events: Events
    log: ContactLog
    chunks: Chunks
    joints: Joints
