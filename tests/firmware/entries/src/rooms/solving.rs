//! The solving path. All settings are arguments, so that no branch is optimised away.

use suspension_core::chassis::RigidMotion;
use suspension_core::linkage::{HasKingpin, HasWheel};
use suspension_core::linkages::{attia2003, five_link};
use suspension_core::signal::ChassisMotion;
use suspension_core::wheel::{CarrierRotation, Kingpin, Wheel};
use suspension_core::{
    Inputs, Linkage, Motion, Newton, Real, Signal, Still, Tangent, Tracker, Values,
};

/// Value, rate and second rate of the drive.
#[repr(C)]
pub struct Drive<T>([T; 3]);

impl<T: Real> Drive<T> {
    fn signal<D: Values<T>>(&self) -> Signal<D> {
        let [value, rate, second_rate] = self.0.map(|number| D::from_values([number]));
        Signal {
            value,
            rate,
            second_rate,
        }
    }

    fn after<D: Values<T>>(&self, time: T) -> Signal<D> {
        let [value, rate, second_rate] = self.0;
        let rate_then = rate + second_rate * time;
        Drive([
            value + (rate + rate_then) * time / (T::one() + T::one()),
            rate_then,
            second_rate,
        ])
        .signal()
    }
}

/// The results that the control loop reads.
#[repr(C)]
pub struct Readout<T> {
    centre: [[T; 3]; 3],
    camber: T,
    toe: T,
    kingpin_angle: T,
    caster: T,
    omega: [T; 3],
    alpha: [T; 3],
}

fn solve<T, L>(
    newton: &Newton<T>,
    linkage: &L,
    drive: &Drive<T>,
    motion: &mut Motion<T, 15>,
) -> bool
where
    T: Real,
    L: Linkage<15, Scalar = T>,
{
    let inputs = Inputs::still(drive.signal());
    newton.solve(linkage, &inputs, &mut motion.position).is_ok()
}

fn rates<T, L>(linkage: &L, drive: &Drive<T>, motion: &mut Motion<T, 15>) -> bool
where
    T: Real,
    L: Linkage<15, Scalar = T>,
{
    match Tangent::new(linkage, &Inputs::still(drive.signal()), &motion.position) {
        Ok(tangent) => {
            motion.velocity = tangent.velocity();
            motion.acceleration = tangent.acceleration(&motion.velocity);
            true
        }
        Err(_) => false,
    }
}

fn step<T, L, C>(
    tracker: &Tracker<T>,
    linkage: &L,
    chassis: C,
    drive: &Drive<T>,
    dt: T,
    motion: &mut Motion<T, 15>,
) -> bool
where
    T: Real,
    L: Linkage<15, Scalar = T>,
    C: ChassisMotion<L::Fixed>,
{
    let inputs = Inputs {
        chassis,
        drives: drive.signal(),
    };
    tracker.step(linkage, &inputs, dt, motion).is_ok()
}

fn advance<T, L>(
    tracker: &Tracker<T>,
    linkage: &L,
    drive: &Drive<T>,
    dt: T,
    motion: &mut Motion<T, 15>,
) -> bool
where
    T: Real,
    L: Linkage<15, Scalar = T>,
{
    let inputs = |time| Inputs::still(drive.after(time));
    tracker
        .advance(linkage, inputs, T::zero(), dt, motion)
        .is_ok()
}

fn read<T, L, C>(
    linkage: &L,
    inputs: &Inputs<C, L::Drives>,
    motion: &Motion<T, 15>,
    readout: &mut Readout<T>,
) -> bool
where
    T: Real,
    L: Linkage<15, Scalar = T, Points: HasWheel<T> + HasKingpin<T>>,
    C: ChassisMotion<L::Fixed>,
{
    let points = motion.points(linkage, inputs);
    let (Some(wheel), Some(carrier)) = (
        Wheel::of(points.value.wheel()),
        CarrierRotation::of(&points.map(|points| points.carrier())),
    ) else {
        return false;
    };
    let kingpin = Kingpin::of(points.value.kingpin(), points.value.wheel());
    let centre = |points: &L::Points| -> [T; 3] {
        let [_, centre] = points.wheel();
        centre.into()
    };
    *readout = Readout {
        centre: [&points.value, &points.rate, &points.second_rate].map(centre),
        camber: wheel.camber,
        toe: wheel.toe,
        kingpin_angle: kingpin.angle,
        caster: kingpin.caster,
        omega: carrier.omega.into(),
        alpha: carrier.alpha.into(),
    };
    true
}

/// Exports each call for one linkage and one number type.
macro_rules! export {
    ($linkage:ident, $number:ty: $solve:ident, $rates:ident, $step:ident, $moving_step:ident,
     $advance:ident, $read:ident) => {
        #[unsafe(no_mangle)]
        extern "C" fn $solve(
            newton: &Newton<$number>,
            linkage: &$linkage::Model<$number>,
            drive: &Drive<$number>,
            motion: &mut Motion<$number, 15>,
        ) -> bool {
            solve(newton, linkage, drive, motion)
        }

        #[unsafe(no_mangle)]
        extern "C" fn $rates(
            linkage: &$linkage::Model<$number>,
            drive: &Drive<$number>,
            motion: &mut Motion<$number, 15>,
        ) -> bool {
            rates(linkage, drive, motion)
        }

        #[unsafe(no_mangle)]
        extern "C" fn $step(
            tracker: &Tracker<$number>,
            linkage: &$linkage::Model<$number>,
            drive: &Drive<$number>,
            dt: $number,
            motion: &mut Motion<$number, 15>,
        ) -> bool {
            step(tracker, linkage, Still, drive, dt, motion)
        }

        #[unsafe(no_mangle)]
        extern "C" fn $moving_step(
            tracker: &Tracker<$number>,
            linkage: &$linkage::Model<$number>,
            chassis: &RigidMotion<$number>,
            drive: &Drive<$number>,
            dt: $number,
            motion: &mut Motion<$number, 15>,
        ) -> bool {
            let anchors = chassis.anchors(linkage.fixed());
            step(tracker, linkage, anchors, drive, dt, motion)
        }

        #[unsafe(no_mangle)]
        extern "C" fn $advance(
            tracker: &Tracker<$number>,
            linkage: &$linkage::Model<$number>,
            drive: &Drive<$number>,
            dt: $number,
            motion: &mut Motion<$number, 15>,
        ) -> bool {
            advance(tracker, linkage, drive, dt, motion)
        }

        #[unsafe(no_mangle)]
        extern "C" fn $read(
            linkage: &$linkage::Model<$number>,
            chassis: &RigidMotion<$number>,
            drive: &Drive<$number>,
            motion: &Motion<$number, 15>,
            readout: &mut Readout<$number>,
        ) -> bool {
            let chassis = chassis.anchors(linkage.fixed());
            let drives = drive.signal();
            read(linkage, &Inputs { chassis, drives }, motion, readout)
        }
    };
}

export!(attia2003, f32: firmware_attia2003_f32_solve, firmware_attia2003_f32_rates,
    firmware_attia2003_f32_step, firmware_attia2003_f32_moving_step,
    firmware_attia2003_f32_advance, firmware_attia2003_f32_read);
export!(attia2003, f64: firmware_attia2003_f64_solve, firmware_attia2003_f64_rates,
    firmware_attia2003_f64_step, firmware_attia2003_f64_moving_step,
    firmware_attia2003_f64_advance, firmware_attia2003_f64_read);
export!(five_link, f32: firmware_five_link_f32_solve, firmware_five_link_f32_rates,
    firmware_five_link_f32_step, firmware_five_link_f32_moving_step,
    firmware_five_link_f32_advance, firmware_five_link_f32_read);
export!(five_link, f64: firmware_five_link_f64_solve, firmware_five_link_f64_rates,
    firmware_five_link_f64_step, firmware_five_link_f64_moving_step,
    firmware_five_link_f64_advance, firmware_five_link_f64_read);
