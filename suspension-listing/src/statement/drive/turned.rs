//! A driven angle between two lines `d` and `e` about a third one, `n`:
//!
//! ```text
//! w = n x d / |n|    p = d.n / |n|    r = e.n / |n|    x = (d.e - p r) / L    y = w.e / L    cos y - sin x = 0
//! ```
//!
//! with `L` the geometric mean of `|d|` and `|e|`. The drive prescribes the sine of a quarter of the angle, from which
//! sine and cosine of the half and of the whole follow ([`Turn`]): all times `L`.

use syn::{Error, Ident};

use super::KIND;
use crate::errors;
use crate::form::{Bilinear, Factor, Form, Multiplied, Turn};
use crate::listing::{Listing, Lowering};
use crate::lower::origin;
use crate::name::{Name, Named};
use crate::site::Site;
use crate::system::{AXES, System, turn_name};

/// Adds the equations of a driven angle, except the drive's own.
pub(super) fn lower(
    lowering: &mut Lowering<'_>,
    drive: &Name,
    lines: &[[Ident; 2]; 2],
    about: &[Ident; 2],
) -> Turned {
    let line = |ends: &[Ident; 2]| ends.each_ref().map(|end| lowering.site(end));
    let ([d, e], n) = (lines.each_ref().map(line), line(about));
    let equations = Equations {
        drive,
        lines: [d, e, n],
    };
    for (name, form) in equations
        .line_equations()
        .into_iter()
        .chain(equations.angle_equations())
    {
        let scalars = match &form {
            Form::Bilinear(form) => form.defines.iter().cloned().collect(),
            Form::Turn(form) => vec![form.sine.clone(), form.cosine.clone()],
            _ => Vec::new(),
        };
        lowering.system.scalars.extend(scalars);
        let docs = Vec::new();
        lowering.equation(Named { name, docs }, origin(KIND, drive, None), form);
    }
    Turned {
        sine: equations.name("quarter_sine"),
        equation: equations.name("quarter"),
    }
}

/// The part of a driven angle that occurs in the drive's own equation.
pub(super) struct Turned {
    /// The unknown that it prescribes.
    pub(super) sine: Name,
    /// The equation whose length makes this the sine of a quarter of the angle.
    pub(super) equation: Name,
}

/// The indices of the lines in [`Equations`].
const D: usize = 0;
const E: usize = 1;
const N: usize = 2;

struct Equations<'a> {
    drive: &'a Name,
    /// `d`, `e` and `n`.
    lines: [[Site; 2]; 3],
}

type Stated = (Name, Form);

impl Equations<'_> {
    fn name(&self, part: &str) -> Name {
        turn_name(self.drive, part)
    }

    fn unknown(&self, part: &str) -> Factor {
        Factor::Unknown(self.name(part))
    }

    /// The products of two lines' coordinates.
    fn dot(&self, by: f64, first: usize, second: usize) -> Vec<Multiplied> {
        let each = |axis| Multiplied {
            by,
            factors: [first, second].map(|line| self.edge(line, axis)),
        };
        [0, 1, 2].map(each).to_vec()
    }

    fn edge(&self, line: usize, axis: usize) -> Factor {
        let line = self.lines[line].clone();
        Factor::Edge { line, axis }
    }

    /// Products over `L` that define an unknown with the equation's name.
    fn defined(&self, part: &str, constant: f64, products: Vec<Multiplied>) -> Stated {
        let [d, e, _] = self.lines.clone();
        self.stated(part, constant, products, vec![d, e])
    }

    /// Products over `|n|` that define an unknown with the equation's name.
    fn defined_about_axis(&self, part: &str, products: Vec<Multiplied>) -> Stated {
        let [.., n] = self.lines.clone();
        self.stated(part, 0.0, products, vec![n])
    }

    fn stated(
        &self,
        part: &str,
        constant: f64,
        products: Vec<Multiplied>,
        length: Vec<[Site; 2]>,
    ) -> Stated {
        let name = self.name(part);
        let form = Bilinear {
            defines: Some(name.clone()),
            constant,
            products,
            length,
        };
        (name, Form::Bilinear(form))
    }

    /// The equations for the position of the lines relative to each other.
    fn line_equations(&self) -> Vec<Stated> {
        let normal = |axis: usize| {
            let [next, last] = [(axis + 1) % 3, (axis + 2) % 3];
            let product = |by, [of_n, of_d]: [usize; 2]| Multiplied {
                by,
                factors: [self.edge(N, of_n), self.edge(D, of_d)],
            };
            let products = vec![product(-1.0, [next, last]), product(1.0, [last, next])];
            self.defined_about_axis(&format!("normal_{}", AXES[axis]), products)
        };
        let mut along = self.dot(-1.0, D, E);
        along.push(Multiplied {
            by: 1.0,
            factors: [self.unknown("first_along"), self.unknown("second_along")],
        });
        let across = (0..3).map(|axis| Multiplied {
            by: -1.0,
            factors: [
                self.unknown(&format!("normal_{}", AXES[axis])),
                self.edge(E, axis),
            ],
        });
        let mut stated: Vec<Stated> = [0, 1, 2].map(normal).to_vec();
        stated.extend([
            self.defined_about_axis("first_along", self.dot(-1.0, D, N)),
            self.defined_about_axis("second_along", self.dot(-1.0, E, N)),
            self.defined("along", 0.0, along),
            self.defined("across", 0.0, across.collect()),
        ]);
        stated
    }

    /// The equations for the angle, and for the lines at this angle.
    fn angle_equations(&self) -> Vec<Stated> {
        let product = |by, factors: [&str; 2]| Multiplied {
            by,
            factors: factors.map(|part| self.unknown(part)),
        };
        let turn = Form::Turn(Turn {
            lines: self.lines.clone(),
            sine: self.name("quarter_sine"),
            cosine: self.name("quarter_cosine"),
        });
        let double = |sine: &str, cosine: &str, [of_sine, of_cosine]: [&str; 2]| {
            let twice = vec![product(-2.0, [of_sine, of_cosine])];
            let square = vec![product(2.0, [of_sine, of_sine])];
            [
                self.defined(sine, 0.0, twice),
                self.defined(cosine, -1.0, square),
            ]
        };
        let quarter = ["quarter_sine", "quarter_cosine"];
        let half = ["half_sine", "half_cosine"];
        let [d, e, _] = self.lines.clone();
        let direction = Form::Bilinear(Bilinear {
            defines: None,
            constant: 0.0,
            products: vec![
                product(1.0, ["cosine", "across"]),
                product(-1.0, ["sine", "along"]),
            ],
            length: vec![d, e],
        });
        let mut stated = vec![(self.name("quarter"), turn)];
        stated.extend(double("half_sine", "half_cosine", quarter));
        stated.extend(double("sine", "cosine", half));
        stated.push((self.name("direction"), direction));
        stated
    }
}

/// The mistake in a driven angle: something must keep the length of its axis, and nothing may keep the angle.
pub(super) fn check(
    drive: &Ident,
    lines: &[[Ident; 2]; 2],
    about: &[Ident; 2],
    listing: &Listing,
    system: &System,
) -> Option<Error> {
    let points: Vec<&Ident> = lines.iter().chain([about]).flatten().collect();
    // Anything else is reported as an operand.
    if !listing.has_points(points.iter().copied()) {
        return None;
    }
    if let Some(body) = system.body_of(points) {
        let lines = format!("the lines of `{drive}` and its axis are");
        let remedy = ", which keeps their angle; take a line";
        return Some(errors::points_of_one_body(drive, &lines, body, remedy));
    }
    let [from, to] = about;
    if from == to {
        return None;
    }
    if !listing.keeps_apart(system, [from, to]) {
        return Some(listing.distance_not_constant([from, to], "the axis of an angle"));
    }
    let mut lines = lines.iter();
    let along = lines.find(|line| listing.are_parallel([line, about]))?;
    Some(along_axis(along, about))
}

fn along_axis([from, to]: &[Ident; 2], [start, end]: &[Ident; 2]) -> Error {
    errors::at(
        from,
        format!(
            "the line `{from} -> {to}` lies along the axis `{start} -> {end}` at the design position, where its angle about \
             the axis is not determined; name a line off the axis"
        ),
    )
}

pub(super) fn missing_axis(drive: &Ident) -> Error {
    errors::at(
        drive,
        "a driven angle between two lines needs the line about which it turns; \
         write `angle(p -> q, r -> s about t -> u)`",
    )
}
