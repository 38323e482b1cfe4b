"""The linkage of a definition, and the motion of its bodies as angles."""

import json
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

import linkage  # noqa: E402
import numpy as np  # noqa: E402


def number(value):
    return {"number": str(value)}


def vector(*values):
    return [number(v) if v >= 0 else {"op": "neg", "args": [number(-v)]} for v in values]


def rod(name):
    length = {"unit": "m", "value": number(2)}
    return {"name": name, "kind": "rod", "properties": {"mass": {"unit": "kg", "value": number(3)}, "length": length}}


def ground(x, y):
    return {"ground": vector(x, y), "unit": "m"}


def place(text):
    return {"place": text}


def definition(joints, loads=()):
    """Two rods in the plane."""
    empty = {key: [] for key in ("constants", "parameters", "inputs", "constraints", "drivers", "outputs")}
    return empty | {
        "linkwright": 1, "kind": "planar", "name": "Two", "gravity": {"unit": "m/s^2", "value": vector(0, -10)},
        "bodies": [rod("a"), rod("b")], "joints": joints, "loads": list(loads),
    }  # fmt: skip


def revolute(name, first, second):
    return {"name": name, "kind": "revolute", "first": first, "second": second}


OPEN = [revolute("outer", place("b.start"), place("a.end")), revolute("inner", ground(1, 0), place("a.start"))]


class TestLinkage(unittest.TestCase):
    def read(self, joints, loads=()):
        return linkage.read("two", json.dumps(definition(joints, loads)))

    def test_links_are_numbered_from_the_ground_outwards(self):
        found = self.read(OPEN)
        self.assertEqual([link.name for link in found.links], ["a", "b"])
        self.assertEqual([link.parent for link in found.links], [linkage.GROUND, 0])

    def test_frames_are_on_hinges(self):
        inner, outer = self.read(OPEN).links
        self.assertEqual(inner.place, [1, 0, 0])
        self.assertEqual(outer.place, [2, 0, 0])
        self.assertEqual(inner.center, [1, 0, 0])
        self.assertAlmostEqual(inner.tensor[2][2], 3 * 4 / 12)

    def test_a_hinge_that_is_written_the_other_way_round_turns_the_other_way_round(self):
        inner, outer = self.read(OPEN).links
        self.assertEqual((inner.axis, outer.axis), ([0, 0, 1], [0, 0, -1]))

    def test_what_closes_a_loop_far_from_the_ground_is_cut(self):
        found = self.read([*OPEN, revolute("last", place("b.end"), ground(5, 0))])
        self.assertEqual([link.joint for link in found.links], ["inner", "last"])
        self.assertEqual([loop.name for loop in found.loops], ["outer"])
        self.assertEqual(found.loops[0].links, [1, 0])
        self.assertEqual(found.loops[0].places, [[-2, 0, 0], [2, 0, 0]])

    def test_torques_act_on_the_hinge_as_it_is_taken(self):
        value = {"number": "7", "unit": "N*m"}
        found = self.read(OPEN, [{"name": "m", "kind": "torque", "on": "outer", "value": value}])
        self.assertEqual(found.torques, [0, -7])

    def test_what_cannot_be_said_is_named(self):
        joints = [OPEN[0], {"name": "slide", "kind": "prismatic", "first": ground(0, 0), "second": place("a.start")}]
        joints[1]["axis"] = {"unit": None, "value": vector(1, 0)}
        with self.assertRaises(linkage.CannotBeExpressed) as raised:
            self.read(joints)
        self.assertIn("slide", str(raised.exception))

    def test_angles_follow_from_the_bodies(self):
        found = self.read(OPEN)
        body = lambda angle, rate, change: [0, 0, np.cos(angle), np.sin(angle), 0, 0, rate, 0, 0, change]  # noqa: E731
        numbers = np.array([body(0.3, 2, 5) + body(1.0, -1, 4)])
        q, v, a = linkage.joint_angles(found, numbers)
        np.testing.assert_allclose(q, [[0.3, -0.7]])
        np.testing.assert_allclose(v, [[2, 3]])
        np.testing.assert_allclose(a, [[5, 1]])
        absolute, _, _ = linkage.absolute_angles(found, numbers, ["b"])
        np.testing.assert_allclose(absolute, [[1.0]])

    def test_angles_in_space_are_about_the_axis_of_the_hinge(self):
        axis = np.array([1.0, 2.0, 2.0]) / 3
        from rivals.poses import turn

        parent, child = turn([0, 1, 0], 0.4), turn([0, 1, 0], 0.4) @ turn(axis, -1.2)
        one = lambda matrix: (matrix[None], np.zeros((1, 3)), np.zeros((1, 3)))  # noqa: E731
        angle, _, _ = linkage.turn(one(parent), one(child), np.eye(3), axis)
        np.testing.assert_allclose(angle, [-1.2])

    def test_plain_text_has_a_line_for_each_part(self):
        lines = self.read([*OPEN, revolute("last", place("b.end"), ground(5, 0))]).plain().splitlines()
        self.assertEqual([line.split()[0] for line in lines], ["planar", "gravity", "link", "link", "loop"])
        self.assertEqual(len(lines[2].split()), 31)
        self.assertEqual(len(lines[4].split()), 15)


if __name__ == "__main__":
    unittest.main()
