"""Expressions of a DEFINITION (trees of plain JSON) to CasADi scalars in SI.

What a name means is not decided here: a scope is asked, by `scope.name(text)`.
"""

import math

import casadi as ca

from units import factor

FUNCTIONS = {
    "sqrt": ca.sqrt, "abs": ca.fabs, "min": ca.fmin, "max": ca.fmax, "sign": ca.sign, "sin": ca.sin, "cos": ca.cos,
    "tan": ca.tan, "asin": ca.asin, "acos": ca.acos, "atan": ca.atan, "atan2": ca.atan2, "exp": ca.exp, "ln": ca.log,
    "log10": ca.log10, "sinh": ca.sinh, "cosh": ca.cosh, "tanh": ca.tanh,
    "hypot": lambda x, y: ca.sqrt(x * x + y * y),
    "clamp": lambda x, least, most: ca.if_else(x < least, least, ca.if_else(x > most, most, x)),
    "deadband": lambda x, half: ca.if_else(x > half, x - half, ca.if_else(x < -half, x + half, 0)),
    "step": lambda x: ca.if_else(x > 0, 1, 0),
    "smoothstep": lambda x, start, end: _smoothstep((x - start) / (end - start)),
    "wrap": lambda x, *period: _wrap(x, *period),
}  # fmt: skip
COMPARISONS = {
    "<": lambda a, b: a < b, "<=": lambda a, b: a <= b, ">": lambda a, b: a > b, ">=": lambda a, b: a >= b,
    "==": lambda a, b: a == b, "!=": lambda a, b: a != b, "and": ca.logic_and, "or": ca.logic_or,
}  # fmt: skip


def entry(node, scope):
    """The value of `{"unit": …, "value": EXPR}` in SI."""
    return in_unit(node["value"], node.get("unit"), scope)


def pair(node, scope, key="value"):
    """The values of `{"unit": …, "value": [EXPR, EXPR]}` (three of them in space) as a column in SI.

    A bare number beside a component that names a quantity could be meant in the unit or in SI; where the two
    differ, the definition is refused rather than guessed at.
    """
    values, unit = node[key], node.get("unit")
    bare = [is_bare(value) for value in values]
    if factor(unit) != 1.0 and any(bare) and not all(bare):
        lone = values[bare.index(True)]
        if float(evaluate(lone, scope)) != 0.0:
            raise ValueError(f"{values}: a bare number beside a named quantity, under the unit `{unit}`")
    return ca.vertcat(*[in_unit(value, unit, scope) for value in values])


def in_unit(value, unit, scope):
    """`value` under the unit of its entry: bare values are multiplied by it, all others are in SI already."""
    result = evaluate(value, scope)
    return result * factor(unit) if is_bare(value) else result


def is_bare(node):
    """Whether a value names no quantity and carries no unit anywhere inside (`pi` is a number)."""
    if "number" in node:
        return node.get("unit") is None
    if "name" in node:
        return node["name"] == "pi"
    if "op" in node:
        return all(is_bare(child) for child in node["args"])
    if "call" in node:
        known = node["call"] in FUNCTIONS or node["call"] == "if"
        return known and all(is_bare(child) for child in node["args"])
    return False  # a parenthesised expression with its own unit, or a place


def _smoothstep(s):
    return ca.if_else(s <= 0, 0, ca.if_else(s >= 1, 1, 3 * s**2 - 2 * s**3))


def _wrap(x, period=None):
    """Into [0, period), an angle without a period into [-pi, pi)."""
    if period is None:
        return x - 2 * math.pi * ca.floor((x + math.pi) / (2 * math.pi))
    return x - period * ca.floor(x / period)


def names(node):
    """All names that occur in an expression (or in any other part of a definition)."""
    if isinstance(node, dict):
        if isinstance(node.get("name"), str) and len(node) == 1:
            yield node["name"]
        for child in node.values():
            yield from names(child)
    elif isinstance(node, list):
        for child in node:
            yield from names(child)


def evaluate(node, scope):
    """The value of an expression in SI, each literal converted from its own unit."""
    if "number" in node:
        return ca.SX(float(node["number"].replace("_", ""))) * factor(node.get("unit"))
    if "name" in node:
        return ca.SX(math.pi) if node["name"] == "pi" else scope.name(node["name"])
    if "op" in node:
        return _operation(node["op"], [evaluate(child, scope) for child in node["args"]])
    if "call" in node:
        return _call(node["call"], node["args"], scope)
    if "value" in node:
        return in_unit(node["value"], node.get("unit"), scope)
    raise ValueError(f"cannot read the expression {node}")


def vector(node, scope):
    """Places, velocities, and what is made of them, as a column along the world's axes; None for what is no vector."""
    if "ground" in node:
        return scope.position(scope.model.place(node))
    if "name" in node:
        return scope.vector(node["name"])
    if "call" in node and node["call"] == "cross":
        a, b = (vector(child, scope) for child in node["args"])
        return ca.cross(a, b) if a is not None and a.numel() == 3 else None
    if "op" not in node:
        return None
    parts = [vector(child, scope) for child in node["args"]]
    if all(part is None for part in parts):
        return None
    # A number beside a vector.
    parts = [evaluate(child, scope) if part is None else part for child, part in zip(node["args"], parts)]
    return _operation(node["op"], parts)


def _operation(operator, arguments):
    if operator == "+":
        return arguments[0] if len(arguments) == 1 else arguments[0] + arguments[1]
    if operator == "-":
        return -arguments[0] if len(arguments) == 1 else arguments[0] - arguments[1]
    if operator == "*":
        return arguments[0] * arguments[1]
    if operator == "/":
        return arguments[0] / arguments[1]
    if operator == "^":
        return _power(arguments[0], arguments[1])
    if operator == "neg":
        return -arguments[0]
    if operator == "not":
        return ca.logic_not(arguments[0])
    if operator in COMPARISONS:
        return COMPARISONS[operator](arguments[0], arguments[1])
    raise ValueError(f"unknown operator `{operator}`")


def _power(base, exponent):
    # Whole powers as products: their derivatives then need no logarithm of a base that may be negative.
    if exponent.is_constant() and float(exponent) == int(float(exponent)) and 0 < abs(float(exponent)) <= 16:
        whole = int(float(exponent))
        result = base
        for _ in range(abs(whole) - 1):
            result = result * base
        return result if whole > 0 else 1 / result
    return base**exponent


def _call(function, arguments, scope):
    if function == "if":
        condition, then, otherwise = (evaluate(child, scope) for child in arguments)
        return ca.if_else(condition, then, otherwise)
    if function == "distance":
        return scope.distance(*arguments)
    if function in ("dot", "cross", "norm"):
        vectors = [vector(child, scope) for child in arguments]
        if function == "norm":
            return ca.sqrt(ca.dot(vectors[0], vectors[0]))
        a, b = vectors
        return ca.dot(a, b) if function == "dot" else a[0] * b[1] - a[1] * b[0]
    if function == "power":
        return scope.power(arguments[0]["name"])
    if function in FUNCTIONS:
        return FUNCTIONS[function](*[evaluate(child, scope) for child in arguments])
    tables, name = getattr(scope, "model", scope).tables, function.removesuffix(".slope")
    if name in tables:
        table = tables[name] if name == function else tables[name].slope
        return table(*[evaluate(child, scope) for child in arguments])
    raise ValueError(f"unknown function `{function}`")


def number(value):
    return float(ca.evalf(ca.SX(value)))
