//! Numbers such as `1,250`, which are one or one thousand.

use crate::commands::import::format::lines::Placed;
use crate::commands::import::format::row::Row;
use crate::commands::import::names::Names;
use crate::commands::import::spelling::key_of;
use crate::decimals::Decimals;
use crate::failure::Failure;
use crate::file::Source;

/// The most digits before a sign for thousands: coordinates of 10 m in mm are not meant.
const LONGEST: usize = 1;

/// What the numbers of a table tell about its commas and points.
#[derive(Debug)]
pub(super) struct Thousands {
    pub(super) decimals: Decimals,
    /// The first number that nothing explains, with its place.
    unclear: Option<Placed<String>>,
}

impl Thousands {
    /// Takes what the coordinates and other known numbers in the lines of a table show.
    pub(super) fn of<'a>(lines: impl Iterator<Item = &'a str>, names: &Names) -> Self {
        let mut decimals = Decimals::with_thousands_behind(LONGEST);
        let rows = lines.map(|line| Row::parse(0..0, line));
        let has_numbers =
            |row: &Row<'_>| row.found().is_some() || names.is_number(&key_of(&row.name()).0);
        for row in rows.filter(has_numbers) {
            row.written_numbers()
                .for_each(|number| decimals.add(number));
        }
        Self {
            decimals,
            unclear: None,
        }
    }

    /// Adds the numbers of a point.
    pub(super) fn add(&mut self, row: &Row<'_>) {
        let number = row
            .written_numbers()
            .find(|it| self.decimals.is_unclear(it));
        if self.unclear.is_none() {
            self.unclear = number.map(|number| (row.place.clone(), number.to_owned()));
        }
    }

    /// Checks that the numbers show whether `1,250` is one or one thousand.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] at the first number that does not.
    pub(super) fn check(self, source: &Source) -> Result<(), Failure> {
        self.unclear.map_or(Ok(()), |(place, number)| {
            Err(source.refuse(&place, Decimals::doubt(&number)))
        })
    }
}
