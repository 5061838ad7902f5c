"""Hinges: of the members of trees, and the links of nets."""

from tamias2d.engine.tables.declarations import Columns

hinge_columns = Columns()  # of a member that hangs on a hinge, or is the root of a tree
H_ANCHOR = hinge_columns(2)  # m, in its own axes
H_FAR_ANCHOR = hinge_columns(2)  # m, in the axes of the body above
H_SIDE = hinge_columns()  # 1 if it is body B of the joint, -1 if it is A
H_ARM = hinge_columns(2)  # m, to the hinge
H_FAR_ARM = hinge_columns(2)  # m, to the hinge from the body above
H_GAP = hinge_columns(2)  # m, by which the hinge is apart as a substep begins
H_AIM = hinge_columns(2)  # m, to which the substep brings it
H_ERROR = hinge_columns(2)  # m/s, rate that it has too much
H_NODE_MASS = hinge_columns(3)  # kg, of the node: by x along x, by y along x, by y along y
H_NODE_MOMENT = hinge_columns(2)  # kg m
H_NODE_INERTIA = hinge_columns()  # kg m^2
H_MOMENT = hinge_columns(2)  # kg m, of the node about its hinge
H_INERTIA = hinge_columns()  # kg m^2, likewise
H_MASS = hinge_columns(3)  # kg, of what hangs on the hinge
H_LEVER = hinge_columns(2)  # 1/m
H_YIELD = hinge_columns()  # 1/(kg m^2), of turning; 0 if the body does not turn
H_FIRM = hinge_columns()  # kg m^2, of laws that govern its angle
H_SHARE = hinge_columns()  # of the turning of the body above that these pass on
H_LAW = hinge_columns()  # N m s, that these ask for
H_BIAS = hinge_columns(3)  # N s, N s, N m s
H_OFFSET = hinge_columns(
    2
)  # m, to which a substep leads it, less the way of the rate at which it parts
H_CHANGE = hinge_columns(3)  # m/s, m/s, rad/s
H_IMPULSE = hinge_columns(2)  # N s, through the hinge by the last solution
H_GIVEN = hinge_columns(2)  # N s, through the hinge since rows were written
H_PULL = hinge_columns(2)  # N s, through the hinge over this part, before that
H_TURN = hinge_columns()  # N m s, likewise, about the body
H_FAR_TURN = hinge_columns()  # N m s, likewise, about the body above
H_APART = hinge_columns(2)  # m, by how much the hinge was apart at most in this part
H_SLIGHT = hinge_columns()  # rad^2, of a root: how much turning is not looked at again in its tree

link_columns = Columns(2)  # of a hinge in a net
# what each substep reads and writes stands first, line by line of the cache
L_ARM_A = link_columns()  # m
L_ARM_B = link_columns()  # m
L_GAP = link_columns()  # m, by which it is apart as a substep begins
L_GIVEN = link_columns()  # N s, since rows were written
L_IMPULSE = link_columns()  # N s
L_WARM = link_columns()  # N s, in the last substep
L_ERROR = link_columns()  # m/s, rate that it has too much
L_RATE = link_columns()  # m/s, by which links that come later change it
L_PULL = link_columns()  # N s, over this part, before rows were written
L_TURN_A = link_columns(1)  # N m s, over this part, before rows were written
L_TURN_B = link_columns(1)  # N m s
L_APART = link_columns()  # m, by how much it was apart at most in this part
L_SLIGHT = link_columns(1)  # m, by how much any may be apart without being looked at; in the first
L_MASS = link_columns(3)  # kg, the inverse of its yield
L_YIELD = link_columns(3)  # 1/kg, by x along x, by y along x, by y along y
L_MADE = link_columns()  # N s, what a sweep makes of the direction
L_LEFT = link_columns()  # N s, what a sweep makes of the error that is left
L_SEARCH = link_columns()  # m/s, direction of conjugate gradients, before a sweep back
L_TRIED = link_columns()  # N s, that direction

_net_nodes = Columns()  # of a member of a net; nothing moves what stands still
N_CHANGE = _net_nodes(3)  # m/s, m/s, rad/s
N_INVERSE_MASS = _net_nodes()  # 1/kg
N_INVERSE_INERTIA = _net_nodes()  # 1/(kg m^2)
