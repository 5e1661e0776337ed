//! The points of a mechanism, for any linkage.

use std::rc::Rc;

use nalgebra::Vector3;

/// All points in a list, or their rates: states about one place share them.
pub type Points = Rc<[Vector3<f64>]>;
