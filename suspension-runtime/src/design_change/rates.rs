//! How derivatives with respect to the drives change with a design.

use nalgebra::{SVector, Vector3};
use suspension_core::model::constraint::{Carried, Frame};
use suspension_core::{Linkage, Real, Values};

use super::{DesignChange, Start, Unknowns};
use crate::form::{Bilinear, Prescribed};
use crate::model::Model;
use crate::site::{Site, Sites, three};
use crate::size::{Chassis, Few, Room, Size};
use crate::table::Table;

/// Derivatives with respect to a drive.
#[derive(Clone, Copy, Debug)]
pub struct AlongDrive<'a, T: Real, const N: usize>
where
    Room<N>: Size,
{
    /// The drive.
    pub drive: u16,
    /// Derivatives of the unknowns.
    pub unknowns: &'a Unknowns<T, N>,
    /// The derivatives of these with respect to the change of the design.
    pub changed: &'a Unknowns<T, N>,
}

impl<T: Real, const N: usize> DesignChange<'_, '_, T, N>
where
    Room<N>: Size,
{
    /// The right-hand side `J x`, where `x` is the change of the unknowns' derivative with respect to a drive and the
    /// change of the design moves the unknowns by `moved`.
    pub fn first_right_hand_side(
        &self,
        moved: &Unknowns<T, N>,
        drive: u16,
        unknowns: &Unknowns<T, N>,
    ) -> SVector<T, N> {
        let mut terms = -curvature(self.given.start.model, moved, unknowns);
        self.add_constants(&mut terms, unknowns, None);
        self.add_drive(&mut terms, drive, &self.coordinates.rate);
        terms
    }

    /// The same for the second derivative `both` with respect to two drives, or twice to the same one.
    pub fn second_right_hand_side(
        &self,
        moved: &Unknowns<T, N>,
        [one, other]: [&AlongDrive<'_, T, N>; 2],
        both: &Unknowns<T, N>,
    ) -> SVector<T, N> {
        let model = self.given.start.model;
        let mut terms = -curvature(model, moved, both);
        let bent = curvature(model, one.changed, other.unknowns);
        if one.drive == other.drive {
            terms -= bent + bent;
            self.add_drive(&mut terms, one.drive, &self.coordinates.second_rate);
        } else {
            terms -= bent + curvature(model, other.changed, one.unknowns);
        }
        self.add_constants(&mut terms, both, Some([one.unknowns, other.unknowns]));
        terms
    }

    /// The derivatives of all points, if those of the unknowns are `moved`.
    pub fn points(&self, moved: &Unknowns<T, N>) -> impl Iterator<Item = Vector3<T>> {
        self.with_markers(moved, |_, rate, _, frame| {
            rate.position(frame) - frame.origin
        })
    }

    /// The derivatives of the points' derivatives with respect to a drive.
    pub fn first(
        &self,
        moved: &Unknowns<T, N>,
        along: &AlongDrive<'_, T, N>,
    ) -> impl Iterator<Item = Vector3<T>> {
        self.with_markers(along.changed, |constant, rate, carriers, frame| {
            let along = along.unknowns.frame(carriers);
            turned(rate, frame, &along) - constant.curvature(&moved.frame(carriers), &along)
        })
    }

    /// The derivatives of the second derivatives `both`, which change by `changed`.
    pub fn second(
        &self,
        moved: &Unknowns<T, N>,
        [one, other]: [&AlongDrive<'_, T, N>; 2],
        [both, changed]: [&Unknowns<T, N>; 2],
    ) -> impl Iterator<Item = Vector3<T>> {
        self.with_markers(changed, move |constant, rate, carriers, frame| {
            let [a, b] = [one, other].map(|along| along.unknowns.frame(carriers));
            let [a_changed, b_changed] = [one, other].map(|along| along.changed.frame(carriers));
            let both = both.frame(carriers);
            turned(rate, frame, &both)
                - rate.curvature(&a, &b)
                - constant.curvature(&moved.frame(carriers), &both)
                - constant.curvature(&a_changed, &b)
                - constant.curvature(&b_changed, &a)
        })
    }

    /// All points. Markers move with their frames, plus a term that `by` computes from the marker's constants, the
    /// derivatives of these, the sites of the frame and the frame.
    fn with_markers(
        &self,
        changed: &Unknowns<T, N>,
        by: impl Fn(&Carried<T>, &Carried<T>, [Site; 3], &Frame<T>) -> Vector3<T>,
    ) -> impl Iterator<Item = Vector3<T>> {
        let Start { model, points, .. } = self.given.start;
        let plan = model.plan();
        let chassis = changed.chassis.values().take(plan.chassis.into());
        let free = (0..plan.free).filter_map(|point| three(changed.free.as_slice(), 3 * point));
        let constants = model.markers.as_slice().iter().zip(self.markers.as_slice());
        let markers = plan.markers.iter().zip(constants);
        let markers = markers.map(move |(carriers, (constant, rate))| {
            let frame = model.frame_of(*carriers, points);
            let carried = constant.velocity(&frame, &changed.frame(*carriers));
            carried + by(constant, rate, *carriers, &frame)
        });
        chassis.chain(free).chain(markers)
    }

    /// Adds the contribution of the constants' derivatives along a derivative of the unknowns; for a second
    /// derivative it takes both first ones too.
    fn add_constants(
        &self,
        terms: &mut SVector<T, N>,
        along: &Unknowns<T, N>,
        firsts: Option<[&Unknowns<T, N>; 2]>,
    ) {
        let plan = self.given.start.model.plan();
        let at = self.given.start.unknowns.sites();
        let along = along.sites();
        let mut rates = self.carried.as_slice().iter();
        for body in plan.forms.bodies.iter().filter(|_| self.reshapes) {
            let (Some(frame), Some(along)) = (body.frame(&at), body.frame(&along)) else {
                continue;
            };
            let firsts = firsts.map(|firsts| firsts.map(|first| body.frame(&first.sites())));
            for (carried, rate) in body.carried.iter().zip(&mut rates) {
                let mut by = turned(rate, &frame, &along);
                if let Some([Some(a), Some(b)]) = &firsts {
                    by -= rate.curvature(a, b);
                }
                for (row, by) in (carried.row..).zip(by.iter()) {
                    add(terms, row, *by);
                }
            }
        }
        for bilinear in plan.forms.bilinear.iter() {
            if let Some(by) = self.scale_term(bilinear, &along) {
                add(terms, bilinear.row, -by);
            }
        }
    }

    /// The contribution of the length by which a sum of products is divided: since the equation is met, the sum
    /// divided by the length is what it defines, with the opposite sign.
    pub(super) fn scale_term(
        &self,
        bilinear: &Bilinear,
        along: &Sites<'_, T, Chassis<T, N>>,
    ) -> Option<T> {
        Some(self.scales.get(bilinear.constant) * along.scalar(bilinear.unknown()?)?)
    }

    /// Adds the contribution of a drive whose coordinate changes.
    fn add_drive(&self, terms: &mut SVector<T, N>, drive: u16, changes: &Few<T, N>) {
        for linear in self.given.start.model.forms().linear.iter() {
            if let Prescribed::Drive(of, factor) = linear.prescribed
                && of == drive
            {
                add(terms, linear.row, T::constant(factor) * changes.get(drive));
            }
        }
    }
}

/// The contribution of the derivatives of a point's constants to its own derivative, along a derivative of its frame.
fn turned<T: Real>(rate: &Carried<T>, frame: &Frame<T>, along: &Frame<T>) -> Vector3<T> {
    rate.velocity(frame, along) - along.origin
}

fn curvature<T: Real, const N: usize>(
    model: &Model<'_, T, N>,
    v: &Unknowns<T, N>,
    w: &Unknowns<T, N>,
) -> SVector<T, N>
where
    Room<N>: Size,
{
    model.curvature(&v.free, &v.chassis, &w.free, &w.chassis)
}

fn add<T: Real, const N: usize>(terms: &mut SVector<T, N>, row: u16, by: T) {
    if let Some(term) = terms.get_mut(usize::from(row)) {
        *term += by;
    }
}
