//! Small vibrations of the car against the linear model.

mod support;

use nalgebra::{SMatrix, SVector, UnitQuaternion, Vector3};
use suspension_car::car::{Car, Controls};
use suspension_car::detail::Detail;
use suspension_car::linkages::{front, rear};
use suspension_car::road::Road;
use suspension_car::saloon::{GRAVITY, Parameters, SALOON};
use suspension_core::Signal;

/// x, y, z, roll, pitch, yaw and the four travels.
const COORDINATES: usize = 10;
type Coordinates = SVector<f64, COORDINATES>;
type Square = SMatrix<f64, COORDINATES, COORDINATES>;

/// The saloon without dampers, on ice.
fn free() -> Parameters {
    let mut car = SALOON;
    car.tyre.damping = 0.0;
    car.tyre.slip_stiffness = 1e-12;
    for axle in &mut car.axles {
        axle.damping = 0.0;
    }
    car
}

/// A corner computed with the library's `Corner`: positions, rates and second rates per bump.
struct Corner {
    centre: Signal<Vector3<f64>>,
    axis: Signal<Vector3<f64>>,
    strut: Signal<f64>,
}

fn left(axle: usize) -> Corner {
    let of = |centre: [Vector3<f64>; 3], inner: [Vector3<f64>; 3], strut| {
        let [value, rate, second_rate] = centre;
        // Both points are 0.1 m apart.
        let [along, turning, second] = [0, 1, 2].map(|order| (centre[order] - inner[order]) / 0.1);
        Corner {
            centre: Signal {
                value,
                rate,
                second_rate,
            },
            axis: Signal {
                value: along,
                rate: turning,
                second_rate: second,
            },
            strut,
        }
    };
    if axle == 0 {
        let corner: front::Corner = front::Corner::design().expect("the design");
        let per = corner
            .per(front::Drives {
                bump: 1.0,
                steer: 0.0,
            })
            .expect("regular");
        let Signal {
            value,
            rate,
            second_rate,
        } = per.points;
        let orders = [value, rate, second_rate];
        of(
            orders.map(|of| of.wheel_centre),
            orders.map(|of| of.axle),
            per.measures.map(|of| of.strut),
        )
    } else {
        let corner: rear::Corner = rear::Corner::design().expect("the design");
        let per = corner.per(rear::Drives { bump: 1.0 }).expect("regular");
        let Signal {
            value,
            rate,
            second_rate,
        } = per.points;
        let orders = [value, rate, second_rate];
        of(
            orders.map(|of| of.wheel_centre),
            orders.map(|of| of.axle),
            per.measures.map(|of| of.strut),
        )
    }
}

/// The value a way along.
fn moved(of: &Signal<Vector3<f64>>, way: f64) -> Vector3<f64> {
    of.value + of.rate * way + of.second_rate * (0.5 * way * way)
}

fn image(v: Vector3<f64>, place: usize) -> Vector3<f64> {
    if place % 2 == 1 {
        Vector3::new(v.x, -v.y, v.z)
    } else {
        v
    }
}

/// The vector from the chassis' centre of mass to the origin of a corner's coordinates, m: ahead, and at the height where
/// the tyre bears its load.
fn origin(car: &Parameters, corner: &Corner, axle: usize) -> Vector3<f64> {
    let deflection = car.static_loads()[axle] / car.tyre.stiffness;
    let upright = (1.0 - corner.axis.value.z.powi(2)).sqrt();
    let above_ground = (car.tyre.radius - deflection * upright) * upright;
    Vector3::new(
        car.axles[axle].ahead,
        0.0,
        above_ground - corner.centre.value.z - car.height,
    )
}

/// The potential energy of springs, bars, tyres and heights, J.
fn energy(car: &Parameters, corners: &[Corner; 2], q: &Coordinates) -> f64 {
    let position = Vector3::new(q[0], q[1], car.height + q[2]);
    let attitude = UnitQuaternion::from_scaled_axis(Vector3::new(q[3], q[4], q[5]));
    let mut energy = car.sprung_mass * GRAVITY * position.z;
    for place in 0..4 {
        let (axle, corner) = (&car.axles[place / 2], &corners[place / 2]);
        let (travel, other) = (q[6 + place], q[6 + (place ^ 1)]);
        let centre = moved(&corner.centre, travel) + origin(car, corner, place / 2);
        let height = (position + attitude * image(centre, place)).z;
        let lean = (attitude * image(moved(&corner.axis, travel), place))
            .normalize()
            .z;
        let deflection = car.tyre.radius - height / (1.0 - lean * lean).sqrt();
        // The force of the spring itself holds the wheel at the start of the test.
        let strut = &corner.strut;
        let spring = strut.rate * travel + 0.5 * strut.second_rate * travel * travel;
        let preload = preload(car, corners, place / 2);
        energy += axle.unsprung_mass * GRAVITY * height
            + 0.5 * car.tyre.stiffness * deflection * deflection
            + 0.5 * axle.stiffness * spring * spring
            - preload * spring
            + 0.25 * axle.bar * (travel - other).powi(2);
    }
    energy
}

/// The force of a spring at rest: the sprung weight over the motion ratio, without the lean of the wheel.
fn preload(car: &Parameters, corners: &[Corner; 2], axle: usize) -> f64 {
    let corner = &corners[axle];
    let load = car.static_loads()[axle];
    let [height, lean] = [
        car.tyre.radius - load / car.tyre.stiffness,
        corner.axis.value.z,
    ];
    let by_lean = load * height * lean * corner.axis.rate.z;
    -(load - car.axles[axle].unsprung_mass * GRAVITY - by_lean) / corner.strut.rate
}

/// Second differences of the energy about rest.
fn stiffness(car: &Parameters, corners: &[Corner; 2]) -> Square {
    const STEP: f64 = 1e-3;
    let at = |a: usize, by: f64, b: usize, and: f64| {
        let mut q = Coordinates::zeros();
        q[a] += by * STEP;
        q[b] += and * STEP;
        energy(car, corners, &q)
    };
    Square::from_fn(|a, b| {
        (at(a, 1.0, b, 1.0) - at(a, 1.0, b, -1.0) - at(a, -1.0, b, 1.0) + at(a, -1.0, b, -1.0))
            / (4.0 * STEP * STEP)
    })
}

/// Point masses in the wheel centres on a rigid chassis.
fn mass(car: &Parameters, corners: &[Corner; 2]) -> Square {
    let [x, y, z] = car.inertia;
    let own = [
        car.sprung_mass,
        car.sprung_mass,
        car.sprung_mass,
        x,
        y,
        z,
        0.0,
        0.0,
        0.0,
        0.0,
    ];
    let mut mass = Square::from_diagonal(&Coordinates::from(own));
    for place in 0..4 {
        let corner = &corners[place / 2];
        let arm = image(corner.centre.value + origin(car, corner, place / 2), place);
        let mut partial = SMatrix::<f64, 3, COORDINATES>::zeros();
        partial.fixed_view_mut::<3, 3>(0, 0).fill_with_identity();
        partial
            .fixed_view_mut::<3, 3>(0, 3)
            .copy_from(&-arm.cross_matrix());
        partial.set_column(6 + place, &image(corner.centre.rate, place));
        mass += partial.transpose() * partial * car.axles[place / 2].unsprung_mass;
    }
    mass
}

#[test]
fn the_car_vibrates_at_the_frequencies_of_the_linear_model() {
    const DT: f64 = 2.5e-4;
    const SIZE: f64 = 1e-4;
    let car = free();
    let corners = [left(0), left(1)];
    let modes = support::modes(mass(&car, &corners), stiffness(&car, &corners));
    // The first three are ahead, aside and yaw, which nothing holds.
    assert!(modes[2].0 < 1e-2, "{} Hz", modes[2].0);
    for (frequency, shape) in &modes[3..] {
        let mut moving = Car::new(&car, Detail::Exact).expect("the design");
        let start = shape * SIZE;
        moving.chassis.position += start.fixed_rows::<3>(0);
        moving.chassis.attitude =
            UnitQuaternion::from_scaled_axis(start.fixed_rows::<3>(3).into_owned());
        for (corner, travel) in moving.corners.iter_mut().zip(start.iter().skip(6)) {
            corner.travel = *travel;
        }
        let seen = start.fixed_rows::<4>(6).icamax();
        let mut samples = Vec::new();
        for _ in 0..12_000 {
            moving
                .tick(DT, &Road::Flat, &Controls::default())
                .expect("a motion");
            samples.push(moving.corners[seen].travel);
        }
        let found = support::frequency(&samples, DT);
        assert!(
            (found / frequency - 1.0).abs() < 1e-4,
            "{found} Hz, not {frequency} Hz"
        );
    }
}
