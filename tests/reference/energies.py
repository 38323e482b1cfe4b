"""Equations of motion from energies and virtual work, all derivatives by automatic differentiation.

    M v̇ + Dᵀ λ = Q,   D v = ν,   D v̇ = γ.

With π the coordinates of which v are the rates (lengths and angles; orientations commute in the plane, so these
exist) and a position Φ(π, t) of the rows:
    D = ∂Φ̇/∂v,   ν = −∂Φ/∂t,   γ = −dΦ̇/dt at v̇ = 0,
    M = ∂²T/∂v²,  Q = Σ_loads (∂w/∂v)ᵀ f − ∂V/∂π − (d/dt(∂T/∂v) at v̇ = 0) + ∂T/∂π,
where a load is a force f on a rate w. (Lagrange's equations, e.g. Goldstein, Classical Mechanics, ch. 1.4 and 2.4.)
"""

from dataclasses import dataclass, field

import casadi as ca

import cables
import contacts
import expressions
import friction
import gears
import hysteresis
import memories
import meshes
import penalties
from expressions import evaluate


@dataclass
class Load:
    """f acts on the rate w; `elastic` is what the potential V stands for beside it; V counts `stored`, too, whose force is in f."""

    name: str
    w: ca.SX
    explicit: ca.SX  # the part of w that is there at v = 0: of places that move by themselves
    f: ca.SX
    elastic: ca.SX
    stored: ca.SX = field(default_factory=lambda: ca.SX(0))

    def power(self):
        return ca.dot(self.f + self.elastic, self.w)

    def power_of_stores(self, kinematics):
        """The part of the power that V gives back."""
        return ca.dot(self.elastic, self.w) - kinematics.rate(self.stored)


class Energies:
    """Derives the equations of one `Kinematics`; each attribute is an expression of (p, t, u, phases, q, v)."""

    def __init__(self, kinematics):
        self.kinematics = kinematics
        self.model = kinematics.model
        kinematics.energies = self
        self._loads = {}
        self._under_way = set()
        self.direction = ca.SX.sym("direction", kinematics.v.numel())

        self.kinetic = self._kinetic()
        self.acting = self._potential()
        self.loads = [self.load(name) for name in contacts.all_loads(self.model.definition)]
        self.potential = sum((load.stored for load in self.loads), self.acting)
        self.powers = ca.vertcat(*[load.power() for load in self.loads])

        declared = [state for state in self.model.states if state["name"] in self.model.rates]
        rates = [evaluate(self.model.rates[state["name"]], kinematics) for state in declared]
        rates += [rate for load in self.model.definition["loads"] for rate in self._inner_rates(load)]
        self.internal_rates = ca.vertcat(*rates) if rates else ca.SX(0, 1)
        starts = [expressions.entry(state, self.model) for state in self.model.states]
        self.internal_starts = ca.vertcat(*starts) if starts else ca.SX(0, 1)

        self._touching()

        v = kinematics.v
        self.momentum = ca.gradient(self.kinetic, v)
        self.mass = ca.jacobian(self.momentum, v)
        damping, self.modal_power = self._modal_damping()
        self.forces = self._applied() + self._inertial() + damping

        self.rows = kinematics.rows()
        self.phi = ca.vertcat(*[row.value for row in self.rows])
        if self.rows:
            drift = kinematics.explicit_rate(self.phi)
            phi_rate = ca.jtimes(self.phi, kinematics.q, kinematics.q_rate(v)) + drift
            self.jacobian = ca.jacobian(phi_rate, v)
            self.nu = -drift
            self.gamma = -kinematics.rate(phi_rate)
        else:
            self.phi = self.nu = self.gamma = ca.SX(0, 1)
            self.jacobian = ca.SX(0, v.numel())

    def _touching(self):
        """Of gates that are held the gaps and the laws without them; of rigid contacts ġ, g̈ at v̇ = 0, and the restitution. Dry friction has in
        the place of the first three nothing and of the last three the sliding, its derivative at v̇ = 0, and nothing."""
        touching, kinematics, definition = self.kinematics.contacts, self.kinematics, self.model.definition
        names = list(dict.fromkeys(name for name, _ in touching.gates))
        dry = [name for name in names if not contacts.find(definition, name)]
        rigid = dry + [name for name in names if name not in dry and contacts.is_rigid(contacts.find(definition, name))]

        def all_of(names, of, of_dry):
            found = [value for name in names for value in (of_dry if name in dry else of)(name)]
            return ca.vertcat(*found) if found else ca.SX(0, 1)

        def nothing(name):
            return [ca.SX(0)] * len(touching.slidings(name))

        self.gaps = all_of(names, lambda name: touching.gaps(name)[0], nothing)
        self.laws = all_of(names, touching.pressing, nothing)
        self.assignments = ca.SX(0, 1)
        if self.model.events or self.model.memories:
            gaps, forces = memories.guards(self.model, kinematics)
            self.gaps, self.laws = ca.vertcat(self.gaps, gaps), ca.vertcat(self.laws, forces)
            self.assignments = memories.assignments(self.model, kinematics)

        def rates_of(name):
            return ca.vertsplit(kinematics.rate(ca.vertcat(*touching.gaps(name)[0])))

        self.gap_rates = all_of(rigid, rates_of, touching.slidings)
        self.gap_biases = all_of(rigid, lambda name: ca.vertsplit(kinematics.rate(ca.vertcat(*rates_of(name)))), touching.bent)
        self.restitutions = all_of(rigid, touching.restitutions, nothing)
        speeds, jumps = memories.jumping(self.model, kinematics)
        # Of events their derivatives are not asked for.
        if rigid:
            first = len(touching.gates)
            rest = ca.SX.zeros(self.model.gates.numel() - first)
            self.gap_rates = ca.vertcat(self.gap_rates, speeds[first:] if jumps.numel() else rest)
            self.gap_biases = ca.vertcat(self.gap_biases, rest)
            self.restitutions = ca.vertcat(self.restitutions, jumps[first:] if jumps.numel() else rest)
        elif jumps.numel():
            self.gap_rates, self.gap_biases, self.restitutions = speeds, ca.SX.zeros(jumps.numel()), jumps

    def _slope(self, value):
        """∂(value)/∂π."""
        along = ca.jtimes(value, self.kinematics.q, self.kinematics.q_rate(self.direction))
        return ca.gradient(along, self.direction)

    def _inertial(self):
        """∂T/∂π − (d/dt(∂T/∂v) at v̇ = 0)."""
        return self._slope(self.kinetic) - self.kinematics.rate(self.momentum)

    def _kinetic(self):
        bodies, poses = self.model.bodies, self.kinematics.poses
        rates = self.kinematics.rate(ca.vertcat(*[c for name in bodies for c in (poses[name].x, poses[name].y)]))
        energy = ca.SX(0)
        for index, (name, body) in enumerate(bodies.items()):
            if body.beam is not None:
                for x, share in body.beam.slices():
                    rate = self.kinematics.rate(self._slice(name, x))
                    energy += share * body.mass * ca.dot(rate, rate) / 2
                if body.beam.thick:
                    energy += body.beam.turning_energy(poses[name].omega, self.kinematics.modes[name][1], body.mass)
                continue
            vx, vy = rates[2 * index], rates[2 * index + 1]
            energy += body.mass * (vx**2 + vy**2) / 2 + body.inertia * poses[name].omega ** 2 / 2
        return energy

    def _slice(self, name, x):
        """World coordinates of the axis of a beam at x."""
        kinematics = self.kinematics
        pose, beam = kinematics.poses[name], self.model.bodies[name].beam
        return pose.position + pose.turn(beam.deformed(x, kinematics.modes[name][0]))

    def _modal_damping(self):
        """Forces −c ṗ on the modes, as forces on v, and the power they take."""
        rates, forces = [], []
        for name, body in self.model.bodies.items():
            if getattr(body, "beam", None) is not None:
                own = self.kinematics.modes[name][1]
                rates += own
                forces += body.beam.modal_forces(own, body.mass)
        if not rates:
            return ca.SX.zeros(self.kinematics.v.numel()), ca.SX(0)
        rates, forces = ca.vertcat(*rates), ca.vertcat(*forces)
        return ca.jtimes(rates, self.kinematics.v, forces, True), ca.dot(rates, forces)

    def _potential(self):
        energy = ca.SX(0)
        for name, body in self.model.bodies.items():
            pose = self.kinematics.poses[name]
            if getattr(body, "beam", None) is not None:
                for x, share in body.beam.slices():
                    energy -= share * body.mass * ca.dot(self.model.gravity, self._slice(name, x))
                energy += body.beam.elastic_energy(self.kinematics.modes[name][0])
                continue
            energy -= body.mass * ca.dot(self.model.gravity, pose.position)
        for load in self.model.definition["loads"]:
            if load["kind"] in (*hysteresis.KINDS, *friction.KINDS, "cable"):
                continue
            if load["kind"] == "mesh":
                continue
            if load["kind"] == "shaft":
                stiffness, beyond, _ = self._shaft(load)
                energy += stiffness * beyond**2 / 2
                continue
            if load["kind"] == "bushing":
                deflection, stiffness, _ = self._bushing(load)
                energy += ca.dot(stiffness, deflection**2) / 2
            elif load.get("stiffness"):
                stiffness, deflection = self._spring(load)
                energy += stiffness * deflection**2 / 2
        for joint in penalties.written(self.model.definition):
            energy += penalties.Penalty(joint, self.kinematics).energy()
        return energy

    def _spring(self, load):
        """Stiffness and deflection of a spring between places or about a rotor."""
        kinematics = self.kinematics
        stiffness = expressions.entry(load["stiffness"], self.model)
        rest = load.get("length") if load["kind"] == "spring" else load.get("angle")
        rest = expressions.entry(rest, self.model) if rest else ca.SX(0)
        if load["kind"] == "spring":
            return stiffness, kinematics.distance(load["first"], load["second"]) - rest
        return stiffness, kinematics.multi_turn(load["on"]) - rest

    def _shaft(self, load):
        """Stiffness, what of θ1 − r θ2 is beyond half the gap on either side, and the rate."""
        kinematics, given = self.kinematics, lambda key: expressions.entry(load[key], self.model) if load.get(key) else ca.SX(0)
        ratio, half = given("ratio"), given("backlash") / 2
        twist = kinematics.multi_turn(load["first"]) - ratio * kinematics.multi_turn(load["second"])
        beyond = ca.if_else(twist > half, twist - half, ca.if_else(twist < -half, twist + half, 0)) if load.get("backlash") else twist
        return given("stiffness"), beyond, kinematics.rotor_rate(load["first"]) - ratio * kinematics.rotor_rate(load["second"])

    def shaft_torque(self, name):
        load = next(load for load in self.model.definition["loads"] if load["name"] == name)
        stiffness, beyond, w = self._shaft(load)
        damping = expressions.entry(load["damping"], self.model) if load.get("damping") else ca.SX(0)
        return stiffness * beyond + damping * w

    def _bushing(self, load):
        """What a bushing is moved and turned by, along the first place's axes; its stiffness and damping along each."""
        first, second = self.model.place(load["first"]), self.model.place(load["second"])
        deflection = ca.vertcat(*self.kinematics.displacement(first, second))
        along, about = (part.numel() for part in self.kinematics.displacement(first, second))

        def each(key, torsional_key):
            return ca.vertcat(self._each(load.get(key), along), self._each(load.get(torsional_key), about))

        return deflection, each("stiffness", "torsional_stiffness"), each("damping", "torsional_damping")

    def _each(self, node, count):
        """One value for each axis: as written, the same for all, or nothing."""
        if not node:
            return ca.SX.zeros(count)
        if isinstance(node["value"], list):
            return expressions.pair(node, self.model)
        return ca.repmat(ca.SX(expressions.entry(node, self.model)), count)

    def _applied(self):
        w = ca.vertcat(*[load.w for load in self.loads])
        f = ca.vertcat(*[load.f for load in self.loads])
        work = ca.jtimes(w, self.kinematics.v, f, True) if self.loads else ca.SX.zeros(self.kinematics.v.numel())
        return work - self._slope(self.acting)

    # Loads by name; a law may name the power of another load.

    def load(self, name):
        if name in self._under_way:
            raise ValueError(f"{self.model.title}: the load `{name}` depends on its own power")
        if name not in self._loads:
            self._under_way.add(name)
            touching, yielding = contacts.find(self.model.definition, name), penalties.find(self.model.definition, name)
            if yielding:
                self._loads[name] = self._penalty(yielding)
                self._under_way.remove(name)
                return self._loads[name]
            written = touching or next(x for x in self.model.definition["loads"] if x["name"] == name)
            self._loads[name] = self._contact(written) if touching else self._derive_load(written)
            self._under_way.remove(name)
        return self._loads[name]

    def resistance(self, name):
        return self._hysteresis(next(x for x in self.model.definition["loads"] if x["name"] == name))[0]

    def _hysteresis(self, load):
        """What a load resists with, and the rates of its states."""
        if load["kind"] not in hysteresis.KINDS:
            return ca.SX(0), []
        way = evaluate(load["expression"], self.kinematics)
        return hysteresis.law(load, self.model, way, self.kinematics.rate(way))

    def _inner_rates(self, load):
        return self._hysteresis(load)[1] or friction.inner_rates(load, self.kinematics)

    def power(self, name):
        return self.load(name).power()

    def energy(self, which):
        kinetic, potential = self.kinetic, self.potential
        return {"kinetic_energy": kinetic, "potential_energy": potential, "energy": kinetic + potential}[which]

    def _contact(self, contact):
        kinematics, name = self.kinematics, contact["name"]
        gaps = ca.vertcat(*kinematics.contacts.gaps(name)[0])
        forces = ca.vertcat(*kinematics.contacts.forces(name))
        return Load(name, kinematics.rate(gaps), kinematics.explicit_rate(gaps), forces, ca.SX.zeros(gaps.numel()))

    def _penalty(self, joint):
        kinematics, penalty = self.kinematics, penalties.Penalty(joint, self.kinematics)
        w, explicit = kinematics.rate(penalty.deflection), kinematics.explicit_rate(penalty.deflection)
        return Load(joint["name"], w, explicit, penalty.lost(w), penalty.elastic())

    def _derive_load(self, load):
        kinematics, name, kind = self.kinematics, load["name"], load["kind"]
        if kind == "force":
            point = kinematics.position(self.model.place(load["place"]))
            force = self._force(load)
            explicit = kinematics.explicit_rate(point)
            return Load(name, kinematics.rate(point), explicit, force, ca.SX.zeros(self.model.dimension))
        if kind == "torque" and load.get("components"):
            return Load(name, kinematics.spin(load["on"]), ca.SX.zeros(3), self._force(load), ca.SX.zeros(3))
        if kind == "torque":
            torque = evaluate(load["value"], kinematics)
            return Load(name, kinematics.rotor_rate(load["on"]), ca.SX(0), torque, ca.SX(0))
        if kind == "push":
            travel = kinematics.travel(self.model.joints[load["on"]])
            pushed = evaluate(load["value"], kinematics)
            return Load(name, kinematics.rate(travel), kinematics.explicit_rate(travel), pushed, ca.SX(0))
        if kind == "along":
            along = evaluate(load["expression"], kinematics)
            pushed = evaluate(load["value"], kinematics)
            return Load(name, kinematics.rate(along), kinematics.explicit_rate(along), pushed, ca.SX(0))
        if kind in hysteresis.KINDS:
            way = evaluate(load["expression"], kinematics)
            resisted = -self._hysteresis(load)[0]
            return Load(name, kinematics.rate(way), kinematics.explicit_rate(way), resisted, ca.SX(0))
        if kind in friction.KINDS:
            rates, acting = friction.efforts(load, kinematics)
            drift = ca.substitute(rates, kinematics.v, ca.SX.zeros(*kinematics.v.shape))
            return Load(name, rates, drift, acting, ca.SX.zeros(rates.numel()))
        if kind == "cable":
            # What changes the cable's own length with time alone is no motion of the mechanism.
            run, own = cables.length(load, kinematics), cables.own_length(load, kinematics)
            by_time = kinematics.explicit_rate(run)
            w = kinematics.rate(run) - kinematics.rate(own) + kinematics.explicit_rate(own)
            return Load(name, w, by_time, -cables.tension(load, kinematics), ca.SX(0))
        if kind == "shaft":
            stiffness, beyond, w = self._shaft(load)
            damping = expressions.entry(load["damping"], self.model) if load.get("damping") else ca.SX(0)
            return Load(name, w, ca.SX(0), -damping * w, -stiffness * beyond)
        if kind == "mesh":
            mesh = meshes.mesh(load, kinematics)
            w, efforts = mesh.rates(), mesh.efforts()
            explicit = ca.substitute(w, kinematics.v, ca.SX.zeros(*kinematics.v.shape)) if gears.axes_move(load) else ca.SX.zeros(w.numel())
            return Load(name, w, explicit, efforts, ca.SX.zeros(w.numel()), mesh.stored())
        if kind == "bushing":
            deflection, stiffness, damping = self._bushing(load)
            w, explicit = kinematics.rate(deflection), kinematics.explicit_rate(deflection)
            return Load(name, w, explicit, -damping * w, -stiffness * deflection)
        if kind == "spring":
            length = kinematics.distance(load["first"], load["second"])
            w, explicit = kinematics.rate(length), kinematics.explicit_rate(length)
        elif kind == "torsion_spring":
            w, explicit = kinematics.rotor_rate(load["on"]), ca.SX(0)
        else:
            raise ValueError(f"{self.model.title}: load `{name}` is of the unknown kind `{kind}`")
        elastic = ca.SX(0)
        if load.get("stiffness"):
            stiffness, deflection = self._spring(load)
            elastic = -stiffness * deflection
        damping = expressions.entry(load["damping"], self.model) if load.get("damping") else ca.SX(0)
        return Load(name, w, explicit, -damping * w, elastic)

    def _force(self, load):
        """World axes."""
        if load.get("components"):
            return ca.vertcat(*[evaluate(component, self.kinematics) for component in load["components"]])
        direction = ca.vertcat(*[evaluate(component, self.kinematics) for component in load["direction"]])
        value = evaluate(load["value"], self.kinematics)
        return value * direction / ca.sqrt(ca.dot(direction, direction))
