//! Mechanisms whose assemblies are known in closed form.

use nalgebra::Vector3;
use suspension::assemblies::Assemblies;
use suspension_core::{Build, Inputs, Linkage, Signal, Still, linkage};

linkage! {
    /// A point on two links, its height driven: the two points where circles meet.
    mod two_links {
        fixed: left, right;
        free:  top;
        link one: left -> top;
        link two: right -> top;
        drive height: top.z;
    }
}

linkage! {
    /// A point on three links, one of which has its foot driven.
    mod tripod {
        fixed: left, right, rear;
        free:  top;
        link one:   left -> top;
        link two:   right -> top;
        link three: rear -> top;
        drive foot: rear.x;
    }
}

const DESIGN: two_links::Points<f64> = two_links::Points {
    left: Vector3::new(-3.0, 0.0, 0.0),
    right: Vector3::new(3.0, 0.0, 0.0),
    top: Vector3::new(0.0, 4.0, 0.0),
};

fn at(height: f64) -> Inputs<Still, two_links::Drives<f64>> {
    Inputs::still(Signal {
        value: two_links::Drives { height },
        ..Signal::default()
    })
}

/// Feet at (-3, 0, 0) and (3, 0, 0), links of length 5: at height z the point stands at
/// (0, +-sqrt(16 - z^2), z), and nowhere above 4.
#[test]
fn two_links_at_a_height_have_two_assemblies_or_none() {
    let model = two_links::Model::new(&DESIGN).expect("a geometry");
    let near = model.unknowns(&DESIGN);
    let mut search = Assemblies::new(&model, &near, &at(0.0), &|_, _| true);
    for height in [0.0, 1.0, 3.999, 4.001, 7.0] {
        let census = search.at(&at(height)).expect("a census");
        assert!(census.tally.doubts().is_empty(), "{height}: {census:?}");
        let [part] = census.tally.parts.as_slice() else {
            panic!("{height}: {census:?}")
        };
        assert_eq!(part.generic, 2);
        let square: f64 = 16.0 - height * height;
        if square < 0.0 {
            assert_eq!((census.real.len(), part.complex), (0, 2), "{height}");
            continue;
        }
        let mut along: Vec<f64> = census.real.iter().map(|q| q.y).collect();
        along.sort_by(f64::total_cmp);
        let expected = [-square.sqrt(), square.sqrt()];
        assert_eq!(along.len(), 2, "{height}");
        for (found, expected) in along.iter().zip(expected) {
            assert!(
                (found - expected).abs() < 1e-12,
                "{height}: {found} {expected}"
            );
        }
    }
}

/// At a height of 4 the two points meet: with imaginary parts of 4.7e-6 they may be real.
#[test]
fn roots_beside_a_fold_are_not_counted_as_complex() {
    let model = two_links::Model::new(&DESIGN).expect("a geometry");
    let near = model.unknowns(&DESIGN);
    let mut search = Assemblies::new(&model, &near, &at(0.0), &|_, _| true);
    let census = search
        .at(&at(4.0 + 4.7e-6 * 4.7e-6 / 8.0))
        .expect("a census");
    println!("{census:?}");
    let [part] = census.tally.parts.as_slice() else {
        panic!("one part")
    };
    assert_eq!((census.real.len(), part.complex), (0, 0));
    assert!(part.unconfirmed > 0 && part.unaccounted() == 2);
    assert!(!census.tally.doubts().is_empty());
}

/// A drive that moves a foot: no equation is linear in it, and the trace test says that it does not
/// apply.
#[test]
fn a_tripod_has_two_assemblies_for_any_position_of_its_foot() {
    let design = tripod::Points {
        left: Vector3::new(-3.0, 0.0, 0.0),
        right: Vector3::new(3.0, 0.0, 0.0),
        rear: Vector3::new(1.0, 2.0, 0.0),
        top: Vector3::new(0.5, 0.5, 4.0),
    };
    let model = tripod::Model::new(&design).expect("a geometry");
    let at = |foot| {
        Inputs::still(Signal {
            value: tripod::Drives { foot },
            ..Signal::default()
        })
    };
    let near = model.unknowns(&design);
    let mut search = Assemblies::new(&model, &near, &at(1.0), &|_, _| true);
    for foot in [0.0, 1.0, 2.0] {
        let census = search.at(&at(foot)).expect("a census");
        assert!(census.tally.doubts().is_empty(), "{foot}: {census:?}");
        assert_eq!(census.tally.parts[0].evidence.trace, None);
        // The feet lie in the plane z = 0, in which the two are mirror images.
        let [a, b] = census.real[..] else {
            panic!("{foot}: {census:?}")
        };
        let mirrored: Vector3<f64> = Vector3::new(b.x, b.y, -b.z);
        assert!((a - mirrored).amax() < 1e-12, "{foot}");
        let rear = Vector3::new(foot, 2.0, 0.0);
        let length = (design.top - design.rear).norm();
        assert!(((a - rear).norm() - length).abs() < 1e-12, "{foot}");
    }
}
