"""Derivatives of the solution of the equations of motion, ∂(v̇, λ), at consistent states.

With z = [v̇; λ] and R = [M v̇ + Dᵀλ − Q; D v̇ − γ] of the exported coordinates,
    K ∂z/∂x = −∂R/∂x,   K = [M Dᵀ; D 0],
∂R by automatic differentiation of expressions that energies gave, x = positions, velocities, inputs, parameters. By positions
along q̇ = N(q) w, so that a pair turns, a quaternion turns in its own axes, a counted angle with its exported rate.
"""

import casadi as ca
import numpy as np

from coordinate_set import given, symbols
from entries import column

TOLERANCE = 1e-10  # in units of the largest entry of a column's v̇ or λ


class Sensitivity:
    def __init__(self, own):
        if own.equations is None:
            raise NotImplementedError("sensitivities of an absolute set in the plane")
        equations, kinematics, model = own.equations, own.kinematics, own.model
        n, m = kinematics.v.numel(), len(own.rows)
        a, multipliers, direction = ca.SX.sym("a", n), ca.SX.sym("lambda", m), ca.SX.sym("direction", n)
        jacobian = equations.jacobian
        residual = ca.vertcat(
            ca.mtimes(equations.mass, a) + ca.mtimes(jacobian.T, multipliers) - equations.forces,
            ca.mtimes(jacobian, a) - equations.gamma,
        )
        along = ca.jtimes(residual, kinematics.q, kinematics.q_rate(direction))
        by = [ca.jacobian(along, direction)]
        by += [ca.jacobian(residual, variable) for variable in (kinematics.v, model.u, model.p)]
        matrix = ca.blockcat([[equations.mass, jacobian.T], [jacobian, ca.SX(m, m)]])
        arguments = [*symbols(model), kinematics.q, kinematics.v, a, multipliers]
        self.function = ca.Function("sensitivity", arguments, [matrix, ca.horzcat(*by)])
        self.velocities = n
        names = own.column_names
        self.columns = [f"position of '{name}'" for name in names] + [f"'{name}'" for name in names]
        self.columns += [f"input {k}" for k in range(model.u.numel())]
        self.columns += [f"parameter {k}" for k in range(model.p.numel())]
        self.rows = [f"rate of '{name}'" for name in names] + [f"λ of '{row}'" for row in own.rows]

    def __call__(self, states, acceleration, multipliers):
        """(states, n + m, columns)."""
        results = []
        for arguments in zip(*given(states), states["q"], states["v"], acceleration, multipliers, strict=True):
            matrix, right = (np.array(part.full()) for part in self.function(*arguments))
            solution = -np.linalg.solve(matrix, right)
            results.append(solution - np.linalg.solve(matrix, right + matrix @ solution))
        return np.array(results)


def compare_sensitivity(check):
    """Requests that have `sensitivity`: (n + m, columns) of every consistent state; gives the reference's own."""
    if not all("sensitivity" in state for state in check.raw):
        return None
    sensitivity = Sensitivity(check.own)
    own = sensitivity(check.states, check.acceleration, check.own_multipliers)
    found = column(check.raw, "sensitivity", *own.shape[1:])[check.kept]
    own_kept, n = own[check.kept], sensitivity.velocities
    for what, part in (("sensitivity_v", slice(0, n)), ("sensitivity_lambda", slice(n, None))):
        of_found, of_own = found[:, part], own_kept[:, part]
        if of_own.size == 0:
            continue
        largest = np.abs(of_own).max(axis=1, keepdims=True)
        # Columns that vanish are measured by the others.
        scale = np.broadcast_to(np.maximum(largest, 1e-3 * largest.max(axis=2, keepdims=True)), of_own.shape)
        width, names = of_own.shape[2], sensitivity.rows[part]
        check.comparison.terms(
            what,
            *(values.reshape(len(values), -1) for values in (of_found, of_own, scale)),
            lambda k, width=width, names=names: f"{names[k // width]} by {sensitivity.columns[k % width]}",
            TOLERANCE,
        )
    return own
