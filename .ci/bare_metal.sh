#!/usr/bin/env bash
# What the solver costs on microcontrollers, and that it reaches no panic there: see
# tests/firmware/README.md. install.sh has brought what this needs.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

# The versions that the workspace is tested with.
cp "$root/Cargo.lock" "$root/tests/firmware/"
cd "$root/tests/firmware"
# Beside what the workspace's tests have built.
cargo test --quiet --package measure --target-dir "$root/target"
cargo run --quiet --package measure --target-dir "$root/target" -- "$@"
