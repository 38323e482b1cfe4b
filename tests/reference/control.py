"""Control work at consistent states: the equations in independent coordinates, and a step of the stepper with its derivatives.

The coordinates s are entries of v, given by their indices: ṡ = v_I. With N of D N = 0, N_I = 1 and a₀ of D a₀ = γ, a₀_I = 0
    M_r = Nᵀ M N,   h = Nᵀ (M a₀ − Q),   g = −Nᵀ Q(v = 0, u = 0),
from the reference's own M, D, Q and γ. The step is Kutta's on the group, as NOTATION.md and the runtime's documentation say it, with
Baumgarte's terms for a time constant of ten steps; A_d and B_d are its automatic derivatives along motions that the rows admit, and C
and D those of the outputs. Inputs that drive s̈ = (1, 2, …) are the least that solve Nᵀ ∂Q/∂u u = Nᵀ (M a − Q). A_d and B_d of held inputs are
the series of the exponential of the A and B given, in extended precision.
"""

import casadi as ca
import numpy as np

from coordinate_set import given, symbols
from entries import column
from expressions import evaluate

TOLERANCE = 1e-10  # in units of the largest entry of a matrix
SINGLE = 1e-4
PART = 0.1


def compare_control(check):
    """Requests that have `reduced`, and perhaps `step`; gives the reference's own values by name."""
    if not all("reduced" in state for state in check.raw):
        return {}
    own = {"reduced": reduced(check)}
    if all("driven" in state for state in check.raw):
        own["driven"] = driven(check)
    if all("step" in state for state in check.raw):
        step = Step(check.own)
        own["step"], own["outputs"] = step(check), step.outputs(check)
        own["held"] = held(check)
    for what, values in own.items():
        for name, tolerance in ((what, TOLERANCE), (f"{what}_single", SINGLE)):
            for part, (first, last) in parts(check, what).items():
                found = column(check.raw, name, values.shape[1])[check.kept, first:last]
                expected = values[check.kept, first:last]
                if expected.size == 0:
                    continue
                scale = np.abs(values[check.kept, slice(*spread(check, what, part))]).max(axis=1, keepdims=True)
                scale = np.broadcast_to(scale, expected.shape)
                check.comparison.terms(f"{name}_{part}", found, expected, scale, lambda k, part=part: f"{part} [{k}]", tolerance)
    return own


def coordinates(check):
    return np.array(check.raw[0]["control_coordinates"], dtype=int)


def parts(check, what):
    """Where matrices and vectors stand in the list of numbers."""
    f, inputs = len(coordinates(check)), check.model.u.numel()
    if what == "driven":
        return {"inputs": (0, inputs)}
    if what == "outputs":
        count = len(check.model.definition["outputs"])
        return {"state": (0, count * 2 * f), "input": (count * 2 * f, count * (2 * f + inputs))}
    if what == "reduced":
        return {"mass": (0, f * f), "bias": (f * f, f * f + f), "gravity": (f * f + f, f * f + 2 * f)}
    size = 2 * f
    return {"state": (0, size * size), "input": (size * size, size * (size + inputs))}


def spread(check, what, part):
    """What an entry is measured by: forces by the larger of bias and gravity, which are sums of the same loads."""
    places = parts(check, what)
    return places[part] if part not in ("bias", "gravity") else (places["bias"][0], places["gravity"][1])


def reduced(check):
    """(states, f² + 2f)."""
    index, states, values = coordinates(check), check.states, check.quantities
    still = {**states, "v": 0 * states["v"], "inputs": 0 * states["inputs"]}
    weights = check.own.evaluate(still)["forces"][0]
    mass, jacobian, forces, gamma = (values[name][0] for name in ("mass", "jacobian", "forces", "gamma"))
    results = []
    for m, d, q, right, weight in zip(mass, jacobian, forces, gamma, weights, strict=True):
        n = motions(d, index)
        a = admissible(d, index, right)
        results.append(np.concatenate([(n.T @ m @ n).ravel(), n.T @ (m @ a - q), -n.T @ weight]))
    return np.array(results)


def admissible(jacobian, index, right):
    """x of D x = right, x_I = 0; rows that repeat others are of no matter."""
    unit = np.eye(jacobian.shape[1])[index]
    matrix = np.vstack([jacobian, unit])
    right = np.concatenate([right, np.zeros(len(index))])
    x = np.linalg.lstsq(matrix, right, rcond=1e-13)[0]
    return x + np.linalg.lstsq(matrix, right - matrix @ x, rcond=1e-13)[0]


def motions(jacobian, index):
    """N, n × f."""
    unit = np.eye(jacobian.shape[1])[index]
    matrix = np.vstack([jacobian, unit])
    right = np.vstack([np.zeros((len(jacobian), len(index))), np.eye(len(index))])
    n = np.linalg.lstsq(matrix, right, rcond=1e-13)[0]
    return n + np.linalg.lstsq(matrix, right - matrix @ n, rcond=1e-13)[0]


def driven(check):
    """The inputs, those given being zero, with which s̈_k = k + 1."""
    index, states, values = coordinates(check), check.states, check.quantities
    inputs = states["inputs"]
    none = check.own.evaluate({**states, "inputs": 0 * inputs})["forces"][0]
    columns = []
    for k in range(inputs.shape[1]):
        one = np.zeros(inputs.shape)
        one[:, k] = 1
        columns.append(check.own.evaluate({**states, "inputs": one})["forces"][0] - none)
    results = []
    for state, (m, d, right) in enumerate(zip(*(values[name][0] for name in ("mass", "jacobian", "gamma")), strict=True)):
        n = motions(d, index)
        a = admissible(d, index, right) + n @ np.arange(1, len(index) + 1)
        by = n.T @ np.array([column[state] for column in columns]).T
        results.append(np.linalg.lstsq(by, n.T @ (m @ a - none[state]), rcond=1e-12)[0])
    return np.array(results)


def held(check):
    """A_d and B_d of the A and B given, by the series of [A B; 0 0] h."""
    results, inputs, size = [], check.model.u.numel(), 2 * len(coordinates(check))
    h = np.longdouble(check.raw[0]["hold"][0])
    for space in column(check.raw, "space", size * (size + inputs)):
        whole = np.zeros((size + inputs, size + inputs), dtype=np.longdouble)
        whole[:size, :size] = space[: size * size].reshape(size, size)
        whole[:size, size:] = space[size * size :].reshape(size, inputs)
        halvings = max(0, int(np.ceil(np.log2(float(np.abs(whole).sum(axis=0).max() * h) + 1e-30))) + 3)
        whole = whole * h / np.longdouble(2) ** halvings
        term = sum_ = np.eye(size + inputs, dtype=np.longdouble)
        for k in range(1, 25):
            term = term @ whole / k
            sum_ = sum_ + term
        for _ in range(halvings):
            sum_ = sum_ @ sum_
        results.append(np.concatenate([sum_[:size, :size].ravel(), sum_[:size, size:].ravel()]).astype(float))
    return np.array(results)


class Step:
    """Kutta's step of mechanisms without states of their own."""

    def __init__(self, own):
        if own.equations is None or own.model.z.numel():
            raise NotImplementedError("steps of an absolute set in the plane, or with internal states")
        self.own, equations, kinematics, model = own, own.equations, own.kinematics, own.model
        self.layout = own.layout
        arguments = [*symbols(model), kinematics.q, kinematics.v]
        jacobian, direction = equations.jacobian, ca.SX.sym("direction", kinematics.v.numel())
        alpha = ca.SX.sym("alpha")
        rate = ca.mtimes(jacobian, kinematics.v) - equations.nu
        right = ca.vertcat(equations.forces, equations.gamma - 2 * alpha * rate - alpha**2 * equations.phi)
        m = len(own.rows)
        matrix = ca.blockcat([[equations.mass, jacobian.T], [jacobian, ca.SX(m, m)]])
        self.system = ca.Function("system", [*arguments, alpha], [matrix, right])
        self.moved = ca.Function("moved", [*arguments, direction], [
            kinematics.q_rate(direction), ca.jtimes(rate, kinematics.q, kinematics.q_rate(direction)), jacobian
        ])
        self.function = self.derive(arguments)

    def derive(self, arguments):
        *outer, q, v = [ca.MX.sym(symbol, size) for symbol, size in zip("ptuxzgenqv", [a.shape for a in arguments], strict=True)]
        h = ca.MX.sym("h")
        n, time = v.numel(), outer[1]

        def acceleration(c, q, v):
            matrix, right = self.system(outer[0], time + c * h, *outer[2:], q, v, PART / h)
            return ca.solve(matrix, right)[:n]

        rates, slopes, turned = [v], [acceleration(0, q, v)], [v]
        for c in (0.5, 0.5, 1.0):
            u, integral = c * h * turned[-1], c * h * rates[-1]
            at, speed = self.retract(q, u, integral), v + c * h * slopes[-1]
            rates.append(speed)
            slopes.append(acceleration(c, at, speed))
            turned.append(self.inverse_differential(u, speed))

        def mean(k):
            return h / 6 * (k[0] + 2 * k[1] + 2 * k[2] + k[3])

        end = ca.vertcat(self.retract(q, mean(turned), mean(rates)), v + mean(slopes))
        by = ca.vertcat(q, v, outer[2])
        return ca.Function("step", [*outer, q, v, h], [end, ca.jacobian(end, by)])

    def kinds(self):
        """Numbers of linear coordinates, pairs, quaternions; rates of counted angles."""
        layout = self.layout
        rates = [angle["rate"] if isinstance(angle, dict) else angle[1] for angle in layout.angles]
        return len(layout.linear), len(layout.rotations), len(getattr(layout, "quaternions", ())), rates

    def retract(self, q, u, integral):
        linear, pairs, quaternions, angles = self.kinds()
        parts = [q[k] + u[k] for k in range(linear)]
        for k in range(pairs):
            c, s, delta = q[linear + 2 * k], q[linear + 2 * k + 1], u[linear + k]
            parts += [c * ca.cos(delta) - s * ca.sin(delta), s * ca.cos(delta) + c * ca.sin(delta)]
        for k in range(quaternions):
            first, turn = linear + 2 * pairs + 4 * k, u[linear + pairs + 3 * k : linear + pairs + 3 * k + 3]
            w, x, angle = q[first], q[first + 1 : first + 4], ca.norm_2(turn)
            c, s = ca.cos(angle / 2), ca.sin(angle / 2) / angle * turn
            parts += [w * c - ca.dot(x, s), w * s + c * x + ca.cross(x, s)]
        first = linear + 2 * pairs + 4 * quaternions
        for k, rate in enumerate(angles):
            parts += [q[first + 2 * k], q[first + 2 * k + 1] + sum(weight * integral[index] for index, weight in rate)]
        return ca.vertcat(*parts)

    def inverse_differential(self, u, v):
        linear, pairs, quaternions, _ = self.kinds()
        first = linear + pairs
        parts = [v[:first]]
        for k in range(quaternions):
            own, omega = u[first + 3 * k : first + 3 * k + 3], v[first + 3 * k : first + 3 * k + 3]
            once = ca.cross(own, omega)
            parts.append(omega + once / 2 + ca.cross(own, once) / 12)
        return ca.vertcat(*parts)

    def __call__(self, check):
        """(states, A_d and B_d row by row)."""
        index, states = coordinates(check), check.states
        size = check.raw[0]["step_size"][0]
        results = []
        for arguments in zip(*given(states), states["q"], states["v"], strict=True):
            end, jacobian = (np.array(part.full()) for part in self.function(*arguments, size))
            results.append(self.matrices(index, arguments, end[:, 0], jacobian))
        return np.array(results)

    def outputs(self, check):
        """(states, C and D row by row)."""
        index, states, results = coordinates(check), check.states, []
        kinematics, model = self.own.kinematics, self.own.model
        arguments = [*symbols(model), kinematics.q, kinematics.v]
        values = [evaluate(output["value"], kinematics) for output in model.definition["outputs"]]
        by = ca.vertcat(kinematics.q, kinematics.v, model.u)
        function = ca.Function("outputs", arguments, [ca.jacobian(ca.vertcat(*values), by)])
        for given_here in zip(*given(states), states["q"], states["v"], strict=True):
            jacobian = np.array(function(*given_here).full())
            begins = self.begins(index, given_here)
            by_state, by_input = jacobian[:, : begins.shape[0]] @ begins, jacobian[:, begins.shape[0] :]
            results.append(np.concatenate([by_state.ravel(), by_input.ravel()]))
        return np.array(results)

    def begins(self, index, arguments):
        """(δq of all entries, δv) of each small motion, a column each: of s, then of ṡ."""
        positions, velocities = len(arguments[-2]), len(arguments[-1])
        _, _, d = (np.array(part.full()) for part in self.moved(*arguments, np.zeros(velocities)))
        begins = []
        for motion in motions(d, index).T:
            entries, rate, _ = self.moved(*arguments, motion)
            entries, rate = entries.full()[:, 0], rate.full().reshape(-1)
            begins.append(np.concatenate([entries, admissible(d, index, -rate)]))
        begins += [np.concatenate([np.zeros(positions), motion]) for motion in motions(d, index).T]
        return np.array(begins).T

    def matrices(self, index, arguments, end, jacobian):
        begins = self.begins(index, arguments)
        state = self.seen(index, end, jacobian[:, : begins.shape[0]] @ begins)
        by_input = self.seen(index, end, jacobian[:, begins.shape[0] :])
        return np.concatenate([state.ravel(), by_input.ravel()])

    def seen(self, index, end, moved):
        """(δs, δṡ) at the end of small motions, a column each."""
        linear, pairs, _, _ = self.kinds()
        rows = []
        for k in index:
            if k < linear:
                rows.append(moved[k])
            elif k < linear + pairs:
                place = linear + 2 * (k - linear)
                rows.append(end[place] * moved[place + 1] - end[place + 1] * moved[place])
            else:
                raise NotImplementedError("coordinates among components of ω")
        first = len(moved) - self.own.kinematics.v.numel()
        return np.array([*rows, *(moved[first + k] for k in index)])
