//! Kinematics from tables: piecewise polynomials of the drives in place of equations.

use nalgebra::Vector3;
use suspension_core::baked::{Curve, Outside, Surface};
use suspension_core::linkage::{Designed, Values};
use suspension_core::listing::Kind;
use suspension_core::{GeometryError, Linkage, Signal};

use super::{Drives, Hub, Kinematics, Refused, Why, design_of};

/// A baked motion of free points and markers: `OUT` coordinates.
pub trait Table<const OUT: usize>: Copy + Send {
    /// Coordinates, their rates and second rates, where the drives (bump, steer) move so.
    ///
    /// # Errors
    ///
    /// [`Outside`] where the table ends.
    fn motion(&self, drives: &Signal<[f64; 2]>) -> Result<[[f64; OUT]; 3], Outside<f64>>;
}

impl<const OUT: usize, const TERMS: usize> Table<OUT> for Surface<'static, f64, OUT, TERMS> {
    fn motion(&self, drives: &Signal<[f64; 2]>) -> Result<[[f64; OUT]; 3], Outside<f64>> {
        Ok(self
            .at(drives.value)?
            .acceleration(drives.rate, drives.second_rate))
    }
}

impl<const OUT: usize, const TERMS: usize> Table<OUT> for Curve<'static, f64, OUT, TERMS> {
    fn motion(&self, drives: &Signal<[f64; 2]>) -> Result<[[f64; OUT]; 3], Outside<f64>> {
        let [bump, rate, second_rate] =
            [drives.value, drives.rate, drives.second_rate].map(|[bump, _]| bump);
        Ok(self.at(bump)?.acceleration(rate, second_rate))
    }
}

/// A linkage whose points stand in a table. The model says which point is what.
#[derive(Clone, Copy)]
pub struct Baked<B, L, const N: usize, const OUT: usize> {
    table: B,
    model: L,
    design: [f64; 2],
}

impl<B, L, const N: usize, const OUT: usize> Baked<B, L, N, OUT>
where
    L: Designed<N, Scalar = f64, Listing: Default>,
{
    /// Of all points of the listing, as `suspension bake --points all` has them.
    ///
    /// # Errors
    ///
    /// Where the listing's positions are not those of a linkage.
    pub fn new(table: B) -> Result<Self, GeometryError> {
        let points = L::design();
        let model = L::new(&points)?;
        let design = design_of(&model, &points);
        Ok(Self {
            table,
            model,
            design,
        })
    }
}

impl<B, L, const N: usize, const OUT: usize> Kinematics for Baked<B, L, N, OUT>
where
    B: Table<OUT>,
    L: Linkage<N, Scalar = f64> + Send,
{
    fn step(&mut self, _dt: f64, drives: &Signal<Drives>) -> Result<Hub, Refused> {
        let refused = |why| Refused {
            drives: drives.value,
            why,
        };
        let mut moved = drives.map(|drives| [drives.travel, drives.rack]);
        for (value, design) in moved.value.iter_mut().zip(self.design) {
            *value += design;
        }
        let by_travel = Signal {
            value: moved.value,
            rate: [1.0, 0.0],
            second_rate: [0.0; 2],
        };
        let points = |drives| self.points(drives).map_err(|_| refused(Why::OutsideTable));
        Hub::of(&self.model, &points(&moved)?, &points(&by_travel)?)
            .ok_or(refused(Why::OutsideTable))
    }
}

impl<B, L, const N: usize, const OUT: usize> Baked<B, L, N, OUT>
where
    B: Table<OUT>,
    L: Linkage<N, Scalar = f64>,
{
    fn points(&self, drives: &Signal<[f64; 2]>) -> Result<Signal<L::Points>, Outside<f64>> {
        let [value, rate, second_rate] = self.table.motion(drives)?;
        let still = L::Fixed::default();
        Ok(Signal {
            value: self.with_chassis(self.model.fixed(), &value),
            rate: self.with_chassis(&still, &rate),
            second_rate: self.with_chassis(&still, &second_rate),
        })
    }

    fn with_chassis(&self, fixed: &L::Fixed, moving: &[f64; OUT]) -> L::Points {
        let (points, _) = moving.as_chunks();
        let points = points.iter().map(|point| Vector3::from(*point));
        let fixed = fixed.values().take(self.model.count(Kind::ChassisPoint));
        L::Points::from_values(fixed.chain(points))
    }
}
