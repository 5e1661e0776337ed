//! Curves over travel or steering.

use super::Along;
use super::parameters::{columns, symbol_per, title};
use crate::mechanism::{Mechanism, State, Suspension};
use crate::output::plot::{Chart, Curve};
use crate::quantities::{
    Column, FRONT_ARM, FRONT_CENTRE, Kind, MEASURES, Quantity, SIDE_ARM, SIDE_CENTRE,
};

/// The curves along a drive, under a heading.
pub(super) struct Charts {
    pub(super) heading: String,
    pub(super) charts: Vec<Chart>,
}

/// All quantities along a drive; of measures their derivatives too, which are motion ratios.
pub(super) fn charts<L: Suspension<N>, const N: usize>(
    mechanism: &Mechanism<L, N>,
    along: &Along,
) -> Charts {
    let drive = &mechanism.names.drives[along.drive];
    let kind = Kind::from(drive.kind);
    let (scale, symbol) = kind.for_people(mechanism.unit);
    let across = format!("change of {} ({symbol})", drive.name);
    let line = |value: &dyn Fn(&State, &Option<State>) -> Option<f64>| -> Vec<(f64, f64)> {
        let places = along.changes.iter().zip(&along.visited.places);
        let points = places.filter_map(|(change, place)| {
            let (state, per) = place.as_ref()?;
            let value = value(state, per).filter(|value| value.is_finite())?;
            Some((change * scale, value))
        });
        points.collect()
    };
    let chart = |title: String, quantity: String, line| Chart {
        title,
        across: across.clone(),
        quantity,
        curves: vec![Curve {
            name: String::new(),
            line,
            marks: Vec::new(),
        }],
    };
    let mut charts = Vec::new();
    for column in columns(mechanism).into_iter().filter(is_bounded) {
        let (scale, symbol) = column.kind.for_people(mechanism.unit);
        let name = name(&column);
        let values = line(&|state, _| Some(column.value(state) * scale));
        charts.push(chart(name.clone(), symbol.clone(), values));
        if column.is(&MEASURES) {
            let ratios = line(&|_, per| Some(column.along(per.as_ref()?).rate * scale));
            let symbol = symbol_per(&symbol, kind, mechanism.unit);
            charts.push(chart(format!("{name} per {}", drive.name), symbol, ratios));
        }
    }
    charts.retain(|chart| chart.curves.iter().any(|curve| curve.line.len() > 1));
    Charts {
        heading: format!("Over {}", drive.name),
        charts,
    }
}

/// Whether it has no poles: instant centres lie at infinity where the carrier moves parallel.
fn is_bounded(column: &Column) -> bool {
    const WITH_POLES: [&Quantity; 4] = [&FRONT_CENTRE, &FRONT_ARM, &SIDE_CENTRE, &SIDE_ARM];
    !WITH_POLES.iter().any(|quantity| column.is(quantity))
}

fn name(column: &Column) -> String {
    let axis = column
        .axis
        .map_or_else(String::new, |axis| format!(" {axis}"));
    title(column) + &axis
}
