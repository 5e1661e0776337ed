//! Code that firmware must not reach: panics, formatting, allocation and floating point in software.

use std::sync::LazyLock;

use anyhow::Result;
use regex::Regex;

use crate::archive::Archive;
use crate::reach::Reach;
use crate::target::Target;

/// A panic, formatting and allocation, in demangled symbols.
static CORE: LazyLock<Regex> = LazyLock::new(|| {
    let names =
        "panic|unwrap_failed|expect_failed|rust_begin_unwind|core::fmt|__rust_alloc|alloc::";
    Regex::new(names).expect("a pattern")
});

/// Arithmetic, comparison and conversion of floating-point numbers in software: names of the ARM
/// run-time ABI (IHI 0043, tables 2 to 8) and of libgcc.
static SOFT: LazyLock<Regex> = LazyLock::new(|| {
    let arm = "__aeabi_([dfh]2[a-z]+|(ui|i|ul|l)2[df]|c?[df](r?cmp|add|r?sub|mul|div|neg)[a-z]*)";
    let arithmetic = "__(add|sub|mul|div|neg|powi)[hsdt]f[23]?(vfp)?";
    let comparison = "__(eq|ne|lt|le|gt|ge|cmp|unord)[hsdt]f2(vfp)?";
    let conversion =
        "__(float(un)?[sdt]i[hsdt]f|fix(uns)?[hsdt]f[sdt]i|(extend|trunc)[hsdt]f[hsdt]f2?)(vfp)?";
    let whole = format!("^({arm}|{arithmetic}|{comparison}|{conversion})$");
    Regex::new(&whole).expect("a pattern")
});

/// The symbols that a call reaches and must not.
fn found<'a>(archive: &'a Archive, root: &str, with_soft: bool) -> Result<Vec<&'a str>> {
    let reach = Reach::of(archive, &[archive.find(root)?]);
    let is_forbidden = |name: &&str| CORE.is_match(name) || (with_soft && SOFT.is_match(name));
    Ok(reach.symbols().filter(is_forbidden).collect())
}

/// Returns a sentence for each forbidden function that the calls of a target reach, and for each offender that the search
/// misses.
pub(crate) fn complaints(target: &Target, archive: &Archive) -> Result<Vec<String>> {
    let mut complaints = Vec::new();
    let mut entries: Vec<&str> = archive.globals.keys().map(String::as_str).collect();
    entries.retain(|name| is_entry(name));
    entries.sort_unstable();
    for entry in entries {
        let with_soft = is_in_loop(entry) && (target.has_doubles || entry.contains("_f32_"));
        let found = found(archive, entry, with_soft)?;
        if !found.is_empty() {
            complaints.push(format!(
                "{}/{entry} reaches {}",
                target.name,
                found.join(", ")
            ));
        }
    }
    for (offender, is_offence) in [
        ("offender_panic", true),
        ("offender_format", true),
        ("offender_allocation", true),
        ("offender_double", !target.has_doubles),
    ] {
        let is_found = !found(archive, offender, true)?.is_empty();
        if is_found != is_offence {
            let (name, not) = (target.name, if is_found { "" } else { "not " });
            complaints.push(format!("{name}/{offender} is {not}found by the search"));
        }
    }
    Ok(complaints)
}

/// Returns whether a call is made in the loop, not once before it.
fn is_in_loop(entry: &str) -> bool {
    !entry.ends_with("_construct") && !entry.ends_with("_start")
}

/// Returns whether a symbol belongs to a call of the solver.
fn is_entry(name: &str) -> bool {
    ["firmware_", "attia2003_f", "five_link_f", "wheel_f"]
        .iter()
        .any(|start| name.starts_with(start))
}

#[cfg(test)]
mod tests {
    use super::{CORE, SOFT};

    #[test]
    fn software_floating_point_is_recognised_by_its_symbols() {
        for name in [
            "__aeabi_dadd",
            "__aeabi_drsub",
            "__aeabi_fmul",
            "__aeabi_dcmplt",
            "__aeabi_cdrcmple",
            "__aeabi_cfcmpeq",
            "__aeabi_d2f",
            "__aeabi_f2d",
            "__aeabi_ui2d",
            "__aeabi_l2f",
            "__aeabi_ul2d",
            "__aeabi_d2iz",
            "__aeabi_f2uiz",
            "__aeabi_d2ulz",
            "__muldf3",
            "__addsf3",
            "__divtf3",
            "__negdf2",
            "__powidf2",
            "__ltdf2",
            "__unordsf2",
            "__floatsidf",
            "__floatundisf",
            "__fixdfsi",
            "__fixunssfdi",
            "__extendsfdf2",
            "__truncdfsf2",
        ] {
            assert!(SOFT.is_match(name), "{name}");
        }
    }

    #[test]
    fn integer_and_memory_functions_are_not_taken_for_floating_point() {
        for name in [
            "__aeabi_uidivmod",
            "__aeabi_ldivmod",
            "__aeabi_lmul",
            "__aeabi_memcpy4",
            "__aeabi_memclr",
            "__aeabi_llsl",
            "__muldi3",
            "__udivsi3",
            "__ashldi3",
            "memcpy",
            "firmware_f32_add",
        ] {
            assert!(!SOFT.is_match(name), "{name}");
        }
    }

    #[test]
    fn panics_formatting_and_allocation_are_recognised_by_symbols() {
        for name in [
            "core::panicking::panic_bounds_check",
            "core::option::unwrap_failed",
            "core::result::unwrap_failed",
            "core::option::expect_failed",
            "__rust_alloc",
            "<f32 as core::fmt::Display>::fmt",
            "alloc::alloc::handle_alloc_error",
            "core::slice::index::slice_end_index_len_fail::do_panic::runtime",
        ] {
            assert!(CORE.is_match(name), "{name}");
        }
    }
}
