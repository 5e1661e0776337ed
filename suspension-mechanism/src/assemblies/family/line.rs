//! The straight line between two systems of a family, and its root as a function of the place on it.

use nalgebra::{Complex, Vector3};
use suspension_core::{Linkage, Listing, Values};

use crate::assemblies::factors::{Factors, Vector};
use crate::assemblies::family::{Drives, Family, Fixed, Member, MemberOf};
use crate::assemblies::tilt::Plane;

impl<G: Listing<N>, const N: usize> Family<G, N> {
    /// The straight line from one member to another.
    pub(crate) fn line(&self, from: MemberOf<G, N>, to: MemberOf<G, N>) -> Line<'_, G, N> {
        let drives = to.drives.combined(&from.drives, |to, from| to - from);
        let fixed = to.fixed.combined(&from.fixed, |to, from| to - from);
        let change = Member {
            fixed: self.model.drive_anchors(fixed, &drives),
            drives,
            right: to.right - from.right,
            plane: to.plane.plus(from.plane, -1.0),
        };
        Line {
            family: self,
            from,
            change,
            is_to_the_mechanism: to.plane == Plane::default(),
        }
    }
}

/// Members `from + s change`, with `s` from 0 to 1.
pub(crate) struct Line<'a, G: Listing<N>, const N: usize> {
    family: &'a Family<G, N>,
    from: MemberOf<G, N>,
    change: MemberOf<G, N>,
    /// Whether it ends at the mechanism itself, some of whose roots may be at infinity.
    pub(crate) is_to_the_mechanism: bool,
}

impl<G: Listing<N>, const N: usize> Line<'_, G, N> {
    /// The longest length of the linkage.
    pub(crate) fn size(&self) -> f64 {
        self.family.size
    }

    fn drives(&self, s: f64) -> Drives<G, N> {
        let changed = |from, change| from + change * Complex::from(s);
        self.from.drives.combined(&self.change.drives, changed)
    }

    fn fixed(&self, s: f64) -> Fixed<G, N> {
        let changed = |from, change: Vector3<_>| from + change * Complex::from(s);
        let fixed = self.from.fixed.combined(&self.change.fixed, changed);
        self.family.model.drive_anchors(fixed, &self.drives(s))
    }

    fn plane(&self, s: f64) -> Plane {
        self.from.plane.plus(self.change.plane, s)
    }

    /// `F(q; u(s)) - c(s)`.
    pub(crate) fn residual(&self, q: &Vector<N>, s: f64) -> Vector<N> {
        let right = self.from.right + self.change.right * Complex::from(s);
        let (fixed, drives) = (self.fixed(s), self.drives(s));
        self.family.residual(q, &fixed, &drives, self.plane(s)) - right
    }

    /// The factors of `dF/dq`.
    pub(crate) fn factors(&self, q: &Vector<N>, s: f64) -> Factors<'_> {
        let mut jacobian = self.family.model.jacobian(q, &self.fixed(s));
        if let Some(tilt) = &self.family.tilt {
            self.family.give(tilt.row, &mut jacobian);
            tilt.add_gradient(self.plane(s), &mut jacobian);
        }
        Factors::compute(&jacobian, &self.family.solved)
    }

    /// Taylor coefficients of the root, order 1 first. `F` is quadratic in `q`, `u` and the tilt together, so one
    /// factorisation gives all of them.
    pub(crate) fn series<const K: usize>(
        &self,
        q: &Vector<N>,
        s: f64,
        factors: &Factors<'_>,
    ) -> Option<[Vector<N>; K]> {
        let Family { model, .. } = self.family;
        let (fixed, rate) = (self.fixed(s), &self.change.fixed);
        let of_drives = model.drive_rate(q, &fixed, rate, &self.change.drives);
        let of_inputs = self
            .family
            .own(of_drives + model.chassis_rate(q, &fixed, rate));
        let mut terms = [Vector::zeros(); K];
        for order in 0..K {
            let (mut right, last) = match order {
                0 => (of_inputs + self.change.right, q),
                _ => {
                    let curvature = self.curvature(&terms[..order]);
                    (curvature * Complex::from(-0.5), &terms[order - 1])
                }
            };
            if let Some(tilt) = &self.family.tilt {
                let less = Plane::default().plus(self.change.plane, -1.0);
                tilt.add(less, last, &mut right);
            }
            terms[order] = factors.solve(&right)?;
        }
        Some(terms)
    }

    /// The sum of `C(a, b)` over the pairs of terms, in either order, whose orders add up to the next order.
    fn curvature(&self, terms: &[Vector<N>]) -> Vector<N> {
        let still = Fixed::<G, N>::default();
        let rate = |index| {
            if index == 0 {
                &self.change.fixed
            } else {
                &still
            }
        };
        let of_pair = |i: usize| {
            let j = terms.len() - 1 - i;
            let model = &self.family.model;
            let curvature = model.curvature(&terms[i], rate(i), &terms[j], rate(j));
            let orders = if i == j { 1.0 } else { 2.0 };
            curvature * Complex::from(orders)
        };
        let mut sum = Vector::zeros();
        for i in 0..terms.len().div_ceil(2) {
            sum += of_pair(i);
        }
        self.family.own(sum)
    }
}
