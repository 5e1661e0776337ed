"""pymycar's multilink on the same mechanism, driven as pymycar drives: by the wheel centre's height."""

import contextlib
import io
import time
from importlib.metadata import version

import numpy as np

from . import mechanism
from .table import Missing, measured, median_and_spread

try:
    from pymycar.CarKinematic import multilink
except ImportError:
    multilink = None

SWEEPS = 5
STEPS = 200
# Our assumption: the paper prints no wheel centre.
AXLE = np.array([0.0, 0.1, 0.0])
NOTE = (
    "nearest it supports: knuckle with two more points (21 unknowns), driven by the wheel centre's height; "
    "fsolve inside its sweep, differences, xtol 1e-12; timed without its files; error against the "
    "fifteen equations at its own driving angle"
)


def measure(scratch):
    if multilink is None:
        raise Missing("pymycar cannot be imported")
    motion = mechanism.starts()
    points = {name: motion[1000, 3:][mechanism.unknown(name)] for name in ("p6", "p7", "p8", "p9", "p10")}
    travel = abs(motion[1100, 3 + 8] - motion[1000, 3 + 8]) / 100
    swept, times = zip(*(_sweep(_data(points), travel, scratch) for _ in range(SWEEPS)))
    clock = median_and_spread(np.array(times) / STEPS)
    yield measured("pymycar multilink", version("pymycar"), "", "position", clock, [_error(swept[0])], NOTE)


def _data(points):
    places = {
        "uca_outer": "p7",
        "uca_outer_aux": "p8",
        "lca_outer": "p6",
        "lca_outer_aux": "p9",
        "tierod_outer": "p10",
    }
    chassis = {"UCA_FRONT": "p2", "UCA_REAR": "p3", "LCA_FRONT": "p1", "LCA_REAR": "p4", "TIEROD_INNER": "p5"}
    return {
        **{key: points[name].copy() for key, name in places.items()},
        **{key: mechanism.CHASSIS[name].copy() for key, name in chassis.items()},
        "wheel_center": points["p8"] + AXLE,
        "wheel_center_axis": points["p8"] + AXLE / 2,
    }


def _sweep(data, travel, scratch):
    """Solutions over `STEPS` heights upwards, and what its solver took for them, ns."""
    taken = []
    solve = multilink.solve

    def timed(*arguments, **options):
        begin = time.perf_counter_ns()
        found = solve(*arguments, **options)
        taken.append(time.perf_counter_ns() - begin)
        return found

    multilink.solve = timed
    try:
        # It writes a log beside where it is started.
        with contextlib.redirect_stdout(io.StringIO()), contextlib.chdir(scratch):
            solution, _ = multilink.multilink(data, STEPS * travel, 0.0, travel, save_to_txt=False)
    finally:
        multilink.solve = solve
    return solution, taken[0]


def _error(solution):
    """Largest distance of a coordinate from the root of our equations at the same driving angle."""
    keys = ("lca_outer", "uca_outer", "uca_outer_aux", "lca_outer_aux", "tierod_outer")
    found = np.hstack([solution[key] for key in keys])
    worst = 0.0
    for row in found:
        angle = np.arccos((row[2] - mechanism.CHASSIS["p1"][2]) / mechanism.DRIVEN_LENGTH)
        q = row.copy()
        for _ in range(3):
            q -= np.linalg.solve(mechanism.jacobian(q), mechanism.residual(q, angle))
        worst = max(worst, abs(q - row).max())
    return worst
