//! The targets: the files built for each, and the emulated board that runs them.

/// A processor with its board.
pub(crate) struct Target {
    /// The name in tables and budgets.
    pub name: &'static str,
    /// The compiler's name of its instruction set.
    pub triple: &'static str,
    /// Compiler flags beyond those of the instruction set.
    pub flags: &'static [&'static str],
    /// Whether the hardware computes `f64`.
    pub has_doubles: bool,
    /// Whether all calls of the solver are searched, not only the counted ones.
    pub has_rooms: bool,
    /// The emulator and its board, started so that instructions can be counted: see `controller`.
    pub emulator: &'static [&'static str],
}

const THUMB: &str = "thumbv7em-none-eabihf";
const ARM: &str = "qemu-system-arm";
const RISC_V: &str = "qemu-system-riscv64";

pub(crate) const TARGETS: [Target; 3] = [
    Target {
        name: "m4f",
        triple: THUMB,
        flags: &[],
        has_doubles: false,
        has_rooms: true,
        emulator: &[
            ARM,
            "-machine",
            "mps2-an386",
            "-icount",
            "shift=10,align=off,sleep=off",
        ],
    },
    Target {
        name: "m7",
        triple: THUMB,
        flags: &["-Ctarget-cpu=cortex-m7"],
        has_doubles: true,
        has_rooms: false,
        emulator: &[
            ARM,
            "-machine",
            "mps2-an500",
            "-icount",
            "shift=10,align=off,sleep=off",
        ],
    },
    Target {
        name: "rv64gc",
        triple: "riscv64gc-unknown-none-elf",
        flags: &[],
        has_doubles: true,
        has_rooms: false,
        emulator: &[
            RISC_V,
            "-machine",
            "virt",
            "-bios",
            "none",
            "-icount",
            "shift=0,align=off,sleep=off",
        ],
    },
];
