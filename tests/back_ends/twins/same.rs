//! Comparisons to the bit.

use nalgebra::Vector3;
use suspension_core::listing::{Kind, Part, Parts};
use suspension_core::{Real, Signal, Values};

/// A number that has bits.
pub(crate) trait Number: Real + std::fmt::LowerExp {
    fn bits(self) -> u64;
}

impl Number for f64 {
    fn bits(self) -> u64 {
        self.to_bits()
    }
}

impl Number for f32 {
    fn bits(self) -> u64 {
        self.to_bits().into()
    }
}

/// Asserts that the numbers are equal to the bit.
#[track_caller]
pub(super) fn same<T: Number>(
    what: &str,
    written: impl IntoIterator<Item = T>,
    walked: impl IntoIterator<Item = T>,
) {
    let mut walked = walked.into_iter();
    for (index, expected) in written.into_iter().enumerate() {
        let found = walked
            .next()
            .unwrap_or_else(|| panic!("{what} ends at {index}"));
        assert!(
            expected.bits() == found.bits(),
            "{what} {index}: {expected:e} is walked as {found:e}"
        );
    }
}

pub(super) fn entries<T: Real, V: IntoIterator<Item = Vector3<T>>>(
    vectors: V,
) -> impl Iterator<Item = T> {
    vectors.into_iter().flat_map(|v| [v.x, v.y, v.z])
}

/// Vectors, to the bit.
#[track_caller]
pub(super) fn same_points<T: Number>(
    what: &str,
    written: &impl Values<Vector3<T>>,
    walked: &impl Values<Vector3<T>>,
) {
    same(what, entries(written.values()), entries(walked.values()));
}

#[track_caller]
pub(super) fn same_signal<T: Number, A: Values<T>, B: Values<T>>(
    what: &str,
    written: &Signal<A>,
    walked: &Signal<B>,
) {
    same(what, written.value.values(), walked.value.values());
    same(what, written.rate.values(), walked.rate.values());
    same(
        what,
        written.second_rate.values(),
        walked.second_rate.values(),
    );
}

/// Copies the values to the type of the other.
pub(super) fn as_other<V: Default, A: Values<V>, B: Values<V>>(values: &A) -> B {
    B::from_values(values.values())
}

pub(super) fn signal_as_other<V: Default, A: Values<V>, B: Values<V>>(
    signal: &Signal<A>,
) -> Signal<B> {
    signal.map(as_other)
}

/// Both have the same parts, under the same names.
pub(crate) fn same_parts(written: &dyn Parts, walked: &dyn Parts) {
    let kinds = [
        Kind::Unknown,
        Kind::ChassisPoint,
        Kind::FreePoint,
        Kind::Marker,
        Kind::Drive,
        Kind::Measure,
        Kind::Length,
    ];
    for kind in kinds {
        assert_eq!(written.count(kind), walked.count(kind), "{kind:?}");
    }
    let parts = [
        Part::Equation,
        Part::Unknown,
        Part::Point,
        Part::Drive,
        Part::Measure,
        Part::Length,
    ];
    for part in parts {
        for index in 0..200 {
            assert_eq!(written.name(part(index)), walked.name(part(index)));
        }
    }
    for index in 0..20 {
        assert_eq!(written.drive_kind(index), walked.drive_kind(index));
        assert_eq!(written.measure_kind(index), walked.measure_kind(index));
        assert_eq!(written.wheel(index), walked.wheel(index));
    }
}
