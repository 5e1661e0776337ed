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
#[allow(clippy::approx_constant, dead_code, non_snake_case, unreachable_pub)]
pub mod attia2003 {
    use ::suspension_core::generated::*;
    use ::suspension_core::generated::{unknown_names, vector_of};
    /// Every point, with a position, velocity or acceleration each.
    #[derive(Clone, Copy, Debug, PartialEq, Named)]
    pub struct Points<T = f64> {
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
    pub struct Fixed<T = f64> {
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
    pub struct Drives<T = f64> {
        /// Eq. (1.15): `z6 - z1 = d6_1 cos(theta)`.
        pub theta: T,
    }

    /// What is measured, or its rates: coordinates and lengths in the unit of the points, angles in radians.
    #[derive(Clone, Copy, Debug, PartialEq, Named)]
    pub struct Measures<T = f64> {
        /// Height of the wheel centre.
        pub height: T,
    }

    /// The constant lengths of links and bodies.
    #[derive(Clone, Copy, Debug, PartialEq, Named)]
    pub struct Lengths<T = f64> {
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
    #[derive(Clone, Copy)]
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
            vector_of![
                self.p6.x, self.p6.y, self.p6.z, self.p7.x, self.p7.y, self.p7.z, self.p8
                .x, self.p8.y, self.p8.z, self.p9.x, self.p9.y, self.p9.z, self.p10.x,
                self.p10.y, self.p10.z
            ]
        }

        #[inline(always)]
        fn p6_p7_p8_frame(&self) -> Frame<T> {
            Frame::new(self.p6, self.p7, self.p8)
        }
    }

    /// The geometry: chassis points at rest and the constants of every equation.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Model<T = f64> {
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
        fn put_drives(&self, _fixed: &mut Fixed<T>, _drives: &Drives<T>) {}
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn residual(
            &self,
            q: &SVector<T, 15>,
            fixed: &Fixed<T>,
            drives: &Drives<T>,
        ) -> SVector<T, 15> {
            let free = Free::of(q);
            let mut rows = [-T::zero(); 15];
            let d = difference(free.p6, fixed.p1);
            rows[equation::D6_1] = self.d6_1.residual(d);
            let d = difference(free.p7, fixed.p2);
            rows[equation::D7_2] = self.d7_2.residual(d);
            let d = difference(free.p8, fixed.p3);
            rows[equation::D8_3] = self.d8_3.residual(d);
            let d = difference(free.p9, fixed.p4);
            rows[equation::D9_4] = self.d9_4.residual(d);
            let d = difference(free.p10, fixed.p5);
            rows[equation::D10_5] = self.d10_5.residual(d);
            let d = difference(free.p7, free.p6);
            rows[equation::D7_6] = self.d7_6.residual(d);
            let d = difference(free.p8, free.p6);
            rows[equation::D8_6] = self.d8_6.residual(d);
            let d = difference(free.p9, free.p6);
            rows[equation::D9_6] = self.d9_6.residual(d);
            let d = difference(free.p10, free.p6);
            rows[equation::D10_6] = self.d10_6.residual(d);
            let d = difference(free.p8, free.p7);
            rows[equation::D8_7] = self.d8_7.residual(d);
            let d = difference(free.p9, free.p7);
            rows[equation::D9_7] = self.d9_7.residual(d);
            let d = difference(free.p10, free.p7);
            rows[equation::D10_7] = self.d10_7.residual(d);
            let d = difference(free.p9, free.p8);
            rows[equation::D9_8] = self.d9_8.residual(d);
            let d = difference(free.p10, free.p8);
            rows[equation::D10_8] = self.d10_8.residual(d);
            rows[equation::THETA] = free.p6.z - fixed.p1.z - drives.theta;
            SVector::from(rows)
        }

        #[cfg_attr(not(debug_assertions), inline(always))]
        fn jacobian(&self, q: &SVector<T, 15>, fixed: &Fixed<T>) -> SMatrix<T, 15, 15> {
            let free = Free::of(q);
            let mut rows = Rows::zero();
            let d = difference(free.p6, fixed.p1);
            let gradient = self.d6_1.gradient(d);
            rows.at(equation::D6_1).by(unknown::P6_X, gradient);
            let d = difference(free.p7, fixed.p2);
            let gradient = self.d7_2.gradient(d);
            rows.at(equation::D7_2).by(unknown::P7_X, gradient);
            let d = difference(free.p8, fixed.p3);
            let gradient = self.d8_3.gradient(d);
            rows.at(equation::D8_3).by(unknown::P8_X, gradient);
            let d = difference(free.p9, fixed.p4);
            let gradient = self.d9_4.gradient(d);
            rows.at(equation::D9_4).by(unknown::P9_X, gradient);
            let d = difference(free.p10, fixed.p5);
            let gradient = self.d10_5.gradient(d);
            rows.at(equation::D10_5).by(unknown::P10_X, gradient);
            let d = difference(free.p7, free.p6);
            let gradient = self.d7_6.gradient(d);
            rows.at(equation::D7_6)
                .by(unknown::P7_X, gradient)
                .by(unknown::P6_X, opposite(gradient));
            let d = difference(free.p8, free.p6);
            let gradient = self.d8_6.gradient(d);
            rows.at(equation::D8_6)
                .by(unknown::P8_X, gradient)
                .by(unknown::P6_X, opposite(gradient));
            let d = difference(free.p9, free.p6);
            let gradient = self.d9_6.gradient(d);
            rows.at(equation::D9_6)
                .by(unknown::P9_X, gradient)
                .by(unknown::P6_X, opposite(gradient));
            let d = difference(free.p10, free.p6);
            let gradient = self.d10_6.gradient(d);
            rows.at(equation::D10_6)
                .by(unknown::P10_X, gradient)
                .by(unknown::P6_X, opposite(gradient));
            let d = difference(free.p8, free.p7);
            let gradient = self.d8_7.gradient(d);
            rows.at(equation::D8_7)
                .by(unknown::P8_X, gradient)
                .by(unknown::P7_X, opposite(gradient));
            let d = difference(free.p9, free.p7);
            let gradient = self.d9_7.gradient(d);
            rows.at(equation::D9_7)
                .by(unknown::P9_X, gradient)
                .by(unknown::P7_X, opposite(gradient));
            let d = difference(free.p10, free.p7);
            let gradient = self.d10_7.gradient(d);
            rows.at(equation::D10_7)
                .by(unknown::P10_X, gradient)
                .by(unknown::P7_X, opposite(gradient));
            let d = difference(free.p9, free.p8);
            let gradient = self.d9_8.gradient(d);
            rows.at(equation::D9_8)
                .by(unknown::P9_X, gradient)
                .by(unknown::P8_X, opposite(gradient));
            let d = difference(free.p10, free.p8);
            let gradient = self.d10_8.gradient(d);
            rows.at(equation::D10_8)
                .by(unknown::P10_X, gradient)
                .by(unknown::P8_X, opposite(gradient));
            rows.at(equation::THETA).by_one(unknown::P6_Z, T::one());
            rows.matrix()
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
            let d = difference(free.p6, fixed.p1);
            let gradient = self.d6_1.gradient(d);
            let [d1_p6_x, d1_p6_y, d1_p6_z] = xyz(gradient);
            let d = difference(free.p7, fixed.p2);
            let gradient = self.d7_2.gradient(d);
            let [d2_p7_x, d2_p7_y, d2_p7_z] = xyz(gradient);
            let d = difference(free.p8, fixed.p3);
            let gradient = self.d8_3.gradient(d);
            let [d3_p8_x, d3_p8_y, d3_p8_z] = xyz(gradient);
            let d = difference(free.p9, fixed.p4);
            let gradient = self.d9_4.gradient(d);
            let [d4_p9_x, d4_p9_y, d4_p9_z] = xyz(gradient);
            let d = difference(free.p10, fixed.p5);
            let gradient = self.d10_5.gradient(d);
            let [d5_p10_x, d5_p10_y, d5_p10_z] = xyz(gradient);
            let d = difference(free.p7, free.p6);
            let gradient = self.d7_6.gradient(d);
            let [d76_p7_x, d76_p7_y, d76_p7_z] = xyz(gradient);
            let [d76_p6_x, d76_p6_y, d76_p6_z] = xyz(opposite(gradient));
            let d = difference(free.p8, free.p6);
            let gradient = self.d8_6.gradient(d);
            let [d86_p8_x, d86_p8_y, d86_p8_z] = xyz(gradient);
            let [d86_p6_x, d86_p6_y, d86_p6_z] = xyz(opposite(gradient));
            let d = difference(free.p9, free.p6);
            let gradient = self.d9_6.gradient(d);
            let [d96_p9_x, d96_p9_y, d96_p9_z] = xyz(gradient);
            let [d96_p6_x, d96_p6_y, d96_p6_z] = xyz(opposite(gradient));
            let d = difference(free.p10, free.p6);
            let gradient = self.d10_6.gradient(d);
            let [d16_p10_x, d16_p10_y, d16_p10_z] = xyz(gradient);
            let [d16_p6_x, d16_p6_y, d16_p6_z] = xyz(opposite(gradient));
            let d = difference(free.p8, free.p7);
            let gradient = self.d8_7.gradient(d);
            let [d87_p8_x, d87_p8_y, d87_p8_z] = xyz(gradient);
            let [d87_p7_x, d87_p7_y, d87_p7_z] = xyz(opposite(gradient));
            let d = difference(free.p9, free.p7);
            let gradient = self.d9_7.gradient(d);
            let [d97_p9_x, d97_p9_y, d97_p9_z] = xyz(gradient);
            let [d97_p7_x, d97_p7_y, d97_p7_z] = xyz(opposite(gradient));
            let d = difference(free.p10, free.p7);
            let gradient = self.d10_7.gradient(d);
            let [d17_p10_x, d17_p10_y, d17_p10_z] = xyz(gradient);
            let [d17_p7_x, d17_p7_y, d17_p7_z] = xyz(opposite(gradient));
            let d = difference(free.p9, free.p8);
            let gradient = self.d9_8.gradient(d);
            let [d98_p9_x, d98_p9_y, d98_p9_z] = xyz(gradient);
            let [d98_p8_x, d98_p8_y, d98_p8_z] = xyz(opposite(gradient));
            let d = difference(free.p10, free.p8);
            let gradient = self.d10_8.gradient(d);
            let [d18_p10_x, d18_p10_y, d18_p10_z] = xyz(gradient);
            let [d18_p8_x, d18_p8_y, d18_p8_z] = xyz(opposite(gradient));
            let d1_p6_y = T::one() / d1_p6_y;
            let d76_p6_y = d76_p6_y * d1_p6_y;
            let d76_p6_x = d76_p6_x.minus_product(d76_p6_y, d1_p6_x);
            let d86_p6_y = d86_p6_y * d1_p6_y;
            let d86_p6_x = d86_p6_x.minus_product(d86_p6_y, d1_p6_x);
            let d96_p6_y = d96_p6_y * d1_p6_y;
            let d96_p6_x = d96_p6_x.minus_product(d96_p6_y, d1_p6_x);
            let d16_p6_y = d16_p6_y * d1_p6_y;
            let d16_p6_x = d16_p6_x.minus_product(d16_p6_y, d1_p6_x);
            let d1_p6_x = d1_p6_x * d1_p6_y;
            let d16_p10_z = T::one() / d16_p10_z;
            let d5_p10_z = d5_p10_z * d16_p10_z;
            let d5_p6_x = -(d5_p10_z * d16_p6_x);
            let d5_p10_x = d5_p10_x.minus_product(d5_p10_z, d16_p10_x);
            let d5_p10_y = d5_p10_y.minus_product(d5_p10_z, d16_p10_y);
            let d17_p10_z = d17_p10_z * d16_p10_z;
            let d17_p6_x = -(d17_p10_z * d16_p6_x);
            let d17_p10_x = d17_p10_x.minus_product(d17_p10_z, d16_p10_x);
            let d17_p10_y = d17_p10_y.minus_product(d17_p10_z, d16_p10_y);
            let d18_p10_z = d18_p10_z * d16_p10_z;
            let d18_p6_x = -(d18_p10_z * d16_p6_x);
            let d18_p10_x = d18_p10_x.minus_product(d18_p10_z, d16_p10_x);
            let d18_p10_y = d18_p10_y.minus_product(d18_p10_z, d16_p10_y);
            let d16_p6_x = d16_p6_x * d16_p10_z;
            let d16_p10_x = d16_p10_x * d16_p10_z;
            let d16_p10_y = d16_p10_y * d16_p10_z;
            let d3_p8_x = T::one() / d3_p8_x;
            let d86_p8_x = d86_p8_x * d3_p8_x;
            let d86_p8_y = d86_p8_y.minus_product(d86_p8_x, d3_p8_y);
            let d86_p8_z = d86_p8_z.minus_product(d86_p8_x, d3_p8_z);
            let d87_p8_x = d87_p8_x * d3_p8_x;
            let d87_p8_y = d87_p8_y.minus_product(d87_p8_x, d3_p8_y);
            let d87_p8_z = d87_p8_z.minus_product(d87_p8_x, d3_p8_z);
            let d98_p8_x = d98_p8_x * d3_p8_x;
            let d98_p8_y = d98_p8_y.minus_product(d98_p8_x, d3_p8_y);
            let d98_p8_z = d98_p8_z.minus_product(d98_p8_x, d3_p8_z);
            let d18_p8_x = d18_p8_x * d3_p8_x;
            let d18_p8_y = d18_p8_y.minus_product(d18_p8_x, d3_p8_y);
            let d18_p8_z = d18_p8_z.minus_product(d18_p8_x, d3_p8_z);
            let d3_p8_y = d3_p8_y * d3_p8_x;
            let d3_p8_z = d3_p8_z * d3_p8_x;
            let d4_p9_x = T::one() / d4_p9_x;
            let d96_p9_x = d96_p9_x * d4_p9_x;
            let d96_p9_y = d96_p9_y.minus_product(d96_p9_x, d4_p9_y);
            let d96_p9_z = d96_p9_z.minus_product(d96_p9_x, d4_p9_z);
            let d97_p9_x = d97_p9_x * d4_p9_x;
            let d97_p9_y = d97_p9_y.minus_product(d97_p9_x, d4_p9_y);
            let d97_p9_z = d97_p9_z.minus_product(d97_p9_x, d4_p9_z);
            let d98_p9_x = d98_p9_x * d4_p9_x;
            let d98_p9_y = d98_p9_y.minus_product(d98_p9_x, d4_p9_y);
            let d98_p9_z = d98_p9_z.minus_product(d98_p9_x, d4_p9_z);
            let d4_p9_y = d4_p9_y * d4_p9_x;
            let d4_p9_z = d4_p9_z * d4_p9_x;
            let d96_p9_z = T::one() / d96_p9_z;
            let d97_p9_z = d97_p9_z * d96_p9_z;
            let d97_p6_x = -(d97_p9_z * d96_p6_x);
            let d97_p9_y = d97_p9_y.minus_product(d97_p9_z, d96_p9_y);
            let d98_p9_z = d98_p9_z * d96_p9_z;
            let d98_p6_x = -(d98_p9_z * d96_p6_x);
            let d98_p9_y = d98_p9_y.minus_product(d98_p9_z, d96_p9_y);
            let d96_p6_x = d96_p6_x * d96_p9_z;
            let d96_p9_y = d96_p9_y * d96_p9_z;
            let d5_p10_y = T::one() / d5_p10_y;
            let d17_p10_y = d17_p10_y * d5_p10_y;
            let d17_p6_x = d17_p6_x.minus_product(d17_p10_y, d5_p6_x);
            let d17_p10_x = d17_p10_x.minus_product(d17_p10_y, d5_p10_x);
            let d18_p10_y = d18_p10_y * d5_p10_y;
            let d18_p6_x = d18_p6_x.minus_product(d18_p10_y, d5_p6_x);
            let d18_p10_x = d18_p10_x.minus_product(d18_p10_y, d5_p10_x);
            let d5_p6_x = d5_p6_x * d5_p10_y;
            let d5_p10_x = d5_p10_x * d5_p10_y;
            let d76_p7_z = T::one() / d76_p7_z;
            let d2_p7_z = d2_p7_z * d76_p7_z;
            let d2_p6_x = -(d2_p7_z * d76_p6_x);
            let d2_p7_x = d2_p7_x.minus_product(d2_p7_z, d76_p7_x);
            let d2_p7_y = d2_p7_y.minus_product(d2_p7_z, d76_p7_y);
            let d87_p7_z = d87_p7_z * d76_p7_z;
            let d87_p6_x = -(d87_p7_z * d76_p6_x);
            let d87_p7_x = d87_p7_x.minus_product(d87_p7_z, d76_p7_x);
            let d87_p7_y = d87_p7_y.minus_product(d87_p7_z, d76_p7_y);
            let d97_p7_z = d97_p7_z * d76_p7_z;
            let d97_p6_x = d97_p6_x.minus_product(d97_p7_z, d76_p6_x);
            let d97_p7_x = d97_p7_x.minus_product(d97_p7_z, d76_p7_x);
            let d97_p7_y = d97_p7_y.minus_product(d97_p7_z, d76_p7_y);
            let d17_p7_z = d17_p7_z * d76_p7_z;
            let d17_p6_x = d17_p6_x.minus_product(d17_p7_z, d76_p6_x);
            let d17_p7_x = d17_p7_x.minus_product(d17_p7_z, d76_p7_x);
            let d17_p7_y = d17_p7_y.minus_product(d17_p7_z, d76_p7_y);
            let d76_p6_x = d76_p6_x * d76_p7_z;
            let d76_p7_x = d76_p7_x * d76_p7_z;
            let d76_p7_y = d76_p7_y * d76_p7_z;
            let d2_p7_y = T::one() / d2_p7_y;
            let d87_p7_y = d87_p7_y * d2_p7_y;
            let d87_p6_x = d87_p6_x.minus_product(d87_p7_y, d2_p6_x);
            let d87_p7_x = d87_p7_x.minus_product(d87_p7_y, d2_p7_x);
            let d97_p7_y = d97_p7_y * d2_p7_y;
            let d97_p6_x = d97_p6_x.minus_product(d97_p7_y, d2_p6_x);
            let d97_p7_x = d97_p7_x.minus_product(d97_p7_y, d2_p7_x);
            let d17_p7_y = d17_p7_y * d2_p7_y;
            let d17_p6_x = d17_p6_x.minus_product(d17_p7_y, d2_p6_x);
            let d17_p7_x = d17_p7_x.minus_product(d17_p7_y, d2_p7_x);
            let d2_p6_x = d2_p6_x * d2_p7_y;
            let d2_p7_x = d2_p7_x * d2_p7_y;
            let d86_p8_z = T::one() / d86_p8_z;
            let d87_p8_z = d87_p8_z * d86_p8_z;
            let d87_p6_x = d87_p6_x.minus_product(d87_p8_z, d86_p6_x);
            let d87_p8_y = d87_p8_y.minus_product(d87_p8_z, d86_p8_y);
            let d98_p8_z = d98_p8_z * d86_p8_z;
            let d98_p6_x = d98_p6_x.minus_product(d98_p8_z, d86_p6_x);
            let d98_p8_y = d98_p8_y.minus_product(d98_p8_z, d86_p8_y);
            let d18_p8_z = d18_p8_z * d86_p8_z;
            let d18_p6_x = d18_p6_x.minus_product(d18_p8_z, d86_p6_x);
            let d18_p8_y = d18_p8_y.minus_product(d18_p8_z, d86_p8_y);
            let d86_p6_x = d86_p6_x * d86_p8_z;
            let d86_p8_y = d86_p8_y * d86_p8_z;
            let d97_p9_y = T::one() / d97_p9_y;
            let d98_p9_y = d98_p9_y * d97_p9_y;
            let d98_p6_x = d98_p6_x.minus_product(d98_p9_y, d97_p6_x);
            let d98_p7_x = -(d98_p9_y * d97_p7_x);
            let d97_p6_x = d97_p6_x * d97_p9_y;
            let d97_p7_x = d97_p7_x * d97_p9_y;
            let d17_p10_x = T::one() / d17_p10_x;
            let d18_p10_x = d18_p10_x * d17_p10_x;
            let d18_p6_x = d18_p6_x.minus_product(d18_p10_x, d17_p6_x);
            let d18_p7_x = -(d18_p10_x * d17_p7_x);
            let d17_p6_x = d17_p6_x * d17_p10_x;
            let d17_p7_x = d17_p7_x * d17_p10_x;
            let d18_p8_y = T::one() / d18_p8_y;
            let d87_p8_y = d87_p8_y * d18_p8_y;
            let d87_p6_x = d87_p6_x.minus_product(d87_p8_y, d18_p6_x);
            let d87_p7_x = d87_p7_x.minus_product(d87_p8_y, d18_p7_x);
            let d98_p8_y = d98_p8_y * d18_p8_y;
            let d98_p6_x = d98_p6_x.minus_product(d98_p8_y, d18_p6_x);
            let d98_p7_x = d98_p7_x.minus_product(d98_p8_y, d18_p7_x);
            let d18_p6_x = d18_p6_x * d18_p8_y;
            let d18_p7_x = d18_p7_x * d18_p8_y;
            let d98_p7_x = T::one() / d98_p7_x;
            let d87_p7_x = d87_p7_x * d98_p7_x;
            let d87_p6_x = d87_p6_x.minus_product(d87_p7_x, d98_p6_x);
            let d98_p6_x = d98_p6_x * d98_p7_x;
            let d87_p6_x = T::one() / d87_p6_x;
            let pivots = [
                d1_p6_y,
                d16_p10_z,
                d3_p8_x,
                d4_p9_x,
                d96_p9_z,
                d5_p10_y,
                d76_p7_z,
                d2_p7_y,
                d86_p8_z,
                d97_p9_y,
                d17_p10_x,
                d18_p8_y,
                d98_p7_x,
                d87_p6_x,
            ];
            Factors {
                growth_squared: sum_of_squares(pivots),
                determinant_sign: -product(pivots),
                d1_p6_z,
                d76_p6_z,
                d86_p6_z,
                d96_p6_z,
                d16_p6_z,
                d1_p6_y,
                d1_p6_x,
                d76_p6_y,
                d86_p6_y,
                d96_p6_y,
                d16_p6_y,
                d16_p10_z,
                d16_p6_x,
                d16_p10_x,
                d16_p10_y,
                d5_p10_z,
                d17_p10_z,
                d18_p10_z,
                d3_p8_x,
                d3_p8_y,
                d3_p8_z,
                d86_p8_x,
                d87_p8_x,
                d98_p8_x,
                d18_p8_x,
                d4_p9_x,
                d4_p9_y,
                d4_p9_z,
                d96_p9_x,
                d97_p9_x,
                d98_p9_x,
                d96_p9_z,
                d96_p6_x,
                d96_p9_y,
                d97_p9_z,
                d98_p9_z,
                d5_p10_y,
                d5_p6_x,
                d5_p10_x,
                d17_p10_y,
                d18_p10_y,
                d76_p7_z,
                d76_p6_x,
                d76_p7_x,
                d76_p7_y,
                d2_p7_z,
                d87_p7_z,
                d97_p7_z,
                d17_p7_z,
                d2_p7_y,
                d2_p6_x,
                d2_p7_x,
                d87_p7_y,
                d97_p7_y,
                d17_p7_y,
                d86_p8_z,
                d86_p6_x,
                d86_p8_y,
                d87_p8_z,
                d98_p8_z,
                d18_p8_z,
                d97_p9_y,
                d97_p6_x,
                d97_p7_x,
                d98_p9_y,
                d17_p10_x,
                d17_p6_x,
                d17_p7_x,
                d18_p10_x,
                d18_p8_y,
                d18_p6_x,
                d18_p7_x,
                d87_p8_y,
                d98_p8_y,
                d98_p7_x,
                d98_p6_x,
                d87_p7_x,
                d87_p6_x,
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
            let v_d = difference(v.p6, v_fixed.p1);
            let w_d = difference(w.p6, w_fixed.p1);
            rows[equation::D6_1] = self.d6_1.curvature(v_d, w_d);
            let v_d = difference(v.p7, v_fixed.p2);
            let w_d = difference(w.p7, w_fixed.p2);
            rows[equation::D7_2] = self.d7_2.curvature(v_d, w_d);
            let v_d = difference(v.p8, v_fixed.p3);
            let w_d = difference(w.p8, w_fixed.p3);
            rows[equation::D8_3] = self.d8_3.curvature(v_d, w_d);
            let v_d = difference(v.p9, v_fixed.p4);
            let w_d = difference(w.p9, w_fixed.p4);
            rows[equation::D9_4] = self.d9_4.curvature(v_d, w_d);
            let v_d = difference(v.p10, v_fixed.p5);
            let w_d = difference(w.p10, w_fixed.p5);
            rows[equation::D10_5] = self.d10_5.curvature(v_d, w_d);
            let v_d = difference(v.p7, v.p6);
            let w_d = difference(w.p7, w.p6);
            rows[equation::D7_6] = self.d7_6.curvature(v_d, w_d);
            let v_d = difference(v.p8, v.p6);
            let w_d = difference(w.p8, w.p6);
            rows[equation::D8_6] = self.d8_6.curvature(v_d, w_d);
            let v_d = difference(v.p9, v.p6);
            let w_d = difference(w.p9, w.p6);
            rows[equation::D9_6] = self.d9_6.curvature(v_d, w_d);
            let v_d = difference(v.p10, v.p6);
            let w_d = difference(w.p10, w.p6);
            rows[equation::D10_6] = self.d10_6.curvature(v_d, w_d);
            let v_d = difference(v.p8, v.p7);
            let w_d = difference(w.p8, w.p7);
            rows[equation::D8_7] = self.d8_7.curvature(v_d, w_d);
            let v_d = difference(v.p9, v.p7);
            let w_d = difference(w.p9, w.p7);
            rows[equation::D9_7] = self.d9_7.curvature(v_d, w_d);
            let v_d = difference(v.p10, v.p7);
            let w_d = difference(w.p10, w.p7);
            rows[equation::D10_7] = self.d10_7.curvature(v_d, w_d);
            let v_d = difference(v.p9, v.p8);
            let w_d = difference(w.p9, w.p8);
            rows[equation::D9_8] = self.d9_8.curvature(v_d, w_d);
            let v_d = difference(v.p10, v.p8);
            let w_d = difference(w.p10, w.p8);
            rows[equation::D10_8] = self.d10_8.curvature(v_d, w_d);
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
            let d = difference(free.p6, fixed.p1);
            let gradient = self.d6_1.gradient(d);
            rows[equation::D6_1] = dot(gradient, fixed_rate.p1);
            let d = difference(free.p7, fixed.p2);
            let gradient = self.d7_2.gradient(d);
            rows[equation::D7_2] = dot(gradient, fixed_rate.p2);
            let d = difference(free.p8, fixed.p3);
            let gradient = self.d8_3.gradient(d);
            rows[equation::D8_3] = dot(gradient, fixed_rate.p3);
            let d = difference(free.p9, fixed.p4);
            let gradient = self.d9_4.gradient(d);
            rows[equation::D9_4] = dot(gradient, fixed_rate.p4);
            let d = difference(free.p10, fixed.p5);
            let gradient = self.d10_5.gradient(d);
            rows[equation::D10_5] = dot(gradient, fixed_rate.p5);
            rows[equation::THETA] = fixed_rate.p1.z;
            SVector::from(rows)
        }

        fn points(&self, q: &SVector<T, 15>, fixed: &Fixed<T>) -> Points<T> {
            let free = Free::of(q);
            let markers = [self.p11.position(&free.p6_p7_p8_frame())];
            Points::all(fixed, &free, markers)
        }

        fn velocities(
            &self,
            at: &Points<T>,
            velocity: &SVector<T, 15>,
            fixed_rate: &Fixed<T>,
        ) -> Points<T> {
            let free = Free::of(velocity);
            let markers = [
                self.p11.velocity(&at.p6_p7_p8_frame(), &free.p6_p7_p8_frame()),
            ];
            Points::all(fixed_rate, &free, markers)
        }

        fn accelerations(
            &self,
            at: &Points<T>,
            velocities: &Points<T>,
            acceleration: &SVector<T, 15>,
            fixed_second_rate: &Fixed<T>,
        ) -> Points<T> {
            let free = Free::of(acceleration);
            let markers = [
                self
                    .p11
                    .acceleration(
                        &at.p6_p7_p8_frame(),
                        &velocities.p6_p7_p8_frame(),
                        &free.p6_p7_p8_frame(),
                    ),
            ];
            Points::all(fixed_second_rate, &free, markers)
        }

        #[cfg_attr(not(debug_assertions), inline(always))]
        fn carry_forces(
            &self,
            q: &SVector<T, 15>,
            _fixed: &Fixed<T>,
            forces: &mut Points<T>,
        ) {
            let free = Free::of(q);
            self.p11
                .carry_force(
                    forces.p11,
                    &free.p6_p7_p8_frame(),
                    [&mut forces.p6, &mut forces.p7, &mut forces.p8],
                );
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
            let measured = points.map(|points| points.p11.z);
            measures.set(measured, |measures| &mut measures.height);
            measures
        }

        #[inline(always)]
        fn linked(&self) -> impl Iterator<Item = usize> {
            [8, 9].into_iter()
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
    ///
    /// An entry is named by its equation: `d1` d6_1, `d2` d7_2, `d3` d8_3, `d4` d9_4, `d5` d10_5, `d76` d7_6, `d86` d8_6, `d96` d9_6, `d16` d10_6, `d87` d8_7, `d97` d9_7, `d17` d10_7, `d98` d9_8, `d18` d10_8, `theta` theta;
    /// and its unknown: `p6` p6, `p7` p7, `p8` p8, `p9` p9, `p10` p10.
    #[derive(Clone, Copy, Debug)]
    pub struct Factors<T> {
        growth_squared: T,
        determinant_sign: T,
        d1_p6_z: T,
        d76_p6_z: T,
        d86_p6_z: T,
        d96_p6_z: T,
        d16_p6_z: T,
        d1_p6_y: T,
        d1_p6_x: T,
        d76_p6_y: T,
        d86_p6_y: T,
        d96_p6_y: T,
        d16_p6_y: T,
        d16_p10_z: T,
        d16_p6_x: T,
        d16_p10_x: T,
        d16_p10_y: T,
        d5_p10_z: T,
        d17_p10_z: T,
        d18_p10_z: T,
        d3_p8_x: T,
        d3_p8_y: T,
        d3_p8_z: T,
        d86_p8_x: T,
        d87_p8_x: T,
        d98_p8_x: T,
        d18_p8_x: T,
        d4_p9_x: T,
        d4_p9_y: T,
        d4_p9_z: T,
        d96_p9_x: T,
        d97_p9_x: T,
        d98_p9_x: T,
        d96_p9_z: T,
        d96_p6_x: T,
        d96_p9_y: T,
        d97_p9_z: T,
        d98_p9_z: T,
        d5_p10_y: T,
        d5_p6_x: T,
        d5_p10_x: T,
        d17_p10_y: T,
        d18_p10_y: T,
        d76_p7_z: T,
        d76_p6_x: T,
        d76_p7_x: T,
        d76_p7_y: T,
        d2_p7_z: T,
        d87_p7_z: T,
        d97_p7_z: T,
        d17_p7_z: T,
        d2_p7_y: T,
        d2_p6_x: T,
        d2_p7_x: T,
        d87_p7_y: T,
        d97_p7_y: T,
        d17_p7_y: T,
        d86_p8_z: T,
        d86_p6_x: T,
        d86_p8_y: T,
        d87_p8_z: T,
        d98_p8_z: T,
        d18_p8_z: T,
        d97_p9_y: T,
        d97_p6_x: T,
        d97_p7_x: T,
        d98_p9_y: T,
        d17_p10_x: T,
        d17_p6_x: T,
        d17_p7_x: T,
        d18_p10_x: T,
        d18_p8_y: T,
        d18_p6_x: T,
        d18_p7_x: T,
        d87_p8_y: T,
        d98_p8_y: T,
        d98_p7_x: T,
        d98_p6_x: T,
        d87_p7_x: T,
        d87_p6_x: T,
    }

    impl<T: Scalar> JacobianFactors<T, 15> for Factors<T> {
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn solve(&self, right: &SVector<T, 15>) -> SVector<T, 15> {
            let [[d1, d2, d3, d4, d5, d76, d86, d96, d16, d87, d97, d17, d98, d18, theta],
            ] = right.data.0;
            let d1 = d1.minus_product(self.d1_p6_z, theta);
            let d76 = d76.minus_product(self.d76_p6_z, theta);
            let d86 = d86.minus_product(self.d86_p6_z, theta);
            let d96 = d96.minus_product(self.d96_p6_z, theta);
            let d16 = d16.minus_product(self.d16_p6_z, theta);
            let d76 = d76.minus_product(self.d76_p6_y, d1);
            let d86 = d86.minus_product(self.d86_p6_y, d1);
            let d96 = d96.minus_product(self.d96_p6_y, d1);
            let d16 = d16.minus_product(self.d16_p6_y, d1);
            let d5 = d5.minus_product(self.d5_p10_z, d16);
            let d17 = d17.minus_product(self.d17_p10_z, d16);
            let d18 = d18.minus_product(self.d18_p10_z, d16);
            let d86 = d86.minus_product(self.d86_p8_x, d3);
            let d87 = d87.minus_product(self.d87_p8_x, d3);
            let d98 = d98.minus_product(self.d98_p8_x, d3);
            let d18 = d18.minus_product(self.d18_p8_x, d3);
            let d96 = d96.minus_product(self.d96_p9_x, d4);
            let d97 = d97.minus_product(self.d97_p9_x, d4);
            let d98 = d98.minus_product(self.d98_p9_x, d4);
            let d97 = d97.minus_product(self.d97_p9_z, d96);
            let d98 = d98.minus_product(self.d98_p9_z, d96);
            let d17 = d17.minus_product(self.d17_p10_y, d5);
            let d18 = d18.minus_product(self.d18_p10_y, d5);
            let d2 = d2.minus_product(self.d2_p7_z, d76);
            let d87 = d87.minus_product(self.d87_p7_z, d76);
            let d97 = d97.minus_product(self.d97_p7_z, d76);
            let d17 = d17.minus_product(self.d17_p7_z, d76);
            let d87 = d87.minus_product(self.d87_p7_y, d2);
            let d97 = d97.minus_product(self.d97_p7_y, d2);
            let d17 = d17.minus_product(self.d17_p7_y, d2);
            let d87 = d87.minus_product(self.d87_p8_z, d86);
            let d98 = d98.minus_product(self.d98_p8_z, d86);
            let d18 = d18.minus_product(self.d18_p8_z, d86);
            let d98 = d98.minus_product(self.d98_p9_y, d97);
            let d18 = d18.minus_product(self.d18_p10_x, d17);
            let d87 = d87.minus_product(self.d87_p8_y, d18);
            let d98 = d98.minus_product(self.d98_p8_y, d18);
            let d87 = d87.minus_product(self.d87_p7_x, d98);
            let p6_x = d87 * self.d87_p6_x;
            let p7_x = (d98 * self.d98_p7_x).minus_product(self.d98_p6_x, p6_x);
            let p8_y = (d18 * self.d18_p8_y)
                .minus_product(self.d18_p6_x, p6_x)
                .minus_product(self.d18_p7_x, p7_x);
            let p10_x = (d17 * self.d17_p10_x)
                .minus_product(self.d17_p6_x, p6_x)
                .minus_product(self.d17_p7_x, p7_x);
            let p9_y = (d97 * self.d97_p9_y)
                .minus_product(self.d97_p6_x, p6_x)
                .minus_product(self.d97_p7_x, p7_x);
            let p8_z = (d86 * self.d86_p8_z)
                .minus_product(self.d86_p6_x, p6_x)
                .minus_product(self.d86_p8_y, p8_y);
            let p7_y = (d2 * self.d2_p7_y)
                .minus_product(self.d2_p6_x, p6_x)
                .minus_product(self.d2_p7_x, p7_x);
            let p7_z = (d76 * self.d76_p7_z)
                .minus_product(self.d76_p6_x, p6_x)
                .minus_product(self.d76_p7_x, p7_x)
                .minus_product(self.d76_p7_y, p7_y);
            let p10_y = (d5 * self.d5_p10_y)
                .minus_product(self.d5_p6_x, p6_x)
                .minus_product(self.d5_p10_x, p10_x);
            let p9_z = (d96 * self.d96_p9_z)
                .minus_product(self.d96_p6_x, p6_x)
                .minus_product(self.d96_p9_y, p9_y);
            let p9_x = (d4 * self.d4_p9_x)
                .minus_product(self.d4_p9_y, p9_y)
                .minus_product(self.d4_p9_z, p9_z);
            let p8_x = (d3 * self.d3_p8_x)
                .minus_product(self.d3_p8_y, p8_y)
                .minus_product(self.d3_p8_z, p8_z);
            let p10_z = (d16 * self.d16_p10_z)
                .minus_product(self.d16_p6_x, p6_x)
                .minus_product(self.d16_p10_x, p10_x)
                .minus_product(self.d16_p10_y, p10_y);
            let p6_y = (d1 * self.d1_p6_y).minus_product(self.d1_p6_x, p6_x);
            let p6_z = theta;
            vector_of![
                p6_x, p6_y, p6_z, p7_x, p7_y, p7_z, p8_x, p8_y, p8_z, p9_x, p9_y, p9_z,
                p10_x, p10_y, p10_z
            ]
        }

        #[cfg_attr(not(debug_assertions), inline(always))]
        fn solve_transposed(&self, right: &SVector<T, 15>) -> SVector<T, 15> {
            let [[p6_x, p6_y, p6_z, p7_x, p7_y, p7_z, p8_x, p8_y, p8_z, p9_x, p9_y, p9_z,
            p10_x, p10_y, p10_z]] = right.data.0;
            let p6_x = p6_x.minus_product(self.d1_p6_x, p6_y);
            let p6_x = p6_x.minus_product(self.d16_p6_x, p10_z);
            let p10_x = p10_x.minus_product(self.d16_p10_x, p10_z);
            let p10_y = p10_y.minus_product(self.d16_p10_y, p10_z);
            let p8_y = p8_y.minus_product(self.d3_p8_y, p8_x);
            let p8_z = p8_z.minus_product(self.d3_p8_z, p8_x);
            let p9_y = p9_y.minus_product(self.d4_p9_y, p9_x);
            let p9_z = p9_z.minus_product(self.d4_p9_z, p9_x);
            let p6_x = p6_x.minus_product(self.d96_p6_x, p9_z);
            let p9_y = p9_y.minus_product(self.d96_p9_y, p9_z);
            let p6_x = p6_x.minus_product(self.d5_p6_x, p10_y);
            let p10_x = p10_x.minus_product(self.d5_p10_x, p10_y);
            let p6_x = p6_x.minus_product(self.d76_p6_x, p7_z);
            let p7_x = p7_x.minus_product(self.d76_p7_x, p7_z);
            let p7_y = p7_y.minus_product(self.d76_p7_y, p7_z);
            let p6_x = p6_x.minus_product(self.d2_p6_x, p7_y);
            let p7_x = p7_x.minus_product(self.d2_p7_x, p7_y);
            let p6_x = p6_x.minus_product(self.d86_p6_x, p8_z);
            let p8_y = p8_y.minus_product(self.d86_p8_y, p8_z);
            let p6_x = p6_x.minus_product(self.d97_p6_x, p9_y);
            let p7_x = p7_x.minus_product(self.d97_p7_x, p9_y);
            let p6_x = p6_x.minus_product(self.d17_p6_x, p10_x);
            let p7_x = p7_x.minus_product(self.d17_p7_x, p10_x);
            let p6_x = p6_x.minus_product(self.d18_p6_x, p8_y);
            let p7_x = p7_x.minus_product(self.d18_p7_x, p8_y);
            let p6_x = p6_x.minus_product(self.d98_p6_x, p7_x);
            let theta = p6_z;
            let d1 = p6_y * self.d1_p6_y;
            let d16 = p10_z * self.d16_p10_z;
            let d3 = p8_x * self.d3_p8_x;
            let d4 = p9_x * self.d4_p9_x;
            let d96 = p9_z * self.d96_p9_z;
            let d5 = p10_y * self.d5_p10_y;
            let d76 = p7_z * self.d76_p7_z;
            let d2 = p7_y * self.d2_p7_y;
            let d86 = p8_z * self.d86_p8_z;
            let d97 = p9_y * self.d97_p9_y;
            let d17 = p10_x * self.d17_p10_x;
            let d18 = p8_y * self.d18_p8_y;
            let d98 = p7_x * self.d98_p7_x;
            let d87 = p6_x * self.d87_p6_x;
            let d98 = d98.minus_product(self.d87_p7_x, d87);
            let d18 = d18.minus_product(self.d87_p8_y, d87);
            let d18 = d18.minus_product(self.d98_p8_y, d98);
            let d17 = d17.minus_product(self.d18_p10_x, d18);
            let d97 = d97.minus_product(self.d98_p9_y, d98);
            let d86 = d86.minus_product(self.d87_p8_z, d87);
            let d86 = d86.minus_product(self.d98_p8_z, d98);
            let d86 = d86.minus_product(self.d18_p8_z, d18);
            let d2 = d2.minus_product(self.d87_p7_y, d87);
            let d2 = d2.minus_product(self.d97_p7_y, d97);
            let d2 = d2.minus_product(self.d17_p7_y, d17);
            let d76 = d76.minus_product(self.d2_p7_z, d2);
            let d76 = d76.minus_product(self.d87_p7_z, d87);
            let d76 = d76.minus_product(self.d97_p7_z, d97);
            let d76 = d76.minus_product(self.d17_p7_z, d17);
            let d5 = d5.minus_product(self.d17_p10_y, d17);
            let d5 = d5.minus_product(self.d18_p10_y, d18);
            let d96 = d96.minus_product(self.d97_p9_z, d97);
            let d96 = d96.minus_product(self.d98_p9_z, d98);
            let d4 = d4.minus_product(self.d96_p9_x, d96);
            let d4 = d4.minus_product(self.d97_p9_x, d97);
            let d4 = d4.minus_product(self.d98_p9_x, d98);
            let d3 = d3.minus_product(self.d86_p8_x, d86);
            let d3 = d3.minus_product(self.d87_p8_x, d87);
            let d3 = d3.minus_product(self.d98_p8_x, d98);
            let d3 = d3.minus_product(self.d18_p8_x, d18);
            let d16 = d16.minus_product(self.d5_p10_z, d5);
            let d16 = d16.minus_product(self.d17_p10_z, d17);
            let d16 = d16.minus_product(self.d18_p10_z, d18);
            let d1 = d1.minus_product(self.d76_p6_y, d76);
            let d1 = d1.minus_product(self.d86_p6_y, d86);
            let d1 = d1.minus_product(self.d96_p6_y, d96);
            let d1 = d1.minus_product(self.d16_p6_y, d16);
            let theta = theta.minus_product(self.d1_p6_z, d1);
            let theta = theta.minus_product(self.d76_p6_z, d76);
            let theta = theta.minus_product(self.d86_p6_z, d86);
            let theta = theta.minus_product(self.d96_p6_z, d96);
            let theta = theta.minus_product(self.d16_p6_z, d16);
            vector_of![
                d1, d2, d3, d4, d5, d76, d86, d96, d16, d87, d97, d17, d98, d18, theta
            ]
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
            unknowns: unknown_names!["p6", "p7", "p8", "p9", "p10";],
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
        fn of(_listing: Listing, at: &Points<T>) -> Result<Self, GeometryError> {
            parts::finite(at.values())?;
            let p6_p7_p8_frame = parts::frame(7, at.p6_p7_p8_frame())?;
            let model = Self {
                fixed: Fixed::from_values(at.values()),
                size: T::zero(),
                d6_1: parts::distance(0, at.p1, at.p6)?,
                d7_2: parts::distance(1, at.p2, at.p7)?,
                d8_3: parts::distance(2, at.p3, at.p8)?,
                d9_4: parts::distance(3, at.p4, at.p9)?,
                d10_5: parts::distance(4, at.p5, at.p10)?,
                d7_6: parts::distance(5, at.p6, at.p7)?,
                d8_6: parts::distance(6, at.p6, at.p8)?,
                d9_6: parts::distance(7, at.p6, at.p9)?,
                d10_6: parts::distance(8, at.p6, at.p10)?,
                d8_7: parts::distance(9, at.p7, at.p8)?,
                d9_7: parts::distance(10, at.p7, at.p9)?,
                d10_7: parts::distance(11, at.p7, at.p10)?,
                d9_8: parts::distance(12, at.p8, at.p9)?,
                d10_8: parts::distance(13, at.p8, at.p10)?,
                p6_p7_p8_frame,
                p6_p7_p8_p9: parts::linked(8, at.p9, &p6_p7_p8_frame)?,
                p6_p7_p8_p10: parts::linked(9, at.p10, &p6_p7_p8_frame)?,
                p11: parts::carried(10, at.p11, &at.p6_p7_p8_frame())?,
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

        fn with_markers(self, at: &Points<T>) -> Result<Self, GeometryError> {
            parts::finite(at.values())?;
            Ok(Self {
                p11: parts::carried(10, at.p11, &at.p6_p7_p8_frame())?,
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
