//! The points of a mechanism, for any linkage.

use std::rc::Rc;

use nalgebra::Vector3;

/// All points in a list, or their rates, shared by states about one place.
pub type Points = Rc<[Vector3<f64>]>;
