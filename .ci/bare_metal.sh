#!/usr/bin/env bash
# What the solver costs on microcontrollers, and that it reaches no panic there: see
# tests/firmware/README.md. install.sh has brought what this needs.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

# The versions that the workspace is tested with.
cp "$root/Cargo.lock" "$root/tests/firmware/"
cd "$root/tests/firmware"
# In a folder of its own: one that others build in would have to be waited for.
cargo test --quiet --package measure
cargo run --quiet --package measure -- "$@"
