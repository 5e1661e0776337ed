//! One of the two suspensions.

use std::slice;
use std::sync::atomic::AtomicBool;

use crate::characteristics::{
    Curves, Effect, Movement, Parameter, Rise, Rises, Span, check_spans, curves, mode_states,
    parameters, shorter_roll,
};
use crate::failure::Failure;
use crate::file::Source;
use crate::kinematics::Kinematics;
use crate::mechanism::{Pair, Unit, Wheel, listed};
use crate::output::notes::{print_notes, print_unmet_range};
use crate::quantities::{Axis, CENTRE, TOE};

/// The compared results of a suspension, with lengths in the unit of the first.
pub(super) struct Suspension {
    pub(super) file: String,
    pub(super) linkage: String,
    /// From which unit or axes to which the numbers were converted; `None` if they were not.
    pub(super) converted: Option<String>,
    /// The unit of lengths of these results.
    pub(super) unit: Unit,
    /// The purposes of the drives with respect to which the parameters have derivatives.
    pub(super) movements: Vec<Movement>,
    /// The names of these drives.
    drives: Vec<String>,
    /// Whether each of these drives is the height of its wheel.
    is_height: Vec<bool>,
    /// Whether a wheel has no radius, so that quantities at the ground are missing.
    pub(super) lacks_radius: bool,
    /// How far the wheels rise per unit of the drives of travel.
    pub(super) rises: Option<Rises>,
    /// The name of each wheel with the index of its drive of travel in `movements`.
    travel_of: Vec<(String, usize)>,
    /// The name of each axle with the indices of the drives of travel of its wheels.
    axles: Vec<(String, Vec<usize>)>,
    pub(super) parameters: Vec<Parameter>,
    /// Curves over travel, and over steering if a drive steers.
    pub(super) curves: Vec<Curves>,
    /// A sentence on the range of the curves over roll, if that is shorter than the travel.
    pub(super) shorter_roll: Option<String>,
    /// Sentences on curves that could not be solved.
    pub(super) missing: Vec<String>,
    /// The failure to report of them.
    pub(super) failure: Option<Failure>,
}

impl Suspension {
    /// Computes the results of a file's mechanism, with lengths in `unit`; `converted` names the other conversions.
    pub(super) fn compute(
        mechanism: &dyn Kinematics,
        (source, converted): (&Source, Option<String>),
        spans: [Option<Span>; 2],
        unit: Unit,
        interrupted: &AtomicBool,
    ) -> Result<Self, Failure> {
        let file = source.name();
        print_notes(check_spans(mechanism, file, spans, unit)?);
        let modes = mode_states(mechanism, spans, unit, interrupted);
        let missing = modes.iter().filter_map(|mode| mode.visited.failure(file));
        let missing = missing.map(|failure| failure.to_string());
        let curves = modes.iter().map(|mode| curves(mechanism, mode, unit));
        let (movements, drives): (Vec<Movement>, Vec<usize>) =
            Movement::of_drives(&mechanism.names).into_iter().unzip();
        let wheels = &mechanism.names.wheels;
        let place = |wheel: &Wheel| drives.iter().position(|drive| Some(*drive) == wheel.travel);
        let travel_of = wheels.iter();
        let travel_of = travel_of.filter_map(|wheel| Some((wheel.name.clone(), place(wheel)?)));
        let axles = Pair::all(wheels).into_iter().map(|pair| {
            let both = pair.wheels.into_iter();
            let movements = both.filter_map(|wheel| place(&wheels[wheel]));
            (pair.name, movements.collect())
        });
        let named = drives.iter();
        let named = named.map(|drive| mechanism.names.drives[*drive].name.clone());
        let parameters = parameters(mechanism, unit);
        let rises = Rise::of_drives(mechanism, &parameters, unit).into_iter();
        let is_height = rises.map(|rise| rise.is_some_and(|rise| rise.is_height));
        Ok(Self {
            file: file.to_owned(),
            linkage: mechanism.linkage.clone(),
            converted,
            unit,
            lacks_radius: wheels.iter().any(|wheel| wheel.radius.is_none()),
            shorter_roll: shorter_roll(mechanism, spans[0]),
            missing: missing.collect(),
            failure: print_unmet_range(&modes, file),
            rises: Rises::compute(mechanism, &parameters),
            axles: axles.collect(),
            travel_of: travel_of.collect(),
            movements,
            drives: named.collect(),
            is_height: is_height.collect(),
            parameters,
            curves: curves.collect(),
        })
    }

    pub(super) fn steers(&self) -> bool {
        self.steer_movement().is_some()
    }

    /// Returns the index of the drive that steers in `movements`, if there is one.
    fn steer_movement(&self) -> Option<usize> {
        let mut movements = self.movements.iter();
        movements.position(|movement| movement.effect == Effect::Steer)
    }

    /// Returns whether steering keeps the wheel centres at their height; `None` if no drive steers.
    pub(super) fn keeps_height_in_steering(&self) -> Option<bool> {
        /// Per unit of the drive.
        const ROUNDING: f64 = 1e-9;
        let steer = self.steer_movement()?;
        let heights = self
            .parameters
            .iter()
            .filter(|parameter| parameter.is(&CENTRE, Axis::Z));
        let rates: Option<Vec<f64>> = heights
            .map(|height| Some(height.per[steer].as_ref()?.value))
            .collect();
        Some(rates?.iter().all(|rate| rate.abs() < ROUNDING))
    }

    /// Returns the drive of steering, and how fast it turns all wheels together towards positive y; `None` if no drive
    /// steers.
    pub(super) fn steering(&self) -> Option<(&str, f64)> {
        let steer = self.steer_movement()?;
        let of_wheel = |toe: &Parameter| {
            let mut others = self.parameters.iter().filter(|of| of.is(&CENTRE, Axis::Y));
            let centre = others.find(|centre| centre.title.wheel == toe.title.wheel)?;
            // Toe is positive inboard.
            Some(-toe.per[steer].as_ref()?.value * centre.value.signum())
        };
        let toes = self.parameters.iter();
        let toes = toes.filter(|parameter| *parameter.quantity == TOE);
        Some((&self.drives[steer], toes.filter_map(of_wheel).sum()))
    }

    /// Returns the index of the drive with the same purpose in another suspension: for travel of a wheel whose name both
    /// have, the drive of that wheel.
    pub(super) fn same_movement(&self, other: &Self, movement: usize) -> Option<usize> {
        let place_of = |side: &Self, name: &str| {
            let mut wheels = side.travel_of.iter();
            wheels
                .find(|(wheel, _)| wheel == name)
                .map(|(_, place)| *place)
        };
        let mut wheels = self.travel_of.iter();
        let share_names = wheels
            .clone()
            .any(|(wheel, _)| place_of(other, wheel).is_some());
        match wheels.find(|(_, place)| *place == movement) {
            Some((wheel, _)) if share_names => place_of(other, wheel),
            _ => other
                .movements
                .iter()
                .position(|theirs| *theirs == self.movements[movement]),
        }
    }

    /// Returns the drive of travel of the wheel or axle `name` in place of the drive `movement`: its own, or for an axle the one on
    /// the same side.
    pub(super) fn own_movement(&self, movement: usize, name: &str) -> usize {
        let Movement {
            effect: Effect::Travel,
            number,
        } = self.movements[movement]
        else {
            return movement;
        };
        let wheel = self.travel_of.iter().find(|(wheel, _)| wheel == name);
        let wheel = wheel.map(|(_, place)| slice::from_ref(place));
        let axle = || self.axles.iter().find(|(axle, _)| axle == name);
        let own = wheel.or_else(|| axle().map(|(_, places)| places.as_slice()));
        match own {
            Some(own) if !own.contains(&movement) => own
                .get(number - 1)
                .or(own.last())
                .copied()
                .unwrap_or(movement),
            _ => movement,
        }
    }

    /// Names the movement of a drive: the travel of its wheels if the derivatives are by wheel or the drive is their height,
    /// counted upwards, otherwise its own change. In a comparison with a suspension whose wheel has no name each wheel moves by its own drive.
    pub(super) fn moved(&self, movement: usize, other: &Self, by_wheel: bool) -> String {
        let drive = &self.drives[movement];
        let own = self.travel_of.iter().filter(|(_, own)| *own == movement);
        let names: Vec<String> = own.map(|(wheel, _)| wheel.replace('_', " ")).collect();
        let is_travel = by_wheel || self.is_height[movement] && self.is_upwards(movement);
        let wheels = match names.as_slice() {
            [] => return format!("change of {drive}"),
            [name] if name.is_empty() => "the wheel".to_owned(),
            _ if !other.names_wheels() && is_travel => "each wheel by its own drive".to_owned(),
            _ if !other.names_wheels() => return "change of each wheel's own drive".to_owned(),
            [name] => format!("the {name} wheel"),
            _ => format!("the {} wheels", listed(names)),
        };
        if is_travel {
            format!("travel of {wheels}")
        } else {
            format!("change of {drive} at {wheels}")
        }
    }

    /// Returns whether a drive of travel grows as its wheel rises.
    fn is_upwards(&self, movement: usize) -> bool {
        let rises = self.rises.as_ref();
        rises.is_none_or(|rises| rises.rise(movement, movement) > 0.0)
    }

    /// Returns whether a wheel with a drive of travel has a name.
    fn names_wheels(&self) -> bool {
        self.travel_of.iter().any(|(wheel, _)| !wheel.is_empty())
    }

    /// Pairs the wheels of drives of travel with those of another suspension, by index; `None` for a wheel that the other
    /// one lacks.
    pub(super) fn pair_wheels(&self, other: &Self) -> Vec<[Option<usize>; 2]> {
        let travels = |side: &Self| {
            let movements = side.movements.iter();
            movements
                .filter(|movement| movement.effect == Effect::Travel)
                .count()
        };
        let own = (0..travels(self))
            .map(|movement| [Some(movement), self.same_movement(other, movement)]);
        let theirs =
            (0..travels(other)).filter(|movement| other.same_movement(self, *movement).is_none());
        own.chain(theirs.map(|movement| [None, Some(movement)]))
            .collect()
    }
}
