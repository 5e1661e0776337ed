//! Statements of a listing that describe another mechanism in other axes.

use suspension_listing::form::Form;
use suspension_listing::system::Quantity;

use crate::listing::Listing;

impl Listing {
    /// The first statement that describes another mechanism if the coordinates of all points are multiplied by
    /// `signs`: one that combines coordinates, in a sum or along a direction, of which some change sign and others do
    /// not.
    pub fn bound_to_axes(&self, signs: [f64; 3]) -> Option<&str> {
        let system = self.system();
        let is_bound = |factors: &mut dyn Iterator<Item = (usize, f64)>| {
            let parts = factors.filter(|(_, factor)| *factor != 0.0);
            let mut signs = parts.filter_map(|(axis, _)| signs.get(axis));
            let first = signs.next();
            signs.any(|sign| Some(sign) != first)
        };
        let of_quantity = |quantity: &Quantity| match quantity {
            Quantity::Sum(terms) => {
                is_bound(&mut terms.iter().map(|term| (term.axis, term.factor)))
            }
            Quantity::Along { direction, .. } => {
                is_bound(&mut direction.iter().copied().enumerate())
            }
            Quantity::Angle { .. } | Quantity::Between { .. } | Quantity::Length { .. } => false,
        };
        let equations = system
            .equations
            .iter()
            .filter(|equation| match &equation.form {
                Form::Linear(sum) => {
                    is_bound(&mut sum.terms.iter().map(|term| (term.axis, term.factor)))
                }
                _ => false,
            });
        let equations = equations.map(|equation| &equation.origin.statement);
        let drives = system
            .drives
            .iter()
            .filter(|drive| of_quantity(&drive.quantity));
        let measures = system
            .measures
            .iter()
            .filter(|measure| of_quantity(&measure.quantity));
        let named = drives.map(|drive| &drive.named.name);
        let named = named.chain(measures.map(|measure| &measure.named.name));
        named.chain(equations).next().map(|name| name.as_str())
    }

    /// 1 or -1: the sign of a measure's change if the coordinates of all points are multiplied by `signs`, a rotation
    /// by which no statement is [bound](Self::bound_to_axes).
    pub fn measure_sign(&self, measure: &str, signs: [f64; 3]) -> f64 {
        let mut measures = self.system().measures.iter();
        let found = measures.find(|found| found.named.name.as_str() == measure);
        let axis = found.and_then(|found| match &found.quantity {
            Quantity::Sum(terms) => terms
                .iter()
                .find(|term| term.factor != 0.0)
                .map(|term| term.axis),
            Quantity::Along { direction, .. } => direction.iter().position(|part| *part != 0.0),
            Quantity::Angle { axis, .. } => Some(*axis),
            Quantity::Between { .. } | Quantity::Length { .. } => None,
        });
        axis.and_then(|axis| signs.get(axis).copied())
            .unwrap_or(1.0)
    }
}
