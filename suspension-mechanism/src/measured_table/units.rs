//! Units in the headings of measured tables.

/// Splits a heading such as `toe [deg]`, `toe (deg)`, `toe / deg` or `toe in deg`, with the unit `below` it. With a unit below,
/// which may be in brackets too, `toe (left)` is a name.
pub fn name_and_symbol<'a>(heading: &'a str, below: &'a str) -> (&'a str, &'a str) {
    let is_word = |(_, symbol): &(&str, &str)| !symbol.trim().contains([' ', '(']);
    let apart = [" / ", " in "].map(|between| heading.rsplit_once(between).filter(is_word));
    let mut others = apart.into_iter().chain([heading.rsplit_once('(')]);
    let other = || others.find_map(|split| split.filter(|_| below.is_empty()));
    let split = heading.rsplit_once('[').or_else(other);
    let (name, symbol) = split.unwrap_or((heading, below));
    let symbol = symbol.trim_matches(['[', '(', ')', ']']);
    (name.trim(), symbol.trim())
}

/// Words and signs of units, and what the program's symbols have in their place.
const OF_UNITS: [[&str; 2]; 8] = [
    ["\u{b0}", "deg"],
    ["degrees", "deg"],
    ["degree", "deg"],
    ["grad", "deg"],
    ["zoll", "in"],
    ["inches", "in"],
    ["inch", "in"],
    ["%", "percent"],
];

/// The program's symbol of a unit, in small letters, for a symbol or word in a table.
pub fn usual_symbol(written: &str) -> String {
    let words = OF_UNITS.iter();
    words.fold(written.to_lowercase(), |symbol, [word, ours]| {
        symbol.replace(word, ours)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_of_units_are_read_as_their_symbols() {
        for (written, symbol) in [
            ("Inches", "in"),
            ("inch", "in"),
            ("Zoll", "in"),
            ("Grad", "deg"),
        ] {
            assert_eq!(usual_symbol(written), symbol);
        }
    }

    #[test]
    fn a_unit_stands_in_brackets_or_behind_a_dash_or_a_word() {
        for heading in [
            "toe in [deg]",
            "toe in (deg)",
            "toe in / deg",
            "toe in in deg",
        ] {
            assert_eq!(name_and_symbol(heading, ""), ("toe in", "deg"));
        }
        for heading in ["toe (left)", "toe / left", "toe in front view"] {
            assert_eq!(name_and_symbol(heading, "deg"), (heading, "deg"));
        }
        assert_eq!(
            name_and_symbol("toe in front view", ""),
            ("toe in front view", "")
        );
    }
}
