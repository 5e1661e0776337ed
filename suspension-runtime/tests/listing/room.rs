//! Listings for which the largest models have no room.

use std::fmt::Write;

use suspension_runtime::Listing;

/// A coordinate between 0 and 1 without a pattern.
fn coordinate(seed: usize) -> f64 {
    let hashed = (seed + 1).wrapping_mul(2_654_435_761) % 100_003;
    hashed as f64 / 100_003.0
}

fn at(seed: usize) -> String {
    let [x, y, z] = [0, 1, 2].map(|axis| coordinate(3 * seed + axis));
    format!("at [{x}, {y}, {z}]")
}

/// Free points on three links each, three of them on a body that carries markers.
fn listing(chassis: usize, free: usize, markers: usize) -> String {
    let mut text = String::new();
    for point in 0..chassis {
        writeln!(text, "fixed: c{point} {};", at(point)).expect("text");
    }
    for point in 0..free {
        writeln!(text, "free: p{point} {};", at(chassis + point)).expect("text");
        // The body and the drive hold what links leave free.
        let links = if point < 4 { 2 } else { 3 };
        for link in 0..links {
            let end = (3 * point + link) % chassis;
            writeln!(text, "link l{point}_{link}: c{end} -> p{point};").expect("text");
        }
    }
    writeln!(text, "body plate: p0, p1, p2;\ndrive bump: p3.z;").expect("text");
    for marker in 0..markers {
        writeln!(
            text,
            "point m{marker}: plate {};",
            at(chassis + free + marker)
        )
        .expect("text");
    }
    text
}

#[test]
fn more_points_than_a_model_has_room_for_are_refused() {
    let listing_of = |markers| Listing::parse(&listing(63, 38, markers));
    assert_eq!(listing_of(27).expect("128 points").size(), 114);
    let refused = listing_of(28).expect_err("129 points").to_string();
    let expected = "129 points; at most 128 are allowed in a listing read at run time";
    assert!(refused.contains(expected), "{refused}");
}
