"""A DEFINITION, as a mechanism carries it, to a model in SI with symbolic parameters.

Converts units, resolves constants, derives the inertia of shapes and the places of points relative to the centres
of mass. Knows nothing of coordinates: laws, loads and equations stay expressions until `kinematics` gives the names
of moving quantities their meaning.
"""

from dataclasses import dataclass, field

import casadi as ca
import numpy as np

import contacts
import expressions
import friction
import gears
import hysteresis
import memories
from beams import Beam
from expressions import entry, in_unit, pair
from tables import Table


@dataclass
class Place:
    """A point fixed to a body (`local`: from the centre of mass, body axes) or to the ground (`local`: world)."""

    body: str | None
    local: ca.SX
    axes: ca.SX | None = None  # in space: of its marker, in body axes
    of_mean: bool = False  # the origin of a free beam's frame, which is no point of its axis


@dataclass
class Line:
    """A directed line through `origin`; `axis` is its unit vector in the axes of the body of `origin`."""

    origin: Place
    axis: ca.SX


@dataclass
class Body:
    name: str
    particle: bool  # a particle has no orientation
    mass: ca.SX
    inertia: ca.SX  # about the centre of mass; in space a tensor
    center: ca.SX  # from the body's origin
    points: dict = field(default_factory=dict)  # name → from the body's origin
    axes: dict = field(default_factory=dict)  # in space: of the markers by name
    beam: Beam | None = None


@dataclass
class Joint:
    name: str
    kind: str
    first: Place
    second: Place
    axis: ca.SX | None  # unit vector in the first's axes
    angle: ca.SX | None
    length: ca.SX | None
    outline: tuple | None = None  # of a cam: table, base, radius of the roller
    curve: tuple | None = None  # of a point on a curve: x and y as entries, the parameter itself where there is none

    @property
    def graph(self):
        """Along which axis the parameter is measured."""
        own = f"{self.name}.parameter"
        pure = [entry is None or entry["value"].get("name") == own for entry in self.curve]
        return pure.index(True)


class Model:
    """Bodies, joints and gravity in SI; as symbols: parameters `p`, `time`, inputs `u`, `phases`, internal states `z`.

    Rates of states may name efforts of drivers, which are given with each state."""

    kind = "planar"
    dimension = 2

    def __init__(self, definition):
        if definition.get("linkwright") != 1 or definition.get("kind") != self.kind:
            raise ValueError(f"only version 1 of a {self.kind} definition is understood")
        self.definition = definition
        self.title = definition["name"]
        self.p = ca.SX.sym("p", len(definition["parameters"]))
        self.time = ca.SX.sym("time")
        self.u = ca.SX.sym("u", len(definition["inputs"]))
        for load in definition["loads"]:
            hysteresis.name_the_way(load, definition)
        self.states = definition.get("states", []) + hysteresis.states(definition)
        self.rates = {rate["name"]: rate["value"] for rate in definition.get("rates", [])}
        self.z = ca.SX.sym("z", len(self.states))
        self.efforts = ca.SX.sym("effort", len(definition["drivers"]) if self.states else 0)
        self.normals = ca.SX.sym("normal", len(friction.rubbing(definition)))
        held = contacts.gates(definition)
        self.events, self.memories = memories.in_places(definition), definition.get("memories", [])
        self.gates = ca.SX.sym("gate", len(held) + len(self.events) + len(self.memories))
        self.values = {"time": self.time}
        for index, parameter in enumerate(definition["parameters"]):
            self.values[parameter["name"]] = self.p[index]
        for index, given in enumerate(definition["inputs"]):
            self.values[given["name"]] = self.u[index]
        for index, state in enumerate(self.states):
            self.values[state["name"]] = self.z[index]
        for memory, gate in zip(reversed(self.memories), reversed(ca.vertsplit(self.gates))):
            self.values[memory["name"]] = gate
        self.constants = {constant["name"]: constant for constant in definition["constants"]}
        self.signals = {signal["name"]: signal for signal in definition.get("signals", [])}
        self.tables = {
            table["name"]: Table(table, lambda node, unit: in_unit(node, unit, self)) for table in definition.get("tables", [])
        }
        self.gravity = pair(definition["gravity"], self) if definition.get("gravity") else ca.SX.zeros(self.dimension)
        self.bodies = {body["name"]: self._body(body) for body in definition["bodies"]}
        self.lines = {
            f"{body['name']}.{line['name']}": line for body in definition["bodies"] for line in body.get("lines") or []
        }
        self.joints = {joint["name"]: self._joint(joint) for joint in definition["joints"]}
        self.pairs = gears.pairs(self)
        self.free_phases = [
            coupling["name"]
            for coupling in definition["constraints"]
            if coupling["kind"] in ("gear", "rack")
            and coupling.get("phase") is None
            or coupling["kind"] == "teeth"
            and not self.pairs[coupling["name"]].follows
        ]
        self.free_phases += [load["name"] for load in definition["loads"] if load["kind"] == "mesh" and not gears.axes_move(load)]
        self.phases = ca.SX.sym("phase", len(self.free_phases))

    # The scope of expressions that name nothing that moves.

    def name(self, text):
        if text in self.constants and text not in self.values:
            self.values[text] = entry(self.constants[text], self)
        if text in self.signals:
            return entry(self.signals[text], self)
        if text not in self.values:
            raise ValueError(f"{self.title}: `{text}` is unknown here")
        return self.values[text]

    def distance(self, *_):
        raise ValueError("a distance cannot stand in a constant value")

    def power(self, _):
        raise ValueError("a power cannot stand in a constant value")

    def phase(self, coupling):
        """The phase of a gear, a rack or teeth: as written, else a symbol for the one fixed at the start."""
        if coupling.get("phase") is not None:
            return entry(coupling["phase"], self)
        return self.phases[self.free_phases.index(coupling["name"])]

    def at_defaults(self, vector):
        """Numbers, with the default values of parameters."""
        defaults = [in_unit(p["value"], p["unit"], self) for p in self.definition["parameters"]]
        values = ca.substitute(ca.SX(vector), ca.vertcat(self.p, self.time), ca.vertcat(*defaults, 0))
        return np.array(ca.evalf(values)).ravel()

    # Places and lines.

    def place(self, node):
        if "ground" in node:
            return Place(None, pair(node, self, key="ground"))
        return self.named_place(node["place"])

    def named_place(self, text):
        body_name, _, point = text.rpartition(".")
        body = self.bodies[body_name]
        if point not in body.points:
            raise ValueError(f"{self.title}: body `{body_name}` has no point `{point}`")
        of_mean = point == "origin" and body.beam is not None and body.beam.shapes in ("free", "modal")
        return Place(body_name, body.points[point] - body.center, of_mean=of_mean)

    def line(self, node):
        if "line" in node:
            node = self.lines[node["line"]]
        start, end = self.place(node["from"]), self.place(node["to"])
        if start.body != end.body:
            raise ValueError(f"a line joins places of `{start.body}` and `{end.body}`")
        return Line(start, _unit(end.local - start.local))

    def _body(self, body):
        kind = body["kind"]
        given = {name: entry(value, self) for name, value in body["properties"].items()}
        center = pair(body["center"], self) if body.get("center") else ca.SX.zeros(2)
        points = {point["name"]: pair(point, self) for point in body.get("points") or []}
        points["origin"] = ca.SX.zeros(2)
        points["center"] = center
        if kind == "rod":
            points["start"] = ca.vertcat(-given["length"] / 2, 0)
            points["end"] = ca.vertcat(given["length"] / 2, 0)
        if kind == "beam":
            # Referred to the origin of its frame, where it has no mass of its own: that is in its slices.
            beam = Beam(body, given, self)
            points.update(beam.points())
            mass = given["mass"] if "mass" in given else given["density"] * beam.area * beam.length
            return Body(body["name"], False, mass, ca.SX(0), ca.SX.zeros(2), points, beam=beam)
        mass = given["mass"] if "mass" in given else given["density"] * _volume(kind, given)
        inertia = given["inertia"] if "inertia" in given else _inertia_of_shape(kind, mass, given)
        return Body(body["name"], kind == "particle", mass, inertia, center, points)

    def _joint(self, joint):
        name, kind = joint["name"], joint["kind"]
        axis = None
        if kind == "point_on_line":
            line = self.line(joint["first"])
            first, axis = line.origin, line.axis
        else:
            first = self.place(joint["first"])
        if kind == "prismatic":
            axis = _unit(pair(joint["axis"], self))
        angle = entry(joint["angle"], self) if joint.get("angle") else ca.SX(0)
        length = entry(joint["length"], self) if joint.get("length") else None
        outline = None
        if kind == "cam":
            base, radius = (entry(joint[key], self) if joint.get(key) else ca.SX(0) for key in ("base", "radius"))
            outline = self.tables[joint["lift"]["value"]["name"]], base, radius
        curve = (joint.get("x"), joint.get("y")) if kind == "point_on_curve" else None
        return Joint(name, kind, first, self.place(joint["second"]), axis, angle, length, outline, curve)


def rotors_in_use(model):
    """The joints and bodies whose multi-turn angle the dynamics use, in a fixed order."""
    definition, found = model.definition, []
    for coupling in definition["constraints"]:
        if coupling["kind"] == "gear":
            found += [coupling["first"], coupling["second"]]
        elif coupling["kind"] == "rack":
            found.append(coupling["pinion"])
        elif coupling["kind"] == "teeth":
            found += model.pairs[coupling["name"]].terms
    found += [load["on"] for load in definition["loads"] if load["kind"] == "torsion_spring"]
    for load in definition["loads"]:
        if load["kind"] == "shaft":
            found += [load["first"], load["second"]]
        if load["kind"] == "mesh":
            found += model.pairs[load["name"]].terms
    parts = ("constraints", "drivers", "loads", "contacts", "events")
    for part in (definition.get(name, []) for name in parts):
        for text in _names(part, model.signals):
            owner, _, quantity = text.rpartition(".")
            if quantity == "angle" and (owner in model.bodies or owner in model.joints):
                found.append(owner)
    return list(dict.fromkeys(found))


def _names(part, signals):
    """All names in a part of a definition, and in the signals among them."""
    for text in expressions.names(part):
        yield text
        for signal in (text, text.removesuffix(".rate")):
            if signal in signals:
                yield from _names(signals[signal], signals)


def _volume(kind, given):
    if kind == "rod":
        return ca.pi * given["radius"] ** 2 * given["length"]
    if kind == "disk":
        return ca.pi * given["radius"] ** 2 * given["thickness"]
    if kind == "box":
        return given["width"] * given["height"] * given["thickness"]
    raise ValueError(f"a body of kind `{kind}` has no volume")


def _inertia_of_shape(kind, mass, given):
    if kind == "rod":
        return mass * (given["length"] ** 2 + 3 * given.get("radius", 0) ** 2) / 12
    if kind == "disk":
        return mass * given["radius"] ** 2 / 2
    if kind == "box":
        return mass * (given["width"] ** 2 + given["height"] ** 2) / 12
    if kind == "particle":
        return ca.SX(0)
    raise ValueError(f"a body of kind `{kind}` needs its inertia written")


def _unit(vector):
    return vector / ca.sqrt(ca.dot(vector, vector))
