//! Each guarantee of `docs/guarantees.toml` names tests that exist, and `docs/guarantees.md` is rendered
//! from it.

use std::fmt::Write as _;
use std::path::Path;

use serde::Deserialize;

const RENDERED: &str = "docs/guarantees.md";

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Guarantees {
    group: Vec<Group>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Group {
    title: String,
    row: Vec<Row>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Row {
    what: String,
    figure: String,
    #[serde(default)]
    test: Vec<String>,
    check: Option<String>,
}

fn read(path: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(path);
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn guarantees() -> Guarantees {
    toml::from_str(&read("docs/guarantees.toml")).expect("guarantees")
}

/// Returns whether a source file has a test of that name.
fn has_test(text: &str, name: &str) -> bool {
    let mut marked = false;
    text.lines().map(str::trim).any(|line| {
        let is_test = marked && line.starts_with(&format!("fn {name}("));
        marked = line.starts_with("#[") && (marked || line == "#[test]");
        is_test
    })
}

#[test]
fn each_guarantee_names_tests_that_exist() {
    let guarantees = guarantees();
    let rows = guarantees.group.iter().flat_map(|group| &group.row);
    let mut named = 0;
    for row in rows {
        assert!(!row.test.is_empty() || row.check.is_some(), "{}", row.what);
        for test in &row.test {
            let (file, name) = test.split_once("::").expect("file::function");
            assert!(has_test(&read(file), name), "{test}: no such test");
            named += 1;
        }
        if let Some(script) = &row.check {
            assert!(
                read(".ci/run").contains(&script[4..]),
                "{script} is not run"
            );
        }
    }
    assert!(named > 50);
}

#[test]
fn guarantees_md_is_rendered_from_guarantees_toml() {
    let page = rendered(&guarantees());
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(RENDERED);
    if std::env::var_os("UPDATE_SNAPSHOTS").is_some_and(|value| value == "1") {
        std::fs::write(&path, &page).expect("the page is written");
    }
    assert!(
        read(RENDERED) == page,
        "{RENDERED} is not what docs/guarantees.toml says; to render it run \
         `UPDATE_SNAPSHOTS=1 cargo test --test all guarantees::`"
    );
}

fn rendered(guarantees: &Guarantees) -> String {
    let mut page = String::from(
        "# Guarantees\n\n\
         Rendered from [guarantees.toml](guarantees.toml). Each row names the tests that fail if it is false;\n\
         `cargo test --workspace` runs the tests, `.ci/run` also the scripts. \"Found\" is the measured value.\n",
    );
    for group in &guarantees.group {
        let _ = write!(page, "\n## {}\n\n", group.title);
        page.push_str("| guarantee | figure | test |\n| --- | --- | --- |\n");
        for row in &group.row {
            let tests = row.test.iter().map(|test| {
                let (file, name) = test.split_once("::").unwrap_or((test, ""));
                format!("[`{name}`](../{file})")
            });
            let scripts = row
                .check
                .iter()
                .map(|path| format!("[`{path}`](../{path})"));
            let proofs: Vec<String> = tests.chain(scripts).collect();
            let _ = writeln!(
                page,
                "| {} | {} | {} |",
                row.what,
                row.figure,
                proofs.join(", ")
            );
        }
    }
    page
}
