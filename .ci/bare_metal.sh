#!/usr/bin/env bash
# Builds tests/firmware for a Cortex-M4F, links what its entry points reach, and searches that for
# panics, formatting and allocation. None may be on the solving path, nor where models are built
# and assembled.
set -euo pipefail
shopt -s inherit_errexit

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
target=thumbv7em-none-eabihf
forbidden='panic|core::fmt|rust_begin_unwind|__rust_alloc|alloc::|unwrap_failed|expect_failed'

host=$(rustc --print host-tuple)
linker=$(rustc --print sysroot)/lib/rustlib/$host/bin/rust-lld
nm=$(compgen -c llvm-nm- | sort --version-sort | tail -n 1)

# Prints the forbidden symbols that firmware with these features reaches.
search() {
    cd "$root/tests/firmware"
    RUSTC_BOOTSTRAP=1 cargo +debian build --quiet --release -Zbuild-std=core \
        --target "$target" --features "$1" >&2
    cd "target/$target/release"
    local library=libsuspension_firmware.a entries symbols
    entries=$("$nm" --defined-only --format=just-symbols "$library" 2>/dev/null |
        grep '^firmware_' | sed 's/^/--undefined=/')
    # shellcheck disable=SC2086 # one argument a line
    "$linker" -flavor gnu --gc-sections --entry=0 $entries "$library" -o "$1.elf"
    symbols=$("$nm" --demangle --format=just-symbols "$1.elf")
    grep -E "$forbidden" <<<"$symbols" || true
}

# The versions that the workspace is tested with.
cp "$root/Cargo.lock" "$root/tests/firmware/"

for path in solving series path construction assembly; do
    found=$(search "$path")
    if [[ -n $found ]]; then
        printf '%s reaches:\n%s\n' "$path" "$found"
        exit 1
    fi
    echo "$path: no panic, no formatting, no allocation"
done

found=$(search solving,deliberate-panic)
if [[ -z $found ]]; then
    echo "the search misses a deliberate panic"
    exit 1
fi
echo "a deliberate panic: found, as it must be"
