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
///
/// 15 unknowns `q`: the coordinates of `p6`, `p7`, `p8`, `p9`, `p10`.
///
/// 15 equations `F(q) = 0`: `d6_1`, `d7_2`, `d8_3`, `d9_4`, `d10_5`, `d7_6`, `d8_6`, `d9_6`, `d10_6`, `d8_7`, `d9_7`, `d10_7`, `d9_8`, `d10_8`, `theta`.
///
/// Jacobian: 15 x 15, 70 non-zeros of 225; 78 are stored of its factors. The longest chain of operations in the factorisation is 33, a division counted as 4; in a solution it is 14.
///
/// | no branch | multiplications | additions | divisions |
/// |---|---|---|---|
/// | residual | 98 | 86 | 0 |
/// | Jacobian | 42 | 42 | 0 |
/// | curvature | 56 | 112 | 0 |
/// | factor | 200 | 118 | 14 |
/// | solve | 78 | 64 | 0 |
#[allow(dead_code, non_snake_case, unreachable_pub)]
pub mod attia2003 {
    use ::suspension_core::generated::*;
    /// Every point, with a position, velocity or acceleration each.
    #[derive(Clone, Copy, Debug, PartialEq, Named)]
    pub struct Points<T> {
        /// Chassis point `p1`.
        pub p1: Vector3<T>,
        /// Chassis point `p2`.
        pub p2: Vector3<T>,
        /// Chassis point `p3`.
        pub p3: Vector3<T>,
        /// Chassis point `p4`.
        pub p4: Vector3<T>,
        /// Chassis point `p5`.
        pub p5: Vector3<T>,
        /// Free point `p6`.
        pub p6: Vector3<T>,
        /// Free point `p7`.
        pub p7: Vector3<T>,
        /// Free point `p8`.
        pub p8: Vector3<T>,
        /// Free point `p9`.
        pub p9: Vector3<T>,
        /// Free point `p10`.
        pub p10: Vector3<T>,
        /// Wheel centre.
        pub p11: Vector3<T>,
    }

    /// Chassis points.
    #[derive(Clone, Copy, Debug, PartialEq, Named)]
    pub struct Fixed<T> {
        /// Chassis point `p1`.
        pub p1: Vector3<T>,
        /// Chassis point `p2`.
        pub p2: Vector3<T>,
        /// Chassis point `p3`.
        pub p3: Vector3<T>,
        /// Chassis point `p4`.
        pub p4: Vector3<T>,
        /// Chassis point `p5`.
        pub p5: Vector3<T>,
    }

    /// The drives' values, or rates: coordinates in the unit of the points, angles in radians.
    #[derive(Clone, Copy, Debug, PartialEq, Named)]
    pub struct Drives<T> {
        /// Eq. (1.15): `z6 - z1 = d6_1 cos(theta)`.
        pub theta: T,
    }

    /// What is measured, or its rates: coordinates and lengths in the unit of the points, angles in radians.
    #[derive(Clone, Copy, Debug, PartialEq, Named)]
    pub struct Measures<T> {
        /// Height of the wheel centre.
        pub height: T,
    }

    /// The constant lengths of links and bodies.
    #[derive(Clone, Copy, Debug, PartialEq, Named)]
    pub struct Lengths<T> {
        /// Eq. (1.1)
        pub d6_1: T,
        /// Eq. (1.2)
        pub d7_2: T,
        /// Eq. (1.3)
        pub d8_3: T,
        /// Eq. (1.4)
        pub d9_4: T,
        /// Eq. (1.5)
        pub d10_5: T,
        /// Eq. (1.6)
        pub d7_6: T,
        /// Eq. (1.7)
        pub d8_6: T,
        /// Eq. (1.8)
        pub d9_6: T,
        /// Eq. (1.9)
        pub d10_6: T,
        /// Eq. (1.10)
        pub d8_7: T,
        /// Eq. (1.11)
        pub d9_7: T,
        /// Eq. (1.12)
        pub d10_7: T,
        /// Eq. (1.13)
        pub d9_8: T,
        /// Eq. (1.14)
        pub d10_8: T,
    }

    impl<T: Scalar> Points<T> {
        #[inline(always)]
        fn all(fixed: &Fixed<T>, free: &Free<T>, markers: [Vector3<T>; 1]) -> Self {
            Self {
                p1: fixed.p1,
                p2: fixed.p2,
                p3: fixed.p3,
                p4: fixed.p4,
                p5: fixed.p5,
                p6: free.p6,
                p7: free.p7,
                p8: free.p8,
                p9: free.p9,
                p10: free.p10,
                p11: markers[0],
            }
        }

        #[inline(always)]
        fn p6_p7_p8_frame(&self) -> Frame<T> {
            Frame::new(self.p6, self.p7, self.p8)
        }
    }

    /// The free points: the unknowns under their names.
    #[derive(Clone, Copy, Debug, PartialEq)]
    struct Free<T> {
        p6: Vector3<T>,
        p7: Vector3<T>,
        p8: Vector3<T>,
        p9: Vector3<T>,
        p10: Vector3<T>,
    }

    impl<T: Scalar> Free<T> {
        #[inline(always)]
        fn of(q: &SVector<T, 15>) -> Self {
            let [[p6_x, p6_y, p6_z, p7_x, p7_y, p7_z, p8_x, p8_y, p8_z, p9_x, p9_y, p9_z,
            p10_x, p10_y, p10_z]] = q.data.0;
            Self {
                p6: Vector3::new(p6_x, p6_y, p6_z),
                p7: Vector3::new(p7_x, p7_y, p7_z),
                p8: Vector3::new(p8_x, p8_y, p8_z),
                p9: Vector3::new(p9_x, p9_y, p9_z),
                p10: Vector3::new(p10_x, p10_y, p10_z),
            }
        }

        #[inline(always)]
        fn unknowns(&self) -> SVector<T, 15> {
            let Self { p6, p7, p8, p9, p10 } = self;
            SVector::from([
                p6.x,
                p6.y,
                p6.z,
                p7.x,
                p7.y,
                p7.z,
                p8.x,
                p8.y,
                p8.z,
                p9.x,
                p9.y,
                p9.z,
                p10.x,
                p10.y,
                p10.z,
            ])
        }

        #[inline(always)]
        fn p6_p7_p8_frame(&self) -> Frame<T> {
            Frame::new(self.p6, self.p7, self.p8)
        }
    }

    /// The geometry: chassis points at rest and the constants of every equation.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Model<T> {
        fixed: Fixed<T>,
        size: T,
        d6_1: Distance<T>,
        d7_2: Distance<T>,
        d8_3: Distance<T>,
        d9_4: Distance<T>,
        d10_5: Distance<T>,
        d7_6: Distance<T>,
        d8_6: Distance<T>,
        d9_6: Distance<T>,
        d10_6: Distance<T>,
        d8_7: Distance<T>,
        d9_7: Distance<T>,
        d10_7: Distance<T>,
        d9_8: Distance<T>,
        d10_8: Distance<T>,
        p11: Carried<T>,
        p6_p7_p8_frame: Frame<T>,
        p6_p7_p8_p9: Linked<T>,
        p6_p7_p8_p10: Linked<T>,
    }

    /// A suspension of this listing that moves.
    pub type Corner<T = f64> = corner::Corner<Model<T>, 15>;
    /// Rows of the residual and the Jacobian.
    #[allow(missing_docs)]
    pub mod equation {
        pub const D6_1: usize = 0;
        pub const D7_2: usize = 1;
        pub const D8_3: usize = 2;
        pub const D9_4: usize = 3;
        pub const D10_5: usize = 4;
        pub const D7_6: usize = 5;
        pub const D8_6: usize = 6;
        pub const D9_6: usize = 7;
        pub const D10_6: usize = 8;
        pub const D8_7: usize = 9;
        pub const D9_7: usize = 10;
        pub const D10_7: usize = 11;
        pub const D9_8: usize = 12;
        pub const D10_8: usize = 13;
        pub const THETA: usize = 14;
    }

    /// Entries of `q`, columns of the Jacobian.
    #[allow(missing_docs)]
    pub mod unknown {
        pub const P6_X: usize = 0;
        pub const P6_Y: usize = 1;
        pub const P6_Z: usize = 2;
        pub const P7_X: usize = 3;
        pub const P7_Y: usize = 4;
        pub const P7_Z: usize = 5;
        pub const P8_X: usize = 6;
        pub const P8_Y: usize = 7;
        pub const P8_Z: usize = 8;
        pub const P9_X: usize = 9;
        pub const P9_Y: usize = 10;
        pub const P9_Z: usize = 11;
        pub const P10_X: usize = 12;
        pub const P10_Y: usize = 13;
        pub const P10_Z: usize = 14;
    }

    impl<T: Scalar> Linkage<15> for Model<T> {
        type Scalar = T;
        type Listing = Listing;
        type Fixed = Fixed<T>;
        type Drives = Drives<T>;
        type Measures = Measures<T>;
        type Points = Points<T>;
        type Factors = Factors<T>;
        #[inline(always)]
        fn linked(&self) -> impl Iterator<Item = usize> {
            [8, 9].into_iter()
        }

        fn listing(&self) -> Listing {
            Listing
        }

        fn fixed(&self) -> &Fixed<T> {
            &self.fixed
        }

        fn size(&self) -> T {
            self.size
        }

        #[inline(always)]
        fn coordinates(&self, drives: &Signal<Drives<T>>) -> Signal<Drives<T>> {
            let mut coordinates = *drives;
            let angle = drives.map(|drives| drives.theta);
            let coordinate = angle_to_coordinate(self.d6_1.length(), angle);
            coordinates.set(coordinate, |drives| &mut drives.theta);
            coordinates
        }

        #[inline(always)]
        fn drive_anchors(&self, fixed: Fixed<T>, _drives: &Drives<T>) -> Fixed<T> {
            fixed
        }

        #[cfg_attr(not(debug_assertions), inline(always))]
        fn residual(
            &self,
            q: &SVector<T, 15>,
            fixed: &Fixed<T>,
            drives: &Drives<T>,
        ) -> SVector<T, 15> {
            let free = Free::of(q);
            let mut rows = [-T::zero(); 15];
            rows[equation::D6_1] = self.d6_1.residual(difference(free.p6, fixed.p1));
            rows[equation::D7_2] = self.d7_2.residual(difference(free.p7, fixed.p2));
            rows[equation::D8_3] = self.d8_3.residual(difference(free.p8, fixed.p3));
            rows[equation::D9_4] = self.d9_4.residual(difference(free.p9, fixed.p4));
            rows[equation::D10_5] = self.d10_5.residual(difference(free.p10, fixed.p5));
            rows[equation::D7_6] = self.d7_6.residual(difference(free.p7, free.p6));
            rows[equation::D8_6] = self.d8_6.residual(difference(free.p8, free.p6));
            rows[equation::D9_6] = self.d9_6.residual(difference(free.p9, free.p6));
            rows[equation::D10_6] = self.d10_6.residual(difference(free.p10, free.p6));
            rows[equation::D8_7] = self.d8_7.residual(difference(free.p8, free.p7));
            rows[equation::D9_7] = self.d9_7.residual(difference(free.p9, free.p7));
            rows[equation::D10_7] = self.d10_7.residual(difference(free.p10, free.p7));
            rows[equation::D9_8] = self.d9_8.residual(difference(free.p9, free.p8));
            rows[equation::D10_8] = self.d10_8.residual(difference(free.p10, free.p8));
            rows[equation::THETA] = free.p6.z - fixed.p1.z - drives.theta;
            SVector::from(rows)
        }

        #[cfg_attr(not(debug_assertions), inline(always))]
        fn jacobian(&self, q: &SVector<T, 15>, fixed: &Fixed<T>) -> SMatrix<T, 15, 15> {
            let free = Free::of(q);
            let mut columns = [[T::zero(); 15]; 15];
            let gradient = self.d6_1.gradient(difference(free.p6, fixed.p1));
            columns[unknown::P6_X][equation::D6_1] = gradient.x;
            columns[unknown::P6_Y][equation::D6_1] = gradient.y;
            columns[unknown::P6_Z][equation::D6_1] = gradient.z;
            let gradient = self.d7_2.gradient(difference(free.p7, fixed.p2));
            columns[unknown::P7_X][equation::D7_2] = gradient.x;
            columns[unknown::P7_Y][equation::D7_2] = gradient.y;
            columns[unknown::P7_Z][equation::D7_2] = gradient.z;
            let gradient = self.d8_3.gradient(difference(free.p8, fixed.p3));
            columns[unknown::P8_X][equation::D8_3] = gradient.x;
            columns[unknown::P8_Y][equation::D8_3] = gradient.y;
            columns[unknown::P8_Z][equation::D8_3] = gradient.z;
            let gradient = self.d9_4.gradient(difference(free.p9, fixed.p4));
            columns[unknown::P9_X][equation::D9_4] = gradient.x;
            columns[unknown::P9_Y][equation::D9_4] = gradient.y;
            columns[unknown::P9_Z][equation::D9_4] = gradient.z;
            let gradient = self.d10_5.gradient(difference(free.p10, fixed.p5));
            columns[unknown::P10_X][equation::D10_5] = gradient.x;
            columns[unknown::P10_Y][equation::D10_5] = gradient.y;
            columns[unknown::P10_Z][equation::D10_5] = gradient.z;
            let gradient = self.d7_6.gradient(difference(free.p7, free.p6));
            columns[unknown::P7_X][equation::D7_6] = gradient.x;
            columns[unknown::P7_Y][equation::D7_6] = gradient.y;
            columns[unknown::P7_Z][equation::D7_6] = gradient.z;
            columns[unknown::P6_X][equation::D7_6] = -gradient.x;
            columns[unknown::P6_Y][equation::D7_6] = -gradient.y;
            columns[unknown::P6_Z][equation::D7_6] = -gradient.z;
            let gradient = self.d8_6.gradient(difference(free.p8, free.p6));
            columns[unknown::P8_X][equation::D8_6] = gradient.x;
            columns[unknown::P8_Y][equation::D8_6] = gradient.y;
            columns[unknown::P8_Z][equation::D8_6] = gradient.z;
            columns[unknown::P6_X][equation::D8_6] = -gradient.x;
            columns[unknown::P6_Y][equation::D8_6] = -gradient.y;
            columns[unknown::P6_Z][equation::D8_6] = -gradient.z;
            let gradient = self.d9_6.gradient(difference(free.p9, free.p6));
            columns[unknown::P9_X][equation::D9_6] = gradient.x;
            columns[unknown::P9_Y][equation::D9_6] = gradient.y;
            columns[unknown::P9_Z][equation::D9_6] = gradient.z;
            columns[unknown::P6_X][equation::D9_6] = -gradient.x;
            columns[unknown::P6_Y][equation::D9_6] = -gradient.y;
            columns[unknown::P6_Z][equation::D9_6] = -gradient.z;
            let gradient = self.d10_6.gradient(difference(free.p10, free.p6));
            columns[unknown::P10_X][equation::D10_6] = gradient.x;
            columns[unknown::P10_Y][equation::D10_6] = gradient.y;
            columns[unknown::P10_Z][equation::D10_6] = gradient.z;
            columns[unknown::P6_X][equation::D10_6] = -gradient.x;
            columns[unknown::P6_Y][equation::D10_6] = -gradient.y;
            columns[unknown::P6_Z][equation::D10_6] = -gradient.z;
            let gradient = self.d8_7.gradient(difference(free.p8, free.p7));
            columns[unknown::P8_X][equation::D8_7] = gradient.x;
            columns[unknown::P8_Y][equation::D8_7] = gradient.y;
            columns[unknown::P8_Z][equation::D8_7] = gradient.z;
            columns[unknown::P7_X][equation::D8_7] = -gradient.x;
            columns[unknown::P7_Y][equation::D8_7] = -gradient.y;
            columns[unknown::P7_Z][equation::D8_7] = -gradient.z;
            let gradient = self.d9_7.gradient(difference(free.p9, free.p7));
            columns[unknown::P9_X][equation::D9_7] = gradient.x;
            columns[unknown::P9_Y][equation::D9_7] = gradient.y;
            columns[unknown::P9_Z][equation::D9_7] = gradient.z;
            columns[unknown::P7_X][equation::D9_7] = -gradient.x;
            columns[unknown::P7_Y][equation::D9_7] = -gradient.y;
            columns[unknown::P7_Z][equation::D9_7] = -gradient.z;
            let gradient = self.d10_7.gradient(difference(free.p10, free.p7));
            columns[unknown::P10_X][equation::D10_7] = gradient.x;
            columns[unknown::P10_Y][equation::D10_7] = gradient.y;
            columns[unknown::P10_Z][equation::D10_7] = gradient.z;
            columns[unknown::P7_X][equation::D10_7] = -gradient.x;
            columns[unknown::P7_Y][equation::D10_7] = -gradient.y;
            columns[unknown::P7_Z][equation::D10_7] = -gradient.z;
            let gradient = self.d9_8.gradient(difference(free.p9, free.p8));
            columns[unknown::P9_X][equation::D9_8] = gradient.x;
            columns[unknown::P9_Y][equation::D9_8] = gradient.y;
            columns[unknown::P9_Z][equation::D9_8] = gradient.z;
            columns[unknown::P8_X][equation::D9_8] = -gradient.x;
            columns[unknown::P8_Y][equation::D9_8] = -gradient.y;
            columns[unknown::P8_Z][equation::D9_8] = -gradient.z;
            let gradient = self.d10_8.gradient(difference(free.p10, free.p8));
            columns[unknown::P10_X][equation::D10_8] = gradient.x;
            columns[unknown::P10_Y][equation::D10_8] = gradient.y;
            columns[unknown::P10_Z][equation::D10_8] = gradient.z;
            columns[unknown::P8_X][equation::D10_8] = -gradient.x;
            columns[unknown::P8_Y][equation::D10_8] = -gradient.y;
            columns[unknown::P8_Z][equation::D10_8] = -gradient.z;
            columns[unknown::P6_Z][equation::THETA] = T::one();
            from_columns(columns)
        }

        fn pivots(&self) -> &[[usize; 2]] {
            &[
                [equation::THETA, unknown::P6_Z],
                [equation::D6_1, unknown::P6_Y],
                [equation::D10_6, unknown::P10_Z],
                [equation::D8_3, unknown::P8_X],
                [equation::D9_4, unknown::P9_X],
                [equation::D9_6, unknown::P9_Z],
                [equation::D10_5, unknown::P10_Y],
                [equation::D7_6, unknown::P7_Z],
                [equation::D7_2, unknown::P7_Y],
                [equation::D8_6, unknown::P8_Z],
                [equation::D9_7, unknown::P9_Y],
                [equation::D10_7, unknown::P10_X],
                [equation::D10_8, unknown::P8_Y],
                [equation::D9_8, unknown::P7_X],
                [equation::D8_7, unknown::P6_X],
            ]
        }

        #[cfg_attr(not(debug_assertions), inline(always))]
        fn factor(&self, q: &SVector<T, 15>, fixed: &Fixed<T>) -> Factors<T> {
            let free = Free::of(q);
            let gradient = self.d6_1.gradient(difference(free.p6, fixed.p1));
            let d6_1_by_p6_x = gradient.x;
            let d6_1_by_p6_y = gradient.y;
            let d6_1_by_p6_z = gradient.z;
            let gradient = self.d7_2.gradient(difference(free.p7, fixed.p2));
            let d7_2_by_p7_x = gradient.x;
            let d7_2_by_p7_y = gradient.y;
            let d7_2_by_p7_z = gradient.z;
            let gradient = self.d8_3.gradient(difference(free.p8, fixed.p3));
            let d8_3_by_p8_x = gradient.x;
            let d8_3_by_p8_y = gradient.y;
            let d8_3_by_p8_z = gradient.z;
            let gradient = self.d9_4.gradient(difference(free.p9, fixed.p4));
            let d9_4_by_p9_x = gradient.x;
            let d9_4_by_p9_y = gradient.y;
            let d9_4_by_p9_z = gradient.z;
            let gradient = self.d10_5.gradient(difference(free.p10, fixed.p5));
            let d10_5_by_p10_x = gradient.x;
            let d10_5_by_p10_y = gradient.y;
            let d10_5_by_p10_z = gradient.z;
            let gradient = self.d7_6.gradient(difference(free.p7, free.p6));
            let d7_6_by_p7_x = gradient.x;
            let d7_6_by_p7_y = gradient.y;
            let d7_6_by_p7_z = gradient.z;
            let d7_6_by_p6_x = -gradient.x;
            let d7_6_by_p6_y = -gradient.y;
            let d7_6_by_p6_z = -gradient.z;
            let gradient = self.d8_6.gradient(difference(free.p8, free.p6));
            let d8_6_by_p8_x = gradient.x;
            let d8_6_by_p8_y = gradient.y;
            let d8_6_by_p8_z = gradient.z;
            let d8_6_by_p6_x = -gradient.x;
            let d8_6_by_p6_y = -gradient.y;
            let d8_6_by_p6_z = -gradient.z;
            let gradient = self.d9_6.gradient(difference(free.p9, free.p6));
            let d9_6_by_p9_x = gradient.x;
            let d9_6_by_p9_y = gradient.y;
            let d9_6_by_p9_z = gradient.z;
            let d9_6_by_p6_x = -gradient.x;
            let d9_6_by_p6_y = -gradient.y;
            let d9_6_by_p6_z = -gradient.z;
            let gradient = self.d10_6.gradient(difference(free.p10, free.p6));
            let d10_6_by_p10_x = gradient.x;
            let d10_6_by_p10_y = gradient.y;
            let d10_6_by_p10_z = gradient.z;
            let d10_6_by_p6_x = -gradient.x;
            let d10_6_by_p6_y = -gradient.y;
            let d10_6_by_p6_z = -gradient.z;
            let gradient = self.d8_7.gradient(difference(free.p8, free.p7));
            let d8_7_by_p8_x = gradient.x;
            let d8_7_by_p8_y = gradient.y;
            let d8_7_by_p8_z = gradient.z;
            let d8_7_by_p7_x = -gradient.x;
            let d8_7_by_p7_y = -gradient.y;
            let d8_7_by_p7_z = -gradient.z;
            let gradient = self.d9_7.gradient(difference(free.p9, free.p7));
            let d9_7_by_p9_x = gradient.x;
            let d9_7_by_p9_y = gradient.y;
            let d9_7_by_p9_z = gradient.z;
            let d9_7_by_p7_x = -gradient.x;
            let d9_7_by_p7_y = -gradient.y;
            let d9_7_by_p7_z = -gradient.z;
            let gradient = self.d10_7.gradient(difference(free.p10, free.p7));
            let d10_7_by_p10_x = gradient.x;
            let d10_7_by_p10_y = gradient.y;
            let d10_7_by_p10_z = gradient.z;
            let d10_7_by_p7_x = -gradient.x;
            let d10_7_by_p7_y = -gradient.y;
            let d10_7_by_p7_z = -gradient.z;
            let gradient = self.d9_8.gradient(difference(free.p9, free.p8));
            let d9_8_by_p9_x = gradient.x;
            let d9_8_by_p9_y = gradient.y;
            let d9_8_by_p9_z = gradient.z;
            let d9_8_by_p8_x = -gradient.x;
            let d9_8_by_p8_y = -gradient.y;
            let d9_8_by_p8_z = -gradient.z;
            let gradient = self.d10_8.gradient(difference(free.p10, free.p8));
            let d10_8_by_p10_x = gradient.x;
            let d10_8_by_p10_y = gradient.y;
            let d10_8_by_p10_z = gradient.z;
            let d10_8_by_p8_x = -gradient.x;
            let d10_8_by_p8_y = -gradient.y;
            let d10_8_by_p8_z = -gradient.z;
            let d6_1_by_p6_y = T::one() / d6_1_by_p6_y;
            let d7_6_by_p6_y = d7_6_by_p6_y * d6_1_by_p6_y;
            let d7_6_by_p6_x = d7_6_by_p6_x.minus_product(d7_6_by_p6_y, d6_1_by_p6_x);
            let d8_6_by_p6_y = d8_6_by_p6_y * d6_1_by_p6_y;
            let d8_6_by_p6_x = d8_6_by_p6_x.minus_product(d8_6_by_p6_y, d6_1_by_p6_x);
            let d9_6_by_p6_y = d9_6_by_p6_y * d6_1_by_p6_y;
            let d9_6_by_p6_x = d9_6_by_p6_x.minus_product(d9_6_by_p6_y, d6_1_by_p6_x);
            let d10_6_by_p6_y = d10_6_by_p6_y * d6_1_by_p6_y;
            let d10_6_by_p6_x = d10_6_by_p6_x.minus_product(d10_6_by_p6_y, d6_1_by_p6_x);
            let d6_1_by_p6_x = d6_1_by_p6_x * d6_1_by_p6_y;
            let d10_6_by_p10_z = T::one() / d10_6_by_p10_z;
            let d10_5_by_p10_z = d10_5_by_p10_z * d10_6_by_p10_z;
            let d10_5_by_p6_x = -(d10_5_by_p10_z * d10_6_by_p6_x);
            let d10_5_by_p10_x = d10_5_by_p10_x
                .minus_product(d10_5_by_p10_z, d10_6_by_p10_x);
            let d10_5_by_p10_y = d10_5_by_p10_y
                .minus_product(d10_5_by_p10_z, d10_6_by_p10_y);
            let d10_7_by_p10_z = d10_7_by_p10_z * d10_6_by_p10_z;
            let d10_7_by_p6_x = -(d10_7_by_p10_z * d10_6_by_p6_x);
            let d10_7_by_p10_x = d10_7_by_p10_x
                .minus_product(d10_7_by_p10_z, d10_6_by_p10_x);
            let d10_7_by_p10_y = d10_7_by_p10_y
                .minus_product(d10_7_by_p10_z, d10_6_by_p10_y);
            let d10_8_by_p10_z = d10_8_by_p10_z * d10_6_by_p10_z;
            let d10_8_by_p6_x = -(d10_8_by_p10_z * d10_6_by_p6_x);
            let d10_8_by_p10_x = d10_8_by_p10_x
                .minus_product(d10_8_by_p10_z, d10_6_by_p10_x);
            let d10_8_by_p10_y = d10_8_by_p10_y
                .minus_product(d10_8_by_p10_z, d10_6_by_p10_y);
            let d10_6_by_p6_x = d10_6_by_p6_x * d10_6_by_p10_z;
            let d10_6_by_p10_x = d10_6_by_p10_x * d10_6_by_p10_z;
            let d10_6_by_p10_y = d10_6_by_p10_y * d10_6_by_p10_z;
            let d8_3_by_p8_x = T::one() / d8_3_by_p8_x;
            let d8_6_by_p8_x = d8_6_by_p8_x * d8_3_by_p8_x;
            let d8_6_by_p8_y = d8_6_by_p8_y.minus_product(d8_6_by_p8_x, d8_3_by_p8_y);
            let d8_6_by_p8_z = d8_6_by_p8_z.minus_product(d8_6_by_p8_x, d8_3_by_p8_z);
            let d8_7_by_p8_x = d8_7_by_p8_x * d8_3_by_p8_x;
            let d8_7_by_p8_y = d8_7_by_p8_y.minus_product(d8_7_by_p8_x, d8_3_by_p8_y);
            let d8_7_by_p8_z = d8_7_by_p8_z.minus_product(d8_7_by_p8_x, d8_3_by_p8_z);
            let d9_8_by_p8_x = d9_8_by_p8_x * d8_3_by_p8_x;
            let d9_8_by_p8_y = d9_8_by_p8_y.minus_product(d9_8_by_p8_x, d8_3_by_p8_y);
            let d9_8_by_p8_z = d9_8_by_p8_z.minus_product(d9_8_by_p8_x, d8_3_by_p8_z);
            let d10_8_by_p8_x = d10_8_by_p8_x * d8_3_by_p8_x;
            let d10_8_by_p8_y = d10_8_by_p8_y.minus_product(d10_8_by_p8_x, d8_3_by_p8_y);
            let d10_8_by_p8_z = d10_8_by_p8_z.minus_product(d10_8_by_p8_x, d8_3_by_p8_z);
            let d8_3_by_p8_y = d8_3_by_p8_y * d8_3_by_p8_x;
            let d8_3_by_p8_z = d8_3_by_p8_z * d8_3_by_p8_x;
            let d9_4_by_p9_x = T::one() / d9_4_by_p9_x;
            let d9_6_by_p9_x = d9_6_by_p9_x * d9_4_by_p9_x;
            let d9_6_by_p9_y = d9_6_by_p9_y.minus_product(d9_6_by_p9_x, d9_4_by_p9_y);
            let d9_6_by_p9_z = d9_6_by_p9_z.minus_product(d9_6_by_p9_x, d9_4_by_p9_z);
            let d9_7_by_p9_x = d9_7_by_p9_x * d9_4_by_p9_x;
            let d9_7_by_p9_y = d9_7_by_p9_y.minus_product(d9_7_by_p9_x, d9_4_by_p9_y);
            let d9_7_by_p9_z = d9_7_by_p9_z.minus_product(d9_7_by_p9_x, d9_4_by_p9_z);
            let d9_8_by_p9_x = d9_8_by_p9_x * d9_4_by_p9_x;
            let d9_8_by_p9_y = d9_8_by_p9_y.minus_product(d9_8_by_p9_x, d9_4_by_p9_y);
            let d9_8_by_p9_z = d9_8_by_p9_z.minus_product(d9_8_by_p9_x, d9_4_by_p9_z);
            let d9_4_by_p9_y = d9_4_by_p9_y * d9_4_by_p9_x;
            let d9_4_by_p9_z = d9_4_by_p9_z * d9_4_by_p9_x;
            let d9_6_by_p9_z = T::one() / d9_6_by_p9_z;
            let d9_7_by_p9_z = d9_7_by_p9_z * d9_6_by_p9_z;
            let d9_7_by_p6_x = -(d9_7_by_p9_z * d9_6_by_p6_x);
            let d9_7_by_p9_y = d9_7_by_p9_y.minus_product(d9_7_by_p9_z, d9_6_by_p9_y);
            let d9_8_by_p9_z = d9_8_by_p9_z * d9_6_by_p9_z;
            let d9_8_by_p6_x = -(d9_8_by_p9_z * d9_6_by_p6_x);
            let d9_8_by_p9_y = d9_8_by_p9_y.minus_product(d9_8_by_p9_z, d9_6_by_p9_y);
            let d9_6_by_p6_x = d9_6_by_p6_x * d9_6_by_p9_z;
            let d9_6_by_p9_y = d9_6_by_p9_y * d9_6_by_p9_z;
            let d10_5_by_p10_y = T::one() / d10_5_by_p10_y;
            let d10_7_by_p10_y = d10_7_by_p10_y * d10_5_by_p10_y;
            let d10_7_by_p6_x = d10_7_by_p6_x
                .minus_product(d10_7_by_p10_y, d10_5_by_p6_x);
            let d10_7_by_p10_x = d10_7_by_p10_x
                .minus_product(d10_7_by_p10_y, d10_5_by_p10_x);
            let d10_8_by_p10_y = d10_8_by_p10_y * d10_5_by_p10_y;
            let d10_8_by_p6_x = d10_8_by_p6_x
                .minus_product(d10_8_by_p10_y, d10_5_by_p6_x);
            let d10_8_by_p10_x = d10_8_by_p10_x
                .minus_product(d10_8_by_p10_y, d10_5_by_p10_x);
            let d10_5_by_p6_x = d10_5_by_p6_x * d10_5_by_p10_y;
            let d10_5_by_p10_x = d10_5_by_p10_x * d10_5_by_p10_y;
            let d7_6_by_p7_z = T::one() / d7_6_by_p7_z;
            let d7_2_by_p7_z = d7_2_by_p7_z * d7_6_by_p7_z;
            let d7_2_by_p6_x = -(d7_2_by_p7_z * d7_6_by_p6_x);
            let d7_2_by_p7_x = d7_2_by_p7_x.minus_product(d7_2_by_p7_z, d7_6_by_p7_x);
            let d7_2_by_p7_y = d7_2_by_p7_y.minus_product(d7_2_by_p7_z, d7_6_by_p7_y);
            let d8_7_by_p7_z = d8_7_by_p7_z * d7_6_by_p7_z;
            let d8_7_by_p6_x = -(d8_7_by_p7_z * d7_6_by_p6_x);
            let d8_7_by_p7_x = d8_7_by_p7_x.minus_product(d8_7_by_p7_z, d7_6_by_p7_x);
            let d8_7_by_p7_y = d8_7_by_p7_y.minus_product(d8_7_by_p7_z, d7_6_by_p7_y);
            let d9_7_by_p7_z = d9_7_by_p7_z * d7_6_by_p7_z;
            let d9_7_by_p6_x = d9_7_by_p6_x.minus_product(d9_7_by_p7_z, d7_6_by_p6_x);
            let d9_7_by_p7_x = d9_7_by_p7_x.minus_product(d9_7_by_p7_z, d7_6_by_p7_x);
            let d9_7_by_p7_y = d9_7_by_p7_y.minus_product(d9_7_by_p7_z, d7_6_by_p7_y);
            let d10_7_by_p7_z = d10_7_by_p7_z * d7_6_by_p7_z;
            let d10_7_by_p6_x = d10_7_by_p6_x.minus_product(d10_7_by_p7_z, d7_6_by_p6_x);
            let d10_7_by_p7_x = d10_7_by_p7_x.minus_product(d10_7_by_p7_z, d7_6_by_p7_x);
            let d10_7_by_p7_y = d10_7_by_p7_y.minus_product(d10_7_by_p7_z, d7_6_by_p7_y);
            let d7_6_by_p6_x = d7_6_by_p6_x * d7_6_by_p7_z;
            let d7_6_by_p7_x = d7_6_by_p7_x * d7_6_by_p7_z;
            let d7_6_by_p7_y = d7_6_by_p7_y * d7_6_by_p7_z;
            let d7_2_by_p7_y = T::one() / d7_2_by_p7_y;
            let d8_7_by_p7_y = d8_7_by_p7_y * d7_2_by_p7_y;
            let d8_7_by_p6_x = d8_7_by_p6_x.minus_product(d8_7_by_p7_y, d7_2_by_p6_x);
            let d8_7_by_p7_x = d8_7_by_p7_x.minus_product(d8_7_by_p7_y, d7_2_by_p7_x);
            let d9_7_by_p7_y = d9_7_by_p7_y * d7_2_by_p7_y;
            let d9_7_by_p6_x = d9_7_by_p6_x.minus_product(d9_7_by_p7_y, d7_2_by_p6_x);
            let d9_7_by_p7_x = d9_7_by_p7_x.minus_product(d9_7_by_p7_y, d7_2_by_p7_x);
            let d10_7_by_p7_y = d10_7_by_p7_y * d7_2_by_p7_y;
            let d10_7_by_p6_x = d10_7_by_p6_x.minus_product(d10_7_by_p7_y, d7_2_by_p6_x);
            let d10_7_by_p7_x = d10_7_by_p7_x.minus_product(d10_7_by_p7_y, d7_2_by_p7_x);
            let d7_2_by_p6_x = d7_2_by_p6_x * d7_2_by_p7_y;
            let d7_2_by_p7_x = d7_2_by_p7_x * d7_2_by_p7_y;
            let d8_6_by_p8_z = T::one() / d8_6_by_p8_z;
            let d8_7_by_p8_z = d8_7_by_p8_z * d8_6_by_p8_z;
            let d8_7_by_p6_x = d8_7_by_p6_x.minus_product(d8_7_by_p8_z, d8_6_by_p6_x);
            let d8_7_by_p8_y = d8_7_by_p8_y.minus_product(d8_7_by_p8_z, d8_6_by_p8_y);
            let d9_8_by_p8_z = d9_8_by_p8_z * d8_6_by_p8_z;
            let d9_8_by_p6_x = d9_8_by_p6_x.minus_product(d9_8_by_p8_z, d8_6_by_p6_x);
            let d9_8_by_p8_y = d9_8_by_p8_y.minus_product(d9_8_by_p8_z, d8_6_by_p8_y);
            let d10_8_by_p8_z = d10_8_by_p8_z * d8_6_by_p8_z;
            let d10_8_by_p6_x = d10_8_by_p6_x.minus_product(d10_8_by_p8_z, d8_6_by_p6_x);
            let d10_8_by_p8_y = d10_8_by_p8_y.minus_product(d10_8_by_p8_z, d8_6_by_p8_y);
            let d8_6_by_p6_x = d8_6_by_p6_x * d8_6_by_p8_z;
            let d8_6_by_p8_y = d8_6_by_p8_y * d8_6_by_p8_z;
            let d9_7_by_p9_y = T::one() / d9_7_by_p9_y;
            let d9_8_by_p9_y = d9_8_by_p9_y * d9_7_by_p9_y;
            let d9_8_by_p6_x = d9_8_by_p6_x.minus_product(d9_8_by_p9_y, d9_7_by_p6_x);
            let d9_8_by_p7_x = -(d9_8_by_p9_y * d9_7_by_p7_x);
            let d9_7_by_p6_x = d9_7_by_p6_x * d9_7_by_p9_y;
            let d9_7_by_p7_x = d9_7_by_p7_x * d9_7_by_p9_y;
            let d10_7_by_p10_x = T::one() / d10_7_by_p10_x;
            let d10_8_by_p10_x = d10_8_by_p10_x * d10_7_by_p10_x;
            let d10_8_by_p6_x = d10_8_by_p6_x
                .minus_product(d10_8_by_p10_x, d10_7_by_p6_x);
            let d10_8_by_p7_x = -(d10_8_by_p10_x * d10_7_by_p7_x);
            let d10_7_by_p6_x = d10_7_by_p6_x * d10_7_by_p10_x;
            let d10_7_by_p7_x = d10_7_by_p7_x * d10_7_by_p10_x;
            let d10_8_by_p8_y = T::one() / d10_8_by_p8_y;
            let d8_7_by_p8_y = d8_7_by_p8_y * d10_8_by_p8_y;
            let d8_7_by_p6_x = d8_7_by_p6_x.minus_product(d8_7_by_p8_y, d10_8_by_p6_x);
            let d8_7_by_p7_x = d8_7_by_p7_x.minus_product(d8_7_by_p8_y, d10_8_by_p7_x);
            let d9_8_by_p8_y = d9_8_by_p8_y * d10_8_by_p8_y;
            let d9_8_by_p6_x = d9_8_by_p6_x.minus_product(d9_8_by_p8_y, d10_8_by_p6_x);
            let d9_8_by_p7_x = d9_8_by_p7_x.minus_product(d9_8_by_p8_y, d10_8_by_p7_x);
            let d10_8_by_p6_x = d10_8_by_p6_x * d10_8_by_p8_y;
            let d10_8_by_p7_x = d10_8_by_p7_x * d10_8_by_p8_y;
            let d9_8_by_p7_x = T::one() / d9_8_by_p7_x;
            let d8_7_by_p7_x = d8_7_by_p7_x * d9_8_by_p7_x;
            let d8_7_by_p6_x = d8_7_by_p6_x.minus_product(d8_7_by_p7_x, d9_8_by_p6_x);
            let d9_8_by_p6_x = d9_8_by_p6_x * d9_8_by_p7_x;
            let d8_7_by_p6_x = T::one() / d8_7_by_p6_x;
            Factors {
                growth_squared: sum_of_squares([
                    d6_1_by_p6_y,
                    d10_6_by_p10_z,
                    d8_3_by_p8_x,
                    d9_4_by_p9_x,
                    d9_6_by_p9_z,
                    d10_5_by_p10_y,
                    d7_6_by_p7_z,
                    d7_2_by_p7_y,
                    d8_6_by_p8_z,
                    d9_7_by_p9_y,
                    d10_7_by_p10_x,
                    d10_8_by_p8_y,
                    d9_8_by_p7_x,
                    d8_7_by_p6_x,
                ]),
                determinant_sign: -product([
                    d6_1_by_p6_y,
                    d10_6_by_p10_z,
                    d8_3_by_p8_x,
                    d9_4_by_p9_x,
                    d9_6_by_p9_z,
                    d10_5_by_p10_y,
                    d7_6_by_p7_z,
                    d7_2_by_p7_y,
                    d8_6_by_p8_z,
                    d9_7_by_p9_y,
                    d10_7_by_p10_x,
                    d10_8_by_p8_y,
                    d9_8_by_p7_x,
                    d8_7_by_p6_x,
                ]),
                d6_1_by_p6_z,
                d7_6_by_p6_z,
                d8_6_by_p6_z,
                d9_6_by_p6_z,
                d10_6_by_p6_z,
                d6_1_by_p6_y,
                d6_1_by_p6_x,
                d7_6_by_p6_y,
                d8_6_by_p6_y,
                d9_6_by_p6_y,
                d10_6_by_p6_y,
                d10_6_by_p10_z,
                d10_6_by_p6_x,
                d10_6_by_p10_x,
                d10_6_by_p10_y,
                d10_5_by_p10_z,
                d10_7_by_p10_z,
                d10_8_by_p10_z,
                d8_3_by_p8_x,
                d8_3_by_p8_y,
                d8_3_by_p8_z,
                d8_6_by_p8_x,
                d8_7_by_p8_x,
                d9_8_by_p8_x,
                d10_8_by_p8_x,
                d9_4_by_p9_x,
                d9_4_by_p9_y,
                d9_4_by_p9_z,
                d9_6_by_p9_x,
                d9_7_by_p9_x,
                d9_8_by_p9_x,
                d9_6_by_p9_z,
                d9_6_by_p6_x,
                d9_6_by_p9_y,
                d9_7_by_p9_z,
                d9_8_by_p9_z,
                d10_5_by_p10_y,
                d10_5_by_p6_x,
                d10_5_by_p10_x,
                d10_7_by_p10_y,
                d10_8_by_p10_y,
                d7_6_by_p7_z,
                d7_6_by_p6_x,
                d7_6_by_p7_x,
                d7_6_by_p7_y,
                d7_2_by_p7_z,
                d8_7_by_p7_z,
                d9_7_by_p7_z,
                d10_7_by_p7_z,
                d7_2_by_p7_y,
                d7_2_by_p6_x,
                d7_2_by_p7_x,
                d8_7_by_p7_y,
                d9_7_by_p7_y,
                d10_7_by_p7_y,
                d8_6_by_p8_z,
                d8_6_by_p6_x,
                d8_6_by_p8_y,
                d8_7_by_p8_z,
                d9_8_by_p8_z,
                d10_8_by_p8_z,
                d9_7_by_p9_y,
                d9_7_by_p6_x,
                d9_7_by_p7_x,
                d9_8_by_p9_y,
                d10_7_by_p10_x,
                d10_7_by_p6_x,
                d10_7_by_p7_x,
                d10_8_by_p10_x,
                d10_8_by_p8_y,
                d10_8_by_p6_x,
                d10_8_by_p7_x,
                d8_7_by_p8_y,
                d9_8_by_p8_y,
                d9_8_by_p7_x,
                d9_8_by_p6_x,
                d8_7_by_p7_x,
                d8_7_by_p6_x,
            }
        }

        #[cfg_attr(not(debug_assertions), inline(always))]
        fn curvature(
            &self,
            v: &SVector<T, 15>,
            v_fixed: &Fixed<T>,
            w: &SVector<T, 15>,
            w_fixed: &Fixed<T>,
        ) -> SVector<T, 15> {
            let v = Free::of(v);
            let w = Free::of(w);
            let mut rows = [-T::zero(); 15];
            rows[equation::D6_1] = self
                .d6_1
                .curvature(difference(v.p6, v_fixed.p1), difference(w.p6, w_fixed.p1));
            rows[equation::D7_2] = self
                .d7_2
                .curvature(difference(v.p7, v_fixed.p2), difference(w.p7, w_fixed.p2));
            rows[equation::D8_3] = self
                .d8_3
                .curvature(difference(v.p8, v_fixed.p3), difference(w.p8, w_fixed.p3));
            rows[equation::D9_4] = self
                .d9_4
                .curvature(difference(v.p9, v_fixed.p4), difference(w.p9, w_fixed.p4));
            rows[equation::D10_5] = self
                .d10_5
                .curvature(difference(v.p10, v_fixed.p5), difference(w.p10, w_fixed.p5));
            rows[equation::D7_6] = self
                .d7_6
                .curvature(difference(v.p7, v.p6), difference(w.p7, w.p6));
            rows[equation::D8_6] = self
                .d8_6
                .curvature(difference(v.p8, v.p6), difference(w.p8, w.p6));
            rows[equation::D9_6] = self
                .d9_6
                .curvature(difference(v.p9, v.p6), difference(w.p9, w.p6));
            rows[equation::D10_6] = self
                .d10_6
                .curvature(difference(v.p10, v.p6), difference(w.p10, w.p6));
            rows[equation::D8_7] = self
                .d8_7
                .curvature(difference(v.p8, v.p7), difference(w.p8, w.p7));
            rows[equation::D9_7] = self
                .d9_7
                .curvature(difference(v.p9, v.p7), difference(w.p9, w.p7));
            rows[equation::D10_7] = self
                .d10_7
                .curvature(difference(v.p10, v.p7), difference(w.p10, w.p7));
            rows[equation::D9_8] = self
                .d9_8
                .curvature(difference(v.p9, v.p8), difference(w.p9, w.p8));
            rows[equation::D10_8] = self
                .d10_8
                .curvature(difference(v.p10, v.p8), difference(w.p10, w.p8));
            SVector::from(rows)
        }

        #[cfg_attr(not(debug_assertions), inline(always))]
        fn drive_rate(
            &self,
            _q: &SVector<T, 15>,
            _fixed: &Fixed<T>,
            _fixed_rate: &Fixed<T>,
            drive_rate: &Drives<T>,
        ) -> SVector<T, 15> {
            let mut rows = [-T::zero(); 15];
            rows[equation::THETA] = drive_rate.theta;
            SVector::from(rows)
        }

        #[cfg_attr(not(debug_assertions), inline(always))]
        fn chassis_rate(
            &self,
            q: &SVector<T, 15>,
            fixed: &Fixed<T>,
            fixed_rate: &Fixed<T>,
        ) -> SVector<T, 15> {
            let free = Free::of(q);
            let mut rows = [-T::zero(); 15];
            rows[equation::D6_1] = dot(
                self.d6_1.gradient(difference(free.p6, fixed.p1)),
                fixed_rate.p1,
            );
            rows[equation::D7_2] = dot(
                self.d7_2.gradient(difference(free.p7, fixed.p2)),
                fixed_rate.p2,
            );
            rows[equation::D8_3] = dot(
                self.d8_3.gradient(difference(free.p8, fixed.p3)),
                fixed_rate.p3,
            );
            rows[equation::D9_4] = dot(
                self.d9_4.gradient(difference(free.p9, fixed.p4)),
                fixed_rate.p4,
            );
            rows[equation::D10_5] = dot(
                self.d10_5.gradient(difference(free.p10, fixed.p5)),
                fixed_rate.p5,
            );
            rows[equation::THETA] = fixed_rate.p1.z;
            SVector::from(rows)
        }

        fn points(&self, q: &SVector<T, 15>, fixed: &Fixed<T>) -> Points<T> {
            let free = Free::of(q);
            Points::all(fixed, &free, [self.p11.position(&free.p6_p7_p8_frame())])
        }

        fn velocities(
            &self,
            at: &Points<T>,
            velocity: &SVector<T, 15>,
            fixed_rate: &Fixed<T>,
        ) -> Points<T> {
            let free = Free::of(velocity);
            Points::all(
                fixed_rate,
                &free,
                [self.p11.velocity(&at.p6_p7_p8_frame(), &free.p6_p7_p8_frame())],
            )
        }

        fn accelerations(
            &self,
            at: &Points<T>,
            velocities: &Points<T>,
            acceleration: &SVector<T, 15>,
            fixed_second_rate: &Fixed<T>,
        ) -> Points<T> {
            let free = Free::of(acceleration);
            Points::all(
                fixed_second_rate,
                &free,
                [
                    self
                        .p11
                        .acceleration(
                            &at.p6_p7_p8_frame(),
                            &velocities.p6_p7_p8_frame(),
                            &free.p6_p7_p8_frame(),
                        ),
                ],
            )
        }

        fn unknowns(&self, points: &Points<T>) -> SVector<T, 15> {
            Free {
                p6: points.p6,
                p7: points.p7,
                p8: points.p8,
                p9: points.p9,
                p10: points.p10,
            }
                .unknowns()
        }

        fn measures(&self, points: &Signal<Points<T>>) -> Signal<Measures<T>>
        where
            T: Real,
        {
            let mut measures: Signal<Measures<T>> = Signal::default();
            measures
                .set(points.map(|points| points.p11.z), |measures| &mut measures.height);
            measures
        }

        #[inline(always)]
        fn mirrored(
            &self,
            q: &SVector<T, 15>,
            _fixed: &Fixed<T>,
        ) -> impl Iterator<Item = T> {
            let free = Free::of(q);
            let p6_p7_p8_frame = free.p6_p7_p8_frame();
            [
                self.p6_p7_p8_p9.mirrored(free.p9, &p6_p7_p8_frame),
                self.p6_p7_p8_p10.mirrored(free.p10, &p6_p7_p8_frame),
            ]
                .into_iter()
        }
    }

    /// The Jacobian eliminated in a fixed order, `L D U`: multipliers below each pivot, what is
    /// left of its row, divided by the pivot, to the right, and in its own place the pivot's
    /// inverse. Pivots that are 1 in every position are left out, and of carried points the rows:
    /// frame and constants stand for them.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Factors<T> {
        growth_squared: T,
        determinant_sign: T,
        d6_1_by_p6_z: T,
        d7_6_by_p6_z: T,
        d8_6_by_p6_z: T,
        d9_6_by_p6_z: T,
        d10_6_by_p6_z: T,
        d6_1_by_p6_y: T,
        d6_1_by_p6_x: T,
        d7_6_by_p6_y: T,
        d8_6_by_p6_y: T,
        d9_6_by_p6_y: T,
        d10_6_by_p6_y: T,
        d10_6_by_p10_z: T,
        d10_6_by_p6_x: T,
        d10_6_by_p10_x: T,
        d10_6_by_p10_y: T,
        d10_5_by_p10_z: T,
        d10_7_by_p10_z: T,
        d10_8_by_p10_z: T,
        d8_3_by_p8_x: T,
        d8_3_by_p8_y: T,
        d8_3_by_p8_z: T,
        d8_6_by_p8_x: T,
        d8_7_by_p8_x: T,
        d9_8_by_p8_x: T,
        d10_8_by_p8_x: T,
        d9_4_by_p9_x: T,
        d9_4_by_p9_y: T,
        d9_4_by_p9_z: T,
        d9_6_by_p9_x: T,
        d9_7_by_p9_x: T,
        d9_8_by_p9_x: T,
        d9_6_by_p9_z: T,
        d9_6_by_p6_x: T,
        d9_6_by_p9_y: T,
        d9_7_by_p9_z: T,
        d9_8_by_p9_z: T,
        d10_5_by_p10_y: T,
        d10_5_by_p6_x: T,
        d10_5_by_p10_x: T,
        d10_7_by_p10_y: T,
        d10_8_by_p10_y: T,
        d7_6_by_p7_z: T,
        d7_6_by_p6_x: T,
        d7_6_by_p7_x: T,
        d7_6_by_p7_y: T,
        d7_2_by_p7_z: T,
        d8_7_by_p7_z: T,
        d9_7_by_p7_z: T,
        d10_7_by_p7_z: T,
        d7_2_by_p7_y: T,
        d7_2_by_p6_x: T,
        d7_2_by_p7_x: T,
        d8_7_by_p7_y: T,
        d9_7_by_p7_y: T,
        d10_7_by_p7_y: T,
        d8_6_by_p8_z: T,
        d8_6_by_p6_x: T,
        d8_6_by_p8_y: T,
        d8_7_by_p8_z: T,
        d9_8_by_p8_z: T,
        d10_8_by_p8_z: T,
        d9_7_by_p9_y: T,
        d9_7_by_p6_x: T,
        d9_7_by_p7_x: T,
        d9_8_by_p9_y: T,
        d10_7_by_p10_x: T,
        d10_7_by_p6_x: T,
        d10_7_by_p7_x: T,
        d10_8_by_p10_x: T,
        d10_8_by_p8_y: T,
        d10_8_by_p6_x: T,
        d10_8_by_p7_x: T,
        d8_7_by_p8_y: T,
        d9_8_by_p8_y: T,
        d9_8_by_p7_x: T,
        d9_8_by_p6_x: T,
        d8_7_by_p7_x: T,
        d8_7_by_p6_x: T,
    }

    impl<T: Scalar> JacobianFactors<T, 15> for Factors<T> {
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn solve(&self, right: &SVector<T, 15>) -> SVector<T, 15> {
            let [mut rows] = right.data.0;
            let mut unknowns = [T::zero(); 15];
            rows[equation::D6_1] = rows[equation::D6_1]
                .minus_product(self.d6_1_by_p6_z, rows[equation::THETA]);
            rows[equation::D7_6] = rows[equation::D7_6]
                .minus_product(self.d7_6_by_p6_z, rows[equation::THETA]);
            rows[equation::D8_6] = rows[equation::D8_6]
                .minus_product(self.d8_6_by_p6_z, rows[equation::THETA]);
            rows[equation::D9_6] = rows[equation::D9_6]
                .minus_product(self.d9_6_by_p6_z, rows[equation::THETA]);
            rows[equation::D10_6] = rows[equation::D10_6]
                .minus_product(self.d10_6_by_p6_z, rows[equation::THETA]);
            rows[equation::D7_6] = rows[equation::D7_6]
                .minus_product(self.d7_6_by_p6_y, rows[equation::D6_1]);
            rows[equation::D8_6] = rows[equation::D8_6]
                .minus_product(self.d8_6_by_p6_y, rows[equation::D6_1]);
            rows[equation::D9_6] = rows[equation::D9_6]
                .minus_product(self.d9_6_by_p6_y, rows[equation::D6_1]);
            rows[equation::D10_6] = rows[equation::D10_6]
                .minus_product(self.d10_6_by_p6_y, rows[equation::D6_1]);
            rows[equation::D10_5] = rows[equation::D10_5]
                .minus_product(self.d10_5_by_p10_z, rows[equation::D10_6]);
            rows[equation::D10_7] = rows[equation::D10_7]
                .minus_product(self.d10_7_by_p10_z, rows[equation::D10_6]);
            rows[equation::D10_8] = rows[equation::D10_8]
                .minus_product(self.d10_8_by_p10_z, rows[equation::D10_6]);
            rows[equation::D8_6] = rows[equation::D8_6]
                .minus_product(self.d8_6_by_p8_x, rows[equation::D8_3]);
            rows[equation::D8_7] = rows[equation::D8_7]
                .minus_product(self.d8_7_by_p8_x, rows[equation::D8_3]);
            rows[equation::D9_8] = rows[equation::D9_8]
                .minus_product(self.d9_8_by_p8_x, rows[equation::D8_3]);
            rows[equation::D10_8] = rows[equation::D10_8]
                .minus_product(self.d10_8_by_p8_x, rows[equation::D8_3]);
            rows[equation::D9_6] = rows[equation::D9_6]
                .minus_product(self.d9_6_by_p9_x, rows[equation::D9_4]);
            rows[equation::D9_7] = rows[equation::D9_7]
                .minus_product(self.d9_7_by_p9_x, rows[equation::D9_4]);
            rows[equation::D9_8] = rows[equation::D9_8]
                .minus_product(self.d9_8_by_p9_x, rows[equation::D9_4]);
            rows[equation::D9_7] = rows[equation::D9_7]
                .minus_product(self.d9_7_by_p9_z, rows[equation::D9_6]);
            rows[equation::D9_8] = rows[equation::D9_8]
                .minus_product(self.d9_8_by_p9_z, rows[equation::D9_6]);
            rows[equation::D10_7] = rows[equation::D10_7]
                .minus_product(self.d10_7_by_p10_y, rows[equation::D10_5]);
            rows[equation::D10_8] = rows[equation::D10_8]
                .minus_product(self.d10_8_by_p10_y, rows[equation::D10_5]);
            rows[equation::D7_2] = rows[equation::D7_2]
                .minus_product(self.d7_2_by_p7_z, rows[equation::D7_6]);
            rows[equation::D8_7] = rows[equation::D8_7]
                .minus_product(self.d8_7_by_p7_z, rows[equation::D7_6]);
            rows[equation::D9_7] = rows[equation::D9_7]
                .minus_product(self.d9_7_by_p7_z, rows[equation::D7_6]);
            rows[equation::D10_7] = rows[equation::D10_7]
                .minus_product(self.d10_7_by_p7_z, rows[equation::D7_6]);
            rows[equation::D8_7] = rows[equation::D8_7]
                .minus_product(self.d8_7_by_p7_y, rows[equation::D7_2]);
            rows[equation::D9_7] = rows[equation::D9_7]
                .minus_product(self.d9_7_by_p7_y, rows[equation::D7_2]);
            rows[equation::D10_7] = rows[equation::D10_7]
                .minus_product(self.d10_7_by_p7_y, rows[equation::D7_2]);
            rows[equation::D8_7] = rows[equation::D8_7]
                .minus_product(self.d8_7_by_p8_z, rows[equation::D8_6]);
            rows[equation::D9_8] = rows[equation::D9_8]
                .minus_product(self.d9_8_by_p8_z, rows[equation::D8_6]);
            rows[equation::D10_8] = rows[equation::D10_8]
                .minus_product(self.d10_8_by_p8_z, rows[equation::D8_6]);
            rows[equation::D9_8] = rows[equation::D9_8]
                .minus_product(self.d9_8_by_p9_y, rows[equation::D9_7]);
            rows[equation::D10_8] = rows[equation::D10_8]
                .minus_product(self.d10_8_by_p10_x, rows[equation::D10_7]);
            rows[equation::D8_7] = rows[equation::D8_7]
                .minus_product(self.d8_7_by_p8_y, rows[equation::D10_8]);
            rows[equation::D9_8] = rows[equation::D9_8]
                .minus_product(self.d9_8_by_p8_y, rows[equation::D10_8]);
            rows[equation::D8_7] = rows[equation::D8_7]
                .minus_product(self.d8_7_by_p7_x, rows[equation::D9_8]);
            unknowns[unknown::P6_X] = rows[equation::D8_7] * self.d8_7_by_p6_x;
            unknowns[unknown::P7_X] = (rows[equation::D9_8] * self.d9_8_by_p7_x)
                .minus_product(self.d9_8_by_p6_x, unknowns[unknown::P6_X]);
            unknowns[unknown::P8_Y] = (rows[equation::D10_8] * self.d10_8_by_p8_y)
                .minus_product(self.d10_8_by_p6_x, unknowns[unknown::P6_X])
                .minus_product(self.d10_8_by_p7_x, unknowns[unknown::P7_X]);
            unknowns[unknown::P10_X] = (rows[equation::D10_7] * self.d10_7_by_p10_x)
                .minus_product(self.d10_7_by_p6_x, unknowns[unknown::P6_X])
                .minus_product(self.d10_7_by_p7_x, unknowns[unknown::P7_X]);
            unknowns[unknown::P9_Y] = (rows[equation::D9_7] * self.d9_7_by_p9_y)
                .minus_product(self.d9_7_by_p6_x, unknowns[unknown::P6_X])
                .minus_product(self.d9_7_by_p7_x, unknowns[unknown::P7_X]);
            unknowns[unknown::P8_Z] = (rows[equation::D8_6] * self.d8_6_by_p8_z)
                .minus_product(self.d8_6_by_p6_x, unknowns[unknown::P6_X])
                .minus_product(self.d8_6_by_p8_y, unknowns[unknown::P8_Y]);
            unknowns[unknown::P7_Y] = (rows[equation::D7_2] * self.d7_2_by_p7_y)
                .minus_product(self.d7_2_by_p6_x, unknowns[unknown::P6_X])
                .minus_product(self.d7_2_by_p7_x, unknowns[unknown::P7_X]);
            unknowns[unknown::P7_Z] = (rows[equation::D7_6] * self.d7_6_by_p7_z)
                .minus_product(self.d7_6_by_p6_x, unknowns[unknown::P6_X])
                .minus_product(self.d7_6_by_p7_x, unknowns[unknown::P7_X])
                .minus_product(self.d7_6_by_p7_y, unknowns[unknown::P7_Y]);
            unknowns[unknown::P10_Y] = (rows[equation::D10_5] * self.d10_5_by_p10_y)
                .minus_product(self.d10_5_by_p6_x, unknowns[unknown::P6_X])
                .minus_product(self.d10_5_by_p10_x, unknowns[unknown::P10_X]);
            unknowns[unknown::P9_Z] = (rows[equation::D9_6] * self.d9_6_by_p9_z)
                .minus_product(self.d9_6_by_p6_x, unknowns[unknown::P6_X])
                .minus_product(self.d9_6_by_p9_y, unknowns[unknown::P9_Y]);
            unknowns[unknown::P9_X] = (rows[equation::D9_4] * self.d9_4_by_p9_x)
                .minus_product(self.d9_4_by_p9_y, unknowns[unknown::P9_Y])
                .minus_product(self.d9_4_by_p9_z, unknowns[unknown::P9_Z]);
            unknowns[unknown::P8_X] = (rows[equation::D8_3] * self.d8_3_by_p8_x)
                .minus_product(self.d8_3_by_p8_y, unknowns[unknown::P8_Y])
                .minus_product(self.d8_3_by_p8_z, unknowns[unknown::P8_Z]);
            unknowns[unknown::P10_Z] = (rows[equation::D10_6] * self.d10_6_by_p10_z)
                .minus_product(self.d10_6_by_p6_x, unknowns[unknown::P6_X])
                .minus_product(self.d10_6_by_p10_x, unknowns[unknown::P10_X])
                .minus_product(self.d10_6_by_p10_y, unknowns[unknown::P10_Y]);
            unknowns[unknown::P6_Y] = (rows[equation::D6_1] * self.d6_1_by_p6_y)
                .minus_product(self.d6_1_by_p6_x, unknowns[unknown::P6_X]);
            unknowns[unknown::P6_Z] = rows[equation::THETA];
            SVector::from(unknowns)
        }

        #[cfg_attr(not(debug_assertions), inline(always))]
        fn solve_drives(&self, right: &SVector<T, 15>) -> SVector<T, 15> {
            let [mut rows] = right.data.0;
            let mut unknowns = [T::zero(); 15];
            rows[equation::D6_1] = -(self.d6_1_by_p6_z * rows[equation::THETA]);
            rows[equation::D7_6] = -(self.d7_6_by_p6_z * rows[equation::THETA]);
            rows[equation::D8_6] = -(self.d8_6_by_p6_z * rows[equation::THETA]);
            rows[equation::D9_6] = -(self.d9_6_by_p6_z * rows[equation::THETA]);
            rows[equation::D10_6] = -(self.d10_6_by_p6_z * rows[equation::THETA]);
            rows[equation::D7_6] = rows[equation::D7_6]
                .minus_product(self.d7_6_by_p6_y, rows[equation::D6_1]);
            rows[equation::D8_6] = rows[equation::D8_6]
                .minus_product(self.d8_6_by_p6_y, rows[equation::D6_1]);
            rows[equation::D9_6] = rows[equation::D9_6]
                .minus_product(self.d9_6_by_p6_y, rows[equation::D6_1]);
            rows[equation::D10_6] = rows[equation::D10_6]
                .minus_product(self.d10_6_by_p6_y, rows[equation::D6_1]);
            rows[equation::D10_5] = -(self.d10_5_by_p10_z * rows[equation::D10_6]);
            rows[equation::D10_7] = -(self.d10_7_by_p10_z * rows[equation::D10_6]);
            rows[equation::D10_8] = -(self.d10_8_by_p10_z * rows[equation::D10_6]);
            rows[equation::D9_7] = -(self.d9_7_by_p9_z * rows[equation::D9_6]);
            rows[equation::D9_8] = -(self.d9_8_by_p9_z * rows[equation::D9_6]);
            rows[equation::D10_7] = rows[equation::D10_7]
                .minus_product(self.d10_7_by_p10_y, rows[equation::D10_5]);
            rows[equation::D10_8] = rows[equation::D10_8]
                .minus_product(self.d10_8_by_p10_y, rows[equation::D10_5]);
            rows[equation::D7_2] = -(self.d7_2_by_p7_z * rows[equation::D7_6]);
            rows[equation::D8_7] = -(self.d8_7_by_p7_z * rows[equation::D7_6]);
            rows[equation::D9_7] = rows[equation::D9_7]
                .minus_product(self.d9_7_by_p7_z, rows[equation::D7_6]);
            rows[equation::D10_7] = rows[equation::D10_7]
                .minus_product(self.d10_7_by_p7_z, rows[equation::D7_6]);
            rows[equation::D8_7] = rows[equation::D8_7]
                .minus_product(self.d8_7_by_p7_y, rows[equation::D7_2]);
            rows[equation::D9_7] = rows[equation::D9_7]
                .minus_product(self.d9_7_by_p7_y, rows[equation::D7_2]);
            rows[equation::D10_7] = rows[equation::D10_7]
                .minus_product(self.d10_7_by_p7_y, rows[equation::D7_2]);
            rows[equation::D8_7] = rows[equation::D8_7]
                .minus_product(self.d8_7_by_p8_z, rows[equation::D8_6]);
            rows[equation::D9_8] = rows[equation::D9_8]
                .minus_product(self.d9_8_by_p8_z, rows[equation::D8_6]);
            rows[equation::D10_8] = rows[equation::D10_8]
                .minus_product(self.d10_8_by_p8_z, rows[equation::D8_6]);
            rows[equation::D9_8] = rows[equation::D9_8]
                .minus_product(self.d9_8_by_p9_y, rows[equation::D9_7]);
            rows[equation::D10_8] = rows[equation::D10_8]
                .minus_product(self.d10_8_by_p10_x, rows[equation::D10_7]);
            rows[equation::D8_7] = rows[equation::D8_7]
                .minus_product(self.d8_7_by_p8_y, rows[equation::D10_8]);
            rows[equation::D9_8] = rows[equation::D9_8]
                .minus_product(self.d9_8_by_p8_y, rows[equation::D10_8]);
            rows[equation::D8_7] = rows[equation::D8_7]
                .minus_product(self.d8_7_by_p7_x, rows[equation::D9_8]);
            unknowns[unknown::P6_X] = rows[equation::D8_7] * self.d8_7_by_p6_x;
            unknowns[unknown::P7_X] = (rows[equation::D9_8] * self.d9_8_by_p7_x)
                .minus_product(self.d9_8_by_p6_x, unknowns[unknown::P6_X]);
            unknowns[unknown::P8_Y] = (rows[equation::D10_8] * self.d10_8_by_p8_y)
                .minus_product(self.d10_8_by_p6_x, unknowns[unknown::P6_X])
                .minus_product(self.d10_8_by_p7_x, unknowns[unknown::P7_X]);
            unknowns[unknown::P10_X] = (rows[equation::D10_7] * self.d10_7_by_p10_x)
                .minus_product(self.d10_7_by_p6_x, unknowns[unknown::P6_X])
                .minus_product(self.d10_7_by_p7_x, unknowns[unknown::P7_X]);
            unknowns[unknown::P9_Y] = (rows[equation::D9_7] * self.d9_7_by_p9_y)
                .minus_product(self.d9_7_by_p6_x, unknowns[unknown::P6_X])
                .minus_product(self.d9_7_by_p7_x, unknowns[unknown::P7_X]);
            unknowns[unknown::P8_Z] = (rows[equation::D8_6] * self.d8_6_by_p8_z)
                .minus_product(self.d8_6_by_p6_x, unknowns[unknown::P6_X])
                .minus_product(self.d8_6_by_p8_y, unknowns[unknown::P8_Y]);
            unknowns[unknown::P7_Y] = (rows[equation::D7_2] * self.d7_2_by_p7_y)
                .minus_product(self.d7_2_by_p6_x, unknowns[unknown::P6_X])
                .minus_product(self.d7_2_by_p7_x, unknowns[unknown::P7_X]);
            unknowns[unknown::P7_Z] = (rows[equation::D7_6] * self.d7_6_by_p7_z)
                .minus_product(self.d7_6_by_p6_x, unknowns[unknown::P6_X])
                .minus_product(self.d7_6_by_p7_x, unknowns[unknown::P7_X])
                .minus_product(self.d7_6_by_p7_y, unknowns[unknown::P7_Y]);
            unknowns[unknown::P10_Y] = (rows[equation::D10_5] * self.d10_5_by_p10_y)
                .minus_product(self.d10_5_by_p6_x, unknowns[unknown::P6_X])
                .minus_product(self.d10_5_by_p10_x, unknowns[unknown::P10_X]);
            unknowns[unknown::P9_Z] = (rows[equation::D9_6] * self.d9_6_by_p9_z)
                .minus_product(self.d9_6_by_p6_x, unknowns[unknown::P6_X])
                .minus_product(self.d9_6_by_p9_y, unknowns[unknown::P9_Y]);
            unknowns[unknown::P9_X] = (-(self.d9_4_by_p9_y * unknowns[unknown::P9_Y]))
                .minus_product(self.d9_4_by_p9_z, unknowns[unknown::P9_Z]);
            unknowns[unknown::P8_X] = (-(self.d8_3_by_p8_y * unknowns[unknown::P8_Y]))
                .minus_product(self.d8_3_by_p8_z, unknowns[unknown::P8_Z]);
            unknowns[unknown::P10_Z] = (rows[equation::D10_6] * self.d10_6_by_p10_z)
                .minus_product(self.d10_6_by_p6_x, unknowns[unknown::P6_X])
                .minus_product(self.d10_6_by_p10_x, unknowns[unknown::P10_X])
                .minus_product(self.d10_6_by_p10_y, unknowns[unknown::P10_Y]);
            unknowns[unknown::P6_Y] = (rows[equation::D6_1] * self.d6_1_by_p6_y)
                .minus_product(self.d6_1_by_p6_x, unknowns[unknown::P6_X]);
            unknowns[unknown::P6_Z] = rows[equation::THETA];
            SVector::from(unknowns)
        }

        #[cfg_attr(not(debug_assertions), inline(always))]
        fn solve_transposed(&self, right: &SVector<T, 15>) -> SVector<T, 15> {
            let [mut unknowns] = right.data.0;
            let mut rows = [T::zero(); 15];
            unknowns[unknown::P6_X] = unknowns[unknown::P6_X]
                .minus_product(self.d6_1_by_p6_x, unknowns[unknown::P6_Y]);
            unknowns[unknown::P6_X] = unknowns[unknown::P6_X]
                .minus_product(self.d10_6_by_p6_x, unknowns[unknown::P10_Z]);
            unknowns[unknown::P10_X] = unknowns[unknown::P10_X]
                .minus_product(self.d10_6_by_p10_x, unknowns[unknown::P10_Z]);
            unknowns[unknown::P10_Y] = unknowns[unknown::P10_Y]
                .minus_product(self.d10_6_by_p10_y, unknowns[unknown::P10_Z]);
            unknowns[unknown::P8_Y] = unknowns[unknown::P8_Y]
                .minus_product(self.d8_3_by_p8_y, unknowns[unknown::P8_X]);
            unknowns[unknown::P8_Z] = unknowns[unknown::P8_Z]
                .minus_product(self.d8_3_by_p8_z, unknowns[unknown::P8_X]);
            unknowns[unknown::P9_Y] = unknowns[unknown::P9_Y]
                .minus_product(self.d9_4_by_p9_y, unknowns[unknown::P9_X]);
            unknowns[unknown::P9_Z] = unknowns[unknown::P9_Z]
                .minus_product(self.d9_4_by_p9_z, unknowns[unknown::P9_X]);
            unknowns[unknown::P6_X] = unknowns[unknown::P6_X]
                .minus_product(self.d9_6_by_p6_x, unknowns[unknown::P9_Z]);
            unknowns[unknown::P9_Y] = unknowns[unknown::P9_Y]
                .minus_product(self.d9_6_by_p9_y, unknowns[unknown::P9_Z]);
            unknowns[unknown::P6_X] = unknowns[unknown::P6_X]
                .minus_product(self.d10_5_by_p6_x, unknowns[unknown::P10_Y]);
            unknowns[unknown::P10_X] = unknowns[unknown::P10_X]
                .minus_product(self.d10_5_by_p10_x, unknowns[unknown::P10_Y]);
            unknowns[unknown::P6_X] = unknowns[unknown::P6_X]
                .minus_product(self.d7_6_by_p6_x, unknowns[unknown::P7_Z]);
            unknowns[unknown::P7_X] = unknowns[unknown::P7_X]
                .minus_product(self.d7_6_by_p7_x, unknowns[unknown::P7_Z]);
            unknowns[unknown::P7_Y] = unknowns[unknown::P7_Y]
                .minus_product(self.d7_6_by_p7_y, unknowns[unknown::P7_Z]);
            unknowns[unknown::P6_X] = unknowns[unknown::P6_X]
                .minus_product(self.d7_2_by_p6_x, unknowns[unknown::P7_Y]);
            unknowns[unknown::P7_X] = unknowns[unknown::P7_X]
                .minus_product(self.d7_2_by_p7_x, unknowns[unknown::P7_Y]);
            unknowns[unknown::P6_X] = unknowns[unknown::P6_X]
                .minus_product(self.d8_6_by_p6_x, unknowns[unknown::P8_Z]);
            unknowns[unknown::P8_Y] = unknowns[unknown::P8_Y]
                .minus_product(self.d8_6_by_p8_y, unknowns[unknown::P8_Z]);
            unknowns[unknown::P6_X] = unknowns[unknown::P6_X]
                .minus_product(self.d9_7_by_p6_x, unknowns[unknown::P9_Y]);
            unknowns[unknown::P7_X] = unknowns[unknown::P7_X]
                .minus_product(self.d9_7_by_p7_x, unknowns[unknown::P9_Y]);
            unknowns[unknown::P6_X] = unknowns[unknown::P6_X]
                .minus_product(self.d10_7_by_p6_x, unknowns[unknown::P10_X]);
            unknowns[unknown::P7_X] = unknowns[unknown::P7_X]
                .minus_product(self.d10_7_by_p7_x, unknowns[unknown::P10_X]);
            unknowns[unknown::P6_X] = unknowns[unknown::P6_X]
                .minus_product(self.d10_8_by_p6_x, unknowns[unknown::P8_Y]);
            unknowns[unknown::P7_X] = unknowns[unknown::P7_X]
                .minus_product(self.d10_8_by_p7_x, unknowns[unknown::P8_Y]);
            unknowns[unknown::P6_X] = unknowns[unknown::P6_X]
                .minus_product(self.d9_8_by_p6_x, unknowns[unknown::P7_X]);
            rows[equation::THETA] = unknowns[unknown::P6_Z];
            rows[equation::D6_1] = unknowns[unknown::P6_Y] * self.d6_1_by_p6_y;
            rows[equation::D10_6] = unknowns[unknown::P10_Z] * self.d10_6_by_p10_z;
            rows[equation::D8_3] = unknowns[unknown::P8_X] * self.d8_3_by_p8_x;
            rows[equation::D9_4] = unknowns[unknown::P9_X] * self.d9_4_by_p9_x;
            rows[equation::D9_6] = unknowns[unknown::P9_Z] * self.d9_6_by_p9_z;
            rows[equation::D10_5] = unknowns[unknown::P10_Y] * self.d10_5_by_p10_y;
            rows[equation::D7_6] = unknowns[unknown::P7_Z] * self.d7_6_by_p7_z;
            rows[equation::D7_2] = unknowns[unknown::P7_Y] * self.d7_2_by_p7_y;
            rows[equation::D8_6] = unknowns[unknown::P8_Z] * self.d8_6_by_p8_z;
            rows[equation::D9_7] = unknowns[unknown::P9_Y] * self.d9_7_by_p9_y;
            rows[equation::D10_7] = unknowns[unknown::P10_X] * self.d10_7_by_p10_x;
            rows[equation::D10_8] = unknowns[unknown::P8_Y] * self.d10_8_by_p8_y;
            rows[equation::D9_8] = unknowns[unknown::P7_X] * self.d9_8_by_p7_x;
            rows[equation::D8_7] = unknowns[unknown::P6_X] * self.d8_7_by_p6_x;
            rows[equation::D9_8] = rows[equation::D9_8]
                .minus_product(self.d8_7_by_p7_x, rows[equation::D8_7]);
            rows[equation::D10_8] = rows[equation::D10_8]
                .minus_product(self.d8_7_by_p8_y, rows[equation::D8_7]);
            rows[equation::D10_8] = rows[equation::D10_8]
                .minus_product(self.d9_8_by_p8_y, rows[equation::D9_8]);
            rows[equation::D10_7] = rows[equation::D10_7]
                .minus_product(self.d10_8_by_p10_x, rows[equation::D10_8]);
            rows[equation::D9_7] = rows[equation::D9_7]
                .minus_product(self.d9_8_by_p9_y, rows[equation::D9_8]);
            rows[equation::D8_6] = rows[equation::D8_6]
                .minus_product(self.d8_7_by_p8_z, rows[equation::D8_7]);
            rows[equation::D8_6] = rows[equation::D8_6]
                .minus_product(self.d9_8_by_p8_z, rows[equation::D9_8]);
            rows[equation::D8_6] = rows[equation::D8_6]
                .minus_product(self.d10_8_by_p8_z, rows[equation::D10_8]);
            rows[equation::D7_2] = rows[equation::D7_2]
                .minus_product(self.d8_7_by_p7_y, rows[equation::D8_7]);
            rows[equation::D7_2] = rows[equation::D7_2]
                .minus_product(self.d9_7_by_p7_y, rows[equation::D9_7]);
            rows[equation::D7_2] = rows[equation::D7_2]
                .minus_product(self.d10_7_by_p7_y, rows[equation::D10_7]);
            rows[equation::D7_6] = rows[equation::D7_6]
                .minus_product(self.d7_2_by_p7_z, rows[equation::D7_2]);
            rows[equation::D7_6] = rows[equation::D7_6]
                .minus_product(self.d8_7_by_p7_z, rows[equation::D8_7]);
            rows[equation::D7_6] = rows[equation::D7_6]
                .minus_product(self.d9_7_by_p7_z, rows[equation::D9_7]);
            rows[equation::D7_6] = rows[equation::D7_6]
                .minus_product(self.d10_7_by_p7_z, rows[equation::D10_7]);
            rows[equation::D10_5] = rows[equation::D10_5]
                .minus_product(self.d10_7_by_p10_y, rows[equation::D10_7]);
            rows[equation::D10_5] = rows[equation::D10_5]
                .minus_product(self.d10_8_by_p10_y, rows[equation::D10_8]);
            rows[equation::D9_6] = rows[equation::D9_6]
                .minus_product(self.d9_7_by_p9_z, rows[equation::D9_7]);
            rows[equation::D9_6] = rows[equation::D9_6]
                .minus_product(self.d9_8_by_p9_z, rows[equation::D9_8]);
            rows[equation::D9_4] = rows[equation::D9_4]
                .minus_product(self.d9_6_by_p9_x, rows[equation::D9_6]);
            rows[equation::D9_4] = rows[equation::D9_4]
                .minus_product(self.d9_7_by_p9_x, rows[equation::D9_7]);
            rows[equation::D9_4] = rows[equation::D9_4]
                .minus_product(self.d9_8_by_p9_x, rows[equation::D9_8]);
            rows[equation::D8_3] = rows[equation::D8_3]
                .minus_product(self.d8_6_by_p8_x, rows[equation::D8_6]);
            rows[equation::D8_3] = rows[equation::D8_3]
                .minus_product(self.d8_7_by_p8_x, rows[equation::D8_7]);
            rows[equation::D8_3] = rows[equation::D8_3]
                .minus_product(self.d9_8_by_p8_x, rows[equation::D9_8]);
            rows[equation::D8_3] = rows[equation::D8_3]
                .minus_product(self.d10_8_by_p8_x, rows[equation::D10_8]);
            rows[equation::D10_6] = rows[equation::D10_6]
                .minus_product(self.d10_5_by_p10_z, rows[equation::D10_5]);
            rows[equation::D10_6] = rows[equation::D10_6]
                .minus_product(self.d10_7_by_p10_z, rows[equation::D10_7]);
            rows[equation::D10_6] = rows[equation::D10_6]
                .minus_product(self.d10_8_by_p10_z, rows[equation::D10_8]);
            rows[equation::D6_1] = rows[equation::D6_1]
                .minus_product(self.d7_6_by_p6_y, rows[equation::D7_6]);
            rows[equation::D6_1] = rows[equation::D6_1]
                .minus_product(self.d8_6_by_p6_y, rows[equation::D8_6]);
            rows[equation::D6_1] = rows[equation::D6_1]
                .minus_product(self.d9_6_by_p6_y, rows[equation::D9_6]);
            rows[equation::D6_1] = rows[equation::D6_1]
                .minus_product(self.d10_6_by_p6_y, rows[equation::D10_6]);
            rows[equation::THETA] = rows[equation::THETA]
                .minus_product(self.d6_1_by_p6_z, rows[equation::D6_1]);
            rows[equation::THETA] = rows[equation::THETA]
                .minus_product(self.d7_6_by_p6_z, rows[equation::D7_6]);
            rows[equation::THETA] = rows[equation::THETA]
                .minus_product(self.d8_6_by_p6_z, rows[equation::D8_6]);
            rows[equation::THETA] = rows[equation::THETA]
                .minus_product(self.d9_6_by_p6_z, rows[equation::D9_6]);
            rows[equation::THETA] = rows[equation::THETA]
                .minus_product(self.d10_6_by_p6_z, rows[equation::D10_6]);
            SVector::from(rows)
        }

        #[inline(always)]
        fn determinant_sign(&self) -> T {
            self.determinant_sign
        }

        #[inline(always)]
        fn growth_squared(&self) -> T {
            self.growth_squared
        }
    }

    /// This listing, over any number.
    #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
    pub struct Listing;
    impl Listing {
        /// Names and kinds of its parts.
        pub const PARTS: Names = Names {
            equations: &[
                "d6_1",
                "d7_2",
                "d8_3",
                "d9_4",
                "d10_5",
                "d7_6",
                "d8_6",
                "d9_6",
                "d10_6",
                "d8_7",
                "d9_7",
                "d10_7",
                "d9_8",
                "d10_8",
                "theta",
            ],
            unknowns: &[
                "p6.x",
                "p6.y",
                "p6.z",
                "p7.x",
                "p7.y",
                "p7.z",
                "p8.x",
                "p8.y",
                "p8.z",
                "p9.x",
                "p9.y",
                "p9.z",
                "p10.x",
                "p10.y",
                "p10.z",
            ],
            chassis: <Fixed<f64> as Named<Vector3<f64>>>::NAMES,
            points: <Points<f64> as Named<Vector3<f64>>>::NAMES,
            markers: 1,
            drives: <Drives<f64> as Named<f64>>::NAMES,
            drive_kinds: &[DriveKind::Angle],
            measures: <Measures<f64> as Named<f64>>::NAMES,
            measure_kinds: &[MeasureKind::Length],
            lengths: <Lengths<f64> as Named<f64>>::NAMES,
            wheels: &[
                WheelPlaces {
                    name: "",
                    axis: [7, 10],
                    carrier: [5, 6, 7],
                    kingpin: Some([5, 7]),
                },
            ],
        };
    }

    impl Parts for Listing {
        #[inline(always)]
        fn table(&self) -> &Names {
            &Self::PARTS
        }
    }

    impl<T: Scalar> Parts for Model<T> {
        #[inline(always)]
        fn table(&self) -> &Names {
            &Listing::PARTS
        }
    }

    impl AnyNumber<15> for Listing {
        type Model<T: Scalar> = Model<T>;
        type Fixed<T: Scalar> = Fixed<T>;
        type Drives<T: Scalar> = Drives<T>;
        type Measures<T: Scalar> = Measures<T>;
        type Points<T: Scalar> = Points<T>;
        fn gather<S: Scalar, T: Scalar>(
            _: &Model<S>,
            number: impl Fn(&dyn Fn(&Model<S>) -> S) -> T,
        ) -> Model<T> {
            let number = &number;
            Model {
                fixed: gather_vectors(|model| model.fixed, number),
                size: number(&|model| model.size),
                d6_1: Distance::gather(|model| model.d6_1, number),
                d7_2: Distance::gather(|model| model.d7_2, number),
                d8_3: Distance::gather(|model| model.d8_3, number),
                d9_4: Distance::gather(|model| model.d9_4, number),
                d10_5: Distance::gather(|model| model.d10_5, number),
                d7_6: Distance::gather(|model| model.d7_6, number),
                d8_6: Distance::gather(|model| model.d8_6, number),
                d9_6: Distance::gather(|model| model.d9_6, number),
                d10_6: Distance::gather(|model| model.d10_6, number),
                d8_7: Distance::gather(|model| model.d8_7, number),
                d9_7: Distance::gather(|model| model.d9_7, number),
                d10_7: Distance::gather(|model| model.d10_7, number),
                d9_8: Distance::gather(|model| model.d9_8, number),
                d10_8: Distance::gather(|model| model.d10_8, number),
                p11: Carried::gather(|model| model.p11, number),
                p6_p7_p8_frame: Frame::gather(|model| model.p6_p7_p8_frame, number),
                p6_p7_p8_p9: Linked::gather(|model| model.p6_p7_p8_p9, number),
                p6_p7_p8_p10: Linked::gather(|model| model.p6_p7_p8_p10, number),
            }
        }
    }

    impl<T: Real> Model<T> {
        /// With `size` brought up to the other constants.
        fn sized(self) -> Self {
            Self {
                size: parts::longest(
                    &[
                        self.d6_1.length(),
                        self.d7_2.length(),
                        self.d8_3.length(),
                        self.d9_4.length(),
                        self.d10_5.length(),
                        self.d7_6.length(),
                        self.d8_6.length(),
                        self.d9_6.length(),
                        self.d10_6.length(),
                        self.d8_7.length(),
                        self.d9_7.length(),
                        self.d10_7.length(),
                        self.d9_8.length(),
                        self.d10_8.length(),
                    ],
                ),
                ..self
            }
        }
    }

    impl<T: Real> Build<15> for Model<T> {
        type Lengths = Lengths<T>;
        fn of(_listing: Listing, design: &Points<T>) -> Result<Self, GeometryError> {
            parts::finite(design.values())?;
            let p6_p7_p8_frame = parts::frame(7, design.p6_p7_p8_frame())?;
            let model = Self {
                fixed: Fixed {
                    p1: design.p1,
                    p2: design.p2,
                    p3: design.p3,
                    p4: design.p4,
                    p5: design.p5,
                },
                size: T::zero(),
                d6_1: parts::distance(0, design.p1, design.p6)?,
                d7_2: parts::distance(1, design.p2, design.p7)?,
                d8_3: parts::distance(2, design.p3, design.p8)?,
                d9_4: parts::distance(3, design.p4, design.p9)?,
                d10_5: parts::distance(4, design.p5, design.p10)?,
                d7_6: parts::distance(5, design.p6, design.p7)?,
                d8_6: parts::distance(6, design.p6, design.p8)?,
                d9_6: parts::distance(7, design.p6, design.p9)?,
                d10_6: parts::distance(8, design.p6, design.p10)?,
                d8_7: parts::distance(9, design.p7, design.p8)?,
                d9_7: parts::distance(10, design.p7, design.p9)?,
                d10_7: parts::distance(11, design.p7, design.p10)?,
                d9_8: parts::distance(12, design.p8, design.p9)?,
                d10_8: parts::distance(13, design.p8, design.p10)?,
                p6_p7_p8_frame,
                p6_p7_p8_p9: parts::linked(8, design.p9, &p6_p7_p8_frame)?,
                p6_p7_p8_p10: parts::linked(9, design.p10, &p6_p7_p8_frame)?,
                p11: parts::carried(10, design.p11, &design.p6_p7_p8_frame())?,
            };
            Ok(model.sized())
        }

        fn check_pivots(&self, points: &Points<T>) -> Result<(), GeometryError> {
            check_pivots(self, points)
        }

        fn with_lengths(self, lengths: &Lengths<T>) -> Result<Self, GeometryError> {
            parts::positive(lengths.values())?;
            let p6_p7_p8_frame = parts::frame_of_lengths(
                7,
                [lengths.d7_6, lengths.d8_6, lengths.d8_7],
            )?;
            let model = Self {
                d6_1: Distance::new(lengths.d6_1),
                d7_2: Distance::new(lengths.d7_2),
                d8_3: Distance::new(lengths.d8_3),
                d9_4: Distance::new(lengths.d9_4),
                d10_5: Distance::new(lengths.d10_5),
                d7_6: Distance::new(lengths.d7_6),
                d8_6: Distance::new(lengths.d8_6),
                d9_6: Distance::new(lengths.d9_6),
                d10_6: Distance::new(lengths.d10_6),
                d8_7: Distance::new(lengths.d8_7),
                d9_7: Distance::new(lengths.d9_7),
                d10_7: Distance::new(lengths.d10_7),
                d9_8: Distance::new(lengths.d9_8),
                d10_8: Distance::new(lengths.d10_8),
                p6_p7_p8_frame,
                p6_p7_p8_p9: parts::linked_at(
                    8,
                    &self.p6_p7_p8_p9,
                    &p6_p7_p8_frame,
                    [lengths.d9_6, lengths.d9_7, lengths.d9_8],
                )?,
                p6_p7_p8_p10: parts::linked_at(
                    9,
                    &self.p6_p7_p8_p10,
                    &p6_p7_p8_frame,
                    [lengths.d10_6, lengths.d10_7, lengths.d10_8],
                )?,
                ..self
            };
            Ok(model.sized())
        }

        fn with_markers(self, points: &Points<T>) -> Result<Self, GeometryError> {
            parts::finite(points.values())?;
            Ok(Self {
                p11: parts::carried(10, points.p11, &points.p6_p7_p8_frame())?,
                ..self
            })
        }

        fn lengths(&self) -> Lengths<T> {
            Lengths {
                d6_1: self.d6_1.length(),
                d7_2: self.d7_2.length(),
                d8_3: self.d8_3.length(),
                d9_4: self.d9_4.length(),
                d10_5: self.d10_5.length(),
                d7_6: self.d7_6.length(),
                d8_6: self.d8_6.length(),
                d9_6: self.d9_6.length(),
                d10_6: self.d10_6.length(),
                d8_7: self.d8_7.length(),
                d9_7: self.d9_7.length(),
                d10_7: self.d10_7.length(),
                d9_8: self.d9_8.length(),
                d10_8: self.d10_8.length(),
            }
        }

        fn drives_at(&self, points: &Points<T>) -> Drives<T> {
            Drives {
                theta: parts::angle(points.p6.z - points.p1.z, self.d6_1.length()),
            }
        }

        fn fit(&self, q: &SVector<T, 15>, _fixed: &Fixed<T>) -> SVector<T, 15> {
            let mut free = Free::of(q);
            let [origin, second, third] = self.p6_p7_p8_frame.points();
            [free.p6, free.p7, free.p8, free.p9, free.p10] = best_rigid_fit(
                &[
                    origin,
                    second,
                    third,
                    self.p6_p7_p8_p9.position(&self.p6_p7_p8_frame),
                    self.p6_p7_p8_p10.position(&self.p6_p7_p8_frame),
                ],
                &[free.p6, free.p7, free.p8, free.p9, free.p10],
            );
            free.unknowns()
        }
    }

    impl<T: Scalar> HasWheel<T> for Points<T> {
        fn wheel(&self) -> [Vector3<T>; 2] {
            [self.p8, self.p11]
        }

        fn carrier(&self) -> [Vector3<T>; 3] {
            [self.p6, self.p7, self.p8]
        }
    }

    impl<T: Scalar> HasKingpin<T> for Points<T> {
        fn kingpin(&self) -> [Vector3<T>; 2] {
            [self.p6, self.p8]
        }
    }
}
