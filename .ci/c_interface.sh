#!/usr/bin/env bash
# The C interface with the features that suspension-c has alone, as users build it. On this machine,
# linked with no other library, and on a Cortex-M4F in QEMU the program in C prints the text that its
# twin in Rust prints on this machine, checksums of all bits included; so does, on this machine, the
# program that reads a listing from text. And what all functions of a linkage reach has no writable
# memory, no panic, no formatting, no allocation. install.sh has brought what this needs.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
forbidden='panic|core::fmt|rust_begin_unwind|__rust_alloc|alloc::|unwrap_failed|expect_failed'

# Fails unless there are as many lines of something as wanted.
check_count() {
    local what=$1 wanted=$2 count
    count=$(wc --lines <<<"$3")
    if ((count != wanted)); then
        echo "$count $what, $wanted wanted"
        exit 1
    fi
}

# What a linked file has in it, none of it forbidden.
check_reach() {
    local symbols
    symbols=$(nm --demangle "$1")
    if grep -E "$forbidden" <<<"$symbols"; then
        echo "the functions reach what they may not"
        exit 1
    fi
}

cd "$root"
# Beside what is built for this machine, in a folder of its own: cargo waits for a folder.
controller=$root/target/controller
mkdir -p "$controller"
CARGO_TARGET_DIR=$controller make --no-print-directory --silent --directory examples/c run-m4f \
    CARGO_BARE="cargo +debian" >"$controller/printed" &
on_controller=$!

by_rust=$(cargo run --quiet --locked --release --package suspension-c --example motion -- f32)
cargo build --quiet --locked --release --package suspension-c --example catalogue
mkdir -p target/c
cc -std=c11 -O2 -ffp-contract=off -I suspension-c/include examples/c/motion.c \
    target/release/examples/libcatalogue.a -o target/c/motion_here
if ! diff <(echo "$by_rust") <(target/c/motion_here); then
    echo "Rust (<) and C (>) on this machine differ"
    exit 1
fi

by_rust_compiled=$(cargo run --quiet --locked --release --package suspension-c --example listing)
cc -std=c11 -O2 -ffp-contract=off -I suspension-c/include examples/c/listing.c \
    target/release/examples/libcatalogue.a -o target/c/listing_here
listing=suspension-core/src/linkages/double_wishbone_pushrod.linkage
if ! diff <(echo "$by_rust_compiled") <(target/c/listing_here "$listing"); then
    echo "a listing compiled for Rust (<) and read by C (>) differ"
    exit 1
fi

cc -std=c11 -O2 -ffp-contract=off -I suspension-c/include examples/c/axle.c \
    target/release/examples/libcatalogue.a -o target/c/axle_here
wheels=$(target/c/axle_here suspension-core/src/linkages/steered_axle.linkage)
if (($(grep --count --extended-regexp '^ +(left|right) +-?[0-9]' <<<"$wheels") != 2)); then
    echo "the program in C does not print the row of each wheel:"
    echo "$wheels"
    exit 1
fi

wait "$on_controller"
by_c=$(<"$controller/printed")
if ! diff <(echo "$by_rust") <(echo "$by_c"); then
    echo "Rust on this machine (<) and C on the Cortex-M4F (>) differ"
    exit 1
fi
check_count "rows of the motion" 22 "$by_c"
echo "C on a Cortex-M4F computes the same bits as Rust here, over 1,901 steps"

cd target
library=controller/thumbv7em-none-eabihf/release/libsuspension_c.a
functions=$(arm-none-eabi-nm --defined-only "$library" 2>/dev/null | awk '$2 == "T" && $3 ~ /^susp_/ { print $3 }')
if (($(wc --lines <<<"$functions") <= 20)); then
    echo "the library for the controller has few functions: $functions"
    exit 1
fi
# shellcheck disable=SC2086 # one argument a line
arm-none-eabi-ld --gc-sections --entry=0 ${functions//susp_/--undefined=susp_} "$library" -o c/all.elf
check_reach c/all.elf
writable=$(arm-none-eabi-size c/all.elf | awk 'NR == 2 { print $2 + $3 }')
if [[ $writable != 0 ]]; then
    echo "$writable bytes of writable memory: a state that is not the caller's"
    exit 1
fi
echo "all functions: no writable memory, no panic, no formatting, no allocation"

# What moves a listing from text is called through tables of functions, into which the linker does not
# look: their entries are made visible to it. The tables of unwinding, which name what handles a panic, go.
objcopy --wildcard --globalize-symbol='*Counted*Moving*' --remove-section=.eh_frame --remove-section=.rela.eh_frame \
    --remove-section='.gcc_except_table*' --remove-section='.rela.gcc_except_table*' \
    release/examples/libcatalogue.a c/entries.a
entries=$(nm --defined-only c/entries.a 2>/dev/null | awk '$2 == "T" && /Counted/ && /Moving/ && !/copied/ { print "--undefined=" $3 }')
# Sixteen in each of four sizes, beside the one that copies.
check_count "functions that move a listing from text" 64 "$entries"
# shellcheck disable=SC2086 # one argument a line
ld --gc-sections --entry=0 --unresolved-symbols=ignore-all $entries c/entries.a -o c/entries.elf
check_reach c/entries.elf
echo "what moves a listing from text: no panic, no formatting, no allocation"
