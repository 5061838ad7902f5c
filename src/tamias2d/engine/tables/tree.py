"""The bounding volume hierarchy of the broad phase."""

from typing import Annotated, NamedTuple

from tamias2d.engine.tables.declarations import Columns, Saved, Sized
from tamias2d.kernels.arrays import FloatRows, PlaceRows, Places, RankRows, Ranks

_tree = Columns()
LEAVES = _tree()  # bounded shapes, the leaves of the tree
PLANES = _tree()  # half-planes, which follow the leaves in `morton`; queries only

_boxes = Columns(4)  # low x, low y, high x, high y, m
LEAF_BOX = _boxes()  # of the k-th leaf
FAT = _boxes()  # of shape k

_centres = Columns()  # m, of a leaf, from which circles are compared
CENTRE_X = _centres()  # middle of the fat bounds of its body
CENTRE_Y = _centres()
HALF_WIDTH = _centres()  # how far the body may be from there
HALF_HEIGHT = _centres()
CENTRE_RADIUS = _centres()  # of the shape

LEAF, KEY = range(2)  # rows of morton and of sorting: the shape of each leaf, its Morton code


class Tree(NamedTuple):
    """A bounding volume hierarchy over shapes; read by the broad phase and by queries."""

    counts: Annotated[Ranks, Sized(_tree.width)]
    boxes: Annotated[FloatRows, Sized("shapes", _boxes.width), Saved(numbers="infinite")]
    # boxes, m; node k holds 2k and 2k + 1
    nodes: Annotated[FloatRows, Sized("nodes", 4), Saved(numbers="infinite")]
    # category, mask and group that the shapes under a node have in common
    filters: Annotated[RankRows, Sized("nodes", 3)]
    centres: Annotated[FloatRows, Sized("shapes", 8), Saved(numbers="infinite")]
    morton: Annotated[PlaceRows, Sized(2, "shapes")]  # in Morton order
    leaf_of_shape: Annotated[Places, Sized("shapes"), Saved("shapes")]
    sorting: Annotated[PlaceRows, Sized(2, "shapes")]  # between passes of the radix sort
    bins: Annotated[Places, Sized(256)]  # of the radix sort
