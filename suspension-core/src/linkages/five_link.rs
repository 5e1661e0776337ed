//! The five-link suspension with a rigid knuckle.

use crate::linkage;

linkage! {
    /// Five links between chassis and knuckle, the knuckle closed so that it keeps its
    /// handedness. The topology of [`attia2003`](super::attia2003) in descriptive names.
    ///
    /// Axes as ISO 8855: x forward, y left, z up.
    pub mod five_link {
        /// Chassis end of the lower leading link.
        fixed: lower_front_inner at [-1.396, -0.025, -0.082];
        /// Chassis end of the upper leading link.
        fixed: upper_front_inner at [-1.301, 0.1168, 0.106];
        /// Chassis end of the upper trailing link.
        fixed: upper_rear_inner at [-1.0941, 0.1987, 0.09];
        /// Chassis end of the lower trailing link.
        fixed: lower_rear_inner at [-0.9838, 0.2609, -0.0501];
        /// Chassis end of the track rod.
        fixed: track_rod_inner at [-1.095, 0.183, -0.0158];
        free: lower_front_outer at [-1.315, 0.400, 0.027],
              upper_front_outer at [-1.302, 0.383, 0.240],
              upper_rear_outer at [-1.270, 0.315, 0.218],
              lower_rear_outer at [-1.292, 0.309, -0.005],
              track_rod_outer at [-1.188, 0.418, 0.167];

        link lower_front: lower_front_inner -> lower_front_outer;
        link upper_front: upper_front_inner -> upper_front_outer;
        link upper_rear:  upper_rear_inner -> upper_rear_outer;
        link lower_rear:  lower_rear_inner -> lower_rear_outer;
        link track_rod:   track_rod_inner -> track_rod_outer;
        body knuckle: lower_front_outer, upper_front_outer, upper_rear_outer, lower_rear_outer,
                      track_rod_outer;

        /// Angle of the lower leading link from the vertical, radians.
        drive theta: angle(lower_front_inner -> lower_front_outer, z);

        point wheel_centre: knuckle;

        /// Height of the wheel centre.
        measure height: wheel_centre.z;

        wheel:   upper_rear_outer -> wheel_centre;
        kingpin: lower_front_outer -> upper_rear_outer;
    }
}
