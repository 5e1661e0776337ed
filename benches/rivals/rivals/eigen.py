"""Eigen's PartialPivLU of fixed size, in C++."""

from pathlib import Path

from . import mechanism, native
from .table import QUANTITIES, Missing

INCLUDE = Path("/usr/include/eigen3")
NOTE = "fixed size; 1 iteration; a second factorisation for the rates; geometry is constant"


def measure(scratch):
    compiler = native.compiler("g++")
    if not INCLUDE.exists():
        raise Missing("Eigen is not installed (apt-get install libeigen3-dev)")
    (scratch / "geometry.h").write_text(_geometry())
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


def _geometry():
    """Links between chassis and knuckle, and within the knuckle; points as their place in `q`."""
    outer, inner = [], []
    for first, second, length in mechanism.LINKS:
        at = mechanism.unknown(second).start
        if first in mechanism.CHASSIS:
            x, y, z = map(float, mechanism.CHASSIS[first])
            outer.append(f"{{{{{x!r}, {y!r}, {z!r}}}, {at}, {length!r}}}")
        else:
            inner.append(f"{{{mechanism.unknown(first).start}, {at}, {length!r}}}")
    return (
        "struct Outer { double chassis[3]; int point; double length; };\n"
        f"constexpr Outer OUTER[] = {{{', '.join(outer)}}};\n"
        "struct Inner { int first, second; double length; };\n"
        f"constexpr Inner INNER[] = {{{', '.join(inner)}}};\n"
        f"constexpr double DRIVEN_LENGTH = {mechanism.DRIVEN_LENGTH!r};\n"
        f"constexpr double DRIVEN_FROM = {float(mechanism.CHASSIS['p1'][2])!r};\n"
    )
