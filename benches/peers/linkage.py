"""A DEFINITION as what multibody libraries ask for: links that hang on one another by hinges, loops that are closed by cut hinges,
springs and torques, all in numbers.

Reading is that of tests/reference. Mechanisms in the plane become trees in space whose axes are all z. The frame of a link has its
origin on the hinge that carries it and the axes of its body. Links are numbered from the ground outwards, each branch to its end
before the next, as depth-first libraries do.
"""

import json
import pathlib
import sys
from dataclasses import asdict, dataclass, field

import numpy as np

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "tests" / "reference"))

from definition import Model  # noqa: E402
from expressions import entry, evaluate  # noqa: E402
from space_definition import SpaceModel  # noqa: E402

GROUND = -1


class CannotBeExpressed(Exception):
    """What the mechanism has and the description has not."""


@dataclass
class Link:
    name: str
    joint: str
    parent: int
    place: list  # of its hinge in the parent's frame
    axes: list  # of its frame in the parent's at angle zero, row by row
    axis: list  # of its hinge, in its own frame
    mass: float
    center: list
    tensor: list  # about the centre of mass, row by row


@dataclass
class Loop:
    """A hinge that is cut: places and axes in the frames of both links."""

    name: str
    links: list
    places: list
    axes: list


@dataclass
class Spring:
    links: list
    places: list
    stiffness: float
    length: float


@dataclass
class Linkage:
    name: str
    planar: bool
    gravity: list
    links: list
    loops: list
    springs: list = field(default_factory=list)
    torques: list = field(default_factory=list)  # on each link's hinge
    bodies: list = field(default_factory=list)  # in the order of the definition

    def json(self):
        return json.dumps(asdict(self), indent=1)

    def plain(self):
        """The text that `interface/linkage.hpp` reads."""
        flat = lambda *parts: " ".join(repr(float(x)) for part in parts for x in np.ravel(part))  # noqa: E731
        lines = ["planar"] if self.planar else []
        lines.append(f"gravity {flat(self.gravity)}")
        for link, torque in zip(self.links, self.torques):
            lines.append(f"link {link.parent} {flat(link.place, link.axes, link.axis, link.mass, link.center, link.tensor, torque)}")
        for loop in self.loops:
            lines.append(f"loop {loop.links[0]} {loop.links[1]} {flat(loop.places, loop.axes)}")
        for spring in self.springs:
            lines.append(f"spring {spring.links[0]} {spring.links[1]} {flat(spring.places, spring.stiffness, spring.length)}")
        return "\n".join(lines) + "\n"


def read(name, definition):
    """The linkage of a DEFINITION's text."""
    definition = json.loads(definition)
    return _Reader(name, definition).linkage()


class _Reader:
    def __init__(self, name, definition):
        self.name, self.definition = name, definition
        self.planar = definition["kind"] == "planar"
        self.model = Model(definition) if self.planar else SpaceModel(definition)
        for what in ("constraints", "drivers", "states", "tables"):
            if definition.get(what):
                raise CannotBeExpressed(f"it has {what}")

    def numbers(self, value):
        import casadi as ca

        inputs = ca.vertcat(self.model.u)
        defaults = [entry(p, self.model) for p in self.definition["parameters"]]
        given = ca.substitute(ca.SX(value), ca.vertcat(self.model.p, inputs, self.model.time), ca.vertcat(*defaults, inputs * 0, 0))
        return np.array(ca.evalf(given), dtype=float)

    def vector(self, value):
        found = self.numbers(value).ravel()
        return np.concatenate([found, [0.0]]) if self.planar else found

    def matrix(self, axes):
        return np.eye(3) if self.planar or axes is None else self.numbers(axes)

    def axis(self, joint):
        return np.array([0.0, 0.0, 1.0]) if self.planar else self.vector(joint.axis)

    def linkage(self):
        for joint in self.model.joints.values():
            if joint.kind != "revolute":
                raise CannotBeExpressed(f"joint `{joint.name}` is {joint.kind}")
        tree, cut = self.spanning_tree()
        order = self.outwards(tree)
        links, origins = [], {None: np.zeros(3)}
        number = {None: GROUND} | {body: k for k, body in enumerate(order)}
        for name in order:
            joint, own, other, sign = tree[name]
            body = self.model.bodies[name]
            hinge = self.vector(own.local)
            origins[name] = hinge
            inside, outside = self.matrix(own.axes), self.matrix(other.axes)
            tensor = np.eye(3) * float(self.numbers(body.inertia)[0, 0]) if self.planar else self.numbers(body.inertia)
            links.append(
                Link(
                    name,
                    joint.name,
                    number[other.body],
                    (self.vector(other.local) - origins[other.body]).tolist(),
                    (outside @ inside.T).tolist(),
                    (sign * inside @ self.axis(joint)).tolist(),
                    float(self.numbers(body.mass)[0, 0]),
                    (-hinge).tolist(),
                    tensor.tolist(),
                )  # fmt: skip
            )
        self.number, self.origins = number, origins
        loops = [
            Loop(
                joint.name, [number[place.body] for place in (joint.first, joint.second)],
                [self.at(place) for place in (joint.first, joint.second)],
                [(self.matrix(place.axes) @ self.axis(joint)).tolist() for place in (joint.first, joint.second)],
            )
            for joint in cut
        ]  # fmt: skip
        gravity = self.vector(self.model.gravity).tolist()
        linkage = Linkage(self.name, self.planar, gravity, links, loops, bodies=list(self.model.bodies))
        linkage.torques = [0.0] * len(links)
        for load in self.definition["loads"]:
            self.load(load, linkage)
        return linkage

    def at(self, place):
        return (self.vector(place.local) - self.origins[place.body]).tolist()

    def spanning_tree(self):
        """Body → (joint, own place, other place, sign of the angle), nearest to the ground first; the joints that are left."""
        tree, left, reached = {}, list(self.model.joints.values()), {None}
        while True:
            found = {}
            for joint in left:
                for own, other, sign in ((joint.second, joint.first, 1), (joint.first, joint.second, -1)):
                    if other.body in reached and own.body not in reached and own.body not in found:
                        found[own.body] = (joint, own, other, sign)
            if not found:
                break
            tree |= found
            reached |= set(found)
            taken = {entry[0].name for entry in found.values()}
            left = [joint for joint in left if joint.name not in taken]
        missing = set(self.model.bodies) - reached
        if missing:
            raise CannotBeExpressed(f"no hinge leads to {sorted(missing)}")
        return tree, left

    def outwards(self, tree):
        children = {}
        for name, (_, _, other, _) in tree.items():
            children.setdefault(other.body, []).append(name)
        order, stack = [], list(reversed(children.get(None, [])))
        while stack:
            name = stack.pop()
            order.append(name)
            stack += reversed(children.get(name, []))
        return order

    def load(self, load, linkage):
        if load["kind"] == "spring" and load.get("stiffness") and not load.get("damping"):
            places = [self.model.place(load["first"]), self.model.place(load["second"])]
            stiffness, length = (float(self.numbers(entry(load[key], self.model))[0, 0]) for key in ("stiffness", "length"))
            numbers = [self.number[place.body] for place in places]
            linkage.springs.append(Spring(numbers, [self.at(place) for place in places], stiffness, length))
        elif load["kind"] == "torque" and load["on"] in self.model.joints:
            at = next((k for k, link in enumerate(linkage.links) if link.joint == load["on"]), None)
            value = float(self.numbers(evaluate(load["value"], self.model))[0, 0])
            if at is None:
                raise CannotBeExpressed(f"load `{load['name']}` acts on a hinge that is cut")
            reversed_hinge = self.model.joints[load["on"]].first.body == linkage.links[at].name
            linkage.torques[at] += -value if reversed_hinge else value
        else:
            raise CannotBeExpressed(f"load `{load['name']}` is {load['kind']}")


# What the bodies do, as angles.


def motions(linkage, numbers):
    """Orientation, ω and ω̇ in body axes of each body, of many states: body → (n×3×3, n×3, n×3)."""
    numbers = np.asarray(numbers)
    found = {None: (np.broadcast_to(np.eye(3), (len(numbers), 3, 3)), np.zeros((len(numbers), 3)), np.zeros((len(numbers), 3)))}
    width = 10 if linkage.planar else 24
    for k, name in enumerate(linkage.bodies):
        part = numbers[:, k * width : (k + 1) * width]
        if linkage.planar:
            axes = np.tile(np.eye(3), (len(part), 1, 1))
            axes[:, 0, 0] = axes[:, 1, 1] = part[:, 2]
            axes[:, 1, 0], axes[:, 0, 1] = part[:, 3], -part[:, 3]
            rate, change = np.zeros((len(part), 3)), np.zeros((len(part), 3))
            rate[:, 2], change[:, 2] = part[:, 6], part[:, 9]
            found[name] = axes, rate, change
        else:
            found[name] = part[:, 3:12].reshape(-1, 3, 3), part[:, 15:18], part[:, 21:24]
    return found


def turn(parent, child, axes, axis):
    """Angle, rate and acceleration of a child about `axis` (its own axes), whose axes are `axes` of the parent's at angle zero."""
    relative = np.einsum("nji,njk->nik", parent[0], child[0])
    c = np.einsum("ji,njk->nik", np.asarray(axes), relative)
    vee = np.stack([c[:, 2, 1] - c[:, 1, 2], c[:, 0, 2] - c[:, 2, 0], c[:, 1, 0] - c[:, 0, 1]], axis=1) / 2
    angle = np.arctan2(vee @ np.asarray(axis), (np.trace(c, axis1=1, axis2=2) - 1) / 2)
    rate, change = ((child[k] - np.einsum("nji,nj->ni", relative, parent[k])) @ np.asarray(axis) for k in (1, 2))
    return angle, rate, change


def joint_angles(linkage, numbers):
    """Angles, rates and accelerations of the links' hinges: three arrays of states by links."""
    bodies = motions(linkage, numbers)
    parts = []
    for link in linkage.links:
        parent = None if link.parent == GROUND else linkage.links[link.parent].name
        parts.append(turn(bodies[parent], bodies[link.name], link.axes, link.axis))
    return tuple(np.stack([part[k] for part in parts], axis=1) for k in range(3))


def absolute_angles(linkage, numbers, names):
    """In the plane: angles, rates and accelerations of these bodies against the ground."""
    bodies = motions(linkage, numbers)
    parts = [turn(bodies[None], bodies[name], np.eye(3), [0, 0, 1]) for name in names]
    return tuple(np.stack([part[k] for part in parts], axis=1) for k in range(3))
