"""The published five-point suspension: data, equations, motion and 40-digit reference.

Unknowns `q` (15): points 6 to 10 in a row, m. Equations: half of `|p_j - p_i|^2 - d^2` for the
fourteen distances of the listing, then `z6 - z1 - d6_1 cos(theta)`.
"""

import csv
import functools
import tomllib
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[3]
STEP = 1e-3
STEPS = 1900  # to t = 1.9 s
REFERENCE = ROOT / "tests/data/attia2003_reference.csv"

_PAPER = tomllib.loads((ROOT / "src/commands/published/attia2003.toml").read_text())


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

DRIVE = _PAPER["drive"]["theta_coefficients"]
"""Of the driving angle in powers of time, rad and s."""

LOAD = np.array([0.0, 0.0, 3000.0])
"""The force at the wheel centre under which reactions are compared, N."""

LOADED = range(100, STEPS, 100)
"""The steps after which it is put on the mechanism at rest."""

RODS = 4
"""Links 7-2, 8-3, 9-4 and 10-5, whose forces are compared."""


def theta(t):
    """Driving angle (rad), its rate and second rate."""
    c0, c1, c2 = DRIVE
    return c0 + c1 * t + c2 * t * t, c1 + 2 * c2 * t, 2 * c2


def unknown(name):
    """Where a knuckle point is in `q`."""
    first = 3 * (int(name[1:]) - 6)
    return slice(first, first + 3)


def _point(q, name):
    return CHASSIS[name] if name in CHASSIS else q[unknown(name)]


def residual(q, angle):
    """The fifteen equations, m^2 (the last: m), in the precision of `q`."""
    distances = []
    for first, second, length in LINKS:
        d = _point(q, second) - _point(q, first)
        distances.append((d @ d - length * q.dtype.type(length)) / 2)
    height = q[2] - CHASSIS["p1"][2] - DRIVEN_LENGTH * np.cos(q.dtype.type(angle))
    return np.array([*distances, height])


def jacobian(q):
    """Derivatives of `residual` by `q`, 15 x 15."""
    matrix = np.zeros((15, 15), q.dtype)
    for row, (first, second, _) in enumerate(LINKS):
        d = _point(q, second) - _point(q, first)
        matrix[row, unknown(second)] = d
        if first not in CHASSIS:
            matrix[row, unknown(first)] = -d
    matrix[14, 2] = 1
    return matrix


def solve(matrix, right):
    """Linear solution in the precision of the arguments, refined from factors in f64."""
    solution = np.zeros_like(right)
    for _ in range(3):
        remaining = right - matrix @ solution
        solution = solution + np.linalg.solve(matrix.astype(float), remaining.astype(float))
    return solution


def rates(q, drive):
    """Velocity and acceleration of `q` at a solution."""
    angle, rate, second_rate = map(q.dtype.type, drive)
    matrix = jacobian(q)
    along_drive = np.zeros_like(q)
    along_drive[14] = -DRIVEN_LENGTH * np.sin(angle) * rate
    velocity = solve(matrix, along_drive)
    # The Jacobian is affine in q: its change along the velocity is a difference of two.
    curvature = (jacobian(q + velocity) - matrix) @ velocity
    along_drive[14] = -DRIVEN_LENGTH * (np.cos(angle) * rate**2 + np.sin(angle) * second_rate)
    return velocity, solve(matrix, along_drive - curvature)


def _reference():
    """Rows of the 40-digit solution: number of the step, `q qdot qddot`."""
    with REFERENCE.open() as file:
        for row in csv.DictReader(file):
            kinds = ("", "v", "a")
            names = [f"p{p}_{kind}{axis}" for kind in kinds for p in range(6, 11) for axis in "xyz"]
            yield round(float(row["t_s"]) / STEP), np.array([float(row[name]) for name in names])


@functools.cache
def starts():
    """Instant 0 to `STEPS`, a row each: theta, its rates (3), q, qdot, qddot (45).

    Newton's method in extended precision, followed from the 40-digit solution at t = 0.
    """
    _, first = next(_reference())
    q, v, a = first.reshape(3, 15).astype(np.longdouble)
    rows = []
    for k in range(STEPS + 1):
        drive = theta(k * STEP)
        for _ in range(3):
            q = q - solve(jacobian(q), residual(q, drive[0]))
        v, a = rates(q, drive)
        rows.append(np.concatenate([drive, q, v, a]).astype(float))
        q = q + STEP * (v + STEP / 2 * a)
    return np.array(rows)


def errors(motions):
    """Largest differences in position, velocity, acceleration: from the 40-digit solution at its
    instants, and from `starts` at all steps.

    `motions`: one row of 45 for each step from 1 to `STEPS`.
    """
    found = [abs(motions - starts()[1:, 3:])]
    found += [abs(motions[k - 1] - exact)[None] for k, exact in _reference() if 0 < k <= STEPS]
    return np.concatenate(found).reshape(-1, 3, 15).max(axis=(0, 2))


@functools.cache
def _wheel_weights():
    """Of points 6 to 9, whose sum is the wheel centre: 0.1 m outboard of point 8 with link 6-1 level."""
    level = starts()[np.argmin(abs(starts()[:, 0] - np.pi / 2)), 3:18]
    for _ in range(3):
        level = level - solve(jacobian(level), residual(level, np.pi / 2))
    known = np.vstack([level[:12].reshape(4, 3).T, np.ones(4)])
    return np.linalg.solve(known, [*(level[unknown("p8")] + [0.0, 0.1, 0.0]), 1.0])


def wheel_centre(q):
    """From point 6, m."""
    return _wheel_weights() @ q[:12].reshape(4, 3) - q[:3]


def wheel_centres():
    """The same at the instants `LOADED`, a row each."""
    return np.array([wheel_centre(q) for q in starts()[LOADED, 3:18]])


def rod_forces():
    """Forces of the rods under `LOAD` at the instants `LOADED`, N, tension positive: virtual work."""
    forces = []
    on_unknowns = np.append(np.outer(_wheel_weights(), LOAD).ravel(), np.zeros(3))
    lengths = np.array([length for *_, length in LINKS[1 : 1 + RODS]])
    for q in starts()[LOADED, 3:18]:
        multipliers = np.linalg.solve(jacobian(q).T, on_unknowns)
        forces.append(multipliers[1 : 1 + RODS] * lengths)
    return np.array(forces)
