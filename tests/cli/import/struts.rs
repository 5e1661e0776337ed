//! MacPherson struts whose line passes through the lower ball joint.

use super::super::program::folder;
use super::{import, swept};

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
