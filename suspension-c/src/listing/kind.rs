//! The kinds of parts that have names in a listing.

/// A kind of what has names: points are 0, drives 1, measures 2, wheels 3, parts 4.
pub type Kind = i32;

/// What parts may be asked for, in C.
pub(crate) const KINDS: &str = "
/** What of a listing has numbers and names: points (on the chassis, free, markers), drives, measures, wheels, and
 * the parts that hold its points: links, bodies, hinges, slides and the like. The name of an only wheel that is
 * stated without one is empty. */
typedef int32_t susp_kind;
enum { SUSP_POINT = 0, SUSP_DRIVE = 1, SUSP_MEASURE = 2, SUSP_WHEEL = 3, SUSP_PART = 4 };
";
