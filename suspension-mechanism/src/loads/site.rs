//! Where a load acts.

/// Where a load acts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Site {
    /// At a free point, which passes the load to whatever it joins.
    Point(usize),
    /// At a point of a body that these three points determine.
    Body(usize, [usize; 3]),
    /// Where a wheel by this number touches the ground, the wheel being held by its carrier.
    Contact(usize),
}
