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
#[allow(dead_code, non_snake_case, unreachable_pub)]
pub mod five_link {
    use ::suspension_core::generated::*;
    /// Every point, with a position, velocity or acceleration each.
    #[derive(Clone, Copy, Debug, PartialEq, Named)]
    pub struct Points<T> {
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
    pub struct Fixed<T> {
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
    pub struct Drives<T> {
        /// Angle of the lower leading link from the vertical, radians.
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
    #[derive(Clone, Copy, Debug, PartialEq)]
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
            let [[lower_front_outer_x, lower_front_outer_y, lower_front_outer_z,
            upper_front_outer_x, upper_front_outer_y, upper_front_outer_z,
            upper_rear_outer_x, upper_rear_outer_y, upper_rear_outer_z,
            lower_rear_outer_x, lower_rear_outer_y, lower_rear_outer_z,
            track_rod_outer_x, track_rod_outer_y, track_rod_outer_z]] = q.data.0;
            Self {
                lower_front_outer: Vector3::new(
                    lower_front_outer_x,
                    lower_front_outer_y,
                    lower_front_outer_z,
                ),
                upper_front_outer: Vector3::new(
                    upper_front_outer_x,
                    upper_front_outer_y,
                    upper_front_outer_z,
                ),
                upper_rear_outer: Vector3::new(
                    upper_rear_outer_x,
                    upper_rear_outer_y,
                    upper_rear_outer_z,
                ),
                lower_rear_outer: Vector3::new(
                    lower_rear_outer_x,
                    lower_rear_outer_y,
                    lower_rear_outer_z,
                ),
                track_rod_outer: Vector3::new(
                    track_rod_outer_x,
                    track_rod_outer_y,
                    track_rod_outer_z,
                ),
            }
        }

        #[inline(always)]
        fn unknowns(&self) -> SVector<T, 15> {
            let Self {
                lower_front_outer,
                upper_front_outer,
                upper_rear_outer,
                lower_rear_outer,
                track_rod_outer,
            } = self;
            SVector::from([
                lower_front_outer.x,
                lower_front_outer.y,
                lower_front_outer.z,
                upper_front_outer.x,
                upper_front_outer.y,
                upper_front_outer.z,
                upper_rear_outer.x,
                upper_rear_outer.y,
                upper_rear_outer.z,
                lower_rear_outer.x,
                lower_rear_outer.y,
                lower_rear_outer.z,
                track_rod_outer.x,
                track_rod_outer.y,
                track_rod_outer.z,
            ])
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
    pub struct Model<T> {
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
        #[inline(always)]
        fn linked(&self) -> impl Iterator<Item = usize> {
            [].into_iter()
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
            let coordinate = angle_to_coordinate(self.lower_front.length(), angle);
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
            let knuckle_frame = free.knuckle_frame();
            let knuckle_lower_rear_outer = self
                .knuckle_lower_rear_outer
                .residual(free.lower_rear_outer, &knuckle_frame);
            let knuckle_track_rod_outer = self
                .knuckle_track_rod_outer
                .residual(free.track_rod_outer, &knuckle_frame);
            let mut rows = [-T::zero(); 15];
            rows[equation::LOWER_FRONT] = self
                .lower_front
                .residual(difference(free.lower_front_outer, fixed.lower_front_inner));
            rows[equation::UPPER_FRONT] = self
                .upper_front
                .residual(difference(free.upper_front_outer, fixed.upper_front_inner));
            rows[equation::UPPER_REAR] = self
                .upper_rear
                .residual(difference(free.upper_rear_outer, fixed.upper_rear_inner));
            rows[equation::LOWER_REAR] = self
                .lower_rear
                .residual(difference(free.lower_rear_outer, fixed.lower_rear_inner));
            rows[equation::TRACK_ROD] = self
                .track_rod
                .residual(difference(free.track_rod_outer, fixed.track_rod_inner));
            rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_FRONT_OUTER] = self
                .knuckle_lower_front_outer_upper_front_outer
                .residual(difference(free.upper_front_outer, free.lower_front_outer));
            rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_REAR_OUTER] = self
                .knuckle_lower_front_outer_upper_rear_outer
                .residual(difference(free.upper_rear_outer, free.lower_front_outer));
            rows[equation::KNUCKLE_UPPER_FRONT_OUTER_UPPER_REAR_OUTER] = self
                .knuckle_upper_front_outer_upper_rear_outer
                .residual(difference(free.upper_rear_outer, free.upper_front_outer));
            rows[equation::KNUCKLE_LOWER_REAR_OUTER_X] = knuckle_lower_rear_outer.x;
            rows[equation::KNUCKLE_LOWER_REAR_OUTER_Y] = knuckle_lower_rear_outer.y;
            rows[equation::KNUCKLE_LOWER_REAR_OUTER_Z] = knuckle_lower_rear_outer.z;
            rows[equation::KNUCKLE_TRACK_ROD_OUTER_X] = knuckle_track_rod_outer.x;
            rows[equation::KNUCKLE_TRACK_ROD_OUTER_Y] = knuckle_track_rod_outer.y;
            rows[equation::KNUCKLE_TRACK_ROD_OUTER_Z] = knuckle_track_rod_outer.z;
            rows[equation::THETA] = free.lower_front_outer.z - fixed.lower_front_inner.z
                - drives.theta;
            SVector::from(rows)
        }

        #[cfg_attr(not(debug_assertions), inline(always))]
        fn jacobian(&self, q: &SVector<T, 15>, fixed: &Fixed<T>) -> SMatrix<T, 15, 15> {
            let free = Free::of(q);
            let knuckle_frame = free.knuckle_frame();
            let mut columns = [[T::zero(); 15]; 15];
            let gradient = self
                .lower_front
                .gradient(difference(free.lower_front_outer, fixed.lower_front_inner));
            columns[unknown::LOWER_FRONT_OUTER_X][equation::LOWER_FRONT] = gradient.x;
            columns[unknown::LOWER_FRONT_OUTER_Y][equation::LOWER_FRONT] = gradient.y;
            columns[unknown::LOWER_FRONT_OUTER_Z][equation::LOWER_FRONT] = gradient.z;
            let gradient = self
                .upper_front
                .gradient(difference(free.upper_front_outer, fixed.upper_front_inner));
            columns[unknown::UPPER_FRONT_OUTER_X][equation::UPPER_FRONT] = gradient.x;
            columns[unknown::UPPER_FRONT_OUTER_Y][equation::UPPER_FRONT] = gradient.y;
            columns[unknown::UPPER_FRONT_OUTER_Z][equation::UPPER_FRONT] = gradient.z;
            let gradient = self
                .upper_rear
                .gradient(difference(free.upper_rear_outer, fixed.upper_rear_inner));
            columns[unknown::UPPER_REAR_OUTER_X][equation::UPPER_REAR] = gradient.x;
            columns[unknown::UPPER_REAR_OUTER_Y][equation::UPPER_REAR] = gradient.y;
            columns[unknown::UPPER_REAR_OUTER_Z][equation::UPPER_REAR] = gradient.z;
            let gradient = self
                .lower_rear
                .gradient(difference(free.lower_rear_outer, fixed.lower_rear_inner));
            columns[unknown::LOWER_REAR_OUTER_X][equation::LOWER_REAR] = gradient.x;
            columns[unknown::LOWER_REAR_OUTER_Y][equation::LOWER_REAR] = gradient.y;
            columns[unknown::LOWER_REAR_OUTER_Z][equation::LOWER_REAR] = gradient.z;
            let gradient = self
                .track_rod
                .gradient(difference(free.track_rod_outer, fixed.track_rod_inner));
            columns[unknown::TRACK_ROD_OUTER_X][equation::TRACK_ROD] = gradient.x;
            columns[unknown::TRACK_ROD_OUTER_Y][equation::TRACK_ROD] = gradient.y;
            columns[unknown::TRACK_ROD_OUTER_Z][equation::TRACK_ROD] = gradient.z;
            let gradient = self
                .knuckle_lower_front_outer_upper_front_outer
                .gradient(difference(free.upper_front_outer, free.lower_front_outer));
            columns[unknown::UPPER_FRONT_OUTER_X][equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_FRONT_OUTER] = gradient
                .x;
            columns[unknown::UPPER_FRONT_OUTER_Y][equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_FRONT_OUTER] = gradient
                .y;
            columns[unknown::UPPER_FRONT_OUTER_Z][equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_FRONT_OUTER] = gradient
                .z;
            columns[unknown::LOWER_FRONT_OUTER_X][equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_FRONT_OUTER] = -gradient
                .x;
            columns[unknown::LOWER_FRONT_OUTER_Y][equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_FRONT_OUTER] = -gradient
                .y;
            columns[unknown::LOWER_FRONT_OUTER_Z][equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_FRONT_OUTER] = -gradient
                .z;
            let gradient = self
                .knuckle_lower_front_outer_upper_rear_outer
                .gradient(difference(free.upper_rear_outer, free.lower_front_outer));
            columns[unknown::UPPER_REAR_OUTER_X][equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_REAR_OUTER] = gradient
                .x;
            columns[unknown::UPPER_REAR_OUTER_Y][equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_REAR_OUTER] = gradient
                .y;
            columns[unknown::UPPER_REAR_OUTER_Z][equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_REAR_OUTER] = gradient
                .z;
            columns[unknown::LOWER_FRONT_OUTER_X][equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_REAR_OUTER] = -gradient
                .x;
            columns[unknown::LOWER_FRONT_OUTER_Y][equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_REAR_OUTER] = -gradient
                .y;
            columns[unknown::LOWER_FRONT_OUTER_Z][equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_REAR_OUTER] = -gradient
                .z;
            let gradient = self
                .knuckle_upper_front_outer_upper_rear_outer
                .gradient(difference(free.upper_rear_outer, free.upper_front_outer));
            columns[unknown::UPPER_REAR_OUTER_X][equation::KNUCKLE_UPPER_FRONT_OUTER_UPPER_REAR_OUTER] = gradient
                .x;
            columns[unknown::UPPER_REAR_OUTER_Y][equation::KNUCKLE_UPPER_FRONT_OUTER_UPPER_REAR_OUTER] = gradient
                .y;
            columns[unknown::UPPER_REAR_OUTER_Z][equation::KNUCKLE_UPPER_FRONT_OUTER_UPPER_REAR_OUTER] = gradient
                .z;
            columns[unknown::UPPER_FRONT_OUTER_X][equation::KNUCKLE_UPPER_FRONT_OUTER_UPPER_REAR_OUTER] = -gradient
                .x;
            columns[unknown::UPPER_FRONT_OUTER_Y][equation::KNUCKLE_UPPER_FRONT_OUTER_UPPER_REAR_OUTER] = -gradient
                .y;
            columns[unknown::UPPER_FRONT_OUTER_Z][equation::KNUCKLE_UPPER_FRONT_OUTER_UPPER_REAR_OUTER] = -gradient
                .z;
            let gradient = self.knuckle_lower_rear_outer.gradient(&knuckle_frame);
            columns[unknown::LOWER_REAR_OUTER_X][equation::KNUCKLE_LOWER_REAR_OUTER_X] = T::one();
            columns[unknown::LOWER_REAR_OUTER_Y][equation::KNUCKLE_LOWER_REAR_OUTER_Y] = T::one();
            columns[unknown::LOWER_REAR_OUTER_Z][equation::KNUCKLE_LOWER_REAR_OUTER_Z] = T::one();
            columns[unknown::LOWER_FRONT_OUTER_X][equation::KNUCKLE_LOWER_REAR_OUTER_X] = gradient
                .origin
                .m11;
            columns[unknown::LOWER_FRONT_OUTER_Y][equation::KNUCKLE_LOWER_REAR_OUTER_X] = gradient
                .origin
                .m12;
            columns[unknown::LOWER_FRONT_OUTER_Z][equation::KNUCKLE_LOWER_REAR_OUTER_X] = gradient
                .origin
                .m13;
            columns[unknown::LOWER_FRONT_OUTER_X][equation::KNUCKLE_LOWER_REAR_OUTER_Y] = gradient
                .origin
                .m21;
            columns[unknown::LOWER_FRONT_OUTER_Y][equation::KNUCKLE_LOWER_REAR_OUTER_Y] = gradient
                .origin
                .m22;
            columns[unknown::LOWER_FRONT_OUTER_Z][equation::KNUCKLE_LOWER_REAR_OUTER_Y] = gradient
                .origin
                .m23;
            columns[unknown::LOWER_FRONT_OUTER_X][equation::KNUCKLE_LOWER_REAR_OUTER_Z] = gradient
                .origin
                .m31;
            columns[unknown::LOWER_FRONT_OUTER_Y][equation::KNUCKLE_LOWER_REAR_OUTER_Z] = gradient
                .origin
                .m32;
            columns[unknown::LOWER_FRONT_OUTER_Z][equation::KNUCKLE_LOWER_REAR_OUTER_Z] = gradient
                .origin
                .m33;
            columns[unknown::UPPER_FRONT_OUTER_X][equation::KNUCKLE_LOWER_REAR_OUTER_X] = gradient
                .second
                .m11;
            columns[unknown::UPPER_FRONT_OUTER_Y][equation::KNUCKLE_LOWER_REAR_OUTER_X] = gradient
                .second
                .m12;
            columns[unknown::UPPER_FRONT_OUTER_Z][equation::KNUCKLE_LOWER_REAR_OUTER_X] = gradient
                .second
                .m13;
            columns[unknown::UPPER_FRONT_OUTER_X][equation::KNUCKLE_LOWER_REAR_OUTER_Y] = gradient
                .second
                .m21;
            columns[unknown::UPPER_FRONT_OUTER_Y][equation::KNUCKLE_LOWER_REAR_OUTER_Y] = gradient
                .second
                .m22;
            columns[unknown::UPPER_FRONT_OUTER_Z][equation::KNUCKLE_LOWER_REAR_OUTER_Y] = gradient
                .second
                .m23;
            columns[unknown::UPPER_FRONT_OUTER_X][equation::KNUCKLE_LOWER_REAR_OUTER_Z] = gradient
                .second
                .m31;
            columns[unknown::UPPER_FRONT_OUTER_Y][equation::KNUCKLE_LOWER_REAR_OUTER_Z] = gradient
                .second
                .m32;
            columns[unknown::UPPER_FRONT_OUTER_Z][equation::KNUCKLE_LOWER_REAR_OUTER_Z] = gradient
                .second
                .m33;
            columns[unknown::UPPER_REAR_OUTER_X][equation::KNUCKLE_LOWER_REAR_OUTER_X] = gradient
                .third
                .m11;
            columns[unknown::UPPER_REAR_OUTER_Y][equation::KNUCKLE_LOWER_REAR_OUTER_X] = gradient
                .third
                .m12;
            columns[unknown::UPPER_REAR_OUTER_Z][equation::KNUCKLE_LOWER_REAR_OUTER_X] = gradient
                .third
                .m13;
            columns[unknown::UPPER_REAR_OUTER_X][equation::KNUCKLE_LOWER_REAR_OUTER_Y] = gradient
                .third
                .m21;
            columns[unknown::UPPER_REAR_OUTER_Y][equation::KNUCKLE_LOWER_REAR_OUTER_Y] = gradient
                .third
                .m22;
            columns[unknown::UPPER_REAR_OUTER_Z][equation::KNUCKLE_LOWER_REAR_OUTER_Y] = gradient
                .third
                .m23;
            columns[unknown::UPPER_REAR_OUTER_X][equation::KNUCKLE_LOWER_REAR_OUTER_Z] = gradient
                .third
                .m31;
            columns[unknown::UPPER_REAR_OUTER_Y][equation::KNUCKLE_LOWER_REAR_OUTER_Z] = gradient
                .third
                .m32;
            columns[unknown::UPPER_REAR_OUTER_Z][equation::KNUCKLE_LOWER_REAR_OUTER_Z] = gradient
                .third
                .m33;
            let gradient = self.knuckle_track_rod_outer.gradient(&knuckle_frame);
            columns[unknown::TRACK_ROD_OUTER_X][equation::KNUCKLE_TRACK_ROD_OUTER_X] = T::one();
            columns[unknown::TRACK_ROD_OUTER_Y][equation::KNUCKLE_TRACK_ROD_OUTER_Y] = T::one();
            columns[unknown::TRACK_ROD_OUTER_Z][equation::KNUCKLE_TRACK_ROD_OUTER_Z] = T::one();
            columns[unknown::LOWER_FRONT_OUTER_X][equation::KNUCKLE_TRACK_ROD_OUTER_X] = gradient
                .origin
                .m11;
            columns[unknown::LOWER_FRONT_OUTER_Y][equation::KNUCKLE_TRACK_ROD_OUTER_X] = gradient
                .origin
                .m12;
            columns[unknown::LOWER_FRONT_OUTER_Z][equation::KNUCKLE_TRACK_ROD_OUTER_X] = gradient
                .origin
                .m13;
            columns[unknown::LOWER_FRONT_OUTER_X][equation::KNUCKLE_TRACK_ROD_OUTER_Y] = gradient
                .origin
                .m21;
            columns[unknown::LOWER_FRONT_OUTER_Y][equation::KNUCKLE_TRACK_ROD_OUTER_Y] = gradient
                .origin
                .m22;
            columns[unknown::LOWER_FRONT_OUTER_Z][equation::KNUCKLE_TRACK_ROD_OUTER_Y] = gradient
                .origin
                .m23;
            columns[unknown::LOWER_FRONT_OUTER_X][equation::KNUCKLE_TRACK_ROD_OUTER_Z] = gradient
                .origin
                .m31;
            columns[unknown::LOWER_FRONT_OUTER_Y][equation::KNUCKLE_TRACK_ROD_OUTER_Z] = gradient
                .origin
                .m32;
            columns[unknown::LOWER_FRONT_OUTER_Z][equation::KNUCKLE_TRACK_ROD_OUTER_Z] = gradient
                .origin
                .m33;
            columns[unknown::UPPER_FRONT_OUTER_X][equation::KNUCKLE_TRACK_ROD_OUTER_X] = gradient
                .second
                .m11;
            columns[unknown::UPPER_FRONT_OUTER_Y][equation::KNUCKLE_TRACK_ROD_OUTER_X] = gradient
                .second
                .m12;
            columns[unknown::UPPER_FRONT_OUTER_Z][equation::KNUCKLE_TRACK_ROD_OUTER_X] = gradient
                .second
                .m13;
            columns[unknown::UPPER_FRONT_OUTER_X][equation::KNUCKLE_TRACK_ROD_OUTER_Y] = gradient
                .second
                .m21;
            columns[unknown::UPPER_FRONT_OUTER_Y][equation::KNUCKLE_TRACK_ROD_OUTER_Y] = gradient
                .second
                .m22;
            columns[unknown::UPPER_FRONT_OUTER_Z][equation::KNUCKLE_TRACK_ROD_OUTER_Y] = gradient
                .second
                .m23;
            columns[unknown::UPPER_FRONT_OUTER_X][equation::KNUCKLE_TRACK_ROD_OUTER_Z] = gradient
                .second
                .m31;
            columns[unknown::UPPER_FRONT_OUTER_Y][equation::KNUCKLE_TRACK_ROD_OUTER_Z] = gradient
                .second
                .m32;
            columns[unknown::UPPER_FRONT_OUTER_Z][equation::KNUCKLE_TRACK_ROD_OUTER_Z] = gradient
                .second
                .m33;
            columns[unknown::UPPER_REAR_OUTER_X][equation::KNUCKLE_TRACK_ROD_OUTER_X] = gradient
                .third
                .m11;
            columns[unknown::UPPER_REAR_OUTER_Y][equation::KNUCKLE_TRACK_ROD_OUTER_X] = gradient
                .third
                .m12;
            columns[unknown::UPPER_REAR_OUTER_Z][equation::KNUCKLE_TRACK_ROD_OUTER_X] = gradient
                .third
                .m13;
            columns[unknown::UPPER_REAR_OUTER_X][equation::KNUCKLE_TRACK_ROD_OUTER_Y] = gradient
                .third
                .m21;
            columns[unknown::UPPER_REAR_OUTER_Y][equation::KNUCKLE_TRACK_ROD_OUTER_Y] = gradient
                .third
                .m22;
            columns[unknown::UPPER_REAR_OUTER_Z][equation::KNUCKLE_TRACK_ROD_OUTER_Y] = gradient
                .third
                .m23;
            columns[unknown::UPPER_REAR_OUTER_X][equation::KNUCKLE_TRACK_ROD_OUTER_Z] = gradient
                .third
                .m31;
            columns[unknown::UPPER_REAR_OUTER_Y][equation::KNUCKLE_TRACK_ROD_OUTER_Z] = gradient
                .third
                .m32;
            columns[unknown::UPPER_REAR_OUTER_Z][equation::KNUCKLE_TRACK_ROD_OUTER_Z] = gradient
                .third
                .m33;
            columns[unknown::LOWER_FRONT_OUTER_Z][equation::THETA] = T::one();
            from_columns(columns)
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
            let gradient = self
                .lower_front
                .gradient(difference(free.lower_front_outer, fixed.lower_front_inner));
            let lower_front_by_lower_front_outer_x = gradient.x;
            let lower_front_by_lower_front_outer_y = gradient.y;
            let lower_front_by_lower_front_outer_z = gradient.z;
            let gradient = self
                .upper_front
                .gradient(difference(free.upper_front_outer, fixed.upper_front_inner));
            let upper_front_by_upper_front_outer_x = gradient.x;
            let upper_front_by_upper_front_outer_y = gradient.y;
            let upper_front_by_upper_front_outer_z = gradient.z;
            let gradient = self
                .upper_rear
                .gradient(difference(free.upper_rear_outer, fixed.upper_rear_inner));
            let upper_rear_by_upper_rear_outer_x = gradient.x;
            let upper_rear_by_upper_rear_outer_y = gradient.y;
            let upper_rear_by_upper_rear_outer_z = gradient.z;
            let gradient = self
                .lower_rear
                .gradient(difference(free.lower_rear_outer, fixed.lower_rear_inner));
            let lower_rear_by_lower_rear_outer_x = gradient.x;
            let lower_rear_by_lower_rear_outer_y = gradient.y;
            let lower_rear_by_lower_rear_outer_z = gradient.z;
            let gradient = self
                .track_rod
                .gradient(difference(free.track_rod_outer, fixed.track_rod_inner));
            let track_rod_by_track_rod_outer_x = gradient.x;
            let track_rod_by_track_rod_outer_y = gradient.y;
            let track_rod_by_track_rod_outer_z = gradient.z;
            let gradient = self
                .knuckle_lower_front_outer_upper_front_outer
                .gradient(difference(free.upper_front_outer, free.lower_front_outer));
            let knuckle_lower_front_outer_upper_front_outer_by_upper_front_outer_x = gradient
                .x;
            let knuckle_lower_front_outer_upper_front_outer_by_upper_front_outer_y = gradient
                .y;
            let knuckle_lower_front_outer_upper_front_outer_by_upper_front_outer_z = gradient
                .z;
            let knuckle_lower_front_outer_upper_front_outer_by_lower_front_outer_x = -gradient
                .x;
            let knuckle_lower_front_outer_upper_front_outer_by_lower_front_outer_y = -gradient
                .y;
            let knuckle_lower_front_outer_upper_front_outer_by_lower_front_outer_z = -gradient
                .z;
            let gradient = self
                .knuckle_lower_front_outer_upper_rear_outer
                .gradient(difference(free.upper_rear_outer, free.lower_front_outer));
            let knuckle_lower_front_outer_upper_rear_outer_by_upper_rear_outer_x = gradient
                .x;
            let knuckle_lower_front_outer_upper_rear_outer_by_upper_rear_outer_y = gradient
                .y;
            let knuckle_lower_front_outer_upper_rear_outer_by_upper_rear_outer_z = gradient
                .z;
            let knuckle_lower_front_outer_upper_rear_outer_by_lower_front_outer_x = -gradient
                .x;
            let knuckle_lower_front_outer_upper_rear_outer_by_lower_front_outer_y = -gradient
                .y;
            let knuckle_lower_front_outer_upper_rear_outer_by_lower_front_outer_z = -gradient
                .z;
            let gradient = self
                .knuckle_upper_front_outer_upper_rear_outer
                .gradient(difference(free.upper_rear_outer, free.upper_front_outer));
            let knuckle_upper_front_outer_upper_rear_outer_by_upper_rear_outer_x = gradient
                .x;
            let knuckle_upper_front_outer_upper_rear_outer_by_upper_rear_outer_y = gradient
                .y;
            let knuckle_upper_front_outer_upper_rear_outer_by_upper_rear_outer_z = gradient
                .z;
            let knuckle_upper_front_outer_upper_rear_outer_by_upper_front_outer_x = -gradient
                .x;
            let knuckle_upper_front_outer_upper_rear_outer_by_upper_front_outer_y = -gradient
                .y;
            let knuckle_upper_front_outer_upper_rear_outer_by_upper_front_outer_z = -gradient
                .z;
            let [origin, second, third] = self
                .knuckle_lower_rear_outer
                .by_frame(
                    Vector3::new(
                        lower_rear_by_lower_rear_outer_x,
                        lower_rear_by_lower_rear_outer_y,
                        lower_rear_by_lower_rear_outer_z,
                    ),
                    &knuckle_frame,
                );
            let lower_rear_by_lower_front_outer_x = origin.x;
            let lower_rear_by_lower_front_outer_y = origin.y;
            let lower_rear_by_lower_front_outer_z = origin.z;
            let lower_rear_by_upper_front_outer_x = second.x;
            let lower_rear_by_upper_front_outer_y = second.y;
            let lower_rear_by_upper_front_outer_z = second.z;
            let lower_rear_by_upper_rear_outer_x = third.x;
            let lower_rear_by_upper_rear_outer_y = third.y;
            let lower_rear_by_upper_rear_outer_z = third.z;
            let [origin, second, third] = self
                .knuckle_track_rod_outer
                .by_frame(
                    Vector3::new(
                        track_rod_by_track_rod_outer_x,
                        track_rod_by_track_rod_outer_y,
                        track_rod_by_track_rod_outer_z,
                    ),
                    &knuckle_frame,
                );
            let track_rod_by_lower_front_outer_x = origin.x;
            let track_rod_by_lower_front_outer_y = origin.y;
            let track_rod_by_lower_front_outer_z = origin.z;
            let track_rod_by_upper_front_outer_x = second.x;
            let track_rod_by_upper_front_outer_y = second.y;
            let track_rod_by_upper_front_outer_z = second.z;
            let track_rod_by_upper_rear_outer_x = third.x;
            let track_rod_by_upper_rear_outer_y = third.y;
            let track_rod_by_upper_rear_outer_z = third.z;
            let lower_front_by_lower_front_outer_y = T::one()
                / lower_front_by_lower_front_outer_y;
            let lower_rear_by_lower_front_outer_y = lower_rear_by_lower_front_outer_y
                * lower_front_by_lower_front_outer_y;
            let lower_rear_by_lower_front_outer_x = lower_rear_by_lower_front_outer_x
                .minus_product(
                    lower_rear_by_lower_front_outer_y,
                    lower_front_by_lower_front_outer_x,
                );
            let track_rod_by_lower_front_outer_y = track_rod_by_lower_front_outer_y
                * lower_front_by_lower_front_outer_y;
            let track_rod_by_lower_front_outer_x = track_rod_by_lower_front_outer_x
                .minus_product(
                    track_rod_by_lower_front_outer_y,
                    lower_front_by_lower_front_outer_x,
                );
            let knuckle_lower_front_outer_upper_front_outer_by_lower_front_outer_y = knuckle_lower_front_outer_upper_front_outer_by_lower_front_outer_y
                * lower_front_by_lower_front_outer_y;
            let knuckle_lower_front_outer_upper_front_outer_by_lower_front_outer_x = knuckle_lower_front_outer_upper_front_outer_by_lower_front_outer_x
                .minus_product(
                    knuckle_lower_front_outer_upper_front_outer_by_lower_front_outer_y,
                    lower_front_by_lower_front_outer_x,
                );
            let knuckle_lower_front_outer_upper_rear_outer_by_lower_front_outer_y = knuckle_lower_front_outer_upper_rear_outer_by_lower_front_outer_y
                * lower_front_by_lower_front_outer_y;
            let knuckle_lower_front_outer_upper_rear_outer_by_lower_front_outer_x = knuckle_lower_front_outer_upper_rear_outer_by_lower_front_outer_x
                .minus_product(
                    knuckle_lower_front_outer_upper_rear_outer_by_lower_front_outer_y,
                    lower_front_by_lower_front_outer_x,
                );
            let lower_front_by_lower_front_outer_x = lower_front_by_lower_front_outer_x
                * lower_front_by_lower_front_outer_y;
            let upper_rear_by_upper_rear_outer_x = T::one()
                / upper_rear_by_upper_rear_outer_x;
            let lower_rear_by_upper_rear_outer_x = lower_rear_by_upper_rear_outer_x
                * upper_rear_by_upper_rear_outer_x;
            let lower_rear_by_upper_rear_outer_y = lower_rear_by_upper_rear_outer_y
                .minus_product(
                    lower_rear_by_upper_rear_outer_x,
                    upper_rear_by_upper_rear_outer_y,
                );
            let lower_rear_by_upper_rear_outer_z = lower_rear_by_upper_rear_outer_z
                .minus_product(
                    lower_rear_by_upper_rear_outer_x,
                    upper_rear_by_upper_rear_outer_z,
                );
            let track_rod_by_upper_rear_outer_x = track_rod_by_upper_rear_outer_x
                * upper_rear_by_upper_rear_outer_x;
            let track_rod_by_upper_rear_outer_y = track_rod_by_upper_rear_outer_y
                .minus_product(
                    track_rod_by_upper_rear_outer_x,
                    upper_rear_by_upper_rear_outer_y,
                );
            let track_rod_by_upper_rear_outer_z = track_rod_by_upper_rear_outer_z
                .minus_product(
                    track_rod_by_upper_rear_outer_x,
                    upper_rear_by_upper_rear_outer_z,
                );
            let knuckle_lower_front_outer_upper_rear_outer_by_upper_rear_outer_x = knuckle_lower_front_outer_upper_rear_outer_by_upper_rear_outer_x
                * upper_rear_by_upper_rear_outer_x;
            let knuckle_lower_front_outer_upper_rear_outer_by_upper_rear_outer_y = knuckle_lower_front_outer_upper_rear_outer_by_upper_rear_outer_y
                .minus_product(
                    knuckle_lower_front_outer_upper_rear_outer_by_upper_rear_outer_x,
                    upper_rear_by_upper_rear_outer_y,
                );
            let knuckle_lower_front_outer_upper_rear_outer_by_upper_rear_outer_z = knuckle_lower_front_outer_upper_rear_outer_by_upper_rear_outer_z
                .minus_product(
                    knuckle_lower_front_outer_upper_rear_outer_by_upper_rear_outer_x,
                    upper_rear_by_upper_rear_outer_z,
                );
            let knuckle_upper_front_outer_upper_rear_outer_by_upper_rear_outer_x = knuckle_upper_front_outer_upper_rear_outer_by_upper_rear_outer_x
                * upper_rear_by_upper_rear_outer_x;
            let knuckle_upper_front_outer_upper_rear_outer_by_upper_rear_outer_y = knuckle_upper_front_outer_upper_rear_outer_by_upper_rear_outer_y
                .minus_product(
                    knuckle_upper_front_outer_upper_rear_outer_by_upper_rear_outer_x,
                    upper_rear_by_upper_rear_outer_y,
                );
            let knuckle_upper_front_outer_upper_rear_outer_by_upper_rear_outer_z = knuckle_upper_front_outer_upper_rear_outer_by_upper_rear_outer_z
                .minus_product(
                    knuckle_upper_front_outer_upper_rear_outer_by_upper_rear_outer_x,
                    upper_rear_by_upper_rear_outer_z,
                );
            let upper_rear_by_upper_rear_outer_y = upper_rear_by_upper_rear_outer_y
                * upper_rear_by_upper_rear_outer_x;
            let upper_rear_by_upper_rear_outer_z = upper_rear_by_upper_rear_outer_z
                * upper_rear_by_upper_rear_outer_x;
            let knuckle_lower_front_outer_upper_rear_outer_by_upper_rear_outer_z = T::one()
                / knuckle_lower_front_outer_upper_rear_outer_by_upper_rear_outer_z;
            let lower_rear_by_upper_rear_outer_z = lower_rear_by_upper_rear_outer_z
                * knuckle_lower_front_outer_upper_rear_outer_by_upper_rear_outer_z;
            let lower_rear_by_upper_rear_outer_y = lower_rear_by_upper_rear_outer_y
                .minus_product(
                    lower_rear_by_upper_rear_outer_z,
                    knuckle_lower_front_outer_upper_rear_outer_by_upper_rear_outer_y,
                );
            let lower_rear_by_lower_front_outer_x = lower_rear_by_lower_front_outer_x
                .minus_product(
                    lower_rear_by_upper_rear_outer_z,
                    knuckle_lower_front_outer_upper_rear_outer_by_lower_front_outer_x,
                );
            let track_rod_by_upper_rear_outer_z = track_rod_by_upper_rear_outer_z
                * knuckle_lower_front_outer_upper_rear_outer_by_upper_rear_outer_z;
            let track_rod_by_upper_rear_outer_y = track_rod_by_upper_rear_outer_y
                .minus_product(
                    track_rod_by_upper_rear_outer_z,
                    knuckle_lower_front_outer_upper_rear_outer_by_upper_rear_outer_y,
                );
            let track_rod_by_lower_front_outer_x = track_rod_by_lower_front_outer_x
                .minus_product(
                    track_rod_by_upper_rear_outer_z,
                    knuckle_lower_front_outer_upper_rear_outer_by_lower_front_outer_x,
                );
            let knuckle_upper_front_outer_upper_rear_outer_by_upper_rear_outer_z = knuckle_upper_front_outer_upper_rear_outer_by_upper_rear_outer_z
                * knuckle_lower_front_outer_upper_rear_outer_by_upper_rear_outer_z;
            let knuckle_upper_front_outer_upper_rear_outer_by_upper_rear_outer_y = knuckle_upper_front_outer_upper_rear_outer_by_upper_rear_outer_y
                .minus_product(
                    knuckle_upper_front_outer_upper_rear_outer_by_upper_rear_outer_z,
                    knuckle_lower_front_outer_upper_rear_outer_by_upper_rear_outer_y,
                );
            let knuckle_upper_front_outer_upper_rear_outer_by_lower_front_outer_x = -(knuckle_upper_front_outer_upper_rear_outer_by_upper_rear_outer_z
                * knuckle_lower_front_outer_upper_rear_outer_by_lower_front_outer_x);
            let knuckle_lower_front_outer_upper_rear_outer_by_upper_rear_outer_y = knuckle_lower_front_outer_upper_rear_outer_by_upper_rear_outer_y
                * knuckle_lower_front_outer_upper_rear_outer_by_upper_rear_outer_z;
            let knuckle_lower_front_outer_upper_rear_outer_by_lower_front_outer_x = knuckle_lower_front_outer_upper_rear_outer_by_lower_front_outer_x
                * knuckle_lower_front_outer_upper_rear_outer_by_upper_rear_outer_z;
            let knuckle_lower_front_outer_upper_front_outer_by_upper_front_outer_z = T::one()
                / knuckle_lower_front_outer_upper_front_outer_by_upper_front_outer_z;
            let upper_front_by_upper_front_outer_z = upper_front_by_upper_front_outer_z
                * knuckle_lower_front_outer_upper_front_outer_by_upper_front_outer_z;
            let upper_front_by_lower_front_outer_x = -(upper_front_by_upper_front_outer_z
                * knuckle_lower_front_outer_upper_front_outer_by_lower_front_outer_x);
            let upper_front_by_upper_front_outer_x = upper_front_by_upper_front_outer_x
                .minus_product(
                    upper_front_by_upper_front_outer_z,
                    knuckle_lower_front_outer_upper_front_outer_by_upper_front_outer_x,
                );
            let upper_front_by_upper_front_outer_y = upper_front_by_upper_front_outer_y
                .minus_product(
                    upper_front_by_upper_front_outer_z,
                    knuckle_lower_front_outer_upper_front_outer_by_upper_front_outer_y,
                );
            let lower_rear_by_upper_front_outer_z = lower_rear_by_upper_front_outer_z
                * knuckle_lower_front_outer_upper_front_outer_by_upper_front_outer_z;
            let lower_rear_by_lower_front_outer_x = lower_rear_by_lower_front_outer_x
                .minus_product(
                    lower_rear_by_upper_front_outer_z,
                    knuckle_lower_front_outer_upper_front_outer_by_lower_front_outer_x,
                );
            let lower_rear_by_upper_front_outer_x = lower_rear_by_upper_front_outer_x
                .minus_product(
                    lower_rear_by_upper_front_outer_z,
                    knuckle_lower_front_outer_upper_front_outer_by_upper_front_outer_x,
                );
            let lower_rear_by_upper_front_outer_y = lower_rear_by_upper_front_outer_y
                .minus_product(
                    lower_rear_by_upper_front_outer_z,
                    knuckle_lower_front_outer_upper_front_outer_by_upper_front_outer_y,
                );
            let track_rod_by_upper_front_outer_z = track_rod_by_upper_front_outer_z
                * knuckle_lower_front_outer_upper_front_outer_by_upper_front_outer_z;
            let track_rod_by_lower_front_outer_x = track_rod_by_lower_front_outer_x
                .minus_product(
                    track_rod_by_upper_front_outer_z,
                    knuckle_lower_front_outer_upper_front_outer_by_lower_front_outer_x,
                );
            let track_rod_by_upper_front_outer_x = track_rod_by_upper_front_outer_x
                .minus_product(
                    track_rod_by_upper_front_outer_z,
                    knuckle_lower_front_outer_upper_front_outer_by_upper_front_outer_x,
                );
            let track_rod_by_upper_front_outer_y = track_rod_by_upper_front_outer_y
                .minus_product(
                    track_rod_by_upper_front_outer_z,
                    knuckle_lower_front_outer_upper_front_outer_by_upper_front_outer_y,
                );
            let knuckle_upper_front_outer_upper_rear_outer_by_upper_front_outer_z = knuckle_upper_front_outer_upper_rear_outer_by_upper_front_outer_z
                * knuckle_lower_front_outer_upper_front_outer_by_upper_front_outer_z;
            let knuckle_upper_front_outer_upper_rear_outer_by_lower_front_outer_x = knuckle_upper_front_outer_upper_rear_outer_by_lower_front_outer_x
                .minus_product(
                    knuckle_upper_front_outer_upper_rear_outer_by_upper_front_outer_z,
                    knuckle_lower_front_outer_upper_front_outer_by_lower_front_outer_x,
                );
            let knuckle_upper_front_outer_upper_rear_outer_by_upper_front_outer_x = knuckle_upper_front_outer_upper_rear_outer_by_upper_front_outer_x
                .minus_product(
                    knuckle_upper_front_outer_upper_rear_outer_by_upper_front_outer_z,
                    knuckle_lower_front_outer_upper_front_outer_by_upper_front_outer_x,
                );
            let knuckle_upper_front_outer_upper_rear_outer_by_upper_front_outer_y = knuckle_upper_front_outer_upper_rear_outer_by_upper_front_outer_y
                .minus_product(
                    knuckle_upper_front_outer_upper_rear_outer_by_upper_front_outer_z,
                    knuckle_lower_front_outer_upper_front_outer_by_upper_front_outer_y,
                );
            let knuckle_lower_front_outer_upper_front_outer_by_lower_front_outer_x = knuckle_lower_front_outer_upper_front_outer_by_lower_front_outer_x
                * knuckle_lower_front_outer_upper_front_outer_by_upper_front_outer_z;
            let knuckle_lower_front_outer_upper_front_outer_by_upper_front_outer_x = knuckle_lower_front_outer_upper_front_outer_by_upper_front_outer_x
                * knuckle_lower_front_outer_upper_front_outer_by_upper_front_outer_z;
            let knuckle_lower_front_outer_upper_front_outer_by_upper_front_outer_y = knuckle_lower_front_outer_upper_front_outer_by_upper_front_outer_y
                * knuckle_lower_front_outer_upper_front_outer_by_upper_front_outer_z;
            let upper_front_by_upper_front_outer_y = T::one()
                / upper_front_by_upper_front_outer_y;
            let lower_rear_by_upper_front_outer_y = lower_rear_by_upper_front_outer_y
                * upper_front_by_upper_front_outer_y;
            let lower_rear_by_lower_front_outer_x = lower_rear_by_lower_front_outer_x
                .minus_product(
                    lower_rear_by_upper_front_outer_y,
                    upper_front_by_lower_front_outer_x,
                );
            let lower_rear_by_upper_front_outer_x = lower_rear_by_upper_front_outer_x
                .minus_product(
                    lower_rear_by_upper_front_outer_y,
                    upper_front_by_upper_front_outer_x,
                );
            let track_rod_by_upper_front_outer_y = track_rod_by_upper_front_outer_y
                * upper_front_by_upper_front_outer_y;
            let track_rod_by_lower_front_outer_x = track_rod_by_lower_front_outer_x
                .minus_product(
                    track_rod_by_upper_front_outer_y,
                    upper_front_by_lower_front_outer_x,
                );
            let track_rod_by_upper_front_outer_x = track_rod_by_upper_front_outer_x
                .minus_product(
                    track_rod_by_upper_front_outer_y,
                    upper_front_by_upper_front_outer_x,
                );
            let knuckle_upper_front_outer_upper_rear_outer_by_upper_front_outer_y = knuckle_upper_front_outer_upper_rear_outer_by_upper_front_outer_y
                * upper_front_by_upper_front_outer_y;
            let knuckle_upper_front_outer_upper_rear_outer_by_lower_front_outer_x = knuckle_upper_front_outer_upper_rear_outer_by_lower_front_outer_x
                .minus_product(
                    knuckle_upper_front_outer_upper_rear_outer_by_upper_front_outer_y,
                    upper_front_by_lower_front_outer_x,
                );
            let knuckle_upper_front_outer_upper_rear_outer_by_upper_front_outer_x = knuckle_upper_front_outer_upper_rear_outer_by_upper_front_outer_x
                .minus_product(
                    knuckle_upper_front_outer_upper_rear_outer_by_upper_front_outer_y,
                    upper_front_by_upper_front_outer_x,
                );
            let upper_front_by_lower_front_outer_x = upper_front_by_lower_front_outer_x
                * upper_front_by_upper_front_outer_y;
            let upper_front_by_upper_front_outer_x = upper_front_by_upper_front_outer_x
                * upper_front_by_upper_front_outer_y;
            let lower_rear_by_upper_front_outer_x = T::one()
                / lower_rear_by_upper_front_outer_x;
            let track_rod_by_upper_front_outer_x = track_rod_by_upper_front_outer_x
                * lower_rear_by_upper_front_outer_x;
            let track_rod_by_upper_rear_outer_y = track_rod_by_upper_rear_outer_y
                .minus_product(
                    track_rod_by_upper_front_outer_x,
                    lower_rear_by_upper_rear_outer_y,
                );
            let track_rod_by_lower_front_outer_x = track_rod_by_lower_front_outer_x
                .minus_product(
                    track_rod_by_upper_front_outer_x,
                    lower_rear_by_lower_front_outer_x,
                );
            let knuckle_upper_front_outer_upper_rear_outer_by_upper_front_outer_x = knuckle_upper_front_outer_upper_rear_outer_by_upper_front_outer_x
                * lower_rear_by_upper_front_outer_x;
            let knuckle_upper_front_outer_upper_rear_outer_by_upper_rear_outer_y = knuckle_upper_front_outer_upper_rear_outer_by_upper_rear_outer_y
                .minus_product(
                    knuckle_upper_front_outer_upper_rear_outer_by_upper_front_outer_x,
                    lower_rear_by_upper_rear_outer_y,
                );
            let knuckle_upper_front_outer_upper_rear_outer_by_lower_front_outer_x = knuckle_upper_front_outer_upper_rear_outer_by_lower_front_outer_x
                .minus_product(
                    knuckle_upper_front_outer_upper_rear_outer_by_upper_front_outer_x,
                    lower_rear_by_lower_front_outer_x,
                );
            let lower_rear_by_upper_rear_outer_y = lower_rear_by_upper_rear_outer_y
                * lower_rear_by_upper_front_outer_x;
            let lower_rear_by_lower_front_outer_x = lower_rear_by_lower_front_outer_x
                * lower_rear_by_upper_front_outer_x;
            let knuckle_upper_front_outer_upper_rear_outer_by_lower_front_outer_x = T::one()
                / knuckle_upper_front_outer_upper_rear_outer_by_lower_front_outer_x;
            let track_rod_by_lower_front_outer_x = track_rod_by_lower_front_outer_x
                * knuckle_upper_front_outer_upper_rear_outer_by_lower_front_outer_x;
            let track_rod_by_upper_rear_outer_y = track_rod_by_upper_rear_outer_y
                .minus_product(
                    track_rod_by_lower_front_outer_x,
                    knuckle_upper_front_outer_upper_rear_outer_by_upper_rear_outer_y,
                );
            let knuckle_upper_front_outer_upper_rear_outer_by_upper_rear_outer_y = knuckle_upper_front_outer_upper_rear_outer_by_upper_rear_outer_y
                * knuckle_upper_front_outer_upper_rear_outer_by_lower_front_outer_x;
            let track_rod_by_upper_rear_outer_y = T::one()
                / track_rod_by_upper_rear_outer_y;
            Factors {
                growth_squared: sum_of_squares([
                    lower_front_by_lower_front_outer_y,
                    upper_rear_by_upper_rear_outer_x,
                    knuckle_lower_front_outer_upper_rear_outer_by_upper_rear_outer_z,
                    knuckle_lower_front_outer_upper_front_outer_by_upper_front_outer_z,
                    upper_front_by_upper_front_outer_y,
                    lower_rear_by_upper_front_outer_x,
                    knuckle_upper_front_outer_upper_rear_outer_by_lower_front_outer_x,
                    track_rod_by_upper_rear_outer_y,
                ]),
                determinant_sign: -product([
                    lower_front_by_lower_front_outer_y,
                    upper_rear_by_upper_rear_outer_x,
                    knuckle_lower_front_outer_upper_rear_outer_by_upper_rear_outer_z,
                    knuckle_lower_front_outer_upper_front_outer_by_upper_front_outer_z,
                    upper_front_by_upper_front_outer_y,
                    lower_rear_by_upper_front_outer_x,
                    knuckle_upper_front_outer_upper_rear_outer_by_lower_front_outer_x,
                    track_rod_by_upper_rear_outer_y,
                ]),
                knuckle_frame,
                knuckle_lower_rear_outer: self.knuckle_lower_rear_outer,
                knuckle_track_rod_outer: self.knuckle_track_rod_outer,
                lower_rear_by_lower_rear_outer_x,
                lower_rear_by_lower_rear_outer_y,
                lower_rear_by_lower_rear_outer_z,
                track_rod_by_track_rod_outer_x,
                track_rod_by_track_rod_outer_y,
                track_rod_by_track_rod_outer_z,
                lower_front_by_lower_front_outer_z,
                lower_rear_by_lower_front_outer_z,
                track_rod_by_lower_front_outer_z,
                knuckle_lower_front_outer_upper_front_outer_by_lower_front_outer_z,
                knuckle_lower_front_outer_upper_rear_outer_by_lower_front_outer_z,
                lower_front_by_lower_front_outer_y,
                lower_front_by_lower_front_outer_x,
                lower_rear_by_lower_front_outer_y,
                track_rod_by_lower_front_outer_y,
                knuckle_lower_front_outer_upper_front_outer_by_lower_front_outer_y,
                knuckle_lower_front_outer_upper_rear_outer_by_lower_front_outer_y,
                upper_rear_by_upper_rear_outer_x,
                upper_rear_by_upper_rear_outer_y,
                upper_rear_by_upper_rear_outer_z,
                lower_rear_by_upper_rear_outer_x,
                track_rod_by_upper_rear_outer_x,
                knuckle_lower_front_outer_upper_rear_outer_by_upper_rear_outer_x,
                knuckle_upper_front_outer_upper_rear_outer_by_upper_rear_outer_x,
                knuckle_lower_front_outer_upper_rear_outer_by_upper_rear_outer_z,
                knuckle_lower_front_outer_upper_rear_outer_by_upper_rear_outer_y,
                knuckle_lower_front_outer_upper_rear_outer_by_lower_front_outer_x,
                lower_rear_by_upper_rear_outer_z,
                track_rod_by_upper_rear_outer_z,
                knuckle_upper_front_outer_upper_rear_outer_by_upper_rear_outer_z,
                knuckle_lower_front_outer_upper_front_outer_by_upper_front_outer_z,
                knuckle_lower_front_outer_upper_front_outer_by_lower_front_outer_x,
                knuckle_lower_front_outer_upper_front_outer_by_upper_front_outer_x,
                knuckle_lower_front_outer_upper_front_outer_by_upper_front_outer_y,
                upper_front_by_upper_front_outer_z,
                lower_rear_by_upper_front_outer_z,
                track_rod_by_upper_front_outer_z,
                knuckle_upper_front_outer_upper_rear_outer_by_upper_front_outer_z,
                upper_front_by_upper_front_outer_y,
                upper_front_by_lower_front_outer_x,
                upper_front_by_upper_front_outer_x,
                lower_rear_by_upper_front_outer_y,
                track_rod_by_upper_front_outer_y,
                knuckle_upper_front_outer_upper_rear_outer_by_upper_front_outer_y,
                lower_rear_by_upper_front_outer_x,
                lower_rear_by_upper_rear_outer_y,
                lower_rear_by_lower_front_outer_x,
                track_rod_by_upper_front_outer_x,
                knuckle_upper_front_outer_upper_rear_outer_by_upper_front_outer_x,
                knuckle_upper_front_outer_upper_rear_outer_by_lower_front_outer_x,
                knuckle_upper_front_outer_upper_rear_outer_by_upper_rear_outer_y,
                track_rod_by_lower_front_outer_x,
                track_rod_by_upper_rear_outer_y,
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
            let knuckle_lower_rear_outer = self
                .knuckle_lower_rear_outer
                .curvature(&knuckle_frame_v, &knuckle_frame_w);
            let knuckle_track_rod_outer = self
                .knuckle_track_rod_outer
                .curvature(&knuckle_frame_v, &knuckle_frame_w);
            let mut rows = [-T::zero(); 15];
            rows[equation::LOWER_FRONT] = self
                .lower_front
                .curvature(
                    difference(v.lower_front_outer, v_fixed.lower_front_inner),
                    difference(w.lower_front_outer, w_fixed.lower_front_inner),
                );
            rows[equation::UPPER_FRONT] = self
                .upper_front
                .curvature(
                    difference(v.upper_front_outer, v_fixed.upper_front_inner),
                    difference(w.upper_front_outer, w_fixed.upper_front_inner),
                );
            rows[equation::UPPER_REAR] = self
                .upper_rear
                .curvature(
                    difference(v.upper_rear_outer, v_fixed.upper_rear_inner),
                    difference(w.upper_rear_outer, w_fixed.upper_rear_inner),
                );
            rows[equation::LOWER_REAR] = self
                .lower_rear
                .curvature(
                    difference(v.lower_rear_outer, v_fixed.lower_rear_inner),
                    difference(w.lower_rear_outer, w_fixed.lower_rear_inner),
                );
            rows[equation::TRACK_ROD] = self
                .track_rod
                .curvature(
                    difference(v.track_rod_outer, v_fixed.track_rod_inner),
                    difference(w.track_rod_outer, w_fixed.track_rod_inner),
                );
            rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_FRONT_OUTER] = self
                .knuckle_lower_front_outer_upper_front_outer
                .curvature(
                    difference(v.upper_front_outer, v.lower_front_outer),
                    difference(w.upper_front_outer, w.lower_front_outer),
                );
            rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_REAR_OUTER] = self
                .knuckle_lower_front_outer_upper_rear_outer
                .curvature(
                    difference(v.upper_rear_outer, v.lower_front_outer),
                    difference(w.upper_rear_outer, w.lower_front_outer),
                );
            rows[equation::KNUCKLE_UPPER_FRONT_OUTER_UPPER_REAR_OUTER] = self
                .knuckle_upper_front_outer_upper_rear_outer
                .curvature(
                    difference(v.upper_rear_outer, v.upper_front_outer),
                    difference(w.upper_rear_outer, w.upper_front_outer),
                );
            rows[equation::KNUCKLE_LOWER_REAR_OUTER_X] = knuckle_lower_rear_outer.x;
            rows[equation::KNUCKLE_LOWER_REAR_OUTER_Y] = knuckle_lower_rear_outer.y;
            rows[equation::KNUCKLE_LOWER_REAR_OUTER_Z] = knuckle_lower_rear_outer.z;
            rows[equation::KNUCKLE_TRACK_ROD_OUTER_X] = knuckle_track_rod_outer.x;
            rows[equation::KNUCKLE_TRACK_ROD_OUTER_Y] = knuckle_track_rod_outer.y;
            rows[equation::KNUCKLE_TRACK_ROD_OUTER_Z] = knuckle_track_rod_outer.z;
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
            rows[equation::LOWER_FRONT] = dot(
                self
                    .lower_front
                    .gradient(
                        difference(free.lower_front_outer, fixed.lower_front_inner),
                    ),
                fixed_rate.lower_front_inner,
            );
            rows[equation::UPPER_FRONT] = dot(
                self
                    .upper_front
                    .gradient(
                        difference(free.upper_front_outer, fixed.upper_front_inner),
                    ),
                fixed_rate.upper_front_inner,
            );
            rows[equation::UPPER_REAR] = dot(
                self
                    .upper_rear
                    .gradient(difference(free.upper_rear_outer, fixed.upper_rear_inner)),
                fixed_rate.upper_rear_inner,
            );
            rows[equation::LOWER_REAR] = dot(
                self
                    .lower_rear
                    .gradient(difference(free.lower_rear_outer, fixed.lower_rear_inner)),
                fixed_rate.lower_rear_inner,
            );
            rows[equation::TRACK_ROD] = dot(
                self
                    .track_rod
                    .gradient(difference(free.track_rod_outer, fixed.track_rod_inner)),
                fixed_rate.track_rod_inner,
            );
            rows[equation::THETA] = fixed_rate.lower_front_inner.z;
            SVector::from(rows)
        }

        fn points(&self, q: &SVector<T, 15>, fixed: &Fixed<T>) -> Points<T> {
            let free = Free::of(q);
            Points::all(
                fixed,
                &free,
                [self.wheel_centre.position(&free.knuckle_frame())],
            )
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
                [self.wheel_centre.velocity(&at.knuckle_frame(), &free.knuckle_frame())],
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
                        .wheel_centre
                        .acceleration(
                            &at.knuckle_frame(),
                            &velocities.knuckle_frame(),
                            &free.knuckle_frame(),
                        ),
                ],
            )
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
            measures
                .set(
                    points.map(|points| points.wheel_centre.z),
                    |measures| &mut measures.height,
                );
            measures
        }

        #[inline(always)]
        fn mirrored(
            &self,
            _q: &SVector<T, 15>,
            _fixed: &Fixed<T>,
        ) -> impl Iterator<Item = T> {
            ::core::iter::empty()
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
        knuckle_frame: Frame<T>,
        knuckle_lower_rear_outer: Carried<T>,
        knuckle_track_rod_outer: Carried<T>,
        lower_rear_by_lower_rear_outer_x: T,
        lower_rear_by_lower_rear_outer_y: T,
        lower_rear_by_lower_rear_outer_z: T,
        track_rod_by_track_rod_outer_x: T,
        track_rod_by_track_rod_outer_y: T,
        track_rod_by_track_rod_outer_z: T,
        lower_front_by_lower_front_outer_z: T,
        lower_rear_by_lower_front_outer_z: T,
        track_rod_by_lower_front_outer_z: T,
        knuckle_lower_front_outer_upper_front_outer_by_lower_front_outer_z: T,
        knuckle_lower_front_outer_upper_rear_outer_by_lower_front_outer_z: T,
        lower_front_by_lower_front_outer_y: T,
        lower_front_by_lower_front_outer_x: T,
        lower_rear_by_lower_front_outer_y: T,
        track_rod_by_lower_front_outer_y: T,
        knuckle_lower_front_outer_upper_front_outer_by_lower_front_outer_y: T,
        knuckle_lower_front_outer_upper_rear_outer_by_lower_front_outer_y: T,
        upper_rear_by_upper_rear_outer_x: T,
        upper_rear_by_upper_rear_outer_y: T,
        upper_rear_by_upper_rear_outer_z: T,
        lower_rear_by_upper_rear_outer_x: T,
        track_rod_by_upper_rear_outer_x: T,
        knuckle_lower_front_outer_upper_rear_outer_by_upper_rear_outer_x: T,
        knuckle_upper_front_outer_upper_rear_outer_by_upper_rear_outer_x: T,
        knuckle_lower_front_outer_upper_rear_outer_by_upper_rear_outer_z: T,
        knuckle_lower_front_outer_upper_rear_outer_by_upper_rear_outer_y: T,
        knuckle_lower_front_outer_upper_rear_outer_by_lower_front_outer_x: T,
        lower_rear_by_upper_rear_outer_z: T,
        track_rod_by_upper_rear_outer_z: T,
        knuckle_upper_front_outer_upper_rear_outer_by_upper_rear_outer_z: T,
        knuckle_lower_front_outer_upper_front_outer_by_upper_front_outer_z: T,
        knuckle_lower_front_outer_upper_front_outer_by_lower_front_outer_x: T,
        knuckle_lower_front_outer_upper_front_outer_by_upper_front_outer_x: T,
        knuckle_lower_front_outer_upper_front_outer_by_upper_front_outer_y: T,
        upper_front_by_upper_front_outer_z: T,
        lower_rear_by_upper_front_outer_z: T,
        track_rod_by_upper_front_outer_z: T,
        knuckle_upper_front_outer_upper_rear_outer_by_upper_front_outer_z: T,
        upper_front_by_upper_front_outer_y: T,
        upper_front_by_lower_front_outer_x: T,
        upper_front_by_upper_front_outer_x: T,
        lower_rear_by_upper_front_outer_y: T,
        track_rod_by_upper_front_outer_y: T,
        knuckle_upper_front_outer_upper_rear_outer_by_upper_front_outer_y: T,
        lower_rear_by_upper_front_outer_x: T,
        lower_rear_by_upper_rear_outer_y: T,
        lower_rear_by_lower_front_outer_x: T,
        track_rod_by_upper_front_outer_x: T,
        knuckle_upper_front_outer_upper_rear_outer_by_upper_front_outer_x: T,
        knuckle_upper_front_outer_upper_rear_outer_by_lower_front_outer_x: T,
        knuckle_upper_front_outer_upper_rear_outer_by_upper_rear_outer_y: T,
        track_rod_by_lower_front_outer_x: T,
        track_rod_by_upper_rear_outer_y: T,
    }

    impl<T: Scalar> JacobianFactors<T, 15> for Factors<T> {
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn solve(&self, right: &SVector<T, 15>) -> SVector<T, 15> {
            let [mut rows] = right.data.0;
            let mut unknowns = [T::zero(); 15];
            rows[equation::LOWER_REAR] = rows[equation::LOWER_REAR]
                .minus_product(
                    self.lower_rear_by_lower_rear_outer_x,
                    rows[equation::KNUCKLE_LOWER_REAR_OUTER_X],
                );
            rows[equation::LOWER_REAR] = rows[equation::LOWER_REAR]
                .minus_product(
                    self.lower_rear_by_lower_rear_outer_y,
                    rows[equation::KNUCKLE_LOWER_REAR_OUTER_Y],
                );
            rows[equation::LOWER_REAR] = rows[equation::LOWER_REAR]
                .minus_product(
                    self.lower_rear_by_lower_rear_outer_z,
                    rows[equation::KNUCKLE_LOWER_REAR_OUTER_Z],
                );
            rows[equation::TRACK_ROD] = rows[equation::TRACK_ROD]
                .minus_product(
                    self.track_rod_by_track_rod_outer_x,
                    rows[equation::KNUCKLE_TRACK_ROD_OUTER_X],
                );
            rows[equation::TRACK_ROD] = rows[equation::TRACK_ROD]
                .minus_product(
                    self.track_rod_by_track_rod_outer_y,
                    rows[equation::KNUCKLE_TRACK_ROD_OUTER_Y],
                );
            rows[equation::TRACK_ROD] = rows[equation::TRACK_ROD]
                .minus_product(
                    self.track_rod_by_track_rod_outer_z,
                    rows[equation::KNUCKLE_TRACK_ROD_OUTER_Z],
                );
            rows[equation::LOWER_FRONT] = rows[equation::LOWER_FRONT]
                .minus_product(
                    self.lower_front_by_lower_front_outer_z,
                    rows[equation::THETA],
                );
            rows[equation::LOWER_REAR] = rows[equation::LOWER_REAR]
                .minus_product(
                    self.lower_rear_by_lower_front_outer_z,
                    rows[equation::THETA],
                );
            rows[equation::TRACK_ROD] = rows[equation::TRACK_ROD]
                .minus_product(
                    self.track_rod_by_lower_front_outer_z,
                    rows[equation::THETA],
                );
            rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_FRONT_OUTER] = rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_FRONT_OUTER]
                .minus_product(
                    self
                        .knuckle_lower_front_outer_upper_front_outer_by_lower_front_outer_z,
                    rows[equation::THETA],
                );
            rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_REAR_OUTER] = rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_REAR_OUTER]
                .minus_product(
                    self
                        .knuckle_lower_front_outer_upper_rear_outer_by_lower_front_outer_z,
                    rows[equation::THETA],
                );
            rows[equation::LOWER_REAR] = rows[equation::LOWER_REAR]
                .minus_product(
                    self.lower_rear_by_lower_front_outer_y,
                    rows[equation::LOWER_FRONT],
                );
            rows[equation::TRACK_ROD] = rows[equation::TRACK_ROD]
                .minus_product(
                    self.track_rod_by_lower_front_outer_y,
                    rows[equation::LOWER_FRONT],
                );
            rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_FRONT_OUTER] = rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_FRONT_OUTER]
                .minus_product(
                    self
                        .knuckle_lower_front_outer_upper_front_outer_by_lower_front_outer_y,
                    rows[equation::LOWER_FRONT],
                );
            rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_REAR_OUTER] = rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_REAR_OUTER]
                .minus_product(
                    self
                        .knuckle_lower_front_outer_upper_rear_outer_by_lower_front_outer_y,
                    rows[equation::LOWER_FRONT],
                );
            rows[equation::LOWER_REAR] = rows[equation::LOWER_REAR]
                .minus_product(
                    self.lower_rear_by_upper_rear_outer_x,
                    rows[equation::UPPER_REAR],
                );
            rows[equation::TRACK_ROD] = rows[equation::TRACK_ROD]
                .minus_product(
                    self.track_rod_by_upper_rear_outer_x,
                    rows[equation::UPPER_REAR],
                );
            rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_REAR_OUTER] = rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_REAR_OUTER]
                .minus_product(
                    self
                        .knuckle_lower_front_outer_upper_rear_outer_by_upper_rear_outer_x,
                    rows[equation::UPPER_REAR],
                );
            rows[equation::KNUCKLE_UPPER_FRONT_OUTER_UPPER_REAR_OUTER] = rows[equation::KNUCKLE_UPPER_FRONT_OUTER_UPPER_REAR_OUTER]
                .minus_product(
                    self
                        .knuckle_upper_front_outer_upper_rear_outer_by_upper_rear_outer_x,
                    rows[equation::UPPER_REAR],
                );
            rows[equation::LOWER_REAR] = rows[equation::LOWER_REAR]
                .minus_product(
                    self.lower_rear_by_upper_rear_outer_z,
                    rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_REAR_OUTER],
                );
            rows[equation::TRACK_ROD] = rows[equation::TRACK_ROD]
                .minus_product(
                    self.track_rod_by_upper_rear_outer_z,
                    rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_REAR_OUTER],
                );
            rows[equation::KNUCKLE_UPPER_FRONT_OUTER_UPPER_REAR_OUTER] = rows[equation::KNUCKLE_UPPER_FRONT_OUTER_UPPER_REAR_OUTER]
                .minus_product(
                    self
                        .knuckle_upper_front_outer_upper_rear_outer_by_upper_rear_outer_z,
                    rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_REAR_OUTER],
                );
            rows[equation::UPPER_FRONT] = rows[equation::UPPER_FRONT]
                .minus_product(
                    self.upper_front_by_upper_front_outer_z,
                    rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_FRONT_OUTER],
                );
            rows[equation::LOWER_REAR] = rows[equation::LOWER_REAR]
                .minus_product(
                    self.lower_rear_by_upper_front_outer_z,
                    rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_FRONT_OUTER],
                );
            rows[equation::TRACK_ROD] = rows[equation::TRACK_ROD]
                .minus_product(
                    self.track_rod_by_upper_front_outer_z,
                    rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_FRONT_OUTER],
                );
            rows[equation::KNUCKLE_UPPER_FRONT_OUTER_UPPER_REAR_OUTER] = rows[equation::KNUCKLE_UPPER_FRONT_OUTER_UPPER_REAR_OUTER]
                .minus_product(
                    self
                        .knuckle_upper_front_outer_upper_rear_outer_by_upper_front_outer_z,
                    rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_FRONT_OUTER],
                );
            rows[equation::LOWER_REAR] = rows[equation::LOWER_REAR]
                .minus_product(
                    self.lower_rear_by_upper_front_outer_y,
                    rows[equation::UPPER_FRONT],
                );
            rows[equation::TRACK_ROD] = rows[equation::TRACK_ROD]
                .minus_product(
                    self.track_rod_by_upper_front_outer_y,
                    rows[equation::UPPER_FRONT],
                );
            rows[equation::KNUCKLE_UPPER_FRONT_OUTER_UPPER_REAR_OUTER] = rows[equation::KNUCKLE_UPPER_FRONT_OUTER_UPPER_REAR_OUTER]
                .minus_product(
                    self
                        .knuckle_upper_front_outer_upper_rear_outer_by_upper_front_outer_y,
                    rows[equation::UPPER_FRONT],
                );
            rows[equation::TRACK_ROD] = rows[equation::TRACK_ROD]
                .minus_product(
                    self.track_rod_by_upper_front_outer_x,
                    rows[equation::LOWER_REAR],
                );
            rows[equation::KNUCKLE_UPPER_FRONT_OUTER_UPPER_REAR_OUTER] = rows[equation::KNUCKLE_UPPER_FRONT_OUTER_UPPER_REAR_OUTER]
                .minus_product(
                    self
                        .knuckle_upper_front_outer_upper_rear_outer_by_upper_front_outer_x,
                    rows[equation::LOWER_REAR],
                );
            rows[equation::TRACK_ROD] = rows[equation::TRACK_ROD]
                .minus_product(
                    self.track_rod_by_lower_front_outer_x,
                    rows[equation::KNUCKLE_UPPER_FRONT_OUTER_UPPER_REAR_OUTER],
                );
            unknowns[unknown::UPPER_REAR_OUTER_Y] = rows[equation::TRACK_ROD]
                * self.track_rod_by_upper_rear_outer_y;
            unknowns[unknown::LOWER_FRONT_OUTER_X] = (rows[equation::KNUCKLE_UPPER_FRONT_OUTER_UPPER_REAR_OUTER]
                * self.knuckle_upper_front_outer_upper_rear_outer_by_lower_front_outer_x)
                .minus_product(
                    self
                        .knuckle_upper_front_outer_upper_rear_outer_by_upper_rear_outer_y,
                    unknowns[unknown::UPPER_REAR_OUTER_Y],
                );
            unknowns[unknown::UPPER_FRONT_OUTER_X] = (rows[equation::LOWER_REAR]
                * self.lower_rear_by_upper_front_outer_x)
                .minus_product(
                    self.lower_rear_by_upper_rear_outer_y,
                    unknowns[unknown::UPPER_REAR_OUTER_Y],
                )
                .minus_product(
                    self.lower_rear_by_lower_front_outer_x,
                    unknowns[unknown::LOWER_FRONT_OUTER_X],
                );
            unknowns[unknown::UPPER_FRONT_OUTER_Y] = (rows[equation::UPPER_FRONT]
                * self.upper_front_by_upper_front_outer_y)
                .minus_product(
                    self.upper_front_by_lower_front_outer_x,
                    unknowns[unknown::LOWER_FRONT_OUTER_X],
                )
                .minus_product(
                    self.upper_front_by_upper_front_outer_x,
                    unknowns[unknown::UPPER_FRONT_OUTER_X],
                );
            unknowns[unknown::UPPER_FRONT_OUTER_Z] = (rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_FRONT_OUTER]
                * self
                    .knuckle_lower_front_outer_upper_front_outer_by_upper_front_outer_z)
                .minus_product(
                    self
                        .knuckle_lower_front_outer_upper_front_outer_by_lower_front_outer_x,
                    unknowns[unknown::LOWER_FRONT_OUTER_X],
                )
                .minus_product(
                    self
                        .knuckle_lower_front_outer_upper_front_outer_by_upper_front_outer_x,
                    unknowns[unknown::UPPER_FRONT_OUTER_X],
                )
                .minus_product(
                    self
                        .knuckle_lower_front_outer_upper_front_outer_by_upper_front_outer_y,
                    unknowns[unknown::UPPER_FRONT_OUTER_Y],
                );
            unknowns[unknown::UPPER_REAR_OUTER_Z] = (rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_REAR_OUTER]
                * self.knuckle_lower_front_outer_upper_rear_outer_by_upper_rear_outer_z)
                .minus_product(
                    self
                        .knuckle_lower_front_outer_upper_rear_outer_by_upper_rear_outer_y,
                    unknowns[unknown::UPPER_REAR_OUTER_Y],
                )
                .minus_product(
                    self
                        .knuckle_lower_front_outer_upper_rear_outer_by_lower_front_outer_x,
                    unknowns[unknown::LOWER_FRONT_OUTER_X],
                );
            unknowns[unknown::UPPER_REAR_OUTER_X] = (rows[equation::UPPER_REAR]
                * self.upper_rear_by_upper_rear_outer_x)
                .minus_product(
                    self.upper_rear_by_upper_rear_outer_y,
                    unknowns[unknown::UPPER_REAR_OUTER_Y],
                )
                .minus_product(
                    self.upper_rear_by_upper_rear_outer_z,
                    unknowns[unknown::UPPER_REAR_OUTER_Z],
                );
            unknowns[unknown::LOWER_FRONT_OUTER_Y] = (rows[equation::LOWER_FRONT]
                * self.lower_front_by_lower_front_outer_y)
                .minus_product(
                    self.lower_front_by_lower_front_outer_x,
                    unknowns[unknown::LOWER_FRONT_OUTER_X],
                );
            unknowns[unknown::LOWER_FRONT_OUTER_Z] = rows[equation::THETA];
            let knuckle_frame = Frame::new(
                Vector3::new(
                    unknowns[unknown::LOWER_FRONT_OUTER_X],
                    unknowns[unknown::LOWER_FRONT_OUTER_Y],
                    unknowns[unknown::LOWER_FRONT_OUTER_Z],
                ),
                Vector3::new(
                    unknowns[unknown::UPPER_FRONT_OUTER_X],
                    unknowns[unknown::UPPER_FRONT_OUTER_Y],
                    unknowns[unknown::UPPER_FRONT_OUTER_Z],
                ),
                Vector3::new(
                    unknowns[unknown::UPPER_REAR_OUTER_X],
                    unknowns[unknown::UPPER_REAR_OUTER_Y],
                    unknowns[unknown::UPPER_REAR_OUTER_Z],
                ),
            );
            let carried = self
                .knuckle_lower_rear_outer
                .velocity(&self.knuckle_frame, &knuckle_frame);
            unknowns[unknown::LOWER_REAR_OUTER_X] = rows[equation::KNUCKLE_LOWER_REAR_OUTER_X]
                + carried.x;
            unknowns[unknown::LOWER_REAR_OUTER_Y] = rows[equation::KNUCKLE_LOWER_REAR_OUTER_Y]
                + carried.y;
            unknowns[unknown::LOWER_REAR_OUTER_Z] = rows[equation::KNUCKLE_LOWER_REAR_OUTER_Z]
                + carried.z;
            let carried = self
                .knuckle_track_rod_outer
                .velocity(&self.knuckle_frame, &knuckle_frame);
            unknowns[unknown::TRACK_ROD_OUTER_X] = rows[equation::KNUCKLE_TRACK_ROD_OUTER_X]
                + carried.x;
            unknowns[unknown::TRACK_ROD_OUTER_Y] = rows[equation::KNUCKLE_TRACK_ROD_OUTER_Y]
                + carried.y;
            unknowns[unknown::TRACK_ROD_OUTER_Z] = rows[equation::KNUCKLE_TRACK_ROD_OUTER_Z]
                + carried.z;
            SVector::from(unknowns)
        }

        #[cfg_attr(not(debug_assertions), inline(always))]
        fn solve_drives(&self, right: &SVector<T, 15>) -> SVector<T, 15> {
            let [mut rows] = right.data.0;
            let mut unknowns = [T::zero(); 15];
            rows[equation::LOWER_FRONT] = -(self.lower_front_by_lower_front_outer_z
                * rows[equation::THETA]);
            rows[equation::LOWER_REAR] = -(self.lower_rear_by_lower_front_outer_z
                * rows[equation::THETA]);
            rows[equation::TRACK_ROD] = -(self.track_rod_by_lower_front_outer_z
                * rows[equation::THETA]);
            rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_FRONT_OUTER] = -(self
                .knuckle_lower_front_outer_upper_front_outer_by_lower_front_outer_z
                * rows[equation::THETA]);
            rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_REAR_OUTER] = -(self
                .knuckle_lower_front_outer_upper_rear_outer_by_lower_front_outer_z
                * rows[equation::THETA]);
            rows[equation::LOWER_REAR] = rows[equation::LOWER_REAR]
                .minus_product(
                    self.lower_rear_by_lower_front_outer_y,
                    rows[equation::LOWER_FRONT],
                );
            rows[equation::TRACK_ROD] = rows[equation::TRACK_ROD]
                .minus_product(
                    self.track_rod_by_lower_front_outer_y,
                    rows[equation::LOWER_FRONT],
                );
            rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_FRONT_OUTER] = rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_FRONT_OUTER]
                .minus_product(
                    self
                        .knuckle_lower_front_outer_upper_front_outer_by_lower_front_outer_y,
                    rows[equation::LOWER_FRONT],
                );
            rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_REAR_OUTER] = rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_REAR_OUTER]
                .minus_product(
                    self
                        .knuckle_lower_front_outer_upper_rear_outer_by_lower_front_outer_y,
                    rows[equation::LOWER_FRONT],
                );
            rows[equation::LOWER_REAR] = rows[equation::LOWER_REAR]
                .minus_product(
                    self.lower_rear_by_upper_rear_outer_z,
                    rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_REAR_OUTER],
                );
            rows[equation::TRACK_ROD] = rows[equation::TRACK_ROD]
                .minus_product(
                    self.track_rod_by_upper_rear_outer_z,
                    rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_REAR_OUTER],
                );
            rows[equation::KNUCKLE_UPPER_FRONT_OUTER_UPPER_REAR_OUTER] = -(self
                .knuckle_upper_front_outer_upper_rear_outer_by_upper_rear_outer_z
                * rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_REAR_OUTER]);
            rows[equation::UPPER_FRONT] = -(self.upper_front_by_upper_front_outer_z
                * rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_FRONT_OUTER]);
            rows[equation::LOWER_REAR] = rows[equation::LOWER_REAR]
                .minus_product(
                    self.lower_rear_by_upper_front_outer_z,
                    rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_FRONT_OUTER],
                );
            rows[equation::TRACK_ROD] = rows[equation::TRACK_ROD]
                .minus_product(
                    self.track_rod_by_upper_front_outer_z,
                    rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_FRONT_OUTER],
                );
            rows[equation::KNUCKLE_UPPER_FRONT_OUTER_UPPER_REAR_OUTER] = rows[equation::KNUCKLE_UPPER_FRONT_OUTER_UPPER_REAR_OUTER]
                .minus_product(
                    self
                        .knuckle_upper_front_outer_upper_rear_outer_by_upper_front_outer_z,
                    rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_FRONT_OUTER],
                );
            rows[equation::LOWER_REAR] = rows[equation::LOWER_REAR]
                .minus_product(
                    self.lower_rear_by_upper_front_outer_y,
                    rows[equation::UPPER_FRONT],
                );
            rows[equation::TRACK_ROD] = rows[equation::TRACK_ROD]
                .minus_product(
                    self.track_rod_by_upper_front_outer_y,
                    rows[equation::UPPER_FRONT],
                );
            rows[equation::KNUCKLE_UPPER_FRONT_OUTER_UPPER_REAR_OUTER] = rows[equation::KNUCKLE_UPPER_FRONT_OUTER_UPPER_REAR_OUTER]
                .minus_product(
                    self
                        .knuckle_upper_front_outer_upper_rear_outer_by_upper_front_outer_y,
                    rows[equation::UPPER_FRONT],
                );
            rows[equation::TRACK_ROD] = rows[equation::TRACK_ROD]
                .minus_product(
                    self.track_rod_by_upper_front_outer_x,
                    rows[equation::LOWER_REAR],
                );
            rows[equation::KNUCKLE_UPPER_FRONT_OUTER_UPPER_REAR_OUTER] = rows[equation::KNUCKLE_UPPER_FRONT_OUTER_UPPER_REAR_OUTER]
                .minus_product(
                    self
                        .knuckle_upper_front_outer_upper_rear_outer_by_upper_front_outer_x,
                    rows[equation::LOWER_REAR],
                );
            rows[equation::TRACK_ROD] = rows[equation::TRACK_ROD]
                .minus_product(
                    self.track_rod_by_lower_front_outer_x,
                    rows[equation::KNUCKLE_UPPER_FRONT_OUTER_UPPER_REAR_OUTER],
                );
            unknowns[unknown::UPPER_REAR_OUTER_Y] = rows[equation::TRACK_ROD]
                * self.track_rod_by_upper_rear_outer_y;
            unknowns[unknown::LOWER_FRONT_OUTER_X] = (rows[equation::KNUCKLE_UPPER_FRONT_OUTER_UPPER_REAR_OUTER]
                * self.knuckle_upper_front_outer_upper_rear_outer_by_lower_front_outer_x)
                .minus_product(
                    self
                        .knuckle_upper_front_outer_upper_rear_outer_by_upper_rear_outer_y,
                    unknowns[unknown::UPPER_REAR_OUTER_Y],
                );
            unknowns[unknown::UPPER_FRONT_OUTER_X] = (rows[equation::LOWER_REAR]
                * self.lower_rear_by_upper_front_outer_x)
                .minus_product(
                    self.lower_rear_by_upper_rear_outer_y,
                    unknowns[unknown::UPPER_REAR_OUTER_Y],
                )
                .minus_product(
                    self.lower_rear_by_lower_front_outer_x,
                    unknowns[unknown::LOWER_FRONT_OUTER_X],
                );
            unknowns[unknown::UPPER_FRONT_OUTER_Y] = (rows[equation::UPPER_FRONT]
                * self.upper_front_by_upper_front_outer_y)
                .minus_product(
                    self.upper_front_by_lower_front_outer_x,
                    unknowns[unknown::LOWER_FRONT_OUTER_X],
                )
                .minus_product(
                    self.upper_front_by_upper_front_outer_x,
                    unknowns[unknown::UPPER_FRONT_OUTER_X],
                );
            unknowns[unknown::UPPER_FRONT_OUTER_Z] = (rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_FRONT_OUTER]
                * self
                    .knuckle_lower_front_outer_upper_front_outer_by_upper_front_outer_z)
                .minus_product(
                    self
                        .knuckle_lower_front_outer_upper_front_outer_by_lower_front_outer_x,
                    unknowns[unknown::LOWER_FRONT_OUTER_X],
                )
                .minus_product(
                    self
                        .knuckle_lower_front_outer_upper_front_outer_by_upper_front_outer_x,
                    unknowns[unknown::UPPER_FRONT_OUTER_X],
                )
                .minus_product(
                    self
                        .knuckle_lower_front_outer_upper_front_outer_by_upper_front_outer_y,
                    unknowns[unknown::UPPER_FRONT_OUTER_Y],
                );
            unknowns[unknown::UPPER_REAR_OUTER_Z] = (rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_REAR_OUTER]
                * self.knuckle_lower_front_outer_upper_rear_outer_by_upper_rear_outer_z)
                .minus_product(
                    self
                        .knuckle_lower_front_outer_upper_rear_outer_by_upper_rear_outer_y,
                    unknowns[unknown::UPPER_REAR_OUTER_Y],
                )
                .minus_product(
                    self
                        .knuckle_lower_front_outer_upper_rear_outer_by_lower_front_outer_x,
                    unknowns[unknown::LOWER_FRONT_OUTER_X],
                );
            unknowns[unknown::UPPER_REAR_OUTER_X] = (-(self
                .upper_rear_by_upper_rear_outer_y
                * unknowns[unknown::UPPER_REAR_OUTER_Y]))
                .minus_product(
                    self.upper_rear_by_upper_rear_outer_z,
                    unknowns[unknown::UPPER_REAR_OUTER_Z],
                );
            unknowns[unknown::LOWER_FRONT_OUTER_Y] = (rows[equation::LOWER_FRONT]
                * self.lower_front_by_lower_front_outer_y)
                .minus_product(
                    self.lower_front_by_lower_front_outer_x,
                    unknowns[unknown::LOWER_FRONT_OUTER_X],
                );
            unknowns[unknown::LOWER_FRONT_OUTER_Z] = rows[equation::THETA];
            let knuckle_frame = Frame::new(
                Vector3::new(
                    unknowns[unknown::LOWER_FRONT_OUTER_X],
                    unknowns[unknown::LOWER_FRONT_OUTER_Y],
                    unknowns[unknown::LOWER_FRONT_OUTER_Z],
                ),
                Vector3::new(
                    unknowns[unknown::UPPER_FRONT_OUTER_X],
                    unknowns[unknown::UPPER_FRONT_OUTER_Y],
                    unknowns[unknown::UPPER_FRONT_OUTER_Z],
                ),
                Vector3::new(
                    unknowns[unknown::UPPER_REAR_OUTER_X],
                    unknowns[unknown::UPPER_REAR_OUTER_Y],
                    unknowns[unknown::UPPER_REAR_OUTER_Z],
                ),
            );
            let carried = self
                .knuckle_lower_rear_outer
                .velocity(&self.knuckle_frame, &knuckle_frame);
            unknowns[unknown::LOWER_REAR_OUTER_X] = carried.x;
            unknowns[unknown::LOWER_REAR_OUTER_Y] = carried.y;
            unknowns[unknown::LOWER_REAR_OUTER_Z] = carried.z;
            let carried = self
                .knuckle_track_rod_outer
                .velocity(&self.knuckle_frame, &knuckle_frame);
            unknowns[unknown::TRACK_ROD_OUTER_X] = carried.x;
            unknowns[unknown::TRACK_ROD_OUTER_Y] = carried.y;
            unknowns[unknown::TRACK_ROD_OUTER_Z] = carried.z;
            SVector::from(unknowns)
        }

        #[cfg_attr(not(debug_assertions), inline(always))]
        fn solve_transposed(&self, right: &SVector<T, 15>) -> SVector<T, 15> {
            let [mut unknowns] = right.data.0;
            let mut rows = [T::zero(); 15];
            let [origin, second, third] = self
                .knuckle_lower_rear_outer
                .by_frame(
                    Vector3::new(
                        unknowns[unknown::LOWER_REAR_OUTER_X],
                        unknowns[unknown::LOWER_REAR_OUTER_Y],
                        unknowns[unknown::LOWER_REAR_OUTER_Z],
                    ),
                    &self.knuckle_frame,
                );
            unknowns[unknown::LOWER_FRONT_OUTER_X] += origin.x;
            unknowns[unknown::LOWER_FRONT_OUTER_Y] += origin.y;
            unknowns[unknown::LOWER_FRONT_OUTER_Z] += origin.z;
            unknowns[unknown::UPPER_FRONT_OUTER_X] += second.x;
            unknowns[unknown::UPPER_FRONT_OUTER_Y] += second.y;
            unknowns[unknown::UPPER_FRONT_OUTER_Z] += second.z;
            unknowns[unknown::UPPER_REAR_OUTER_X] += third.x;
            unknowns[unknown::UPPER_REAR_OUTER_Y] += third.y;
            unknowns[unknown::UPPER_REAR_OUTER_Z] += third.z;
            let [origin, second, third] = self
                .knuckle_track_rod_outer
                .by_frame(
                    Vector3::new(
                        unknowns[unknown::TRACK_ROD_OUTER_X],
                        unknowns[unknown::TRACK_ROD_OUTER_Y],
                        unknowns[unknown::TRACK_ROD_OUTER_Z],
                    ),
                    &self.knuckle_frame,
                );
            unknowns[unknown::LOWER_FRONT_OUTER_X] += origin.x;
            unknowns[unknown::LOWER_FRONT_OUTER_Y] += origin.y;
            unknowns[unknown::LOWER_FRONT_OUTER_Z] += origin.z;
            unknowns[unknown::UPPER_FRONT_OUTER_X] += second.x;
            unknowns[unknown::UPPER_FRONT_OUTER_Y] += second.y;
            unknowns[unknown::UPPER_FRONT_OUTER_Z] += second.z;
            unknowns[unknown::UPPER_REAR_OUTER_X] += third.x;
            unknowns[unknown::UPPER_REAR_OUTER_Y] += third.y;
            unknowns[unknown::UPPER_REAR_OUTER_Z] += third.z;
            unknowns[unknown::LOWER_FRONT_OUTER_X] = unknowns[unknown::LOWER_FRONT_OUTER_X]
                .minus_product(
                    self.lower_front_by_lower_front_outer_x,
                    unknowns[unknown::LOWER_FRONT_OUTER_Y],
                );
            unknowns[unknown::UPPER_REAR_OUTER_Y] = unknowns[unknown::UPPER_REAR_OUTER_Y]
                .minus_product(
                    self.upper_rear_by_upper_rear_outer_y,
                    unknowns[unknown::UPPER_REAR_OUTER_X],
                );
            unknowns[unknown::UPPER_REAR_OUTER_Z] = unknowns[unknown::UPPER_REAR_OUTER_Z]
                .minus_product(
                    self.upper_rear_by_upper_rear_outer_z,
                    unknowns[unknown::UPPER_REAR_OUTER_X],
                );
            unknowns[unknown::UPPER_REAR_OUTER_Y] = unknowns[unknown::UPPER_REAR_OUTER_Y]
                .minus_product(
                    self
                        .knuckle_lower_front_outer_upper_rear_outer_by_upper_rear_outer_y,
                    unknowns[unknown::UPPER_REAR_OUTER_Z],
                );
            unknowns[unknown::LOWER_FRONT_OUTER_X] = unknowns[unknown::LOWER_FRONT_OUTER_X]
                .minus_product(
                    self
                        .knuckle_lower_front_outer_upper_rear_outer_by_lower_front_outer_x,
                    unknowns[unknown::UPPER_REAR_OUTER_Z],
                );
            unknowns[unknown::LOWER_FRONT_OUTER_X] = unknowns[unknown::LOWER_FRONT_OUTER_X]
                .minus_product(
                    self
                        .knuckle_lower_front_outer_upper_front_outer_by_lower_front_outer_x,
                    unknowns[unknown::UPPER_FRONT_OUTER_Z],
                );
            unknowns[unknown::UPPER_FRONT_OUTER_X] = unknowns[unknown::UPPER_FRONT_OUTER_X]
                .minus_product(
                    self
                        .knuckle_lower_front_outer_upper_front_outer_by_upper_front_outer_x,
                    unknowns[unknown::UPPER_FRONT_OUTER_Z],
                );
            unknowns[unknown::UPPER_FRONT_OUTER_Y] = unknowns[unknown::UPPER_FRONT_OUTER_Y]
                .minus_product(
                    self
                        .knuckle_lower_front_outer_upper_front_outer_by_upper_front_outer_y,
                    unknowns[unknown::UPPER_FRONT_OUTER_Z],
                );
            unknowns[unknown::LOWER_FRONT_OUTER_X] = unknowns[unknown::LOWER_FRONT_OUTER_X]
                .minus_product(
                    self.upper_front_by_lower_front_outer_x,
                    unknowns[unknown::UPPER_FRONT_OUTER_Y],
                );
            unknowns[unknown::UPPER_FRONT_OUTER_X] = unknowns[unknown::UPPER_FRONT_OUTER_X]
                .minus_product(
                    self.upper_front_by_upper_front_outer_x,
                    unknowns[unknown::UPPER_FRONT_OUTER_Y],
                );
            unknowns[unknown::UPPER_REAR_OUTER_Y] = unknowns[unknown::UPPER_REAR_OUTER_Y]
                .minus_product(
                    self.lower_rear_by_upper_rear_outer_y,
                    unknowns[unknown::UPPER_FRONT_OUTER_X],
                );
            unknowns[unknown::LOWER_FRONT_OUTER_X] = unknowns[unknown::LOWER_FRONT_OUTER_X]
                .minus_product(
                    self.lower_rear_by_lower_front_outer_x,
                    unknowns[unknown::UPPER_FRONT_OUTER_X],
                );
            unknowns[unknown::UPPER_REAR_OUTER_Y] = unknowns[unknown::UPPER_REAR_OUTER_Y]
                .minus_product(
                    self
                        .knuckle_upper_front_outer_upper_rear_outer_by_upper_rear_outer_y,
                    unknowns[unknown::LOWER_FRONT_OUTER_X],
                );
            rows[equation::KNUCKLE_LOWER_REAR_OUTER_X] = unknowns[unknown::LOWER_REAR_OUTER_X];
            rows[equation::KNUCKLE_LOWER_REAR_OUTER_Y] = unknowns[unknown::LOWER_REAR_OUTER_Y];
            rows[equation::KNUCKLE_LOWER_REAR_OUTER_Z] = unknowns[unknown::LOWER_REAR_OUTER_Z];
            rows[equation::KNUCKLE_TRACK_ROD_OUTER_X] = unknowns[unknown::TRACK_ROD_OUTER_X];
            rows[equation::KNUCKLE_TRACK_ROD_OUTER_Y] = unknowns[unknown::TRACK_ROD_OUTER_Y];
            rows[equation::KNUCKLE_TRACK_ROD_OUTER_Z] = unknowns[unknown::TRACK_ROD_OUTER_Z];
            rows[equation::THETA] = unknowns[unknown::LOWER_FRONT_OUTER_Z];
            rows[equation::LOWER_FRONT] = unknowns[unknown::LOWER_FRONT_OUTER_Y]
                * self.lower_front_by_lower_front_outer_y;
            rows[equation::UPPER_REAR] = unknowns[unknown::UPPER_REAR_OUTER_X]
                * self.upper_rear_by_upper_rear_outer_x;
            rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_REAR_OUTER] = unknowns[unknown::UPPER_REAR_OUTER_Z]
                * self.knuckle_lower_front_outer_upper_rear_outer_by_upper_rear_outer_z;
            rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_FRONT_OUTER] = unknowns[unknown::UPPER_FRONT_OUTER_Z]
                * self
                    .knuckle_lower_front_outer_upper_front_outer_by_upper_front_outer_z;
            rows[equation::UPPER_FRONT] = unknowns[unknown::UPPER_FRONT_OUTER_Y]
                * self.upper_front_by_upper_front_outer_y;
            rows[equation::LOWER_REAR] = unknowns[unknown::UPPER_FRONT_OUTER_X]
                * self.lower_rear_by_upper_front_outer_x;
            rows[equation::KNUCKLE_UPPER_FRONT_OUTER_UPPER_REAR_OUTER] = unknowns[unknown::LOWER_FRONT_OUTER_X]
                * self.knuckle_upper_front_outer_upper_rear_outer_by_lower_front_outer_x;
            rows[equation::TRACK_ROD] = unknowns[unknown::UPPER_REAR_OUTER_Y]
                * self.track_rod_by_upper_rear_outer_y;
            rows[equation::KNUCKLE_UPPER_FRONT_OUTER_UPPER_REAR_OUTER] = rows[equation::KNUCKLE_UPPER_FRONT_OUTER_UPPER_REAR_OUTER]
                .minus_product(
                    self.track_rod_by_lower_front_outer_x,
                    rows[equation::TRACK_ROD],
                );
            rows[equation::LOWER_REAR] = rows[equation::LOWER_REAR]
                .minus_product(
                    self.track_rod_by_upper_front_outer_x,
                    rows[equation::TRACK_ROD],
                );
            rows[equation::LOWER_REAR] = rows[equation::LOWER_REAR]
                .minus_product(
                    self
                        .knuckle_upper_front_outer_upper_rear_outer_by_upper_front_outer_x,
                    rows[equation::KNUCKLE_UPPER_FRONT_OUTER_UPPER_REAR_OUTER],
                );
            rows[equation::UPPER_FRONT] = rows[equation::UPPER_FRONT]
                .minus_product(
                    self.lower_rear_by_upper_front_outer_y,
                    rows[equation::LOWER_REAR],
                );
            rows[equation::UPPER_FRONT] = rows[equation::UPPER_FRONT]
                .minus_product(
                    self.track_rod_by_upper_front_outer_y,
                    rows[equation::TRACK_ROD],
                );
            rows[equation::UPPER_FRONT] = rows[equation::UPPER_FRONT]
                .minus_product(
                    self
                        .knuckle_upper_front_outer_upper_rear_outer_by_upper_front_outer_y,
                    rows[equation::KNUCKLE_UPPER_FRONT_OUTER_UPPER_REAR_OUTER],
                );
            rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_FRONT_OUTER] = rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_FRONT_OUTER]
                .minus_product(
                    self.upper_front_by_upper_front_outer_z,
                    rows[equation::UPPER_FRONT],
                );
            rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_FRONT_OUTER] = rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_FRONT_OUTER]
                .minus_product(
                    self.lower_rear_by_upper_front_outer_z,
                    rows[equation::LOWER_REAR],
                );
            rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_FRONT_OUTER] = rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_FRONT_OUTER]
                .minus_product(
                    self.track_rod_by_upper_front_outer_z,
                    rows[equation::TRACK_ROD],
                );
            rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_FRONT_OUTER] = rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_FRONT_OUTER]
                .minus_product(
                    self
                        .knuckle_upper_front_outer_upper_rear_outer_by_upper_front_outer_z,
                    rows[equation::KNUCKLE_UPPER_FRONT_OUTER_UPPER_REAR_OUTER],
                );
            rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_REAR_OUTER] = rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_REAR_OUTER]
                .minus_product(
                    self.lower_rear_by_upper_rear_outer_z,
                    rows[equation::LOWER_REAR],
                );
            rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_REAR_OUTER] = rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_REAR_OUTER]
                .minus_product(
                    self.track_rod_by_upper_rear_outer_z,
                    rows[equation::TRACK_ROD],
                );
            rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_REAR_OUTER] = rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_REAR_OUTER]
                .minus_product(
                    self
                        .knuckle_upper_front_outer_upper_rear_outer_by_upper_rear_outer_z,
                    rows[equation::KNUCKLE_UPPER_FRONT_OUTER_UPPER_REAR_OUTER],
                );
            rows[equation::UPPER_REAR] = rows[equation::UPPER_REAR]
                .minus_product(
                    self.lower_rear_by_upper_rear_outer_x,
                    rows[equation::LOWER_REAR],
                );
            rows[equation::UPPER_REAR] = rows[equation::UPPER_REAR]
                .minus_product(
                    self.track_rod_by_upper_rear_outer_x,
                    rows[equation::TRACK_ROD],
                );
            rows[equation::UPPER_REAR] = rows[equation::UPPER_REAR]
                .minus_product(
                    self
                        .knuckle_lower_front_outer_upper_rear_outer_by_upper_rear_outer_x,
                    rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_REAR_OUTER],
                );
            rows[equation::UPPER_REAR] = rows[equation::UPPER_REAR]
                .minus_product(
                    self
                        .knuckle_upper_front_outer_upper_rear_outer_by_upper_rear_outer_x,
                    rows[equation::KNUCKLE_UPPER_FRONT_OUTER_UPPER_REAR_OUTER],
                );
            rows[equation::LOWER_FRONT] = rows[equation::LOWER_FRONT]
                .minus_product(
                    self.lower_rear_by_lower_front_outer_y,
                    rows[equation::LOWER_REAR],
                );
            rows[equation::LOWER_FRONT] = rows[equation::LOWER_FRONT]
                .minus_product(
                    self.track_rod_by_lower_front_outer_y,
                    rows[equation::TRACK_ROD],
                );
            rows[equation::LOWER_FRONT] = rows[equation::LOWER_FRONT]
                .minus_product(
                    self
                        .knuckle_lower_front_outer_upper_front_outer_by_lower_front_outer_y,
                    rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_FRONT_OUTER],
                );
            rows[equation::LOWER_FRONT] = rows[equation::LOWER_FRONT]
                .minus_product(
                    self
                        .knuckle_lower_front_outer_upper_rear_outer_by_lower_front_outer_y,
                    rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_REAR_OUTER],
                );
            rows[equation::THETA] = rows[equation::THETA]
                .minus_product(
                    self.lower_front_by_lower_front_outer_z,
                    rows[equation::LOWER_FRONT],
                );
            rows[equation::THETA] = rows[equation::THETA]
                .minus_product(
                    self.lower_rear_by_lower_front_outer_z,
                    rows[equation::LOWER_REAR],
                );
            rows[equation::THETA] = rows[equation::THETA]
                .minus_product(
                    self.track_rod_by_lower_front_outer_z,
                    rows[equation::TRACK_ROD],
                );
            rows[equation::THETA] = rows[equation::THETA]
                .minus_product(
                    self
                        .knuckle_lower_front_outer_upper_front_outer_by_lower_front_outer_z,
                    rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_FRONT_OUTER],
                );
            rows[equation::THETA] = rows[equation::THETA]
                .minus_product(
                    self
                        .knuckle_lower_front_outer_upper_rear_outer_by_lower_front_outer_z,
                    rows[equation::KNUCKLE_LOWER_FRONT_OUTER_UPPER_REAR_OUTER],
                );
            rows[equation::KNUCKLE_TRACK_ROD_OUTER_Z] = rows[equation::KNUCKLE_TRACK_ROD_OUTER_Z]
                .minus_product(
                    self.track_rod_by_track_rod_outer_z,
                    rows[equation::TRACK_ROD],
                );
            rows[equation::KNUCKLE_TRACK_ROD_OUTER_Y] = rows[equation::KNUCKLE_TRACK_ROD_OUTER_Y]
                .minus_product(
                    self.track_rod_by_track_rod_outer_y,
                    rows[equation::TRACK_ROD],
                );
            rows[equation::KNUCKLE_TRACK_ROD_OUTER_X] = rows[equation::KNUCKLE_TRACK_ROD_OUTER_X]
                .minus_product(
                    self.track_rod_by_track_rod_outer_x,
                    rows[equation::TRACK_ROD],
                );
            rows[equation::KNUCKLE_LOWER_REAR_OUTER_Z] = rows[equation::KNUCKLE_LOWER_REAR_OUTER_Z]
                .minus_product(
                    self.lower_rear_by_lower_rear_outer_z,
                    rows[equation::LOWER_REAR],
                );
            rows[equation::KNUCKLE_LOWER_REAR_OUTER_Y] = rows[equation::KNUCKLE_LOWER_REAR_OUTER_Y]
                .minus_product(
                    self.lower_rear_by_lower_rear_outer_y,
                    rows[equation::LOWER_REAR],
                );
            rows[equation::KNUCKLE_LOWER_REAR_OUTER_X] = rows[equation::KNUCKLE_LOWER_REAR_OUTER_X]
                .minus_product(
                    self.lower_rear_by_lower_rear_outer_x,
                    rows[equation::LOWER_REAR],
                );
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
            unknowns: &[
                "lower_front_outer.x",
                "lower_front_outer.y",
                "lower_front_outer.z",
                "upper_front_outer.x",
                "upper_front_outer.y",
                "upper_front_outer.z",
                "upper_rear_outer.x",
                "upper_rear_outer.y",
                "upper_rear_outer.z",
                "lower_rear_outer.x",
                "lower_rear_outer.y",
                "lower_rear_outer.z",
                "track_rod_outer.x",
                "track_rod_outer.y",
                "track_rod_outer.z",
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
        fn of(_listing: Listing, design: &Points<T>) -> Result<Self, GeometryError> {
            parts::finite(design.values())?;
            let knuckle_frame = parts::frame(7, design.knuckle_frame())?;
            let model = Self {
                fixed: Fixed {
                    lower_front_inner: design.lower_front_inner,
                    upper_front_inner: design.upper_front_inner,
                    upper_rear_inner: design.upper_rear_inner,
                    lower_rear_inner: design.lower_rear_inner,
                    track_rod_inner: design.track_rod_inner,
                },
                size: T::zero(),
                lower_front: parts::distance(
                    0,
                    design.lower_front_inner,
                    design.lower_front_outer,
                )?,
                upper_front: parts::distance(
                    1,
                    design.upper_front_inner,
                    design.upper_front_outer,
                )?,
                upper_rear: parts::distance(
                    2,
                    design.upper_rear_inner,
                    design.upper_rear_outer,
                )?,
                lower_rear: parts::distance(
                    3,
                    design.lower_rear_inner,
                    design.lower_rear_outer,
                )?,
                track_rod: parts::distance(
                    4,
                    design.track_rod_inner,
                    design.track_rod_outer,
                )?,
                knuckle_lower_front_outer_upper_front_outer: parts::distance(
                    5,
                    design.lower_front_outer,
                    design.upper_front_outer,
                )?,
                knuckle_lower_front_outer_upper_rear_outer: parts::distance(
                    6,
                    design.lower_front_outer,
                    design.upper_rear_outer,
                )?,
                knuckle_upper_front_outer_upper_rear_outer: parts::distance(
                    7,
                    design.upper_front_outer,
                    design.upper_rear_outer,
                )?,
                knuckle_frame,
                knuckle_lower_rear_outer: parts::carried(
                    8,
                    design.lower_rear_outer,
                    &knuckle_frame,
                )?,
                knuckle_track_rod_outer: parts::carried(
                    9,
                    design.track_rod_outer,
                    &knuckle_frame,
                )?,
                wheel_centre: parts::carried(
                    10,
                    design.wheel_centre,
                    &design.knuckle_frame(),
                )?,
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

        fn with_markers(self, points: &Points<T>) -> Result<Self, GeometryError> {
            parts::finite(points.values())?;
            Ok(Self {
                wheel_centre: parts::carried(
                    10,
                    points.wheel_centre,
                    &points.knuckle_frame(),
                )?,
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
