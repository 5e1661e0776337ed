//! The catalogue: one listing a file. Each module holds the types of one linkage: `Model`,
//! `Points`, `Fixed`, `Drives`, `Measures`, `Lengths`.

use crate::linkage;

macro_rules! catalogue {
    ($($name:ident),* $(,)?) => {
        $(linkage! { pub mod $name; })*

        /// The listings by name, as text.
        pub const LISTINGS: &[(&str, &str)] = &[
            $((stringify!($name), include_str!(concat!(stringify!($name), ".linkage")))),*
        ];
    };
}

catalogue! {
    attia2003,
    five_link,
    double_wishbone,
    double_wishbone_pushrod,
}
