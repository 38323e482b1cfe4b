"""The spatial reference against formulas by hand: frames and markers, inertia, Euler's equations, a top, a screw.

Shares with the reference only the definitions; everything expected is written with numpy.
"""

import unittest

import casadi as ca
import numpy as np

import kinds
import space_generate
import space_mechanisms
from mechanisms import joint, number, op, place, value
from space_consistent import SpaceAbsoluteSystem
from space_definition import SpaceModel
from space_frames import canonical_frame, quaternion_matrix
from space_mechanisms import body, ground, inertia, marker, point, rows_of, space, tree_set, triple


def numbers(matrix):
    return np.array(ca.evalf(ca.SX(matrix)).full())


def turn(axis, angle):
    """Rodrigues' formula."""
    x, y, z = axis = np.asarray(axis, float) / np.linalg.norm(axis)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


def derive(model, coordinates):
    return kinds.kind_of(model).derive(model, coordinates)


def one_state(own, q, v, **given):
    empty = {"parameters": np.zeros((1, 0)), "time": np.zeros((1, 1)), "inputs": np.zeros((1, 0))}
    empty |= {name: np.zeros((1, 0)) for name in ("phases", "z", "gates", "efforts")}
    return empty | {"q": np.array([q], float), "v": np.array([v], float)} | given


class Frames(unittest.TestCase):
    def test_canonical_frames(self):
        """Columns x, y, z: signed permutations for coordinate axes, the first of equal components otherwise."""
        root = np.sqrt(0.5)
        for axis, columns in (
            ((2, 0, 0), ((0, 1, 0), (0, 0, 1), (1, 0, 0))),
            ((0, 3, 0), ((0, 0, 1), (1, 0, 0), (0, 1, 0))),
            ((0, 0, 1), ((1, 0, 0), (0, 1, 0), (0, 0, 1))),
            ((0, 0, -1), ((1, 0, 0), (0, -1, 0), (0, 0, -1))),
            ((-1, 0, 0), ((0, 1, 0), (0, 0, -1), (-1, 0, 0))),
            ((1, 1, 0), ((-root, root, 0), (0, 0, 1), (root, root, 0))),
        ):
            frame = numbers(canonical_frame(ca.SX(axis), axis))
            np.testing.assert_allclose(frame, np.array(columns).T, atol=1e-15, err_msg=str(axis))
            if np.count_nonzero(axis) == 1:
                self.assertTrue(np.all(frame == np.array(columns).T))

    def test_quaternions(self):
        """Of a turn by φ about n: (cos φ/2, n sin φ/2)."""
        for axis, angle in (((0, 0, 1), 0.3), ((1, 2, -2), 2.0), ((0, 1, 1), -1.1)):
            n = np.array(axis) / np.linalg.norm(axis)
            q = [np.cos(angle / 2), *(n * np.sin(angle / 2))]
            np.testing.assert_allclose(numbers(quaternion_matrix(ca.SX(q))), turn(axis, angle), atol=1e-15)
            back = space_generate.quaternions_of(turn(axis, angle))
            np.testing.assert_allclose(back * np.sign(back @ q), q, atol=1e-15)

    def test_markers(self):
        yaw, pitch, roll = 0.3, -0.5, 0.7
        model = SpaceModel(space("Marked", [], [], [
            marker("rpy", (0, 0, 0), about_z=value(yaw), about_y=value(pitch), about_x=value(roll)),
            marker("quarter", (1, 2, 3), about_x=value(90, "deg")),
            marker("axes", (0, 0, 0), axis=triple(0, 0, 2, "1"), reference=triple(0, -3, 5, "1")),
            marker("axis", (0, 0, 0), axis=triple(0, 2, 0, "1")),
        ]))  # fmt: skip
        x, y, z = np.eye(3)
        expected = turn(z, yaw) @ turn(y, pitch) @ turn(x, roll)
        np.testing.assert_allclose(numbers(model.named_place("rpy").axes), expected, atol=1e-15)
        self.assertTrue(np.all(numbers(model.named_place("quarter").axes) == np.array([x, z, -y]).T))
        np.testing.assert_allclose(numbers(model.named_place("axes").axes), np.array([-y, x, z]).T, atol=1e-15)
        np.testing.assert_allclose(numbers(model.named_place("axis").axes), np.array([z, x, y]).T, atol=1e-15)
        np.testing.assert_allclose(numbers(model.named_place("quarter").local).ravel(), [1, 2, 3])

    def test_shapes(self):
        """Mass and principal moments; ∫ over boxes and cylinders checked by their formulas in numbers."""
        density, size = value(1000, "kg/m^3"), {"size": triple(0.1, 0.2, 0.3)}
        cases = (
            (body("b", "rod", mass=2, length=3), 2, (0, 1.5, 1.5)),
            (body("b", "rod", density=density, length=3, radius=0.1), 94.24777960769379,
             (0.4712388980384690, 70.9214541547896, 70.9214541547896)),
            (body("b", "cylinder", mass=2, length=3, radius=0.5), 2, (0.25, 1.625, 1.625)),
            (body("b", "sphere", density=density, radius=0.1), 4.188790204786391, 3 * (0.016755160819145565,)),
            (body("b", "box", density=density, vectors=size), 6, (0.065, 0.05, 0.025)),
            (body("b", "disk", mass=4, radius=0.5), 4, (0.25, 0.25, 0.5)),
            (body("b", "disk", density=density, radius=0.5, thickness=0.1), 78.53981633974483,
             (4.97418836818384, 4.97418836818384, 9.817477042468104)),
            (body("b", "box", mass=4, vectors=size | inertia(1, 2, 3)), 4, (1, 2, 3)),
        )  # fmt: skip
        for shape, mass, moments in cases:
            found = SpaceModel(space("Shape", [shape], [])).bodies["b"]
            self.assertAlmostEqual(float(found.mass) / mass, 1, delta=1e-14)
            np.testing.assert_allclose(numbers(found.inertia), np.diag(moments), rtol=1e-13, err_msg=shape["kind"])


class Bodies(unittest.TestCase):
    def test_euler(self):
        """J ω̇ + ω × J ω = τ and m v̇ = f for a general body; f acts at a place off the centre."""
        model = space(
            "Euler",
            [body("rock", mass=2, center=triple(0.1, -0.05, 0.2), inertia_axes="main",
                  vectors=inertia(0.3, 0.4, 0.5, 0.02, -0.03, 0.01), points=[point("corner", 0.3, 0.2, -0.1)],
                  markers=[marker("main", (0, 0, 0), about_z=value(0.6))])],
            [],
            gravity=triple(0, 0, op("neg", number("9.81")), "m/s^2"),
            loads=[{"name": "f", "kind": "force", "place": place("rock.corner"),
                    "components": [number(1), number(-2), number(3)]},
                   {"name": "t", "kind": "torque", "on": "rock",
                    "components": [number("0.1"), number("0.2"), number("-0.3")]}],
        )  # fmt: skip
        coordinates = space_mechanisms.absolute_set(model, [])
        coordinates["linear"] = [{"kind": kind, "of": "rock"} for kind in "xyz"]
        _, _, own = derive(model, coordinates)
        main = np.array([[0.3, 0.02, -0.03], [0.02, 0.4, 0.01], [-0.03, 0.01, 0.5]])
        tensor = turn((0, 0, 1), 0.6) @ main @ turn((0, 0, 1), 0.6).T
        states = space_generate.draw(np.random.default_rng(1), own, 5)
        quantities = own.evaluate(states)
        for k in range(5):
            w, (a, b, c, d), v = states["v"][k, 3:], states["q"][k, 3:], states["v"][k, :3]
            angle, axis = 2 * np.arctan2(np.linalg.norm([b, c, d]), a), (b, c, d)
            matrix, force = turn(axis, angle), np.array([1, -2, 3])
            torque = matrix.T @ np.array([0.1, 0.2, -0.3]) + np.cross([0.2, 0.25, -0.3], matrix.T @ force)
            expected = [*(force + 2 * np.array([0, 0, -9.81])), *(torque - np.cross(w, tensor @ w))]
            np.testing.assert_allclose(quantities["forces"][0][k], expected, atol=1e-13)
            mass = np.block([[2 * np.eye(3), np.zeros((3, 3))], [np.zeros((3, 3)), tensor]])
            np.testing.assert_allclose(quantities["mass"][0][k], mass, atol=1e-14)
            self.assertAlmostEqual(quantities["kinetic"][0][k, 0], v @ v + w @ tensor @ w / 2, delta=1e-13)
            at = matrix @ (np.cross(w, [0.2, 0.25, -0.3])) + v
            powers = [force @ at, matrix.T @ np.array([0.1, 0.2, -0.3]) @ w]
            np.testing.assert_allclose(quantities["powers"][0][k], powers, atol=1e-13)

    def test_heavy_top(self):
        """About a fixed place with axes B: J ω̇ + ω × J ω = r × m g, all in the axes of the place."""
        model = space(
            "HeavyTop",
            [body("top", mass=3, center=triple(0.1, 0.2, 0.5), vectors=inertia(0.3, 0.4, 0.5, 0.02, -0.03, 0.01),
                  markers=[marker("tip", (0.02, 0, -0.1), about_x=value(0.8))])],
            [joint("foot", "spherical", place("stand"), place("top.tip"))],
            [marker("stand", (1, 2, 3), about_y=value(-0.4))],
            gravity=triple(0, 0, op("neg", number("9.81")), "m/s^2"),
        )  # fmt: skip
        _, _, own = derive(model, tree_set([("top", "foot", "ground")], [], [], [("joint", "foot")], []))
        b, stand = turn((1, 0, 0), 0.8), turn((0, 1, 0), -0.4)
        arm = np.array([0.08, 0.2, 0.6])
        tensor = np.array([[0.3, 0.02, -0.03], [0.02, 0.4, 0.01], [-0.03, 0.01, 0.5]])
        tensor = tensor + 3 * (arm @ arm * np.eye(3) - np.outer(arm, arm))
        tensor, arm = b.T @ tensor @ b, b.T @ arm
        states = space_generate.draw(np.random.default_rng(1), own, 5)
        quantities = own.evaluate(states)
        for k in range(5):
            w, (c, *axis) = states["v"][k], states["q"][k]
            world = stand @ turn(axis, 2 * np.arctan2(np.linalg.norm(axis), c))
            weight = world.T @ np.array([0, 0, -3 * 9.81])
            np.testing.assert_allclose(quantities["mass"][0][k], tensor, atol=1e-13)
            expected = np.cross(arm, weight) - np.cross(w, tensor @ w)
            np.testing.assert_allclose(quantities["forces"][0][k], expected, atol=1e-12)
            height = 3 + world[2] @ arm
            self.assertAlmostEqual(quantities["potential"][0][k, 0], 3 * 9.81 * height, delta=1e-12)

    def test_screw(self):
        """(I + m h²) θ̈ = −m g h down a vertical screw of lead h per radian; it rises with positive turns."""
        model = space(
            "Screw",
            [body("nut", "disk", mass=2, radius=0.3)],
            [joint("thread", "screw", ground(0, 0, 1), place("nut.center"), axis=triple(0, 0, 1, "1"), pitch=value(0.5))],
            gravity=triple(0, 0, op("neg", number("9.81")), "m/s^2"),
        )
        coordinates = tree_set([("nut", "thread", "ground")], [], [("thread", "angle")], [], [], [("thread", [[0, 1.0]])])
        _, _, own = derive(model, coordinates)
        lead = 0.5 / (2 * np.pi)
        states = one_state(own, [np.cos(1), np.sin(1), 2, 1], [3])
        quantities = own.evaluate(states)
        self.assertAlmostEqual(quantities["mass"][0][0, 0, 0], 0.09 + 2 * lead**2, delta=1e-15)
        self.assertAlmostEqual(quantities["forces"][0][0, 0], -2 * 9.81 * lead, delta=1e-14)
        bodies, _ = own.bodies(states, np.zeros((1, 1)))
        expected = [0, 0, 1 + 2 * 0.5 + lead, *turn((0, 0, 1), 1).ravel(), 0, 0, 3 * lead, 0, 0, 3, *np.zeros(6)]
        np.testing.assert_allclose(bodies[0, 0], expected, atol=1e-14)

    def test_universal(self):
        """A2 B2 = A1 B1 Rot(axis, angle_1) Rot(second axis, angle_2); carried by its first place the inverse."""
        axis, second, one, two = (1, 1, 0), (1, -1, 1), 0.4, -1.3
        for backward in (False, True):
            hook, stand = marker("hook", (0, 0, 0), about_x=value(0.8)), marker("stand", (0, 0, 0), about_y=value(-0.4))
            first, last = place("stand"), place("wheel.hook")
            model = space(
                "Joint",
                [body("wheel", "disk", mass=2, radius=0.3, markers=[hook])],
                [joint("it", "universal", *((last, first) if backward else (first, last)),
                       axis=triple(*axis, "1"), second_axis=triple(*second, "1"))],
                [stand],
            )  # fmt: skip
            rotations = [("it", "angle_1"), ("it", "angle_2")]
            _, _, own = derive(model, tree_set([("wheel", "it", "ground")], [], rotations, [], []))
            q = [np.cos(one), np.sin(one), np.cos(two), np.sin(two)]
            bodies, _ = own.bodies(one_state(own, q, [0, 0]), np.zeros((1, 2)))
            turned = turn(axis, one) @ turn(second, two)
            turned = turn((0, 1, 0), -0.4) @ (turned.T if backward else turned) @ turn((1, 0, 0), 0.8).T
            np.testing.assert_allclose(bodies[0, 0, 3:12], turned.ravel(), atol=1e-14)

    def test_reactions_at_rest(self):
        """A welded body: the joint bears its weight and the moment about the second place, on the second's body."""
        weight = np.array([0, 0, -2 * 9.81])
        center, pin = np.array([0.3, -0.2, 0.1]), np.array([0.1, 0.2, 0.4])
        for backward in (False, True):
            ends = ground(*pin.tolist()), place("plate.hole")
            model = space(
                "Welded",
                [body("plate", mass=2, vectors=inertia(0.3, 0.4, 0.5), points=[point("hole", *(pin - center).tolist())])],
                [joint("weld", "fixed", *(reversed(ends) if backward else ends))],
                gravity=triple(0, 0, op("neg", number("9.81")), "m/s^2"),
            )
            coordinates = space_mechanisms.absolute_set(model, rows_of(model, ["weld"], {"weld": "plate"}))
            _, absolute, own = derive(model, coordinates)
            q = [center[2], center[0], center[1], 1, 0, 0, 0]
            states = one_state(own, q, np.zeros(6))
            parts = space_generate.consistent_part(own, SpaceAbsoluteSystem(absolute), states)[0]
            on_plate = np.array([*-weight, *-np.cross(center - pin, weight)])
            np.testing.assert_allclose(parts["acceleration"], np.zeros(6), atol=1e-13)
            np.testing.assert_allclose(parts["reactions"][0], -on_plate if backward else on_plate, atol=1e-12)


if __name__ == "__main__":
    unittest.main()
