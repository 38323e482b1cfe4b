"""Surfaces, contacts and limits of a DEFINITION: gaps from the surfaces themselves, all in world axes, and forces by `if_else`.

A contact acts along its gaps g, each with a force F(d, ḋ), d = −g > 0, and 0 where g ≥ 0. Where gates are held, F is s times the law, s the
gate of the state, and the law goes on where it would pull, a linear one also where g > 0. Of rigid contacts the gate is F itself.
"""

import math

import casadi as ca

import expressions
import friction
import penalties
from expressions import entry, evaluate

REFINED = 3  # passes of Newton's method for the foot on a profile
FINE = 2.0**50
SLOWEST = 1e-3  # m/s or rad/s
PARALLEL = 1e-8  # sin² of the angle between bars
TINY = 1e-24  # m²: below it a distance is none
ROUND = ("point", "circle", "sphere")
FLAT = ("half_plane", "plane")


def all_loads(definition):
    """The names of the loads in the order of their powers: contacts and then joints that yield come last."""
    touching = [contact["name"] for contact in definition.get("contacts", [])]
    return [load["name"] for load in definition["loads"]] + touching + [joint["name"] for joint in penalties.written(definition)]


# What expressions name of a contact; a joint with play has a contact of its name.
QUANTITIES = ("gap", "depth", "closing", "force", "point", "sliding")


def find(definition, name):
    return next((contact for contact in definition.get("contacts", []) if contact["name"] == name), None)


def is_rigid(contact):
    return contact["law"]["kind"] == "rigid"


def is_dry(load):
    """Whether it is the friction of a rigid contact that holds what rests."""
    return load["kind"] == "dry"


def gates(definition):
    """(contact or dry friction, which of the gaps) of each gate that is held within a step: those of joints, or of contacts; of these only rigid
    ones where there are such."""
    all_contacts = definition.get("contacts", [])
    word = definition.get("options", {}).get("contact", "live")
    sticking = [load for load in definition["loads"] if is_dry(load) and not find(definition, load["on"])]
    if sticking:
        return [(load["name"], which) for load in sticking for which in range(directions(definition, load))]
    rigid = [contact for contact in all_contacts if is_rigid(contact)]
    if word != "held" and not rigid:
        return []
    rubbing = [(load["name"], find(definition, load["on"])) for load in definition["loads"] if is_dry(load)]
    all_of = [(name, count(definition, contact) * axes(definition, contact)) for name, contact in rubbing]
    all_of += [(contact["name"], count(definition, contact)) for contact in rigid or all_contacts]
    return [(name, which) for name, many in all_of for which in range(many)]


def drawn(definition, numbers):
    """Gates from numbers between 0 and 1: open or closed; where there are rigid contacts, forces."""
    rigid = any(is_rigid(contact) for contact in definition.get("contacts", []))
    return numbers if rigid else numbers.round()


def axes(definition, contact):
    """How many numbers the sliding of surfaces has at each gap: in space one along each axis of the world."""
    return 3 if definition["kind"] == "spatial" and contact["kind"] == "between" else 1


def directions(definition, load):
    """Along how many coordinates the surfaces of a joint with dry friction slide."""
    joint = next(joint for joint in definition["joints"] if joint["name"] == load["on"])
    if joint["kind"] == "cylindrical":
        return 2 if load.get("radius") else 1
    return {"universal": 2, "spherical": 3}.get(joint["kind"], 1)


def count(definition, contact):
    """How many gaps a contact has."""
    surfaces = {s["name"]: s for s in definition.get("surfaces", [])}
    pair = [surfaces.get(contact.get(end)) or {"kind": "circle"} for end in ("first", "second")]
    kinds = [surface["kind"] for surface in pair]
    # What has ends or corners may stand on each of them.
    several = kinds[0] in FLAT or kinds[1] in FLAT
    ends = [len(surface["places"]) for surface in pair if several and surface["kind"] in ("segment", "capsule", "polygon")]
    return max(ends, default=1)


def along_surface(velocity, normal):
    """The component of a velocity in the plane along a surface; what a gap says of itself has one."""
    return velocity if normal is None else normal[1] * velocity[0] - normal[0] * velocity[1]


def beside(vector, normal):
    """What of it is along the surface."""
    return vector - normal * ca.dot(normal, vector)


class Contacts:
    def __init__(self, kinematics):
        self.kinematics = kinematics
        self.model = kinematics.model
        self.definition = self.model.definition
        self._touching = {}
        self._of_bodies = {}
        self._forces = {}
        self.own = None  # (name, which): the law that is being read, and of which gap
        self.gates = {key: self.model.gates[k] for k, key in enumerate(gates(self.definition))}

    def is_held(self, name):
        """Whether there is a gate of each of its gaps."""
        return (name, 0) in self.gates

    def gaps(self, name):
        """The gaps and where they are."""
        if name not in self._touching:
            contact = find(self.definition, name)
            if contact["kind"] == "between":
                gaps, points, _ = self._between(contact["first"], contact["second"])
                self._touching[name] = gaps, points or [point for point, _ in self.spots(name)]
            elif contact["kind"] == "gap":
                self._touching[name] = [evaluate(contact["expression"], self.kinematics)], None
            else:
                x = self.kinematics.name(contact["quantity"]["name"])
                low, high = (expressions.in_unit(contact[end], contact["unit"], self.model) for end in ("from", "to"))
                self._touching[name] = [ca.if_else(x - low < high - x, x - low, high - x)], None
        return self._touching[name]

    def spots(self, name):
        """Where the surfaces of a contact touch: points, and normals to the side of the first of the pair."""
        contact = find(self.definition, name)
        one, other = self._ordered(contact["first"], contact["second"])
        if one["kind"] == other["kind"] == "capsule":
            _, [point], _ = self._bars(one, other)
            foot = self._feet(one, other)
            return [(point, (foot[0] - foot[1]) / length(foot[0] - foot[1]))]
        if one["kind"] not in ROUND:
            normal = self._flat(other)[1]
            return [(point, normal) for point in self._pair(one, other)[1]]
        # The gap grows along the normal where the round surface moves, whatever the other is.
        center, radius = ca.SX.sym("center", self.model.dimension), self._size(one, "radius", ca.SX(0))
        gap = self._round(center, one, other)[0][0]
        normal = ca.gradient(gap, center)
        point = center - normal * (radius + gap / 2)
        return [tuple(ca.substitute([point, normal], [center], [self._at(one)]))]

    def sliding(self, name):
        """Velocities of the first surface against the second where they touch, of the material there, and normals."""
        contact = find(self.definition, name)
        if contact["kind"] == "gap":
            return [(self.kinematics.rate(entry(contact["slip"], self.kinematics)), None)]
        one, other = self._ordered(contact["first"], contact["second"])
        order = 1 if one is self._surface(contact["first"]) else -1
        places = self._place(one), self._place(other)
        found = []
        for point, normal in self.spots(name):
            here, there = (self._material(place, point) for place in places)
            # Both turn round with the order.
            found.append((order * (here - there), order * normal))
        return found

    def _material(self, place, point):
        """Of what is fixed to the body of a place, or to the section of a beam, and is just there."""
        if place.body is not None and self.model.bodies[place.body].particle:
            return self.kinematics.rate(self.kinematics.position(place))
        axes = self._axes(place)
        at = self.kinematics.position(place)
        fixed = ca.SX.sym("fixed", self.model.dimension)
        velocity = self.kinematics.rate(at + ca.mtimes(axes, fixed))
        velocity = ca.substitute(velocity, fixed, ca.mtimes(axes.T, point - at))
        if self.model.dimension == 2:
            # Axes in the plane are those of the body; the section of a beam turns beyond it.
            x, y = ca.vertsplit(point - at)
            velocity += self.kinematics.slope(place, of_rates=True) * ca.vertcat(-y, x)
        return velocity

    def forces(self, name):
        if name not in self._forces:
            contact, gaps = find(self.definition, name), self.gaps(name)[0]
            keys = [(name, which) for which in range(len(gaps))]
            if is_rigid(contact):
                self._forces[name] = [self.gates[key] for key in keys]
            elif self.is_held(name):
                self._forces[name] = [ca.if_else(self.gates[key] > 0.5, law, 0) for key, law in zip(keys, self.laws(name))]
            else:
                pushed = zip(gaps, self.laws(name))
                pulls = bool(contact["law"].get("adhesion"))
                self._forces[name] = [ca.if_else(gap < 0, law if pulls else ca.if_else(law > 0, law, 0), 0) for gap, law in pushed]
        return self._forces[name]

    def laws(self, name):
        """What the law says of each gap, whether it is closed or not; nothing of a rigid contact."""
        contact, found = find(self.definition, name), []
        for which, gap in enumerate(self.gaps(name)[0]):
            outer, self.own = self.own, (name, which)
            found.append(ca.SX(0) if is_rigid(contact) else self._law(contact["law"], gap, name))
            self.own = outer
        return found

    def adheres(self, name):
        return bool(find(self.definition, name)["law"].get("adhesion"))

    def pressing(self, name):
        """Positive where a closed gap stays closed: what adheres parts by its gap alone."""
        return [ca.SX(1) if self.adheres(name) else found for found in self.laws(name)]

    def closed(self, name):
        """Whether surfaces touch, at each gap."""
        gaps = self.gaps(name)[0]
        return [self.gates[name, which] > 0.5 if self.is_held(name) else gap < 0 for which, gap in enumerate(gaps)]

    def slidings(self, name):
        """Of a dry friction how fast the surfaces slide at each gap, along the normal turned clockwise, in space along the axes of the world, or
        in its joint."""
        load = next(load for load in self.definition["loads"] if load["name"] == name)
        if not find(self.definition, load["on"]):
            along = [way for group, _ in friction.slips(load, self.kinematics) for way in group]
            return [factor * rate for rate, factor in along if not factor.is_zero()]
        if axes(self.definition, find(self.definition, load["on"])) == 1:
            return [along_surface(velocity, normal) for velocity, normal in self.sliding(load["on"])]
        return [x for velocity, normal in self.sliding(load["on"]) for x in ca.vertsplit(beside(velocity, normal))]

    def bent(self, name):
        """The derivatives of these at v̇ = 0, in space without what is along the normal."""
        bent = self.kinematics.rate(ca.vertcat(*self.slidings(name)))
        load = next(load for load in self.definition["loads"] if load["name"] == name)
        contact = find(self.definition, load["on"])
        if not contact or axes(self.definition, contact) == 1:
            return ca.vertsplit(bent)
        normals = [normal for _, normal in self.sliding(load["on"])]
        return [x for k, normal in enumerate(normals) for x in ca.vertsplit(beside(bent[3 * k : 3 * k + 3], normal))]

    def restitutions(self, name):
        law = find(self.definition, name)["law"]
        share = entry(law["restitution"], self.model)
        if not law.get("rest"):
            return [share] * len(self.gaps(name)[0])
        rest = entry(law["rest"], self.model)
        return [ca.if_else(share * self.kinematics.rate(gap) > -rest, 0, share) for gap in self.gaps(name)[0]]

    def quantity(self, name, what):
        gaps, points = self.gaps(name)
        if self.own and self.own[0] == name:
            gaps = [gaps[self.own[1]]]
        least = gaps[0]
        for gap in gaps[1:]:
            least = ca.if_else(gap < least, gap, least)
        if what == "gap":
            return least
        if what == "depth":
            return ca.if_else(least < 0, -least, 0)
        if what == "closing":
            return -self.kinematics.rate(least)
        if what == "force":
            return sum(self.forces(name), ca.SX(0))
        if what.partition(".")[0] == "sliding":
            along = []
            for velocity, normal in self.sliding(name):
                if normal is None:
                    along.append(velocity)
                elif what == "sliding":
                    along.append(normal[1] * velocity[0] - normal[0] * velocity[1])
                else:
                    along.append(beside(velocity, normal))
            if self.own and self.own[0] == name:
                along = [along[self.own[1]]]
            axis, points = self.kinematics.axes.index(what[-1]) if "." in what else 0, along
        else:
            axis = self.kinematics.axes.index(what.removeprefix("point."))
            if self.own and self.own[0] == name:
                points = [points[self.own[1]]]
        least, point = gaps[0], points[0]
        for gap, other in zip(gaps[1:], points[1:]):
            point = ca.if_else(gap < least, other, point)
            least = ca.if_else(gap < least, gap, least)
        return point[axis]

    # Laws.

    def _law(self, law, gap, name):
        kind, rate = law["kind"], -self.kinematics.rate(gap)
        depth = ca.if_else(gap < 0, -gap, 0)
        on = -gap if self.is_held(name) else depth  # of what is linear

        def given(key, default=0.0):
            return entry(law[key], self.model) if law.get(key) else ca.SX(default)

        if kind == "expression":
            return evaluate(law["value"], self.kinematics)
        if kind == "kelvin_voigt":
            share = ca.if_else(rate > 0, 1, given("release", 1.0))
            return given("stiffness") * on + given("damping") * share * rate
        if kind == "hunt_crossley":
            exponent = float(given("exponent", 1.5))
            elastic = given("force") * _power((on if exponent == 1 else depth) / given("depth"), exponent)
        elif kind == "hertz":
            elastic = self._hertz(law, name) * _power(depth, 1.5)
        elif kind == "hertz_line":
            elastic = self._line(law, name, depth)
        else:
            raise ValueError(f"`{name}` has the unknown law `{kind}`")
        loss = given("dissipation")
        if law.get("restitution"):
            word = law["damping"]["value"]["name"].rpartition(".")[2] if law.get("damping") else "exact"
            loss = dissipation(float(given("restitution")), word) / self._impact_speed(law, given, name)
        factor = 1 + loss * rate
        return elastic * (factor if self.is_held(name) or law.get("adhesion") else ca.if_else(factor > 0, factor, 0))

    def _impact_speed(self, law, given, name):
        """As stated, or that of the touch that lasts, but not less than the slowest that counts."""
        kept = self.model.values.get(f"{name}.speed")
        if kept is None:
            return given("speed")
        slowest = given("slowest", SLOWEST)
        return ca.if_else(kept > slowest, kept, slowest)

    def _hertz(self, law, name):
        contact = find(self.definition, name)
        radius = self._between(contact["first"], contact["second"])[2]
        return 4 * ca.sqrt(radius) / (3 * self._compliance(law))

    def _line(self, law, name, depth):
        """F of d = F/(π E l) (ln(4 π E l ΔR/F) − 1), up to d = 4 ΔR/e³ and from there along the tangent. F = π E l d/s, s − ln s = ln(4 ΔR/d) − 1,
        which s ← ln(4 ΔR/d) − 1 + ln s approaches by a third at each pass at least."""
        contact = find(self.definition, name)
        one, other = self._ordered(contact["first"], contact["second"])
        radii = self._size(other, "radius") + self._size(one, "radius") * (-1 if other["kind"] == "hole" else 1)
        stiffness = math.pi * entry(law["length"], self.model) / self._compliance(law)
        most, least = 4 * radii * math.exp(-3), 1e-12 * radii
        within = ca.if_else(depth < most, ca.if_else(depth > least, depth, least), most)
        eta, last = ca.log(4 * radii / within) - 1, 2.0
        s = eta
        for _ in range(40):
            s, last = eta + ca.log(s), 2 + math.log(last)
        return stiffness * ca.if_else(depth < most, depth / s, most / last + (depth - most) / (last - 1))

    def _compliance(self, law):
        compliance = ca.SX(0)
        for which in ("first", "second"):
            wanted = law[which]["value"]["name"]
            material = next(material for material in self.definition["materials"] if material["name"] == wanted)
            compliance += (1 - entry(material["poisson"], self.model) ** 2) / entry(material["modulus"], self.model)
        return compliance

    # Surfaces.

    def _surface(self, name):
        for surface in self.definition.get("surfaces", []):
            if surface["name"] == name:
                return surface
        body, _, own = name.rpartition(".")
        if name in self._of_bodies:
            return self._of_bodies[name]
        written = next(node for node in self.definition["bodies"] if node["name"] == body)
        if own != "surface":
            raise ValueError(f"no surface `{name}`")
        surface = {"kind": "circle", "places": [{"place": f"{body}.center"}], "radius": written["properties"]["radius"]}
        self._of_bodies[name] = surface
        return surface

    def _place(self, surface, which=0):
        if "line" in surface:
            return self.model.line(surface["line"]).origin
        return self.model.place(surface["places"][which])

    def _at(self, surface, which=0):
        return self.kinematics.position(self._place(surface, which))

    def _turned(self, place, vector):
        axes = getattr(self.kinematics, "place_axes", None)
        return ca.mtimes(axes(place), vector) if axes else self.kinematics.pose(place.body).turn(vector)

    def _axes(self, place):
        """Of what is fixed to it, as columns."""
        return ca.horzcat(*[self._turned(place, ca.DM.eye(self.model.dimension)[:, k]) for k in range(self.model.dimension)])

    def _size(self, surface, key, default=None):
        return entry(surface[key], self.model) if surface.get(key) else default

    def _axis(self, surface):
        """World axes."""
        axis = expressions.pair(surface["axis"], self.model) if surface.get("axis") else ca.DM([0, 0, 1])
        return self._turned(self._place(surface), axis / ca.sqrt(ca.dot(axis, axis)))

    def _between(self, first, second):
        """Gaps, places, and the radius of both curvatures."""
        return self._pair(*self._ordered(first, second))

    def _ordered(self, first, second):
        for one, other in ((first, second), (second, first)):
            if self._pair(self._surface(one), self._surface(other)):
                return self._surface(one), self._surface(other)
        raise ValueError(f"no gap between `{first}` and `{second}`")

    def _pair(self, one, other):
        kind, against = one["kind"], other["kind"]
        if kind in ROUND:
            return self._round(self._at(one), one, other)
        if kind == against == "capsule":
            return self._bars(one, other)
        if against in ("half_plane", "plane") and kind in ("segment", "capsule", "polygon"):
            foot, normal = self._flat(other)
            radius = self._size(one, "radius", ca.SX(0))
            ends = [self._at(one, which) for which in range(len(one["places"]))]
            gaps = [ca.dot(normal, end - foot) - radius for end in ends]
            return gaps, [end - normal * (radius + gap / 2) for end, gap in zip(ends, gaps)], None
        if against == "plane" and kind == "disk_rim":
            foot, normal = self._flat(other)
            center, axis, radius = self._at(one), self._axis(one), self._size(one, "radius")
            # The steepest way down within the disk.
            down = -(normal - ca.dot(normal, axis) * axis)
            lowest = center + radius * down / length(down)
            gap = ca.dot(normal, lowest - foot)
            return [gap], [lowest - normal * gap / 2], None
        return None

    def _round(self, center, one, other):
        against, radius = other["kind"], self._size(one, "radius", ca.SX(0))
        if against in ("half_plane", "plane"):
            foot, normal = self._flat(other)
            gap = ca.dot(normal, center - foot) - radius
            return [gap], [center - normal * (radius + gap / 2)], radius
        if against in ROUND:
            return self._balls(center, radius, self._at(other), self._size(other, "radius", ca.SX(0)))
        if against in ("hole", "ball_socket"):
            middle, hole = self._at(other), self._size(other, "radius")
            out = center - middle
            gap = hole - radius - length(out)
            point = middle + out / length(out) * (hole - gap / 2)
            return [gap], [point], hole * radius / (hole - radius)
        if against in ("segment", "capsule"):
            own, (at, ends) = self._size(other, "radius", ca.SX(0)), self._within(center, other)
            out = at - nearest(at, *ends)
            gap = length(out) - radius - own
            out = self._turned(self._place(other), out)
            return [gap], [center - out / length(out) * (radius + gap / 2)], None
        if against == "polygon":
            return [self._polygon(center, other) - radius], None, None
        if against == "profile":
            return [self._profile(center, other) - radius], None, None
        if against in ("cylinder", "bore"):
            return [self._about(center, radius, other)], None, None
        return None

    def _flat(self, surface):
        """A place of it and the normal that points to what is free."""
        if surface["kind"] == "plane":
            return self._at(surface), self._axis(surface)
        line = self.model.line(surface["line"])
        side = -1 if surface.get("side") and surface["side"]["value"]["name"].rpartition(".")[2] == "right" else 1
        along = self.kinematics.pose(line.origin.body).turn(line.axis)
        return self.kinematics.position(line.origin), side * ca.vertcat(-along[1], along[0])

    def _balls(self, center, radius, other, own):
        out = center - other
        gap = length(out) - radius - own
        return [gap], [other + out / length(out) * (own + gap / 2)], radius * own / (radius + own)

    def _bars(self, one, other):
        a, b = self._feet(one, other)
        radii = [self._size(surface, "radius", ca.SX(0)) for surface in (one, other)]
        gap = length(a - b) - radii[0] - radii[1]
        return [gap], [b + (a - b) / length(a - b) * (radii[1] + gap / 2)], None

    def _feet(self, one, other):
        """The nearest points of two bars, in world axes: free ones of the whole lines, then each nearest to the other within its ends."""
        ends = [[self._at(surface, which) for which in (0, 1)] for surface in (one, other)]
        (p, u), (q, v) = [(start, (end - start) / length(end - start)) for start, end in ends]
        long = [length(end - start) for start, end in ends]

        def within(x, most):
            return ca.if_else(x < 0, 0, ca.if_else(x > most, most, x))

        cosine = ca.dot(u, v)
        sine = 1 - cosine**2
        sine = ca.if_else(sine > PARALLEL, sine, PARALLEL)
        free = within(ca.dot(q - p, u - cosine * v) / sine, long[0])
        there = q + v * within(ca.dot(p + u * free - q, v), long[1])
        return p + u * within(ca.dot(there - p, u), long[0]), there

    def _within(self, center, surface):
        """A place and those of a surface from the first of these, along the axes of its body: terms that turn cancel before they count."""
        places = [self._place(surface, which) for which in range(len(surface["places"]))]
        axes, first = self._axes(places[0]), self.kinematics.position(places[0])
        if self.model.dimension == 2:
            own = [place.local - places[0].local for place in places]
        else:
            own = [ca.mtimes(axes.T, self.kinematics.position(place) - first) for place in places]
        return ca.mtimes(axes.T, center - first), own

    def _polygon(self, center, surface):
        """Inside the way to the nearest edge, outside the distance to the nearest point of any edge."""
        center, corners = self._within(center, surface)
        inside, outside = None, None
        for start, end in zip(corners, corners[1:] + corners[:1]):
            along = (end - start) / length(end - start)
            way = ca.dot(ca.vertcat(along[1], -along[0]), center - start)
            inside = way if inside is None else ca.if_else(way > inside, way, inside)
            far = length(center - nearest(center, start, end))
            outside = far if outside is None else ca.if_else(far < outside, far, outside)
        return ca.if_else(inside > 0, outside, inside)

    def _profile(self, center, surface):
        place = self._place(surface)
        at = ca.mtimes(self._axes(place).T, center - self.kinematics.position(place))
        table = self.model.tables[surface["radius"]["value"]["name"]]
        passes = int(float(self._size(surface, "refine", REFINED)))
        return out_of_curve(at, table, self._size(surface, "base", ca.SX(0)), passes)

    def _about(self, center, radius, surface):
        axis, own, whole = self._axis(surface), self._size(surface, "radius"), self._size(surface, "length")
        out = center - self._at(surface)
        along = ca.dot(axis, out)
        across = length(out - along * axis)
        if surface["kind"] == "bore":
            gap = own - radius - across
            return gap if whole is None else ca.if_else(ca.fabs(along) <= whole / 2, gap, ca.fabs(gap))
        side = across - own
        if whole is None:
            return side - radius
        end = ca.fabs(along) - whole / 2
        beside, beyond = ca.if_else(side > 0, side, 0), ca.if_else(end > 0, end, 0)
        nearer = ca.if_else(side > end, side, end)
        return ca.if_else(nearer > 0, length(ca.vertcat(beside, beyond)), nearer) - radius


def out_of_curve(at, table, own, passes):
    """How far out of the curve (own + table(φ)) e_r(φ) a place is. |p − c(φ)| is least at the foot φ, which Newton's method finds by derivatives of
    |p − c(φ)|², the second kept from zero. There it is taken as given: with n and t of the curve there and its curvature κ the distance is
    d = n·(p − c) + κ/(1 + κ d) (t·(p − p₀))²/2 and what is of third order in p − p₀, so that its first two derivatives are those of the distance."""
    angle, point, base = ca.SX.sym("angle"), ca.SX.sym("point", 2), ca.SX.sym("base")
    curve = (base + table(angle)) * ca.vertcat(ca.cos(angle), ca.sin(angle))
    slope = ca.gradient(ca.sumsqr(point - curve) / 2, angle)
    along = ca.jacobian(curve, angle)
    steep, least = ca.jacobian(slope, angle), ca.sumsqr(along) / 4
    step, bent = slope / ca.if_else(steep > least, steep, least), ca.jacobian(along, angle)
    size = length(along)
    foot = ca.atan2(at[1], at[0])
    for _ in range(passes):
        # Passes make errors smaller, and not larger as their operations would have it.
        foot = given(foot - ca.substitute(step, ca.vertcat(angle, point, base), ca.vertcat(foot, at, own)))
    foot = given(foot)
    known = [curve, along / size, (along[0] * bent[1] - along[1] * bent[0]) / size**3]
    curve, t, curvature = (given(part) for part in ca.substitute(known, [angle, base], [foot, own]))
    out, aside = ca.dot(ca.vertcat(t[1], -t[0]), at - curve), ca.dot(t, at - curve)
    return out + given(curvature / (1 + curvature * given(out))) * (aside - given(aside)) ** 2 / 2


def length(vector):
    square = ca.dot(vector, vector)
    return ca.sqrt(ca.if_else(square > TINY, square, TINY))


def given(x):
    """Of what is taken as given: it has no derivatives and is as exact as it is."""
    return ca.floor(x * FINE) / FINE


def nearest(point, start, end):
    """On the way from start to end."""
    span = end - start
    share = ca.dot(point - start, span) / ca.dot(span, span)
    return start + ca.if_else(share < 0, 0, ca.if_else(share > 1, 1, share)) * span


def _power(base, exponent):
    if exponent == int(exponent):
        return base ** int(exponent)
    return ca.if_else(base > 1e-12, base, 1e-12) ** exponent


def dissipation(e, word):
    """b v of a restitution: x − ln(1 + x) = −e x − ln(1 − e x), both ways without other forces."""
    if word == "lankarani_nikravesh":
        return 3 * (1 - e**2) / 4
    if word == "hunt_crossley":
        return 3 * (1 - e) / 2
    if word == "flores":
        return 8 * (1 - e) / (5 * e)
    if e >= 1:
        return 0.0
    low, high = 0.0, 1 / e
    for _ in range(200):
        x = (low + high) / 2
        if x in (low, high):
            break
        low, high = (x, high) if (1 + e) * x - math.log1p(x) + math.log1p(-e * x) > 0 else (low, x)
    return (low + high) / 2
