//! The committed headers are those that the descriptions of the functions give.

use std::path::PathBuf;

use suspension_c::catalogue::{attia2003_f32, attia2003_f64, five_link_f32, five_link_f64};

/// If this is set, the test writes the headers.
const UPDATE: &str = "UPDATE_SNAPSHOTS";

#[test]
fn the_committed_headers_match_the_function_descriptions() {
    let headers = [
        ("suspension.h", suspension_c::header::common().to_string()),
        (
            "suspension_listing.h",
            suspension_c::header::listing().to_string(),
        ),
        (
            "suspension_attia2003_f32.h",
            attia2003_f32::INTERFACE.to_string(),
        ),
        (
            "suspension_attia2003_f64.h",
            attia2003_f64::INTERFACE.to_string(),
        ),
        (
            "suspension_five_link_f32.h",
            five_link_f32::INTERFACE.to_string(),
        ),
        (
            "suspension_five_link_f64.h",
            five_link_f64::INTERFACE.to_string(),
        ),
    ];
    for (name, text) in headers {
        let path = PathBuf::from(env!("CARGO_MANIFEST_DIR"))
            .join("include")
            .join(name);
        if std::env::var_os(UPDATE).is_some() {
            std::fs::write(&path, &text).expect("a folder of the repository");
        }
        let committed = std::fs::read_to_string(&path).unwrap_or_default();
        assert!(
            committed == text,
            "{name} is not up to date: set {UPDATE}=1 and look at the difference"
        );
    }
}
