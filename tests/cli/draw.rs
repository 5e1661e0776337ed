//! `suspension draw`.

use super::program::{folder, run};

/// A swing arm with a damper, led by one of its drives.
fn drawn(drive: &str, at: f64) -> String {
    let folder = folder();
    let file = format!(
        "unit = 'm'\nstatements = '''\nfixed: front at [0.2, 0.3, 0.2], rear at [-0.2, 0.3, 0.2], top at [0.0, 0.5, 0.6];\n\
         free: low at [0.0, 0.5, 0.2], centre at [0.0, 0.7, 0.2];\nhinge arm: front, rear -> centre, low;\n{drive}\n'''\n\
         time = {{ instants = [0.0] }}\ndrives = {{ led = {at} }}\n"
    );
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let output = run(folder.path(), &["draw", "a.toml", "--out", "-"]);
    assert!(output.status.success(), "{output:?}");
    String::from_utf8(output.stdout).expect("text")
}

#[test]
fn a_damper_is_drawn_where_its_length_is_driven_as_where_it_is_measured() {
    let measured = drawn(
        "measure damper: length(low -> top);\ndrive led: centre.z;",
        0.2,
    );
    let driven = drawn("drive led: length(low -> top);", 0.4);
    let lines = |svg: &str| svg.matches("<polyline").count();
    assert_eq!(lines(&driven), lines(&measured));
}
