//! A design that is not stated.

fn main() {
    suspension_core::linkage! {
        mod arm {
            fixed: front at [0.2, 0.3, 0.2], rear;
            free:  hub at [0.0, 0.7, 0.3];
            hinge wishbone: front, rear -> hub;
            drive bump: hub.z;
        }
    }
    let _ = arm::Corner::<f64>::design();
}
