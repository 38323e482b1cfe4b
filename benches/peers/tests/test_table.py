"""The table, the picture, and what is read off a curve."""

import pathlib
import sys
import tempfile
import unittest
import xml.etree.ElementTree as xml

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

import numpy as np  # noqa: E402
import table  # noqa: E402
from compare import disagreement  # noqa: E402
from picture import picture  # noqa: E402
from precision import at_error, turned  # noqa: E402

MACHINE = {"processor": "P", "cores": 2, "load": [0.1, 0, 0], "rustc": "r", "gcc": "g", "clang": "absent"}


def timed(ns, ratio):
    return {kind: {"ns": ns, "median": ns, "ratio": ratio} for kind in ("evaluation", "chain", "step")}


def peer(**more):
    return {
        "agrees_to": 1e-12,
        "middle_agrees_to": 1e-13,
        "tolerance": 1e-6,
        "note": "",
        "generation": None,
        "build": None,
        "code": None,
    } | more


def results():
    peers = {
        "Linkwright": peer(**timed(10.0, 1.0), build=2.0),
        "Rival": peer(**timed(8.0, 0.8), code=100, generation=1e-3, build=2e-3),
        "Soft": peer(agrees_to=1e-2, middle_agrees_to=1e-4, **timed(1e4, 1000.0)),
        "Handed, handed cos, sin": peer(evaluation={"ns": 12.0, "median": 12.0, "ratio": 1.2}),
        "Wrong": peer(agrees_to=3.0),
    }
    curves = {"Linkwright": [[10, 1e-5, 1e-3], [20, 2e-5, 1e-5]], "Rival": [[10, 1e-4, 1e-3], [20, 2e-4, 1e-9]]}
    mechanism = {
        "title": "four-bar", "peers": peers, "refused": [{"peer": "Wrong", "error": 3.0, "tolerance": 1e-6}],
        "clock": {"least": 3.0, "median": 3.5, "most": 3.6},
        "precision": {
            "end": 1.0, "reference": {"peer": "Rival", "agrees_to": 1e-12}, "curves": curves,
            "at": {name: [at_error(curve, level) for level in (1e-4, 1e-6, 1e-8)] for name, curve in curves.items()},
        },
        "batches": {"Linkwright": {"threads": 2, "rate": 2e7}},
    }  # fmt: skip
    absent = [{"peer": "mujoco", "mechanism": None, "reason": "no network | none"}]
    return {"machine": MACHINE, "settings": {"only": [], "quick": True}, "mechanisms": {"four_bar": mechanism}, "absent": absent}


class TestTable(unittest.TestCase):
    def setUp(self):
        self.page = table.markdown(results(), "2026-01-01")

    def test_who_is_ahead_is_said(self):
        self.assertIn("Where Linkwright is behind: four-bar: Rival, evaluation at 0.80", self.page)

    def test_the_best_rival_is_an_exact_one(self):
        self.assertIn("| four-bar | 10 | 0.80 (Rival) | 1.20 (Handed) | 10 | 0.80 (Rival) |", self.page)

    def test_who_is_built_sooner_is_said(self):
        self.assertIn("four-bar Rival 3 ms (Linkwright 2 s)", self.page)

    def test_who_is_refused_has_no_times(self):
        line = next(line for line in self.page.splitlines() if line.startswith("| Wrong"))
        self.assertIn("refused", line)
        self.assertEqual(line.count("|"), 9)

    def test_who_is_absent_is_named_with_the_reason(self):
        self.assertIn("| mujoco | all | no network \\| none |", self.page)

    def test_what_is_not_reached_is_said(self):
        self.assertIn("| Linkwright | 14.1 µs | not reached | not reached | 1e-05 |", self.page)

    def test_softness_is_shown(self):
        self.assertIn("| Soft | 1e-02, the middle state to 1e-04 |", self.page)

    def test_files_are_written(self):
        with tempfile.TemporaryDirectory() as folder:
            paths = table.write(results(), pathlib.Path(folder) / "new", "2026-01-01")
            self.assertEqual([path.name for path in paths], ["2026-01-01.json", "2026-01-01.md", "2026-01-01-four_bar.svg"])
            self.assertTrue(all(path.exists() for path in paths))

    def test_numbers_have_no_power_of_ten(self):
        self.assertEqual([table.number(x) for x in (None, 3.456, 123456.0, 1000.0, 0.5)], ["", "3.46", "123 456", "1 000", "0.5"])
        self.assertEqual([table.seconds(x) for x in (None, 2.0, 3e-5, 4e-9)], ["", "2 s", "30 µs", "4 ns"])


class TestPicture(unittest.TestCase):
    def test_it_is_svg(self):
        drawn = picture("a < b", {"x": [[1, 1e-3, 1e-2], [2, 2e-3, 1e-4]], "nothing": []})
        root = xml.fromstring(drawn)
        self.assertEqual(len(root.findall("{http://www.w3.org/2000/svg}polyline")), 1)

    def test_nothing_is_no_picture(self):
        self.assertIsNone(picture("empty", {"x": []}))


class TestPrecision(unittest.TestCase):
    def test_between_two_points_by_their_logarithms(self):
        self.assertAlmostEqual(at_error([[1, 1.0, 1e-2], [2, 4.0, 1e-4]], 1e-3), 2.0)
        self.assertIsNone(at_error([[1, 1.0, 1e-2], [2, 4.0, 1e-4]], 1e-6))

    def test_better_at_once_is_the_first_point(self):
        self.assertEqual(at_error([[1, 1.0, 1e-7], [2, 2.0, 1e-9]], 1e-4), 1.0)

    def test_turns_do_not_count(self):
        self.assertAlmostEqual(turned([0.1, 2 * np.pi - 0.2]), 0.2)

    def test_disagreement_is_relative_to_the_largest_of_a_state(self):
        expected = np.array([[1.0, 100.0], [10.0, 0.0], [5.0, 5.0]])
        found = expected + np.array([[0.0, 1.0], [1.0, 0.0], [0.0, 0.0]])
        np.testing.assert_allclose(disagreement(found, expected), (0.01, 0.1))
        self.assertEqual(disagreement(found * np.nan, expected)[1], float("inf"))


if __name__ == "__main__":
    unittest.main()
