"""The example car in general multibody engines: `../car` has a program of each; tyres, road, driver, clock and errors are
those of the example, in a library that the programs link."""

import csv
import subprocess
from dataclasses import dataclass
from importlib.metadata import PackageNotFoundError, version

from . import eigen, mechanism, mujoco_c, native, pinocchio, rust
from .table import Missing

FOLDER = mechanism.ROOT / "benches/rivals/car"
FLAGS = "-O3 -march=native -std=c++17 -DNDEBUG"
RUST = "-C target-cpu=native"
COLUMNS = ["", "a tick, us", "wheel centre, m", "camber, deg", "loads rms, N", "place after 10 s, m"]
POINT, DISC = "0", "0.5"
"""Inertia of a wheel across its axis, kg m^2."""


@dataclass
class Driven:
    name: str
    figures: tuple = ()
    note: str = ""

    def cells(self):
        return [self.name, *(self.figures or [self.note, "", "", "", ""])]


def measure(scratch):
    """Builds and drives; yields each car as it is done."""
    if not eigen.INCLUDE.exists():
        raise Missing("Eigen is not installed (apt-get install libeigen3-dev)")
    rust.compiler()
    rust.build(FOLDER / "Cargo.toml", scratch / "cargo-car", RUST)
    library = scratch / "cargo-car/release/libcar_rivals.a"
    ours = []
    for program, name, runs in engines(scratch, library):
        for label, *arguments in runs:
            yield drive([program, *arguments], f"{name}{label}", scratch, ours)
    if not ours:
        raise Missing("neither pin nor mujoco is installed")
    yield Driven("ours, exact", sorted(ours)[len(ours) // 2])


def engines(scratch, library):
    """Programs, what they are, and how they are run: label, steps in a tick, inertia across."""
    car = [library, "-lpthread", "-ldl"]
    all_ways = [
        ("", "1", POINT),
        (", wheels as discs", "1", DISC),
        (", 8 steps a tick", "8", POINT),
        (", 8 steps, discs", "8", DISC),
    ]
    if found := _version("pin"):
        headers = ["-isystem", pinocchio.HEADERS, "-isystem", eigen.INCLUDE, *car]
        yield _built(scratch, "pinocchio", headers, pinocchio.LIMITS), f"Pinocchio {found}", all_ways
    if found := _version("mujoco"):
        shared = mujoco_c.FOLDER / f"libmujoco.so.{found}"
        options = ["-isystem", mujoco_c.FOLDER / "include", shared, f"-Wl,-rpath,{mujoco_c.FOLDER}", *car]
        yield _built(scratch, "mujoco", options, {"STIFF": None}), f"MuJoCo {found}, stiff", all_ways
        yield _built(scratch, "mujoco", options, {}), f"MuJoCo {found}", [(", wheels as discs", "1", DISC)]


def _version(package):
    try:
        return version(package)
    except PackageNotFoundError:
        return None


def _built(scratch, engine, options, defines):
    program = scratch / "-".join(["car", engine, *defines.keys() & {"STIFF"}])
    native.build("g++", FOLDER / f"native/{engine}.cpp", f"{FLAGS} -w", defines, program, options)
    return program


def drive(command, name, scratch, ours):
    """One car; `ours` takes the figures of ours in the same run."""
    done = subprocess.run(command, capture_output=True, text=True, check=False, cwd=scratch)
    if done.returncode:
        said = done.stderr.strip() or f"exit code {done.returncode}"
        return Driven(name, note=f"fails: {said.splitlines()[0]}")
    told = {key: tuple(map(float, figures)) for key, *figures in csv.reader(done.stdout.splitlines())}
    ours.append(told["ours"])
    return Driven(name, told["engine"])


def write(cars, path):
    with path.open("w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["car", "tick_us", "wheel_m", "camber_deg", "load_N", "place_m", "note"])
        writer.writerows([car.name, *(car.figures or [""] * 5), car.note] for car in cars)


def markdown(cars, heading):
    lines = [heading, "", f"| {' | '.join(COLUMNS)} |", "| --- " * len(COLUMNS) + "|"]
    for car in sorted(cars, key=lambda car: car.figures or (float("inf"),)):
        cells = [f"{cell:.1e}" if isinstance(cell, float) else cell for cell in car.cells()]
        if car.figures:
            cells[1] = f"{car.figures[0]:.1f}"
        lines.append(f"| {' | '.join(cells)} |")
    return "\n".join(lines) + "\n"
