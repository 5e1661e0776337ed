"""General multibody engines: a program of ours each, and one row."""

import dataclasses

import numpy as np

from . import mechanism, native
from .table import measured

FLAGS = "-O3 -march=native -std=c++17 -DNDEBUG"
RODS = "rods.bin"


def compiled(scratch, source, libraries, defines, flags=FLAGS):
    """Builds an engine's program; gives it and what it was compiled with."""
    label = f"{native.compiler('g++')} {flags}"
    native.geometry_file(scratch)
    program = scratch / source.removesuffix(".cpp")
    native.build("g++", source, f"{flags} -I{scratch}", defines, program, libraries)
    return program, label


def row(scratch, command, method, version, flags, note, known=3):
    """Runs an engine's program; `known`: 3 with accelerations, 2 without."""
    (scratch / RODS).unlink(missing_ok=True)
    told = {name: values for name, *values in native.lines(command, scratch)}
    time = tuple(map(float, told["step"]))
    errors = native.errors_of(scratch / "step.bin", "step")[:known]
    made = measured(method, version, flags, "step", time, errors, note)
    return asked(made, scratch / RODS, ",".join(told["lock"]))


def asked(row, rods, past_lock):
    """Adds what engines alone are asked: forces of rods, N, from a file that may not be there."""
    row.past_lock = past_lock
    if rods.exists():
        found = np.fromfile(rods).reshape(-1, mechanism.RODS)
        row.error_rods_n = float(abs(found - mechanism.rod_forces()).max())
    return row


def all_at_once(row):
    """An engine that integrates computes position, velocity and acceleration together: the position
    alone takes as long."""
    yield dataclasses.replace(row, quantity="position", error_velocity_m_s="", error_acceleration_m_s2="")
    yield row
