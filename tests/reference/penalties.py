"""Joints that yield: forces in place of their rows.

With x what the joint holds, components of the way between places that coincide along the axes of the first's body and the
residuals of its other rows:
    V = Σ k x²/2,   effort −c ẋ along x,
    or of the way δ between places, with `damping_along`, −c (δ·δ̇)/max(δ·δ, ε²) δ.
"""

import casadi as ca

import expressions

MEETING = ("spherical", "revolute", "fixed", "universal", "constant_velocity")
TURNING = ("angle", "axis_1", "axis_2", "cross", "twist")


def written(definition):
    return [joint for joint in definition["joints"] if joint.get("penalty")]


def find(definition, name):
    return next((joint for joint in written(definition) if joint["name"] == name), None)


class Penalty:
    """What one joint exerts: along `deflection`, by `stiffness` and `damping`."""

    def __init__(self, node, kinematics):
        self.kinematics = kinematics
        joint, penalty = kinematics.model.joints[node["name"]], node["penalty"]
        rows = kinematics.joint_rows(joint)
        shifts = [row.value for row in rows if row.what not in TURNING]
        turns = [row.value for row in rows if row.what in TURNING]
        if joint.kind in MEETING:
            shifts = ca.vertsplit(kinematics.displacement(joint.first, joint.second)[0])

        def value(key):
            return expressions.entry(penalty[key], kinematics.model) if penalty.get(key) else ca.SX(0)

        def each(key):
            return ca.vertcat(ca.repmat(value(key), len(shifts)), ca.repmat(value(f"torsional_{key}"), len(turns)))

        self.shifts = len(shifts)
        self.deflection = ca.vertcat(*shifts, *turns)
        self.stiffness, self.damping = each("stiffness"), each("damping")
        self.smallest = value("smallest") if penalty.get("damping_along") else None

    def elastic(self):
        return -self.stiffness * self.deflection

    def energy(self):
        return ca.dot(self.stiffness, self.deflection**2) / 2

    def lost(self, rate):
        """The efforts of damping."""
        rates = ca.SX(rate)
        if self.smallest is not None:
            way = self.deflection[: self.shifts]
            square = ca.dot(way, way)
            along = ca.dot(way, rates[: self.shifts]) / ca.fmax(square, self.smallest**2)
            rates[: self.shifts] = along * way
        return -self.damping * rates
