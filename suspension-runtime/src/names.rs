//! The names of a listing's parts.

use suspension_core::listing::Part;
use suspension_listing::system::{AXES, Point, System};

/// Names in the order of the parts.
#[derive(Clone, Debug)]
pub(crate) struct Names {
    equations: Vec<String>,
    unknowns: Vec<String>,
    pub(crate) points: Vec<String>,
    pub(crate) drives: Vec<String>,
    pub(crate) measures: Vec<String>,
    pub(crate) lengths: Vec<String>,
}

impl Names {
    pub(crate) fn new(system: &System) -> Self {
        let coordinates = |point: &Point| AXES.map(|axis| format!("{}.{axis}", point.named.name));
        let drives = system.drives.iter().map(|drive| &drive.named.name);
        let measures = system.measures.iter().map(|measure| &measure.named.name);
        let lengths = system.lengths();
        Self {
            equations: texts(system.rows()),
            unknowns: (system.free.iter().flat_map(coordinates))
                .chain(texts(&system.scalars))
                .collect(),
            points: texts(system.points()),
            drives: texts(drives),
            measures: texts(measures),
            lengths: texts(lengths.iter().map(|length| &length.named.name)),
        }
    }

    /// The name of a part; `?` if there is none.
    pub(crate) fn name(&self, part: Part) -> &str {
        let table = match part {
            Part::Equation(_) => &self.equations,
            Part::Unknown(_) => &self.unknowns,
            Part::Point(_) => &self.points,
            Part::Drive(_) => &self.drives,
            Part::Measure(_) => &self.measures,
            Part::Length(_) => &self.lengths,
        };
        table.get(part.index()).map_or("?", String::as_str)
    }
}

fn texts<N: ToString>(names: impl IntoIterator<Item = N>) -> Vec<String> {
    names.into_iter().map(|name| name.to_string()).collect()
}
