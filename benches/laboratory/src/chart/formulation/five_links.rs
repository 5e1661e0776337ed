//! The geometry of a five-link suspension, for formulations that are not generated.

use nalgebra::{SVector, Vector3};
use suspension_core::listing::{DriveKind, Kind};
use suspension_core::{Build, Real, Signal, Values};

use suspension_double_double::DoubleDouble;

/// Five links of constant length between chassis and knuckle, the first one driven.
#[derive(Clone, Copy, Debug)]
pub struct FiveLinks<T> {
    /// Chassis ends.
    pub chassis: [Vector3<T>; 5],
    /// Knuckle ends, from the first one, at the instant that the motion begins.
    pub knuckle: [Vector3<T>; 5],
    /// The first knuckle end at that instant.
    pub origin: Vector3<T>,
    /// Lengths.
    pub lengths: [T; 5],
}

impl<T: Real> FiveLinks<T> {
    /// Returns the links of a linkage whose free points have the coordinates `position`; `None` if it is not a five-link
    /// suspension with a driving angle between its first link and the z axis.
    pub fn of<L: Build<N, Scalar = f64>, const N: usize>(
        model: &L,
        position: &SVector<DoubleDouble, N>,
    ) -> Option<Self> {
        let chassis: [Vector3<f64>; 5] = collect(model.fixed().values())?;
        let free = position.as_slice().chunks_exact(3);
        let free: [Vector3<DoubleDouble>; 5] = collect(free.map(Vector3::from_column_slice))?;
        let lengths: [f64; 5] = collect(model.lengths().values().take(5))?;
        let nearest = |v: Vector3<DoubleDouble>| v.map(DoubleDouble::nearest);
        let are_links = (0..5).all(|i| {
            let length = (nearest(free[i]) - chassis[i]).norm();
            (length - lengths[i]).abs() < 1e-9 * length
        });
        let is_driven =
            model.count(Kind::Drive) == 1 && model.drive_kind(0) == DriveKind::Angle && {
                let height = free[0].z.nearest() - chassis[0].z;
                let angle = Signal {
                    value: L::Drives::from_values([(height / lengths[0]).acos()]),
                    ..Signal::default()
                };
                let driven = model.coordinates(&angle).value.values().next();
                driven.is_some_and(|driven| (driven - height).abs() < 1e-9 * lengths[0])
            };
        let cast = |v: Vector3<f64>| v.map(T::constant);
        (are_links && is_driven).then(|| Self {
            chassis: chassis.map(cast),
            knuckle: free.map(|point| cast(nearest(point - free[0]))),
            origin: cast(nearest(free[0])),
            lengths: lengths.map(T::constant),
        })
    }

    /// The longest link.
    pub fn size(&self) -> T {
        self.lengths
            .iter()
            .fold(T::zero(), |size, length| size.max(*length))
    }
}

fn collect<V, const K: usize>(values: impl Iterator<Item = V>) -> Option<[V; K]> {
    values.collect::<Vec<_>>().try_into().ok()
}

/// Coordinates of all five knuckle ends in a row.
pub fn in_a_row<T: Real, const N: usize>(point: impl Fn(usize) -> Vector3<T>) -> SVector<f64, N> {
    let points = [0, 1, 2, 3, 4].map(point);
    SVector::from_fn(|row, _| points[row / 3][row % 3].to_subset_unchecked())
}
