"""Absolute equations of a spatial mechanism in an order of the script's own, with the rows that a set has.

    q = [x, y, z per body | modes | quaternion per rigid body | offset per joint angle],
    v = [ẋ, ẏ, ż per body | rates of modes | ω per rigid body].

A counted angle is its principal value from the axes of the two bodies plus a constant offset; so it is derived here
without the exported rates. The rows are those of the joints that the exported tree stands on and those exported (in
the exported axes): for an absolute set exactly the exported ones. In the order of the model; rows that were dropped
as redundant are kept aside.
"""

import casadi as ca
import numpy as np

from coordinate_set import given, symbols
from space_definition import ANGLES
from space_energies import SpaceEnergies
from space_tree import SpaceTree


class SpaceAbsolute(SpaceTree):
    def __init__(self, model, coordinates):
        self.angles = [
            (joint.name, angle) for joint in model.joints.values() for angle in ANGLES.get(joint.kind, ())
        ]
        self.body_names = list(model.bodies)
        self.rigid = [name for name, body in model.bodies.items() if not body.particle]
        self.bent = [(mode, name) for name, body in model.bodies.items() if body.beam for mode in body.beam.names]
        own = {
            "tree": [{"body": name, "joint": None, "parent": "ground"} for name in self.body_names],
            "linear": [{"kind": kind, "of": name} for name in self.body_names for kind in "xyz"]
            + [{"kind": mode, "of": name} for mode, name in self.bent],
            "rotations": [],
            "quaternions": [{"body": name} for name in self.rigid],
            "angles": [],
            "rows": coordinates["rows"],
        }
        self.carrying = {branch["joint"] for branch in coordinates["tree"]}
        super().__init__(model, own)
        self.dropped = []
        principals = [self.principal(model.joints[joint], angle) for joint, angle in self.angles]
        self._principals = ca.Function("principals", [*symbols(model), self.q], [ca.vertcat(*principals)])

    def _symbols(self, size):
        self.offsets = size
        return super()._symbols(size + len(self.angles))

    def q_rate(self, v):
        return ca.vertcat(super().q_rate(v), ca.SX.zeros(len(self.angles)))

    def counted(self, joint, angle):
        """The offset is a coordinate that does not move."""
        if (joint, angle) not in self.angles:
            return None
        at = self.offsets + self.angles.index((joint, angle))
        return self.principal(self.model.joints[joint], angle) + self.q[at]

    def rows(self):
        asked = {self.row_key(row["of"], row["what"]) for row in self.exported}
        rows = super(SpaceTree, self).rows()
        keep = [row.of in self.carrying or self.row_key(row.of, row.what) in asked for row in rows]
        self.dropped = [row for row, kept in zip(rows, keep, strict=True) if not kept]
        return [row for row, kept in zip(rows, keep, strict=True) if kept]

    def columns(self, body):
        """v's columns of a body."""
        at = 3 * self.body_names.index(body)
        columns = [at, at + 1, at + 2]
        if body in self.rigid:
            first = 3 * len(self.body_names) + len(self.bent) + 3 * self.rigid.index(body)
            columns += [first, first + 1, first + 2]
        return columns

    # Numbers: states as rows of arrays.

    def from_bodies(self, states, bodies, angles, modes=None):
        """(q, v, v̇) of states given body by body, as (states, bodies, 24); `angles` by (joint, angle), `modes` of beams with their rates
        and accelerations by (mode, body)."""
        rigid = [self.body_names.index(name) for name in self.rigid]
        count = len(bodies)

        bent = [np.zeros((count, 0))] * 3
        if self.bent:
            bent = [np.stack([modes[key][which] for key in self.bent], axis=1) for which in range(3)]

        def flat(linear, modal, angular):
            parts = bodies[:, :, linear : linear + 3], modal, bodies[:, rigid, angular : angular + 3]
            return np.hstack([part.reshape(count, -1) for part in parts])

        quaternions = quaternions_of(bodies[:, rigid, 3:12].reshape(count, -1, 3, 3)).reshape(count, -1)
        q = np.hstack([bodies[:, :, 0:3].reshape(count, -1), bent[0], quaternions, np.zeros((count, len(self.angles)))])
        if self.angles:
            principal = np.array(self._principals(*[part.T for part in (*given(states), q)]).full()).T
            for k, key in enumerate(self.angles):
                if key in angles:
                    q[:, self.offsets + k] = angles[key] - principal[:, k]
        return q, flat(12, bent[1], 15), flat(18, bent[2], 21)


def quaternions_of(matrices):
    """Unit quaternions of rotation matrices (…, 3, 3): the largest column of the symmetric 4 × 4 matrix 4 q qᵀ."""
    a = np.asarray(matrices, float)
    trace = np.trace(a, axis1=-2, axis2=-1)
    product = np.zeros((*a.shape[:-2], 4, 4))
    product[..., 0, 0] = 1 + trace
    for i in range(3):
        j, k = (i + 1) % 3, (i + 2) % 3
        product[..., i + 1, i + 1] = 1 + 2 * a[..., i, i] - trace
        product[..., 0, i + 1] = product[..., i + 1, 0] = a[..., k, j] - a[..., j, k]
        product[..., i + 1, j + 1] = product[..., j + 1, i + 1] = a[..., i, j] + a[..., j, i]
    largest = np.argmax(np.einsum("...ii->...i", product), axis=-1)
    column = np.take_along_axis(product, largest[..., None, None], axis=-1)[..., 0]
    return column / np.linalg.norm(column, axis=-1, keepdims=True)


def derive(model, coordinates):
    """The absolute equations of a model, with the rows of a coordinate set."""
    return SpaceEnergies(SpaceAbsolute(model, coordinates))
