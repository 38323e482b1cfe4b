"""Tests of the reference itself: `python -m unittest` in this directory.

Identities (differences, projection of absolute equations on the tree, energy), a model derived by hand, and changed
values that must be noticed.
"""

import contextlib
import copy
import io
import json
import math
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

import check
import expressions
import generate
import hand_four_bar
import mechanisms
import reference
import units
from consistent import AbsoluteSystem, System
from coordinate_set import CoordinateSet
from definition import Model
from mechanisms import call, name, number, op
from sensitivity import Sensitivity

HERE = Path(__file__).parent


def sets(make):
    """(model, coordinate set, tree, start) for both coordinate sets of a mechanism."""
    definition, tree, absolute, start = make()
    model = Model(definition)
    equations = reference.derive(model)
    for coordinates in (tree, absolute):
        yield model, CoordinateSet(model, equations, coordinates), tree, start


def run_check(*requests, arguments=()):
    """Exit code, printed text and summary of the check of these requests."""
    with tempfile.TemporaryDirectory() as directory:
        for request in requests:
            title, kind = request["definition"]["name"], request["coordinates"]["coordinates"]
            (Path(directory) / f"{title}.{kind}.json").write_text(json.dumps(request))
        summary = Path(directory) / "summary.txt"
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            code = check.main([directory, "--summary", str(summary), *arguments])
        return code, printed.getvalue(), json.loads(summary.read_text())


class Units(unittest.TestCase):
    def test_factors(self):
        cases = {
            "1": 1, "kg*m^2/s^2": 1, "mm": 1e-3, "N*s/mm": 1e3, "1/s": 1, "rpm": math.pi / 30, "g": 1e-3, "min": 60,
            "kg*mm^2": 1e-6, "deg": math.pi / 180, "cm^-1": 100, "kN/(m*s)": 1e3, "µm": 1e-6, "bar": 1e5,
            "t/h": 1 / 3.6, "MPa": 1e6, "m^(1/2)": 1, None: 1,
        }  # fmt: skip
        for unit, factor in cases.items():
            self.assertAlmostEqual(units.factor(unit) / factor, 1, delta=1e-15, msg=unit)

    def test_unknown(self):
        for unit in ("furlong", "m**2", "(m", "kdeg", "m^", ""):
            with self.assertRaises((ValueError, IndexError), msg=unit):
                units.factor(unit)


class Expressions(unittest.TestCase):
    def value(self, node, unit=None):
        definition = mechanisms.definition("Empty", [], [], constants=[{"name": "A", "unit": "mm", "value": number(7)}])
        return float(expressions.in_unit(node, unit, Model(definition)))

    def test_bare_numbers_take_the_unit_of_the_entry(self):
        self.assertEqual(self.value(op("/", number(3), number(2)), "mm"), 1.5e-3)
        self.assertAlmostEqual(self.value(op("/", name("pi"), number(2)), "deg"), math.pi * math.pi / 360)

    def test_others_do_not(self):
        self.assertEqual(self.value(name("A"), "mm"), 7e-3)
        self.assertEqual(self.value(op("*", number(2), name("A")), "mm"), 14e-3)
        self.assertEqual(self.value(number("0.5", "m"), "mm"), 0.5)
        self.assertEqual(self.value({"value": op("+", number(1), number(1)), "unit": "cm"}, "mm"), 2e-2)

    def test_operations(self):
        self.assertEqual(self.value(op("^", number(2), op("neg", number(3)))), 1 / 8)
        self.assertEqual(self.value(call("if", op("<", number(2), number(1)), number(5), number(6))), 6)
        self.assertEqual(self.value(op("-", call("max", number(2), number(9)), call("abs", op("neg", number(4))))), 5)
        self.assertAlmostEqual(self.value(call("atan2", number(1), op("neg", number(1)))), 3 * math.pi / 4)

    def test_doubtful_pair_is_refused(self):
        definition = mechanisms.definition("Empty", [], [], constants=[{"name": "A", "unit": "mm", "value": number(7)}])
        with self.assertRaises(ValueError):
            expressions.pair(mechanisms.pair(name("A"), 3, "mm"), Model(definition))


class Identities(unittest.TestCase):
    def test_rows_against_differences(self):
        """Φ̇ = D v − ν, and d/dt(D v − ν) = −γ at v̇ = 0."""
        for make in mechanisms.ALL:
            for model, own, _, _ in sets(make):
                states = generate.draw(np.random.default_rng(5), own, 12)
                here = own.evaluate(states)
                speed = self.row_rates(own, states)
                step = 1e-5
                ahead, behind = (self.moved(own, states, sign * step) for sign in (1, -1))
                rate = (own.evaluate(ahead)["phi"][0] - own.evaluate(behind)["phi"][0]) / (2 * step)
                second = (self.row_rates(own, ahead) - self.row_rates(own, behind)) / (2 * step)
                with self.subTest(model=model.title):
                    scale = 1 + np.abs(here["phi"][1])
                    np.testing.assert_array_less(np.abs(rate - speed) / scale, 1e-6)
                    scale = 1 + here["gamma"][1]
                    np.testing.assert_array_less(np.abs(second + here["gamma"][0]) / scale, 1e-6)

    def row_rates(self, own, states):
        quantities = own.evaluate(states)
        return np.einsum("sij,sj->si", quantities["jacobian"][0], states["v"]) - quantities["nu"][0]

    def moved(self, own, states, step):
        layout = own.layout
        n, r = len(layout.linear), len(layout.rotations)
        q, v = states["q"].copy(), states["v"]
        q[:, :n] += step * v[:, :n]
        for k in range(r):
            angle = np.arctan2(q[:, n + 2 * k + 1], q[:, n + 2 * k]) + step * v[:, n + k]
            q[:, n + 2 * k], q[:, n + 2 * k + 1] = np.cos(angle), np.sin(angle)
        for k, angle in enumerate(layout.angles):
            for index, weight in angle["rate"]:
                q[:, n + 2 * r + 2 * k + 1] += weight * step * v[:, index]
        return states | {"q": q, "time": states["time"] + step}

    def test_tree_is_the_projection_of_the_absolute_equations(self):
        """With v_abs = J v + …:  M_tree = Jᵀ M J,  Q_tree = Jᵀ (Q − M b), b the accelerations at v̇ = 0."""
        for make in mechanisms.ALL:
            model, own, _, _ = next(sets(make))
            states = generate.draw(np.random.default_rng(6), own, 10)
            n = states["v"].shape[1]
            zero = np.zeros(states["v"].shape)
            bodies, _ = own.bodies(states, zero)
            system = AbsoluteSystem(reference.derive(model))
            parts, _, bias = system.evaluate(states, bodies, own.layout.angle_values(states["q"]))
            columns = []
            for k in range(n):
                unit = zero.copy()
                unit[:, k] = 1.0
                moved, _ = own.bodies(states, unit)
                columns.append(system.kinematics.from_bodies(moved, own.layout.angle_values(states["q"]))[2] - bias)
            jacobian = np.stack(columns, axis=2)
            mass, forces = parts["mass"][0], parts["forces"][0]
            expected = np.einsum("sik,sij,sjl->skl", jacobian, mass, jacobian)
            rest = forces - np.einsum("sij,sj->si", mass, bias)
            tree = own.evaluate(states)
            with self.subTest(model=model.title):
                np.testing.assert_allclose(tree["mass"][0], expected, atol=1e-12, rtol=1e-11)
                np.testing.assert_allclose(
                    tree["forces"][0], np.einsum("sik,si->sk", jacobian, rest), atol=1e-10, rtol=1e-10
                )

    def test_kinetic_energy_is_a_quadratic_form_where_nothing_moves_by_itself(self):
        for make in (mechanisms.double_pendulum, mechanisms.four_bar, mechanisms.gear_pair):
            for _, own, _, _ in sets(make):
                states = generate.draw(np.random.default_rng(7), own, 10)
                parts = own.evaluate(states)
                form = np.einsum("si,sij,sj->s", states["v"], parts["mass"][0], states["v"]) / 2
                np.testing.assert_allclose(parts["kinetic"][0][:, 0], form, rtol=1e-13)

    def test_absolute_set_written_as_a_forest(self):
        """The tree's way of placing bodies, with all of them free, gives the absolute equations."""
        for make in mechanisms.ALL:
            definition, _, absolute, _ = make()
            model = Model(definition)
            equations = reference.derive(model)
            forest = CoordinateSet(model, equations, absolute | {"coordinates": "tree"})
            own = CoordinateSet(model, equations, absolute)
            states = generate.draw(np.random.default_rng(8), own, 10)
            one, other = own.evaluate(states), forest.evaluate(states)
            for quantity in one:
                value, scale = one[quantity]
                close = np.abs(value - other[quantity][0]) <= 1e-14 * scale
                self.assertTrue(close.all(), msg=(model.title, quantity))


class Sensitivities(unittest.TestCase):
    def test_against_differences_in_random_directions(self):
        for make in mechanisms.ALL:
            model, own, _, _ = next(sets(make))
            rng = np.random.default_rng(9)
            states = generate.draw(rng, own, 6)
            n, parameters = states["v"].shape[1], states["parameters"]
            sizes = (n, n, states["inputs"].shape[1], parameters.shape[1])
            by_q, by_v, by_u, by_p = (rng.normal(size=(6, size)) for size in sizes)
            by_p *= 0.1 * parameters

            def solution(step):
                along = Identities().moved(own, states | {"v": by_q}, step)
                moved = states | {"q": along["q"], "v": states["v"] + step * by_v}
                moved |= {"inputs": states["inputs"] + step * by_u, "parameters": parameters + step * by_p}
                return System(own.evaluate(moved)).solve()

            slopes = [(solution(h) - solution(-h)) / (2 * h) for h in (2e-4, 1e-4)]
            expected, here = (4 * slopes[1] - slopes[0]) / 3, solution(0.0)
            found = Sensitivity(own)(states, here[:, :n], here[:, n:])
            found = np.einsum("sij,sj->si", found, np.hstack([by_q, by_v, by_u, by_p]))
            with self.subTest(model=model.title):
                regular = System(own.evaluate(states)).conditions() < 1e4
                self.assertTrue(regular.any())
                scale = 1 + np.abs(expected).max(axis=1, keepdims=True)
                np.testing.assert_array_less((np.abs(found - expected) / scale)[regular], 1e-6)


class Requests(unittest.TestCase):
    def requests(self, make):
        definition, tree, absolute, start = make()
        return [generate.generate(definition, coordinates, tree, start) for coordinates in (tree, absolute)]

    def test_own_values_agree(self):
        """Includes what `generate` does not solve for: tree results in the absolute system, and the power balance."""
        for make in (*mechanisms.ALL, lambda: mechanisms.ladder(3)):
            code, printed, summary = run_check(*self.requests(make))
            self.assertEqual(code, 0, msg=printed)
            for line in summary:
                self.assertEqual((line["random"], line["consistent"], line["set_aside"]), (20, 20, 0))
                self.assertIn("kkt_scaled", line["worst"])
                self.assertIn("power_balance", line["worst"])

    def test_derived_by_hand(self):
        definition, tree, _, _ = mechanisms.four_bar()
        code, printed, _ = run_check(hand_four_bar.request(definition, tree))
        self.assertEqual(code, 0, msg=printed)

    def test_wrong_signs_by_hand_are_noticed(self):
        definition, tree, _, _ = mechanisms.four_bar()
        right = hand_four_bar.request(definition, tree)
        random = {name: (name, 0) for name in ("phi", "gamma", "forces")}
        for quantity, (key, k) in random.items():
            wrong = copy.deepcopy(right)
            wrong["random"][7][key][k] *= -1
            self.assert_noticed(wrong, quantity)
        for quantity in ("jacobian", "mass"):
            wrong = copy.deepcopy(right)
            wrong["random"][3][quantity][1][2] *= -1
            self.assert_noticed(wrong, quantity)
        for quantity in ("kinetic", "potential"):
            wrong = copy.deepcopy(right)
            wrong["random"][2][quantity] *= -1
            self.assert_noticed(wrong, quantity)
        for key, quantity in (
            ("acceleration", "kkt_own"),
            ("lambda", "kkt_own"),
            ("bodies", "kkt"),
            ("reactions", "kkt"),
        ):
            wrong = copy.deepcopy(right)
            target = wrong["consistent"][5][key]
            if key == "bodies":
                target[1][9] *= -1
            elif key == "reactions":
                target[1][0] *= -1
            else:
                target[0] *= -1
            self.assert_noticed(wrong, quantity)

    def test_small_errors_everywhere_are_noticed(self):
        """1e-9 of every entry that is compared, in turn, in a model that has them all."""
        for make in (mechanisms.slider_crank, mechanisms.gear_pair):
            for right in self.requests(make):
                for kind, keys in COMPARED.items():
                    for key in keys:
                        wrong = copy.deepcopy(right)
                        if self.disturb(wrong[kind][4], key):
                            code, _, _ = run_check(wrong)
                            self.assertEqual(code, 1, msg=(right["definition"]["name"], kind, key))

    def disturb(self, state, key):
        """Changes the largest entry; whether there was one."""
        values = np.array(state[key], float)
        if values.size == 0:
            return False
        if key in ("jacobian", "mass"):
            k = int(np.argmax(np.abs(values[:, 2])))
            state[key][k][2] *= 1 + 1e-9
            return True
        at = np.unravel_index(np.argmax(np.abs(values)), values.shape) if values.shape else ()
        values[at] = values[at] * (1 + 1e-6) + 1e-6 if key in IDENTITIES else values[at] * (1 + 1e-9)
        changed = values.tolist()
        different = changed != state[key]
        state[key] = changed
        return different

    def test_not_numbers_are_noticed(self):
        definition, tree, _, _ = mechanisms.four_bar()
        request = hand_four_bar.request(definition, tree)
        request["random"][0]["phi"][0] = None
        self.assert_noticed(request, "phi")

    def test_malformed_requests_are_noticed(self):
        definition, tree, _, _ = mechanisms.four_bar()
        request = hand_four_bar.request(definition, tree)
        for change, what in (
            (lambda r: r["random"][0].pop("gamma"), "gamma"),
            (lambda r: r["coordinates"]["rows"].pop(), "rows exported"),
            (lambda r: r["coordinates"]["tree"].pop(), "spanning tree"),
            (lambda r: r["random"].clear(), "0 states"),
            (lambda r: r["consistent"][1]["reactions"].pop(), "reactions"),
        ):
            wrong = copy.deepcopy(request)
            change(wrong)
            code, printed, _ = run_check(wrong)
            self.assertEqual(code, 1)
            self.assertIn(what, printed)

    def test_nothing_to_compare_is_no_success(self):
        code, printed, _ = run_check()
        self.assertEqual(code, 2)
        self.assertIn("nothing was compared", printed)

    def assert_noticed(self, request, quantity):
        code, printed, _ = run_check(request)
        self.assertEqual(code, 1, msg=quantity)
        self.assertIn(f"{quantity}:", printed)


COMPARED = {
    "random": ("phi", "jacobian", "nu", "gamma", "mass", "forces", "kinetic", "potential", "powers"),
    "consistent": (
        "acceleration", "lambda", "bodies", "reactions", "multipliers", "kinetic", "potential", "powers",
        "driver_efforts", "driver_powers",
    ),
}  # fmt: skip
IDENTITIES = ("acceleration", "lambda", "bodies", "reactions", "multipliers", "driver_efforts", "driver_powers")


class CommandLine(unittest.TestCase):
    def test_runs_and_records(self):
        definition, tree, absolute, start = mechanisms.slider_crank()
        with tempfile.TemporaryDirectory() as directory:
            requests, records = Path(directory) / "requests", Path(directory) / "records"
            requests.mkdir()
            request = generate.generate(definition, absolute, tree, start)
            (requests / "slider_crank.absolute.json").write_text(json.dumps(request))
            command = [sys.executable, str(HERE / "check.py"), str(requests), "--record", str(records), "--states", "2"]
            done = subprocess.run(command, capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, msg=done.stdout + done.stderr)
            self.assertIn("slider_crank.absolute: agrees", done.stdout)
            record = json.loads((records / "slider_crank.absolute.json").read_text())
        self.assertEqual(record["definition_hash"], request["definition_hash"])
        self.assertEqual([len(record[kind]) for kind in ("random", "consistent")], [2, 2])
        for kind, keys in COMPARED.items():
            for key in keys:
                for k in range(2):
                    self.assert_recorded(key, record[kind][k][key], request[kind][k][key])

    def assert_recorded(self, key, recorded, given):
        """The generated values are the reference's own, so that they must come back."""
        if key in ("jacobian", "mass"):
            values = {(r, c): value for r, c, value, _ in recorded}
            for r, c, value in given:
                self.assertAlmostEqual(values[(r, c)], value, delta=1e-12 * (1 + abs(value)))
        elif key in ("kinetic", "potential"):
            self.assertAlmostEqual(recorded[0], given, delta=1e-12 * (1 + abs(given)))
        else:
            given = np.array(given, float)
            np.testing.assert_allclose(recorded, given, atol=1e-10 * (1 + np.abs(given).max(initial=0.0)), err_msg=key)


if __name__ == "__main__":
    unittest.main()
