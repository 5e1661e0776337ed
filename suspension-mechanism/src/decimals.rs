//! Numbers in which a comma or a point stands before decimals, or between thousands.

const SIGNS: [char; 2] = ['.', ','];

/// The characters that tables have for a minus: a hyphen, and in typeset ones and in some languages a minus or an en dash.
pub const MINUS: [char; 3] = ['-', '\u{2212}', '\u{2013}'];

/// What the numbers of a text show of their commas and points.
#[derive(Clone, Copy, Debug)]
pub struct Decimals {
    /// The most digits before a first sign between thousands.
    longest: usize,
    follow_point: bool,
    follow_comma: bool,
    /// Whether a number such as `250` has no decimals.
    has_whole: bool,
}

impl Default for Decimals {
    /// Nothing is shown yet.
    fn default() -> Self {
        Self::with_thousands_behind(3)
    }
}

impl Decimals {
    /// Nothing is shown yet; a sign behind more digits than `longest` stands before decimals.
    pub fn with_thousands_behind(longest: usize) -> Self {
        Self {
            longest,
            follow_point: false,
            follow_comma: false,
            has_whole: false,
        }
    }

    /// Adds what a number shows: `12,5` and `1.640,5` have decimals behind the comma, `1,250` shows nothing of it.
    pub fn add(&mut self, written: &str) {
        match self.shown_by(written) {
            Some('.') => self.follow_point = true,
            Some(_) => self.follow_comma = true,
            None => self.has_whole |= unsigned(written).len() > 1 && are_digits(unsigned(written)),
        }
    }

    /// Returns whether a number such as `1,250`, beside whole ones, may be one or one thousand, and nothing shows which.
    pub fn is_unclear(&self, written: &str) -> bool {
        self.has_whole && self.is_group(written) && self.shown_by_others().is_none()
    }

    /// Returns the sentence on a number that [is unclear](Self::is_unclear).
    pub fn doubt(written: &str) -> String {
        let digits = written.replace(SIGNS, "");
        format!(
            "`{written}` may be {digits}, or a number with decimals: write {digits}, or {written}0 for decimals"
        )
    }

    /// Returns a number; `inf` and `nan` are none.
    pub fn number(&self, written: &str) -> Option<f64> {
        let decimal = self.shown_by(written).or(self.shown_by_others());
        let first = signs(written).next();
        let plain = match first.filter(|first| decimal.is_some_and(|decimal| decimal != *first)) {
            Some(thousands) => without_thousands(written, thousands)?,
            None => written.replace(',', "."),
        };
        let plain = plain.replacen(MINUS, "-", 1);
        plain.parse().ok().filter(|number: &f64| number.is_finite())
    }

    /// Returns the sign before decimals that a number shows by itself.
    fn shown_by(&self, written: &str) -> Option<char> {
        let mut signs = signs(written);
        let first = signs.next()?;
        match signs.last() {
            Some(last) if last == first => Some(other(first)),
            Some(last) => Some(last),
            None => (!self.is_group(written)).then_some(first),
        }
    }

    fn shown_by_others(&self) -> Option<char> {
        match (self.follow_point, self.follow_comma) {
            (true, false) => Some('.'),
            (false, true) => Some(','),
            _ => None,
        }
    }

    /// Returns whether a number has one sign, and behind it three digits that may be those below a thousand.
    fn is_group(&self, written: &str) -> bool {
        let Some((before, behind)) = unsigned(written).split_once(SIGNS) else {
            return false;
        };
        let is_thousand = (1..=self.longest).contains(&before.len()) && !before.starts_with('0');
        is_thousand && behind.len() == 3 && are_digits(before) && are_digits(behind)
    }
}

fn signs(written: &str) -> impl Iterator<Item = char> {
    written.chars().filter(|c| SIGNS.contains(c))
}

fn other(sign: char) -> char {
    if sign == '.' { ',' } else { '.' }
}

/// Returns a number without a minus, of which typeset tables have several, or a plus.
fn unsigned(written: &str) -> &str {
    written.trim_start_matches(|c: char| !c.is_ascii_digit() && !SIGNS.contains(&c))
}

fn are_digits(text: &str) -> bool {
    text.chars().all(|c| c.is_ascii_digit())
}

/// Returns a number with a decimal point, without the sign between thousands; `None` where that stands elsewhere.
fn without_thousands(written: &str, sign: char) -> Option<String> {
    let (whole, decimals) = written.split_at(written.rfind(other(sign)).unwrap_or(written.len()));
    let mut groups = whole.split(sign);
    let first = unsigned(groups.next()?);
    let are_groups = matches!(first.len(), 1..=3)
        && are_digits(first)
        && groups.all(|group| group.len() == 3 && are_digits(group));
    are_groups.then(|| whole.replace(sign, "") + &decimals.replace(',', "."))
}

#[cfg(test)]
mod tests {
    use super::Decimals;

    /// Reads the first number beside the others.
    fn beside(written: &str, others: &[&str]) -> Option<f64> {
        let mut decimals = Decimals::default();
        others.iter().for_each(|other| decimals.add(other));
        decimals.number(written)
    }

    #[test]
    fn a_sign_is_that_for_thousands_where_decimals_follow_the_other() {
        for (written, others, expected) in [
            ("2,140", vec!["-170.5", "1,300"], 2140.0),
            ("-2.140", vec!["170,5"], -2140.0),
            ("\u{2212}2.140", vec!["170,5"], -2140.0),
            ("\u{2013}12,5", vec![], -12.5),
            ("2,140", vec!["1,640.25"], 2140.0),
            ("2.140", vec!["-170.5"], 2.14),
            ("2,140", vec!["-170,5"], 2.14),
            ("2,140", vec!["125", "1.300"], 2.14),
            ("2,140", vec!["-170.5", "170,5"], 2.14),
            ("0,250", vec!["-170.5"], 0.25),
            ("12,5", vec!["-170.5"], 12.5),
            ("1.640,25", vec!["-170.5"], 1640.25),
            ("1,234,567", vec![], 1_234_567.0),
            ("1.250e3", vec!["170,5"], 1250.0),
            (".5", vec![], 0.5),
        ] {
            let number = beside(written, &others).unwrap_or(f64::NAN);
            assert_eq!(
                number.to_bits(),
                f64::to_bits(expected),
                "{written} beside {others:?}"
            );
        }
    }

    #[test]
    fn signs_out_of_place_make_no_number() {
        for written in [
            "1,64,250.5",
            "1.2.3",
            "1,2345.5",
            "1.250,5.5",
            ",250.5",
            "",
            "-",
            "\u{2013}-1",
            "5\u{2013}1",
            "nan",
            "inf",
        ] {
            assert_eq!(beside(written, &[]), None, "{written}");
        }
    }

    #[test]
    fn only_numbers_that_nothing_explains_are_unclear() {
        let mut decimals = Decimals::with_thousands_behind(1);
        decimals.add("2,250");
        assert!(
            !decimals.is_unclear("-1,250"),
            "all numbers have three decimals"
        );
        decimals.add("-40");
        assert!(decimals.is_unclear("-1,250"));
        for clear in ["0,250", "12,250", "1,25", "1,250.5", "1250"] {
            assert!(!decimals.is_unclear(clear), "{clear}");
        }
        decimals.add("12,5");
        assert!(!decimals.is_unclear("-1,250"));
        decimals.add("12.5");
        assert!(decimals.is_unclear("-1,250"));
    }
}
