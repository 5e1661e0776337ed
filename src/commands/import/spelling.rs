//! Names as they are compared: in one spelling, without corners and prefixes.

use crate::vehicle_corner::{Side, Sides, corner_of};

/// Returns a name in lower-case letters with `_` between words.
pub(super) fn spelled(name: &str) -> String {
    let words = name.split(|c: char| !c.is_alphanumeric());
    let words = words.filter(|word| !word.is_empty());
    words.collect::<Vec<_>>().join("_").to_lowercase()
}

/// Returns whether a word is one of several, with blanks between them.
pub(super) fn is_one_of(word: &str, words: &str) -> bool {
    words.split_ascii_whitespace().any(|other| other == word)
}

/// Returns whether a spelled name is that of a point on the ground, such as `wheel_centre_contact_patch`: no layout has one.
pub(super) fn is_on_ground(name: &str) -> bool {
    is_contact(name) || name.split('_').any(|word| word == "ground")
}

/// Returns whether a spelled name may be that of the wheel's contact point.
pub(super) fn is_contact(name: &str) -> bool {
    let mut words = name.split('_');
    words.any(|word| ["contact", "patch", "radaufstandspunkt"].contains(&word))
}

/// Returns the meaning of the first or the last word of a name, and the known name without it.
pub(super) fn without_end<T>(
    key: &str,
    meaning: impl Fn(&str) -> Option<T>,
    is_known: impl Fn(&str) -> bool,
) -> Option<(T, String)> {
    let first = key.split_once('_');
    let last = key.rsplit_once('_').map(|(own, word)| (word, own));
    let mut ends = [first, last].into_iter().flatten();
    ends.find_map(|(word, own)| {
        let meant = meaning(word)?;
        is_known(own).then(|| (meant, own.to_owned()))
    })
}

/// Words that are no name without the part before them, as in `lca.front` of a structure.
const OF_PART: [&str; 8] = [
    "front", "rear", "fore", "aft", "inner", "outer", "centre", "center",
];

/// Returns a name as it is compared, and the side that it states. It omits the prefixes of Adams/Car, the model, and hpl_,
/// hpr_ or hps_ for left, right and single; the path of a structure in a program; and the code of a corner such as RL. A point
/// behind an abbreviation, as in `Lwr. arm`, is not that of a path.
pub(super) fn key_of(name: &str) -> (String, Sides) {
    let name = name.trim_end_matches('.').replace(". ", " ");
    let mut path = name.rsplit('.');
    let own = path.next().unwrap_or(&name);
    let key = match path.next() {
        Some(part) if OF_PART.contains(&spelled(own).as_str()) => spelled(&format!("{part} {own}")),
        _ => spelled(own),
    };
    let prefixes = [
        ("hpl_", Sides::One(Side::Left)),
        ("hpr_", Sides::One(Side::Right)),
        ("pvl_", Sides::One(Side::Left)),
        ("pvr_", Sides::One(Side::Right)),
        ("hps_", Sides::Unsaid),
        ("pvs_", Sides::Unsaid),
    ];
    let mut found = prefixes.into_iter();
    let found = found.find_map(|(prefix, side)| Some((key.strip_prefix(prefix)?.to_owned(), side)));
    let found = found.or_else(|| {
        let side = |code: &str| Some(Sides::One(corner_of(code)?.1));
        let (side, own) = without_end(&key, side, |_| true)?;
        Some((own, side))
    });
    found.unwrap_or((key, Sides::Unsaid))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spelled_names_join_words_by_one_underscore() {
        assert_eq!(
            spelled(" Lower  Wishbone-front.pivot "),
            "lower_wishbone_front_pivot"
        );
    }
}
