"""MuJoCo: MJCF of a linkage, and its shared library behind the interface.

Cut hinges are `connect` rows: one in the plane; two along the axis in space. They are soft by design; here as stiff as the library
takes them, with the time constant of two steps to which it raises shorter ones. Contacts are off.
"""

import time
import xml.etree.ElementTree as xml

import numpy as np
from linkage import GROUND, joint_angles
from surroundings import HERE, Entry, native

NAME = "mujoco"
SOFT = 1e-3  # of accelerations, with these settings


def text(numbers):
    return " ".join(repr(float(x)) for x in np.ravel(numbers))


def quaternion(axes):
    """(w, x, y, z) of a rotation, by the largest of its components."""
    a = np.asarray(axes)
    square = np.array([1 + a[0, 0] + a[1, 1] + a[2, 2], *(1 + 2 * a[k, k] - np.trace(a) for k in range(3))])
    k = int(np.argmax(square))
    vee = [a[2, 1] - a[1, 2], a[0, 2] - a[2, 0], a[1, 0] - a[0, 1]]
    if k == 0:
        found = np.array([square[0], *vee])
    else:
        found = np.array([vee[k - 1], *(a[k - 1, j] + a[j, k - 1] for j in range(3))])
        found[k] = square[k]
    return found / np.linalg.norm(found)


def mjcf(linkage):
    root = xml.Element("mujoco", model=linkage.name)
    xml.SubElement(root, "compiler", angle="radian", autolimits="false")
    option = xml.SubElement(
        root, "option", gravity=text(linkage.gravity), timestep="0.001", integrator="RK4", solver="Newton", iterations="100",
        tolerance="1e-14", jacobian="auto",
    )  # fmt: skip
    xml.SubElement(option, "flag", contact="disable")
    world = xml.SubElement(root, "worldbody")
    nodes = {GROUND: world}
    for number, link in enumerate(linkage.links):
        node = xml.SubElement(nodes[link.parent], "body", name=link.name, pos=text(link.place), quat=text(quaternion(link.axes)))
        tensor = np.asarray(link.tensor)
        entries = [tensor[i, j] for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))]
        xml.SubElement(node, "inertial", pos=text(link.center), mass=text(link.mass), fullinertia=text(entries))
        xml.SubElement(node, "joint", name=link.joint, type="hinge", axis=text(link.axis), pos="0 0 0")
        nodes[number] = node
    name = lambda number: "world" if number == GROUND else linkage.links[number].name  # noqa: E731
    equality = xml.SubElement(root, "equality")
    for loop in linkage.loops:
        pairs = (
            [loop.places]
            if linkage.planar
            else [[(np.asarray(p) + s * np.asarray(a)).tolist() for p, a in zip(loop.places, loop.axes)] for s in (-0.5, 0.5)]
        )
        for k, places in enumerate(pairs):
            sites = []
            for end, (link, place) in enumerate(zip(loop.links, places)):
                sites.append(f"{loop.name}_{k}_{end}")
                xml.SubElement(nodes[link], "site", name=sites[-1], pos=text(place))
            xml.SubElement(equality, "connect", site1=sites[0], site2=sites[1], solref="1e-9 1", solimp="0.9999 0.9999 0.001 0.5 2")
    tendons = xml.SubElement(root, "tendon")
    for k, spring in enumerate(linkage.springs):
        tendon = xml.SubElement(tendons, "spatial", springlength=text(spring.length), stiffness=text(spring.stiffness))
        for end, (link, place) in enumerate(zip(spring.links, spring.places)):
            xml.SubElement(nodes[link], "site", name=f"spring_{k}_{end}", pos=text(place))
            xml.SubElement(tendon, "site", site=f"spring_{k}_{end}")
    actuators = xml.SubElement(root, "actuator")
    for link, torque in zip(linkage.links, linkage.torques):
        if torque:
            xml.SubElement(
                actuators, "general", joint=link.joint, gaintype="fixed", gainprm="0", biastype="affine", biasprm=text([torque, 0, 0])
            )
    del name
    xml.indent(root)
    return xml.tostring(root, encoding="unicode")


def library(surroundings):
    """The shared library, once for all mechanisms."""
    output = surroundings.folder("built", NAME) / "peer.so"
    if not output.exists() or output.stat().st_mtime < (HERE / "rivals" / NAME / "peer.c").stat().st_mtime:
        package = surroundings.packages(NAME) / "mujoco"
        shared = next(package.glob("libmujoco.so*"))
        include = ["-I", package / "include"]
        source = HERE / "rivals" / NAME / "peer.c"
        surroundings.compile("gcc", [*native(), *include, source, shared, f"-Wl,-rpath,{package}", "-lpthread"], output)
    return output


def prepare(surroundings, linkage, source):
    folder = surroundings.folder("generated", NAME)
    shared = library(surroundings)
    begin = time.perf_counter()
    written = folder / f"{linkage.name}.xml"
    written.write_text(mjcf(linkage))
    passed = time.perf_counter() - begin
    soft = SOFT if linkage.loops else 1e-9
    note = "soft rows" if linkage.loops else ""
    return [
        Entry(
            "MuJoCo", shared, str(written), lambda numbers: joint_angles(linkage, numbers), soft, bool(linkage.loops), note,
            generation=passed,
        )
    ]  # fmt: skip
