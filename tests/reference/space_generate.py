"""Requests for spatial mechanisms made with the reference's own derivation; the counterpart of `generate`."""

import numpy as np

import contacts
import kinds
from consistent import System
from coordinate_set import given, symbols
from generate import consistent_part, nominal, random_part
from magnitude import Evaluator
from space_consistent import SpaceAbsoluteSystem
from space_coordinate_set import SpaceCoordinateSet
from space_reference import quaternions_of


def generate(definition, coordinates, tree, start, random=15, consistent=15, seed=1):
    rng = np.random.default_rng(seed)
    model, absolute, own = kinds.kind_of(definition).derive(definition, coordinates)
    return {
        "definition": definition,
        "coordinates": coordinates,
        "parameters_are_si": True,
        "definition_hash": "0" * 64,
        "random": random_part(own, draw(rng, own, random)),
        "consistent": consistent_states(model, absolute, own, assembled(rng, model, own, tree, start, consistent)),
    }


def consistent_states(model, absolute, own, states):
    deficient = model.definition["options"].get("redundant") == "keep"
    return consistent_part(own, SpaceAbsoluteSystem(absolute), states, deficient)


def assembled(rng, model, own, tree, start, count):
    """Consistent states in the coordinates of `own`, found along the tree."""
    assembled_in = SpaceCoordinateSet(model, tree)
    states = draw(rng, assembled_in, count)
    spread = np.asarray(start) + 0.1 * rng.normal(size=(count, len(start)))
    states = assemble(assembled_in, states, spread)
    return to_absolute(assembled_in, own, states) if own.is_absolute else states


def draw(rng, own, count):
    """Unit pairs and quaternions, everything else at random."""
    layout, model = own.layout, own.model
    q = np.zeros((count, layout.sizes()[0]))
    pairs, quaternions, angles, _ = layout.starts()
    q[:, :pairs] = rng.normal(size=(count, pairs))
    turns = rng.uniform(-np.pi, np.pi, (count, len(layout.rotations)))
    q[:, pairs:quaternions:2], q[:, pairs + 1 : quaternions : 2] = np.cos(turns), np.sin(turns)
    balls = rng.normal(size=(count, len(layout.quaternions), 4))
    q[:, quaternions:angles] = (balls / np.linalg.norm(balls, axis=2, keepdims=True)).reshape(count, -1)
    q[:, angles::2] = rng.integers(-3, 4, (count, len(layout.angles)))
    q[:, angles + 1 :: 2] = rng.uniform(-np.pi, np.pi, (count, len(layout.angles)))
    at = np.array(nominal(model))
    return {
        "parameters": at * rng.uniform(0.9, 1.1, (count, len(at))),
        "time": rng.uniform(0, 2, (count, 1)),
        "inputs": rng.normal(size=(count, model.u.numel())),
        "phases": rng.normal(size=(count, model.phases.numel())),
        "z": rng.normal(size=(count, model.z.numel())),
        "gates": contacts.drawn(model.definition, rng.uniform(size=(count, model.gates.numel()))),
        "efforts": rng.normal(size=(count, model.efforts.numel())),
        "q": q,
        "v": rng.normal(size=(count, layout.sizes()[1])),
    }


def moved(layout, q, increment):
    """q moved by an increment of velocities' kind: exactly along circles and spheres."""
    q = q.copy()
    pairs, quaternions, angles, _ = layout.starts()
    n, r = len(layout.linear), len(layout.rotations)
    q[:, :pairs] += increment[:, :n]
    for k in range(r):
        at, by = pairs + 2 * k, increment[:, n + k]
        c, s = q[:, at].copy(), q[:, at + 1].copy()
        q[:, at], q[:, at + 1] = c * np.cos(by) - s * np.sin(by), s * np.cos(by) + c * np.sin(by)
    for k in range(len(layout.quaternions)):
        at, by = quaternions + 4 * k, increment[:, n + r + 3 * k : n + r + 3 * k + 3]
        half = np.linalg.norm(by, axis=1, keepdims=True) / 2
        turn = np.hstack([np.cos(half), by / 2 * np.sinc(half / np.pi)])
        turned = product(q[:, at : at + 4], turn)
        q[:, at : at + 4] = turned / np.linalg.norm(turned, axis=1, keepdims=True)
    for k, (_, rate) in enumerate(layout.angles):
        for index, weight in rate:
            q[:, angles + 2 * k + 1] += weight * increment[:, index]
    return q


def product(p, q):
    """Of quaternions as rows."""
    scalar = p[:, :1] * q[:, :1] - np.sum(p[:, 1:] * q[:, 1:], axis=1, keepdims=True)
    return np.hstack([scalar, p[:, :1] * q[:, 1:] + q[:, :1] * p[:, 1:] + np.cross(p[:, 1:], q[:, 1:])])


def assemble(own, states, start):
    """Newton from `start`, taken as a way from all coordinates at zero; then velocities by least squares."""
    layout = own.layout
    q = np.zeros(states["q"].shape)
    pairs, quaternions, angles, _ = layout.starts()
    q[:, pairs:quaternions:2] = 1.0
    q[:, quaternions:angles:4] = 1.0
    states["q"] = moved(layout, q, start)
    kinematics = own.kinematics
    arguments = [*symbols(own.model), kinematics.q, kinematics.v]
    rows = Evaluator(arguments, {"phi": own.equations.phi, "jacobian": own.equations.jacobian})
    for _ in range(60):
        results = rows(*given(states), states["q"], states["v"])
        quantities = {name: result.dense() for name, result in results.items()}
        phi, jacobian = quantities["phi"][0], quantities["jacobian"][0]
        if phi.shape[1] == 0 or np.abs(phi).max() < 1e-13:
            break
        step = [np.linalg.lstsq(jacobian[k], phi[k], rcond=1e-10)[0] for k in range(len(phi))]
        states["q"] = moved(layout, states["q"], -np.clip(step, -0.3, 0.3))
    quantities = own.evaluate(states)
    for k in range(len(start)):
        jacobian, v = quantities["jacobian"][0][k], states["v"][k]
        if len(jacobian):
            wanted = quantities["nu"][0][k] - jacobian @ v
            states["v"][k] = v + np.linalg.lstsq(jacobian, wanted, rcond=1e-10)[0]
    return states


def to_absolute(tree, own, states):
    bodies, _ = tree.bodies(states, np.zeros(states["v"].shape))
    names, layout = list(own.model.bodies), own.layout
    q, v = [], []
    for kind, of in layout.linear:
        at = "xyz".index(kind)
        q.append(bodies[:, names.index(of), at, None])
        v.append(bodies[:, names.index(of), 12 + at, None])
    for _, of in layout.quaternions:
        q.append(quaternions_of(bodies[:, names.index(of), 3:12].reshape(-1, 3, 3)))
        v.append(bodies[:, names.index(of), 15:18])
    by_rotor = tree.layout.angle_values(states["q"])
    for key, _ in layout.angles:
        turns = np.round(by_rotor[key] / (2 * np.pi))
        q.append(np.stack([turns, by_rotor[key] - 2 * np.pi * turns], axis=1))
    return states | {"q": np.hstack(q), "v": np.hstack(v)}


def accelerations(own, states, deficient=False):
    """Motions of all bodies (states, bodies, 24) at the accelerations of this set's own equations."""
    solution = System(own.evaluate(states), deficient).solve()
    return own.bodies(states, solution[:, : states["v"].shape[1]])[0]
