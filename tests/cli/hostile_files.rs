//! Files that are not motion files: exit code 2 and one sentence.

use std::path::Path;

use super::program::{CORNER, edited, example, folder, rows, run, text};

/// The message with which a file is refused.
fn refused(folder: &Path, file: &str) -> String {
    let output = run(folder, &["motion", file]);
    let message = text(&output.stderr).to_owned();
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(output.stdout.is_empty());
    assert_eq!(message.lines().count(), 1, "{message}");
    assert!(
        message.len() < 1000 && message.starts_with(file),
        "{message}"
    );
    message
}

fn refused_content(content: impl AsRef<[u8]>) -> String {
    let folder = folder();
    std::fs::write(folder.path().join("bad.toml"), content).expect("written");
    refused(folder.path(), "bad.toml")
}

#[test]
fn files_that_are_not_utf_8_are_refused() {
    let message = refused_content(b"linkage = \"attia2003\"\nunit = \"\xff\xfe\"");
    assert!(
        message.starts_with("bad.toml:2:9: is not text in UTF-8; save it in that encoding"),
        "{message}"
    );
    refused_content([0_u8; 1000]);
    refused_content((0..=u8::MAX).cycle().take(100_000).collect::<Vec<u8>>());
    refused_content(b"\x7fELF\x02\x01\x01");
    refused_content(b"");
}

#[test]
fn json_is_refused_in_one_line() {
    let message = refused_content("{\n  \"unit\": \"m\",\n  \"drives\": { \"bump\": 0.3 }\n}\n");
    assert_eq!(
        message,
        "bad.toml:1:1: this is JSON; a motion file is in TOML, as suspension motion --help shows\n"
    );
}

#[test]
fn workbooks_are_refused() {
    for start in [b"PK\x03\x04", b"\xd0\xcf\x11\xe0"] {
        assert_eq!(
            refused_content(start),
            "bad.toml: is a workbook, not text; save the sheet as CSV in UTF-8\n"
        );
    }
}

#[test]
fn files_of_any_size_are_read_or_refused() {
    assert!(refused_content(vec![b'x'; 100_000_000]).contains("larger than 4 MiB"));
    // Just small enough to be read.
    let long_key = "x".repeat(4_000_000);
    assert!(refused_content(&long_key).starts_with("bad.toml:1:"));
    assert!(
        refused_content(edited("p2", &format!("{long_key} = [0, 0, 1]"))).contains("unknown point")
    );
    let zeros = "0,".repeat(200_000);
    let message = refused_content(edited("instants", &format!("instants = [{zeros}]")));
    assert!(
        message.contains("must increase or decrease throughout"),
        "{message}"
    );
}

#[test]
fn a_file_of_mistakes_is_refused_with_the_first_20() {
    let folder = folder();
    for line in ["k = 1,\n", "[drives\n"] {
        std::fs::write(folder.path().join("bad.toml"), line.repeat(500_000)).expect("written");
        let output = run(folder.path(), &["check", "bad.toml"]);
        assert_eq!(output.status.code(), Some(2), "{line}");
        assert_eq!(text(&output.stderr).lines().count(), 21, "{line}");
    }
}

#[cfg(unix)]
#[test]
fn an_endless_device_is_refused_as_too_large() {
    let folder = folder();
    assert!(refused(folder.path(), "/dev/zero").contains("larger than 4 MiB"));
}

/// A listing that is included is read by the same rules as the one that includes it.
#[test]
fn included_files_of_any_size_and_bytes_are_refused() {
    let folder = folder();
    let at = |name: &str| folder.path().join(name);
    let main = CORNER.replace(
        "linkage = \"double_wishbone_pushrod\"",
        "listing = \"main.linkage\"",
    );
    std::fs::write(at("main.toml"), main).expect("written");
    std::fs::write(at("main.linkage"), "include left: \"part.linkage\";\n").expect("written");
    let part = std::fs::File::create(at("part.linkage")).expect("a file");
    // More than there is memory for; on the disk it takes no place.
    part.set_len(1 << 37).expect("a file with a hole");
    for (content, expected) in [
        (
            None,
            "part.linkage: it is 137438953472 bytes long; at most 65536 are allowed",
        ),
        (
            Some(b"fixed: a\xff;"),
            "part.linkage: it is not text in UTF-8; save it in that encoding",
        ),
    ] {
        if let Some(content) = content {
            std::fs::write(at("part.linkage"), content).expect("written");
        }
        let output = run(folder.path(), &["check", "main.toml"]);
        assert_eq!(output.status.code(), Some(2), "{output:?}");
        let message = text(&output.stderr);
        assert_eq!(
            message,
            format!("main.linkage:1:15: cannot read {expected}\n")
        );
    }
}

#[test]
fn deeply_nested_files_are_refused() {
    for (open, close) in [("[", "]"), ("{ a = ", " }")] {
        let value = open.repeat(100_000) + "1" + &close.repeat(100_000);
        refused_content(edited("p2", &format!("p2 = {value}")));
        refused_content(edited("p2", &format!("p2 = {}", open.repeat(100_000))));
    }
    refused_content(edited("p2", &format!("p2{} = 1", ".a".repeat(100_000))));
    refused_content(edited("[time]", &format!("[{}]", ["a"; 100_000].join("."))));
}

#[test]
fn unreadable_paths_are_refused_in_one_line() {
    let folder = folder();
    std::fs::create_dir(folder.path().join("a_folder")).expect("made");
    std::fs::write(folder.path().join("file"), "").expect("written");
    for name in ["a_folder", "none.toml", "file/none.toml", "\u{1f697}.toml"] {
        assert!(refused(folder.path(), name).contains(": cannot be read: "));
    }
    let output = run(folder.path(), &["motion", "two\nlines"]);
    assert_eq!(text(&output.stderr).lines().count(), 1);
}

/// Line ends and a mark of byte order as editors on other systems leave them.
#[test]
fn line_ends_and_byte_order_marks_of_other_systems_are_accepted() {
    let folder = folder();
    let plain = example("five_link.toml");
    let solved = |name: &str, content: &str| {
        std::fs::write(folder.path().join(name), content).expect("written");
        let output = run(folder.path(), &["motion", name, "--csv", "-"]);
        assert!(output.status.success(), "{}", text(&output.stderr));
        output.stdout
    };
    let expected = solved("plain.toml", &plain);
    let crlf = plain.replace('\n', "\r\n");
    assert_eq!(solved("straße \u{1f697}.toml", &crlf), expected);
    assert_eq!(solved("mark.toml", &format!("\u{feff}{plain}")), expected);
    let wrong = crlf.replace("unit = \"mm\"", "unit = \"ft\"");
    let message = refused_content(format!("\u{feff}{wrong}"));
    assert!(message.starts_with("bad.toml:6:8: "), "{message}");
}

/// The same mechanism a thousand kilometres away: the same motion, with all positions shifted.
#[test]
fn a_mechanism_1000_km_from_the_origin_has_the_same_motion() {
    const AWAY: [f64; 3] = [1e6, -2e6, 5e5];
    let folder = folder();
    let home = example("attia2003.toml");
    let away: Vec<String> = home.lines().map(|line| moved(line, AWAY)).collect();
    std::fs::write(folder.path().join("home.toml"), &home).expect("written");
    std::fs::write(folder.path().join("away.toml"), away.join("\n")).expect("written");
    let [home, away] = ["home.toml", "away.toml"].map(|name| {
        let output = run(folder.path(), &["motion", name, "--csv", "-"]);
        assert!(output.status.success(), "{}", text(&output.stderr));
        rows(&output.stdout)
    });
    assert_eq!(home.len(), away.len());
    for (home, away) in home.iter().zip(&away) {
        for (name, value) in home.iter().filter(|(name, _)| *name != "iterations") {
            // The measured height is a coordinate too.
            let name_of_coordinate = if name == "height_m" { "p11_z" } else { name };
            let axis = ["_x", "_y", "_z"]
                .iter()
                .position(|axis| name_of_coordinate.ends_with(axis));
            let turning = name.starts_with("omega") || name.starts_with("alpha");
            let moved = axis.filter(|_| !turning).map_or(0.0, |axis| AWAY[axis]);
            // The rounding errors of coordinates of this size, in input and output.
            let size = if moved == 0.0 { 1e-7 } else { 1e-9 };
            assert!(
                (away[name] - moved - value).abs() <= size * value.abs().max(1.0),
                "{name}"
            );
        }
        assert!(away["residual_m"] < 1e-14);
    }
}

/// A line of the file with a point's coordinates moved.
fn moved(line: &str, by: [f64; 3]) -> String {
    match line.split_once(" = [") {
        Some((name, list)) if name.starts_with('p') && !name.contains(' ') => {
            let (list, rest) = list.split_once(']').expect("a list");
            let numbers: Vec<String> = list
                .split(',')
                .zip(by)
                .map(|(number, by)| {
                    (number.trim().parse::<f64>().expect("a number") + by).to_string()
                })
                .collect();
            format!("{name} = [{}]{rest}", numbers.join(", "))
        }
        _ => line.to_owned(),
    }
}
