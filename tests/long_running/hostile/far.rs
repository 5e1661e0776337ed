//! A mechanism a thousand kilometres from the origin moves as it does beside the origin.

use nalgebra::{SVector, Vector3};
use suspension_core::linkage::Values;
use suspension_core::linkages::five_link;
use suspension_core::model::local::LocalOrigin;
use suspension_core::{Build, Inputs, Motion, Newton, Real, Signal, Tracker, assemble};

use super::mechanisms::{four_bar, rocker};
use crate::support::five_link_rough;

/// Exactly representable, so that what is put in is the same mechanism.
const AWAY: [f64; 3] = [1_048_576.0, -2_097_152.0, 524_288.0];

/// Rounded so that adding [`AWAY`] changes no bit of what is left.
fn coarse<P: Values<Vector3<f64>>>(points: &P) -> P {
    points.map(|point| point.map(|x| (x * 1_048_576.0).round() / 1_048_576.0))
}

fn moved<P: Values<Vector3<f64>>>(points: &P) -> P {
    points.map(|point| point + Vector3::from(AWAY))
}

/// The motion half a second after the design, in given coordinates.
fn drive<T: Real, L: Build<N, Scalar = T, Listing: Default>, const N: usize>(
    design: &L::Points,
) -> Motion<T, N> {
    let model = L::new(design).expect("a linkage");
    let at_design = model.drives_at(design);
    let inputs = |t: T| {
        Inputs::still(Signal {
            value: at_design.map(|value| value + T::constant(0.03) * t),
            rate: at_design.map(|_| T::constant(0.03)),
            second_rate: at_design.map(|_| T::zero()),
        })
    };
    let mut q = model.unknowns(design);
    assemble(&Newton::from_afar(), &model, &inputs(T::zero()), &mut q).expect("assembles");
    let mut motion = Motion::at_rest(q);
    Tracker::default()
        .advance(&model, inputs, T::zero(), T::constant(0.5), &mut motion)
        .expect("moves");
    motion
}

fn check<L: Build<N, Scalar = f64, Listing: Default>, const N: usize>(design: &L::Points) {
    let home = coarse(design);
    let away = moved(&home);
    let local = LocalOrigin::among(away.values());
    let at_home = drive::<f64, L, N>(&home);
    let at_local = drive::<f64, L, N>(&local.to_local(&away));
    let shift = Vector3::from(AWAY) - local.position();
    let position = at_local.position - SVector::from_fn(|row, _| shift[row % 3]);
    assert!((position - at_home.position).amax() < 1e-14);
    assert!((at_local.velocity - at_home.velocity).amax() < 1e-13);
    assert!((at_local.acceleration - at_home.acceleration).amax() < 1e-12);
    // What it would be without: a hundred million times less exact.
    let in_place = drive::<f64, L, N>(&away);
    assert!((in_place.velocity - at_home.velocity).amax() > 1e-12);
}

#[test]
fn a_mechanism_1000_km_away_has_the_same_motion() {
    check::<five_link::Model<f64>, 15>(&five_link_rough());
    check::<four_bar::Model<f64>, 6>(&four_bar_design());
    check::<rocker::Model<f64>, 6>(&rocker_design());
}

/// In `f32` hardpoints at that distance have no significant digits, so that they are made local before.
#[test]
fn local_points_give_f32_its_accuracy_far_from_the_origin() {
    let home = coarse(&rocker_design());
    let away = moved(&home);
    let local = LocalOrigin::among(away.values()).to_local(&away);
    let single = |points: &rocker::Points<f64>| {
        let values = points.values();
        rocker::Points::<f32>::from_values(values.map(|each| each.map(|x| x as f32)))
    };
    let exact = drive::<f64, rocker::Model<f64>, 6>(&local);
    let found = drive::<f32, rocker::Model<f32>, 6>(&single(&local));
    assert!((found.position.map(f64::from) - exact.position).amax() < 1e-6);
    // Six centimetres from one number to the next.
    assert_eq!((AWAY[0] + 0.03) as f32, AWAY[0] as f32);
}

#[test]
fn a_local_origin_shifts_drives_and_measures() {
    let away = moved(&coarse(&rocker_design()));
    let local = LocalOrigin::among(away.values());
    let model = rocker::Model::new(&local.to_local(&away)).expect("a linkage");
    let offset = local.of_drives(&model);
    assert_eq!(offset.slide, local.position().z);
    let read = model.drives_at(&local.to_local(&away)).slide + offset.slide;
    assert_eq!(read, model.drives_at(&away).slide);
    let measures = local.of_measures(&model);
    assert_eq!(measures.height, local.position().z);
    assert_eq!(
        (measures.lift, measures.lean, measures.reach),
        (0.0, 0.0, 0.0)
    );
    let model = four_bar::Model::new(&four_bar_design()).expect("a linkage");
    let offset = local.of_drives(&model);
    assert_eq!((offset.turn, offset.align), (0.0, 0.0));
    assert_eq!(offset.slide, local.position().x);
}

#[test]
fn a_local_origin_lies_among_the_points_and_has_few_digits() {
    let rough = five_link_rough::<f64>();
    let extent = |points: &five_link::Points<f64>| {
        let largest = points.values().map(|point| point.amax());
        largest.fold(0.0, f64::max)
    };
    for scale in [1e-3, 1.0, 25.4, 1e3] {
        for away in [0.0, 4.0, -524_288.0] {
            let points = rough.map(|point| (point + Vector3::repeat(away)) * scale);
            let origin = LocalOrigin::among(points.values());
            let local = origin.to_local(&points);
            assert!(extent(&local) < 0.45 * scale, "{away} {scale}: {local:?}");
            let [single, double] = [
                origin.in_numbers::<f32>().position().map(f64::from),
                origin.position(),
            ];
            assert_eq!(single, double);
            let [there_and_back, points] =
                [origin.from_local(&local), points].map(|points| Vec::from_iter(points.values()));
            for (back, point) in there_and_back.into_iter().zip(points) {
                assert!((back - point).amax() <= f64::EPSILON * (extent(&local) + point.amax()));
            }
        }
    }
    let home = rough.map(|point| point - LocalOrigin::among(rough.values()).position());
    assert_eq!(
        LocalOrigin::among(home.values()).position(),
        Vector3::zeros()
    );
}

#[test]
fn for_points_without_a_finite_middle_the_local_origin_is_zero() {
    let mut bad = five_link_rough::<f64>();
    let all_in_one = bad.map(|_| Vector3::repeat(3.0));
    for number in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        bad.track_rod_outer.z = number;
        assert_eq!(
            LocalOrigin::among(bad.values()).position(),
            Vector3::zeros()
        );
    }
    assert_eq!(
        LocalOrigin::among(all_in_one.values()).position(),
        Vector3::zeros()
    );
    let huge = all_in_one.map(|point| point * f64::MAX);
    assert_eq!(
        LocalOrigin::among(huge.values()).position(),
        Vector3::zeros()
    );
}

fn four_bar_design() -> four_bar::Points<f64> {
    four_bar::Points {
        crank_pin: Vector3::zeros(),
        rocker_pin: Vector3::new(0.0, 0.6, 0.1),
        crank_end: Vector3::new(0.0, 0.17, 0.11),
        rocker_end: Vector3::new(0.0, 0.55, 0.48),
    }
}

fn rocker_design() -> rocker::Points<f64> {
    rocker::Points {
        front: Vector3::new(0.10, 0.02, 0.50),
        rear: Vector3::new(-0.08, 0.05, 0.53),
        anchor: Vector3::new(0.3, 0.12, 0.65),
        push: Vector3::new(0.03, 0.15, 0.55),
        pull: Vector3::new(-0.01, 0.08, 0.63),
        mark: Vector3::new(0.02, 0.12, 0.60),
    }
}
