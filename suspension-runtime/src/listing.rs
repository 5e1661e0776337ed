//! A listing read from text.

use suspension_listing::{check, eliminate, lower, parse, sample};

use crate::plan::Plan;

/// A listing, parsed and checked.
#[derive(Clone, Debug)]
pub struct Listing {
    pub(crate) plan: Plan,
}

impl Listing {
    /// Reads a listing.
    ///
    /// # Errors
    ///
    /// Mistakes.
    pub fn parse(text: &str) -> Result<Self, String> {
        let text = format!("mod listing {{{text}}}");
        let tokens = text.parse().map_err(|error| format!("{error}"))?;
        let (listing, mut errors) = parse::listing(tokens).map_err(|error| error.to_string())?;
        check::names(&listing, &mut errors);
        let system = lower::system(&listing);
        check::angles(&listing, &system, &mut errors);
        if errors.is_empty() {
            check::chassis_points(&listing, &mut errors);
            check::determined(&system, &mut errors);
        }
        errors.into_result().map_err(|error| error.to_string())?;
        let entries = system.entries(&sample::positions(&system));
        let order = eliminate::order(system.size(), &entries);
        Ok(Self {
            plan: Plan::new(&system, &order),
        })
    }
}
impl Listing {
    /// scratch
    pub fn stored(&self) -> usize { self.plan.elimination.stored.len() }
}
