//! A tick does not allocate, whatever the detail, nor does a change of detail or a refusal.

#[path = "../../../tests/counting/mod.rs"]
mod counting;

use counting::{Counting, allocations};
use suspension_car::car::{Car, Controls};
use suspension_car::detail::Detail;
use suspension_car::road::Road;
use suspension_car::saloon::SALOON;

const BUMPS: Road = Road::Bumpy {
    size: 0.02,
    from: 0.0,
};

#[global_allocator]
static ALLOCATOR: Counting = Counting;

#[test]
fn a_tick_of_the_car_does_not_allocate() {
    for detail in Detail::ALL {
        let mut car = Car::new(&SALOON, detail).expect("the design").rolling(20.0);
        let mut others = Detail::Exact.corners().expect("a linkage");
        let controls = Controls::default();
        let before = allocations();
        for _ in 0..1_000 {
            let driven = car.tick(1e-3, &BUMPS, &controls);
            assert!(driven.is_ok());
        }
        for _ in 0..2 {
            let changed = car.change(&mut others, &controls);
            assert!(changed.is_ok());
        }
        car.corners[0].travel = 3.0;
        let refused = car.tick(1e-3, &Road::Flat, &controls).is_err();
        assert_eq!(allocations(), before, "{} allocates", detail.name());
        assert_eq!(refused, detail != Detail::Constant);
    }
}
