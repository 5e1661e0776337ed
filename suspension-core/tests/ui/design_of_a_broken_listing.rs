suspension_core::linkage! {
    mod corner {
        fixed: fore at [0.3, 0.0, 0.0], aft at [-0.3, 0.0, 0.0];
        free: tip at [0.0, 0.4, 0.0];
        link front: fore -> tip;
        link rear: afd -> tip;
        drive lift: tip.z;
    }
}

use corner::{Corner, Drives};
use suspension_core::Signal;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut corner: Corner = Corner::design()?;
    let start = corner.drives();
    corner.advance(1.0, |time| Signal::line(start, Drives { lift: 0.05 }, time))?;
    println!("{}", corner.points().rate.tip.z);
    Ok(())
}
