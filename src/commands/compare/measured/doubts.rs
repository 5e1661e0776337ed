//! Numbers of columns that lead which may not be what the heading says.

use super::heading::Stated;
use crate::grid::doubt_of_option;
use crate::kinematics::Kinematics;
use crate::mechanism::{CountedFrom, Length, ends, extent};
use crate::number::number;
use crate::quantities::WHEEL_TRAVEL;

/// Returns a sentence if numbers of a drive seem to be in another unit, or counted otherwise.
pub(super) fn doubt(
    mechanism: &dyn Kinematics,
    stated: &Stated,
    numbers: &[f64],
    from: CountedFrom,
) -> Option<String> {
    /// The most that a rig lets a drive move which it holds away from the design position, as a part of the distance: such a
    /// small motion tells nothing of the unit.
    const HELD: f64 = 0.05;
    let (drive, _) = *stated.named.drives.first()?;
    let [least, greatest] = ends(numbers.iter().copied())?;
    let is_small = greatest - least < HELD * least.abs().max(greatest.abs());
    let is_held = from == CountedFrom::Start && is_small;
    let ends = [if is_held { greatest } else { least }, greatest];
    doubt_of_option(mechanism, drive, (ends, stated.unit), from)
}

/// Returns a sentence if numbers of wheel travel seem to be in another unit, or heights of the wheel centre.
pub(super) fn doubt_of_travel(
    mechanism: &dyn Kinematics,
    stated: &Stated,
    numbers: &[f64],
) -> Option<String> {
    /// Heights are above this part of that at the design position: no wheel falls so far.
    const LEAST: f64 = 0.4;
    let named = &stated.named;
    let travel = named.quantity.as_ref();
    let travel = travel.filter(|quantity| quantity.is(&WHEEL_TRAVEL))?;
    let [least, greatest] = ends(numbers.iter().copied())?;
    let (title, symbol) = (&named.title, &stated.symbol);
    let largest = least.abs().max(greatest.abs()) / stated.scale;
    if largest > extent(mechanism.points()).norm() && stated.unit.length != Length::Millimetre {
        return Some(format!("is `{title}` in mm? Its heading states {symbol}"));
    }
    let name = travel.wheel.as_deref().unwrap_or_default();
    let mut wheels = mechanism.names.wheels.iter();
    let [_, centre] = wheels.find(|wheel| wheel.name == name)?.design?;
    let height = mechanism.axes.turned(centre + mechanism.origin).z * stated.scale;
    let are_heights = least > LEAST * height && (least..=greatest).contains(&height);
    are_heights.then(|| {
        let height = number(height);
        format!(
            "`{title}` counts from the design position, and its numbers look like heights of the wheel centre, which is {height} \
             {symbol} there: subtract {height} {symbol} from them"
        )
    })
}
