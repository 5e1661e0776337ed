//! Listings with carried points in all possible positions: driven, linked to each other or to nothing, next to a frame on
//! the chassis, held by two bodies, in the frame of another body.

use nalgebra::Vector3;
use suspension_core::{Real, Values};

suspension_core::linkage! {
    /// An arm that drives a rocker, both hinged to the chassis. The pushrod joins two carried points;
    /// the sensor is joined to none.
    pub mod pushrod {
        fixed: inner, outer, pivot_front, pivot_rear;
        free:  tip, foot, seat, sensor, lever, head, arb;
        body arm:    inner, outer, tip, foot, seat, sensor;
        body rocker: pivot_front, pivot_rear, lever, head, arb;
        link rod:    foot -> head;
        drive bump:  seat.z;
    }
}

suspension_core::linkage! {
    /// Two bodies that carry their common point, each with another.
    pub mod common_point {
        fixed: inner, outer, front, rear, top;
        free:  tip, joint, pad, p, q, r, eye;
        body arm:     inner, outer, tip, joint, pad;
        body knuckle: p, q, r, joint, eye;
        link lead:    front -> p;
        link trail:   rear -> q;
        link upper:   top -> eye;
        drive bump:   pad.z;
    }
}

suspension_core::linkage! {
    /// A carried point in the frame of the next body. One of its neighbours is tied to that frame,
    /// one to a point that it carries.
    pub mod in_the_next_frame {
        fixed: inner, outer, front;
        free:  tip, joint, horn, lug, q, r, eye;
        body arm:     inner, outer, tip, joint, horn, lug;
        body knuckle: joint, q, r, eye;
        link lead:    front -> q;
        link droop:   horn -> r;
        link strap:   lug -> eye;
        drive bump:   tip.z;
    }
}

suspension_core::linkage! {
    /// A body that is held only by carried points.
    pub mod held_by_carried {
        fixed: front, rear, top;
        free:  a, b, c, p, q, r, s;
        body plate:  a, b, c, p, q, r, s;
        link lead:   front -> p;
        link trail:  rear -> q;
        link upper:  top -> r;
        drive turn:  angle(front -> p, z);
        drive tilt:  q.z - r.z;
        drive steer: s.y;
    }
}

/// No two points alike, and no four in a plane.
pub(crate) fn scattered<T: Real, P: Values<Vector3<T>>>() -> P {
    let mut angle = 0.0_f64;
    P::from_values(std::iter::repeat_with(|| {
        angle += 1.0;
        Vector3::new(
            angle.sin(),
            (2.3 * angle).cos(),
            (0.7 * angle * angle).sin(),
        )
        .map(|x| T::constant(0.3 * x))
    }))
}
