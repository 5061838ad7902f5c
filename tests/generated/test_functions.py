"""Each generated function gives what its equation says.

Generated from srs/ by `python -m tools.generate`. Edit the chapter, not this file.
"""

from hypothesis import given

from tamias2d.generated import (
    continuous_collision,
    definitions,
    detection,
    drag,
    firm_contact,
    friction,
    gravitation,
    impact,
    island_energy,
    rest,
    rotation,
    sleeping,
    soft_contact,
    spring,
    translation,
)
from tests.support import Value, agrees, values


@given(velocity=values("velocity"), angular_velocity=values("angular_velocity"), arm=values("arm"))
def test_point_velocity_is_dd9(**given: Value) -> None:
    """DD9, srs/definitions.md:66."""
    agrees(definitions.point_velocity, "velocity + cross(angular_velocity, arm)", given)


@given(arm=values("arm"), force=values("force"))
def test_torque_is_dd13(**given: Value) -> None:
    """DD13, srs/definitions.md:83."""
    agrees(definitions.torque, "cross(arm, force)", given)


@given(mass=values("mass"), radius=values("radius"))
def test_inertia_disc_is_dd18(**given: Value) -> None:
    """DD18, srs/definitions.md:110."""
    agrees(definitions.inertia_disc, "mass*radius**2/2", given)


@given(mass=values("mass"), width=values("width"), height=values("height"))
def test_inertia_box_is_dd18(**given: Value) -> None:
    """DD18, srs/definitions.md:110."""
    agrees(definitions.inertia_box, "mass*(width**2 + height**2)/12", given)


@given(mass=values("mass"), vertex_i=values("vertex_i"), vertex_j=values("vertex_j"))
def test_inertia_polygon_is_dd18(**given: Value) -> None:
    """DD18, srs/definitions.md:110."""
    agrees(
        definitions.inertia_polygon,
        "mass*sum(cross(vertex_i, vertex_j)*(dot(vertex_i, vertex_i) + dot(vertex_i, vertex_j) + dot(vertex_j, vertex_j)))/(6*sum(cross(vertex_i, vertex_j)))",
        given,
    )


@given(vertex_i=values("vertex_i"), vertex_j=values("vertex_j"))
def test_area_polygon_is_dd18(**given: Value) -> None:
    """DD18, srs/definitions.md:110."""
    agrees(definitions.area_polygon, "sum(cross(vertex_i, vertex_j))/2", given)


@given(vertex_i=values("vertex_i"), vertex_j=values("vertex_j"))
def test_centroid_polygon_is_dd18(**given: Value) -> None:
    """DD18, srs/definitions.md:110."""
    agrees(
        definitions.centroid_polygon,
        "sum((vertex_i + vertex_j)*cross(vertex_i, vertex_j))/(3*sum(cross(vertex_i, vertex_j)))",
        given,
    )


@given(radius=values("radius"))
def test_area_disc_is_dd24(**given: Value) -> None:
    """DD24, srs/definitions.md:144."""
    agrees(definitions.area_disc, "pi*radius**2", given)


@given(width=values("width"), height=values("height"))
def test_area_box_is_dd24(**given: Value) -> None:
    """DD24, srs/definitions.md:144."""
    agrees(definitions.area_box, "width*height", given)


@given(length=values("length"), radius=values("radius"))
def test_area_capsule_is_dd24(**given: Value) -> None:
    """DD24, srs/definitions.md:144."""
    agrees(definitions.area_capsule, "2*radius*length + pi*radius**2", given)


@given(mass=values("mass"), length=values("length"))
def test_inertia_segment_is_dd24(**given: Value) -> None:
    """DD24, srs/definitions.md:144."""
    agrees(definitions.inertia_segment, "mass*length**2/12", given)


@given(mass=values("mass"), length=values("length"), radius=values("radius"))
def test_inertia_capsule_is_dd24(**given: Value) -> None:
    """DD24, srs/definitions.md:144."""
    agrees(
        definitions.inertia_capsule,
        "mass*(length**3/6 + 2*radius**2*length + pi*radius*(radius**2/2 + length**2/4))/(2*length + pi*radius)",
        given,
    )


@given(area_i=values("area_i"), position_i=values("position_i"))
def test_position_compound_is_dd25(**given: Value) -> None:
    """DD25, srs/definitions.md:188."""
    agrees(definitions.position_compound, "sum(area_i*position_i)/sum(area_i)", given)


@given(inertia_i=values("inertia_i"), mass_i=values("mass_i"), arm_i=values("arm_i"))
def test_inertia_compound_is_dd25(**given: Value) -> None:
    """DD25, srs/definitions.md:188."""
    agrees(definitions.inertia_compound, "sum(inertia_i + mass_i*dot(arm_i, arm_i))", given)


@given(gravity=values("gravity"), force=values("force"), inverse_mass=values("inverse_mass"))
def test_acceleration_is_dd30(**given: Value) -> None:
    """DD30, srs/definitions.md:225."""
    agrees(definitions.acceleration, "gravity + inverse_mass*force", given)


@given(torque=values("torque"), inverse_inertia=values("inverse_inertia"))
def test_angular_acceleration_is_dd30(**given: Value) -> None:
    """DD30, srs/definitions.md:225."""
    agrees(definitions.angular_acceleration, "inverse_inertia*torque", given)


@given(flow_gain=values("flow_gain"), pull=values("pull"))
def test_pace_given_is_dd41(**given: Value) -> None:
    """DD41, srs/definitions.md:252."""
    agrees(definitions.pace_given, "flow_gain*pull", given)


@given(flow_decay=values("flow_decay"), pace=values("pace"), pace_given=values("pace_given"))
def test_pace_later_is_dd41(**given: Value) -> None:
    """DD41, srs/definitions.md:252."""
    agrees(definitions.pace_later, "flow_decay*pace + pace_given", given)


@given(
    flow_gain=values("flow_gain"),
    flow_lift=values("flow_lift"),
    pace=values("pace"),
    pull=values("pull"),
)
def test_way_is_dd41(**given: Value) -> None:
    """DD41, srs/definitions.md:252."""
    agrees(definitions.way, "flow_gain*pace + flow_lift*pull", given)


@given(mass=values("mass"), velocity=values("velocity"))
def test_momentum_is_dd21(**given: Value) -> None:
    """DD21, srs/definitions.md:327."""
    agrees(definitions.momentum, "mass*velocity", given)


@given(inertia=values("inertia"), angular_velocity=values("angular_velocity"))
def test_angular_momentum_own_is_dd21(**given: Value) -> None:
    """DD21, srs/definitions.md:327."""
    agrees(definitions.angular_momentum_own, "inertia*angular_velocity", given)


@given(
    mass=values("mass"),
    position=values("position"),
    velocity=values("velocity"),
    inertia=values("inertia"),
    angular_velocity=values("angular_velocity"),
)
def test_angular_momentum_is_dd21(**given: Value) -> None:
    """DD21, srs/definitions.md:327."""
    agrees(
        definitions.angular_momentum,
        "mass*cross(position, velocity) + angular_momentum_own",
        given,
        {"angular_momentum_own": "inertia*angular_velocity"},
    )


@given(restitution_a=values("restitution_a"), restitution_b=values("restitution_b"))
def test_pair_restitution_is_dd17(**given: Value) -> None:
    """DD17, srs/definitions.md:425."""
    agrees(definitions.pair_restitution, "min(restitution_a, restitution_b)", given)


@given(point_velocity_a=values("point_velocity_a"), point_velocity_b=values("point_velocity_b"))
def test_normal_is_gd11(**given: Value) -> None:
    """GD11, srs/definitions.md:458."""
    agrees(
        definitions.normal,
        "(point_velocity_a - point_velocity_b)/norm(point_velocity_a - point_velocity_b)",
        given,
    )


@given(normal=values("normal"))
def test_tangent_is_dd22(**given: Value) -> None:
    """DD22, srs/definitions.md:482."""
    agrees(definitions.tangent, "perp(normal)", given)


@given(friction_a=values("friction_a"), friction_b=values("friction_b"))
def test_pair_friction_is_dd23(**given: Value) -> None:
    """DD23, srs/definitions.md:494."""
    agrees(definitions.pair_friction, "sqrt(friction_a*friction_b)", given)


@given(
    mass=values("mass"),
    velocity=values("velocity"),
    inertia=values("inertia"),
    angular_velocity=values("angular_velocity"),
)
def test_kinetic_energy_is_dd15(**given: Value) -> None:
    """DD15, srs/definitions.md:514."""
    agrees(
        definitions.kinetic_energy,
        "mass*dot(velocity, velocity)/2 + inertia*angular_velocity**2/2",
        given,
    )


@given(mass=values("mass"), gravity=values("gravity"), position=values("position"))
def test_potential_energy_is_dd16(**given: Value) -> None:
    """DD16, srs/definitions.md:528."""
    agrees(definitions.potential_energy, "-mass*dot(gravity, position)", given)


@given(
    restitution=values("restitution"),
    impulse=values("impulse"),
    normal_velocity=values("normal_velocity"),
)
def test_energy_loss_is_dd60(**given: Value) -> None:
    """DD60, srs/definitions.md:544."""
    agrees(definitions.energy_loss, "-(1 - restitution)*impulse*normal_velocity/2", given)


@given(position=values("position"), shift=values("shift"), fraction=values("fraction"))
def test_position_later_is_gd14(**given: Value) -> None:
    """GD14, srs/models/continuous_collision.md:23."""
    agrees(continuous_collision.position_later, "position + fraction*shift", given)


@given(
    position_a=values("position_a"),
    shift_a=values("shift_a"),
    position_b=values("position_b"),
    shift_b=values("shift_b"),
    fraction=values("fraction"),
)
def test_span_is_gd14(**given: Value) -> None:
    """GD14, srs/models/continuous_collision.md:23."""
    agrees(
        continuous_collision.span, "position_b - position_a + fraction*(shift_b - shift_a)", given
    )


@given(
    position=values("position"), shift_change=values("shift_change"), fraction=values("fraction")
)
def test_position_redirected_is_gd14(**given: Value) -> None:
    """GD14, srs/models/continuous_collision.md:23."""
    agrees(continuous_collision.position_redirected, "position - fraction*shift_change", given)


@given(
    orientation=values("orientation"),
    turn_change=values("turn_change"),
    fraction=values("fraction"),
)
def test_orientation_redirected_is_gd14(**given: Value) -> None:
    """GD14, srs/models/continuous_collision.md:23."""
    agrees(continuous_collision.orientation_redirected, "orientation - fraction*turn_change", given)


@given(shift=values("shift"), shift_change=values("shift_change"))
def test_shift_redirected_is_gd14(**given: Value) -> None:
    """GD14, srs/models/continuous_collision.md:23."""
    agrees(continuous_collision.shift_redirected, "shift + shift_change", given)


@given(turn=values("turn"), turn_change=values("turn_change"))
def test_turn_redirected_is_gd14(**given: Value) -> None:
    """GD14, srs/models/continuous_collision.md:23."""
    agrees(continuous_collision.turn_redirected, "turn + turn_change", given)


@given(shift=values("shift"), turn=values("turn"), extent=values("extent"))
def test_motion_bound_is_dd44(**given: Value) -> None:
    """DD44, srs/models/continuous_collision.md:65."""
    agrees(
        continuous_collision.motion_bound, "abs(x(shift)) + abs(y(shift)) + abs(turn)*extent", given
    )


@given(
    distance=values("distance"),
    extent=values("extent"),
    fraction=values("fraction"),
    motion_bound=values("motion_bound"),
)
def test_distance_bound_is_dd44(**given: Value) -> None:
    """DD44, srs/models/continuous_collision.md:65."""
    agrees(continuous_collision.distance_bound, "distance + extent + fraction*motion_bound", given)


@given(span=values("span"), shift=values("shift"))
def test_miss_distance_is_dd45(**given: Value) -> None:
    """DD45, srs/models/continuous_collision.md:87."""
    agrees(continuous_collision.miss_distance, "cross(span, shift)/norm(shift)", given)


@given(span=values("span"), shift=values("shift"))
def test_fraction_closest_is_dd45(**given: Value) -> None:
    """DD45, srs/models/continuous_collision.md:87."""
    agrees(continuous_collision.fraction_closest, "-dot(span, shift)/dot(shift, shift)", given)


@given(extent=values("extent"), miss_distance=values("miss_distance"), shift=values("shift"))
def test_half_interval_is_dd45(**given: Value) -> None:
    """DD45, srs/models/continuous_collision.md:87."""
    agrees(
        continuous_collision.half_interval, "sqrt(extent**2 - miss_distance**2)/norm(shift)", given
    )


@given(
    separation=values("separation"),
    separation_rate=values("separation_rate"),
    gap_acceleration_least=values("gap_acceleration_least"),
)
def test_discriminant_is_dd46(**given: Value) -> None:
    """DD46, srs/models/continuous_collision.md:125."""
    agrees(
        continuous_collision.discriminant,
        "separation_rate**2 - 2*gap_acceleration_least*separation",
        given,
    )


@given(
    separation_rate=values("separation_rate"),
    gap_acceleration_least=values("gap_acceleration_least"),
    discriminant=values("discriminant"),
)
def test_advance_opening_is_dd46(**given: Value) -> None:
    """DD46, srs/models/continuous_collision.md:125."""
    agrees(
        continuous_collision.advance_opening,
        "(separation_rate + sqrt(discriminant))/(-gap_acceleration_least)",
        given,
    )


@given(
    separation=values("separation"),
    separation_rate=values("separation_rate"),
    discriminant=values("discriminant"),
)
def test_advance_closing_is_dd46(**given: Value) -> None:
    """DD46, srs/models/continuous_collision.md:125."""
    agrees(
        continuous_collision.advance_closing,
        "2*separation/(sqrt(discriminant) - separation_rate)",
        given,
    )


@given(angular_speed=values("angular_speed"), angular_acceleration=values("angular_acceleration"))
def test_circling_is_dd47(**given: Value) -> None:
    """DD47, srs/models/continuous_collision.md:155."""
    agrees(continuous_collision.circling, "angular_speed**2 + angular_acceleration", given)


@given(
    acceleration_a=values("acceleration_a"),
    acceleration_b=values("acceleration_b"),
    normal=values("normal"),
    deviation=values("deviation"),
)
def test_centre_acceleration_least_is_dd47(**given: Value) -> None:
    """DD47, srs/models/continuous_collision.md:155."""
    agrees(
        continuous_collision.centre_acceleration_least,
        "dot(acceleration_b - acceleration_a, normal) - deviation",
        given,
    )


@given(
    circling=values("circling"),
    distance=values("distance"),
    angular_speed=values("angular_speed"),
    speed=values("speed"),
    acceleration_size=values("acceleration_size"),
)
def test_centre_acceleration_turning_is_dd47(**given: Value) -> None:
    """DD47, srs/models/continuous_collision.md:155."""
    agrees(
        continuous_collision.centre_acceleration_turning,
        "-(circling*distance + 2*angular_speed*speed + acceleration_size)",
        given,
    )


@given(
    centre_acceleration_least=values("centre_acceleration_least"),
    extent_a=values("extent_a"),
    circling_a=values("circling_a"),
    extent_b=values("extent_b"),
    circling_b=values("circling_b"),
)
def test_gap_acceleration_least_is_dd47(**given: Value) -> None:
    """DD47, srs/models/continuous_collision.md:155."""
    agrees(
        continuous_collision.gap_acceleration_least,
        "centre_acceleration_least - extent_a*circling_a - extent_b*circling_b",
        given,
    )


@given(normal=values("normal"), turn=values("turn"), fraction=values("fraction"))
def test_normal_turned_is_dd48(**given: Value) -> None:
    """DD48, srs/models/continuous_collision.md:194."""
    agrees(continuous_collision.normal_turned, "normal - cross(fraction*turn, normal)", given)


@given(shift=values("shift"), normal=values("normal"), turn=values("turn"), span=values("span"))
def test_gap_change_is_dd48(**given: Value) -> None:
    """DD48, srs/models/continuous_collision.md:194."""
    agrees(continuous_collision.gap_change, "dot(shift, normal) + turn*cross(normal, span)", given)


@given(turn=values("turn"), extent=values("extent"))
def test_arc_bend_is_dd48(**given: Value) -> None:
    """DD48, srs/models/continuous_collision.md:194."""
    agrees(continuous_collision.arc_bend, "turn**2*extent", given)


@given(
    base_gap=values("base_gap"),
    corner_gap_a=values("corner_gap_a"),
    corner_gap_b=values("corner_gap_b"),
    gap_change=values("gap_change"),
    arc_bend=values("arc_bend"),
    fraction=values("fraction"),
)
def test_separation_least_is_dd48(**given: Value) -> None:
    """DD48, srs/models/continuous_collision.md:194."""
    agrees(
        continuous_collision.separation_least,
        "base_gap + corner_gap_a + corner_gap_b + fraction*(gap_change - fraction*arc_bend/2)",
        given,
    )


@given(turn=values("turn"), fraction=values("fraction"), arc=values("arc"))
def test_inward_share_is_dd49(**given: Value) -> None:
    """DD49, srs/models/continuous_collision.md:294."""
    agrees(
        continuous_collision.inward_share, "abs(turn)*min(abs(turn)*(1 - fraction), arc/2)", given
    )


@given(
    shift=values("shift"),
    turn=values("turn"),
    span=values("span"),
    inward_share=values("inward_share"),
)
def test_shift_carried_is_dd49(**given: Value) -> None:
    """DD49, srs/models/continuous_collision.md:294."""
    agrees(
        continuous_collision.shift_carried, "shift + cross(turn, span) - inward_share*span", given
    )


@given(
    center_a=values("center_a"),
    width_a=values("width_a"),
    height_a=values("height_a"),
    center_b=values("center_b"),
    width_b=values("width_b"),
    height_b=values("height_b"),
)
def test_overlap_is_im4(**given: Value) -> None:
    """IM4, srs/models/detection.md:15."""
    agrees(
        detection.overlap,
        "abs(x(center_a) - x(center_b)) <= (width_a + width_b)/2 and abs(y(center_a) - y(center_b)) <= (height_a + height_b)/2",
        given,
    )


@given(linear_drag=values("linear_drag"), velocity=values("velocity"))
def test_linear_drag_force_is_im6(**given: Value) -> None:
    """IM6, srs/models/drag.md:18."""
    agrees(drag.linear_drag_force, "-linear_drag*velocity", given)


@given(quadratic_drag=values("quadratic_drag"), velocity=values("velocity"))
def test_quadratic_drag_force_is_im6(**given: Value) -> None:
    """IM6, srs/models/drag.md:18."""
    agrees(
        drag.quadratic_drag_force,
        "-quadratic_drag*speed*velocity",
        given,
        {"speed": "norm(velocity)"},
    )


@given(linear_drag=values("linear_drag"), mass=values("mass"))
def test_drag_rate_is_im6(**given: Value) -> None:
    """IM6, srs/models/drag.md:18."""
    agrees(drag.drag_rate, "linear_drag/mass", given)


@given(angular_drag=values("angular_drag"), angular_velocity=values("angular_velocity"))
def test_angular_drag_torque_is_im6(**given: Value) -> None:
    """IM6, srs/models/drag.md:18."""
    agrees(drag.angular_drag_torque, "-angular_drag*angular_velocity", given)


@given(angular_drag=values("angular_drag"), inertia=values("inertia"))
def test_angular_drag_rate_is_im6(**given: Value) -> None:
    """IM6, srs/models/drag.md:18."""
    agrees(drag.angular_drag_rate, "angular_drag/inertia", given)


@given(
    position_start=values("position_start"),
    velocity_start=values("velocity_start"),
    acceleration=values("acceleration"),
    drag_rate=values("drag_rate"),
    time=values("time"),
)
def test_position_is_im6(**given: Value) -> None:
    """IM6, srs/models/drag.md:18."""
    agrees(
        drag.position,
        "position_start + velocity_start*time*phi1(-drag_rate*time) + acceleration*time**2*phi2(-drag_rate*time)",
        given,
    )


@given(
    velocity_start=values("velocity_start"),
    acceleration=values("acceleration"),
    drag_rate=values("drag_rate"),
    time=values("time"),
)
def test_velocity_is_im6(**given: Value) -> None:
    """IM6, srs/models/drag.md:18."""
    agrees(
        drag.velocity,
        "velocity_start*exp(-drag_rate*time) + acceleration*time*phi1(-drag_rate*time)",
        given,
    )


@given(
    orientation_start=values("orientation_start"),
    angular_velocity_start=values("angular_velocity_start"),
    angular_acceleration=values("angular_acceleration"),
    angular_drag_rate=values("angular_drag_rate"),
    time=values("time"),
)
def test_orientation_is_im6(**given: Value) -> None:
    """IM6, srs/models/drag.md:18."""
    agrees(
        drag.orientation,
        "orientation_start + angular_velocity_start*time*phi1(-angular_drag_rate*time) + angular_acceleration*time**2*phi2(-angular_drag_rate*time)",
        given,
    )


@given(
    angular_velocity_start=values("angular_velocity_start"),
    angular_acceleration=values("angular_acceleration"),
    angular_drag_rate=values("angular_drag_rate"),
    time=values("time"),
)
def test_angular_velocity_is_im6(**given: Value) -> None:
    """IM6, srs/models/drag.md:18."""
    agrees(
        drag.angular_velocity,
        "angular_velocity_start*exp(-angular_drag_rate*time) + angular_acceleration*time*phi1(-angular_drag_rate*time)",
        given,
    )


@given(
    push=values("push"),
    row_velocity_kicked=values("row_velocity_kicked"),
    bias_velocity=values("bias_velocity"),
    firmness=values("firmness"),
)
def test_push_wanted_is_gd12(**given: Value) -> None:
    """GD12, srs/models/firm_contact.md:21."""
    agrees(firm_contact.push_wanted, "push - firmness*(row_velocity_kicked + bias_velocity)", given)


@given(
    rub=values("rub"),
    row_velocity_kicked=values("row_velocity_kicked"),
    firmness=values("firmness"),
)
def test_rub_wanted_is_gd12(**given: Value) -> None:
    """GD12, srs/models/firm_contact.md:21."""
    agrees(firm_contact.rub_wanted, "rub - firmness*row_velocity_kicked", given)


@given(push_first=values("push_first"), push_both=values("push_both"))
def test_push_share_is_dd32(**given: Value) -> None:
    """DD32, srs/models/firm_contact.md:76."""
    agrees(firm_contact.push_share, "push_first/push_both", given)


@given(
    turning_arm_first=values("turning_arm_first"),
    turning_arm_second=values("turning_arm_second"),
    push_share=values("push_share"),
)
def test_turning_arm_both_is_dd32(**given: Value) -> None:
    """DD32, srs/models/firm_contact.md:76."""
    agrees(
        firm_contact.turning_arm_both,
        "push_share*turning_arm_first + (1 - push_share)*turning_arm_second",
        given,
    )


@given(
    row_velocity_first=values("row_velocity_first"),
    row_velocity_second=values("row_velocity_second"),
    push_share=values("push_share"),
)
def test_row_velocity_both_is_dd32(**given: Value) -> None:
    """DD32, srs/models/firm_contact.md:76."""
    agrees(
        firm_contact.row_velocity_both,
        "push_share*row_velocity_first + (1 - push_share)*row_velocity_second",
        given,
    )


@given(push=values("push"), friction=values("friction"))
def test_rub_most_is_dd32(**given: Value) -> None:
    """DD32, srs/models/firm_contact.md:76."""
    agrees(firm_contact.rub_most, "friction*push", given)


@given(rub_wanted=values("rub_wanted"), rub_most=values("rub_most"))
def test_limited_rub_is_dd32(**given: Value) -> None:
    """DD32, srs/models/firm_contact.md:76."""
    agrees(firm_contact.limited_rub, "max(min(rub_wanted, rub_most), -rub_most)", given)


@given(line=values("line"), firmness=values("firmness"))
def test_firm_mass_x_is_dd33(**given: Value) -> None:
    """DD33, srs/models/firm_contact.md:153."""
    agrees(firm_contact.firm_mass_x, "firmness*x(line)*line", given)


@given(line=values("line"), firmness=values("firmness"))
def test_firm_mass_y_is_dd33(**given: Value) -> None:
    """DD33, srs/models/firm_contact.md:153."""
    agrees(firm_contact.firm_mass_y, "firmness*y(line)*line", given)


@given(line=values("line"), turning_arm_a=values("turning_arm_a"), firmness=values("firmness"))
def test_firm_moment_is_dd33(**given: Value) -> None:
    """DD33, srs/models/firm_contact.md:153."""
    agrees(firm_contact.firm_moment, "firmness*line*turning_arm_a", given)


@given(line=values("line"), turning_arm_b=values("turning_arm_b"), firmness=values("firmness"))
def test_firm_lever_is_dd33(**given: Value) -> None:
    """DD33, srs/models/firm_contact.md:153."""
    agrees(firm_contact.firm_lever, "firmness*turning_arm_b*line", given)


@given(
    turning_arm_a=values("turning_arm_a"),
    turning_arm_b=values("turning_arm_b"),
    firmness=values("firmness"),
)
def test_firm_inertia_is_dd33(**given: Value) -> None:
    """DD33, srs/models/firm_contact.md:153."""
    agrees(firm_contact.firm_inertia, "firmness*turning_arm_b*turning_arm_a", given)


@given(mass=values("mass"), velocity_start=values("velocity_start"), velocity=values("velocity"))
def test_momentum_left_is_dd34(**given: Value) -> None:
    """DD34, srs/models/firm_contact.md:210."""
    agrees(firm_contact.momentum_left, "mass*(velocity_start - velocity)", given)


@given(
    inertia=values("inertia"),
    angular_velocity_start=values("angular_velocity_start"),
    angular_velocity=values("angular_velocity"),
)
def test_angular_momentum_left_is_dd34(**given: Value) -> None:
    """DD34, srs/models/firm_contact.md:210."""
    agrees(
        firm_contact.angular_momentum_left,
        "inertia*(angular_velocity_start - angular_velocity)",
        given,
    )


@given(momentum_a=values("momentum_a"), kick=values("kick"), line=values("line"))
def test_momentum_a_kicked_is_dd34(**given: Value) -> None:
    """DD34, srs/models/firm_contact.md:210."""
    agrees(firm_contact.momentum_a_kicked, "momentum_a - kick*line", given)


@given(
    angular_momentum_a=values("angular_momentum_a"),
    kick=values("kick"),
    turning_arm_a=values("turning_arm_a"),
)
def test_angular_momentum_a_kicked_is_dd34(**given: Value) -> None:
    """DD34, srs/models/firm_contact.md:210."""
    agrees(firm_contact.angular_momentum_a_kicked, "angular_momentum_a - kick*turning_arm_a", given)


@given(momentum_b=values("momentum_b"), kick=values("kick"), line=values("line"))
def test_momentum_b_kicked_is_dd34(**given: Value) -> None:
    """DD34, srs/models/firm_contact.md:210."""
    agrees(firm_contact.momentum_b_kicked, "momentum_b + kick*line", given)


@given(
    angular_momentum_b=values("angular_momentum_b"),
    kick=values("kick"),
    turning_arm_b=values("turning_arm_b"),
)
def test_angular_momentum_b_kicked_is_dd34(**given: Value) -> None:
    """DD34, srs/models/firm_contact.md:210."""
    agrees(firm_contact.angular_momentum_b_kicked, "angular_momentum_b + kick*turning_arm_b", given)


@given(mass=values("mass"), velocity=values("velocity"))
def test_linear_energy_is_dd35(**given: Value) -> None:
    """DD35, srs/models/firm_contact.md:238."""
    agrees(firm_contact.linear_energy, "mass*dot(velocity, velocity)/2", given)


@given(inertia=values("inertia"), angular_velocity=values("angular_velocity"))
def test_turning_energy_is_dd35(**given: Value) -> None:
    """DD35, srs/models/firm_contact.md:238."""
    agrees(firm_contact.turning_energy, "inertia*angular_velocity**2/2", given)


@given(momentum=values("momentum"), mass=values("mass"))
def test_linear_energy_start_is_dd35(**given: Value) -> None:
    """DD35, srs/models/firm_contact.md:238."""
    agrees(firm_contact.linear_energy_start, "dot(momentum, momentum)/(2*mass)", given)


@given(angular_momentum=values("angular_momentum"), inertia=values("inertia"))
def test_turning_energy_start_is_dd35(**given: Value) -> None:
    """DD35, srs/models/firm_contact.md:238."""
    agrees(firm_contact.turning_energy_start, "angular_momentum**2/(2*inertia)", given)


@given(mass=values("mass"), bias_velocity=values("bias_velocity"))
def test_bias_energy_is_dd35(**given: Value) -> None:
    """DD35, srs/models/firm_contact.md:238."""
    agrees(firm_contact.bias_energy, "mass*bias_velocity**2/2", given)


@given(
    velocity_a=values("velocity_a"),
    angular_velocity_a=values("angular_velocity_a"),
    arm_a=values("arm_a"),
    velocity_b=values("velocity_b"),
    angular_velocity_b=values("angular_velocity_b"),
    arm_b=values("arm_b"),
    normal=values("normal"),
)
def test_tangential_velocity_is_im9(**given: Value) -> None:
    """IM9, srs/models/friction.md:57."""
    agrees(
        friction.tangential_velocity,
        "dot(velocity_b + cross(angular_velocity_b, arm_b) - velocity_a - cross(angular_velocity_a, arm_a), perp(normal))",
        given,
    )


@given(
    inverse_inertia_a=values("inverse_inertia_a"),
    arm_a=values("arm_a"),
    inverse_inertia_b=values("inverse_inertia_b"),
    arm_b=values("arm_b"),
    normal=values("normal"),
)
def test_cross_coupling_is_im9(**given: Value) -> None:
    """IM9, srs/models/friction.md:57."""
    agrees(
        friction.cross_coupling,
        "inverse_inertia_a*cross(arm_a, normal)*cross(arm_a, perp(normal)) + inverse_inertia_b*cross(arm_b, normal)*cross(arm_b, perp(normal))",
        given,
    )


@given(
    inverse_mass_a=values("inverse_mass_a"),
    inverse_inertia_a=values("inverse_inertia_a"),
    arm_a=values("arm_a"),
    inverse_mass_b=values("inverse_mass_b"),
    inverse_inertia_b=values("inverse_inertia_b"),
    arm_b=values("arm_b"),
    inverse_effective_mass=values("inverse_effective_mass"),
)
def test_inverse_sliding_mass_is_im9(**given: Value) -> None:
    """IM9, srs/models/friction.md:57."""
    agrees(
        friction.inverse_sliding_mass,
        "((inverse_mass_a + inverse_mass_b)*(inverse_mass_a + inverse_mass_b + inverse_inertia_a*dot(arm_a, arm_a) + inverse_inertia_b*dot(arm_b, arm_b)) + inverse_inertia_a*inverse_inertia_b*cross(arm_a, arm_b)**2)/inverse_effective_mass",
        given,
    )


@given(
    tangential_velocity=values("tangential_velocity"),
    cross_coupling=values("cross_coupling"),
    normal_velocity=values("normal_velocity"),
    inverse_effective_mass=values("inverse_effective_mass"),
)
def test_tangential_velocity_closest_is_im9(**given: Value) -> None:
    """IM9, srs/models/friction.md:57."""
    agrees(
        friction.tangential_velocity_closest,
        "tangential_velocity - cross_coupling*normal_velocity/inverse_effective_mass",
        given,
    )


@given(
    tangential_velocity_closest=values("tangential_velocity_closest"),
    inverse_sliding_mass=values("inverse_sliding_mass"),
)
def test_sticking_impulse_is_im9(**given: Value) -> None:
    """IM9, srs/models/friction.md:57."""
    agrees(friction.sticking_impulse, "-tangential_velocity_closest/inverse_sliding_mass", given)


@given(
    cross_coupling=values("cross_coupling"),
    sticking_impulse=values("sticking_impulse"),
    inverse_effective_mass=values("inverse_effective_mass"),
)
def test_normal_change_is_im9(**given: Value) -> None:
    """IM9, srs/models/friction.md:57."""
    agrees(friction.normal_change, "-cross_coupling*sticking_impulse/inverse_effective_mass", given)


@given(
    pair_friction=values("pair_friction"),
    impulse=values("impulse"),
    sticking_impulse=values("sticking_impulse"),
    normal_change=values("normal_change"),
)
def test_share_is_im9(**given: Value) -> None:
    """IM9, srs/models/friction.md:57."""
    agrees(
        friction.share,
        "impulse/max(abs(sticking_impulse)/pair_friction - normal_change, impulse)",
        given,
    )


@given(impulse=values("impulse"), share=values("share"), normal_change=values("normal_change"))
def test_normal_impulse_is_im9(**given: Value) -> None:
    """IM9, srs/models/friction.md:57."""
    agrees(friction.normal_impulse, "impulse + share*normal_change", given)


@given(share=values("share"), sticking_impulse=values("sticking_impulse"))
def test_tangential_impulse_is_im9(**given: Value) -> None:
    """IM9, srs/models/friction.md:57."""
    agrees(friction.tangential_impulse, "share*sticking_impulse", given)


@given(
    normal_impulse=values("normal_impulse"),
    tangential_impulse=values("tangential_impulse"),
    normal=values("normal"),
)
def test_impulse_vector_is_im9(**given: Value) -> None:
    """IM9, srs/models/friction.md:57."""
    agrees(
        friction.impulse_vector, "normal_impulse*normal + tangential_impulse*perp(normal)", given
    )


@given(
    velocity_a=values("velocity_a"),
    inverse_mass_a=values("inverse_mass_a"),
    impulse_vector=values("impulse_vector"),
)
def test_velocity_a_after_is_im9(**given: Value) -> None:
    """IM9, srs/models/friction.md:57."""
    agrees(friction.velocity_a_after, "velocity_a - inverse_mass_a*impulse_vector", given)


@given(
    angular_velocity_a=values("angular_velocity_a"),
    inverse_inertia_a=values("inverse_inertia_a"),
    arm_a=values("arm_a"),
    impulse_vector=values("impulse_vector"),
)
def test_angular_velocity_a_after_is_im9(**given: Value) -> None:
    """IM9, srs/models/friction.md:57."""
    agrees(
        friction.angular_velocity_a_after,
        "angular_velocity_a - inverse_inertia_a*cross(arm_a, impulse_vector)",
        given,
    )


@given(
    velocity_b=values("velocity_b"),
    inverse_mass_b=values("inverse_mass_b"),
    impulse_vector=values("impulse_vector"),
)
def test_velocity_b_after_is_im9(**given: Value) -> None:
    """IM9, srs/models/friction.md:57."""
    agrees(friction.velocity_b_after, "velocity_b + inverse_mass_b*impulse_vector", given)


@given(
    angular_velocity_b=values("angular_velocity_b"),
    inverse_inertia_b=values("inverse_inertia_b"),
    arm_b=values("arm_b"),
    impulse_vector=values("impulse_vector"),
)
def test_angular_velocity_b_after_is_im9(**given: Value) -> None:
    """IM9, srs/models/friction.md:57."""
    agrees(
        friction.angular_velocity_b_after,
        "angular_velocity_b + inverse_inertia_b*cross(arm_b, impulse_vector)",
        given,
    )


@given(
    acceleration_a=values("acceleration_a"),
    angular_acceleration_a=values("angular_acceleration_a"),
    arm_a=values("arm_a"),
    acceleration_b=values("acceleration_b"),
    angular_acceleration_b=values("angular_acceleration_b"),
    arm_b=values("arm_b"),
    normal=values("normal"),
)
def test_tangential_acceleration_is_gd8(**given: Value) -> None:
    """GD8, srs/models/friction.md:311."""
    agrees(
        friction.tangential_acceleration,
        "dot(acceleration_b + cross(angular_acceleration_b, arm_b) - acceleration_a - cross(angular_acceleration_a, arm_a), perp(normal))",
        given,
    )


@given(
    sense=values("sense"),
    pair_friction=values("pair_friction"),
    contact_force=values("contact_force"),
)
def test_friction_force_is_gd8(**given: Value) -> None:
    """GD8, srs/models/friction.md:311."""
    agrees(friction.friction_force, "-sense*pair_friction*contact_force", given)


@given(
    tangential_acceleration=values("tangential_acceleration"),
    angular_velocity_a=values("angular_velocity_a"),
    arm_a=values("arm_a"),
    angular_velocity_b=values("angular_velocity_b"),
    arm_b=values("arm_b"),
    tangent=values("tangent"),
)
def test_tangential_acceleration_turning_is_gd16(**given: Value) -> None:
    """GD16, srs/models/friction.md:364."""
    agrees(
        friction.tangential_acceleration_turning,
        "tangential_acceleration + turning_part",
        given,
        {
            "turning_part": "angular_velocity_a**2*dot(tangent, arm_a) - angular_velocity_b**2*dot(tangent, arm_b)"
        },
    )


@given(
    gravitational_constant=values("gravitational_constant"),
    mass_a=values("mass_a"),
    mass_b=values("mass_b"),
    position_a=values("position_a"),
    position_b=values("position_b"),
)
def test_attraction_is_im5(**given: Value) -> None:
    """IM5, srs/models/gravitation.md:12."""
    agrees(
        gravitation.attraction,
        "gravitational_constant*mass_a*mass_b*span/distance**3",
        given,
        {"span": "position_b - position_a", "distance": "norm(span)"},
    )


@given(
    gravitational_constant=values("gravitational_constant"),
    mass_a=values("mass_a"),
    mass_b=values("mass_b"),
    position_a=values("position_a"),
    position_b=values("position_b"),
)
def test_gravitational_energy_is_im5(**given: Value) -> None:
    """IM5, srs/models/gravitation.md:12."""
    agrees(
        gravitation.gravitational_energy,
        "-gravitational_constant*mass_a*mass_b/distance",
        given,
        {"span": "position_b - position_a", "distance": "norm(span)"},
    )


@given(
    velocity_a=values("velocity_a"),
    angular_velocity_a=values("angular_velocity_a"),
    arm_a=values("arm_a"),
    velocity_b=values("velocity_b"),
    angular_velocity_b=values("angular_velocity_b"),
    arm_b=values("arm_b"),
    normal=values("normal"),
)
def test_normal_velocity_is_im3(**given: Value) -> None:
    """IM3, srs/models/impact.md:26."""
    agrees(
        impact.normal_velocity,
        "dot(velocity_b + cross(angular_velocity_b, arm_b) - velocity_a - cross(angular_velocity_a, arm_a), normal)",
        given,
    )


@given(
    inverse_mass=values("inverse_mass"),
    inverse_inertia=values("inverse_inertia"),
    arm_first=values("arm_first"),
    normal_first=values("normal_first"),
    arm_second=values("arm_second"),
    normal_second=values("normal_second"),
)
def test_coupling_is_im3(**given: Value) -> None:
    """IM3, srs/models/impact.md:26."""
    agrees(
        impact.coupling,
        "inverse_mass*dot(normal_first, normal_second) + inverse_inertia*cross(arm_first, normal_first)*cross(arm_second, normal_second)",
        given,
    )


@given(
    inverse_mass_a=values("inverse_mass_a"),
    inverse_inertia_a=values("inverse_inertia_a"),
    arm_a=values("arm_a"),
    inverse_mass_b=values("inverse_mass_b"),
    inverse_inertia_b=values("inverse_inertia_b"),
    arm_b=values("arm_b"),
    normal=values("normal"),
)
def test_inverse_effective_mass_is_im3(**given: Value) -> None:
    """IM3, srs/models/impact.md:26."""
    agrees(
        impact.inverse_effective_mass,
        "inverse_mass_a + inverse_inertia_a*cross(arm_a, normal)**2 + inverse_mass_b + inverse_inertia_b*cross(arm_b, normal)**2",
        given,
    )


@given(
    restitution=values("restitution"),
    normal_velocity=values("normal_velocity"),
    inverse_effective_mass=values("inverse_effective_mass"),
)
def test_impulse_is_im3(**given: Value) -> None:
    """IM3, srs/models/impact.md:26."""
    agrees(impact.impulse, "-(1 + restitution)*normal_velocity/inverse_effective_mass", given)


@given(
    velocity_a=values("velocity_a"),
    impulse=values("impulse"),
    normal=values("normal"),
    inverse_mass_a=values("inverse_mass_a"),
)
def test_velocity_a_after_is_im3(**given: Value) -> None:
    """IM3, srs/models/impact.md:26."""
    agrees(impact.velocity_a_after, "velocity_a - impulse*inverse_mass_a*normal", given)


@given(
    angular_velocity_a=values("angular_velocity_a"),
    impulse=values("impulse"),
    arm_a=values("arm_a"),
    normal=values("normal"),
    inverse_inertia_a=values("inverse_inertia_a"),
)
def test_angular_velocity_a_after_is_im3(**given: Value) -> None:
    """IM3, srs/models/impact.md:26."""
    agrees(
        impact.angular_velocity_a_after,
        "angular_velocity_a - impulse*inverse_inertia_a*cross(arm_a, normal)",
        given,
    )


@given(
    velocity_b=values("velocity_b"),
    impulse=values("impulse"),
    normal=values("normal"),
    inverse_mass_b=values("inverse_mass_b"),
)
def test_velocity_b_after_is_im3(**given: Value) -> None:
    """IM3, srs/models/impact.md:26."""
    agrees(impact.velocity_b_after, "velocity_b + impulse*inverse_mass_b*normal", given)


@given(
    angular_velocity_b=values("angular_velocity_b"),
    impulse=values("impulse"),
    arm_b=values("arm_b"),
    normal=values("normal"),
    inverse_inertia_b=values("inverse_inertia_b"),
)
def test_angular_velocity_b_after_is_im3(**given: Value) -> None:
    """IM3, srs/models/impact.md:26."""
    agrees(
        impact.angular_velocity_b_after,
        "angular_velocity_b + impulse*inverse_inertia_b*cross(arm_b, normal)",
        given,
    )


@given(
    mass=values("mass"),
    gravity=values("gravity"),
    force=values("force"),
    torque=values("torque"),
    shift=values("shift"),
    turn=values("turn"),
)
def test_work_is_dd36(**given: Value) -> None:
    """DD36, srs/models/island_energy.md:12."""
    agrees(island_energy.work, "dot(mass*gravity + force, shift) + torque*turn", given)


@given(velocity=values("velocity"), velocity_support=values("velocity_support"))
def test_velocity_seen_is_dd37(**given: Value) -> None:
    """DD37, srs/models/island_energy.md:39."""
    agrees(island_energy.velocity_seen, "velocity - velocity_support", given)


@given(
    angular_velocity=values("angular_velocity"),
    angular_velocity_support=values("angular_velocity_support"),
)
def test_angular_velocity_seen_is_dd37(**given: Value) -> None:
    """DD37, srs/models/island_energy.md:39."""
    agrees(
        island_energy.angular_velocity_seen, "angular_velocity - angular_velocity_support", given
    )


@given(
    shift=values("shift"),
    velocity_support=values("velocity_support"),
    time_step=values("time_step"),
)
def test_shift_seen_is_dd37(**given: Value) -> None:
    """DD37, srs/models/island_energy.md:39."""
    agrees(island_energy.shift_seen, "shift - time_step*velocity_support", given)


@given(
    turn=values("turn"),
    angular_velocity_support=values("angular_velocity_support"),
    time_step=values("time_step"),
)
def test_turn_seen_is_dd37(**given: Value) -> None:
    """DD37, srs/models/island_energy.md:39."""
    agrees(island_energy.turn_seen, "turn - time_step*angular_velocity_support", given)


@given(mass=values("mass"), position=values("position"))
def test_mass_moment_is_dd38(**given: Value) -> None:
    """DD38, srs/models/island_energy.md:67."""
    agrees(island_energy.mass_moment, "mass*position", given)


@given(mass=values("mass"), position=values("position"), inertia=values("inertia"))
def test_inertia_origin_is_dd38(**given: Value) -> None:
    """DD38, srs/models/island_energy.md:67."""
    agrees(island_energy.inertia_origin, "inertia + mass*dot(position, position)", given)


@given(mass_moment=values("mass_moment"), mass=values("mass"))
def test_position_island_is_dd38(**given: Value) -> None:
    """DD38, srs/models/island_energy.md:67."""
    agrees(island_energy.position_island, "mass_moment/mass", given)


@given(momentum=values("momentum"), mass=values("mass"))
def test_velocity_island_is_dd38(**given: Value) -> None:
    """DD38, srs/models/island_energy.md:67."""
    agrees(island_energy.velocity_island, "momentum/mass", given)


@given(
    inertia_origin=values("inertia_origin"),
    mass=values("mass"),
    position_island=values("position_island"),
)
def test_inertia_island_is_dd38(**given: Value) -> None:
    """DD38, srs/models/island_energy.md:67."""
    agrees(
        island_energy.inertia_island,
        "inertia_origin - mass*dot(position_island, position_island)",
        given,
    )


@given(
    angular_momentum=values("angular_momentum"),
    mass=values("mass"),
    position_island=values("position_island"),
    velocity_island=values("velocity_island"),
    inertia_island=values("inertia_island"),
)
def test_angular_velocity_island_is_dd38(**given: Value) -> None:
    """DD38, srs/models/island_energy.md:67."""
    agrees(
        island_energy.angular_velocity_island,
        "(angular_momentum - mass*cross(position_island, velocity_island))/inertia_island",
        given,
    )


@given(
    kinetic_energy_before=values("kinetic_energy_before"),
    kinetic_energy_after=values("kinetic_energy_after"),
    change_energy=values("change_energy"),
    kept_share=values("kept_share"),
)
def test_kinetic_energy_kept_is_gd13(**given: Value) -> None:
    """GD13, srs/models/island_energy.md:128."""
    agrees(
        island_energy.kinetic_energy_kept,
        "(1 - kept_share)*kinetic_energy_before + kept_share*kinetic_energy_after - kept_share*(1 - kept_share)*change_energy",
        given,
    )


@given(
    velocity_before=values("velocity_before"),
    velocity_after=values("velocity_after"),
    kept_share=values("kept_share"),
)
def test_velocity_kept_is_gd13(**given: Value) -> None:
    """GD13, srs/models/island_energy.md:128."""
    agrees(
        island_energy.velocity_kept,
        "velocity_before + kept_share*(velocity_after - velocity_before)",
        given,
    )


@given(
    angular_velocity_before=values("angular_velocity_before"),
    angular_velocity_after=values("angular_velocity_after"),
    kept_share=values("kept_share"),
)
def test_angular_velocity_kept_is_gd13(**given: Value) -> None:
    """GD13, srs/models/island_energy.md:128."""
    agrees(
        island_energy.angular_velocity_kept,
        "angular_velocity_before + kept_share*(angular_velocity_after - angular_velocity_before)",
        given,
    )


@given(push=values("push"), kick=values("kick"), kept_share=values("kept_share"))
def test_push_kept_is_gd13(**given: Value) -> None:
    """GD13, srs/models/island_energy.md:128."""
    agrees(island_energy.push_kept, "push - (1 - kept_share)*kick", given)


@given(
    energy_room=values("energy_room"),
    energy_rise=values("energy_rise"),
    change_energy=values("change_energy"),
)
def test_kept_share_rising_is_gd13(**given: Value) -> None:
    """GD13, srs/models/island_energy.md:128."""
    agrees(
        island_energy.kept_share_rising,
        "min(2*energy_room/(energy_slope + energy_root), 1)",
        given,
        {
            "energy_slope": "energy_rise - change_energy",
            "energy_root": "sqrt(energy_slope**2 + 4*change_energy*energy_room)",
        },
    )


@given(
    energy_room=values("energy_room"),
    energy_rise=values("energy_rise"),
    change_energy=values("change_energy"),
)
def test_kept_share_falling_is_gd13(**given: Value) -> None:
    """GD13, srs/models/island_energy.md:128."""
    agrees(
        island_energy.kept_share_falling,
        "min((energy_root - energy_slope)/(2*change_energy), 1)",
        given,
        {
            "energy_slope": "energy_rise - change_energy",
            "energy_root": "sqrt(energy_slope**2 + 4*change_energy*energy_room)",
        },
    )


@given(kinetic_energy_start=values("kinetic_energy_start"), work=values("work"))
def test_kinetic_energy_most_is_im11(**given: Value) -> None:
    """IM11, srs/models/island_energy.md:220."""
    agrees(island_energy.kinetic_energy_most, "kinetic_energy_start + max(work, 0)", given)


@given(
    kinetic_energy=values("kinetic_energy"),
    kinetic_energy_most=values("kinetic_energy_most"),
    kinetic_energy_least=values("kinetic_energy_least"),
)
def test_calm_share_is_im11(**given: Value) -> None:
    """IM11, srs/models/island_energy.md:220."""
    agrees(
        island_energy.calm_share,
        "min(sqrt((kinetic_energy_most - kinetic_energy_least)/(kinetic_energy - kinetic_energy_least)), 1)",
        given,
    )


@given(
    velocity=values("velocity"),
    velocity_island=values("velocity_island"),
    calm_share=values("calm_share"),
)
def test_velocity_calmed_is_im11(**given: Value) -> None:
    """IM11, srs/models/island_energy.md:220."""
    agrees(
        island_energy.velocity_calmed,
        "velocity_island + calm_share*(velocity - velocity_island)",
        given,
    )


@given(
    angular_velocity=values("angular_velocity"),
    angular_velocity_island=values("angular_velocity_island"),
    calm_share=values("calm_share"),
)
def test_angular_velocity_calmed_is_im11(**given: Value) -> None:
    """IM11, srs/models/island_energy.md:220."""
    agrees(
        island_energy.angular_velocity_calmed,
        "angular_velocity_island + calm_share*(angular_velocity - angular_velocity_island)",
        given,
    )


@given(
    acceleration_a=values("acceleration_a"),
    angular_acceleration_a=values("angular_acceleration_a"),
    arm_a=values("arm_a"),
    acceleration_b=values("acceleration_b"),
    angular_acceleration_b=values("angular_acceleration_b"),
    arm_b=values("arm_b"),
    normal=values("normal"),
)
def test_normal_acceleration_is_gd3(**given: Value) -> None:
    """GD3, srs/models/rest.md:14."""
    agrees(
        rest.normal_acceleration,
        "dot(acceleration_b + cross(angular_acceleration_b, arm_b) - acceleration_a - cross(angular_acceleration_a, arm_a), normal)",
        given,
    )


@given(
    normal_acceleration=values("normal_acceleration"),
    angular_velocity_a=values("angular_velocity_a"),
    angular_velocity_b=values("angular_velocity_b"),
    arm_b=values("arm_b"),
    normal=values("normal"),
    slip=values("slip"),
    distance=values("distance"),
)
def test_gap_acceleration_side_is_gd15(**given: Value) -> None:
    """GD15, srs/models/rest.md:53."""
    agrees(
        rest.gap_acceleration_side,
        "normal_acceleration + turning_part_side",
        given,
        {
            "turning_part_side": "2*angular_velocity_a*slip - angular_velocity_a**2*distance - angular_velocity_b**2*dot(normal, arm_b)"
        },
    )


@given(
    normal_acceleration=values("normal_acceleration"),
    angular_velocity_a=values("angular_velocity_a"),
    arm_a=values("arm_a"),
    angular_velocity_b=values("angular_velocity_b"),
    arm_b=values("arm_b"),
    normal=values("normal"),
    slip=values("slip"),
    distance=values("distance"),
)
def test_gap_acceleration_corner_is_gd15(**given: Value) -> None:
    """GD15, srs/models/rest.md:53."""
    agrees(
        rest.gap_acceleration_corner,
        "normal_acceleration + turning_part_corner",
        given,
        {
            "turning_part_corner": "slip**2/distance - angular_velocity_b**2*dot(normal, arm_b) + angular_velocity_a**2*dot(normal, arm_a)"
        },
    )


@given(
    normal_velocity_after=values("normal_velocity_after"),
    normal_acceleration=values("normal_acceleration"),
    restitution=values("restitution"),
)
def test_time_to_rest_is_gd5(**given: Value) -> None:
    """GD5, srs/models/rest.md:163."""
    agrees(
        rest.time_to_rest, "-2*normal_velocity_after/(normal_acceleration*(1 - restitution))", given
    )


@given(torque=values("torque"), inertia=values("inertia"))
def test_angular_acceleration_is_im2(**given: Value) -> None:
    """IM2, srs/models/rotation.md:27."""
    agrees(rotation.angular_acceleration, "torque/inertia", given)


@given(
    orientation_start=values("orientation_start"),
    angular_velocity_start=values("angular_velocity_start"),
    angular_acceleration=values("angular_acceleration"),
    time=values("time"),
)
def test_orientation_is_im2(**given: Value) -> None:
    """IM2, srs/models/rotation.md:27."""
    agrees(
        rotation.orientation,
        "orientation_start + angular_velocity_start*time + angular_acceleration*time**2/2",
        given,
    )


@given(
    angular_velocity_start=values("angular_velocity_start"),
    angular_acceleration=values("angular_acceleration"),
    time=values("time"),
)
def test_angular_velocity_is_im2(**given: Value) -> None:
    """IM2, srs/models/rotation.md:27."""
    agrees(rotation.angular_velocity, "angular_velocity_start + angular_acceleration*time", given)


@given(
    quiet_share=values("quiet_share"), extent=values("extent"), gravity_size=values("gravity_size")
)
def test_quiet_square_is_dd50(**given: Value) -> None:
    """DD50, srs/models/sleeping.md:12."""
    agrees(sleeping.quiet_square, "quiet_share**2*extent*gravity_size", given)


@given(
    velocity=values("velocity"),
    angular_velocity=values("angular_velocity"),
    shift=values("shift"),
    turn=values("turn"),
    extent=values("extent"),
    quiet_square=values("quiet_square"),
    time_step=values("time_step"),
)
def test_quiet_is_dd50(**given: Value) -> None:
    """DD50, srs/models/sleeping.md:12."""
    agrees(
        sleeping.quiet,
        "motion_square <= quiet_square and way_square <= quiet_square*time_step**2",
        given,
        {
            "rim_velocity": "angular_velocity*extent",
            "motion_square": "dot(velocity, velocity) + rim_velocity**2",
            "rim_way": "turn*extent",
            "way_square": "dot(shift, shift) + rim_way**2",
        },
    )


@given(
    mass=values("mass"),
    inertia=values("inertia"),
    extent=values("extent"),
    quiet_square=values("quiet_square"),
)
def test_kinetic_energy_most_is_im13(**given: Value) -> None:
    """IM13, srs/models/sleeping.md:59."""
    agrees(sleeping.kinetic_energy_most, "max(mass, inertia/extent**2)*quiet_square/2", given)


@given(arm=values("arm"), line=values("line"))
def test_turning_arm_is_dd26(**given: Value) -> None:
    """DD26, srs/models/soft_contact.md:22."""
    agrees(soft_contact.turning_arm, "cross(arm, line)", given)


@given(
    velocity_a=values("velocity_a"),
    angular_velocity_a=values("angular_velocity_a"),
    turning_arm_a=values("turning_arm_a"),
    velocity_b=values("velocity_b"),
    angular_velocity_b=values("angular_velocity_b"),
    turning_arm_b=values("turning_arm_b"),
    line=values("line"),
)
def test_row_velocity_is_dd26(**given: Value) -> None:
    """DD26, srs/models/soft_contact.md:22."""
    agrees(
        soft_contact.row_velocity,
        "dot(velocity_b - velocity_a, line) + angular_velocity_b*turning_arm_b - angular_velocity_a*turning_arm_a",
        given,
    )


@given(
    inverse_mass_a=values("inverse_mass_a"),
    inverse_inertia_a=values("inverse_inertia_a"),
    turning_arm_a=values("turning_arm_a"),
    inverse_mass_b=values("inverse_mass_b"),
    inverse_inertia_b=values("inverse_inertia_b"),
    turning_arm_b=values("turning_arm_b"),
)
def test_row_mass_is_dd26(**given: Value) -> None:
    """DD26, srs/models/soft_contact.md:22."""
    agrees(
        soft_contact.row_mass,
        "1/(inverse_mass_a + inverse_inertia_a*turning_arm_a**2 + inverse_mass_b + inverse_inertia_b*turning_arm_b**2)",
        given,
    )


@given(
    velocity_a=values("velocity_a"),
    kick=values("kick"),
    line=values("line"),
    inverse_mass_a=values("inverse_mass_a"),
)
def test_velocity_a_kicked_is_dd27(**given: Value) -> None:
    """DD27, srs/models/soft_contact.md:93."""
    agrees(soft_contact.velocity_a_kicked, "velocity_a - kick*inverse_mass_a*line", given)


@given(
    angular_velocity_a=values("angular_velocity_a"),
    kick=values("kick"),
    turning_arm_a=values("turning_arm_a"),
    inverse_inertia_a=values("inverse_inertia_a"),
)
def test_angular_velocity_a_kicked_is_dd27(**given: Value) -> None:
    """DD27, srs/models/soft_contact.md:93."""
    agrees(
        soft_contact.angular_velocity_a_kicked,
        "angular_velocity_a - kick*inverse_inertia_a*turning_arm_a",
        given,
    )


@given(
    velocity_b=values("velocity_b"),
    kick=values("kick"),
    line=values("line"),
    inverse_mass_b=values("inverse_mass_b"),
)
def test_velocity_b_kicked_is_dd27(**given: Value) -> None:
    """DD27, srs/models/soft_contact.md:93."""
    agrees(soft_contact.velocity_b_kicked, "velocity_b + kick*inverse_mass_b*line", given)


@given(
    angular_velocity_b=values("angular_velocity_b"),
    kick=values("kick"),
    turning_arm_b=values("turning_arm_b"),
    inverse_inertia_b=values("inverse_inertia_b"),
)
def test_angular_velocity_b_kicked_is_dd27(**given: Value) -> None:
    """DD27, srs/models/soft_contact.md:93."""
    agrees(
        soft_contact.angular_velocity_b_kicked,
        "angular_velocity_b + kick*inverse_inertia_b*turning_arm_b",
        given,
    )


@given(
    angular_frequency=values("angular_frequency"),
    damping_ratio=values("damping_ratio"),
    time_step=values("time_step"),
)
def test_bias_rate_is_gd9(**given: Value) -> None:
    """GD9, srs/models/soft_contact.md:185."""
    agrees(
        soft_contact.bias_rate,
        "angular_frequency/(2*damping_ratio + time_step*angular_frequency)",
        given,
    )


@given(
    angular_frequency=values("angular_frequency"),
    damping_ratio=values("damping_ratio"),
    time_step=values("time_step"),
)
def test_mass_share_is_gd9(**given: Value) -> None:
    """GD9, srs/models/soft_contact.md:185."""
    agrees(
        soft_contact.mass_share,
        "time_step*angular_frequency*(2*damping_ratio + time_step*angular_frequency)/(1 + time_step*angular_frequency*(2*damping_ratio + time_step*angular_frequency))",
        given,
    )


@given(
    angular_frequency=values("angular_frequency"),
    damping_ratio=values("damping_ratio"),
    time_step=values("time_step"),
)
def test_impulse_share_is_gd9(**given: Value) -> None:
    """GD9, srs/models/soft_contact.md:185."""
    agrees(
        soft_contact.impulse_share,
        "1/(1 + time_step*angular_frequency*(2*damping_ratio + time_step*angular_frequency))",
        given,
    )


@given(
    push=values("push"),
    row_mass=values("row_mass"),
    angular_frequency=values("angular_frequency"),
    time_step=values("time_step"),
)
def test_separation_rest_is_dd28(**given: Value) -> None:
    """DD28, srs/models/soft_contact.md:293."""
    agrees(soft_contact.separation_rest, "-push/(time_step*row_mass*angular_frequency**2)", given)


@given(
    preload=values("preload"),
    separation=values("separation"),
    preload_share=values("preload_share"),
    overlap_allowed=values("overlap_allowed"),
    preload_largest=values("preload_largest"),
)
def test_preload_later_is_dd39(**given: Value) -> None:
    """DD39, srs/models/soft_contact.md:345."""
    agrees(
        soft_contact.preload_later,
        "min(max(preload - preload_share*(max(separation, 0) + min(separation + overlap_allowed, 0)), 0), preload_largest)",
        given,
    )


@given(
    angular_frequency=values("angular_frequency"),
    push=values("push"),
    inverse_mass_a=values("inverse_mass_a"),
    inverse_mass_b=values("inverse_mass_b"),
    time_step=values("time_step"),
    overlap_share=values("overlap_share"),
    extent=values("extent"),
    firmest=values("firmest"),
)
def test_angular_frequency_loaded_is_dd42(**given: Value) -> None:
    """DD42, srs/models/soft_contact.md:408."""
    agrees(
        soft_contact.angular_frequency_loaded,
        "max(angular_frequency, min(angular_frequency_wanted, firmest*angular_frequency))",
        given,
        {
            "angular_frequency_wanted": "sqrt(push*(inverse_mass_a + inverse_mass_b)/(time_step*overlap_share*extent))"
        },
    )


@given(shift=values("shift"), velocity=values("velocity"), time_step=values("time_step"))
def test_shift_later_is_dd43(**given: Value) -> None:
    """DD43, srs/models/soft_contact.md:462."""
    agrees(soft_contact.shift_later, "shift + time_step*velocity", given)


@given(
    turn=values("turn"), angular_velocity=values("angular_velocity"), time_step=values("time_step")
)
def test_turn_later_is_dd43(**given: Value) -> None:
    """DD43, srs/models/soft_contact.md:462."""
    agrees(soft_contact.turn_later, "turn + time_step*angular_velocity", given)


@given(arm=values("arm"), line=values("line"))
def test_bend_is_dd29(**given: Value) -> None:
    """DD29, srs/models/soft_contact.md:482."""
    agrees(soft_contact.bend, "dot(arm, line)", given)


@given(
    separation=values("separation"),
    shift_a=values("shift_a"),
    turn_a=values("turn_a"),
    turning_arm_a=values("turning_arm_a"),
    bend_a=values("bend_a"),
    shift_b=values("shift_b"),
    turn_b=values("turn_b"),
    turning_arm_b=values("turning_arm_b"),
    bend_b=values("bend_b"),
    line=values("line"),
)
def test_separation_later_is_dd29(**given: Value) -> None:
    """DD29, srs/models/soft_contact.md:482."""
    agrees(
        soft_contact.separation_later,
        "separation + dot(shift_b - shift_a, line) + turn_b*turning_arm_b - turn_a*turning_arm_a - (turn_b**2*bend_b - turn_a**2*bend_a)/2",
        given,
    )


@given(
    separation=values("separation"),
    row_velocity=values("row_velocity"),
    time_step=values("time_step"),
)
def test_bias_velocity_later_is_dd31(**given: Value) -> None:
    """DD31, srs/models/soft_contact.md:554."""
    agrees(soft_contact.bias_velocity_later, "max(separation/time_step + row_velocity, 0)", given)


@given(
    bias_velocity_later=values("bias_velocity_later"),
    row_velocity=values("row_velocity"),
    time_step=values("time_step"),
)
def test_separation_is_dd31(**given: Value) -> None:
    """DD31, srs/models/soft_contact.md:554."""
    agrees(soft_contact.separation, "time_step*(bias_velocity_later - row_velocity)", given)


@given(
    removal_share=values("removal_share"), extent=values("extent"), time_step=values("time_step")
)
def test_bias_velocity_least_is_im10(**given: Value) -> None:
    """IM10, srs/models/soft_contact.md:593."""
    agrees(soft_contact.bias_velocity_least, "-removal_share*extent/time_step", given)


@given(
    separation=values("separation"),
    bias_rate=values("bias_rate"),
    bias_velocity_least=values("bias_velocity_least"),
    time_step=values("time_step"),
)
def test_bias_velocity_is_im10(**given: Value) -> None:
    """IM10, srs/models/soft_contact.md:593."""
    agrees(
        soft_contact.bias_velocity,
        "max(max(separation, 0)/time_step + bias_rate*min(separation, 0), bias_velocity_least)",
        given,
    )


@given(
    push=values("push"),
    row_velocity=values("row_velocity"),
    bias_velocity=values("bias_velocity"),
    row_mass=values("row_mass"),
    mass_share=values("mass_share"),
    impulse_share=values("impulse_share"),
)
def test_soft_push_is_im10(**given: Value) -> None:
    """IM10, srs/models/soft_contact.md:593."""
    agrees(
        soft_contact.soft_push,
        "max(push - row_mass*mass_share*(row_velocity + bias_velocity) - impulse_share*push, 0)",
        given,
    )


@given(
    rub=values("rub"),
    row_velocity=values("row_velocity"),
    row_mass=values("row_mass"),
    friction=values("friction"),
    push=values("push"),
)
def test_limited_rub_is_im10(**given: Value) -> None:
    """IM10, srs/models/soft_contact.md:593."""
    agrees(
        soft_contact.limited_rub,
        "max(min(rub - row_mass*row_velocity, friction*push), -friction*push)",
        given,
    )


@given(
    push=values("push"),
    row_velocity=values("row_velocity"),
    row_velocity_before=values("row_velocity_before"),
    restitution=values("restitution"),
    row_mass=values("row_mass"),
)
def test_bouncing_push_is_im10(**given: Value) -> None:
    """IM10, srs/models/soft_contact.md:593."""
    agrees(
        soft_contact.bouncing_push,
        "max(push - row_mass*(row_velocity + restitution*row_velocity_before), 0)",
        given,
    )


@given(
    stiffness=values("stiffness"),
    rest_length=values("rest_length"),
    damping=values("damping"),
    point_a=values("point_a"),
    point_velocity_a=values("point_velocity_a"),
    point_b=values("point_b"),
    point_velocity_b=values("point_velocity_b"),
)
def test_spring_force_is_im7(**given: Value) -> None:
    """IM7, srs/models/spring.md:30."""
    agrees(
        spring.spring_force,
        "tension*axis",
        given,
        {
            "span": "point_b - point_a",
            "distance": "norm(span)",
            "extension": "distance - rest_length",
            "axis": "span/max(distance, 1e-150[m])",
            "extension_rate": "dot(point_velocity_b - point_velocity_a, axis)",
            "tension": "stiffness*extension + damping*extension_rate",
        },
    )


@given(
    stiffness=values("stiffness"),
    rest_length=values("rest_length"),
    point_a=values("point_a"),
    point_b=values("point_b"),
)
def test_spring_energy_is_im7(**given: Value) -> None:
    """IM7, srs/models/spring.md:30."""
    agrees(
        spring.spring_energy,
        "stiffness*extension**2/2",
        given,
        {
            "span": "point_b - point_a",
            "distance": "norm(span)",
            "extension": "distance - rest_length",
        },
    )


@given(stiffness=values("stiffness"), mass=values("mass"))
def test_angular_frequency_is_im7(**given: Value) -> None:
    """IM7, srs/models/spring.md:30."""
    agrees(spring.angular_frequency, "sqrt(stiffness/mass)", given)


@given(
    point=values("point"),
    acceleration=values("acceleration"),
    angular_frequency=values("angular_frequency"),
)
def test_equilibrium_is_im7(**given: Value) -> None:
    """IM7, srs/models/spring.md:30."""
    agrees(spring.equilibrium, "point + acceleration/angular_frequency**2", given)


@given(
    equilibrium=values("equilibrium"),
    position_start=values("position_start"),
    velocity_start=values("velocity_start"),
    angular_frequency=values("angular_frequency"),
    time=values("time"),
)
def test_position_is_im7(**given: Value) -> None:
    """IM7, srs/models/spring.md:30."""
    agrees(
        spring.position,
        "equilibrium + (position_start - equilibrium)*cos(angular_frequency*time) + velocity_start*(sin(angular_frequency*time)/angular_frequency)",
        given,
    )


@given(
    equilibrium=values("equilibrium"),
    position_start=values("position_start"),
    velocity_start=values("velocity_start"),
    angular_frequency=values("angular_frequency"),
    time=values("time"),
)
def test_velocity_is_im7(**given: Value) -> None:
    """IM7, srs/models/spring.md:30."""
    agrees(
        spring.velocity,
        "velocity_start*cos(angular_frequency*time) + (equilibrium - position_start)*(angular_frequency*sin(angular_frequency*time))",
        given,
    )


@given(gravity=values("gravity"), force=values("force"), mass=values("mass"))
def test_acceleration_is_im1(**given: Value) -> None:
    """IM1, srs/models/translation.md:24."""
    agrees(translation.acceleration, "gravity + force/mass", given)


@given(
    position_start=values("position_start"),
    velocity_start=values("velocity_start"),
    acceleration=values("acceleration"),
    time=values("time"),
)
def test_position_is_im1(**given: Value) -> None:
    """IM1, srs/models/translation.md:24."""
    agrees(
        translation.position, "position_start + velocity_start*time + acceleration*time**2/2", given
    )


@given(
    velocity_start=values("velocity_start"),
    acceleration=values("acceleration"),
    time=values("time"),
)
def test_velocity_is_im1(**given: Value) -> None:
    """IM1, srs/models/translation.md:24."""
    agrees(translation.velocity, "velocity_start + acceleration*time", given)
