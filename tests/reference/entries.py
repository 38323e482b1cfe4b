"""States of a request as arrays, and random states compared entry by entry."""

import numpy as np

import friction
from comparison import numbers
from coordinate_set import MATRICES, SCALARS, VECTORS


def read_states(model, own, states):
    """What a state is given by, as arrays (states, size)."""
    sizes = {
        "parameters": model.p.numel(),
        "time": 1,
        "inputs": model.u.numel(),
        "phases": model.phases.numel(),
        "z": model.z.numel(),
        "gates": model.gates.numel(),
        "efforts": model.efforts.numel(),
        "q": own.kinematics.q.numel(),
        "v": own.kinematics.v.numel(),
    }
    found = {name: column(states, name, size) for name, size in sizes.items()}
    # What presses is not part of a state: without it there is no friction by reactions, as in Q.
    return found | {"normals": np.zeros((len(states), model.normals.numel()))}


def column(states, name, *shape):
    """One entry of all states as an array (states, …)."""
    if shape == (0,) and name not in states[0]:
        return np.zeros((len(states), 0))
    try:
        return numbers([state[name] for state in states], (len(states), *shape))
    except ValueError as error:
        raise ValueError(f"`{name}` should have {shape} entries in every state") from error


def compare_norms(comparison, own, states):
    """Pairs and quaternions must be of length one: the equations compared mean something only there."""
    norms = own.norms(states["q"])
    one = np.ones(norms.shape)
    comparison.terms("norms", norms, one, one, lambda k: f"pair or quaternion number {k}")


def compare_random(comparison, own, states, quantities):
    compare_energies(comparison, own, states, quantities, random=True)
    for name in VECTORS:
        # Rates may name powers of friction, which are known at consistent states.
        unknown = ("powers", "internal_rates") if states and friction.rubbing(own.model.definition) else ("powers",)
        if name not in unknown:
            compare_vector(comparison, own, states, quantities, name)
    for name in MATRICES:
        compare_matrix(comparison, own, name, [state[name] for state in states], quantities[name])


def compare_vector(comparison, own, states, quantities, name):
    value, scale = quantities[name]
    comparison.terms(name, column(states, name, value.shape[1]), value, scale, own.entry_name(name))


def compare_energies(comparison, own, states, quantities, random=False):
    for name in SCALARS:
        value, scale = quantities[name]
        comparison.terms(name, column(states, name, 1), value, scale, own.entry_name(name))
    value, scale = quantities["powers"]
    # Powers of friction by reactions are known where these are, at consistent states.
    unknown = {load["name"] for load in friction.rubbing(own.model.definition)} if random else set()
    kept = [k for k, load in enumerate(own.model.definition["loads"]) if load["name"] not in unknown]
    found, name = column(states, "powers", value.shape[1]), own.entry_name("powers")
    comparison.terms("powers", found[:, kept], value[:, kept], scale[:, kept], lambda k: name(kept[k]))


def compare_matrix(comparison, own, name, triplets, quantity):
    """Entries of a sparse matrix; a missing entry is a zero, an entry without terms is measured by its row."""
    value, scale = quantity
    dense = np.zeros(value.shape)
    for state, entries in enumerate(triplets):
        entries = numbers(entries, (-1, 3))
        rows, columns = entries[:, 0].astype(int), entries[:, 1].astype(int)
        if len(entries) and (rows.max() >= value.shape[1] or columns.max() >= value.shape[2]):
            comparison.fail(name, f"an entry outside of {value.shape[1]} × {value.shape[2]}")
            return
        dense[state, rows, columns] = entries[:, 2]
        if name == "mass":
            dense[state, columns, rows] = entries[:, 2]
    # Only entries that are there on one of the sides.
    there = np.any((dense != 0.0) | (scale != 0.0), axis=0)
    scale = np.where(scale == 0.0, scale.max(axis=2, keepdims=True, initial=0.0), scale)
    if name == "mass":
        there &= np.tri(len(there), dtype=bool)
    rows, columns = np.nonzero(there)
    comparison.terms(
        name,
        dense[:, rows, columns],
        value[:, rows, columns],
        scale[:, rows, columns],
        lambda k: own.pair_name(name, rows[k], columns[k]),
    )
