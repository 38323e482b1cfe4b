"""Loads between teeth: deflection, stiffness and force, from "Teeth" of NOTATION.md. The shape of teeth is evaluated anew.

Where axes move, how deep teeth are in each other follows from their flanks as curves, and what acts from virtual work alone: no line of action is written
down. In space the force acts at the pitch point, on both wheels alike.
"""

import casadi as ca
import numpy as np

import gears
from expressions import entry
from quadrature import gauss

POSITIONS = 256
FOUNDATION = {
    "L": (-5.574e-5, -1.9986e-3, -2.3015e-4, 4.7702e-3, 0.0271, 6.8045),
    "M": (60.111e-5, 28.100e-3, -83.431e-4, -9.9256e-3, 0.1624, 0.9086),
    "P": (-50.952e-5, 185.50e-3, 0.0538e-4, 53.300e-3, 0.2895, 0.9236),
    "Q": (-6.2042e-5, 9.0889e-3, -4.0964e-4, 7.8297e-3, -0.1472, 0.6904),
}


def inv(angle):
    return np.tan(angle) - angle


def mesh(load, kinematics):
    if gears.axes_move(load):
        return MovingMesh(load, kinematics)
    if kinematics.model.pairs[load["name"]].touch is not None:
        import touching  # whose classes are made of these

        return touching.mesh(load, kinematics)
    return (Mesh if kinematics.model.kind == "planar" else SpatialMesh)(load, kinematics)


class Mesh:
    """One load, at the q and v of some kinematics."""

    def __init__(self, load, kinematics):
        self.load, self.kinematics, self.model = load, kinematics, kinematics.model
        self.pair = self.model.pairs[load["name"]]
        first, second = self.pair.wheels
        self.base = (first.base, second.base)
        self.reach = abs(second.base + self.pair.sense * first.base)
        self.distance = self.axes_apart()
        self.working = np.arccos(self.reach / self.distance)
        self.pitch = 2 * np.pi * first.base / first.teeth
        self.wheel, self.other = (second, first) if first.internal else (first, second)

    def axes_apart(self):
        return self.pair.distance

    def given(self, key):
        return entry(self.load[key], self.kinematics) if self.load.get(key) else ca.SX(0)

    # What moves.

    def deflection(self):
        phase = self.model.phases[self.model.free_phases.index(self.load["name"])]
        total = -phase
        for rotor, factor in self.pair.terms.items():
            total += factor * self.kinematics.multi_turn(rotor)
        return self.base[0] / self.pair.wheels[0].teeth * total - self.given("error")

    def rate(self):
        # Of counted angles, whose rates are those of the rotors.
        first = self.pair.wheels[0]
        turning = sum(factor * self.kinematics.rotor_rate(rotor) for rotor, factor in self.pair.terms.items())
        error = self.given("error_rate") if self.load.get("error_rate") else self.kinematics.rate(self.given("error"))
        return self.base[0] / first.teeth * turning - error

    def phase_at_rest(self):
        """τ where the wheel's turn against what holds it is zero, and the sense in which it grows."""
        sense = -self._sense() if self.pair.wheels[0].internal else self._sense()
        x, y = self.pair.between
        if self.pair.wheels[1].internal:
            x, y = -x, -y
        half = (np.pi / 2 + 2 * self.wheel.shift * np.tan(self.wheel.angle)) / self.wheel.teeth
        half += inv(self.wheel.transverse_angle) - inv(self.working)
        start = (self.wheel.base * (np.tan(self.working) + half) - self.path()[0]) / self.pitch
        carrier = self.pair.carrier
        still = 0.0
        for body, sign in ((self.wheel.body, 1), (carrier, -1)):
            root, angle = gears._orientation(self.model, body)
            still += sign * angle if root is None else 0.0
        turned = self.wheel.teeth * (still + self.wheel.first - np.arctan2(y, x)) / (2 * np.pi)
        return start + sense * turned, sense

    def _sense(self):
        return 1 if not self.load.get("sense") or float(ca.DM(entry(self.load["sense"], self.model))) > 0 else -1

    def turn(self):
        """(cos, sin) of the wheel's angle against what holds it."""
        carrier = self.pair.carrier
        c, s = ca.SX(1), ca.SX(0)
        for body, sign in ((self.wheel.body, 1), (carrier, -1)):
            if gears._orientation(self.model, body)[0] is not None:
                pose = self.kinematics.pose(body)
                c, s = c * pose.c - sign * s * pose.s, s * pose.c + sign * c * pose.s
        return c, s

    def phase(self):
        start, sense = self.phase_at_rest()
        carrier = self.pair.carrier
        total = ca.SX(0)
        for body, sign in ((self.wheel.body, 1), (carrier, -1)):
            if gears._orientation(self.model, body)[0] is not None:
                total += sign * self.kinematics.multi_turn(body)
        tau = start + sense * self.wheel.teeth * total / (2 * ca.pi)
        return tau - ca.floor(tau)

    def pairs_in_contact(self):
        begin, end = self.path()
        ratio = (end - begin) / self.pitch
        return np.floor(ratio) + ca.if_else(self.phase() < ratio - np.floor(ratio), 1, 0)

    def stiffness(self):
        node = self.load["stiffness"]
        if "involute" not in node:
            return entry(node, self.kinematics)
        mean, waves = self.series(node["involute"])
        start, sense = self.phase_at_rest()
        c, s = self.turn()
        # By angle and length and not as a product of many pairs, whose magnitude would be beyond all bounds.
        turned, square = ca.atan2(s, c), c**2 + s**2
        k = ca.SX(mean)
        for h, (a, b) in enumerate(waves, 1):
            count = self.wheel.teeth * h
            # cos(angle + sense h x) and sin of it.
            angle = 2 * np.pi * h * start + sense * count * turned
            k += square ** (count / 2) * (a * ca.cos(angle) + b * ca.sin(angle))
        return k

    def damping(self):
        """c, and whether it acts always."""
        node = self.load.get("damping")
        if node and node["value"].get("call") == "always":
            inner = {**node, "value": node["value"]["args"][0]}
            return entry(inner, self.model), True
        if node:
            return entry(node, self.model), False
        if not self.load.get("damping_ratio"):
            return ca.SX(0), False
        ratio = entry(self.load["damping_ratio"], self.model)
        stiffness = self.load["stiffness"]
        mean = self.series(stiffness["involute"])[0] if "involute" in stiffness else entry(stiffness, self.model)
        inverse = 0.0
        for which, wheel in enumerate(self.pair.wheels):
            root, _ = gears._orientation(self.model, wheel.body)
            if root is not None:
                bodies = self._moves_with(wheel, root)
                inverse += self._lever(which) ** 2 / sum(self._about_axle(self.model.bodies[name], which) for name in bodies)
        return float(self.model.at_defaults(2 * ratio * ca.sqrt(mean / inverse))[0]), False

    def _moves_with(self, wheel, root):
        return [name for name in self.model.bodies if gears._orientation(self.model, name)[0] == root]

    def _lever(self, which):
        return self.base[which]

    def _about_axle(self, body, which):
        return float(self.model.at_defaults(body.inertia)[0])

    def is_elastic(self):
        """Whether it stores energy."""
        if "involute" in self.load["stiffness"] or self.load.get("error"):
            return False
        stiffness = ca.SX(self.stiffness())
        if ca.depends_on(stiffness, ca.vertcat(self.kinematics.q, self.model.time, self.model.u, self.model.z)):
            return False
        damping, always = self.damping()
        return always or not self.load.get("backlash") or (isinstance(damping, ca.SX) and damping.is_zero())

    def stored(self):
        """½ k f², where that is an energy."""
        return self.stiffness() * self.beyond() ** 2 / 2 if self.is_elastic() else ca.SX(0)

    def beyond(self):
        u, half = self.deflection(), self.given("backlash") / 2
        return ca.if_else(u > half, u - half, ca.if_else(u < -half, u + half, 0))

    def force(self):
        k, (c, always) = self.stiffness(), self.damping()
        resisted = c * self.rate()
        if not self.load.get("backlash"):
            return k * self.deflection() + resisted
        if always:
            return k * self.beyond() + resisted
        u, half = self.deflection(), self.given("backlash") / 2
        ahead = ca.fmax(k * (u - half) + resisted, 0)
        behind = ca.fmin(k * (u + half) + resisted, 0)
        return ca.if_else(u > half, ahead, ca.if_else(u < -half, behind, 0))

    def rates(self):
        """Rates of both wheels, then of both centres; what acts along them is `efforts`."""
        first, second = self.pair.wheels
        spins = [self.kinematics.pose(wheel.body).omega for wheel in (first, second)]
        centers = [self.kinematics.rate(self.kinematics.position(wheel.center)) for wheel in (first, second)]
        return ca.vertcat(*spins, *centers)

    def efforts(self):
        """Torques −r_b1 N, ∓r_b2 N; on the second centre N cos α across the line of centres and |N| sin α along it."""
        force, pair = self.force(), self.pair
        carrier = pair.carrier
        pose = self.kinematics.pose(carrier)
        x, y = pair.between / pair.distance
        along, across = pose.turn(ca.DM([x, y])), pose.turn(ca.DM([-y, x]))
        tangential = force * np.cos(self.working)
        radial = ca.fabs(force) * np.sin(self.working)
        if pair.wheels[1].internal:
            pushed = -tangential * across - radial * along
        elif pair.wheels[0].internal:
            pushed = tangential * across - radial * along
        else:
            pushed = tangential * across + radial * along
        return ca.vertcat(-self.base[0] * force, -pair.sense * self.base[1] * force, -pushed, pushed)

    # The shape of teeth.

    def path(self):
        """Of contact, from the base tangent point of the wheel."""
        tangent = self.distance * np.sin(self.working)

        def reach(toothing):
            return np.sqrt(max(toothing.tip**2 - toothing.base**2, 0))

        if self.other.internal:
            return max(reach(self.other) - tangent, 0.0), reach(self.wheel)
        return max(tangent - reach(self.other), 0.0), min(reach(self.wheel), tangent)

    def series(self, node):
        young = float(ca.DM(entry(node["young"], self.model)))
        number = lambda key, default: float(ca.DM(entry(node[key], self.model))) if node.get(key) else default
        poisson, harmonics, over = number("poisson", 0.3), round(number("harmonics", 5)), number("entry", 0.0)
        section = bool(node.get("tooth")) and node["tooth"]["value"]["name"] == "section"
        widths = [wheel.width for wheel in self.pair.wheels if wheel.width]
        width = min(widths)
        begin, end = self.path()
        ratio = (end - begin) / self.pitch

        def one(along):
            material = (section, young, poisson, width)
            give = _gives(self.wheel, along, *material) + _gives(self.other, self._across(along), *material)
            return 1 / (give + (0 if section else 4 * (1 - poisson**2) / (np.pi * young * width)))

        curve = np.zeros(POSITIONS)
        for index in range(POSITIONS):
            at = index / POSITIONS
            while at < ratio:
                s = 1.0 if over == 0 else min(max(min(at, ratio - at) / over, 0.0), 1.0)
                curve[index] += s * s * (3 - 2 * s) * one(begin + at * self.pitch)
                at += 1
        spectrum = np.fft.rfft(curve) / POSITIONS
        waves = [(2 * spectrum[h].real, -2 * spectrum[h].imag) for h in range(1, harmonics + 1)]
        return spectrum[0].real, [self._across_the_face(h, wave, width) for h, wave in enumerate(waves, 1)]

    def _across(self, along):
        """Where the other wheel is touched, from its base tangent point."""
        tangent = self.distance * np.sin(self.working)
        return tangent + along if self.other.internal else tangent - along

    def _across_the_face(self, h, wave, width):
        """The mean of a harmonic over slices from one end of slanted teeth to the other, which the phase of the middle is counted for."""
        overlap = width * np.sin(abs(self.pair.wheels[0].helix)) / (np.pi * self.pair.wheels[0].module)
        if overlap == 0:
            return wave
        nodes, weights = gauss(60)
        shifts = np.pi * h * overlap * nodes
        # a cos(x − s) + b sin(x − s), the parts that are odd in s being none.
        even = float(np.sum(weights * np.cos(shifts))) / 2
        return wave[0] * even, wave[1] * even


class MovingMesh(Mesh):
    """Of axes that move: of either side of a tooth, how far the flank of the one wheel is beyond that of the other along their common normal."""

    def axes_apart(self):
        """Without play: inv α₀ = inv α_t + 2 Σx tan α/Σz, by bisection."""
        first, second = self.pair.wheels
        signs = (-1 if first.internal else 1, -1 if second.internal else 1)
        if self.pair.sense < 0 and first.internal:
            signs = (1, -1)
            first, second = second, first
        teeth = abs(first.teeth + signs[1] * second.teeth)
        shifts = first.shift + second.shift if self.pair.sense > 0 else second.shift - first.shift
        wanted = inv(first.transverse_angle) + 2 * shifts * np.tan(first.angle) / teeth
        low, high = 0.0, 1.5
        for _ in range(200):
            middle = (low + high) / 2
            low, high = (middle, high) if inv(middle) < wanted else (low, middle)
        return self.reach / np.cos(low)

    def _centres(self):
        """From the first to the second, of a ring from its centre to the wheel's."""
        first, second = (self.kinematics.position(wheel.center) for wheel in self.pair.wheels)
        return first - second if self.pair.wheels[1].internal else second - first

    def _flanks(self):
        """Both overlaps along the common normal, but for whole pitches, and a."""
        d = self._centres()
        square = ca.dot(d, d)
        apart = square > self.reach**2
        tangent = ca.if_else(apart, ca.sqrt(ca.if_else(apart, square - self.reach**2, 1)), 0)
        alpha, psi = ca.atan2(tangent, self.reach), ca.atan2(d[1], d[0])
        overlaps = []
        for side in (1, -1):
            lengths = []
            for wheel, own in zip(self.pair.wheels, (0, np.pi)):
                pose = self.kinematics.pose(wheel.body)
                own = own if self.pair.sense > 0 else 0
                # A ring's space is shaped like the tooth of a wheel, half a pitch beside its own.
                middle = ca.atan2(pose.s, pose.c) + wheel.first + (np.pi / wheel.teeth if wheel.internal else 0)
                half = (np.pi / 2 + 2 * wheel.shift * np.tan(wheel.angle)) / wheel.teeth + inv(wheel.transverse_angle)
                lengths.append(wheel.base * (side * (middle - psi - own) + half + alpha))
            if self.pair.sense > 0:
                overlaps.append(lengths[0] + lengths[1] - tangent)
            else:
                inner, ring = lengths if self.pair.wheels[1].internal else reversed(lengths)
                overlaps.append(inner - ring + tangent)
        if self.pair.wheels[0].internal:  # ahead is the ring, which presses the other side of the wheel's tooth
            overlaps.reverse()
        return overlaps

    def turned(self):
        """Half of their difference, in the middle of a space where that is none, and what lies between them then."""
        ahead, behind = self._flanks()
        x, between = (ahead - behind) / 2, -(ahead + behind) / 2
        if self.pair.sense > 0:
            x, between = x + self.pitch / 2, between + self.pitch / 2
        return x - self.pitch * ca.floor(x / self.pitch + 0.5), between

    def deflection(self):
        return self.turned()[0] - self.given("error")

    def sides(self):
        """N of either side, and the rate along which each of them resists."""
        (x, between), k, (c, _) = self.turned(), self.stiffness(), self.damping()
        error = self.given("error")
        error_rate = self.given("error_rate") if self.load.get("error_rate") else self.kinematics.rate(error)
        forces, rates = [], []
        for side in (1, -1):
            deep = side * (x - error) - between - self.given("backlash") / 2
            rate = self.kinematics.rate(side * x - between)
            forces.append(ca.if_else(deep > 0, ca.fmax(k * deep + c * (rate - side * error_rate), 0), 0))
            rates.append(rate)
        return ca.vertcat(*forces), ca.vertcat(*rates)

    def force(self):
        forces, _ = self.sides()
        return forces[0] - forces[1]

    def rates(self):
        return self.sides()[1]

    def efforts(self):
        return -self.sides()[0]

    def is_elastic(self):
        damping, _ = self.damping()
        return super().is_elastic() and isinstance(damping, ca.SX) and damping.is_zero()

    def stored(self):
        if not self.is_elastic():
            return ca.SX(0)
        x, between = self.turned()
        within = between + self.given("backlash") / 2
        return self.stiffness() * (ca.fmax(x - within, 0) ** 2 + ca.fmax(-x - within, 0) ** 2) / 2

    def turn(self):
        pose, d = self.kinematics.pose(self.wheel.body), self._centres()
        a = ca.sqrt(ca.dot(d, d))
        return (pose.c * d[0] + pose.s * d[1]) / a, (pose.s * d[0] - pose.c * d[1]) / a

    def phase_at_rest(self):
        sense = -self._sense() if self.pair.wheels[0].internal else self._sense()
        half = (np.pi / 2 + 2 * self.wheel.shift * np.tan(self.wheel.angle)) / self.wheel.teeth
        half += inv(self.wheel.transverse_angle) - inv(self.working)
        start = (self.wheel.base * (np.tan(self.working) + half) - self.path()[0]) / self.pitch
        return start + sense * self.wheel.teeth * self.wheel.first / (2 * np.pi), sense

    def phase(self):
        start, sense = self.phase_at_rest()
        c, s = self.turn()
        tau = start + sense * self.wheel.teeth * ca.atan2(s, c) / (2 * ca.pi)
        return tau - ca.floor(tau)


class SpatialMesh(Mesh):
    """About parallel axes in space: the angles are those of joints."""

    def _about_axle(self, body, which):
        axle = self.pair.axes[:, 2]
        return float(axle @ self.model.at_defaults(ca.vec(body.inertia)).reshape(3, 3) @ axle)

    def _turns(self):
        return self.pair.turns[self.pair.wheels.index(self.wheel)].items()

    def phase_at_rest(self):
        sense = -self._sense() if self.pair.wheels[0].internal else self._sense()
        x, y = -self.pair.between if self.pair.wheels[1].internal else self.pair.between
        half = (np.pi / 2 + 2 * self.wheel.shift * np.tan(self.wheel.angle)) / self.wheel.teeth
        half += inv(self.wheel.transverse_angle) - inv(self.working)
        start = (self.wheel.base * (np.tan(self.working) + half) - self.path()[0]) / self.pitch
        middle = self.pair.firsts[self.pair.wheels.index(self.wheel)]
        return start + sense * self.wheel.teeth * (middle - np.arctan2(y, x)) / (2 * np.pi), sense

    def turn(self):
        # Not brought to length one where bodies are not yet consistent.
        c, s = ca.SX(1), ca.SX(0)
        for joint, sign in self._turns():
            e1, e2 = self.kinematics.frames(self.model.joints[joint])
            own_c, own_s = ca.dot(e1[:, 0], e2[:, 0]), sign * ca.dot(e1[:, 1], e2[:, 0])
            c, s = c * own_c - s * own_s, s * own_c + c * own_s
        return c, s

    def phase(self):
        start, sense = self.phase_at_rest()
        total = sum((sign * self.kinematics.multi_turn(joint) for joint, sign in self._turns()), ca.SX(0))
        tau = start + sense * self.wheel.teeth * total / (2 * ca.pi)
        return tau - ca.floor(tau)

    def rates(self):
        """Angular velocities of both wheels, then velocities of both centres, in world axes."""
        spins = [self.kinematics.spin(wheel.body) for wheel in self.pair.wheels]
        centers = [self.kinematics.rate(self.kinematics.position(wheel.center)) for wheel in self.pair.wheels]
        return ca.vertcat(*spins, *centers)

    def efforts(self):
        """One force at the pitch point, and its opposite."""
        force, (first, second) = self.force(), self.pair.wheels
        carrier = self.pair.carrier
        x, y, axle = (self.kinematics.pose(carrier).turn(ca.DM(self.pair.axes[:, k])) for k in range(3))
        along = (self.pair.between[0] * x + self.pair.between[1] * y) / self.distance
        across = ca.cross(axle, along)
        tangential, radial = force * np.cos(self.working), ca.fabs(force) * np.sin(self.working)
        if second.internal:
            pushed = -tangential * across - radial * along
        elif first.internal:
            pushed = tangential * across - radial * along
        else:
            pushed = tangential * across + radial * along
        pushed -= force * np.tan(first.helix) * np.cos(first.transverse_angle) * axle
        # From the first centre it lies towards the second, but a ring is around its wheel.
        out = -1 if second.internal else 1
        at_first = out * self.base[0] / np.cos(self.working) * along + self.pair.beside / 2 * axle
        at_second = at_first - self.distance * along - self.pair.beside * axle
        return ca.vertcat(ca.cross(at_first, -pushed), ca.cross(at_second, pushed), -pushed, pushed)


def _half(toothing, angle):
    """Half the angle of a tooth where the pressure angle is this."""
    own = np.pi / 2 + (-1 if toothing.internal else 1) * 2 * toothing.shift * np.tan(toothing.angle)
    side = -1 if toothing.internal else 1
    return own / toothing.teeth + side * (inv(toothing.transverse_angle) - inv(angle))


def _gives(toothing, place, section, young, poisson, width):
    """The compliance of a tooth, of a rack so far above its line."""
    if toothing.kind == "rack":
        return _straight(toothing, place, section, young, poisson, width)
    return _section(toothing, place, young, width) if section else _profile(toothing, place, young, poisson, width)


def _straight(rack, height, section, young, poisson, width):
    """A trapezium, half a pitch thick at the line, by slices from its root."""
    foot = -rack.dedendum * rack.module

    def thickness(y):
        return np.pi * rack.module / 2 - 2 * y * np.tan(rack.angle)

    if section:
        return (height - foot) ** 3 / (3 * young * (width * thickness(height) ** 3 / 12))
    plate = young / (1 - poisson**2) if width > 5 * thickness(0) else young
    shear = young / (2 * (1 + poisson))
    nodes, weights = gauss(60)
    y = (height + foot) / 2 + (height - foot) / 2 * nodes
    # N = (cos α across the tooth, sin α down along it), at half its thickness beside the middle.
    bent = (height - y) * np.cos(rack.angle) - thickness(height) / 2 * np.sin(rack.angle)
    area, second = width * thickness(y), width * thickness(y) ** 3 / 12
    give = bent**2 / (plate * second) + 1.2 * np.cos(rack.angle) ** 2 / (shear * area) + np.sin(rack.angle) ** 2 / (plate * area)
    return float(weights @ give) * (height - foot) / 2


def _section(toothing, along, young, width):
    radius, angle = np.hypot(toothing.base, along), np.arctan2(along, toothing.base)
    half = _half(toothing, angle)
    thickness, height = 2 * radius * np.sin(half), abs(radius * np.cos(half) - toothing.root)
    return height**3 / (3 * young * (width * thickness**3 / 12))


def _profile(toothing, along, young, poisson, width):
    base, root, side = toothing.base, toothing.root, -1 if toothing.internal else 1
    radius, angle = np.hypot(base, along), np.arctan2(along, base)
    half = _half(toothing, angle)
    load = angle - side * half
    height, across = side * radius * np.cos(half), radius * np.sin(half)
    thick = 2 * toothing.pitch * _half(toothing, toothing.transverse_angle)
    plate = young / (1 - poisson**2) if width > 5 * thick else young
    shear = young / (2 * (1 + poisson))
    nodes, weights = gauss(40)

    def slices(y, x, dy):
        moment = (height - y) * np.cos(load) - across * np.sin(load)
        give = moment**2 / (plate * 2 * width * x**3 / 3)
        give += (1.2 * np.cos(load) ** 2 / shear + np.sin(load) ** 2 / plate) / (2 * width * x)
        return float(np.sum(weights * give * dy))

    total, foot = 0.0, np.arccos(base / root) if root > base else 0.0
    whole = _half(toothing, 0.0)
    if side > 0 and root < base:
        low, high = root * np.cos(whole), base * np.cos(whole)
        y = (low + high) / 2 + (high - low) / 2 * nodes
        total += slices(y, y * np.tan(whole), (high - low) / 2)
    alpha = (foot + angle) / 2 + (angle - foot) / 2 * nodes
    halves, radii = _half(toothing, alpha), base / np.cos(alpha)
    growth = radii * np.tan(alpha) * (np.cos(halves) + side * np.sin(halves) * np.tan(alpha))
    total += slices(side * radii * np.cos(halves), radii * np.sin(halves), side * growth * (angle - foot) / 2)
    if side < 0:
        return total
    theta = _half(toothing, foot)
    ratio = root / (toothing.bore / 2 if toothing.bore else root / 2)
    of = {
        name: a / theta**2 + b * ratio**2 + c * ratio / theta + d / theta + e * ratio + f
        for name, (a, b, c, d, e, f) in FOUNDATION.items()
    }
    part = (height - across * np.tan(load) - root * np.cos(theta)) / (2 * root * theta)
    body = of["L"] * part**2 + of["M"] * part + of["P"] * (1 + of["Q"] * np.tan(load) ** 2)
    return total + np.cos(load) ** 2 / (width * young) * body
