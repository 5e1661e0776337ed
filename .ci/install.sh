#!/usr/bin/env bash
# What the tests need beside Rust, from Debian's packages: valgrind, C compilers, a Rust compiler for bare
# metal, emulated boards. That compiler and the source of `core` always match, because both come from
# one source package; they become rustup's toolchain `debian`, with `core` built for each target.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
packages=(
    # tests/instructions.rs, suspension-c/tests
    valgrind gcc g++
    # tests/firmware
    rustc-web cargo-web rust-web-src qemu-system-arm qemu-system-misc
    # examples/c on a controller
    gcc-arm-none-eabi libnewlib-arm-none-eabi make
)
targets=(thumbv7em-none-eabihf riscv64gc-unknown-none-elf)

as_root() {
    if [[ $EUID -eq 0 ]]; then "$@"; else sudo "$@"; fi
}

# Builds `core` and `alloc` for all targets into the compiler's own folders. Bitcode is for
# link-time optimisation, stack sizes are for tests/firmware.
build_core() {
    local folder target flags=()
    folder=$(mktemp --directory)
    trap 'rm -rf "$folder"' RETURN
    mkdir "$folder/src"
    echo '#![no_std]' >"$folder/src/lib.rs"
    printf '%s\n' '[package]' 'name = "empty"' '[profile.release]' 'panic = "abort"' \
        >"$folder/Cargo.toml"
    for target in "${targets[@]}"; do flags+=(--target "$target"); done
    (
        cd "$folder"
        RUSTC_BOOTSTRAP=1 RUSTFLAGS="-Cembed-bitcode=yes -Zemit-stack-sizes" \
            cargo +debian build --quiet --release -Zbuild-std=core,alloc --target-dir target "${flags[@]}"
    )
    for target in "${targets[@]}"; do
        local libraries
        libraries=$(rustc +debian --print target-libdir --target "$target")
        as_root rm -rf "$libraries"
        as_root mkdir -p "$libraries"
        as_root cp "$folder/target/$target/release/deps/"lib{core,compiler_builtins,alloc}-*.rlib \
            "$libraries"
    done
    # Cargo does not see that `core` is another.
    rm -rf "$root/tests/firmware/target"
}

if ! dpkg --status "${packages[@]}" >/dev/null 2>&1; then
    as_root apt-get update -qq
    as_root env DEBIAN_FRONTEND=noninteractive \
        apt-get install -y -qq --no-install-recommends "${packages[@]}" >/dev/null
fi

if ! rustup toolchain list | grep -q '^debian\b'; then
    rustup toolchain link debian /usr
fi

version=$(rustc +debian --version)
mark=$(rustc +debian --print sysroot)/lib/rustlib/suspension-core-of
if [[ $(cat "$mark" 2>/dev/null) != "$version ${targets[*]}" ]]; then
    build_core
    as_root tee "$mark" <<<"$version ${targets[*]}" >/dev/null
fi
echo "$version"
