//! The targets that a motion file sets for `suspension tune`.

use suspension_listing::did_you_mean::unknown;
use toml::Spanned;

use crate::characteristics::{columns, meant};
use crate::failure::Failure;
use crate::file::TargetTable;
use crate::prepare::analyses::tuning::named_parts::Naming;
use crate::quantities::Column;
use crate::tune::{Reading, Target};

impl Naming<'_> {
    pub(crate) fn read_target(
        &self,
        name: &Spanned<String>,
        stated: &Spanned<TargetTable>,
    ) -> Result<Target, Failure> {
        let table = stated.get_ref();
        let column = self.column(&table.of)?;
        let per = table.per.as_ref().map(|per| self.drive(per)).transpose()?;
        if per.is_some() && !column.has_derivatives {
            let message = format!("`{}` has no derivatives", table.of.get_ref());
            return Err(self.source.refuse(&table.of.span(), message));
        }
        let reading = Reading { column, per };
        let scale = reading.file_factor(self.mechanism);
        let within = *table.within.get_ref() / scale;
        if !(within.is_finite() && within > 0.0) {
            let message = "`within` must be a positive number, the largest permitted deviation from the target";
            return Err(self.source.refuse(&table.within.span(), message));
        }
        let (over, wanted) = self.wanted(name, table, &reading)?;
        Ok(Target {
            name: name.get_ref().clone(),
            reading,
            over,
            wanted,
            within,
        })
    }

    fn column(&self, of: &Spanned<String>) -> Result<Column, Failure> {
        let mut columns = columns(self.mechanism);
        let names: Vec<String> = columns.iter().map(Column::title).collect();
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let wanted = of.get_ref();
        let refuse = |message: String| Err(self.source.refuse(&of.span(), message));
        if let Some(found) = names.iter().position(|name| name == wanted) {
            return Ok(columns.swap_remove(found));
        }
        match meant(wanted, names.iter().copied(), self.mechanism) {
            Ok(Some(meant)) => {
                let message = format!("unknown quantity `{wanted}`; did you mean {meant}?");
                return refuse(message);
            }
            Ok(None) => {}
            Err(message) => return refuse(message),
        }
        let begun = |name: &&&str| wanted.starts_with(&format!("{name}_"));
        if let Some(name) = names.iter().filter(begun).max_by_key(|name| name.len()) {
            return refuse(format!(
                "unknown quantity `{wanted}`; did you mean `{name}`? Quantities are named without a unit"
            ));
        }
        let message = unknown("quantity", wanted, &names);
        // A long list is shortened where it is printed.
        let all = format!(
            "; suspension sensitivities {} prints all",
            self.source.name()
        );
        let is_answered = message.ends_with('?');
        refuse(message + if is_answered { "" } else { &all })
    }
}
