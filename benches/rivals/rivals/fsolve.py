"""SciPy's fsolve from the same prediction, with and without the analytic Jacobian."""

import time

import numpy as np

from . import mechanism
from .mechanism import STEP, STEPS
from .table import Missing, measured, median_and_spread

try:
    import scipy
    from scipy.optimize import fsolve
except ImportError:
    scipy = None

BATCHES = 9
# With each the loosest tolerance that keeps 1e-14 m over the whole motion.
SETTINGS = {"analytic Jacobian": 1e-6, "Jacobian by differences": 1e-10}
STRIDE = 30
NAMES = [*mechanism.CHASSIS, *(f"p{p}" for p in range(6, 11))]
FIRST, SECOND = (np.array([NAMES.index(link[end]) for link in mechanism.LINKS]) for end in (0, 1))
SQUARES = np.array([length**2 for *_, length in mechanism.LINKS])
CHASSIS = np.array(list(mechanism.CHASSIS.values()))
ROWS = np.arange(len(mechanism.LINKS))[:, None]


def _differences(q):
    points = np.concatenate([CHASSIS, q.reshape(5, 3)])
    return points[SECOND] - points[FIRST]


def residual(q, angle):
    """As `mechanism.residual`, without loops in Python."""
    d = _differences(q)
    height = q[2] - CHASSIS[0, 2] - mechanism.DRIVEN_LENGTH * np.cos(angle)
    return np.append((np.einsum("ij,ij->i", d, d) - SQUARES) / 2, height)


def jacobian(q, _angle):
    d = _differences(q)
    matrix = np.zeros((15, 10, 3))
    matrix[ROWS[:, 0], SECOND] = d
    matrix[ROWS[:, 0], FIRST] -= d
    matrix[14, 5, 2] = 1.0
    return matrix[:, 5:].reshape(15, 15)


def rates(q, drive):
    """Velocity and acceleration at a solution."""
    angle, rate, second_rate = drive
    matrix = jacobian(q, angle)
    right = np.zeros(15)
    right[14] = -mechanism.DRIVEN_LENGTH * np.sin(angle) * rate
    velocity = np.linalg.solve(matrix, right)
    right[:14] = -_curvature(q, velocity)
    right[14] = -mechanism.DRIVEN_LENGTH * (np.cos(angle) * rate**2 + np.sin(angle) * second_rate)
    return velocity, np.linalg.solve(matrix, right)


def _curvature(q, velocity):
    """Second derivative of the distances along the velocity: its own squared differences."""
    d = _differences(q + velocity) - _differences(q)
    return np.einsum("ij,ij->i", d, d)


def measure(_scratch):
    if scipy is None:
        raise Missing("SciPy cannot be imported")
    starts = mechanism.starts()
    for name, tolerance in SETTINGS.items():
        derivative = jacobian if name.startswith("analytic") else None
        note = "vectorised NumPy callbacks; numpy.linalg.solve twice for the rates"
        flags = f"{name}, xtol {tolerance:g}"
        for quantity, clock, errors in _results(_solver(derivative, tolerance), starts):
            yield measured("SciPy fsolve", scipy.__version__, flags, quantity, clock, errors, note)


def _solver(derivative, tolerance):
    def position(motion, angle):
        q, v, a = motion.reshape(3, 15)
        guess = q + STEP * (v + STEP / 2 * a)
        return fsolve(residual, guess, angle, fprime=derivative, xtol=tolerance)

    return position


def _results(position, starts):
    motions = np.zeros((STEPS, 45))
    motions[:, :15] = [position(starts[k, 3:], starts[k + 1, 0]) for k in range(STEPS)]

    def some():
        for k in range(0, STEPS, STRIDE):
            position(starts[k, 3:], starts[k + 1, 0])

    yield "position", _clock(some, len(range(0, STEPS, STRIDE))), mechanism.errors(motions)[:1]

    def follow():
        motion = starts[0, 3:]
        for k in range(1, STEPS + 1):
            q = position(motion, starts[k, 0])
            motion = motions[k - 1] = np.concatenate([q, *rates(q, starts[k, :3])])

    clock = _clock(follow, STEPS)
    yield "step", clock, mechanism.errors(motions)


def _clock(work, calls):
    """Median and spread of the batches, ns a call."""
    batches = []
    for _ in range(BATCHES):
        begin = time.perf_counter_ns()
        work()
        batches.append((time.perf_counter_ns() - begin) / calls)
    return median_and_spread(batches)
