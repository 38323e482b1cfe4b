"""Where everything is and how fast it moves, from the poses of the bodies; the rows of the constraints.

The choice of coordinates is left to `reference` (absolute) and `tree`: each says how the poses follow from its q and
how q changes with its v. Everything below is common and only uses that.

Angular quantities: a body's pose is (x, y) of its centre of mass and the pair (c, s) of its orientation; multi-turn
angles are coordinates of their own, so that at random states they need not agree with the pairs.
"""

import copy
from dataclasses import dataclass

import casadi as ca

import contacts
import expressions
import meshes
import penalties
from expressions import entry, evaluate


FOOT_OF_CAM = 5  # passes of Newton's method for the foot of a cam's roller


@dataclass
class Pose:
    x: ca.SX
    y: ca.SX
    c: ca.SX
    s: ca.SX
    omega: ca.SX

    @property
    def position(self):
        return ca.vertcat(self.x, self.y)

    def turn(self, vector):
        """Body axes to world axes: A vector, A = [c −s; s c]."""
        return ca.vertcat(self.c * vector[0] - self.s * vector[1], self.s * vector[0] + self.c * vector[1])

    def unturn(self, vector):
        """World axes to body axes."""
        return ca.vertcat(self.c * vector[0] + self.s * vector[1], self.c * vector[1] - self.s * vector[0])


@dataclass
class Row:
    of: str
    what: str
    value: ca.SX  # Φ of this row

    def __str__(self):
        return f"{self.of}.{self.what}"


GROUND = Pose(ca.SX(0), ca.SX(0), ca.SX(1), ca.SX(0), ca.SX(0))


class Kinematics:
    """To be completed with `q`, `v`, `poses` (by body), `q_rate(v)` and `multi_turn(rotor)`."""

    axes = ("x", "y")

    def __init__(self, model):
        self.model = model
        self.poses = {}
        self.contacts = contacts.Contacts(self)
        self.modes = {}  # of beams by body: coordinates, rates
        self.energies = None  # set by `energies`, for laws that name an energy or a power

    def rate(self, value):
        """Total time derivative of an expression of q and time, at velocity v."""
        return ca.jtimes(value, self.q, self.q_rate(self.v)) + self.explicit_rate(value)

    def explicit_rate(self, value):
        """∂/∂t at fixed q: what moves by itself."""
        return ca.densify(ca.jacobian(value, self.model.time))

    # Quantities.

    def pose(self, body):
        return GROUND if body is None else self.poses[body]

    def position(self, place):
        pose = self.pose(place.body)
        return pose.position + pose.turn(self.arm(place))

    def beam(self, body):
        return None if body is None else self.model.bodies[body].beam

    def arm(self, place):
        """From the body's origin of coordinates, in its axes; of a beam as it is deformed."""
        beam = self.beam(place.body)
        return place.local if beam is None or place.of_mean else beam.deformed(beam.spot(place.local), self.modes[place.body][0])

    def slope(self, place, of_rates=False):
        """By how much the section at a place is turned against its body, and how fast."""
        beam = self.beam(place.body)
        if beam is None:
            return ca.SX(0)
        return beam.slope(beam.spot(place.local), self.modes[place.body][int(of_rates)])

    def slopes(self, name, of_rates=False):
        """What a rotor turns by beyond its bodies."""
        if name not in self.model.joints:
            return ca.SX(0)
        joint = self.model.joints[name]
        return self.slope(joint.second, of_rates) - self.slope(joint.first, of_rates)

    def rotor(self, name):
        """The bodies (turning, reference) of a rotor: a joint's second and first, or a body and the ground."""
        if name in self.model.joints:
            joint = self.model.joints[name]
            return joint.second.body, joint.first.body
        if name in self.model.bodies:
            return name, None
        raise ValueError(f"{self.model.title}: no joint or body `{name}`")

    def rotor_rate(self, name):
        plus, minus = self.rotor(name)
        return self.pose(plus).omega - self.pose(minus).omega + self.slopes(name, of_rates=True)

    def principal_angle(self, name):
        """The rotor's angle in (−π, π] from the pairs."""
        plus, minus = (self.pose(body) for body in self.rotor(name))
        principal = ca.atan2(plus.s * minus.c - plus.c * minus.s, plus.c * minus.c + plus.s * minus.s)
        return principal + self.slopes(name)

    def travel(self, joint, which="travel"):
        """Of the second place along the axis, which turns with the first's body: (A1 â)·(p2 − p1); â is x or y of the
        first's axes where there are several travels."""
        if joint.kind == "point_on_curve":
            return self.parameter(joint)
        along = {"travel": joint.axis, "travel_1": (1, 0), "travel_2": (0, 1)}[which]
        axis = self.pose(joint.first.body).turn(along)
        return ca.dot(axis, self.position(joint.second) - self.position(joint.first))

    def parameter(self, joint):
        """Of a joint on a curve that is a graph: how far the second place is along that axis of the first's body."""
        return self.way(joint)[joint.graph]

    def way(self, joint):
        """p2 − p1 along the axes of the first's body."""
        return self.pose(joint.first.body).unturn(self.position(joint.second) - self.position(joint.first))

    def on_curve(self, joint):
        """The curve's point at the parameter, in the axes of the first's body."""
        own = f"{joint.name}.parameter"
        return ca.vertcat(*[self.name(own) if given is None else entry(given, self) for given in joint.curve])

    def tangent_of_curve(self, joint):
        """c′ of the curve at the parameter, in the axes of the first's body."""
        own, parameter = copy.copy(self), ca.SX.sym("parameter")
        own.parameter = lambda _: parameter
        return ca.substitute(ca.jacobian(own.on_curve(joint), parameter), parameter, self.parameter(joint))

    # The scope of laws, equations and loads.

    def name(self, text):
        model = self.model
        if text in model.values or text in model.constants:
            return model.name(text)
        if text in ("energy", "kinetic_energy", "potential_energy"):
            return self.energies.energy(text)
        if text in model.signals:
            return entry(model.signals[text], self)
        owner, _, quantity = text.rpartition(".")
        whole, _, part = owner.rpartition(".")
        for touching, what in ((owner, quantity), (whole, f"{part}.{quantity}")):
            joint = model.joints.get(touching)
            if contacts.find(model.definition, touching) and (joint is None or what.partition(".")[0] in contacts.QUANTITIES):
                return self.contacts.quantity(touching, what)
        if owner in model.signals and owner not in model.joints and owner not in model.bodies:
            return self.rate(entry(model.signals[owner], self))
        shafts = [load["name"] for load in model.definition["loads"] if load["kind"] == "shaft"]
        if owner in shafts and quantity == "torque":
            return self.energies.shaft_torque(owner)
        if owner in self.model.pairs and quantity in ("force", "deflection", "stiffness", "phase", "pairs"):
            return self._of_mesh(owner, quantity)
        if quantity == "resistance":
            return self.energies.resistance(owner)
        drivers = [driver["name"] for driver in model.definition["drivers"]]
        if owner in drivers and quantity in ("effort", "power"):
            return self._of_driver(drivers.index(owner), quantity)
        if whole in model.joints and part == "offset":
            first, second = model.joints[whole].first, model.joints[whole].second
            return self.displacement(first, second)[0][self.axes.index(quantity)]
        if owner in model.joints and quantity == "eccentricity":
            joint = model.joints[owner]
            return ca.norm_2(self.position(joint.second) - self.position(joint.first))
        if owner in model.joints:
            return self._of_joint(owner, quantity)
        body, _, mode = owner.rpartition(".")
        for of, which, index in ((owner, quantity, 0), (body, mode, 1)):
            beam = self.beam(of) if of in model.bodies else None
            if beam is not None and which in beam.names and (index == 0 or quantity == "rate"):
                return self.modes[of][index][beam.names.index(which)]
        if owner in model.bodies and quantity == "angle":
            return self.multi_turn(owner)
        if owner in model.bodies and quantity == "rate":
            return self.rotor_rate(owner)
        if quantity in self.axes:
            axis = self.axes.index(quantity)
            if owner.endswith(".velocity"):
                return self.rate(self.position(model.named_place(owner.removesuffix(".velocity"))))[axis]
            return self.position(model.named_place(owner))[axis]
        raise ValueError(f"{model.title}: `{text}` has no meaning here")

    def _of_joint(self, owner, quantity):
        joint = self.model.joints[owner]
        if quantity == "angle":
            return self.multi_turn(owner)
        if quantity == "rate":
            return self.rotor_rate(owner)
        if quantity in ("parameter", "parameter_rate"):
            parameter = self.parameter(joint)
            return parameter if quantity == "parameter" else self.rate(parameter)
        kind, _, number = quantity.partition("_")
        which = f"travel_{number}" if number else "travel"
        if kind == "travel":
            return self.travel(joint, which)
        if kind == "speed":
            return self.rate(self.travel(joint, which))
        raise ValueError(f"{self.model.title}: joint `{owner}` has no `{quantity}`")

    def _of_mesh(self, owner, quantity):
        mesh = meshes.mesh(next(load for load in self.model.definition["loads"] if load["name"] == owner), self)
        return mesh.pairs_in_contact() if quantity == "pairs" else getattr(mesh, quantity)()

    def _of_driver(self, index, quantity):
        """The effort as given, and its power along the law."""
        effort = self.model.efforts[index]
        law = entry(self.model.definition["drivers"][index]["law"], self)
        return effort if quantity == "effort" else effort * self.explicit_rate(law)

    def distance(self, first, second):
        difference = self.position(self._place_of(second)) - self.position(self._place_of(first))
        return ca.sqrt(ca.dot(difference, difference))

    def vector(self, text):
        """A place or its velocity; None where the name is of neither."""
        place = text.removesuffix(".velocity")
        owner, _, point = place.rpartition(".")
        if owner not in self.model.bodies or point in ("angle", "rate"):
            return None
        position = self.position(self.model.named_place(place))
        return position if place == text else self.rate(position)

    def displacement(self, first, second):
        """The second place less the first along the axes of the first's body; the angle between their bodies in (−π, π]."""
        one, other = self.pose(first.body), self.pose(second.body)
        span = self.position(second) - self.position(first)
        along = ca.vertcat(one.c * span[0] + one.s * span[1], one.c * span[1] - one.s * span[0])
        return along, ca.atan2(other.s * one.c - other.c * one.s, other.c * one.c + other.s * one.s)

    def _place_of(self, node):
        return self.model.named_place(node["name"]) if "name" in node else self.model.place(node)

    def power(self, load):
        return self.energies.power(load)

    # Constraint rows: joints as declared, constraints, drivers.

    def rows(self):
        definition = self.model.definition
        rows = [row for joint in self.model.joints.values() if not self.yields(joint.name) for row in self.joint_rows(joint)]
        rows += [self._coupling_row(coupling) for coupling in definition["constraints"] if not self._follows(coupling)]
        rows += [self._driver_row(driver) for driver in definition["drivers"]]
        for row in rows:
            if ca.depends_on(row.value, self.v):
                raise ValueError(f"{self.model.title}: the row {row} depends on velocities")
        return rows

    def yields(self, name):
        """Whether forces act in place of the joint's rows."""
        joint = next(joint for joint in self.model.definition["joints"] if joint["name"] == name)
        return bool(joint.get("penalty") or joint.get("play"))

    def joint_rows(self, joint):
        p1, p2 = self.position(joint.first), self.position(joint.second)
        pose1, pose2 = self.pose(joint.first.body), self.pose(joint.second.body)
        rows = []
        if joint.kind in ("revolute", "fixed"):
            rows += [Row(joint.name, "x", p1[0] - p2[0]), Row(joint.name, "y", p1[1] - p2[1])]
        if joint.kind in ("prismatic", "point_on_line"):
            normal = pose1.turn(ca.vertcat(-joint.axis[1], joint.axis[0]))
            rows.append(Row(joint.name, "normal", ca.dot(normal, p2 - p1)))
        if joint.kind in ("prismatic", "fixed", "parallel") and not self._joins_particle(joint):
            sine = pose2.s * pose1.c - pose2.c * pose1.s  # of θ2 − θ1
            cosine = pose2.c * pose1.c + pose2.s * pose1.s
            level = sine * ca.cos(joint.angle) - cosine * ca.sin(joint.angle)
            upright = cosine * ca.cos(joint.angle) + sine * ca.sin(joint.angle)
            # Across of the sections' directions A (1, σ).
            first, second = self.slope(joint.first), self.slope(joint.second)
            value = (second - first) * upright + (1 + first * second) * level
            rows.append(Row(joint.name, "angle", value))
        if joint.kind in ("distance", "cord"):
            rows.append(Row(joint.name, "distance", (ca.dot(p2 - p1, p2 - p1) - joint.length**2) / 2))
        if joint.kind == "point_on_curve":
            beside = self.way(joint) - self.on_curve(joint)
            rows.append(Row(joint.name, "beside", beside[1] if joint.graph == 0 else -beside[0]))
        if joint.kind == "cam":
            table, base, radius = joint.outline
            way = pose1.unturn(p2 - p1)
            rows.append(Row(joint.name, "out", contacts.out_of_curve(way, table, base, FOOT_OF_CAM) - radius))
        if not rows:
            raise ValueError(f"{self.model.title}: joint `{joint.name}` is of the unknown kind `{joint.kind}`")
        return rows

    def _joins_particle(self, joint):
        places = (joint.first, joint.second)
        return any(place.body is not None and self.model.bodies[place.body].particle for place in places)

    def _follows(self, coupling):
        """Teeth that others hold in place have no row."""
        return coupling["kind"] == "teeth" and self.model.pairs[coupling["name"]].follows

    def _coupling_row(self, coupling):
        kind, name = coupling["kind"], coupling["name"]
        if kind == "equation":
            value = evaluate(coupling["left"], self) - evaluate(coupling["right"], self)
        elif kind == "gear":
            ratio = expressions.entry(coupling["ratio"], self.model)
            first, second = self.multi_turn(coupling["first"]), self.multi_turn(coupling["second"])
            value = first - ratio * second - self.model.phase(coupling)
        elif kind == "teeth":
            pair = self.model.pairs[name]
            value = -self.model.phase(coupling)
            for rotor, factor in pair.terms.items():
                value += factor / pair.scale * self.multi_turn(rotor)
            for joint, factor in pair.travels.items():
                value += factor / pair.scale * self.travel(self.model.joints[joint])
        elif kind == "rack":
            radius = expressions.entry(coupling["radius"], self.model)
            travel = self.travel(self.model.joints[coupling["rail"]])
            value = travel - radius * self.multi_turn(coupling["pinion"]) - self.model.phase(coupling)
        else:
            raise ValueError(f"{self.model.title}: constraint `{name}` is of the unknown kind `{kind}`")
        return Row(name, kind, value)

    def _driver_row(self, driver):
        law = expressions.entry(driver["law"], self)
        return Row(driver["name"], "driver", evaluate(driver["quantity"], self) - law)
