//! The smallest listing of each kind: all compile, without a warning.

suspension_core::linkage! {
    /// Shows a chassis point that a drive moves.
    pub mod rack {
        fixed: rack, a, b;
        free: p;
        link tie_rod: rack -> p;
        link fore: a -> p;
        link aft: b -> p;
        drive steer: rack.y;
    }
}

suspension_core::linkage! {
    /// Shows a body that turns about two chassis points.
    pub mod rocker {
        fixed: front, rear;
        free: push, pull;
        body rocker: push, front, pull, rear;
        drive lift: push.z;
    }
}

suspension_core::linkage! {
    /// Shows names that begin and end with an underscore, in names made of two.
    pub mod underscores {
        fixed: front_, _rear;
        free: push_, _pull;
        body rocker_: push_, front_, _pull, _rear;
        drive lift_: push_.z;
    }
}

suspension_core::linkage! {
    /// Shows two bodies with a common edge.
    pub mod hinge {
        fixed: front, rear;
        free: p, q, tip;
        body arm: front, rear, p, q;
        body flap: p, q, tip;
        drive lift: p.z;
        drive fold: tip.z - p.z;
    }
}

suspension_core::linkage! {
    /// Shows a prescribed difference of coordinates.
    pub mod difference {
        fixed: a;
        free: p, q;
        drive x: p.x;
        drive y: p.y;
        drive z: p.z;
        drive gap_x: q.x - p.x;
        drive gap_y: q.y - a.y;
        drive gap_z: a.z - q.z;
    }
}

suspension_core::linkage! {
    /// Shows a body of two points.
    pub mod bar {
        fixed: a;
        free: p;
        body bar: a, p;
        drive y: p.y;
        drive z: p.z;
    }
}

suspension_core::linkage! {
    /// Shows what can be measured, of any points.
    pub mod measures {
        fixed: a, b;
        free: p, q, r;
        link rod: a -> p;
        body plate: p, q, r;
        drive y: p.y;
        drive z: p.z;
        drive lift: q.z;
        drive side: q.y;
        drive turn: r.z;
        point hub: plate;
        measure height: hub.z;
        /// Between any two points.
        measure spring: length(b -> hub);
        measure track: r.y - b.y;
        measure points: angle(b -> r, x);
        measure each: angle(hub -> p, y);
    }
}

suspension_core::linkage! {
    /// Shows names that are words of Rust, or of the generated code.
    pub mod keywords {
        fixed: r#type, q;
        free: free, frame, rows;
        link r#loop: r#type -> free;
        body columns: free, frame, rows, q;
        drive drives: rows.y;
        drive v: rows.z;
        point at: columns;
        wheel: rows -> at;
    }
}
