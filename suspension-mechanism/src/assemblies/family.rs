//! The family of equations around those of a linkage: `F(q; u) = c` over complex numbers.

mod line;

use nalgebra::{Complex, SMatrix, Vector3};
use suspension_core::{Inputs, Linkage, Listing, Still, Values};

use crate::assemblies::factors::{Solved, Vector};
use crate::assemblies::parts::{Part, parts_in_order};
use crate::assemblies::random::Random;
use crate::assemblies::tilt::{Plane, Tilt};
use crate::mechanism::Suspension;

pub(crate) use line::Line;

/// Driven coordinates.
pub(crate) type Drives<G, const N: usize> = <G as Listing<N>>::Drives<Complex<f64>>;
/// Chassis points, including those that drives move.
pub(crate) type Fixed<G, const N: usize> = <G as Listing<N>>::Fixed<Complex<f64>>;
/// A member of the family of a listing.
pub(crate) type MemberOf<G, const N: usize> = Member<Fixed<G, N>, Drives<G, N>, N>;

/// All systems `F(q; u) = c` of one part of a linkage, with or without one tilted equation. In place of the equations
/// of other parts, their unknowns are given: `q = c`.
///
/// Each `q` is a root of exactly one `c` for given `u`, so all pairs `(q, c)` form a copy of the space of `q`, which
/// is connected. Loops of `c` therefore lead from any root of a generic `c` to any other.
pub(crate) struct Family<G: Listing<N>, const N: usize> {
    model: G::Model<Complex<f64>>,
    /// The longest length of the linkage.
    pub(crate) size: f64,
    pub(crate) part: Part,
    solved: Solved,
    /// The tilt of the equation of an unknown that the part needs, or of its first drive: the variable along which
    /// the part's assemblies form a curve.
    pub(crate) tilt: Option<Tilt<N>>,
}

/// One system of a family.
#[derive(Clone, Copy)]
pub(crate) struct Member<F, D, const N: usize> {
    /// `u`: the chassis points.
    pub(crate) fixed: F,
    /// `u`: the drives, with angles as the coordinates that they prescribe.
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
            solved: Solved::new(&part.own, &part.others, tilted),
            part,
            tilt,
        }
    }

    /// The chassis points of the linkage.
    pub(crate) fn own_fixed(&self) -> Fixed<G, N> {
        *self.model.fixed()
    }

    /// Random chassis points nearby. Those of the linkage are special if axes are parallel; if axes are nearly
    /// parallel, some of the roots are so far away that rounding hides how many there are.
    pub(crate) fn general_fixed(&self, random: &mut Random) -> Fixed<G, N> {
        let general = |point: Vector3<Complex<f64>>| point + random.vector::<3>(self.size);
        Values::from_values(self.own_fixed().values().map(general))
    }

    /// The member of which `q` is a root, otherwise equal to `other`.
    pub(crate) fn with_root(&self, q: &Vector<N>, other: MemberOf<G, N>) -> MemberOf<G, N> {
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

    /// The derivatives of an equation that gives an unknown of another part.
    fn give(&self, equation: usize, jacobian: &mut SMatrix<Complex<f64>, N, N>) {
        let mut given = self.part.others.iter();
        if let Some(&[row, column]) = given.find(|[row, _]| *row == equation) {
            jacobian.row_mut(row).fill(Complex::ZERO);
            jacobian[(row, column)] = Complex::ONE;
        }
    }

    /// The rows of the part alone.
    fn own(&self, mut rows: Vector<N>) -> Vector<N> {
        for &[row, _] in &self.part.others {
            rows[row] = Complex::ZERO;
        }
        rows
    }
}

/// The parts of a model that can be put together one after another, wherever drives move the chassis points.
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
    let jacobian = model.jacobian(&anywhere, &fixed);
    let pattern = jacobian
        .row_iter()
        .map(|row| row.iter().map(|entry| *entry != Complex::ZERO).collect());
    parts_in_order(&pattern.collect(), &is_linear)
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
pub(crate) fn complex<L: Suspension<N>, const N: usize>(
    model: &L,
    inputs: &Inputs<Still, L::Drives>,
) -> Drives<L::Listing, N> {
    let coordinates = model.coordinates(&inputs.drives).value;
    Values::from_values(coordinates.values().map(Complex::from))
}
