"""Rotations of space as CasADi matrices: quaternions, turns about axes, the canonical frame of an axis, marker axes.

A rotation matrix takes components in the turned axes to those in the axes it is turned from; its columns are the
turned axes. Knows nothing of bodies and joints.
"""

import casadi as ca
import numpy as np

SMALL = 1e-15  # what is left of an exact zero in an entry of order one


def unit(vector):
    return vector / ca.sqrt(ca.dot(vector, vector))


def tilde(vector):
    """The matrix of vector × ·."""
    x, y, z = (vector[k] for k in range(3))
    return ca.vertcat(ca.horzcat(0, -z, y), ca.horzcat(z, 0, -x), ca.horzcat(-y, x, 0))


def vee(matrix):
    """The vector of the antisymmetric part."""
    return ca.vertcat(matrix[2, 1] - matrix[1, 2], matrix[0, 2] - matrix[2, 0], matrix[1, 0] - matrix[0, 1]) / 2


def quaternion_matrix(q):
    """A = 1 + 2 w x̃ + 2 x̃² of a unit quaternion (w, x)."""
    x = tilde(q[1:4])
    return ca.SX.eye(3) + 2 * q[0] * x + 2 * ca.mtimes(x, x)


def quaternion_rate(q, omega):
    """½ q ⊗ (0, ω), ω in the turned axes."""
    w, x = q[0], q[1:4]
    return ca.vertcat(-ca.dot(x, omega), w * omega + ca.cross(x, omega)) / 2


def turn_about(k, cosine, sine):
    """About the coordinate axis number k, from axis k + 1 to axis k + 2."""
    result = ca.SX.zeros(3, 3)
    i, j = (k + 1) % 3, (k + 2) % 3
    result[k, k] = 1
    result[i, i] = result[j, j] = cosine
    result[j, i], result[i, j] = sine, -sine
    return result


def turn_in(frame, cosine, sine):
    """About the z of a frame J: J Rot(z) Jᵀ."""
    return cleaned(ca.mtimes(ca.mtimes(frame, turn_about(2, cosine, sine)), frame.T))


def canonical_frame(axis, at):
    """J(a): z = a/|a|, k the largest |component| of a (the first of equals, in the numbers `at`), r the unit vector
    number (k + 1) mod 3, x = r − (r·z) z normalised, y = z × x."""
    k = int(np.argmax(np.abs(at)))
    reference = ca.SX.zeros(3)
    reference[(k + 1) % 3] = 1
    return frame_about(axis, reference)


def frame_about(axis, reference):
    z = unit(axis)
    x = unit(reference - ca.dot(reference, z) * z)
    return cleaned(ca.horzcat(x, ca.cross(z, x), z))


def cleaned(matrix):
    """Constant entries that are zero but for rounding become zero: cos 90°, products of axes at right angles.

    Such an entry has no magnitude of terms by which a difference could be judged.
    """
    result = ca.densify(ca.SX(matrix))
    constants = [float(entry) for entry in ca.vertsplit(ca.vec(result)) if entry.is_constant()]
    largest = max((abs(value) for value in constants), default=0.0)
    for row in range(result.shape[0]):
        for column in range(result.shape[1]):
            entry = result[row, column]
            if entry.is_constant() and abs(float(entry)) < SMALL * largest:
                result[row, column] = 0
    return result
