//! Forces in every layout of the catalogue, against methods without multipliers: virtual work, and the equilibrium of each
//! part as a free body. A statically determinate mechanism has no other solution.

use fastrand::Rng;
use nalgebra::{SVector, Vector3};
use suspension_core::directions::Directions;
use suspension_core::linkages::LISTINGS;
use suspension_core::listing::{Kind, Part, Parts};
use suspension_core::statics::{Loads, Statics, spread};
use suspension_core::{Build, Inputs, Linkage, Signal, Tracker, Values};
use suspension_runtime::{Fitted, Listing, Model, Room, Size, Statement, Work};

use crate::back_ends::hardpoints;

/// A listing under random forces.
struct Loaded<'a> {
    listing: &'a Listing,
    name: &'static str,
}

impl Work for Loaded<'_> {
    type Answer = ();

    fn on<const N: usize>(self, fitted: Fitted<'_, N>)
    where
        Room<N>: Size,
    {
        let mut rng = Rng::with_seed(13);
        let design = Values::from_values(hardpoints(self.listing, &mut rng));
        let model = Model::<f64, N>::of(fitted, &design).expect("a model");
        for case in 0..8 {
            let (q, drives) = moved(&model, &design, &mut rng);
            Case {
                listing: self.listing,
                name: format!("{}, case {case} of seed 13", self.name),
                model: &model,
                q,
                drives,
            }
            .check(&mut rng);
        }
    }
}

/// A place that the drives lead to, up to 20 mm or 0.02 rad from the design; listings without positions stay there.
fn moved<const N: usize>(
    model: &Model<'_, f64, N>,
    design: &<Model<'_, f64, N> as Linkage<N>>::Points,
    rng: &mut Rng,
) -> (
    SVector<f64, N>,
    <Model<'static, f64, N> as Linkage<N>>::Drives,
)
where
    Room<N>: Size,
{
    let start = model.drives_at(design);
    let count = model.count(Kind::Drive);
    let most = if model.listing().listing().design().is_some() {
        0.02
    } else {
        0.0
    };
    let changes: Vec<f64> = (0..count).map(|_| most * (2.0 * rng.f64() - 1.0)).collect();
    let change = Values::from_values(changes);
    let mut motion = suspension_core::Motion::at_rest(model.unknowns(design));
    let inputs = |time: f64| Inputs::still(Signal::line(start, change, time));
    let advanced = Tracker::default().advance(model, inputs, 0.0, 1.0, &mut motion);
    advanced.expect("within reach");
    (motion.position, inputs(1.0).drives.value)
}

struct Case<'a, 'l, const N: usize>
where
    Room<N>: Size,
{
    listing: &'a Listing,
    name: String,
    model: &'a Model<'l, f64, N>,
    q: SVector<f64, N>,
    drives: <Model<'l, f64, N> as Linkage<N>>::Drives,
}

fn random(rng: &mut Rng) -> Vector3<f64> {
    Vector3::from_fn(|_, _| 2000.0 * (2.0 * rng.f64() - 1.0))
}

impl<const N: usize> Case<'_, '_, N>
where
    Room<N>: Size,
{
    fn check(&self, rng: &mut Rng) {
        let count = self.model.count(Kind::ChassisPoint) + self.model.count(Kind::FreePoint);
        let points = self.points();
        let forces: Vec<Vector3<f64>> = points.iter().map(|_| random(rng)).collect();
        let by_name = Values::from_values(forces.iter().copied());
        let statics = Statics::new(self.model, self.drives, &self.q).expect("not singular");
        let loads = statics.under(&by_name).expect("finite");
        self.virtual_work(&forces, &loads);
        let mut carried = by_name;
        let fixed = Values::from_values(points.iter().copied());
        self.model.carry_forces(&self.q, &fixed, &mut carried);
        let carried: Vec<_> = carried.values().take(count).collect();
        self.free_bodies(&points, &carried, &loads);
    }

    fn points(&self) -> Vec<Vector3<f64>> {
        let inputs: Inputs<suspension_core::Still, _> = Inputs::still(Signal::still(self.drives));
        let motion = suspension_core::Motion::at_rest(self.q);
        let points = motion.points(self.model, &inputs).value;
        let count = Kind::POINTS.map(|kind| self.model.count(kind));
        points.values().take(count.into_iter().sum()).collect()
    }

    /// The load on a drive is the work of the forces per motion of the drive, those at chassis points that it moves
    /// included.
    fn virtual_work(&self, forces: &[Vector3<f64>], loads: &Loads<'_, Model<'_, f64, N>, N>) {
        for (drive, found) in loads
            .on_drives()
            .values()
            .take(self.model.count(Kind::Drive))
            .enumerate()
        {
            let change = <Model<'_, f64, N> as Linkage<N>>::Drives::default().with(drive, 1.0);
            let points = Directions::at(self.model, self.drives, &self.q, |directions| {
                directions.points(change)
            });
            let points = points.expect("neither singular nor infinite").rate;
            let works = points
                .values()
                .zip(forces)
                .map(|(rate, force)| rate.dot(force));
            let works: Vec<f64> = works.collect();
            let size: f64 = works.iter().map(|work| work.abs()).sum();
            let off = (works.iter().sum::<f64>() - found).abs();
            assert!(
                off <= 1e-12 * size,
                "{}: drive {drive}: off by {off:e} of {size}",
                self.name
            );
        }
    }

    /// Each statement holds itself, and all together each free point.
    fn free_bodies(
        &self,
        points: &[Vector3<f64>],
        forces: &[Vector3<f64>],
        loads: &Loads<'_, Model<'_, f64, N>, N>,
    ) {
        let chassis = self.model.count(Kind::ChassisPoint);
        let size: f64 = forces.iter().map(Vector3::norm).sum();
        let mut on_points = forces.to_vec();
        for statement in self.listing.statements() {
            let by = by(&statement, loads);
            if ["link", "body", "hinge"].contains(&&*statement.kind.to_string()) {
                let force: Vector3<f64> = by.iter().sum();
                let moments = by.iter().zip(points).map(|(force, at)| at.cross(force));
                let moment: Vector3<f64> = moments.sum();
                let (name, equation) = (&self.name, statement.name);
                let largest = by.iter().map(Vector3::norm).fold(size, f64::max);
                assert!(
                    force.norm() <= 1e-10 * largest,
                    "{name}: {equation}: {force}"
                );
                assert!(
                    moment.norm() <= 1e-10 * largest,
                    "{name}: {equation}: {moment}"
                );
            }
            if statement.ends().is_some() {
                self.tension(&statement, &by, points, loads.multipliers());
            }
            let elsewhere = (0..by.len()).filter(|point| !statement.points.contains(point));
            for point in elsewhere {
                assert_eq!(
                    by[point],
                    Vector3::zeros(),
                    "{}: {}",
                    self.name,
                    statement.name
                );
            }
            for (sum, force) in on_points.iter_mut().zip(&by) {
                *sum += force;
            }
        }
        for (point, left) in on_points.iter().enumerate().skip(chassis) {
            let point = self.model.name(Part::Point(point));
            let largest = loads.multipliers().amax().max(size);
            assert!(
                left.norm() <= 1e-10 * largest,
                "{}: point {point}: {left}",
                self.name
            );
        }
    }
}

impl<const N: usize> Case<'_, '_, N>
where
    Room<N>: Size,
{
    /// The multiplier of a link is the force in it.
    fn tension(
        &self,
        link: &Statement<'_>,
        by: &[Vector3<f64>],
        points: &[Vector3<f64>],
        multipliers: &SVector<f64, N>,
    ) {
        let ([from, to], [equations]) = (link.points.as_slice(), link.equations.as_slice()) else {
            panic!("{}: link {}", self.name, link.name);
        };
        let along = (points[*to] - points[*from]).normalize();
        let expected = multipliers[equations.start];
        let off = (by[*from].dot(&along) - expected).abs();
        assert!(
            equations.len() == 1 && off <= 1e-10 * expected.abs(),
            "{}: link {}: off by {off:e} of {expected}",
            self.name,
            link.name
        );
    }
}

/// The forces of a statement on all points.
fn by<const N: usize>(
    statement: &Statement<'_>,
    loads: &Loads<'_, Model<'_, f64, N>, N>,
) -> Vec<Vector3<f64>>
where
    Room<N>: Size,
{
    let mut sum: Vec<Vector3<f64>> = Vec::new();
    for equations in &statement.equations {
        let part: Vec<Vector3<f64>> = loads.by(equations.clone()).values().collect();
        sum.resize(part.len(), Vector3::zeros());
        for (sum, part) in sum.iter_mut().zip(part) {
            *sum += part;
        }
    }
    sum
}

#[test]
fn loads_match_virtual_work_and_every_part_is_in_equilibrium() {
    for (name, text) in LISTINGS {
        let listing = Listing::parse(text).expect("a listing of the catalogue");
        let work = Loaded {
            listing: &listing,
            name,
        };
        listing.in_its_size(work);
    }
}

#[test]
fn three_forces_are_equivalent_to_one_force_and_a_moment() {
    let mut rng = Rng::with_seed(7);
    for _ in 0..100 {
        let points = [(); 3].map(|()| random(&mut rng) / 4000.0);
        let [force, place, moment] = [
            random(&mut rng),
            random(&mut rng) / 4000.0,
            random(&mut rng),
        ];
        let parts = spread(points, force, place, moment);
        let sum: Vector3<f64> = parts.iter().sum();
        let moments = parts.iter().zip(points).map(|(part, at)| at.cross(part));
        let turning: Vector3<f64> = moments.sum();
        let largest = parts.iter().map(Vector3::norm).fold(1.0, f64::max);
        assert!((sum - force).norm() <= 1e-13 * largest);
        assert!((turning - place.cross(&force) - moment).norm() <= 1e-12 * largest);
    }
}
