//! The words that names are made of: several mean the same, and they may stand in any order, joined or apart.

use std::collections::BTreeMap;

use suspension_listing::did_you_mean::nearest;

/// The most words that one meaning has, as `top_a_arm_ball`.
const MOST_WORDS: usize = 4;

/// The longest word that may be joined to others, in bytes.
const LONGEST: usize = 24;

/// Words with their meanings.
#[derive(Debug)]
pub(super) struct Words {
    /// The meaning, in one or more words, of each word and of words that are joined; empty for those that mean nothing.
    meanings: BTreeMap<String, Vec<String>>,
}

impl Words {
    /// Collects the words of names, and `synonyms`: those that mean the same, by their meaning. The `unsaid` mean nothing.
    pub(super) fn new<'a>(
        names: impl Iterator<Item = &'a str>,
        synonyms: &'a BTreeMap<String, Vec<String>>,
        unsaid: &'a [String],
    ) -> Self {
        let mut meanings = BTreeMap::new();
        for word in names.flat_map(|name| name.split('_')) {
            meanings.insert(word.to_owned(), vec![word.to_owned()]);
        }
        for (meaning, words) in synonyms {
            let own: Vec<String> = meaning.split('_').map(str::to_owned).collect();
            for word in words.iter().chain([meaning]) {
                meanings.insert(word.replace('_', ""), own.clone());
            }
        }
        let nothing = unsaid.iter().map(|word| (word.clone(), Vec::new()));
        meanings.extend(nothing);
        Self { meanings }
    }

    /// Returns a spelled name in the form that all names with its meaning have.
    pub(super) fn normal(&self, name: &str) -> String {
        let words = name.split('_').flat_map(|word| self.apart(word));
        let words: Vec<&str> = words.collect();
        let mut normal = Vec::new();
        let mut rest = words.as_slice();
        while let [first, behind @ ..] = rest {
            let mut counts = (1..=MOST_WORDS.min(rest.len())).rev();
            let meaning = |count: usize| Some((count, self.meanings.get(&rest[..count].concat())?));
            match counts.find_map(meaning) {
                Some((count, meaning)) => {
                    normal.extend(meaning.iter().map(String::as_str));
                    rest = &rest[count..];
                }
                None => {
                    normal.push(first);
                    rest = behind;
                }
            }
        }
        normal.sort_unstable();
        normal.join("_")
    }

    /// Splits a word into known words, the longest first; returns the word itself if it is known, or has an unknown part.
    fn apart<'a>(&self, word: &'a str) -> Vec<&'a str> {
        if self.meanings.contains_key(word) {
            return vec![word];
        }
        // For each place, the end of the known word that begins there, if known words can follow it up to the end.
        let mut ends: Vec<Option<usize>> = vec![None; word.len() + 1];
        ends[word.len()] = Some(word.len());
        for start in (0..word.len()).rev() {
            let last = word.len().min(start + LONGEST);
            ends[start] = (start + 1..=last).rev().find(|end| {
                let known = word.get(start..*end);
                ends[*end].is_some() && known.is_some_and(|known| self.meanings.contains_key(known))
            });
        }
        let mut parts = Vec::new();
        let mut start = 0;
        while start < word.len() {
            let Some(end) = ends[start] else {
                return vec![word];
            };
            parts.push(&word[start..end]);
            start = end;
        }
        parts
    }

    /// Returns the spelled name with the nearest known word in place of each mistyped one.
    pub(super) fn corrected(&self, name: &str) -> String {
        let mut known: Vec<&str> = self.meanings.keys().map(String::as_str).collect();
        known.sort_by_key(|word| std::cmp::Reverse(word.len()));
        let words = name.split('_').map(|word| {
            let is_known = self
                .apart(word)
                .iter()
                .all(|part| self.meanings.contains_key(*part));
            let meant = nearest(word, known.iter().copied()).filter(|_| !is_known);
            meant.unwrap_or(word)
        });
        words.collect::<Vec<_>>().join("_")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words() -> Words {
        let synonyms = [
            ("front", vec!["fore", "for"]),
            ("wishbone", vec!["control_arm", "a_arm"]),
            ("lower_wishbone", vec!["lca"]),
        ];
        let owned = |words: Vec<&str>| words.into_iter().map(str::to_owned).collect();
        let synonyms = synonyms.map(|(meaning, words)| (meaning.to_owned(), owned(words)));
        let names = ["lower_wishbone_front", "top"];
        let unsaid = ["point".to_owned(), "to".to_owned()];
        Words::new(names.into_iter(), &synonyms.into(), &unsaid)
    }

    #[test]
    fn names_with_one_meaning_have_one_form() {
        let words = words();
        let form = words.normal("lower_wishbone_front");
        for name in [
            "front_lower_wishbone",
            "lca_fore",
            "lcafor",
            "lower_control_arm_front",
            "lowercontrolarm_front_point",
            "fore_a_arm_lower",
        ] {
            assert_eq!(words.normal(name), form, "{name}");
        }
        for name in [
            "lower_wishbone",
            "lower_wishbone_front_front",
            "lower_wishbones_front",
            "lcafory",
        ] {
            assert_ne!(words.normal(name), form, "{name}");
        }
    }

    #[test]
    fn a_known_word_is_not_split_and_an_unknown_one_stays() {
        let words = words();
        assert_eq!(words.apart("top"), ["top"]);
        assert_eq!(words.apart("toforetop"), ["to", "fore", "top"]);
        assert_eq!(words.apart("fortax"), ["fortax"]);
        // A text that could be split in very many ways.
        let long = "lowerwishbone".repeat(200) + "x";
        assert_eq!(words.apart(&long), [long.as_str()]);
    }

    #[test]
    fn mistyped_words_are_corrected() {
        let words = words();
        assert_eq!(
            words.corrected("lower_wishbnoe_fronnt"),
            "lower_wishbone_front"
        );
        assert_eq!(words.corrected("ballast"), "ballast");
    }
}
