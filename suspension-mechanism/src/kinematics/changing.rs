//! How a mechanism changes with its hardpoints and lengths.

use nalgebra::{Complex, Vector3};
use suspension_core::factored::Factored;
use suspension_core::motion::Prescribed;
use suspension_core::{Inputs, Signal, Still, Values};

use crate::kinematics::changed::Changes;
use crate::kinematics::varied::{Along, Number, Varied, derivative};
use crate::mechanism::{Mechanism, Points, State, Suspension};

/// The derivatives of a mechanism along a change, where it starts.
pub struct Changing {
    /// The state, with the derivatives along the change as its rates. Second rates are zero.
    pub alone: State,
    /// The state with the rates along the change and a drive together, for each drive; second rates are twice the mixed
    /// derivatives.
    pub with_drives: Vec<State>,
}

/// `None` where no such suspensions can be built, or the mechanism locks where it starts.
pub(super) fn changing<L: Suspension<N>, const N: usize>(
    mechanism: &Mechanism<L, N>,
    changes: &Changes,
) -> Option<Changing> {
    let factored = factored(mechanism)?;
    let varied = Varied::of(mechanism, changes, &factored)?;
    Some(Around::new(mechanism, varied).changing())
}

fn factored<L: Suspension<N>, const N: usize>(
    mechanism: &Mechanism<L, N>,
) -> Option<Factored<L::Factors, f64, N>> {
    let drives = L::Drives::from_values(mechanism.first_drives());
    let inputs: Inputs<Still, _> = Inputs::still(Signal::still(drives));
    let fixed = Prescribed::new(&mechanism.model, &inputs).fixed.value;
    Factored::new(&mechanism.model, &mechanism.start.position, &fixed).ok()
}

/// The varied mechanism about its start.
struct Around<'a, L: Suspension<N>, const N: usize> {
    mechanism: &'a Mechanism<L, N>,
    varied: Varied<'a, L, N>,
    positions: Vec<Vector3<Number>>,
    along: Vec<Along>,
}

/// All points, or rates of theirs, with their derivatives.
type Jet = Signal<Points>;

impl<'a, L: Suspension<N>, const N: usize> Around<'a, L, N> {
    fn new(mechanism: &'a Mechanism<L, N>, varied: Varied<'a, L, N>) -> Self {
        let drives = 0..mechanism.names.drives.len();
        Self {
            mechanism,
            positions: varied.along(&[]).value,
            along: drives.map(|drive| varied.along(&[drive])).collect(),
            varied,
        }
    }

    fn changing(&self) -> Changing {
        let drives = 0..self.along.len();
        let alone = self.state(alone(&self.positions), |of| alone(&self.along[of].rate));
        let with_drive = |drive: usize| {
            let rates = &self.along[drive].rate;
            self.state(together(&self.positions, rates), |of| {
                together(&self.along[of].rate, &self.mixed(of, drive))
            })
        };
        Changing {
            alone,
            with_drives: drives.map(with_drive).collect(),
        }
    }

    /// The mixed second derivative of the points with respect to two drives.
    fn mixed(&self, one: usize, other: usize) -> Vec<Vector3<Number>> {
        let [a, b] = [one, other].map(|drive| &self.along[drive].second_rate);
        if one == other {
            return a.clone();
        }
        let both = self.varied.along(&[one, other]).second_rate;
        let points = both.iter().zip(a.iter().zip(b));
        points
            .map(|(both, (a, b))| (both - a - b) * Complex::from(0.5))
            .collect()
    }

    fn state(&self, points: Jet, velocities: impl Fn(usize) -> Jet) -> State {
        let vehicle = &self.mechanism.names.vehicle;
        let drives = L::Drives::from_values(self.mechanism.first_drives());
        let listed = points.map(|points: &Points| L::Points::from_values(points.iter().copied()));
        let of_drive = |drive| vehicle.is_moved_by(drive).then(|| velocities(drive));
        State {
            velocities: (0..self.along.len()).map(of_drive).collect(),
            ..self.mechanism.state(0.0, &drives, &listed)
        }
    }
}

/// What changes along the change.
fn alone(numbers: &[Vector3<Number>]) -> Jet {
    Signal {
        value: numbers.iter().map(|number| number.map(|x| x.re)).collect(),
        rate: numbers
            .iter()
            .map(|number| number.map(derivative))
            .collect(),
        second_rate: numbers.iter().map(|_| Vector3::zeros()).collect(),
    }
}

/// The same along the change and a drive together.
fn together(numbers: &[Vector3<Number>], per_drive: &[Vector3<Number>]) -> Jet {
    let alone = alone(numbers);
    let rates = alone.rate.iter().zip(per_drive);
    Signal {
        rate: rates
            .map(|(rate, per_drive)| rate + per_drive.map(|x| x.re))
            .collect(),
        second_rate: per_drive
            .iter()
            .map(|mixed| mixed.map(derivative) * 2.0)
            .collect(),
        ..alone
    }
}
