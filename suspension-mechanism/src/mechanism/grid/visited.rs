//! The quantities read at the places of a grid.

use crate::failure::Failure;
use crate::mechanism::grid::place::VisitEnd;

/// The results read at the places of a grid.
#[derive(Clone, Debug)]
pub struct Visited<R> {
    /// The results in the order of the grid; `None` if the mechanism has no configuration.
    pub places: Vec<Option<R>>,
    pub(crate) end: VisitEnd,
}

impl<R> Visited<R> {
    /// The failure to report if places are missing.
    pub fn failure(&self, source: &str) -> Option<Failure> {
        let (all, missing) = self.counts();
        let written = match all - missing {
            0 => "none was solved".to_owned(),
            1 => "the other one was solved".to_owned(),
            others => format!("the {others} others were solved"),
        };
        if self.end.interrupted {
            let are = if missing == 1 { "is" } else { "are" };
            return Some(Failure::Interrupted(format!(
                "{source}: interrupted; {missing} of {all} places {are} missing, {written}"
            )));
        }
        let [missing, why] = self.missing_and_why(source)?;
        Some(Failure::Solver(format!(
            "{source}: {missing}; {written}:{why}"
        )))
    }

    /// The reason why places are missing if the mechanism locks, with a line for each lock and one for each remedy.
    pub fn out_of_reach(&self, source: &str) -> Option<String> {
        let [missing, why] = self.missing_and_why(source)?;
        Some(format!("{missing}:{why}"))
    }

    /// How many places are missing, and the lines that say why and what to do.
    fn missing_and_why(&self, source: &str) -> Option<[String; 2]> {
        if self.end.locks.is_empty() {
            return None;
        }
        let (all, missing) = self.counts();
        let are = if missing == 1 { "is" } else { "are" };
        let missing =
            format!("{missing} of {all} places {are} out of reach from the design position");
        let locks = self.end.locks.iter();
        let remedies = locks.clone().map(|end| (end.remedy)(source));
        let mut lines = Vec::new();
        for line in locks.map(|end| end.in_words.clone()).chain(remedies) {
            if !lines.contains(&line) {
                lines.push(line);
            }
        }
        Some([missing, format!("\n  {}", lines.join(";\n  "))])
    }

    /// The number of places, and the number of missing ones.
    fn counts(&self) -> (usize, usize) {
        let missing = self.places.iter().filter(|place| place.is_none()).count();
        (self.places.len(), missing)
    }
}
