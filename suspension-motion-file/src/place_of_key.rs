//! Places of keys that belong in one table of a motion file.

/// The place, in words, of a key that is no name which a listing or a file may give.
pub(crate) fn place_of_key(key: &str) -> Option<&'static str> {
    match key {
        "unit" | "angle" | "axes" | "linkage" | "listing" | "statements" => {
            Some("above the first table")
        }
        "wheel_radius" | "travel" | "rack_per_turn" | "steering_box_ratio" | "wheelbase"
        | "cg_height" | "brake_share" | "drive_share" | "brake_torque" | "drive_torque" => {
            Some("under [vehicle]")
        }
        _ => None,
    }
}

/// The same where no name stands but keys alone: drives and points may have these names elsewhere.
pub(crate) fn place_among_keys(key: &str) -> Option<&'static str> {
    match key {
        "steer" | "axle" => Some("under [vehicle]"),
        "start" | "stop" | "step" | "instants" => Some("under [time]"),
        _ => place_of_key(key),
    }
}
