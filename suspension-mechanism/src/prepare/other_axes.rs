//! The mechanism of a file in axes other than its own.

use toml::Spanned;

use crate::failure::Failure;
use crate::kinematics::Kinematics;
use crate::mechanism::Axes;
use crate::prepare::loaded::Loaded;
use crate::prepare::task::{Request, Start};

impl Loaded<'_> {
    /// As [`at_design`](Self::at_design) in other axes: points and masses are turned to them, and the statements
    /// refer to coordinates in them.
    ///
    /// # Errors
    ///
    /// As [`at_design`](Self::at_design), and [`Failure::Input`] if a statement or `[design]` means something else in
    /// other axes.
    pub fn at_design_in(&self, axes: Axes) -> Result<Box<dyn Kinematics + '_>, Failure> {
        let [from, to] = [self.axes(), axes].map(Axes::signs);
        let signs = [0, 1, 2].map(|axis| from[axis] * to[axis]);
        let refuse = |what: String| {
            let name = self.source.name();
            Failure::Input(format!("{name}: {what}; state both files in the same axes"))
        };
        let names = [self.axes(), axes].map(Axes::name);
        if let Some(statement) = self.listing().bound_to_axes(signs) {
            let [from, to] = names;
            return Err(refuse(format!(
                "`{statement}` joins coordinates, and only some of them change sign from axes {from} to {to}"
            )));
        }
        if self.file.design.is_some() && self.axes() != axes {
            let [from, to] = names;
            return Err(refuse(format!("[design] is in axes {from}, not {to}")));
        }
        let mut file = self.file.clone().turned(axes);
        let springs = file
            .springs
            .iter_mut()
            .flat_map(|table| table.get_mut().values_mut());
        for spring in springs.map(Spanned::get_mut) {
            let sign = self.listing().measure_sign(spring.along.get_ref(), signs);
            *spring.load.get_mut() *= sign;
        }
        self.listing.kinematics(Request {
            file: &file,
            ..self.request(Start::Design)
        })
    }
}
