"""Compiled rivals: built, run over the recorded starts, and held beside the reference."""

import platform
import shutil
import subprocess

import numpy as np

from . import mechanism
from .table import Missing, measured

SOURCES = mechanism.ROOT / "benches/rivals/native"
FLAGS = ["-O3 -march=native", "-O3 -march=native -ffast-math"]


def starts_file(scratch):
    """The recorded motion in the harness's form."""
    path = scratch / "starts.bin"
    mechanism.starts().tofile(path)
    return path


def geometry_file(scratch):
    """The listing as constants: links between chassis and knuckle, and within the knuckle; points as
    their place in `q`."""
    outer, inner = [], []
    for first, second, length in mechanism.LINKS:
        at = mechanism.unknown(second).start
        if first in mechanism.CHASSIS:
            outer.append(f"{{{_braced(mechanism.CHASSIS[first])}, {at}, {length!r}}}")
        else:
            inner.append(f"{{{mechanism.unknown(first).start}, {at}, {length!r}}}")
    (scratch / "geometry.h").write_text(
        "struct Outer { double chassis[3]; int point; double length; };\n"
        f"constexpr Outer OUTER[] = {{{', '.join(outer)}}};\n"
        "struct Inner { int first, second; double length; };\n"
        f"constexpr Inner INNER[] = {{{', '.join(inner)}}};\n"
        f"constexpr double DRIVEN_LENGTH = {mechanism.DRIVEN_LENGTH!r};\n"
        f"constexpr double DRIVEN_FROM = {float(mechanism.CHASSIS['p1'][2])!r};\n"
        "/* Of the driving angle: its value and rate at t = 0, half its second rate. */\n"
        f"constexpr double THETA[3] = {_braced(mechanism.DRIVE)};\n"
        "/* The wheel centre from point 6, in the axes of t = 0. */\n"
        f"constexpr double WHEEL_CENTRE[3] = {_braced(mechanism.wheel_centre(mechanism.starts()[0, 3:18]))};\n"
        f"constexpr double LOAD[3] = {_braced(mechanism.LOAD)};\n"
    )


def _braced(numbers):
    return f"{{{', '.join(repr(float(number)) for number in numbers)}}}"


def compiler(name):
    """`gcc 12.2.0`, or `Missing`."""
    if not shutil.which(name):
        raise Missing(f"{name} is not installed")
    version = subprocess.run([name, "-dumpfullversion"], capture_output=True, text=True, check=True)
    return f"{name} {version.stdout.strip()}"


def build(name, source, flags, defines, program, libraries=()):
    """Compiles one source of ours; the flags are as the table has them."""
    options = [f"-D{key}" if value is None else f"-D{key}={value}" for key, value in defines.items()]
    sources = [f"-I{SOURCES}", SOURCES / source]
    _run([name, *flags.split(), *options, *sources, "-o", program, *libraries, "-lm"])


def run(program, scratch):
    """`quantity, (median, spread), errors` of each quantity that the program times."""
    for quantity, *time in lines([program], scratch):
        yield quantity, tuple(map(float, time)), errors_of(scratch / f"{quantity}.bin", quantity)


def lines(command, scratch):
    """What a program prints, `name,value...` a line; it is called with starts and folder first."""
    program, *more = command
    output = _run([program, starts_file(scratch), scratch, *more])
    return [line.split(",") for line in output.splitlines()]


def errors_of(path, quantity):
    """Errors of what a harness has written: of all three for a step, else of the position."""
    found = mechanism.errors(np.fromfile(path).reshape(mechanism.STEPS, 45))
    return found if quantity == "step" else found[:1]


def rows(method, version, flags, note, results, quantities):
    for quantity, time, errors in results:
        if quantity in quantities:
            yield measured(method, version, flags, quantity, time, errors, note)


def machine():
    """The processor and the system, for the head of the table."""
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        models = [line.split(":")[1].strip() for line in file if line.startswith("model name")]
    return f"{models[0] if models else platform.processor()}, {platform.system()}"


def _run(command):
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode:
        first = next((line for line in done.stderr.splitlines() if "error" in line), done.stderr[:300])
        raise RuntimeError(f"{command[0]} failed: {first.strip()}")
    return done.stdout
