//! Links between the pages of the repository lead to files and headings that exist, and the page about the architecture names
//! every crate.

use std::path::{Path, PathBuf};

const ARCHITECTURE: &str = "docs/architecture.md";

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The pages below a folder, without those of build folders.
fn pages(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).expect("a folder");
    let paths = entries.map(|entry| entry.expect("an entry").path());
    let pages = paths.flat_map(|path| {
        let name = path.file_name().expect("a name").to_string_lossy();
        if path.is_dir() && name != "target" && name != "out" && !name.starts_with('.') {
            pages(&path)
        } else if name.ends_with(".md") {
            vec![path]
        } else {
            Vec::new()
        }
    });
    pages.collect()
}

/// The targets of a page's links that are neither on the web nor items of documentation.
fn links(page: &str) -> Vec<&str> {
    let behind = page.split("](").skip(1);
    let targets = behind.filter_map(|text| text.split([')', '\n']).next());
    let is_file = |target: &&str| target.contains(['/', '.', '#']) && !target.contains("::");
    targets
        .filter(is_file)
        .filter(|target| !target.contains("://"))
        .collect()
}

/// The anchors of a page's headings, as GitHub makes them.
fn anchors(page: &str) -> Vec<String> {
    let headings = page.lines().filter(|line| line.starts_with('#'));
    let kept = |letter: &char| letter.is_alphanumeric() || " -_".contains(*letter);
    let anchors = headings.map(|line| {
        let heading = line.trim_start_matches('#').trim().to_lowercase();
        heading.chars().filter(kept).collect::<String>()
    });
    anchors.map(|heading| heading.replace(' ', "-")).collect()
}

/// The fault of a link from a page; empty if nothing is.
fn fault(page: &Path, link: &str) -> Option<String> {
    let (file, anchor) = link.split_once('#').unwrap_or((link, ""));
    let target = if file.is_empty() {
        page.to_owned()
    } else {
        page.parent().expect("a folder").join(file)
    };
    let fault_of = |what: &str| Some(format!("{}: {link}: {what}", page.display()));
    if !target.exists() {
        return fault_of("there is no such file");
    }
    if anchor.is_empty() {
        return None;
    }
    let text = std::fs::read_to_string(&target).unwrap_or_default();
    let has_heading = anchors(&text).iter().any(|heading| heading == anchor);
    if has_heading {
        None
    } else {
        fault_of("there is no such heading")
    }
}

#[test]
fn links_in_pages_lead_to_existing_files_and_headings() {
    let pages = pages(root());
    let mut count = 0;
    let mut faults = Vec::new();
    for page in &pages {
        let text = std::fs::read_to_string(page).expect("a page");
        let links = links(&text);
        count += links.len();
        faults.extend(links.iter().filter_map(|link| fault(page, link)));
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    assert!(count > 150, "{count} links in {} pages", pages.len());
}

#[test]
fn the_check_of_links_finds_a_missing_file_or_heading() {
    let page = root().join("README.md");
    assert_eq!(fault(&page, "docs/speed.md"), None);
    assert_eq!(fault(&page, "#licence"), None);
    for wrong in ["docs/missing.md", "docs/speed.md#missing", "#missing"] {
        let fault = fault(&page, wrong).expect("a fault");
        assert!(fault.contains(wrong), "{fault}");
    }
}

#[test]
fn architecture_md_names_every_crate() {
    let page = std::fs::read_to_string(root().join(ARCHITECTURE)).expect("the page");
    let entries = std::fs::read_dir(root()).expect("a folder");
    let folders = entries.map(|entry| entry.expect("an entry").path());
    let crates = folders.filter(|folder| folder.join("Cargo.toml").exists());
    let names: Vec<_> = crates
        .map(|folder| folder.file_name().expect("a name").display().to_string())
        .collect();
    assert!(names.len() >= 10, "{names:?}");
    for name in names {
        assert!(page.contains(&format!("[`{name}`](../{name})")), "{name}");
    }
}
