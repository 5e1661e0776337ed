//! The springs that act in a load case by their rates.

use suspension_listing::did_you_mean::unknown;
use toml::Spanned;

use crate::failure::Failure;
use crate::file::{Entries, Load, LoadCase};
use crate::loads::Case;
use crate::prepare::analyses::load_cases::{ACTING, Reader};

impl Reader<'_> {
    /// The springs that the line `acting` of a case names, by number.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] at a name that is not a spring's, and at a spring whose load the case states or derives in another
    /// way.
    pub(crate) fn acting(
        &self,
        case: &Case,
        LoadCase(loads): &LoadCase,
    ) -> Result<Vec<usize>, Failure> {
        let Some(stated) = loads.get(ACTING) else {
            return Ok(Vec::new());
        };
        let acting = self.named(stated).and_then(|springs| {
            let mut refusals = springs
                .iter()
                .map(|spring| self.refusal(*spring, case, loads));
            let refusal = refusals.find_map(|refusal| refusal);
            refusal.map_or(Ok(springs), Err)
        });
        acting.map_err(|message| self.source.refuse(&stated.span(), message))
    }

    /// The springs of a list of names, each once.
    fn named(&self, stated: &Spanned<Load>) -> Result<Vec<usize>, String> {
        let names = match stated.get_ref() {
            Load::By(name) => std::slice::from_ref(name),
            Load::BySeveral(names) => names.as_slice(),
            Load::Along(_) | Load::At(_) => {
                return Err(format!(
                    "`{ACTING}` is a list of springs that act by their rates: write {ACTING} = [\"NAME\"], with the NAME of [springs.NAME]"
                ));
            }
        };
        let springs = names.iter().map(|name| self.spring(name));
        let mut springs = springs.collect::<Result<Vec<usize>, String>>()?;
        springs.sort_unstable();
        springs.dedup();
        Ok(springs)
    }

    fn spring(&self, name: &str) -> Result<usize, String> {
        let known: Vec<&str> = self.springs().map(|spring| spring.name.as_str()).collect();
        let spring = known.iter().position(|spring| *spring == name);
        spring.ok_or_else(|| match known.as_slice() {
            [] => format!("unknown spring `{name}`: state it under [springs.{name}]"),
            known => unknown("spring", name, known),
        })
    }

    /// Why a spring cannot act by its rate in a case, if another line of the case decides its load.
    fn refusal(&self, spring: usize, case: &Case, loads: &Entries<Load>) -> Option<String> {
        let names = &self.mechanism.names;
        let spring = &names.vehicle.springs[spring];
        let (name, case_name) = (&spring.name, &case.name);
        // A measure of that name comes first: its load is added to that of the spring.
        let is_measure = names.measure(name).is_some();
        if !is_measure && loads.has(name) {
            return Some(format!(
                "load case `{case_name}` states the load of spring `{name}`, which cannot act by its rate as well: leave `{name}` out of \
                 {ACTING}, or leave out the line {name} = ..."
            ));
        }
        let mut borne = case.borne_by.iter();
        let (drive, _) = borne.find(|(_, by)| *by == spring.measure)?;
        let (drive, measure) = (
            &names.drives[*drive].name,
            &names.measures[spring.measure].name,
        );
        Some(format!(
            "in load case `{case_name}` the measure `{measure}` bears the load of the drive `{drive}`, whatever the rate of spring `{name}`: \
             leave `{name}` out of {ACTING}, or leave out the line {drive} = ..."
        ))
    }
}
