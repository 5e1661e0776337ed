//! The equations of a linkage among their neighbours: `F(q; u) = c` over complex numbers.

use nalgebra::{Complex, SMatrix, Vector3};
use suspension_core::{Inputs, Linkage, Listing, Still, Values};

use crate::assemblies::factors::{Factors, Solved, Vector};
use crate::assemblies::parts::{Part, in_order};
use crate::assemblies::random::Random;
use crate::assemblies::tilt::{Plane, Tilt};

/// A model of a listing, whose equations can be taken over complex numbers.
pub trait Enumerable<const N: usize>:
    Linkage<N, Scalar = f64, Listing: Listing<N, Model<f64> = Self>>
{
}

impl<L, const N: usize> Enumerable<N> for L where
    L: Linkage<N, Scalar = f64, Listing: Listing<N, Model<f64> = L>>
{
}

/// Driven coordinates.
pub(crate) type Drives<G, const N: usize> = <G as Listing<N>>::Drives<Complex<f64>>;
/// Chassis points, those that drives move included.
pub(crate) type Fixed<G, const N: usize> = <G as Listing<N>>::Fixed<Complex<f64>>;
/// A member of the family of a listing.
pub(crate) type MemberOf<G, const N: usize> = Member<Fixed<G, N>, Drives<G, N>, N>;

/// All systems `F(q; u) = c` of one part of a linkage, one equation tilted or not. In the place of the equations of other parts
/// their unknowns are given: `q = c`.
///
/// Each `q` is a root of exactly one `c` for given `u`, so that all pairs `(q, c)` form a copy of
/// the space of `q`: one piece. Loops of `c` therefore lead from any root of a generic `c` to any
/// other.
pub(crate) struct Family<G: Listing<N>, const N: usize> {
    model: G::Model<Complex<f64>>,
    /// The longest length of the linkage.
    pub(crate) size: f64,
    pub(crate) part: Part,
    solved: Solved,
    /// Of an unknown that the part needs, or of its first drive: of what the part's assemblies are a curve over.
    pub(crate) tilt: Option<Tilt<N>>,
}

/// One system of a family.
#[derive(Clone, Copy)]
pub(crate) struct Member<F, D, const N: usize> {
    /// `u`: the chassis points,
    pub(crate) fixed: F,
    /// and the drives, angles as the coordinates that they prescribe.
    pub(crate) drives: D,
    /// `c`.
    pub(crate) right: Vector<N>,
    pub(crate) plane: Plane,
}

impl<G: Listing<N>, const N: usize> Family<G, N> {
    pub(crate) fn new(model: &G::Model<f64>, part: Part, random: &mut Random) -> Self {
        let model_of_complex = G::converted(model, Complex::from);
        let of_given = part.needed.first().map(|[row, _]| *row);
        let tilted = of_given.or_else(|| driven_row::<G, N>(&model_of_complex, &part));
        let tilt = tilted.map(|row| Tilt::new(row, model.size(), random));
        Self {
            model: model_of_complex,
            size: model.size(),
            solved: Solved::of(&part.own, &part.others, tilted),
            part,
            tilt,
        }
    }

    /// The chassis points of the linkage.
    pub(crate) fn own_fixed(&self) -> Fixed<G, N> {
        *self.model.fixed()
    }

    /// Other ones anywhere near. Those of the linkage are special where axes are parallel; where they nearly are, some of the
    /// roots lie so far away that rounding hides how many there are.
    pub(crate) fn general_fixed(&self, random: &mut Random) -> Fixed<G, N> {
        let of = |point: Vector3<Complex<f64>>| point + random.vector::<3>(self.size);
        Values::from_values(self.own_fixed().values().map(of))
    }

    /// The member of which `q` is a root, otherwise as another.
    pub(crate) fn of_root(&self, q: &Vector<N>, other: MemberOf<G, N>) -> MemberOf<G, N> {
        let MemberOf::<G, N> { drives, plane, .. } = other;
        let fixed = self.model.drive_anchors(other.fixed, &drives);
        Member {
            right: self.residual(q, &fixed, &drives, plane),
            ..other
        }
    }

    /// `F(q; u)`.
    fn residual(
        &self,
        q: &Vector<N>,
        fixed: &Fixed<G, N>,
        drives: &Drives<G, N>,
        plane: Plane,
    ) -> Vector<N> {
        let mut rows = self.model.residual(q, fixed, drives);
        for &[row, column] in &self.part.others {
            rows[row] = q[column];
        }
        if let Some(tilt) = &self.tilt {
            tilt.add(plane, q, &mut rows);
        }
        rows
    }

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

    /// The derivatives of an equation, where that gives an unknown of another part.
    fn give(&self, equation: usize, jacobian: &mut SMatrix<Complex<f64>, N, N>) {
        let mut given = self.part.others.iter();
        if let Some(&[row, column]) = given.find(|[row, _]| *row == equation) {
            jacobian.row_mut(row).fill(Complex::ZERO);
            jacobian[(row, column)] = Complex::ONE;
        }
    }

    /// Rows of the part alone.
    fn own(&self, mut rows: Vector<N>) -> Vector<N> {
        for &[row, _] in &self.part.others {
            rows[row] = Complex::ZERO;
        }
        rows
    }
}

/// The parts of a model that can be put together one after another, wherever drives move the chassis' points.
pub(crate) fn parts<G: Listing<N>, const N: usize>(
    model: &G::Model<f64>,
    random: &mut Random,
) -> Vec<Part> {
    let model: G::Model<Complex<f64>> = G::converted(model, Complex::from);
    let anywhere = std::iter::repeat_with(|| random.vector::<1>(1.0).x);
    let drives = Values::from_values(anywhere.take(N));
    let fixed = model.drive_anchors(*model.fixed(), &drives);
    let anywhere = random.vector::<N>(1.0);
    let is_linear = |part: &Part| {
        let mut change = Vector::zeros();
        part.columns()
            .for_each(|column| change[column] = anywhere[column]);
        let still = Fixed::<G, N>::default();
        let curvature = model.curvature(&change, &still, &change, &still);
        part.rows().all(|row| curvature[row] == Complex::ZERO)
    };
    in_order(&model.jacobian(&anywhere, &fixed), is_linear)
}

/// The equation of a part's first drive.
fn driven_row<G: Listing<N>, const N: usize>(
    model: &G::Model<Complex<f64>>,
    part: &Part,
) -> Option<usize> {
    let nowhere = Vector::zeros();
    let still = Fixed::<G, N>::default();
    let at_rest = Drives::<G, N>::default();
    let mut rows = (0..at_rest.values().count()).filter_map(|drive| {
        let rate = at_rest.with(drive, Complex::from(1.0));
        let rate = model.drive_rate(&nowhere, &still, &still, &rate);
        part.rows().find(|row| rate[*row] != Complex::ZERO)
    });
    rows.next()
}

/// The coordinates that drives prescribe.
pub(crate) fn complex<L: Enumerable<N>, const N: usize>(
    model: &L,
    inputs: &Inputs<Still, L::Drives>,
) -> Drives<L::Listing, N> {
    let coordinates = model.coordinates(&inputs.drives).value;
    Values::from_values(coordinates.values().map(Complex::from))
}

/// Members `from + s change`, with `s` from 0 to 1.
pub(crate) struct Line<'a, G: Listing<N>, const N: usize> {
    family: &'a Family<G, N>,
    from: MemberOf<G, N>,
    change: MemberOf<G, N>,
    /// Whether it ends at the mechanism itself, of which some of the roots may be at infinity.
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
        Factors::of(&jacobian, &self.family.solved)
    }

    /// Taylor coefficients of the root, order 1 first: `F` is quadratic in `q`, `u` and the tilt together, so
    /// that one factorisation gives all of them.
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

    /// The sum of `C(a, b)` over the pairs of terms, in either order, whose orders make the next one.
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
        let pairs = 0..terms.len().div_ceil(2);
        let sum = pairs
            .map(of_pair)
            .fold(Vector::zeros(), |sum, one| sum + one);
        self.family.own(sum)
    }
}
