//! The effect of a change of hardpoints, then of lengths, on a model's equations.
//!
//! A model made anew of moved hardpoints has its points where they were moved to: all constants change so that the equations
//! stay met. Derivatives with respect to the drives change with the curvature of the equations, and with those constants that
//! points are multiplied with. What a whole equation is divided by, and what an unknown that is no coordinate is multiplied
//! with, moves no point and is taken as constant.

mod constants;
mod rates;

use nalgebra::{SVector, Vector3};
use suspension_core::generated::dot;
use suspension_core::model::constraint::{Carried, Frame};
use suspension_core::{Real, Scalar, Signal, Values};

use crate::form::{Prescribed, Walked};
use crate::model::Model;
use crate::plan::Length;
use crate::site::{Site, Sites};
use crate::size::{Chassis, Few, Points, Room, Size};
use crate::table::{Table, index, put, put_three};

pub use rates::AlongDrive;

/// The unknowns and the chassis points of a model: their positions, or a derivative of these.
#[derive(Clone, Copy, Debug)]
pub struct Unknowns<T: Scalar, const N: usize>
where
    Room<N>: Size,
{
    /// The unknowns.
    pub free: SVector<T, N>,
    /// The chassis points.
    pub chassis: Chassis<T, N>,
}

/// A model whose design changes, at a position that solves its equations.
#[derive(Clone, Debug)]
pub struct Start<'a, 'l, T: Scalar, const N: usize>
where
    Room<N>: Size,
{
    /// The model.
    pub model: &'a Model<'l, T, N>,
    /// Its unknowns.
    pub unknowns: Unknowns<T, N>,
    /// All its points.
    pub points: Points<Vector3<T>, N>,
    /// The drives.
    pub drives: Few<T, N>,
}

/// A change of the design of a model. Hardpoints change first: the model is made anew with them, and the drives get
/// the values that they give. Lengths of links change second, with the drives held. All derivatives are per unit of
/// the change.
#[derive(Clone, Debug)]
pub struct DesignChange<'a, 'l, T: Real, const N: usize>
where
    Room<N>: Size,
{
    given: Given<'a, 'l, T, N>,
    /// Whether constants of points that bodies carry change.
    reshapes: bool,
    /// The derivatives of the constants of the points that bodies carry.
    carried: Few<Carried<T>, N>,
    /// The derivatives of the constants of markers.
    markers: Few<Carried<T>, N>,
    /// The derivatives of the logarithms of the lengths by which sums of products are divided.
    scales: Few<T, N>,
    /// The derivatives of the coordinates that drives prescribe, and of the first and second derivatives of these
    /// with respect to the drive.
    coordinates: Signal<Few<T, N>>,
}

/// The given change.
#[derive(Clone, Debug)]
struct Given<'a, 'l, T: Scalar, const N: usize>
where
    Room<N>: Size,
{
    start: &'a Start<'a, 'l, T, N>,
    /// Points by their indices, each with its displacement.
    points: &'a [(usize, Vector3<T>)],
    /// Lengths of links by their indices, each with the increase.
    lengths: &'a [(usize, T)],
    /// The displacements of the points that are not markers.
    moved: Unknowns<T, N>,
}

impl<T: Scalar, const N: usize> Unknowns<T, N>
where
    Room<N>: Size,
{
    /// The unknowns alone; chassis points are zero.
    pub fn from_free(free: SVector<T, N>) -> Self {
        Self {
            free,
            chassis: Default::default(),
        }
    }

    fn sites(&self) -> Sites<'_, T, Chassis<T, N>> {
        Sites::new(self.free.as_slice(), &self.chassis)
    }

    fn frame(&self, sites: [Site; 3]) -> Frame<T> {
        let [a, b, c] = sites.map(|site| self.sites().get(site).unwrap_or_default());
        Frame::new(a, b, c)
    }
}

impl<'a, 'l, T: Real, const N: usize> DesignChange<'a, 'l, T, N>
where
    Room<N>: Size,
{
    /// A change of points and lengths by their indices, each with its displacement or increase; `None` for a length
    /// that no link keeps.
    pub fn new(
        start: &'a Start<'a, 'l, T, N>,
        points: &'a [(usize, Vector3<T>)],
        lengths: &'a [(usize, T)],
    ) -> Option<Self> {
        let model = start.model;
        if !lengths.iter().all(|(length, _)| model.is_of_link(*length)) {
            return None;
        }
        let given = Given {
            start,
            points,
            lengths,
            moved: model.moved(points),
        };
        let carried = given.carried();
        Some(Self {
            reshapes: carried.values().any(|rate| rate != Carried::default()),
            carried,
            markers: given.markers(),
            scales: given.scales(),
            coordinates: given.coordinates(),
            given,
        })
    }

    /// The displacements of the hardpoints and the chassis points. Unknowns that are not coordinates do not move.
    pub fn moved(&self) -> &Unknowns<T, N> {
        &self.given.moved
    }

    /// The residual of the equations, to first order, if the points are [`moved`](Self::moved) and the constants
    /// change with the design.
    pub fn residual(&self) -> SVector<T, N> {
        let Start {
            model, unknowns, ..
        } = self.given.start;
        let (plan, at, moved) = (model.plan(), unknowns.sites(), self.moved().sites());
        let mut result = SVector::from([T::zero(); N]);
        let [rows] = &mut result.data.0;
        for (length, by) in self.given.lengths {
            if let Some(distance) = model.distance_of(*length) {
                put(rows, distance, -*by);
            }
        }
        for linear in plan.forms.linear.iter() {
            if let (Prescribed::Drive(drive, factor), Some(sum)) =
                (linear.prescribed, linear.sum(&moved))
            {
                let by = T::constant(factor) * self.coordinates.value.get(drive);
                put(rows, linear.row, sum - by);
            }
        }
        for (line, constant) in plan.forms.lines.iter().zip(model.lines.as_slice()) {
            if let Some(off) = line.left_where_moved(constant, &at, &moved) {
                put_three(rows, line.row, off);
            }
        }
        for (plane, constant) in plan.forms.planes.iter().zip(model.planes.as_slice()) {
            if let Some(off) = plane.left_where_moved(constant, &at, &moved) {
                put_three(rows, plane.row, off);
            }
        }
        for (stretch, constant) in plan.forms.stretches.iter().zip(model.stretches.as_slice()) {
            if let (Some(d), Some(by)) = (stretch.span.vector(&at), stretch.span.vector(&moved)) {
                put(rows, stretch.span.row, dot(constant.gradient(d), by));
            }
        }
        for (product, constant) in plan.forms.products.iter().zip(model.products.as_slice()) {
            if let Some([d, e]) = product.vectors(&at) {
                let [of_d, of_e] = product.lengths;
                let longer = self.given.longer(of_d, d) + self.given.longer(of_e, e);
                put(rows, product.row, -longer * dot(d, constant.gradient(e)));
            }
        }
        for bilinear in plan.forms.bilinear.iter() {
            let constant = model.scales.get(bilinear.constant);
            bilinear.curvature(&constant, [&at, &moved], rows);
            if let Some(off) = rows.get_mut(usize::from(bilinear.row)) {
                *off += self.scale_term(bilinear, &at).unwrap_or_else(T::zero);
            }
        }
        result
    }
}

impl<T: Real, const N: usize> Model<'_, T, N>
where
    Room<N>: Size,
{
    /// Whether a link, and not a body, keeps a length.
    fn is_of_link(&self, length: usize) -> bool {
        let mut bodies = self.forms().bodies.iter();
        let place = index(length);
        let is_of_body = bodies.any(|body| {
            let mut reaches = body.carried.iter().flat_map(|carried| carried.reaches);
            body.edges.contains(&Some(place)) || reaches.any(|reach| reach == place)
        });
        self.distance_of(length).is_some() && !is_of_body
    }

    /// The row of the equation that keeps a length.
    fn distance_of(&self, length: usize) -> Option<u16> {
        let Length::Distance(distance) = self.plan().lengths.get(length)? else {
            return None;
        };
        let distance = self.forms().distances.get(usize::from(*distance))?;
        Some(distance.span.row)
    }

    /// The displacements of unknowns and chassis points if points are moved so.
    fn moved(&self, points: &[(usize, Vector3<T>)]) -> Unknowns<T, N> {
        let plan = self.plan();
        let [chassis, free] = [plan.chassis, plan.free].map(usize::from);
        let mut moved = Unknowns::from_free(SVector::from([T::zero(); N]));
        for (point, by) in points {
            if *point < chassis {
                *moved.chassis.place(index(*point)) += by;
                continue;
            }
            let first = 3 * (*point - chassis);
            let of_point = moved.free.as_mut_slice().get_mut(first..first + 3);
            if let Some(places) = of_point.filter(|_| *point < chassis + free) {
                for (place, by) in places.iter_mut().zip(by.iter()) {
                    *place += *by;
                }
            }
        }
        moved
    }
}
