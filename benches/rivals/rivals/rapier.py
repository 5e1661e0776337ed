"""Rapier in f64: the Cargo package beside, apart from the Rust rivals."""

import subprocess

from . import engines, mechanism, rust

MANIFEST = mechanism.ROOT / "benches/rivals/rapier/Cargo.toml"
FLAGS = "-C target-cpu=native"
NOTE = "rods as bodies as heavy as the knuckle, ball joints, height of point 6 by a kinematic body"
VARIANTS = {"Rapier": (4, "default"), "Rapier, 50 iterations": (50, "50 solver iterations")}


def measure(scratch):
    label = f"{rust.compiler()}, release, {FLAGS}"
    rust.build(MANIFEST, scratch / "cargo-rapier", FLAGS)
    program = scratch / "cargo-rapier/release/rapier-rival"
    metadata = ["cargo", "pkgid", "--manifest-path", MANIFEST, "rapier3d-f64"]
    found = subprocess.run(metadata, capture_output=True, text=True, check=True).stdout
    version = found.strip().rpartition("@")[2]
    for name, (iterations, settings) in VARIANTS.items():
        command = [program, str(iterations)]
        note = f"{NOTE}; {settings}; accelerations are not told, impulses along rows of its own"
        row = engines.row(scratch, command, name, version, label, note, known=2)
        yield from engines.all_at_once(row)
