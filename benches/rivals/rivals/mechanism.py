"""The published five-point suspension: data, equations, motion and 40-digit reference.

Unknowns `q` (15): points 6 to 10 in a row, m. Equations: half of `|p_j - p_i|^2 - d^2` for the
fourteen distances of the listing, then `z6 - z1 - d6_1 cos(theta)`.
"""

import csv
import tomllib
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[3]
STEP = 1e-3
STEPS = 1900  # to t = 1.9 s
REFERENCE = ROOT / "tests/data/attia2003_reference.csv"

_PAPER = tomllib.loads((ROOT / "src/published/attia2003.toml").read_text())


def _corrected(place, printed):
    for correction in _PAPER["correction"]:
        if correction["where"] == place and correction["printed"] == printed:
            return correction["corrected"]
    return printed


CHASSIS = {
    name: np.array([_corrected(f"table1.{name} {axis}", x) for axis, x in zip("xyz", point)])
    for name, point in _PAPER["table1"].items()
}
"""Points 1 to 5, m; the misprinted sign corrected as the data file says."""

LINKS = [
    (f"p{small}", f"p{large}", length)
    for name, length in _PAPER["lengths"].items()
    for large, small in [name[1:].split("_")]
]
"""First point, second point, length in m."""

DRIVEN_LENGTH = _PAPER["lengths"]["d6_1"]


def theta(t):
    """Driving angle (rad), its rate and second rate."""
    c0, c1, c2 = _PAPER["drive"]["theta_coefficients"]
    return c0 + c1 * t + c2 * t * t, c1 + 2 * c2 * t, 2 * c2


def unknown(name):
    """Where a knuckle point is in `q`."""
    first = 3 * (int(name[1:]) - 6)
    return slice(first, first + 3)


def _point(q, name):
    return CHASSIS[name] if name in CHASSIS else q[unknown(name)]


def residual(q, angle):
    """The fifteen equations, m^2 (the last: m)."""
    distances = []
    for first, second, length in LINKS:
        d = _point(q, second) - _point(q, first)
        distances.append((d @ d - length * length) / 2)
    height = q[2] - CHASSIS["p1"][2] - DRIVEN_LENGTH * np.cos(angle)
    return np.array([*distances, height])


def jacobian(q):
    """Derivatives of `residual` by `q`, 15 x 15."""
    matrix = np.zeros((15, 15))
    for row, (first, second, _) in enumerate(LINKS):
        d = _point(q, second) - _point(q, first)
        matrix[row, unknown(second)] = d
        if first not in CHASSIS:
            matrix[row, unknown(first)] = -d
    matrix[14, 2] = 1.0
    return matrix


def rates(q, drive):
    """Velocity and acceleration of `q` at a solution."""
    angle, rate, second_rate = drive
    matrix = jacobian(q)
    drive_row = np.zeros(15)
    drive_row[14] = -DRIVEN_LENGTH * np.sin(angle) * rate
    velocity = np.linalg.solve(matrix, drive_row)
    # The Jacobian is affine in q: its change along the velocity is its own value there,
    # without what the chassis points add.
    curvature = (jacobian(q + velocity) - matrix) @ velocity
    drive_row[14] = -DRIVEN_LENGTH * (np.cos(angle) * rate**2 + np.sin(angle) * second_rate)
    return velocity, np.linalg.solve(matrix, drive_row - curvature)


def reference():
    """Rows of the 40-digit solution after t = 0 and up to t = 1.9 s: step number, `q qdot qddot`."""
    return {k: motion for k, motion in _reference_rows() if 0 < k <= STEPS}


def _reference_rows():
    with REFERENCE.open() as file:
        for row in csv.DictReader(file):
            kinds = ("", "v", "a")
            names = [f"p{p}_{kind}{axis}" for kind in kinds for p in range(6, 11) for axis in "xyz"]
            yield round(float(row["t_s"]) / STEP), np.array([float(row[name]) for name in names])


def starts():
    """Instant 0 to `STEPS`, a row each: theta, its rates (3), q, qdot, qddot (45).

    Followed in f64 from the reference at t = 0, Newton to rounding.
    """
    _, first = next(_reference_rows())
    q, v, a = first.reshape(3, 15)
    rows = [np.concatenate([theta(0.0), first])]
    for k in range(1, STEPS + 1):
        drive = theta(k * STEP)
        q = q + STEP * (v + STEP / 2 * a)
        for _ in range(3):
            q = q - np.linalg.solve(jacobian(q), residual(q, drive[0]))
        v, a = rates(q, drive)
        rows.append(np.concatenate([drive, q, v, a]))
    return np.array(rows)


def errors(motions):
    """Largest differences from the reference in position, velocity, acceleration.

    `motions`: one row of 45 for each step from 1 to `STEPS`.
    """
    found = [abs(motions[k - 1] - exact).reshape(3, 15).max(axis=1) for k, exact in reference().items()]
    return np.max(found, axis=0)
