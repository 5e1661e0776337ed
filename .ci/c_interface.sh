#!/usr/bin/env bash
# The C interface on a Cortex-M4F in QEMU: the program in C prints the text that its twin in Rust prints
# on this machine, checksums of all bits included. On this machine `cargo test` compares them.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
packages=(gcc gcc-arm-none-eabi libnewlib-arm-none-eabi make qemu-system-arm)

as_root() {
    if [[ $EUID -eq 0 ]]; then "$@"; else sudo "$@"; fi
}

if ! dpkg --status "${packages[@]}" >/dev/null 2>&1; then
    as_root apt-get update -qq
    as_root env DEBIAN_FRONTEND=noninteractive \
        apt-get install -y -qq --no-install-recommends "${packages[@]}" >/dev/null
fi

cd "$root"
by_rust=$(cargo run --quiet --locked --package suspension-c --example motion -- f32)
export RUSTC_BOOTSTRAP=1
by_c=$(make --no-print-directory --silent --directory examples/c run-m4f \
    CARGO_BARE="cargo +debian" CARGO_BARE_FLAGS=-Zbuild-std=core)

if ! diff <(echo "$by_rust") <(echo "$by_c"); then
    echo "Rust on this machine (<) and C on the Cortex-M4F (>) differ"
    exit 1
fi
rows=$(wc --lines <<<"$by_c")
((rows == 22))
echo "C on a Cortex-M4F computes the same bits as Rust here, over 1,901 steps"
