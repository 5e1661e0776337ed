//! Drives the car.

use suspension_car::{car::Car, detail::Detail, driver::Driver, road::Road, saloon::SALOON};

fn main() {
    for detail in Detail::ALL {
        let mut car = Car::new(&SALOON, detail).expect("the design").rolling(20.0);
        let driver = Driver {
            speed: 20.0,
            rack: 0.006,
            from: 1.0,
            ramp: 0.3,
            hold: 2.0,
        };
        let mut look = std::time::Duration::ZERO;
        let mut touch = std::time::Duration::ZERO;
        let mut advance = std::time::Duration::ZERO;
        for tick in 0..10_000 {
            let road = if tick < 5000 {
                Road::Flat
            } else {
                Road::Bumpy(0.02)
            };
            let controls = driver.controls(tick as f64 * 1e-3, &car);
            if tick % 1000 == 0 {
                println!(
                    "{tick} {:.3?} {:.3?} rack {:.4} loads {:.0?} travel {:.4?}",
                    car.chassis.position.as_slice(),
                    car.chassis.frame().velocity.as_slice(),
                    controls.rack.value,
                    car.corners.each_ref().map(|c| c.ground.load),
                    car.corners.each_ref().map(|c| c.travel)
                );
            }
            let a = std::time::Instant::now();
            car.look(1e-3, &controls.rack).expect("ok");
            let b = std::time::Instant::now();
            let frame = car.touch(1e-3, &road);
            let c = std::time::Instant::now();
            car.advance(1e-3, &frame, &controls);
            let d = std::time::Instant::now();
            look += b - a;
            touch += c - b;
            advance += d - c;
        }
        println!(
            "{} {:?} {:?} {:?}",
            detail.name(),
            look / 10_000,
            touch / 10_000,
            advance / 10_000
        );
    }
}
