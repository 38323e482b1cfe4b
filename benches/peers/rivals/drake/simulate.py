"""Drake simulates a tree: a continuous plant, by Runge–Kutta of order three with fixed steps.

    python simulate.py LINKAGE.json TOLD.json

Prints [[steps, seconds, angles at the end], …]. Runs in Drake's own environment.
"""

import json
import sys
import time

import numpy as np
from pydrake.math import RigidTransform, RotationMatrix
from pydrake.multibody.plant import MultibodyPlant
from pydrake.multibody.tree import FixedOffsetFrame, RevoluteJoint, SpatialInertia, UnitInertia
from pydrake.systems.analysis import ResetIntegratorFromFlags, Simulator


def plant_of(linkage):
    plant = MultibodyPlant(0.0)
    plant.mutable_gravity_field().set_gravity_vector(np.array(linkage["gravity"]))
    bodies = []
    for link in linkage["links"]:
        mass, center = link["mass"], np.array(link["center"])
        tensor = np.array(link["tensor"]) + mass * (center @ center * np.eye(3) - np.outer(center, center))
        unit = tensor / mass
        inertia = SpatialInertia(
            mass, center, UnitInertia(unit[0, 0], unit[1, 1], unit[2, 2], unit[0, 1], unit[0, 2], unit[1, 2]), skip_validity_check=True
        )
        bodies.append(plant.AddRigidBody(link["name"], inertia))
        parent = bodies[link["parent"]] if link["parent"] >= 0 else plant.world_body()
        place = RigidTransform(RotationMatrix(np.array(link["axes"])), np.array(link["place"]))
        joint = RevoluteJoint(
            link["joint"],
            plant.AddFrame(FixedOffsetFrame(link["joint"] + "_at", parent.body_frame(), place)),
            bodies[-1].body_frame(), np.array(link["axis"]),
        )  # fmt: skip
        plant.AddJoint(joint)
    plant.Finalize()
    return plant


def simulate(linkage, told, steps):
    plant = plant_of(linkage)
    simulator = Simulator(plant)
    context = simulator.get_mutable_context()
    joints = [plant.GetJointByName(link["joint"]) for link in linkage["links"]]
    for joint, q, v in zip(joints, told["q"], told["v"]):
        joint.set_angle(context, q)
        joint.set_angular_rate(context, v)
    step = told["end"] / steps
    integrator = ResetIntegratorFromFlags(simulator=simulator, scheme="runge_kutta3", max_step_size=step)
    integrator.set_fixed_step_mode(True)
    simulator.Initialize()
    begin = time.perf_counter()
    simulator.AdvanceTo(told["end"])
    passed = time.perf_counter() - begin
    return passed, [joint.get_angle(simulator.get_context()) for joint in joints]


def main():
    linkage, told = (json.load(open(path)) for path in sys.argv[1:3])
    found, said = [], ""
    for steps in told["steps"]:
        try:
            seconds, end = simulate(linkage, told, steps)
        except RuntimeError as error:
            said = str(error)
            continue
        found.append([steps, seconds, end])
        if 2 * seconds > told["longest"]:
            break
    if not found:
        raise SystemExit(f"no run reached the end; error of the last: {said}")
    print(json.dumps(found))


if __name__ == "__main__":
    main()
