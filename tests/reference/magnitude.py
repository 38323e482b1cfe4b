"""Values of expressions at many states, each with the sum of magnitudes of the terms that formed it.

The instructions of a CasADi function are read once and sorted by depth and operation; every step works on all of one kind and on all
states together. Beside its value each intermediate carries a magnitude m, with m = |x| for what is given and
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


class Group:
    """Instructions of one operation that need nothing of one another: they fill `rows`, reading an array of rows by operand."""

    def __init__(self, rule, rows, reads):
        self.rule, self.rows, self.reads = rule, rows, reads


class Evaluator:
    """A named set of expressions of the same arguments."""

    def __init__(self, arguments, outputs):
        self.outputs = {name: ca.SX(value) for name, value in outputs.items()}
        self.function = ca.Function("values", list(arguments), list(self.outputs.values()))
        self._sort(*self._read())

    def _read(self):
        """Of each instruction but outputs its operation, its depth, and of which instructions it reads; once more where it reads one."""
        function = self.function
        identity, reads_of, writes_of = function.instruction_id, function.instruction_input, function.instruction_output
        written_by = [0] * function.sz_w()
        operations, depths, first, second = [], [], [], []
        self.inputs, self.constants, self.results = [], [], []
        for k in range(function.n_instructions()):
            operation, reads = identity(k), reads_of(k)
            if operation == ca.OP_OUTPUT:
                self.results.append((*writes_of(k), written_by[reads[0]]))
                continue
            depth, one, other = 0, 0, 0
            if operation == ca.OP_CONST:
                self.constants.append(function.instruction_constant(k))
            elif operation == ca.OP_INPUT:
                self.inputs.append(reads)
            elif operation in RULES:
                one, other = written_by[reads[0]], written_by[reads[-1]]
                depth = 1 + max(depths[one], depths[other])
            else:
                raise NotImplementedError(f"CasADi operation {operation}")
            written_by[writes_of(k)[0]] = len(depths)
            operations.append(operation)
            depths.append(depth)
            first.append(one)
            second.append(other)
        return (np.array(values, dtype=int) for values in (operations, depths, first, second))

    def _sort(self, operations, depths, first, second):
        """Groups: all that are of one depth and operation, in the order of depths; what is given leads."""
        order = np.lexsort((operations, depths))
        row = np.empty_like(order)
        row[order] = np.arange(len(order))
        operations, depths, first, second = operations[order], depths[order], row[first[order]], row[second[order]]
        begins = np.ones(len(order), dtype=bool)
        begins[1:] = (np.diff(operations) != 0) | (np.diff(depths) != 0)
        begins = np.flatnonzero(begins)
        self.rows, self.groups = len(order), []
        for begin, end in zip(begins, [*begins[1:], len(order)]):
            rows, operation = slice(begin, end), operations[begin]
            if operation == ca.OP_CONST:
                self.constant_rows = rows
            elif operation == ca.OP_INPUT:
                self.input_rows = rows
            else:
                rule = RULES[operation]
                self.groups.append(Group(rule, rows, (first[rows], second[rows])[: rule.operands]))
        self.results = [(output, entry, row[index]) for output, entry, index in self.results]

    def __call__(self, *arguments):
        """`arguments` as (states, size) each; returns a `Result` by name."""
        return self._results(arguments, np.float64, with_magnitudes=True)

    def values(self, *arguments, dtype):
        """The same computed in numbers of `dtype`, without magnitudes, which stay zero."""
        return self._results(arguments, dtype, with_magnitudes=False)

    def _results(self, arguments, dtype, with_magnitudes):
        arguments = [np.atleast_2d(np.asarray(argument, float)) for argument in arguments]
        states = len(arguments[0])
        for k, argument in enumerate(arguments):
            if argument.shape != (states, self.function.numel_in(k)):
                expected = (states, self.function.numel_in(k))
                raise ValueError(f"argument {k} has the shape {argument.shape}, expected {expected}")
        value = np.empty((self.rows, states), dtype)
        if self.inputs:
            value[self.input_rows] = [arguments[argument][:, entry] for argument, entry in self.inputs]
        if self.constants:
            value[self.constant_rows] = np.array(self.constants, dtype)[:, None]
        magnitude = None
        if with_magnitudes:
            given = len(self.inputs) + len(self.constants)
            magnitude = np.empty_like(value)
            magnitude[:given] = np.abs(value[:given])
        with np.errstate(all="ignore"):
            for group in self.groups:
                operands = [value[reads] for reads in group.reads]
                result = group.rule.value(*operands)
                value[group.rows] = result
                if with_magnitudes:
                    magnitudes = [magnitude[reads] for reads in group.reads]
                    magnitude[group.rows] = group.rule.magnitude(result, *operands, *magnitudes)
        results = {name: Result(output, states, is_matrix(name)) for name, output in self.outputs.items()}
        ordered = list(results.values())
        for output, entry, row in self.results:
            ordered[output].values[:, entry] = value[row]
            if with_magnitudes:
                ordered[output].magnitudes[:, entry] = magnitude[row]
        return results


class Rule:
    """The value of an operation from those of its operands, and its magnitude from the value, its operands and theirs."""

    def __init__(self, operands, value, magnitude):
        self.operands, self.value, self.magnitude = operands, value, magnitude


def _smooth(function, slope):
    """m(f(a)) = |f(a)| + |f'(a)| m(a)."""
    return Rule(1, function, lambda f, a, m: np.abs(f) + np.abs(slope(a, f)) * m)


def _choice(function):
    """Results 0 and 1, exact."""
    return Rule(2, lambda a, b: function(a, b).astype(a.dtype), lambda f, a, b, m, n: f)


def _if_else_zero(a, b):
    # The branch not taken may be no number.
    return np.where(a != 0, b, 0.0).astype(b.dtype)


def _power(f, a, b, m, n):
    base = np.where(a == 0, 1.0, np.abs(a))
    exponent_error = np.where(np.isclose(b, np.round(b)), 0.0, np.abs(np.log(base)) * n)
    return np.abs(f) * (1.0 + np.abs(b) * m / base + exponent_error)


def _atan2(f, a, b, m, n):
    return np.abs(f) + (np.abs(b) * m + np.abs(a) * n) / (a * a + b * b)


def _whole(f, a, m):
    # Exact, unless rounding takes the argument over a whole number.
    return np.abs(f)


RULES = {
    ca.OP_ASSIGN: Rule(1, lambda a: a, lambda f, a, m: m),
    ca.OP_ADD: Rule(2, np.add, lambda f, a, b, m, n: m + n),
    ca.OP_SUB: Rule(2, np.subtract, lambda f, a, b, m, n: m + n),
    ca.OP_MUL: Rule(2, np.multiply, lambda f, a, b, m, n: m * n),
    ca.OP_DIV: Rule(2, np.divide, lambda f, a, b, m, n: m * n / (b * b)),
    ca.OP_NEG: Rule(1, np.negative, lambda f, a, m: m),
    ca.OP_INV: Rule(1, np.reciprocal, lambda f, a, m: m / (a * a)),
    ca.OP_SQ: Rule(1, np.square, lambda f, a, m: m * m),
    ca.OP_TWICE: Rule(1, lambda a: a + a, lambda f, a, m: m + m),
    ca.OP_FABS: Rule(1, np.abs, lambda f, a, m: m),
    ca.OP_SIGN: Rule(1, np.sign, _whole),
    ca.OP_FLOOR: Rule(1, np.floor, _whole),
    ca.OP_FMIN: Rule(2, np.fmin, lambda f, a, b, m, n: np.maximum(m, n)),
    ca.OP_FMAX: Rule(2, np.fmax, lambda f, a, b, m, n: np.maximum(m, n)),
    ca.OP_IF_ELSE_ZERO: Rule(2, _if_else_zero, lambda f, a, b, m, n: np.where(a != 0, n, 0.0)),
    ca.OP_POW: Rule(2, np.power, _power),
    ca.OP_CONSTPOW: Rule(2, np.power, _power),
    ca.OP_ATAN2: Rule(2, np.arctan2, _atan2),
    ca.OP_HYPOT: Rule(2, np.hypot, lambda f, a, b, m, n: f + (np.abs(a) * m + np.abs(b) * n) / f),
    ca.OP_NOT: Rule(1, lambda a: (a == 0).astype(a.dtype), lambda f, a, m: f),
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
