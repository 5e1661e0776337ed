//! Linker scripts: of the runtime, and of the boards that QEMU emulates.

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    let variable = |name: &str| std::env::var(name).unwrap_or_default();
    if variable("CARGO_CFG_TARGET_OS") != "none" {
        return;
    }
    let arch = variable("CARGO_CFG_TARGET_ARCH");
    let board = format!("{}/{arch}", variable("CARGO_MANIFEST_DIR"));
    println!("cargo:rerun-if-changed={board}/memory.x");
    println!("cargo:rustc-link-search={board}");
    println!("cargo:rustc-link-arg-bins=--nmagic");
    if arch.starts_with("riscv") {
        println!("cargo:rustc-link-arg-bins=-Tmemory.x");
    }
    println!("cargo:rustc-link-arg-bins=-Tlink.x");
}
