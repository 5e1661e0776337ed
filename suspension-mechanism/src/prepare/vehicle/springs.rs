//! The springs of a motion file, with the indices of their measures.

use suspension_listing::did_you_mean::unknown;

use crate::failure::Failure;
use crate::mechanism::Spring;
use crate::prepare::task::Task;

/// The springs that a file states, at the measures of its design, in the file's coordinates.
///
/// # Errors
///
/// [`Failure::Input`] at a name that is not a measure, and at a rate or load that is not finite.
pub(crate) fn springs(task: &Task<'_>, design: &[f64]) -> Result<Vec<Spring>, Failure> {
    let Some(table) = &task.file.springs else {
        return Ok(Vec::new());
    };
    let unit = task.file.unit();
    let each = table.get_ref().iter().map(|(name, stated)| {
        let name = name.get_ref();
        let stated = stated.get_ref();
        let along = stated.along.get_ref().as_str();
        let measure = task.names.measure(along).ok_or_else(|| {
            let message = remedy_along_drive(task, along)
                .unwrap_or_else(|| unknown("measure", along, &task.names.measure_names()));
            task.source.refuse(&stated.along.span(), message)
        })?;
        let rate = *stated.rate.get_ref();
        if !(rate.is_finite() && rate >= 0.0) {
            let message = format!("the rate of spring `{name}` must be zero or a positive number");
            return Err(task.source.refuse(&stated.rate.span(), message));
        }
        let load = *stated.load.get_ref();
        if !load.is_finite() {
            let message = format!("the load of spring `{name}` is not finite");
            return Err(task.source.refuse(&stated.load.span(), message));
        }
        let kind = task.names.measures[measure].kind;
        Ok(Spring {
            name: name.clone(),
            measure,
            kind,
            rate: rate * unit.file_factor(kind),
            load,
            design: design[measure],
        })
    });
    Failure::all(each)
}

/// The remedy if a spring is stated along a drive.
fn remedy_along_drive(task: &Task<'_>, name: &str) -> Option<String> {
    let drive = task.names.drive(name)?;
    let line = task
        .listing
        .and_then(|listing| listing.driven_length(drive));
    let [from, to] = line.unwrap_or(["a", "b"]);
    Some(format!(
        "`{name}` is a drive, and a spring acts along a measure: add `measure NAME: length({from} -> {to});` to the listing, and write \
         along = \"NAME\""
    ))
}
