//! The macro `linkage!`, which names its own crate whatever a program calls it.

#[doc = include_str!("../docs/linkage.md")]
#[macro_export]
macro_rules! linkage {
    ($($listing:tt)*) => {
        $crate::generated::expand! { [$crate] $($listing)* }
    };
}
