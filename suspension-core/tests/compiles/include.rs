//! The statements of another file, included in braces and in a file.

suspension_core::linkage! {
    pub mod bars {
        mirror: left -> right;
        include left: "in_a_file.linkage" at [0.0, 0.5, 0.0];
    }
}

suspension_core::linkage! {
    pub mod include;
}

#[test]
fn each_included_listing_is_placed_at_its_offset() {
    let design = bars::Corner::<f64>::design().unwrap().points().value;
    assert_eq!(
        [design.left_p.x, design.left_p.y, design.left_p.z],
        [0.3, 0.5, 0.4]
    );
    assert_eq!([design.right_a.y, design.right_p.y], [-0.5; 2]);
    assert_eq!(
        bars::Listing::PARTS.drives,
        ["left_y", "left_z", "right_y", "right_z"]
    );
}

#[test]
fn a_file_includes_files_in_its_folder() {
    let lengths = include::Corner::<f64>::design().unwrap();
    assert_eq!(lengths.points().value.front_p.x, 1.3);
    assert_eq!(
        include::Lengths {
            front_bar: 0.5,
            stay: 0.1
        }
        .stay,
        0.1
    );
}
