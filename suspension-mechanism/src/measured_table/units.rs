//! Units in the headings of measured tables.

/// Splits a heading such as `toe [deg]` or `toe (deg)`, with the unit `below` it. With a unit below, which may be in
/// brackets too, `toe (left)` is a name.
pub fn name_and_symbol<'a>(heading: &'a str, below: &'a str) -> (&'a str, &'a str) {
    let round = || heading.rsplit_once('(').filter(|_| below.is_empty());
    let split = heading.rsplit_once('[').or_else(round);
    let (name, symbol) = split.unwrap_or((heading, below));
    let symbol = symbol.trim_matches(['[', '(', ')', ']']);
    (name.trim(), symbol.trim())
}

/// Words and signs of units, and what the program's symbols have in their place.
const OF_UNITS: [[&str; 2]; 6] = [
    ["\u{b0}", "deg"],
    ["degrees", "deg"],
    ["degree", "deg"],
    ["grad", "deg"],
    ["zoll", "in"],
    ["%", "percent"],
];

/// The program's symbol of a unit, in small letters, for a symbol or word in a table.
pub fn usual_symbol(written: &str) -> String {
    let words = OF_UNITS.iter();
    words.fold(written.to_lowercase(), |symbol, [word, ours]| {
        symbol.replace(word, ours)
    })
}
