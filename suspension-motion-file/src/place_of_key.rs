//! The tables in which reserved keys of a motion file belong.

/// Says where a key belongs that listings and files may not use as a name.
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

/// Says where a key belongs in a table that has no names, only keys: elsewhere drives and points may use it as a name.
pub(crate) fn place_among_keys(key: &str) -> Option<&'static str> {
    match key {
        "steer" | "axle" => Some("under [vehicle]"),
        "start" | "stop" | "step" | "instants" => Some("under [time]"),
        _ => place_of_key(key),
    }
}
