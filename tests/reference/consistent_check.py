"""Consistent states compared: motions of bodies, residuals, the system K z = b, reactions, drivers, power balance."""

import numpy as np

from comparison import BACKWARD, CONDITION, RESIDUAL, SET_ASIDE
from consistent import AbsoluteSystem, System
from entries import column, compare_energies, compare_vector, read_states
from motion import PLANE


REST = 1e-5  # of the fastest velocity, and of a metre or a radian


class ConsistentCheck:
    motion = PLANE
    system_of = AbsoluteSystem
    background = 0.0

    def __init__(self, comparison, model, absolute, own, states):
        self.comparison, self.model, self.own, self.raw = comparison, model, own, states
        self.states = read_states(model, own, states)
        self.system = self.system_of(absolute)
        n, bodies, joints = own.kinematics.v.numel(), len(model.bodies), len(model.joints)
        self.acceleration = column(states, "acceleration", n)
        self.own_multipliers = column(states, "lambda", len(own.rows))
        self.given_bodies = column(states, "bodies", bodies, self.motion.size)
        self.reactions = column(states, "reactions", joints, len(self.motion.wrench))
        self.couplings = column(states, "multipliers", len(absolute.rows) - self.system.first_coupling)
        self.efforts = column(states, "driver_efforts", self.system.drivers)
        self.driver_powers = column(states, "driver_powers", self.system.drivers)
        self.powers = column(states, "powers", len(absolute.loads))

        self.bodies, self.body_scale = own.bodies(self.states, self.acceleration)
        angles = own.layout.angle_values(self.states["q"])
        placed = self.bodies.copy()
        accelerations = list(self.motion.groups["accelerations"])
        placed[:, :, accelerations] = self.given_bodies[:, :, accelerations]
        if model.normals.numel():
            self.states["normals"] = self.system.pressing(self.states, placed, angles, self.reactions)
        # The reference's own view of the same states.
        self.quantities = own.evaluate(self.states)
        self.absolute, self.v, self.a = self.system_state(placed, angles)
        self.multipliers, self.leftover = self.system.multipliers(self.absolute, self.reactions, self.couplings)
        self.absolute_equations, self.own_equations = (
            System(quantities, self.keeps_redundant(), self.background)
            for quantities in (self.absolute, self.quantities)
        )
        self.condition = self.absolute_equations.conditions()
        self.kept = self.condition <= CONDITION

    def system_state(self, placed, angles):
        modes = self.own.layout.mode_values(self.states["q"], self.states["v"], self.acceleration)
        return self.system.evaluate(self.states, placed, angles, modes)

    def keeps_redundant(self):
        """Whether rows that others imply stay in the system: λ is then one of many."""
        return self.model.definition["options"].get("redundant") == "keep"

    def run(self, line):
        compare_energies(self.comparison, self.own, self.raw, self.quantities)
        compare_vector(self.comparison, self.own, self.raw, self.quantities, "internal_rates")
        self.compare_bodies()
        self.compare_residuals("own", self.quantities, self.states["v"])
        self.compare_residuals("absolute", self.absolute, self.v)
        self.compare_systems()
        self.compare_reactions()
        self.compare_drivers()
        self.compare_balance()
        self.compare_further()
        aside = int((~self.kept).sum())
        line["set_aside"] = aside
        finite = self.condition[np.isfinite(self.condition)]
        line["condition"] = [float(finite.min()), float(finite.max())] if finite.size else None
        if aside > SET_ASIDE * len(self.kept):
            self.comparison.fail("condition", f"{aside} of {len(self.kept)} states are above {CONDITION:g}")

    def compare_bodies(self):
        rigid = [not body.particle for body in self.model.bodies.values()]
        names, motion = list(self.model.bodies), self.motion
        for quantity, entries in motion.groups.items():
            chosen = [(body, k) for body in range(len(names)) for k in entries]
            chosen = [(body, k) for body, k in chosen if rigid[body] or k not in motion.angular]
            at = (slice(None), [body for body, _ in chosen], [k for _, k in chosen])
            self.comparison.terms(
                quantity,
                self.given_bodies[at],
                self.bodies[at],
                self.body_scale[at],
                lambda j, chosen=chosen: f"{motion.entries[chosen[j][1]]} of '{names[chosen[j][0]]}'",
            )

    def compare_residuals(self, which, quantities, v):
        """Φ and D v − ν of the states themselves: they must be consistent."""
        rows = self.own.rows if which == "own" else self.system.equations.rows
        jacobian, terms = quantities["jacobian"]
        nu, nu_terms = quantities["nu"]
        speed = np.einsum("sij,sj->si", jacobian, v)
        speed_terms = np.einsum("sij,sj->si", terms, np.abs(v)) + nu_terms
        # Where all that a row feels is at rest, its rate is rounding of the others' velocities.
        fastest = np.abs(v).max(axis=1, keepdims=True, initial=0.0)
        speed_terms = np.maximum(speed_terms, REST * terms.sum(axis=2) * fastest)
        # A row without terms at these positions still feels their rounding, through D.
        phi, phi_terms = quantities["phi"]
        phi_terms = np.maximum(phi_terms, REST * terms.sum(axis=2))
        zero, name = np.zeros(phi.shape), lambda k: f"row '{rows[k]}'"
        self.comparison.terms(f"residual_{which}", phi, zero, phi_terms, name, RESIDUAL)
        self.comparison.terms(f"residual_rate_{which}", speed, nu, speed_terms, name, RESIDUAL)

    def compare_systems(self):
        solution = np.hstack([self.a, self.multipliers])
        # λ stems from reactions there: sums of what bodies need, of beams with accelerations of fast modes that cancel in them.
        bends = any(getattr(body, "beam", None) is not None for body in self.model.bodies.values())
        self._compare_system("kkt", self.absolute_equations, solution, 10 * BACKWARD if bends else BACKWARD)
        self._compare_system("kkt_own", self.own_equations, np.hstack([self.acceleration, self.own_multipliers]))

    def _compare_system(self, quantity, system, solution, limit=BACKWARD):
        plain, scaled = system.backward_errors(solution)
        before = len(self.comparison.failures)
        self.comparison.errors(quantity, plain[self.kept], limit, "backward error of [v̇; λ]")
        self.comparison.errors(f"{quantity}_scaled", scaled[self.kept], limit, "backward error after scaling")
        if len(self.comparison.failures) > before:
            self._name_worst_row(quantity, system, solution)

    def _name_worst_row(self, quantity, system, solution):
        """Where the residual of the equilibrated system is largest."""
        worst = (0.0, None)
        for chunk, k in system.matrices(system.scaling):
            z = solution[chunk] / system.scaling
            residual = np.abs(np.einsum("sij,sj->si", k, z) - system.scaling * system.right[chunk])
            residual[~self.kept[chunk]] = 0.0
            at = np.unravel_index(np.argmax(residual), residual.shape)
            if residual[at] > worst[0]:
                worst = (residual[at], (chunk.start + int(at[0]), int(at[1])))
        if worst[1] is None:
            return
        state, row = worst[1]
        own = quantity == "kkt_own"
        columns = self.own.column_names if own else self.system.kinematics.velocity_names()
        rows = self.own.rows if own else self.system.equations.rows
        equation = f"momentum of '{columns[row]}'" if row < len(columns) else f"row '{rows[row - len(columns)]}'"
        exact = system.solve()[state]
        names = [f"acceleration of '{column}'" for column in columns] + [f"λ of '{of}'" for of in rows]
        difference = np.abs(exact - solution[state]) / system.scaling
        k = int(np.nanargmax(difference)) if np.any(np.isfinite(difference)) else 0
        self.comparison.fail(
            quantity,
            f"largest residual in {equation} (state {state}); most different there: {names[k]}: "
            f"compiler {float(solution[state, k])!r}, reference {float(exact[k])!r}",
        )

    def compare_reactions(self):
        """Joints transmit only what their rows can; rows in this coordinate set carry the same λ."""
        joints, wrench = list(self.model.joints), self.motion.wrench
        forces = np.abs(np.einsum("sij,sj->si", self.absolute["mass"][0], self.a)).max(axis=1, initial=0.0)
        scale = np.maximum(forces, np.abs(self.reactions).max(axis=(1, 2), initial=0.0))
        scale = np.maximum(scale, self.absolute["forces"][1].max(axis=1, initial=0.0))
        flat = (len(scale), -1)
        leftover = self.leftover.reshape(flat)
        self.comparison.terms(
            "reactions",
            leftover,
            np.zeros(leftover.shape),
            np.broadcast_to(scale[:, None], leftover.shape),
            lambda k: f"what joint '{joints[k // len(wrench)]}' cannot transmit ({wrench[k % len(wrench)]})",
            RESIDUAL,
        )
        order = {str(row): k for k, row in enumerate(self.system.equations.rows)}
        expected = self.multipliers[:, [order[str(row)] for row in self.own.rows]]
        largest = np.abs(expected).max(axis=1, keepdims=True, initial=0.0)
        largest = np.maximum(largest, 1e-3 * self.background * scale[:, None])
        self.comparison.terms(
            "multipliers",
            self.own_multipliers[self.kept],
            expected[self.kept],
            np.broadcast_to(largest, expected.shape)[self.kept],
            self.own.entry_name("phi"),
            RESIDUAL,
        )

    def compare_drivers(self):
        """Effort −λ of the driver's row, power effort · rate of the driven quantity."""
        drivers = self.model.definition["drivers"]
        start = len(self.system.equations.rows) - len(drivers)
        effort = -self.multipliers[:, start:]
        rate, rate_terms = self.absolute["driver_rates"]
        scale = np.abs(effort)
        self.comparison.terms("driver_efforts", self.efforts, effort, scale, lambda k: drivers[k]["name"])
        power, power_terms = effort * rate, scale * rate_terms
        # The compiler may take the rate from the law instead: as far as the state is consistent.
        self.comparison.terms(
            "driver_powers", self.driver_powers, power, power_terms, lambda k: drivers[k]["name"], RESIDUAL
        )

    def compare_balance(self):
        """d/dt(T + V) against the power of loads and drivers, and of what moves by itself (places, laws)."""
        value = {name: part[0] for name, part in self.absolute.items()}
        terms = {name: part[1] for name, part in self.absolute.items()}
        change = np.einsum("si,si->s", value["momentum"], self.a) + value["energy_drift"][:, 0]
        loads = (self.powers - value["elastic_powers"]).sum(axis=1) + value["modal_power"][:, 0]
        passive = slice(0, value["nu"].shape[1] - self.system.drivers)
        moved = -np.einsum("si,si->s", self.multipliers[:, passive], value["nu"][:, passive])
        moved += value["energy_explicit"][:, 0] - value["support_powers"].sum(axis=1)
        supplied = loads + self.driver_powers.sum(axis=1) + moved
        scale = np.einsum("si,si->s", terms["momentum"], np.abs(self.a)) + terms["energy_drift"][:, 0]
        scale += terms["powers"].sum(axis=1) + terms["elastic_powers"].sum(axis=1)
        through = np.einsum("sij,sj->si", terms["jacobian"], np.abs(self.v)) + terms["nu"]
        scale += np.einsum("si,si->s", np.abs(self.multipliers), through)
        scale += 1e-3 * self.background * terms["kinetic"][:, 0] * np.abs(self.v).max(axis=1, initial=0.0)
        self.comparison.terms(
            "power_balance",
            supplied[self.kept, None],
            change[self.kept, None],
            scale[self.kept, None],
            lambda _: "power supplied against d/dt(T + V)",
            RESIDUAL,
        )

    def compare_further(self):
        """What only some kinds have."""
