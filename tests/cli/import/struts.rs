//! MacPherson struts whose line passes through the lower ball joint.

use super::super::program::folder;
use super::refused::refusal;
use super::{import, listed, swept, table};

/// The front strut of a Porsche 718 in Assetto Corsa (ks_porsche_718_boxster_s), 0.7575 m outboard and 0.335 m above the
/// ground.
const STRUT: &str = "units; m\nwheel centre; 0; 0.7575; 0.335\nstrut top; -0.08294; 0.47253; 0.73718\n\
                     strut bottom; 0.01798; 0.64966; 0.17098\nlower arm front pivot; 0.26073; 0.3195; 0.16725\n\
                     lower arm rear pivot; -0.0128; 0.34693; 0.17828\nlower ball joint; 0.01798; 0.64966; 0.17098\n\
                     tie rod inner; 0.10865; 0.26907; 0.24211\ntie rod outer; 0.14781; 0.66043; 0.25021\n\
                     camber_angle; 0\ntoe_angle; 0\n";

/// Travel, rack, and what the closed form of MiniEngine (`tools/suspension_reference`, commit d8e54e9) gives: wheel centre
/// x, camber to the ground, toe, and the length of the strut from ball joint to top.
const PUBLISHED: [[f64; 6]; 3] = [
    [
        -0.083947953521,
        0.0,
        -0.001580486785,
        3.0035088703,
        -0.5134602853,
        0.672458811656,
    ],
    [
        0.081173285397,
        0.0,
        -0.003113596782,
        -1.5618498736,
        -0.1518295130,
        0.525762308916,
    ],
    [
        0.039664666962,
        0.02,
        -0.023516287988,
        0.7026758172,
        -8.0661448566,
        0.561696781152,
    ],
];

/// The strut's line is all that counts, so its lower end is placed farther up.
#[test]
fn a_strut_that_ends_in_the_ball_joint_moves_as_published() {
    let folder = folder();
    let imported = import(folder.path(), "a.csv", STRUT, &[]);
    let said = "a.csv: `strut bottom` is in the same place as `lower ball joint`: strut_low is placed a quarter of the way \
                from there to top. ";
    assert!(imported.notes.contains(said), "{}", imported.notes);
    let quarter = 0.601_782_621_301 / 4.0;
    for [travel, rack, x, camber, toe, strut] in PUBLISHED {
        let drives = [("bump", travel), ("steer", rack)].map(|(name, by)| format!("{name}={by}"));
        let stated = drives.each_ref().map(String::as_str);
        let row = &swept(folder.path(), "motion.toml", &stated)[0];
        for (name, published, gate) in [
            ("wheel_centre_x", x, 1e-11),
            ("camber_to_ground_deg", camber, 2e-10),
            ("toe_deg", toe, 2e-10),
            ("damper_m", strut - quarter, 2e-12),
        ] {
            let off = row[name] - published;
            assert!(off.abs() < gate, "{name}: {off:e} at {drives:?}");
        }
    }
}

/// The catalogue's strut on two lower links, its points under a name each and their rows.
fn on_two_links(names: &[(&str, &str)]) -> String {
    let points = listed("macpherson_two_links");
    let named = names.iter().map(|(own, name)| {
        let (_, at) = points
            .iter()
            .find(|(point, _)| point == own)
            .expect("a point");
        (*name, at.map(|at| 1000.0 * at))
    });
    table(&named.collect::<Vec<_>>())
}

const TWO_LINKS: [(&str, &str); 10] = [
    ("lateral_inner", "Lower control arm inner"),
    ("lateral_ball", "Lower control arm outer"),
    ("tension_inner", "Tension strut inner"),
    ("tension_ball", "Tension strut outer"),
    ("rack", "Tie rod inner"),
    ("tie_ball", "Tie rod outer"),
    ("top", "Strut top mount"),
    ("strut_low", "Strut lower mount"),
    ("wheel_centre", "Wheel centre"),
    ("axle", "Spindle"),
];

/// Names of the two links, as workshops and spreadsheets have them.
#[test]
fn a_strut_on_two_lower_links_is_found_by_usual_names() {
    let folder = folder();
    let links = [
        [
            "Lower control arm inner",
            "Lower control arm outer",
            "Tension strut inner",
            "Tension strut outer",
        ],
        [
            "LCA inner",
            "LCA outer ball joint",
            "Tension rod inner bush",
            "Tension rod outer ball joint",
        ],
        [
            "Transverse link inner",
            "Transverse link outer",
            "Thrust arm bushing",
            "Thrust arm ball joint",
        ],
        [
            "Control arm inboard",
            "Control arm outboard",
            "Tension link chassis",
            "Tension link knuckle",
        ],
        [
            "Querlenker innen",
            "Querlenker außen",
            "Zugstrebe innen",
            "Zugstrebe außen",
        ],
        [
            "Rear lower control arm inner",
            "Rear lower control arm outer",
            "Front lower control arm inner",
            "Front lower control arm outer",
        ],
        [
            "Rear lower link inner",
            "Rear lower link outer",
            "Front lower link inner",
            "Front lower link outer",
        ],
        [
            "Transverse arm inner",
            "Transverse arm outer",
            "Traction strut inner",
            "Traction strut outer",
        ],
        [
            "Track control arm inner",
            "Track control arm outer",
            "Compression rod inner",
            "Compression rod outer",
        ],
        [
            "TCA inner",
            "TCA outer",
            "Caster arm inner",
            "Caster arm outer",
        ],
        [
            "Lower arm inner",
            "Lower arm outer",
            "Radius rod inner",
            "Radius rod outer",
        ],
        [
            "Lateral link inner",
            "Lateral link outer",
            "Tension arm inner",
            "Tension arm outer",
        ],
    ];
    for named in links {
        let mut names = TWO_LINKS;
        for ((_, name), other) in names.iter_mut().zip(named) {
            *name = other;
        }
        let imported = import(folder.path(), "a.csv", &on_two_links(&names), &[]);
        assert_eq!(
            imported.text("linkage"),
            "macpherson_two_links",
            "{named:?}"
        );
        let points = imported.points();
        assert_eq!(points["lateral_inner"], [-50.0, 340.0, 185.0], "{named:?}");
        assert_eq!(points["tension_ball"], [40.0, 690.0, 175.0], "{named:?}");
        assert!(imported.notes.contains("strut_high"), "{}", imported.notes);
        let row = &swept(folder.path(), "motion.toml", &["bump=0.0"])[0];
        assert!(
            (row["virtual_kingpin_deg"] - 12.1379).abs() < 1e-4,
            "{named:?}"
        );
    }
}

/// Other names of the ends of the strut and of the tie rod.
#[test]
fn a_strut_is_found_by_other_names_of_its_ends() {
    let folder = folder();
    let plain = import(folder.path(), "a.csv", &on_two_links(&TWO_LINKS), &[]).points();
    for [inner, outer, top, low] in [
        [
            "Tie rod inner",
            "Track rod end",
            "Federbein oben",
            "Federbein unten",
        ],
        [
            "Inner tie rod end",
            "Outer tie rod end",
            "Federbeinlager",
            "Strut bottom",
        ],
        [
            "Rack end",
            "Tie rod end",
            "Strut mount",
            "Strut lower mount",
        ],
    ] {
        let mut names = TWO_LINKS;
        for (at, name) in [(4, inner), (5, outer), (6, top), (7, low)] {
            names[at].1 = name;
        }
        let imported = import(folder.path(), "a.csv", &on_two_links(&names), &[]);
        assert_eq!(imported.points(), plain, "{names:?}");
    }
}

/// The tension strut runs forward, so the file's x axis points rearward.
#[test]
fn the_tension_strut_tells_the_direction_of_x() {
    let folder = folder();
    let file = on_two_links(&TWO_LINKS);
    let turned = file
        .lines()
        .map(|line| match line.split(", ").collect::<Vec<_>>()[..] {
            [name, x, y, z] => format!(
                "{name}, {}, -{y}, {z}\n",
                0.0 - x.parse::<f64>().expect("x")
            ),
            _ => format!("{line}\n"),
        });
    let turned = turned.collect::<String>();
    assert_ne!(turned, file);
    let imported = import(folder.path(), "a.csv", &turned, &["--side", "left"]);
    assert_eq!(
        imported.points()["tension_inner"],
        [340.0, 400.0, 185.0],
        "{}",
        imported.notes
    );
}

/// The refusal of a table that lacks a point names the nearest layout: the strut on one arm, or on two links.
#[test]
fn a_strut_that_lacks_a_point_is_nearest_to_the_layout_of_its_lower_end() {
    let arm = [
        ("LCA front", [10.0, 360.0, 190.0]),
        ("LCA rear", [-300.0, 370.0, 200.0]),
        ("LCA outer", [5.0, 720.0, 170.0]),
        ("Tie rod inner", [-140.0, 330.0, 250.0]),
        ("Tie rod outer", [-135.0, 690.0, 240.0]),
        ("Strut top", [-30.0, 575.0, 830.0]),
        ("Strut lower mount", [0.0, 631.0, 410.0]),
        ("Wheel centre", [0.0, 760.0, 310.0]),
    ];
    for left_out in 0..arm.len() {
        let mut points = arm.to_vec();
        points.remove(left_out);
        let message = refusal("a.csv", &table(&points), &[]);
        assert!(
            message.contains("the nearest, macpherson, lacks "),
            "{message}"
        );
    }
    // The second point of the strut's line and of the spin axis are placed from the others.
    for left_out in 0..TWO_LINKS.len() - 1 {
        let mut names = TWO_LINKS.to_vec();
        let (own, _) = names.remove(left_out);
        let message = refusal("a.csv", &on_two_links(&names), &[]);
        let expected = format!("the nearest, macpherson_two_links, lacks `{own}`");
        assert!(message.contains(&expected), "{message}");
    }
}

/// A known point that the nearest layout does not have may be a mistake in a name.
#[test]
fn points_of_other_layouts_are_named_where_one_is_missing() {
    let mut names = TWO_LINKS.to_vec();
    names.retain(|(own, _)| *own != "rack");
    let file = format!("{}Pushrod inner, 0, 0, 0\n", on_two_links(&names));
    let message = refusal("a.csv", &file, &[]);
    let expected = "; of other layouts: `Pushrod inner` (a.csv:10); suspension import --names";
    assert!(message.contains(expected), "{message}");
}

/// The upper point of the strut's line, which the file lacks, is placed halfway, and does not hide the mistake.
#[test]
fn a_slipped_decimal_point_of_a_strut_is_noted() {
    let strut = STRUT.replace("0.64966; 0.17098\nlower arm", "0.6; 0.41\nlower arm");
    for (written, slipped, expected) in [
        (
            "0.6; 0.41",
            "0.6; 4.1",
            "`strut_low` (strut bottom, a.csv:4) lies 3.367 m from the other points: should its z be 0.41 instead of 4.1?",
        ),
        (
            "0.73718",
            "7.3718",
            "`top` (strut top, a.csv:3) lies 6.964 m from the other points: ",
        ),
    ] {
        assert!(strut.contains(written), "{strut}");
        let folder = folder();
        let file = strut.replace(written, slipped);
        let notes = import(folder.path(), "a.csv", &file, &[]).notes;
        assert!(notes.contains(expected), "{notes}");
        let notes = import(folder.path(), "a.csv", &strut, &[]).notes;
        assert!(!notes.contains("from the other points"), "{notes}");
    }
}

#[test]
fn german_names_of_a_strut_are_known() {
    let folder = folder();
    for (top, ball) in [
        ("Domlager", "Führungsgelenk"),
        ("Stützlager", "Radführungsgelenk"),
    ] {
        let strut = STRUT
            .replace("strut top", top)
            .replace("lower ball joint", ball)
            .replace("tie rod inner", "Spurstangengelenk innen")
            .replace("tie rod outer", "Spurstangengelenk außen")
            .replace("units; m", "Alle Maße in m");
        let imported = import(folder.path(), "a.csv", &strut, &[]);
        let said = "the unit of lengths is m, as the file says";
        assert!(imported.notes.contains(said), "{}", imported.notes);
        assert_eq!(imported.points()["top"], [-0.08294, 0.47253, 0.73718]);
    }
}
