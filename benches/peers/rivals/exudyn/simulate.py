"""Exudyn simulates a linkage: its bodies with their own coordinates and its hinges as constraints, by generalised-α.

    python simulate.py LINKAGE.json TOLD.json

Prints [[steps, seconds, angles at the end], …]. Runs in Exudyn's own environment.
"""

import json
import pathlib
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

import exudyn as exu  # noqa: E402
import numpy as np  # noqa: E402
from exudyn import itemInterface as items  # noqa: E402
from exudyn import utilities  # noqa: E402
from poses import angles, poses  # noqa: E402

RADIUS = 0.9  # spectral radius at infinity
LINEAR = [0.0, 0.0, 0.0]


class System:
    def __init__(self, linkage, told):
        self.linkage, self.links = linkage, linkage["links"]
        self.container = exu.SystemContainer()
        self.mbs = self.container.AddSystem()
        self.at = poses(linkage, told["q"], told["v"])
        self.ground = self.mbs.AddObject(items.ObjectGround())
        self.nodes, self.bodies = [], []
        for link, pose in zip(self.links, self.at):
            if linkage["planar"]:
                self.add_planar(link, pose)
            else:
                self.add_spatial(link, pose)
        for i, link in enumerate(self.links):
            self.hinge((link["parent"], link["place"]), (i, [0, 0, 0]), self.at[i].rotation @ np.array(link["axis"]))
        for loop in linkage["loops"]:
            first, second = zip(loop["links"], loop["places"])
            self.hinge(first, second, self.at[loop["links"][0]].rotation @ np.array(loop["axes"][0]))
        for spring in linkage["springs"]:
            markers = [self.marker(*end) for end in zip(spring["links"], spring["places"])]
            self.mbs.AddObject(items.SpringDamper(markerNumbers=markers, referenceLength=spring["length"], stiffness=spring["stiffness"]))
        for i, torque in enumerate(linkage["torques"]):
            if torque:
                self.torque(i, torque)
        self.mbs.Assemble()

    def add_planar(self, link, pose):
        center, velocity = pose.point(link["center"]), pose.speed(link["center"])
        angle = float(np.arctan2(pose.rotation[1, 0], pose.rotation[0, 0]))
        node = self.mbs.AddNode(
            items.NodeRigidBody2D(
                referenceCoordinates=[center[0], center[1], angle], initialVelocities=[velocity[0], velocity[1], pose.rate[2]]
            )
        )
        body = self.mbs.AddObject(items.RigidBody2D(mass=link["mass"], inertia=link["tensor"][2][2], nodeNumber=node))
        self.nodes.append(node)
        self.bodies.append(body)
        self.weigh(len(self.bodies) - 1, link)

    def weigh(self, number, link):
        marker = self.mbs.AddMarker(items.MarkerBodyPosition(bodyNumber=self.bodies[number], localPosition=LINEAR))
        weight = (link["mass"] * np.array(self.linkage["gravity"])).tolist()
        self.mbs.AddLoad(items.Force(markerNumber=marker, loadVector=weight))

    def add_spatial(self, link, pose):
        inertia = utilities.RigidBodyInertia(mass=link["mass"], inertiaTensor=np.array(link["tensor"]), com=np.zeros(3))
        made = self.mbs.CreateRigidBody(
            inertia=inertia, referencePosition=pose.point(link["center"]).tolist(), referenceRotationMatrix=pose.rotation,
            initialVelocity=pose.speed(link["center"]).tolist(), initialAngularVelocity=pose.rate.tolist(),
            gravity=self.linkage["gravity"], returnDict=True,
        )  # fmt: skip
        self.nodes.append(made["nodeNumber"])
        self.bodies.append(made["bodyNumber"])

    def local(self, number, place):
        """From the centre of mass, which is where this library's bodies are."""
        return (np.array(place) - (np.array(self.links[number]["center"]) if number >= 0 else 0)).tolist()

    def marker(self, number, place):
        body = self.bodies[number] if number >= 0 else self.ground
        return self.mbs.AddMarker(items.MarkerBodyPosition(bodyNumber=body, localPosition=self.local(number, place)))

    def hinge(self, first, second, axis):
        if self.linkage["planar"]:
            self.mbs.AddObject(items.RevoluteJoint2D(markerNumbers=[self.marker(*first), self.marker(*second)]))
            return
        numbers = [self.bodies[number] if number >= 0 else self.ground for number, _ in (first, second)]
        place = self.at[first[0]].point(first[1])
        self.mbs.CreateRevoluteJoint(bodyNumbers=numbers, position=place.tolist(), axis=axis.tolist(), useGlobalFrame=True)

    def torque(self, number, value):
        parent = self.links[number]["parent"]
        for at, sign in ((number, 1), (parent, -1)):
            if at >= 0:
                marker = self.mbs.AddMarker(items.MarkerBodyRigid(bodyNumber=self.bodies[at], localPosition=LINEAR))
                self.mbs.AddLoad(items.Torque(markerNumber=marker, loadVector=[0, 0, sign * value]))

    def simulate(self, end, steps):
        """Seconds, and angles at the end."""
        settings = exu.SimulationSettings()
        settings.timeIntegration.numberOfSteps = steps
        settings.timeIntegration.endTime = end
        settings.timeIntegration.verboseMode = 0
        settings.timeIntegration.generalizedAlpha.spectralRadius = RADIUS
        settings.timeIntegration.newton.useModifiedNewton = True
        settings.solution.file.write = False
        settings.show.statistics = False
        settings.show.computationTime = False
        if len(self.links) > 15:
            settings.linearSolverType = exu.LinearSolverType.EigenSparse
        begin = time.perf_counter()
        self.mbs.SolveDynamic(settings, exu.DynamicSolverType.GeneralizedAlpha)
        passed = time.perf_counter() - begin
        return passed, self.angles()

    def angles(self):
        rotations = [np.array(self.mbs.GetNodeOutput(node, exu.OutputVariableType.RotationMatrix)).reshape(3, 3) for node in self.nodes]
        return angles(self.linkage, rotations)


def main():
    linkage, told = (json.load(open(path)) for path in sys.argv[1:3])
    exu.config.printToConsole = False
    found, said = [], ""
    for steps in told["steps"]:
        try:
            seconds, end = System(linkage, told).simulate(told["end"], steps)
        except Exception as error:  # the library raises many kinds; a step that is too long is no fault of it
            lines = [line for line in str(error).splitlines() if line.strip()]
            said = lines[0] if lines else type(error).__name__
            continue
        found.append([steps, seconds, end])
        if 2 * seconds > told["longest"]:
            break
    if not found:
        raise SystemExit(f"no run reached the end; error of the last: {said}")
    print(json.dumps(found))


if __name__ == "__main__":
    main()
