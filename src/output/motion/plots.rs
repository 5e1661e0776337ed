//! Plots of a motion: the height of the wheel centre, and the angles of wheel and kingpin.

use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use crate::failure::Failure;
use crate::kinematics::Kinematics;
use crate::mechanism::{Description, End, Instants, Names, State, Unit};
use crate::output::capitalised::capitalised;
use crate::output::motion::record::{Outcome, record};
use crate::output::plot::{Chart, Curve};
use crate::output::rows::TableTargets;
use crate::output::svg_folder::SvgFolder;
use crate::quantities::{
    Axis, CAMBER, CASTER, CENTRE, Column, KINGPIN, Quantity, STEER_ANGLE, TOE, columns,
};

/// Instants per line.
const DENSE: usize = 401;

/// The horizontal axis.
pub const TIME: &str = "time t (s)";

/// Plots with their names, made of a dense sequence of states for lines and of the states to mark.
pub type Charts = Vec<(&'static str, Chart)>;

/// Draws the recorded part of a motion into a folder, and returns the paths of the files. Draws nothing if nothing was recorded
/// or the user interrupts.
///
/// # Errors
///
/// [`Failure::Output`] if a file cannot be written.
pub fn draw(
    mechanism: &dyn Kinematics,
    outcome: &Outcome,
    folder: &SvgFolder<'_>,
    charts: impl Fn(&Description, [&[State]; 2]) -> Charts,
) -> Result<Vec<PathBuf>, Failure> {
    if outcome.solved == 0 || outcome.end == End::Cut {
        return Ok(Vec::new());
    }
    let [first, _] = mechanism.instants.ends();
    let dense = Instants::dense(first, outcome.farthest(), DENSE);
    let never = AtomicBool::new(false);
    let line = record(mechanism, &dense, &TableTargets::default(), DENSE, &never)?.kept;
    let every_instant_kept = outcome.kept.len() == outcome.solved;
    let marks = if every_instant_kept {
        outcome.kept.as_slice()
    } else {
        &[]
    };
    folder.draw(charts(mechanism, [&line, marks]))
}

/// Returns the plots for any linkage; a quantity that it lacks has none.
pub fn height_and_angles(mechanism: &Description, states: [&[State]; 2]) -> Charts {
    let Description { names, unit, .. } = mechanism;
    let angles = [&TOE, &CAMBER, &STEER_ANGLE, &CASTER, &KINGPIN];
    let angles = angles.map(|angle| (angle.name, angle_chart(angle, names, *unit, states)));
    let height = ("height", height(mechanism, states));
    let charts = [height].into_iter().chain(angles);
    charts
        .filter(|(_, chart)| !chart.curves.is_empty())
        .collect()
}

/// Returns the sign of z upwards, so that heights point up in any axes, and the label of the vertical axis.
pub fn upwards(mechanism: &Description) -> (f64, String) {
    let [.., up] = mechanism.axes.signs();
    let sign = if up < 0.0 { "-" } else { "" };
    (up, format!("height {sign}z ({})", mechanism.unit.symbol()))
}

fn height(mechanism: &Description, states: [&[State]; 2]) -> Chart {
    let Description { names, unit, .. } = mechanism;
    let (up, quantity) = upwards(mechanism);
    let columns = columns([&CENTRE], names).into_iter();
    let heights = columns.filter(|column| column.axis == Some(Axis::Z));
    let curves = heights.zip(&names.wheels).map(|(height, wheel)| {
        let [_, centre] = wheel.points.axis;
        let name = named(&wheel.title(CENTRE.title), &names.points[centre]);
        let (scale, _) = height.dimension.display_scale(*unit);
        over_time(name, states, |state| height.value(state) * scale * up)
    });
    Chart {
        title: format!("Height of the {}", CENTRE.title),
        across: TIME.to_owned(),
        quantity,
        curves: curves.collect(),
    }
}

fn angle_chart(
    angle: &'static Quantity,
    names: &Names,
    unit: Unit,
    states: [&[State]; 2],
) -> Chart {
    let columns = columns([angle], names);
    let curves = columns.iter().map(|column| {
        let name = with_points(column, names);
        let is_title = name == angle.title;
        let name = if is_title { String::new() } else { name };
        let (scale, _) = column.dimension.display_scale(unit);
        over_time(name, states, |state| column.value(state) * scale)
    });
    Chart {
        title: capitalised(angle.title),
        across: TIME.to_owned(),
        quantity: "angle (deg)".to_owned(),
        curves: curves.collect(),
    }
}

/// Returns a curve over time, of a dense line and of marks; a value that is not finite is left out.
pub fn over_time(name: String, states: [&[State]; 2], value: impl Fn(&State) -> f64) -> Curve {
    let [line, marks] = states.map(|states| {
        let points = states.iter().map(|state| (state.t, value(state)));
        points.filter(|(_, value)| value.is_finite()).collect()
    });
    Curve {
        name,
        line,
        marks,
        ..Curve::default()
    }
}

/// Returns the title of a wheel's quantity, with the points of the kingpin if it depends on them.
fn with_points(column: &Column, names: &Names) -> String {
    let name = column.wheel.as_deref().unwrap_or_default();
    let mut wheels = names.wheels.iter().filter(|wheel| wheel.name == name);
    let (Some(wheel), quantity) = (wheels.next(), column.quantity) else {
        return column.name.clone();
    };
    let title = wheel.title(quantity.title);
    match wheel.points.kingpin {
        Some(kingpin) if column.is(&KINGPIN) => {
            let [lower, upper] = kingpin.map(|point| &names.points[point]);
            format!("{title} ({lower} to {upper})")
        }
        _ => title,
    }
}

/// Returns the purpose of a point and its name, if these differ.
fn named(what: &str, point: &str) -> String {
    if point.replace('_', " ") == what.replace('_', " ") {
        what.to_owned()
    } else {
        format!("{what} {point}")
    }
}
