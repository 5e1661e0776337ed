//! Computes the cases at all places, writes rows and collects the figures of the report.

use std::ops::ControlFlow;
use std::rc::Rc;
use std::sync::atomic::{AtomicBool, Ordering};

use suspension_runtime::Listing;

use crate::commands::loads::case_results::{CaseResults, without_answer};
use crate::commands::loads::drawing::drawing;
use crate::commands::loads::notes::notes;
use crate::commands::loads::place_columns::PlaceColumns;
use crate::commands::loads::report::Report;
use crate::commands::loads::table::{headings, row};
use crate::failure::Failure;
use crate::file::tell;
use crate::grid::{Swept, grid};
use crate::interrupt::unless_set;
use crate::kinematics::Kinematics;
use crate::loads::{Case, Outcome, Structure};
use crate::mechanism::{CountedFrom, DerivativeOrder, Place, State};
use crate::output::files::{announce, print};
use crate::output::heading::Header;
use crate::output::notes::print_notes_on;
use crate::output::progress::Progress;
use crate::output::rows::{Rows, TableTargets};
use crate::output::svg_folder::SvgFolder;
use crate::quantities::{DRIVES, TIME};

/// The cases of a file with the mechanism that they load.
pub(super) struct Run<'a> {
    pub(super) source: &'a str,
    pub(super) mechanism: &'a dyn Kinematics,
    pub(super) listing: &'a Listing,
    pub(super) structure: &'a Structure<'a>,
    pub(super) cases: &'a [Case],
    /// The folder of drawings.
    pub(super) drawings: Option<SvgFolder<'a>>,
}

impl<'a> Run<'a> {
    /// Computes the loads at each place of a grid.
    pub(super) fn run_grid(
        &self,
        (drives, from): (&[Swept], CountedFrom),
        tables: &TableTargets,
        interrupted: &AtomicBool,
    ) -> Result<(), Failure> {
        let grid = grid(self.mechanism, self.source, drives, from)?;
        let mut progress = Progress::new(grid.places().unwrap_or_default(), "places");
        let leading = PlaceColumns::new(self.mechanism, &[&DRIVES]);
        let mut found = self.none_found();
        let mut read = |place: &dyn Place| {
            progress.step();
            let state = place.state();
            let (at, outcomes): (Rc<[f64]>, _) =
                (leading.read(&state).into(), self.outcomes(&state));
            self.start(&mut found, &outcomes, (&state, &at));
            count(&mut found, &outcomes, (&state, &at));
            let drawn = self.drawings.is_some().then_some(state);
            (at, outcomes, drawn)
        };
        let visited = self
            .mechanism
            .visit(&grid, DerivativeOrder::First, interrupted, &mut read);
        let failure = visited.failure(self.source);
        let is_any = visited.places.iter().any(Option::is_some);
        let mut rows = self.rows(tables, &leading, &found)?;
        let mut first = None;
        for (at, outcomes, drawn) in visited.places.into_iter().flatten() {
            if let Some(rows) = &mut rows {
                rows.add(&row(&at, &found, &outcomes))?;
            }
            first = first.or_else(|| Some((drawn?, outcomes)));
        }
        self.finish((tables, &leading), rows, first, &found)?;
        self.ended(failure, &found, is_any)
    }

    /// Computes the loads at each instant of the motion.
    pub(super) fn run_motion(
        &self,
        tables: &TableTargets,
        interrupted: &AtomicBool,
    ) -> Result<(), Failure> {
        let instants = &self.mechanism.instants;
        let leading = PlaceColumns::new(self.mechanism, &[&TIME, &DRIVES]);
        let mut found = self.none_found();
        // The table has columns for the cases with an answer at any instant; nearly always all have one at the first.
        let mut progress = Progress::new(instants.count(), "instants");
        self.mechanism.move_through(instants, &mut |state| {
            progress.step();
            let at = leading.read(&state).into();
            self.start(&mut found, &self.outcomes(&state), (&state, &at));
            Ok(match found.iter().all(Option::is_some) {
                true => ControlFlow::Break(()),
                false => unless_set(interrupted),
            })
        })?;
        drop(progress);
        if interrupted.load(Ordering::Relaxed) {
            return Err(Failure::nothing_written(self.source));
        }
        let mut rows = self.rows(tables, &leading, &found)?;
        let mut first = None;
        let mut progress = Progress::new(instants.count(), "instants");
        let end = self.mechanism.move_through(instants, &mut |state| {
            progress.step();
            let (at, outcomes) = (leading.read(&state).into(), self.outcomes(&state));
            count(&mut found, &outcomes, (&state, &at));
            if let Some(rows) = &mut rows {
                rows.add(&row(&at, &found, &outcomes))?;
            }
            first.get_or_insert((state, outcomes));
            Ok(unless_set(interrupted))
        })?;
        let is_any = first.is_some();
        let done = match rows {
            Some(_) => "the rows up to there were written",
            None => "nothing was written",
        };
        self.finish((tables, &leading), rows, first, &found)?;
        let failure = end.failure(self.source, done);
        self.ended(failure, &found, is_any)
    }

    fn none_found(&self) -> Vec<Option<CaseResults<'a>>> {
        self.cases.iter().map(|_| None).collect()
    }

    fn outcomes(&self, state: &State) -> Vec<Option<Outcome>> {
        let cases = self.cases.iter();
        let outcomes = cases.map(|case| self.structure.solve(self.mechanism, case, state));
        outcomes.collect()
    }

    /// Starts the results of cases at their first answer.
    fn start(
        &self,
        found: &mut [Option<CaseResults<'a>>],
        outcomes: &[Option<Outcome>],
        (state, at): (&State, &Rc<[f64]>),
    ) {
        for ((found, case), outcome) in found.iter_mut().zip(self.cases).zip(outcomes) {
            if let (None, Some(outcome)) = (&found, outcome) {
                let first = (state, outcome);
                let unborne = self.structure.unborne(self.mechanism, case, first);
                *found = Some(CaseResults::new((case, unborne), outcome.clone(), at));
            }
        }
    }

    /// Creates the table if the user wants one and a case has an answer.
    fn rows(
        &self,
        tables: &TableTargets,
        leading: &PlaceColumns,
        found: &[Option<CaseResults<'_>>],
    ) -> Result<Option<Rows>, Failure> {
        if tables.is_empty() || found.iter().all(Option::is_none) {
            return Ok(None);
        }
        let headings = headings(self.mechanism, self.structure, leading, found);
        Rows::create(tables, &Header::new(self.mechanism), &headings).map(Some)
    }

    /// Ends the table, draws the cases at the `first` place, and prints the reports.
    fn finish(
        &self,
        (tables, leading): (&TableTargets, &PlaceColumns),
        rows: Option<Rows>,
        first: Option<(State, Vec<Option<Outcome>>)>,
        found: &[Option<CaseResults<'_>>],
    ) -> Result<(), Failure> {
        if let Some(rows) = rows {
            rows.finish()?;
            announce(tables.files().map(|(path, _)| path));
        }
        if let (Some(folder), Some((state, outcomes))) = (&self.drawings, &first) {
            let place = leading.in_words(&leading.read(state), |_| true);
            let drawn = found.iter().zip(outcomes).filter_map(|(found, outcome)| {
                let case = found.as_ref()?.case;
                let svg = self.drawing(case, (state, &place, outcome.as_ref()));
                Some(svg.and_then(|svg| folder.write(&case.name, &svg)))
            });
            announce(&drawn.collect::<Result<Vec<_>, Failure>>()?);
        }
        let of_file = (&self.mechanism.names, self.mechanism.axes);
        let notes = notes(of_file, self.structure, found);
        print_notes_on(self.source, notes);
        if tables.is_to_stdout() {
            return Ok(());
        }
        let report = Report {
            file: self.source,
            mechanism: self.mechanism,
            structure: self.structure,
            driven: self.listing.driven_points(),
            leading,
        };
        let mut found = found.iter().flatten();
        found.try_for_each(|found| print(&report.text(found)))
    }

    fn drawing(
        &self,
        case: &Case,
        at: (&State, &str, Option<&Outcome>),
    ) -> Result<String, Failure> {
        let whole = (self.mechanism, self.listing);
        drawing(whole, self.structure, case, at).whole(self.source)
    }

    /// Returns why the result is incomplete: what ended the grid or the motion comes before cases without an answer at any
    /// place.
    fn ended(
        &self,
        failure: Option<Failure>,
        found: &[Option<CaseResults<'_>>],
        is_any: bool,
    ) -> Result<(), Failure> {
        let each = self.cases.iter().zip(found);
        let without = each.filter(|(_, found)| is_any && found.is_none());
        let names: Vec<&str> = without.map(|(case, _)| case.name.as_str()).collect();
        match (failure, without_answer(self.source, &names)) {
            (Some(failure), without) => {
                without.into_iter().for_each(tell);
                Err(failure)
            }
            (None, without) => without.map_or(Ok(()), |without| Err(Failure::Solver(without))),
        }
    }
}

/// Adds a place to the results of each case.
fn count(
    found: &mut [Option<CaseResults<'_>>],
    outcomes: &[Option<Outcome>],
    at: (&State, &Rc<[f64]>),
) {
    for (found, outcome) in found.iter_mut().zip(outcomes) {
        if let (Some(found), Some(outcome)) = (found, outcome) {
            found.add(outcome, at);
        }
    }
}
