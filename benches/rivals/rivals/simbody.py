"""Simbody in C++, from Debian's package."""

from pathlib import Path

from . import engines
from .table import Missing

HEADERS = Path("/usr/include/simbody")
LIBRARIES = ["-lSimTKsimbody", "-lSimTKmath", "-lSimTKcommon"]
# Classes have another layout with NDEBUG, without which Debian's library is built.
FLAGS = "-O3 -march=native -std=c++17"
NOTE = "four rods as constraints, prescribed angle, projected each step (1e-13)"


def measure(scratch):
    if not HEADERS.exists():
        raise Missing("Simbody is not installed (apt-get install libsimbody-dev)")
    library = next(Path("/usr/lib").glob("*/libSimTKsimbody.so.*"))
    options = ["-isystem", HEADERS, *LIBRARIES]
    program, flags = engines.compiled(scratch, "simbody.cpp", options, {}, FLAGS)
    version = library.name.split(".so.")[1]
    yield engines.row(scratch, [program], "Simbody", version, flags, NOTE)
