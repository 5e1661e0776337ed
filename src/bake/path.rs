//! The exact motion as a function of one drive.

use nalgebra::Vector3;
use suspension_core::{
    Build, HasWheel, Inputs, Linkage, Motion, Named, Signal, SolveError, Still, Stopped, Tracker,
};

/// Which points are wanted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wish {
    /// Every point that the drive moves: free points, markers, driven chassis points.
    AllPoints,
    /// The wheel: its centre and its spin axis.
    Wheel,
}

/// Three coordinates of a curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Output {
    /// A point's position.
    Point(&'static str),
    /// The wheel centre's position.
    WheelCentre,
    /// The spin axis, of unit length, outboard.
    SpinAxis,
}

impl Output {
    /// Its name: a point's, or what it is of the wheel.
    pub fn name(self) -> &'static str {
        match self {
            Self::Point(name) => name,
            Self::WheelCentre => "wheel_centre",
            Self::SpinAxis => "spin_axis",
        }
    }
}

/// A value with its first and second derivative with respect to the drive.
pub type Derivatives = [Vector3<f64>; 3];

/// The mechanism driven by one drive, the others held.
#[derive(Clone, Debug)]
pub struct Path<'a, L: Linkage<N>, const N: usize> {
    model: &'a L,
    held: L::Drives,
    drive: usize,
    wish: Wish,
    /// Configurations evenly over the range, with the drive's value.
    anchors: Vec<(f64, Motion<f64, N>)>,
}

/// The mechanism does not go through the range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutOfReach {
    /// The drive's first and last value towards the range that the mechanism reaches.
    pub reached: [f64; 2],
    /// Why it goes no further.
    pub cause: Option<SolveError<f64>>,
}

impl OutOfReach {
    fn between(from: f64, stopped: &Stopped<f64>) -> Self {
        Self {
            reached: [from, stopped.reached],
            cause: stopped.refused.map(|(_, cause)| cause),
        }
    }
}

/// A motion along a drive, whatever its linkage.
pub trait Exact {
    /// What the outputs are.
    fn outputs(&self) -> Vec<Output>;

    /// The outputs where the drive has the value `at`.
    ///
    /// # Errors
    ///
    /// [`OutOfReach`].
    fn at(&self, at: f64) -> Result<Vec<Derivatives>, OutOfReach>;
}

const ANCHORS: u32 = 65;

impl<'a, L, const N: usize> Path<'a, L, N>
where
    L: Build<N, Scalar = f64, Points: HasWheel<f64>>,
{
    /// The path of drive number `drive` over `range`, with the other drives held at `held`. The
    /// mechanism is driven there from the configuration `start` at `held`.
    ///
    /// # Errors
    ///
    /// [`OutOfReach`] where the mechanism cannot be driven through the range.
    pub fn new(
        model: &'a L,
        start: &Motion<f64, N>,
        held: L::Drives,
        drive: usize,
        range: [f64; 2],
        wish: Wish,
    ) -> Result<Self, OutOfReach> {
        let mut path = Self {
            model,
            held,
            drive,
            wish,
            anchors: Vec::new(),
        };
        let now = held.values().nth(drive).unwrap_or_default();
        // The rates of the start are those of another motion.
        let start = Motion {
            positive_determinant: start.positive_determinant,
            ..Motion::at_rest(start.position)
        };
        let [mut first, mut last] = [start; 2];
        let [from, to] = range;
        let down = path.follow([now, from], &mut first);
        let up = path.follow([now, to], &mut last);
        let limit = |way: Result<(), Stopped<f64>>, end| way.err().map_or(end, |stop| stop.reached);
        if let Some(stopped) = down.and(up).err() {
            return Err(OutOfReach {
                reached: [limit(down, from), limit(up, to)],
                cause: stopped.refused.map(|(_, cause)| cause),
            });
        }
        let (mut at, mut motion) = (from, first);
        for part in 0..ANCHORS {
            let next = from + (to - from) * f64::from(part) / f64::from(ANCHORS - 1);
            let on_the_way = path.follow([at, next], &mut motion);
            on_the_way.map_err(|stopped| OutOfReach::between(at, &stopped))?;
            path.anchors.push((next, motion));
            at = next;
        }
        Ok(path)
    }

    fn follow(
        &self,
        [from, to]: [f64; 2],
        motion: &mut Motion<f64, N>,
    ) -> Result<(), Stopped<f64>> {
        let tracker = Tracker {
            max_steps: 10_000,
            ..Tracker::default()
        };
        let followed = tracker.advance(self.model, |at| self.inputs(at), from, to, motion);
        followed.map(|_| ())
    }

    /// The drive at a value, moving at one unit per unit of "time": rates are derivatives.
    fn inputs(&self, at: f64) -> Inputs<Still, L::Drives> {
        let mut held = self.held.values().enumerate();
        let value = L::Drives::from_fn(|_| match held.next() {
            Some((index, _)) if index == self.drive => at,
            Some((_, held)) => held,
            None => 0.0,
        });
        Inputs::still(Signal {
            value,
            rate: self.unit_rate(),
            second_rate: L::Drives::default(),
        })
    }

    fn unit_rate(&self) -> L::Drives {
        let mut indices = 0..;
        L::Drives::from_fn(|_| f64::from(u8::from(indices.next() == Some(self.drive))))
    }

    /// The numbers of the points that the drive can move.
    fn moved(&self) -> impl Iterator<Item = usize> {
        let driven = L::drive_anchors(L::Fixed::default(), &self.unit_rate());
        let driven: Vec<bool> = driven.values().map(|p| p != Vector3::zeros()).collect();
        let count = <L::Points as Named<Vector3<f64>>>::NAMES.len();
        (0..count).filter(move |point| driven.get(*point).copied().unwrap_or(true))
    }
}

impl<L, const N: usize> Exact for Path<'_, L, N>
where
    L: Build<N, Scalar = f64, Points: HasWheel<f64>>,
{
    fn outputs(&self) -> Vec<Output> {
        match self.wish {
            Wish::Wheel => vec![Output::WheelCentre, Output::SpinAxis],
            Wish::AllPoints => {
                let names = <L::Points as Named<Vector3<f64>>>::NAMES;
                self.moved()
                    .map(|point| Output::Point(names[point]))
                    .collect()
            }
        }
    }

    fn at(&self, at: f64) -> Result<Vec<Derivatives>, OutOfReach> {
        let nearest = self
            .anchors
            .iter()
            .min_by(|(a, _), (b, _)| (a - at).abs().total_cmp(&(b - at).abs()));
        let Some((from, mut motion)) = nearest.copied() else {
            return Ok(Vec::new());
        };
        let followed = self.follow([from, at], &mut motion);
        followed.map_err(|stopped| OutOfReach::between(from, &stopped))?;
        let points = motion.points(self.model, &self.inputs(at));
        let derivatives = [&points.value, &points.rate, &points.second_rate];
        Ok(match self.wish {
            Wish::Wheel => {
                let [inner, centre] = [0, 1].map(|end| derivatives.map(|p| p.wheel()[end]));
                let axis = [0, 1, 2].map(|order| centre[order] - inner[order]);
                // Both points belong to one body: their distance does not change.
                let length = axis[0].norm();
                vec![centre, axis.map(|axis| axis / length)]
            }
            Wish::AllPoints => {
                let each = derivatives.map(|points| points.values().collect::<Vec<_>>());
                self.moved()
                    .map(|point| [0, 1, 2].map(|order| each[order][point]))
                    .collect()
            }
        })
    }
}
