"""Coordinates along a spanning tree: poses of all bodies as functions of the tree's q.

Takes the exported COORDINATES (which joints form the tree, what the coordinates are called, which rows are left) and
derives the rest. Every tree joint places its body on its parent by solving its own rows for the body's pose:
    revolute, fixed:           p2 = p1
    prismatic, point_on_line:  p2 = p1 + travel · A1 â   (whichever of the two bodies is the parent)
    parallel:                  p2 = p1 + A1 (travel_1, travel_2)
    point_on_curve:            p2 = p1 + A1 c(parameter)
    prismatic, fixed, parallel: θ2 = θ1 + angle, so such bodies share one rotation.
"""

from dataclasses import dataclass, field

import casadi as ca
import numpy as np

from energies import Energies
from kinematics import GROUND, Kinematics, Pose


@dataclass
class Layout:
    """Where the coordinates stand in q and v."""

    linear: dict  # (kind, of) → index
    rotations: dict  # body → index among the rotations
    angles: list = field(default_factory=list)  # of the multi-turn angles: as exported

    @classmethod
    def read(cls, coordinates):
        linear = {(entry["kind"], entry["of"]): index for index, entry in enumerate(coordinates["linear"])}
        rotations = {entry["body"]: index for index, entry in enumerate(coordinates["rotations"])}
        return cls(linear, rotations, coordinates.get("angles") or [])

    def sizes(self):
        """Lengths of q and v."""
        n, r = len(self.linear), len(self.rotations)
        return n + 2 * r + 2 * len(self.angles), n + r

    def angle_values(self, q):
        """2π · turns + remainder by rotor, of states as rows of `q`."""
        start = len(self.linear) + 2 * len(self.rotations)
        return {
            angle["of"]: 2 * np.pi * q[:, start + 2 * k] + q[:, start + 2 * k + 1]
            for k, angle in enumerate(self.angles)
        }

    def mode_values(self, *states):
        """By (mode, body) the columns of each of `states`, which are rows of q, v or v̇."""
        modes = [key for key in self.linear if "[" in key[0]]
        return {key: [state[:, self.linear[key]] for state in states] for key in modes}

    def velocity_names(self):
        return [f"{of} {kind}" for kind, of in self.linear] + [f"{body} ω" for body in self.rotations]


class Tree(Kinematics):
    def __init__(self, model, coordinates):
        super().__init__(model)
        self.layout = Layout.read(coordinates)
        self.remaining = coordinates["rows"]
        size_q, size_v = self.layout.sizes()
        self.q, self.v = ca.SX.sym("q", size_q), ca.SX.sym("v", size_v)
        self.branches = {branch["body"]: branch for branch in coordinates["tree"]}
        if set(self.branches) != set(model.bodies) or len(coordinates["tree"]) != len(model.bodies):
            raise ValueError(f"{model.title}: the spanning tree does not hold each body once")
        self.orientations = {}
        self.used = set()
        for name, body in model.bodies.items():
            if body.beam is not None:
                self.modes[name] = (
                    [self._coordinate(mode, name) for mode in body.beam.names],
                    [self.v[self.layout.linear[(mode, name)]] for mode in body.beam.names],
                )
        for name in model.bodies:
            self._place(name, [])
        unused = set(self.layout.linear) - self.used
        if unused:
            raise ValueError(f"{model.title}: coordinates that move nothing: {sorted(unused)}")
        self._check_angles()

    def q_rate(self, v):
        """q̇ = N(q) v. Whole turns do not move; the remainder turns with the rotor."""
        layout, n = self.layout, len(self.layout.linear)
        rates = [v[index] for index in range(n)]
        for index in layout.rotations.values():
            c, s, omega = self.q[n + 2 * index], self.q[n + 2 * index + 1], v[n + index]
            rates += [-s * omega, c * omega]
        for angle in layout.angles:
            rates += [ca.SX(0), ca.substitute(self.rotor_rate(angle["of"]), self.v, v)]
        return ca.vertcat(*rates)

    def multi_turn(self, rotor):
        start = len(self.layout.linear) + 2 * len(self.layout.rotations)
        values = {
            angle["of"]: 2 * ca.pi * self.q[start + 2 * k] + self.q[start + 2 * k + 1]
            for k, angle in enumerate(self.layout.angles)
        }
        return values[rotor] if rotor in values else self.principal_angle(rotor)

    def rows(self):
        """The rows exported, in their order; each must be one that the tree does not already satisfy."""
        satisfied = {branch["joint"] for branch in self.branches.values()}
        own = {row_key(row.of, row.what): row for row in super().rows() if row.of not in satisfied}
        asked = [row_key(row["of"], row["what"]) for row in self.remaining]
        if sorted(asked) != sorted(own):
            raise ValueError(f"{self.model.title}: rows exported {sorted(asked)}, rows of the tree {sorted(own)}")
        return [own[key] for key in asked]

    def velocity_names(self):
        return self.layout.velocity_names()

    # Poses.

    def _coordinate(self, kind, of):
        self.used.add((kind, of))
        return self.q[self.layout.linear[(kind, of)]]

    def _place(self, name, path):
        if name in self.poses:
            return
        if name in path:
            raise ValueError(f"{self.model.title}: the tree closes on itself at `{name}`")
        branch = self.branches[name]
        if branch["joint"] is None:
            c, s, omega = self._orientation(name)
            x, y = self._coordinate("x", name), self._coordinate("y", name)
            self.poses[name] = Pose(x, y, c, s, omega)
            return
        joint = self.model.joints[branch["joint"]]
        parent = None if branch["parent"] == "ground" else branch["parent"]
        if parent is not None:
            self._place(parent, path + [name])
        is_second = joint.second.body == name
        if {joint.first.body, joint.second.body} != {name, parent}:
            raise ValueError(f"{self.model.title}: joint `{joint.name}` does not hang `{name}` on `{branch['parent']}`")
        c, s, omega = self._orientation(name)
        pose = Pose(ca.SX(0), ca.SX(0), c, s, omega)
        own, other = (joint.second, joint.first) if is_second else (joint.first, joint.second)
        offset = self._offset(joint, self.pose(parent) if is_second else pose)
        at = self.position(other) + (offset if is_second else -offset) - pose.turn(self.arm(own))
        self.poses[name] = Pose(at[0], at[1], c, s, omega)

    def _offset(self, joint, first):
        """p2 − p1 as the tree joint leaves it."""
        if joint.kind in ("revolute", "fixed"):
            return ca.SX.zeros(2)
        if joint.kind in ("prismatic", "point_on_line"):
            return self._coordinate("travel", joint.name) * first.turn(joint.axis)
        if joint.kind == "parallel":
            return first.turn([self._coordinate(which, joint.name) for which in ("travel_1", "travel_2")])
        if joint.kind == "point_on_curve":
            return first.turn(self.on_curve(joint))
        raise ValueError(f"{self.model.title}: a joint of kind `{joint.kind}` cannot stand in the tree")

    def parameter(self, joint):
        carries = ("parameter", joint.name) in self.layout.linear
        return self._coordinate("parameter", joint.name) if carries else super().parameter(joint)

    def _orientation(self, name):
        """(c, s, ω): its own rotation, or that of the body it is fixed to, turned by the angles between."""
        if self.model.bodies[name].particle:
            return GROUND.c, GROUND.s, GROUND.omega
        if name not in self.orientations:
            (c, s, omega), angle = self._rotation_of_group(name)
            turned = Pose(0, 0, c, s, 0).turn(ca.vertcat(ca.cos(angle), ca.sin(angle)))
            self.orientations[name] = (turned[0], turned[1], omega + ca.jacobian(angle, self.model.time))
        return self.orientations[name]

    def _rotation_of_group(self, name):
        """Search along fixed and prismatic tree joints for the ground or the body that the rotation is named after."""
        seen, waiting = {name}, [(name, ca.SX(0))]  # body, θ(name) − θ(body)
        found = []
        while waiting:
            body, angle = waiting.pop()
            if body is None:
                found.append(((GROUND.c, GROUND.s, GROUND.omega), angle))
                continue
            if body in self.layout.rotations:
                index, n = self.layout.rotations[body], len(self.layout.linear)
                found.append(((self.q[n + 2 * index], self.q[n + 2 * index + 1], self.v[n + index]), angle))
            for neighbour, step in self._rigid_neighbours(body):
                if neighbour not in seen:
                    seen.add(neighbour)
                    waiting.append((neighbour, angle + step))
        if len(found) != 1:
            raise ValueError(f"{self.model.title}: `{name}` has {len(found)} rotations in the tree, expected one")
        return found[0]

    def _rigid_neighbours(self, body):
        """Bodies (None: ground) of the same orientation up to a constant, with θ(body) − θ(neighbour)."""
        for branch in self.branches.values():
            joint = self.model.joints.get(branch["joint"])
            if joint is None or joint.kind not in ("fixed", "prismatic", "parallel") or self._joins_particle(joint):
                continue
            if any(ca.evalf(ca.jacobian(self.slope(place), self.q)).nnz() for place in (joint.first, joint.second)):
                raise ValueError(f"{self.model.title}: `{joint.name}` stands in the tree at a section that bends")
            if joint.second.body == body:
                yield joint.first.body, joint.angle
            elif joint.first.body == body:
                yield joint.second.body, -joint.angle

    def _check_angles(self):
        """The exported velocities of each multi-turn angle must be those of its rotor."""
        for angle in self.layout.angles:
            rate = sum((weight * self.v[index] for index, weight in angle["rate"]), ca.SX(0))
            difference = ca.evalf(ca.jacobian(rate - self.rotor_rate(angle["of"]), self.v))
            if np.any(np.abs(np.asarray(difference.full())) > 1e-12 * self._steepest()):
                raise ValueError(f"{self.model.title}: the angle of `{angle['of']}` turns with other velocities")

    def _steepest(self):
        """What slopes are measured by: there are none without beams, and rates then agree to the last digit."""
        lengths = [body.beam.length for body in self.model.bodies.values() if body.beam is not None]
        return 1 / min(lengths) if lengths else 0.0

    # Bodies, for the way to absolute coordinates.

    def bodies(self, acceleration):
        """[x y c s vx vy ω ax ay α] per body, as a column, with v̇ = `acceleration`."""
        poses = [self.poses[name] for name in self.model.bodies]
        position = ca.vertcat(*[value for pose in poses for value in (pose.x, pose.y)])
        velocity = self.rate(position)
        omega = ca.vertcat(*[pose.omega for pose in poses])
        second = self._derivative(velocity, acceleration)
        alpha = self._derivative(omega, acceleration)
        rows = []
        for k, pose in enumerate(poses):
            rows += [pose.x, pose.y, pose.c, pose.s, velocity[2 * k], velocity[2 * k + 1], omega[k]]
            rows += [second[2 * k], second[2 * k + 1], alpha[k]]
        return ca.vertcat(*rows)

    def _derivative(self, value, acceleration):
        return self.rate(value) + ca.jtimes(value, self.v, acceleration)


def row_key(of, what):
    """Rows of couplings and drivers stand alone under their name; a joint's are told apart by what they are."""
    return (of, what if what in ("x", "y", "angle", "normal", "distance") else "")


def derive(model, coordinates):
    """The equations in an exported coordinate set."""
    return Energies(Tree(model, coordinates))
