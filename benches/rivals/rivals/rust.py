"""Ours and the Rust rivals: the program of this folder's Cargo package, in two builds."""

import csv
import os
import shutil
import subprocess

from . import mechanism, native
from .table import Missing, measured

MANIFEST = mechanism.ROOT / "benches/rivals/Cargo.toml"
BUILDS = {"default": "", "native": "-C target-cpu=native"}


def measure(scratch):
    if not shutil.which("cargo"):
        raise Missing("cargo is not installed")
    rustc = subprocess.run(["rustc", "--version"], capture_output=True, text=True, check=True)
    compiler = " ".join(rustc.stdout.split()[:2])
    for build, flags in BUILDS.items():
        target = scratch / f"cargo-{build}"
        print(f"   building {build}", flush=True)
        _build(target, flags)
        folder = scratch / "rust"
        folder.mkdir(exist_ok=True)
        program = subprocess.run(
            [target / "release/rivals", folder], capture_output=True, text=True, check=False
        )
        if program.returncode:
            raise RuntimeError(program.stderr.strip())
        label = f"{compiler}, release, {flags or 'default target'}"
        for method, version, quantity, *time, note in csv.reader(program.stdout.splitlines()):
            errors = native.errors_of(folder / f"{method}.{quantity}.bin", quantity)
            time = tuple(map(float, time))
            yield measured(method, version, label, quantity, time, errors, note)


def _build(target, flags):
    command = ["cargo", "build", "--release", "--locked", "--manifest-path", MANIFEST]
    done = subprocess.run(
        [*command, "--target-dir", target],
        env={**os.environ, "RUSTFLAGS": flags},
        capture_output=True,
        text=True,
        check=False,
    )
    if done.returncode:
        raise RuntimeError(f"cargo build failed: {done.stderr.strip().splitlines()[-1]}")
