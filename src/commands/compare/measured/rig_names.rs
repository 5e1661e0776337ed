//! Names by which rigs call what the model calls otherwise.

use crate::mechanism::{Axle, Description, Wheel};
use crate::vehicle_corner::Section;

/// Words of rigs, and the model's words in their place; an entry comes before those that have a part of its words.
const OF_RIGS: [(&[&str], &[&str]); 42] = [
    (&["wheel", "centre", "vertical", "travel"], WHEEL_TRAVEL),
    (&["wheel", "vertical", "travel"], WHEEL_TRAVEL),
    (&["vertical", "travel"], WHEEL_TRAVEL),
    (&["wheel", "travel", "z"], WHEEL_TRAVEL),
    (&["wheel", "jounce"], WHEEL_TRAVEL),
    (&["jounce"], WHEEL_TRAVEL),
    (&["hand", "wheel", "angle"], STEERING_WHEEL),
    (&["handwheel", "angle"], STEERING_WHEEL),
    (&["handwheel"], STEERING_WHEEL),
    (&["swa"], STEERING_WHEEL),
    (&["steering", "rack", "travel"], RACK),
    (&["rack", "travel"], RACK),
    (&["rack"], RACK),
    (&["kingpin", "inclination"], &["kingpin"]),
    (&["king", "pin", "inclination"], &["kingpin"]),
    (&["kpi"], &["kingpin"]),
    (&["castor", "angle"], &["caster"]),
    (&["castor"], &["caster"]),
    (&["caster", "trail"], &["mechanical", "trail"]),
    (&["wheel", "centre", "recession"], &["recession"]),
    (&["wheel", "recession"], &["recession"]),
    (&["track", "width"], &["track"]),
    (&["toe", "in"], &["toe"]),
    (&["lenkradwinkel"], STEERING_WHEEL),
    (&["lenkwinkel"], &["steer", "angle"]),
    (&["zahnstangenweg"], RACK),
    (&["zahnstangenhub"], RACK),
    (&["federweg"], WHEEL_TRAVEL),
    (&["einfederung"], WHEEL_TRAVEL),
    (&["radhub"], WHEEL_TRAVEL),
    (&["spur"], &["toe"]),
    (&["spurwinkel"], &["toe"]),
    (&["vorspur"], &["toe"]),
    (&["gesamtspur"], &["total", "toe"]),
    (&["spurweite"], &["track"]),
    (&["sturz"], &["camber"]),
    (&["sturzwinkel"], &["camber"]),
    (&["nachlauf"], &["caster"]),
    (&["nachlaufwinkel"], &["caster"]),
    (&["nachlaufstrecke"], &["mechanical", "trail"]),
    (&["spreizung"], &["kingpin"]),
    (&["spreizungswinkel"], &["kingpin"]),
];

const WHEEL_TRAVEL: &[&str] = &["wheel", "travel"];
const STEERING_WHEEL: &[&str] = &["steering", "wheel", "angle"];
/// The drive that steers has its own name.
const RACK: &[&str] = &["rack"];

/// Returns the name in tables of what a rig calls so; another name, with its words as the model writes them.
pub(super) fn in_own_words(mechanism: &Description, name: &str) -> String {
    let name = name.to_lowercase();
    let plain = words(&name).flat_map(plain);
    let mut words: Vec<&str> = plain.filter(|word| !is_unsaid(mechanism, word)).collect();
    let mut entries = OF_RIGS.iter();
    let entry = entries.find(|(of_rig, _)| of_rig.iter().all(|word| words.contains(word)));
    if let Some((of_rig, own)) = entry {
        words.retain(|word| !of_rig.contains(word));
        match *own == RACK {
            true => words.extend(rack_drive(mechanism)),
            false => words.extend(*own),
        }
    }
    words.join("_")
}

fn words(name: &str) -> impl Iterator<Item = &str> {
    let words = name.split(|c: char| c.is_whitespace() || "_-()".contains(c));
    words.filter(|word| !word.is_empty())
}

/// Returns what one word of a rig means: corners and sides are often codes.
fn plain(word: &str) -> Vec<&str> {
    let section = match word {
        "l" => Section::of_word("left"),
        "r" => Section::of_word("right"),
        _ => Section::of_word(word),
    };
    match (section, word) {
        (Some(section), _) => section.words(),
        (None, "displacement") => vec!["travel"],
        (None, "center") => vec!["centre"],
        (None, "vl") => vec!["front", "left"],
        (None, "vr") => vec!["front", "right"],
        (None, "hl") => vec!["rear", "left"],
        (None, "hr") => vec!["rear", "right"],
        (None, "links") => vec!["left"],
        (None, "rechts") => vec!["right"],
        (None, word) => vec![word],
    }
}

/// Whether a word is true of all wheels, whose names leave it out: the end of the vehicle where an axle is, and the side of
/// a single wheel.
fn is_unsaid(mechanism: &Description, word: &str) -> bool {
    let wheels = &mechanism.names.wheels;
    let is_of_end = |axle| {
        let is_other = |wheel: &Wheel| wheel.axle.is_some_and(|own| own != axle);
        let is_said = |wheel: &Wheel| wheel.name.split('_').any(|part| part == word);
        !wheels.iter().any(|wheel| is_other(wheel) || is_said(wheel))
    };
    match word {
        "front" => is_of_end(Axle::Front),
        "rear" => is_of_end(Axle::Rear),
        "left" => has_one_wheel(mechanism, 1.0),
        "right" => has_one_wheel(mechanism, -1.0),
        _ => false,
    }
}

/// Whether the only wheel, which has no name, is on the side of this sign of y.
fn has_one_wheel(mechanism: &Description, side: f64) -> bool {
    match &mechanism.names.wheels[..] {
        [wheel] if wheel.name.is_empty() => wheel
            .design
            .is_some_and(|[_, centre]| side * mechanism.axes.turned(centre).y > 0.0),
        _ => false,
    }
}

/// Whether a name is of the axle that the model does not have.
pub(super) fn is_of_other_axle(mechanism: &Description, name: &str) -> bool {
    let wheels = &mechanism.names.wheels;
    let all_are = |axle| wheels.iter().all(|wheel| wheel.axle == Some(axle));
    let name = in_own_words(mechanism, name);
    let says = |end: &str| name.split('_').any(|word| word == end);
    (says("front") && all_are(Axle::Rear)) || (says("rear") && all_are(Axle::Front))
}

/// Says that a name is of toe-out, which is toe with the opposite sign.
pub(super) fn toe_out(name: &str) -> Option<String> {
    let lower = name.to_lowercase();
    let has = |wanted: &str| words(&lower).any(|word| word == wanted);
    (has("toe") && has("out")).then(|| {
        format!(
            "`{name}` has the opposite sign of `toe`, which is positive if the front of the wheel points inboard: change the \
             signs and call it `toe`; a column whose heading is empty is left out"
        )
    })
}

/// Whether a name is of the wheel on the other side, which the model does not have.
pub(super) fn is_of_other_side(mechanism: &Description, name: &str) -> bool {
    let name = in_own_words(mechanism, name);
    let says = |side: &str| name.split('_').any(|word| word == side);
    (says("left") && has_one_wheel(mechanism, -1.0))
        || (says("right") && has_one_wheel(mechanism, 1.0))
}

/// The drive that moves a rack, if there is one alone.
fn rack_drive(mechanism: &Description) -> Option<&str> {
    let names = &mechanism.names;
    match names.vehicle.steer[..] {
        [drive] => {
            let drive = &names.drives[drive];
            (!drive.kind.is_angle()).then_some(&*drive.name)
        }
        _ => None,
    }
}
