"""The reference's own values at a few states of a request, for a comparison without CasADi.

One JSON file per request. A quantity compared in units of its terms is followed by its magnitudes: a vector as
`name` and `name_scale`, a matrix as [row, column, value, scale] (of the mass matrix the lower triangle), a scalar as
[value, scale]. Consistent states also carry the reference's solution (acceleration, lambda, bodies, reactions,
multipliers, efforts and powers of drivers) with the condition after scaling, which bounds how far a backward stable
solution may be from it, and the system itself (mass, jacobian, forces, gamma), for a backward error.
"""

import json

import casadi as ca
import numpy as np

from coordinate_set import MATRICES, SCALARS, VECTORS

GIVEN = ("parameters", "time", "inputs", "q", "v", "phases")


def write_record(path, request, own, records):
    path.parent.mkdir(parents=True, exist_ok=True)
    head = {
        "format": 1,
        "model": request["definition"]["name"],
        "coordinates": request["coordinates"]["coordinates"],
        "definition_hash": request.get("definition_hash"),
        "casadi": ca.__version__,
        "rows": [str(row) for row in own.rows],
        "velocities": own.column_names,
    }
    # A state a line: short enough, and a change shows where it is.
    lines = [f" {json.dumps(key)}: {json.dumps(value, ensure_ascii=False)}" for key, value in head.items()]
    for kind, states in records.items():
        body = ",\n".join("  " + json.dumps(state, separators=(",", ":")) for state in states)
        lines.append(f" {json.dumps(kind)}: [\n{body}\n ]")
    path.write_text("{\n" + ",\n".join(lines) + "\n}\n")


def random_records(states, quantities, count):
    return [
        given_part(states, k) | quantity_part(quantities, k, (*VECTORS, *SCALARS, *MATRICES))
        for k in range(min(count, len(states["q"])))
    ]


def consistent_records(check, count, further):
    """Of well-conditioned states; accelerations and reactions as the reference solves for them."""
    chosen = np.flatnonzero(check.kept)[:count]
    n, absolute_n = check.states["v"].shape[1], check.v.shape[1]
    own_solution, solution = check.own_equations.solve(), check.absolute_equations.solve()
    multipliers = solution[:, absolute_n:]
    bodies, _ = check.own.bodies(check.states, own_solution[:, :n])
    reactions = check.system.reactions(check.absolute, multipliers)
    first, drivers = check.system.first_coupling, check.system.drivers
    efforts = -multipliers[:, multipliers.shape[1] - drivers :]
    solved = {
        "acceleration": own_solution[:, :n],
        "lambda": own_solution[:, n:],
        "bodies": bodies,
        "reactions": reactions,
        "multipliers": multipliers[:, first:],
        "driver_efforts": efforts,
        "driver_powers": efforts * check.absolute["driver_rates"][0],
    }
    solved |= further
    return [
        given_part(check.states, k)
        | quantity_part(check.quantities, k, ("powers", *SCALARS, "forces", "nu", "gamma", *MATRICES))
        | {"condition": rounded(check.condition[k])}
        | {name: shortened(values[k]) for name, values in solved.items()}
        for k in chosen
    ]


def given_part(states, k):
    part = {name: states[name][k].tolist() for name in GIVEN}
    part |= {name: states[name][k].tolist() for name in ("z", "gates", "efforts") if states[name].size}
    return part | {"time": part["time"][0]}


def quantity_part(quantities, k, names):
    part = {}
    for name in names:
        value, scale = (array[k] for array in quantities[name])
        if name.startswith(("internal_", "gap", "laws", "restitutions", "assignments")) and value.size == 0:
            continue
        if name in SCALARS:
            part[name] = [shortened(value[0]), rounded(scale[0])]
        elif name in VECTORS:
            part[name] = shortened(value)
            part[f"{name}_scale"] = [rounded(x) for x in scale]
        else:
            shown = np.tril(scale) if name == "mass" else scale
            rows, columns = np.nonzero(shown)
            part[name] = [
                [int(r), int(c), shortened(value[r, c]), rounded(scale[r, c])] for r, c in zip(rows, columns, strict=True)
            ]
    return part


def shortened(value):
    """Fifteen digits, a thousandth of what is asked; what the values are of is written in full."""
    return float(f"{value:.15g}") if np.ndim(value) == 0 else [shortened(part) for part in value]


def rounded(value):
    """Three digits are enough for a magnitude."""
    return float(f"{value:.2e}")
