//! Single precision beside `f64`: how far off it is, and what it refuses.

mod support;

mod f32 {
    mod case;
    mod chassis_axes;
    mod published;
    mod random;
}
