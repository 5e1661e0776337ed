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


def compiler(name):
    """`gcc 12.2.0`, or `Missing`."""
    if not shutil.which(name):
        raise Missing(f"{name} is not installed")
    version = subprocess.run([name, "-dumpfullversion"], capture_output=True, text=True, check=True)
    return f"{name} {version.stdout.strip()}"


def build(name, source, flags, defines, program):
    """Compiles one source of ours; the flags are as the table has them."""
    options = [f"-D{key}" if value is None else f"-D{key}={value}" for key, value in defines.items()]
    command = [name, *flags.split(), *options, f"-I{SOURCES}", SOURCES / source, "-o", program, "-lm"]
    _run(command)


def run(program, scratch):
    """`quantity, (median, spread), errors` of each quantity that the program times."""
    output = _run([program, starts_file(scratch), scratch])
    for line in output.splitlines():
        quantity, *time = line.split(",")
        yield quantity, tuple(map(float, time)), errors_of(scratch / f"{quantity}.bin", quantity)


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
