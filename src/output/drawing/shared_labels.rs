//! Points of both sides that a view shows in one place, which share a label.

/// The first words of the names in a label, the rest of these names, and their place.
type Label<'a> = (Vec<&'a str>, &'a str, (i32, i32));

/// Returns the labels with their places: one for each name, and one for all names in one place that differ in the first word
/// alone, such as `left_ball` and `right_ball`.
pub(super) fn labels(
    names: &[String],
    places: &[(i32, i32)],
    near: i32,
) -> Vec<(String, (i32, i32))> {
    let mut labels: Vec<Label<'_>> = Vec::new();
    for (name, &(x, y)) in names.iter().zip(places) {
        let (first, rest) = name.split_once('_').unwrap_or(("", name));
        let is_same = |(_, other, at): &&mut Label<'_>| {
            !first.is_empty() && *other == rest && (at.0 - x).abs().max((at.1 - y).abs()) <= near
        };
        match labels.iter_mut().find(is_same) {
            Some((firsts, ..)) => firsts.push(first),
            None => labels.push((vec![first], rest, (x, y))),
        }
    }
    let joined = |(firsts, rest, place): Label<'_>| match firsts[..] {
        [""] => (rest.to_owned(), place),
        [first] => (format!("{first}_{rest}"), place),
        _ => (format!("{rest} ({})", firsts.join(", ")), place),
    };
    labels.into_iter().map(joined).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_of_both_sides_in_one_place_share_a_label() {
        let names = [
            "left_ball",
            "rack",
            "right_ball",
            "left_top",
            "rack",
            "right_top",
        ];
        let places = [(0, 0), (0, 0), (1, -1), (0, 9), (0, 0), (3, 9)];
        let expected = [
            ("ball (left, right)", (0, 0)),
            ("rack", (0, 0)),
            ("left_top", (0, 9)),
            ("rack", (0, 0)),
            ("right_top", (3, 9)),
        ];
        let found = labels(&names.map(str::to_owned), &places, 2);
        assert_eq!(found, expected.map(|(name, at)| (name.to_owned(), at)));
    }
}
