"""rapier: simulations of linkages in the plane, because its interface has no accelerations; see `src/main.rs`.

It moves by semi-implicit Euler and iterates on impulses, and is made to be fast and robust in games, not exact.
"""

import json
import os

import numpy as np
import own
from rivals.poses import angles, poses, turn
from surroundings import HERE, Absent

NAME = "rapier"
PEER = "rapier, impulse joints"


def text(linkage, told):
    """What the program reads."""
    flat = lambda *parts: " ".join(repr(float(x)) for part in parts for x in np.ravel(part))  # noqa: E731
    links = linkage["links"]
    found = poses(linkage, told["q"], told["v"])
    local = lambda number, place: np.subtract(place, links[number]["center"] if number >= 0 else [0, 0, 0])[:2]  # noqa: E731
    lines = [f"gravity {flat(linkage['gravity'][:2])}"]
    torques = np.array(linkage["torques"])
    for number, link in enumerate(links):
        torque = torques[number] - sum(torques[k] for k, other in enumerate(links) if other["parent"] == number)
        pose = found[number]
        angle = np.arctan2(pose.rotation[1, 0], pose.rotation[0, 0])
        center, speed = pose.point(link["center"])[:2], pose.speed(link["center"])[:2]
        lines.append(f"body {flat(link['mass'], link['tensor'][2][2], center, angle, speed, pose.rate[2], torque)}")
    for number, link in enumerate(links):
        ends = local(link["parent"], link["place"]), local(number, [0, 0, 0])
        lines.append(f"pin {link['parent']} {number} {flat(*ends)}")
    for kind, parts in (("pin", linkage["loops"]), ("spring", linkage["springs"])):
        for part in parts:
            ends = [local(number, place) for number, place in zip(part["links"], part["places"])]
            law = (part["stiffness"], part["length"]) if kind == "spring" else ()
            lines.append(f"{kind} {part['links'][0]} {part['links'][1]} {flat(*ends, *law)}")
    return lines


class Rapier:
    """Like `rivals.simulator.Simulator`, with a program in place of a script."""

    peer = PEER

    def __init__(self, surroundings, linkage):
        self.surroundings = surroundings
        self.linkage = json.loads(linkage.json())
        target = surroundings.folder("built", NAME)
        manifest = HERE / "rivals" / NAME / "Cargo.toml"
        command = ["cargo", "build", "--release", "--quiet", "--locked", "--manifest-path", manifest, "--target-dir", target]
        surroundings.run(command, env=own.environment() | {"PATH": os.environ["PATH"]})
        self.program = target / "release" / "rapier-peer"
        self.file = surroundings.folder("generated", NAME) / f"{linkage.name}.txt"

    def run(self, told):
        told = json.loads(told.read_text())
        lines, found = text(self.linkage, told), []
        for steps in told["steps"]:
            self.file.write_text("\n".join([*lines, f"run {told['end']!r} {steps}"]) + "\n")
            _, seconds, *ends = (float(part) for part in self.surroundings.run([self.program, self.file], timeout=120).split())
            found.append([steps, seconds, angles(self.linkage, [turn([0, 0, 1], angle) for angle in ends])])
            if 2 * seconds > told["longest"]:
                break
        return json.dumps(found)


def simulator(surroundings, linkage):
    if not linkage.planar:
        raise Absent("written for its library of the plane")
    return Rapier(surroundings, linkage)
