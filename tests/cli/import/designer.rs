//! Double wishbones of FS-Suspension-Designer, a MATLAB program with a solver of its own: the regression tests of its commit 6f94ab5.

use std::path::Path;

use super::super::program::folder;
use super::{import, swept};

/// A corner whose wishbones turn about lines along x; front left, x rearward, y right, z up.
const PLANE: &str = "units; m\nUCA front; -0.1; -0.4; 0.35\nUCA rear; 0.1; -0.4; 0.35\nUBJ; 0; -0.6; 0.4166666666666667\n\
                     LCA front; -0.1; -0.4; 0.15\nLCA rear; 0.1; -0.4; 0.15\nLBJ; 0; -0.6; 0.08333333333333333\n\
                     Tie rod inboard; 0.05; -0.4; 0.25\nTie rod outboard; 0.05; -0.57; 0.23\nWheel center; 0; -0.65; 0.25\n";

/// A corner whose wishbones turn about oblique lines.
const OBLIQUE: &str = "units; m\nUCA front; -0.12; -0.38; 0.36\nUCA rear; 0.1; -0.42; 0.34\nUBJ; 0.03; -0.6; 0.42\n\
                       LCA front; -0.11; -0.39; 0.14\nLCA rear; 0.12; -0.41; 0.16\nLBJ; -0.02; -0.6; 0.08\n\
                       Tie rod inboard; 0.04; -0.39; 0.25\nTie rod outboard; 0.05; -0.57; 0.23\nWheel center; 0; -0.65; 0.25\n";

/// The positions of upper and lower ball joint, tie rod and wheel centre in the program's axes, m; camber and toe, rad.
type Published = [f64; 14];

const PLANE_BUMP: Published = [
    0.0,
    -0.593_040_544_489_881_4,
    0.434_733_656_993_514_6,
    0.0,
    -0.605_192_603_365_927_5,
    0.101_621_906_110_745_17,
    0.050_747_285_623_706_2,
    -0.571_146_970_751_954_9,
    0.247_144_134_697_485_47,
    -0.001_272_466_597_828_217,
    -0.649_067_152_990_470_5,
    0.27,
    -0.036_464_256_825_650_805,
    0.025_469_003_018_318_85,
];

const PLANE_REBOUND: Published = [
    0.0,
    -0.605_192_608_936_599_1,
    0.398_378_070_261_600_4,
    0.0,
    -0.593_040_534_369_953_6,
    0.065_266_319_951_231_06,
    0.049_203_186_777_301_82,
    -0.567_118_529_653_883_5,
    0.212_976_195_022_497_43,
    0.001_299_856_815_792_511,
    -0.649_066_446_300_292_2,
    0.23,
    0.036_464_303_928_760_06,
    -0.026_017_352_787_515_95,
];

const OBLIQUE_BUMP: Published = [
    0.031_734_444_260_060_626,
    -0.595_676_016_302_773_6,
    0.430_430_919_466_214_03,
    -0.021_245_219_553_871_89,
    -0.603_350_815_583_076,
    0.090_969_209_286_450_5,
    0.050_553_637_698_901_505,
    -0.570_775_962_633_352_5,
    0.239_575_410_545_010_9,
    -0.000_575_546_056_971_639_6,
    -0.649_407_663_341_358,
    0.262,
    -0.025_167_319_421_219_202,
    0.016_426_452_901_017_508,
];

/// Compares both wheels of an axle, of which the program has the right one as the mirror image of the left one.
fn agrees(folder: &Path, travel: f64, published: &Published) {
    let drives = ["left", "right"].map(|side| format!("{side}_bump={travel}"));
    let row = &swept(
        folder,
        "motion.toml",
        &drives.each_ref().map(String::as_str),
    )[0];
    for (side, outboard) in [("left", -1.0), ("right", 1.0)] {
        let points = ["upper_ball", "lower_ball", "tie_ball", "wheel_centre"];
        for (point, at) in points.iter().zip(published.chunks(3)) {
            for ((axis, sign), at) in [("x", -1.0), ("y", outboard), ("z", 1.0)].iter().zip(at) {
                let off = row[&format!("{side}_{point}_{axis}")] - sign * at;
                assert!(
                    off.abs() < 1e-15,
                    "{side}_{point}_{axis}: {off:e} at {travel}"
                );
            }
        }
        for (angle, published) in ["camber", "toe"].iter().zip(&published[12..]) {
            let off = row[&format!("{side}_{angle}_deg")] - published.to_degrees();
            assert!(off.abs() < 1e-12, "{side}_{angle}: {off:e} at {travel}");
        }
    }
}

/// The roles of points in the program, after the code of the corner.
#[test]
fn a_table_with_the_names_of_the_program_has_the_same_points() {
    let folder = folder();
    let named = [
        ("UCA front", "FL_UCA_FWD_CHASSIS"),
        ("UCA rear", "FL_UCA_AFT_CHASSIS"),
        ("UBJ", "FL_UBJ"),
        ("LCA front", "FL_LCA_FWD_CHASSIS"),
        ("LCA rear", "FL_LCA_AFT_CHASSIS"),
        ("LBJ", "FL_LBJ"),
        ("Tie rod inboard", "FL_TIE_ROD_INBOARD"),
        ("Tie rod outboard", "FL_TIE_ROD_OUTBOARD"),
        ("Wheel center", "FL_WHEEL_CENTER"),
    ];
    let mut file = OBLIQUE.to_owned();
    for (ours, theirs) in named {
        file = file.replace(ours, theirs);
    }
    let expected = import(folder.path(), "a.csv", OBLIQUE, &[]).points();
    assert_eq!(
        import(folder.path(), "b.csv", &file, &[]).points(),
        expected
    );
}

#[test]
fn double_wishbones_move_as_published_by_a_program_for_formula_student() {
    let folder = folder();
    for (corner, travel, published) in [
        (PLANE, 0.02, PLANE_BUMP),
        (PLANE, -0.02, PLANE_REBOUND),
        (OBLIQUE, 0.012, OBLIQUE_BUMP),
    ] {
        let imported = import(folder.path(), "a.csv", corner, &["--axle"]);
        assert!(
            imported.notes.contains("axes are Adams"),
            "{}",
            imported.notes
        );
        agrees(folder.path(), travel, &published);
    }
}
