from math import sqrt


def collide(p, s, t, x, y, margin, shape_kind, shape_first, shape_count, shape_radius, turned, touch, trace):
    ks, kt = shape_kind[s], shape_kind[t]
    trace[p, 0] = 0
    fs, ft = shape_first[s], shape_first[t]
    rs, rt = shape_radius[s], shape_radius[t]
    if ks == 0 and kt == 0:
        d2 = x * x + y * y
        r = rs + rt + margin
        if d2 >= r * r:
            touch[p, 8] = touch[p, 9] = 0.0
            return 0
        d = sqrt(d2)
        if d > 0:
            touch[p, 0], touch[p, 1] = x / d, y / d
        else:
            touch[p, 0], touch[p, 1] = 0.0, 1.0
        gap = d - rs - rt
        touch[p, 2] = touch[p, 0] * (rs + 0.5 * gap)
        touch[p, 3] = touch[p, 1] * (rs + 0.5 * gap)
        touch[p, 4] = gap
        trace[p, 0] = 1
        return 1
    if ks == 3 or kt == 3:
        f = fs if ks == 3 else ft
        r = rt if ks == 3 else rs
        nx, ny = turned[f, 2], turned[f, 3]
        sx, sy = (x, y) if ks == 3 else (-x, -y)
        gap = nx * sx + ny * sy - turned[f, 0] - r
        if gap >= margin:
            touch[p, 8] = touch[p, 9] = 0.0
            return 0
        touch[p, 4] = gap
        px, py = sx - nx * (r + 0.5 * gap), sy - ny * (r + 0.5 * gap)
        if ks == 3:
            touch[p, 0], touch[p, 1] = nx, ny
            touch[p, 2], touch[p, 3] = px, py
        else:
            touch[p, 0], touch[p, 1] = -nx, -ny
            touch[p, 2], touch[p, 3] = px + x, py + y
        trace[p, 0] = 1
        return 1
    return 0
