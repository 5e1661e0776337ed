//! Other names that authors of motion files may give to its keys.

/// Keys, each with its other names.
const OTHER_NAMES: [(&str, &[&str]); 24] = [
    ("points", &["hardpoints", "coordinates"]),
    ("drives", &["inputs", "motion"]),
    ("csv", &["file", "path"]),
    ("columns", &["headings", "headers"]),
    ("factor", &["scale", "gain"]),
    ("mean", &["center", "centre", "average"]),
    ("centre", &["center", "cg"]),
    ("moment", &["torque", "Mx", "My", "Mz"]),
    ("force", &["Fx", "Fy", "Fz"]),
    ("frequency", &["hz"]),
    ("rate", &["stiffness", "k"]),
    ("load", &["preload"]),
    ("by", &["range", "box", "limits", "bounds"]),
    ("within", &["tolerance"]),
    ("of", &["quantity"]),
    ("start", &["from", "begin"]),
    ("stop", &["to", "end"]),
    ("step", &["dt"]),
    (
        "wheel_radius",
        &[
            "radius",
            "tyre_radius",
            "tire_radius",
            "loaded_radius",
            "static_loaded_radius",
            "rolling_radius",
        ],
    ),
    ("cg_height", &["cog_height", "h_cg", "h_cog", "hcg"]),
    (
        "brake_share",
        &["brake_bias", "brake_balance", "brake_distribution"],
    ),
    ("drive_share", &["torque_split", "drive_split"]),
    ("rack_per_turn", &["c_factor", "rack_ratio"]),
    ("steering_box_ratio", &["steering_ratio"]),
];

/// Returns which of the keys that are expected has another name.
pub(crate) fn key_meant<'a>(
    name: &str,
    mut expected: impl Iterator<Item = &'a str>,
) -> Option<&'a str> {
    let is_of = |key: &str| {
        let mut rows = OTHER_NAMES.iter();
        rows.any(|(own, others)| *own == key && others.contains(&name))
    };
    expected.find(|key| is_of(key))
}
