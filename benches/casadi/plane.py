"""The four-bar ladders, as an expert writes them around CasADi; what loops in the plane share.

    (angles, rates, (2α, β²)) -> (accelerations, multipliers)

Coordinates: the absolute angles of all rods, cranks first, then couplers (the couplers ride on their left cranks, so
each window has one loop closure of two rows). M has blocks of two, inverted by hand. Rods of 1 m and 1 kg, pins 1 m
apart, g = 9.81 m/s².
"""

import casadi as ca


def ladder(windows):
    """Symbols, M⁻¹, forces, constraints of the ladder."""
    cranks, rods = windows + 1, 2 * windows + 1
    q, v = ca.SX.sym("q", rods), ca.SX.sym("v", rods)
    c, s = ca.cos(q), ca.sin(q)
    g = 9.81

    inverse = ca.SX(rods, rods)
    forces = ca.SX(rods, 1)
    third = 1.0 / 3.0
    for i in range(cranks):
        k = cranks + i
        if i == windows:
            # The last crank carries nothing.
            inverse[i, i] = 1.0 / third
            forces[i] = -0.5 * g * c[i]
            continue
        # Crank with a point mass of the coupler at its tip, the coupler about its left end, coupled by cos Δ.
        coupling = 0.5 * (c[i] * c[k] + s[i] * s[k])
        skew = 0.5 * (s[i] * c[k] - c[i] * s[k])
        a, d = third + 1.0, third
        determinant = a * d - coupling * coupling
        inverse[i, i], inverse[k, k] = d / determinant, a / determinant
        inverse[i, k] = inverse[k, i] = -coupling / determinant
        forces[i] = -1.5 * g * c[i] - skew * v[k] * v[k]
        forces[k] = -0.5 * g * c[k] + skew * v[i] * v[i]

    jacobian = ca.SX(2 * windows, rods)
    phi, gamma = ca.SX(2 * windows, 1), ca.SX(2 * windows, 1)
    for i in range(windows):
        k, j = cranks + i, i + 1
        phi[2 * i] = c[i] + c[k] - c[j] - 1.0
        phi[2 * i + 1] = s[i] + s[k] - s[j]
        for column, sign in ((i, 1.0), (k, 1.0), (j, -1.0)):
            jacobian[2 * i, column] = -sign * s[column]
            jacobian[2 * i + 1, column] = sign * c[column]
            gamma[2 * i] += sign * c[column] * v[column] ** 2
            gamma[2 * i + 1] += sign * s[column] * v[column] ** 2
    return q, v, inverse, forces, jacobian, phi, gamma


def function(name, windows):
    q, v, inverse, forces, jacobian, phi, gamma = ladder(windows)
    gains = ca.SX.sym("gains", 2)
    target = gamma - gains[0] * ca.mtimes(jacobian, v) - gains[1] * phi
    return ca.Function(name, [q, v, gains], ca.cse(eliminated(inverse, forces, jacobian, target)))


def eliminated(inverse, forces, jacobian, target):
    """Accelerations and multipliers. D M⁻¹ Dᵀ is factored by CasADi's symbolic sparse LDLᵀ, in the order of its rows."""
    spread = ca.mtimes(inverse, jacobian.T)
    free = ca.mtimes(inverse, forces)
    d, lt, p = ca.ldl(ca.mtimes(jacobian, spread), False)
    multipliers = ca.ldl_solve(ca.mtimes(jacobian, free) - target, d, lt, p)
    return [free - ca.mtimes(spread, multipliers), multipliers]


def functions():
    for name, windows in (("four_bar", 1), ("n_four_bar_10", 10), ("n_four_bar_40", 40)):
        yield function(name, windows)
