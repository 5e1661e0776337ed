//! The numbers of a design: the value of each quantity, and its derivatives with respect to the drives.

use suspension_listing::did_you_mean::did_you_mean;

use crate::characteristics::suggestions::meant;
use crate::mechanism::Description;
use crate::quantities::Column;

/// The value of a quantity at the design position, or its derivative with respect to a drive.
#[derive(Clone, Debug)]
pub struct DesignNumber {
    /// The index of its column.
    pub column: usize,
    /// 0 for the value, or 1 more than the number of the drive.
    pub number: usize,
    /// The name of the quantity: `toe`.
    pub quantity: String,
    /// `design` for the value, or the drive of a derivative: `per bump`.
    pub of: String,
    /// The name of the number: `toe`, or `toe per bump`.
    pub title: String,
    /// The name in a table of comma-separated values.
    pub csv_name: String,
    /// The factor from the solver's unit to the file's.
    pub in_file: f64,
    /// The factor from the solver's unit to the printed one.
    pub scale: f64,
    /// The printed unit.
    pub symbol: String,
}

impl DesignNumber {
    /// All numbers of a mechanism's columns: for each column the value, then the derivatives.
    pub fn all<'a>(
        mechanism: &'a Description,
        columns: &'a [Column],
    ) -> impl Iterator<Item = Self> + 'a {
        let numbers = 0..=mechanism.names.drives.len();
        let of_column = move |(at, column): (usize, &'a Column)| {
            numbers
                .clone()
                .map(move |number| Self::new(mechanism, (at, column), number))
        };
        columns.iter().enumerate().flat_map(of_column)
    }

    fn new(mechanism: &Description, (at, column): (usize, &Column), number: usize) -> Self {
        let unit = mechanism.unit;
        let drive = number.checked_sub(1);
        let drive = drive.and_then(|drive| mechanism.names.drives.get(drive));
        let per = drive.map(|drive| format!("_per_{}", drive.name));
        let (scale, symbol) = column.display_scale_per(drive, unit);
        Self {
            column: at,
            number,
            quantity: column.title(),
            of: drive.map_or_else(
                || "design".to_owned(),
                |drive| format!("per {}", drive.name),
            ),
            title: column.title_per(drive),
            csv_name: column.csv_name(unit) + &per.unwrap_or_default(),
            in_file: column.file_factor_per(drive, unit),
            scale,
            symbol,
        }
    }

    /// Whether its name begins with one of `of`.
    pub fn is_one_of(&self, of: &[String]) -> bool {
        let mut of = of.iter();
        of.any(|wanted| self.title.starts_with(wanted.as_str()))
    }
}

/// Refuses a name in `of` that begins no number's name, or only names of numbers without a value. `known` has the numbers
/// with a value, `all` also those without; `no_value` says what follows from this, `otherwise` what is printed without names.
///
/// # Errors
///
/// A sentence with the names that there are.
pub fn refuse_unknown_numbers(
    of: &[String],
    [known, all]: [&[DesignNumber]; 2],
    mechanism: &Description,
    [no_value, otherwise]: [&str; 2],
) -> Result<(), String> {
    let begins = |numbers: &[DesignNumber], wanted: &String| {
        let wanted = std::slice::from_ref(wanted);
        numbers.iter().any(|number| number.is_one_of(wanted))
    };
    let Some(wanted) = of.iter().find(|wanted| !begins(known, wanted)) else {
        return Ok(());
    };
    if begins(all, wanted) {
        return Err(format!(
            "`{wanted}` has no value at the design position{no_value}; suspension motion --help says where quantities have none"
        ));
    }
    let titles = || known.iter().map(|number| number.title.as_str());
    let names: Vec<&str> = titles().filter(|title| !title.contains(' ')).collect();
    let meant = match meant(wanted, titles(), mechanism)? {
        Some(meant) => format!("; did you mean {meant}?"),
        None => did_you_mean(wanted, names.iter().copied()),
    };
    let then = if meant.is_empty() {
        format!("; known are {}", names.join(", "))
    } else {
        format!("{meant} {otherwise}")
    };
    Err(format!("no quantity begins with `{wanted}`{then}"))
}
