"""Units as a user writes them, `kg*m^2/s^2`, to factors of SI.

Dimensions are the compiler's affair: this file only answers by what number a value in a unit is multiplied.
"""

import math
import re

# Units with a name of their own that take no prefix. Looked up before prefixes: `min` is no milli-inch.
PLAIN = {
    "1": 1.0,
    "kg": 1.0,
    "rad": 1.0,
    "deg": math.pi / 180.0,
    "rev": 2.0 * math.pi,
    "rpm": 2.0 * math.pi / 60.0,
    "bar": 1e5,
    "t": 1e3,
    "min": 60.0,
    "h": 3600.0,
}
PREFIXED = {
    "m": 1.0, "g": 1e-3, "s": 1.0, "N": 1.0, "Pa": 1.0, "J": 1.0, "W": 1.0, "Hz": 1.0,
    "A": 1.0, "V": 1.0, "ohm": 1.0, "H": 1.0, "F": 1.0, "Wb": 1.0,
}  # fmt: skip
PREFIXES = {
    "f": 1e-15, "p": 1e-12, "n": 1e-9, "u": 1e-6, "µ": 1e-6, "μ": 1e-6, "m": 1e-3, "c": 1e-2, "d": 1e-1,
    "h": 1e2, "k": 1e3, "M": 1e6, "G": 1e9, "T": 1e12,
}  # fmt: skip

TOKEN = re.compile(r"\s*(?:(\d+(?:\.\d+)?)|([^\W\d]+)|([*/^()+-]))")


def factor(unit):
    """The number by which a value in `unit` is multiplied to be in SI. No unit (None) counts as 1."""
    if unit is None:
        return 1.0
    tokens = _tokens(unit)
    value, rest = _product(tokens, unit)
    if rest:
        raise ValueError(f"unit `{unit}`: cannot read `{rest[0]}`")
    return value


def _tokens(unit):
    tokens, at = [], 0
    text = unit.strip()
    while at < len(text):
        match = TOKEN.match(text, at)
        if match is None:
            raise ValueError(f"unit `{unit}`: cannot read `{text[at:]}`")
        tokens.append(match.group(0).strip())
        at = match.end()
    return tokens


def _product(tokens, unit):
    value, tokens = _power(tokens, unit)
    while tokens and tokens[0] in "*/":
        operator = tokens[0]
        other, tokens = _power(tokens[1:], unit)
        value = value * other if operator == "*" else value / other
    return value, tokens


def _power(tokens, unit):
    if not tokens:
        raise ValueError(f"unit `{unit}` ends too early")
    if tokens[0] == "(":
        value, tokens = _product(tokens[1:], unit)
        tokens = _close(tokens, unit)
    else:
        value, tokens = _single(tokens[0]), tokens[1:]
    if tokens and tokens[0] == "^":
        exponent, tokens = _exponent(tokens[1:], unit)
        value = value**exponent
    return value, tokens


def _exponent(tokens, unit):
    if tokens[:1] == ["("]:
        exponent, tokens = _exponent(tokens[1:], unit)
        if tokens[:1] == ["/"]:
            exponent, tokens = exponent / float(tokens[1]), tokens[2:]
        return exponent, _close(tokens, unit)
    sign = -1.0 if tokens[:1] == ["-"] else 1.0
    if tokens[:1] in (["-"], ["+"]):
        tokens = tokens[1:]
    return sign * float(tokens[0]), tokens[1:]


def _close(tokens, unit):
    if tokens[:1] != [")"]:
        raise ValueError(f"unit `{unit}`: a parenthesis is not closed")
    return tokens[1:]


def _single(name):
    if name in PLAIN:
        return PLAIN[name]
    if name in PREFIXED:
        return PREFIXED[name]
    if name[:1] in PREFIXES and name[1:] in PREFIXED:
        return PREFIXES[name[0]] * PREFIXED[name[1:]]
    raise ValueError(f"unknown unit `{name}`")
