"""CasADi: the C that it writes for what an expert derives around it (benches/casadi of this project), compiled by gcc.

An expert chooses coordinates, formulation and elimination for each mechanism by hand; the double pendulum, which is not there, is taken
through the expert's articulated bodies and elimination of trees. Functions whose names end in `_turns` are handed cosines and sines.
"""

import sys
import time

import numpy as np
from linkage import absolute_angles, joint_angles, motions, turn
from surroundings import HERE, ROOT, Absent, Entry, bytes_of_code, native

sys.path.append(str(ROOT / "benches" / "casadi"))

import andrews  # noqa: E402
import casadi as ca  # noqa: E402
import plane  # noqa: E402
import space  # noqa: E402
from trees import Link, Tree  # noqa: E402

NAME = "casadi"
SUFFIXES = ("", "_turns")


def variants(linkage):
    """What the expert has: (title, function that makes it)."""
    turned = lambda make, name: [(f"{name}{suffix}", make, bool(suffix)) for suffix in SUFFIXES]  # noqa: E731
    windows = {"four_bar": 1, "n_four_bar_10": 10, "n_four_bar_40": 40}
    if linkage.name in windows:
        count = windows[linkage.name]
        return [(f"{linkage.name}_ldl", lambda name, _: plane.function(name, count), False)]
    if linkage.name == "andrews":
        return turned(andrews.by_elimination, "andrews_ldl") + turned(andrews.by_crank, "andrews_crank")
    if linkage.name == "panda":
        return turned(space.panda_articulated, "panda_aba") + turned(space.panda_eliminated, "panda_ldl")
    if linkage.name == "bricard":
        # The row of the cut hinge with which simulations come out better by far.
        return turned(lambda name, turns: space.bricard(name, turns, kept=1), "bricard_ldl")
    if not linkage.loops and all(np.allclose(link.axis, [0, 0, 1]) for link in linkage.links):
        return turned(articulated(linkage), f"{linkage.name}_aba") + turned(eliminated(linkage), f"{linkage.name}_ldl")
    raise Absent("no expert has written it around CasADi")


def tree(linkage, symbols):
    """The links as the expert's trees have them, whose hinges are along z."""
    links = []
    for link in linkage.links:
        tensor = np.asarray(link.tensor)
        products = [tensor[0, 1], tensor[0, 2], tensor[1, 2]]
        parent = link.parent if link.parent >= 0 else None
        clean = lambda values: [0 if x == 0 else float(x) for x in values]  # noqa: E731
        axes = [clean(row) for row in link.axes]
        links.append(Link(parent, clean(link.place), axes, link.mass, clean(link.center), clean(np.diag(tensor)), clean(products)))
    return Tree(links, symbols.turns, linkage.gravity)


def articulated(linkage):
    def make(name, turns):
        symbols = space.Symbols(len(linkage.links), turns)
        return symbols.function(name, tree(linkage, symbols).articulated_bodies(symbols.v, symbols.torques), ca.SX(0, 1))

    return make


def eliminated(linkage):
    def make(name, turns):
        size = len(linkage.links)
        symbols = space.Symbols(size, turns)
        bodies = tree(linkage, symbols)
        bias, _ = bodies.inverse_dynamics(symbols.v)
        order = list(reversed(range(size)))
        d, lt, p = ca.ldl(bodies.mass_matrix()[order, order], False)
        return symbols.function(name, ca.ldl_solve((symbols.torques - bias)[order], d, lt, p)[order], ca.SX(0, 1))

    return make


# Bricard's hinges 1, 2, 6, 5, 4 from the ground outwards; hinge 3 is cut. All axes are parallel at angle zero.
HINGES = ((None, "rod_1", 1), ("rod_1", "rod_2", 2), (None, "rod_5", 0), ("rod_5", "rod_4", 2), ("rod_4", "rod_3", 1))


def angles(linkage, numbers):
    """Angles, rates and accelerations in the expert's coordinates."""
    if linkage.name == "bricard":
        bodies = motions(linkage, numbers)
        parts = [turn(bodies[before], bodies[behind], np.eye(3), np.eye(3)[axis]) for before, behind, axis in HINGES]
        return tuple(np.stack([part[k] for part in parts], axis=1) for k in range(3))
    if linkage.planar and linkage.loops:
        return absolute_angles(linkage, numbers, sorted(linkage.bodies, key=lambda name: name.startswith("coupler")))
    return joint_angles(linkage, numbers)


def with_turns(states):
    q, v, a = states
    return np.stack([np.cos(q), np.sin(q)], axis=2).reshape(len(q), -1), v, a


def prepare(surroundings, linkage, source):
    folder = surroundings.folder("generated", NAME)
    entries = []
    for name, make, turns in variants(linkage):
        begin = time.perf_counter()
        made = make(name, turns)
        made.generate(f"{name}.c", {"with_header": False})
        passed = time.perf_counter() - begin
        written = folder / f"{name}.c"
        (folder.cwd() / f"{name}.c").replace(written)
        sizes = {"SIZE": len(linkage.links), "INTEGERS": made.sz_iw(), "WORK": made.sz_w(), "FUNCTION": name, "SOURCE": f'"{written}"'}
        defines = [f"-D{key}={value}" for key, value in (sizes | ({"PEER_POSITIONS": 2} if turns else {})).items()]
        output = surroundings.folder("built", NAME) / f"{name}.so"
        alone = output.with_suffix(".o")
        built = surroundings.compile("gcc", ["-O3", "-march=native", "-fPIC", "-c", written], alone)
        surroundings.compile("gcc", [*native(), *defines, HERE / "rivals" / NAME / "peer.c", "-lm"], output)
        way = name.removeprefix(f"{linkage.name}_").removesuffix("_turns").upper().replace("CRANK", "crank")
        title = f"CasADi, {way}" + (", handed cos, sin" if turns else "")
        states = lambda numbers, turns=turns: (with_turns if turns else tuple)(angles(linkage, numbers))  # noqa: E731
        entries.append(Entry(title, output, name, states, 1e-6, generation=passed, build=built, code=bytes_of_code(alone)))
    return entries
