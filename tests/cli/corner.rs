//! A double wishbone whose points tests state in other units and axes.

/// The points of a left corner with a rack, m, in ISO 8855: double_wishbone of the catalogue.
pub(crate) const POINTS: [(&str, [f64; 3]); 10] = [
    ("lower_front", [0.20, 0.35, 0.16]),
    ("lower_rear", [-0.20, 0.35, 0.16]),
    ("upper_front", [0.15, 0.42, 0.42]),
    ("upper_rear", [-0.15, 0.42, 0.42]),
    ("rack", [0.11, 0.34, 0.20]),
    ("lower_ball", [0.005, 0.70, 0.17]),
    ("upper_ball", [-0.015, 0.66, 0.44]),
    ("tie_ball", [0.12, 0.68, 0.21]),
    ("wheel_centre", [0.0, 0.75, 0.30]),
    ("axle", [0.0, 0.65, 0.30]),
];
