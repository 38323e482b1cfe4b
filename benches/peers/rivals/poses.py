"""Poses and velocities of links from the angles of their hinges, for peers that live in Python and take bodies one by one.

Needs numpy alone, because it runs in the peers' environments.
"""

import numpy as np


def turn(axis, angle):
    """Rodrigues' formula."""
    x, y, z = axis
    k = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * k + (1 - np.cos(angle)) * k @ k


class Pose:
    """World axes: rotation, place of the hinge, its velocity, angular velocity."""

    def __init__(self, rotation=np.eye(3), place=np.zeros(3), velocity=np.zeros(3), rate=np.zeros(3)):
        self.rotation, self.place, self.velocity, self.rate = rotation, place, velocity, rate

    def point(self, local):
        return self.place + self.rotation @ np.asarray(local)

    def speed(self, local):
        return self.velocity + np.cross(self.rate, self.rotation @ np.asarray(local))


def poses(linkage, q, v):
    """Of all links; the ground's is the last, so that its number is −1."""
    found = [None] * len(linkage["links"]) + [Pose()]
    for i, link in enumerate(linkage["links"]):
        before = found[link["parent"]]
        axes, axis = np.array(link["axes"]), np.array(link["axis"])
        rotation = before.rotation @ axes @ turn(axis, q[i])
        rate = before.rate + rotation @ axis * v[i]
        found[i] = Pose(rotation, before.point(link["place"]), before.speed(link["place"]), rate)
    return found


def angles(linkage, rotations):
    """Angles of the hinges from the rotations of all links."""
    found = []
    rotations = [*rotations, np.eye(3)]
    for link, rotation in zip(linkage["links"], rotations):
        c = np.array(link["axes"]).T @ rotations[link["parent"]].T @ rotation
        vee = np.array([c[2, 1] - c[1, 2], c[0, 2] - c[2, 0], c[1, 0] - c[0, 1]]) / 2
        found.append(float(np.arctan2(vee @ link["axis"], (np.trace(c) - 1) / 2)))
    return found
