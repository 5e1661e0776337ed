"""MuJoCo from C++, by the library and headers of its wheel."""

import sysconfig
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

from . import engines
from .table import Missing

FOLDER = Path(sysconfig.get_path("purelib")) / "mujoco"
BY_HAND = "solref of two time steps, solimp 0.9999; angle, rate and acceleration set by hand, a heavy joint"
VARIANTS = {
    "MuJoCo": ({}, "rods as tendons and the angle as equalities, all as by default"),
    "MuJoCo, stiff": ({"STIFF": None}, f"rods as tendon equalities, {BY_HAND}"),
    "MuJoCo, stiff, 10 substeps": ({"STIFF": None, "SUBSTEPS": 10}, "the same in steps of 0.1 ms"),
}


def measure(scratch):
    try:
        found = version("mujoco")
    except PackageNotFoundError as reason:
        raise Missing("mujoco is not installed") from reason
    library = FOLDER / f"libmujoco.so.{found}"
    options = ["-isystem", FOLDER / "include", library, f"-Wl,-rpath,{FOLDER}"]
    for name, (defines, note) in VARIANTS.items():
        program, flags = engines.compiled(scratch, "mujoco.cpp", options, defines)
        row = engines.row(scratch, [program], name, found, flags, note)
        yield from engines.all_at_once(row)
