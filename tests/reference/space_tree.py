"""Coordinates of space along a spanning tree: poses of all bodies as functions of the tree's q.

    q = [linear | (cos, sin) per joint angle | (w, x, y, z) per quaternion | (turns, remainder) per counted angle],
    v = [linear rates | angle rates | three ω per quaternion, in the carried axes].
A tree joint takes the frame of the first place to that of the second by elementary motions (slides along and turns
about its axes, a ball); a body that carries the first place is placed by their inverses. A body without a joint is
free. Takes the exported COORDINATES; an absolute set is a tree of free bodies.
"""

from dataclasses import dataclass

import casadi as ca
import numpy as np

from space_definition import TRAVELS
from space_frames import cleaned, quaternion_matrix, quaternion_rate, turn_in
from space_kinematics import GROUND, SpaceKinematics, SpacePose

ALONG_Z = ca.SX([0, 0, 1])
BALLS = ("spherical", "point_on_line", "point_on_plane")
CARRYING = (*BALLS, "revolute", "prismatic", "cylindrical", "screw", "universal", "planar", "parallel", "fixed")


@dataclass
class SpaceLayout:
    """Where the coordinates stand in q and v."""

    linear: dict  # (kind, of) → index
    rotations: dict  # (joint, angle) → index among the rotations
    quaternions: dict  # ("body" | "joint", name) → index among the quaternions
    angles: list  # ((joint, angle), [(index, weight)…]) of the counted angles

    @classmethod
    def read(cls, coordinates):
        linear = {(entry["kind"], entry["of"]): index for index, entry in enumerate(coordinates["linear"])}
        rotations = {(entry["joint"], entry["angle"]): k for k, entry in enumerate(coordinates["rotations"])}
        quaternions = {key: k for k, entry in enumerate(coordinates["quaternions"]) for key in entry.items()}
        angles = [(angle_key(entry["of"]), entry["rate"]) for entry in coordinates.get("angles") or []]
        return cls(linear, rotations, quaternions, angles)

    def starts(self):
        """Of pairs, quaternions and counted angles in q, and of q's end."""
        pairs = len(self.linear)
        quaternions = pairs + 2 * len(self.rotations)
        angles = quaternions + 4 * len(self.quaternions)
        return pairs, quaternions, angles, angles + 2 * len(self.angles)

    def sizes(self):
        return self.starts()[3], len(self.linear) + len(self.rotations) + 3 * len(self.quaternions)

    def angle_values(self, q):
        """2π · turns + remainder by (joint, angle), of states as rows of `q`."""
        start = self.starts()[2]
        return {
            key: 2 * np.pi * q[:, start + 2 * k] + q[:, start + 2 * k + 1] for k, (key, _) in enumerate(self.angles)
        }

    def mode_values(self, *states):
        """By (mode, body) the columns of each of `states`, which are rows of q, v or v̇."""
        modes = [key for key in self.linear if "[" in key[0]]
        return {key: [state[:, self.linear[key]] for state in states] for key in modes}

    def norms(self, q):
        """Lengths of pairs and quaternions, of states as rows of `q`."""
        pairs, quaternions, angles, _ = self.starts()
        parts = [(q[:, pairs:quaternions], 2), (q[:, quaternions:angles], 4)]
        return np.hstack([np.linalg.norm(part.reshape(len(q), -1, size), axis=2) for part, size in parts])

    def velocity_names(self):
        names = [f"{of} {kind}" for kind, of in self.linear]
        names += [f"{joint} {angle} rate" for joint, angle in self.rotations]
        return names + [f"{name} ω_{axis}" for _, name in self.quaternions for axis in "xyz"]


def angle_key(of):
    """`joint`, or `joint.angle_1`, as (joint, angle)."""
    joint, _, angle = of.rpartition(".")
    return (joint, angle) if angle.startswith("angle") and joint else (of, "angle")


class SpaceTree(SpaceKinematics):
    def __init__(self, model, coordinates):
        super().__init__(model)
        self.layout = SpaceLayout.read(coordinates)
        self.exported = coordinates["rows"]
        for row in self.exported:
            body = row.get("in") or "ground"
            self.row_axes[(row["of"], row["what"])] = None if body == "ground" else body
        size_q, size_v = self.layout.sizes()
        self.q, self.v = self._symbols(size_q), ca.SX.sym("v", size_v)
        self.branches = {branch["body"]: branch for branch in coordinates["tree"]}
        if set(self.branches) != set(model.bodies) or len(coordinates["tree"]) != len(model.bodies):
            raise ValueError(f"{model.title}: the spanning tree does not hold each body once")
        self.used = set()
        for name, body in model.bodies.items():
            if body.beam is not None:
                self.modes[name] = (
                    [self._linear(mode, name) for mode in body.beam.names],
                    [self.v[self.layout.linear[(mode, name)]] for mode in body.beam.names],
                )
        for name in model.bodies:
            self._place(name, [])
        layout = self.layout
        unused = {*layout.linear, *layout.rotations, *layout.quaternions} - self.used
        if unused:
            raise ValueError(f"{model.title}: coordinates that move nothing: {sorted(unused)}")

    def _symbols(self, size):
        return ca.SX.sym("q", size)

    def q_rate(self, v):
        """q̇ = N(q) v. Whole turns do not move; a remainder has the exported rate."""
        layout = self.layout
        n, first = len(layout.linear), len(layout.linear) + len(layout.rotations)
        rates = [v[index] for index in range(n)]
        for key, index in layout.rotations.items():
            c, s = self._pair(key)
            rates += [-s * v[n + index], c * v[n + index]]
        for key, index in layout.quaternions.items():
            rates.append(quaternion_rate(self._quaternion(key), v[first + 3 * index : first + 3 * index + 3]))
        for _, rate in layout.angles:
            rates += [ca.SX(0), sum((weight * v[index] for index, weight in rate), ca.SX(0))]
        return ca.vertcat(*rates)

    def counted(self, joint, angle):
        start = self.layout.starts()[2]
        for k, (key, _) in enumerate(self.layout.angles):
            if key == (joint, angle):
                return 2 * ca.pi * self.q[start + 2 * k] + self.q[start + 2 * k + 1]
        return None

    def rows(self):
        """The rows exported, in their order; each must be one that the tree does not already satisfy.

        Where redundant rows are dropped, any may be missing: `consistent` sees whether the others imply them.
        """
        satisfied = {branch["joint"] for branch in self.branches.values()}
        own = {self.row_key(row.of, row.what): row for row in super().rows() if row.of not in satisfied}
        asked = [self.row_key(row["of"], row["what"]) for row in self.exported]
        dropping = self.model.definition["options"].get("redundant") == "drop"
        known = set(asked) <= set(own) and len(set(asked)) == len(asked)
        if not known or (len(asked) < len(own) and not dropping):
            raise ValueError(f"{self.model.title}: rows exported {sorted(asked)}, rows of the tree {sorted(own)}")
        return [own[key] for key in asked]

    def row_key(self, of, what):
        """Rows of couplings and drivers stand alone under their name; a joint's are told apart by what they are."""
        return (of, what if of in self.model.joints else "")

    def velocity_names(self):
        return self.layout.velocity_names()

    # Coordinates.

    def _linear(self, kind, of):
        self.used.add((kind, of))
        return self.q[self.layout.linear[(kind, of)]]

    def _pair(self, key):
        self.used.add(key)
        at = self.layout.starts()[0] + 2 * self.layout.rotations[key]
        return self.q[at], self.q[at + 1]

    def _quaternion(self, key):
        self.used.add(key)
        at = self.layout.starts()[1] + 4 * self.layout.quaternions[key]
        return self.q[at : at + 4]

    # Poses.

    def _place(self, name, path):
        if name in self.poses:
            return
        if name in path:
            raise ValueError(f"{self.model.title}: the tree closes on itself at `{name}`")
        branch = self.branches[name]
        if branch["joint"] is None:
            position = ca.vertcat(*[self._linear(kind, name) for kind in "xyz"])
            free = not self.model.bodies[name].particle
            matrix = quaternion_matrix(self._quaternion(("body", name))) if free else GROUND.matrix
            self.poses[name] = SpacePose(position, matrix)
            return
        joint = self.model.joints[branch["joint"]]
        parent = None if branch["parent"] == "ground" else branch["parent"]
        if parent is not None:
            self._place(parent, path + [name])
        is_second = joint.second.body == name
        if {joint.first.body, joint.second.body} != {name, parent} or joint.kind not in CARRYING:
            raise ValueError(f"{self.model.title}: joint `{joint.name}` does not hang `{name}` on `{branch['parent']}`")
        own, other = (joint.second, joint.first) if is_second else (joint.first, joint.second)
        matrix = self._orientation(joint, name, own, other, is_second)
        pose = SpacePose(ca.SX.zeros(3), matrix)
        # The slides are along the first's axes, whichever is placed.
        carrying = self.section(joint.first) if is_second else ca.mtimes(matrix, self.turned(joint.first))
        first = ca.mtimes(carrying, joint.first.axes)
        offset = ca.mtimes(ca.mtimes(first, joint.frame), self._slides(joint))
        position = self.position(other) + (offset if is_second else -offset) - pose.turn(self.arm(own))
        self.poses[name] = SpacePose(position, matrix)

    def _orientation(self, joint, name, own, other, is_second):
        """A_own = A_other B_other R B_ownᵀ, R the turning of the own place's axes against the other's."""
        if self.model.bodies[name].particle:
            return GROUND.matrix
        if joint.kind in BALLS:
            turning = quaternion_matrix(self._quaternion(("joint", joint.name)))
        else:
            turning = self._turning(joint)
            turning = turning if is_second else turning.T
        turned = cleaned(ca.mtimes(ca.mtimes(other.axes, turning), own.axes.T))
        turned = ca.mtimes(self.section(other), turned)
        return turned if self.beam(own.body) is None else ca.mtimes(turned, self.turned(own).T)

    def _turning(self, joint):
        """Of the second place's axes against the first's."""
        if joint.kind in ("fixed", "prismatic", "parallel"):
            return ca.SX.eye(3)
        if joint.kind == "universal":
            first = turn_in(joint.frame, *self._pair((joint.name, "angle_1")))
            return ca.mtimes(first, turn_in(joint.second_frame, *self._pair((joint.name, "angle_2"))))
        return turn_in(joint.frame, *self._pair((joint.name, "angle")))

    def _slides(self, joint):
        """p2 − p1 in the first's joint frame."""
        name = joint.name
        if joint.kind == "screw":
            counted = self.counted(name, "angle")
            if counted is None:
                raise ValueError(f"{self.model.title}: the angle of the screw `{name}` is not counted")
            return joint.pitch / (2 * ca.pi) * counted * ALONG_Z
        if joint.kind in ("planar", "point_on_plane"):
            return ca.vertcat(self._linear("travel_1", name), self._linear("travel_2", name), 0)
        if joint.kind == "parallel":
            return ca.vertcat(*[self._linear(which, name) for which in TRAVELS["parallel"]])
        if "travel" in TRAVELS.get(joint.kind, ()):
            return self._linear("travel", name) * ALONG_Z
        return ca.SX.zeros(3)

    # Bodies, for the way to absolute coordinates.

    def bodies(self, acceleration):
        """[position, A row by row, velocity, ω, acceleration, ω̇] per body, as a column, with v̇ = `acceleration`."""
        names = list(self.model.bodies)
        position = ca.vertcat(*[self.poses[name].position for name in names])
        omega = ca.vertcat(*[self.omega(name) for name in names])
        velocity = self.rate(position)
        parts = [position, velocity, omega, self._derivative(velocity, acceleration)]
        parts.append(self._derivative(omega, acceleration))
        rows = []
        for k, name in enumerate(names):
            x, v, w, a, alpha = (part[3 * k : 3 * k + 3] for part in parts)
            rows += [x, ca.vec(ca.SX(self.poses[name].matrix).T), v, w, a, alpha]
        return ca.vertcat(*rows)

    def _derivative(self, value, acceleration):
        return self.rate(value) + ca.jtimes(value, self.v, acceleration)
