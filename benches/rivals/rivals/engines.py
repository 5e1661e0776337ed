"""General multibody engines: a program of ours each, and one row."""

import dataclasses

import numpy as np

from . import mechanism, native
from .table import measured

FLAGS = "-O3 -march=native -std=c++17 -DNDEBUG"


def compiled(scratch, source, libraries, defines, flags=FLAGS):
    """Builds an engine's program; gives it and what it was compiled with."""
    label = f"{native.compiler('g++')} {flags}"
    native.geometry_file(scratch)
    program = scratch / source.removesuffix(".cpp")
    native.build("g++", source, f"{flags} -I{scratch}", defines, program, libraries)
    return program, label


def row(scratch, program, method, version, flags, note):
    """Runs an engine's program."""
    told = dict((name, values) for name, *values in native.lines(program, scratch))
    time = tuple(map(float, told["step"]))
    errors = native.errors_of(scratch / "step.bin", "step")
    return of_engine(scratch, method, version, flags, time, errors, ",".join(told["lock"]), note)


def of_engine(scratch, method, version, flags, time, errors, past_lock, note):
    made = measured(method, version, flags, "step", time, errors, note)
    made.error_rods_n = rods_error(scratch / "rods.bin")
    made.past_lock = past_lock
    return made


def rods_error(path):
    """Largest difference of a rod's force under the load, N."""
    found = np.fromfile(path).reshape(-1, mechanism.RODS)
    return float(abs(found - mechanism.rod_forces()).max())


def all_at_once(row):
    """An engine that integrates computes position, velocity and acceleration together: the position
    alone takes as long."""
    yield dataclasses.replace(row, quantity="position", error_velocity_m_s="", error_acceleration_m_s2="")
    yield row
