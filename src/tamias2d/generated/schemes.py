"""Integration schemes: one step of each.

Generated from srs/schemes/composed.md,
srs/schemes/embedded.md,
srs/schemes/euler.md,
srs/schemes/exponential.md,
srs/schemes/legacy.md,
srs/schemes/runge_kutta.md,
srs/schemes/verlet.md by `python -m tools.generate`. Edit the chapter, not this file.
Positions and velocities are arrays of any one shape, angles and their rates among them; an
acceleration is a function of time, position and velocity.
"""

from collections.abc import Callable
from typing import Any, NamedTuple

Acceleration = Callable[[Any, Any, Any], Any]
Drift = Callable[[Any, Any, Any, Any], tuple[Any, Any]]
"""From time, time step, position and velocity to both after motion under a part of the forces."""


class Facts(NamedTuple):
    """What is known of a scheme before it runs."""

    order: int
    symplectic: bool
    oscillation: float
    """Longest stable step, times the angular frequency."""
    decay: float
    """Longest stable step, times the rate of the decay."""
    evaluations: int
    """Of the accelerations in a step."""


class Pair(NamedTuple):
    """A step that knows its error.

    `position_errors` and `velocity_errors` have one estimate for each lower order, the highest
    first. Where a share x of the step has passed, the velocity is that at the start plus the
    time step times the sum of `dense[k]` times the power k + 1 of x.
    """

    position: Any
    velocity: Any
    position_errors: tuple[Any, ...]
    velocity_errors: tuple[Any, ...]
    dense: tuple[Any, ...]


Weighted = tuple[float, tuple[tuple[int, float], ...]]
"""A divisor of the time step, and the slopes that are summed, each with its weight."""


class RungeKutta(NamedTuple):
    """A scheme of slopes, as numbers: what its function says, for code that loops over them."""

    moments: tuple[tuple[float, float], ...]
    """Of each slope: a factor of the time step, and a divisor."""
    stages: tuple[Weighted, ...]
    """What each slope but the first is taken from."""
    end: Weighted
    errors: tuple[Weighted, ...]
    dense: tuple[Weighted, ...]


class Splitting(NamedTuple):
    """A scheme of kicks and drifts, as numbers, likewise."""

    parts: tuple[tuple[bool, float, float, float, float], ...]
    """In order: whether it is a kick; factor and divisor of the time step for its length, and for
    the time that has passed before it."""


def yoshida_4(
    time: Any, time_step: Any, position: Any, velocity: Any, acceleration: Acceleration
) -> tuple[Any, Any]:
    """Yoshida's fourth order, of order 4.

    Three velocity Verlet steps, of which the middle one goes back in time.

    Source: srs/schemes/composed.md:10; forest1990, yoshida1990.
    """
    velocity = velocity + 0.6756035959798288 * time_step * acceleration(time, position, velocity)
    position = position + 1.3512071919596575 * time_step * velocity
    velocity = velocity + -0.17560359597982883 * time_step * acceleration(
        time + 1.3512071919596575 * time_step, position, velocity
    )
    position = position + -1.7024143839193153 * time_step * velocity
    velocity = velocity + -0.17560359597982883 * time_step * acceleration(
        time + -0.35120719195965766 * time_step, position, velocity
    )
    position = position + 1.3512071919596575 * time_step * velocity
    velocity = velocity + 0.6756035959798288 * time_step * acceleration(
        time + 1.0 * time_step, position, velocity
    )
    return position, velocity


def dormand_prince_5(
    time: Any, time_step: Any, position: Any, velocity: Any, acceleration: Acceleration
) -> Pair:
    """Dormand-Prince 5(4), of order 5.

    Seven slopes, the last of which is the first of the next step; the weights of order four,
    subtracted from those of order five, give the error.

    Source: srs/schemes/embedded.md:17; dormand1980, hairer1993.
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
    velocity_4 = velocity + time_step / 45 * (44 * rate_1 - 168 * rate_2 + 160 * rate_3)
    rate_4 = acceleration(
        time + 4 * time_step / 5,
        position + time_step / 45 * (44 * velocity - 168 * velocity_2 + 160 * velocity_3),
        velocity_4,
    )
    velocity_5 = velocity + time_step / 6561 * (
        19372 * rate_1 - 76080 * rate_2 + 64448 * rate_3 - 1908 * rate_4
    )
    rate_5 = acceleration(
        time + 8 * time_step / 9,
        position
        + time_step
        / 6561
        * (19372 * velocity - 76080 * velocity_2 + 64448 * velocity_3 - 1908 * velocity_4),
        velocity_5,
    )
    velocity_6 = velocity + time_step / 167904 * (
        477901 * rate_1 - 1806240 * rate_2 + 1495424 * rate_3 + 46746 * rate_4 - 45927 * rate_5
    )
    rate_6 = acceleration(
        time + time_step,
        position
        + time_step
        / 167904
        * (
            477901 * velocity
            - 1806240 * velocity_2
            + 1495424 * velocity_3
            + 46746 * velocity_4
            - 45927 * velocity_5
        ),
        velocity_6,
    )
    velocity_7 = velocity + time_step / 142464 * (
        12985 * rate_1 + 64000 * rate_3 + 92750 * rate_4 - 45927 * rate_5 + 18656 * rate_6
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
            - 45927 * velocity_5
            + 18656 * velocity_6
        ),
        velocity_7,
    )
    position_end = position + time_step / 142464 * (
        12985 * velocity
        + 64000 * velocity_3
        + 92750 * velocity_4
        - 45927 * velocity_5
        + 18656 * velocity_6
    )
    velocity_end = velocity + time_step / 142464 * (
        12985 * rate_1 + 64000 * rate_3 + 92750 * rate_4 - 45927 * rate_5 + 18656 * rate_6
    )
    return Pair(
        position_end,
        velocity_end,
        (
            time_step
            / 21369600
            * (
                -26341 * velocity
                + 90880 * velocity_3
                - 790230 * velocity_4
                + 1086939 * velocity_5
                - 895488 * velocity_6
                + 534240 * velocity_7
            ),
        ),
        (
            time_step
            / 21369600
            * (
                -26341 * rate_1
                + 90880 * rate_3
                - 790230 * rate_4
                + 1086939 * rate_5
                - 895488 * rate_6
                + 534240 * rate_7
            ),
        ),
        (
            rate_1,
            -2.8535800653862835 * rate_1
            + 4.023133379230305 * rate_3
            - 3.7324019615885042 * rate_4
            + 2.5548038301849423 * rate_5
            - 1.3744241142186024 * rate_6
            + 1.3824689317781436 * rate_7,
            3.0717434641059005 * rate_1
            - 6.249321565289 * rate_3
            + 10.068970589843675 * rate_4
            - 6.399112377351017 * rate_5
            + 3.272657752246729 * rate_6
            - 3.764937863556287 * rate_7,
            -1.1270175653862835 * rate_1
            + 2.675424484351598 * rate_3
            - 5.685526961588504 * rate_4
            + 3.5219323679207912 * rate_5
            - 1.7672812570757455 * rate_6
            + 2.382468931778144 * rate_7,
        ),
    )


def dop853(
    time: Any, time_step: Any, position: Any, velocity: Any, acceleration: Acceleration
) -> Pair:
    """Dormand-Prince 8(5,3), of order 8.

    Twelve slopes for a step of order eight; an error of order five that one of order three
    corrects.

    Source: srs/schemes/embedded.md:60; hairer1993.
    """
    rate_1 = acceleration(time, position, velocity)
    velocity_2 = velocity + time_step * (0.05260015195876773 * rate_1)
    rate_2 = acceleration(
        time + 0.05260015195876773 * time_step,
        position + time_step * (0.05260015195876773 * velocity),
        velocity_2,
    )
    velocity_3 = velocity + time_step * (0.0197250569845379 * rate_1 + 0.0591751709536137 * rate_2)
    rate_3 = acceleration(
        time + 0.0789002279381516 * time_step,
        position + time_step * (0.0197250569845379 * velocity + 0.0591751709536137 * velocity_2),
        velocity_3,
    )
    velocity_4 = velocity + time_step * (
        0.02958758547680685 * rate_1 + 0.08876275643042054 * rate_3
    )
    rate_4 = acceleration(
        time + 0.1183503419072274 * time_step,
        position + time_step * (0.02958758547680685 * velocity + 0.08876275643042054 * velocity_3),
        velocity_4,
    )
    velocity_5 = velocity + time_step * (
        0.2413651341592667 * rate_1 - 0.8845494793282861 * rate_3 + 0.924834003261792 * rate_4
    )
    rate_5 = acceleration(
        time + 0.2816496580927726 * time_step,
        position
        + time_step
        * (
            0.2413651341592667 * velocity
            - 0.8845494793282861 * velocity_3
            + 0.924834003261792 * velocity_4
        ),
        velocity_5,
    )
    velocity_6 = velocity + time_step * (
        0.037037037037037035 * rate_1 + 0.17082860872947386 * rate_4 + 0.12546768756682242 * rate_5
    )
    rate_6 = acceleration(
        time + 0.3333333333333333 * time_step,
        position
        + time_step
        * (
            0.037037037037037035 * velocity
            + 0.17082860872947386 * velocity_4
            + 0.12546768756682242 * velocity_5
        ),
        velocity_6,
    )
    velocity_7 = velocity + time_step * (
        0.037109375 * rate_1
        + 0.17025221101954405 * rate_4
        + 0.06021653898045596 * rate_5
        - 0.017578125 * rate_6
    )
    rate_7 = acceleration(
        time + time_step / 4,
        position
        + time_step
        * (
            0.037109375 * velocity
            + 0.17025221101954405 * velocity_4
            + 0.06021653898045596 * velocity_5
            - 0.017578125 * velocity_6
        ),
        velocity_7,
    )
    velocity_8 = velocity + time_step * (
        0.03709200011850479 * rate_1
        + 0.17038392571223998 * rate_4
        + 0.10726203044637328 * rate_5
        - 0.015319437748624402 * rate_6
        + 0.008273789163814023 * rate_7
    )
    rate_8 = acceleration(
        time + 0.3076923076923077 * time_step,
        position
        + time_step
        * (
            0.03709200011850479 * velocity
            + 0.17038392571223998 * velocity_4
            + 0.10726203044637328 * velocity_5
            - 0.015319437748624402 * velocity_6
            + 0.008273789163814023 * velocity_7
        ),
        velocity_8,
    )
    velocity_9 = velocity + time_step * (
        0.6241109587160757 * rate_1
        - 3.3608926294469414 * rate_4
        - 0.868219346841726 * rate_5
        + 27.59209969944671 * rate_6
        + 20.154067550477894 * rate_7
        - 43.48988418106996 * rate_8
    )
    rate_9 = acceleration(
        time + 0.6512820512820513 * time_step,
        position
        + time_step
        * (
            0.6241109587160757 * velocity
            - 3.3608926294469414 * velocity_4
            - 0.868219346841726 * velocity_5
            + 27.59209969944671 * velocity_6
            + 20.154067550477894 * velocity_7
            - 43.48988418106996 * velocity_8
        ),
        velocity_9,
    )
    velocity_10 = velocity + time_step * (
        0.47766253643826434 * rate_1
        - 2.4881146199716677 * rate_4
        - 0.590290826836843 * rate_5
        + 21.230051448181193 * rate_6
        + 15.279233632882423 * rate_7
        - 33.28821096898486 * rate_8
        - 0.020331201708508627 * rate_9
    )
    rate_10 = acceleration(
        time + 3 * time_step / 5,
        position
        + time_step
        * (
            0.47766253643826434 * velocity
            - 2.4881146199716677 * velocity_4
            - 0.590290826836843 * velocity_5
            + 21.230051448181193 * velocity_6
            + 15.279233632882423 * velocity_7
            - 33.28821096898486 * velocity_8
            - 0.020331201708508627 * velocity_9
        ),
        velocity_10,
    )
    velocity_11 = velocity + time_step * (
        -0.9371424300859873 * rate_1
        + 5.186372428844064 * rate_4
        + 1.0914373489967295 * rate_5
        - 8.149787010746927 * rate_6
        - 18.52006565999696 * rate_7
        + 22.739487099350505 * rate_8
        + 2.4936055526796523 * rate_9
        - 3.0467644718982196 * rate_10
    )
    rate_11 = acceleration(
        time + 0.8571428571428571 * time_step,
        position
        + time_step
        * (
            -0.9371424300859873 * velocity
            + 5.186372428844064 * velocity_4
            + 1.0914373489967295 * velocity_5
            - 8.149787010746927 * velocity_6
            - 18.52006565999696 * velocity_7
            + 22.739487099350505 * velocity_8
            + 2.4936055526796523 * velocity_9
            - 3.0467644718982196 * velocity_10
        ),
        velocity_11,
    )
    velocity_12 = velocity + time_step * (
        2.273310147516538 * rate_1
        - 10.53449546673725 * rate_4
        - 2.0008720582248625 * rate_5
        - 17.9589318631188 * rate_6
        + 27.94888452941996 * rate_7
        - 2.8589982771350235 * rate_8
        - 8.87285693353063 * rate_9
        + 12.360567175794303 * rate_10
        + 0.6433927460157636 * rate_11
    )
    rate_12 = acceleration(
        time + time_step,
        position
        + time_step
        * (
            2.273310147516538 * velocity
            - 10.53449546673725 * velocity_4
            - 2.0008720582248625 * velocity_5
            - 17.9589318631188 * velocity_6
            + 27.94888452941996 * velocity_7
            - 2.8589982771350235 * velocity_8
            - 8.87285693353063 * velocity_9
            + 12.360567175794303 * velocity_10
            + 0.6433927460157636 * velocity_11
        ),
        velocity_12,
    )
    velocity_13 = velocity + time_step * (
        0.054293734116568765 * rate_1
        + 4.450312892752409 * rate_6
        + 1.8915178993145003 * rate_7
        - 5.801203960010585 * rate_8
        + 0.3111643669578199 * rate_9
        - 0.1521609496625161 * rate_10
        + 0.20136540080403034 * rate_11
        + 0.04471061572777259 * rate_12
    )
    rate_13 = acceleration(
        time + time_step,
        position
        + time_step
        * (
            0.054293734116568765 * velocity
            + 4.450312892752409 * velocity_6
            + 1.8915178993145003 * velocity_7
            - 5.801203960010585 * velocity_8
            + 0.3111643669578199 * velocity_9
            - 0.1521609496625161 * velocity_10
            + 0.20136540080403034 * velocity_11
            + 0.04471061572777259 * velocity_12
        ),
        velocity_13,
    )
    velocity_14 = velocity + time_step * (
        0.056167502283047954 * rate_1
        + 0.25350021021662483 * rate_7
        - 0.2462390374708025 * rate_8
        - 0.12419142326381637 * rate_9
        + 0.15329179827876568 * rate_10
        + 0.00820105229563469 * rate_11
        + 0.007567897660545699 * rate_12
        - 0.008298 * rate_13
    )
    rate_14 = acceleration(
        time + time_step / 10,
        position
        + time_step
        * (
            0.056167502283047954 * velocity
            + 0.25350021021662483 * velocity_7
            - 0.2462390374708025 * velocity_8
            - 0.12419142326381637 * velocity_9
            + 0.15329179827876568 * velocity_10
            + 0.00820105229563469 * velocity_11
            + 0.007567897660545699 * velocity_12
            - 0.008298 * velocity_13
        ),
        velocity_14,
    )
    velocity_15 = velocity + time_step * (
        0.03183464816350214 * rate_1
        + 0.028300909672366776 * rate_6
        + 0.053541988307438566 * rate_7
        - 0.05492374857139099 * rate_8
        - 0.00010834732869724932 * rate_11
        + 0.0003825710908356584 * rate_12
        - 0.00034046500868740456 * rate_13
        + 0.1413124436746325 * rate_14
    )
    rate_15 = acceleration(
        time + time_step / 5,
        position
        + time_step
        * (
            0.03183464816350214 * velocity
            + 0.028300909672366776 * velocity_6
            + 0.053541988307438566 * velocity_7
            - 0.05492374857139099 * velocity_8
            - 0.00010834732869724932 * velocity_11
            + 0.0003825710908356584 * velocity_12
            - 0.00034046500868740456 * velocity_13
            + 0.1413124436746325 * velocity_14
        ),
        velocity_15,
    )
    velocity_16 = velocity + time_step * (
        -0.42889630158379194 * rate_1
        - 4.697621415361164 * rate_6
        + 7.683421196062599 * rate_7
        + 4.06898981839711 * rate_8
        + 0.3567271874552811 * rate_9
        - 0.0013990241651590145 * rate_13
        + 2.9475147891527724 * rate_14
        - 9.15095847217987 * rate_15
    )
    rate_16 = acceleration(
        time + 0.7777777777777778 * time_step,
        position
        + time_step
        * (
            -0.42889630158379194 * velocity
            - 4.697621415361164 * velocity_6
            + 7.683421196062599 * velocity_7
            + 4.06898981839711 * velocity_8
            + 0.3567271874552811 * velocity_9
            - 0.0013990241651590145 * velocity_13
            + 2.9475147891527724 * velocity_14
            - 9.15095847217987 * velocity_15
        ),
        velocity_16,
    )
    position_end = position + time_step * (
        0.054293734116568765 * velocity
        + 4.450312892752409 * velocity_6
        + 1.8915178993145003 * velocity_7
        - 5.801203960010585 * velocity_8
        + 0.3111643669578199 * velocity_9
        - 0.1521609496625161 * velocity_10
        + 0.20136540080403034 * velocity_11
        + 0.04471061572777259 * velocity_12
    )
    velocity_end = velocity + time_step * (
        0.054293734116568765 * rate_1
        + 4.450312892752409 * rate_6
        + 1.8915178993145003 * rate_7
        - 5.801203960010585 * rate_8
        + 0.3111643669578199 * rate_9
        - 0.1521609496625161 * rate_10
        + 0.20136540080403034 * rate_11
        + 0.04471061572777259 * rate_12
    )
    return Pair(
        position_end,
        velocity_end,
        (
            time_step
            * (
                0.01312004499419488 * velocity
                - 1.2251564463762044 * velocity_6
                - 0.4957589496572502 * velocity_7
                + 1.6643771824549864 * velocity_8
                - 0.35032884874997366 * velocity_9
                + 0.3341791187130175 * velocity_10
                + 0.08192320648511571 * velocity_11
                - 0.022355307863886294 * velocity_12
            ),
            time_step
            * (
                -0.18980075407240762 * velocity
                + 4.450312892752409 * velocity_6
                + 1.8915178993145003 * velocity_7
                - 5.801203960010585 * velocity_8
                - 0.42268232132379197 * velocity_9
                - 0.1521609496625161 * velocity_10
                + 0.20136540080403034 * velocity_11
                + 0.022651792198360825 * velocity_12
            ),
        ),
        (
            time_step
            * (
                0.01312004499419488 * rate_1
                - 1.2251564463762044 * rate_6
                - 0.4957589496572502 * rate_7
                + 1.6643771824549864 * rate_8
                - 0.35032884874997366 * rate_9
                + 0.3341791187130175 * rate_10
                + 0.08192320648511571 * rate_11
                - 0.022355307863886294 * rate_12
            ),
            time_step
            * (
                -0.18980075407240762 * rate_1
                + 4.450312892752409 * rate_6
                + 1.8915178993145003 * rate_7
                - 5.801203960010585 * rate_8
                - 0.42268232132379197 * rate_9
                - 0.1521609496625161 * rate_10
                + 0.20136540080403034 * rate_11
                + 0.022651792198360825 * rate_12
            ),
        ),
        (
            rate_1,
            -10.266057073759306 * rate_1
            + 13.917653631776604 * rate_6
            + 2.6056037519936095 * rate_7
            - 15.018944223519684 * rate_8
            + 3.050527683318488 * rate_9
            - 1.3278744327655212 * rate_10
            + 2.844533632672879 * rate_11
            + 0.7657106259527866 * rate_12
            - 1.0889903364513334 * rate_13
            + 18.148505520854727 * rate_14
            - 9.194632392478356 * rate_15
            - 4.436036387594894 * rate_16,
            48.161850968566455 * rate_1
            - 154.78787266663716 * rate_6
            - 21.622822384626506 * rate_7
            + 160.09447708973047 * rate_8
            - 38.54396729189063 * rate_9
            + 16.661770430049543 * rate_10
            - 36.55829548991012 * rate_11
            - 9.906995535619366 * rate_12
            + 14.097013042320002 * rate_13
            - 127.63310949253875 * rate_14
            + 93.3567459327894 * rate_15
            + 56.68120539776666 * rate_16,
            -114.93304874997833 * rate_1
            + 522.9219089608218 * rate_6
            + 2.535182028966755 * rate_7
            - 474.3071826037644 * rate_8
            + 174.47140009219885 * rate_9
            - 74.44027814126304 * rate_10
            + 170.69007169147514 * rate_11
            + 46.8029919188744 * rate_12
            - 66.68230591294363 * rate_13
            + 357.3419516129657 * rate_14
            - 282.6272618704363 * rate_15
            - 261.77342902691703 * rate_16,
            147.46446875669767 * rate_1
            - 456.25918840208783 * rate_6
            + 292.25417465990404 * rate_7
            + 135.96036916173838 * rate_8
            - 337.0513470238771 * rate_9
            + 140.75210016191608 * rate_10
            - 345.9748485480496 * rate_11
            - 96.5198694669957 * rate_12
            + 137.96299063474376 * rate_13
            - 500.7031507909224 * rate_14
            + 361.14007718803333 * rate_15
            + 520.9742236688993 * rate_16,
            -97.06685363011368 * rate_1
            - 75.53193732135753 * rate_6
            - 505.40999933296894 * rate_7
            + 545.1091945264187 * rate_8
            + 291.78987509083254 * rate_9
            - 119.2562021040512 * rate_10
            + 313.299553623578 * rate_11
            + 88.74316650017616 * rate_12
            - 127.82216401767992 * rate_13
            + 349.17035710882897 * rate_14
            - 201.85219053352347 * rate_15
            - 461.17279991013964 * rate_16,
            25.69393346270375 * rate_1
            + 154.18974869023643 * rate_6
            + 231.5293791760455 * rate_7
            - 357.6391179106141 * rate_8
            - 93.40532418362432 * rate_9
            + 37.45832313645163 * rate_10
            - 104.0996495089623 * rate_11
            - 29.8402934266605 * rate_12
            + 43.53345659001114 * rate_13
            - 96.32455395918828 * rate_14
            + 39.17726167561544 * rate_15
            + 149.72683625798564 * rate_16,
        ),
    )


def explicit_euler(
    time: Any, time_step: Any, position: Any, velocity: Any, acceleration: Acceleration
) -> tuple[Any, Any]:
    """Explicit Euler, of order 1.

    Position and velocity both move along the slopes of the step's beginning.

    Source: srs/schemes/euler.md:30; hairer1993.
    """
    rate_1 = acceleration(time, position, velocity)
    position_end = position + time_step * velocity
    velocity_end = velocity + time_step * rate_1
    return position_end, velocity_end


def semi_implicit_euler(
    time: Any, time_step: Any, position: Any, velocity: Any, acceleration: Acceleration
) -> tuple[Any, Any]:
    """Semi-implicit Euler, of order 1.

    The velocity takes a full kick, then the position drifts with the velocity that results.

    Source: srs/schemes/euler.md:57; hairer2006.
    """
    velocity = velocity + time_step * acceleration(time, position, velocity)
    position = position + time_step * velocity
    return position, velocity


def exponential_verlet(
    time: Any,
    time_step: Any,
    position: Any,
    velocity: Any,
    acceleration: Acceleration,
    drift: Drift,
) -> tuple[Any, Any]:
    """Exponential Verlet, of order 2.

    Half a kick with the forces that are neither drag nor constant, an exact drift under drag
    and all constant forces, half a kick with the force at its end.

    Source: srs/schemes/exponential.md:10; strang1968, hairer2006.
    """
    velocity = velocity + time_step / 2 * acceleration(time, position, velocity)
    position, velocity = drift(time, time_step, position, velocity)
    velocity = velocity + time_step / 2 * acceleration(time + time_step, position, velocity)
    return position, velocity


def legacy_2018_translation(
    time_step: Any, position: Any, velocity: Any, previous: Any, current: Any
) -> tuple[Any, Any]:
    """Translation in the program of 2018, of order 0.

    The position moves with half the velocity and with the acceleration of the step before; the
    velocity with the mean of that and of the one of now, at the beginning of the step.

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
    the step before; the angular velocity with the one of now, at the beginning of the step.

    Source: srs/schemes/legacy.md:38; tamias2018.
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
    position_end = position + time_step / 6 * (
        velocity + 2 * velocity_2 + 2 * velocity_3 + velocity_4
    )
    velocity_end = velocity + time_step / 6 * (rate_1 + 2 * rate_2 + 2 * rate_3 + rate_4)
    return position_end, velocity_end


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


FACTS: dict[str, Facts] = {
    "yoshida_4": Facts(4, True, 1.5734, 2.5078, 4),
    "dormand_prince_5": Facts(5, False, 0.9972, 3.3066, 7),
    "dop853": Facts(8, False, 5.9604, 6.3937, 16),
    "explicit_euler": Facts(1, False, 0.0, 2.0, 1),
    "semi_implicit_euler": Facts(1, True, 2.0, 2.0, 1),
    "exponential_verlet": Facts(2, False, 2.0, 4.0, 2),
    "runge_kutta_4": Facts(4, False, 2.8284, 2.7853, 4),
    "velocity_verlet": Facts(2, True, 2.0, 4.0, 2),
}

RUNGE_KUTTA: dict[str, RungeKutta] = {
    "dormand_prince_5": RungeKutta(
        ((0, 1), (1, 5), (3, 10), (4, 5), (8, 9), (1, 1), (1, 1)),
        (
            (5, ((0, 1),)),
            (40, ((0, 3), (1, 9))),
            (45, ((0, 44), (1, -168), (2, 160))),
            (6561, ((0, 19372), (1, -76080), (2, 64448), (3, -1908))),
            (167904, ((0, 477901), (1, -1806240), (2, 1495424), (3, 46746), (4, -45927))),
            (142464, ((0, 12985), (2, 64000), (3, 92750), (4, -45927), (5, 18656))),
        ),
        (142464, ((0, 12985), (2, 64000), (3, 92750), (4, -45927), (5, 18656))),
        (
            (
                21369600,
                ((0, -26341), (2, 90880), (3, -790230), (4, 1086939), (5, -895488), (6, 534240)),
            ),
        ),
        (
            (1, ((0, 1),)),
            (
                1,
                (
                    (0, -2.8535800653862835),
                    (2, 4.023133379230305),
                    (3, -3.7324019615885042),
                    (4, 2.5548038301849423),
                    (5, -1.3744241142186024),
                    (6, 1.3824689317781436),
                ),
            ),
            (
                1,
                (
                    (0, 3.0717434641059005),
                    (2, -6.249321565289),
                    (3, 10.068970589843675),
                    (4, -6.399112377351017),
                    (5, 3.272657752246729),
                    (6, -3.764937863556287),
                ),
            ),
            (
                1,
                (
                    (0, -1.1270175653862835),
                    (2, 2.675424484351598),
                    (3, -5.685526961588504),
                    (4, 3.5219323679207912),
                    (5, -1.7672812570757455),
                    (6, 2.382468931778144),
                ),
            ),
        ),
    ),
    "dop853": RungeKutta(
        (
            (0, 1),
            (0.05260015195876773, 1),
            (0.0789002279381516, 1),
            (0.1183503419072274, 1),
            (0.2816496580927726, 1),
            (0.3333333333333333, 1),
            (1, 4),
            (0.3076923076923077, 1),
            (0.6512820512820513, 1),
            (3, 5),
            (0.8571428571428571, 1),
            (1, 1),
            (1, 1),
            (1, 10),
            (1, 5),
            (0.7777777777777778, 1),
        ),
        (
            (1, ((0, 0.05260015195876773),)),
            (1, ((0, 0.0197250569845379), (1, 0.0591751709536137))),
            (1, ((0, 0.02958758547680685), (2, 0.08876275643042054))),
            (1, ((0, 0.2413651341592667), (2, -0.8845494793282861), (3, 0.924834003261792))),
            (1, ((0, 0.037037037037037035), (3, 0.17082860872947386), (4, 0.12546768756682242))),
            (
                1,
                (
                    (0, 0.037109375),
                    (3, 0.17025221101954405),
                    (4, 0.06021653898045596),
                    (5, -0.017578125),
                ),
            ),
            (
                1,
                (
                    (0, 0.03709200011850479),
                    (3, 0.17038392571223998),
                    (4, 0.10726203044637328),
                    (5, -0.015319437748624402),
                    (6, 0.008273789163814023),
                ),
            ),
            (
                1,
                (
                    (0, 0.6241109587160757),
                    (3, -3.3608926294469414),
                    (4, -0.868219346841726),
                    (5, 27.59209969944671),
                    (6, 20.154067550477894),
                    (7, -43.48988418106996),
                ),
            ),
            (
                1,
                (
                    (0, 0.47766253643826434),
                    (3, -2.4881146199716677),
                    (4, -0.590290826836843),
                    (5, 21.230051448181193),
                    (6, 15.279233632882423),
                    (7, -33.28821096898486),
                    (8, -0.020331201708508627),
                ),
            ),
            (
                1,
                (
                    (0, -0.9371424300859873),
                    (3, 5.186372428844064),
                    (4, 1.0914373489967295),
                    (5, -8.149787010746927),
                    (6, -18.52006565999696),
                    (7, 22.739487099350505),
                    (8, 2.4936055526796523),
                    (9, -3.0467644718982196),
                ),
            ),
            (
                1,
                (
                    (0, 2.273310147516538),
                    (3, -10.53449546673725),
                    (4, -2.0008720582248625),
                    (5, -17.9589318631188),
                    (6, 27.94888452941996),
                    (7, -2.8589982771350235),
                    (8, -8.87285693353063),
                    (9, 12.360567175794303),
                    (10, 0.6433927460157636),
                ),
            ),
            (
                1,
                (
                    (0, 0.054293734116568765),
                    (5, 4.450312892752409),
                    (6, 1.8915178993145003),
                    (7, -5.801203960010585),
                    (8, 0.3111643669578199),
                    (9, -0.1521609496625161),
                    (10, 0.20136540080403034),
                    (11, 0.04471061572777259),
                ),
            ),
            (
                1,
                (
                    (0, 0.056167502283047954),
                    (6, 0.25350021021662483),
                    (7, -0.2462390374708025),
                    (8, -0.12419142326381637),
                    (9, 0.15329179827876568),
                    (10, 0.00820105229563469),
                    (11, 0.007567897660545699),
                    (12, -0.008298),
                ),
            ),
            (
                1,
                (
                    (0, 0.03183464816350214),
                    (5, 0.028300909672366776),
                    (6, 0.053541988307438566),
                    (7, -0.05492374857139099),
                    (10, -0.00010834732869724932),
                    (11, 0.0003825710908356584),
                    (12, -0.00034046500868740456),
                    (13, 0.1413124436746325),
                ),
            ),
            (
                1,
                (
                    (0, -0.42889630158379194),
                    (5, -4.697621415361164),
                    (6, 7.683421196062599),
                    (7, 4.06898981839711),
                    (8, 0.3567271874552811),
                    (12, -0.0013990241651590145),
                    (13, 2.9475147891527724),
                    (14, -9.15095847217987),
                ),
            ),
        ),
        (
            1,
            (
                (0, 0.054293734116568765),
                (5, 4.450312892752409),
                (6, 1.8915178993145003),
                (7, -5.801203960010585),
                (8, 0.3111643669578199),
                (9, -0.1521609496625161),
                (10, 0.20136540080403034),
                (11, 0.04471061572777259),
            ),
        ),
        (
            (
                1,
                (
                    (0, 0.01312004499419488),
                    (5, -1.2251564463762044),
                    (6, -0.4957589496572502),
                    (7, 1.6643771824549864),
                    (8, -0.35032884874997366),
                    (9, 0.3341791187130175),
                    (10, 0.08192320648511571),
                    (11, -0.022355307863886294),
                ),
            ),
            (
                1,
                (
                    (0, -0.18980075407240762),
                    (5, 4.450312892752409),
                    (6, 1.8915178993145003),
                    (7, -5.801203960010585),
                    (8, -0.42268232132379197),
                    (9, -0.1521609496625161),
                    (10, 0.20136540080403034),
                    (11, 0.022651792198360825),
                ),
            ),
        ),
        (
            (1, ((0, 1),)),
            (
                1,
                (
                    (0, -10.266057073759306),
                    (5, 13.917653631776604),
                    (6, 2.6056037519936095),
                    (7, -15.018944223519684),
                    (8, 3.050527683318488),
                    (9, -1.3278744327655212),
                    (10, 2.844533632672879),
                    (11, 0.7657106259527866),
                    (12, -1.0889903364513334),
                    (13, 18.148505520854727),
                    (14, -9.194632392478356),
                    (15, -4.436036387594894),
                ),
            ),
            (
                1,
                (
                    (0, 48.161850968566455),
                    (5, -154.78787266663716),
                    (6, -21.622822384626506),
                    (7, 160.09447708973047),
                    (8, -38.54396729189063),
                    (9, 16.661770430049543),
                    (10, -36.55829548991012),
                    (11, -9.906995535619366),
                    (12, 14.097013042320002),
                    (13, -127.63310949253875),
                    (14, 93.3567459327894),
                    (15, 56.68120539776666),
                ),
            ),
            (
                1,
                (
                    (0, -114.93304874997833),
                    (5, 522.9219089608218),
                    (6, 2.535182028966755),
                    (7, -474.3071826037644),
                    (8, 174.47140009219885),
                    (9, -74.44027814126304),
                    (10, 170.69007169147514),
                    (11, 46.8029919188744),
                    (12, -66.68230591294363),
                    (13, 357.3419516129657),
                    (14, -282.6272618704363),
                    (15, -261.77342902691703),
                ),
            ),
            (
                1,
                (
                    (0, 147.46446875669767),
                    (5, -456.25918840208783),
                    (6, 292.25417465990404),
                    (7, 135.96036916173838),
                    (8, -337.0513470238771),
                    (9, 140.75210016191608),
                    (10, -345.9748485480496),
                    (11, -96.5198694669957),
                    (12, 137.96299063474376),
                    (13, -500.7031507909224),
                    (14, 361.14007718803333),
                    (15, 520.9742236688993),
                ),
            ),
            (
                1,
                (
                    (0, -97.06685363011368),
                    (5, -75.53193732135753),
                    (6, -505.40999933296894),
                    (7, 545.1091945264187),
                    (8, 291.78987509083254),
                    (9, -119.2562021040512),
                    (10, 313.299553623578),
                    (11, 88.74316650017616),
                    (12, -127.82216401767992),
                    (13, 349.17035710882897),
                    (14, -201.85219053352347),
                    (15, -461.17279991013964),
                ),
            ),
            (
                1,
                (
                    (0, 25.69393346270375),
                    (5, 154.18974869023643),
                    (6, 231.5293791760455),
                    (7, -357.6391179106141),
                    (8, -93.40532418362432),
                    (9, 37.45832313645163),
                    (10, -104.0996495089623),
                    (11, -29.8402934266605),
                    (12, 43.53345659001114),
                    (13, -96.32455395918828),
                    (14, 39.17726167561544),
                    (15, 149.72683625798564),
                ),
            ),
        ),
    ),
    "explicit_euler": RungeKutta(((0, 1),), (), (1, ((0, 1),)), (), ()),
    "runge_kutta_4": RungeKutta(
        ((0, 1), (1, 2), (1, 2), (1, 1)),
        ((2, ((0, 1),)), (2, ((1, 1),)), (1, ((2, 1),))),
        (6, ((0, 1), (1, 2), (2, 2), (3, 1))),
        (),
        (),
    ),
}

SPLITTING: dict[str, Splitting] = {
    "yoshida_4": Splitting(
        (
            (True, 0.6756035959798288, 1, 0, 1),
            (False, 1.3512071919596575, 1, 0, 1),
            (True, -0.17560359597982883, 1, 1.3512071919596575, 1),
            (False, -1.7024143839193153, 1, 1.3512071919596575, 1),
            (True, -0.17560359597982883, 1, -0.35120719195965766, 1),
            (False, 1.3512071919596575, 1, -0.35120719195965766, 1),
            (True, 0.6756035959798288, 1, 1.0, 1),
        )
    ),
    "semi_implicit_euler": Splitting(
        (
            (True, 1, 1, 0, 1),
            (False, 1, 1, 0, 1),
        )
    ),
    "velocity_verlet": Splitting(
        (
            (True, 1, 2, 0, 1),
            (False, 1, 1, 0, 1),
            (True, 1, 2, 1, 1),
        )
    ),
}
