"""Friction in joints, from the reaction that the joint has, and in contacts, from their own force.

Where the surfaces slide with v (rad/s about a pin, else m/s) friction resists with N p(v) + o(v) along each component of v, N being the
force that presses: sizes of parts of the reaction R, M on the second place's body, about the second place. N is given with each state; of
consistent ones it is computed from their reactions, so that M v̇ + Dᵀ λ = Q holds with what these reactions make of friction. In contacts
it acts on the material of both bodies at the point where they touch, along what is left of its velocity beside the normal.
"""

import casadi as ca
import numpy as np

import bristles
import contacts
from expressions import entry, evaluate

KINDS = ("coulomb", "stribeck", "dry", *bristles.KINDS)
TURNING = ("revolute", "universal", "spherical", "constant_velocity")
FACES = ("planar", "point_on_plane")
SMALLEST = 1e-9  # of the weight
STANDARD_GRAVITY = 9.80665


def value(load, key, kinematics):
    return entry(load[key], kinematics) if load.get(key) else ca.SX(0)


def rubbing(definition):
    """The loads whose friction follows from reactions."""
    loads = [load for load in definition["loads"] if load["kind"] in KINDS and follows(load)]
    return [load for load in loads if not contacts.find(definition, load["on"])]


def follows(load):
    def zero(node):
        return node["value"].get("number") is not None and float(node["value"]["number"]) == 0.0

    return any(load.get(key) and not zero(load[key]) for key in ("coefficient", "static", "kinetic"))


def normal(load, model):
    """N of a load, with its preload."""
    names = [other["name"] for other in rubbing(model.definition)]
    own = model.normals[names.index(load["name"])] if load["name"] in names else ca.SX(0)
    return own + value(load, "preload", model)


def slips(load, kinematics):
    """Groups of components of v, each with the factor of its coordinate's rate, and what N acts by."""
    joint, radius = kinematics.model.joints[load["on"]], value(load, "radius", kinematics)
    one = ca.SX(1)
    if joint.kind == "revolute":
        return [([(kinematics.rotor_rate(load["on"]), one)], radius)]
    if joint.kind == "universal":
        return [([(kinematics.joint_rate(joint, f"angle_{k}"), one)], radius) for k in (1, 2)]
    if joint.kind in ("spherical", "constant_velocity"):
        relative = kinematics.spin(joint.second.body) - kinematics.spin(joint.first.body)
        return [([(relative[k], one) for k in range(3)], radius)]
    if joint.kind in FACES:
        first, _ = kinematics.frames(joint)
        along = [(kinematics.rate(ca.dot(first[:, k], kinematics.span(joint))), one) for k in (0, 1)]
        turning = [(kinematics.joint_rate(joint), radius)] if joint.kind == "planar" else []
        return [(turning + along, one)]
    along = (kinematics.rate(kinematics.travel(joint)), one)
    if joint.kind == "point_on_curve":
        slope = kinematics.tangent_of_curve(joint)
        return [([(ca.dot(slope, kinematics.rate(kinematics.way(joint))) / ca.norm_2(slope), one)], one)]
    if joint.kind == "screw":
        lead, whole = thread(load, kinematics, joint)
        return [([((radius**2 * kinematics.joint_rate(joint) + lead * along[0]) / whole, one)], one)]
    if joint.kind == "cylindrical":
        return [([(kinematics.joint_rate(joint), radius), along], one)]
    return [([along], one)]


def thread(load, kinematics, joint):
    """p and √(r² + p²)."""
    lead = joint.pitch / (2 * ca.pi)
    return lead, ca.sqrt(value(load, "radius", kinematics) ** 2 + lead**2)


def resisted(load, kinematics, v, z=()):
    """p and o of each component; z are deflections where the law remembers."""
    if load["kind"] in bristles.KINDS:
        return bristles.resisted(load, kinematics, v, z)
    speed = value(load, "speed", kinematics)
    squares = sum(component**2 for component in v)
    smooth = ca.sqrt(squares + speed**2)
    if load["kind"] == "coulomb":
        mu = value(load, "coefficient", kinematics)
        own = value(load, "force", kinematics) + value(load, "torque", kinematics)
        return [(mu * x / smooth, own * x / smooth) for x in v]
    most, least, transition = (value(load, key, kinematics) for key in ("static", "kinetic", "transition"))
    mu = least + (most - least) * ca.exp(-squares / transition**2)
    return [(mu * x / smooth, value(load, "viscous", kinematics) * x) for x in v]


def in_contact(load, kinematics):
    """Rates w and what acts along them at each place where surfaces touch."""
    rates, acting, touching = [], [], kinematics.contacts
    if contacts.is_dry(load):
        slidings = touching.slidings(load["name"])
        return ca.vertcat(*slidings), ca.vertcat(*[touching.gates[load["name"], k] for k in range(len(slidings))])
    # What adheres presses nothing while it pulls.
    pressing = [ca.if_else(force > 0, force, 0) if touching.adheres(load["on"]) else force for force in touching.forces(load["on"])]
    places = zip(touching.closed(load["on"]), pressing, touching.sliding(load["on"]))
    deflections = iter(bristles.own(load, kinematics.model))
    for closed, pressed, (velocity, normal) in places:
        if load["kind"] in bristles.KINDS:
            frame, sliding = bristles.sliding(velocity, normal)
            z = [next(deflections) for _ in sliding]
            along = [-(pressed * p + ca.if_else(closed, o, 0)) for p, o in resisted(load, kinematics, sliding, z)]
            rates.append(velocity)
            acting += ca.vertsplit(ca.mtimes(frame, ca.vertcat(*along)))
            continue
        tangential = velocity if normal is None else contacts.beside(velocity, normal)
        resisted_along = resisted(load, kinematics, ca.vertsplit(tangential))
        rates.append(velocity)
        acting += [-(pressed * p + ca.if_else(closed, o, 0)) for p, o in resisted_along]
    return ca.vertcat(*rates), ca.vertcat(*acting)


def efforts(load, kinematics):
    """Rates w and what acts along them."""
    if contacts.find(kinematics.model.definition, load["on"]):
        return in_contact(load, kinematics)
    if contacts.is_dry(load):
        slidings = kinematics.contacts.slidings(load["name"])
        return ca.vertcat(*slidings), ca.vertcat(*[kinematics.contacts.gates[load["name"], k] for k in range(len(slidings))])
    pressed = normal(load, kinematics.model)
    rates, acting, deflections = [], [], iter(bristles.own(load, kinematics.model))
    for group, arm in slips(load, kinematics):
        v = [factor * rate for rate, factor in group]
        z = [next(deflections) for _ in v] if load["kind"] in bristles.KINDS else []
        for (rate, factor), (p, o) in zip(group, resisted(load, kinematics, v, z)):
            rates.append(rate)
            acting.append(-factor * (pressed * arm * p + o))
    return ca.vertcat(*rates), ca.vertcat(*acting)


def inner_rates(load, kinematics):
    """The rates of its deflections."""
    if load["kind"] not in bristles.KINDS:
        return []
    deflections, found = iter(bristles.own(load, kinematics.model)), []
    if contacts.find(kinematics.model.definition, load["on"]):
        touching = kinematics.contacts
        for closed, (velocity, normal) in zip(touching.closed(load["on"]), touching.sliding(load["on"])):
            v = bristles.sliding(velocity, normal)[1]
            z = [next(deflections) for _ in v]
            bent = bristles.bending(load, kinematics, v, z)
            found += [ca.if_else(closed, rate, -z / bristles.FORGETTING) for rate, z in zip(bent, z)]
        return found
    for group, _ in slips(load, kinematics):
        v = [factor * rate for rate, factor in group]
        found += bristles.bending(load, kinematics, v, [next(deflections) for _ in v])
    return found


def pressing(load, kinematics, force, torque, small):
    """N without preload, of a reaction in world axes."""

    def size(vector):
        return ca.sqrt(ca.dot(vector, vector) + small**2)

    joint, length = kinematics.model.joints[load["on"]], load.get("length")
    length = entry(length, kinematics) if length else None
    if joint.kind in ("universal", "spherical") or kinematics.model.dimension == 2 and joint.kind == "revolute":
        return size(force)
    if joint.kind == "constant_velocity":
        return size(force) + size(torque / value(load, "radius", kinematics))
    if joint.kind == "point_on_curve":
        slope = kinematics.pose(joint.first.body).turn(kinematics.tangent_of_curve(joint))
        return size((slope[0] * force[1] - slope[1] * force[0]) / ca.norm_2(slope))
    if kinematics.model.dimension == 2:
        axis = kinematics.pose(joint.first.body).turn(joint.axis)
        across = -axis[1] * force[0] + axis[0] * force[1]
        ends = [across] if length is None else [across / 2 + torque / length, across / 2 - torque / length]
        return sum(size(ca.vertcat(end)) for end in ends)
    axis = next(kinematics.frames(joint))[:, 2]
    if joint.kind in FACES:
        return size(ca.dot(axis, force))
    radial = force - ca.dot(axis, force) * axis
    if joint.kind == "screw":
        steep = thread(load, kinematics, joint)[1] / value(load, "radius", kinematics)
        return size(ca.dot(axis, force) * steep) + size(radial)
    if joint.kind == "revolute":
        pressed = size(radial)
        if load.get("shoulder"):
            shoulder = entry(load["shoulder"], kinematics) / value(load, "radius", kinematics)
            pressed += size(ca.dot(axis, force) * shoulder)
        if length is not None:
            pressed += size(2 * (torque - ca.dot(axis, torque) * axis) / length)
        return pressed
    if length is None:
        return size(radial)
    couple = ca.cross(torque, axis) / length
    return size(radial / 2 + couple) + size(radial / 2 - couple)


def smallest(model):
    """ε of √(R·R + ε²), by the weight at the defaults of parameters."""
    defaults = [float(entry(parameter, model)) for parameter in model.definition["parameters"]]
    whole = ca.vertcat(ca.vertcat(*[body.mass for body in model.bodies.values()]), model.gravity)
    numbers = np.array(ca.Function("weight", [model.p], [whole])(defaults)).ravel()
    mass, gravity = numbers[: len(model.bodies)].sum(), np.linalg.norm(numbers[len(model.bodies) :])
    return SMALLEST * mass * (gravity if gravity > 0 else STANDARD_GRAVITY)


class Pressing:
    """N of all frictions at consistent states, from their reactions."""

    def __init__(self, kinematics, arguments):
        model = kinematics.model
        self.loads = rubbing(model.definition)
        self.joints = [list(model.joints).index(load["on"]) for load in self.loads]
        dimension = model.dimension
        torques = 1 if dimension == 2 else 3
        force, torque = ca.SX.sym("force", dimension), ca.SX.sym("torque", torques)
        self.functions = []
        for load in self.loads:
            pressed = pressing(load, kinematics, force, torque, smallest(model))
            self.functions.append(ca.Function("pressing", [*arguments, kinematics.q, kinematics.v, force, torque], [pressed]))
        self.dimension = dimension

    def __call__(self, given, q, v, reactions):
        """(states, frictions)."""
        found = np.zeros((len(q), len(self.loads)))
        for k, (function, joint) in enumerate(zip(self.functions, self.joints)):
            for state in range(len(q)):
                reaction = reactions[state, joint]
                arguments = [part[state] for part in given]
                parts = reaction[: self.dimension], reaction[self.dimension :]
                found[state, k] = float(function(*arguments, q[state], v[state], *parts))
        return found
