"""The Franka Panda's forward dynamics and Bricard's mechanism, as an expert writes them around CasADi.

    (angles, rates, (2α, β²), torques) -> (accelerations, multipliers)

Names that end in `_turns` take cosine and sine of each angle in place of the angle. Data: models/src/panda.rs and
models/src/bricard.rs of this project.
"""

import casadi as ca

from trees import AXES, Link, Tree, add, cross, transposed

# The turn of URDF's rpy (±π/2, 0, 0): columns are the axes of the next joint.
UP = [[1, 0, 0], [0, 0, 1], [0, -1, 0]]
DOWN = [[1, 0, 0], [0, 0, -1], [0, 1, 0]]
SAME = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]

# Place, axes, mass, centre, moments of inertia about it, products (Ixy, Ixz, Iyz).
PANDA = [
    ((0, 0, 0.333), SAME, 4.970684, (0.003875, 0.002081, -0.04762),
     (0.70337, 0.70661, 0.009117), (-0.000139, 0.006772, 0.019169)),
    ((0, 0, 0), UP, 0.646926, (-0.003141, -0.02872, 0.003495),
     (0.007962, 0.02811, 0.025995), (-0.003925, 0.010254, 0.000704)),
    ((0, -0.316, 0), DOWN, 3.228604, (0.027518, 0.039252, -0.066502),
     (0.037242, 0.036155, 0.01083), (-0.004761, -0.011396, -0.012805)),
    ((0.0825, 0, 0), DOWN, 3.587895, (-0.05317, 0.104419, 0.027454),
     (0.025853, 0.019552, 0.028323), (0.007796, -0.001332, 0.008641)),
    ((-0.0825, 0.384, 0), UP, 1.225946, (-0.011953, 0.041065, -0.038437),
     (0.035549, 0.029474, 0.008627), (-0.002117, -0.004037, 0.000229)),
    ((0, 0, 0), DOWN, 1.666555, (0.060149, -0.014117, -0.010517),
     (0.001964, 0.004354, 0.005433), (0.000109, -0.001158, 0.000341)),
    ((0.088, 0, 0), DOWN, 0.735522, (0.010517, -0.004252, 0.061597),
     (0.012516, 0.010027, 0.004815), (-0.000428, -0.001196, -0.000741)),
]


class Symbols:
    """Angles or their cosines and sines, rates, gains, torques."""

    def __init__(self, size, turns):
        self.first = ca.SX.sym("turns", 2 * size) if turns else ca.SX.sym("q", size)
        split = [(self.first[2 * i], self.first[2 * i + 1]) for i in range(size)] if turns else None
        self.turns = split or [(ca.cos(self.first[i]), ca.sin(self.first[i])) for i in range(size)]
        self.v, self.gains = ca.SX.sym("v", size), ca.SX.sym("gains", 2)
        self.torques = ca.SX.sym("torques", size)
        self.all = [self.first, self.v, self.gains, self.torques]

    def function(self, name, *results):
        """After common subexpressions have been found."""
        return ca.Function(name, self.all, ca.cse(list(results)))


def panda(symbols):
    links = [Link(i - 1 if i else None, *data) for i, data in enumerate(PANDA)]
    return Tree(links, symbols.turns, (0, 0, -9.81))


def panda_articulated(name, turns):
    symbols = Symbols(7, turns)
    return symbols.function(name, panda(symbols).articulated_bodies(symbols.v, symbols.torques), ca.SX(0, 1))


def panda_eliminated(name, turns):
    """CRBA, RNEA, symbolic LDLᵀ. The chain is eliminated from the hand inwards, as its branches would need."""
    symbols = Symbols(7, turns)
    tree = panda(symbols)
    bias, _ = tree.inverse_dynamics(symbols.v)
    order = list(reversed(range(7)))
    d, lt, p = ca.ldl(tree.mass_matrix()[order, order], False)
    acceleration = ca.ldl_solve((symbols.torques - bias)[order], d, lt, p)[order]
    return symbols.function(name, acceleration, ca.SX(0, 1))


def panda_parts():
    """Inverse dynamics and mass matrix alone, only to be counted."""
    symbols, a = Symbols(7, True), ca.SX.sym("a", 7)
    tree = panda(symbols)
    torques, _ = tree.inverse_dynamics(symbols.v, a)
    yield ca.Function("panda_rnea_turns", [symbols.first, symbols.v, a], ca.cse([torques]))
    lower = ca.tril(tree.mass_matrix())
    yield ca.Function("panda_crba_turns", [symbols.first], ca.cse([lower]))


# Hinges y, z from the ground to rod 2; x, z, y from the ground to rod 3, each rod to the next outwards. Place in the
# parent, world axes; axis; the rod's axis and centre from its hinge.
BRICARD = [
    (None, (0, 0, 0), 1, 0, (0.5, 0, 0)),
    (0, (1, 0, 0), 2, 1, (0, -0.5, 0)),
    (None, (0, 0, 1), 0, 1, (0, -0.5, 0)),
    (2, (0, -1, 0), 2, 0, (0.5, 0, 0)),
    (3, (1, 0, 0), 1, 2, (0, 0, -0.5)),
]


def bricard(name, turns, kept=2):
    """Hinge 3, between rods 2 and 3 about x at (1, −1, 0), is cut; of its two rows y'·x'' and z'·x'' one, which follows from the others,
    is left out. Accelerations are the same with either; simulations with y'·x'' (`kept` 1) have errors 1e-5 of those with z'·x''."""
    symbols = Symbols(5, turns)
    v = symbols.v
    # Columns: the axes of a link's frame at angle zero in world axes, z along the hinge: a signed permutation.
    frames = [[[int(row == (axis + 1 + k) % 3) for k in AXES] for row in AXES] for _, _, axis, _, _ in BRICARD]
    links = []
    for (parent, place, _, along, center), frame in zip(BRICARD, frames):
        before = SAME if parent is None else frames[parent]
        axes = [[sum(before[k][i] * frame[k][j] for k in AXES) for j in AXES] for i in AXES]
        into = lambda vector, frame: [sum(frame[k][i] * vector[k] for k in AXES) for i in AXES]
        # Square rod of 1 m and 0.1 m: (0.1² + 0.1²)/12 about itself, (1 + 0.1²)/12 across.
        tensor = [0.02 / 12 if k == along else 1.01 / 12 for k in AXES]
        links.append(Link(parent, into(place, before), axes, 1.0, into(center, frame), into(tensor, frame)))
    tree = Tree(links, symbols.turns, (0, -9.81, 0))
    bias, _ = tree.inverse_dynamics(v)
    mass = tree.mass_matrix()

    # World axes outwards: where the hinges are and point, and what the ends do at zero accelerations of the angles.
    def chain(numbers, end):
        position, velocity, change = [0, 0, 0], [0, 0, 0], [0, 0, 0]
        spin, spin_change, hinges = [0, 0, 0], [0, 0, 0], []
        columns = SAME
        world = lambda vector: [sum((columns[k][row] * vector[k] for k in AXES), ca.SX(0)) for row in AXES]

        def step(arm, position, velocity, change):
            turned = cross(spin, arm)
            bent = add(cross(spin_change, arm), cross(spin, turned))
            return add(position, arm), add(velocity, turned), add(change, bent)

        for i in numbers:
            position, velocity, change = step(world(links[i].r), position, velocity, change)
            # The link's axes in world axes: the parent's times P, turned about z.
            x, y, z = (world(column) for column in transposed(links[i].axes))
            c, s = symbols.turns[i]
            columns = [
                [c * a + s * b for a, b in zip(x, y)],
                [c * b - s * a for a, b in zip(x, y)],
                z,
            ]
            turn = [v[i] * e for e in z]
            spin_change = add(spin_change, cross(spin, turn))
            spin = add(spin, turn)
            hinges.append((i, z, position))
        back = [sum(frames[numbers[-1]][k][i] * end[k] for k in AXES) for i in AXES]
        position, velocity, change = step(world(back), position, velocity, change)
        axes = [world([frames[numbers[-1]][k][i] for i in AXES]) for k in AXES]
        return position, velocity, change, spin, spin_change, hinges, axes

    # From the last hinge of each chain to hinge 3.
    first, second = chain([0, 1], (0, -1, 0)), chain([2, 3, 4], (0, 0, -1))
    minus = lambda a, b: [x - y for x, y in zip(a, b)]
    dot = lambda a, b: sum((x * y for x, y in zip(a, b)), ca.SX(0))
    jacobian = ca.SX(4, 5)
    # Φ = p'' − p' and one of the two. D v, and γ from the accelerations at zero angular accelerations.
    phi, speed, gamma = minus(second[0], first[0]), minus(second[1], first[1]), minus(first[2], second[2])
    x, z = second[6][0], first[6][kept]
    for sign, part in ((-1, first), (1, second)):
        for i, axis, place in part[5]:
            column = cross(axis, minus(part[0], place))
            for row in AXES:
                jacobian[row, i] = sign * column[row]
            # d/dt z'·x'' = (ω'' − ω')·(x'' × z')
            jacobian[3, i] = sign * dot(axis, cross(x, z))
    relative = minus(second[3], first[3])
    normal = cross(x, z)
    turning = add(cross(cross(second[3], x), z), cross(x, cross(first[3], z)))
    phi.append(dot(z, x))
    speed.append(dot(relative, normal))
    gamma.append(-dot(minus(second[4], first[4]), normal) - dot(relative, turning))
    target = ca.vertcat(*gamma) - symbols.gains[0] * ca.vertcat(*speed) - symbols.gains[1] * ca.vertcat(*phi)

    # M = L δ Lᵀ in two blocks; S = (L⁻¹ Dᵀ)ᵀ δ⁻¹ (L⁻¹ Dᵀ), half of the solution for each.
    order = [1, 0, 4, 3, 2]
    d, lt, _ = ca.ldl(mass[order, order], False)
    half = ca.horzcat(jacobian.T, -bias)[order, :]
    half = forward(lt, half)
    scaled = ca.SX(half)
    for i in range(5):
        scaled[i, :] = half[i, :] / d[i]
    spread, free = half[:, :4], scaled[:, 4]
    e, mt, p = ca.ldl(ca.mtimes(spread.T, scaled[:, :4]), False)
    multipliers = ca.ldl_solve(ca.mtimes(spread.T, free) - target, e, mt, p)
    acceleration = backward(lt, free - ca.mtimes(scaled[:, :4], multipliers))
    result = ca.SX(5, 1)
    for k, i in enumerate(order):
        result[i] = acceleration[k]
    return symbols.function(name, result, multipliers)


def forward(lt, columns):
    """L⁻¹ B of unit L."""
    result = ca.SX(columns)
    for i in range(result.rows()):
        for k in range(i):
            if lt.sparsity().has_nz(k, i):
                result[i, :] = result[i, :] - lt[k, i] * result[k, :]
    return result


def backward(lt, columns):
    """L⁻ᵀ B of unit L."""
    result = ca.SX(columns)
    for i in reversed(range(result.rows())):
        for k in range(i + 1, result.rows()):
            if lt.sparsity().has_nz(i, k):
                result[i, :] = result[i, :] - lt[i, k] * result[k, :]
    return result


def functions():
    for suffix in ("", "_turns"):
        yield panda_articulated("panda_aba" + suffix, bool(suffix))
        yield panda_eliminated("panda_ldl" + suffix, bool(suffix))
        yield bricard("bricard" + suffix, bool(suffix))
