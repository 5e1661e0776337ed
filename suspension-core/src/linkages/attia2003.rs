//! The five-point suspension as the paper lists it.

use crate::linkage;

linkage! {
    /// The multi-link five-point suspension of Attia 2003, equations (1.1) to (1.15) as printed:
    /// fourteen distances and the drive, points by the paper's numbers.
    ///
    /// H. A. Attia, "Kinematic Analysis of the Multi-Link Five-Point Suspension System in Point
    /// Coordinates", KSME International Journal 17(8), 2003. The nine distances of the knuckle
    /// (6 to 10) also admit mirrored knuckles; [`five_link`](super::five_link) does not.
    ///
    /// Points 8 and 11 define the spin axis, points 6 and 8 the line of the kingpin angle. The paper
    /// prints no coordinates for the wheel centre, point 11: which position it is given is up to the
    /// host. Nor does it say which way x points; here it is forward.
    pub mod attia2003 {
        fixed: p1 at [-1.396, -0.025, -0.082], p2 at [-1.301, 0.1168, 0.106],
               p3 at [-1.0941, 0.1987, 0.09], p4 at [-0.9838, 0.2609, -0.0501],
               p5 at [-1.095, 0.183, -0.0158];
        free:  p6 at [-1.315, 0.400, 0.027], p7 at [-1.302, 0.383, 0.240],
               p8 at [-1.270, 0.315, 0.218], p9 at [-1.292, 0.309, -0.005],
               p10 at [-1.188, 0.418, 0.167];

        /// Eq. (1.1)
        link d6_1: p1 -> p6;
        /// Eq. (1.2)
        link d7_2: p2 -> p7;
        /// Eq. (1.3)
        link d8_3: p3 -> p8;
        /// Eq. (1.4)
        link d9_4: p4 -> p9;
        /// Eq. (1.5)
        link d10_5: p5 -> p10;
        /// Eq. (1.6)
        link d7_6: p6 -> p7;
        /// Eq. (1.7)
        link d8_6: p6 -> p8;
        /// Eq. (1.8)
        link d9_6: p6 -> p9;
        /// Eq. (1.9)
        link d10_6: p6 -> p10;
        /// Eq. (1.10)
        link d8_7: p7 -> p8;
        /// Eq. (1.11)
        link d9_7: p7 -> p9;
        /// Eq. (1.12)
        link d10_7: p7 -> p10;
        /// Eq. (1.13)
        link d9_8: p8 -> p9;
        /// Eq. (1.14)
        link d10_8: p8 -> p10;

        /// Eq. (1.15): `z6 - z1 = d6_1 cos(theta)`.
        drive theta: angle(p1 -> p6, z);

        /// Wheel centre.
        point p11: p6, p7, p8;

        /// Height of the wheel centre.
        measure height: p11.z;

        wheel:   p8 -> p11;
        kingpin: p6 -> p8;
    }
}
