//! How a mechanism changes with its hardpoints and lengths.

use nalgebra::{Complex, Vector3};
use suspension_core::factored::Factored;
use suspension_core::motion::Prescribed;
use suspension_core::{Inputs, Signal, Still, Values};

use crate::kinematics::changed::{Changes, points};
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

/// How a mechanism changes, where it starts.
pub type Change<'a> = dyn Fn(&Changes) -> Option<Changing> + 'a;

/// `None` where the mechanism locks where it starts.
pub(super) fn changing<L: Suspension<N>, const N: usize>(
    mechanism: &Mechanism<L, N>,
) -> Option<Box<Change<'_>>> {
    let points = points(mechanism);
    let drives = L::Drives::from_values(mechanism.first_drives());
    let inputs: Inputs<Still, _> = Inputs::still(Signal::still(drives));
    let fixed = Prescribed::new(&mechanism.model, &inputs).fixed.value;
    let factored = Factored::new(&mechanism.model, &mechanism.start.position, &fixed).ok()?;
    Some(Box::new(move |changes| {
        let varied = Varied::of(mechanism, &points, changes, factored.factors())?;
        Some(Around::new(mechanism, &varied).changing())
    }))
}

/// The varied mechanism about its start.
struct Around<'a, L, const N: usize> {
    mechanism: &'a Mechanism<L, N>,
    /// Along each drive, and along each pair of them, a row for each drive, up to itself.
    along: Vec<Along>,
}

/// All points, or rates of theirs, with their derivatives.
type Jet = Signal<Points>;

impl<'a, L: Suspension<N>, const N: usize> Around<'a, L, N> {
    fn new(mechanism: &'a Mechanism<L, N>, varied: &Varied<'_, L, N>) -> Self {
        let drives = 0..mechanism.names.drives.len();
        let pairs = drives.flat_map(|other| (0..=other).map(move |one| [one, other]));
        Self {
            mechanism,
            along: pairs.map(|pair| varied.along(pair)).collect(),
        }
    }

    fn of(&self, one: usize, other: usize) -> &Along {
        let (one, other) = (one.min(other), one.max(other));
        &self.along[other * (other + 1) / 2 + one]
    }

    fn changing(&self) -> Changing {
        let drives = 0..self.mechanism.names.drives.len();
        let rates = |drive| &self.of(drive, drive).rate;
        let positions = &self.of(0, 0).value;
        let alone = self.state(alone(positions), |of| alone(rates(of)));
        let with_drive = |drive: usize| {
            self.state(together(positions, rates(drive)), |of| {
                together(rates(of), &self.mixed(of, drive))
            })
        };
        Changing {
            alone,
            with_drives: drives.map(with_drive).collect(),
        }
    }

    /// The mixed second derivative of the points with respect to two drives.
    fn mixed(&self, one: usize, other: usize) -> Vec<Vector3<Number>> {
        let both = &self.of(one, other).second_rate;
        if one == other {
            return both.clone();
        }
        let [a, b] = [one, other].map(|drive| &self.of(drive, drive).second_rate);
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
            velocities: (0..self.mechanism.names.drives.len())
                .map(of_drive)
                .collect(),
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
