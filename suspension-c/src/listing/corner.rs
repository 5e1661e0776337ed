//! Functions of a moving suspension.
#![allow(unsafe_code, reason = "names for the linker")]

use suspension_core::nalgebra::Vector3;

use super::loads::Wanted;
use super::moving::Moving;
use super::objects::{Corner, Listing};
use super::parsed::Parsed;
use super::placed::Placed;
use super::text::{Number, check_count};
use crate::convert::{fill, kingpin_of, rotation_of, wheel_of};
use crate::failure::{Trouble, answer, respond};
use crate::of::f64::{CarrierRotation, Failure, Kingpin, Masses, Report, Wheel};
use crate::pointer::{Create, Destroy, In, InOut, Object, Out};
use crate::status::Status;

/// Does the work of a call that moves a suspension.
fn moved(
    corner: InOut<'_, Corner>,
    failure: Out<'_, Failure>,
    work: impl FnOnce(&mut dyn Moving, &Parsed) -> Result<(), Trouble>,
) -> Status {
    match corner.object().map(Placed::parts) {
        Ok((moving, parsed)) => respond(failure, parsed, || work(moving, parsed)),
        Err(status) => respond(failure, &(), || Err(status.into())),
    }
}

/// The number of the wheel where a call has none.
const FIRST: usize = 0;

fn read_wheel(corner: In<'_, Corner>, index: usize, wheel: Out<'_, Wheel>) -> Status {
    answer(|| {
        let (corner, wheel) = (corner.object()?, wheel.get()?);
        let axis = corner.moving().wheel_axis(index).ok_or(Status::Absent)?;
        wheel.write(wheel_of(axis)?);
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
        kingpin.write(kingpin_of(ends, axis)?);
        Ok(())
    })
}

crate::functions! { "susp":
    /// Makes a suspension at rest where the points are, `points[POINTS][3]`: those that `susp_listing_design`
    /// gives, or others in their place. Where the listing states no positions the order of elimination is
    /// chosen by these.
    fn corner_new(listing: In<Listing>, points: In<Number>, count: usize, corner: Create<Corner>, failure: Out<Failure>) -> Status {
        let parsed = match listing.object() {
            Ok(parsed) => parsed,
            Err(status) => return respond(failure, &(), || Err(status.into())),
        };
        respond(failure, parsed, || {
            let (points, corner) = (points.many(count)?, corner.get()?);
            check_count(count, 3 * parsed.counts().points)?;
            let (points, _) = points.as_chunks();
            let points: std::vec::Vec<_> = points.iter().copied().map(Vector3::from).collect();
            corner.write(Object::on_heap(Placed::new(parsed, &points)?));
            Ok(())
        })
    }

    /// Makes a copy of a suspension, which stands as it does and goes on by itself: with it a state is saved, before a
    /// lock say.
    fn corner_copy(corner: In<Corner>, copy: Create<Corner>) -> Status {
        answer(|| {
            let (corner, copy) = (corner.object()?, copy.get()?);
            copy.write(Object::on_heap(corner.copied()));
            Ok(())
        })
    }

    /// Frees a suspension; NULL is none.
    fn corner_destroy(corner: Destroy<Corner>) -> Status {
        answer(|| corner.end())
    }

    /// The time, s, from 0 where the suspension was made.
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

    /// A step of `dt` seconds (0: a pause, to drives near the last ones) to the values and rates of the drives at its end,
    /// `drives[3][DRIVES]`, however far: in as many sub-steps as it takes, 200 at most. In between the
    /// drives follow the cubics that have their values and rates at both ends or, where these lead past a
    /// lock, straight lines from rest, in 200 more. `report` may be NULL.
    fn corner_step(corner: InOut<Corner>, drives: In<Number>, count: usize, dt: Number, report: Out<Report>, failure: Out<Failure>) -> Status {
        moved(corner, failure, |moving, parsed| {
            let (drives, report) = (drives.many(count)?, report.optional()?);
            check_count(count, 3 * parsed.counts().drives)?;
            fill(report, moving.step(dt, drives).map_err(Trouble::Solver)?);
            Ok(())
        })
    }

    /// `susp_corner_step` that keeps what it has got to where it stops early, as at a lock:
    /// `failure->reached` seconds from its start. Time, drives and points are then those there; from a lock
    /// no step may lead on or back, as rates have no bound there.
    fn corner_advance(corner: InOut<Corner>, drives: In<Number>, count: usize, dt: Number, report: Out<Report>, failure: Out<Failure>) -> Status {
        moved(corner, failure, |moving, parsed| {
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

    /// What the listing measures, `measures[3][MEASURES]`. A rate is NaN where a measured length is zero, or
    /// a measured angle 0 or pi.
    fn corner_read_measures(corner: In<Corner>, measures: Out<Number>, count: usize) -> Status {
        answer(|| {
            let (corner, measures) = (corner.object()?, measures.many(count)?);
            check_count(count, 3 * corner.parsed().counts().measures)?;
            corner.moving().read_measures(measures);
            Ok(())
        })
    }

    /// Motion ratios: points and measures with their first and second derivative where the drives change
    /// as `change[DRIVES]` says, say one of them by 1 and the rest by 0, at rest too: per unit of that
    /// change in place of per second. `points[3][POINTS][3]` and `measures[3][MEASURES]` may each be NULL.
    /// SUSP_ERROR_SINGULAR where the drives lock.
    fn corner_read_derivatives(corner: In<Corner>, change: In<Number>, drive_count: usize, points: Out<Number>, point_count: usize, measures: Out<Number>, measure_count: usize, failure: Out<Failure>) -> Status {
        let corner = match corner.object() {
            Ok(corner) => corner,
            Err(status) => return respond(failure, &(), || Err(status.into())),
        };
        respond(failure, corner.parsed(), || {
            let counts = corner.parsed().counts();
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
            let derived = corner.moving().read_per(change, points, measures);
            derived.map_err(Trouble::Solver)
        })
    }

    /// Adds to `forces[POINTS][3]` weight and inertia of masses where the suspension is, as it moves: for
    /// `susp_corner_read_loads`. `design[POINTS][3]` are the points where the masses are stated. Each is at any points;
    /// SUSP_ERROR_ABSENT of no point, SUSP_ERROR_NO_DIRECTION where three points that hold a body are in line.
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

    /// What forces at the points do, `forces[POINTS][3]`, in N in the axes of the points, the suspension at rest where it
    /// is: at a marker on its body, at a chassis point on the drive that moves it. `drives[DRIVES]` is their work per unit of each
    /// drive, which what moves the drive bears, of a length in N, of an angle in N times the unit of the points;
    /// `tensions[PARTS]` the force in each link, positive in tension, 0 of other parts; `reactions[PARTS][POINTS][3]`
    /// the forces that each part exerts on the points; what drives or holds an angle acts on the parts that carry the
    /// angle's lines, so that an angle between lines of parts exerts none itself. Each of these may be NULL.
    /// SUSP_ERROR_SINGULAR where the drives lock.
    fn corner_read_loads(corner: In<Corner>, forces: In<Number>, force_count: usize, drives: Out<Number>, drive_count: usize, tensions: Out<Number>, tension_count: usize, reactions: Out<Number>, reaction_count: usize, failure: Out<Failure>) -> Status {
        let corner = match corner.object() {
            Ok(corner) => corner,
            Err(status) => return respond(failure, &(), || Err(status.into())),
        };
        let parsed = corner.parsed();
        respond(failure, parsed, || {
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
            let loaded = corner.moving().read_loads(&parsed.structure, forces, wanted);
            loaded.map_err(Trouble::Solver)
        })
    }

    /// The wheel, the first of several; SUSP_ERROR_ABSENT where the listing states none.
    fn corner_read_wheel(corner: In<Corner>, wheel: Out<Wheel>) -> Status {
        read_wheel(corner, FIRST, wheel)
    }

    /// How the body that carries that wheel turns; SUSP_ERROR_ABSENT where the listing states no wheel.
    fn corner_read_rotation(corner: In<Corner>, rotation: Out<CarrierRotation>) -> Status {
        read_rotation(corner, FIRST, rotation)
    }

    /// The kingpin of that wheel; SUSP_ERROR_ABSENT where the listing states none, or no wheel.
    fn corner_read_kingpin(corner: In<Corner>, kingpin: Out<Kingpin>) -> Status {
        read_kingpin(corner, FIRST, kingpin)
    }

    /// Any of several wheels, by its number as SUSP_WHEEL; SUSP_ERROR_ABSENT where there is no such wheel.
    fn corner_read_wheel_at(corner: In<Corner>, index: usize, wheel: Out<Wheel>) -> Status {
        read_wheel(corner, index, wheel)
    }

    /// How the body that carries it turns; SUSP_ERROR_ABSENT where there is no such wheel.
    fn corner_read_rotation_at(corner: In<Corner>, index: usize, rotation: Out<CarrierRotation>) -> Status {
        read_rotation(corner, index, rotation)
    }

    /// Its kingpin; SUSP_ERROR_ABSENT where there is no such wheel, or it has none.
    fn corner_read_kingpin_at(corner: In<Corner>, index: usize, kingpin: Out<Kingpin>) -> Status {
        read_kingpin(corner, index, kingpin)
    }
}
