//! The style of methods in figures: colours for colour-blind readers (M. Okabe and K. Ito, Color Universal Design, 2008),
//! and shapes.

use maud::{Markup, html};

/// Text and lines.
pub const INK: &str = "#1a1a1a";

/// Families of methods, by the beginning of their names.
const FAMILIES: [(&str, &str); 8] = [
    ("nalgebra", "#000000"),
    ("dense", "#7f7f7f"),
    ("generated", "#0072b2"),
    ("bounded", "#56b4e9"),
    ("absolute", "#009e73"),
    ("relative", "#cc79a7"),
    ("series", "#e69f00"),
    ("baked", "#d55e00"),
];

/// The style of a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Style {
    /// The method's.
    pub colour: &'static str,
    shape: Shape,
    is_filled: bool,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Shape {
    Circle,
    Square,
    Diamond,
    Cross,
}

impl Style {
    /// The style of one of our methods: the colour by its name, hollow for `f32`, the shape by its lanes.
    pub fn new(method: &str, scalar: &str, lanes: usize) -> Self {
        let family = FAMILIES.iter().find(|(name, _)| method.starts_with(name));
        let shape = match lanes {
            1 => Shape::Circle,
            4 => Shape::Square,
            _ => Shape::Diamond,
        };
        Self {
            colour: family.map_or(INK, |(_, colour)| colour),
            shape,
            is_filled: scalar != "f32",
        }
    }

    /// The style of a rival.
    pub fn rival() -> Self {
        Self {
            colour: "#5a5a5a",
            shape: Shape::Cross,
            is_filled: false,
        }
    }

    /// The point.
    pub fn draw(&self, x: f64, y: f64) -> Markup {
        let fill = if self.is_filled { self.colour } else { "white" };
        let path = match self.shape {
            Shape::Circle => {
                return html! { circle cx=(x) cy=(y) r="4" fill=(fill) stroke=(self.colour) stroke-width="1.5" {} };
            }
            Shape::Square => "M-3.5 -3.5h7v7h-7z",
            Shape::Diamond => "M0 -5l5 5l-5 5l-5 -5z",
            Shape::Cross => "M-4 -4l8 8M-4 4l8 -8",
        };
        let at = format!("translate({x} {y})");
        html! { path d=(path) transform=(at) fill=(fill) stroke=(self.colour) stroke-width="1.5" {} }
    }
}

/// Width and height of the legend.
pub const LEGEND: (f64, f64) = (720.0, 62.0);

/// Returns the legend of colours and shapes, as a group of SVG elements of the size [`LEGEND`].
pub fn legend() -> Markup {
    const ACROSS: f64 = 82.0;
    const SHAPES: [(&str, &str, usize); 4] = [
        ("f64", "f64", 1),
        ("f32", "f32", 1),
        ("4 lanes", "f64", 4),
        ("8 lanes", "f64", 8),
    ];
    let entry = |column: usize, y: f64, style: Style, text: &str| {
        let x = 24.0 + ACROSS * column as f64;
        html! { (style.draw(x, y)) text x=(x + 10.0) y=(y + 4.0) { (text) } }
    };
    html! {
        g font-size="12" fill=(INK) {
            @for (column, (name, _)) in FAMILIES.iter().enumerate() {
                (entry(column, 16.0, Style::new(name, "f64", 1), name))
            }
            @for (column, (text, scalar, lanes)) in SHAPES.iter().enumerate() {
                (entry(column, 42.0, Style::new("", scalar, *lanes), text))
            }
            (entry(SHAPES.len(), 42.0, Style::rival(), "rival"))
            path d="M434 42h24" stroke=(INK) stroke-width="1.2" stroke-dasharray="5 3" {}
            text x="464" y="46" { "no method is faster and more accurate" }
        }
    }
}
