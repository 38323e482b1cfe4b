"""Loads between the teeth of racks, cones and worms: one force where pitch surfaces touch, by velocities there. From "Teeth" of NOTATION.md.

A radian of a pitch is as long along the normal of the flanks as the first wheel goes there. The shape of cones is that of the spur gears they are like.
"""

from dataclasses import replace

import casadi as ca
import numpy as np

import gears
from meshes import Mesh, SpatialMesh, inv


def mesh(load, kinematics):
    return (PlanarTouch if kinematics.model.kind == "planar" else SpatialTouch)(load, kinematics)


class Touching(Mesh):
    def __init__(self, load, kinematics):
        self.load, self.kinematics, self.model = load, kinematics, kinematics.model
        self.pair = self.model.pairs[load["name"]]
        self.touch = self.pair.touch
        wheels = self.pair.wheels
        # Phases are counted by the pinion, the first of two cones, the wheel that a worm drives.
        self.counted = next(k for k, wheel in enumerate(wheels) if wheel.kind not in ("rack", "worm"))
        self.wheel, self.other = wheels[self.counted], wheels[1 - self.counted]
        self.shape = [self.wheel, self.other]
        if self.wheel.kind == "bevel":
            long = wheels[0].pitch / np.sin(wheels[0].cone)
            face = min([wheel.width for wheel in wheels if wheel.width], default=0.0)
            middle = 1 - face / 2 / long
            self.shape = [replace(w, teeth=w.teeth / np.cos(w.cone), module=middle * w.module) for w in self.shape]
            self.distance = sum(w.pitch for w in self.shape)
        else:
            self.distance = self.pair.distance
        self.working = self.wheel.transverse_angle
        self.pitch = np.pi * self.shape[0].module / np.cos(self.wheel.helix) * np.cos(self.working)

    def teeth_and_travels(self, of_rotor, of_travel):
        total = sum((factor * of_rotor(rotor) for rotor, factor in self.pair.terms.items()), ca.SX(0))
        return total + sum((factor * of_travel(self.model.joints[joint]) for joint, factor in self.pair.travels.items()), ca.SX(0))

    def deflection(self):
        phase = self.model.phases[self.model.free_phases.index(self.load["name"])]
        total = self.teeth_and_travels(self.kinematics.multi_turn, self.kinematics.travel)
        return self.touch.radius * (total - phase) - self.given("error")

    def rate(self):
        total = self.teeth_and_travels(
            self.kinematics.rotor_rate, lambda joint: self.kinematics.rate(self.kinematics.travel(joint))
        )
        error = self.given("error_rate") if self.load.get("error_rate") else self.kinematics.rate(self.given("error"))
        return self.touch.radius * total - error

    def path(self):
        wheel, other = self.shape
        long = np.sqrt(max(wheel.tip**2 - wheel.base**2, 0))
        if other.kind == "bevel":
            tangent = self.distance * np.sin(self.working)
            return max(tangent - np.sqrt(max(other.tip**2 - other.base**2, 0)), 0.0), min(long, tangent)
        # From where the line of the rack's tips cuts the line of action.
        above = other.module * other.addendum - wheel.module * wheel.shift
        return max(wheel.pitch * np.sin(self.working) - above / np.sin(self.working), 0.0), long

    def phase_at_rest(self):
        wheel, side = self.shape[0], 1
        if self.other.kind == "worm" and self.pair.wheels[0] is self.other:
            joint, sign = next(iter(self.pair.turns[1].items()))
            side = np.sign(self.pair.terms[joint] * sign)
        sense = side * self._sense()
        half = (np.pi / 2 + 2 * wheel.shift * np.tan(wheel.angle)) / wheel.teeth
        half += inv(wheel.transverse_angle) - inv(self.working)
        start = (wheel.base * (np.tan(self.working) + half) - self.path()[0]) / self.pitch
        turned = self.wheel.first + self._still() - self.touch.psi(self.model, self.counted)
        return start + sense * self.wheel.teeth * turned / (2 * np.pi), sense

    def _still(self):
        return 0.0

    def _across(self, along):
        if self.other.kind != "rack":
            return self.distance * np.sin(self.working) - along
        # Above the line of the rack, which is as far from the pinion's centre as the pair is apart.
        point = self.wheel.base * np.cos(self.working) + along * np.sin(self.working)
        return self.distance - point

    def series(self, node):
        own = self.wheel, self.other
        self.wheel, self.other = self.shape
        found = super().series(node)
        self.wheel, self.other = own
        return found

    def _moves_with(self, wheel, root):
        if wheel.kind != "rack":
            return super()._moves_with(wheel, root)
        return list(gears._fixed_to(self.model, wheel.body, gears._known(self.model, wheel.center), wheel.along))

    def _lever(self, which):
        return self.touch.radius * self.pair.wheels[which].teeth or np.cos(self.touch.angle)

    def _about_axle(self, body, which):
        if self.pair.wheels[which].kind == "rack":
            return float(self.model.at_defaults(body.mass)[0])
        if self.model.kind == "planar":
            return super()._about_axle(body, which)
        axle = self.touch.axes[which] / np.linalg.norm(self.touch.axes[which])
        return float(axle @ self.model.at_defaults(ca.vec(body.inertia)).reshape(3, 3) @ axle)

    def _points(self):
        """From each centre to where they touch, in world axes."""
        pose, centers = self.kinematics.pose(self.pair.carrier), [self.kinematics.position(w.center) for w in self.pair.wheels]
        size = centers[0].numel()
        there = centers[self.counted] + pose.turn(ca.DM(list(self.touch.points[self.counted][:size])))
        return [there - center for center in centers]

    def efforts(self):
        """On the second wheel, and its opposite on the first."""
        pose, size = self.kinematics.pose(self.pair.carrier), 2 if self.model.kind == "planar" else 3
        along, apart = (pose.turn(ca.DM(list(axis[:size]))) for axis in (self.touch.along, self.touch.apart))
        force = self.force()
        pushed = force * np.cos(self.touch.angle) * along + ca.fabs(force) * np.sin(self.touch.angle) * apart
        return ca.vertcat(-pushed, pushed)


class PlanarTouch(Touching):
    def _still(self):
        still = 0.0
        for body, sign in ((self.wheel.body, 1), (self.pair.carrier, -1)):
            root, angle = gears._orientation(self.model, body)
            still += sign * angle if root is None else 0.0
        return still

    def rates(self):
        """Velocities of both where they touch."""
        rates = []
        for wheel, (x, y) in zip(self.pair.wheels, (ca.vertsplit(point) for point in self._points())):
            center = self.kinematics.rate(self.kinematics.position(wheel.center))
            rates.append(center + self.kinematics.pose(wheel.body).omega * ca.vertcat(-y, x))
        return ca.vertcat(*rates)


class SpatialTouch(Touching, SpatialMesh):
    def _turns(self):
        return self.pair.turns[self.counted].items()

    def rates(self):
        rates = []
        for wheel, point in zip(self.pair.wheels, self._points()):
            center = self.kinematics.rate(self.kinematics.position(wheel.center))
            rates.append(center + ca.cross(self.kinematics.spin(wheel.body), point))
        return ca.vertcat(*rates)
