"""Frictions that remember: bristles that bend (lugre), and a spring to an anchor that is dragged along (asperity).

Each component of the sliding v has a deflection z, a state. Of surfaces that press with N they resist with N p(v, z) + o(v).
"""

import casadi as ca

import contacts
from expressions import entry

KINDS = ("lugre", "asperity")
STATE = {"lugre": "bristle", "asperity": "way"}
COMPONENTS = {
    "revolute": 1, "prismatic": 1, "screw": 1, "point_on_line": 1, "point_on_curve": 1, "universal": 2, "cylindrical": 2, "point_on_plane": 2,
    "spherical": 3, "constant_velocity": 3, "planar": 3,
}
FORGETTING = 1e-3  # s
SMALL = 1e-6  # of v_t, v_s or μ/k: what the length of several components is not less than


def states(load, definition):
    """Their names, with the keys of declared ones."""
    contact = contacts.find(definition, load["on"])
    if contact is None:
        count = COMPONENTS[next(joint["kind"] for joint in definition["joints"] if joint["name"] == load["on"])]
    else:
        count = contacts.axes(definition, contact) * contacts.count(definition, contact)
    name = f"{load['name']}.{STATE[load['kind']]}"
    return [name] if count == 1 else [f"{name}[{i}]" for i in range(count)]


def own(load, model):
    """Its deflections, if it remembers."""
    if load["kind"] not in KINDS:
        return []
    return [model.values[name] for name in states(load, model.definition)]


def sliding(velocity, normal):
    """Of the surfaces of a contact: directions, as columns, and the components of v along them."""
    if normal is None:
        return ca.SX(1), [velocity]
    if normal.numel() == 2:
        along = ca.vertcat(normal[1], -normal[0])
        return along, [ca.dot(along, velocity)]
    return ca.SX.eye(3), ca.vertsplit(contacts.beside(velocity, normal))


def length(x, least):
    if len(x) == 1:
        return ca.fabs(x[0])
    return ca.sqrt(sum(part**2 for part in x) + least**2)


def given(load, kinematics, *keys):
    return [entry(load[key], kinematics) if load.get(key) else ca.SX(0) for key in keys]


def bending(load, kinematics, v, z):
    """The rates of the deflections."""
    if load["kind"] == "lugre":
        most, least, transition, stiffness = given(load, kinematics, "static", "kinetic", "transition", "stiffness")
        steady = least + (most - least) * ca.exp(-sum(x**2 for x in v) / transition**2)
        return [x - stiffness * length(v, SMALL * transition) * bent / steady for x, bent in zip(v, z)]
    most, stiffness = given(load, kinematics, "coefficient", "stiffness")
    far = length(z, SMALL * most / stiffness)
    rest = (1 - far * stiffness / most) / 0.05
    rest = ca.if_else(rest < 0, 0, ca.if_else(rest > 1, 1, rest))
    dragged = 1 - (3 * rest**2 - 2 * rest**3)
    if len(v) == 1:
        return [v[0] * (1 - ca.if_else(v[0] * z[0] > 0, dragged, 0))]
    onwards = sum(x * bent for x, bent in zip(v, z))
    onwards = ca.if_else(onwards > 0, onwards, 0)
    return [x - dragged * bent * onwards / far**2 for x, bent in zip(v, z)]


def resisted(load, kinematics, v, z):
    """p and o of each component."""
    if load["kind"] == "lugre":
        stiffness, damping, viscous = given(load, kinematics, "stiffness", "damping", "viscous")
        parts = zip(v, z, bending(load, kinematics, v, z))
        return [(stiffness * bent + damping * rate, viscous * x) for x, bent, rate in parts]
    most, stiffness, speed = given(load, kinematics, "coefficient", "stiffness", "speed")
    fast = length(v, SMALL * speed)
    asked = [most * x / ca.if_else(fast > speed, fast, speed) + stiffness * bent for x, bent in zip(v, z)]
    size = length(asked, SMALL * most)
    return [(x * most / ca.if_else(size > most, size, most), ca.SX(0)) for x in asked]
