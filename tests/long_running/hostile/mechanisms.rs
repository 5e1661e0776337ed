//! Small mechanisms that, with the catalogue's, have every kind of statement.

suspension_core::linkage! {
    /// A crank, a coupler and a rocker, closed by links alone; every kind of drive of free points.
    pub(crate) mod four_bar {
        fixed: crank_pin, rocker_pin;
        free:  crank_end, rocker_end;
        link crank:   crank_pin -> crank_end;
        link coupler: crank_end -> rocker_end;
        link rocker:  rocker_pin -> rocker_end;
        drive turn:   angle(crank_pin -> crank_end, z);
        drive slide:  crank_end.x;
        drive align:  rocker_end.x - crank_end.x;
    }
}

suspension_core::linkage! {
    /// A strut that an anchor pulls: a body on two chassis points, and a driven chassis point.
    pub(crate) mod rocker {
        fixed: front, rear, anchor;
        free:  push, pull;
        body bell_crank: push, pull, front, rear;
        link strut: anchor -> pull;
        drive slide: anchor.z;
        point mark: bell_crank;
        measure height: mark.z;
        measure lift: mark.z - front.z;
        measure lean: angle(front -> mark, z);
        measure reach: length(anchor -> mark);
    }
}
