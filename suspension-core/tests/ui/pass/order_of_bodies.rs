//! A hinge is the same in either order of its bodies, and `r#name` is the same name as `name`.
#![deny(warnings)]

use suspension_core::Linkage;

suspension_core::linkage! {
    /// The flap first.
    pub mod flap_first {
        fixed: front, rear;
        free: p, q, tip;
        body flap: p, q, tip;
        body arm: front, rear, p, q;
        drive lift: r#p.z;
        drive fold: tip.z;
    }
}

suspension_core::linkage! {
    /// The arm first, and a keyword as a name.
    pub mod arm_first {
        fixed: front, rear;
        free: p, q, r#type;
        body arm: front, rear, p, q;
        body flap: p, q, r#type;
        drive lift: p.z;
        drive fold: r#type.z;
    }
}

fn main() {
    assert_eq!(flap_first::Model::<f64>::EQUATIONS.len(), arm_first::Model::<f64>::EQUATIONS.len());
    assert_eq!(arm_first::Model::<f64>::UNKNOWNS[8], "type.z");
}
