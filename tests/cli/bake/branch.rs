//! Measures that have the same values on two branches.

use super::super::program::{folder, run, text};
use super::languages::numbers;

/// An arm that swings past the line to the mount of a damper, which has each length on both sides of it.
#[test]
fn a_measure_with_two_branches_is_baked_on_that_of_the_first_instant() {
    let folder = folder();
    let first_heights = [0.4, 0.2].map(|lift| {
        let file = format!(
            "statements = '''fixed: front at [0.2, 0.3, 0.3], rear at [-0.2, 0.3, 0.3], mount at [0.0, 0.9, 0.3];\n\
             free: hub at [0.0, 0.7, 0.3]; hinge arm: front, rear -> hub;\n\
             drive lift: hub.z; measure reach: length(mount -> hub);'''\n\
             unit = \"m\"\n[time]\nstart = 0.0\nstop = 1.0\nstep = 1.0\n[drives]\nlift = {lift:?}\n"
        );
        std::fs::write(folder.path().join("arm.toml"), file).expect("written");
        let along = ["--along", "reach=0.23:0.3", "--points", "all", "--as", "toml"];
        let output = run(folder.path(), &[&["bake", "arm.toml", "-o", "-"], &along[..]].concat());
        let baked = text(&output.stdout);
        let branch = format!("in place of drive lift, on the branch of lift = {lift:?} m.\n");
        assert!(baked.contains(&branch), "{baked}{}", text(&output.stderr));
        let table: toml::Table = baked.parse().expect("TOML");
        numbers(&table["segments"])[2]
    });
    let [above, below] = first_heights.map(|height| height - 0.3);
    assert!(
        above > 0.09 && (above + below).abs() < 1e-6,
        "{first_heights:?}"
    );
}
