"""What is written for the peers, and what is made of their absence."""

import pathlib
import sys
import tempfile
import unittest
import xml.etree.ElementTree as xml

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

import numpy as np  # noqa: E402
from linkage import GROUND, Link, Linkage, Loop, Spring  # noqa: E402
from rivals.mujoco.build import mjcf, quaternion  # noqa: E402
from rivals.poses import angles, poses, turn  # noqa: E402
from rivals.sympy.build import MOST_LINKS  # noqa: E402
from rivals.sympy.build import prepare as sympy  # noqa: E402
from surroundings import Absent, Surroundings, run  # noqa: E402

SAME = np.eye(3).tolist()


def two(planar=True):
    links = [
        Link("a", "inner", GROUND, [1, 0, 0], SAME, [0, 0, 1], 3.0, [0.5, 0, 0], SAME),
        Link("b", "outer", 0, [2, 0, 0], SAME, [0, 0, 1], 4.0, [0.25, 0, 0], SAME),
    ]
    loop = Loop("last", [1, GROUND], [[2, 0, 0], [5, 0, 0]], [[0, 0, 1], [0, 0, 1]])
    spring = Spring([0, GROUND], [[1, 0, 0], [0, 1, 0]], 50.0, 0.5)
    return Linkage("two", planar, [0, -10, 0], links, [loop], [spring], [0.0, 7.0], ["a", "b"])


class TestMujoco(unittest.TestCase):
    def test_bodies_hang_on_one_another(self):
        root = xml.fromstring(mjcf(two()))
        self.assertEqual(root.find("worldbody/body").get("name"), "a")
        self.assertEqual(root.find("worldbody/body/body").get("name"), "b")
        self.assertEqual(root.find("worldbody/body/body/joint").get("axis"), "0.0 0.0 1.0")

    def test_a_cut_hinge_is_one_point_in_the_plane_and_two_in_space(self):
        for planar, count in ((True, 1), (False, 2)):
            self.assertEqual(len(xml.fromstring(mjcf(two(planar))).findall("equality/connect")), count)

    def test_springs_and_torques_are_there(self):
        root = xml.fromstring(mjcf(two()))
        self.assertEqual(root.find("tendon/spatial").get("stiffness"), "50.0")
        self.assertEqual(root.find("actuator/general").get("joint"), "outer")

    def test_quaternions_of_turns(self):
        for axis, angle in (([0, 0, 1], 0.3), ([1, 0, 0], np.pi), ([0, 1, 0], np.pi), ([0, 0, 1], np.pi), ([0.6, 0, 0.8], -3.0)):
            found = quaternion(turn(axis, angle))
            expected = np.array([np.cos(angle / 2), *(np.sin(angle / 2) * np.array(axis))])
            self.assertAlmostEqual(abs(found @ expected), 1.0)


class TestPoses(unittest.TestCase):
    def test_angles_come_back(self):
        import dataclasses

        told = dataclasses.asdict(two())
        found = poses(told, [0.4, -1.1], [1.0, 2.0])
        np.testing.assert_allclose(angles(told, [pose.rotation for pose in found[:2]]), [0.4, -1.1])
        np.testing.assert_allclose(found[1].rate, [0, 0, 3])
        np.testing.assert_allclose(found[1].place, [1 + 2 * np.cos(0.4), 2 * np.sin(0.4), 0])


class TestAbsence(unittest.TestCase):
    def test_a_command_that_is_missing_is_named(self):
        with self.assertRaises(Absent) as raised:
            run(["no-such-command-anywhere"])
        self.assertIn("no-such-command-anywhere", str(raised.exception))

    def test_a_command_that_fails_says_its_error(self):
        with self.assertRaises(Absent) as raised:
            run([sys.executable, "-c", "import no_such_module"])
        self.assertIn("no_such_module", str(raised.exception))

    def test_an_environment_that_cannot_be_made_is_absent_each_time(self):
        with tempfile.TemporaryDirectory() as folder:
            here = Surroundings(pathlib.Path(folder))
            here.ready["mujoco"] = Absent("no network")
            for _ in range(2):
                with self.assertRaises(Absent):
                    here.python("mujoco")

    def test_limits_of_a_peer_have_a_reason(self):
        for linkage in (two(planar=False), two()):
            linkage.links = linkage.links * (1 if not linkage.planar else MOST_LINKS)
            with self.assertRaises(Absent) as raised:
                sympy(None, linkage, "")
            self.assertTrue(str(raised.exception))


if __name__ == "__main__":
    unittest.main()
