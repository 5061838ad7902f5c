"""What the stages of a step call for joints alone: scenes without joints do without it."""

from tamias2d.engine.broad_phase.kept_apart import without_kept_apart
from tamias2d.engine.early import note_early_joined
from tamias2d.engine.energy.angular_momentum import add_given_by_joints
from tamias2d.engine.energy.joined_gains import joints_disagree, note_gains, noted_if_free
from tamias2d.engine.islands import join_islands
from tamias2d.engine.joined import mark_joined, or_joined, unless_joined
from tamias2d.engine.joined_approach import joined_approach, judge_blow
from tamias2d.engine.joints.acting import unless_tied
from tamias2d.engine.joints.activity import (
    activate_joined,
    clear_of_joints,
    hold_tied,
    join_slabs,
    note_mechanisms,
)
from tamias2d.engine.joints.at_rest import note_joined_support, wake_tied
from tamias2d.engine.joints.impacts import answer_impacts, answer_rebounds
from tamias2d.engine.joints.island_bound import bound_joined, support_joined
from tamias2d.engine.joints.joined_dissipation import reduce_motion_as_one, reduce_together
from tamias2d.engine.joints.placement import note_places
from tamias2d.engine.joints.rebound import fit_rebound
from tamias2d.engine.joints.reserve import note_reserves
from tamias2d.engine.joints.stages import (
    begin_joints,
    end_joints,
    fit_touched,
    relax_joints,
    solve_joints,
    store_joints,
)
from tamias2d.engine.joints.step_impulses import keep_joint_impulses
from tamias2d.engine.joints.summed_energy import look_at_touched, past_untouched
from tamias2d.engine.joints.unforeseen import meets_unforeseen

JOINT_STAGES = (
    activate_joined,
    add_given_by_joints,
    answer_impacts,
    answer_rebounds,
    begin_joints,
    look_at_touched,
    meets_unforeseen,
    clear_of_joints,
    end_joints,
    fit_rebound,
    fit_touched,
    judge_blow,
    hold_tied,
    join_islands,
    join_slabs,
    joined_approach,
    keep_joint_impulses,
    mark_joined,
    note_gains,
    note_early_joined,
    note_joined_support,
    note_mechanisms,
    note_places,
    note_reserves,
    noted_if_free,
    past_untouched,
    relax_joints,
    solve_joints,
    store_joints,
    bound_joined,
    reduce_together,
    reduce_motion_as_one,
    support_joined,
    joints_disagree,
    or_joined,
    unless_joined,
    unless_tied,
    wake_tied,
    without_kept_apart,
)
