//! The macro `linkage!`, which finds its own crate under any name that a program gives it.

#[doc = include_str!("../docs/linkage.md")]
#[macro_export]
macro_rules! linkage {
    ($($listing:tt)*) => {
        $crate::generated::expand! { [$crate] $($listing)* }
    };
}
