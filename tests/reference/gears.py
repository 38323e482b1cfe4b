"""Toothings: which angles a pair of them couples, by numbers of teeth, and where teeth face spaces. Written from "Teeth" of NOTATION.md.

A wheel turns against what holds its centre and that of its partner: a body, or the ground, to which joints that keep a place pin both. In
the plane angles are those of bodies, in space those of the joints about whose axes they turn. Everything here is a number.

Where the axes are not parallel, and of a rack, the factors follow from the point where the pitch surfaces touch: what is at rest there is the part of its
velocities along the normal of the flanks.
"""

from dataclasses import dataclass, field
from fractions import Fraction

import casadi as ca
import numpy as np

import expressions

TAU = 2 * np.pi
KEEPS_PLACE = ("revolute", "fixed", "spherical", "universal", "constant_velocity")
KEEPS_ORIENTATION = ("fixed", "prismatic", "parallel")


@dataclass
class Toothing:
    body: str
    kind: str
    teeth: int  # of a worm its starts, of a rack none
    module: float  # of the normal section, of a worm along its axis
    angle: float  # of the normal section
    helix: float
    shift: float
    addendum: float
    dedendum: float
    first: float
    width: float | None
    bore: float | None
    center: object  # of a rack the first point of its line
    cone: float = 0.0
    diameter: float = 0.0
    along: object = None  # the direction of a rack's line

    @property
    def internal(self):
        return self.kind == "internal"

    @property
    def transverse_angle(self):
        return np.arctan(np.tan(self.angle) / np.cos(self.helix))

    @property
    def pitch(self):
        return self.module / np.cos(self.helix) * self.teeth / 2

    @property
    def base(self):
        return self.pitch * np.cos(self.transverse_angle)

    @property
    def tip(self):
        return self.pitch + self.module * (self.shift - self.addendum if self.internal else self.shift + self.addendum)

    @property
    def root(self):
        return self.pitch + self.module * (self.shift + self.dedendum if self.internal else self.shift - self.dedendum)


@dataclass
class Pair:
    name: str
    wheels: tuple
    sense: int  # +1 of two wheels, −1 of a wheel in a ring
    between: np.ndarray  # from the first centre to the second across the axes
    terms: dict = field(default_factory=dict)  # rotor → factor, in pitches
    travels: dict = field(default_factory=dict)  # joint → factor, in half modules of a rack
    constant: float = 0.0
    axes: np.ndarray | None = None  # in space: J of the first wheel's axle, in the axes of what holds both
    beside: float = 0.0  # in space: from the first centre to the second along the axle
    turns: tuple = ()  # in space: of each wheel, joints with signs about that axle
    firsts: tuple = ()  # of each wheel: a tooth's middle about that axle
    carrier: str | None = None  # what holds the centres
    touch: object = None  # of all but cylinders
    follows: bool = False

    @property
    def distance(self):
        return float(np.hypot(*self.between))

    @property
    def scale(self):
        """What the row is divided by."""
        return self.wheels[0].teeth or self.wheels[1].teeth


@dataclass
class Touch:
    """Where pitch surfaces touch, in the axes of what holds the wheels."""

    points: list  # from each centre, none of a rack
    axes: list  # of the wheels that turn, likewise
    along: np.ndarray  # where the first drives, it pushes the second this way; of length one
    apart: np.ndarray  # from the first to the second, across that and the teeth
    angle: float  # between the flanks' normal and the first of these
    radius: float  # a radian of a pitch along the normal, m
    directions: list  # of each wheel that turns: across its axle to its partner

    def psi(self, model, which):
        x, y = self.directions[which][:2]
        if model.kind != "planar":
            frame = _numbers(model, self.axes[which])
            x, y = frame[:, 0] @ self.directions[which], frame[:, 1] @ self.directions[which]
        return float(np.arctan2(y, x))


def pairs(model):
    """By name: constraints first, then loads."""
    definition = model.definition
    written = [part for part in definition["constraints"] if part["kind"] == "teeth"]
    written += [part for part in definition["loads"] if part["kind"] == "mesh"]
    found, rows = {}, []
    for part in written:
        if axes_move(part):
            first, second = (_toothing(model, part[key]["place"]) for key in ("first", "second"))
            found[part["name"]] = Pair(part["name"], (first, second), -1 if first.internal or second.internal else 1, None)
            continue
        pair = _pair(model, part["name"], [_toothing(model, part[key]["place"]) for key in ("first", "second")])
        rows.append(_row(model, pair))
        pair.follows = _rank(rows) < len(rows)
        if pair.follows:
            rows.pop()
        found[pair.name] = pair
    return found


def axes_move(load):
    return bool(load.get("axes")) and load["axes"]["value"].get("name") == "moving"


def _toothing(model, path):
    body, _, rim = path.rpartition(".")
    node = next(node for node in model.definition["bodies"] if node["name"] == body)
    node = next(own for own in node["toothings"] if own["name"] == rim)

    def value(key, default=None):
        if node.get(key) is None:
            return default
        return float(model.at_defaults(expressions.entry(node[key], model))[0])

    center, along = node["at"] if node.get("at") else f"{body}.center", None
    if node["kind"] == "rack":
        line = model.line({"line": node["line"]})
        center, along = line.origin, np.array(model.at_defaults(line.axis))
    return Toothing(
        body,
        node["kind"],
        round(value("starts" if node["kind"] == "worm" else "teeth", 0)),
        value("module"),
        value("pressure_angle", np.radians(20)),
        value("helix", 0.0),
        value("shift", 0.0),
        value("addendum", 1.0),
        value("dedendum", 1.25),
        value("first", 0.0),
        value("face_width"),
        value("bore"),
        model.named_place(center) if isinstance(center, str) else center,
        value("cone", 0.0),
        value("diameter", 0.0),
        along,
    )


def _pair(model, name, wheels):
    kinds = [wheel.kind for wheel in wheels]
    if "rack" in kinds:
        return _rack(model, name, wheels, kinds.index("rack"))
    if "bevel" in kinds or "worm" in kinds:
        return _crossed(model, name, wheels)
    first, second = wheels
    sense = -1 if first.internal or second.internal else 1
    carrier, across = _carrier(model, wheels)
    if model.kind == "planar":
        terms, fixed = {}, 0.0
        for factor, body in ((first.teeth, first.body), (sense * second.teeth, second.body), (-first.teeth - sense * second.teeth, carrier)):
            still, angle = _orientation(model, body)
            if still is None:
                fixed += factor * angle
            elif factor:
                terms[body] = terms.get(body, 0) + factor
        between = across[:2]
    else:
        terms, fixed, firsts = {}, 0.0, []
        turns = [_turn(model, wheel.body, carrier) for wheel in wheels]
        axis = next(axis for _, axis in turns if axis is not None)
        signed = []
        for (own, about), factor in zip(turns, (first.teeth, sense * second.teeth)):
            side = 1 if about is None else round(float(np.dot(axis, about)))
            signed.append({joint: side * sign for joint, sign in own.items()})
            firsts.append(_about(model, axis, axis if about is None else about, wheels[len(firsts)].first))
            for joint, sign in own.items():
                terms[joint] = terms.get(joint, 0) + factor * side * sign
        terms = {joint: factor for joint, factor in terms.items() if factor}
        frame = _numbers(model, axis)
        between = np.array([frame[:, 0] @ across, frame[:, 1] @ across])
    pair = Pair(name, (first, second), sense, np.array(between), terms, carrier=carrier, firsts=(first.first, second.first))
    if model.kind != "planar":
        pair.axes, pair.turns, pair.beside, pair.firsts = frame, tuple(signed), float(frame[:, 2] @ across), tuple(firsts)
    pair.constant = _wrapped(_facing(pair) - fixed)
    return pair


def _rack(model, name, wheels, which):
    """The pitch circle rolls on the line: ω × r = v along it."""
    rack, pinion = wheels[which], wheels[1 - which]
    lines = _fixed_to(model, rack.body, _known(model, rack.center), rack.along)
    for carrier, center in _pinned(model, pinion.center).items():
        for joint in model.joints.values():
            ends = (joint.first.body, joint.second.body)
            body = ends[1] if ends[0] == carrier else ends[0]
            if joint.kind != "prismatic" or carrier not in ends or carrier == pinion.body or body not in lines:
                continue
            at, along = lines[body]
            axis = np.array(model.at_defaults(joint.axis))
            turn = _turned(model, body, carrier)
            if carrier == ends[0]:
                start = _known(model, joint.first) + turn @ (at - _known(model, joint.second))
                moves = axis
            else:
                start = _known(model, joint.second) + turn @ (at - _known(model, joint.first))
                moves = turn @ -axis
            along = turn @ along
            way = center - start
            if model.kind == "planar":
                terms, about = {}, np.array([0, 0, 1])
                for factor, own in ((1, pinion.body), (-1, carrier)):
                    if _orientation(model, own)[0] is not None:
                        terms[own] = factor
                way, along3, moves3 = (np.append(vector, 0) for vector in (way, along, moves))
            else:
                terms, about = _turn(model, pinion.body, carrier)
                along3, moves3 = along, moves
            towards = -(way - way @ along3 * along3 - way @ about * about)
            touch = towards / np.linalg.norm(towards) * pinion.pitch
            rolls = np.cross(about, touch) @ along3
            turns = terms if model.kind != "planar" else {}
            terms = {rotor: factor * pinion.teeth for rotor, factor in terms.items()}
            travels = {joint.name: -(moves3 @ along3) * pinion.teeth / rolls}
            pair = Pair(name, wheels, 1, np.array([np.linalg.norm(towards), 0.0]), terms, travels, carrier=carrier)
            pair.turns, pair.firsts = (turns, turns), (pinion.first, pinion.first)
            # Where the pinion is ahead, by the order of both.
            order = -1 if which == 0 else 1
            points, axes = [touch, touch], [np.array(about, float)] * 2
            points[which] = axes[which] = None
            surface = np.cross(about, touch)
            angle = pinion.transverse_angle
            push, part = order * surface / np.linalg.norm(surface), order * touch / np.linalg.norm(touch)
            pair.touch = Touch(points, axes, push, part, angle, pinion.base / pinion.teeth, [touch, touch])
            return pair
    raise ValueError(f"{model.title}: nothing guides the rack of `{name}`")


def _fixed_to(model, body, at, along):
    """The line in everything that its body is fixed to."""
    found = {body: (at, along)}
    waiting = [body]
    while waiting:
        here = waiting.pop(0)
        for joint in model.joints.values():
            for near, far in ((joint.first, joint.second), (joint.second, joint.first)):
                if joint.kind == "fixed" and near.body == here and far.body not in found:
                    turn = _turned(model, here, far.body)
                    at, along = found[here]
                    found[far.body] = (_known(model, far) + turn @ (at - _known(model, near)), turn @ along)
                    waiting.append(far.body)
    return found


def _turned(model, body, other):
    """The axes of a body in those of another that keeps its orientation against it."""
    if model.kind != "planar":
        return np.eye(3)
    angle = _orientation(model, body)[1] - _orientation(model, other)[1]
    return np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])


def _crossed(model, name, wheels):
    """Bevel gears and worms: at the point that touches both velocities have the same part along the normal of the flanks."""
    carrier, across = _carrier(model, wheels)
    turns = [_turn(model, wheel.body, carrier) for wheel in wheels]
    axes = [np.array(about) for _, about in turns]
    kinds = [wheel.kind for wheel in wheels]
    if "worm" in kinds:
        worm = kinds.index("worm")
        normal = np.cross(axes[0], axes[1])
        normal *= np.sign(normal @ across) / np.linalg.norm(normal)
        # On the pitch circle of the wheel, where threads are as steep as they are so far from their axis.
        radii = [abs(normal @ across) - wheels[1 - worm].pitch if wheel.kind == "worm" else wheel.pitch for wheel in wheels]
        touch = [radii[0] * normal, -radii[1] * normal]
        # In the middle plane of the wheel.
        touch[worm] = touch[worm] + (1 - 2 * worm) * (across @ axes[worm]) * axes[worm]
        lead = np.arctan(wheels[worm].teeth * wheels[worm].module / 2 / radii[worm])
        hand = np.sign(wheels[1 - worm].helix)
        around = np.cross(axes[worm], (1 - 2 * worm) * normal)
        thread = np.cos(lead) * around + hand * np.sin(lead) * axes[worm]
        flank, apart = np.cross(thread, normal), normal
        angle = np.arctan(np.tan(wheels[1 - worm].transverse_angle) * np.cos(lead))
        directions = [normal, -normal]
    else:
        # The pitch cones touch along a line from where the axes cross.
        cone = np.cross(axes[0], axes[1])
        apex = np.cross(across, axes[1]) @ cone / (cone @ cone) * axes[0]
        out = [-apex / np.linalg.norm(apex), (across - apex) / np.linalg.norm(across - apex)]
        toward = out[1] - out[0] @ out[1] * out[0]
        line = np.cos(wheels[0].cone) * out[0] + np.sin(wheels[0].cone) * toward / np.linalg.norm(toward)
        long = wheels[0].pitch / np.sin(wheels[0].cone)
        middle = 1 - min([wheel.width for wheel in wheels if wheel.width], default=0.0) / 2 / long
        point = apex + middle * long * line
        touch, flank = [point, point - across], cone / np.linalg.norm(cone)
        apart = np.cross(line, flank)
        apart *= np.sign(apart @ toward)
        angle, directions = wheels[0].angle, [out[1], out[0]]
    speeds = [np.cross(axis, at) @ flank for axis, at in zip(axes, touch)]
    factors = [wheels[0].teeth, -wheels[0].teeth * speeds[1] / speeds[0]]
    terms = {}
    for (own, _), factor in zip(turns, factors):
        for joint, sign in own.items():
            terms[joint] = terms.get(joint, 0) + factor * sign
    pair = Pair(name, tuple(wheels), 1, np.array([np.linalg.norm(across), 0.0]), terms, carrier=carrier)
    pair.turns, pair.firsts = tuple(own for own, _ in turns), tuple(wheel.first for wheel in wheels)
    radius = np.cos(angle) * abs(speeds[0]) / wheels[0].teeth
    pair.touch = Touch(touch, axes, np.sign(speeds[0]) * flank, apart, angle, radius, directions)
    return pair


def _numbers(model, axis):
    """J(axis)."""
    return np.array(ca.evalf(model.joint_frame(ca.SX(ca.DM(list(axis))))))


def _about(model, axis, own, angle):
    """The angle about an axis of what has one about its own axle, which is parallel."""
    frame, other = _numbers(model, own), _numbers(model, axis)
    middle = np.cos(angle) * frame[:, 0] + np.sin(angle) * frame[:, 1]
    return float(np.arctan2(other[:, 1] @ middle, other[:, 0] @ middle))


def _facing(pair):
    """z1(θ1 − ψ) ± z2(θ2 − ψ …) where a tooth of the first faces a space of the second, without the angles θ."""
    first, second = pair.wheels
    x, y = pair.between
    if second.internal:  # from the ring's centre to the wheel's
        x, y = -x, -y
    psi = np.arctan2(y, x)
    if pair.sense < 0:
        return np.pi + (first.teeth - second.teeth) * psi - first.teeth * pair.firsts[0] + second.teeth * pair.firsts[1]
    return np.pi + first.teeth * (psi - pair.firsts[0]) + second.teeth * (psi + np.pi - pair.firsts[1])


def _wrapped(angle):
    return angle - TAU * np.floor(angle / TAU + 0.5)


# What holds the wheels.


def _carrier(model, wheels):
    own = [wheel.body for wheel in wheels]
    first, second = (_pinned(model, wheel.center) for wheel in wheels)
    order = [None, *model.bodies]
    for body in order:
        if body not in own and body in first and body in second:
            return body, second[body] - first[body]
    raise ValueError(f"{model.title}: nothing holds the centres of `{own[0]}` and `{own[1]}`")


def _pinned(model, place):
    found = {place.body: _known(model, place)}
    waiting = [place.body]
    while waiting:
        body = waiting.pop(0)
        for joint in model.joints.values():
            if joint.kind not in KEEPS_PLACE:
                continue
            for near, far in ((joint.first, joint.second), (joint.second, joint.first)):
                at, there = _known(model, near), _known(model, far)
                if near.body != body or at is None or there is None or far.body in found:
                    continue
                if np.allclose(at, found[body], rtol=0, atol=1e-9 * max(np.abs([*at, *found[body]]).max(), 1e-12)):
                    found[far.body] = there
                    waiting.append(far.body)
    return found


def _known(model, place):
    if ca.depends_on(ca.SX(place.local), model.time):
        return None
    return model.at_defaults(place.local)


def _orientation(model, body):
    """What a body's orientation is fixed to (None: the ground), and the angle against it."""
    order = [None, *model.bodies]
    of = {name: (name, 0.0) for name in order}
    for joint in model.joints.values():
        if joint.kind not in KEEPS_ORIENTATION:
            continue
        written = getattr(joint, "angle", None)
        angle = float(model.at_defaults(written)[0]) if written is not None else 0.0
        (a, of_a), (b, of_b) = of[joint.first.body], of[joint.second.body]
        turn = of_a + angle - of_b
        keep, lose, turn = (a, b, turn) if order.index(a) <= order.index(b) else (b, a, -turn)
        if keep != lose:
            of = {name: (keep, own + turn) if root == lose else (root, own) for name, (root, own) in of.items()}
    return of[body]


def _turn(model, wheel, carrier):
    """In space: joints with signs, and their axis."""
    for third in [carrier, None, *model.bodies]:
        one, other = _against(model, wheel, third), _against(model, carrier, third)
        if one is None or other is None:
            continue
        side = 1 if one[1] is None or other[1] is None else round(float(np.dot(one[1], other[1])))
        if side == 0:
            continue
        terms = dict(one[0])
        for joint, sign in other[0].items():
            terms[joint] = terms.get(joint, 0) - side * sign
        return terms, one[1] if one[1] is not None else other[1]
    raise ValueError(f"{model.title}: no axle of `{wheel}`")


def _against(model, body, other):
    if _orientation(model, body)[0] == _orientation(model, other)[0]:
        return {}, None
    for joint in model.joints.values():
        if joint.kind in ("revolute", "cylindrical") and {joint.first.body, joint.second.body} == {body, other}:
            axis = model.at_defaults(joint.axis)
            return {joint.name: 1 if joint.second.body == body else -1}, axis / np.linalg.norm(axis)
    return None


# Which rows say something new.


def _row(model, pair):
    row = {}
    for rotor, factor in pair.terms.items():
        key = _orientation(model, rotor)[0] if rotor in model.bodies else f"joint {rotor}"
        row[key] = row.get(key, 0) + round(factor)
    for joint, factor in pair.travels.items():
        module = next(wheel.module for wheel in pair.wheels if wheel.kind == "rack")
        row[f"travel {joint} {module}"] = round(factor * module / 2)
    return row


def _rank(rows):
    columns = list(dict.fromkeys(key for row in rows for key in row))
    matrix = [[Fraction(row.get(key, 0)) for key in columns] for row in rows]
    rank = 0
    for column in range(len(columns)):
        pivot = next((row for row in range(rank, len(matrix)) if matrix[row][column]), None)
        if pivot is None:
            continue
        matrix[rank], matrix[pivot] = matrix[pivot], matrix[rank]
        for row in range(rank + 1, len(matrix)):
            factor = matrix[row][column] / matrix[rank][column]
            matrix[row] = [a - factor * b for a, b in zip(matrix[row], matrix[rank])]
        rank += 1
    return rank
