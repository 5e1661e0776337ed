//! Points that a view shows in one place, as those of both sides, which share a label.

use crate::vehicle_corner::Section;

/// A label of one point, or of several in one place whose names differ in one word.
struct Label<'a> {
    /// The words of the first name.
    words: Vec<&'a str>,
    /// The index of the word in which the names differ, and that word of each name.
    varying: Option<(usize, Vec<&'a str>)>,
    at: (i32, i32),
}

impl<'a> Label<'a> {
    fn new(name: &'a str, at: (i32, i32)) -> Self {
        Self {
            words: name.split('_').collect(),
            varying: None,
            at,
        }
    }

    /// Takes in a name that differs from the others in one word alone, the same word for all names; returns whether it does.
    fn join(&mut self, name: &'a str) -> bool {
        let words: Vec<&str> = name.split('_').collect();
        let both = self.words.iter().zip(&words).enumerate();
        let unlike = both.filter(|(_, (own, other))| own != other);
        let unlike: Vec<usize> = unlike.map(|(index, _)| index).collect();
        let has_rest = self.words.len() == words.len() && words.len() > 1;
        let (true, [index]) = (has_rest, unlike.as_slice()) else {
            return false;
        };
        let first = || (*index, vec![self.words[*index]]);
        let (varying, each) = self.varying.get_or_insert_with(first);
        let is_same = varying == index;
        each.extend(is_same.then_some(words[*index]));
        is_same
    }

    /// The name, or the words that all names have, and those in which they differ: `ball (left, right)`, `upper (front, rear)`.
    /// Names that differ in another word than the last one or that of a corner stay whole.
    fn text(&self) -> String {
        let Some((index, each)) = &self.varying else {
            return self.words.join("_");
        };
        let (before, behind) = (&self.words[..*index], &self.words[index + 1..]);
        if behind.is_empty() || each.iter().all(|word| Section::of_word(word).is_some()) {
            return format!(
                "{} ({})",
                [before, behind].concat().join("_"),
                each.join(", ")
            );
        }
        let names = each
            .iter()
            .map(|word| [before, &[*word], behind].concat().join("_"));
        names.collect::<Vec<_>>().join(", ")
    }
}

/// Returns the labels with their places: one for each name, and one for all names in one place that differ in one word
/// alone, such as `left_ball` and `right_ball`.
pub(super) fn labels(
    names: &[String],
    places: &[(i32, i32)],
    near: i32,
) -> Vec<(String, (i32, i32))> {
    let mut labels: Vec<Label<'_>> = Vec::new();
    for (name, &(x, y)) in names.iter().zip(places) {
        let is_near = |(left, top): (i32, i32)| (left - x).abs().max((top - y).abs()) <= near;
        let mut here = labels.iter_mut().filter(|label| is_near(label.at));
        if !here.any(|label| label.join(name)) {
            labels.push(Label::new(name, (x, y)));
        }
    }
    let labels = labels.iter().map(|label| (label.text(), label.at));
    labels.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_in_one_place_whose_names_differ_in_one_word_share_a_label() {
        let named = [
            ("left_ball", (0, 0)),
            ("rack", (0, 0)),
            ("right_ball", (1, -1)),
            ("left_top", (0, 9)),
            ("rod", (0, 0)),
            ("right_top", (3, 9)),
            ("front_left_hub", (20, 0)),
            ("front_right_hub", (20, 0)),
            ("rear_left_hub", (20, 0)),
            ("upper_front", (40, 0)),
            ("upper_rear", (40, 0)),
            ("lower_front", (40, 0)),
            ("damper_in", (60, 0)),
            ("push_in", (60, 0)),
        ];
        let expected = [
            ("ball (left, right)", (0, 0)),
            ("rack", (0, 0)),
            ("left_top", (0, 9)),
            ("rod", (0, 0)),
            ("right_top", (3, 9)),
            ("front_hub (left, right)", (20, 0)),
            ("rear_left_hub", (20, 0)),
            ("upper (front, rear)", (40, 0)),
            ("lower_front", (40, 0)),
            ("damper_in, push_in", (60, 0)),
        ];
        let named = named.map(|(name, at)| (name.to_owned(), at));
        let (names, places): (Vec<_>, Vec<_>) = named.into_iter().unzip();
        let found = labels(&names, &places, 2);
        assert_eq!(found, expected.map(|(name, at)| (name.to_owned(), at)));
    }
}
