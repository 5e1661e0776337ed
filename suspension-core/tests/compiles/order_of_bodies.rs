//! A hinge is the same in either order of its bodies, and `r#name` is the same name as `name`.

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

#[test]
fn a_hinge_is_the_same_in_either_order_of_its_bodies() {
    let (flap_first, arm_first) = (flap_first::Listing::PARTS, arm_first::Listing::PARTS);
    assert_eq!(flap_first.equations.len(), arm_first.equations.len());
    assert_eq!(arm_first.unknowns[8], "type.z");
}
