//! The two back ends side by side: what `linkage!` writes of a listing, and its text walked.

use nalgebra::SVector;
use suspension_core::linkage::Factors;
use suspension_core::step::bounded::Outputs;
use suspension_core::{Bounded, Build, Inputs, Motion, Signal, Still, Tracker, Values};

mod same;

pub(crate) use same::{Number, same_parts};
use same::{as_other, entries, same, same_points, same_signal, signal_as_other};

/// A model of `N` unknowns that `linkage!` wrote, and one with room for `M` or fewer that walks the text.
pub(crate) struct Twins<L, R, const N: usize, const M: usize> {
    pub(crate) written: L,
    pub(crate) walked: R,
}

impl<T, L, R, const N: usize, const M: usize> Twins<L, R, N, M>
where
    T: Number,
    L: Build<N, Scalar = T> + Copy,
    R: Build<M, Scalar = T> + Copy,
{
    /// The same vector with room to spare.
    fn wide(&self, q: &SVector<T, N>) -> SVector<T, M> {
        SVector::from_fn(|index, _| q.get(index).copied().unwrap_or_else(T::zero))
    }

    #[track_caller]
    fn same_vector(&self, what: &str, written: &SVector<T, N>, walked: &SVector<T, M>) {
        same(what, written.iter().copied(), walked.iter().copied());
        let beyond = walked.iter().skip(N);
        assert!(beyond.into_iter().all(|x| *x == T::zero()), "{what} beyond");
    }

    /// Everything that is computed of a model, at some points and rates, which need not fit.
    pub(crate) fn compare_functions(&self, points: &[L::Points; 3]) {
        let Self { written, walked } = self;
        let [at, rate, second] = points;
        let others: [R::Points; 3] = points.each_ref().map(as_other);
        let [q, v, w] = points.each_ref().map(|points| written.unknowns(points));
        let [q_walked, v_walked, w_walked] =
            others.each_ref().map(|points| walked.unknowns(points));
        for (written, walked) in [(&q, &q_walked), (&v, &v_walked), (&w, &w_walked)] {
            self.same_vector("unknowns", written, walked);
        }
        let chassis = |points: &L::Points| L::Fixed::from_values(points.values());
        let [fixed, fixed_rate, fixed_second] = points.each_ref().map(chassis);
        let [other, other_rate, other_second]: [R::Fixed; 3] =
            [&fixed, &fixed_rate, &fixed_second].map(as_other);
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
        let drives = written.drives_at(at);
        let other_drives = walked.drives_at(&others[0]);
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
        assert!(written.linked().eq(walked.linked()));
        self.same_vector(
            "fit",
            &written.fit(&q, &fixed),
            &walked.fit(&q_walked, &other),
        );
        let all = written.points(&q, &fixed);
        let other_all = walked.points(&q_walked, &other);
        same_points("points", &all, &other_all);
        let velocities = written.velocities(&all, &v, &fixed_rate);
        let other_velocities = walked.velocities(&other_all, &v_walked, &other_rate);
        same_points("velocities", &velocities, &other_velocities);
        same_points(
            "accelerations",
            &written.accelerations(&all, &velocities, &w, &fixed_second),
            &walked.accelerations(&other_all, &other_velocities, &w_walked, &other_second),
        );
        let signal = Signal {
            value: *at,
            rate: *rate,
            second_rate: *second,
        };
        let other_signal = signal_as_other(&signal);
        same_signal(
            "measures",
            &written.measures(&signal),
            &walked.measures(&other_signal),
        );
        assert_eq!(written.wheel_axis(at), walked.wheel_axis(&others[0]));
        assert_eq!(written.wheel_carrier(at), walked.wheel_carrier(&others[0]));
        assert_eq!(written.kingpin(at), walked.kingpin(&others[0]));
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

    /// The same with the lengths of other points, where there is such a linkage.
    pub(crate) fn with_lengths_of(&self, points: &L::Points) -> Option<Self> {
        let lengths = L::of(self.written.listing(), points).map(|model| model.lengths());
        let others = R::of(self.walked.listing(), &as_other(points)).map(|model| model.lengths());
        let (lengths, others) = match (lengths, others) {
            (Ok(lengths), Ok(others)) => (lengths, others),
            (refused, also) => {
                assert_eq!(refused.err(), also.err());
                return None;
            }
        };
        same("lengths", lengths.values(), others.values());
        let written = self.written.with_lengths(&lengths);
        let walked = self.walked.with_lengths(&others);
        match (written, walked) {
            (Ok(written), Ok(walked)) => Some(Self { written, walked }),
            (refused, also) => {
                assert_eq!(refused.err(), also.err());
                None
            }
        }
    }

    /// A motion from the design, at a fixed cost and to tolerance; returns how many steps it took.
    pub(crate) fn compare_motion(&self, design: &L::Points, swing: f64) -> usize {
        let (rest, swing) = (self.written.drives_at(design), T::constant(swing));
        let inputs = |t: T| {
            let swung = |amplitude: T| {
                let mut fraction = T::one();
                let values = rest.values().map(|_| {
                    let value = amplitude * fraction;
                    fraction *= T::constant(-0.5);
                    value
                });
                values.collect::<Vec<T>>()
            };
            let add = |change: Vec<T>| {
                let values = rest.values().zip(change);
                L::Drives::from_values(values.map(|(rest, change)| rest + change))
            };
            let frequency = T::constant(5.0);
            let (sine, cosine) = (frequency * t).sin_cos();
            Inputs::still(Signal {
                value: add(swung(swing * sine)),
                rate: L::Drives::from_values(swung(swing * frequency * cosine)),
                second_rate: L::Drives::from_values(swung(-swing * frequency * frequency * sine)),
            })
        };
        let q = self.written.unknowns(design);
        let start = (Motion::at_rest(q), Motion::at_rest(self.wide(&q)));
        let bounded = self.follow(start, inputs, |inputs, others, dt, (motion, other)| {
            let bounded = Bounded::<T>::default();
            let outputs = Outputs::Acceleration;
            let done = bounded.attempt(outputs, &self.written, inputs, dt, motion);
            let also = bounded.attempt(outputs, &self.walked, others, dt, other);
            assert_eq!(done, also);
            done.is_ok()
        });
        let tracked = self.follow(start, inputs, |inputs, others, dt, (motion, other)| {
            let done = Tracker::default().step(&self.written, inputs, dt, motion);
            let also = Tracker::default().step(&self.walked, others, dt, other);
            assert_eq!(done.as_ref().err(), also.as_ref().err());
            done.is_ok()
        });
        bounded + tracked
    }

    fn follow(
        &self,
        start: (Motion<T, N>, Motion<T, M>),
        inputs: impl Fn(T) -> Inputs<Still, L::Drives>,
        step: impl Fn(
            &Inputs<Still, L::Drives>,
            &Inputs<Still, R::Drives>,
            T,
            &mut (Motion<T, N>, Motion<T, M>),
        ) -> bool,
    ) -> usize {
        let mut motions = start;
        for index in 0..100 {
            let dt = if index == 0 { 0.0 } else { 1e-3 };
            let inputs = inputs(T::constant(1e-3 * f64::from(index)));
            let others = Inputs::still(signal_as_other(&inputs.drives));
            if !step(&inputs, &others, T::constant(dt), &mut motions) {
                return index as usize;
            }
            let (motion, other) = &motions;
            self.same_vector("position", &motion.position, &other.position);
            self.same_vector("velocity", &motion.velocity, &other.velocity);
            self.same_vector("acceleration", &motion.acceleration, &other.acceleration);
            assert_eq!(motion.positive_determinant, other.positive_determinant);
            let points = motion.points(&self.written, &inputs);
            let others = other.points(&self.walked, &others);
            same_points("points", &points.value, &others.value);
            same_points("velocities", &points.rate, &others.rate);
            same_points("accelerations", &points.second_rate, &others.second_rate);
        }
        100
    }
}
