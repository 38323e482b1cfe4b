"""Spatial definitions and coordinate sets written by hand, for the tests of the reference itself.

Each function returns (definition, tree set, absolute set, start): `start` holds the tree's linear coordinates, angles
and a rotation vector per quaternion, near an assembly. Values that could hide an error (units of one, axes along
coordinate axes, orders as declared) are avoided where nothing else is tested.
"""

from functools import partial

from mechanisms import call, definition, joint, name, name_value, number, op, parameter, place, spring, value

ROWS = {
    "spherical": "x y z",
    "revolute": "x y z axis_1 axis_2",
    "fixed": "x y z axis_1 axis_2 angle",
    "prismatic": "normal_1 normal_2 axis_1 axis_2 angle",
    "cylindrical": "normal_1 normal_2 axis_1 axis_2",
    "screw": "normal_1 normal_2 axis_1 axis_2 screw",
    "universal": "x y z cross",
    "planar": "normal axis_1 axis_2",
    "constant_velocity": "x y z twist",
    "point_on_line": "normal_1 normal_2",
    "point_on_plane": "normal",
    "distance": "distance",
}


def triple(x, y, z, unit="m"):
    return {"unit": unit, "value": [entry if isinstance(entry, dict) else number(entry) for entry in (x, y, z)]}


def ground(x, y, z, unit="m"):
    return {"ground": triple(x, y, z)["value"], "unit": unit}


def point(text, x, y, z, unit="m"):
    return {"name": text} | triple(x, y, z, unit)


def marker(text, at, **axes):
    """Axes by keyword: triples or entries, in the order written."""
    return {"name": text} | triple(*at) | {"axes": [{"key": key} | given for key, given in axes.items()]}


def body(text, kind="body", center=None, points=(), lines=(), markers=(), inertia_axes=None, vectors=None, **properties):
    units = {"mass": "kg", "density": "kg/m^3"}
    return {
        "name": text,
        "kind": kind,
        "properties": {
            key: given if isinstance(given, dict) else value(given, units.get(key, "m"))
            for key, given in properties.items()
        },
        "vectors": vectors or {},
        "inertia_axes": inertia_axes,
        "markers": list(markers),
        "center": center,
        "points": list(points),
        "lines": list(lines),
    }


def inertia(xx, yy, zz, xy=0.0, xz=0.0, yz=0.0):
    return {"inertia": triple(xx, yy, zz, "kg*m^2"), "products": triple(xy, xz, yz, "kg*m^2")}


def space(title, bodies, joints, markers=(), **more):
    return definition(title, bodies, joints, **more) | {"kind": "spatial", "markers": list(markers)}


GRAVITY = triple(0.5, number("-0.7"), op("neg", number("9.81")), "m/s^2")
MOVING = ground(
    number(-0.5, "m"), op("*", number(0.1, "m/s"), name("time")), op("*", number(0.2, "m"), call("sin", name("time")))
)


def rows_of(model, names, frames=()):
    """All rows of these joints; `frames`: the body in whose axes the rows x, y, z of a joint are."""
    kinds, frames = {j["name"]: j["kind"] for j in model["joints"]}, dict(frames)
    rows = []
    for text in names:
        for what in ROWS[kinds[text]].split():
            rows.append({"of": text, "what": what} | ({"in": frames.get(text, "ground")} if what in "xyz" else {}))
    return rows


def couplings(*rows):
    return [{"of": of, "what": what} for of, what in rows]


def tree_set(branches, linear, rotations, quaternions, rows, angles=()):
    return {
        "coordinates": "tree",
        "tree": [{"body": b, "joint": j, "parent": p} for b, j, p in branches],
        "linear": [{"kind": kind, "of": of} for kind, of in linear],
        "rotations": [{"joint": of, "angle": angle} for of, angle in rotations],
        "quaternions": [{kind: of} for kind, of in quaternions],
        "angles": [{"of": of, "rate": rate} for of, rate in angles],
        "rows": rows,
    }


def absolute_set(model, rows, counted=()):
    """In an order of its own: bodies backwards, z before x, so that orders are not taken for granted.

    `counted`: (joint, first, second, axis), the axis being the same in the axes of both bodies (None: the ground).
    """
    bodies = list(reversed(model["bodies"]))
    rigid = [b["name"] for b in bodies if b["kind"] != "particle"]
    angles = []
    for text, first, second, axis in counted:
        rate = []
        for sign, of in ((-1.0, first), (1.0, second)):
            if of is not None:
                at = 3 * len(bodies) + 3 * rigid.index(of)
                rate += [[at + k, sign * axis[k]] for k in range(3) if axis[k]]
        angles.append({"of": text, "rate": rate})
    return {
        "coordinates": "absolute",
        "tree": [{"body": b["name"], "joint": None, "parent": "ground"} for b in bodies],
        "linear": [{"kind": kind, "of": b["name"]} for b in bodies for kind in "zxy"],
        "rotations": [],
        "quaternions": [{"body": of} for of in rigid],
        "angles": angles,
        "rows": rows,
    }


def free_body():
    """A general rigid body with an offset centre, tied to a free particle by a spring; forces and torques on it."""
    model = space(
        "FreeBody",
        [
            body(
                "rock", mass=name_value("m"), center=triple(0.1, -0.05, 0.2), inertia_axes="main",
                vectors=inertia(0.3, 0.4, 0.5, 0.02, -0.03, 0.01),
                points=[point("corner", 300, 200, -100, "mm")],
                markers=[marker("main", (0.1, 0, 0), about_z=value(30, "deg"), about_x=value(0.4, "rad"))],
            ),
            body("bead", "particle", mass=0.25),
        ],
        [],
        parameters=[parameter("m", "kg", 2)],
        inputs=[{"name": "push", "unit": "N"}],
        gravity=GRAVITY,
        loads=[
            spring("rope", place("bead.center"), place("rock.corner"), 40, 0.3, 0.7),
            spring("moved", MOVING, place("rock.main"), 30, 0.1, 0.4),
            {"name": "pushing", "kind": "force", "place": place("rock.corner"), "value": name("push"),
             "direction": [number(1), number(2), op("neg", number(2))]},
            {"name": "drag", "kind": "force", "place": place("bead.center"),
             "components": [op("neg", name(f"bead.center.velocity.{axis}")) for axis in "xyz"]},
            {"name": "brake", "kind": "torque", "on": "rock",
             "components": [op("neg", name("rock.rate.x")), op("*", number(2), name("rock.rate.z")), number(0.5)]},
        ],
    )  # fmt: skip
    absolute = absolute_set(model, [])
    linear = [(kind, of) for of in ("rock", "bead") for kind in "xyz"]
    tree = tree_set([("rock", None, "ground"), ("bead", None, "ground")], linear, [], [("body", "rock")], [])
    return model, tree, absolute, [0.1, 0.2, 0.3, 1.0, 0.9, 1.1, 0.3, 0.4, 0.5]


def top():
    """A top on a turned marker of the ground, a rod hung on it by its own first place, a particle on the rod."""
    model = space(
        "Top",
        [
            body("top", "cylinder", density=value(900, "kg/m^3"), length=0.3, radius=value(4, "cm"),
                 markers=[marker("tip", (-0.15, 0, 0), axis=triple(1, 2, 2, "1"), reference=triple(1, 0, 0, "1"))]),
            body("rod", "rod", mass=0.4, length=0.5,
                 markers=[marker("eye", (-0.25, 0, 0.01), axis=triple(-1, 3, 2, "1"))]),
            body("drop", "particle", mass=0.2),
        ],
        [
            joint("foot", "spherical", place("socket"), place("top.tip")),
            joint("hang", "spherical", place("rod.eye"), place("top.end")),
            joint("hold", "spherical", place("drop.center"), place("rod.end")),
        ],
        [marker("socket", (0.2, -0.1, 0.3),
                about_z=value(-50, "deg"), about_y=value(20, "deg"), about_x=value(1, "rad"))],
        gravity=GRAVITY,
        loads=[spring("rope", MOVING, place("drop.center"), 20, 0.3, 0.7)],
    )  # fmt: skip
    branches = [("drop", "hold", "rod"), ("rod", "hang", "top"), ("top", "foot", "ground")]
    tree = tree_set(branches, [], [], [("joint", "hang"), ("joint", "foot")], [])
    rows = rows_of(model, ["hold", "foot", "hang"], {"foot": "top", "hang": "rod"})
    return model, tree, absolute_set(model, rows), [0.3, -0.2, 0.4, 0.5, 0.1, -0.6]


def universals():
    """Two bodies on universal joints, the second carried by its first place; a torque and a law of both angles."""
    turned = marker("fork", (0.1, 0.02, 0), about_y=value(25, "deg"))
    model = space(
        "Universals",
        [
            body("upper", "box", mass=2, vectors={"size": triple(0.1, 0.2, 0.6)},
                 points=[point("head", 0.01, 0, 0.3)], markers=[turned]),
            body("lower", "disk", mass=name_value("m"), radius=0.2, points=[point("rim", 0.2, 0, 0)],
                 markers=[marker("boss", (0, 0, 0.05), axis=triple(0, 1, 1, "1"))]),
        ],
        [
            joint("shoulder", "universal", MOVING, place("upper.head"), axis=triple(1, 1, 0, "1"),
                  second_axis=triple(1, op("neg", number(1)), 0, "1")),
            joint("knee", "universal", place("lower.boss"), place("upper.fork"), axis=triple(0, 3, 0, "1"),
                  second_axis=triple(name("tilt"), 0, 1, "1")),
        ],
        parameters=[parameter("m", "kg", 1.5), parameter("tilt", "1", 0.5)],
        gravity=GRAVITY,
        loads=[
            {"name": "push", "kind": "force", "place": place("lower.rim"),
             "components": [name("knee.angle_1"), op("neg", name("shoulder.angle_2")), number(3)]},
        ],
    )  # fmt: skip
    branches = [("upper", "shoulder", "ground"), ("lower", "knee", "upper")]
    rotations = [(of, angle) for of in ("knee", "shoulder") for angle in ("angle_2", "angle_1")]
    tree = tree_set(branches, [], rotations, [], [])
    rows = rows_of(model, ["shoulder", "knee"], {"knee": "lower"})
    return model, tree, absolute_set(model, rows), [0.3, 0.5, -0.4, 0.2]


def slider_crank():
    """Crank, a coupler between ball and universal joint, a slider; cut at the ball, its rows in the crank's axes."""
    model = space(
        "SpaceSliderCrank",
        [
            body("crank", "rod", mass=0.5, length=0.1, radius=0.01),
            body("coupler", "rod", mass=name_value("m"), length=0.4),
            body("slider", "sphere", density=value(7800, "kg/m^3"), radius=0.03,
                 markers=[marker("yoke", (0.02, 0, 0))]),
        ],
        [
            joint("pin", "revolute", ground(0, 0.1, 0.12), place("crank.start"), axis=triple(0, 1, 3, "1")),
            joint("ball", "spherical", place("crank.end"), place("coupler.start")),
            joint("cross", "universal", place("slider.yoke"), place("coupler.end"), axis=triple(0, 0, 1, "1"),
                  second_axis=triple(0, 1, 0, "1")),
            joint("rail", "prismatic", ground(0, 0, 0), place("slider.origin"), axis=triple(1, 0, 0, "1")),
        ],
        parameters=[parameter("m", "kg", 0.8)],
        inputs=[{"name": "drive", "unit": "N*m"}],
        gravity=GRAVITY,
        loads=[{"name": "motor", "kind": "torque", "on": "pin", "value": name("drive")}],
    )  # fmt: skip
    branches = [("crank", "pin", "ground"), ("slider", "rail", "ground"), ("coupler", "cross", "slider")]
    rotations = [("pin", "angle"), ("cross", "angle_1"), ("cross", "angle_2")]
    tree = tree_set(branches, [("travel", "rail")], rotations, [], rows_of(model, ["ball"], {"ball": "crank"}))
    rows = rows_of(model, ["ball", "rail", "cross", "pin"], {"ball": "coupler", "pin": "crank"})
    return model, tree, absolute_set(model, rows), [0.45, 0.7, 0.3, -0.2]


def carriers(backward=False):
    """Every joint that can carry a body, on a free base or beneath it, with cut joints between what they carry.

    `backward`: the carried body has the first place.
    """
    tilted = triple(1, 2, -2, "1")

    def carried(text, **more):
        return body(text, mass=0.7, vectors=inertia(0.05, 0.06, 0.08, 0.01, 0.002, -0.003),
                    center=triple(0.02, 0.01, -0.03),
                    markers=[marker("m", (0.1, -0.05, 0.02), about_x=value(40, "deg"), about_z=value(-0.3, "rad"))],
                    lines=[{"name": "edge", "from": place(f"{text}.m"), "to": place(f"{text}.center")}],
                    points=[point("p", -0.1, 0.1, 0.05)], **more)  # fmt: skip

    kinds = ["revolute", "prismatic", "cylindrical", "planar", "fixed", "point_on_line", "point_on_plane", "spherical"]
    names = ["base", *[f"on_{kind}" for kind in kinds]]
    joints = []
    for kind in kinds:
        first, second = place("base.m"), place(f"on_{kind}.m")
        if backward:
            first, second = place(f"on_{kind}.m"), place("base.p")
        if kind == "point_on_line":
            first = {"line": f"on_{kind}.edge" if backward else "base.edge"}
        axis = {"axis": tilted} if kind not in ("fixed", "spherical", "point_on_line") else {}
        joints.append(joint(f"j_{kind}", kind, first, second, **axis))
    joints += [
        joint("strut", "distance", place("on_point_on_line.p"), ground(0.1, 0.2, 0.3), length=value(0.9, "m")),
        joint("bond", "spherical", place("on_planar.p"), place("on_point_on_plane.p")),
        joint("shaft", "constant_velocity", place("on_cylindrical.p"), place("on_spherical.p"),
              axis=triple(1, 1, 3, "1")),
        joint("slot", "point_on_line", {"from": ground(0, 0, 0), "to": ground(1, 1, 0.5)}, place("bead.center")),
        joint("floor", "point_on_plane", ground(0, 0, 0.1), place("ball.center"), axis=triple(0.1, 0, 1, "1")),
        joint("stick", "distance", place("ball.center"), place("bead.center"), length=value(1.2, "m")),
    ]
    particles = [body("bead", "particle", mass=0.3), body("ball", "particle", mass=0.4)]
    model = space("Backward" if backward else "Forward", [*[carried(text) for text in names], *particles], joints,
                  gravity=GRAVITY,
                  loads=[spring("rope", MOVING, place("on_revolute.p"), 40, 0.3, 0.7),
                         spring("link", place("bead.center"), place("on_fixed.p"), 20, 0.3, 0.7)])  # fmt: skip
    branches = [("base", None, "ground"), ("bead", "slot", "ground"), ("ball", "floor", "ground")]
    branches += [(f"on_{kind}", f"j_{kind}", "base") for kind in kinds]
    linear = [("travel", "slot"), *[(kind, "base") for kind in "xyz"]]
    linear += [("travel", f"j_{kind}") for kind in ("cylindrical", "prismatic", "point_on_line")]
    linear += [(f"travel_{k}", f"j_{kind}") for kind in ("planar", "point_on_plane") for k in (2, 1)]
    linear += [("travel_1", "floor"), ("travel_2", "floor")]
    rotations = [(f"j_{kind}", "angle") for kind in ("planar", "revolute", "cylindrical")]
    quaternions = [("joint", f"j_{kind}") for kind in ("point_on_line", "point_on_plane", "spherical")]
    quaternions.insert(1, ("body", "base"))
    cut = ["strut", "bond", "shaft", "stick"]
    frames = {"bond": "on_planar", "shaft": "base"}
    tree = tree_set(branches, linear, rotations, quaternions, rows_of(model, cut, frames))
    frames |= {"j_fixed": "base", "j_spherical": "on_spherical"}
    rows = rows_of(model, [*cut, *[f"j_{kind}" for kind in reversed(kinds)], "slot", "floor"], frames)
    start = [0.7, 0.2, -0.3, 0.4, 0.1, -0.2, 0.15, 0.05, -0.1, 0.2, 0.1, -0.4, 0.3, 0.2, -0.5, 0.4]
    start += [0.1, 0.2, -0.1, 0.3, -0.2, 0.1, 0.2, 0.3, -0.2, -0.1, 0.2, 0.1]
    return model, tree, absolute_set(model, rows), start


def gears():
    """A screw geared to a driven shaft, a rack, a torsion spring on a cylindrical joint, an equation with a travel."""
    round_z, round_x = (0, 0, 1.0), (1.0, 0, 0)
    along_z, along_x = triple(0, 0, 2, "1"), triple(1, 0, 0, "1")
    law = op("+", op("*", name("speed"), name("time")), op("*", number(0.2), call("sin", name("time"))))
    model = space(
        "ScrewAndGears",
        [
            body("shaft", "cylinder", mass=1, length=0.2, radius=0.05),
            body("nut", "sphere", mass=0.5, radius=0.04, points=[point("thread", 0.01, 0.02, 0.1)]),
            body("bar", "box", mass=0.6, vectors={"size": triple(0.5, 0.02, 0.03)}),
            body("sleeve", mass=0.3, vectors=inertia(0.01, 0.02, 0.015)),
            body("stage", "particle", mass=0.2),
        ],
        [
            joint("main", "revolute", ground(0, 0, 0), place("shaft.center"), axis=along_x),
            joint("lead", "screw", ground(0.1, 0.2, 0), place("nut.thread"), axis=along_z, pitch=value(50, "mm")),
            joint("slide", "prismatic", place("bar.center"), ground(0, 0.05, 0), axis=triple(0, 1, 0, "1")),
            joint("roll", "cylindrical", place("sleeve.center"), place("shaft.end"), axis=along_x),
            joint("line", "point_on_line", {"from": ground(0, 0, 0), "to": ground(0, 0, 1)}, place("stage.center")),
        ],
        parameters=[parameter("speed", "rad/s", 2)],
        gravity=GRAVITY,
        constraints=[
            {"name": "mesh", "kind": "gear", "first": "main", "second": "lead", "phase": None,
             "ratio": value(op("neg", number(1.5)), "1")},
            {"name": "teeth", "kind": "rack", "pinion": "main", "rail": "slide", "radius": value(50, "mm"),
             "phase": value(3, "cm")},
            {"name": "follow", "kind": "equation", "left": name("line.travel"),
             "right": op("+", op("*", number(2), name("lead.travel")), op("^", name("roll.travel"), number(2)))},
        ],
        drivers=[{"name": "motor", "quantity": name("main.angle"), "law": value(law)}],
        loads=[
            {"name": "bar_spring", "kind": "torsion_spring", "on": "roll", "stiffness": value(3, "N*m/rad"),
             "angle": value(20, "deg"), "damping": value(0.05, "N*m*s/rad")},
            {"name": "friction", "kind": "torque", "on": "lead", "value": op("neg", name("lead.rate"))},
            {"name": "wind", "kind": "force", "place": place("nut.center"),
             "components": [name("lead.speed"), name("roll.rate"), name("roll.speed")]},
        ],
    )  # fmt: skip
    branches = [("shaft", "main", "ground"), ("nut", "lead", "ground"), ("bar", "slide", "ground"),
                ("sleeve", "roll", "shaft"), ("stage", "line", "ground")]  # fmt: skip
    rows = couplings(("teeth", "rack"), ("mesh", "gear"), ("follow", "equation"), ("motor", "driver"))
    linear = [("travel", "slide"), ("travel", "line"), ("travel", "roll")]
    angles = [("lead", [[4, 1.0]]), ("main", [[5, 1.0]]), ("roll", [[3, 1.0]])]
    tree = tree_set(branches, linear, [("roll", "angle"), ("lead", "angle"), ("main", "angle")], [], rows, angles)
    counted = [("roll", "sleeve", "shaft", round_x), ("main", None, "shaft", round_x), ("lead", None, "nut", round_z)]
    rows = rows_of(model, ["roll", "main", "lead", "slide", "line"]) + rows
    return model, tree, absolute_set(model, rows, counted), [0.05, 0.3, 0.2, 0.4, -0.5, 0.8]


def four_bar(redundant="drop"):
    """A planar four-bar in space: of the knee's five rows only two are independent."""
    axis = {"axis": triple(0, 1, 2, "1")}

    def along(length):
        """Along the body's x: at right angles to the pins."""
        return [point("start", -length / 2, 0.02, -0.01), point("end", length / 2, 0.02, -0.01)]

    tensor = inertia(0.01, 0.03, 0.04, 0.001, 0.002, 0.0)
    model = space(
        "Dropping" if redundant == "drop" else "Keeping",
        [body(text, mass=mass, vectors=tensor, points=along(length))
         for text, mass, length in (("crank", 1.2, 0.4), ("coupler", 2, 1.0), ("rocker", 1.5, 0.8))],
        [
            joint("a", "revolute", ground(0, 0, 0), place("crank.start"), **axis),
            joint("b", "revolute", place("crank.end"), place("coupler.start"), **axis),
            joint("knee", "revolute", place("coupler.end"), place("rocker.end"), **axis),
            joint("d", "revolute", ground(0.9, 0, 0), place("rocker.start"), **axis),
        ],
        inputs=[{"name": "drive", "unit": "N*m"}],
        gravity=GRAVITY,
        options={"redundant": redundant},
        loads=[{"name": "motor", "kind": "torque", "on": "a", "value": name("drive")}],
    )  # fmt: skip
    branches = [("crank", "a", "ground"), ("coupler", "b", "crank"), ("rocker", "d", "ground")]
    dropped = [("knee", "y"), ("knee", "axis_1"), ("knee", "axis_2")] if redundant == "drop" else []

    def left(rows):
        return [row for row in rows if (row["of"], row["what"]) not in dropped]

    # In the axes of the coupler the plane of motion holds x and (0, 2, −1): y and z are one row there.
    tree_rows = left(rows_of(model, ["knee"], {"knee": "coupler"}))
    tree = tree_set(branches, [], [("a", "angle"), ("b", "angle"), ("d", "angle")], [], tree_rows)
    absolute = absolute_set(model, left(rows_of(model, ["knee", "a", "b", "d"], {"knee": "coupler"})))
    return model, tree, absolute, [1.0, -0.5, 1.4]


backward_carriers = partial(carriers, backward=True)
kept_four_bar = partial(four_bar, "keep")
ALL = (free_body, top, universals, slider_crank, carriers, backward_carriers, gears, four_bar)
