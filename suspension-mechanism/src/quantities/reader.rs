//! The reader of the quantities of one state.

pub(super) mod axle_in_roll;
pub(super) mod iso_positions;
pub(super) mod opposite_wheel;
pub(super) mod two_drives;
pub(super) mod wheel;

use std::cell::OnceCell;
use std::ops::Deref;

use suspension_core::Signal;
use suspension_core::wheel::SteeringAxis;

use crate::mechanism::{Positions, State};
use crate::quantities::number::Number;
use crate::quantities::reader::axle_in_roll::InRoll;
use crate::quantities::reader::iso_positions::IsoPositions;
use crate::quantities::reader::opposite_wheel::OppositeWheel;
use crate::quantities::reader::two_drives::{combined, rates};
use crate::quantities::reader::wheel::{CarrierMotion, MovingWheel, Rolling, Wheel, carrier};

/// Reads quantities of one state of a mechanism. Values that several of them need are computed once. It can be read
/// as the [`State`].
pub struct Reader<'a, N = Signal<f64>> {
    pub(super) positions: IsoPositions<'a, N>,
    first: Cells<N>,
}

/// The values computed for a wheel, and for the wheels after it.
struct Cells<N> {
    wheel: OnceCell<Wheel<N>>,
    /// The wheel at the design position.
    design: OnceCell<Option<Wheel<N>>>,
    kingpin: OnceCell<Option<SteeringAxis<N>>>,
    travel: OnceCell<Option<MovingWheel<N>>>,
    heave: OnceCell<Option<MovingWheel<N>>>,
    steer: OnceCell<Option<MovingWheel<N>>>,
    /// The axle in roll, stored for its left wheel.
    in_roll: OnceCell<Option<InRoll<N>>>,
    next: OnceCell<Box<Cells<N>>>,
}

impl<N> Default for Cells<N> {
    fn default() -> Self {
        Self {
            wheel: OnceCell::new(),
            design: OnceCell::new(),
            kingpin: OnceCell::new(),
            travel: OnceCell::new(),
            heave: OnceCell::new(),
            steer: OnceCell::new(),
            in_roll: OnceCell::new(),
            next: OnceCell::new(),
        }
    }
}

impl<'a> Reader<'a, Signal<f64>> {
    /// Reads a state, with the derivatives along its rates.
    pub fn new(state: &'a State) -> Self {
        Self::with_numbers(state, state)
    }
}

impl<'a, N: Number> Reader<'a, N> {
    /// Reads a state with what its positions determine in numbers of this type.
    pub(crate) fn with_numbers(state: &'a State, numbers: &'a dyn Positions<N>) -> Self {
        Self {
            positions: IsoPositions { state, numbers },
            first: Cells::default(),
        }
    }

    pub(super) fn wheel(&self, rolling: Rolling) -> &Wheel<N> {
        let wheel = &self.cells(rolling).wheel;
        wheel.get_or_init(|| Wheel::read(&self.positions, rolling))
    }

    /// The wheel at the design position, if that is known.
    pub(super) fn at_design(&self, rolling: Rolling) -> Option<&Wheel<N>> {
        let design = &self.cells(rolling).design;
        let of_design = || Wheel::at_design(&self.positions, rolling);
        design.get_or_init(of_design).as_ref()
    }

    /// Its kingpin, if the listing states one.
    pub(super) fn kingpin(&self, rolling: Rolling) -> Option<&SteeringAxis<N>> {
        let kingpin = &self.cells(rolling).kingpin;
        let through = || {
            let ends = rolling.points.kingpin?;
            Some(SteeringAxis::through(
                ends.map(|end| self.positions.at(end)),
            ))
        };
        kingpin.get_or_init(through).as_ref()
    }

    /// Its carrier in motion.
    pub(super) fn moving(
        &self,
        motion: CarrierMotion,
        rolling: Rolling,
    ) -> Option<&MovingWheel<N>> {
        let cells = self.cells(rolling);
        let (cell, both) = match (motion, rolling.heaved()) {
            (CarrierMotion::Steer, _) => (&cells.steer, None),
            (CarrierMotion::SideView, Some(heaved)) => (&cells.heave, Some((heaved, [1.0, 1.0]))),
            _ => (&cells.travel, rolling.held().map(|held| (held, [1.0, 0.0]))),
        };
        let moving = || match both {
            Some((beside, at)) => self.moved_by_both(rolling, beside, at),
            None => self.moved_by(rolling.drive(motion)?, rolling),
        };
        cell.get_or_init(moving).as_ref()
    }

    /// A wheel when its drive and that of the wheel beside it move it, so that their centres rise at the rates `at`.
    fn moved_by_both(
        &self,
        rolling: Rolling,
        beside: &OppositeWheel,
        at: [f64; 2],
    ) -> Option<MovingWheel<N>> {
        let [one, other] = [rolling.travel?, beside.travel];
        let own = [self.moved_by(one, rolling)?, self.moved_by(other, rolling)?];
        let carrier_beside = |drive| carrier(&self.positions, drive, beside.points);
        let rises = [
            own.each_ref().map(|by| by.carrier.velocity.z),
            [carrier_beside(one)?, carrier_beside(other)?].map(|by| by.velocity.z),
        ];
        let carrier = combined(&own, rates(rises, at));
        let [moving, _] = own;
        Some(moving.with(carrier))
    }

    /// The wheel when any drive of travel or steering moves it, computed anew.
    pub(super) fn moved_by(&self, drive: usize, rolling: Rolling) -> Option<MovingWheel<N>> {
        MovingWheel::compute(&self.positions, drive, rolling.points, self.wheel(rolling))
    }

    /// An axle in roll, from its left wheel and its right one.
    pub(super) fn in_roll(&self, axle: [Rolling; 2]) -> Option<&InRoll<N>> {
        let [left, _] = axle;
        let wheels = axle.map(|rolling| (rolling, self.wheel(rolling)));
        let in_roll = || InRoll::compute(wheels, |rolling, drive| self.moved_by(drive, rolling));
        self.cells(left).in_roll.get_or_init(in_roll).as_ref()
    }

    fn cells(&self, rolling: Rolling) -> &Cells<N> {
        let mut cells = &self.first;
        for _ in 0..rolling.number {
            cells = cells.next.get_or_init(Box::default);
        }
        cells
    }
}

impl<N> Deref for Reader<'_, N> {
    type Target = State;

    fn deref(&self) -> &State {
        self.positions.state
    }
}
