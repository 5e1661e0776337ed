#!/usr/bin/env bash
# A compiler for bare metal from Debian's packages: rustc and the source of `core`, which always
# match, because both come from one source package. They become rustup's toolchain `debian`.
set -euo pipefail

packages=(rustc-web cargo-web rust-web-src rust-web-llvm)

as_root() {
    if [[ $EUID -eq 0 ]]; then "$@"; else sudo "$@"; fi
}

if ! dpkg --status "${packages[@]}" >/dev/null 2>&1; then
    as_root apt-get update -qq
    as_root env DEBIAN_FRONTEND=noninteractive \
        apt-get install -y -qq --no-install-recommends "${packages[@]}" >/dev/null
fi

if ! rustup toolchain list | grep -q '^debian\b'; then
    rustup toolchain link debian /usr
fi
rustc +debian --version
