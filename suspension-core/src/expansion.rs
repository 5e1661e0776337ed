//! The macro `linkage!`, which names its own crate whatever a program calls it.

/// Expands a listing into a module with the linkage's points, drives, lengths and equations.
///
/// ```text
/// pub mod name {
///     fixed: a, b at [0.1, 0.4, 0.2];   chassis points, with or without a design position
///     free:  c, d, e;              points to solve for, three unknowns each
///     link rod:   a -> c;          a constant length
///     body plate: c, d, e;         a rigid body: chassis points first, then those shared with
///                                  another body, then in this order, three are not in line
///     hinge arm:  a, b -> c, d;    a rigid body that turns about the line of two chassis points
///     slide strut: a on d -> e;    a point on the line through two others, which a body or the chassis
///                                    carries; adds an unknown, the distance from `d` to `a`
///     drive lift: e.z;             prescribes a coordinate: of a free point, an equation;
///                                  of a fixed point, it moves the anchor
///     drive gap:  c.z - a.z;       prescribes a difference of coordinates
///     drive rack: b along [0, 1, 0.1];  prescribes the coordinate of a point along a direction
///     drive ram:  length(b -> d);  prescribes the length between two points that nothing else keeps;
///                                    adds an unknown, the length
///     drive turn: angle(a -> c, z);  prescribes the angle from an axis to the line between two
///                                    points whose distance a link or a body's frame keeps
///     measure gauge: length(a -> hub);  reads what a drive could prescribe off any points;
///                                    adds no equation
///     point hub:  plate;           a marker carried by a body, or by three points; with or without
///                                    a design position
///     wheel:   d -> hub;           the spin axis, outboard; its second point is the centre
///     kingpin: c -> d;             upwards
/// }
/// ```
///
/// A MacPherson strut with a rack that is not square to the vehicle: the knuckle carries the strut's line, on which
/// the chassis' `top` slides. The strut's length is an unknown beside the points' coordinates.
///
/// ```
/// suspension_core::linkage! {
///     pub mod macpherson {
///         fixed: lower_front, lower_rear, rack, top;
///         free:  lower_ball, tie_ball, strut_low, strut_high, wheel_centre;
///
///         hinge lower_arm: lower_front, lower_rear -> lower_ball;
///         link tie_rod:    rack -> tie_ball;
///         body knuckle:    lower_ball, tie_ball, wheel_centre, strut_low, strut_high;
///         slide strut:     top on strut_low -> strut_high;
///
///         drive bump:  wheel_centre.z;
///         drive steer: rack along [0.05, 1.0, 0.0];
///     }
/// }
///
/// let parts = macpherson::Listing::PARTS;
/// assert_eq!((parts.equations.len(), parts.unknowns.len()), (16, 16));
/// assert_eq!(parts.unknowns.last(), Some(&"strut"));
/// ```
///
/// A rocker that an actuator turns, by its length:
///
/// ```
/// suspension_core::linkage! {
///     pub mod actuated {
///         fixed: front, rear, anchor;
///         free:  push, pull;
///
///         hinge rocker: front, rear -> push, pull;
///
///         drive actuator: length(anchor -> push);
///     }
/// }
///
/// let drives: actuated::Drives<f64> = actuated::Drives { actuator: 0.3 };
/// ```
///
/// The statements may stand in a file of their own, whose path is relative to the source file. It is
/// read again when it has changed; its mistakes are reported with the file's line and column.
///
/// ```text
/// pub mod name in "corner.linkage";
/// pub mod corner;                 the same for a file of the module's name
/// ```
///
/// `//!` at the top of the file documents the module.
///
/// Where every point states its design position, the order of elimination is chosen by the size of
/// the pivots there and, up to 60 unknowns, where drives of free points lead from there; otherwise by 256
/// designs in round numbers as corners of vehicles are drawn, which takes some more operations.
/// [`Build::new`](crate::Build::new) tells where the order does not suit hardpoints.
#[macro_export]
macro_rules! linkage {
    ($($listing:tt)*) => {
        $crate::generated::expand! { [$crate] $($listing)* }
    };
}
