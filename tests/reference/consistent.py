"""Consistent states: accelerations and reactions against the absolute equations, and the power balance.

The compiler's result, in whichever coordinates, is first expanded to all bodies: z = [v̇; λ] of the absolute system
    K z = b,   K = [M Dᵀ; D 0],   b = [Q; γ].
A joint's multipliers come from its reaction by virtual work: the joint's rows D₂ in the columns of the second
place's body turn λ into the wrench −D₂ᵀ λ about that body's centre, which must be the one given.
"""

import casadi as ca
import numpy as np

import friction
import penalties
from coordinate_set import equations_evaluator, given, symbols
from expressions import evaluate
from magnitude import Evaluator

CHUNK = 16  # dense systems held at a time
NOISE = 1e-13  # entries below, relative to their terms, are zeros of a deficient system
RANK = 1e-11  # singular values below, relative to the largest, are zeros


class AbsoluteSystem:
    """The absolute equations of a model at states that are given body by body."""

    evaluator_of = Evaluator

    def __init__(self, absolute):
        self.equations = absolute
        self.kinematics = absolute.kinematics
        self.model = absolute.model
        kinematics, definition = self.kinematics, self.model.definition
        centers = ca.vertcat(*[self._arm(joint) for joint in self.model.joints.values()])
        quantities = [evaluate(driver["quantity"], kinematics) for driver in definition["drivers"]]
        energy = absolute.kinetic + absolute.potential
        further = self._further()
        self.evaluator = equations_evaluator(
            absolute,
            {
                "arms": centers,
                "driver_rates": kinematics.rate(ca.vertcat(*quantities)) if quantities else ca.SX(0, 1),
                "modal_power": absolute.modal_power,
                "momentum": absolute.momentum,
                "energy_drift": kinematics.rate(energy),
                "energy_explicit": kinematics.explicit_rate(energy),
                "elastic_powers": ca.vertcat(*[load.power_of_stores(kinematics) for load in absolute.loads]),
                "support_powers": ca.vertcat(*[ca.dot(load.f, load.explicit) for load in absolute.loads]),
                "yielding": self._yielding(),
                **further,
            },
            self.evaluator_of,
        )
        joints = list(self.model.joints)
        owners = [row.of for row in absolute.rows]
        self.joint_rows = [[k for k, of in enumerate(owners) if of == name] for name in joints]
        self.first_coupling = sum(len(rows) for rows in self.joint_rows)
        self.drivers = len(definition["drivers"])
        yielding = [joint["name"] for joint in penalties.written(definition)]
        self.yielding = {joints.index(name): k for k, name in enumerate(yielding)}

    def _yielding(self):
        """The generalised forces of the joints that yield, one after the other."""
        loads = [self.equations.load(joint["name"]) for joint in penalties.written(self.model.definition)]
        forces = [ca.jtimes(load.w, self.kinematics.v, load.f + load.elastic, True) for load in loads]
        return ca.vertcat(*forces) if forces else ca.SX(0, 1)

    def _further(self):
        """Quantities that only some kinds need."""
        return {}

    def evaluate(self, states, bodies, angles, modes=None):
        """Quantities by name as (values, magnitudes), and (q, v, v̇) in absolute coordinates."""
        q, v, a = self.kinematics.from_bodies(bodies, angles, modes)
        results = self.evaluator(*given(states), q, v)
        return {name: result.dense() for name, result in results.items()}, v, a

    def pressing(self, states, bodies, angles, reactions):
        """The forces that press surfaces together, by the reactions."""
        q, v, _ = self.coordinates(states, bodies, angles)
        return friction.Pressing(self.kinematics, symbols(self.model))(given(states), q, v, reactions)

    def coordinates(self, states, bodies, angles):
        return self.kinematics.from_bodies(bodies, angles)

    def multipliers(self, quantities, reactions, couplings):
        """λ of all rows from reactions (states, joints, [fx fy τ]); second: what no row of a joint can transmit."""
        jacobian = quantities["jacobian"][0]
        result = np.zeros(quantities["phi"][0].shape)
        leftover = np.zeros(reactions.shape)
        for index, rows in enumerate(self.joint_rows):
            transfer, wrench = self._wrench(index, rows, quantities, jacobian, reactions[:, index])
            result[:, rows] = np.einsum("sij,sj->si", np.linalg.pinv(transfer), wrench)
            if index in self.yielding:
                columns, sign = self._columns(index)
                count = self.kinematics.v.numel()
                first = self.yielding[index] * count
                wrench = wrench - sign * quantities["yielding"][0][:, first : first + count][:, columns]
            leftover[:, index, : wrench.shape[1]] = wrench - np.einsum("sij,sj->si", transfer, result[:, rows])
            size = wrench.shape[1]
            leftover[:, index, size:] = reactions[:, index, size:]  # nothing can turn a particle
        result[:, self.first_coupling :] = couplings
        return result, leftover

    def reactions(self, quantities, multipliers):
        """The inverse: (states, joints, [fx fy τ about the second place]) from λ of all rows."""
        jacobian, arms = quantities["jacobian"][0], quantities["arms"][0]
        result = np.zeros((len(jacobian), len(self.joint_rows), 3))
        for index, rows in enumerate(self.joint_rows):
            columns, sign = self._columns(index)
            wrench = -sign * np.einsum("srj,sr->sj", jacobian[:, rows][:, :, columns], multipliers[:, rows])
            arm = arms[:, 2 * index : 2 * index + 2]
            result[:, index, 0:2] = wrench[:, 0:2]
            if len(columns) == 3:
                torque = arm[:, 0] * wrench[:, 1] - arm[:, 1] * wrench[:, 0]
                result[:, index, 2] = wrench[:, 2] - torque
        return result

    def _wrench(self, index, rows, quantities, jacobian, reaction):
        """−D₂ᵀ (or D₁ᵀ, where the second place is on the ground) and the wrench about the centre it must give."""
        arm = quantities["arms"][0][:, 2 * index : 2 * index + 2]
        columns, sign = self._columns(index)
        fx, fy, torque = reaction[:, 0], reaction[:, 1], reaction[:, 2]
        moment = torque + arm[:, 0] * fy - arm[:, 1] * fx
        wrench = np.stack([fx, fy, moment], axis=1)[:, : len(columns)]
        transfer = -sign * np.transpose(jacobian[:, rows][:, :, columns], (0, 2, 1))
        return transfer, wrench

    def _columns(self, index):
        """v's columns of the body on which the reaction is written down, and the sign of the reaction there."""
        joint = list(self.model.joints.values())[index]
        body, sign = (joint.second.body, 1.0) if joint.second.body is not None else (joint.first.body, -1.0)
        at = self.kinematics.bodies.index(body)
        columns = [2 * at, 2 * at + 1]
        if body in self.kinematics.rigid:
            columns.append(self.kinematics.omega_index(body))
        return columns, sign

    def _arm(self, joint):
        """From the centre of that body to the second place."""
        kinematics = self.kinematics
        body = joint.second.body if joint.second.body is not None else joint.first.body
        pose = kinematics.pose(body)
        return kinematics.position(joint.second) - ca.vertcat(pose.x, pose.y)


class System:
    """K z = b at all states, plain and equilibrated by one scaling for the whole model.

    `deficient`: rows may be implied by others. K is then singular in the directions of λ that exert nothing; condition
    and solution are those across these directions (pseudo-inverse). `background`: share of the terms of b that counts
    as its size even where they cancel.
    """

    def __init__(self, quantities, deficient=False, background=0.0):
        self.deficient = deficient
        self.mass, self.jacobian = quantities["mass"][0], quantities["jacobian"][0]
        if deficient:
            # A row that others imply altogether is nothing but rounding, which no scaling should bring to one.
            self.jacobian = np.where(np.abs(self.jacobian) <= NOISE * quantities["jacobian"][1], 0.0, self.jacobian)
        self.right = np.hstack([quantities["forces"][0], quantities["gamma"][0]])
        self.background = background * np.hstack([quantities["forces"][1], quantities["gamma"][1]])
        self.scaling = self._equilibrate()

    def matrices(self, scaling=None):
        """Dense K, scaled on both sides, in chunks of states."""
        n, m = self.mass.shape[1], self.jacobian.shape[1]
        for start in range(0, len(self.right), CHUNK):
            chunk = slice(start, start + CHUNK)
            k = np.zeros((len(self.right[chunk]), n + m, n + m))
            k[:, :n, :n] = self.mass[chunk]
            k[:, n:, :n] = self.jacobian[chunk]
            k[:, :n, n:] = np.transpose(self.jacobian[chunk], (0, 2, 1))
            yield chunk, k if scaling is None else k * scaling[:, None] * scaling[None, :]

    def backward_errors(self, solution):
        """‖K z − b‖ / (‖K‖ ‖z‖ + ‖b‖ + background) per state, plain and after scaling."""
        plain = self._backward(solution, None)
        return plain, self._backward(solution / self.scaling, self.scaling)

    def conditions(self):
        """‖K‖₁ ‖K⁻¹‖₁ per state after scaling; of a deficient one the ratio of singular values that are no zeros."""
        result = np.full(len(self.right), np.inf)
        for chunk, k in self.matrices(self.scaling):
            for index, matrix in enumerate(k):
                if not np.all(np.isfinite(matrix)):
                    continue
                if self.deficient:
                    singular = np.linalg.svd(matrix, compute_uv=False)
                    result[chunk.start + index] = singular[0] / singular[singular > RANK * singular[0]][-1]
                    continue
                try:
                    inverse = np.linalg.inv(matrix)
                except np.linalg.LinAlgError:
                    continue
                result[chunk.start + index] = np.linalg.norm(matrix, 1) * np.linalg.norm(inverse, 1)
        return result

    def solve(self):
        """z per state; NaN where K is singular without being meant to be."""
        result = np.full(self.right.shape, np.nan)
        for chunk, k in self.matrices(self.scaling):
            for index, matrix in enumerate(k):
                right = self.scaling * self.right[chunk.start + index]
                solve = np.linalg.solve if not self.deficient else _least_squares
                try:
                    scaled = solve(matrix, right)
                    scaled += solve(matrix, right - matrix @ scaled)
                    result[chunk.start + index] = self.scaling * scaled
                except np.linalg.LinAlgError:
                    pass
        return result

    def _backward(self, solution, scaling):
        result = np.zeros(len(self.right))
        for chunk, k in self.matrices(scaling):
            right = self.right[chunk] if scaling is None else scaling * self.right[chunk]
            z = solution[chunk]
            residual = np.abs(np.einsum("sij,sj->si", k, z) - right).max(axis=1)
            norm = np.abs(k).sum(axis=2).max(axis=1)
            background = self.background[chunk] if scaling is None else scaling * self.background[chunk]
            scale = norm * np.abs(z).max(axis=1) + np.abs(right).max(axis=1) + background.max(axis=1)
            result[chunk] = np.where(residual == 0.0, 0.0, residual / np.where(scale == 0.0, 1.0, scale))
        return result

    def _equilibrate(self):
        """Ruiz's iteration (2001) on the largest magnitude of each entry over the states."""
        n, m = self.mass.shape[1], self.jacobian.shape[1]
        largest = np.zeros((n + m, n + m))
        largest[:n, :n] = np.abs(self.mass).max(axis=0)
        largest[n:, :n] = np.abs(self.jacobian).max(axis=0)
        largest[:n, n:] = largest[n:, :n].T
        scaling = np.ones(n + m)
        for _ in range(20):
            peak = (largest * scaling[:, None] * scaling[None, :]).max(axis=1)
            scaling /= np.sqrt(np.where(peak == 0.0, 1.0, peak))
        return scaling


def _least_squares(matrix, right):
    return np.linalg.lstsq(matrix, right, rcond=RANK)[0]
