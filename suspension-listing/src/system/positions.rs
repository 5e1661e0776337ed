//! The positions of the points.

use super::{Point, Site, System};
use crate::form::Equations;
use crate::vector::Vector;

/// The values of the points' coordinates and of the other unknowns.
#[derive(Clone, Debug)]
pub struct Positions {
    pub fixed: Vec<Vector>,
    pub free: Vec<Vector>,
    pub scalars: Vec<f64>,
}

impl Positions {
    /// The positions of the sites of an equation.
    pub(crate) fn at_sites(&self, form: &dyn Equations) -> Vec<Vector> {
        form.sites().into_iter().map(|site| self.at(site)).collect()
    }

    pub fn at(&self, site: &Site) -> Vector {
        if site.is_free() {
            self.free[site.index]
        } else {
            self.fixed[site.index]
        }
    }
}

impl System {
    /// The design position, if the listing states all of it.
    pub fn design(&self) -> Option<Positions> {
        let stated =
            |points: &[Point]| -> Option<Vec<Vector>> { points.iter().map(|p| p.at).collect() };
        Some(self.positions(stated(&self.fixed)?, stated(&self.free)?))
    }

    /// The positions of the points, and the scalars that belong to them.
    pub fn positions(&self, fixed: Vec<Vector>, free: Vec<Vector>) -> Positions {
        let mut positions = Positions {
            fixed,
            free,
            scalars: vec![0.0; self.scalars.len()],
        };
        for equation in &self.equations {
            let form = equation.form.equations();
            let indices = form.scalars().into_iter();
            let indices: Vec<usize> = indices.filter_map(|(name, _)| self.scalar(name)).collect();
            let known: Vec<f64> = indices
                .iter()
                .map(|&index| positions.scalars[index])
                .collect();
            let values = form.scalars_at(&positions.at_sites(form), &known);
            for (index, value) in indices.into_iter().zip(values.into_iter().flatten()) {
                positions.scalars[index] = value;
            }
        }
        positions
    }
}
