//! A library for C with a user's own linkage. `tests/own_linkage.rs` prints its header and links
//! `examples/c/four_bar.c` with it.

suspension_core::linkage! {
    /// A four-bar in the y-z plane: crank, coupler and rocker.
    pub mod four_bar {
        fixed: crank_pin  at [0.0, 0.0, 0.0],
               rocker_pin at [0.0, 0.6, 0.1];
        free:  crank_end  at [0.0, 0.0, 0.2],
               rocker_end at [0.0, 0.45, 0.5];
        link crank:   crank_pin -> crank_end;
        link coupler: crank_end -> rocker_end;
        link rocker:  rocker_pin -> rocker_end;
        /// Angle of the crank from the vertical.
        drive turn:   angle(crank_pin -> crank_end, z);
        drive slide:  crank_end.x;
        drive align:  rocker_end.x - crank_end.x;
        measure double: angle(rocker_pin -> rocker_end, z);
    }
}

suspension_c::export!(
    /// A four-bar in the y-z plane: crank, coupler and rocker. Drives: `turn`, the crank's angle from
    /// the vertical in rad; `slide` and `align`, which keep it in the plane.
    pub mod four_bar_f32 = four_bar, f32, "my_four_bar_f32", design
);
