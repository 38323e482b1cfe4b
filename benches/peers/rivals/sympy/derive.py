"""SymPy in the hands of a careful user: C of a linkage in the plane, (q, v) → v̇ in the angles of its hinges.

    python derive.py LINKAGE.json NAME OUT.c

Absolute angles are taken as unknowns, which keeps M and D short; T and V are differentiated by SymPy. M and D M⁻¹ Dᵀ are factored as
L D Lᵀ entry by entry over what is not zero, each entry a symbol of its own, so that nothing is written twice; `cse` does the rest.
Baumgarte's terms as in all peers. Runs in SymPy's own environment and imports nothing of this project.
"""

import json
import sys
import time

import sympy as sp

RATE = 10.0


class Code:
    """Statements of C; an expression that is written gets a name."""

    def __init__(self):
        self.statements = []

    def keep(self, expression):
        """The symbol of a value; numbers and symbols stay what they are."""
        expression = sp.sympify(expression)
        if expression.is_Number or expression.is_Symbol:
            return expression
        name = sp.Symbol(f"k{len(self.statements)}")
        self.statements.append((name, expression))
        return name


def ldl(matrix, code):
    """L without its diagonal, and the reciprocals of D, of a sparse symmetric matrix {(i, j): value, i ≥ j}."""
    size = 1 + max(i for i, _ in matrix)
    entries, low, inverse = dict(matrix), {}, []
    for j in range(size):
        inverse.append(code.keep(1 / entries[j, j]))
        below = [i for i in range(j + 1, size) if entries.get((i, j), 0) != 0]
        for i in below:
            low[i, j] = code.keep(entries[i, j] * inverse[j])
        for at, i in enumerate(below):
            for k in below[: at + 1]:
                entries[i, k] = code.keep(entries.get((i, k), 0) - low[i, j] * entries[k, j])
    return low, inverse


def forward(low, column, code):
    column = list(column)
    for (i, j), value in sorted(low.items(), key=lambda item: item[0][1]):
        if column[j] != 0:
            column[i] = code.keep(column[i] - value * column[j])
    return column


def backward(low, column, code):
    column = list(column)
    for (i, j), value in sorted(low.items(), key=lambda item: -item[0][1]):
        if column[i] != 0:
            column[j] = code.keep(column[j] - value * column[i])
    return column


class Plane:
    def __init__(self, linkage):
        self.links, self.linkage = linkage["links"], linkage
        n = len(self.links)
        self.angles, self.rates = sp.symbols(f"x0:{n}"), sp.symbols(f"w0:{n}")
        self.c, self.s = sp.symbols(f"c0:{n}"), sp.symbols(f"s0:{n}")

    def turned(self, number, place):
        if number < 0:
            return [sp.Float(place[0]), sp.Float(place[1])]
        c, s = sp.cos(self.angles[number]), sp.sin(self.angles[number])
        return [c * place[0] - s * place[1], s * place[0] + c * place[1]]

    def point(self, number, place):
        """World place of a point of a link."""
        found = self.turned(number, place)
        while number >= 0:
            link = self.links[number]
            arm = self.turned(link["parent"], link["place"])
            found = [a + b for a, b in zip(found, arm)]
            number = link["parent"]
        return found

    def speed(self, place):
        return [sum(sp.diff(x, q) * w for q, w in zip(self.angles, self.rates)) for x in place]


def derived(linkage):
    plane = Plane(linkage)
    q, w, n = plane.angles, plane.rates, len(plane.links)
    kinetic = potential = 0
    for number, link in enumerate(plane.links):
        center = plane.point(number, link["center"])
        velocity = plane.speed(center)
        kinetic += sp.Float(link["mass"]) / 2 * sum(x**2 for x in velocity) + sp.Float(link["tensor"][2][2]) / 2 * w[number] ** 2
        potential -= link["mass"] * sum(g * x for g, x in zip(linkage["gravity"], center))
    for spring in linkage["springs"]:
        ends = [plane.point(number, place) for number, place in zip(spring["links"], spring["places"])]
        length = sp.sqrt(sum((a - b) ** 2 for a, b in zip(*ends)))
        potential += sp.Float(spring["stiffness"]) / 2 * (length - spring["length"]) ** 2
    kinetic = sp.expand(kinetic)
    momenta = [sp.diff(kinetic, x) for x in w]
    mass = {(i, j): sp.simplify(sp.diff(momenta[i], w[j])) for i in range(n) for j in range(i + 1)}
    mass = {at: value for at, value in mass.items() if value != 0}
    forces = []
    for i in range(n):
        drift = sum(sp.diff(momenta[i], q[k]) * w[k] for k in range(n))
        forces.append(sp.simplify(sp.diff(kinetic, q[i]) - drift) - sp.diff(potential, q[i]))
    for i, torque in enumerate(linkage["torques"]):
        forces[i] += torque
        if plane.links[i]["parent"] >= 0:
            forces[plane.links[i]["parent"]] -= torque
    phi = []
    for loop in linkage["loops"]:
        ends = [plane.point(number, place) for number, place in zip(loop["links"], loop["places"])]
        phi += [a - b for a, b in zip(*ends)]
    jacobian = [{i: sp.diff(row, q[i]) for i in range(n) if sp.diff(row, q[i]) != 0} for row in phi]
    target = []
    for row, slopes in zip(phi, jacobian):
        speed = sum(slope * w[i] for i, slope in slopes.items())
        bent = sum(sp.diff(speed, q[i]) * w[i] for i in slopes)
        target.append(-bent - 2 * RATE * speed - RATE**2 * row)
    return plane, mass, forces, jacobian, target


def solved(plane, mass, forces, jacobian, target, code):
    """v̇ of the absolute angles as symbols. Columns are eliminated from the ends of branches inwards."""
    n = len(plane.links)
    order = list(reversed(range(n)))
    place = {i: k for k, i in enumerate(order)}
    swapped = {(max(place[i], place[j]), min(place[i], place[j])): code.keep(value) for (i, j), value in mass.items()}
    low, inverse = ldl(swapped, code)
    free = forward(low, [code.keep(forces[i]) for i in order], code)
    spread = []
    for row in jacobian:
        column = [0] * n
        for i, value in row.items():
            column[place[i]] = code.keep(value)
        spread.append(forward(low, column, code))
    scaled = [[code.keep(x * d) if x != 0 else 0 for x, d in zip(column, inverse)] for column in spread]
    result = list(free)
    if jacobian:
        schur = {}
        for a in range(len(spread)):
            for b in range(a + 1):
                value = sum(x * y for x, y in zip(spread[a], scaled[b]))
                if value != 0:
                    schur[a, b] = code.keep(value)
        lower, reciprocal = ldl(schur, code)
        right = [code.keep(sum(x * y for x, y in zip(column, free)) - code.keep(g)) for column, g in zip(scaled, target)]
        half = forward(lower, right, code)
        multipliers = backward(lower, [code.keep(x * d) for x, d in zip(half, reciprocal)], code)
        for i in range(n):
            result[i] = code.keep(free[i] - sum(column[i] * m for column, m in zip(spread, multipliers)))
    accelerations = backward(low, [code.keep(x * d) for x, d in zip(result, inverse)], code)
    return [accelerations[place[i]] for i in range(n)]


def written(name, plane, code, accelerations):
    n = len(plane.links)
    trig = {sp.cos(q): c for q, c in zip(plane.angles, plane.c)} | {sp.sin(q): s for q, s in zip(plane.angles, plane.s)}
    expressions = [value.subs(trig) for _, value in code.statements]
    shared, reduced = sp.cse(expressions, symbols=sp.numbered_symbols("t"), order="none")
    defined = [(name, value) for name, value in shared]
    defined += [(name, value) for (name, _), value in zip(code.statements, reduced)]
    lines = [f"void {name}(const double *q, const double *v, double *a) {{"]
    for i, link in enumerate(plane.links):
        before = link["parent"]
        lines.append(f"    const double x{i} = q[{i}]{f' + x{before}' if before >= 0 else ''};")
        lines.append(f"    const double w{i} = v[{i}]{f' + w{before}' if before >= 0 else ''};")
        lines.append(f"    const double c{i} = cos(x{i}), s{i} = sin(x{i});")
    for symbol, value in sorted_by_use(defined):
        lines.append(f"    const double {symbol} = {sp.ccode(value)};")
    for i, link in enumerate(plane.links):
        before = link["parent"]
        difference = accelerations[i] - accelerations[before] if before >= 0 else accelerations[i]
        lines.append(f"    a[{i}] = {sp.ccode(difference)};")
    operations = sum(sp.count_ops(value) for _, value in defined)
    return "#include <math.h>\n\n" + "\n".join(lines) + "\n}\n", operations + n


def sorted_by_use(defined):
    """Each after what it needs."""
    known = {symbol: value for symbol, value in defined}
    done, order = set(), []
    for symbol, _ in defined:
        stack = [symbol]
        while stack:
            top = stack[-1]
            missing = [s for s in known[top].free_symbols if s in known and s not in done] if top not in done else []
            if missing:
                stack += missing
                continue
            stack.pop()
            if top not in done:
                done.add(top)
                order.append((top, known[top]))
    return order


def main():
    linkage, name, out = json.load(open(sys.argv[1])), sys.argv[2], sys.argv[3]
    if not linkage["planar"]:
        raise SystemExit("only linkages in the plane are derived")
    begin = time.perf_counter()
    plane, *equations = derived(linkage)
    code = Code()
    text, operations = written(name, plane, code, solved(plane, *equations, code))
    open(out, "w").write(text)
    print(time.perf_counter() - begin, operations)


if __name__ == "__main__":
    main()
