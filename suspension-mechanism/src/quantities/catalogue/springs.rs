//! The effects of springs and anti-roll bars at the wheels.

use crate::file::Dimension;
use crate::quantities::quantity::{Quantity, Shown};
use crate::quantities::readings::springs::{of_springs, of_wheels};

catalogue! {
    SPRING_FORCES: "forces and moments of springs" {
        name: "",
        sign: "positive where a spring makes its measure larger",
        definition: "the force of each spring or bar of the file under its name, such as spring_force_N, or its \
                     moment in an angle, such as bar_moment_Nm: F = load - rate (s - s_design) in its measure s",
        source: "[springs] of the file",
        shown: Shown::InTables,
        read: of_springs,
    }
    SPRING_LOAD: "load on the springs at the wheel" {
        name: "spring_load",
        sign: "positive where springs press the wheel down",
        definition: "the vertical force at the wheel centre that all springs of the file bear, the wheel beside it \
                     held at its height and the other drives held: -sum F ds/dz in their measures s, F = load - rate \
                     (s - s_design). Wheels that one drive moves share it",
        source: "virtual work",
        shown: Shown::InTables,
        read: |names| of_wheels(names, Dimension::Force, |sprung| sprung.force),
    }
    WHEEL_RATE: "wheel rate" {
        name: "wheel_rate",
        sign: "positive where the springs push back",
        definition: "the derivative of spring_load with respect to the height of the wheel centre, the other drives \
                     held: sum rate (ds/dz)^2 - F d2s/dz2. It includes an anti-roll bar, because the other wheel is \
                     held: see heave_rate",
        source: "Milliken 1995, chapter 16, with the change of the motion ratio",
        shown: Shown::InTables,
        read: |names| of_wheels(names, Dimension::Stiffness, |sprung| sprung.rate),
    }
}
