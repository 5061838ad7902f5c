"""Andrews' squeezer against its textbook equations in seven angles, and against printed values.

The equations are those of the figure in Hairer and Wanner (Solving Ordinary Differential Equations
II, section VI.9): other coordinates, other constraints, no bodies. In index one, by scipy.
"""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import tamias2d as t2
from tamias2d.run import Run

M1, M2, M3, M4, M5, M6, M7 = 0.04325, 0.00365, 0.02373, 0.00706, 0.0705, 0.00706, 0.05498
I1, I2, I3, I4 = 2.194e-6, 4.41e-7, 5.255e-6, 5.667e-7
I5, I6, I7 = 1.169e-5, 5.667e-7, 1.912e-5
XA, YA, XB, YB, XC, YC = -0.06934, -0.00227, -0.03635, 0.03273, 0.014, 0.072
C0, L0, MOM = 4530, 0.07785, 0.033
D, DA, E, EA, RR, RA, SS = 0.028, 0.0115, 0.02, 0.01421, 0.007, 0.00092, 0.035
SA, SB, SC, SD = 0.01874, 0.01043, 0.018, 0.02
TA, TB, U, UA, UB, ZF, ZT, FA = 0.02308, 0.00916, 0.04, 0.01228, 0.00449, 0.02, 0.04, 0.01421
START = [
    -0.0617138900142764496, 0, 0.455279819163070380, 0.222668390165885885,
    0.487364979543842550, -0.222668390165885885, 1.23054744454982119,
]  # fmt: skip
"""beta, Theta, gamma, Phi, delta, Omega, epsilon"""
PRINTED = np.array([
    15.81077119629904, -15.75637105984298, 0.04082224013073101, -0.5347301163226948,
    0.5244099658805304, 0.5347301163226948, 1.048080741042263,
    1139.920302151208, -1424.379294994111, 11.03291221937134, 19.29337464421385,
    0.5735699284790808, -19.29337464421385, 0.3231791658026955,
])  # fmt: skip
"""Angles and rates at 30 ms, of the test set for initial value problems."""
E4, F6 = E - EA, ZF - FA


def mass(q: np.ndarray) -> np.ndarray:
    _, theta, _, phi, _, omega, _ = q
    m = np.zeros((7, 7))
    m[0, 0] = M1 * RA**2 + M2 * (RR**2 - 2 * DA * RR * np.cos(theta) + DA**2) + I1 + I2
    m[0, 1] = m[1, 0] = M2 * (DA**2 - DA * RR * np.cos(theta)) + I2
    m[1, 1] = M2 * DA**2 + I2
    m[2, 2] = M3 * (SA**2 + SB**2) + I3
    m[3, 3] = M4 * E4**2 + I4
    m[3, 4] = m[4, 3] = M4 * (E4**2 + ZT * E4 * np.sin(phi)) + I4
    m[4, 4] = M4 * (ZT**2 + 2 * ZT * E4 * np.sin(phi) + E4**2) + M5 * (TA**2 + TB**2) + I4 + I5
    m[5, 5] = M6 * F6**2 + I6
    m[5, 6] = m[6, 5] = M6 * (F6**2 - U * F6 * np.sin(omega)) + I6
    m[6, 6] = M6 * (F6**2 - 2 * U * F6 * np.sin(omega) + U**2) + M7 * (UA**2 + UB**2) + I6 + I7
    return m


def spring(gamma: float) -> tuple[float, float, float]:
    """Both components of the way from the spring's fixed end, and its length."""
    x = SD * np.cos(gamma) + SC * np.sin(gamma) + XB - XC
    y = SD * np.sin(gamma) - SC * np.cos(gamma) + YB - YC
    return x, y, float(np.hypot(x, y))


def forces(q: np.ndarray, v: np.ndarray) -> np.ndarray:
    _, theta, gamma, phi, _, omega, _ = q
    x, y, length = spring(gamma)
    pull = -C0 * (length - L0) / length
    return np.array([
        MOM - M2 * DA * RR * v[1] * (v[1] + 2 * v[0]) * np.sin(theta),
        M2 * DA * RR * v[0] ** 2 * np.sin(theta),
        pull * x * (SC * np.cos(gamma) - SD * np.sin(gamma))
        + pull * y * (SD * np.cos(gamma) + SC * np.sin(gamma)),
        M4 * ZT * E4 * v[4] ** 2 * np.cos(phi),
        -M4 * ZT * E4 * v[3] * (v[3] + 2 * v[4]) * np.cos(phi),
        -M6 * U * F6 * v[6] ** 2 * np.cos(omega),
        M6 * U * F6 * v[5] * (v[5] + 2 * v[6]) * np.cos(omega),
    ])  # fmt: skip


def jacobian(q: np.ndarray) -> np.ndarray:
    beta, theta, gamma, phi, delta, omega, epsilon = q
    j = np.zeros((6, 7), complex)
    for k in (0, 2, 4):
        j[k, 0] = -RR * np.sin(beta) + D * np.sin(beta + theta)
        j[k, 1] = D * np.sin(beta + theta)
        j[k + 1, 0] = RR * np.cos(beta) - D * np.cos(beta + theta)
        j[k + 1, 1] = -D * np.cos(beta + theta)
    j[0, 2], j[1, 2] = -SS * np.cos(gamma), -SS * np.sin(gamma)
    j[2, 3], j[3, 3] = -E * np.cos(phi + delta), -E * np.sin(phi + delta)
    j[2, 4] = -E * np.cos(phi + delta) + ZT * np.sin(delta)
    j[3, 4] = -E * np.sin(phi + delta) - ZT * np.cos(delta)
    j[4, 5], j[5, 5] = ZF * np.sin(omega + epsilon), -ZF * np.cos(omega + epsilon)
    j[4, 6] = ZF * np.sin(omega + epsilon) - U * np.cos(epsilon)
    j[5, 6] = -ZF * np.cos(omega + epsilon) - U * np.sin(epsilon)
    return j


def solved(y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Accelerations (7,) and the forces (6,) that close the loops."""
    q, v = y[:7], y[7:]
    rows = jacobian(q).real
    convective = jacobian(q + 1e-40j * v).imag @ v / 1e-40  # a derivative without differences
    matrix = np.block([[mass(q), rows.T], [rows, np.zeros((6, 6))]])
    found = np.linalg.solve(matrix, np.concatenate([forces(q, v), -convective]))
    return found[:7], found[7:]


def energy(y: np.ndarray) -> float:
    """Kinetic, of the spring, and of the constant torque, J."""
    length = spring(y[2])[2]
    return float(y[7:] @ mass(y[:7]) @ y[7:] / 2 + C0 * (length - L0) ** 2 / 2 - MOM * y[0])


@pytest.fixture(scope="module")
def textbook() -> np.ndarray:
    def rate(_: float, y: np.ndarray) -> np.ndarray:
        return np.concatenate([y[7:], solved(y)[0]])

    start = [*START, *[0.0] * 7]
    found = solve_ivp(rate, (0, 0.03), start, method="DOP853", rtol=1e-13, atol=1e-15)
    return np.asarray(found.y[:, -1])


@pytest.fixture(scope="module")
def squeezed() -> Run:
    scene = t2.catalogue.load("andrews")
    return t2.simulate(scene, duration=0.03, method=t2.Dop853(rtol=1e-13), times=[0.0, 0.03])


def in_angles(turns: np.ndarray) -> np.ndarray:
    """The seven angles, or rates, from those of the bodies K1 to K7."""
    k1, k2, k3, k4, k5, k6, k7 = turns.tolist()
    return np.array([k1, k2 - k1, k3, k4 - k5, k5, k6 - k7, k7])


def test_all_fourteen_values_are_those_of_the_textbook(squeezed: Run, textbook: np.ndarray) -> None:
    found = [in_angles(rows[-1]) for rows in (squeezed.orientation, squeezed.angular_velocity)]
    assert np.concatenate(found) == pytest.approx(textbook, rel=1e-10, abs=1e-11)


def test_reactions_are_the_multipliers_of_the_textbook(squeezed: Run, textbook: np.ndarray) -> None:
    """Those that close the loops where K3, K4 and K6 meet K2."""
    _, multipliers = solved(textbook)
    names = ("P3", "P4", "P6")
    found = [squeezed.reactions.force[-1, squeezed.reactions.index(name), 0] for name in names]
    assert np.ravel(found) == pytest.approx(-multipliers, rel=1e-9)


def test_printed_values_agree_as_far_as_they_keep_the_energy(
    squeezed: Run, textbook: np.ndarray
) -> None:
    """The printed rates let the loops open at 1e-9 m/s, and have lost 2e-10 J: they err by 3e-8."""
    start = energy(np.array([*START, *[0.0] * 7]))
    assert energy(textbook) == pytest.approx(start, abs=1e-12)
    assert abs(energy(PRINTED) - start) > 1e-10
    opens = np.abs(jacobian(PRINTED[:7]).real @ PRINTED[7:]).max()
    assert opens > 5e-10
    assert np.abs(jacobian(textbook[:7]).real @ textbook[7:]).max() < 1e-12
    assert in_angles(squeezed.orientation[-1]) == pytest.approx(PRINTED[:7], rel=1e-9, abs=1e-10)
    assert in_angles(squeezed.angular_velocity[-1]) == pytest.approx(
        PRINTED[7:], rel=3e-8, abs=3e-8
    )
