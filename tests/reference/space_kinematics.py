"""Places, velocities, joint quantities and constraint rows of space, from the poses of the bodies.

The counterpart of `kinematics`, which keeps what is common: scopes of laws, couplings, drivers. `space_tree` says how
the poses follow from q. A body's pose is the position of its centre of mass and the rotation matrix A (world ← body);
angular velocities are the vee of Aᵀ Ȧ, in body axes.

With E = A B J the frame of a joint on either body (B: the axes of the place, J: the canonical frame of the joint's
axis; x, y, z its columns in world axes), p the places and Δ = p2 − p1:
    angle: from x1 to x2 about z1,   travel: z1·Δ,   planar: x1·Δ, y1·Δ, parallel: and z1·Δ.
"""

from dataclasses import dataclass

import casadi as ca

from kinematics import Kinematics, Row
from space_definition import ANGLES, TRAVELS
from space_frames import cleaned, vee


@dataclass
class SpacePose:
    position: ca.SX
    matrix: ca.SX  # A

    def turn(self, vector):
        return ca.mtimes(self.matrix, vector)


GROUND = SpacePose(ca.SX.zeros(3), ca.densify(ca.SX.eye(3)))
AXIS_ROWS = ("revolute", "fixed", "prismatic", "cylindrical", "screw", "planar", "parallel")
MEETING = ("spherical", "revolute", "fixed", "universal", "constant_velocity")
ANGLE_ROW = ("fixed", "prismatic", "parallel")


class SpaceKinematics(Kinematics):
    """To be completed with `q`, `v`, `poses`, `q_rate(v)` and `counted(joint, angle)`."""

    axes = ("x", "y", "z")

    def __init__(self, model):
        super().__init__(model)
        self.row_axes = {}  # (joint, "x" | "y" | "z") → the body in whose axes the row is
        self._omegas = {}

    def pose(self, body):
        return GROUND if body is None else self.poses[body]

    def section(self, place):
        """World ← what a place belongs to: its body, or the section of a beam there."""
        beam = self.beam(place.body)
        if beam is None or place.of_mean:
            return self.pose(place.body).matrix
        return ca.mtimes(self.pose(place.body).matrix, self.turned(place))

    def turned(self, place):
        """Body ← section."""
        beam = self.beam(place.body)
        if beam is None or place.of_mean:
            return ca.SX.eye(3)
        return beam.turned(beam.spot(place.local), self.modes[place.body][0])

    def turning(self, place):
        """The angular velocity of what a place belongs to, in its axes."""
        if self.beam(place.body) is None or place.of_mean:
            return self.omega(place.body)
        a = self.section(place)
        return vee(ca.mtimes(a.T, ca.reshape(self.rate(ca.vec(a)), 3, 3)))

    def omega(self, body):
        """Body axes."""
        if body is None or self.model.bodies[body].particle:
            return ca.SX.zeros(3)
        if body not in self._omegas:
            a = self.pose(body).matrix
            rate = ca.reshape(self.rate(ca.vec(a)), 3, 3)
            self._omegas[body] = vee(ca.mtimes(a.T, rate))
        return self._omegas[body]

    def spin(self, body):
        """The angular velocity in world axes."""
        return self.pose(body).turn(self.omega(body))

    # Quantities of joints.

    def place_axes(self, place):
        return ca.mtimes(self.section(place), place.axes)

    def frames(self, joint):
        """E1 and E2."""
        for place in (joint.first, joint.second):
            yield ca.mtimes(self.section(place), cleaned(ca.mtimes(place.axes, joint.frame)))

    def span(self, joint):
        return self.position(joint.second) - self.position(joint.first)

    def travel(self, joint, which="travel"):
        if which not in TRAVELS.get(joint.kind, ()):
            raise ValueError(f"{self.model.title}: joint `{joint.name}` has no `{which}`")
        e1, _ = self.frames(joint)
        return ca.dot(e1[:, {"travel": 2, "travel_1": 0, "travel_2": 1, "travel_3": 2}[which]], self.span(joint))

    def principal(self, joint, which="angle"):
        """In (−π, π], from the axes of the bodies."""
        self._check_angle(joint, which)
        if joint.kind != "universal":
            e1, e2 = self.frames(joint)
            return ca.atan2(ca.dot(e1[:, 1], e2[:, 0]), ca.dot(e1[:, 0], e2[:, 0]))
        # A2 B2 = A1 B1 Rot(a, angle_1) Rot(s, angle_2): s seen from the first has turned about a by angle_1,
        # a seen from the second about s by −angle_2.
        first, second = self.place_axes(joint.first), self.place_axes(joint.second)
        between = ca.mtimes(first.T, second)
        a, s = joint.axis, joint.second_axis
        if which == "angle_1":
            return _angle_about(a, s, ca.mtimes(between, s))
        return -_angle_about(s, a, ca.mtimes(between.T, a))

    def angle(self, joint, which="angle"):
        counted = self.counted(joint.name, which)
        return self.principal(joint, which) if counted is None else counted

    def angle_rate(self, joint, which="angle"):
        """Each body's rate about its own axis of the joint: where the axes coincide, the rate of the angle.

        A universal joint has none of its two axes fixed to both bodies: its rates are those of the relative angular
        velocity along the first's axis and along the second's.
        """
        self._check_angle(joint, which)
        first, second = joint.first, joint.second
        if joint.kind != "universal":
            along = [ca.dot(ca.mtimes(p.axes, joint.axis), self.turning(p)) for p in (first, second)]
            return along[1] - along[0]
        second_spin, first_spin = (ca.mtimes(self.section(p), self.turning(p)) for p in (second, first))
        relative = second_spin - first_spin
        if which == "angle_1":
            return ca.dot(ca.mtimes(self.place_axes(first), joint.axis), relative)
        return ca.dot(ca.mtimes(self.place_axes(second), joint.second_axis), relative)

    def _check_angle(self, joint, which):
        if which not in ANGLES.get(joint.kind, ()) or self._joins_particle(joint):
            raise ValueError(f"{self.model.title}: joint `{joint.name}` has no `{which}`")

    def _of_joint(self, owner, quantity):
        joint = self.model.joints[owner]
        kind, _, number = quantity.partition("_")
        suffix = f"_{number}" if number else ""
        if kind == "angle":
            return self.angle(joint, quantity)
        if kind == "rate":
            return self.joint_rate(joint, f"angle{suffix}")
        if kind == "travel":
            return self.travel(joint, quantity)
        if kind == "speed":
            return self.rate(self.travel(joint, f"travel{suffix}"))
        raise ValueError(f"{self.model.title}: joint `{owner}` has no `{quantity}`")

    def joint_rate(self, joint, which="angle"):
        """That of the counted angle, if there is one."""
        counted = self.counted(joint.name, which)
        return self.angle_rate(joint, which) if counted is None else self.rate(counted)

    def displacement(self, first, second):
        """The second place less the first along the first's axes; the vector of the antisymmetric part of E1ᵀ E2."""
        e1, e2 = self.place_axes(first), self.place_axes(second)
        return ca.mtimes(e1.T, self.position(second) - self.position(first)), vee(ca.mtimes(e1.T, e2))

    # What gears, racks and torsion springs ask for.

    def multi_turn(self, rotor):
        return self.angle(self.model.joints[rotor])

    def rotor_rate(self, rotor):
        return self.joint_rate(self.model.joints[rotor])

    def name(self, text):
        owner, _, quantity = text.rpartition(".")
        body = owner.removesuffix(".rate")
        if owner.endswith(".rate") and body in self.model.bodies and quantity in ("x", "y", "z"):
            return self.omega(body)["xyz".index(quantity)]
        return super().name(text)

    # Rows.

    def joint_rows(self, joint):
        """In the order of the table in NOTATION.md; Φ of each in SI."""
        kind, delta = joint.kind, self.span(joint)
        e1, e2 = self.frames(joint)
        rows = []

        def add(what, value):
            rows.append(Row(joint.name, what, value))

        if kind in MEETING:
            for k, what in enumerate("xyz"):
                axes = self.pose(self.row_axes.get((joint.name, what))).matrix
                add(what, -ca.dot(axes[:, k], delta))
        elif kind in ("prismatic", "cylindrical", "screw", "point_on_line"):
            add("normal_1", ca.dot(e1[:, 0], delta))
            add("normal_2", ca.dot(e1[:, 1], delta))
        elif kind in ("planar", "point_on_plane"):
            add("normal", ca.dot(e1[:, 2], delta))
        elif kind in ("distance", "cord"):
            add("distance", (ca.dot(delta, delta) - joint.length**2) / 2)
        elif kind != "parallel":
            raise ValueError(f"{self.model.title}: joint `{joint.name}` is of the unknown kind `{kind}`")
        if kind in AXIS_ROWS:
            add("axis_1", ca.dot(e1[:, 0], e2[:, 2]))
            add("axis_2", ca.dot(e1[:, 1], e2[:, 2]))
        if kind in ANGLE_ROW:
            add("angle", ca.dot(e1[:, 0], e2[:, 1]))
        if kind == "screw":
            add("screw", self.travel(joint) - joint.pitch / (2 * ca.pi) * self.angle(joint))
        if kind == "universal":
            second = ca.mtimes(self.place_axes(joint.second), joint.second_axis)
            add("cross", ca.dot(e1[:, 2], second))
        if kind == "constant_velocity":
            add("twist", ca.dot(e1[:, 0], e2[:, 1]) - ca.dot(e1[:, 1], e2[:, 0]))
        if self._joins_particle(joint) and kind not in ("spherical", "point_on_line", "point_on_plane", "distance", "cord"):
            raise ValueError(f"{self.model.title}: joint `{joint.name}` needs the orientation of a particle")
        return rows

    def sides(self, joint):
        """What is positive on the root that is meant."""
        e1, e2 = self.frames(joint)
        sides = [ca.dot(e1[:, 2], e2[:, 2])] if joint.kind in AXIS_ROWS else []
        if joint.kind in ANGLE_ROW:
            sides.append(ca.dot(e1[:, 1], e2[:, 1]))
        if joint.kind == "constant_velocity":
            sides.append(ca.dot(e1[:, 0], e2[:, 0]) + ca.dot(e1[:, 1], e2[:, 1]))
        return sides


def _angle_about(axis, start, end):
    return ca.atan2(ca.dot(axis, ca.cross(start, end)), ca.dot(start, end) - ca.dot(axis, start) * ca.dot(axis, end))

