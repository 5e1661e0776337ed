//! Assemblies as text and as rows of a table.

use std::fmt::Write;

use crate::assemblies::{Assembly, Listed};
use crate::input::file::Unit;
use crate::number::number;
use crate::study::Study;

/// The columns' names of [`rows`].
pub fn columns(study: &dyn Study) -> Vec<String> {
    let unit = study.unit().symbol();
    let names = study.columns();
    let drives = names
        .iter()
        .skip(1)
        .take_while(|name| !name.ends_with("_x"));
    let mut columns: Vec<String> = drives.cloned().collect();
    columns.push("assembly".to_owned());
    columns.extend(["distance", "farthest"].map(|name| format!("{name}_{unit}")));
    columns.extend(["mirrored", "smallest_pivot", "camber_rad", "toe_rad"].map(String::from));
    let points = study.points();
    let points = points.free.iter().chain(&points.markers);
    columns.extend(points.flat_map(|name| ["x", "y", "z"].map(|axis| format!("{name}_{axis}"))));
    columns
}

/// One row an assembly.
pub fn rows(listed: &Listed) -> impl Iterator<Item = Vec<f64>> {
    (1..).zip(&listed.assemblies).map(|(count, assembly)| {
        let mut row = listed.drives.clone();
        row.push(f64::from(count));
        row.extend([
            assembly.distance,
            assembly.farthest,
            assembly.mirrored.len() as f64,
            assembly.smallest_pivot,
        ]);
        row.extend(assembly.wheel.map_or([f64::NAN; 2], |w| [w.camber, w.toe]));
        row.extend(&assembly.coordinates);
        row
    })
}

/// The assemblies in a table, and how sure it is that they are all.
pub fn text(listed: &Listed, unit: Unit) -> String {
    let mut out = format!("At {}:\n\n", listed.drives_in_words);
    let symbol = unit.symbol();
    let headings = [
        "assembly".to_owned(),
        format!("distance ({symbol})"),
        format!("farthest ({symbol})"),
        "smallest pivot".to_owned(),
        format!("centre x ({symbol})"),
        format!("y ({symbol})"),
        format!("z ({symbol})"),
        "camber (deg)".to_owned(),
        "mirrored".to_owned(),
    ];
    let widths = headings.each_ref().map(|heading| heading.len().max(9));
    for (heading, width) in headings.iter().zip(widths) {
        let _ = write!(out, "  {heading:>width$}");
    }
    out.push('\n');
    for (count, assembly) in (1..).zip(&listed.assemblies) {
        for (cell, width) in cells(count, assembly, unit).iter().zip(widths) {
            let _ = write!(out, "  {cell:>width$}");
        }
        out.push('\n');
    }
    let _ = write!(out, "\n{}", certainty(listed));
    out
}

fn cells(count: usize, assembly: &Assembly, unit: Unit) -> [String; 9] {
    let digits = match unit {
        Unit::Metre => 5,
        Unit::Millimetre => 2,
    };
    let length = |value: f64| format!("{value:.digits$}");
    let [x, y, z, camber] = match &assembly.wheel {
        Some(wheel) => {
            let [x, y, z] = [wheel.centre.x, wheel.centre.y, wheel.centre.z].map(length);
            [x, y, z, format!("{:.3}", wheel.camber.to_degrees())]
        }
        None => [(); 4].map(|()| "-".to_owned()),
    };
    let mirrored = match assembly.mirrored.as_slice() {
        [] => "-".to_owned(),
        points => points.join(" "),
    };
    [
        count.to_string(),
        length(assembly.distance),
        length(assembly.farthest),
        format!("{:.1e}", assembly.smallest_pivot),
        x,
        y,
        z,
        camber,
        mirrored,
    ]
}

/// How sure it is that the list is complete, and why.
fn certainty(listed: &Listed) -> String {
    let tally = &listed.tally;
    let verdict = if tally.is_complete() {
        "The list is complete by all that was tried"
    } else {
        "The list may not be complete"
    };
    let unconfirmed = match tally.unconfirmed {
        0 => String::new(),
        count => format!(" ({count} beside a fold, real or complex is not to be told)"),
    };
    let evidence = &tally.evidence;
    let trace = match evidence.trace {
        Some(bend) => format!("the trace test leaves {} of a straight line", rounded(bend)),
        None => "the trace test does not apply, as no drive moves a free point".to_owned(),
    };
    let loops = match evidence.loops {
        1 => "one loop".to_owned(),
        loops => format!("{loops} loops, the last {}", evidence.quiet),
    };
    format!(
        "{verdict}: {} real and {} complex assemblies, {} at infinity, \
         {} not accounted for{unconfirmed},\nof the {} that such a mechanism has with general \
         lengths ({} random starts, {loops} without a\nnew one; {trace}).\n",
        tally.real,
        tally.complex,
        tally.infinite,
        tally.unaccounted(),
        tally.generic,
        evidence.starts,
    )
}

fn rounded(bend: f64) -> String {
    if bend.is_finite() {
        format!("{bend:.0e}")
    } else {
        number(bend)
    }
}
