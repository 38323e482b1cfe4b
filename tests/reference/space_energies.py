"""Equations of motion of spatial mechanisms: Lagrange's equations in the redundant q, projected with q̇ = N(q) v.

    T(q, q̇, t) = Σ ½ m |ṙ|² + ½ tr(Ȧ S Ȧᵀ),   S = ½ tr(J) 1 − J = ∫ x xᵀ dm in body axes about the centre of mass,
    of beams slice by slice, each of which turns about the axis by the rate of the frame and that of its twist, or with shear about all axes,
    of bodies with the modes of a file point by point, and what turns at their nodes by the rates of the frame and of the modes,
    M = Nᵀ (∂²T/∂q̇²) N,   Q = loads − Nᵀ ∂V/∂q − Nᵀ [(d/dt ∂T/∂q̇ at v̇ = 0) − ∂T/∂q].
Ȧ is ∂A/∂q q̇, so no angular velocity occurs. Admissible variations are δq = N δπ, tangent to the unit circles and
spheres of the pairs and quaternions, so that T may be continued off them in any way: the reactions of the norms'
constraints point along q and Nᵀ q = 0 there. (Goldstein, Classical Mechanics, ch. 2.4: multipliers; the matrix S:
García de Jalón & Bayo, 1994, ch. 4.2.) Loads, constraints and their derivatives are those of `energies`.
"""

import casadi as ca

from energies import Energies
from modal import Modal
from space_frames import cleaned, vee


class SpaceEnergies(Energies):
    def _kinetic(self):
        """T as a function of (q, v); keeps T(q, q̇, t)."""
        kinematics, bodies = self.kinematics, self.model.bodies
        self.q_dot = ca.SX.sym("q_dot", kinematics.q.numel())
        poses = [kinematics.poses[name] for name in bodies]
        slices = [(body.mass * share, self._slice(name, x)) for name, body in bodies.items() if body.beam for x, share in body.beam.slices()]
        place = [ca.vertcat(pose.position, ca.vec(ca.SX(pose.matrix))) for pose in poses]
        twisted = [(body, share, self._turned_slice(name, x)) for name, body in bodies.items() if self._twists(body) for x, share in body.beam.slices()]
        place = ca.vertcat(*place, *[at for _, at in slices], *[ca.vec(matrix) for _, _, matrix in twisted])
        rates = ca.jtimes(place, kinematics.q, self.q_dot) + kinematics.explicit_rate(place)
        energy = ca.SX(0)
        for index, body in enumerate(bodies.values()):
            own = rates[12 * index : 12 * index + 12]
            if not body.beam:
                energy += body.mass * ca.dot(own[:3], own[:3]) / 2
            shears = bool(getattr(body.beam, "thick", None))
            if not body.particle and not self._twists(body) and not shears:
                energy += self._turning(body, own[3:])
            if isinstance(body.beam, Modal) or shears:
                omega = vee(ca.mtimes(ca.SX(poses[index].matrix).T, ca.reshape(own[3:], 3, 3)))
                modes = ca.vertcat(*kinematics.modes[body.name][0])
                modal = ca.jtimes(modes, kinematics.q, self.q_dot)
                energy += body.beam.turning_energy(omega, modal, *([body.mass] if shears else []))
        for index, (mass, _) in enumerate(slices):
            own = rates[12 * len(bodies) + 3 * index : 12 * len(bodies) + 3 * index + 3]
            energy += mass * ca.dot(own, own) / 2
        begin = 12 * len(bodies) + 3 * len(slices)
        for index, (body, share, _) in enumerate(twisted):
            energy += share * self._turning(body, rates[begin + 9 * index : begin + 9 * index + 9])
        self.redundant = energy
        return ca.substitute(energy, self.q_dot, kinematics.q_rate(kinematics.v))

    @staticmethod
    def _twists(body):
        return body.beam is not None and body.beam.torsion > 0 and not body.beam.thick

    @staticmethod
    def _turning(body, rates):
        """½ tr(Ȧ S Ȧᵀ)."""
        turning = ca.reshape(rates, 3, 3)
        moments = cleaned(ca.trace(body.inertia) / 2 * ca.SX.eye(3) - body.inertia)
        return ca.trace(ca.mtimes(ca.mtimes(turning, moments), turning.T)) / 2

    def _turned_slice(self, name, x):
        """World ← a section of a beam that is turned about its axis by the whole twist there."""
        twist = self.model.bodies[name].beam.twist(x, self.kinematics.modes[name][0])
        cos, sin = ca.cos(twist), ca.sin(twist)
        about = ca.vertcat(ca.horzcat(1, 0, 0), ca.horzcat(0, cos, -sin), ca.horzcat(0, sin, cos))
        return ca.mtimes(ca.SX(self.kinematics.poses[name].matrix), about)

    def _inertial(self):
        """−Nᵀ [(d/dt ∂T/∂q̇ at v̇ = 0) − ∂T/∂q]."""
        kinematics = self.kinematics
        q, time, v = kinematics.q, self.model.time, kinematics.v
        q_rate = kinematics.q_rate(v)
        second = ca.jtimes(q_rate, q, q_rate)  # q̈ at v̇ = 0
        momentum = ca.gradient(self.redundant, self.q_dot)
        change = ca.jtimes(momentum, ca.vertcat(q, time, self.q_dot), ca.vertcat(q_rate, 1, second))
        lagrange = ca.substitute(change - ca.gradient(self.redundant, q), self.q_dot, q_rate)
        # Nᵀ as the transposed derivative of q̇ with respect to v.
        return -ca.jtimes(q_rate, v, lagrange, True)
