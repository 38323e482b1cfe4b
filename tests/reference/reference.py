"""Absolute coordinates, in an order of the script's own: x, y of each centre of mass, then the orientations.

    q = [x, y per body | c, s per rigid body | θ per rotor in use],   v = [ẋ, ẏ per body | ω per rigid body].

A particle has no orientation. Everything else follows from `energies`. `from_bodies` and `from_layout` bring states
of other coordinate sets here.
"""

import casadi as ca
import numpy as np

from definition import rotors_in_use
from energies import Energies
from kinematics import Kinematics, Pose


class Absolute(Kinematics):
    def __init__(self, model):
        super().__init__(model)
        self.bodies = list(model.bodies)
        self.rigid = [name for name, body in model.bodies.items() if not body.particle]
        self.rotors = rotors_in_use(model)
        self.bent = [(mode, name) for name, body in model.bodies.items() if body.beam for mode in body.beam.names]
        n, m, r = 2 * len(self.bodies), len(self.bent), len(self.rigid)
        self.linear = n + m
        self.q = ca.SX.sym("q", n + m + 2 * r + len(self.rotors))
        self.v = ca.SX.sym("v", n + m + r)
        self.pair_start, self.angle_start = n + m, n + m + 2 * r
        for name, body in model.bodies.items():
            if body.beam is not None:
                own = [n + self.bent.index((mode, name)) for mode in body.beam.names]
                self.modes[name] = ([self.q[k] for k in own], [self.v[k] for k in own])
        for index, name in enumerate(self.bodies):
            c, s, omega = ca.SX(1), ca.SX(0), ca.SX(0)
            if name in self.rigid:
                rotation = self.rigid.index(name)
                c, s = (self.q[self.pair_start + 2 * rotation + k] for k in range(2))
                omega = self.v[self.linear + rotation]
            self.poses[name] = Pose(self.q[2 * index], self.q[2 * index + 1], c, s, omega)

    def q_rate(self, v):
        """q̇ = N(q) v: ċ = −s ω, ṡ = c ω, θ̇ = ω of the turning body − ω of the other."""
        rates = [v[: self.linear]]
        for name in self.rigid:
            omega = v[self.omega_index(name)]
            rates += [-self.poses[name].s * omega, self.poses[name].c * omega]
        for rotor in self.rotors:
            plus, minus = (v[self.omega_index(b)] if b in self.rigid else ca.SX(0) for b in self.rotor(rotor))
            rates.append(plus - minus + ca.substitute(self.slopes(rotor, of_rates=True), self.v, v))
        return ca.vertcat(*rates)

    def multi_turn(self, rotor):
        return self.q[self.angle_start + self.rotors.index(rotor)]

    def omega_index(self, body):
        return self.linear + self.rigid.index(body)

    def velocity_names(self):
        linear = [f"{name} v{axis}" for name in self.bodies for axis in "xy"]
        linear += [f"{name} {mode}" for mode, name in self.bent]
        return linear + [f"{name} ω" for name in self.rigid]

    # Numbers: states as rows of arrays.

    def from_bodies(self, bodies, angles, modes=None):
        """(q, v, v̇) of states given body by body, as (states, bodies, [x y c s vx vy ω ax ay α]); `angles` by rotor, `modes`
        of beams with their rates and accelerations by (mode, body)."""
        rigid = [self.bodies.index(name) for name in self.rigid]
        states = len(bodies)
        pairs = bodies[:, rigid, 2:4].reshape(states, -1)
        bent = [np.zeros((states, 0))] * 3
        if self.bent:
            bent = [np.stack([modes[key][which] for key in self.bent], axis=1) for which in range(3)]
        q = np.hstack([bodies[:, :, 0:2].reshape(states, -1), bent[0], pairs, self._angles(pairs, angles)])
        v = np.hstack([bodies[:, :, 4:6].reshape(states, -1), bent[1], bodies[:, rigid, 6]])
        a = np.hstack([bodies[:, :, 7:9].reshape(states, -1), bent[2], bodies[:, rigid, 9]])
        return q, v, a

    def from_layout(self, layout, q):
        """This order's q of states in the layout of an exported absolute coordinate set."""
        q_order, v_order = self.orders(layout)
        q = np.asarray(q, float)
        bare = q[:, q_order]
        return np.hstack([bare, self._angles(bare[:, self.pair_start :], layout.angle_values(q))]), v_order

    def orders(self, layout):
        """For each of this order's linear and pair entries the index in `layout`; the same for v."""
        linear = [layout.linear[(axis, name)] for name in self.bodies for axis in "xy"]
        linear += [layout.linear[key] for key in self.bent]
        rotations = [layout.rotations[name] for name in self.rigid]
        if len(linear) != len(layout.linear) or len(rotations) != len(layout.rotations):
            raise ValueError(f"{self.model.title}: the absolute coordinates list more than the bodies have")
        n = len(linear)
        q_order = linear + [n + 2 * rotation + k for rotation in rotations for k in range(2)]
        return q_order, linear + [n + rotation for rotation in rotations]

    def _angles(self, pairs, angles):
        """Multi-turn angles of the rotors in use: those given (by rotor), else from the pairs, in (−π, π]."""
        theta = np.arctan2(pairs[:, 1::2], pairs[:, 0::2])
        columns = []
        for rotor in self.rotors:
            values = angles.get(rotor)
            if values is None:
                plus, minus = (
                    theta[:, self.rigid.index(body)] if body in self.rigid else 0.0 for body in self.rotor(rotor)
                )
                values = np.remainder(plus - minus + np.pi, 2 * np.pi) - np.pi
            columns.append(values)
        return np.stack(columns, axis=1) if columns else np.zeros((len(pairs), 0))


def derive(model):
    """The absolute equations of a model."""
    return Energies(Absolute(model))
