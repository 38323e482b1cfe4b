"""The equations of a spatial mechanism in an exported coordinate set, in the exported order."""

import casadi as ca

from coordinate_set import CoordinateSet, equations_evaluator, given, symbols
from motion import SPACE
from rounding import RoundingEvaluator
from space_energies import SpaceEnergies
from space_tree import SpaceTree


class SpaceCoordinateSet(CoordinateSet):
    """An absolute set is a tree of free bodies: there is nothing to permute."""

    motion = SPACE
    evaluator_of = RoundingEvaluator

    def __init__(self, model, coordinates):
        self.model = model
        self.is_absolute = coordinates["coordinates"] == "absolute"
        if self.is_absolute:
            free = [{"body": name, "joint": None, "parent": "ground"} for name in model.bodies]
            coordinates = {**coordinates, "tree": free}
        self.kinematics = SpaceTree(model, coordinates)
        self.layout = self.kinematics.layout
        self.absolute = None
        equations = self.equations = SpaceEnergies(self.kinematics)
        self.evaluator = equations_evaluator(equations, None, RoundingEvaluator)
        self.column_names = self.layout.velocity_names()
        self.rows = equations.rows
        self._bodies = None

    def norms(self, q):
        return self.layout.norms(q)

    def angle_rates(self, states):
        """Rates of counted angles: as exported, and of the angles between the bodies; values and magnitudes."""
        kinematics = self.kinematics
        counted = [kinematics.counted(*key) for key, _ in self.layout.angles]
        between = [kinematics.principal(self.model.joints[joint], angle) for (joint, angle), _ in self.layout.angles]
        outputs = {
            name: kinematics.rate(ca.vertcat(*angles)) if angles else ca.SX(0, 1)
            for name, angles in (("exported", counted), ("between", between))
        }
        arguments = [*symbols(self.model), kinematics.q, kinematics.v]
        results = RoundingEvaluator(arguments, outputs)(*given(states), states["q"], states["v"])
        return [results[name].dense() for name in outputs]
