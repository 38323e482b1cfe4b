"""Requests made with the reference's own derivation, for the tests of the reference itself.

Draws random states, and consistent ones by Newton's method from a given start; solves the equations of the chosen
coordinate set and expands the result to bodies and reactions the way a compiler would. `generate` therefore agrees
with `check` but for rounding, unless something is changed afterwards.
"""

import numpy as np

import contacts
import reference
from consistent import AbsoluteSystem, System
from coordinate_set import CoordinateSet
from definition import Model


def generate(definition, coordinates, tree, start, random=20, consistent=20, seed=1):
    """`start`: linear coordinates and angles (in the place of the pairs) in the order of the v of `tree`, near an
    assembly. `coordinates` may be that tree, or absolute ones, to which the assembled states are brought."""
    rng = np.random.default_rng(seed)
    model = Model(definition)
    absolute = reference.derive(model)
    own = CoordinateSet(model, absolute, coordinates)
    states = draw(rng, own, random)
    assembled_in = CoordinateSet(model, absolute, tree)
    free = draw(rng, assembled_in, consistent)
    free = assemble(assembled_in, free, np.asarray(start) + 0.1 * rng.normal(size=(consistent, len(start))))
    if own.absolute is not None:
        free = to_absolute(assembled_in, own, free)
    return {
        "definition": definition,
        "coordinates": coordinates,
        "parameters_are_si": True,
        "definition_hash": "0" * 64,
        "random": random_part(own, states),
        "consistent": consistent_part(own, AbsoluteSystem(absolute), free),
    }


def draw(rng, own, count):
    layout, model = own.layout, own.model
    at = np.array(nominal(model))
    angles = rng.uniform(-np.pi, np.pi, (count, len(layout.rotations)))
    linear = rng.normal(size=(count, len(layout.linear)))
    turns = rng.integers(-3, 4, (count, len(layout.angles)))
    remainder = rng.uniform(-np.pi, np.pi, turns.shape)
    return {
        "parameters": at * rng.uniform(0.7, 1.4, (count, len(at))),
        "time": rng.uniform(0, 2, (count, 1)),
        "inputs": rng.normal(size=(count, model.u.numel())),
        "phases": rng.normal(size=(count, model.phases.numel())),
        "z": rng.normal(size=(count, model.z.numel())),
        "gates": contacts.drawn(model.definition, rng.uniform(size=(count, model.gates.numel()))),
        "efforts": rng.normal(size=(count, model.efforts.numel())),
        "q": pack(linear, angles, turns, remainder),
        "v": rng.normal(size=(count, len(layout.linear) + len(layout.rotations))),
    }


def nominal(model):
    return [float(p["value"]["number"]) for p in model.definition["parameters"]]


def pack(linear, angles, turns, remainder):
    states = len(linear)
    pairs = np.stack([np.cos(angles), np.sin(angles)], axis=2).reshape(states, -1)
    multi = np.stack([turns, remainder], axis=2).reshape(states, -1)
    return np.hstack([linear, pairs, multi])


def assemble(own, states, start):
    """Newton from `start`, multi-turn angles being differences of the plain ones; then velocities by least squares."""
    n, at = len(own.layout.linear), start.copy()
    for _ in range(200):
        states["q"] = place(own, at, n)
        quantities = own.evaluate(states)
        phi, jacobian = quantities["phi"][0], quantities["jacobian"][0]
        if phi.shape[1] == 0:
            break
        for state in range(len(at)):
            at[state] -= np.clip(np.linalg.lstsq(jacobian[state], phi[state], rcond=None)[0], -0.3, 0.3)
        if np.abs(phi).max() < 1e-14:
            break
    states["q"] = place(own, at, n)
    quantities = own.evaluate(states)
    for state in range(len(at)):
        jacobian, v = quantities["jacobian"][0][state], states["v"][state]
        if len(jacobian):
            wanted = quantities["nu"][0][state] - jacobian @ v
            states["v"][state] = v + np.linalg.lstsq(jacobian, wanted, rcond=None)[0]
    return states


def to_absolute(tree, own, states):
    bodies, _ = tree.bodies(states, np.zeros(states["v"].shape))
    names, layout = list(own.model.bodies), own.layout
    linear, rotations = [(of, "xy".index(axis)) for axis, of in layout.linear], list(layout.rotations)
    at = [names.index(of) for of in rotations]
    by_rotor = tree.layout.angle_values(states["q"])
    multi = np.array([by_rotor[angle["of"]] for angle in layout.angles]).T.reshape(len(bodies), -1)
    turns = np.round(multi / (2 * np.pi))
    columns = [bodies[:, names.index(of), axis] for of, axis in linear]
    columns += [bodies[:, k, 2 + part] for k in at for part in (0, 1)]
    columns += [part[:, k] for k in range(turns.shape[1]) for part in (turns, multi - 2 * np.pi * turns)]
    rates = [bodies[:, names.index(of), 4 + axis] for of, axis in linear] + [bodies[:, k, 6] for k in at]
    return states | {"q": np.stack(columns, axis=1), "v": np.stack(rates, axis=1)}


def place(own, at, n):
    multi = np.zeros((len(at), len(own.layout.angles)))
    for k, angle in enumerate(own.layout.angles):
        for index, weight in angle["rate"]:
            multi[:, k] += weight * at[:, index]
    turns = np.round(multi / (2 * np.pi))
    return pack(at[:, :n], at[:, n:], turns, multi - 2 * np.pi * turns)


def random_part(own, states):
    quantities = own.evaluate(states)
    return [given_part(states, k) | derived_part(quantities, k) for k in range(len(states["q"]))]


def given_part(states, k):
    return {name: part[k].tolist() for name, part in states.items()} | {"time": float(states["time"][k, 0])}


def derived_part(quantities, k):
    part = {name: quantities[name][0][k].tolist() for name in ("phi", "nu", "gamma", "forces", "powers")}
    part |= {name: float(quantities[name][0][k, 0]) for name in ("kinetic", "potential")}
    return part | {
        "jacobian": triplets(quantities["jacobian"][0][k]),
        "mass": triplets(np.tril(quantities["mass"][0][k])),
    }


def triplets(matrix):
    return [[int(r), int(c), float(matrix[r, c])] for r, c in zip(*np.nonzero(matrix), strict=True)]


def consistent_part(own, system, states, deficient=False):
    quantities = own.evaluate(states)
    solution = System(quantities, deficient).solve()
    n = states["v"].shape[1]
    bodies, _ = own.bodies(states, solution[:, :n])
    parts, _, a = system.evaluate(states, bodies, own.layout.angle_values(states["q"]))
    multipliers = absolute_multipliers(own, system, parts, a, solution[:, n:] if deficient else None)
    reactions = system.reactions(parts, multipliers)
    efforts = -multipliers[:, multipliers.shape[1] - system.drivers :]
    powers = efforts * parts["driver_rates"][0]
    result = []
    for k in range(len(a)):
        derived = derived_part(quantities, k)
        solved = {
            "acceleration": solution[k, :n],
            "lambda": solution[k, n:],
            "bodies": bodies[k],
            "reactions": reactions[k],
            "multipliers": multipliers[k, system.first_coupling :],
            "driver_efforts": efforts[k],
            "driver_powers": powers[k],
        }
        energies = {name: derived[name] for name in ("kinetic", "potential", "powers")}
        result.append(given_part(states, k) | energies | {name: part.tolist() for name, part in solved.items()})
    return result


def absolute_multipliers(own, system, parts, a, known=None):
    """They follow from the bodies' accelerations: Dᵀ λ = Q − M v̇. Where λ is one of many, those of the set's own rows
    are `known`."""
    jacobian = parts["jacobian"][0]
    multipliers = np.zeros(parts["phi"][0].shape)
    names = [str(row) for row in system.equations.rows]
    shared = [names.index(str(row)) for row in own.rows] if known is not None else []
    rest = [k for k in range(len(names)) if k not in shared]
    for k in range(len(a)):
        missing = parts["forces"][0][k] - parts["mass"][0][k] @ a[k]
        if shared:
            multipliers[k, shared] = known[k]
            missing -= jacobian[k, shared].T @ known[k]
        if rest:
            multipliers[k, rest] = np.linalg.lstsq(jacobian[k, rest].T, missing, rcond=None)[0]
    return multipliers
