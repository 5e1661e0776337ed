//! Functions of a moving suspension.
#![allow(unsafe_code, reason = "names for the linker")]

use suspension_core::nalgebra::Vector3;

use super::loads::Wanted;
use super::objects::{Corner, Listing};
use super::parsed::Parsed;
use super::placed::Placed;
use super::text::{Number, check_count};
use crate::convert::{fill, kingpin_of, rotation_of, wheel_of, wheel_rates_of};
use crate::failure::{Trouble, answer, respond};
use crate::of::f64::{CarrierRotation, Failure, Kingpin, Masses, Report, Wheel, WheelRates};
use crate::pointer::{Create, Destroy, In, InOut, Object, Out};
use crate::status::Status;

/// Runs the work of a call on an object. The listing names the part concerned by a failure.
fn on<'a, O>(
    object: Result<(O, &'a Parsed), Status>,
    failure: Out<'_, Failure>,
    work: impl FnOnce(O, &'a Parsed) -> Result<(), Trouble>,
) -> Status {
    match object {
        Ok((object, parsed)) => respond(failure, parsed, || work(object, parsed)),
        Err(status) => respond(failure, &(), || Err(status.into())),
    }
}

/// The number of the wheel if a call does not state one.
const FIRST: usize = 0;

fn read_wheel(corner: In<'_, Corner>, index: usize, wheel: Out<'_, Wheel>) -> Status {
    answer(|| {
        let (corner, wheel) = (corner.object()?, wheel.get()?);
        let axis = corner.moving().wheel_axis(index).ok_or(Status::Absent)?;
        wheel.write(wheel_of(axis.value)?);
        Ok(())
    })
}

fn read_rotation(
    corner: In<'_, Corner>,
    index: usize,
    rotation: Out<'_, CarrierRotation>,
) -> Status {
    answer(|| {
        let (corner, rotation) = (corner.object()?, rotation.get()?);
        let carrier = corner.moving().wheel_carrier(index).ok_or(Status::Absent)?;
        rotation.write(rotation_of(&carrier)?);
        Ok(())
    })
}

fn read_kingpin(corner: In<'_, Corner>, index: usize, kingpin: Out<'_, Kingpin>) -> Status {
    answer(|| {
        let (corner, kingpin) = (corner.object()?, kingpin.get()?);
        let moving = corner.moving();
        let ends = moving.kingpin(index).zip(moving.wheel_axis(index));
        let (ends, axis) = ends.ok_or(Status::Absent)?;
        kingpin.write(kingpin_of(ends, axis.value)?);
        Ok(())
    })
}

crate::functions! { "susp":
    /// Makes a suspension at rest at the points `points[POINTS][3]`: those that `susp_listing_design`
    /// returns, or others. If the listing states no positions, they determine the order of elimination.
    fn corner_new(listing: In<Listing>, points: In<Number>, count: usize, corner: Create<Corner>, failure: Out<Failure>) -> Status {
        on(listing.object().map(|parsed| ((), parsed)), failure, |(), parsed| {
            let (points, corner) = (points.many(count)?, corner.get()?);
            check_count(count, 3 * parsed.counts().points)?;
            let (points, _) = points.as_chunks();
            let points: std::vec::Vec<_> = points.iter().copied().map(Vector3::from).collect();
            corner.write(Object::on_heap(Placed::new(parsed, &points)?));
            Ok(())
        })
    }

    /// Frees a suspension; NULL has no effect.
    fn corner_destroy(corner: Destroy<Corner>) -> Status {
        answer(|| corner.end())
    }

    /// The time, s, which is 0 when the suspension is made.
    fn corner_time(corner: In<Corner>, time: Out<Number>) -> Status {
        answer(|| {
            let (corner, time) = (corner.object()?, time.get()?);
            time.write(corner.moving().time());
            Ok(())
        })
    }

    /// The values of the drives, `drives[DRIVES]`.
    fn corner_drives(corner: In<Corner>, drives: Out<Number>, count: usize) -> Status {
        answer(|| {
            let (corner, drives) = (corner.object()?, drives.many(count)?);
            check_count(count, corner.parsed().counts().drives)?;
            corner.moving().read_drives(drives);
            Ok(())
        })
    }

    /// A step of `dt` seconds to `drives[3][DRIVES]`, the values and rates of the drives at its end,
    /// however far: in as many sub-steps as necessary, at most 200. With `dt` = 0 the step takes no time,
    /// and the drives must be near the last ones. In between the drives follow the cubics with their values
    /// and rates at both ends or, if these lead past a lock, straight lines from rest, in at most 200
    /// further sub-steps. A refusal at a lock takes 500 to 2,000 times as long as a step of a millisecond.
    /// `report` may be NULL.
    fn corner_step(corner: InOut<Corner>, drives: In<Number>, count: usize, dt: Number, report: Out<Report>, failure: Out<Failure>) -> Status {
        on(corner.object().map(Placed::parts_mut), failure, |moving, parsed| {
            let (drives, report) = (drives.many(count)?, report.optional()?);
            check_count(count, 3 * parsed.counts().drives)?;
            fill(report, moving.step(dt, drives).map_err(Trouble::Solver)?);
            Ok(())
        })
    }

    /// `susp_corner_step` that keeps its progress if it stops early, for example at a lock: time, drives
    /// and points become those of `failure->reached` seconds after its start. The status is then the reason
    /// why the next sub-step was refused, however short: at a lock SUSP_ERROR_SINGULAR,
    /// SUSP_ERROR_DIVERGING or another, and shorter steps do not help. From a lock there may be no step
    /// forwards or backwards, because rates are unbounded there.
    fn corner_advance(corner: InOut<Corner>, drives: In<Number>, count: usize, dt: Number, report: Out<Report>, failure: Out<Failure>) -> Status {
        on(corner.object().map(Placed::parts_mut), failure, |moving, parsed| {
            let (drives, report) = (drives.many(count)?, report.optional()?);
            check_count(count, 3 * parsed.counts().drives)?;
            fill(report, moving.step_towards(dt, drives).map_err(Trouble::Solver)?);
            Ok(())
        })
    }

    /// Positions, velocities and accelerations of all points, `points[3][POINTS][3]`.
    fn corner_read_points(corner: In<Corner>, points: Out<Number>, count: usize) -> Status {
        answer(|| {
            let (corner, points) = (corner.object()?, points.many(count)?);
            check_count(count, 9 * corner.parsed().counts().points)?;
            corner.moving().read_points(points);
            Ok(())
        })
    }

    /// The measures of the listing, `measures[3][MEASURES]`. A rate is NaN where a measured length is zero,
    /// or a measured angle without `about` is 0 or pi.
    fn corner_read_measures(corner: In<Corner>, measures: Out<Number>, count: usize) -> Status {
        answer(|| {
            let (corner, measures) = (corner.object()?, measures.many(count)?);
            check_count(count, 3 * corner.parsed().counts().measures)?;
            corner.moving().read_measures(measures);
            Ok(())
        })
    }

    /// Motion ratios: points and measures with their first and second derivatives for the change
    /// `change[DRIVES]` of the drives, for example 1 for one of them and 0 for the rest; the suspension may
    /// be at rest. Derivatives are per unit of that change in place of per second. `points[3][POINTS][3]`
    /// and `measures[3][MEASURES]` may each be NULL. SUSP_ERROR_SINGULAR where the drives lock.
    fn corner_read_derivatives(corner: In<Corner>, change: In<Number>, drive_count: usize, points: Out<Number>, point_count: usize, measures: Out<Number>, measure_count: usize, failure: Out<Failure>) -> Status {
        on(corner.object().map(Placed::parts), failure, |moving, parsed| {
            let counts = parsed.counts();
            let change = change.many(drive_count)?;
            let points = points.optional_many(point_count)?;
            let measures = measures.optional_many(measure_count)?;
            check_count(drive_count, counts.drives)?;
            if points.is_some() {
                check_count(point_count, 9 * counts.points)?;
            }
            if measures.is_some() {
                check_count(measure_count, 3 * counts.measures)?;
            }
            let (points, measures) = (points.unwrap_or_default(), measures.unwrap_or_default());
            let derived = moving.read_per(change, points, measures);
            derived.map_err(Trouble::Solver)
        })
    }

    /// Adds weight and inertia of masses in the present motion of the suspension to `forces[POINTS][3]`,
    /// for `susp_corner_read_loads`. `design[POINTS][3]` are the points at which the masses are stated. A
    /// mass may refer to any points; SUSP_ERROR_ABSENT for a number without a point,
    /// SUSP_ERROR_NO_DIRECTION if the three points of a body are in line, SUSP_ERROR_OVERFLOW if a
    /// force is not finite.
    fn corner_add_masses(corner: In<Corner>, masses: In<Masses>, design: In<Number>, design_count: usize, forces: InOut<Number>, force_count: usize) -> Status {
        answer(|| {
            let (corner, masses) = (corner.object()?, masses.get()?);
            let (design, forces) = (design.many(design_count)?, forces.many(force_count)?);
            let count = 3 * corner.parsed().counts().points;
            check_count(design_count, count)?;
            check_count(force_count, count)?;
            corner.moving().add_masses(masses, design, forces)
        })
    }

    /// The effects of forces at the points, `forces[POINTS][3]`, N in the axes of the points, on the
    /// suspension at rest at its present position. A force at a marker acts on its body, a force at a
    /// chassis point on the drive that moves it. `drives[DRIVES]` receives the work of the forces per unit
    /// of each drive, which is the load on its actuator: N for a length, N times the unit of the points for
    /// an angle. `tensions[PARTS]` receives the force in each link, positive in tension, and 0 for other
    /// parts. `reactions[PARTS][POINTS][3]` receives the forces that each part exerts on the points. A
    /// force at a marker acts at three points of its body and is not in the reactions of the body there:
    /// the force in a joint of a loaded body is what the other parts exert on the point. The
    /// moment that drives or holds an angle acts on the parts that carry the lines of the angle, so that an
    /// angle between lines of parts exerts no force itself. A `couple` exerts forces on its points alone,
    /// whose sum is not zero: no chassis point bears the difference. Each of these three may be NULL.
    /// SUSP_ERROR_SINGULAR where the drives lock.
    fn corner_read_loads(corner: In<Corner>, forces: In<Number>, force_count: usize, drives: Out<Number>, drive_count: usize, tensions: Out<Number>, tension_count: usize, reactions: Out<Number>, reaction_count: usize, failure: Out<Failure>) -> Status {
        on(corner.object().map(Placed::parts), failure, |moving, parsed| {
            let counts = parsed.counts();
            let forces = forces.many(force_count)?;
            check_count(force_count, 3 * counts.points)?;
            let rows = [
                (drives.optional_many(drive_count)?, drive_count, counts.drives),
                (tensions.optional_many(tension_count)?, tension_count, counts.parts),
                (reactions.optional_many(reaction_count)?, reaction_count, 3 * counts.parts * counts.points),
            ];
            for (row, count, wanted) in &rows {
                if row.is_some() {
                    check_count(*count, *wanted)?;
                }
            }
            let [drives, tensions, reactions] = rows.map(|(row, ..)| row.unwrap_or_default());
            let wanted = Wanted { drives, tensions, reactions };
            let loaded = moving.read_loads(&parsed.structure, forces, wanted);
            loaded.map_err(Trouble::Solver)
        })
    }

    /// The wheel, or the first of several; SUSP_ERROR_ABSENT if the listing states none.
    fn corner_read_wheel(corner: In<Corner>, wheel: Out<Wheel>) -> Status {
        read_wheel(corner, FIRST, wheel)
    }

    /// The rotation of the body that carries that wheel; SUSP_ERROR_ABSENT if the listing states no wheel.
    fn corner_read_rotation(corner: In<Corner>, rotation: Out<CarrierRotation>) -> Status {
        read_rotation(corner, FIRST, rotation)
    }

    /// The kingpin of that wheel; SUSP_ERROR_ABSENT if the listing states none, or no wheel.
    fn corner_read_kingpin(corner: In<Corner>, kingpin: Out<Kingpin>) -> Status {
        read_kingpin(corner, FIRST, kingpin)
    }

    /// One of several wheels, by its number as SUSP_WHEEL; SUSP_ERROR_ABSENT if there is no such wheel.
    fn corner_read_wheel_at(corner: In<Corner>, index: usize, wheel: Out<Wheel>) -> Status {
        read_wheel(corner, index, wheel)
    }

    /// A wheel with its time derivatives, by its number, 0 for the first or only one; SUSP_ERROR_ABSENT if there is
    /// no such wheel.
    fn corner_read_wheel_rates(corner: In<Corner>, index: usize, wheel: Out<WheelRates>) -> Status {
        answer(|| {
            let (corner, wheel) = (corner.object()?, wheel.get()?);
            let axis = corner.moving().wheel_axis(index).ok_or(Status::Absent)?;
            wheel.write(wheel_rates_of(&axis)?);
            Ok(())
        })
    }

    /// A wheel with its derivatives per unit of the change `change[DRIVES]` of the drives, such as camber gain and
    /// bump steer, by its number, 0 for the first or only one: see `susp_corner_read_derivatives`.
    /// SUSP_ERROR_ABSENT if there is no such wheel, SUSP_ERROR_SINGULAR where the drives lock.
    fn corner_read_wheel_derivatives(corner: In<Corner>, index: usize, change: In<Number>, drive_count: usize, wheel: Out<WheelRates>, failure: Out<Failure>) -> Status {
        on(corner.object().map(Placed::parts), failure, |moving, parsed| {
            let (change, wheel) = (change.many(drive_count)?, wheel.get()?);
            check_count(drive_count, parsed.counts().drives)?;
            let axis = moving.wheel_axis_per(index, change).map_err(Trouble::Solver)?;
            wheel.write(wheel_rates_of(&axis.ok_or(Status::Absent)?)?);
            Ok(())
        })
    }

    /// The rotation of the body that carries it; SUSP_ERROR_ABSENT if there is no such wheel.
    fn corner_read_rotation_at(corner: In<Corner>, index: usize, rotation: Out<CarrierRotation>) -> Status {
        read_rotation(corner, index, rotation)
    }

    /// Its kingpin; SUSP_ERROR_ABSENT if there is no such wheel, or it has none.
    fn corner_read_kingpin_at(corner: In<Corner>, index: usize, kingpin: Out<Kingpin>) -> Status {
        read_kingpin(corner, index, kingpin)
    }
}
