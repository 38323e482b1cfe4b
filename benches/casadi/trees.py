"""Algorithms over trees of revolute links, as an expert writes them with CasADi's SX.

Links are numbered outwards. The frame of a link has its origin on its joint and z along it, so that a link's
transform is a constant rotation and translation, then a turn about z. Spatial vectors are pairs (angular, linear) of
lists in the frame of the link; inertias are kept in 3×3 blocks [I, H; Hᵀ, M], I and M symmetric. Zeros and ones of
constants vanish as CasADi builds the expression, so that only what the geometry needs is computed.

Source: Featherstone, Rigid Body Dynamics Algorithms (2008): RNEA table 5.1, CRBA table 6.2, articulated bodies table
7.1, turns of inertias about z by appendix A.
"""

import casadi as ca

AXES = range(3)


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def add(a, b):
    return [x + y for x, y in zip(a, b)]


def times(matrix, vector):
    return [sum((matrix[i][j] * vector[j] for j in AXES if not is_zero(matrix[i][j])), ca.SX(0)) for i in AXES]


def transposed(matrix):
    return [list(row) for row in zip(*matrix)]


def product(a, b):
    return transposed([times(a, column) for column in transposed(b)])


def is_zero(value):
    return value.is_zero() if isinstance(value, ca.SX) else value == 0


def tilde(r):
    return [[0, -r[2], r[1]], [r[2], 0, -r[0]], [-r[1], r[0], 0]]


def without(block, x, y):
    """block − x yᵀ"""
    return [[block[a][b] - x[a] * y[b] for b in AXES] for a in AXES]


class Link:
    """Mass, centre and tensor about it; place r of its frame in the parent's, its axes there at angle zero."""

    def __init__(self, parent, place, axes, mass, center, inertia, products=(0, 0, 0)):
        self.parent, self.r, self.axes = parent, list(place), axes
        (xx, yy, zz), (xy, xz, yz), (x, y, z) = inertia, products, center
        self.mass = mass
        self.moment = [mass * c for c in center]
        # About the origin: I + m (c·c 1 − c cᵀ).
        self.inertia = [
            [xx + mass * (y * y + z * z), xy - mass * x * y, xz - mass * x * z],
            [xy - mass * x * y, yy + mass * (x * x + z * z), yz - mass * y * z],
            [xz - mass * x * z, yz - mass * y * z, zz + mass * (x * x + y * y)],
        ]


class Tree:
    def __init__(self, links, turns, gravity):
        self.links, self.turns, self.gravity = links, turns, gravity
        self.size = range(len(links))

    def inwards(self, i, vector):
        """Components in the parent's axes."""
        c, s = self.turns[i]
        x, y, z = vector
        return times(self.links[i].axes, [c * x - s * y, s * x + c * y, z])

    def outwards(self, i, vector):
        c, s = self.turns[i]
        x, y, z = times(transposed(self.links[i].axes), vector)
        return [c * x + s * y, c * y - s * x, z]

    def motion_outwards(self, i, motion):
        angular, linear = motion
        return self.outwards(i, angular), self.outwards(i, add(linear, cross(angular, self.links[i].r)))

    def force_inwards(self, i, force):
        angular, linear = (self.inwards(i, part) for part in force)
        return add(angular, cross(self.links[i].r, linear)), linear

    def symmetric_inwards(self, i, block):
        c, s = self.turns[i]
        sine, cosine = 2 * s * c, 1 - 2 * s * s
        xx, yy, xy, xz, yz, zz = block[0][0], block[1][1], block[1][0], block[2][0], block[2][1], block[2][2]
        change = s * s * (xx - yy) + sine * xy
        mixed = s * c * (xx - yy) + cosine * xy
        x, y = c * xz - s * yz, s * xz + c * yz
        turned = [[xx - change, mixed, x], [mixed, yy + change, y], [x, y, zz]]
        return product(product(self.links[i].axes, turned), transposed(self.links[i].axes))

    def general_inwards(self, i, block):
        c, s = self.turns[i]
        sine, cosine = 2 * s * c, 1 - 2 * s * s
        mean, spin = 0.5 * (block[0][0] + block[1][1]), 0.5 * (block[0][1] - block[1][0])
        p, q = 0.5 * (block[0][0] - block[1][1]), 0.5 * (block[0][1] + block[1][0])
        p, q = cosine * p - sine * q, sine * p + cosine * q
        last = [c * block[0][2] - s * block[1][2], s * block[0][2] + c * block[1][2]]
        row = [c * block[2][0] - s * block[2][1], s * block[2][0] + c * block[2][1]]
        turned = [[mean + p, q + spin, last[0]], [q - spin, mean - p, last[1]], row + [block[2][2]]]
        return product(product(self.links[i].axes, turned), transposed(self.links[i].axes))

    def velocities(self, v):
        """Spatial velocities, and velocity products of the accelerations."""
        velocities, biases = [], []
        for i in self.size:
            parent, zero = self.links[i].parent, [ca.SX(0)] * 3
            angular, linear = ([0] * 3, [0] * 3) if parent is None else velocities[parent]
            angular, linear = self.motion_outwards(i, (angular, linear)) if parent is not None else (zero, zero)
            turn = [0, 0, v[i]]
            biases.append((cross(angular, turn), cross(linear, turn)))
            velocities.append((add(angular, turn), linear))
        return velocities, biases

    def momentum_rate(self, i, velocity):
        """v ×* I v."""
        link, (angular, linear) = self.links[i], velocity
        spin = add(times(link.inertia, angular), cross(link.moment, linear))
        push = add([link.mass * x for x in linear], cross(angular, link.moment))
        return add(cross(angular, spin), cross(linear, push)), cross(angular, push)

    def rest(self):
        return [0, 0, 0], [-g for g in self.gravity]

    def inverse_dynamics(self, v, a=None):
        """Torques for accelerations a (zero if none), and the accelerations of the links with gravity in them."""
        velocities, biases = self.velocities(v)
        forces, accelerations = [], []
        for i in self.size:
            link = self.links[i]
            before = self.rest() if link.parent is None else accelerations[link.parent]
            angular, linear = (add(x, y) for x, y in zip(self.motion_outwards(i, before), biases[i]))
            if a is not None:
                angular = add(angular, [0, 0, a[i]])
            accelerations.append((angular, linear))
            spin, push = self.momentum_rate(i, velocities[i])
            spin = add(spin, add(times(link.inertia, angular), cross(link.moment, linear)))
            push = add(push, add([link.mass * x for x in linear], cross(angular, link.moment)))
            forces.append((spin, push))
        torques = ca.SX(len(self.links), 1)
        for i in reversed(self.size):
            torques[i] = forces[i][0][2]
            parent = self.links[i].parent
            if parent is not None:
                forces[parent] = tuple(add(x, y) for x, y in zip(forces[parent], self.force_inwards(i, forces[i])))
        return torques, accelerations

    def mass_matrix(self):
        """Composite rigid bodies: mass, first moment and tensor about the origin."""
        composites = [(link.mass, link.moment, link.inertia) for link in self.links]
        matrix = ca.SX(len(self.links), len(self.links))
        for i in reversed(self.size):
            mass, moment, inertia = composites[i]
            force = [inertia[k][2] for k in AXES], cross([0, 0, 1], moment)
            matrix[i, i] = inertia[2][2]
            at = i
            while self.links[at].parent is not None:
                force = self.force_inwards(at, force)
                at = self.links[at].parent
                matrix[i, at] = matrix[at, i] = force[0][2]
            parent, r = self.links[i].parent, self.links[i].r
            if parent is not None:
                # About the parent's origin: − r̃ h̃ − h̃ r̃ − m r̃ r̃, that is − r̃ (h + m r)~ − h̃ r̃.
                inertia, h = self.symmetric_inwards(i, inertia), self.inwards(i, moment)
                total = add(h, [mass * x for x in r])
                first, second = product(tilde(r), tilde(total)), product(tilde(h), tilde(r))
                inertia = [[inertia[a][b] - first[a][b] - second[a][b] for b in AXES] for a in AXES]
                inertia = [[inertia[max(a, b)][min(a, b)] for b in AXES] for a in AXES]
                own = composites[parent]
                matrices = [add(x, y) for x, y in zip(own[2], inertia)]
                composites[parent] = own[0] + mass, add(own[1], total), matrices
        return matrix

    def articulated_bodies(self, v, torques):
        """Accelerations; no linear system is formed."""
        velocities, biases = self.velocities(v)
        inertias = []
        forces = []
        for i in self.size:
            link = self.links[i]
            diagonal = [[link.mass if a == b else 0 for b in AXES] for a in AXES]
            inertias.append((link.inertia, tilde(link.moment), diagonal))
            forces.append(self.momentum_rate(i, velocities[i]))
        eliminated = [None] * len(self.links)
        for i in reversed(self.size):
            (inertia, mixed, mass), (spin, push) = inertias[i], forces[i]
            column = [inertia[k][2] for k in AXES], [mixed[2][k] for k in AXES]
            pivot, rest = 1 / inertia[2][2], torques[i] - spin[2]
            eliminated[i] = column, pivot, rest
            parent, r = self.links[i].parent, self.links[i].r
            if parent is None:
                continue
            scaled = [x * pivot for x in column[0]], [x * pivot for x in column[1]]
            inertia = without(inertia, column[0], scaled[0])
            mixed = without(mixed, column[0], scaled[1])
            mass = without(mass, column[1], scaled[1])
            # What is left about the axis is zero.
            for k in AXES:
                inertia[2][k] = inertia[k][2] = mixed[2][k] = ca.SX(0)
            angular, linear = biases[i]
            spin = add(spin, add(times(inertia, angular), times(mixed, linear)))
            push = add(push, add(times(transposed(mixed), angular), times(mass, linear)))
            spin = add(spin, [x * rest for x in scaled[0]])
            push = add(push, [x * rest for x in scaled[1]])
            # As it must: the axis passes on the torque of its motor and nothing else.
            spin[2] = torques[i]
            force = self.force_inwards(i, (spin, push))
            forces[parent] = tuple(add(x, y) for x, y in zip(forces[parent], force))
            inertia, mass = self.symmetric_inwards(i, inertia), self.symmetric_inwards(i, mass)
            mixed = self.general_inwards(i, mixed)
            moved = [add(x, y) for x, y in zip(mixed, product(tilde(r), mass))]
            # I − H r̃ + r̃ (H + r̃ M)ᵀ
            first, second = product(mixed, tilde(r)), product(tilde(r), transposed(moved))
            inertia = [[inertia[a][b] - first[a][b] + second[a][b] for b in AXES] for a in AXES]
            inertia = [[inertia[max(a, b)][min(a, b)] for b in AXES] for a in AXES]
            blocks = inertia, moved, mass
            inertias[parent] = tuple([add(x, y) for x, y in zip(p, q)] for p, q in zip(inertias[parent], blocks))
        result, accelerations = ca.SX(len(self.links), 1), []
        for i in self.size:
            parent = self.links[i].parent
            before = self.rest() if parent is None else accelerations[parent]
            angular, linear = (add(x, y) for x, y in zip(self.motion_outwards(i, before), biases[i]))
            column, pivot, rest = eliminated[i]
            for x, y in zip(column[0] + column[1], angular + linear):
                rest = rest - x * y
            result[i] = rest * pivot
            accelerations.append((add(angular, [0, 0, result[i]]), linear))
        return result


def counts(function):
    """Additions (with negations), multiplications (with squares), divisions, square roots, sines and cosines."""
    kinds = {
        "+": (ca.OP_ADD, ca.OP_SUB, ca.OP_NEG, ca.OP_TWICE),
        "×": (ca.OP_MUL, ca.OP_SQ),
        "÷": (ca.OP_DIV, ca.OP_INV),
        "√": (ca.OP_SQRT,),
        "sin, cos": (ca.OP_SIN, ca.OP_COS),
    }
    found = [function.instruction_id(k) for k in range(function.n_instructions())]
    moves = (ca.OP_INPUT, ca.OP_OUTPUT, ca.OP_CONST)
    result = {name: sum(found.count(op) for op in ops) for name, ops in kinds.items()}
    result["other"] = sum(op not in moves for op in found) - sum(result.values())
    return result
