//! A user's own listing: a double wishbone with rack steering.

use nalgebra::Vector3;

suspension_core::linkage! {
    /// Double wishbone. Axes as ISO 8855.
    pub(crate) mod listing {
        fixed: lower_front, lower_rear, upper_front, upper_rear, rack;
        free:  lower_ball, upper_ball, tie_ball, axle_inner, axle_outer;

        link lower_fore: lower_front -> lower_ball;
        link lower_aft:  lower_rear  -> lower_ball;
        link upper_fore: upper_front -> upper_ball;
        link upper_aft:  upper_rear  -> upper_ball;
        link tie_rod:    rack        -> tie_ball;
        body upright:    lower_ball, upper_ball, tie_ball, axle_inner, axle_outer;

        drive bump:  axle_outer.z;
        drive steer: rack.y;

        wheel:   axle_inner -> axle_outer;
        kingpin: lower_ball -> upper_ball;
    }
}

/// Points of about the size of a passenger car's, metres.
pub(crate) fn design() -> listing::Points<f64> {
    let at = Vector3::new;
    listing::Points {
        lower_front: at(0.15, 0.40, 0.18),
        lower_rear: at(-0.20, 0.42, 0.19),
        upper_front: at(0.10, 0.45, 0.55),
        upper_rear: at(-0.15, 0.48, 0.56),
        rack: at(-0.16, 0.38, 0.30),
        lower_ball: at(0.01, 0.75, 0.15),
        upper_ball: at(-0.02, 0.68, 0.56),
        tie_ball: at(-0.14, 0.74, 0.31),
        axle_inner: at(0.0, 0.66, 0.33),
        axle_outer: at(0.0, 0.76, 0.33),
    }
}
