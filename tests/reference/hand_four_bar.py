"""A request for the four-bar of `mechanisms`, in tree coordinates, from equations derived by hand with angles.

Shares no line with the derivation it tests. Crank and coupler are a chain a – b, the rocker stands on d, the knee is
cut; θ1, θ2, θ3 are the angles, ω their rates, eᵢ = (cos θᵢ, sin θᵢ), nᵢ = (−sin θᵢ, cos θᵢ). Reactions by
Newton–Euler, joint by joint.
"""

import numpy as np

L1, L2, L3 = 0.4, 1.0, 0.8
D = np.array([0.9, -0.1])
M2, M3, I3, G = 2.0, 1.5, 0.3, 9.81
I2 = M2 * L2**2 / 12


def request(definition, coordinates, count=30, seed=3):
    rng = np.random.default_rng(seed)
    head = {"definition": definition, "coordinates": coordinates, "parameters_are_si": True}
    random = [random_state(rng) for _ in range(count)]
    return head | {"random": random, "consistent": [consistent_state(rng) for _ in range(count)]}


def random_state(rng):
    theta, omega = rng.uniform(-3, 3, 3), rng.normal(size=3)
    m1, drive = rng.uniform(0.5, 2), rng.normal()
    mass, forces, jacobian, gamma, phi = equations(theta, omega, m1, drive)
    return given(theta, omega, m1, drive) | energies(theta, omega, m1, drive) | {
        "phi": phi.tolist(),
        "nu": [0.0, 0.0],
        "gamma": gamma.tolist(),
        "forces": forces.tolist(),
        "jacobian": [[r, c, float(jacobian[r, c])] for r in range(2) for c in range(3)],
        "mass": [[r, c, float(mass[r, c])] for r in range(3) for c in range(r + 1)],
    }  # fmt: skip


def consistent_state(rng):
    theta1 = rng.uniform(-3, 3)
    theta = close(theta1)
    m1, drive = rng.uniform(0.5, 2), rng.normal()
    _, _, jacobian, _, _ = equations(theta, np.zeros(3), m1, drive)
    omega1 = rng.normal()
    omega = np.array([omega1, *np.linalg.solve(jacobian[:, 1:], -jacobian[:, 0] * omega1)])
    mass, forces, jacobian, gamma, _ = equations(theta, omega, m1, drive)
    kkt = np.block([[mass, jacobian.T], [jacobian, np.zeros((2, 2))]])
    solution = np.linalg.solve(kkt, np.concatenate([forces, gamma]))
    alpha, multipliers = solution[:3], solution[3:]
    bodies = motion(theta, omega, alpha)
    return given(theta, omega, m1, drive) | energies(theta, omega, m1, drive) | {
        "acceleration": alpha.tolist(),
        "lambda": multipliers.tolist(),
        "bodies": bodies.tolist(),
        "reactions": reactions(bodies, multipliers, m1, drive).tolist(),
        "multipliers": [],
        "driver_efforts": [],
        "driver_powers": [],
    }  # fmt: skip


def given(theta, omega, m1, drive):
    q = [value for angle in theta for value in (np.cos(angle), np.sin(angle))]
    return {
        "parameters": [m1], "time": 0.3, "inputs": [drive], "phases": [],
        "q": [float(x) for x in q], "v": omega.tolist(),
    }  # fmt: skip


def energies(theta, omega, m1, drive):
    bodies = motion(theta, omega, np.zeros(3))
    masses, inertias = [m1, M2, M3], [m1 * L1**2 / 12, I2, I3]
    speed = (bodies[:, 4:6] ** 2).sum(axis=1)
    return {
        "kinetic": float(np.dot(masses, speed) / 2 + np.dot(inertias, omega**2) / 2),
        "potential": float(G * np.dot(masses, bodies[:, 1])),
        "powers": [float(drive * omega[0])],
    }


def equations(theta, omega, m1, drive):
    (t1, t2, t3), (w1, w2, w3) = theta, omega
    h = M2 * L1 * L2 / 2  # coupling of crank and coupler
    mass = np.array(
        [
            [m1 * L1**2 / 3 + M2 * L1**2, h * np.cos(t1 - t2), 0],
            [h * np.cos(t1 - t2), M2 * L2**2 / 3, 0],
            [0, 0, I3 + M3 * L3**2 / 4],
        ]
    )
    forces = np.array(
        [
            drive - h * np.sin(t1 - t2) * w2**2 - G * (m1 * L1 / 2 + M2 * L1) * np.cos(t1),
            h * np.sin(t1 - t2) * w1**2 - G * M2 * L2 / 2 * np.cos(t2),
            -G * M3 * L3 / 2 * np.cos(t3),
        ]
    )
    jacobian = np.array(
        [
            [-L1 * np.sin(t1), -L2 * np.sin(t2), L3 * np.sin(t3)],
            [L1 * np.cos(t1), L2 * np.cos(t2), -L3 * np.cos(t3)],
        ]
    )
    along = np.array([L1 * w1**2, L2 * w2**2, -L3 * w3**2])
    gamma = np.array([along @ np.cos(theta), along @ np.sin(theta)])
    lengths = np.array([L1, L2, -L3])
    phi = np.array([lengths @ np.cos(theta), lengths @ np.sin(theta)]) - D
    return mass, forces, jacobian, gamma, phi


def close(theta1):
    """θ2, θ3 with the knee above the line from crank pin to d: intersection of two circles."""
    b = L1 * np.array([np.cos(theta1), np.sin(theta1)])
    r = D - b
    distance = np.hypot(*r)
    along = (L2**2 - L3**2 + distance**2) / (2 * distance)
    height = np.sqrt(L2**2 - along**2)
    knee = b + (along * r + height * np.array([-r[1], r[0]])) / distance
    return np.array([theta1, np.arctan2(*(knee - b)[::-1]), np.arctan2(*(knee - D)[::-1])])


def motion(theta, omega, alpha):
    """[x y c s vx vy ω ax ay α] of crank, coupler, rocker."""
    e = np.stack([np.cos(theta), np.sin(theta)], axis=1)
    n = np.stack([-np.sin(theta), np.cos(theta)], axis=1)
    velocity = n * omega[:, None]
    acceleration = n * alpha[:, None] - e * (omega**2)[:, None]

    def centers(part):
        return np.array([L1 / 2 * part[0], L1 * part[0] + L2 / 2 * part[1], L3 / 2 * part[2]])

    x = centers(e)
    x[2] += D
    return np.hstack([x, e, centers(velocity), omega[:, None], centers(acceleration), alpha[:, None]])


def reactions(bodies, multipliers, m1, drive):
    """Force of each joint on its second place's body: a → crank, b → coupler, knee → rocker, d → rocker."""
    weight = np.array([0.0, -G])
    knee = multipliers  # row = p1 − p2: +λ on the second
    crank, coupler, rocker = bodies[:, 7:9]
    d = M3 * (rocker - weight) - knee
    b = M2 * (coupler - weight) + knee  # the coupler also bears −knee
    a = m1 * (crank - weight) + b
    return np.array([[*a, 0.0], [*b, 0.0], [*knee, 0.0], [*d, 0.0]])
