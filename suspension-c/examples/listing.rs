//! `examples/c/listing.c` in Rust, with the listing compiled: prints the same text, including checksums of
//! all bits.

use std::error::Error;

use suspension_core::linkage::Designed;
use suspension_core::linkages::double_wishbone_pushrod::{Corner, Drives, Model};
use suspension_core::nalgebra::Vector3;
use suspension_core::{Signal, Values};

const STEPS: i32 = 12;

/// An FNV-1a checksum.
struct Checksum(u64);

impl Checksum {
    fn add(&mut self, number: f64) {
        for byte in number.to_le_bytes() {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }

    fn add_points<P: Values<Vector3<f64>>>(&mut self, points: &Signal<P>) {
        for points in [&points.value, &points.rate, &points.second_rate] {
            for point in points.values() {
                point.iter().for_each(|number| self.add(*number));
            }
        }
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut design = <Model<f64> as Designed<_>>::design();
    design.damper_inner.y = 0.11;
    let mut corner: Corner = Corner::new(&design)?;
    let (start, mut checksum) = (corner.drives(), Checksum(0xcbf2_9ce4_8422_2325));
    let (bump, none) = (1.0, Drives::default());
    println!("    bump   camber  damper per bump");
    println!("       m      deg");
    for step in 0..=STEPS {
        let travel = 0.01 * f64::from(step - STEPS / 2);
        let drives = Signal {
            value: Drives {
                bump: start.bump + travel,
                ..start
            },
            rate: Drives { bump: 0.01, ..none },
            second_rate: none,
        };
        corner.step_towards(1.0, drives)?;
        checksum.add_points(&corner.points());
        let per = corner.per(Drives { bump, ..none })?;
        checksum.add_points(&per.points);
        for measures in [
            per.measures.value,
            per.measures.rate,
            per.measures.second_rate,
        ] {
            measures.values().for_each(|number| checksum.add(number));
        }
        let camber = corner.wheel().ok_or("no wheel")?.camber;
        checksum.add(camber);
        println!(
            "{travel:8.3} {:8.4} {:10.6}  {:016x}",
            camber.to_degrees(),
            per.measures.rate.damper,
            checksum.0
        );
    }
    Ok(())
}
