//! No solving call allocates, whether it succeeds or fails.

use std::hint::black_box;

use nalgebra::{Isometry3, SVector, Vector3};
use suspension_core::certificate::Certifier;
use suspension_core::chassis::RigidMotion;
use suspension_core::linkage::{HasKingpin, HasWheel};
use suspension_core::path::{Continuation, Curve, Leader, Led};
use suspension_core::step::bounded::Outputs;
use suspension_core::step::series::{InputSeries, Jet, SeriesTracker};
use suspension_core::wheel::{CarrierRotation, Kingpin, Wheel};
use suspension_core::{
    Bounded, Build, Inputs, Linkage, Listing, Motion, Newton, Real, Signal, Still, Tangent,
    Tracker, assemble,
};
use suspension_lanes::{Instructions, Lane, Lanes};

use crate::counting::{Counting, allocations};
use crate::support;

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// The result of `work`, which must not allocate.
fn without_allocating<R>(what: &str, work: impl FnOnce() -> R) -> R {
    let before = allocations();
    let result = black_box(work());
    let made = allocations() - before;
    assert_eq!(made, 0, "{what} allocates");
    result
}

/// A linkage, a rough guess of its first configuration, and its inputs by time.
struct Case<T, L: Build<15, Scalar = T>> {
    model: L,
    rough: L::Points,
    inputs: fn(T) -> Inputs<Still, L::Drives>,
}

impl<T, L> Case<T, L>
where
    T: Real,
    L: Build<15, Scalar = T, Points: HasKingpin<T> + HasWheel<T>>
        + Linkage<15, Listing: Listing<15, Model<T> = L>>
        + Copy,
{
    fn check(&self) {
        let q = self.first_configuration();
        self.certificate(&q);
        let motion = self.motion(q);
        self.readings(&motion);
        self.moving_chassis(&motion);
        self.failures(&motion);
        self.curves(q);
    }

    fn first_configuration(&self) -> SVector<T, 15> {
        let mut q = self.model.unknowns(&self.rough);
        let inputs = (self.inputs)(T::zero());
        without_allocating("assemble", || {
            assemble(&Newton::from_afar(), &self.model, &inputs, &mut q)
        })
        .expect("assembles");
        q
    }

    fn certificate(&self, q: &SVector<T, 15>) {
        let certifier = without_allocating("Certifier", || Certifier::new(&self.model));
        for (t, is_root) in [(0.0, true), (0.1, false), (f64::NAN, false)] {
            let inputs = (self.inputs)(T::constant(t));
            let certificate = without_allocating("certify", || certifier.certify(&inputs, q));
            assert_eq!(certificate.is_proved(), is_root);
        }
    }

    fn motion(&self, mut q: SVector<T, 15>) -> Motion<T, 15> {
        let dt = T::constant(0.001);
        let inputs = (self.inputs)(dt);
        without_allocating("Newton::solve", || {
            Newton::near_by().solve(&self.model, &inputs, &mut q)
        })
        .expect("a root near by");
        let mut motion = Motion::at_rest(q);
        without_allocating("Tangent", || {
            let tangent = Tangent::new(&self.model, &inputs, &motion.position)?;
            motion.velocity = tangent.velocity();
            motion.acceleration = tangent.acceleration(&motion.velocity);
            Ok::<_, suspension_core::SolveError<T>>(())
        })
        .expect("regular");
        let tracker = Tracker::default();
        let next = (self.inputs)(dt + dt);
        without_allocating("Tracker::step", || {
            tracker.step(&self.model, &next, dt, &mut motion)
        })
        .expect("a regular motion");
        without_allocating("Bounded::step", || {
            let inputs = (self.inputs)(dt + dt + dt);
            Bounded::<T>::default().step(&self.model, &inputs, dt, &mut motion.clone())
        })
        .expect("a regular motion");
        without_allocating("Tracker::advance", || {
            let end = T::constant(0.5);
            tracker.advance(&self.model, self.inputs, dt + dt, end, &mut motion)
        })
        .expect("a regular motion");
        without_allocating("SeriesTracker::step", || {
            let ahead: Jet<_, 6> = Jet::of_signal(&(self.inputs)(T::constant(0.5)).drives);
            let tracker = SeriesTracker::within(T::constant(1e-5));
            tracker.step(
                &self.model,
                &InputSeries::still(ahead),
                dt,
                &mut motion.clone(),
            )
        })
        .expect("a regular motion");
        motion
    }

    fn readings(&self, motion: &Motion<T, 15>) {
        let inputs = (self.inputs)(T::constant(0.5));
        let points = without_allocating("points", || motion.points(&self.model, &inputs));
        without_allocating("Wheel", || Wheel::of(points.value.wheel())).expect("a spin axis");
        without_allocating("Wheel::with_rates", || {
            Wheel::with_rates(&points.map(HasWheel::wheel))
        })
        .expect("a spin axis");
        without_allocating("Kingpin", || {
            Kingpin::of(points.value.kingpin(), points.value.wheel())
        });
        without_allocating("CarrierRotation", || {
            CarrierRotation::of(&points.map(|points| points.carrier()))
        })
        .expect("a rigid carrier");
    }

    fn moving_chassis(&self, motion: &Motion<T, 15>) {
        let chassis = RigidMotion {
            pose: Isometry3::identity(),
            velocity: Vector3::x(),
            omega: Vector3::zeros(),
            acceleration: Vector3::zeros(),
            alpha: Vector3::z(),
        };
        let drives = (self.inputs)(T::constant(0.501)).drives;
        let mut motion = *motion;
        without_allocating("Tracker::step with a moving chassis", || {
            let chassis = chassis.anchors(self.model.fixed());
            let inputs = Inputs { chassis, drives };
            Tracker::default().step(&self.model, &inputs, T::constant(0.001), &mut motion)
        })
        .expect("a regular motion");
    }

    fn curves(&self, q: SVector<T, 15>) {
        let inputs = (self.inputs)(T::zero());
        let end = without_allocating("Path", || {
            let curve = Curve::new(&self.model, &inputs, 0)?;
            let path = Continuation::default().path(curve, &q, true).ok()?;
            path.last()
        });
        assert!(matches!(end, Some(Ok(_))), "followed to its end");
        let height = |points: &Signal<L::Points>| Signal {
            value: points.value.wheel()[1].z,
            rate: points.rate.wheel()[1].z,
            second_rate: points.second_rate.wheel()[1].z,
        };
        let curve = Curve::new(&self.model, &inputs, 0).expect("a drive");
        let mut led = without_allocating("Led", || Led::at_rest(&curve, &q)).expect("regular");
        let target = height(&led.points(&self.model, &inputs));
        let leader = Leader::default();
        without_allocating("Leader::step", || {
            leader.step(&self.model, &inputs, height, &target, T::zero(), &mut led)
        })
        .expect("where it is");
        without_allocating("Leader::step to where it turns", || {
            let beyond = Signal {
                value: target.value + T::constant(0.04),
                ..target
            };
            leader.step(&self.model, &inputs, height, &beyond, T::one(), &mut led)
        })
        .expect_err("the wheel rises no higher");
    }

    fn failures(&self, motion: &Motion<T, 15>) {
        let mut motion = *motion;
        let nowhere = (self.inputs)(T::constant(f64::NAN));
        let (model, dt) = (&self.model, T::constant(0.001));
        without_allocating("a solve that is not finite", || {
            Newton::near_by().solve(model, &nowhere, &mut motion.position)
        })
        .expect_err("not finite");
        without_allocating("a step of fixed cost that is not finite", || {
            Bounded::<T>::default().step(model, &nowhere, dt, &mut motion)
        })
        .expect_err("not finite");
        without_allocating("a step of fixed cost that is too long", || {
            let far = (self.inputs)(T::one());
            Bounded::<T>::default().step(model, &far, dt, &mut motion)
        })
        .expect_err("a residual or a correction that is too large");
        let all_in_one = || SVector::repeat(T::one());
        without_allocating("a singular solve", || {
            Newton::from_afar().solve(model, &(self.inputs)(dt), &mut all_in_one())
        })
        .expect_err("singular");
        without_allocating("a singular step of fixed cost", || {
            let mut singular = Motion::at_rest(all_in_one());
            Bounded::<T>::default().step(model, &(self.inputs)(dt), dt, &mut singular)
        })
        .expect_err("singular");
        without_allocating("a singular tangent", || {
            Tangent::new(model, &(self.inputs)(dt), &all_in_one()).map(|_| ())
        })
        .expect_err("singular");
        without_allocating("an assembly that fails", || {
            let impatient = Newton {
                max_iterations: 0,
                ..Newton::from_afar()
            };
            assemble(&impatient, model, &(self.inputs)(dt), &mut motion.position)
        })
        .expect_err("no iterations allowed");
        without_allocating("a series step that is too long", || {
            let ahead: Jet<_, 6> = Jet::of_signal(&(self.inputs)(T::constant(0.5)).drives);
            let tracker = SeriesTracker::within(T::constant(1e-5));
            let far = T::constant(100.0);
            tracker.step(model, &InputSeries::still(ahead), far, &mut motion)
        })
        .expect_err("beyond the radius of convergence");
        without_allocating("an advance that stops", || {
            let far = T::constant(100.0);
            Tracker::default().advance(model, self.inputs, T::constant(0.5), far, &mut motion)
        })
        .expect_err("the end of the travel");
    }
}

/// Four lanes of one linkage: steps of all, and with one that fails, which is then replaced.
fn lanes<T: Lane, G: Listing<15> + 'static>(case: &Case<T, G::Model<T>>)
where
    G::Model<T>: Build<15, Points: HasKingpin<T> + HasWheel<T>>,
{
    let q = case.first_configuration();
    for instructions in [
        Instructions::Plain,
        Instructions::Avx2,
        Instructions::Avx512,
    ] {
        let starts = [Motion::at_rest(q); 4];
        let mut lanes = Lanes::<G, T, 15, 4>::with(instructions, [case.model; 4], &starts);
        let mut drives = [(case.inputs)(T::zero()).drives; 4];
        let results = without_allocating("Lanes::step", || {
            lanes.step(Outputs::Acceleration, &drives, T::zero())
        });
        assert!(results.iter().all(Result::is_ok));
        drives[2] = (case.inputs)(T::constant(f64::NAN)).drives;
        let results = without_allocating("Lanes::step with a lane that fails", || {
            lanes.step(Outputs::Acceleration, &drives, T::zero())
        });
        assert!(results[2].is_err() && results[3].is_ok());
        without_allocating("Lanes::replace", || {
            lanes.replace(2, case.model, &starts[2]);
        });
    }
}

fn attia<T: Real>() -> Case<T, suspension_core::linkages::attia2003::Model<T>> {
    Case {
        model: support::attia_model(),
        rough: support::attia_rough(),
        inputs: support::attia_inputs,
    }
}

fn five_link<T: Real>() -> Case<T, suspension_core::linkages::five_link::Model<T>> {
    Case {
        model: support::five_link_model(),
        rough: support::five_link_rough(),
        inputs: support::five_link_inputs,
    }
}

#[test]
fn solving_attia2003_does_not_allocate() {
    attia::<f64>().check();
    attia::<f32>().check();
}

#[test]
fn solving_five_link_does_not_allocate() {
    five_link::<f64>().check();
    five_link::<f32>().check();
}

#[test]
fn steps_of_lanes_do_not_allocate() {
    use suspension_core::linkages::{attia2003, five_link};
    lanes::<f64, attia2003::Listing>(&attia());
    lanes::<f32, five_link::Listing>(&five_link());
}

#[test]
#[should_panic(expected = "a box allocates")]
fn an_allocation_is_detected() {
    without_allocating("a box", || Box::new(black_box(1.0)));
}
