"""Ours and the Rust rivals: the program of this folder's Cargo package, in two builds."""

import csv
import os
import shutil
import subprocess

from . import engines, mechanism, native
from .table import Missing, measured

MANIFEST = mechanism.ROOT / "benches/rivals/Cargo.toml"
BUILDS = {"default": "", "native": "-C target-cpu=native"}


def measure(scratch):
    version_of_rustc = compiler()
    for name, flags in BUILDS.items():
        target = scratch / f"cargo-{name}"
        print(f"   building {name}", flush=True)
        build(MANIFEST, target, flags)
        folder = scratch / "rust"
        folder.mkdir(exist_ok=True)
        mechanism.wheel_centres().tofile(folder / "centres.bin")
        program = subprocess.run(
            [target / "release/rivals", folder], capture_output=True, text=True, check=False
        )
        if program.returncode:
            raise RuntimeError(program.stderr.strip())
        label = f"{version_of_rustc}, release, {flags or 'default target'}"
        for method, version, quantity, *time, note in csv.reader(program.stdout.splitlines()):
            errors = native.errors_of(folder / f"{method}.{quantity}.bin", quantity)
            time = tuple(map(float, time))
            row = measured(method, version, label, quantity, time, errors, note)
            lock = folder / f"{method}.lock.txt"
            if quantity == "step" and lock.exists():
                row = engines.asked(row, folder / engines.RODS, lock.read_text())
            yield row


def compiler():
    """`rustc 1.95.0`, or `Missing`."""
    if not shutil.which("cargo"):
        raise Missing("cargo is not installed")
    rustc = subprocess.run(["rustc", "--version"], capture_output=True, text=True, check=True)
    return " ".join(rustc.stdout.split()[:2])


def build(manifest, target, flags):
    """Builds a Cargo package as it is locked."""
    command = ["cargo", "build", "--release", "--locked", "--manifest-path", manifest]
    done = subprocess.run(
        [*command, "--target-dir", target],
        env={**os.environ, "RUSTFLAGS": flags},
        capture_output=True,
        text=True,
        check=False,
    )
    if done.returncode:
        raise RuntimeError(f"cargo build failed: {done.stderr.strip().splitlines()[-1]}")
