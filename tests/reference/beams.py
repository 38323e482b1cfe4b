"""Beams: shapes by their textbook formulas, and everything else by quadrature along the axis.

A point of the axis at x (from the frame's origin) is at (x + Σ N_a p_a, Σ N_b p_b) in the frame, in space with a third component of
the same kind, where a section is turned by the rotation of (1 − c̃)⁻¹ (1 + c̃), c half of (Σ N_t p_t, −Σ N′ p_z, Σ N′ p_y). No integral of shapes over the
mass is formed: energies are sums over slices, each with its position and its turn about the axis, whose rates come from automatic differentiation.
With `stiffening` bending draws a place in by ½ Σ Γ_jk p_j p_k, Γ_jk = ∫ N_j′ N_k′ dx.
Shapes (Blevins, Formulas for Natural Frequency and Mode Shape, tables 8-1 and 8-16) are written here so that no
differences of large hyperbolic functions occur, each in another form than in the compiler.
"""

import functools
import math

import casadi as ca
import numpy as np

from expressions import entry, number
from quadrature import gauss
from space_frames import tilde
from thick import Thick

SLICES = 24


class Beam:
    """Shapes and rigidities of one beam."""

    def __init__(self, node, given, model):
        beam = node["beam"]
        self.length = float(ca.evalf(ca.SX(given["length"])))
        self.shapes = beam["shapes"]
        self.start = -self.length / 2 if self.shapes == "free" else 0.0
        self.dimension = model.dimension
        across = ["bending"] if self.dimension == 2 else ["bending_y", "bending_z"]
        self.axial = beam["axial"]
        self.polynomials = {}
        if self.shapes == "static":
            self.polynomials |= {way: _polynomials(beam[way], 2) for way in across}
        if self.shapes == "static" or beam.get("quadratic"):
            self.polynomials["axial"] = _polynomials(self.axial, 1)
        self.torsion = beam.get("torsion", 0)
        if self.shapes == "static":
            self.polynomials["torsion"] = _polynomials(self.torsion, 1)
        self.names = [f"{way}[{k}]" for way in ["axial", *across] for k in range(beam[way])]
        self.bent = len(self.names)  # what follows twists
        self.directions = [["axial", *across].index(name.split("[")[0]) for name in self.names]
        self.names += [f"torsion[{k}]" for k in range(self.torsion)]
        section = beam.get("section")
        if section:
            lengths = {name: entry(value, model) for name, value in section.items() if name != "kind"}
            self.area, *moments = SECTIONS[section["kind"]](**lengths)
            twisted = (_torsion_of_rectangle(**lengths) if section["kind"] == "rectangle" else sum(moments)) if self.torsion else 0
        else:
            words = ["second_moment"] if self.dimension == 2 else ["second_moment_z", "second_moment_y"]
            self.area, moments = given["area"], [given[word] for word in words]
            twisted = given["torsion_constant"] if self.torsion else 0
        self.rigidity = {way: given["young"] * moment for way, moment in zip(across, moments)}
        self.rigidity["axial"] = given["young"] * self.area
        if self.torsion:
            self.rigidity["torsion"] = given["shear_modulus"] * twisted
        self.polar = sum(moments) / self.area  # m² about the axis
        self.ratio = given.get("damping_ratio", ca.SX(0))
        self.thick, self.gyration = {}, {}
        if beam.get("theory") == "timoshenko":
            self._shear(across, moments, section and section["kind"], lengths if section else {}, given, beam)
        self.stiffening = beam.get("stiffening", False)
        # The frame of free shapes stays in the centre of mass.
        mean = lambda j, k: sum(share * self._integral(j, k, x) for x, share in self.slices())
        bending = range(self.axial, self.bent) if self.stiffening else ()
        pairs = [(j, k) for j in bending for k in bending if self.directions[j] == self.directions[k]]
        self.drawn = {pair: mean(*pair) if self.shapes == "free" else 0.0 for pair in pairs}

    def _shear(self, across, moments, kind, lengths, given, beam):
        """Timoshenko's shapes, with the shear factor as written or Cowper's (J. Appl. Mech. 33, 1966)."""
        value = lambda expression: float(ca.evalf(ca.SX(expression)))
        young, shear = value(given["young"]), value(given["shear_modulus"])
        nu = young / (2 * shear) - 1
        if "shear_factor" in given:
            factor = value(given["shear_factor"])
        elif kind == "rectangle":
            factor = 10 * (1 + nu) / (12 + 11 * nu)
        else:
            m2 = (value(lengths["inner"]) / value(lengths["outer"])) ** 2 if kind == "tube" else 0.0
            factor = 6 * (1 + nu) * (1 + m2) ** 2 / ((7 + 6 * nu) * (1 + m2) ** 2 + (20 + 12 * nu) * m2)
        self.shear = factor * shear * value(self.area)
        for way, moment in zip(across, moments):
            self.gyration[way] = value(moment) / value(self.area)
            r2 = self.gyration[way] / self.length**2
            self.thick[way] = Thick(self.shapes, beam[way], r2, r2 * young / (factor * shear))

    def points(self):
        middle = self.start + self.length / 2
        on_axis = lambda x: ca.vertcat(x, ca.SX.zeros(self.dimension - 1))
        return {"start": on_axis(self.start), "center": on_axis(middle), "end": on_axis(self.start + self.length)}

    def slices(self):
        """x and share of the mass of each."""
        nodes, weights = gauss(SLICES)
        return [(self.start + self.length * (1 + s) / 2, w / 2) for s, w in zip(nodes, weights)]

    def shape(self, mode, x, order):
        """N, N′ or N″ of a mode at x."""
        way, number = self.names[mode].rstrip("]").split("[")
        xi = (x - self.start) / self.length
        if way in self.thick:
            value = self.thick[way].shape(int(number), xi, order)
        elif way in self.polynomials:
            value = self.polynomials[way][int(number)].deriv(order)(xi) if order else self.polynomials[way][int(number)](xi)
        else:
            value = SHAPES[self.shapes, {"torsion": "axial"}.get(way, way.split("_")[0])](int(number), xi, order)
        # What is held does not move at all, and rounding of it is nothing to compare.
        return 0.0 if abs(value) < 1e-12 else value / self.length**order

    def deformed(self, x, p):
        """Where the point of the axis at x is in the frame."""
        at = [x - self._drawn_in(x, p), *[ca.SX(0)] * (self.dimension - 1)]
        for k, direction in enumerate(self.directions):
            at[direction] += self.shape(k, x, 0) * p[k]
        return ca.vertcat(*at)

    def turned(self, x, p):
        """The section at x in space against the frame: Cayley's rotation with the slopes as its first order."""
        rises = [ca.SX(0)] * 3
        for k, direction in enumerate(self.directions):
            rises[direction] += self.slope_of(k, x) * p[k]
        half = ca.vertcat(self.twist(x, p), -rises[2], rises[1]) / 2
        return ca.simplify(ca.mtimes(ca.inv(ca.SX.eye(3) - tilde(half)), ca.SX.eye(3) + tilde(half)))

    def twist(self, x, p):
        """By how much the section at x is turned about the axis."""
        return sum((self.shape(k, x, 0) * p[k] for k in range(self.bent, len(self.names))), ca.SX(0))

    def _drawn_in(self, x, p):
        """By how much bending moves the point of the axis at x towards the start: half the integral of the slope's square."""
        terms = ((self._integral(j, k, x) - mean) * p[j] * p[k] / 2 for (j, k), mean in self.drawn.items())
        return sum(terms, ca.SX(0))

    @functools.cache
    def _integral(self, j, k, x):
        """Of N_j′ N_k′ from the start to x."""
        nodes, weights = gauss(2 * SLICES)
        span = x - self.start
        at = [self.start + span * (1 + s) / 2 for s in nodes]
        return span / 2 * sum(w * self.shape(j, s, 1) * self.shape(k, s, 1) for s, w in zip(at, weights))

    def slope(self, x, p):
        """By how much the section at x is turned, to first order."""
        return sum((self.slope_of(k, x) * p[k] for k in range(self.axial, self.bent)), ca.SX(0))

    def slope_of(self, mode, x):
        """N′, or ψ of what shears."""
        if self.thick and self.axial <= mode < self.bent:
            return self._psi(mode, x, 0)
        return self.shape(mode, x, 1) if self.axial <= mode < self.bent else 0.0

    def _psi(self, mode, x, order):
        way, number = self.names[mode].rstrip("]").split("[")
        value = self.thick[way].turn(int(number), (x - self.start) / self.length, order)
        return 0.0 if abs(value) < 1e-12 else value / self.length ** (1 + order)

    def turning_energy(self, omega, rates, mass):
        """Of sections that shear: each turns with the frame and by its modes, about z in the plane and about all axes in space."""
        energy = ca.SX(0)
        for x, share in self.slices():
            turns = [ca.SX(0)] * 3
            for k in range(len(self.names)):
                own = self.names[k].split("[")[0]
                about, sign = {"torsion": (0, 1), "bending_z": (1, -1)}.get(own, (2, 1))
                turns[about] += sign * (self.shape(k, x, 0) if k >= self.bent else self.slope_of(k, x)) * rates[k]
            if self.dimension == 2:
                squares = [(self.gyration["bending"], omega + turns[2])]
            else:
                about = [self.gyration["bending_y"] + self.gyration["bending_z"], self.gyration["bending_z"], self.gyration["bending_y"]]
                squares = [(about[k], omega[k] + turns[k]) for k in range(3)]
            energy += share * mass * sum(radius * rate**2 for radius, rate in squares) / 2
        return energy

    def stiffness(self, mode):
        """∫ EA N′² dx, ∫ EI N″² dx or ∫ G J_t N′² dx."""
        order, way = 2 if self.axial <= mode < self.bent else 1, self.names[mode].split("[")[0]
        if way in self.thick:
            bent = sum(weight * self._psi(mode, x, 1) ** 2 for x, weight in self.slices())
            sheared = sum(weight * (self.shape(mode, x, 1) - self._psi(mode, x, 0)) ** 2 for x, weight in self.slices())
            return self.length * (self.rigidity[way] * bent + self.shear * sheared)
        integral = self.length * sum(weight * self.shape(mode, x, order) ** 2 for x, weight in self.slices())
        return self.rigidity[way] * integral

    def elastic_energy(self, p):
        return sum((self.stiffness(k) * p[k] ** 2 / 2 for k in range(len(self.names))), ca.SX(0))

    def spot(self, local):
        """x of a place on the axis."""
        return number(local[0])

    def modal_forces(self, rates, mass):
        return [-self.damping(mode, mass) * rate for mode, rate in enumerate(rates)]

    def damping(self, mode, mass):
        """2 ζ √(K M), in torsion with the moment of inertia about the axis."""
        if mode >= self.bent:
            mass = mass * self.polar
        own = sum(weight * self.shape(mode, x, 0) ** 2 for x, weight in self.slices())
        way = self.names[mode].split("[")[0]
        if way in self.thick:
            own += self.gyration[way] * sum(weight * self._psi(mode, x, 0) ** 2 for x, weight in self.slices())
        return 2 * self.ratio * ca.sqrt(self.stiffness(mode) * mass * own)


def _polynomials(count, order):
    """Of all polynomials ξ^order … those across to one another in ∫N² = 1 and ∫(N^(order))², the slowest first, positive at 1."""
    if count == 0:
        return []
    legendre = lambda k: np.polynomial.Legendre.basis(k, domain=[0, 1])
    factor = np.polynomial.Polynomial([0] * order + [1]).convert(kind=np.polynomial.Legendre, domain=[0, 1])
    basis = [factor * legendre(k) for k in range(count)]
    nodes, weights = gauss(count + order + 1)
    at, weights = (1 + nodes) / 2, weights / 2
    gram = lambda functions: np.array([[np.sum(weights * f(at) * g(at)) for g in functions] for f in functions])
    stiffness, mass = gram([f.deriv(order) for f in basis]), gram(basis)
    lower = np.linalg.inv(np.linalg.cholesky(stiffness))
    values, vectors = np.linalg.eigh(lower @ mass @ lower.T)
    found = []
    for square, vector in sorted(zip(values, vectors.T), key=lambda pair: -pair[0]):
        shape = sum(c * f for c, f in zip(lower.T @ vector, basis)) / np.sqrt(square)
        found.append(shape if shape(1.0) > 0 else -shape)
    return found


# Area, second moments about z and about y.
SECTIONS = {
    "circle": lambda diameter: (ca.pi * diameter**2 / 4, *[ca.pi * diameter**4 / 64] * 2),
    "tube": lambda outer, inner: (ca.pi * (outer**2 - inner**2) / 4, *[ca.pi * (outer**4 - inner**4) / 64] * 2),
    "rectangle": lambda height, width: (height * width, width * height**3 / 12, height * width**3 / 12),
}


def _torsion_of_rectangle(height, width):
    """Saint-Venant's constant by Prandtl's stress function (Timoshenko and Goodier, Theory of Elasticity, 109), whichever side is longer, as
    long as they differ by less than six times: what is left of 1 − tanh then is below 1e-16."""
    odd = range(1, 80, 2)
    fifths = sum(n**-5.0 for n in range(20001, 0, -2))
    lacking = sum(2 / (1 + ca.exp(n * ca.pi * height / width)) / n**5 for n in odd)
    return height * width**3 / 3 - 64 / ca.pi**5 * width**4 * (fifths - lacking)


@functools.cache
def _root(number, sign):
    """cos λ cosh λ = sign by bisection; the rigid motions of a free beam have no number."""
    middle = (number + (1.5 if sign > 0 else 0.5)) * math.pi
    low, high = middle - 0.5, middle + 0.5
    value = lambda x: math.cos(x) - sign / math.cosh(x)
    for _ in range(100):
        half = (low + high) / 2
        low, high = (half, high) if value(low) * value(half) > 0 else (low, half)
    return (low + high) / 2


def _sine(lam, xi, order):
    return lam**order * math.sin(lam * xi + order * math.pi / 2)


def _free_bending(number, xi, order):
    """Even or odd about the middle: cos λs / cos(λ/2) + cosh λs / cosh(λ/2), or with sines; 2 at the start."""
    lam = _root(number, 1.0)
    s, half = xi - 0.5, lam / 2
    if number % 2 == 0:
        trigonometric = _sine(lam, s + math.pi / 2 / lam, order) / math.cos(half)
        hyperbolic = (math.cosh if order % 2 == 0 else math.sinh)(lam * s) / math.cosh(half)
        return trigonometric + lam**order * hyperbolic
    trigonometric = _sine(lam, s, order) / math.sin(half)
    hyperbolic = (math.sinh if order % 2 == 0 else math.cosh)(lam * s) / math.sinh(half)
    return -trigonometric - lam**order * hyperbolic


def _clamped_bending(number, xi, order):
    """(cosh λ(1 − ξ) + cos λ cosh λξ + sin λ sinh λξ)/(cosh λ + cos λ) − cos λξ + σ sin λξ."""
    lam = _root(number, -1.0)
    cosh, sinh, cos, sin = math.cosh(lam), math.sinh(lam), math.cos(lam), math.sin(lam)
    sigma = (sinh - sin) / (cosh + cos)
    even = math.cosh if order % 2 == 0 else math.sinh
    odd = math.sinh if order % 2 == 0 else math.cosh
    back = (-1) ** order * even(lam * (1 - xi))
    hyperbolic = (back + cos * even(lam * xi) + sin * odd(lam * xi)) / (cosh + cos)
    return lam**order * hyperbolic - _sine(lam, xi + math.pi / 2 / lam, order) + sigma * _sine(lam, xi, order)


def _quarters(number, xi, order):
    return _sine((2 * number + 1) * math.pi / 2, xi, order)


SHAPES = {
    ("free", "axial"): lambda number, xi, order: _sine((number + 1) * math.pi, xi + 0.5 / (number + 1), order),
    ("free", "bending"): _free_bending,
    ("clamped", "axial"): _quarters,
    ("clamped", "bending"): _clamped_bending,
    ("pinned", "axial"): _quarters,
    ("pinned", "bending"): lambda number, xi, order: _sine((number + 1) * math.pi, xi, order),
}
