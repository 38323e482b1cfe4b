"""The equations in an exported coordinate set, in the exported order of coordinates and rows.

Absolute sets are derived by `reference` in its own order and permuted here; all others by `tree`.
"""

import casadi as ca
import numpy as np

import contacts
import tree
from energies import Energies
from magnitude import MATRICES, Evaluator
from motion import PLANE

TOUCHING = ("gaps", "laws", "gap_rates", "gap_biases", "restitutions", "assignments")
VECTORS = ("phi", "nu", "gamma", "forces", "powers", "internal_rates", "internal_starts", *TOUCHING)
SCALARS = ("kinetic", "potential")


class CoordinateSet:
    motion = PLANE
    evaluator_of = Evaluator

    def __init__(self, model, absolute, coordinates):
        self.model = model
        if coordinates["coordinates"] == "absolute":
            free = [{"body": name, "joint": None, "parent": "ground"} for name in model.bodies]
            coordinates = {**coordinates, "tree": free}
        self.kinematics = tree.Tree(model, coordinates)
        self.layout = self.kinematics.layout
        self.absolute = absolute if coordinates["coordinates"] == "absolute" else None
        self.equations = None if self.absolute else Energies(self.kinematics)
        equations = self.absolute or self.equations
        self.evaluator = equations_evaluator(equations)
        self.column_names = self.layout.velocity_names()
        self.rows = equations.rows if self.absolute is None else self._exported_rows(coordinates["rows"])
        self._bodies = None

    def evaluate(self, states):
        """Values and magnitudes of all quantities by name, in the exported order."""
        q, v = states["q"], states["v"]
        columns = None
        if self.absolute is not None:
            q, columns = self.absolute.kinematics.from_layout(self.layout, q)
            v = v[:, columns]
        results = self.evaluator(*given(states), q, v)
        return {name: self._ordered(name, result.dense(), columns) for name, result in results.items()}

    def bodies(self, states, acceleration):
        """The entries of `motion` per body as (states, bodies, entries), values and magnitudes."""
        if self._bodies is None:
            kinematics = self.kinematics
            a = ca.SX.sym("a", kinematics.v.numel())
            arguments = [*symbols(self.model), kinematics.q, kinematics.v, a]
            self._bodies = self.evaluator_of(arguments, {"bodies": kinematics.bodies(a)})
        result = self._bodies(*given(states), states["q"], states["v"], acceleration)["bodies"]
        shape = (len(acceleration), len(self.model.bodies), self.motion.size)
        return tuple(part.reshape(shape) for part in result.dense())

    def norms(self, q):
        """Lengths that must be one, as (states, …); of planar pairs nothing is asked."""
        return np.zeros((len(q), 0))

    def entry_name(self, quantity):
        """How the k-th entry of a vector quantity is called."""
        if quantity in ("phi", "nu", "gamma"):
            return lambda k: f"row '{self.rows[k]}'"
        if quantity == "forces":
            return lambda k: f"force on '{self.column_names[k]}'"
        if quantity in ("internal_rates", "internal_starts"):
            return lambda k: f"state '{self.model.states[k]['name']}'"
        if quantity in TOUCHING:
            return lambda k: f"{quantity} {k} of {[name for name, _ in self.kinematics.contacts.gates]}"
        if quantity == "powers":
            return lambda k: f"power of '{contacts.all_loads(self.model.definition)[k]}'"
        return lambda k: quantity

    def pair_name(self, quantity, row, column):
        """How an entry of a matrix is called."""
        of = self.rows[row] if quantity == "jacobian" else self.column_names[row]
        return f"row '{of}' column '{self.column_names[column]}'"

    def _exported_rows(self, exported):
        own = {tree.row_key(row.of, row.what): k for k, row in enumerate(self.absolute.rows)}
        asked = [tree.row_key(row["of"], row["what"]) for row in exported]
        if sorted(asked) != sorted(own):
            raise ValueError(f"{self.model.title}: rows exported {sorted(asked)}, rows of the model {sorted(own)}")
        self.row_order = [own[key] for key in asked]
        return [self.absolute.rows[k] for k in self.row_order]

    def _ordered(self, name, dense, columns):
        if columns is None:
            return dense
        inverse = np.argsort(columns)
        if name in ("phi", "nu", "gamma"):
            return tuple(part[:, self.row_order] for part in dense)
        if name == "forces":
            return tuple(part[:, inverse] for part in dense)
        if name == "jacobian":
            return tuple(part[:, self.row_order][:, :, inverse] for part in dense)
        if name == "mass":
            return tuple(part[:, inverse][:, :, inverse] for part in dense)
        return dense


def equations_evaluator(equations, further=None, evaluator_of=Evaluator):
    """All compared quantities of `Energies` as functions of (p, t, u, phases, z, gates, efforts, normals, q, v)."""
    outputs = {name: getattr(equations, name) for name in (*VECTORS, *SCALARS, *MATRICES)}
    kinematics = equations.kinematics
    arguments = [*symbols(equations.model), kinematics.q, kinematics.v]
    return evaluator_of(arguments, {**outputs, **(further or {})})


def symbols(model):
    return [model.p, model.time, model.u, model.phases, model.z, model.gates, model.efforts, model.normals]


def given(states):
    names = ("parameters", "time", "inputs", "phases", "z", "gates", "efforts", "normals")
    return [states.get(name, np.zeros((len(states["time"]), 0))) for name in names]
