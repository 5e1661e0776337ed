//! The wheels' motion in a driven car against a cold solve, and the details against each other.

use nalgebra::Vector3;
use suspension_car::car::Car;
use suspension_car::detail::Detail;
use suspension_car::driver::Driver;
use suspension_car::kinematics::{Drives, Hub};
use suspension_car::linkages::{front, rear};
use suspension_car::road::Road;
use suspension_car::saloon::SALOON;

use suspension_car::tables;
use suspension_core::Signal;
use suspension_core::body::angular_velocity;

const BUMPS: Road = Road::Bumpy {
    size: 0.02,
    from: 0.0,
};

/// Wheel centre, a point inboard on the axis, and the strut's length.
struct Cold {
    centre: Vector3<f64>,
    inner: Vector3<f64>,
    strut: f64,
}

/// A left corner that goes to the drives from the design.
fn cold(axle: usize, drives: Drives) -> Cold {
    if axle == 0 {
        let mut corner: front::Corner = front::Corner::design().expect("the design");
        let front::Drives { bump, steer } = corner.drives();
        let to = front::Drives {
            bump: bump + drives.travel,
            steer: steer + drives.rack,
        };
        corner
            .step(1.0, Signal::still(to))
            .expect("a configuration");
        let points = corner.points().value;
        let strut = corner.measures().value.strut;
        Cold {
            centre: points.wheel_centre,
            inner: points.axle,
            strut,
        }
    } else {
        let mut corner: rear::Corner = rear::Corner::design().expect("the design");
        let to = rear::Drives {
            bump: corner.drives().bump + drives.travel,
        };
        corner
            .step(1.0, Signal::still(to))
            .expect("a configuration");
        let points = corner.points().value;
        let strut = corner.measures().value.strut;
        Cold {
            centre: points.wheel_centre,
            inner: points.axle,
            strut,
        }
    }
}

fn left_hub(car: &Car, place: usize) -> Hub {
    let hub = car.corners[place].hub;
    if place % 2 == 1 { hub.mirrored() } else { hub }
}

#[test]
fn wheel_motion_of_each_tick_agrees_with_a_cold_solve() {
    const DT: f64 = 1e-3;
    let driver = Driver {
        speed: 20.0,
        rack: 0.006,
        from: 0.2,
        ramp: 0.3,
        hold: 0.5,
    };
    let mut car = Car::new(&SALOON, Detail::Exact)
        .expect("the design")
        .rolling(20.0);
    let origins: [Vector3<f64>; 4] = std::array::from_fn(|place| {
        left_hub(&car, place).centre.value - cold(place / 2, Drives::default()).centre
    });
    for tick in 0..2_000 {
        let controls = driver.controls(f64::from(tick) * DT, &car);
        let travels = car.corners.each_ref().map(|corner| corner.travel);
        car.tick(DT, &BUMPS, &controls).expect("a motion");
        if tick % 50 != 0 {
            continue;
        }
        for (place, travel) in travels.into_iter().enumerate() {
            let to_left = if place % 2 == 1 { -1.0 } else { 1.0 };
            let at = |more| {
                cold(
                    place / 2,
                    Drives {
                        travel: travel + more,
                        rack: controls.rack.value * to_left,
                    },
                )
            };
            let (hub, expected) = (left_hub(&car, place), at(0.0));
            let off = (hub.centre.value - origins[place] - expected.centre).norm();
            assert!(off < 1e-13, "corner {place}, tick {tick}: {off} m");
            let axis = (expected.centre - expected.inner).normalize();
            assert!((hub.axis * hub.axis.y.signum() - axis).norm() < 1e-12);
            let [above, below] = [1e-5, -1e-5].map(at);
            let slope = (above.centre - below.centre) / 2e-5;
            assert!((hub.per_travel.centre - slope).norm() < 1e-8);
            let slope = (above.strut - below.strut) / 2e-5;
            assert!((hub.per_travel.strut - slope).abs() < 1e-8);
        }
    }
}

#[test]
fn the_carrier_has_the_angular_velocity_of_the_library() {
    let corner: front::Corner = front::Corner::design().expect("the design");
    let per = corner
        .per(front::Drives {
            bump: 1.0,
            steer: 0.0,
        })
        .expect("regular")
        .points;
    let three = |of: &front::Points<f64>| [of.lower_ball, of.upper_ball, of.tie_ball];
    let turn = angular_velocity(&three(&per.value), &three(&per.rate)).expect("not in line");
    let hub = Detail::Exact
        .corner(0)
        .expect("a linkage")
        .step(1e-3, &Signal::default())
        .expect("the design");
    assert!(
        (hub.per_travel.turn - turn).norm() < 1e-12,
        "{} {turn}",
        hub.per_travel.turn
    );
}

/// The largest errors of a detail over a motion: wheel centre in m, its rate in m/s, motion ratio.
fn off(detail: Detail, axle: usize, size: f64) -> [f64; 3] {
    let [mut fine, mut coarse] =
        [Detail::Exact, detail].map(|detail| detail.corner(axle).expect("a linkage"));
    let mut worst = [0.0_f64; 3];
    for tick in 0..2_000 {
        let (sine, cosine) = (1e-3 * f64::from(tick) * 9.0).sin_cos();
        let of = |part: f64| Drives {
            travel: 0.08 * size * part,
            rack: 0.015 * size * part,
        };
        let drives = Signal {
            value: of(sine),
            rate: of(9.0 * cosine),
            second_rate: Drives {
                travel: 0.0,
                rack: -81.0 * 0.015 * size * sine,
            },
        };
        let [exact, found] =
            [&mut fine, &mut coarse].map(|corner| corner.step(1e-3, &drives).expect("a motion"));
        let now = [
            (exact.centre.value - found.centre.value).norm(),
            (exact.centre.rate - found.centre.rate).norm(),
            (exact.per_travel.strut - found.per_travel.strut).abs(),
        ];
        worst = std::array::from_fn(|at| worst[at].max(now[at]));
    }
    worst
}

#[test]
fn wheel_motion_of_each_detail_is_within_its_stated_error() {
    for axle in 0..2 {
        for (detail, bounds) in [
            (Detail::Bounded, [5e-7, 1e-5, 2e-5]),
            (Detail::Baked, [1e-5, 4e-4, 4e-4]),
        ] {
            let found = off(detail, axle, 1.0);
            assert!(
                found
                    .iter()
                    .zip(bounds)
                    .all(|(found, bound)| *found < bound),
                "{}: {found:?}",
                detail.name()
            );
        }
        // Half a step from a grid point, in m, the error is an eighth of its square over the smallest radius of a path.
        let linear = off(Detail::Table, axle, 1.0)[0];
        assert!((1e-5..2e-4).contains(&linear), "{linear}");
        let [coarse, fine] = [1.0, 0.5].map(|size| off(Detail::Constant, axle, size));
        let ratio = coarse[0] / fine[0];
        assert!(
            (3.0..5.0).contains(&ratio),
            "of second order: {coarse:?} {fine:?}"
        );
    }
}

#[test]
fn tables_have_the_points_that_their_indices_name() {
    let names =
        |outputs: &[&'static str], places: [usize; 4]| places.map(|place| outputs[3 * place]);
    let in_front = names(
        &tables::front::FRONT_POINTS_BY_BUMP_AND_STEER_OUTPUTS,
        tables::IN_FRONT,
    );
    assert_eq!(
        in_front,
        ["wheel_centre_x", "axle_x", "lower_ball_x", "strut_lower_x"]
    );
    let behind = names(&tables::rear::REAR_POINTS_BY_BUMP_OUTPUTS, tables::BEHIND);
    assert_eq!(
        behind,
        [
            "wheel_centre_x",
            "axle_x",
            "lateral_ball_x",
            "lateral_ball_x"
        ]
    );
}

#[test]
fn changing_the_level_of_detail_does_not_disturb_the_motion() {
    const DT: f64 = 1e-3;
    let driver = Driver {
        speed: 20.0,
        rack: 0.006,
        from: 0.2,
        ramp: 0.3,
        hold: 0.5,
    };
    let fine = [Detail::Exact, Detail::Bounded, Detail::Baked];
    let mut spare = fine.map(|detail| detail.corners().expect("a linkage"));
    let [mut steady, mut changing] = [(); 2].map(|()| {
        Car::new(&SALOON, Detail::Exact)
            .expect("the design")
            .rolling(20.0)
    });
    for tick in 0..4_000 {
        let time = f64::from(tick) * DT;
        if tick % 130 == 129 {
            let controls = driver.controls(time, &changing);
            changing
                .change(&mut spare[tick as usize / 130 % 3], &controls)
                .expect("a way there");
        }
        for car in [&mut steady, &mut changing] {
            let controls = driver.controls(time, car);
            car.tick(DT, &BUMPS, &controls).expect("a motion");
        }
    }
    let off = (steady.chassis.position - changing.chassis.position).norm();
    assert!(off > 0.0 && off < 1e-3, "{off} m");
}
