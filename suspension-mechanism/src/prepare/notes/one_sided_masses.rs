//! Masses on only one side of the vehicle.

use suspension_runtime::Listing;

use crate::mechanism::{name_on_other_side, quoted};
use crate::prepare::task::Task;

/// A note on parts with a mass whose counterparts on the other side have none.
pub(in crate::prepare) fn note(task: &Task<'_>, listing: &Listing) -> Option<String> {
    let table = task.file.masses.as_ref()?;
    let statements = listing.statements();
    let is_part = |name: &String| {
        task.names.point(name).is_some() || statements.iter().any(|part| part.name == name)
    };
    let has_mass = |name: &String| table.get_ref().has(name);
    let pairs = table.get_ref().iter().filter_map(|(name, _)| {
        let other = name_on_other_side(name.get_ref())?;
        (is_part(&other) && !has_mass(&other)).then(|| [name.get_ref().clone(), other])
    });
    let pairs: Vec<[String; 2]> = pairs.collect();
    let all = |side: usize| quoted(pairs.iter().map(|pair| &pair[side]));
    let (verb, them) = match pairs.len() {
        0 => return None,
        1 => ("has", "it"),
        _ => ("have", "them"),
    };
    Some(format!(
        "[masses] has {}, and {} of the other side {verb} no mass; state {them} too",
        all(0),
        all(1)
    ))
}
