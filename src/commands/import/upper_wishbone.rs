//! A pushrod or a damper on the upper wishbone: the catalogue's layouts have it on the lower one.

use super::hardpoints::Hardpoint;

/// A point of the lower wishbone, with the statements that put it there and those that put it on the upper wishbone.
struct OnLower {
    point: &'static str,
    statements: &'static [[&'static str; 2]],
}

const POINTS: [OnLower; 2] = [
    OnLower {
        point: "pushrod_lower",
        statements: &[
            ["-> lower_ball, pushrod_lower;", "-> lower_ball;"],
            [
                "upper_rear -> upper_ball;",
                "upper_rear -> upper_ball, pushrod_lower;",
            ],
        ],
    },
    OnLower {
        point: "damper_lower",
        statements: &[[
            "damper_lower: lower_wishbone",
            "damper_lower: upper_wishbone",
        ]],
    },
];

/// How the catalogue's layouts describe it.
const IN_WORDS: [&str; 2] = ["from the lower wishbone", "from the upper wishbone"];

/// Returns the points that a layout has on its lower wishbone.
fn on_lower(layout: &str) -> impl Iterator<Item = &'static OnLower> {
    POINTS
        .iter()
        .filter(|on| on.statements.iter().all(|[is, _]| layout.contains(is)))
}

/// Returns the point that is nearer to the upper ball joint than to the lower one, so that it is on the upper wishbone.
pub(super) fn point_on_upper<'a>(
    layout: &str,
    point: impl Fn(&str) -> Option<&'a Hardpoint>,
) -> Option<&'static str> {
    let (lower, upper) = (point("lower_ball")?, point("upper_ball")?);
    let apart = |a: &Hardpoint, b: &Hardpoint| {
        let squares = [0, 1, 2].map(|axis| (a.at[axis] - b.at[axis]).powi(2));
        squares.iter().sum::<f64>()
    };
    let mut points = on_lower(layout).map(|on| on.point);
    points.find(|name| point(name).is_some_and(|at| apart(at, upper) < apart(at, lower)))
}

/// Returns a layout with its pushrod or its damper on the upper wishbone.
pub(super) fn on_upper(layout: &str) -> String {
    let statements = on_lower(layout).flat_map(|on| on.statements);
    let changes = statements.chain([&IN_WORDS]);
    changes.fold(layout.to_owned(), |text, [from, to]| text.replace(from, to))
}
