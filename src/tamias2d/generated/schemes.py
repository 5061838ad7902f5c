"""Integration schemes: one step of each.

Generated from srs/schemes/composed.md,
srs/schemes/embedded.md,
srs/schemes/euler.md,
srs/schemes/legacy.md,
srs/schemes/runge_kutta.md,
srs/schemes/verlet.md by `python -m tools.generate`. Edit the chapter, not this file.
Positions and velocities are arrays of any one shape, angles and their rates among them; an
acceleration is a function of time, position and velocity.
"""

from collections.abc import Callable
from typing import Any

Acceleration = Callable[[Any, Any, Any], Any]


def yoshida_4(
    time: Any, time_step: Any, position: Any, velocity: Any, acceleration: Acceleration
) -> tuple[Any, Any]:
    """Yoshida's fourth order, of order 4.

    Three velocity Verlet steps, of which the middle one goes back in time.

    Source: srs/schemes/composed.md:10; forest1990, yoshida1990.
    """
    velocity = (
        velocity
        + 67560359597982881702384390448573
        * time_step
        / 100000000000000000000000000000000
        * acceleration(time, position, velocity)
    )
    position = (
        position
        + 2702414383919315268095375617943 * time_step / 2000000000000000000000000000000 * velocity
    )
    velocity = (
        velocity
        + -17560359597982881702384390448573
        * time_step
        / 100000000000000000000000000000000
        * acceleration(
            time + 2702414383919315268095375617943 * time_step / 2000000000000000000000000000000,
            position,
            velocity,
        )
    )
    position = (
        position
        + -17024143839193152680953756179429
        * time_step
        / 10000000000000000000000000000000
        * velocity
    )
    velocity = (
        velocity
        + -17560359597982881702384390448573
        * time_step
        / 100000000000000000000000000000000
        * acceleration(
            time + -1756035959798288170238439044857 * time_step / 5000000000000000000000000000000,
            position,
            velocity,
        )
    )
    position = (
        position
        + 2702414383919315268095375617943 * time_step / 2000000000000000000000000000000 * velocity
    )
    velocity = (
        velocity
        + 67560359597982881702384390448573
        * time_step
        / 100000000000000000000000000000000
        * acceleration(
            time + 10000000000000000000000000000001 * time_step / 10000000000000000000000000000000,
            position,
            velocity,
        )
    )
    return position, velocity


def dormand_prince_5(
    time: Any, time_step: Any, position: Any, velocity: Any, acceleration: Acceleration
) -> tuple[Any, Any]:
    """Dormand-Prince 5(4), of order 5.

    Seven slopes, the last of which is the first of the next step; the weights of order four,
    subtracted from those of order five, give the error.

    Source: srs/schemes/embedded.md:16; dormand1980, hairer1993.
    """
    rate_1 = acceleration(time, position, velocity)
    velocity_2 = velocity + time_step / 5 * rate_1
    rate_2 = acceleration(time + time_step / 5, position + time_step / 5 * velocity, velocity_2)
    velocity_3 = velocity + time_step / 40 * (3 * rate_1 + 9 * rate_2)
    rate_3 = acceleration(
        time + 3 * time_step / 10,
        position + time_step / 40 * (3 * velocity + 9 * velocity_2),
        velocity_3,
    )
    velocity_4 = velocity + time_step / 45 * (44 * rate_1 + -168 * rate_2 + 160 * rate_3)
    rate_4 = acceleration(
        time + 4 * time_step / 5,
        position + time_step / 45 * (44 * velocity + -168 * velocity_2 + 160 * velocity_3),
        velocity_4,
    )
    velocity_5 = velocity + time_step / 6561 * (
        19372 * rate_1 + -76080 * rate_2 + 64448 * rate_3 + -1908 * rate_4
    )
    rate_5 = acceleration(
        time + 8 * time_step / 9,
        position
        + time_step
        / 6561
        * (19372 * velocity + -76080 * velocity_2 + 64448 * velocity_3 + -1908 * velocity_4),
        velocity_5,
    )
    velocity_6 = velocity + time_step / 167904 * (
        477901 * rate_1 + -1806240 * rate_2 + 1495424 * rate_3 + 46746 * rate_4 + -45927 * rate_5
    )
    rate_6 = acceleration(
        time + time_step,
        position
        + time_step
        / 167904
        * (
            477901 * velocity
            + -1806240 * velocity_2
            + 1495424 * velocity_3
            + 46746 * velocity_4
            + -45927 * velocity_5
        ),
        velocity_6,
    )
    velocity_7 = velocity + time_step / 142464 * (
        12985 * rate_1 + 64000 * rate_3 + 92750 * rate_4 + -45927 * rate_5 + 18656 * rate_6
    )
    rate_7 = acceleration(
        time + time_step,
        position
        + time_step
        / 142464
        * (
            12985 * velocity
            + 64000 * velocity_3
            + 92750 * velocity_4
            + -45927 * velocity_5
            + 18656 * velocity_6
        ),
        velocity_7,
    )
    position = position + time_step / 142464 * (
        12985 * velocity
        + 64000 * velocity_3
        + 92750 * velocity_4
        + -45927 * velocity_5
        + 18656 * velocity_6
    )
    velocity = velocity + time_step / 142464 * (
        12985 * rate_1 + 64000 * rate_3 + 92750 * rate_4 + -45927 * rate_5 + 18656 * rate_6
    )
    return position, velocity


def dop853(
    time: Any, time_step: Any, position: Any, velocity: Any, acceleration: Acceleration
) -> tuple[Any, Any]:
    """Dormand-Prince 8(5,3), of order 8.

    Twelve slopes for a step of order eight; an error of order five that one of order three
    corrects.

    Source: srs/schemes/embedded.md:58; hairer1993.
    """
    rate_1 = acceleration(time, position, velocity)
    velocity_2 = (
        velocity
        + time_step / 1250000000000000000000000000000 * 65750189948459664848198443061 * rate_1
    )
    rate_2 = acceleration(
        time + 65750189948459664848198443061 * time_step / 1250000000000000000000000000000,
        position
        + time_step / 1250000000000000000000000000000 * 65750189948459664848198443061 * velocity,
        velocity_2,
    )
    velocity_3 = velocity + time_step / 10000000000000000000000000000000 * (
        197250569845378994544595329183 * rate_1 + 591751709536136983633785987549 * rate_2
    )
    rate_3 = acceleration(
        time + 197250569845378994544595329183 * time_step / 2500000000000000000000000000000,
        position
        + time_step
        / 10000000000000000000000000000000
        * (197250569845378994544595329183 * velocity + 591751709536136983633785987549 * velocity_2),
        velocity_3,
    )
    velocity_4 = velocity + time_step / 10000000000000000000000000000000 * (
        295875854768068491816892993775 * rate_1 + 887627564304205475450678981324 * rate_3
    )
    rate_4 = acceleration(
        time + 11835034190722739672675719751 * time_step / 100000000000000000000000000000,
        position
        + time_step
        / 10000000000000000000000000000000
        * (295875854768068491816892993775 * velocity + 887627564304205475450678981324 * velocity_3),
        velocity_4,
    )
    velocity_5 = velocity + time_step / 1000000000000000000000000000000 * (
        241365134159266685502369798665 * rate_1
        + -884549479328286085344864962717 * rate_3
        + 924834003261792003115737966543 * rate_4
    )
    rate_5 = acceleration(
        time + 28164965809277260327324280249 * time_step / 100000000000000000000000000000,
        position
        + time_step
        / 1000000000000000000000000000000
        * (
            241365134159266685502369798665 * velocity
            + -884549479328286085344864962717 * velocity_3
            + 924834003261792003115737966543 * velocity_4
        ),
        velocity_5,
    )
    velocity_6 = velocity + time_step / 1000000000000000000000000000000 * (
        37037037037037037037037037037 * rate_1
        + 170828608729473871279604482173 * rate_4
        + 125467687566822425016691814123 * rate_5
    )
    rate_6 = acceleration(
        time + 333333333333333333333333333333 * time_step / 1000000000000000000000000000000,
        position
        + time_step
        / 1000000000000000000000000000000
        * (
            37037037037037037037037037037 * velocity
            + 170828608729473871279604482173 * velocity_4
            + 125467687566822425016691814123 * velocity_5
        ),
        velocity_6,
    )
    velocity_7 = velocity + time_step / 10000000000000000000000000000000 * (
        371093750000000000000000000000 * rate_1
        + 1702522110195440393149780602720 * rate_4
        + 602165389804559606850219397283 * rate_5
        + -175781250000000000000000000000 * rate_6
    )
    rate_7 = acceleration(
        time + time_step / 4,
        position
        + time_step
        / 10000000000000000000000000000000
        * (
            371093750000000000000000000000 * velocity
            + 1702522110195440393149780602720 * velocity_4
            + 602165389804559606850219397283 * velocity_5
            + -175781250000000000000000000000 * velocity_6
        ),
        velocity_7,
    )
    velocity_8 = velocity + time_step / 50000000000000000000000000000000 * (
        1854600005925239635543896599180 * rate_1
        + 8519196285611999690510702735250 * rate_4
        + 5363101522318664232590459958400 * rate_5
        + -765971887431220087639680791180 * rate_6
        + 413689458190701144379236883001 * rate_7
    )
    rate_8 = acceleration(
        time + 76923076923076923076923076923 * time_step / 250000000000000000000000000000,
        position
        + time_step
        / 50000000000000000000000000000000
        * (
            1854600005925239635543896599180 * velocity
            + 8519196285611999690510702735250 * velocity_4
            + 5363101522318664232590459958400 * velocity_5
            + -765971887431220087639680791180 * velocity_6
            + 413689458190701144379236883001 * velocity_7
        ),
        velocity_8,
    )
    velocity_9 = velocity + time_step / 1000000000000000000000000000000 * (
        624110958716075717114429577812 * rate_1
        + -3360892629446941294068571098250 * rate_4
        + -868219346841726006818189891453 * rate_5
        + 27592099699446708304941560079700 * rate_6
        + 20154067550477893408618678897900 * rate_7
        + -43489884181069958847736625514400 * rate_8
    )
    rate_9 = acceleration(
        time + 325641025641025641025641025641 * time_step / 500000000000000000000000000000,
        position
        + time_step
        / 1000000000000000000000000000000
        * (
            624110958716075717114429577812 * velocity
            + -3360892629446941294068571098250 * velocity_4
            + -868219346841726006818189891453 * velocity_5
            + 27592099699446708304941560079700 * velocity_6
            + 20154067550477893408618678897900 * velocity_7
            + -43489884181069958847736625514400 * velocity_8
        ),
        velocity_9,
    )
    velocity_10 = velocity + time_step / 10000000000000000000000000000000 * (
        4776625364382643658904339085270 * rate_1
        + -24881146199716676419264258646800 * rate_4
        + -5902908268368429963714464757430 * rate_5
        + 212300514481811942347288949897000 * rate_6
        + 152792336328824235832596922938000 * rate_7
        + -332882109689848629194453265587000 * rate_8
        + -203312017085086261358222928593 * rate_9
    )
    rate_10 = acceleration(
        time + 3 * time_step / 5,
        position
        + time_step
        / 10000000000000000000000000000000
        * (
            4776625364382643658904339085270 * velocity
            + -24881146199716676419264258646800 * velocity_4
            + -5902908268368429963714464757430 * velocity_5
            + 212300514481811942347288949897000 * velocity_6
            + 152792336328824235832596922938000 * velocity_7
            + -332882109689848629194453265587000 * velocity_8
            + -203312017085086261358222928593 * velocity_9
        ),
        velocity_10,
    )
    velocity_11 = velocity + time_step / 100000000000000000000000000000 * (
        -93714243008598732571704021658 * rate_1
        + 518637242884406370830023853209 * rate_4
        + 109143734899672957818500254654 * rate_5
        + -814978701074692612513997267357 * rate_6
        + -1852006565999695986415661807010 * rate_7
        + 2273948709935050428189700567340 * rate_8
        + 249360555267965238987089396762 * rate_9
        + -304676447189821950038236690220 * rate_10
    )
    rate_11 = acceleration(
        time + 428571428571428571428571428571 * time_step / 500000000000000000000000000000,
        position
        + time_step
        / 100000000000000000000000000000
        * (
            -93714243008598732571704021658 * velocity
            + 518637242884406370830023853209 * velocity_4
            + 109143734899672957818500254654 * velocity_5
            + -814978701074692612513997267357 * velocity_6
            + -1852006565999695986415661807010 * velocity_7
            + 2273948709935050428189700567340 * velocity_8
            + 249360555267965238987089396762 * velocity_9
            + -304676447189821950038236690220 * velocity_10
        ),
        velocity_11,
    )
    velocity_12 = velocity + time_step / 500000000000000000000000000000 * (
        1136655073758269103961798842245 * rate_1
        + -5267247733368625099203334493950 * rate_4
        + -1000436029112431249548378592220 * rate_5
        + -8979465931559399458638297526700 * rate_6
        + 13974442264709980025424990441850 * rate_7
        + -1429499138567511847370327543370 * rate_8
        + -4436428466765314772167746446290 * rate_9
        + 6180283587897151532363310076400 * rate_10
        + 321696373007881765177985242023 * rate_11
    )
    rate_12 = acceleration(
        time + time_step,
        position
        + time_step
        / 500000000000000000000000000000
        * (
            1136655073758269103961798842245 * velocity
            + -5267247733368625099203334493950 * velocity_4
            + -1000436029112431249548378592220 * velocity_5
            + -8979465931559399458638297526700 * velocity_6
            + 13974442264709980025424990441850 * velocity_7
            + -1429499138567511847370327543370 * velocity_8
            + -4436428466765314772167746446290 * velocity_9
            + 6180283587897151532363310076400 * velocity_10
            + 321696373007881765177985242023 * velocity_11
        ),
        velocity_12,
    )
    velocity_13 = velocity + time_step / 10000000000000000000000000000000 * (
        542937341165687622380535766363 * rate_1
        + 44503128927524088814411395056600 * rate_6
        + 18915178993145003830428159904400 * rate_7
        + -58012039600105847814672114227000 * rate_8
        + 3111643669578198944089160623700 * rate_9
        + -1521609496625160785561788068050 * rate_10
        + 2013654008040303483747765375010 * rate_11
        + 447106157277725905176885569043 * rate_12
    )
    rate_13 = acceleration(
        time + time_step,
        position
        + time_step
        / 10000000000000000000000000000000
        * (
            542937341165687622380535766363 * velocity
            + 44503128927524088814411395056600 * velocity_6
            + 18915178993145003830428159904400 * velocity_7
            + -58012039600105847814672114227000 * velocity_8
            + 3111643669578198944089160623700 * velocity_9
            + -1521609496625160785561788068050 * velocity_10
            + 2013654008040303483747765375010 * velocity_11
            + 447106157277725905176885569043 * velocity_12
        ),
        velocity_13,
    )
    velocity_14 = velocity + time_step / 100000000000000000000000000000000 * (
        5616750228304795233929092196810 * rate_1
        + 25350021021662481108879476533300 * rate_7
        + -24623903747080248991744147544100 * rate_8
        + -12419142326381636046901014062600 * rate_9
        + 15329179827876569731206322685000 * rate_10
        + 820105229563468988491666602057 * rate_11
        + 756789766054569976138603589584 * rate_12
        + -829800000000000000000000000000 * rate_13
    )
    rate_14 = acceleration(
        time + time_step / 10,
        position
        + time_step
        / 100000000000000000000000000000000
        * (
            5616750228304795233929092196810 * velocity
            + 25350021021662481108879476533300 * velocity_7
            + -24623903747080248991744147544100 * velocity_8
            + -12419142326381636046901014062600 * velocity_9
            + 15329179827876569731206322685000 * velocity_10
            + 820105229563468988491666602057 * velocity_11
            + 756789766054569976138603589584 * velocity_12
            + -829800000000000000000000000000 * velocity_13
        ),
        velocity_14,
    )
    velocity_15 = velocity + time_step / 1000000000000000000000000000000000 * (
        31834648163502140506076847326100 * rate_1
        + 28300909672366775528832296140200 * rate_6
        + 53541988307438567622379738437200 * rate_7
        + -54923748571390988464656934030600 * rate_8
        + -108347328697249322858509316994 * rate_11
        + 382571090835658412954920192323 * rate_12
        + -340465008687404560802977114492 * rate_13
        + 141312443674632500278074618366000 * rate_14
    )
    rate_15 = acceleration(
        time + time_step / 5,
        position
        + time_step
        / 1000000000000000000000000000000000
        * (
            31834648163502140506076847326100 * velocity
            + 28300909672366775528832296140200 * velocity_6
            + 53541988307438567622379738437200 * velocity_7
            + -54923748571390988464656934030600 * velocity_8
            + -108347328697249322858509316994 * velocity_11
            + 382571090835658412954920192323 * velocity_12
            + -340465008687404560802977114492 * velocity_13
            + 141312443674632500278074618366000 * velocity_14
        ),
        velocity_15,
    )
    velocity_16 = velocity + time_step / 50000000000000000000000000000000 * (
        -21444815079189596170428676934600 * rate_1
        + -234881070768058192157224723603000 * rate_6
        + 384171059803129952092120476939000 * rate_7
        + 203449490919855503985106777165500 * rate_8
        + 17836359372764055463533477151050 * rate_9
        + -69951208257950731064709004867 * rate_13
        + 147375739457638616947781360745000 * rate_14
        + -457547923608993500540935093569000 * rate_15
    )
    rate_16 = acceleration(
        time + 388888888888888888888888888889 * time_step / 500000000000000000000000000000,
        position
        + time_step
        / 50000000000000000000000000000000
        * (
            -21444815079189596170428676934600 * velocity
            + -234881070768058192157224723603000 * velocity_6
            + 384171059803129952092120476939000 * velocity_7
            + 203449490919855503985106777165500 * velocity_8
            + 17836359372764055463533477151050 * velocity_9
            + -69951208257950731064709004867 * velocity_13
            + 147375739457638616947781360745000 * velocity_14
            + -457547923608993500540935093569000 * velocity_15
        ),
        velocity_16,
    )
    position = position + time_step / 10000000000000000000000000000000 * (
        542937341165687622380535766363 * velocity
        + 44503128927524088814411395056600 * velocity_6
        + 18915178993145003830428159904400 * velocity_7
        + -58012039600105847814672114227000 * velocity_8
        + 3111643669578198944089160623700 * velocity_9
        + -1521609496625160785561788068050 * velocity_10
        + 2013654008040303483747765375010 * velocity_11
        + 447106157277725905176885569043 * velocity_12
    )
    velocity = velocity + time_step / 10000000000000000000000000000000 * (
        542937341165687622380535766363 * rate_1
        + 44503128927524088814411395056600 * rate_6
        + 18915178993145003830428159904400 * rate_7
        + -58012039600105847814672114227000 * rate_8
        + 3111643669578198944089160623700 * rate_9
        + -1521609496625160785561788068050 * rate_10
        + 2013654008040303483747765375010 * rate_11
        + 447106157277725905176885569043 * rate_12
    )
    return position, velocity


def explicit_euler(
    time: Any, time_step: Any, position: Any, velocity: Any, acceleration: Acceleration
) -> tuple[Any, Any]:
    """Explicit Euler, of order 1.

    Position and velocity both move along the slopes of the step's beginning.

    Source: srs/schemes/euler.md:22; hairer1993.
    """
    rate_1 = acceleration(time, position, velocity)
    position = position + time_step * velocity
    velocity = velocity + time_step * rate_1
    return position, velocity


def semi_implicit_euler(
    time: Any, time_step: Any, position: Any, velocity: Any, acceleration: Acceleration
) -> tuple[Any, Any]:
    """Semi-implicit Euler, of order 1.

    The velocity takes a full kick, then the position drifts with the velocity that results.

    Source: srs/schemes/euler.md:47; hairer2006.
    """
    velocity = velocity + time_step * acceleration(time, position, velocity)
    position = position + time_step * velocity
    return position, velocity


def legacy_2018_translation(
    time_step: Any, position: Any, velocity: Any, previous: Any, current: Any
) -> tuple[Any, Any]:
    """Translation in the program of 2018, of order 0.

    The position moves with half the velocity and with the acceleration of the step before; the
    velocity with the mean of the accelerations before and now.

    Source: srs/schemes/legacy.md:19; tamias2018.
    """
    return (
        position + time_step / 2 * velocity + time_step * time_step / 2 * previous,
        velocity + time_step / 2 * previous + time_step / 2 * current,
    )


def legacy_2018_rotation(
    time_step: Any, position: Any, velocity: Any, previous: Any, current: Any
) -> tuple[Any, Any]:
    """Rotation in the program of 2018, of order 1.

    The orientation moves with the full angular velocity and with the angular acceleration of
    the step before; the angular velocity with the one of now.

    Source: srs/schemes/legacy.md:35; tamias2018.
    """
    return (
        position + time_step * velocity + time_step * time_step / 2 * previous,
        velocity + time_step * current,
    )


def runge_kutta_4(
    time: Any, time_step: Any, position: Any, velocity: Any, acceleration: Acceleration
) -> tuple[Any, Any]:
    """Classical Runge-Kutta, of order 4.

    Four slopes, one at the beginning, two in the middle and one at the end of the step,
    averaged with the weights of Simpson's rule.

    Source: srs/schemes/runge_kutta.md:8; kutta1901, hairer1993.
    """
    rate_1 = acceleration(time, position, velocity)
    velocity_2 = velocity + time_step / 2 * rate_1
    rate_2 = acceleration(time + time_step / 2, position + time_step / 2 * velocity, velocity_2)
    velocity_3 = velocity + time_step / 2 * rate_2
    rate_3 = acceleration(time + time_step / 2, position + time_step / 2 * velocity_2, velocity_3)
    velocity_4 = velocity + time_step * rate_3
    rate_4 = acceleration(time + time_step, position + time_step * velocity_3, velocity_4)
    position = position + time_step / 6 * (velocity + 2 * velocity_2 + 2 * velocity_3 + velocity_4)
    velocity = velocity + time_step / 6 * (rate_1 + 2 * rate_2 + 2 * rate_3 + rate_4)
    return position, velocity


def velocity_verlet(
    time: Any, time_step: Any, position: Any, velocity: Any, acceleration: Acceleration
) -> tuple[Any, Any]:
    """Velocity Verlet, of order 2.

    Half a kick with the force at the step's beginning, a full drift, half a kick with the force
    at its end.

    Source: srs/schemes/verlet.md:7; verlet1967, hairer2006.
    """
    velocity = velocity + time_step / 2 * acceleration(time, position, velocity)
    position = position + time_step * velocity
    velocity = velocity + time_step / 2 * acceleration(time + time_step, position, velocity)
    return position, velocity
