//! A prescribed sum of coordinates, or a prescribed scalar: `sum k x + s - drive`, or less what it is in the design; divided by
//! a scale, so that its residual is a length.

use super::{Dependence, Equations};
use crate::name::Name;
use crate::site::Site;
use crate::vector::Vector;

#[derive(Clone, Debug)]
pub struct Linear {
    /// With factors that are divided by the scale.
    pub terms: Vec<Term>,
    pub scalar: Option<Name>,
    pub prescribed: Prescribed,
    /// A power of two: 1 unless all factors are small or one is large.
    pub scale: f64,
}

impl Linear {
    /// A sum with the factors of the listing.
    pub(crate) fn sum(mut terms: Vec<Term>, prescribed: Prescribed) -> Self {
        let factors = terms.iter().map(|term| term.factor.abs());
        let scale = scale(factors.fold(0.0, f64::max));
        for term in &mut terms {
            term.factor /= scale;
        }
        Self {
            terms,
            scalar: None,
            prescribed,
            scale,
        }
    }

    /// A scalar that a drive prescribes.
    pub(crate) fn scalar(name: Name, drive: Name) -> Self {
        Self {
            terms: Vec::new(),
            scalar: Some(name),
            prescribed: Prescribed::Drive(drive),
            scale: 1.0,
        }
    }
}

/// The power of two by which the largest factor is divided to become one from 1 to 2. From a half to 2 it is fine as it is.
fn scale(largest: f64) -> f64 {
    if largest == 0.0 || (0.5..=2.0).contains(&largest) {
        return 1.0;
    }
    // Without the fraction a number is its power of two, and no logarithm is needed, which programs in C would have to link.
    const EXPONENT: u64 = !0 << (f64::MANTISSA_DIGITS - 1);
    f64::from_bits(largest.max(f64::MIN_POSITIVE).to_bits() & EXPONENT)
}

/// The source of the value of a sum.
#[derive(Clone, Debug)]
pub enum Prescribed {
    Drive(Name),
    /// The sum keeps its design value.
    Design,
}

/// A coordinate of a point, times a factor.
#[derive(Clone, Debug)]
pub struct Term {
    pub factor: f64,
    pub site: Site,
    pub axis: usize,
}

impl Equations for Linear {
    fn sites(&self) -> Vec<&Site> {
        self.terms.iter().map(|term| &term.site).collect()
    }

    fn scalars(&self) -> Vec<(&Name, Dependence)> {
        let scalar = self.scalar.iter();
        scalar.map(|name| (name, Dependence::Unit)).collect()
    }

    fn dependence(&self, _row: usize, site: usize, axis: usize) -> Dependence {
        let term = &self.terms[site];
        if term.axis != axis {
            Dependence::Never
        } else if term.factor == 1.0 {
            Dependence::Unit
        } else {
            Dependence::Any
        }
    }

    fn constants(&self, at: &[Vector]) -> Option<Vector> {
        Some(match self.prescribed {
            Prescribed::Drive(_) => [0.0; 3],
            Prescribed::Design => self.residual(&[0.0; 3], at, &[]),
        })
    }

    fn residual(&self, &[held, ..]: &Vector, at: &[Vector], scalars: &[f64]) -> Vector {
        let terms = self.terms.iter().zip(at);
        let sum: f64 = terms.map(|(term, at)| term.factor * at[term.axis]).sum();
        [sum + scalars.iter().sum::<f64>() - held, 0.0, 0.0]
    }

    fn drive(&self) -> Option<&Name> {
        match &self.prescribed {
            Prescribed::Drive(drive) => Some(drive),
            Prescribed::Design => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_scale_is_the_power_of_two_below_a_factor_far_from_1() {
        for (largest, expected) in [
            (0.0, 1.0),
            (0.5, 1.0),
            (2.0, 1.0),
            (4.0, 4.0),
            (57.3, 32.0),
            (1000.0, 512.0),
            (0.001, 0.000_976_562_5),
        ] {
            assert_eq!(scale(largest), expected, "{largest}");
        }
        for largest in [f64::MAX, f64::MIN_POSITIVE, f64::from_bits(1)] {
            let scale = scale(largest);
            assert!(
                scale.recip().recip() == scale && (largest / scale).is_finite(),
                "{largest}"
            );
        }
    }
}
