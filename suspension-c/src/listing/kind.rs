//! The kinds of parts that have names in a listing.

/// A kind of named parts: points are 0, drives 1, measures 2, wheels 3, parts 4.
pub type Kind = i32;

/// The kinds in C.
pub(crate) const KINDS: &str = "
/** The kinds of numbered and named items of a listing: points (chassis points, free points, markers), drives,
 * measures, wheels, and the parts that hold points, such as links, bodies, hinges and slides. A single wheel that
 * the listing states without a name has an empty name. */
typedef int32_t susp_kind;
enum { SUSP_POINT = 0, SUSP_DRIVE = 1, SUSP_MEASURE = 2, SUSP_WHEEL = 3, SUSP_PART = 4 };
";
