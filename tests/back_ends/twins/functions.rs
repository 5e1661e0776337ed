//! The functions of a model, one by one, at points and rates that need not fit.

use nalgebra::SVector;
use suspension_core::linkage::Factors;
use suspension_core::{Build, Signal, Values};

use super::Twins;
use super::same::{Number, as_other, entries, same, same_points, same_signal, signal_as_other};

impl<T, L, R, const N: usize, const M: usize> Twins<L, R, N, M>
where
    T: Number,
    L: Build<N, Scalar = T> + Copy,
    R: Build<M, Scalar = T> + Copy,
{
    /// Everything that is computed of a model, at some points and rates.
    pub(crate) fn compare_functions(&self, points: &[L::Points; 3]) {
        self.compare_constants();
        self.compare_equations(points);
        self.compare_points(points);
        self.compare_readings(points);
    }

    fn compare_constants(&self) {
        let Self { written, walked } = self;
        same("size", [written.size()], [walked.size()]);
        same(
            "lengths",
            written.lengths().values(),
            walked.lengths().values(),
        );
        same(
            "fixed",
            entries(written.fixed().values()),
            entries(walked.fixed().values()),
        );
        assert!(written.linked().eq(walked.linked()));
    }

    /// Compares the statements of the equations.
    fn compare_equations(&self, points: &[L::Points; 3]) {
        let Self { written, walked } = self;
        let ([q, v, w], [q_walked, v_walked, w_walked]) = self.unknowns(points);
        let ([fixed, fixed_rate, fixed_second], [other, other_rate, other_second]) =
            Self::chassis(points);
        let drives = written.drives_at(&points[0]);
        let other_drives = walked.drives_at(&as_other(&points[0]));
        same("drives_at", drives.values(), other_drives.values());
        self.compare_inputs(&fixed, &drives);
        self.same_vector(
            "residual",
            &written.residual(&q, &fixed, &drives),
            &walked.residual(&q_walked, &other, &other_drives),
        );
        self.same_vector(
            "curvature",
            &written.curvature(&v, &fixed_rate, &w, &fixed_second),
            &walked.curvature(&v_walked, &other_rate, &w_walked, &other_second),
        );
        self.same_vector(
            "drive_rate",
            &written.drive_rate(&q, &fixed, &fixed_rate, &drives),
            &walked.drive_rate(&q_walked, &other, &other_rate, &other_drives),
        );
        self.same_vector(
            "chassis_rate",
            &written.chassis_rate(&q, &fixed, &fixed_rate),
            &walked.chassis_rate(&q_walked, &other, &other_rate),
        );
        self.compare_jacobian(&q, &fixed, &fixed_rate);
        same(
            "mirrored",
            written.mirrored(&q, &fixed),
            walked.mirrored(&q_walked, &other),
        );
        self.same_vector(
            "fit",
            &written.fit(&q, &fixed),
            &walked.fit(&q_walked, &other),
        );
    }

    fn compare_inputs(&self, fixed: &L::Fixed, drives: &L::Drives) {
        let signal = Signal {
            value: *drives,
            rate: drives.map(|x| x + T::constant(0.25)),
            second_rate: drives.map(|x| x - T::constant(0.75)),
        };
        let coordinates = self.written.coordinates(&signal);
        let others = self.walked.coordinates(&signal_as_other(&signal));
        same_signal("coordinates", &coordinates, &others);
        same_points(
            "drive_anchors",
            &self.written.drive_anchors(*fixed, &coordinates.rate),
            &self.walked.drive_anchors(as_other(fixed), &others.rate),
        );
    }

    /// The Jacobian, its factors and their solutions.
    fn compare_jacobian(&self, q: &SVector<T, N>, fixed: &L::Fixed, fixed_rate: &L::Fixed) {
        let Self { written, walked } = self;
        let (q_walked, other) = (self.wide(q), as_other(fixed));
        let jacobian = written.jacobian(q, fixed);
        let walked_jacobian = walked.jacobian(&q_walked, &other);
        for column in 0..M {
            let found = walked_jacobian.column(column).into_owned();
            match column {
                column if column < N => {
                    self.same_vector("jacobian", &jacobian.column(column).into_owned(), &found)
                }
                _ => assert!(found.iter().enumerate().all(|(row, entry)| {
                    *entry == if row == column { T::one() } else { T::zero() }
                })),
            }
        }
        let factors = written.factor(q, fixed);
        let others = walked.factor(&q_walked, &other);
        same(
            "growth",
            [factors.growth_squared()],
            [others.growth_squared()],
        );
        same(
            "sign",
            [factors.determinant_sign()],
            [others.determinant_sign()],
        );
        let drives = L::Drives::from_values(q.iter().copied());
        let of_drives = written.drive_rate(q, fixed, fixed_rate, &drives);
        for right in [*q, jacobian * q, of_drives] {
            let wide = self.wide(&right);
            self.same_vector("solve", &factors.solve(&right), &others.solve(&wide));
            self.same_vector(
                "solve_transposed",
                &factors.solve_transposed(&right),
                &others.solve_transposed(&wide),
            );
        }
    }

    /// Compares the points for the unknowns and their rates.
    fn compare_points(&self, points: &[L::Points; 3]) {
        let Self { written, walked } = self;
        let ([q, v, w], [q_walked, v_walked, w_walked]) = self.unknowns(points);
        let ([fixed, rate, second], [other, other_rate, other_second]) = Self::chassis(points);
        let all = written.points(&q, &fixed);
        let other_all = walked.points(&q_walked, &other);
        same_points("points", &all, &other_all);
        let velocities = written.velocities(&all, &v, &rate);
        let other_velocities = walked.velocities(&other_all, &v_walked, &other_rate);
        same_points("velocities", &velocities, &other_velocities);
        same_points(
            "accelerations",
            &written.accelerations(&all, &velocities, &w, &second),
            &walked.accelerations(&other_all, &other_velocities, &w_walked, &other_second),
        );
        let [_, forces, _] = points;
        let (mut carried, mut other_carried) = (*forces, as_other(forces));
        written.carry_forces(&q, &fixed, &mut carried);
        walked.carry_forces(&q_walked, &other, &mut other_carried);
        same_points("carry_forces", &carried, &other_carried);
    }

    /// Compares all quantities of the points.
    fn compare_readings(&self, [at, rate, second]: &[L::Points; 3]) {
        let Self { written, walked } = self;
        let signal = Signal {
            value: *at,
            rate: *rate,
            second_rate: *second,
        };
        let other = signal_as_other(&signal);
        same_signal(
            "measures",
            &written.measures(&signal),
            &walked.measures(&other),
        );
        assert_eq!(written.wheel_axis(at), walked.wheel_axis(&other.value));
        assert_eq!(
            written.wheel_carrier(at),
            walked.wheel_carrier(&other.value)
        );
        assert_eq!(written.kingpin(at), walked.kingpin(&other.value));
    }

    /// The unknowns of points and their rates, by each back end.
    fn unknowns(
        &self,
        [at, rate, second]: &[L::Points; 3],
    ) -> ([SVector<T, N>; 3], [SVector<T, M>; 3]) {
        let of = |points| {
            let written = self.written.unknowns(points);
            let walked = self.walked.unknowns(&as_other(points));
            self.same_vector("unknowns", &written, &walked);
            (written, walked)
        };
        let ((q, q_walked), (v, v_walked), (w, w_walked)) = (of(at), of(rate), of(second));
        ([q, v, w], [q_walked, v_walked, w_walked])
    }

    /// Returns their chassis points.
    fn chassis([at, rate, second]: &[L::Points; 3]) -> ([L::Fixed; 3], [R::Fixed; 3]) {
        let of = |points: &L::Points| L::Fixed::from_values(points.values());
        let [at, rate, second] = [of(at), of(rate), of(second)];
        let walked = [as_other(&at), as_other(&rate), as_other(&second)];
        ([at, rate, second], walked)
    }
}
