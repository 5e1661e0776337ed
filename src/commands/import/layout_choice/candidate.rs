//! A layout that may be chosen for a file.

use std::collections::BTreeMap;

use crate::commands::import::hardpoints::Hardpoint;
use crate::commands::import::layout::Layout;
use crate::commands::import::names::Names;
use crate::commands::import::stand_in::has_stand_in;

/// A listing that may be chosen, with the points that the file has for it.
#[derive(Debug)]
pub(in crate::commands::import) struct Candidate<'a> {
    pub(in crate::commands::import) layout: &'a Layout,
    /// The points that the file has, in the order of the listing, each with its name there.
    pub(in crate::commands::import) found: Vec<(String, &'a Hardpoint)>,
    /// Missing points that are computed from others.
    pub(in crate::commands::import) spare: Vec<String>,
    /// The other missing points.
    pub(super) missing: Vec<String>,
}

impl<'a> Candidate<'a> {
    /// The layout with the points that the file has for it, given by the forms of their names.
    pub(super) fn new(
        layout: &'a Layout,
        by_form: &BTreeMap<String, &'a Hardpoint>,
        names: &Names,
    ) -> Self {
        let (mut found, mut missing) = (Vec::new(), Vec::new());
        for name in layout.points.iter().cloned() {
            let mut forms = names.forms_of(&name).iter();
            let point = forms.find_map(|form| by_form.get(form)).copied();
            match point {
                Some(point) => found.push((name, point)),
                None => missing.push(name),
            }
        }
        let has = |name: &str| found.iter().any(|(other, _)| other == name);
        let (spare, missing) = missing
            .into_iter()
            .partition(|name| has_stand_in(name, layout.text, has));
        Self {
            layout,
            found,
            spare,
            missing,
        }
    }

    /// Returns the missing points that cannot be placed from the others.
    pub(super) fn needed(&self) -> Vec<&str> {
        let found = self.found.iter().map(|(name, _)| name);
        let with_missing: Vec<&String> = found.chain(&self.missing).collect();
        let has = |name: &str| with_missing.iter().any(|other| *other == name);
        let missing = self.missing.iter().map(String::as_str);
        missing
            .filter(|name| !has_stand_in(name, self.layout.text, has))
            .collect()
    }

    /// Returns the file's point for a point of the listing.
    pub(in crate::commands::import) fn point(&self, name: &str) -> Option<&'a Hardpoint> {
        let mut found = self.found.iter();
        found.find_map(|(other, point)| (other == name).then_some(*point))
    }

    /// Returns whether a point of the file is one of the listing's.
    pub(in crate::commands::import) fn uses(&self, point: &Hardpoint) -> bool {
        let mut found = self.found.iter();
        found.any(|(_, used)| std::ptr::eq(*used, point))
    }
}
