"""C code for the four-bar ladders, as an expert writes it around CasADi; for space.py's mechanisms likewise.

    python benches/casadi/generate.py DIRECTORY

Prints the operations of each function after common subexpressions have been found.

Coordinates: the absolute angles of all rods, cranks first, then couplers (the couplers ride on their left cranks, so
each window has one loop closure of two rows). M has blocks of two, inverted by hand; the Schur complement D M⁻¹ Dᵀ is
factored by CasADi's symbolic sparse LDLᵀ, in the natural order of the chain. Everything is one straight-line function

    (angles, rates, (2α, β²)) -> (accelerations, multipliers)

whose C is compiled by gcc -O3, and into DIRECTORY/native by gcc -O3 -march=native. Rods of 1 m and 1 kg, pins 1 m apart, g = 9.81 m/s².
"""

import itertools
import pathlib
import subprocess
import sys

import casadi as ca

import space
import trees


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
    spread = ca.mtimes(inverse, jacobian.T)
    free = ca.mtimes(inverse, forces)
    d, lt, p = ca.ldl(ca.mtimes(jacobian, spread), False)
    multipliers = ca.ldl_solve(ca.mtimes(jacobian, free) - target, d, lt, p)
    acceleration = free - ca.mtimes(spread, multipliers)
    return ca.Function(name, [q, v, gains], ca.cse([acceleration, multipliers]))


def main():
    directory = pathlib.Path(sys.argv[1])
    (directory / "native").mkdir(parents=True, exist_ok=True)
    ladders = (("four_bar", 1), ("n_four_bar_10", 10), ("n_four_bar_40", 40))
    for made in itertools.chain((function(*ladder) for ladder in ladders), space.functions()):
        name = made.name()
        made.generate(f"{name}.c", {"with_header": False})
        pathlib.Path(f"{name}.c").rename(directory / f"{name}.c")
        for target, flags in ((".", []), ("native", ["-march=native"])):
            command = ["gcc", "-O3", *flags, "-shared", "-fPIC", f"{name}.c", "-o", f"{target}/{name}.so", "-lm"]
            subprocess.run(command, cwd=directory, check=True)
        (directory / f"{name}.operations").write_text(str(report(made)))
    for part in space.panda_parts():
        report(part)


def report(made):
    """Prints the counts of a function; their sum."""
    counts = trees.counts(made)
    total = sum(counts.values())
    print(f"{made.name():<18}{total:>6}  " + "  ".join(f"{kind} {n}" for kind, n in counts.items() if n))
    return total


if __name__ == "__main__":
    main()
