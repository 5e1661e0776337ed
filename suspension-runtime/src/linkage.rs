//! The interface of a model for the solvers. A longer function is an inherent one of the same name, beside what it uses:
//! `self.jacobian(...)` calls that one.

use nalgebra::{SMatrix, SVector, Vector3};
use suspension_core::model::constraint::Frame;
use suspension_core::{Build, GeometryError, Linkage, Real, Scalar, Signal};

use crate::equations::{rows, zeros};
use crate::factors::Factors;
use crate::fitted::Fitted;
use crate::model::Model;
use crate::site::Sites;
use crate::size::{Chassis, Few, Lengths, Points, Room, Size};
use crate::table::Table;

impl<'l, const N: usize> suspension_core::Listing<N> for Fitted<'l, N>
where
    Room<N>: Size,
{
    type Model<T: Scalar> = Model<'l, T, N>;
    type Fixed<T: Scalar> = Chassis<T, N>;
    type Drives<T: Scalar> = Few<T, N>;
    type Measures<T: Scalar> = Few<T, N>;
    type Points<T: Scalar> = Points<Vector3<T>, N>;

    fn gather<S: Scalar, T: Scalar>(
        like: &Model<'l, S, N>,
        number: impl Fn(&dyn Fn(&Model<'l, S, N>) -> S) -> T,
    ) -> Model<'l, T, N> {
        Model::gather(like.listing, number)
    }
}

impl<'l, T: Scalar, const N: usize> Linkage<N> for Model<'l, T, N>
where
    Room<N>: Size,
{
    type Scalar = T;
    type Listing = Fitted<'l, N>;
    type Fixed = Chassis<T, N>;
    type Drives = Few<T, N>;
    type Measures = Few<T, N>;
    type Points = Points<Vector3<T>, N>;
    type Factors = Factors<'l, T, N>;

    fn linked(&self) -> impl Iterator<Item = usize> {
        let points = self
            .plan()
            .clusters
            .iter()
            .flat_map(|cluster| &cluster.points);
        points.map(|point| point.point.into())
    }

    fn listing(&self) -> Fitted<'l, N> {
        self.listing
    }

    fn fixed(&self) -> &Self::Fixed {
        &self.fixed
    }

    fn size(&self) -> T {
        self.size
    }

    #[inline(always)]
    fn coordinates(&self, drives: &Signal<Self::Drives>) -> Signal<Self::Drives> {
        let mut coordinates = *drives;
        self.put_angles(&mut coordinates);
        coordinates
    }

    fn put_drives(&self, fixed: &mut Self::Fixed, drives: &Self::Drives) {
        self.put_drives(fixed, drives);
    }

    #[inline(always)]
    fn residual(
        &self,
        q: &SVector<T, N>,
        fixed: &Self::Fixed,
        drives: &Self::Drives,
    ) -> SVector<T, N> {
        let mut residual = zeros();
        self.residual_to(rows(&mut residual), q, fixed, drives);
        residual
    }

    fn jacobian(&self, q: &SVector<T, N>, fixed: &Self::Fixed) -> SMatrix<T, N, N> {
        self.jacobian(q, fixed)
    }

    fn pivots(&self) -> &[[usize; 2]] {
        &self.plan().elimination.pivots
    }

    #[inline(always)]
    fn factor(&self, q: &SVector<T, N>, fixed: &Self::Fixed) -> Self::Factors {
        self.factor(q, fixed)
    }

    #[inline(always)]
    fn curvature(
        &self,
        v: &SVector<T, N>,
        v_fixed: &Self::Fixed,
        w: &SVector<T, N>,
        w_fixed: &Self::Fixed,
    ) -> SVector<T, N> {
        let mut curvature = zeros();
        self.curvature_to(rows(&mut curvature), v, v_fixed, w, w_fixed);
        curvature
    }

    #[inline(always)]
    fn drive_rate(
        &self,
        q: &SVector<T, N>,
        fixed: &Self::Fixed,
        fixed_rate: &Self::Fixed,
        drive_rate: &Self::Drives,
    ) -> SVector<T, N> {
        let mut rates = zeros();
        self.input_rates_to(rows(&mut rates), q, fixed, fixed_rate, Some(drive_rate));
        rates
    }

    #[inline(always)]
    fn chassis_rate(
        &self,
        q: &SVector<T, N>,
        fixed: &Self::Fixed,
        fixed_rate: &Self::Fixed,
    ) -> SVector<T, N> {
        let mut rates = zeros();
        self.input_rates_to(rows(&mut rates), q, fixed, fixed_rate, None);
        rates
    }

    fn points(&self, q: &SVector<T, N>, fixed: &Self::Fixed) -> Self::Points {
        self.all_points(q, fixed, |marker, _, frame| marker.position(frame))
    }

    fn velocities(
        &self,
        at: &Self::Points,
        velocity: &SVector<T, N>,
        fixed_rate: &Self::Fixed,
    ) -> Self::Points {
        self.all_points(velocity, fixed_rate, |marker, carriers, rate| {
            marker.velocity(&self.frame_of(carriers, at), rate)
        })
    }

    fn accelerations(
        &self,
        at: &Self::Points,
        velocities: &Self::Points,
        acceleration: &SVector<T, N>,
        fixed_second_rate: &Self::Fixed,
    ) -> Self::Points {
        self.all_points(
            acceleration,
            fixed_second_rate,
            |marker, carriers, second| {
                let frame = self.frame_of(carriers, at);
                marker.acceleration(&frame, &self.frame_of(carriers, velocities), second)
            },
        )
    }

    fn carry_forces(&self, q: &SVector<T, N>, fixed: &Self::Fixed, forces: &mut Self::Points) {
        self.carry_forces(q, fixed, forces);
    }

    fn unknowns(&self, points: &Self::Points) -> SVector<T, N> {
        self.unknowns(points)
    }

    fn measures(&self, points: &Signal<Self::Points>) -> Signal<Self::Measures>
    where
        T: Real,
    {
        self.measures(points)
    }

    fn mirrored(&self, q: &SVector<T, N>, fixed: &Self::Fixed) -> impl Iterator<Item = T> {
        let points = self.plan().clusters.iter().flat_map(|cluster| {
            let points = cluster.points.iter();
            points.map(|point| (cluster.frame, point.site))
        });
        let linked = points.zip(self.linked.as_slice());
        linked.filter_map(move |((frame, site), linked)| {
            let sites = Sites::new(q.as_slice(), fixed);
            let [a, b, c] = sites.get_each(frame)?;
            Some(linked.mirrored(sites.get(site)?, &Frame::new(a, b, c)))
        })
    }
}

impl<'l, T: Real, const N: usize> Build<N> for Model<'l, T, N>
where
    Room<N>: Size,
{
    type Lengths = Lengths<T, N>;

    fn of(listing: Fitted<'l, N>, design: &Self::Points) -> Result<Self, GeometryError> {
        Self::build(listing, design)
    }

    fn check_pivots(&self, points: &Self::Points) -> Result<(), GeometryError> {
        suspension_core::generated::check_pivots(self, points)
    }

    fn with_lengths(self, lengths: &Self::Lengths) -> Result<Self, GeometryError> {
        self.with_lengths(lengths)
    }

    fn with_markers(self, points: &Self::Points) -> Result<Self, GeometryError> {
        self.with_markers(points)
    }

    fn lengths(&self) -> Self::Lengths {
        self.lengths()
    }

    fn drives_at(&self, points: &Self::Points) -> Self::Drives {
        self.drives_at(points)
    }

    fn fit(&self, q: &SVector<T, N>, fixed: &Self::Fixed) -> SVector<T, N> {
        self.fit(q, fixed)
    }
}
