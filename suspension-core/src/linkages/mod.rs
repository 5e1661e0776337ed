//! The catalogue: one listing a file. Each module holds the types of one linkage: `Model`,
//! `Points`, `Fixed`, `Drives`, `Measures`, `Lengths`.

#[path = "attia2003.rs"]
mod attia2003_listing;
#[path = "five_link.rs"]
mod five_link_listing;

pub use attia2003_listing::attia2003;
pub use five_link_listing::five_link;
