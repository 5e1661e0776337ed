//! The displacement of each wheel from its design position, where it is zero.

use suspension_core::signal::Number as _;

use crate::quantities::axis::Axis;
use crate::quantities::catalogue::wheel::{CENTRE, CONTACT};
use crate::quantities::quantity::{Quantity, Shown};
use crate::quantities::readings::from_design::{of_moved, of_moved_from_other_axle};

catalogue! {
    WHEEL_TRAVEL: "wheel travel" {
        name: "wheel_travel",
        sign: "positive upwards: bump",
        definition: "the height of the wheel centre above its height at the design position",
        source: "as reports of kinematics and compliance have it",
        zero_at_design: (&CENTRE, Some(Axis::Z)),
        shown: Shown::InTables,
        read: |names| of_moved(names, false, |now, design| now.centre.z - design.centre.z),
    }
    RECESSION: "recession" {
        name: "recession",
        sign: "positive where the wheel moves rearward",
        definition: "how far the wheel centre is behind its design position, along x",
        source: "as wheel_travel",
        zero_at_design: (&CENTRE, Some(Axis::X)),
        shown: Shown::InTables,
        read: |names| of_moved(names, false, |now, design| design.centre.x - now.centre.x),
    }
    HALF_TRACK_CHANGE: "change of half track" {
        name: "half_track_change",
        sign: "positive outboard",
        definition: "how far the contact point is outboard of its design position, along y",
        source: "as wheel_travel",
        zero_at_design: (&CONTACT, Some(Axis::Y)),
        shown: Shown::InTables,
        read: |names| of_moved(names, true, |now, design| {
            let moved = now.contact.y - design.contact.y;
            if design.axis.y.is_below_zero() { -moved } else { moved }
        }),
    }
    WHEELBASE_CHANGE: "change of wheelbase" {
        name: "wheelbase_change",
        sign: "positive where the wheel moves away from the other axle",
        definition: "how far the contact point is from its design position, along x: what the wheel adds to the \
                     wheelbase of its side",
        source: "as wheel_travel",
        vehicle: "`axle`",
        zero_at_design: (&CONTACT, Some(Axis::X)),
        shown: Shown::InTables,
        read: |names| of_moved_from_other_axle(names, |now, design| now.contact.x - design.contact.x),
    }
}
