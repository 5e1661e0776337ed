//! Random tables: points in any order, under names in other words and letters, in any axes, of one corner or a whole vehicle.

use fastrand::Rng;

use super::super::program::folder;
use super::{IN_OUR_AXES, import};

/// Names of the first nine points, in the order of [`IN_OUR_AXES`].
const NAMES: [&[&str]; 9] = [
    &[
        "lower wishbone front",
        "lower wishbone front inner",
        "lower front pivot",
    ],
    &[
        "lower wishbone rear",
        "lower wishbone rear inner",
        "lower rear pivot",
    ],
    &["lower wishbone outer", "lower ball joint", "lower outer"],
    &[
        "upper wishbone front",
        "upper wishbone front inner",
        "upper front pivot",
    ],
    &[
        "upper wishbone rear",
        "upper wishbone rear inner",
        "upper rear pivot",
    ],
    &["upper wishbone outer", "upper ball joint", "upper outer"],
    &["tie rod inner", "steering rack", "track rod inner"],
    &["tie rod outer", "track rod outer"],
    &["wheel centre", "wheel center point"],
];

/// Words with others that mean the same.
const WORDS: [(&str, &[&str]); 7] = [
    ("front", &["fore", "fwd", "forward"]),
    ("rear", &["aft"]),
    ("lower", &["lwr", "bottom"]),
    ("inner", &["inboard", "chassis"]),
    ("outer", &["outboard", "upright"]),
    ("wishbone", &["arm", "control arm", "A-arm"]),
    ("pivot", &["bush", "mount"]),
];

const SEPARATORS: [&str; 4] = [", ", ";", "\t", " | "];
const AXES: [[f64; 3]; 3] = [[1.0, 1.0, 1.0], [-1.0, -1.0, 1.0], [1.0, -1.0, -1.0]];

/// The places in which a table states the corners of its points: groups are groups of columns.
#[derive(Clone, Copy, Debug)]
enum Place {
    Headings,
    Names,
    Columns,
    Groups,
}

fn any<'a, T: ?Sized>(rng: &mut Rng, choices: &[&'a T]) -> &'a T {
    choices[rng.usize(..choices.len())]
}

fn name_of(rng: &mut Rng, point: usize) -> String {
    let mut name = any(rng, NAMES[point]).to_owned();
    for (word, others) in WORDS {
        if rng.bool() {
            name = name.replace(word, any(rng, others));
        }
    }
    let name = name.replace(' ', any(rng, &[" ", "_", "-", " \u{2013} "]));
    match rng.u8(..3) {
        0 => name.to_uppercase(),
        1 => name,
        _ => name[..1].to_uppercase() + &name[1..],
    }
}

type Corner = Vec<[f64; 3]>;

/// A table of two corners of the vehicle, which are called by two words.
fn table(rng: &mut Rng, stated: Place, words: [&str; 2], corners: [&Corner; 2]) -> String {
    let (separator, signs) = (any(rng, &SEPARATORS), AXES[rng.usize(..AXES.len())]);
    let mut order: Vec<usize> = (0..NAMES.len()).collect();
    rng.shuffle(&mut order);
    let names: Vec<String> = (0..NAMES.len()).map(|point| name_of(rng, point)).collect();
    let at = |corner: &Corner, point: usize| {
        let at: [f64; 3] = corner[point];
        [0, 1, 2]
            .map(|axis| (signs[axis] * at[axis]).to_string())
            .join(separator)
    };
    let rows = |word: &str, corner: &Corner| {
        let rows = order.iter().map(|point| {
            let before = match stated {
                Place::Names => format!("{word} "),
                Place::Columns => format!("{word}{separator}"),
                Place::Headings | Place::Groups => String::new(),
            };
            format!(
                "{before}{}{separator}{}\n",
                names[*point],
                at(corner, *point)
            )
        });
        rows.collect::<String>()
    };
    let [(one, first), (other, second)] = [(words[0], corners[0]), (words[1], corners[1])];
    match stated {
        Place::Groups => {
            let gap = separator.repeat(3);
            let heading = format!("Point{separator}{one}{gap}{other}{separator}{separator}\n");
            let both = order.iter().map(|point| {
                let [first, second] = [first, second].map(|corner| at(corner, *point));
                format!("{}{separator}{first}{separator}{second}\n", names[*point])
            });
            heading + &both.collect::<String>()
        }
        Place::Headings => format!(
            "{one}\n{}{other}\n{}",
            rows(one, first),
            rows(other, second)
        ),
        Place::Names | Place::Columns => rows(one, first) + &rows(other, second),
    }
}

#[test]
fn random_tables_give_the_points_that_they_state() {
    let folder = folder();
    let front: Corner = IN_OUR_AXES[..NAMES.len()]
        .iter()
        .map(|(_, at)| *at)
        .collect();
    let rear = front
        .iter()
        .map(|[x, y, z]| [x - 1600.0, y - 20.0, z + 10.0])
        .collect();
    let right = front.iter().map(|[x, y, z]| [*x, -y - 3.0, *z]).collect();
    let ways = [Place::Headings, Place::Names, Place::Columns, Place::Groups];
    for seed in 0..25 {
        let mut rng = Rng::with_seed(seed);
        let stated = ways[rng.usize(..ways.len())];
        let (words, option, other) = match rng.bool() {
            true => (["Front", "Rear"], "--end", &rear),
            false => (["Left", "Right"], "--side", &right),
        };
        let file = table(&mut rng, stated, words, [&front, other]);
        for (word, expected) in words.into_iter().zip([&front, other]) {
            let options = [option, &word.to_lowercase()];
            let points = import(folder.path(), "a.csv", &file, &options).points();
            for ((name, _), at) in IN_OUR_AXES.iter().zip(expected) {
                assert_eq!(
                    points[*name], *at,
                    "seed {seed}, {stated:?}, {word}: {name} of\n{file}"
                );
            }
        }
    }
}
