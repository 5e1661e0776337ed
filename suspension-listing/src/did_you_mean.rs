//! Suggestions for a mistyped name.

/// The number of letters that may be wrong, missing, surplus or transposed; in short names fewer than half of them.
const MISTYPED: usize = 2;

/// `; did you mean ...?` with the nearest known name, or otherwise the two that end with the wanted one or begin with the same
/// word, for example both ends of a damper, or the only one for which the wanted one is short; empty if there are none.
pub fn did_you_mean<'a>(wanted: &str, known: impl IntoIterator<Item = &'a str>) -> String {
    let known: Vec<&str> = known.into_iter().collect();
    match (
        nearest(wanted, known.iter().copied()),
        alike(wanted, &known),
    ) {
        (Some(name), _) => format!("; did you mean `{name}`?"),
        (None, Some([one, other])) => format!("; did you mean `{one}` or `{other}`?"),
        (None, None) => match longer(wanted, &known) {
            Some(name) => format!("; did you mean `{name}`?"),
            None => String::new(),
        },
    }
}

/// The only known name that begins with the wanted one.
fn longer<'a>(wanted: &str, known: &[&'a str]) -> Option<&'a str> {
    let begins = |name: &&&str| wanted.len() > MISTYPED && name.starts_with(wanted);
    let mut longer = known.iter().filter(|name| **name != wanted).filter(begins);
    longer.next().filter(|_| longer.next().is_none()).copied()
}

/// The two known names that end with the wanted one, as those of both sides, or else that begin with the first of several words of it,
/// if there are exactly two.
fn alike<'a>(wanted: &str, known: &[&'a str]) -> Option<[&'a str; 2]> {
    let two = |is_alike: &dyn Fn(&str) -> bool| {
        let alike = known.iter().copied();
        let alike = alike.filter(|name| *name != wanted && is_alike(name));
        alike.collect::<Vec<_>>().try_into().ok()
    };
    let ends_with = |name: &str| {
        name.strip_suffix(wanted)
            .is_some_and(|side| side.ends_with('_'))
    };
    let of_sides = two(&ends_with);
    of_sides.or_else(|| {
        let (word, _) = wanted.split_once('_')?;
        two(&|name| name.split_once('_').is_some_and(|(first, _)| first == word))
    })
}

/// The sentence about an unknown name.
pub fn unknown(what: &str, wanted: &str, known: &[&str]) -> String {
    if known.is_empty() {
        return format!("unknown {what} `{wanted}`; the listing states none");
    }
    let hint = did_you_mean(wanted, known.iter().copied());
    let known = known.join(", ");
    format!("unknown {what} `{wanted}`; known are {known}{hint}")
}

/// The known name that is the wanted one but for capitals, blanks and hyphens, or the nearest, or otherwise the longest whose
/// words the wanted one contains, or the only one with a word in common.
pub fn nearest<'a>(wanted: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    // A known name may be used where another kind is required.
    let known = known.into_iter().filter(|name| *name != wanted);
    let known: Vec<&str> = known.collect();
    let within = known.iter().filter(|name| has_words_of(wanted, name));
    let within = within.max_by_key(|name| name.len()).copied();
    let plain = |name: &str| name.to_lowercase().replace([' ', '-'], "_");
    let mut same = known.iter().copied();
    same.find(|name| plain(name) == plain(wanted))
        .or_else(|| mistyped(wanted, known.iter().copied()))
        .or(within)
        .or_else(|| {
            let mut related = known.iter().filter(|name| share_a_word(wanted, name));
            related.next().filter(|_| related.next().is_none()).copied()
        })
}

/// The nearest of the known names that differ from the wanted one by a few letters.
pub fn mistyped<'a>(wanted: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let off = |name: &str| {
        let mut letters = 1..=MISTYPED.min(name.len().min(wanted.len()).saturating_sub(1) / 2);
        letters.find(|off| is_within(*off, wanted.as_bytes(), name.as_bytes()))
    };
    let near = known
        .into_iter()
        .filter_map(|name| Some((off(name)?, name)));
    near.min_by_key(|(off, _)| *off).map(|(_, name)| name)
}

/// Whether one text becomes the other if at most `off` letters are changed.
fn is_within(off: usize, a: &[u8], b: &[u8]) -> bool {
    let same = a.iter().zip(b).take_while(|(a, b)| a == b).count();
    match (&a[same..], &b[same..]) {
        ([], []) => true,
        _ if off == 0 => false,
        ([], others) | (others, []) => others.len() <= off,
        (a @ [first, rest_of_a @ ..], b @ [second, rest_of_b @ ..]) => {
            let swapped = match (rest_of_a, rest_of_b) {
                ([x, a @ ..], [y, b @ ..]) if x == second && y == first => is_within(off - 1, a, b),
                _ => false,
            };
            swapped
                || is_within(off - 1, rest_of_a, rest_of_b)
                || is_within(off - 1, rest_of_a, b)
                || is_within(off - 1, a, rest_of_b)
        }
    }
}

/// Whether a name has all words of another one, which are more than single letters.
fn has_words_of(a: &str, b: &str) -> bool {
    let mut words = b.split('_');
    words.all(|word| word.len() > MISTYPED && a.split('_').any(|other| other == word))
}

/// Whether two names have a word of more than one or two letters in common.
fn share_a_word(a: &str, b: &str) -> bool {
    let mut words = a.split('_').filter(|word| word.len() > MISTYPED);
    words.any(|word| b.split('_').any(|other| other == word))
}
