//! Effective masses at the wheels.

use crate::quantities::quantity::{Quantity, Shown};
use crate::quantities::readings::masses::of_wheels;

catalogue! {
    EFFECTIVE_MASS: "effective mass at the wheel" {
        name: "effective_mass",
        sign: "",
        definition: "the mass that has the kinetic energy of all parts in [masses] if it moves with the height of the \
                     wheel centre: sum (m v^2 + omega . I omega) / (dz/dt)^2. The wheel beside it stays at its \
                     height, and the other drives are held; wheels that one drive moves share it",
        source: "kinetic energy; the unsprung mass as travel feels it, without what the file gives no mass",
        shown: Shown::InTables,
        read: of_wheels,
    }
}
