"""Definitions and coordinate sets written by hand, for the tests of the reference itself."""


def number(value, unit=None):
    node = {"number": repr(value) if isinstance(value, float) else str(value)}
    return node | {"unit": unit} if unit else node


def name(text):
    return {"name": text}


def op(operator, *arguments):
    return {"op": operator, "args": list(arguments)}


def call(function, *arguments):
    return {"call": function, "args": list(arguments)}


def value(node, unit=None):
    return {"unit": unit, "value": node if isinstance(node, (dict, list)) else number(node)}


def pair(x, y, unit="m", **more):
    return {"unit": unit, "value": [entry if isinstance(entry, dict) else number(entry) for entry in (x, y)]} | more


def ground(x, y, unit="m"):
    return {"ground": pair(x, y)["value"], "unit": unit}


def place(text):
    return {"place": text}


def parameter(text, unit, at):
    return {"name": text, "unit": unit, "value": number(at), "min": None, "max": None}


def body(text, kind="body", center=None, points=(), lines=(), **properties):
    units = {"mass": "kg", "inertia": "kg*m^2"}
    return {
        "name": text,
        "kind": kind,
        "properties": {
            key: given if "value" in (given if isinstance(given, dict) else {}) else value(given, units.get(key, "m"))
            for key, given in properties.items()
        },
        "center": center,
        "points": list(points),
        "lines": list(lines),
    }


def point(text, x, y, unit="m"):
    return {"name": text} | pair(x, y, unit)


def joint(text, kind, first, second, **more):
    return {"name": text, "kind": kind, "first": first, "second": second} | more


def definition(title, bodies, joints, **more):
    empty = {key: [] for key in "constants parameters inputs constraints drivers loads start outputs".split()}
    head = {"linkwright": 1, "kind": "planar", "name": title, "gravity": None, "options": {}, "expect": {}} | empty
    return head | {"bodies": bodies, "joints": joints} | more


def rate(plus, minus):
    """v[plus] − v[minus], as far as there are such."""
    return [[index, weight] for index, weight in ((plus, 1.0), (minus, -1.0)) if index is not None]


MOVING = ground(number(-0.5, "m"), op("*", number(0.1, "m/s"), name("time")))
GRAVITY = pair(0, op("neg", number("9.81")), "m/s^2")


def tree_coordinates(branches, linear, rotations, rows, angles=()):
    return {
        "coordinates": "tree",
        "tree": [{"body": b, "joint": j, "parent": p} for b, j, p in branches],
        "linear": [{"kind": kind, "of": of} for kind, of in linear],
        "rotations": [{"body": of} for of in rotations],
        "angles": [{"of": of, "rate": rate(plus, minus)} for of, plus, minus in angles],
        "rows": [{"of": of, "what": what} for of, what in rows],
    }


def absolute_coordinates(model, rows, angles=()):
    """In an order of its own: bodies backwards, y before x, so that orders are not taken for granted."""
    bodies = list(reversed(model["bodies"]))
    return {
        "coordinates": "absolute",
        "tree": [{"body": b["name"], "joint": None, "parent": "ground"} for b in bodies],
        "linear": [{"kind": kind, "of": b["name"]} for b in bodies for kind in ("y", "x")],
        "rotations": [{"body": b["name"]} for b in bodies if b["kind"] != "particle"],
        "angles": [{"of": of, "rate": rate(plus, minus)} for of, plus, minus in angles],
        "rows": [{"of": of, "what": what} for of, what in rows],
    }


def pins(*names):
    return [(text, axis) for text in names for axis in ("x", "y")]


def double_pendulum():
    """A rod with an offset centre of mass and a box hung on its end; a torque between the two as an input."""
    model = definition(
        "DoublePendulum",
        [
            body("upper", "rod", mass=2, length=value(1200, "mm"), center=pair(0.1, 0.02)),
            body("lower", "box", mass=name_value("load"), width=0.2, height=0.6, points=[point("top", 0, 300, "mm")]),
        ],
        [
            joint("shoulder", "revolute", ground(0.1, 0.2), place("upper.start")),
            joint("elbow", "revolute", place("lower.top"), place("upper.end")),
        ],
        parameters=[parameter("load", "kg", 1.5)],
        inputs=[{"name": "drive", "unit": "N*m"}],
        gravity=GRAVITY,
        loads=[{"name": "motor", "kind": "torque", "on": "elbow", "value": name("drive")}],
    )
    branches = [("upper", "shoulder", "ground"), ("lower", "elbow", "upper")]
    tree = tree_coordinates(branches, [], ["lower", "upper"], [])
    return model, tree, absolute_coordinates(model, pins("shoulder", "elbow")), [0.3, -0.5]


def name_value(text, unit="kg"):
    return {"unit": unit, "value": name(text)}


def four_bar():
    model = definition(
        "FourBar",
        [
            body("crank", "rod", mass=name_value("m1"), length=0.4),
            body("coupler", "rod", mass=2, length=1.0),
            body("rocker", mass=1.5, inertia=0.3, points=[point("foot", -0.4, 0), point("tip", 0.4, 0)]),
        ],
        [
            joint("a", "revolute", ground(0, 0), place("crank.start")),
            joint("b", "revolute", place("crank.end"), place("coupler.start")),
            joint("knee", "revolute", place("coupler.end"), place("rocker.tip")),
            joint("d", "revolute", ground(0.9, -0.1), place("rocker.foot")),
        ],
        parameters=[parameter("m1", "kg", 1.2)],
        inputs=[{"name": "drive", "unit": "N*m"}],
        gravity=GRAVITY,
        loads=[{"name": "motor", "kind": "torque", "on": "a", "value": name("drive")}],
    )
    branches = [("crank", "a", "ground"), ("coupler", "b", "crank"), ("rocker", "d", "ground")]
    tree = tree_coordinates(branches, [], ["crank", "coupler", "rocker"], pins("knee"))
    return model, tree, absolute_coordinates(model, pins("knee", "a", "b", "d")), [1.0, 0.5, 1.4]


def slider_crank():
    """Every planar joint, springs and dampers, a torsion spring, a massless link and a bushing of two loads.

    crank (pin in a slotted guide), guide on a moving ground, slider on an inclined rail with a fixed plate,
    a particle riding on the guide's line, a strut of fixed distance.
    """
    model = definition(
        "SliderCrank",
        [
            body("crank", mass=0.4, inertia=0.02, points=[point("pivot", -0.1, 0.01), point("tip", 0.15, 0)]),
            body(
                "guide",
                "rod",
                mass=0.6,
                length=0.8,
                lines=[{"name": "slot", "from": place("guide.start"), "to": place("guide.end")}],
            ),
            body("coupler", "rod", mass=0, inertia=0, length=0.7),
            body("slider", "box", mass=2, width=0.1, height=0.05),
            body("plate", "disk", mass=0.3, radius=0.05, points=[point("side", 0.02, -0.03)]),
            body("bead", "particle", mass=0.25),
            body("bob", "disk", mass=0.5, radius=value(4, "cm")),
        ],
        [
            joint("crank_pin", "revolute", ground(0, 0), place("crank.pivot")),
            joint(
                "guide_pin",
                "revolute",
                ground(op("*", number(0.01, "m"), call("sin", op("*", number(3), name("time")))), number(-0.3, "m")),
                place("guide.start"),
            ),
            joint("block", "point_on_line", {"line": "guide.slot"}, place("crank.tip")),
            joint("knee", "revolute", place("guide.end"), place("coupler.end")),
            joint("wrist", "revolute", place("coupler.start"), place("slider.center")),
            joint(
                "rail", "prismatic", ground(0, 0.4), place("slider.center"), axis=pair(4, 1, "1"), angle=value(10, "deg")
            ),
            joint("weld", "fixed", place("plate.side"), place("slider.origin"), angle=value(-0.3, "rad")),
            joint("ride", "point_on_line", {"line": "guide.slot"}, place("bead.center")),
            joint("strut", "distance", place("plate.center"), place("bob.center"), length=value(0.35, "m")),
        ],
        gravity=GRAVITY,
        loads=[
            spring("rope", ground(-0.5, 0.1), place("bead.center"), 40, 0.3, 0.7),
            spring("moved", MOVING, place("bob.center"), 30, 0.1, 0.4),
            {
                "name": "shock", "kind": "spring", "first": place("crank.tip"), "second": place("bob.center"),
                "damping": value(2, "N*s/m"),
            },
            {
                "name": "bar", "kind": "torsion_spring", "on": "knee", "stiffness": value(0.2, "N*m/rad"),
                "angle": value(20, "deg"), "damping": value(0.01, "N*m*s/rad"),
            },
            {
                "name": "wind", "kind": "force", "place": place("bob.center"), "direction": [number(3), number(4)],
                "value": op("*", number(-0.5), op("^", name("bob.center.velocity.x"), number(2))),
            },
            {
                "name": "push", "kind": "force", "place": place("plate.center"),
                "components": [
                    call("if", op("<", name("rail.speed"), number(0)), number(2), number(-1)), name("rail.travel"),
                ],
            },
            {"name": "brake", "kind": "torque", "on": "bob", "value": op("*", number(-0.1), name("bob.rate"))},
        ],
    )  # fmt: skip
    branches = [
        ("crank", "crank_pin", "ground"),
        ("guide", "guide_pin", "ground"),
        ("slider", "rail", "ground"),
        ("plate", "weld", "slider"),
        ("coupler", "wrist", "slider"),
        ("bead", "ride", "guide"),
        ("bob", None, "ground"),
    ]
    rows = [("block", "normal"), *pins("knee"), ("strut", "distance")]
    linear = [("travel", "rail"), ("x", "bob"), ("travel", "ride"), ("y", "bob")]
    tree = tree_coordinates(branches, linear, ["crank", "guide", "coupler", "bob"], rows, [("knee", 6, 5)])
    rows = rows + pins("crank_pin", "guide_pin", "wrist", "weld")
    rows += [("rail", "normal"), ("rail", "angle"), ("weld", "angle"), ("ride", "normal")]
    # v: two per body, then bob, plate, slider, coupler, guide, crank
    absolute = absolute_coordinates(model, rows, [("knee", 17, 18)])
    return model, tree, absolute, [0.1, 0.2, 0.3, 0.75, 5.2, 0.9, 0.2, 0.1]


def spring(text, first, second, stiffness, length, damping):
    return {
        "name": text, "kind": "spring", "first": first, "second": second, "stiffness": value(stiffness, "N/m"),
        "length": value(length, "m"), "damping": value(damping, "N*s/m"),
    }  # fmt: skip


def car_axis():
    """Two particles at a fixed distance on springs, the right wheel following a road; after the IVP test set."""
    road = op("*", number(0.1), call("sin", op("*", number(10), name("time"))))
    along = call("sqrt", op("-", number(1), op("^", road, number(2))))
    model = definition(
        "CarAxis",
        [body("left", "particle", mass=5), body("right", "particle", mass=5)],
        [joint("axis", "distance", place("left.center"), place("right.center"), length=value(1, "m"))],
        gravity=pair(0, -1, "m/s^2"),
        constraints=[
            {
                "name": "square",
                "kind": "equation",
                "left": op("+", op("*", name("left.center.x"), along), op("*", name("left.center.y"), road)),
                "right": number(0),
            }
        ],
        loads=[
            spring("rear", ground(0, 0), place("left.center"), 1000, 0.5, 3),
            spring("front", ground(along, road), place("right.center"), 1000, 0.5, 3),
        ],
    )
    tree = tree_coordinates(
        [("left", None, "ground"), ("right", None, "ground")],
        [("x", "left"), ("y", "left"), ("x", "right"), ("y", "right")],
        [],
        [("axis", "distance"), ("square", "equation")],
    )
    rows = [("square", "equation"), ("axis", "distance")]
    return model, tree, absolute_coordinates(model, rows), [0.0, 0.5, 1.0, 0.5]


def gear_pair():
    """A driven wheel, its external mate with a free phase, a rack with a written one, an arm on a torsion spring."""
    model = definition(
        "GearPair",
        [
            body("wheel", "disk", mass=3, radius=0.2),
            body("mate", "disk", mass=1, radius=0.1),
            body("rod", "box", mass=2, width=0.5, height=0.05),
            body("arm", "rod", mass=1, length=0.5),
        ],
        [
            joint("main", "revolute", ground(0, 0), place("wheel.center")),
            joint("side", "revolute", ground(0.3, 0), place("mate.center")),
            joint("slide", "prismatic", ground(0, 0.1), place("rod.center"), axis=pair(1, 0, "1")),
            joint("hinge", "revolute", place("rod.center"), place("arm.start")),
        ],
        constants=[{"name": "TEETH", "unit": "1", "value": number(2)}],
        parameters=[parameter("speed", "rad/s", 5)],
        gravity=GRAVITY,
        constraints=[
            {"name": "mesh", "kind": "gear", "first": "main", "second": "side", "phase": None,
             "ratio": value(op("neg", op("/", number(1), name("TEETH"))), "1")},
            {"name": "teeth", "kind": "rack", "pinion": "side", "rail": "slide", "radius": value(100, "mm"),
             "phase": value(3, "cm")},
        ],
        drivers=[
            {"name": "motor", "quantity": name("wheel.angle"),
             "law": value(op("+", op("*", name("speed"), name("time")), op("*", number(0.2), call("sin", name("time")))))}
        ],
        loads=[
            {"name": "bar", "kind": "torsion_spring", "on": "arm", "stiffness": value(3, "N*m/rad"),
             "angle": value(0, "rad")},
        ],
    )  # fmt: skip
    branches = [
        ("wheel", "main", "ground"),
        ("mate", "side", "ground"),
        ("rod", "slide", "ground"),
        ("arm", "hinge", "rod"),
    ]
    angles = [("main", 1, None), ("wheel", 1, None), ("side", 2, None), ("arm", 3, None)]
    rows = [("mesh", "gear"), ("teeth", "rack"), ("motor", "driver")]
    tree = tree_coordinates(branches, [("travel", "slide")], ["wheel", "mate", "arm"], rows, angles)
    rows += pins("main", "side", "hinge") + [("slide", "normal"), ("slide", "angle")]
    # v: two per body, then arm, rod, mate, wheel
    angles = [("wheel", 11, None), ("arm", 8, None), ("main", 11, None), ("side", 10, None)]
    absolute = absolute_coordinates(model, rows, angles)
    return model, tree, absolute, [0.1, 0.4, 0.7, -0.5]


def inside_out():
    """Tree joints whose first place is on the child, rotations named after any body that shares them."""
    model = definition(
        "InsideOut",
        [
            body("block", "box", mass=2, width=0.2, height=0.1, points=[point("ear", 0.1, 0.05)]),
            body("bar", "rod", mass=0.7, length=0.9, center=pair(0.1, -0.02)),
            body("plate", "disk", mass=0.3, radius=0.05, points=[point("side", 0.02, -0.03)]),
            body("tray", mass=0.4, inertia=0.01, center=pair(0.01, 0.03), points=[point("edge", 0.1, 0)]),
            body("stone", "particle", mass=0.2),
            body("cup", "disk", mass=0.1, radius=0.02),
        ],
        [
            joint(
                "rail", "prismatic", place("block.ear"), ground(0.1, 0.2), axis=pair(1, 2, "1"), angle=value(15, "deg")
            ),
            joint("ride", "point_on_line", line_between("bar.start", "bar.end"), place("block.ear")),
            joint("weld", "fixed", place("plate.side"), place("bar.end"), angle=value(40, "deg")),
            joint(
                "drawer", "prismatic", place("tray.edge"), place("plate.center"), axis=pair(-1, 1, "1"), angle=value(1)
            ),
            joint("string", "revolute", place("stone.center"), place("tray.origin")),
            joint("handle", "revolute", place("cup.center"), place("stone.center")),
            joint("tie", "distance", ground(0, 0), place("stone.center"), length=value(0.8, "m")),
        ],
        gravity=GRAVITY,
        loads=[spring("rope", MOVING, place("cup.center"), 40, 0.3, 0.7)],
    )
    branches = [
        ("cup", "handle", "stone"),
        ("stone", "string", "tray"),
        ("tray", "drawer", "plate"),
        ("plate", "weld", "bar"),
        ("bar", "ride", "block"),
        ("block", "rail", "ground"),
    ]
    linear = [("travel", "drawer"), ("travel", "ride"), ("travel", "rail")]
    rows = [("tie", "distance")]
    tree = tree_coordinates(branches, linear, ["plate", "cup"], rows)
    rows = rows + pins("weld", "string", "handle")
    rows += [("rail", "normal"), ("rail", "angle"), ("drawer", "angle"), ("drawer", "normal"), ("weld", "angle")]
    absolute = absolute_coordinates(model, rows + [("ride", "normal")])
    return model, tree, absolute, [0.1, 0.2, 0.3, 0.4, 0.0]


def line_between(first, second):
    return {"from": place(first), "to": place(second)}


def ladder(count):
    """`count` unit four-bars in a row: uprights 0..count on the ground, couplers between their tips."""
    bodies, joints, branches, cut = [], [], [], []
    for i in range(count + 1):
        bodies.append(body(f"upright[{i}]", "rod", mass=1, length=1))
        joints.append(joint(f"foot[{i}]", "revolute", ground(i, 0), place(f"upright[{i}].start")))
        branches.append((f"upright[{i}]", f"foot[{i}]", "ground"))
    for i in range(count):
        bodies.append(body(f"coupler[{i}]", "rod", mass=1, length=1))
        joints.append(joint(f"left[{i}]", "revolute", place(f"upright[{i}].end"), place(f"coupler[{i}].start")))
        joints.append(joint(f"right[{i}]", "revolute", place(f"coupler[{i}].end"), place(f"upright[{i + 1}].end")))
        branches.append((f"coupler[{i}]", f"left[{i}]", f"upright[{i}]"))
        cut.append(f"right[{i}]")
    model = definition("Ladder", bodies, joints, gravity=GRAVITY)
    rotations = [b["name"] for b in bodies]
    tree = tree_coordinates(branches, [], rotations, pins(*cut))
    absolute = absolute_coordinates(model, pins(*[j["name"] for j in joints]))
    return model, tree, absolute, [1.2] * (count + 1) + [0.0] * count


ALL = (double_pendulum, four_bar, slider_crank, car_axis, gear_pair, inside_out)
