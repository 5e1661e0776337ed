//! Names of rows: words that are joined or in parentheses, and notes on names that are mistyped or may mean two things.

use super::super::program::folder;
use super::{CORNER, import, table};

#[test]
fn a_mistyped_name_of_a_number_is_noted_with_a_suggestion() {
    let folder = folder();
    let imported = import(
        folder.path(),
        "a.csv",
        &(table(&CORNER) + "toe_angel, 0.2\n"),
        &[],
    );
    let expected = "numbers that are not used: `toe_angel` (a.csv:16, did you mean toe_angle?)\n";
    assert!(imported.notes.contains(expected), "{}", imported.notes);
}

/// `Spur` is the toe or the track, and a diameter is no radius: neither is guessed.
#[test]
fn numbers_that_may_be_toe_or_are_a_diameter_are_noted_with_what_to_write() {
    let folder = folder();
    let rows = "Spur, 0.2\nTire Diameter, 458\nReifendurchmesser, 458\nSpurweite, 1220\n";
    let notes = import(folder.path(), "a.csv", &(table(&CORNER) + rows), &[]).notes;
    let expected = "numbers that are not used: `Spur` (a.csv:16, did you mean vorspur?), \
                    `Tire Diameter` (a.csv:17, write half of it as wheel_radius), \
                    `Reifendurchmesser` (a.csv:18, write half of it as wheel_radius), `Spurweite` (a.csv:19)\n";
    assert!(notes.contains(expected), "{notes}");
}

/// A pushrod that is not known would leave a double wishbone without one.
#[test]
fn words_of_a_point_name_may_be_joined_or_separate() {
    let names = [
        ("prod_outboard", "Push rod outer"),
        ("prod_inboard", "Push rod inner"),
        ("shock_to_bellcrank", "Shock to bell crank"),
        ("uca_front", "UCA Front"),
    ];
    let folder = folder();
    let [known, apart] = [false, true].map(|is_apart| {
        let file = names.iter().fold(table(&CORNER), |file, (name, other)| {
            assert!(file.contains(name), "{name}");
            if is_apart {
                file.replace(name, other)
            } else {
                file
            }
        });
        import(folder.path(), "a.csv", &file, &[])
    });
    assert!(
        known.notes.contains("the layout is double_wishbone_"),
        "{}",
        known.notes
    );
    let layout = |notes: &str| notes.lines().next().map(str::to_owned);
    assert_eq!(layout(&apart.notes), layout(&known.notes));
    assert!(!apart.notes.contains("not used"), "{}", apart.notes);
}

/// `axle` is a point of the layout too.
#[test]
fn words_in_parentheses_are_part_of_a_name_or_a_remark() {
    let names = [
        ("tierod_inner", "Tie rod (inner)"),
        ("wheel_center", "Wheel centre (WC)"),
        ("uca_outer", "UCA outer (axle)"),
        ("lca_outer", "Joint (LCA outer)"),
        ("tire_radius", "tire radius (mm)"),
    ];
    let folder = folder();
    let plain = table(&CORNER) + "tire_radius, 229\n";
    let names = names.iter();
    let file = names.fold(plain.clone(), |file, (name, other)| {
        file.replace(name, other)
    });
    let [plain, file] = [plain, file].map(|file| import(folder.path(), "a.csv", &file, &[]));
    assert_eq!(file.points(), plain.points(), "{}", file.notes);
    assert_eq!(file.motion["vehicle"], plain.motion["vehicle"]);
}

#[test]
fn a_mistyped_optional_point_is_noted_with_a_suggestion() {
    let folder = folder();
    let file = table(&CORNER).replace("shock_to_chassis", "shock_to_chasis");
    let imported = import(folder.path(), "a.csv", &file, &[]);
    let expected = "shock_to_chasis (did you mean shock_to_chassis?)";
    assert!(imported.notes.contains(expected), "{}", imported.notes);
}

#[test]
fn short_words_of_cad_exports_and_german_names_are_known() {
    let folder = folder();
    let known = import(folder.path(), "a.csv", &table(&CORNER), &[]).points();
    for names in [
        [
            ("lca_front", "LCA CHMNT front"),
            ("lca_outer", "lwr ball jt"),
            ("uca_front", "UWBF"),
            ("uca_outer", "UCA OB"),
            ("tierod_inner", "Rack ball"),
            ("tierod_outer", "tie rod OB"),
            ("wheel_center", "wheel hub ctr"),
            ("prod_outboard", "pushrod btm"),
            ("prod_inboard", "pushrod IB"),
        ],
        [
            ("lca_front", "LCA front"),
            ("lca_outer", "Lower BJ"),
            ("uca_front", "UCA front"),
            ("uca_outer", "uprt upper BJ"),
            ("tierod_inner", "Steering tie rod inboard"),
            ("tierod_outer", "Steering tie rod uprt"),
            ("wheel_center", "WC"),
            ("prod_outboard", "pushrod outboard"),
            ("prod_inboard", "pushrod inboard"),
        ],
        [
            ("lca_front", "Querlenker unten vorne innen"),
            ("lca_outer", "Radführungsgelenk unten"),
            ("uca_front", "Querlenker oben vorne"),
            ("uca_outer", "Führungsgelenk oben"),
            ("tierod_inner", "Spurstange innen"),
            ("tierod_outer", "Spurhebel"),
            ("wheel_center", "Radnabe Mitte"),
            ("bellcrank_pivot", "Umlenkhebel Drehpunkt"),
            ("bellcrank_axis", "Umlenkhebelachse"),
        ],
        [
            ("lca_front", "Bras inf\u{e9}rieur avant int."),
            ("lca_outer", "LCA_O"),
            ("uca_front", "Upr. arm frt."),
            ("uca_outer", "UCA_O"),
            ("tierod_inner", "Biellette direction int."),
            ("tierod_outer", "Biellette direction ext."),
            ("wheel_center", "Wheel ctr."),
            ("shock_to_bellcrank", "Spring/damper rocker"),
            ("shock_to_chassis", "Spring/damper chassis"),
        ],
    ] {
        let mut file = table(&CORNER);
        for (name, other) in names {
            assert!(file.contains(name), "{name}");
            file = file.replace(name, other);
        }
        let imported = import(folder.path(), "a.csv", &file, &[]);
        assert_eq!(imported.points(), known, "{}", imported.notes);
        assert!(!imported.notes.contains("not used"), "{}", imported.notes);
    }
}

#[test]
fn german_names_of_five_links_are_known() {
    let file = "Rear axle
Lower front link inner, 142.1, 318.2, 101.4
Upper front link inner, 118.4, 402.6, 318.2
Upper rear link inner, -96.3, 388.7, 341.5
Lower rear link inner, -212.4, 251.9, 121.2
Toe link inner, -118.7, 302.5, 128.4
Lower front link outer, 46.1, 688.2, 118.9
Upper front link outer, 18.4, 661.7, 371.4
Upper rear link outer, -28.3, 671.2, 384.9
Lower rear link outer, -52.6, 672.3, 108.1
Toe link outer, -139.2, 662.8, 142.8
Wheel centre, 0, 742, 262
";
    let words = [
        ("Rear axle", "Hinterachse"),
        ("Toe link", "Spurlenker"),
        ("Wheel centre", "Radmitte"),
        ("link", "Lenker"),
        ("Lower", "Unterer"),
        ("Upper", "Oberer"),
        ("front", "vorderer"),
        ("rear", "hinterer"),
        ("inner", "innen"),
        ("outer", "au\u{df}en"),
    ];
    let words = words.iter();
    let german = words.fold(file.to_owned(), |file, (name, other)| {
        file.replace(name, other)
    });
    let folder = folder();
    let [english, german] = [file, &german].map(|file| import(folder.path(), "a.csv", file, &[]));
    assert_eq!(german.points(), english.points());
    assert_eq!(german.text("linkage"), "multi_link");
}
