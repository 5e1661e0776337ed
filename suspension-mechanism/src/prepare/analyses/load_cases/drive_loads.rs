//! The measure that bears the load of a drive in a load case.

use suspension_listing::did_you_mean::unknown;

use crate::loads::Case;
use crate::mechanism::Spring;
use crate::prepare::analyses::load_cases::Reader;

impl Reader<'_> {
    /// A drive that bears nothing, with the measure that bears its load, both by number.
    ///
    /// # Errors
    ///
    /// A sentence with the remedy, if `name` is not a drive, `by` is neither a measure nor a spring, or has the load
    /// of another drive.
    pub(crate) fn borne_by(
        &self,
        case: &Case,
        name: &str,
        by: &str,
    ) -> Result<(usize, usize), String> {
        let Some(drive) = self.mechanism.names.drive(name) else {
            return Err(self.no_drive(name, by));
        };
        let Some(measure) = self.measure(by) else {
            return Err(unknown("measure or spring", by, &self.bearing()));
        };
        let mut stated = case.borne_by.iter();
        if let Some((other, _)) = stated.find(|(_, own)| *own == measure) {
            let other = &self.mechanism.names.drives[*other].name;
            return Err(format!(
                "`{by}` is to bear the loads of both `{other}` and `{name}`, but a spring can bear the load of only one drive; name another \
                 spring or measure for `{name}`"
            ));
        }
        Ok((drive, measure))
    }

    /// The measure of this name, or the one along which a spring of this name acts.
    pub(crate) fn measure(&self, name: &str) -> Option<usize> {
        let measure = self.mechanism.names.measure(name);
        let spring = || self.springs().find(|spring| spring.name == name);
        measure.or_else(|| Some(spring()?.measure))
    }

    /// Whether a name that has a measure is that of the measure or of a spring, as a word.
    pub(crate) fn kind_of_measure(&self, name: &str) -> &'static str {
        match self.mechanism.names.measure(name) {
            Some(_) => "a measure",
            None => "a spring",
        }
    }

    /// A sentence about what may replace a force for a drive.
    pub(crate) fn no_load_of_drive(&self, drive: &str) -> String {
        let known = match self.bearing()[..] {
            [] => "there is no measure or spring yet".to_owned(),
            ref known => format!("measures and springs are {}", known.join(", ")),
        };
        format!(
            "`{drive}` is a drive: write the name of the measure or spring that bears its load, or a force where it acts; {known}"
        )
    }

    /// The remedy if a drive of a case has several names, `by`.
    pub(crate) fn one_bears(&self, case: &str, drive: &str, by: &[String]) -> String {
        let mut names = by.iter();
        if let Some(other) = names.find(|name| self.measure(name).is_none()) {
            return unknown("measure or spring", other, &self.bearing());
        }
        let one = by.first().map_or("", String::as_str);
        format!(
            "`{drive}` of load case `{case}` has a list of names, but only one measure or spring can bear the load of a drive; write \
             {drive} = \"{one}\", and for another that acts beside it the force in it, NAME = 500.0, or for a spring with \
             its rate acting = [\"NAME\"]"
        )
    }

    /// The remedy if the name before the equals sign is that of what should bear a load, or of something else that is
    /// not a drive.
    fn no_drive(&self, name: &str, by: &str) -> String {
        let names = &self.mechanism.names;
        let known = names.drive_names();
        if self.measure(name).is_some() && names.drive(by).is_some() {
            let kind = self.kind_of_measure(name);
            return format!(
                "`{name}` is {kind} and `{by}` is a drive; the drive comes first: write {by} = \"{name}\""
            );
        }
        let drives = known.join(", ");
        let message = format!("`{name}` is not a drive; the drives are {drives}");
        let travel = names.vehicle.travel.first().copied().unwrap_or_default();
        match (self.measure(by), known.get(travel)) {
            (Some(_), Some(drive)) => format!(
                "{message}; first comes the drive whose load `{by}` bears: write {drive} = \"{by}\""
            ),
            _ => message,
        }
    }

    pub(crate) fn springs(&self) -> impl Iterator<Item = &Spring> {
        self.mechanism.names.vehicle.springs.iter()
    }

    /// The names of the parts that may bear loads.
    fn bearing(&self) -> Vec<&str> {
        let springs = self.springs().map(|spring| spring.name.as_str());
        let measures = self.mechanism.names.measure_names().into_iter();
        measures.chain(springs).collect()
    }
}
