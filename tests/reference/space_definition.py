"""A spatial DEFINITION to a model in SI: inertia tensors of shapes, markers with axes, joint frames.

What is common with the plane (constants, parameters, expressions, lines) is in `definition`. A place has axes of its
own: those of its marker, else of its body.
"""

from dataclasses import dataclass

import casadi as ca

from beams import Beam
from definition import Body, Model, Place
from expressions import entry, in_unit, pair
from modal import Modal
from space_frames import canonical_frame, cleaned, frame_about, turn_about

ALONG_Z = ca.SX([0, 0, 1])
# Angles by joint; each has a rate under the same number.
ANGLES = {
    "revolute": ("angle",), "cylindrical": ("angle",), "screw": ("angle",), "planar": ("angle",),
    "universal": ("angle_1", "angle_2"),
}  # fmt: skip
TRAVELS = {
    "prismatic": ("travel",), "cylindrical": ("travel",), "screw": ("travel",), "point_on_line": ("travel",),
    "planar": ("travel_1", "travel_2"), "parallel": ("travel_1", "travel_2", "travel_3"),
}  # fmt: skip


@dataclass
class SpaceJoint:
    name: str
    kind: str
    first: Place
    second: Place
    frame: ca.SX  # J: columns x, y, z in the axes of both places
    second_frame: ca.SX | None  # J of the second axis of a universal joint, in the axes of the second place
    pitch: ca.SX | None
    length: ca.SX | None

    @property
    def axis(self):
        return self.frame[:, 2]

    @property
    def second_axis(self):
        return self.second_frame[:, 2]


class SpaceModel(Model):
    kind = "spatial"
    dimension = 3

    def place(self, node):
        if "ground" in node:
            return Place(None, pair(node, self, key="ground"), ca.SX.eye(3))
        return self.named_place(node["place"])

    def named_place(self, text):
        """A point or marker of a body, `body.name`; without a dot a marker of the ground."""
        if "." not in text:
            for marker in self.definition.get("markers") or []:
                if marker["name"] == text:
                    return Place(None, pair(marker, self), self._marker_axes(marker))
            raise ValueError(f"{self.title}: the ground has no marker `{text}`")
        place = super().named_place(text)
        place.local = cleaned(place.local)
        place.axes = self.bodies[place.body].axes.get(text.rpartition(".")[2], ca.SX.eye(3))
        return place

    def joint_frame(self, axis):
        return canonical_frame(axis, self.at_defaults(axis))

    def _marker_axes(self, marker):
        turns = marker.get("axes") or []
        given = {turn["key"]: pair(turn, self) for turn in turns if turn["key"] in ("axis", "reference")}
        axes = ca.SX.eye(3)
        if "reference" in given:
            axes = frame_about(given.get("axis", ALONG_Z), given["reference"])
        elif "axis" in given:
            axes = self.joint_frame(given["axis"])
        # About the marker's own axes, in the order written.
        for turn in turns:
            if turn["key"].startswith("about_"):
                k, angle = "xyz".index(turn["key"][-1]), entry(turn, self)
                axes = ca.mtimes(axes, turn_about(k, ca.cos(angle), ca.sin(angle)))
        return cleaned(axes)

    def _body(self, body):
        kind, name = body["kind"], body["name"]
        given = {key: entry(value, self) for key, value in body["properties"].items()}
        vectors = {key: pair(value, self) for key, value in (body.get("vectors") or {}).items()}
        center = pair(body["center"], self) if body.get("center") else ca.SX.zeros(3)
        markers = body.get("markers") or []
        points = {point["name"]: pair(point, self) for point in [*(body.get("points") or []), *markers]}
        points |= {"origin": ca.SX.zeros(3), "center": center}
        if kind in ("rod", "cylinder"):
            points["start"] = ca.vertcat(-given["length"] / 2, 0, 0)
            points["end"] = ca.vertcat(given["length"] / 2, 0, 0)
        axes = {marker["name"]: self._marker_axes(marker) for marker in markers}
        if kind == "beam":
            # Referred to the origin of its frame; its mass is in its slices, but what turns about its own axis.
            beam = Beam(body, given, self)
            points |= beam.points()
            mass = given["mass"] if "mass" in given else given["density"] * beam.area * beam.length
            spin = ca.diag(ca.vertcat(mass * beam.polar, 0, 0))
            points["origin"] = ca.SX.zeros(3)
            return Body(name, False, mass, spin, ca.SX.zeros(3), points, axes, beam=beam)
        if kind == "flexible":
            # Referred to the origin of its frame; its mass is in its points, but what turns at its nodes.
            modal = Modal(body, given)
            return Body(name, False, ca.SX(modal.mass), ca.SX(modal.turning_inertia), ca.SX.zeros(3), points, axes, beam=modal)
        if ("mass" in given) == ("density" in given):
            raise ValueError(f"{self.title}: body `{name}` needs exactly one of mass and density")
        mass = given["mass"] if "mass" in given else given["density"] * _volume(kind, given, vectors)
        inertia = self._inertia(body, mass, given, vectors, axes)
        return Body(name, kind == "particle", mass, inertia, center, points, axes)

    def _inertia(self, body, mass, given, vectors, axes):
        """The tensor about the centre of mass in body axes."""
        if "inertia" not in vectors:
            return ca.diag(_moments(body["kind"], mass, given, vectors))
        products = vectors.get("products", ca.SX.zeros(3))
        xy, xz, yz = (products[k] for k in range(3))
        tensor = ca.diag(vectors["inertia"]) + ca.vertcat(
            ca.horzcat(0, xy, xz), ca.horzcat(xy, 0, yz), ca.horzcat(xz, yz, 0)
        )
        if body.get("inertia_axes"):
            b = axes[body["inertia_axes"]]
            tensor = cleaned(ca.mtimes(ca.mtimes(b, tensor), b.T))
        return tensor

    def _joint(self, joint):
        name, kind = joint["name"], joint["kind"]
        axis = pair(joint["axis"], self) if joint.get("axis") else ALONG_Z
        if kind == "point_on_line":
            line = self.line(joint["first"])
            # The frame of the direction is in the axes of the line's body, whatever marker it starts from.
            first, axis = Place(line.origin.body, line.origin.local, ca.SX.eye(3)), line.axis
        else:
            first = self.place(joint["first"])
        second_frame = self.joint_frame(pair(joint["second_axis"], self)) if kind == "universal" else None
        frame = ca.SX.eye(3) if kind in ("fixed", "parallel") else self.joint_frame(axis)
        pitch, length = (entry(joint[key], self) if joint.get(key) else None for key in ("pitch", "length"))
        return SpaceJoint(name, kind, first, self.place(joint["second"]), frame, second_frame, pitch, length)


def _volume(kind, given, vectors):
    if kind in ("rod", "cylinder"):
        return ca.pi * given["radius"] ** 2 * given["length"]
    if kind == "sphere":
        return 4 * ca.pi / 3 * given["radius"] ** 3
    if kind == "box":
        a, b, c = (vectors["size"][k] for k in range(3))
        return a * b * c
    if kind == "disk":
        return ca.pi * given["radius"] ** 2 * given["thickness"]
    raise ValueError(f"a body of kind `{kind}` has no volume")


def _moments(kind, mass, given, vectors):
    if kind == "particle":
        return ca.SX.zeros(3)
    if kind == "cylinder" or (kind == "rod" and "radius" in given):
        square = given["radius"] ** 2
        across = mass * (3 * square + given["length"] ** 2) / 12
        return ca.vertcat(mass * square / 2, across, across)
    if kind == "rod":
        across = mass * given["length"] ** 2 / 12
        return ca.vertcat(0, across, across)
    if kind == "sphere":
        return ca.repmat(2 * mass * given["radius"] ** 2 / 5, 3, 1)
    if kind == "box":
        a, b, c = (vectors["size"][k] ** 2 for k in range(3))
        return mass / 12 * ca.vertcat(b + c, a + c, a + b)
    if kind == "disk":
        square = mass * given["radius"] ** 2
        across = square / 4 + mass * given.get("thickness", 0) ** 2 / 12
        return ca.vertcat(across, across, square / 2)
    raise ValueError(f"a body of kind `{kind}` needs its inertia written")
