"""Modes of Timoshenko's beams: exponentials and waves that solve both equations, put together so that the ends are as they are held.

In ξ = x/L, with r² = I/(A L²), s² = E I/(κ G A L²) and b² = ρ A L⁴ ω²/(E I): N″ − ψ′ + b² s² N = 0, ψ″ + (N′ − ψ)/s² + b² r² ψ = 0. b is found where the
determinant of the four conditions changes its sign, and the shape from the conditions' null vector.
"""

import math

import numpy as np

from quadrature import gauss


class Thick:
    """N and ψ of the modes of one way of bending, N over the length and ψ by ξ."""

    def __init__(self, shapes, count, r2, s2):
        self.shapes, self.r2, self.s2 = shapes, r2, s2
        found, low, step = [], 0.05, 0.02
        # In √b, in which roots of slender beams are about π apart.
        while len(found) < count:
            high = low + step
            if self._determinant(low) * self._determinant(high) < 0:
                found.append(self._halved(low, high))
            low = high
        self.modes = [self._mode(root**2) for root in found]

    def shape(self, number, xi, order):
        """N or a derivative by ξ."""
        return self._sum(self.modes[number], xi, order, 0)

    def turn(self, number, xi, order):
        """ψ or a derivative by ξ."""
        return self._sum(self.modes[number], xi, order, 1)

    def _sum(self, mode, xi, order, which):
        b, coefficients = mode
        return float(sum(c * part for c, part in zip(coefficients, self._parts(b, xi, order)[which])))

    def _parts(self, b, xi, order):
        """N and ψ of e^(−αξ), e^(α(ξ − 1)), cos βξ, sin βξ with their derivatives."""
        r2, s2 = self.r2, self.s2
        root = math.sqrt((r2 - s2) ** 2 + 4 / b**2)
        alpha = b * math.sqrt((root - r2 - s2) / 2)
        beta = b * math.sqrt((root + r2 + s2) / 2)
        falling, waving = alpha + b * b * s2 / alpha, beta - b * b * s2 / beta
        down = (-alpha) ** order * math.exp(-alpha * xi)
        up = alpha**order * math.exp(alpha * (xi - 1))
        phase = order * math.pi / 2
        cos, sin = beta**order * math.cos(beta * xi + phase), beta**order * math.sin(beta * xi + phase)
        return [down, up, cos, sin], [-falling * down, falling * up, -waving * sin, waving * cos]

    def _conditions(self, b):
        """What is zero at the start and at the end, by the four parts."""
        rows = []
        for xi in (0.0, 1.0):
            (n, psi), (n1, psi1) = self._parts(b, xi, 0), self._parts(b, xi, 1)
            moment, shear = np.array(psi1), np.array(n1) - np.array(psi)
            if self.shapes == "pinned":
                rows += [np.array(n), moment]
            elif self.shapes == "clamped" and xi == 0.0:
                rows += [np.array(n), np.array(psi)]
            else:
                rows += [moment, shear]
        return np.array([row / np.linalg.norm(row) for row in rows])

    def _determinant(self, root):
        return np.linalg.det(self._conditions(root**2))

    def _halved(self, low, high):
        start = self._determinant(low)
        for _ in range(60):
            half = (low + high) / 2
            low, high = (half, high) if self._determinant(half) * start > 0 else (low, half)
        return (low + high) / 2

    def _mode(self, b):
        """∫ N² + r² ψ² = 1, on two hinges an amplitude of 1; positive at the start, what is held there bent that way."""
        coefficients = np.linalg.svd(self._conditions(b))[2][3]
        mode = b, coefficients
        if self.shapes == "pinned":
            return b, coefficients / coefficients[3]
        nodes, weights = gauss(40)
        square = sum(
            w / 2 * (self._sum(mode, (1 + s) / 2, 0, 0) ** 2 + self.r2 * self._sum(mode, (1 + s) / 2, 0, 1) ** 2) for s, w in zip(nodes, weights)
        )
        sign = self._sum(mode, 0.0, 0, 0) if self.shapes == "free" else self._sum(mode, 0.0, 1, 1)
        return b, coefficients * math.copysign(1 / math.sqrt(square), sign)
