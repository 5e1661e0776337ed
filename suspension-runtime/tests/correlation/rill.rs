//! The double wishbone of G. Rill, Road Vehicle Dynamics, 2012 (listing 5.6): what the book prints at the design position (page
//! 155, as MiniEngine quotes it), and the closed form of MiniEngine for the same hardpoints (commit d8e54e9, `tools/suspension_reference`).

use suspension_core::wheel::{Heading, SteeringAxis, camber_to_ground, caster, kingpin_angle, toe};

use nalgebra::Vector3;

use crate::agreement::Agreement;
use crate::published::{folder, geometry, number, point};
use crate::suspension::{DOUBLE_WISHBONE, Suspension, values};

/// The file's names.
fn published(name: &str) -> &str {
    match name {
        "lower_inboard_front" => "lower_front",
        "lower_inboard_rear" => "lower_rear",
        "upper_inboard_front" => "upper_front",
        "upper_inboard_rear" => "upper_rear",
        "lower_outboard" => "lower_outer",
        "upper_outboard" => "upper_outer",
        "trackrod_inboard" => "rack",
        "trackrod_outboard" => "draglink_outer",
        _ => "wheel_center",
    }
}

/// Travel and rack, m; wheel centre x, m, camber to the ground and toe, degrees.
const CLOSED_FORM: [[f64; 5]; 4] = [
    [
        -0.070198595737,
        0.0,
        0.003566817762,
        -0.9989079132,
        -0.2385631219,
    ],
    [
        0.072591766230,
        0.0,
        -0.003557648744,
        0.6719665150,
        0.1595177544,
    ],
    [
        -0.002469436013,
        -0.04,
        -0.017970123956,
        3.4923888587,
        -17.7961230844,
    ],
    [
        0.037460189977,
        0.03,
        0.010106688461,
        -0.5676288193,
        12.0156654850,
    ],
];

#[test]
fn rill() {
    let Some(folder) = folder("rill") else {
        return;
    };
    let table = geometry(&folder.join("hardpoints_without_results.toml"));
    let table = &table["rill_double_wishbone_book"];
    let suspension = Suspension::new(DOUBLE_WISHBONE, |name| {
        // The spin axis is [0, 1, -camber], with the camber in radians.
        let camber = number(&table["initial_camber_deg"]).to_radians();
        let inboard = Vector3::new(0.0, -1.0, camber);
        let is_inner = name == "axle_inboard";
        point(&table[published(name)]) + if is_inner { inboard } else { Vector3::zeros() }
    });
    let design = suspension.design().in_bump();
    let spin = values(&design.spin_axis());
    let contact = values(&design.contact(number(&table["tyre_radius_m"])));
    let ends = ["lower_outboard", "upper_outboard"].map(|name| values(&design.point(name)));
    let (axis, heading) = (SteeringAxis::through(ends), Heading::of(&spin));
    let mut agreement = Agreement::default();
    for (name, gate, ours, printed) in [
        (
            "kingpin",
            5e-5,
            kingpin_angle(&axis.direction, &spin).to_degrees(),
            10.5182,
        ),
        ("caster", 5e-5, caster(&axis.direction).to_degrees(), 7.0561),
        (
            "caster offset",
            5e-7,
            axis.ahead_of(&contact, &heading),
            0.030326,
        ),
        (
            "scrub radius",
            5e-8,
            axis.inboard_of(&contact, &heading),
            0.0010327,
        ),
    ] {
        agreement.note(name, gate, ours - printed);
    }
    for [travel, rack, x, camber, turned] in CLOSED_FORM {
        let moved = suspension.design().moved([travel, rack]).in_bump();
        let spin = values(&moved.spin_axis());
        agreement.note("wheel centre x", 1e-12, values(&moved.centre()).x - x);
        agreement.note(
            "camber",
            1e-10,
            camber_to_ground(&spin).to_degrees() - camber,
        );
        agreement.note("toe", 1e-10, toe(&spin).to_degrees() - turned);
    }
    agreement.holds("Rill", 16);
}
