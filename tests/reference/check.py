"""Compares what the compiler computed with an independent derivation from each model's DEFINITION.

    python check.py DIRECTORY [--summary FILE] [--record DIRECTORY --states K]

DIRECTORY holds one request `NAME.COORDINATES.json` per model and coordinate set: the definition, the exported
coordinates, and states with the compiler's values (see README.md). One line is printed per request; the exit code is
1 where anything disagrees, 2 where there was nothing to compare. Everything is in SI.
"""

import argparse
import json
import sys
import time
from pathlib import Path

import numpy as np

import reference
from comparison import BACKWARD, CONDITION, RESIDUAL, SET_ASIDE, Comparison, numbers
from consistent import AbsoluteSystem, System
from coordinate_set import MATRICES, SCALARS, VECTORS, CoordinateSet
from definition import Model
from record import consistent_records, random_records, write_record


def main(arguments=None):
    options = read_options(arguments)
    files = sorted(path for path in options.directory.glob("*.json") if options.only in path.name)
    summary = [check_file(path, options) for path in files]
    if options.summary:
        options.summary.write_text(json.dumps(summary, indent=1))
    failures = [failure for line in summary for failure in line["failures"]]
    for failure in failures:
        print(failure)
    if not files:
        print(f"no requests in {options.directory}: nothing was compared")
        return 2
    bad = sum(1 for line in summary if line["failures"])
    states = sum(line["random"] + line["consistent"] for line in summary)
    verdict = f"{bad} of {len(files)} disagree" if bad else "all agree"
    print(f"{len(files)} requests, {states} states: {verdict}")
    return 1 if failures else 0


def read_options(arguments):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("directory", type=Path, help="where the requests are")
    parser.add_argument("--summary", type=Path, help="file for the results as JSON")
    parser.add_argument("--record", type=Path, help="directory for the reference's own values")
    parser.add_argument("--states", type=int, default=2, help="how many states of each kind to record")
    parser.add_argument("--only", default="", help="only requests whose file name contains this")
    parser.add_argument("--minimum", type=int, default=1, help="random and consistent states each must have")
    return parser.parse_args(arguments)


def check_file(path, options):
    began = time.monotonic()
    line = {"request": path.stem, "random": 0, "consistent": 0, "set_aside": 0, "condition": None}
    comparison = Comparison(path.stem)
    try:
        request = json.loads(path.read_text())
        check_request(request, comparison, line, options)
    except (ValueError, KeyError, TypeError, IndexError, NotImplementedError, RuntimeError) as error:
        comparison.fail("request", f"{type(error).__name__}: {error}")
    for kind in ("random", "consistent"):
        if line[kind] < options.minimum:
            comparison.fail(kind, f"{line[kind]} states, expected at least {options.minimum}")
    line |= {"worst": comparison.worst, "failures": comparison.failures, "seconds": time.monotonic() - began}
    print_line(line)
    return line


def print_line(line):
    worst = " ".join(f"{name} {error:.1e}" for name, error in line["worst"].items())
    condition = "-" if line["condition"] is None else "{:.1e}..{:.1e}".format(*line["condition"])
    states = f"{line['random']} random, {line['consistent']} consistent, {line['set_aside']} set aside"
    verdict = "DISAGREES" if line["failures"] else "agrees"
    print(f"{line['request']}: {verdict} | {worst} | {states} | condition {condition} | {line['seconds']:.1f} s")
    sys.stdout.flush()


def check_request(request, comparison, line, options):
    if request.get("parameters_are_si") is not True:
        raise ValueError("parameters must be in SI")
    model = Model(request["definition"])
    absolute = reference.derive(model)
    own = CoordinateSet(model, absolute, request["coordinates"])
    records = {"random": [], "consistent": []}
    if request["random"]:
        line["random"] = len(request["random"])
        states = read_states(model, own, request["random"])
        quantities = own.evaluate(states)
        compare_random(comparison, own, request["random"], quantities)
        if options.record:
            records["random"] = random_records(states, quantities, options.states)
    if request["consistent"]:
        line["consistent"] = len(request["consistent"])
        check = ConsistentCheck(comparison, model, absolute, own, request["consistent"])
        check.run(line)
        if options.record:
            records["consistent"] = consistent_records(check, options.states)
    if options.record:
        write_record(options.record / f"{line['request']}.json", request, own, records)


def read_states(model, own, states):
    """What a state is given by, as arrays (states, size)."""
    sizes = {
        "parameters": model.p.numel(),
        "time": 1,
        "inputs": model.u.numel(),
        "phases": model.phases.numel(),
        "q": own.kinematics.q.numel(),
        "v": own.kinematics.v.numel(),
    }
    return {name: column(states, name, size) for name, size in sizes.items()}


def column(states, name, *shape):
    """One entry of all states as an array (states, …)."""
    try:
        return numbers([state[name] for state in states], (len(states), *shape))
    except ValueError as error:
        raise ValueError(f"`{name}` should have {shape} entries in every state") from error


# Random states: entry by entry.


def compare_random(comparison, own, states, quantities):
    compare_energies(comparison, own, states, quantities)
    for name in VECTORS:
        if name != "powers":
            value, scale = quantities[name]
            comparison.terms(name, column(states, name, value.shape[1]), value, scale, own.entry_name(name))
    for name in MATRICES:
        compare_matrix(comparison, own, name, [state[name] for state in states], quantities[name])


def compare_energies(comparison, own, states, quantities):
    for name in SCALARS:
        value, scale = quantities[name]
        comparison.terms(name, column(states, name, 1), value, scale, own.entry_name(name))
    value, scale = quantities["powers"]
    comparison.terms("powers", column(states, "powers", value.shape[1]), value, scale, own.entry_name("powers"))


def compare_matrix(comparison, own, name, triplets, quantity):
    """Entries of a sparse matrix; a missing entry is a zero, an entry without terms is measured by its row."""
    value, scale = quantity
    dense = np.zeros(value.shape)
    for state, entries in enumerate(triplets):
        entries = numbers(entries, (-1, 3))
        rows, columns = entries[:, 0].astype(int), entries[:, 1].astype(int)
        if len(entries) and (rows.max() >= value.shape[1] or columns.max() >= value.shape[2]):
            comparison.fail(name, f"an entry outside of {value.shape[1]} × {value.shape[2]}")
            return
        dense[state, rows, columns] = entries[:, 2]
        if name == "mass":
            dense[state, columns, rows] = entries[:, 2]
    # Only entries that are there on one of the sides.
    there = np.any((dense != 0.0) | (scale != 0.0), axis=0)
    scale = np.where(scale == 0.0, scale.max(axis=2, keepdims=True, initial=0.0), scale)
    if name == "mass":
        there &= np.tri(len(there), dtype=bool)
    rows, columns = np.nonzero(there)
    comparison.terms(
        name,
        dense[:, rows, columns],
        value[:, rows, columns],
        scale[:, rows, columns],
        lambda k: own.pair_name(name, rows[k], columns[k]),
    )


# Consistent states: accelerations, reactions, powers.


class ConsistentCheck:
    def __init__(self, comparison, model, absolute, own, states):
        self.comparison, self.model, self.own, self.raw = comparison, model, own, states
        self.states = read_states(model, own, states)
        self.system = AbsoluteSystem(absolute)
        n, bodies, joints = own.kinematics.v.numel(), len(model.bodies), len(model.joints)
        self.acceleration = column(states, "acceleration", n)
        self.own_multipliers = column(states, "lambda", len(own.rows))
        self.given_bodies = column(states, "bodies", bodies, 10)
        self.reactions = column(states, "reactions", joints, 3)
        self.couplings = column(states, "multipliers", len(absolute.rows) - self.system.first_coupling)
        self.efforts = column(states, "driver_efforts", self.system.drivers)
        self.driver_powers = column(states, "driver_powers", self.system.drivers)
        self.powers = column(states, "powers", len(absolute.loads))

        # The reference's own view of the same states.
        self.quantities = own.evaluate(self.states)
        self.bodies, self.body_scale = own.bodies(self.states, self.acceleration)
        angles = own.layout.angle_values(self.states["q"])
        placed = self.bodies.copy()
        placed[:, :, 7:] = self.given_bodies[:, :, 7:]
        self.absolute, self.v, self.a = self.system.evaluate(self.states, placed, angles)
        self.multipliers, self.leftover = self.system.multipliers(self.absolute, self.reactions, self.couplings)
        self.absolute_equations, self.own_equations = System(self.absolute), System(self.quantities)
        self.condition = self.absolute_equations.conditions()
        self.kept = self.condition <= CONDITION

    def run(self, line):
        compare_energies(self.comparison, self.own, self.raw, self.quantities)
        self.compare_bodies()
        self.compare_residuals("own", self.quantities, self.states["v"])
        self.compare_residuals("absolute", self.absolute, self.v)
        self.compare_systems()
        self.compare_reactions()
        self.compare_drivers()
        self.compare_balance()
        aside = int((~self.kept).sum())
        line["set_aside"] = aside
        finite = self.condition[np.isfinite(self.condition)]
        line["condition"] = [float(finite.min()), float(finite.max())] if finite.size else None
        if aside > SET_ASIDE * len(self.kept):
            self.comparison.fail("condition", f"{aside} of {len(self.kept)} states are above {CONDITION:g}")

    def compare_bodies(self):
        rigid = [not body.particle for body in self.model.bodies.values()]
        names = ("x", "y", "cos θ", "sin θ", "v_x", "v_y", "ω", "a_x", "a_y", "α")
        for quantity, entries in (("poses", range(0, 4)), ("velocities", range(4, 7)), ("accelerations", range(7, 10))):
            chosen = [(body, k) for body in range(len(rigid)) for k in entries if rigid[body] or k not in (2, 3, 6, 9)]
            at = (slice(None), [body for body, _ in chosen], [k for _, k in chosen])
            self.comparison.terms(
                quantity,
                self.given_bodies[at],
                self.bodies[at],
                self.body_scale[at],
                lambda j, chosen=chosen: f"{names[chosen[j][1]]} of '{list(self.model.bodies)[chosen[j][0]]}'",
            )

    def compare_residuals(self, which, quantities, v):
        """Φ and D v − ν of the states themselves: they must be consistent."""
        rows = self.own.rows if which == "own" else self.system.equations.rows
        jacobian, terms = quantities["jacobian"]
        nu, nu_terms = quantities["nu"]
        speed = np.einsum("sij,sj->si", jacobian, v)
        speed_terms = np.einsum("sij,sj->si", terms, np.abs(v)) + nu_terms
        phi, phi_terms = quantities["phi"]
        zero, name = np.zeros(phi.shape), lambda k: f"row '{rows[k]}'"
        self.comparison.terms(f"residual_{which}", phi, zero, phi_terms, name, RESIDUAL)
        self.comparison.terms(f"residual_rate_{which}", speed, nu, speed_terms, name, RESIDUAL)

    def compare_systems(self):
        solution = np.hstack([self.a, self.multipliers])
        self._compare_system("kkt", self.absolute_equations, solution)
        self._compare_system("kkt_own", self.own_equations, np.hstack([self.acceleration, self.own_multipliers]))

    def _compare_system(self, quantity, system, solution):
        plain, scaled = system.backward_errors(solution)
        before = len(self.comparison.failures)
        self.comparison.errors(quantity, plain[self.kept], BACKWARD, "backward error of [v̇; λ]")
        self.comparison.errors(f"{quantity}_scaled", scaled[self.kept], BACKWARD, "backward error after scaling")
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
        joints = list(self.model.joints)
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
            lambda k: f"what joint '{joints[k // 3]}' cannot transmit ({'xyτ'[k % 3]})",
            RESIDUAL,
        )
        order = {str(row): k for k, row in enumerate(self.system.equations.rows)}
        expected = self.multipliers[:, [order[str(row)] for row in self.own.rows]]
        largest = np.abs(expected).max(axis=1, keepdims=True, initial=0.0)
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
        loads = (self.powers - value["elastic_powers"]).sum(axis=1)
        passive = slice(0, value["nu"].shape[1] - self.system.drivers)
        moved = -np.einsum("si,si->s", self.multipliers[:, passive], value["nu"][:, passive])
        moved += value["energy_explicit"][:, 0] - value["support_powers"].sum(axis=1)
        supplied = loads + self.driver_powers.sum(axis=1) + moved
        scale = np.einsum("si,si->s", terms["momentum"], np.abs(self.a)) + terms["energy_drift"][:, 0]
        scale += terms["powers"].sum(axis=1) + terms["elastic_powers"].sum(axis=1)
        through = np.einsum("sij,sj->si", terms["jacobian"], np.abs(self.v)) + terms["nu"]
        scale += np.einsum("si,si->s", np.abs(self.multipliers), through)
        self.comparison.terms(
            "power_balance",
            supplied[self.kept, None],
            change[self.kept, None],
            scale[self.kept, None],
            lambda _: "power supplied against d/dt(T + V)",
            RESIDUAL,
        )


if __name__ == "__main__":
    sys.exit(main())
