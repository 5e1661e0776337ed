//! What a lane holds: its model and its motion.

use std::array;
use std::fmt;

use suspension_core::{Listing, Motion};

use crate::{Lane, Lanes};

impl<G, T, const N: usize, const LANES: usize, const CORRECTIONS: usize, const ORDER: usize>
    Lanes<G, T, N, LANES, CORRECTIONS, ORDER>
where
    G: Listing<N>,
    T: Lane,
{
    /// The model of a lane.
    ///
    /// # Panics
    ///
    /// If there is no such lane.
    pub fn model(&self, lane: usize) -> &G::Model<T> {
        &self.models[lane]
    }

    /// The motion of a lane.
    ///
    /// # Panics
    ///
    /// If there is no such lane.
    pub fn motion(&self, lane: usize) -> Motion<T, N> {
        Motion {
            positive_determinant: self.signs[lane],
            ..self.engine.motion(lane)
        }
    }

    /// Sets the motion of a lane, for example to bring it back among the others after
    /// [`Tracker::step_between`](suspension_core::Tracker::step_between) has led its own motion through the step that
    /// it was refused. A lane whose drives are not finite should instead step to its last good ones,
    /// [`Signal::still`](suspension_core::Signal::still).
    ///
    /// ```
    /// use suspension_core::linkages::double_wishbone::{Corner, Drives, Listing};
    /// use suspension_core::step::bounded::Outputs;
    /// use suspension_core::{Inputs, Signal, Tracker};
    /// use suspension_lanes::Lanes;
    ///
    /// let corner: Corner = Corner::design()?;
    /// let (start, rate) = (corner.drives(), Drives { bump: 0.5, steer: 0.0 });
    /// let drives = |tick| {
    ///     let mut drives = [Signal::line(start, rate, 1e-3 * f64::from(tick)); 4];
    ///     drives[2].value.bump += if tick < 10 { 0.0 } else { 0.03 }; // a jump of 30 mm
    ///     drives
    /// };
    /// let mut lanes = Lanes::<Listing, f64, _, 4>::new([*corner.model(); 4], &[*corner.motion(); 4]);
    /// assert!(lanes.step(Outputs::Acceleration, &drives(0), 0.0).iter().all(Result::is_ok));
    /// let mut refused = 0;
    /// for tick in 1..=20 {
    ///     let results = lanes.step(Outputs::Acceleration, &drives(tick), 1e-3);
    ///     for (lane, _) in results.iter().enumerate().filter(|(_, result)| result.is_err()) {
    ///         // In the same tick, from the drives of the last one, in sub-steps.
    ///         let ends = [tick - 1, tick].map(|tick| Inputs::still(drives(tick)[lane]));
    ///         let mut motion = lanes.motion(lane);
    ///         Tracker::default().step_between(lanes.model(lane), ends.each_ref(), 1e-3, &mut motion)?;
    ///         lanes.set_motion(lane, &motion);
    ///         refused += 1;
    ///     }
    /// }
    /// assert_eq!(refused, 1);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Panics
    ///
    /// If there is no such lane.
    pub fn set_motion(&mut self, lane: usize, motion: &Motion<T, N>) {
        self.signs[lane] = motion.positive_determinant;
        self.engine.set_motion(lane, motion);
    }

    /// Replaces the model of a lane, for example by one with other hardpoints, and its motion by one of the new model, which
    /// must be at the present drives. The other lanes are not affected. Nothing allocates.
    ///
    /// ```
    /// use suspension_core::linkage::Designed;
    /// use suspension_core::linkages::double_wishbone::{Corner, Drives, Listing, Model};
    /// use suspension_core::step::bounded::Outputs;
    /// use suspension_core::Signal;
    /// use suspension_lanes::Lanes;
    ///
    /// let corner: Corner = Corner::design()?;
    /// let (start, rate) = (corner.drives(), Drives { bump: 0.5, steer: 0.0 });
    /// let drives = |tick| [Signal::line(start, rate, 1e-3 * f64::from(tick)); 4];
    /// let mut lanes = Lanes::<Listing, f64, _, 4>::new([*corner.model(); 4], &[*corner.motion(); 4]);
    /// assert!(lanes.step(Outputs::Acceleration, &drives(0), 0.0).iter().all(Result::is_ok));
    ///
    /// let mut hardpoints = Model::design();
    /// hardpoints.rack.z += 0.005;
    /// for tick in 1..=20 {
    ///     for result in lanes.step(Outputs::Acceleration, &drives(tick), 1e-3) {
    ///         result?;
    ///     }
    ///     if tick == 10 {
    ///         let mut changed: Corner = Corner::new(&hardpoints)?;
    ///         changed.step(1e-3, drives(tick)[2])?;
    ///         lanes.replace(2, *changed.model(), changed.motion());
    ///     }
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Panics
    ///
    /// If there is no such lane.
    pub fn replace(&mut self, lane: usize, model: G::Model<T>, motion: &Motion<T, N>) {
        self.models[lane] = model;
        self.engine.set_models(self.models.each_ref());
        self.set_motion(lane, motion);
    }
}

/// Writes the settings, and the model and the motion of each lane.
impl<G, T, const N: usize, const LANES: usize, const CORRECTIONS: usize, const ORDER: usize>
    fmt::Debug for Lanes<G, T, N, LANES, CORRECTIONS, ORDER>
where
    G: Listing<N, Model<T>: fmt::Debug>,
    T: Lane,
{
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let motions: [_; LANES] = array::from_fn(|lane| self.motion(lane));
        f.debug_struct("Lanes")
            .field("settings", &self.settings)
            .field("models", &self.models)
            .field("motions", &motions)
            .finish()
    }
}
