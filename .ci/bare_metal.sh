#!/usr/bin/env bash
# What the solver costs on microcontrollers, and that it reaches no panic there: see
# tests/firmware/README.md. install.sh has brought what this needs, `cargo build --workspace --bin measure`
# the program that measures. (It is not built here: cargo would wait for lints and tests beside this.)
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

"${CARGO_TARGET_DIR:-$root/target}/debug/measure"
