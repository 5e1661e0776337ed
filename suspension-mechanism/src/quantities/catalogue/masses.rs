//! What masses are at the wheels.

use crate::quantities::inert::of_wheels;
use crate::quantities::quantity::{Quantity, Shown};

catalogue! {
    EFFECTIVE_MASS: "effective mass at the wheel" {
        name: "effective_mass",
        sign: "",
        definition: "of all parts in [masses], the mass that has their kinetic energy at the height of the wheel centre, the wheel beside it \
                     at its own and the other drives held: sum (m v^2 + omega . I omega) / (dz/dt)^2; wheels that one drive moves share it",
        source: "kinetic energy; the unsprung mass as travel feels it, without what the file gives no mass",
        shown: Shown::InTables,
        read: of_wheels,
    }
}
