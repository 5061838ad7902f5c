"""To be replaced by the generated chapter."""


def row_velocity(va, wa, aa, vb, wb, ab, n):
    return (vb[0] - va[0]) * n[0] + (vb[1] - va[1]) * n[1] + wb * ab - wa * aa


def row_mass(ima, iia, aa, imb, iib, ab):
    return 1.0 / (ima + imb + iia * (aa * aa) + iib * (ab * ab))


def bias_rate(omega, zeta, h):
    return omega / (2 * zeta + h * omega)


def mass_share(omega, zeta, h):
    return h * omega * (2 * zeta + h * omega) / (1 + h * omega * (2 * zeta + h * omega))


def impulse_share(omega, zeta, h):
    return 1 / (1 + h * omega * (2 * zeta + h * omega))


def soft_push(push, vn, bias, m, ms, share):
    new = push - m * ms * (vn + bias) - share * push
    return new if new > 0.0 else 0.0


def rub(rub, vt, m, mu, push):
    new = rub - m * vt
    most = mu * push
    new = new if new < most else most
    return new if new > -most else -most


def separation_later(s, da, ta, aa, ba, db, tb, ab, bb, n):
    return (
        s
        + (db[0] - da[0]) * n[0]
        + (db[1] - da[1]) * n[1]
        + tb * ab
        - ta * aa
        - (tb * tb * bb - ta * ta * ba) / 2
    )


def bouncing_push(push, vn, before, e, m):
    new = push - m * (vn + e * before)
    return new if new > 0.0 else 0.0
