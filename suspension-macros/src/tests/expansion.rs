//! Pretty-printed expansions of the catalogue against the committed snapshots.

use quote::{format_ident, quote};

use suspension_listing::include::NoIncludes;

use crate::expand::expand_text;
use crate::module::{self, Source};

/// The expansion of a catalogue file.
fn expansion(name: &str) -> proc_macro2::TokenStream {
    let ident = format_ident!("{name}");
    let module =
        module::parse(quote!([::suspension_core] pub mod #ident;)).map(|(module, _)| module);
    let module = module.unwrap_or_else(|error| panic!("{error}"));
    let Source::File(path) = &module.source else {
        panic!("a file");
    };
    let folder = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../suspension-core/src/linkages"
    );
    let file = format!("{folder}/{}", path.value());
    let text = std::fs::read_to_string(&file).unwrap_or_else(|e| panic!("{file}: {e}"));
    expand_text(&module, path, &text, &NoIncludes)
}

/// Compares the expansion of a catalogue file with its snapshot, or rewrites the snapshot.
fn snapshot(name: &str) {
    let expansion = expansion(name);
    let file = syn::parse2(expansion).expect("the expansion is a Rust file");
    let printed = spaced(&prettyplease::unparse(&file));
    let path = format!("{}/src/snapshots/{name}.rs", env!("CARGO_MANIFEST_DIR"));
    if std::env::var_os("UPDATE_SNAPSHOTS").is_some_and(|value| value == "1") {
        std::fs::write(&path, &printed).unwrap_or_else(|e| panic!("{path}: {e}"));
    }
    let committed = std::fs::read_to_string(&path).unwrap_or_default();
    let differs = committed
        .lines()
        .zip(printed.lines())
        .position(|(committed, printed)| committed != printed);
    assert!(
        committed == printed,
        "the expansion of `{name}` differs from {path} from line {} on; to accept it run \
         `UPDATE_SNAPSHOTS=1 cargo test -p suspension-macros` and read the difference",
        differs.map_or(
            committed.lines().count().min(printed.lines().count()),
            |i| i + 1
        )
    );
}

/// A blank line behind each item of a module or an implementation.
fn spaced(code: &str) -> String {
    let mut spaced = String::new();
    let mut lines = code.lines().peekable();
    while let Some(line) = lines.next() {
        spaced.push_str(line);
        spaced.push('\n');
        let ends_item = ["    }", "        }"].contains(&line);
        let next_is_item = lines
            .peek()
            .is_some_and(|next| !next.trim().starts_with('}'));
        if ends_item && next_is_item {
            spaced.push('\n');
        }
    }
    spaced
}

#[test]
fn expansion_of_attia2003_matches_its_snapshot() {
    snapshot("attia2003");
}

#[test]
fn expansion_of_five_link_matches_its_snapshot() {
    snapshot("five_link");
}
