"""Tables against values that SciPy 1.16 gives."""

import unittest

import casadi as ca

from tables import Table, in_si

X = [-0.5, -0.3, -0.1, 0, 0.05, 0.2, 0.25, 0.6, 1]
Y = [-900, -700, -250, 0, 0, 400, 420, 900, 2500]
EXPECTED = {
    "linear": (0, 0, 1700, 4000),
    "cubic": (0.5168646558779941, -265.5042278923213, 1570.3042830741952, 4019.08138048122),
    "natural": (0.5164628474983033, -265.3224049885034, 1611.850285828795, 4146.916190285342),
    "akima": (9.743856143856144, -721.838161838162, 1538.3219954648528, 4151.247165532881),
    "modified_akima": (4.510308634262156, -604.973135074347, 1549.5106055929937, 4312.775851788374),
    "pchip": (0, 0, 1530.9337609693087, 4144.378814201078),
    "monotone": (0, 0, 1559.809523809524, 4000),
}


def numbers(values):
    return [{"op": "neg", "args": [{"number": str(-v)}]} if v < 0 else {"number": str(v)} for v in values]


def line(x, y, kind, outside="linear"):
    points = [list(point) for point in zip(numbers(x), numbers(y))]
    head = {"arguments": [{"name": "x", "unit": "1"}], "unit": "1", "kind": kind, "outside": outside}
    return Table({**head, "points": points}, in_si)


class Tables(unittest.TestCase):
    def test_splines(self):
        for kind, expected in EXPECTED.items():
            table = line(X, Y, kind)
            found = [float(f(ca.SX(x))) for x in (0.02, 0.8) for f in (table, table.slope)]
            for value, own in zip(found, expected):
                self.assertAlmostEqual(value, own, delta=1e-11 * max(1, abs(own)), msg=kind)

    def test_periodic(self):
        table = line([0, 1, 2, 4], [1, 3, -1, 1], "periodic")
        x = ca.SX.sym("x")
        slope = ca.Function("slope", [x], [ca.jacobian(table(x), x), table.slope(x)])
        for at in (0.3, 1.7, 3.9):
            self.assertAlmostEqual(float(table(ca.SX(at + 8))), float(table(ca.SX(at))), delta=1e-12)
            by_automatic, own = slope(at)
            self.assertAlmostEqual(float(by_automatic), float(own), delta=1e-12)

    def test_outside(self):
        held = line(X, Y, "natural", "hold")
        self.assertEqual(float(held(ca.SX(1.5))), 2500)
        self.assertEqual(float(held(ca.SX(-7))), -900)

    def test_bilinear(self):
        z = [[0, 2, 3, 8], [1, 2.5, 5, 9], [3, 6, 7, 12]]
        head = {"arguments": [{"unit": "1"}, {"unit": "1"}], "unit": "1", "kind": "bilinear", "outside": "linear"}
        axes = [numbers([0, 1, 2, 4]), numbers([0, 0.5, 2])]
        grid = Table({**head, "axes": axes, "rows": [numbers(row) for row in z]}, in_si)
        places = {(0.5, 0.25): 1.375, (1.5, 1): 4.666666666666667, (3, 0.4): 6.7, (3.9, 1.9): 11.55333333333333}
        for place, expected in places.items():
            self.assertAlmostEqual(float(grid(*map(ca.SX, place))), expected, delta=1e-12)

    def test_bicubic(self):
        """Values of SciPy's RectBivariateSpline through all points."""
        z = [[0, 2, 3, 8, 7], [1, 2.5, 5, 9, 6], [3, 6, 7, 12, 11], [2, 6.5, 4, 10, 13]]
        head = {"arguments": [{"unit": "1"}, {"unit": "1"}], "unit": "1", "kind": "bicubic", "outside": "linear"}
        axes = [numbers([0, 1, 2, 4, 5]), numbers([0, 0.5, 2, 3])]
        sheet = Table({**head, "axes": axes, "rows": [numbers(row) for row in z]}, in_si)
        places = {
            (0.5, 0.25): 1.3750302269345238,
            (1.5, 1): 4.886755952380952,
            (3, 0.4): 7.469923809523811,
            (4.7, 2.9): 12.715294599999996,
        }
        for place, expected in places.items():
            self.assertAlmostEqual(float(sheet(*map(ca.SX, place))), expected, delta=1e-12)


if __name__ == "__main__":
    unittest.main()
