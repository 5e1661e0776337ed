//! A scene of 40 cars at 1 kHz: one detail for all corners, or for each car the detail that it needs.
//!
//! The player's car is exact, acceleration included. The rest need 0.1 mm and no acceleration; how
//! they are computed is chosen from measured figures (`suspension::level_of_detail`).
//!
//! `cargo run --profile bench --example scene`

use std::error::Error;
use std::time::{Duration, Instant};

use nalgebra::Vector3;
use suspension::bake::{Baked, Continuity, Path, RequestedPoints, TERMS, Wanted, bake};
use suspension::level_of_detail::{self, Detail, Method, Need, Outputs, choose};
use suspension_core::baked::Curve;
use suspension_core::{Bounded, Build, Inputs, Linkage, Motion, Signal, Tracker, linkage};

linkage! {
    /// Front-left double wishbone. Axes of ISO 8855.
    mod double_wishbone {
        fixed: lower_front at [0.20, 0.35, 0.16], lower_rear at [-0.20, 0.35, 0.16],
               upper_front at [0.15, 0.42, 0.42], upper_rear at [-0.15, 0.42, 0.42],
               rack at [0.11, 0.34, 0.20];
        free:  lower_ball at [0.005, 0.70, 0.17], upper_ball at [-0.015, 0.66, 0.44],
               tie_ball at [0.12, 0.68, 0.21], axle_inner at [0.0, 0.65, 0.30],
               axle_outer at [0.0, 0.75, 0.30];

        link lower_fore: lower_front -> lower_ball;
        link lower_aft:  lower_rear  -> lower_ball;
        link upper_fore: upper_front -> upper_ball;
        link upper_aft:  upper_rear  -> upper_ball;
        link tie_rod:    rack        -> tie_ball;
        body upright:    lower_ball, upper_ball, tie_ball, axle_inner, axle_outer;

        drive bump:  axle_outer.z;
        drive steer: rack.y;

        wheel:   axle_inner -> axle_outer;
        kingpin: lower_ball -> upper_ball;
    }
}
use double_wishbone::{Drives, Model, Points};

const CORNERS: usize = 4 * 40;
const PLAYERS: usize = 4;
const TICKS: usize = 2000;
const STEP: f64 = 1e-3;
/// Travel of a wheel up and down, m.
const TRAVEL: f64 = 0.08;

/// The results of a corner: the wheel centre and its velocity.
type Read = [Vector3<f64>; 2];

/// The computation of a corner. More methods are more variants.
#[derive(Clone)]
enum Corner<'a> {
    Exact(Box<Motion<f64, 15>>),
    Bounded(Box<Motion<f64, 15>>),
    Baked(Curve<'a, f64, 6, TERMS>),
}

impl Corner<'_> {
    fn tick(
        &mut self,
        model: &Model<f64>,
        drives: &Signal<Drives<f64>>,
    ) -> Result<Read, Box<dyn Error>> {
        match self {
            Self::Exact(motion) => {
                let inputs = Inputs::still(*drives);
                Tracker::default().step(model, &inputs, STEP, motion)?;
                let points = motion.points(model, &inputs);
                Ok([points.value.axle_outer, points.rate.axle_outer])
            }
            Self::Bounded(motion) => {
                let inputs = Inputs::still(*drives);
                let step = Bounded::<f64>::default();
                step.step_to(Outputs::Velocity, model, &inputs, STEP, motion)?;
                let points = motion.points(model, &inputs);
                Ok([points.value.axle_outer, points.rate.axle_outer])
            }
            Self::Baked(curve) => {
                let outputs = curve.at(drives.value.bump)?.velocity(drives.rate.bump);
                Ok(outputs.map(|[x, y, z, ..]| Vector3::new(x, y, z)))
            }
        }
    }
}

/// The scene: one geometry, and a different road under each wheel.
struct Scene {
    model: Model<f64>,
    design: Points<f64>,
}

impl Scene {
    fn new() -> Result<Self, Box<dyn Error>> {
        let at = Vector3::new;
        let design = Points {
            lower_front: at(0.20, 0.35, 0.16),
            lower_rear: at(-0.20, 0.35, 0.16),
            upper_front: at(0.15, 0.42, 0.42),
            upper_rear: at(-0.15, 0.42, 0.42),
            rack: at(0.11, 0.34, 0.20),
            lower_ball: at(0.005, 0.70, 0.17),
            upper_ball: at(-0.015, 0.66, 0.44),
            tie_ball: at(0.12, 0.68, 0.21),
            axle_inner: at(0.0, 0.65, 0.30),
            axle_outer: at(0.0, 0.75, 0.30),
        };
        let model = Model::new(&design)?;
        Ok(Self { model, design })
    }

    fn start(&self) -> Motion<f64, 15> {
        Motion::at_rest(self.model.unknowns(&self.design))
    }

    /// Waves under the wheels, each at its own pace, from the design position.
    fn drives(&self, corner: usize, tick: usize) -> Signal<Drives<f64>> {
        let pace = 4.0 + 0.2 * corner as f64;
        let phase = pace * STEP * tick as f64;
        let bump = |bump: f64| Drives { bump, steer: 0.0 };
        let straight = self.model.drives_at(&self.design);
        Signal {
            value: Drives {
                bump: straight.bump + 0.9 * TRAVEL * phase.sin(),
                ..straight
            },
            rate: bump(0.9 * TRAVEL * pace * phase.cos()),
            second_rate: bump(-0.9 * TRAVEL * pace * pace * phase.sin()),
        }
    }

    /// Returns the median time of a tick, and the results of all ticks.
    fn run(&self, corners: &[Corner<'_>]) -> Result<(Duration, Vec<Read>), Box<dyn Error>> {
        let mut corners = corners.to_vec();
        let (mut times, mut read) = (Vec::new(), Vec::new());
        for tick in 0..TICKS {
            let drives: Vec<_> = (0..CORNERS)
                .map(|corner| self.drives(corner, tick))
                .collect();
            let mut wheels = [Read::default(); CORNERS];
            let began = Instant::now();
            for ((corner, drives), wheel) in corners.iter_mut().zip(&drives).zip(&mut wheels) {
                *wheel = corner.tick(&self.model, drives)?;
            }
            times.push(began.elapsed());
            read.extend(wheels);
        }
        times.sort_unstable();
        Ok((times[TICKS / 2], read))
    }

    /// The wheel's motion to a tolerance.
    fn bake(&self, tolerance: f64) -> Result<Baked, Box<dyn Error>> {
        let straight = self.model.drives_at(&self.design);
        let range = [straight.bump - TRAVEL, straight.bump + TRAVEL];
        let wanted = Wanted {
            range,
            tolerance,
            metre: 1.0,
            continuity: Continuity::Velocity,
        };
        let path = Path::new(
            &self.model,
            &self.start(),
            straight,
            0,
            range,
            RequestedPoints::Wheel(0),
        )?;
        Ok(bake(&wanted, &path)?)
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let scene = Scene::new()?;
    let need = Need {
        tolerance: 1e-4,
        outputs: Outputs::Velocity,
        points: level_of_detail::Points::Wheel,
        step: STEP,
    };
    let Detail { method, .. } = choose(&need).ok_or("no method meets the need")?;
    let exact = Corner::Exact(Box::new(scene.start()));
    let table;
    let others = match method {
        Method::Baked { tolerance } => {
            let baked = scene.bake(tolerance)?;
            table = baked.table().ok_or("a wheel has six outputs")?;
            Corner::Baked(baked.curve(&table))
        }
        Method::Exact => exact.clone(),
        Method::Bounded { corrections: 1 } => Corner::Bounded(Box::new(scene.start())),
        other => return Err(format!("this scene has no corners of method {other}").into()),
    };
    let mut chosen = vec![exact.clone(); PLAYERS];
    chosen.resize(CORNERS, others);

    let (all_exact, truth) = scene.run(&vec![exact; CORNERS])?;
    let (with_chosen, read) = scene.run(&chosen)?;
    let mut worst = [0.0_f64; 2];
    for (found, exact) in read.iter().zip(&truth) {
        for (order, worst) in worst.iter_mut().enumerate() {
            *worst = worst.max((found[order] - exact[order]).norm());
        }
    }
    println!("{CORNERS} corners, {TICKS} ticks of {STEP} s; {method} for all but the player's car");
    println!("all exact:  {all_exact:>10.1?} a tick");
    println!(
        "as chosen:  {with_chosen:>10.1?} a tick, {:.1} times faster",
        all_exact.as_secs_f64() / with_chosen.as_secs_f64()
    );
    println!("error made: {:.2e} m, {:.2e} m/s", worst[0], worst[1]);
    Ok(())
}
