"""Bodies with the modes of a file: the mass as points that weigh alike, whose kinetic energy is summed one by one.

The integrals C = ∫ (1, f)(1, f)ᵀ dm / m with f = (x, y, z, φ_1x, φ_1y, φ_1z, …) are those of as many points as they have rows: of a root of C
whose columns are turned until each has the same first entry. No invariant and no formula of M is formed. What nodes have by turning is
½ ω·J ω + ω·B ṗ + ½ ṗ·D ṗ.
"""

from dataclasses import dataclass

import casadi as ca
import numpy as np

from space_frames import tilde


@dataclass(frozen=True, eq=False)
class Spot:
    """A place with how each mode moves and turns it, row by row of modes."""

    at: np.ndarray
    shifts: np.ndarray
    turns: np.ndarray


class Modal:
    """What a beam is to the other scripts, for numbers of a file."""

    shapes = "modal"  # its frame is no place
    torsion = 0
    thick = None

    def __init__(self, body, given):
        numbers = body["modal"]
        self.names = [f"mode[{number}]" for number in numbers["modes"]]
        self.mass = numbers["mass"]
        self.nodes = [Spot(*(np.array(node[key]) for key in ("at", "shifts", "turns"))) for node in numbers["nodes"]]
        self.generalised_mass, self.stiffness = (np.array(numbers[key]) for key in ("generalised_mass", "stiffness"))
        moments = np.array(numbers["moments"])
        first = self.mass * np.array(numbers["center"]), *np.array(numbers["momentum"])
        whole = np.block([[np.array([[self.mass]]), np.concatenate(first)[None, :]], [np.concatenate(first)[:, None], moments]]) / self.mass
        self.points = self._points(whole)
        count = len(self.names)
        placed = moments[:3, :3]
        self.turning_inertia = tidy(np.array(numbers["inertia"]) - (np.trace(placed) * np.eye(3) - placed), self.mass)
        # (r × φ)_a = r_b φ_c − r_c φ_b.
        mixed = moments[:3, 3:].reshape(3, count, 3)
        swept = np.array([[mixed[(a + 1) % 3, j, (a + 2) % 3] - mixed[(a + 2) % 3, j, (a + 1) % 3] for j in range(count)] for a in range(3)])
        self.turning_momentum = tidy(np.array(numbers["angular_momentum"]).T - swept, self.mass)
        traces = np.einsum("jaka->jk", moments[3:, 3:].reshape(count, 3, count, 3))
        self.turning_modes = tidy(self.generalised_mass - traces, self.mass)
        ratio = given.get("damping_ratio", ca.SX(0))
        # 2 ζ M Ψ Ω Ψᵀ M with Ψᵀ M Ψ = 1.
        lower = np.linalg.inv(np.linalg.cholesky(self.generalised_mass))
        squares, natural = np.linalg.eigh(lower @ self.stiffness @ lower.T)
        shapes = lower.T @ natural
        carried = self.generalised_mass @ shapes
        self.resistance = ratio * ca.SX(2 * carried @ np.diag(np.sqrt(np.abs(squares))) @ carried.T)

    @staticmethod
    def _points(whole):
        sizes = np.sqrt(np.diag(whole))
        over = np.divide(1, sizes, out=np.zeros_like(sizes), where=sizes > 0)
        values, vectors = np.linalg.eigh(whole * np.outer(over, over))
        root = sizes[:, None] * (vectors * np.sqrt(np.maximum(values, 0))) @ vectors.T
        count = len(sizes)
        # The turn in the plane of the first row and (1, 1, …) that takes one to the other.
        row, equal = root[0] / np.linalg.norm(root[0]), np.ones(count) / np.sqrt(count)
        way = row - equal
        if np.linalg.norm(way) > 1e-15:
            root = root - 2 * np.outer(root @ way, way) / (way @ way)
        columns = np.sqrt(count) * root[1:].T
        return [Spot(column[:3], column[3:].reshape(-1, 3), np.zeros((0, 3))) for column in columns]

    def slices(self):
        return [(point, 1 / len(self.points)) for point in self.points]

    def spot(self, local):
        """The node at a place of the body."""
        at = np.array(ca.evalf(ca.SX(local))).ravel()
        return min(self.nodes, key=lambda node: np.linalg.norm(node.at - at))

    def deformed(self, spot, p):
        return ca.SX(spot.at) + sum((ca.SX(shift) * q for shift, q in zip(spot.shifts, p)), ca.SX.zeros(3))

    def turned(self, spot, p):
        """Cayley's rotation with the turn of the node as its first order."""
        half = sum((ca.SX(turn) * q for turn, q in zip(spot.turns, p)), ca.SX.zeros(3)) / 2
        return ca.simplify(ca.mtimes(ca.inv(ca.SX.eye(3) - tilde(half)), ca.SX.eye(3) + tilde(half)))

    def turning_energy(self, omega, rates):
        """Beyond ½ ω·J ω."""
        return ca.dot(omega, ca.mtimes(ca.SX(self.turning_momentum), rates)) + ca.dot(rates, ca.mtimes(ca.SX(self.turning_modes), rates)) / 2

    def elastic_energy(self, p):
        p = ca.vertcat(*p)
        return ca.dot(p, ca.mtimes(ca.SX(self.stiffness), p)) / 2

    def modal_forces(self, rates, _):
        return ca.vertsplit(-ca.mtimes(self.resistance, ca.vertcat(*rates)))


def tidy(values, mass):
    """What is nothing but for rounding in the file."""
    return np.where(np.abs(values) < 1e-10 * mass, 0.0, values)
