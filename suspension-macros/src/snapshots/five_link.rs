/// Five links between chassis and knuckle, the knuckle closed so that it keeps its
/// handedness. The topology of [`attia2003`](super::attia2003) in descriptive names.
///
/// Axes as ISO 8855: x forward, y left, z up.
///
/// 15 unknowns `q`: the coordinates of `lower_front_outer`, `upper_front_outer`, `upper_rear_outer`, `lower_rear_outer`, `track_rod_outer`.
///
/// 15 equations `F(q) = 0`: `lower_front`, `upper_front`, `upper_rear`, `lower_rear`, `track_rod`, `knuckle_lower_front_outer_upper_front_outer`, `knuckle_lower_front_outer_upper_rear_outer`, `knuckle_upper_front_outer_upper_rear_outer`, `knuckle_lower_rear_outer_x`, `knuckle_lower_rear_outer_y`, `knuckle_lower_rear_outer_z`, `knuckle_track_rod_outer_x`, `knuckle_track_rod_outer_y`, `knuckle_track_rod_outer_z`, `theta`.
///
/// Jacobian: 15 x 15, 94 non-zeros of 225; 53 are stored of its factors. The longest chain of operations in the factorisation is 32, a division counted as 4; in a solution it is 21.
///
/// | no branch | multiplications | additions | divisions |
/// |---|---|---|---|
/// | residual | 86 | 86 | 0 |
/// | Jacobian | 36 | 40 | 0 |
/// | curvature | 62 | 94 | 0 |
/// | factor | 166 | 116 | 8 |
/// | solve | 95 | 93 | 0 |
#[allow(clippy::approx_constant, dead_code, non_snake_case, unreachable_pub)]
pub mod five_link {
    use ::suspension_core::generated::*;
    use ::suspension_core::generated::{unknown_names, vector_of};
    /// Every point, with a position, velocity or acceleration each.
    #[derive(Clone, Copy, Debug, PartialEq, Named)]
    pub struct Points<T = f64> {
        /// Chassis point `lower_front_inner`.
        pub lower_front_inner: Vector3<T>,
        /// Chassis point `upper_front_inner`.
        pub upper_front_inner: Vector3<T>,
        /// Chassis point `upper_rear_inner`.
        pub upper_rear_inner: Vector3<T>,
        /// Chassis point `lower_rear_inner`.
        pub lower_rear_inner: Vector3<T>,
        /// Chassis point `track_rod_inner`.
        pub track_rod_inner: Vector3<T>,
        /// Free point `lower_front_outer`.
        pub lower_front_outer: Vector3<T>,
        /// Free point `upper_front_outer`.
        pub upper_front_outer: Vector3<T>,
        /// Free point `upper_rear_outer`.
        pub upper_rear_outer: Vector3<T>,
        /// Free point `lower_rear_outer`.
        pub lower_rear_outer: Vector3<T>,
        /// Free point `track_rod_outer`.
        pub track_rod_outer: Vector3<T>,
        /// Marker, carried by `lower_front_outer`, `upper_front_outer`, `upper_rear_outer`.
        pub wheel_centre: Vector3<T>,
    }

    /// Chassis points.
    #[derive(Clone, Copy, Debug, PartialEq, Named)]
    pub struct Fixed<T = f64> {
        /// Chassis point `lower_front_inner`.
        pub lower_front_inner: Vector3<T>,
        /// Chassis point `upper_front_inner`.
        pub upper_front_inner: Vector3<T>,
        /// Chassis point `upper_rear_inner`.
        pub upper_rear_inner: Vector3<T>,
        /// Chassis point `lower_rear_inner`.
        pub lower_rear_inner: Vector3<T>,
        /// Chassis point `track_rod_inner`.
        pub track_rod_inner: Vector3<T>,
    }

    /// The drives' values, or rates: coordinates in the unit of the points, angles in radians.
    #[derive(Clone, Copy, Debug, PartialEq, Named)]
    pub struct Drives<T = f64> {
        /// Angle of the lower leading link from the vertical, radians.
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
        /// From `lower_front_inner` to `lower_front_outer`.
        pub lower_front: T,
        /// From `upper_front_inner` to `upper_front_outer`.
        pub upper_front: T,
        /// From `upper_rear_inner` to `upper_rear_outer`.
        pub upper_rear: T,
        /// From `lower_rear_inner` to `lower_rear_outer`.
        pub lower_rear: T,
        /// From `track_rod_inner` to `track_rod_outer`.
        pub track_rod: T,
        /// From `lower_front_outer` to `upper_front_outer`.
        pub knuckle_lower_front_outer_upper_front_outer: T,
        /// From `lower_front_outer` to `upper_rear_outer`.
        pub knuckle_lower_front_outer_upper_rear_outer: T,
        /// From `upper_front_outer` to `upper_rear_outer`.
        pub knuckle_upper_front_outer_upper_rear_outer: T,
        /// From `lower_rear_outer` to `lower_front_outer`.
        pub knuckle_lower_rear_outer_lower_front_outer: T,
        /// From `lower_rear_outer` to `upper_front_outer`.
        pub knuckle_lower_rear_outer_upper_front_outer: T,
        /// From `lower_rear_outer` to `upper_rear_outer`.
        pub knuckle_lower_rear_outer_upper_rear_outer: T,
        /// From `track_rod_outer` to `lower_front_outer`.
        pub knuckle_track_rod_outer_lower_front_outer: T,
        /// From `track_rod_outer` to `upper_front_outer`.
        pub knuckle_track_rod_outer_upper_front_outer: T,
        /// From `track_rod_outer` to `upper_rear_outer`.
        pub knuckle_track_rod_outer_upper_rear_outer: T,
    }

    impl<T: Scalar> Points<T> {
        #[inline(always)]
        fn all(fixed: &Fixed<T>, free: &Free<T>, markers: [Vector3<T>; 1]) -> Self {
            Self {
                lower_front_inner: fixed.lower_front_inner,
                upper_front_inner: fixed.upper_front_inner,
                upper_rear_inner: fixed.upper_rear_inner,
                lower_rear_inner: fixed.lower_rear_inner,
                track_rod_inner: fixed.track_rod_inner,
                lower_front_outer: free.lower_front_outer,
                upper_front_outer: free.upper_front_outer,
                upper_rear_outer: free.upper_rear_outer,
                lower_rear_outer: free.lower_rear_outer,
                track_rod_outer: free.track_rod_outer,
                wheel_centre: markers[0],
            }
        }

        #[inline(always)]
        fn knuckle_frame(&self) -> Frame<T> {
            Frame::new(
                self.lower_front_outer,
                self.upper_front_outer,
                self.upper_rear_outer,
            )
        }
    }

    /// The free points: the unknowns under their names.
    #[derive(Clone, Copy)]
    struct Free<T> {
        lower_front_outer: Vector3<T>,
        upper_front_outer: Vector3<T>,
        upper_rear_outer: Vector3<T>,
        lower_rear_outer: Vector3<T>,
        track_rod_outer: Vector3<T>,
    }

    impl<T: Scalar> Free<T> {
        #[inline(always)]
        fn of(q: &SVector<T, 15>) -> Self {
            let [[lfo_x, lfo_y, lfo_z, ufo_x, ufo_y, ufo_z, uro_x, uro_y, uro_z, lro_x,
            lro_y, lro_z, tro_x, tro_y, tro_z]] = q.data.0;
            Self {
                lower_front_outer: Vector3::new(lfo_x, lfo_y, lfo_z),
                upper_front_outer: Vector3::new(ufo_x, ufo_y, ufo_z),
                upper_rear_outer: Vector3::new(uro_x, uro_y, uro_z),
                lower_rear_outer: Vector3::new(lro_x, lro_y, lro_z),
                track_rod_outer: Vector3::new(tro_x, tro_y, tro_z),
            }
        }

        #[inline(always)]
        fn unknowns(&self) -> SVector<T, 15> {
            vector_of![
                self.lower_front_outer.x, self.lower_front_outer.y, self
                .lower_front_outer.z, self.upper_front_outer.x, self.upper_front_outer.y,
                self.upper_front_outer.z, self.upper_rear_outer.x, self.upper_rear_outer
                .y, self.upper_rear_outer.z, self.lower_rear_outer.x, self
                .lower_rear_outer.y, self.lower_rear_outer.z, self.track_rod_outer.x,
                self.track_rod_outer.y, self.track_rod_outer.z
            ]
        }

        #[inline(always)]
        fn knuckle_frame(&self) -> Frame<T> {
            Frame::new(
                self.lower_front_outer,
                self.upper_front_outer,
                self.upper_rear_outer,
            )
        }
    }

    /// The geometry: chassis points at rest and the constants of every equation.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Model<T = f64> {
        fixed: Fixed<T>,
        size: T,
        lower_front: Distance<T>,
        upper_front: Distance<T>,
        upper_rear: Distance<T>,
        lower_rear: Distance<T>,
        track_rod: Distance<T>,
        knuckle_lower_front_outer_upper_front_outer: Distance<T>,
        knuckle_lower_front_outer_upper_rear_outer: Distance<T>,
        knuckle_upper_front_outer_upper_rear_outer: Distance<T>,
        knuckle_frame: Frame<T>,
        knuckle_lower_rear_outer: Carried<T>,
        knuckle_track_rod_outer: Carried<T>,
        wheel_centre: Carried<T>,
    }

    /// A suspension of this listing that moves.
    pub type Corner<T = f64> = corner::Corner<Model<T>, 15>;
    /// Rows of the residual and the Jacobian.
    #[allow(missing_docs)]
    pub mod equation {
        pub const LOWER_FRONT: usize = 0;
        pub const UPPER_FRONT: usize = 1;
        pub const UPPER_REAR: usize = 2;
        pub const LOWER_REAR: usize = 3;
        pub const TRACK_ROD: usize = 4;
        pub const KNUCKLE_LOWER_FRONT_OUTER_UPPER_FRONT_OUTER: usize = 5;
        pub const KNUCKLE_LOWER_FRONT_OUTER_UPPER_REAR_OUTER: usize = 6;
        pub const KNUCKLE_UPPER_FRONT_OUTER_UPPER_REAR_OUTER: usize = 7;
        pub const KNUCKLE_LOWER_REAR_OUTER_X: usize = 8;
        pub const KNUCKLE_LOWER_REAR_OUTER_Y: usize = 9;
        pub const KNUCKLE_LOWER_REAR_OUTER_Z: usize = 10;
        pub const KNUCKLE_TRACK_ROD_OUTER_X: usize = 11;
        pub const KNUCKLE_TRACK_ROD_OUTER_Y: usize = 12;
        pub const KNUCKLE_TRACK_ROD_OUTER_Z: usize = 13;
        pub const THETA: usize = 14;
    }

    /// Entries of `q`, columns of the Jacobian.
    #[allow(missing_docs)]
    pub mod unknown {
        pub const LOWER_FRONT_OUTER_X: usize = 0;
        pub const LOWER_FRONT_OUTER_Y: usize = 1;
        pub const LOWER_FRONT_OUTER_Z: usize = 2;
        pub const UPPER_FRONT_OUTER_X: usize = 3;
        pub const UPPER_FRONT_OUTER_Y: usize = 4;
        pub const UPPER_FRONT_OUTER_Z: usize = 5;
        pub const UPPER_REAR_OUTER_X: usize = 6;
        pub const UPPER_REAR_OUTER_Y: usize = 7;
        pub const UPPER_REAR_OUTER_Z: usize = 8;
        pub const LOWER_REAR_OUTER_X: usize = 9;
        pub const LOWER_REAR_OUTER_Y: usize = 10;
        pub const LOWER_REAR_OUTER_Z: usize = 11;
        pub const TRACK_ROD_OUTER_X: usize = 12;
        pub const TRACK_ROD_OUTER_Y: usize = 13;
        pub const TRACK_ROD_OUTER_Z: usize = 14;
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
            let coordinate = angle_to_coordinate(self.lower_front.length(), angle);
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
            let knuckle_frame = free.knuckle_frame();
            let mut rows = [-T::zero(); 15];
            let term = self
                .knuckle_lower_rear_outer
                .residual(free.lower_rear_outer, &knuckle_frame);
            rows[equation::KNUCKLE_LOWER_REAR_OUTER_X] = term.x;
            rows[equation::KNUCKLE_LOWER_REAR_OUTER_Y] = term.y;
            rows[equation::KNUCKLE_LOWER_REAR_OUTER_Z] = term.z;
            let term = self
                .knuckle_track_rod_outer
                .residual(free.track_rod_outer, &knuckle_frame);
            rows[equation::KNUCKLE_TRACK_ROD_OUTER_X] = term.x;
            rows[equation::KNUCKLE_TRACK_ROD_OUTER_Y] = term.y;
            rows[equation::KNUCKLE_TRACK_ROD_OUTER_Z] = term.z;
            let d = difference(free.lower_front_outer, fixed.lower_front_inner);
            rows[equation::LOWER_FRONT] = self.lower_front.residual(d);
            let d = difference(free.upper_front_outer, fixed.upper_front_inner);
            rows[equation::UPPER_FRONT] = self.upper_front.residual(d);
            let d = difference(free.upper_rear_outer, fixed.upper_rear_inner);
            rows[equation::UPPER_REAR] = self.upper_rear.residual(d);
            let d = difference(free.lower_rear_outer, fixed.lower_rear_inner);
            rows[equation::LOWER_REAR] = self.lower_rear.residual(d);
            let d = difference(free.track_rod_outer, fixed.track_rod_inner);
            rows[equation::TRACK_ROD] = self.track_rod.residual(d);
            let d = difference(free.upper_front_outer, free.lower_front_outer);
            rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_FRONT_OUTER] = self
                .knuckle_lower_front_outer_upper_front_outer
                .residual(d);
            let d = difference(free.upper_rear_outer, free.lower_front_outer);
            rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_REAR_OUTER] = self
                .knuckle_lower_front_outer_upper_rear_outer
                .residual(d);
            let d = difference(free.upper_rear_outer, free.upper_front_outer);
            rows[equation::KNUCKLE_UPPER_FRONT_OUTER_UPPER_REAR_OUTER] = self
                .knuckle_upper_front_outer_upper_rear_outer
                .residual(d);
            rows[equation::THETA] = free.lower_front_outer.z - fixed.lower_front_inner.z
                - drives.theta;
            SVector::from(rows)
        }

        #[cfg_attr(not(debug_assertions), inline(always))]
        fn jacobian(&self, q: &SVector<T, 15>, fixed: &Fixed<T>) -> SMatrix<T, 15, 15> {
            let free = Free::of(q);
            let knuckle_frame = free.knuckle_frame();
            let mut rows = Rows::zero();
            let d = difference(free.lower_front_outer, fixed.lower_front_inner);
            let gradient = self.lower_front.gradient(d);
            rows.at(equation::LOWER_FRONT).by(unknown::LOWER_FRONT_OUTER_X, gradient);
            let d = difference(free.upper_front_outer, fixed.upper_front_inner);
            let gradient = self.upper_front.gradient(d);
            rows.at(equation::UPPER_FRONT).by(unknown::UPPER_FRONT_OUTER_X, gradient);
            let d = difference(free.upper_rear_outer, fixed.upper_rear_inner);
            let gradient = self.upper_rear.gradient(d);
            rows.at(equation::UPPER_REAR).by(unknown::UPPER_REAR_OUTER_X, gradient);
            let d = difference(free.lower_rear_outer, fixed.lower_rear_inner);
            let gradient = self.lower_rear.gradient(d);
            rows.at(equation::LOWER_REAR).by(unknown::LOWER_REAR_OUTER_X, gradient);
            let d = difference(free.track_rod_outer, fixed.track_rod_inner);
            let gradient = self.track_rod.gradient(d);
            rows.at(equation::TRACK_ROD).by(unknown::TRACK_ROD_OUTER_X, gradient);
            let d = difference(free.upper_front_outer, free.lower_front_outer);
            let gradient = self.knuckle_lower_front_outer_upper_front_outer.gradient(d);
            rows.at(equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_FRONT_OUTER)
                .by(unknown::UPPER_FRONT_OUTER_X, gradient)
                .by(unknown::LOWER_FRONT_OUTER_X, opposite(gradient));
            let d = difference(free.upper_rear_outer, free.lower_front_outer);
            let gradient = self.knuckle_lower_front_outer_upper_rear_outer.gradient(d);
            rows.at(equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_REAR_OUTER)
                .by(unknown::UPPER_REAR_OUTER_X, gradient)
                .by(unknown::LOWER_FRONT_OUTER_X, opposite(gradient));
            let d = difference(free.upper_rear_outer, free.upper_front_outer);
            let gradient = self.knuckle_upper_front_outer_upper_rear_outer.gradient(d);
            rows.at(equation::KNUCKLE_UPPER_FRONT_OUTER_UPPER_REAR_OUTER)
                .by(unknown::UPPER_REAR_OUTER_X, gradient)
                .by(unknown::UPPER_FRONT_OUTER_X, opposite(gradient));
            let gradient = self.knuckle_lower_rear_outer.gradient(&knuckle_frame);
            rows.at(equation::KNUCKLE_LOWER_REAR_OUTER_X)
                .diagonal_by(unknown::LOWER_REAR_OUTER_X, T::one())
                .three_by(unknown::LOWER_FRONT_OUTER_X, gradient.origin)
                .three_by(unknown::UPPER_FRONT_OUTER_X, gradient.second)
                .three_by(unknown::UPPER_REAR_OUTER_X, gradient.third);
            let gradient = self.knuckle_track_rod_outer.gradient(&knuckle_frame);
            rows.at(equation::KNUCKLE_TRACK_ROD_OUTER_X)
                .diagonal_by(unknown::TRACK_ROD_OUTER_X, T::one())
                .three_by(unknown::LOWER_FRONT_OUTER_X, gradient.origin)
                .three_by(unknown::UPPER_FRONT_OUTER_X, gradient.second)
                .three_by(unknown::UPPER_REAR_OUTER_X, gradient.third);
            rows.at(equation::THETA).by_one(unknown::LOWER_FRONT_OUTER_Z, T::one());
            rows.matrix()
        }

        fn pivots(&self) -> &[[usize; 2]] {
            &[
                [equation::KNUCKLE_LOWER_REAR_OUTER_X, unknown::LOWER_REAR_OUTER_X],
                [equation::KNUCKLE_LOWER_REAR_OUTER_Y, unknown::LOWER_REAR_OUTER_Y],
                [equation::KNUCKLE_LOWER_REAR_OUTER_Z, unknown::LOWER_REAR_OUTER_Z],
                [equation::KNUCKLE_TRACK_ROD_OUTER_X, unknown::TRACK_ROD_OUTER_X],
                [equation::KNUCKLE_TRACK_ROD_OUTER_Y, unknown::TRACK_ROD_OUTER_Y],
                [equation::KNUCKLE_TRACK_ROD_OUTER_Z, unknown::TRACK_ROD_OUTER_Z],
                [equation::THETA, unknown::LOWER_FRONT_OUTER_Z],
                [equation::LOWER_FRONT, unknown::LOWER_FRONT_OUTER_Y],
                [equation::UPPER_REAR, unknown::UPPER_REAR_OUTER_X],
                [
                    equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_REAR_OUTER,
                    unknown::UPPER_REAR_OUTER_Z,
                ],
                [
                    equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_FRONT_OUTER,
                    unknown::UPPER_FRONT_OUTER_Z,
                ],
                [equation::UPPER_FRONT, unknown::UPPER_FRONT_OUTER_Y],
                [equation::LOWER_REAR, unknown::UPPER_FRONT_OUTER_X],
                [
                    equation::KNUCKLE_UPPER_FRONT_OUTER_UPPER_REAR_OUTER,
                    unknown::LOWER_FRONT_OUTER_X,
                ],
                [equation::TRACK_ROD, unknown::UPPER_REAR_OUTER_Y],
            ]
        }

        #[cfg_attr(not(debug_assertions), inline(always))]
        fn factor(&self, q: &SVector<T, 15>, fixed: &Fixed<T>) -> Factors<T> {
            let free = Free::of(q);
            let knuckle_frame = free.knuckle_frame();
            let d = difference(free.lower_front_outer, fixed.lower_front_inner);
            let gradient = self.lower_front.gradient(d);
            let [lf_lfo_x, lf_lfo_y, lf_lfo_z] = xyz(gradient);
            let d = difference(free.upper_front_outer, fixed.upper_front_inner);
            let gradient = self.upper_front.gradient(d);
            let [uf_ufo_x, uf_ufo_y, uf_ufo_z] = xyz(gradient);
            let d = difference(free.upper_rear_outer, fixed.upper_rear_inner);
            let gradient = self.upper_rear.gradient(d);
            let [ur_uro_x, ur_uro_y, ur_uro_z] = xyz(gradient);
            let d = difference(free.lower_rear_outer, fixed.lower_rear_inner);
            let gradient = self.lower_rear.gradient(d);
            let [lr_lro_x, lr_lro_y, lr_lro_z] = xyz(gradient);
            let d = difference(free.track_rod_outer, fixed.track_rod_inner);
            let gradient = self.track_rod.gradient(d);
            let [tr_tro_x, tr_tro_y, tr_tro_z] = xyz(gradient);
            let d = difference(free.upper_front_outer, free.lower_front_outer);
            let gradient = self.knuckle_lower_front_outer_upper_front_outer.gradient(d);
            let [klfoufo_ufo_x, klfoufo_ufo_y, klfoufo_ufo_z] = xyz(gradient);
            let [klfoufo_lfo_x, klfoufo_lfo_y, klfoufo_lfo_z] = xyz(opposite(gradient));
            let d = difference(free.upper_rear_outer, free.lower_front_outer);
            let gradient = self.knuckle_lower_front_outer_upper_rear_outer.gradient(d);
            let [klfouro_uro_x, klfouro_uro_y, klfouro_uro_z] = xyz(gradient);
            let [klfouro_lfo_x, klfouro_lfo_y, klfouro_lfo_z] = xyz(opposite(gradient));
            let d = difference(free.upper_rear_outer, free.upper_front_outer);
            let gradient = self.knuckle_upper_front_outer_upper_rear_outer.gradient(d);
            let [kufouro_uro_x, kufouro_uro_y, kufouro_uro_z] = xyz(gradient);
            let [kufouro_ufo_x, kufouro_ufo_y, kufouro_ufo_z] = xyz(opposite(gradient));
            let gradient = Vector3::new(lr_lro_x, lr_lro_y, lr_lro_z);
            let [origin, second, third] = self
                .knuckle_lower_rear_outer
                .by_frame(gradient, &knuckle_frame);
            let [lr_lfo_x, lr_lfo_y, lr_lfo_z] = xyz(origin);
            let [lr_ufo_x, lr_ufo_y, lr_ufo_z] = xyz(second);
            let [lr_uro_x, lr_uro_y, lr_uro_z] = xyz(third);
            let gradient = Vector3::new(tr_tro_x, tr_tro_y, tr_tro_z);
            let [origin, second, third] = self
                .knuckle_track_rod_outer
                .by_frame(gradient, &knuckle_frame);
            let [tr_lfo_x, tr_lfo_y, tr_lfo_z] = xyz(origin);
            let [tr_ufo_x, tr_ufo_y, tr_ufo_z] = xyz(second);
            let [tr_uro_x, tr_uro_y, tr_uro_z] = xyz(third);
            let lf_lfo_y = T::one() / lf_lfo_y;
            let lr_lfo_y = lr_lfo_y * lf_lfo_y;
            let lr_lfo_x = lr_lfo_x.minus_product(lr_lfo_y, lf_lfo_x);
            let tr_lfo_y = tr_lfo_y * lf_lfo_y;
            let tr_lfo_x = tr_lfo_x.minus_product(tr_lfo_y, lf_lfo_x);
            let klfoufo_lfo_y = klfoufo_lfo_y * lf_lfo_y;
            let klfoufo_lfo_x = klfoufo_lfo_x.minus_product(klfoufo_lfo_y, lf_lfo_x);
            let klfouro_lfo_y = klfouro_lfo_y * lf_lfo_y;
            let klfouro_lfo_x = klfouro_lfo_x.minus_product(klfouro_lfo_y, lf_lfo_x);
            let lf_lfo_x = lf_lfo_x * lf_lfo_y;
            let ur_uro_x = T::one() / ur_uro_x;
            let lr_uro_x = lr_uro_x * ur_uro_x;
            let lr_uro_y = lr_uro_y.minus_product(lr_uro_x, ur_uro_y);
            let lr_uro_z = lr_uro_z.minus_product(lr_uro_x, ur_uro_z);
            let tr_uro_x = tr_uro_x * ur_uro_x;
            let tr_uro_y = tr_uro_y.minus_product(tr_uro_x, ur_uro_y);
            let tr_uro_z = tr_uro_z.minus_product(tr_uro_x, ur_uro_z);
            let klfouro_uro_x = klfouro_uro_x * ur_uro_x;
            let klfouro_uro_y = klfouro_uro_y.minus_product(klfouro_uro_x, ur_uro_y);
            let klfouro_uro_z = klfouro_uro_z.minus_product(klfouro_uro_x, ur_uro_z);
            let kufouro_uro_x = kufouro_uro_x * ur_uro_x;
            let kufouro_uro_y = kufouro_uro_y.minus_product(kufouro_uro_x, ur_uro_y);
            let kufouro_uro_z = kufouro_uro_z.minus_product(kufouro_uro_x, ur_uro_z);
            let ur_uro_y = ur_uro_y * ur_uro_x;
            let ur_uro_z = ur_uro_z * ur_uro_x;
            let klfouro_uro_z = T::one() / klfouro_uro_z;
            let lr_uro_z = lr_uro_z * klfouro_uro_z;
            let lr_uro_y = lr_uro_y.minus_product(lr_uro_z, klfouro_uro_y);
            let lr_lfo_x = lr_lfo_x.minus_product(lr_uro_z, klfouro_lfo_x);
            let tr_uro_z = tr_uro_z * klfouro_uro_z;
            let tr_uro_y = tr_uro_y.minus_product(tr_uro_z, klfouro_uro_y);
            let tr_lfo_x = tr_lfo_x.minus_product(tr_uro_z, klfouro_lfo_x);
            let kufouro_uro_z = kufouro_uro_z * klfouro_uro_z;
            let kufouro_uro_y = kufouro_uro_y
                .minus_product(kufouro_uro_z, klfouro_uro_y);
            let kufouro_lfo_x = -(kufouro_uro_z * klfouro_lfo_x);
            let klfouro_uro_y = klfouro_uro_y * klfouro_uro_z;
            let klfouro_lfo_x = klfouro_lfo_x * klfouro_uro_z;
            let klfoufo_ufo_z = T::one() / klfoufo_ufo_z;
            let uf_ufo_z = uf_ufo_z * klfoufo_ufo_z;
            let uf_lfo_x = -(uf_ufo_z * klfoufo_lfo_x);
            let uf_ufo_x = uf_ufo_x.minus_product(uf_ufo_z, klfoufo_ufo_x);
            let uf_ufo_y = uf_ufo_y.minus_product(uf_ufo_z, klfoufo_ufo_y);
            let lr_ufo_z = lr_ufo_z * klfoufo_ufo_z;
            let lr_lfo_x = lr_lfo_x.minus_product(lr_ufo_z, klfoufo_lfo_x);
            let lr_ufo_x = lr_ufo_x.minus_product(lr_ufo_z, klfoufo_ufo_x);
            let lr_ufo_y = lr_ufo_y.minus_product(lr_ufo_z, klfoufo_ufo_y);
            let tr_ufo_z = tr_ufo_z * klfoufo_ufo_z;
            let tr_lfo_x = tr_lfo_x.minus_product(tr_ufo_z, klfoufo_lfo_x);
            let tr_ufo_x = tr_ufo_x.minus_product(tr_ufo_z, klfoufo_ufo_x);
            let tr_ufo_y = tr_ufo_y.minus_product(tr_ufo_z, klfoufo_ufo_y);
            let kufouro_ufo_z = kufouro_ufo_z * klfoufo_ufo_z;
            let kufouro_lfo_x = kufouro_lfo_x
                .minus_product(kufouro_ufo_z, klfoufo_lfo_x);
            let kufouro_ufo_x = kufouro_ufo_x
                .minus_product(kufouro_ufo_z, klfoufo_ufo_x);
            let kufouro_ufo_y = kufouro_ufo_y
                .minus_product(kufouro_ufo_z, klfoufo_ufo_y);
            let klfoufo_lfo_x = klfoufo_lfo_x * klfoufo_ufo_z;
            let klfoufo_ufo_x = klfoufo_ufo_x * klfoufo_ufo_z;
            let klfoufo_ufo_y = klfoufo_ufo_y * klfoufo_ufo_z;
            let uf_ufo_y = T::one() / uf_ufo_y;
            let lr_ufo_y = lr_ufo_y * uf_ufo_y;
            let lr_lfo_x = lr_lfo_x.minus_product(lr_ufo_y, uf_lfo_x);
            let lr_ufo_x = lr_ufo_x.minus_product(lr_ufo_y, uf_ufo_x);
            let tr_ufo_y = tr_ufo_y * uf_ufo_y;
            let tr_lfo_x = tr_lfo_x.minus_product(tr_ufo_y, uf_lfo_x);
            let tr_ufo_x = tr_ufo_x.minus_product(tr_ufo_y, uf_ufo_x);
            let kufouro_ufo_y = kufouro_ufo_y * uf_ufo_y;
            let kufouro_lfo_x = kufouro_lfo_x.minus_product(kufouro_ufo_y, uf_lfo_x);
            let kufouro_ufo_x = kufouro_ufo_x.minus_product(kufouro_ufo_y, uf_ufo_x);
            let uf_lfo_x = uf_lfo_x * uf_ufo_y;
            let uf_ufo_x = uf_ufo_x * uf_ufo_y;
            let lr_ufo_x = T::one() / lr_ufo_x;
            let tr_ufo_x = tr_ufo_x * lr_ufo_x;
            let tr_uro_y = tr_uro_y.minus_product(tr_ufo_x, lr_uro_y);
            let tr_lfo_x = tr_lfo_x.minus_product(tr_ufo_x, lr_lfo_x);
            let kufouro_ufo_x = kufouro_ufo_x * lr_ufo_x;
            let kufouro_uro_y = kufouro_uro_y.minus_product(kufouro_ufo_x, lr_uro_y);
            let kufouro_lfo_x = kufouro_lfo_x.minus_product(kufouro_ufo_x, lr_lfo_x);
            let lr_uro_y = lr_uro_y * lr_ufo_x;
            let lr_lfo_x = lr_lfo_x * lr_ufo_x;
            let kufouro_lfo_x = T::one() / kufouro_lfo_x;
            let tr_lfo_x = tr_lfo_x * kufouro_lfo_x;
            let tr_uro_y = tr_uro_y.minus_product(tr_lfo_x, kufouro_uro_y);
            let kufouro_uro_y = kufouro_uro_y * kufouro_lfo_x;
            let tr_uro_y = T::one() / tr_uro_y;
            let pivots = [
                lf_lfo_y,
                ur_uro_x,
                klfouro_uro_z,
                klfoufo_ufo_z,
                uf_ufo_y,
                lr_ufo_x,
                kufouro_lfo_x,
                tr_uro_y,
            ];
            Factors {
                growth_squared: sum_of_squares(pivots),
                determinant_sign: -product(pivots),
                knuckle_frame,
                knuckle_lower_rear_outer: self.knuckle_lower_rear_outer,
                knuckle_track_rod_outer: self.knuckle_track_rod_outer,
                lr_lro_x,
                lr_lro_y,
                lr_lro_z,
                tr_tro_x,
                tr_tro_y,
                tr_tro_z,
                lf_lfo_z,
                lr_lfo_z,
                tr_lfo_z,
                klfoufo_lfo_z,
                klfouro_lfo_z,
                lf_lfo_y,
                lf_lfo_x,
                lr_lfo_y,
                tr_lfo_y,
                klfoufo_lfo_y,
                klfouro_lfo_y,
                ur_uro_x,
                ur_uro_y,
                ur_uro_z,
                lr_uro_x,
                tr_uro_x,
                klfouro_uro_x,
                kufouro_uro_x,
                klfouro_uro_z,
                klfouro_uro_y,
                klfouro_lfo_x,
                lr_uro_z,
                tr_uro_z,
                kufouro_uro_z,
                klfoufo_ufo_z,
                klfoufo_lfo_x,
                klfoufo_ufo_x,
                klfoufo_ufo_y,
                uf_ufo_z,
                lr_ufo_z,
                tr_ufo_z,
                kufouro_ufo_z,
                uf_ufo_y,
                uf_lfo_x,
                uf_ufo_x,
                lr_ufo_y,
                tr_ufo_y,
                kufouro_ufo_y,
                lr_ufo_x,
                lr_uro_y,
                lr_lfo_x,
                tr_ufo_x,
                kufouro_ufo_x,
                kufouro_lfo_x,
                kufouro_uro_y,
                tr_lfo_x,
                tr_uro_y,
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
            let knuckle_frame_v = v.knuckle_frame();
            let knuckle_frame_w = w.knuckle_frame();
            let mut rows = [-T::zero(); 15];
            let term = self
                .knuckle_lower_rear_outer
                .curvature(&knuckle_frame_v, &knuckle_frame_w);
            rows[equation::KNUCKLE_LOWER_REAR_OUTER_X] = term.x;
            rows[equation::KNUCKLE_LOWER_REAR_OUTER_Y] = term.y;
            rows[equation::KNUCKLE_LOWER_REAR_OUTER_Z] = term.z;
            let term = self
                .knuckle_track_rod_outer
                .curvature(&knuckle_frame_v, &knuckle_frame_w);
            rows[equation::KNUCKLE_TRACK_ROD_OUTER_X] = term.x;
            rows[equation::KNUCKLE_TRACK_ROD_OUTER_Y] = term.y;
            rows[equation::KNUCKLE_TRACK_ROD_OUTER_Z] = term.z;
            let v_d = difference(v.lower_front_outer, v_fixed.lower_front_inner);
            let w_d = difference(w.lower_front_outer, w_fixed.lower_front_inner);
            rows[equation::LOWER_FRONT] = self.lower_front.curvature(v_d, w_d);
            let v_d = difference(v.upper_front_outer, v_fixed.upper_front_inner);
            let w_d = difference(w.upper_front_outer, w_fixed.upper_front_inner);
            rows[equation::UPPER_FRONT] = self.upper_front.curvature(v_d, w_d);
            let v_d = difference(v.upper_rear_outer, v_fixed.upper_rear_inner);
            let w_d = difference(w.upper_rear_outer, w_fixed.upper_rear_inner);
            rows[equation::UPPER_REAR] = self.upper_rear.curvature(v_d, w_d);
            let v_d = difference(v.lower_rear_outer, v_fixed.lower_rear_inner);
            let w_d = difference(w.lower_rear_outer, w_fixed.lower_rear_inner);
            rows[equation::LOWER_REAR] = self.lower_rear.curvature(v_d, w_d);
            let v_d = difference(v.track_rod_outer, v_fixed.track_rod_inner);
            let w_d = difference(w.track_rod_outer, w_fixed.track_rod_inner);
            rows[equation::TRACK_ROD] = self.track_rod.curvature(v_d, w_d);
            let v_d = difference(v.upper_front_outer, v.lower_front_outer);
            let w_d = difference(w.upper_front_outer, w.lower_front_outer);
            rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_FRONT_OUTER] = self
                .knuckle_lower_front_outer_upper_front_outer
                .curvature(v_d, w_d);
            let v_d = difference(v.upper_rear_outer, v.lower_front_outer);
            let w_d = difference(w.upper_rear_outer, w.lower_front_outer);
            rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_REAR_OUTER] = self
                .knuckle_lower_front_outer_upper_rear_outer
                .curvature(v_d, w_d);
            let v_d = difference(v.upper_rear_outer, v.upper_front_outer);
            let w_d = difference(w.upper_rear_outer, w.upper_front_outer);
            rows[equation::KNUCKLE_UPPER_FRONT_OUTER_UPPER_REAR_OUTER] = self
                .knuckle_upper_front_outer_upper_rear_outer
                .curvature(v_d, w_d);
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
            let d = difference(free.lower_front_outer, fixed.lower_front_inner);
            let gradient = self.lower_front.gradient(d);
            rows[equation::LOWER_FRONT] = dot(gradient, fixed_rate.lower_front_inner);
            let d = difference(free.upper_front_outer, fixed.upper_front_inner);
            let gradient = self.upper_front.gradient(d);
            rows[equation::UPPER_FRONT] = dot(gradient, fixed_rate.upper_front_inner);
            let d = difference(free.upper_rear_outer, fixed.upper_rear_inner);
            let gradient = self.upper_rear.gradient(d);
            rows[equation::UPPER_REAR] = dot(gradient, fixed_rate.upper_rear_inner);
            let d = difference(free.lower_rear_outer, fixed.lower_rear_inner);
            let gradient = self.lower_rear.gradient(d);
            rows[equation::LOWER_REAR] = dot(gradient, fixed_rate.lower_rear_inner);
            let d = difference(free.track_rod_outer, fixed.track_rod_inner);
            let gradient = self.track_rod.gradient(d);
            rows[equation::TRACK_ROD] = dot(gradient, fixed_rate.track_rod_inner);
            rows[equation::THETA] = fixed_rate.lower_front_inner.z;
            SVector::from(rows)
        }

        fn points(&self, q: &SVector<T, 15>, fixed: &Fixed<T>) -> Points<T> {
            let free = Free::of(q);
            let markers = [self.wheel_centre.position(&free.knuckle_frame())];
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
                self.wheel_centre.velocity(&at.knuckle_frame(), &free.knuckle_frame()),
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
                    .wheel_centre
                    .acceleration(
                        &at.knuckle_frame(),
                        &velocities.knuckle_frame(),
                        &free.knuckle_frame(),
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
            self.wheel_centre
                .carry_force(
                    forces.wheel_centre,
                    &free.knuckle_frame(),
                    [
                        &mut forces.lower_front_outer,
                        &mut forces.upper_front_outer,
                        &mut forces.upper_rear_outer,
                    ],
                );
        }

        fn unknowns(&self, points: &Points<T>) -> SVector<T, 15> {
            Free {
                lower_front_outer: points.lower_front_outer,
                upper_front_outer: points.upper_front_outer,
                upper_rear_outer: points.upper_rear_outer,
                lower_rear_outer: points.lower_rear_outer,
                track_rod_outer: points.track_rod_outer,
            }
                .unknowns()
        }

        fn measures(&self, points: &Signal<Points<T>>) -> Signal<Measures<T>>
        where
            T: Real,
        {
            let mut measures: Signal<Measures<T>> = Signal::default();
            let measured = points.map(|points| points.wheel_centre.z);
            measures.set(measured, |measures| &mut measures.height);
            measures
        }
    }

    /// The Jacobian eliminated in a fixed order, `L D U`: multipliers below each pivot, what is
    /// left of its row, divided by the pivot, to the right, and in its own place the pivot's
    /// inverse. Pivots that are 1 in every position are left out, and of carried points the rows:
    /// frame and constants stand for them.
    ///
    /// An entry is named by its equation: `lf` lower_front, `uf` upper_front, `ur` upper_rear, `lr` lower_rear, `tr` track_rod, `klfoufo` knuckle_lower_front_outer_upper_front_outer, `klfouro` knuckle_lower_front_outer_upper_rear_outer, `kufouro` knuckle_upper_front_outer_upper_rear_outer, `klro` knuckle_lower_rear_outer, `ktro` knuckle_track_rod_outer, `theta` theta;
    /// and its unknown: `lfo` lower_front_outer, `ufo` upper_front_outer, `uro` upper_rear_outer, `lro` lower_rear_outer, `tro` track_rod_outer.
    #[derive(Clone, Copy, Debug)]
    pub struct Factors<T> {
        growth_squared: T,
        determinant_sign: T,
        knuckle_frame: Frame<T>,
        knuckle_lower_rear_outer: Carried<T>,
        knuckle_track_rod_outer: Carried<T>,
        lr_lro_x: T,
        lr_lro_y: T,
        lr_lro_z: T,
        tr_tro_x: T,
        tr_tro_y: T,
        tr_tro_z: T,
        lf_lfo_z: T,
        lr_lfo_z: T,
        tr_lfo_z: T,
        klfoufo_lfo_z: T,
        klfouro_lfo_z: T,
        lf_lfo_y: T,
        lf_lfo_x: T,
        lr_lfo_y: T,
        tr_lfo_y: T,
        klfoufo_lfo_y: T,
        klfouro_lfo_y: T,
        ur_uro_x: T,
        ur_uro_y: T,
        ur_uro_z: T,
        lr_uro_x: T,
        tr_uro_x: T,
        klfouro_uro_x: T,
        kufouro_uro_x: T,
        klfouro_uro_z: T,
        klfouro_uro_y: T,
        klfouro_lfo_x: T,
        lr_uro_z: T,
        tr_uro_z: T,
        kufouro_uro_z: T,
        klfoufo_ufo_z: T,
        klfoufo_lfo_x: T,
        klfoufo_ufo_x: T,
        klfoufo_ufo_y: T,
        uf_ufo_z: T,
        lr_ufo_z: T,
        tr_ufo_z: T,
        kufouro_ufo_z: T,
        uf_ufo_y: T,
        uf_lfo_x: T,
        uf_ufo_x: T,
        lr_ufo_y: T,
        tr_ufo_y: T,
        kufouro_ufo_y: T,
        lr_ufo_x: T,
        lr_uro_y: T,
        lr_lfo_x: T,
        tr_ufo_x: T,
        kufouro_ufo_x: T,
        kufouro_lfo_x: T,
        kufouro_uro_y: T,
        tr_lfo_x: T,
        tr_uro_y: T,
    }

    impl<T: Scalar> JacobianFactors<T, 15> for Factors<T> {
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn solve(&self, right: &SVector<T, 15>) -> SVector<T, 15> {
            let [[lf, uf, ur, lr, tr, klfoufo, klfouro, kufouro, klro_x, klro_y, klro_z,
            ktro_x, ktro_y, ktro_z, theta]] = right.data.0;
            let lr = lr.minus_product(self.lr_lro_x, klro_x);
            let lr = lr.minus_product(self.lr_lro_y, klro_y);
            let lr = lr.minus_product(self.lr_lro_z, klro_z);
            let tr = tr.minus_product(self.tr_tro_x, ktro_x);
            let tr = tr.minus_product(self.tr_tro_y, ktro_y);
            let tr = tr.minus_product(self.tr_tro_z, ktro_z);
            let lf = lf.minus_product(self.lf_lfo_z, theta);
            let lr = lr.minus_product(self.lr_lfo_z, theta);
            let tr = tr.minus_product(self.tr_lfo_z, theta);
            let klfoufo = klfoufo.minus_product(self.klfoufo_lfo_z, theta);
            let klfouro = klfouro.minus_product(self.klfouro_lfo_z, theta);
            let lr = lr.minus_product(self.lr_lfo_y, lf);
            let tr = tr.minus_product(self.tr_lfo_y, lf);
            let klfoufo = klfoufo.minus_product(self.klfoufo_lfo_y, lf);
            let klfouro = klfouro.minus_product(self.klfouro_lfo_y, lf);
            let lr = lr.minus_product(self.lr_uro_x, ur);
            let tr = tr.minus_product(self.tr_uro_x, ur);
            let klfouro = klfouro.minus_product(self.klfouro_uro_x, ur);
            let kufouro = kufouro.minus_product(self.kufouro_uro_x, ur);
            let lr = lr.minus_product(self.lr_uro_z, klfouro);
            let tr = tr.minus_product(self.tr_uro_z, klfouro);
            let kufouro = kufouro.minus_product(self.kufouro_uro_z, klfouro);
            let uf = uf.minus_product(self.uf_ufo_z, klfoufo);
            let lr = lr.minus_product(self.lr_ufo_z, klfoufo);
            let tr = tr.minus_product(self.tr_ufo_z, klfoufo);
            let kufouro = kufouro.minus_product(self.kufouro_ufo_z, klfoufo);
            let lr = lr.minus_product(self.lr_ufo_y, uf);
            let tr = tr.minus_product(self.tr_ufo_y, uf);
            let kufouro = kufouro.minus_product(self.kufouro_ufo_y, uf);
            let tr = tr.minus_product(self.tr_ufo_x, lr);
            let kufouro = kufouro.minus_product(self.kufouro_ufo_x, lr);
            let tr = tr.minus_product(self.tr_lfo_x, kufouro);
            let uro_y = tr * self.tr_uro_y;
            let lfo_x = (kufouro * self.kufouro_lfo_x)
                .minus_product(self.kufouro_uro_y, uro_y);
            let ufo_x = (lr * self.lr_ufo_x)
                .minus_product(self.lr_uro_y, uro_y)
                .minus_product(self.lr_lfo_x, lfo_x);
            let ufo_y = (uf * self.uf_ufo_y)
                .minus_product(self.uf_lfo_x, lfo_x)
                .minus_product(self.uf_ufo_x, ufo_x);
            let ufo_z = (klfoufo * self.klfoufo_ufo_z)
                .minus_product(self.klfoufo_lfo_x, lfo_x)
                .minus_product(self.klfoufo_ufo_x, ufo_x)
                .minus_product(self.klfoufo_ufo_y, ufo_y);
            let uro_z = (klfouro * self.klfouro_uro_z)
                .minus_product(self.klfouro_uro_y, uro_y)
                .minus_product(self.klfouro_lfo_x, lfo_x);
            let uro_x = (ur * self.ur_uro_x)
                .minus_product(self.ur_uro_y, uro_y)
                .minus_product(self.ur_uro_z, uro_z);
            let lfo_y = (lf * self.lf_lfo_y).minus_product(self.lf_lfo_x, lfo_x);
            let lfo_z = theta;
            let knuckle_frame = Frame::new(
                Vector3::new(lfo_x, lfo_y, lfo_z),
                Vector3::new(ufo_x, ufo_y, ufo_z),
                Vector3::new(uro_x, uro_y, uro_z),
            );
            let carried = self
                .knuckle_lower_rear_outer
                .velocity(&self.knuckle_frame, &knuckle_frame);
            let lro_x = klro_x + carried.x;
            let lro_y = klro_y + carried.y;
            let lro_z = klro_z + carried.z;
            let carried = self
                .knuckle_track_rod_outer
                .velocity(&self.knuckle_frame, &knuckle_frame);
            let tro_x = ktro_x + carried.x;
            let tro_y = ktro_y + carried.y;
            let tro_z = ktro_z + carried.z;
            vector_of![
                lfo_x, lfo_y, lfo_z, ufo_x, ufo_y, ufo_z, uro_x, uro_y, uro_z, lro_x,
                lro_y, lro_z, tro_x, tro_y, tro_z
            ]
        }

        #[cfg_attr(not(debug_assertions), inline(always))]
        fn solve_transposed(&self, right: &SVector<T, 15>) -> SVector<T, 15> {
            let [[lfo_x, lfo_y, lfo_z, ufo_x, ufo_y, ufo_z, uro_x, uro_y, uro_z, lro_x,
            lro_y, lro_z, tro_x, tro_y, tro_z]] = right.data.0;
            let gradient = Vector3::new(lro_x, lro_y, lro_z);
            let [origin, second, third] = self
                .knuckle_lower_rear_outer
                .by_frame(gradient, &self.knuckle_frame);
            let lfo_x = lfo_x + origin.x;
            let lfo_y = lfo_y + origin.y;
            let lfo_z = lfo_z + origin.z;
            let ufo_x = ufo_x + second.x;
            let ufo_y = ufo_y + second.y;
            let ufo_z = ufo_z + second.z;
            let uro_x = uro_x + third.x;
            let uro_y = uro_y + third.y;
            let uro_z = uro_z + third.z;
            let gradient = Vector3::new(tro_x, tro_y, tro_z);
            let [origin, second, third] = self
                .knuckle_track_rod_outer
                .by_frame(gradient, &self.knuckle_frame);
            let lfo_x = lfo_x + origin.x;
            let lfo_y = lfo_y + origin.y;
            let lfo_z = lfo_z + origin.z;
            let ufo_x = ufo_x + second.x;
            let ufo_y = ufo_y + second.y;
            let ufo_z = ufo_z + second.z;
            let uro_x = uro_x + third.x;
            let uro_y = uro_y + third.y;
            let uro_z = uro_z + third.z;
            let lfo_x = lfo_x.minus_product(self.lf_lfo_x, lfo_y);
            let uro_y = uro_y.minus_product(self.ur_uro_y, uro_x);
            let uro_z = uro_z.minus_product(self.ur_uro_z, uro_x);
            let uro_y = uro_y.minus_product(self.klfouro_uro_y, uro_z);
            let lfo_x = lfo_x.minus_product(self.klfouro_lfo_x, uro_z);
            let lfo_x = lfo_x.minus_product(self.klfoufo_lfo_x, ufo_z);
            let ufo_x = ufo_x.minus_product(self.klfoufo_ufo_x, ufo_z);
            let ufo_y = ufo_y.minus_product(self.klfoufo_ufo_y, ufo_z);
            let lfo_x = lfo_x.minus_product(self.uf_lfo_x, ufo_y);
            let ufo_x = ufo_x.minus_product(self.uf_ufo_x, ufo_y);
            let uro_y = uro_y.minus_product(self.lr_uro_y, ufo_x);
            let lfo_x = lfo_x.minus_product(self.lr_lfo_x, ufo_x);
            let uro_y = uro_y.minus_product(self.kufouro_uro_y, lfo_x);
            let klro_x = lro_x;
            let klro_y = lro_y;
            let klro_z = lro_z;
            let ktro_x = tro_x;
            let ktro_y = tro_y;
            let ktro_z = tro_z;
            let theta = lfo_z;
            let lf = lfo_y * self.lf_lfo_y;
            let ur = uro_x * self.ur_uro_x;
            let klfouro = uro_z * self.klfouro_uro_z;
            let klfoufo = ufo_z * self.klfoufo_ufo_z;
            let uf = ufo_y * self.uf_ufo_y;
            let lr = ufo_x * self.lr_ufo_x;
            let kufouro = lfo_x * self.kufouro_lfo_x;
            let tr = uro_y * self.tr_uro_y;
            let kufouro = kufouro.minus_product(self.tr_lfo_x, tr);
            let lr = lr.minus_product(self.tr_ufo_x, tr);
            let lr = lr.minus_product(self.kufouro_ufo_x, kufouro);
            let uf = uf.minus_product(self.lr_ufo_y, lr);
            let uf = uf.minus_product(self.tr_ufo_y, tr);
            let uf = uf.minus_product(self.kufouro_ufo_y, kufouro);
            let klfoufo = klfoufo.minus_product(self.uf_ufo_z, uf);
            let klfoufo = klfoufo.minus_product(self.lr_ufo_z, lr);
            let klfoufo = klfoufo.minus_product(self.tr_ufo_z, tr);
            let klfoufo = klfoufo.minus_product(self.kufouro_ufo_z, kufouro);
            let klfouro = klfouro.minus_product(self.lr_uro_z, lr);
            let klfouro = klfouro.minus_product(self.tr_uro_z, tr);
            let klfouro = klfouro.minus_product(self.kufouro_uro_z, kufouro);
            let ur = ur.minus_product(self.lr_uro_x, lr);
            let ur = ur.minus_product(self.tr_uro_x, tr);
            let ur = ur.minus_product(self.klfouro_uro_x, klfouro);
            let ur = ur.minus_product(self.kufouro_uro_x, kufouro);
            let lf = lf.minus_product(self.lr_lfo_y, lr);
            let lf = lf.minus_product(self.tr_lfo_y, tr);
            let lf = lf.minus_product(self.klfoufo_lfo_y, klfoufo);
            let lf = lf.minus_product(self.klfouro_lfo_y, klfouro);
            let theta = theta.minus_product(self.lf_lfo_z, lf);
            let theta = theta.minus_product(self.lr_lfo_z, lr);
            let theta = theta.minus_product(self.tr_lfo_z, tr);
            let theta = theta.minus_product(self.klfoufo_lfo_z, klfoufo);
            let theta = theta.minus_product(self.klfouro_lfo_z, klfouro);
            let ktro_z = ktro_z.minus_product(self.tr_tro_z, tr);
            let ktro_y = ktro_y.minus_product(self.tr_tro_y, tr);
            let ktro_x = ktro_x.minus_product(self.tr_tro_x, tr);
            let klro_z = klro_z.minus_product(self.lr_lro_z, lr);
            let klro_y = klro_y.minus_product(self.lr_lro_y, lr);
            let klro_x = klro_x.minus_product(self.lr_lro_x, lr);
            vector_of![
                lf, uf, ur, lr, tr, klfoufo, klfouro, kufouro, klro_x, klro_y, klro_z,
                ktro_x, ktro_y, ktro_z, theta
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
                "lower_front",
                "upper_front",
                "upper_rear",
                "lower_rear",
                "track_rod",
                "knuckle_lower_front_outer_upper_front_outer",
                "knuckle_lower_front_outer_upper_rear_outer",
                "knuckle_upper_front_outer_upper_rear_outer",
                "knuckle_lower_rear_outer_x",
                "knuckle_lower_rear_outer_y",
                "knuckle_lower_rear_outer_z",
                "knuckle_track_rod_outer_x",
                "knuckle_track_rod_outer_y",
                "knuckle_track_rod_outer_z",
                "theta",
            ],
            unknowns: unknown_names![
                "lower_front_outer", "upper_front_outer", "upper_rear_outer",
                "lower_rear_outer", "track_rod_outer";
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
                lower_front: Distance::gather(|model| model.lower_front, number),
                upper_front: Distance::gather(|model| model.upper_front, number),
                upper_rear: Distance::gather(|model| model.upper_rear, number),
                lower_rear: Distance::gather(|model| model.lower_rear, number),
                track_rod: Distance::gather(|model| model.track_rod, number),
                knuckle_lower_front_outer_upper_front_outer: Distance::gather(
                    |model| model.knuckle_lower_front_outer_upper_front_outer,
                    number,
                ),
                knuckle_lower_front_outer_upper_rear_outer: Distance::gather(
                    |model| model.knuckle_lower_front_outer_upper_rear_outer,
                    number,
                ),
                knuckle_upper_front_outer_upper_rear_outer: Distance::gather(
                    |model| model.knuckle_upper_front_outer_upper_rear_outer,
                    number,
                ),
                knuckle_frame: Frame::gather(|model| model.knuckle_frame, number),
                knuckle_lower_rear_outer: Carried::gather(
                    |model| model.knuckle_lower_rear_outer,
                    number,
                ),
                knuckle_track_rod_outer: Carried::gather(
                    |model| model.knuckle_track_rod_outer,
                    number,
                ),
                wheel_centre: Carried::gather(|model| model.wheel_centre, number),
            }
        }
    }

    impl<T: Real> Model<T> {
        /// With `size` brought up to the other constants.
        fn sized(self) -> Self {
            Self {
                size: parts::longest(
                    &[
                        self.lower_front.length(),
                        self.upper_front.length(),
                        self.upper_rear.length(),
                        self.lower_rear.length(),
                        self.track_rod.length(),
                        self.knuckle_lower_front_outer_upper_front_outer.length(),
                        self.knuckle_lower_front_outer_upper_rear_outer.length(),
                        self.knuckle_upper_front_outer_upper_rear_outer.length(),
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
            let knuckle_frame = parts::frame(7, at.knuckle_frame())?;
            let model = Self {
                fixed: Fixed::from_values(at.values()),
                size: T::zero(),
                lower_front: parts::distance(
                    0,
                    at.lower_front_inner,
                    at.lower_front_outer,
                )?,
                upper_front: parts::distance(
                    1,
                    at.upper_front_inner,
                    at.upper_front_outer,
                )?,
                upper_rear: parts::distance(
                    2,
                    at.upper_rear_inner,
                    at.upper_rear_outer,
                )?,
                lower_rear: parts::distance(
                    3,
                    at.lower_rear_inner,
                    at.lower_rear_outer,
                )?,
                track_rod: parts::distance(4, at.track_rod_inner, at.track_rod_outer)?,
                knuckle_lower_front_outer_upper_front_outer: parts::distance(
                    5,
                    at.lower_front_outer,
                    at.upper_front_outer,
                )?,
                knuckle_lower_front_outer_upper_rear_outer: parts::distance(
                    6,
                    at.lower_front_outer,
                    at.upper_rear_outer,
                )?,
                knuckle_upper_front_outer_upper_rear_outer: parts::distance(
                    7,
                    at.upper_front_outer,
                    at.upper_rear_outer,
                )?,
                knuckle_frame,
                knuckle_lower_rear_outer: parts::carried(
                    8,
                    at.lower_rear_outer,
                    &knuckle_frame,
                )?,
                knuckle_track_rod_outer: parts::carried(
                    9,
                    at.track_rod_outer,
                    &knuckle_frame,
                )?,
                wheel_centre: parts::carried(10, at.wheel_centre, &at.knuckle_frame())?,
            };
            Ok(model.sized())
        }

        fn check_pivots(&self, points: &Points<T>) -> Result<(), GeometryError> {
            check_pivots(self, points)
        }

        fn with_lengths(self, lengths: &Lengths<T>) -> Result<Self, GeometryError> {
            parts::positive(lengths.values())?;
            let knuckle_frame = parts::frame_of_lengths(
                7,
                [
                    lengths.knuckle_lower_front_outer_upper_front_outer,
                    lengths.knuckle_lower_front_outer_upper_rear_outer,
                    lengths.knuckle_upper_front_outer_upper_rear_outer,
                ],
            )?;
            let model = Self {
                lower_front: Distance::new(lengths.lower_front),
                upper_front: Distance::new(lengths.upper_front),
                upper_rear: Distance::new(lengths.upper_rear),
                lower_rear: Distance::new(lengths.lower_rear),
                track_rod: Distance::new(lengths.track_rod),
                knuckle_lower_front_outer_upper_front_outer: Distance::new(
                    lengths.knuckle_lower_front_outer_upper_front_outer,
                ),
                knuckle_lower_front_outer_upper_rear_outer: Distance::new(
                    lengths.knuckle_lower_front_outer_upper_rear_outer,
                ),
                knuckle_upper_front_outer_upper_rear_outer: Distance::new(
                    lengths.knuckle_upper_front_outer_upper_rear_outer,
                ),
                knuckle_frame,
                knuckle_lower_rear_outer: parts::carried_at(
                    8,
                    &self.knuckle_lower_rear_outer,
                    &knuckle_frame,
                    [
                        lengths.knuckle_lower_rear_outer_lower_front_outer,
                        lengths.knuckle_lower_rear_outer_upper_front_outer,
                        lengths.knuckle_lower_rear_outer_upper_rear_outer,
                    ],
                )?,
                knuckle_track_rod_outer: parts::carried_at(
                    9,
                    &self.knuckle_track_rod_outer,
                    &knuckle_frame,
                    [
                        lengths.knuckle_track_rod_outer_lower_front_outer,
                        lengths.knuckle_track_rod_outer_upper_front_outer,
                        lengths.knuckle_track_rod_outer_upper_rear_outer,
                    ],
                )?,
                ..self
            };
            Ok(model.sized())
        }

        fn with_markers(self, at: &Points<T>) -> Result<Self, GeometryError> {
            parts::finite(at.values())?;
            Ok(Self {
                wheel_centre: parts::carried(10, at.wheel_centre, &at.knuckle_frame())?,
                ..self
            })
        }

        fn lengths(&self) -> Lengths<T> {
            let [knuckle_lower_rear_outer_lower_front_outer,
            knuckle_lower_rear_outer_upper_front_outer,
            knuckle_lower_rear_outer_upper_rear_outer] = self
                .knuckle_lower_rear_outer
                .lengths(&self.knuckle_frame);
            let [knuckle_track_rod_outer_lower_front_outer,
            knuckle_track_rod_outer_upper_front_outer,
            knuckle_track_rod_outer_upper_rear_outer] = self
                .knuckle_track_rod_outer
                .lengths(&self.knuckle_frame);
            Lengths {
                lower_front: self.lower_front.length(),
                upper_front: self.upper_front.length(),
                upper_rear: self.upper_rear.length(),
                lower_rear: self.lower_rear.length(),
                track_rod: self.track_rod.length(),
                knuckle_lower_front_outer_upper_front_outer: self
                    .knuckle_lower_front_outer_upper_front_outer
                    .length(),
                knuckle_lower_front_outer_upper_rear_outer: self
                    .knuckle_lower_front_outer_upper_rear_outer
                    .length(),
                knuckle_upper_front_outer_upper_rear_outer: self
                    .knuckle_upper_front_outer_upper_rear_outer
                    .length(),
                knuckle_lower_rear_outer_lower_front_outer,
                knuckle_lower_rear_outer_upper_front_outer,
                knuckle_lower_rear_outer_upper_rear_outer,
                knuckle_track_rod_outer_lower_front_outer,
                knuckle_track_rod_outer_upper_front_outer,
                knuckle_track_rod_outer_upper_rear_outer,
            }
        }

        fn drives_at(&self, points: &Points<T>) -> Drives<T> {
            Drives {
                theta: parts::angle(
                    points.lower_front_outer.z - points.lower_front_inner.z,
                    self.lower_front.length(),
                ),
            }
        }

        fn fit(&self, q: &SVector<T, 15>, _fixed: &Fixed<T>) -> SVector<T, 15> {
            let mut free = Free::of(q);
            let [origin, second, third] = self.knuckle_frame.points();
            [
                free.lower_front_outer,
                free.upper_front_outer,
                free.upper_rear_outer,
                free.lower_rear_outer,
                free.track_rod_outer,
            ] = best_rigid_fit(
                &[
                    origin,
                    second,
                    third,
                    self.knuckle_lower_rear_outer.position(&self.knuckle_frame),
                    self.knuckle_track_rod_outer.position(&self.knuckle_frame),
                ],
                &[
                    free.lower_front_outer,
                    free.upper_front_outer,
                    free.upper_rear_outer,
                    free.lower_rear_outer,
                    free.track_rod_outer,
                ],
            );
            free.unknowns()
        }
    }

    impl<T: Scalar> HasWheel<T> for Points<T> {
        fn wheel(&self) -> [Vector3<T>; 2] {
            [self.upper_rear_outer, self.wheel_centre]
        }

        fn carrier(&self) -> [Vector3<T>; 3] {
            [self.lower_front_outer, self.upper_front_outer, self.upper_rear_outer]
        }
    }

    impl<T: Scalar> HasKingpin<T> for Points<T> {
        fn kingpin(&self) -> [Vector3<T>; 2] {
            [self.lower_front_outer, self.upper_rear_outer]
        }
    }
}
