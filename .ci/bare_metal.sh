#!/usr/bin/env bash
# What the solver costs on microcontrollers, and that it reaches no panic there: see
# tests/firmware/README.md. install.sh has brought what this needs.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

cd "$root"
# The versions that the workspace is tested with.
cp Cargo.lock tests/firmware/
# With the features that all of the workspace is built with, so that it is built from what tests are built from.
cargo build --quiet --workspace --bin measure
"${CARGO_TARGET_DIR:-target}/debug/measure" "$@"
