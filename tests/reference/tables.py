"""Tables of a DEFINITION as CasADi expressions, built from their knots and kinds alone.

Splines by the second derivatives at their knots (moments), others by Hermite's polynomials: neither as the compiler does it.
"""

import casadi as ca
import numpy as np

from units import factor


class Table:
    """One table in SI; `value(node, unit)` gives the number of an expression under a unit."""

    def __init__(self, table, value):
        units = [argument["unit"] for argument in table["arguments"]]
        number = lambda node, unit: float(value(node, unit))
        if "points" in table:
            x = np.array([number(point[0], units[0]) for point in table["points"]])
            y = np.array([number(point[1], table["unit"]) for point in table["points"]])
            self.curve = Line(x, y, table["kind"], table["outside"])
        else:
            axes = [np.array([number(node, units[k]) for node in table["axes"][k]]) for k in (0, 1)]
            z = np.array([[number(node, table["unit"]) for node in row] for row in table["rows"]])
            self.curve = (Sheet if table["kind"] == "bicubic" else Grid)(*axes, z, table["outside"])

    def __call__(self, *arguments):
        return self.curve(*arguments)

    def slope(self, x):
        return self.curve.slope(x)


class Line:
    """Polynomials by increasing powers of x less the knot at which they begin."""

    def __init__(self, x, y, kind, outside):
        self.x, self.period = x, (x[-1] - x[0] if kind == "periodic" else None)
        inner = _splines(x, y, kind) if kind in ("cubic", "natural", "periodic") else _hermite(x, y, kind)
        first, last = inner[0], inner[-1]
        end = x[-1] - x[-2]
        slope = last[1] + 2 * last[2] * end + 3 * last[3] * end**2
        hold = 0.0 if outside == "hold" else 1.0
        before, behind = np.array([y[0], hold * first[1], 0, 0]), np.array([y[-1], hold * slope, 0, 0])
        self.pieces = [(x[0], before), *zip(x[:-1], inner), (x[-1], behind)]

    def __call__(self, x):
        return self._taken(x, lambda s, c: c[0] + s * (c[1] + s * (c[2] + s * c[3])))

    def slope(self, x):
        return self._taken(x, lambda s, c: c[1] + s * (2 * c[2] + s * 3 * c[3]))

    def _taken(self, x, polynomial):
        if self.period is not None:
            x = x - self.period * ca.floor((x - self.x[0]) / self.period)
        base, coefficients = self.pieces[0]
        value = polynomial(x - base, coefficients)
        for base, coefficients in self.pieces[1:]:
            value = ca.if_else(x >= base, polynomial(x - base, coefficients), value)
        return value


class Grid:
    """Straight along both arguments: the four values around a place, each with its share."""

    def __init__(self, x, y, z, outside):
        self.x, self.y, self.z, self.hold = x, y, z, outside == "hold"

    def __call__(self, x, y):
        if self.hold:
            x, y = ca.fmin(ca.fmax(x, self.x[0]), self.x[-1]), ca.fmin(ca.fmax(y, self.y[0]), self.y[-1])
        value = 0
        for j in range(len(self.y) - 1):
            for i in range(len(self.x) - 1):
                inside = ca.logic_and(_within(x, self.x, i), _within(y, self.y, j))
                value = value + ca.if_else(inside, self._patch(x, y, i, j), 0)
        return value

    def _patch(self, x, y, i, j):
        share = (x - self.x[i]) / (self.x[i + 1] - self.x[i])
        other = (y - self.y[j]) / (self.y[j + 1] - self.y[j])
        below = self.z[j, i] * (1 - share) + self.z[j, i + 1] * share
        above = self.z[j + 1, i] * (1 - share) + self.z[j + 1, i + 1] * share
        return below * (1 - other) + above * other


class Sheet:
    """Splines along x through the rows, each with its share: the spline along y that is one at its knot and zero at the others."""

    def __init__(self, x, y, z, outside):
        self.rows = [Line(x, row, "cubic", outside) for row in z]
        self.shares = [Line(y, unit, "cubic", outside) for unit in np.eye(len(y))]

    def __call__(self, x, y):
        return sum(row(x) * share(y) for row, share in zip(self.rows, self.shares))


def _within(x, knots, i):
    """In an interval; the outer ones go on for ever."""
    above = x >= knots[i] if i > 0 else 1
    below = x < knots[i + 1] if i < len(knots) - 2 else 1
    return ca.logic_and(above, below)


def _splines(x, y, kind):
    """The moments M at the knots: the second derivative is straight between them, the first one continuous."""
    n, h = len(x), np.diff(x)
    rise = np.diff(y) / h
    system, right = np.zeros((n, n)), np.zeros(n)
    for i in range(1, n - 1):
        system[i, i - 1 : i + 2] = h[i - 1] / 6, (h[i - 1] + h[i]) / 3, h[i] / 6
        right[i] = rise[i] - rise[i - 1]
    if kind == "natural":
        system[0, 0] = system[-1, -1] = 1
    elif kind == "cubic":
        # The third derivative is continuous at the second knot and at the last but one.
        system[0, :3] = -1 / h[0], 1 / h[0] + 1 / h[1], -1 / h[1]
        system[-1, -3:] = -1 / h[-2], 1 / h[-2] + 1 / h[-1], -1 / h[-1]
    else:
        system[0, 0], system[0, -1] = 1, -1
        system[-1, 0] += h[0] / 3
        system[-1, 1] += h[0] / 6
        system[-1, -2] += h[-1] / 6
        system[-1, -1] += h[-1] / 3
        right[-1] = rise[0] - rise[-1]
    moments = np.linalg.solve(system, right)
    pieces = []
    for i in range(n - 1):
        first = rise[i] - h[i] * (2 * moments[i] + moments[i + 1]) / 6
        pieces.append(np.array([y[i], first, moments[i] / 2, (moments[i + 1] - moments[i]) / (6 * h[i])]))
    return pieces


def _hermite(x, y, kind):
    h = np.diff(x)
    rise = np.diff(y) / h
    if kind == "linear" or len(x) == 2:
        return [np.array([y[i], rise[i], 0, 0]) for i in range(len(h))]
    m = {"akima": _akima, "modified_akima": _modified, "monotone": _steffen, "pchip": _pchip}[kind](h, rise)
    basis = np.array([[1, 0, 0, 0], [0, 1, 0, 0], [-3, -2, 3, -1], [2, 1, -2, 1]])
    pieces = []
    for i, width in enumerate(h):
        by_share = basis @ np.array([y[i], width * m[i], y[i + 1], width * m[i + 1]])
        pieces.append(by_share / width ** np.arange(4))
    return pieces


def _extended(rise):
    low = [2 * rise[0] - rise[1], 3 * rise[0] - 2 * rise[1]]
    high = [2 * rise[-1] - rise[-2], 3 * rise[-1] - 2 * rise[-2]]
    return np.array([low[1], low[0], *rise, *high])


def _weighted(rise, weight, flat, least):
    m = _extended(rise)
    left = np.array([weight(m[i], m[i + 1]) for i in range(len(rise) + 1)])
    right = np.array([weight(m[i + 2], m[i + 3]) for i in range(len(rise) + 1)])
    least = least * np.max(left + right)
    slopes = []
    for i, (a, b) in enumerate(zip(left, right)):
        slopes.append((b * m[i + 1] + a * m[i + 2]) / (a + b) if a + b > least else flat(m[i : i + 4]))
    return slopes


def _akima(_, rise):
    return _weighted(rise, lambda a, b: abs(b - a), lambda m: (m[0] + m[3]) / 2, 1e-9)


def _modified(_, rise):
    return _weighted(rise, lambda a, b: abs(b - a) + abs(a + b) / 2, lambda _: 0.0, 0.0)


def _steffen(h, rise):
    def end(h, s):
        p = s[0] * (1 + h[0] / (h[0] + h[1])) - s[1] * h[0] / (h[0] + h[1])
        return 0.0 if p * s[0] <= 0 else 2 * s[0] if abs(p) > 2 * abs(s[0]) else p

    slopes = [end(h[:2], rise[:2])]
    for i in range(1, len(h)):
        p = (rise[i - 1] * h[i] + rise[i] * h[i - 1]) / (h[i - 1] + h[i])
        least = min(abs(rise[i - 1]), abs(rise[i]), abs(p) / 2)
        slopes.append((np.sign(rise[i - 1]) + np.sign(rise[i])) * least)
    return [*slopes, end(h[:-3:-1], rise[:-3:-1])]


def _pchip(h, rise):
    def end(h, s):
        d = ((2 * h[0] + h[1]) * s[0] - h[0] * s[1]) / (h[0] + h[1])
        if np.sign(d) != np.sign(s[0]):
            return 0.0
        return 3 * s[0] if np.sign(s[0]) != np.sign(s[1]) and abs(d) > 3 * abs(s[0]) else d

    slopes = [end(h[:2], rise[:2])]
    for i in range(1, len(h)):
        if rise[i - 1] * rise[i] <= 0:
            slopes.append(0.0)
            continue
        w = np.array([2 * h[i] + h[i - 1], h[i] + 2 * h[i - 1]])
        slopes.append(w.sum() / (w[0] / rise[i - 1] + w[1] / rise[i]))
    return [*slopes, end(h[:-3:-1], rise[:-3:-1])]


def in_si(node, unit):
    """A number as it stands in a table, where no scope is needed."""
    sign = -1 if "op" in node else 1
    return sign * float((node["args"][0] if "op" in node else node)["number"]) * factor(unit)
