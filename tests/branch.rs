//! The assembly found from the paper's printed initial guess, and the ends of motions.

use nalgebra::{SVector, Vector3};
use suspension_core::linkage::Named;
use suspension_core::linkages::{attia2003, five_link};
use suspension_core::listing::{Part, Parts};
use suspension_core::{
    Bounded, Build, GeometryError, Inputs, Linkage, Motion, Newton, Signal, SolveError, Still,
    Tracker, Values, assemble, model::handedness,
};

use crate::support::{self, Reference};

/// Returns the signed volume spanned by points 6, 7, 8 and 9: its sign distinguishes a knuckle from its mirror image.
fn handedness(q: &SVector<f64, 15>) -> f64 {
    let point = |index: usize| q.fixed_rows::<3>(3 * index).into_owned();
    let [u, v, w] = [1, 2, 3].map(|index| point(index) - point(0));
    u.cross(&v).dot(&w)
}

fn printed_guess() -> SVector<f64, 15> {
    let points: Vec<Vector3<f64>> = (6..=10)
        .map(|number| support::printed_guess(&format!("p{number}")))
        .collect();
    SVector::from_iterator(points.iter().flat_map(|point| point.iter().copied()))
}

/// Nine distances admit a mirrored knuckle, and Newton's method finds it: residual zero, wrong.
#[test]
fn nine_distances_converge_to_a_mirrored_knuckle() {
    let model: attia2003::Model<f64> = support::attia_model();
    let mut q = printed_guess();
    let plain = Newton {
        max_halvings: 0,
        ..Newton::from_afar()
    };
    let converged = plain
        .solve(&model, &support::attia_inputs(0.0), &mut q)
        .expect("a root, though not the published one");
    let published = Reference::load().unknowns(0, "");
    assert!(converged.residual() < 1e-15);
    assert!(handedness(&published) < 0.0 && handedness(&q) > 0.0);
    assert!((q - published).amax() > 0.01, "a different configuration");
}

/// The best rigid fit and the orientation-keeping closure lead to Table 2.
#[test]
fn the_rigid_knuckle_assembles_as_published() {
    let model: five_link::Model<f64> = support::five_link_model();
    let mut q = printed_guess();
    let inputs = support::five_link_inputs(0.0);
    assemble(&Newton::from_afar(), &model, &inputs, &mut q).expect("Table 2's configuration");
    let published = Reference::load().unknowns(0, "");
    assert!((q - published).amax() < 5e-15);
}

/// The nine distances are fitted as the rigid body that they are, and end there too.
#[test]
fn nine_distances_assemble_as_published() {
    let model: attia2003::Model<f64> = support::attia_model();
    let mut q = printed_guess();
    let inputs = support::attia_inputs(0.0);
    assemble(&Newton::from_afar(), &model, &inputs, &mut q).expect("Table 2's configuration");
    let published = Reference::load().unknowns(0, "");
    assert!((q - published).amax() < 5e-15);
}

/// Every method that could return a root with a mirrored knuckle refuses it.
#[test]
fn no_method_returns_a_mirrored_knuckle() {
    let model: attia2003::Model<f64> = support::attia_model();
    let inputs = support::attia_inputs(0.0);
    let plain = Newton {
        max_halvings: 0,
        ..Newton::from_afar()
    };
    let mut mirrored = printed_guess();
    let found = plain.solve(&model, &inputs, &mut mirrored);
    found.expect("a root, though not the published one");
    let wrong = SolveError::Mirrored { part: support::P9 };
    let points = handedness::count_mirrored(&model, &mirrored, model.fixed());
    assert!((points - 1.0).abs() < 1e-12, "{points}");
    let start = Motion::at_rest(mirrored);
    let mut motion = start;
    let step = Tracker::default().step(&model, &inputs, 0.0, &mut motion);
    assert_eq!((step.expect_err("mirrored"), motion), (wrong, start));
    let step = <Bounded<f64>>::default().step(&model, &inputs, 0.0, &mut motion);
    assert_eq!((step.expect_err("mirrored"), motion), (wrong, start));
    // A guess with the point on the wrong side is turned round.
    assemble(&Newton::from_afar(), &model, &inputs, &mut mirrored)
        .expect("Table 2's configuration");
    let published = Reference::load().unknowns(0, "");
    assert!((mirrored - published).amax() < 5e-15);
}

/// Four points in a plane: three distances do not hold the fourth, a body does.
#[test]
fn a_coplanar_knuckle_of_distances_is_refused() {
    let rough = support::attia_rough();
    let [p6, p7, p8] = [rough.p6, rough.p7, rough.p8];
    let flat = |height: f64| attia2003::Points {
        p9: p6 + (p7 - p6) * 0.3 - (p8 - p6) * 0.8
            + (p7 - p6).cross(&(p8 - p6)).normalize() * height,
        ..rough
    };
    assert!(attia2003::Model::new(&flat(0.01)).is_ok());
    let error = attia2003::Model::new(&flat(1e-6)).expect_err("in the plane of 6, 7 and 8");
    assert_eq!(
        error,
        GeometryError::Flat {
            point: support::P9.index()
        }
    );
    let message = error.named(&attia2003::Listing).to_string();
    assert!(message.contains("`p9`") && message.contains("`body`"));
    let points = flat(0.0);
    let mut points = points.values();
    let design = five_link::Points::from_fn(|_| points.next().unwrap_or_default());
    five_link::Model::new(&design).expect("a body may be flat");
}

/// The published two seconds end at a turning point of the drive (extended system, 40 digits).
#[test]
fn the_motion_ends_where_the_mechanism_locks() {
    let limit = 1.978_367_769_183_33;
    let model: attia2003::Model<f64> = support::attia_model();
    let mut motion = *support::motions(&model, &support::attia_rough(), support::attia_inputs)
        .last()
        .expect("nine motions");
    let stopped = Tracker::default()
        .advance(&model, support::attia_inputs, 1.95, 2.0, &mut motion)
        .expect_err("no configuration beyond the turning point");
    assert!(
        (stopped.reached - limit).abs() < 1e-9,
        "stopped at {}",
        stopped.reached
    );
    let inputs = support::attia_inputs(stopped.reached).drives;
    let coordinates = model.coordinates(&inputs);
    let residual = model.residual(&motion.position, model.fixed(), &coordinates.value);
    assert!(residual.amax() < 1e-14, "the motion is the last good one");
}

/// However far the next instant, the motion stays in its assembly: without the tracker's bound on
/// corrections 42 of these 1,560 jumps ended in another.
#[test]
fn far_jumps_stay_in_the_assembly() {
    let model: five_link::Model<f64> = support::five_link_model();
    let mut motion = support::motions(
        &model,
        &support::five_link_rough(),
        support::five_link_inputs,
    )[0];
    let tracker = Tracker::default();
    let instants: Vec<f64> = (0..40).map(|index| f64::from(index) * 0.05).collect();
    let mut motions = vec![motion];
    for pair in instants.windows(2) {
        let steps = tracker.advance(
            &model,
            support::five_link_inputs,
            pair[0],
            pair[1],
            &mut motion,
        );
        steps.expect("a regular motion");
        motions.push(motion);
    }
    for (from, start) in instants.iter().zip(&motions) {
        for (to, expected) in instants.iter().zip(&motions) {
            let mut motion = *start;
            let steps = tracker.advance(&model, support::five_link_inputs, *from, *to, &mut motion);
            steps.expect("a regular motion");
            let difference = (motion.position - expected.position).amax();
            assert!(
                difference < 1e-13,
                "from {from} s to {to} s: {difference:e} m"
            );
        }
    }
}

/// A start so far away that its rounding error is larger than the mechanism proves nothing.
#[test]
fn a_start_at_astronomical_distance_returns_no_false_root() {
    let model: five_link::Model<f64> = support::five_link_model();
    for exponent in [6, 10, 12, 14, 20, 60, 100] {
        for unknown in 0..15 {
            let mut q = Reference::load().unknowns(4, "");
            q[unknown] = 10_f64.powi(exponent);
            let inputs = support::five_link_inputs(1.0);
            if let Ok(converged) = Newton::from_afar().solve(&model, &inputs, &mut q) {
                let coordinates = model.coordinates(&inputs.drives).value;
                let residual = model.residual(&q, model.fixed(), &coordinates).amax();
                assert!(residual <= converged.tolerance() && converged.tolerance() < 1e-13);
            }
        }
    }
}

/// Near a fold the position is known only to the square root of rounding, and no digit of the velocity: it is refused, not
/// guessed.
#[test]
fn no_velocity_is_returned_beside_a_fold() {
    suspension_core::linkage! {
        mod pendulum {
            fixed: a;
            free:  p;
            link rod: a -> p;
            drive theta: angle(a -> p, z);
            drive y: p.y;
        }
    }
    use pendulum::{Drives, Model, Points};
    let design = Points {
        a: Vector3::zeros(),
        p: Vector3::new(0.3, 0.0, 0.4),
    };
    let model = Model::new(&design).expect("a rod");
    for theta in [0.0, 1e-8, std::f64::consts::PI] {
        let drives = |theta| Drives { theta, y: 0.0 };
        let drives = Signal {
            value: drives(theta),
            rate: drives(1.0),
            second_rate: drives(0.0),
        };
        let inputs = Inputs::still(drives);
        let mut q = model.unknowns(&design);
        if Newton::from_afar().solve(&model, &inputs, &mut q).is_ok() {
            let tangent = suspension_core::Tangent::new(&model, &inputs, &q);
            assert!(
                matches!(tangent, Err(SolveError::Singular { .. })),
                "theta = {theta}"
            );
        }
    }
}

/// A failed solve leaves the state as it was and says why.
#[test]
fn a_failed_solve_leaves_the_state_untouched() {
    let model: attia2003::Model<f64> = support::attia_model();
    let start = Reference::load().unknowns(4, "");
    let attempt = |drive: f64| {
        let mut q = start;
        let drives = attia2003::Drives { theta: drive };
        let inputs: Inputs<Still, _> = Inputs::still(Signal {
            value: drives,
            ..Signal::default()
        });
        let error = Newton::near_by()
            .solve(&model, &inputs, &mut q)
            .expect_err("no root");
        assert_eq!(q, start);
        error
    };
    assert!(matches!(
        attempt(f64::NAN),
        SolveError::NotFinite {
            part: Part::Equation(14)
        }
    ));
    assert!(matches!(attempt(2.3), SolveError::Diverging { .. }));
    let far = SolveError::<f64>::Diverging {
        part: Part::Unknown(2),
        step: 1.0,
        bound: 0.5,
    };
    let culprit = far.part().map(|part| attia2003::Listing.name(part));
    assert_eq!(culprit, Some("p6.z"));
}

/// At theta = 0 the cosine has no slope: the drive does not determine the motion.
#[test]
fn a_drive_that_does_not_determine_the_motion_is_an_error() {
    let design = attia2003::Points::from_fn(|name| match name {
        "p6" => support::chassis_point("p1") + Vector3::new(0.0, 0.0, 0.4),
        "p11" => support::table2_point("p8", 4) + Vector3::new(0.0, 0.1, 0.0),
        "p1" | "p2" | "p3" | "p4" | "p5" => support::chassis_point(name),
        _ => support::table2_point(name, 4),
    });
    let model = attia2003::Model::new(&design).expect("a geometry");
    let drives = model.drives_at(&design);
    assert!(drives.theta.abs() < 1e-7);
    let inputs = Inputs::still(Signal {
        value: drives,
        ..Signal::default()
    });
    let mut motion = Motion::at_rest(model.unknowns(&design));
    let error = Tracker::default()
        .step(&model, &inputs, 0.0, &mut motion)
        .expect_err("singular");
    assert!(matches!(error, SolveError::Singular { .. }), "{error}");
}
