//! Names of two files in the legend of a chart.

use std::path::Path;

/// The most characters in a legend.
const LONGEST: usize = 28;

/// Returns the names of two files without the folders, the name and the ending that both share; `A` and `B` for one file
/// twice. Of a long name the end stays.
pub(super) fn short_names(files: [&str; 2]) -> [String; 2] {
    if files[0] == files[1] {
        return ["A", "B"].map(str::to_owned);
    }
    let [mut a, mut b] = files.map(parts);
    while a.len() > 1 && b.len() > 1 && a[0] == b[0] {
        a.remove(0);
        b.remove(0);
    }
    while a.len() > 1 && b.len() > 1 && a.last() == b.last() {
        a.pop();
        b.pop();
    }
    [a, b].map(|parts| ending(&parts.join("/")))
}

/// The folders of a file and its name without the ending `.toml`.
fn parts(file: &str) -> Vec<String> {
    let file = file.strip_suffix(".toml").unwrap_or(file);
    let parts = Path::new(file).components();
    parts
        .map(|part| part.as_os_str().to_string_lossy().into_owned())
        .collect()
}

fn ending(name: &str) -> String {
    let length = name.chars().count();
    if length <= LONGEST {
        return name.to_owned();
    }
    let last = name.chars().skip(length - LONGEST + 1);
    format!("\u{2026}{}", last.collect::<String>())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn legends_have_what_differs_between_the_names_of_files() {
        let long = "hardpoints_of_the_front_axle_version_2.toml";
        for (files, expected) in [
            (["a.toml", "b.toml"], ["a", "b"]),
            (["designs/a.toml", "designs/b.toml"], ["a", "b"]),
            (["v1/front.toml", "v2/front.toml"], ["v1", "v2"]),
            (["front.toml", "v2/front.toml"], ["front", "v2/front"]),
            (
                ["/x/v1/front.toml", "/x/v2/rear.toml"],
                ["v1/front", "v2/rear"],
            ),
            (["a.toml", "a.toml"], ["A", "B"]),
            (
                ["a.toml", long],
                ["a", "\u{2026}of_the_front_axle_version_2"],
            ),
        ] {
            assert_eq!(short_names(files), expected, "{files:?}");
        }
    }
}
