"""Andrews' squeezer, as an expert writes it around CasADi.

    (angles, rates, (2α, β²)) -> (accelerations, multipliers)

Coordinates: the absolute angles of the seven bodies in the order of models/src/andrews.rs, whose data these are; names that
end in `_turns` take cosine and sine of each angle instead. Four chains lead from the ground to the point E, the two of
one body or two: M has blocks of two, and three loops close, six rows. Two ways from there:

`andrews_ldl`: M inverted by blocks, D M⁻¹ Dᵀ factored by CasADi's symbolic LDLᵀ. Of the 96 orders of three loops this has
the fewest operations.

`andrews_crank`: all accelerations are n α + p with α that of the crank; n and p, and λ by the same three determinants, by
Cramer's rule. It takes that in no position of the motion two arms of a pair solved for are in line: link and triangle, upper
and left, lower and right.
"""

import collections
import contextlib
import itertools
import math

import casadi as ca

from plane import eliminated
from space import Symbols

# Mass, moment about the centre; centre and outer pin from the inner pin.
Body = collections.namedtuple("Body", "mass moment center end")
CRANK, LINK, TRIANGLE, LEFT, UPPER, RIGHT, LOWER = range(7)
BODIES = [
    Body(0.04325, 2.194e-6, (0.00092, 0), (0.007, 0)),
    Body(0.00365, 4.410e-7, (-0.0115, 0), (-0.028, 0)),
    Body(0.02373, 5.255e-6, (0.01043, -0.01874), (0, -0.035)),
    Body(0.00706, 5.667e-7, (0, 0.01421 - 0.02), (0, -0.02)),
    Body(0.0705, 1.169e-5, (0.02308, 0.00916), (0.04, 0)),
    Body(0.00706, 5.667e-7, (0.02 - 0.01421, 0), (0.02, 0)),
    Body(0.05498, 1.912e-5, (-0.00449, -0.01228), (0, -0.04)),
]
# Bodies from the ground to E, and the pin on the ground.
CHAINS = [
    ((CRANK, LINK), (0, 0)),
    ((TRIANGLE,), (-0.03635, 0.03273)),
    ((UPPER, LEFT), (-0.06934, -0.00227)),
    ((LOWER, RIGHT), (-0.06934, -0.00227)),
]
# Loops of two chains, for LDLᵀ and for Cramer's rule.
PATH = ((0, 2), (0, 1), (1, 3))
STAR = ((0, 1), (2, 1), (3, 1))
MOTOR = 0.033
# Point D of the triangle, the spring's end C on the ground, stiffness, free length.
SPRING = (0.02, -0.018), (0.014, 0.072), 4530.0, 0.07785


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1]


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def across(a):
    """What a unit of angular velocity makes of an arm."""
    return [-a[1], a[0]]


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


@contextlib.contextmanager
def as_written():
    """CasADi makes x / y of x (1 / y), so that each product with an inverted determinant would be a division."""
    ca.GlobalOptions.setSimplificationOnTheFly(False)
    try:
        yield
    finally:
        ca.GlobalOptions.setSimplificationOnTheFly(True)


def scaled(values, factor):
    with as_written():
        return [value * factor for value in values]


class Andrews:
    """M, forces, arms in world axes, and for each chain −(2α ẋ + β² x) of E less its acceleration at v̇ = 0."""

    def __init__(self, turns):
        self.symbols = Symbols(7, turns)
        self.turns, self.v, self.gains = self.symbols.turns, self.symbols.v, self.symbols.gains
        self.square = [self.v[i] * self.v[i] for i in range(7)]
        self.arms = [self.arm(i) for i in range(7)]
        self.mass, self.forces = ca.SX(7, 7), ca.SX(7, 1)
        for numbers, _ in CHAINS:
            self.inertia(*numbers)
        self.forces[CRANK] += MOTOR
        self.forces[TRIANGLE] += self.spring()
        self.ends = [[self.end(numbers, pin, k) for k in (0, 1)] for numbers, pin in CHAINS]

    def arm(self, i):
        (c, s), (x, y) = self.turns[i], BODIES[i].end
        return [c * x - s * y, s * x + c * y]

    def inertia(self, inner, outer=None):
        """About the pin on the ground; of a second body about the first one's outer pin, where its mass is the first one's too."""
        for i in (inner,) if outer is None else (inner, outer):
            body = BODIES[i]
            self.mass[i, i] = body.moment + body.mass * dot(body.center, body.center)
        if outer is None:
            return
        arm, (mass, _, center, _) = BODIES[inner].end, BODIES[outer]
        self.mass[inner, inner] += mass * dot(arm, arm)
        # By the difference of the angles. Arm and centre are in line or at right angles: one of the products is zero.
        (c, s), (cosine, sine) = self.turns[inner], self.turns[outer]
        cosine, sine = c * cosine + s * sine, c * sine - s * cosine
        along, beside = mass * dot(arm, center), mass * cross(arm, center)
        self.mass[inner, outer] = self.mass[outer, inner] = along * cosine - beside * sine
        skew = along * sine + beside * cosine
        self.forces[inner] += skew * self.square[outer]
        self.forces[outer] -= skew * self.square[inner]

    def spring(self):
        """Torque k (1 − l₀/l) d × (e − d), e from B to C. As d × d is zero and |d| constant, d·e and d × e are enough."""
        point, ground, stiffness, free = SPRING
        e = minus(ground, CHAINS[1][1])
        c, s = self.turns[TRIANGLE]
        along, beside = dot(point, e), cross(point, e)
        length = ca.sqrt(dot(point, point) + dot(e, e) - 2 * (c * along + s * beside))
        return stiffness * (1 - free / length) * (c * beside - s * along)

    def end(self, numbers, pin, k):
        position = sum((self.arms[i][k] for i in numbers), ca.SX(pin[k]))
        speed = sum(across(self.arms[i])[k] * self.v[i] for i in numbers)
        bent = sum(self.arms[i][k] * self.square[i] for i in numbers)
        return bent - self.gains[0] * speed - self.gains[1] * position

    def closing(self, loops):
        """D and what D v̇ must be."""
        jacobian, target = ca.SX(6, 7), []
        for at, (first, second) in enumerate(loops):
            for sign, chain in ((1, first), (-1, second)):
                for i in CHAINS[chain][0]:
                    jacobian[2 * at : 2 * at + 2, i] = sign * ca.vertcat(*across(self.arms[i]))
            target += minus(self.ends[first], self.ends[second])
        return jacobian, ca.vertcat(*target)

    def inverse(self):
        """M⁻¹ by blocks."""
        inverse = ca.SX(7, 7)
        for numbers, _ in CHAINS:
            block = self.mass[numbers, numbers]
            if len(numbers) == 1:
                inverse[numbers, numbers] = 1 / block
                continue
            determinant = block[0, 0] * block[1, 1] - block[0, 1] * block[0, 1]
            for i, j in ((0, 1), (1, 0)):
                inverse[numbers[i], numbers[i]] = block[j, j] / determinant
                inverse[numbers[i], numbers[j]] = -block[i, j] / determinant
        return inverse

    def function(self, name, results, loops):
        """After common subexpressions have been found, and a look whether the equations hold."""
        jacobian, target = self.closing(loops)
        acceleration, multipliers = results
        rows = ca.mtimes(self.mass, acceleration) + ca.mtimes(jacobian.T, multipliers) - self.forces
        inputs = self.symbols.all[:3]
        left = ca.Function("left", inputs, [ca.norm_inf(rows), ca.norm_inf(ca.mtimes(jacobian, acceleration) - target)])
        angles = [0.3 + i * i for i in range(7)]
        turns = [turn(angle) for angle in angles for turn in (math.cos, math.sin)]
        state = [turns if name.endswith("_turns") else angles, [10 - 4 * i for i in range(7)], [20, 100]]
        worst = [float(row) for row in left(*state)]
        if not max(worst) < 1e-10:
            raise ArithmeticError(f"{name}: rows are {worst} off")
        with as_written():
            return ca.Function(name, inputs, ca.cse(results))


def by_elimination(name, turns):
    model = Andrews(turns)
    jacobian, target = model.closing(PATH)
    return model.function(name, eliminated(model.inverse(), model.forces, jacobian, target), PATH)


class Pair:
    """a' x + b' y = w and its transpose, where a' is a turned by a right angle: b·a' = a × b."""

    def __init__(self, a, b):
        self.a, self.b, self.factor = a, b, 1 / cross(a, b)

    def rates(self, w):
        return scaled([dot(self.b, w), -dot(self.a, w)], self.factor)

    def force(self, x, y):
        return scaled([b * x - a * y for a, b in zip(self.a, self.b)], self.factor)


def by_crank(name, turns):
    model = Andrews(turns)
    arms, anchor = model.arms, model.ends[1]
    triangle = across(arms[TRIANGLE])
    null, free = [ca.SX(1)] + [ca.SX(0)] * 6, [ca.SX(0)] * 7
    first = Pair(arms[LINK], arms[TRIANGLE])
    for solution, w in ((null, minus((0, 0), across(arms[CRANK]))), (free, minus(model.ends[0], anchor))):
        solution[LINK], opposite = first.rates(w)
        solution[TRIANGLE] = -opposite
    others = [(inner, outer, Pair(arms[inner], arms[outer])) for (inner, outer), _ in CHAINS[2:]]
    for (inner, outer, pair), end in zip(others, model.ends[2:]):
        for solution, rest in ((null, (0, 0)), (free, minus(end, anchor))):
            w = [part + solution[TRIANGLE] * each for part, each in zip(rest, triangle)]
            solution[inner], solution[outer] = pair.rates(w)
    null, free = ca.vertcat(*null), ca.vertcat(*free)
    rest, moved = model.forces - ca.mtimes(model.mass, free), ca.mtimes(model.mass, null)
    crank = ca.dot(null, rest) / ca.dot(null, moved)
    rest -= crank * moved
    forces = [pair.force(rest[inner], rest[outer]) for inner, outer, pair in others]
    # What is left of the triangle's row, which stands in all three loops, after the forces of the two.
    torque = rest[TRIANGLE] + sum(dot(triangle, force) for force in forces)
    forces.insert(0, first.force(rest[LINK], -torque))
    return model.function(name, [free + crank * null, ca.vertcat(*itertools.chain(*forces))], STAR)


def functions():
    for suffix in ("", "_turns"):
        yield by_elimination("andrews_ldl" + suffix, bool(suffix))
        yield by_crank("andrews_crank" + suffix, bool(suffix))
