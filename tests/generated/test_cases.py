"""Each case of the specification passes.

Generated from srs/ by `python -m tools.generate`. Edit the chapter, not this file.
"""

from tests.support import passes


def test_oe1_bound_on_a_fall_against_quadratic_drag() -> None:
    """OE1, srs/verification/certificates.md:11; verifies R10."""
    passes("OE1")


def test_oe2_bound_on_a_damped_spring() -> None:
    """OE2, srs/verification/certificates.md:39; verifies R10."""
    passes("OE2")


def test_oe3_bound_on_two_bodies_that_circle_each_other() -> None:
    """OE3, srs/verification/certificates.md:72; verifies R10."""
    passes("OE3")


def test_oe4_bound_where_the_answer_is_exact() -> None:
    """OE4, srs/verification/certificates.md:110; verifies R10."""
    passes("OE4")


def test_og9_advances_and_their_bounds() -> None:
    """OG9, srs/verification/continuous_collision.md:8; verifies R7, R12."""
    passes("OG9")


def test_og10_quiet_bodies() -> None:
    """OG10, srs/verification/continuous_collision.md:119; verifies R12."""
    passes("OG10")


def test_oa5c_fall_in_drag_in_a_few_long_steps() -> None:
    """OA5c, srs/verification/exponential.md:7; verifies R5, R9, R10."""
    passes("OA5c")


def test_oa9g_spring_in_drag() -> None:
    """OA9g, srs/verification/exponential.md:42; verifies R5, R9, R10."""
    passes("OA9g")


def test_oa5_linear_drag() -> None:
    """OA5, srs/verification/forces.md:24; verifies R5, R9, R10."""
    passes("OA5")


def test_oa5b_errors_of_the_steps_under_linear_drag() -> None:
    """OA5b, srs/verification/forces.md:69; verifies R5, R9, R10."""
    passes("OA5b")


def test_oa6_fall_against_linear_drag() -> None:
    """OA6, srs/verification/forces.md:114; verifies R5, R9, R10."""
    passes("OA6")


def test_oa6c_drag_so_weak_that_it_cancels() -> None:
    """OA6c, srs/verification/forces.md:164; verifies R5, R9."""
    passes("OA6c")


def test_oa7_fall_against_quadratic_drag() -> None:
    """OA7, srs/verification/forces.md:194; verifies R5, R9, R10."""
    passes("OA7")


def test_oa9_spring() -> None:
    """OA9, srs/verification/forces.md:256; verifies R5, R9, R10."""
    passes("OA9")


def test_oa9b_spring_that_hangs() -> None:
    """OA9b, srs/verification/forces.md:301; verifies R5, R9, R10."""
    passes("OA9b")


def test_oa9c_spring_with_a_rest_length_and_a_damper() -> None:
    """OA9c, srs/verification/forces.md:352; verifies R5, R9, R10."""
    passes("OA9c")


def test_oa9d_two_bodies_on_a_spring() -> None:
    """OA9d, srs/verification/forces.md:417; verifies R9, NFR2."""
    passes("OA9d")


def test_oa9e_two_bodies_on_a_damped_spring() -> None:
    """OA9e, srs/verification/forces.md:453; verifies R9, NFR2."""
    passes("OA9e")


def test_oa9f_spring_for_high_orders() -> None:
    """OA9f, srs/verification/forces.md:493; verifies R5, R9, R10."""
    passes("OA9f")


def test_oa9j_spring_for_order_eight() -> None:
    """OA9j, srs/verification/forces.md:536; verifies R5, R9, R10."""
    passes("OA9j")


def test_oa10_pendulum() -> None:
    """OA10, srs/verification/forces.md:590; verifies R6, R9, R10."""
    passes("OA10")


def test_oa10b_pendulum_in_mid_swing() -> None:
    """OA10b, srs/verification/forces.md:686; verifies R6, R9, R10."""
    passes("OA10b")


def test_oa11_kepler_s_ellipse() -> None:
    """OA11, srs/verification/forces.md:747; verifies R5, R9, R10."""
    passes("OA11")


def test_oa11b_kepler_s_ellipse_on_the_way_out() -> None:
    """OA11b, srs/verification/forces.md:820; verifies R5, R9, R10."""
    passes("OA11b")


def test_oa11c_the_trap_of_the_whole_period() -> None:
    """OA11c, srs/verification/forces.md:859; verifies R10."""
    passes("OA11c")


def test_oa12_two_bodies_that_attract_each_other() -> None:
    """OA12, srs/verification/forces.md:897; verifies R5, R9, R10."""
    passes("OA12")


def test_oa12b_momenta_under_coarse_steps() -> None:
    """OA12b, srs/verification/forces.md:974; verifies R9, NFR2."""
    passes("OA12b")


def test_oa12c_three_bodies_that_attract_each_other() -> None:
    """OA12c, srs/verification/forces.md:1005; verifies R9, NFR2."""
    passes("OA12c")


def test_oa14_motion_made_to_measure_with_all_terms() -> None:
    """OA14, srs/verification/forces.md:1059; verifies R2, R5, R6, R9, R10."""
    passes("OA14")


def test_oa14b_many_turns_made_to_measure_with_all_terms() -> None:
    """OA14b, srs/verification/forces.md:1290; verifies R2, R5, R6, R9, R10."""
    passes("OA14b")


def test_of1a_block_that_slides_down_a_slope_of_30_degrees() -> None:
    """OF1a, srs/verification/friction.md:14; verifies R3, R8, R11."""
    passes("OF1a")


def test_of1b_block_that_stays_on_a_slope_of_30_degrees_for_100_s() -> None:
    """OF1b, srs/verification/friction.md:64; verifies R3, R8, R11."""
    passes("OF1b")


def test_of1c_blocks_beside_the_angle_of_friction() -> None:
    """OF1c, srs/verification/friction.md:100; verifies R3, R8, R11."""
    passes("OF1c")


def test_of2_block_that_slides_on_a_floor_until_it_stops() -> None:
    """OF2, srs/verification/friction.md:147; verifies R3, R8, R11."""
    passes("OF2")


def test_of3a_disc_that_slips_on_a_floor() -> None:
    """OF3a, srs/verification/friction.md:202; verifies R3, R8, R11."""
    passes("OF3a")


def test_of3b_disc_that_sticks_to_a_floor() -> None:
    """OF3b, srs/verification/friction.md:244; verifies R3, R8, R11."""
    passes("OF3b")


def test_of4_oblique_impact_of_two_spinning_rough_bodies() -> None:
    """OF4, srs/verification/friction.md:292; verifies R8, R11."""
    passes("OF4")


def test_of5a_disc_that_rolls_down_20_degrees() -> None:
    """OF5a, srs/verification/friction.md:373; verifies R3, R8, R11."""
    passes("OF5a")


def test_of5b_hoop_that_rolls_down_20_degrees() -> None:
    """OF5b, srs/verification/friction.md:406; verifies R3, R8, R11."""
    passes("OF5b")


def test_of5c_disc_that_slips_while_it_turns() -> None:
    """OF5c, srs/verification/friction.md:440; verifies R3, R8, R11."""
    passes("OF5c")


def test_of5d_disc_that_rolls_down_20_degrees_listed_last() -> None:
    """OF5d, srs/verification/friction.md:477; verifies R3, R8, R11."""
    passes("OF5d")


def test_of10_rod_that_turns_about_its_tip() -> None:
    """OF10, srs/verification/friction.md:514; verifies R3, R8, R11."""
    passes("OF10")


def test_of6_ball_that_is_thrown_and_begins_to_roll() -> None:
    """OF6, srs/verification/friction.md:557; verifies R3, R8, R11."""
    passes("OF6")


def test_of7_rod_of_painlev() -> None:
    """OF7, srs/verification/friction.md:611; verifies R8, R11."""
    passes("OF7")


def test_of8_coefficients_of_friction_that_cannot_be_meant() -> None:
    """OF8, srs/verification/friction.md:640; verifies R4, R11."""
    passes("OF8")


def test_of9_spin_against_angular_drag() -> None:
    """OF9, srs/verification/friction.md:677; verifies R2, R6, R9."""
    passes("OF9")


def test_tc10_bodies_of_the_same_mass_that_never_meet() -> None:
    """TC10, srs/verification/impact.md:12; verifies R1, R2, R3, R4, R5, R7."""
    passes("TC10")


def test_tc10b_bodies_of_the_same_mass_that_meet() -> None:
    """TC10b, srs/verification/impact.md:56; verifies R1, R2, R3, R4, R7, R8."""
    passes("TC10b")


def test_tc11_a_dynamic_body_dropped_on_a_static_one() -> None:
    """TC11, srs/verification/impact.md:105; verifies R1, R2, R3, R4, R7, R8."""
    passes("TC11")


def test_tc12_usability_survey() -> None:
    """TC12, srs/verification/nonfunctional.md:11; verifies NFR3, NFR4."""
    passes("TC12")


def test_tc13_agreement_with_independent_programs() -> None:
    """TC13, srs/verification/nonfunctional.md:44; verifies NFR2, R5, R6, R7, R8."""
    passes("TC13")


def test_tc14_stress_scene_of_2018() -> None:
    """TC14, srs/verification/nonfunctional.md:72; verifies NFR1."""
    passes("TC14")


def test_ob1_oblique_impact_of_two_spinning_bodies() -> None:
    """OB1, srs/verification/oracles_impact.md:13; verifies R8."""
    passes("OB1")


def test_ob2_central_impact_at_mass_ratios_from_1e_12_to_1e12() -> None:
    """OB2, srs/verification/oracles_impact.md:52; verifies R3, R7, R8."""
    passes("OB2")


def test_ob3_off_centre_impacts_of_discs() -> None:
    """OB3, srs/verification/oracles_impact.md:166; verifies R3, R7, R8."""
    passes("OB3")


def test_ob4_spinning_square_that_hits_a_floor_with_a_corner() -> None:
    """OB4, srs/verification/oracles_impact.md:236; verifies R3, R7, R8."""
    passes("OB4")


def test_ob13_squares_that_meet_tip_to_tip_corner_to_corner_and_side_to_side() -> None:
    """OB13, srs/verification/oracles_impact.md:286; verifies R3, R7, R8."""
    passes("OB13")


def test_ob6a_bouncing_ball_with_restitution_0_5() -> None:
    """OB6a, srs/verification/oracles_impact.md:373; verifies R3, R7, R8."""
    passes("OB6a")


def test_ob6b_bouncing_ball_with_restitution_0_8() -> None:
    """OB6b, srs/verification/oracles_impact.md:448; verifies R3, R7, R8."""
    passes("OB6b")


def test_ob6c_bouncing_ball_with_restitution_0_9() -> None:
    """OB6c, srs/verification/oracles_impact.md:523; verifies R3, R7, R8."""
    passes("OB6c")


def test_ob6d_bouncing_ball_with_restitution_1_for_100_s() -> None:
    """OB6d, srs/verification/oracles_impact.md:601; verifies R3, R7, R8."""
    passes("OB6d")


def test_ob12_bodies_at_rest_on_a_floor() -> None:
    """OB12, srs/verification/oracles_impact.md:651; verifies R3, R7, R8."""
    passes("OB12")


def test_ob16_rod_that_a_torque_presses_down_on_a_smooth_floor() -> None:
    """OB16, srs/verification/oracles_impact.md:692; verifies R3, R7, R8."""
    passes("OB16")


def test_ob8a_3_impacts_for_a_mass_ratio_of_1() -> None:
    """OB8a, srs/verification/oracles_impact.md:732; verifies R3, R7, R8."""
    passes("OB8a")


def test_ob8b_31_impacts_for_a_mass_ratio_of_100() -> None:
    """OB8b, srs/verification/oracles_impact.md:777; verifies R3, R7, R8."""
    passes("OB8b")


def test_ob8c_314_impacts_for_a_mass_ratio_of_10000() -> None:
    """OB8c, srs/verification/oracles_impact.md:807; verifies R3, R7, R8."""
    passes("OB8c")


def test_ob8d_3141_impacts_for_a_mass_ratio_of_1000000() -> None:
    """OB8d, srs/verification/oracles_impact.md:854; verifies R3, R7, R8."""
    passes("OB8d")


def test_oa1_constant_force() -> None:
    """OA1, srs/verification/oracles_motion.md:16; verifies R2, R5."""
    passes("OA1")


def test_oa2_throws_in_eight_directions() -> None:
    """OA2, srs/verification/oracles_motion.md:78; verifies R2, R5."""
    passes("OA2")


def test_oa3_constant_torque() -> None:
    """OA3, srs/verification/oracles_motion.md:217; verifies R2, R6."""
    passes("OA3")


def test_oa4_free_body_that_spins_fast() -> None:
    """OA4, srs/verification/oracles_motion.md:270; verifies R5, R6."""
    passes("OA4")


def test_oa14a_motion_made_to_measure() -> None:
    """OA14a, srs/verification/oracles_motion.md:312; verifies R2, R5, R6."""
    passes("OA14a")


def test_od1_overlap_of_axis_parallel_boxes() -> None:
    """OD1, srs/verification/quantities.md:14; verifies R7."""
    passes("OD1")


def test_od2_inertia_area_and_centre_of_simple_shapes() -> None:
    """OD2, srs/verification/quantities.md:79; verifies R2."""
    passes("OD2")


def test_od3_quantities_of_one_body() -> None:
    """OD3, srs/verification/quantities.md:134; verifies R8."""
    passes("OD3")


def test_oc1_inputs_outside_their_ranges() -> None:
    """OC1, srs/verification/refusals.md:7; verifies R2, R3, R4."""
    passes("OC1")


def test_oc2_forces_that_cannot_be_meant() -> None:
    """OC2, srs/verification/refusals.md:120; verifies R4, R9."""
    passes("OC2")


def test_tc8_rotation_about_the_own_axis() -> None:
    """TC8, srs/verification/rotation.md:11; verifies R1, R2, R4, R6."""
    passes("TC8")


def test_tc9_angular_velocity_under_constant_torque() -> None:
    """TC9, srs/verification/rotation.md:34; verifies R1, R2, R4, R6."""
    passes("TC9")


def test_os1_showcase() -> None:
    """OS1, srs/verification/showcase.md:19; verifies R1, R2, R3, R5, R6, R7, R8."""
    passes("OS1")


def test_og1_rows_of_a_contact() -> None:
    """OG1, srs/verification/soft_contact.md:9; verifies R12."""
    passes("OG1")


def test_og2_visits_of_a_soft_contact() -> None:
    """OG2, srs/verification/soft_contact.md:54; verifies R12."""
    passes("OG2")


def test_og3_acceleration_by_inverse_mass() -> None:
    """OG3, srs/verification/soft_contact.md:225; verifies R12."""
    passes("OG3")


def test_og4_firm_contacts() -> None:
    """OG4, srs/verification/soft_contact.md:256; verifies R12."""
    passes("OG4")


def test_og5_momenta_and_energies_of_a_thin_island() -> None:
    """OG5, srs/verification/soft_contact.md:306; verifies R12."""
    passes("OG5")


def test_og6_energy_of_an_island() -> None:
    """OG6, srs/verification/soft_contact.md:356; verifies R12."""
    passes("OG6")


def test_og7_bound_on_the_energy_of_an_island() -> None:
    """OG7, srs/verification/soft_contact.md:439; verifies R12."""
    passes("OG7")


def test_og8_flow_through_a_step() -> None:
    """OG8, srs/verification/soft_contact.md:477; verifies R12."""
    passes("OG8")


def test_oa9h_unstable_steps() -> None:
    """OA9h, srs/verification/stability.md:9; verifies R5."""
    passes("OA9h")


def test_tc1_translation_without_force() -> None:
    """TC1, srs/verification/translation.md:21; verifies R1, R2, R4, R5."""
    passes("TC1")


def test_tc2_constant_acceleration_to_the_right() -> None:
    """TC2, srs/verification/translation.md:50; verifies R1, R2, R4, R5."""
    passes("TC2")


def test_tc3_constant_acceleration_to_the_left() -> None:
    """TC3, srs/verification/translation.md:77; verifies R1, R2, R4, R5."""
    passes("TC3")


def test_tc4_free_fall_of_three_bodies() -> None:
    """TC4, srs/verification/translation.md:116; verifies R1, R2, R4, R5."""
    passes("TC4")


def test_tc5_floating_bodies_under_forces() -> None:
    """TC5, srs/verification/translation.md:183; verifies R1, R2, R4, R5."""
    passes("TC5")


def test_tc6_projectile_launched_at_45_degrees() -> None:
    """TC6, srs/verification/translation.md:246; verifies R1, R2, R4, R5."""
    passes("TC6")


def test_tc7_projectile_launched_at_60_degrees() -> None:
    """TC7, srs/verification/translation.md:288; verifies R1, R2, R4, R5."""
    passes("TC7")
