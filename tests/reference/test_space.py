"""Tests of the reference's spatial part against itself: identities, both kinds of coordinates, noticed changes.

What is compared with formulas by hand is in `test_space_by_hand`.
"""

import contextlib
import copy
import io
import json
import tempfile
import unittest
from pathlib import Path

import casadi as ca
import numpy as np

import check
import kinds
import space_generate
import space_mechanisms
import test_reference
from coordinate_set import symbols
from space_consistent import SpaceAbsoluteSystem
from space_definition import ANGLES, TRAVELS
from test_reference import COMPARED, run_check

CARRYING = (*space_mechanisms.ALL, space_mechanisms.kept_four_bar)


def sets(make):
    """(model, absolute equations, coordinate set, tree, start) for the tree and for the absolute set."""
    definition, tree, absolute, start = make()
    for coordinates in (tree, absolute):
        yield (*kinds.kind_of(definition).derive(definition, coordinates), tree, start)


class Identities(unittest.TestCase):
    def test_rows_against_differences(self):
        """Φ̇ = D v − ν, and d/dt(D v − ν) = −γ at v̇ = 0, moving along circles and spheres."""
        for make in space_mechanisms.ALL:
            for model, _, own, _, _ in sets(make):
                states = space_generate.draw(np.random.default_rng(5), own, 5)
                here, step = own.evaluate(states), 1e-5
                ahead, behind = (self.later(own, states, sign * step) for sign in (1, -1))
                after, before = own.evaluate(ahead), own.evaluate(behind)
                rate = (after["phi"][0] - before["phi"][0]) / (2 * step)
                second = (self.row_rates(after, states) - self.row_rates(before, states)) / (2 * step)
                with self.subTest(model=model.title):
                    scale = 1 + np.abs(here["phi"][1])
                    np.testing.assert_array_less(np.abs(rate - self.row_rates(here, states)) / scale, 1e-6)
                    scale = 1 + here["gamma"][1]
                    np.testing.assert_array_less(np.abs(second + here["gamma"][0]) / scale, 1e-6)

    def row_rates(self, quantities, states):
        return np.einsum("sij,sj->si", quantities["jacobian"][0], states["v"]) - quantities["nu"][0]

    def later(self, own, states, step):
        q = space_generate.moved(own.layout, states["q"], step * states["v"])
        return states | {"q": q, "time": states["time"] + step}

    def test_motions_of_bodies_against_differences(self):
        """Velocities and accelerations of all bodies; Ȧ = A ω̃."""
        step = 1e-5
        for make in space_mechanisms.ALL:
            model, _, own, _, _ = next(sets(make))
            states = space_generate.draw(np.random.default_rng(4), own, 4)
            zero = np.zeros(states["v"].shape)
            here, ahead, behind = (own.bodies(self.later(own, states, s), zero)[0] for s in (0, step, -step))
            rate = (ahead - behind) / (2 * step)
            matrices = here[:, :, 3:12].reshape(*here.shape[:2], 3, 3)
            spin = np.cross(here[:, :, None, 15:18], matrices)  # rows of A ω̃
            with self.subTest(model=model.title):
                for found, expected in (
                    (rate[..., 0:3], here[..., 12:15]),
                    (rate[..., 3:12], -spin.reshape(*here.shape[:2], 9)),
                    (rate[..., 12:18], here[..., 18:24]),
                ):
                    np.testing.assert_allclose(found, expected, atol=1e-7 * (1 + np.abs(expected).max()))

    def test_tree_coordinates_are_the_quantities_of_joints(self):
        """Angles and travels of tree joints, whichever place is carried, are those measured between the bodies."""
        for make in space_mechanisms.ALL:
            model, _, own, _, _ = next(sets(make))
            kinematics, layout = own.kinematics, own.layout
            pairs = layout.starts()[0]
            states = space_generate.draw(np.random.default_rng(3), own, 4)
            of_tree = {branch["joint"] for branch in kinematics.branches.values()}
            measured, expected = [], []
            for joint in (model.joints[name] for name in of_tree if name is not None):
                for k, travel in enumerate(TRAVELS.get(joint.kind, ())):
                    if (travel, joint.name) in layout.linear:
                        measured += [kinematics.travel(joint, travel), kinematics.rate(kinematics.travel(joint, travel))]
                        at = layout.linear[(travel, joint.name)]
                        expected += [states["q"][:, at], states["v"][:, at]]
                for angle in ANGLES.get(joint.kind, ()):
                    at = layout.rotations[(joint.name, angle)]
                    measured += [kinematics.principal(joint, angle), kinematics.angle_rate(joint, angle)]
                    c, s = (states["q"][:, pairs + 2 * at + k] for k in range(2))
                    expected += [np.arctan2(s, c), states["v"][:, len(layout.linear) + at]]
                    measured.append(kinematics.rate(kinematics.principal(joint, angle)))
                    expected.append(expected[-1])
            values = ca.Function("values", [*symbols(model), kinematics.q, kinematics.v], [ca.vertcat(*measured)])
            states["normals"] = np.zeros((4, 0))
            columns = [states[name].T for name in ("parameters", "time", "inputs", "phases", "z", "gates", "efforts", "normals", "q", "v")]
            with self.subTest(model=model.title):
                if expected:
                    np.testing.assert_allclose(np.array(values(*columns).full()), expected, atol=1e-12)

    def test_tree_is_the_projection_of_the_absolute_equations(self):
        """With v_abs = J v + …:  M_tree = Jᵀ M J,  Q_tree = Jᵀ (Q − M b), b the accelerations at v̇ = 0."""
        for make in space_mechanisms.ALL:
            model, absolute, own, _, _ = next(sets(make))
            states = space_generate.draw(np.random.default_rng(6), own, 4)
            n, zero = states["v"].shape[1], np.zeros(states["v"].shape)
            angles, system = own.layout.angle_values(states["q"]), SpaceAbsoluteSystem(absolute)
            parts, _, bias = system.evaluate(states, own.bodies(states, zero)[0], angles)
            columns = []
            for k in range(n):
                unit = zero.copy()
                unit[:, k] = 1.0
                columns.append(system.kinematics.from_bodies(states, own.bodies(states, unit)[0], angles)[2] - bias)
            jacobian, mass, forces = np.stack(columns, axis=2), parts["mass"][0], parts["forces"][0]
            rest = forces - np.einsum("sij,sj->si", mass, bias)
            tree = own.evaluate(states)
            with self.subTest(model=model.title):
                expected = np.einsum("sik,sij,sjl->skl", jacobian, mass, jacobian)
                np.testing.assert_allclose(tree["mass"][0], expected, atol=1e-12, rtol=1e-11)
                expected = np.einsum("sik,si->sk", jacobian, rest)
                np.testing.assert_allclose(tree["forces"][0], expected, atol=1e-10, rtol=1e-10)

    def test_accelerations_do_not_depend_on_the_coordinates(self):
        """At consistent states, those of a tree set and of the absolute set, each from its own equations."""
        for make in CARRYING:
            definition, tree, absolute, start = make()
            kind = kinds.kind_of(definition)
            model, _, own = kind.derive(definition, tree)
            _, _, other = kind.derive(definition, absolute)
            deficient = definition["options"].get("redundant") == "keep"
            states = space_generate.assembled(np.random.default_rng(2), model, own, tree, start, 6)
            one = space_generate.accelerations(own, states, deficient)
            states = space_generate.to_absolute(own, other, states)
            two = space_generate.accelerations(other, states, deficient)
            with self.subTest(model=model.title):
                np.testing.assert_allclose(one, two, rtol=1e-9, atol=1e-9 * np.abs(one).max())

    def test_kinetic_energy_is_a_quadratic_form_where_nothing_moves_by_itself(self):
        for make in (space_mechanisms.free_body, space_mechanisms.carriers, space_mechanisms.gears):
            for _, _, own, _, _ in sets(make):
                states = space_generate.draw(np.random.default_rng(7), own, 5)
                parts = own.evaluate(states)
                form = np.einsum("si,sij,sj->s", states["v"], parts["mass"][0], states["v"]) / 2
                np.testing.assert_allclose(parts["kinetic"][0][:, 0], form, rtol=1e-12)


class Requests(unittest.TestCase):
    def requests(self, make, **counts):
        definition, tree, absolute, start = make()
        return [space_generate.generate(definition, each, tree, start, **counts) for each in (tree, absolute)]

    def test_own_values_agree(self):
        """Includes what is not solved for: tree results in the absolute system, and the power balance."""
        for make in CARRYING:
            code, printed, summary = run_check(*self.requests(make, random=10, consistent=10))
            self.assertEqual(code, 0, msg=printed)
            for line in summary:
                self.assertEqual((line["random"], line["consistent"], line["set_aside"]), (10, 10, 0))
                self.assertIn("kkt_scaled", line["worst"])
                self.assertIn("power_balance", line["worst"])

    def test_small_errors_everywhere_are_noticed(self):
        """1e-9 of every quantity that is compared, in turn, in a model that has them all."""
        tree, absolute = self.requests(space_mechanisms.gears, random=3, consistent=3)
        for right, kind in ((absolute, "random"), (tree, "consistent"), (tree, "random")):
            for key in COMPARED[kind]:
                wrong = copy.deepcopy(right)
                if test_reference.Requests.disturb(self, wrong[kind][1], key):
                    code, _, _ = run_check(wrong)
                    self.assertEqual(code, 1, msg=(right["coordinates"]["coordinates"], kind, key))

    def test_components_of_bodies_and_reactions_is_noticed(self):
        right = self.requests(space_mechanisms.slider_crank, random=1, consistent=2)[1]
        for key, entries in (("bodies", (0, 5, 7, 13, 15, 17, 18, 22)), ("reactions", range(6))):
            for k in entries:
                wrong = copy.deepcopy(right)
                wrong["consistent"][1][key][1][k] += 1e-6
                self.assert_noticed(wrong, "")

    def test_other_coordinates_are_noticed(self):
        tree, absolute = self.requests(space_mechanisms.slider_crank, random=2, consistent=2)
        crank, screw = tree["coordinates"], self.requests(space_mechanisms.gears, random=2, consistent=2)[1]
        for request, change, what in (
            (tree, lambda r: r["coordinates"]["rows"][1].update({"in": "ground"}), "phi:"),
            (absolute, lambda r: r["coordinates"]["rows"][1].update({"in": "crank"}), "phi:"),
            (tree, lambda r: r["coordinates"]["rows"].pop(), "rows exported"),
            (tree, lambda r: r["coordinates"]["tree"].pop(), "spanning tree"),
            (tree, lambda r: r["coordinates"]["rotations"].append({"joint": "ball", "angle": "angle"}), "move nothing"),
            (tree, lambda r: r["consistent"][0]["reactions"].pop(), "reactions"),
            (tree, lambda r: r["definition"].update({"kind": "flat"}), "unknown kind"),
            (absolute, lambda r: self.stretch(r["random"][1], len(crank["tree"])), "norms:"),
            (absolute, lambda r: self.stretch(r["consistent"][1], len(crank["tree"])), "norms:"),
            (screw, lambda r: r["coordinates"]["angles"][0]["rate"][0].__setitem__(1, 1.1), "counted_rates:"),
            (screw, lambda r: r["coordinates"]["angles"][1]["rate"][0].__setitem__(1, -1.0), "counted_rates:"),
        ):
            wrong = copy.deepcopy(request)
            change(wrong)
            self.assert_noticed(wrong, what)

    def stretch(self, state, bodies):
        at = 3 * bodies
        state["q"][at : at + 4] = [1.001 * x for x in state["q"][at : at + 4]]

    def test_dropped_rows_must_be_implied(self):
        definition, tree, absolute, start = space_mechanisms.four_bar()
        for coordinates, of in ((tree, "knee"), (absolute, "d")):
            fewer = copy.deepcopy(coordinates)
            fewer["rows"] = [row for row in fewer["rows"] if (row["of"], row["what"]) != (of, "x")]
            request = space_generate.generate(definition, fewer, fewer if coordinates is tree else tree, start)
            self.assert_noticed(request, "dropped")

    def test_flipped_roots_are_noticed(self):
        """A body upside down on its hinge meets every row."""
        definition = space_mechanisms.space(
            "Flipped",
            [space_mechanisms.body("wheel", "disk", mass=1, radius=0.1)],
            [space_mechanisms.joint("hinge", "revolute", space_mechanisms.ground(0, 0, 0),
                                    space_mechanisms.place("wheel.center"), axis=space_mechanisms.triple(0, 0, 1, "1"))],
        )  # fmt: skip
        coordinates = space_mechanisms.absolute_set(definition, space_mechanisms.rows_of(definition, ["hinge"]))
        model, absolute, own = kinds.kind_of(definition).derive(definition, coordinates)
        for quaternion, code in (((0.6, 0, 0, 0.8), 0), ((0, 0.6, 0.8, 0), 1)):
            states = space_generate.draw(np.random.default_rng(1), own, 2)
            random = space_generate.random_part(own, states)
            states["q"][:] = [0, 0, 0, *quaternion]
            states["v"][:] = [0, 0, 0, 0, 0, 1.5]
            request = {"definition": definition, "coordinates": coordinates, "parameters_are_si": True, "random": random}
            request["consistent"] = space_generate.consistent_states(model, absolute, own, states)
            found, printed, _ = run_check(request)
            self.assertEqual(found, code, msg=printed)
            self.assertEqual("flipped root" in printed, code == 1)

    def test_records(self):
        """Values of two states of each kind, in the sizes of space, with the solution of a system that has many λ."""
        for make in (space_mechanisms.gears, space_mechanisms.kept_four_bar):
            with tempfile.TemporaryDirectory() as directory:
                requests, records = Path(directory) / "requests", Path(directory) / "records"
                requests.mkdir()
                request = self.requests(make, random=3, consistent=3)[1]
                (requests / "it.absolute.json").write_text(json.dumps(request))
                options = check.read_options([str(requests), "--record", str(records), "--states", "2"])
                with contextlib.redirect_stdout(io.StringIO()):
                    self.assertEqual(check.check_file(requests / "it.absolute.json", options)["failures"], [])
                record = json.loads((records / "it.absolute.json").read_text())
            for k, state in enumerate(record["consistent"]):
                for key in ("bodies", "reactions", "acceleration", "lambda"):
                    given = np.array(request["consistent"][k][key], float)
                    np.testing.assert_allclose(state[key], given, atol=1e-9 * (1 + np.abs(given).max()), err_msg=key)
            self.assertEqual([len(record[kind]) for kind in ("random", "consistent")], [2, 2])

    def assert_noticed(self, request, what):
        code, printed, _ = run_check(request)
        self.assertEqual(code, 1, msg=what)
        self.assertIn(what, printed)


if __name__ == "__main__":
    unittest.main()
