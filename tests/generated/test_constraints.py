"""Slopes, rate and convective part of each constraint follow from its equation.

Generated from srs/ by `python -m tools.generate`. Edit the chapter, not this file.
"""

from hypothesis import given

from tamias2d.generated.constraints import CONSTRAINTS
from tests.support import Value, follows, values


@given(
    anchor_a=values("anchor_a"),
    anchor_b=values("anchor_b"),
    position_a=values("position_a"),
    velocity_a=values("velocity_a"),
    orientation_a=values("orientation_a"),
    angular_velocity_a=values("angular_velocity_a"),
    position_b=values("position_b"),
    velocity_b=values("velocity_b"),
    orientation_b=values("orientation_b"),
    angular_velocity_b=values("angular_velocity_b"),
    position_c=values("position_c"),
    velocity_c=values("velocity_c"),
    orientation_c=values("orientation_c"),
    angular_velocity_c=values("angular_velocity_c"),
)
def test_revolute_follows_from_its_equation(**given: Value) -> None:
    """srs/models/joints.md:227."""
    follows(CONSTRAINTS["revolute"], given)


@given(
    anchor_a=values("anchor_a"),
    anchor_b=values("anchor_b"),
    joint_length=values("joint_length"),
    position_a=values("position_a"),
    velocity_a=values("velocity_a"),
    orientation_a=values("orientation_a"),
    angular_velocity_a=values("angular_velocity_a"),
    position_b=values("position_b"),
    velocity_b=values("velocity_b"),
    orientation_b=values("orientation_b"),
    angular_velocity_b=values("angular_velocity_b"),
    position_c=values("position_c"),
    velocity_c=values("velocity_c"),
    orientation_c=values("orientation_c"),
    angular_velocity_c=values("angular_velocity_c"),
)
def test_distance_follows_from_its_equation(**given: Value) -> None:
    """srs/models/joints.md:241."""
    follows(CONSTRAINTS["distance"], given)


@given(
    anchor_a=values("anchor_a"),
    anchor_b=values("anchor_b"),
    joint_angle=values("joint_angle"),
    position_a=values("position_a"),
    velocity_a=values("velocity_a"),
    orientation_a=values("orientation_a"),
    angular_velocity_a=values("angular_velocity_a"),
    position_b=values("position_b"),
    velocity_b=values("velocity_b"),
    orientation_b=values("orientation_b"),
    angular_velocity_b=values("angular_velocity_b"),
    position_c=values("position_c"),
    velocity_c=values("velocity_c"),
    orientation_c=values("orientation_c"),
    angular_velocity_c=values("angular_velocity_c"),
)
def test_weld_follows_from_its_equation(**given: Value) -> None:
    """srs/models/joints.md:258."""
    follows(CONSTRAINTS["weld"], given)


@given(
    anchor_a=values("anchor_a"),
    guide_a=values("guide_a"),
    anchor_b=values("anchor_b"),
    joint_angle=values("joint_angle"),
    position_a=values("position_a"),
    velocity_a=values("velocity_a"),
    orientation_a=values("orientation_a"),
    angular_velocity_a=values("angular_velocity_a"),
    position_b=values("position_b"),
    velocity_b=values("velocity_b"),
    orientation_b=values("orientation_b"),
    angular_velocity_b=values("angular_velocity_b"),
    position_c=values("position_c"),
    velocity_c=values("velocity_c"),
    orientation_c=values("orientation_c"),
    angular_velocity_c=values("angular_velocity_c"),
)
def test_prismatic_follows_from_its_equation(**given: Value) -> None:
    """srs/models/joints.md:271."""
    follows(CONSTRAINTS["prismatic"], given)


@given(
    anchor_a=values("anchor_a"),
    guide_a=values("guide_a"),
    anchor_b=values("anchor_b"),
    position_a=values("position_a"),
    velocity_a=values("velocity_a"),
    orientation_a=values("orientation_a"),
    angular_velocity_a=values("angular_velocity_a"),
    position_b=values("position_b"),
    velocity_b=values("velocity_b"),
    orientation_b=values("orientation_b"),
    angular_velocity_b=values("angular_velocity_b"),
    position_c=values("position_c"),
    velocity_c=values("velocity_c"),
    orientation_c=values("orientation_c"),
    angular_velocity_c=values("angular_velocity_c"),
)
def test_groove_follows_from_its_equation(**given: Value) -> None:
    """srs/models/joints.md:288."""
    follows(CONSTRAINTS["groove"], given)


@given(
    gear_ratio=values("gear_ratio"),
    joint_angle=values("joint_angle"),
    position_a=values("position_a"),
    velocity_a=values("velocity_a"),
    orientation_a=values("orientation_a"),
    angular_velocity_a=values("angular_velocity_a"),
    position_b=values("position_b"),
    velocity_b=values("velocity_b"),
    orientation_b=values("orientation_b"),
    angular_velocity_b=values("angular_velocity_b"),
    position_c=values("position_c"),
    velocity_c=values("velocity_c"),
    orientation_c=values("orientation_c"),
    angular_velocity_c=values("angular_velocity_c"),
)
def test_gear_follows_from_its_equation(**given: Value) -> None:
    """srs/models/joints.md:304."""
    follows(CONSTRAINTS["gear"], given)


@given(
    anchor_a=values("anchor_a"),
    anchor_b=values("anchor_b"),
    post_a=values("post_a"),
    post_b=values("post_b"),
    gear_ratio=values("gear_ratio"),
    joint_length=values("joint_length"),
    position_a=values("position_a"),
    velocity_a=values("velocity_a"),
    orientation_a=values("orientation_a"),
    angular_velocity_a=values("angular_velocity_a"),
    position_b=values("position_b"),
    velocity_b=values("velocity_b"),
    orientation_b=values("orientation_b"),
    angular_velocity_b=values("angular_velocity_b"),
    position_c=values("position_c"),
    velocity_c=values("velocity_c"),
    orientation_c=values("orientation_c"),
    angular_velocity_c=values("angular_velocity_c"),
)
def test_pulley_follows_from_its_equation(**given: Value) -> None:
    """srs/models/joints.md:322."""
    follows(CONSTRAINTS["pulley"], given)


@given(
    joint_angle=values("joint_angle"),
    position_a=values("position_a"),
    velocity_a=values("velocity_a"),
    orientation_a=values("orientation_a"),
    angular_velocity_a=values("angular_velocity_a"),
    position_b=values("position_b"),
    velocity_b=values("velocity_b"),
    orientation_b=values("orientation_b"),
    angular_velocity_b=values("angular_velocity_b"),
    position_c=values("position_c"),
    velocity_c=values("velocity_c"),
    orientation_c=values("orientation_c"),
    angular_velocity_c=values("angular_velocity_c"),
)
def test_angle_follows_from_its_equation(**given: Value) -> None:
    """srs/models/joints.md:354."""
    follows(CONSTRAINTS["angle"], given)


@given(
    anchor_a=values("anchor_a"),
    guide_a=values("guide_a"),
    anchor_b=values("anchor_b"),
    joint_travel=values("joint_travel"),
    position_a=values("position_a"),
    velocity_a=values("velocity_a"),
    orientation_a=values("orientation_a"),
    angular_velocity_a=values("angular_velocity_a"),
    position_b=values("position_b"),
    velocity_b=values("velocity_b"),
    orientation_b=values("orientation_b"),
    angular_velocity_b=values("angular_velocity_b"),
    position_c=values("position_c"),
    velocity_c=values("velocity_c"),
    orientation_c=values("orientation_c"),
    angular_velocity_c=values("angular_velocity_c"),
)
def test_travel_follows_from_its_equation(**given: Value) -> None:
    """srs/models/joints.md:364."""
    follows(CONSTRAINTS["travel"], given)
