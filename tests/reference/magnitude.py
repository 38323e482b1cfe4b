"""Values of expressions at many states, each with the sum of magnitudes of the terms that formed it.

The instructions of a CasADi function are walked once; every step works on all states together. Beside its value each
intermediate carries a magnitude m, with m = |x| for what is given and
    m(a ± b) = m(a) + m(b),   m(a b) = m(a) m(b),   m(a/b) = m(a) m(b)/b²,   m(f(a)) = |f(a)| + |f'(a)| m(a).
A rounding error of relative size ε in any of the terms changes the result by about ε m: differences between two ways
of computing the same entry are measured in units of m.
"""

import casadi as ca
import numpy as np

# Quantities of every set that stay matrices even with one column.
MATRICES = ("jacobian", "mass")


def is_matrix(name):
    return name in MATRICES or name.endswith("_jacobian")


class Result:
    """One output: `rows`, `columns` of its nonzeros, `values` and `magnitudes` as (states, nonzeros)."""

    def __init__(self, output, states, is_matrix):
        self.is_matrix = is_matrix
        sparsity = output.sparsity()
        self.shape = output.shape
        self.rows, self.columns = (np.array(part, dtype=int) for part in sparsity.get_triplet())
        self.values = np.zeros((states, sparsity.nnz()))
        self.magnitudes = np.zeros((states, sparsity.nnz()))

    def dense(self):
        """Values and magnitudes as (states, rows, columns); vectors as (states, rows)."""
        return self._spread(self.values), self._spread(self.magnitudes)

    def _spread(self, entries):
        full = np.zeros((len(entries), *self.shape))
        full[:, self.rows, self.columns] = entries
        return full if self.is_matrix else full[:, :, 0]


class Evaluator:
    """A named set of expressions of the same arguments."""

    def __init__(self, arguments, outputs):
        self.outputs = {name: ca.SX(value) for name, value in outputs.items()}
        self.function = ca.Function("values", list(arguments), list(self.outputs.values()))
        function = self.function
        self.program = []
        for k in range(function.n_instructions()):
            operation = function.instruction_id(k)
            constant = function.instruction_constant(k) if operation == ca.OP_CONST else None
            reads, writes = function.instruction_input(k), function.instruction_output(k)
            self.program.append((operation, reads, writes, constant))

    def __call__(self, *arguments, dtype=np.float64):
        """`arguments` as (states, size) each; returns a `Result` by name, computed in numbers of `dtype`."""
        arguments = [np.atleast_2d(np.asarray(argument, float)) for argument in arguments]
        states = len(arguments[0])
        for k, argument in enumerate(arguments):
            if argument.shape != (states, self.function.numel_in(k)):
                expected = (states, self.function.numel_in(k))
                raise ValueError(f"argument {k} has the shape {argument.shape}, expected {expected}")
        columns = [np.ascontiguousarray(argument.T, dtype) for argument in arguments]
        absolutes = [np.abs(column) for column in columns]
        results = {name: Result(output, states, is_matrix(name)) for name, output in self.outputs.items()}
        ordered = list(results.values())
        value = [None] * self.function.sz_w()
        magnitude = [None] * self.function.sz_w()
        with np.errstate(all="ignore"):
            for operation, reads, writes, constant in self.program:
                if operation == ca.OP_CONST:
                    value[writes[0]] = np.full(states, constant, dtype)
                    magnitude[writes[0]] = np.full(states, abs(constant), dtype)
                elif operation == ca.OP_INPUT:
                    value[writes[0]] = columns[reads[0]][reads[1]]
                    magnitude[writes[0]] = absolutes[reads[0]][reads[1]]
                elif operation == ca.OP_OUTPUT:
                    ordered[writes[0]].values[:, writes[1]] = value[reads[0]]
                    ordered[writes[0]].magnitudes[:, writes[1]] = magnitude[reads[0]]
                else:
                    rule = RULES.get(operation)
                    if rule is None:
                        raise NotImplementedError(f"CasADi operation {operation}")
                    operands = [(value[index], magnitude[index]) for index in reads[: rule.__code__.co_argcount]]
                    value[writes[0]], magnitude[writes[0]] = rule(*operands)
        return results


def _smooth(function, slope):
    """m(f(a)) = |f(a)| + |f'(a)| m(a)."""

    def rule(a):
        result = function(a[0])
        return result, np.abs(result) + np.abs(slope(a[0], result)) * a[1]

    return rule


def _choice(function):
    """Results 0 and 1, exact."""

    def rule(a, b):
        result = function(a[0], b[0]).astype(a[0].dtype)
        return result, result

    return rule


def _add(a, b):
    return a[0] + b[0], a[1] + b[1]


def _subtract(a, b):
    return a[0] - b[0], a[1] + b[1]


def _multiply(a, b):
    return a[0] * b[0], a[1] * b[1]


def _divide(a, b):
    return a[0] / b[0], a[1] * b[1] / (b[0] * b[0])


def _invert(a):
    return 1.0 / a[0], a[1] / (a[0] * a[0])


def _square(a):
    return a[0] * a[0], a[1] * a[1]


def _twice(a):
    return a[0] + a[0], a[1] + a[1]


def _negate(a):
    return -a[0], a[1]


def _absolute(a):
    return np.abs(a[0]), a[1]


def _sign(a):
    result = np.sign(a[0])
    return result, np.abs(result)


def _floor(a):
    # A whole number, exact unless rounding takes the argument over one.
    result = np.floor(a[0])
    return result, np.abs(result)


def _not(a):
    result = (a[0] == 0).astype(a[0].dtype)
    return result, result


def _minimum(a, b):
    return np.fmin(a[0], b[0]), np.maximum(a[1], b[1])


def _maximum(a, b):
    return np.fmax(a[0], b[0]), np.maximum(a[1], b[1])


def _if_else_zero(a, b):
    # The branch not taken may be no number.
    return np.where(a[0] != 0, b[0], 0.0), np.where(a[0] != 0, b[1], 0.0)


def _power(a, b):
    result = a[0] ** b[0]
    base = np.where(a[0] == 0, 1.0, np.abs(a[0]))
    exponent_error = np.where(np.isclose(b[0], np.round(b[0])), 0.0, np.abs(np.log(base)) * b[1])
    return result, np.abs(result) * (1.0 + np.abs(b[0]) * a[1] / base + exponent_error)


def _atan2(a, b):
    result = np.arctan2(a[0], b[0])
    square = a[0] * a[0] + b[0] * b[0]
    return result, np.abs(result) + (np.abs(b[0]) * a[1] + np.abs(a[0]) * b[1]) / square


def _hypot(a, b):
    result = np.hypot(a[0], b[0])
    return result, result + (np.abs(a[0]) * a[1] + np.abs(b[0]) * b[1]) / result


RULES = {
    ca.OP_ASSIGN: lambda a: a,
    ca.OP_ADD: _add,
    ca.OP_SUB: _subtract,
    ca.OP_MUL: _multiply,
    ca.OP_DIV: _divide,
    ca.OP_NEG: _negate,
    ca.OP_INV: _invert,
    ca.OP_SQ: _square,
    ca.OP_TWICE: _twice,
    ca.OP_FABS: _absolute,
    ca.OP_SIGN: _sign,
    ca.OP_FLOOR: _floor,
    ca.OP_FMIN: _minimum,
    ca.OP_FMAX: _maximum,
    ca.OP_IF_ELSE_ZERO: _if_else_zero,
    ca.OP_POW: _power,
    ca.OP_CONSTPOW: _power,
    ca.OP_ATAN2: _atan2,
    ca.OP_HYPOT: _hypot,
    ca.OP_NOT: _not,
    ca.OP_LT: _choice(np.less),
    ca.OP_LE: _choice(np.less_equal),
    ca.OP_EQ: _choice(np.equal),
    ca.OP_NE: _choice(np.not_equal),
    ca.OP_AND: _choice(np.logical_and),
    ca.OP_OR: _choice(np.logical_or),
    ca.OP_SQRT: _smooth(np.sqrt, lambda x, f: 0.5 / f),
    ca.OP_SIN: _smooth(np.sin, lambda x, f: np.cos(x)),
    ca.OP_COS: _smooth(np.cos, lambda x, f: np.sin(x)),
    ca.OP_TAN: _smooth(np.tan, lambda x, f: 1.0 + f * f),
    ca.OP_ASIN: _smooth(np.arcsin, lambda x, f: 1.0 / np.cos(f)),
    ca.OP_ACOS: _smooth(np.arccos, lambda x, f: 1.0 / np.sin(f)),
    ca.OP_ATAN: _smooth(np.arctan, lambda x, f: 1.0 / (1.0 + x * x)),
    ca.OP_EXP: _smooth(np.exp, lambda x, f: f),
    ca.OP_LOG: _smooth(np.log, lambda x, f: 1.0 / x),
    ca.OP_TANH: _smooth(np.tanh, lambda x, f: 1.0 - f * f),
    ca.OP_SINH: _smooth(np.sinh, lambda x, f: np.cosh(x)),
    ca.OP_COSH: _smooth(np.cosh, lambda x, f: np.sinh(x)),
}
