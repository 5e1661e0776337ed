//! What a mistyped name may have been meant to be.

/// Letters that may be wrong, left out, too many or in another order.
const MISTYPED: usize = 2;

/// `; did you mean ...?`, or nothing where no known name is near.
pub fn did_you_mean<'a>(wanted: &str, known: impl IntoIterator<Item = &'a str>) -> String {
    let off = |name: &str| strsim::damerau_levenshtein(wanted, name);
    let nearest = known.into_iter().min_by_key(|name| off(name));
    let near =
        nearest.filter(|name| off(name) <= MISTYPED && off(name) < name.len().min(wanted.len()));
    near.map_or_else(String::new, |name| format!("; did you mean `{name}`?"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_is_near_where_a_letter_or_two_are_wrong() {
        let known = ["linkage", "drives", "unit"];
        for (wanted, expected) in [
            ("drive", "; did you mean `drives`?"),
            ("lnikage", "; did you mean `linkage`?"),
            ("points", ""),
            ("m", ""),
        ] {
            assert_eq!(did_you_mean(wanted, known), expected);
        }
    }
}
