//! The motion looked up in baked curves.

use nalgebra::SVector;
use suspension_core::baked::{Curve, Split};
use suspension_core::listing::Kind;
use suspension_core::{Real, Signal, Values};

use super::course::{Course, Given, cast};
use super::formulation::{first_drive, to_f64};
use super::method::{Coordinates, Method, Outputs};
use suspension::bake::{
    Continuity, Derivatives, Exact, OutOfReach, Output, Path, RequestedPoints, TERMS, Wanted, bake,
};
use suspension::mechanism::{Mechanism, Suspension};

/// Tolerances of the chart, m.
const TOLERANCES: [(&str, f64); 3] = [
    ("baked_1e-4", 1e-4),
    ("baked_1e-6", 1e-6),
    ("baked_1e-8", 1e-8),
];

/// The free points' coordinates over the one drive, in two number types.
#[derive(Clone, Debug)]
pub struct Tables<const N: usize> {
    baked: suspension::bake::Baked,
    double: Vec<[[f64; N]; TERMS]>,
    single: Vec<[[f32; N]; TERMS]>,
}

impl<const N: usize> Tables<N> {
    /// The curve in `f64`.
    pub fn double(&self) -> Curve<'_, f64, N, TERMS> {
        self.baked.curve(&self.double)
    }

    /// The curve in `f32`.
    pub fn single(&self) -> Curve<'_, f32, N, TERMS> {
        self.baked.curve(&self.single)
    }
}

/// Bakes curves of a motion, by name; none if it has several drives, or if a tolerance cannot be met.
pub fn tables<L: Suspension<N>, D: Values<f64>, const N: usize>(
    mechanism: &Mechanism<L, N>,
    course: &Course<D>,
) -> Vec<(&'static str, Tables<N>)> {
    if mechanism.model.count(Kind::Drive) != 1 {
        return Vec::new();
    }
    let metre = mechanism.unit.metre();
    let baked = TOLERANCES
        .map(|(name, tolerance)| Some((name, table(mechanism, course, tolerance * metre)?)));
    baked.into_iter().flatten().collect()
}

fn table<L: Suspension<N>, D: Values<f64>, const N: usize>(
    mechanism: &Mechanism<L, N>,
    course: &Course<D>,
    tolerance: f64,
) -> Option<Tables<N>> {
    let drives = course.drives.iter().map(|given| given.signal.value);
    let values = drives.flat_map(|drives| drives.values().collect::<Vec<_>>());
    let range = values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| {
        [value.min(low), value.max(high)]
    });
    let held: L::Drives = cast(&course.drives.first()?.signal.value);
    let Mechanism { model, start, .. } = mechanism;
    let path = Path::new(model, start, held, 0, range, RequestedPoints::AllPoints).ok()?;
    let wanted = Wanted {
        range,
        tolerance,
        metre: mechanism.unit.metre(),
        continuity: Continuity::Acceleration,
    };
    let count = mechanism.names.free;
    let baked = bake(&wanted, &FreePoints { path, count }).ok()?;
    Some(Tables {
        double: baked.table()?,
        single: baked.table()?,
        baked,
    })
}

/// The free points of a path, which come first.
struct FreePoints<P> {
    path: P,
    count: usize,
}

impl<P: Exact> Exact for FreePoints<P> {
    fn outputs(&self) -> Vec<Output> {
        let outputs = self.path.outputs().into_iter();
        outputs.take(self.count).collect()
    }

    fn at(&self, at: f64) -> Result<Vec<Derivatives>, OutOfReach> {
        let all = self.path.at(at)?.into_iter();
        Ok(all.take(self.count).collect())
    }
}

/// A baked curve.
#[derive(Clone, Copy, Debug)]
pub struct Baked<'a, T, const N: usize>(pub Curve<'a, T, N, TERMS>);

impl<T, D, const N: usize> Method<D, N> for Baked<'_, T, N>
where
    T: Real + Split,
    D: Values<f64>,
{
    type Input = Signal<T>;
    type State = [[T; N]; 3];

    fn input(&self, _: &Given<D>, to: &Given<D>) -> Signal<T> {
        first_drive(&to.signal)
    }

    fn rest(&self, _: &SVector<f64, N>) -> [[T; N]; 3] {
        [[T::zero(); N]; 3]
    }

    fn step(
        &self,
        outputs: Outputs,
        drive: &Signal<T>,
        _: f64,
        _: &[[T; N]; 3],
    ) -> Option<[[T; N]; 3]> {
        let zero = [T::zero(); N];
        let place = self.0.at(drive.value);
        // Rounding may put an end of the range outside it.
        let place = place.or_else(|outside| self.0.at(outside.nearest)).ok()?;
        Some(match outputs {
            Outputs::Position => [place.position(), zero, zero],
            Outputs::Velocity => {
                let [position, velocity] = place.velocity(drive.rate);
                [position, velocity, zero]
            }
            Outputs::Acceleration => place.acceleration(drive.rate, drive.second_rate),
        })
    }

    fn coordinates(&self, state: &[[T; N]; 3]) -> Coordinates<N> {
        state.map(|coordinates| to_f64(SVector::from(coordinates)))
    }
}
