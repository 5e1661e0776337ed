//! The listing of a ladder: bodies in a row, each held to the one before by three rails along x and
//! to the chassis by three hangers.
//!
//! All bodies are alike and stand a pitch apart, so that they move alike: the program that the
//! listing is compiled into checks that.

use std::fmt::Write;

type Vector = [f64; 3];

/// The distance from a body to the next, along x, m.
const PITCH: f64 = 0.3;

/// A point of the first body, and the chassis end of its hanger.
struct Corner {
    name: &'static str,
    at: Vector,
    hung_from: Vector,
}

const CORNERS: [Corner; 3] = [
    Corner {
        name: "left",
        at: [0.00, 0.31, 0.02],
        hung_from: [0.03, 0.33, 0.52],
    },
    Corner {
        name: "right",
        at: [0.02, -0.29, 0.00],
        hung_from: [0.01, -0.33, 0.49],
    },
    Corner {
        name: "top",
        at: [0.01, 0.03, 0.24],
        hung_from: [0.02, 0.53, 0.27],
    },
];

/// A listing of `bodies` bodies, with the design positions of all points in their order.
pub(crate) fn listing(bodies: usize) -> String {
    format!(
        "suspension_core::linkage! {{\n    pub mod ladder {{\n{}    }}\n}}\n\n{}",
        statements(bodies),
        design(bodies)
    )
}

/// Returns the statements, without the surrounding `mod ladder`.
pub(crate) fn statements(bodies: usize) -> String {
    let mut text = String::new();
    let mut line = |statement: String| {
        writeln!(text, "        {statement}").expect("a string takes all text");
    };
    for (name, at) in points(bodies) {
        let kind = if name.starts_with("hook") {
            "fixed"
        } else {
            "free"
        };
        line(format!("{kind}: {name} at {at:?};"));
    }
    for body in 1..=bodies {
        let corners = CORNERS.map(|corner| format!("{}_{body}", corner.name));
        line(format!("body rung_{body}: {};", corners.join(", ")));
        for Corner { name, .. } in &CORNERS {
            line(format!(
                "link hanger_{name}_{body}: hook_{name}_{body} -> {name}_{body};"
            ));
            if body > 1 {
                let before = body - 1;
                line(format!(
                    "link rail_{name}_{body}: {name}_{before} -> {name}_{body};"
                ));
            }
        }
    }
    line("drive travel: left_1.x;".to_owned());
    line("drive yaw: right_1.x - left_1.x;".to_owned());
    line("drive pitch: top_1.x - left_1.x;".to_owned());
    text
}

/// Returns all points with their names: those of the chassis, then the free ones.
fn points(bodies: usize) -> impl Iterator<Item = (String, Vector)> {
    let row = move |prefix: &'static str, of: fn(&Corner) -> Vector| {
        (1..=bodies).flat_map(move |body| {
            CORNERS.iter().map(move |corner| {
                let [x, y, z] = of(corner);
                let x = x + PITCH * (body - 1) as f64;
                (format!("{prefix}{}_{body}", corner.name), [x, y, z])
            })
        })
    };
    row("hook_", |corner| corner.hung_from).chain(row("", |corner| corner.at))
}

fn design(bodies: usize) -> String {
    let positions: Vec<Vector> = points(bodies).map(|(_, at)| at).collect();
    let (size, count) = (9 * bodies, positions.len());
    format!(
        "pub const SIZE: usize = {size};\npub const PITCH: f64 = {PITCH:?};\n\
         pub const DESIGN: [[f64; 3]; {count}] = {positions:?};\n"
    )
}
