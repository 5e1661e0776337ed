"""Eigen's PartialPivLU of fixed size, in C++."""

from pathlib import Path

from . import native
from .table import QUANTITIES, Missing

INCLUDE = Path("/usr/include/eigen3")
NOTE = "fixed size; 1 iteration; a second factorisation for the rates; geometry is constant"


def measure(scratch):
    compiler = native.compiler("g++")
    if not INCLUDE.exists():
        raise Missing("Eigen is not installed (apt-get install libeigen3-dev)")
    native.geometry_file(scratch)
    program = scratch / "eigen"
    for flags in native.FLAGS:
        flags = f"{flags} -DNDEBUG"
        native.build("g++", "eigen.cpp", f"{flags} -I{INCLUDE} -I{scratch}", {}, program)
        results = native.run(program, scratch)
        label = f"{compiler} {flags}"
        yield from native.rows("Eigen PartialPivLU", _version(), label, NOTE, results, QUANTITIES)


def _version():
    text = (INCLUDE / "Eigen/src/Core/util/Macros.h").read_text()
    parts = ("WORLD", "MAJOR", "MINOR")
    return ".".join(text.split(f"#define EIGEN_{part}_VERSION ")[1].split()[0] for part in parts)
