"""Consistent states of space: reactions of six components, and what else must hold there.

A joint's rows turn λ into the wrench −D₂ᵀ λ on the second place's body: a force in world axes and a torque about the
centre of mass in body axes; the reaction is that force with the torque about the second place in world axes.
"""

import casadi as ca
import numpy as np

from comparison import RESIDUAL
from consistent import AbsoluteSystem
from consistent_check import ConsistentCheck
from coordinate_set import given
from motion import SPACE
from rounding import RoundingEvaluator


IMPLIED = 1e-3  # of a metre or a radian, and of the fastest velocity


class SpaceAbsoluteSystem(AbsoluteSystem):
    evaluator_of = RoundingEvaluator

    def _further(self):
        kinematics = self.kinematics
        joints = list(self.model.joints.values())
        matrices = [ca.vec(kinematics.pose(self._written_on(joint)).matrix) for joint in joints]
        holding = [joint for joint in joints if not kinematics.yields(joint.name)]
        sides = [(joint.name, side) for joint in holding for side in kinematics.sides(joint)]
        self.side_names = [name for name, _ in sides]
        dropped = ca.vertcat(*[row.value for row in kinematics.dropped]) if kinematics.dropped else ca.SX(0, 1)
        return {
            "matrices": ca.vertcat(*matrices) if matrices else ca.SX(0, 1),
            "sides": ca.vertcat(*[side for _, side in sides]) if sides else ca.SX(0, 1),
            "dropped": dropped,
            "dropped_rate": kinematics.rate(dropped) if kinematics.dropped else ca.SX(0, 1),
            "dropped_jacobian": ca.jacobian(kinematics.rate(dropped), kinematics.v),
        }

    def evaluate(self, states, bodies, angles, modes=None):
        q, v, a = self.kinematics.from_bodies(states, bodies, angles, modes)
        results = self.evaluator(*given(states), q, v)
        return {name: result.dense() for name, result in results.items()}, v, a

    def coordinates(self, states, bodies, angles):
        return self.kinematics.from_bodies(states, bodies, angles)

    def reactions(self, quantities, multipliers):
        """(states, joints, [force, torque about the second place]) from λ of all rows."""
        jacobian = quantities["jacobian"][0]
        result = np.zeros((len(jacobian), len(self.joint_rows), 6))
        for index, rows in enumerate(self.joint_rows):
            columns, sign = self._columns(index)
            wrench = -sign * np.einsum("srj,sr->sj", jacobian[:, rows][:, :, columns], multipliers[:, rows])
            force = result[:, index, :3] = wrench[:, :3]
            if len(columns) == 6:
                arm, matrix = self._arm_and_matrix(index, quantities)
                result[:, index, 3:] = np.einsum("sij,sj->si", matrix, wrench[:, 3:]) - np.cross(arm, force)
        return result

    def _wrench(self, index, rows, quantities, jacobian, reaction):
        arm, matrix = self._arm_and_matrix(index, quantities)
        columns, sign = self._columns(index)
        force, torque = reaction[:, :3], reaction[:, 3:]
        moment = np.einsum("sji,sj->si", matrix, torque + np.cross(arm, force))
        wrench = np.hstack([force, moment])[:, : len(columns)]
        return -sign * np.transpose(jacobian[:, rows][:, :, columns], (0, 2, 1)), wrench

    def _arm_and_matrix(self, index, quantities):
        arm = quantities["arms"][0][:, 3 * index : 3 * index + 3]
        matrix = quantities["matrices"][0][:, 9 * index : 9 * index + 9].reshape(-1, 3, 3)
        return arm, np.transpose(matrix, (0, 2, 1))  # columns were stacked

    def _written_on(self, joint):
        return joint.second.body if joint.second.body is not None else joint.first.body

    def _columns(self, index):
        joint = list(self.model.joints.values())[index]
        return self.kinematics.columns(self._written_on(joint)), 1.0 if joint.second.body is not None else -1.0

    def _arm(self, joint):
        return self.kinematics.position(joint.second) - self.kinematics.pose(self._written_on(joint)).position


class SpaceConsistentCheck(ConsistentCheck):
    motion = SPACE
    system_of = SpaceAbsoluteSystem
    background = 0.1  # gyroscopic terms cancel: where nothing acts, Q is their rounding

    def system_state(self, placed, angles):
        modes = self.own.layout.mode_values(self.states["q"], self.states["v"], self.acceleration)
        return self.system.evaluate(self.states, placed, angles, modes)

    def compare_further(self):
        """Lengths of pairs and quaternions, roots, rows that were dropped, rates of counted angles."""
        norms = self.own.norms(self.states["q"])
        one = np.ones(norms.shape)
        self.comparison.terms("norms", norms, one, one, lambda k: f"pair or quaternion number {k}")
        sides, _ = self.absolute["sides"]
        for k, name in enumerate(self.system.side_names):
            if not np.all(sides[:, k] > 0.0):
                self.comparison.fail("sides", f"joint '{name}' stands on its flipped root")
        rows = self.system.kinematics.dropped
        # What is only implied holds as well as the rows that imply it, times their condition.
        felt = IMPLIED * self.absolute["dropped_jacobian"][1].sum(axis=2)
        fastest = np.abs(self.v).max(axis=1, keepdims=True, initial=0.0)
        for quantity, least in (("dropped", felt), ("dropped_rate", felt * fastest)):
            value, terms = self.absolute[quantity]
            terms = np.maximum(terms, least)
            zero = np.zeros(value.shape)
            self.comparison.terms(quantity, value, zero, terms, lambda k: f"row '{rows[k]}'", RESIDUAL)
        if rows:
            self._compare_dropped(rows)
        (exported, terms), (between, more) = self.own.angle_rates(self.states)
        names = [f"{joint}.{angle}" for (joint, angle), _ in self.own.layout.angles]
        self.comparison.terms("counted_rates", exported, between, terms + more, lambda k: names[k], RESIDUAL)

    def _compare_dropped(self, rows):
        """Each dropped row of D must be a combination of those that are left."""
        jacobian, (dropped, terms) = self.absolute["jacobian"][0], self.absolute["dropped_jacobian"]
        left = np.zeros(dropped.shape)
        for state, matrix in enumerate(jacobian):
            combination = np.linalg.lstsq(matrix.T, dropped[state].T, rcond=1e-10)[0]
            left[state] = dropped[state] - combination.T @ matrix
        left, terms = np.abs(left).max(axis=2), terms.max(axis=2)
        self.comparison.terms(
            "dropped_jacobian", left, np.zeros(left.shape), terms, lambda k: f"row '{rows[k]}' is not implied", RESIDUAL
        )
