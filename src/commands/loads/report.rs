//! The report of a load case as text.

use crate::commands::loads::case_results::{CaseResults, Extreme};
use crate::commands::loads::parts::{Load, Part, parts};
use crate::commands::loads::place_columns::PlaceColumns;
use crate::commands::loads::report_lines::{Line, shown, table};
use crate::commands::loads::unloaded::Unloaded;
use crate::loads::{Case, Structure};
use crate::mechanism::{Description, Drive, Measure, Names};

pub(super) struct Report<'a> {
    pub(super) file: &'a str,
    pub(super) mechanism: &'a Description,
    pub(super) structure: &'a Structure<'a>,
    /// The chassis points that drives move.
    pub(super) driven: Vec<usize>,
    pub(super) leading: &'a PlaceColumns,
}

impl Report<'_> {
    /// Returns the report of a case over all places that have an answer.
    pub(super) fn text(&self, found: &CaseResults<'_>) -> String {
        let [drives, measures, links, joints, moments, on_chassis] = self.lines(found);
        let mut unloaded = Unloaded::new(found);
        let inside = [links, joints, moments].map(|lines| unloaded.remove_from(lines));
        let [links, joints, moments] = inside;
        let on_chassis = on_chassis.into_iter();
        let on_chassis = on_chassis.filter(|line| unloaded.is_loaded(line)).collect();
        let [of_forces, of_moments, borne] = match found.places {
            1 => [
                "exerts along x, y and z",
                "about x, y and z",
                "bears along x, y and z",
            ],
            _ => ["exerts a force of the size", "size", "bears"],
        };
        let tables = [
            (["drive", "bears"], drives),
            (
                ["measure", "bears (positive: towards a larger value)"],
                measures,
            ),
            (["link", "tension"], links),
            (["joint", of_forces], joints),
            (["moment", of_moments], moments),
            (["chassis point", borne], on_chassis),
        ];
        let tables = tables.map(|(headings, lines)| table(headings, &lines));
        let notes = [unloaded.in_words(), self.lock_note(found)];
        self.heading(found) + &tables.concat() + &notes.concat()
    }

    /// Returns the lines of drives, measures, links, joints, moments about angles, and forces on chassis points.
    fn lines(&self, found: &CaseResults<'_>) -> [Vec<Line>; 6] {
        let (structure, names) = (self.structure, &self.mechanism.names);
        let mut lines = [const { Vec::new() }; 6];
        for ((part, load), range) in parts(&found.first).zip(&found.ranges) {
            let (table, name) = match part {
                Part::Drive(drive) => (0, drive_with_bearer(names, found.case, drive)),
                Part::Measure(measure) => (1, measure_with_loads(names, found.case, measure)),
                Part::Link(link) => (2, structure.statements[link].name.to_owned()),
                Part::Joint(by, at) => {
                    let by = structure.name_of(by, names);
                    (3, format!("{by} at {}", names.points[at]))
                }
                Part::Moment(by, on) => {
                    let by = structure.name_of(by, names);
                    (4, format!("{by} on {}", structure.statements[on].name))
                }
                Part::ChassisPoint(point) => (5, self.on_chassis(point)),
            };
            lines[table].push(self.line((name, part.unit(names)), load, range, found));
        }
        lines
    }

    /// Returns the name of the case, its place or the number of places, and what the places have in common.
    fn heading(&self, found: &CaseResults<'_>) -> String {
        let common = self
            .leading
            .in_words(&found.place, |number| !found.varies[number]);
        let places = match found.places {
            1 => format!(" at {common}"),
            several if common.is_empty() => format!(", least and greatest of {several} places"),
            several => format!(", least and greatest of {several} places with {common}"),
        };
        let axes = self.mechanism.axes.in_words();
        let (file, case) = (self.file, &found.case.name);
        format!("{file}: load case {case}{places}; axes of {axes}\n\n")
    }

    /// Returns the line of a part: at one place the load, one in space with its components; or the least and the greatest of
    /// several, with their places if they differ.
    fn line(
        &self,
        (name, unit): (String, &'static str),
        load: Load<'_>,
        range: &[Extreme; 2],
        found: &CaseResults<'_>,
    ) -> Line {
        let numbers = match found.places {
            1 => load
                .numbers()
                .into_iter()
                .map(|(_, number)| number)
                .collect(),
            _ => range.iter().map(|extreme| extreme.value).collect(),
        };
        let is_the_same =
            |[least, greatest]: &[Extreme; 2]| shown(least.value) == shown(greatest.value);
        Line {
            name,
            numbers,
            unit,
            places: match is_the_same(range) {
                true => Default::default(),
                false => self.places(range, found),
            },
            largest: Extreme::largest(range),
        }
    }

    fn places(&self, range: &[Extreme; 2], found: &CaseResults<'_>) -> [String; 2] {
        range.each_ref().map(|extreme| {
            self.leading
                .in_words(&extreme.place, |number| found.varies[number])
        })
    }

    /// Returns the name of a chassis point, marked if a drive moves it.
    fn on_chassis(&self, point: usize) -> String {
        let name = &self.mechanism.names.points[point];
        if self.driven.contains(&point) {
            format!("{name} (driven)")
        } else {
            name.clone()
        }
    }

    /// Returns a note if internal forces are so large that a lock must be near.
    fn lock_note(&self, found: &CaseResults<'_>) -> String {
        /// Arms and rockers alone make forces several times as large as the load.
        const MANY: f64 = 100.0;
        let Extreme { value: most, place } = &found.amplification;
        if *most < MANY {
            return String::new();
        }
        let place = self.leading.in_words(place, |_| true);
        format!(
            "The largest force inside is {most:.0} times the largest load, at {place}: the mechanism is near a position where it locks.\n\n"
        )
    }
}

/// Names a drive, and the measure that bears its load if the case names one.
fn drive_with_bearer(names: &Names, case: &Case, drive: usize) -> String {
    let Drive { name, .. } = &names.drives[drive];
    let borne = case.borne_by.iter().find(|(borne, _)| *borne == drive);
    match borne {
        Some((_, by)) => format!("{name} (its load is in {})", names.measures[*by].name),
        None => name.clone(),
    }
}

/// Names a measure with the springs that bear its load, which is what a drive would bear or what their rates give, and with
/// the load that the case states in it.
fn measure_with_loads(names: &Names, case: &Case, measure: usize) -> String {
    let bears = case.borne_by.iter().any(|(_, by)| *by == measure);
    let along = names.vehicle.springs.iter().enumerate();
    let along = along.filter(|(number, spring)| {
        spring.measure == measure && (bears || case.acting.contains(number))
    });
    let springs: Vec<&str> = along.map(|(_, spring)| spring.name.as_str()).collect();
    let springs = match springs.as_slice() {
        [] => None,
        [spring] => Some(format!("spring {spring}")),
        _ => Some(format!("springs {}", springs.join(" and "))),
    };
    let Measure { name, .. } = &names.measures[measure];
    let unit = Part::Measure(measure).unit(names);
    let stated = case.along.iter().filter(|(along, _)| *along == measure);
    let stated = stated.map(|(_, along)| format!("the stated {} {unit}", shown(*along)));
    let acting: Vec<String> = springs.into_iter().chain(stated).collect();
    match acting.as_slice() {
        [] => name.clone(),
        acting => format!("{name} ({})", acting.join(" and ")),
    }
}
