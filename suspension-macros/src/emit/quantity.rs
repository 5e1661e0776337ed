//! Quantities, which drives prescribe and measures read: what they are in the generated code.

use proc_macro2::TokenStream;
use quote::quote;

use super::form::{constant, sum};
use super::terms::ident;
use suspension_listing::name::Name;
use suspension_listing::system::{AXES, Drive, Quantity, Term};

/// The documentation of a field if the user gives none.
pub(super) fn describe(quantity: &Quantity) -> String {
    match quantity {
        Quantity::Sum(terms) => format!(" `{}`.", sum_in_words(terms)),
        Quantity::Angle {
            axis,
            line: [from, to],
        } => {
            let axis = AXES[*axis];
            format!(" Angle of `{from} -> {to}` from the {axis} axis, radians.")
        }
        Quantity::Between { lines, about } => {
            let [first, second] = lines
                .each_ref()
                .map(|[from, to]| format!("`{from} -> {to}`"));
            let about = about.as_ref();
            let about = about.map_or(String::new(), |[from, to]| {
                format!(", about `{from} -> {to}`")
            });
            format!(" Angle from {first} to {second}{about}, radians.")
        }
        Quantity::Length { line: [from, to] } => format!(" From `{from}` to `{to}`."),
        Quantity::Along { point, direction } => {
            let [x, y, z] = direction.map(|x| (x * 1e4).round() / 1e4);
            format!(" `{point}` along [{x}, {y}, {z}].")
        }
    }
}

/// `0.5 p.z - q.z`.
fn sum_in_words(terms: &[Term]) -> String {
    let mut words = String::new();
    for Term {
        factor,
        point,
        axis,
    } in terms
    {
        words += match (words.is_empty(), *factor < 0.0) {
            (true, false) => "",
            (true, true) => "-",
            (false, false) => " + ",
            (false, true) => " - ",
        };
        if factor.abs() != 1.0 {
            words += &format!("{} ", factor.abs());
        }
        words += &format!("{point}.{}", AXES[*axis]);
    }
    words
}

/// A sum of coordinates of the struct `points`.
fn sum_of(terms: &[Term]) -> TokenStream {
    sum(terms.iter().map(|term| {
        let (point, axis) = (&term.point, ident(AXES[term.axis]));
        (term.factor, quote!(points.#point.#axis))
    }))
}

/// `MeasureKind`.
pub(super) fn measure_kind(quantity: &Quantity) -> TokenStream {
    match quantity {
        Quantity::Angle { .. } | Quantity::Between { .. } => quote!(MeasureKind::Angle),
        _ => quote!(MeasureKind::Length),
    }
}

/// `DriveKind`.
pub(super) fn drive_kind(quantity: &Quantity) -> TokenStream {
    match quantity {
        Quantity::Angle { .. } => quote!(DriveKind::Angle),
        Quantity::Between { .. } => quote!(DriveKind::Turn),
        _ => quote!(DriveKind::Coordinate),
    }
}

/// The value and rates of a quantity, from the signal `points`.
pub(super) fn measured(quantity: &Quantity) -> TokenStream {
    let line = |[from, to]: &[Name; 2]| quote!(points.map(|points| points.#to - points.#from));
    match quantity {
        Quantity::Sum(terms) => {
            let sum = sum_of(terms);
            quote!(points.map(|points| #sum))
        }
        Quantity::Angle { axis, line: ends } => {
            let (axis, line) = (ident(AXES[*axis]), line(ends));
            quote!(measure::angle(&#line, Vector3::#axis()))
        }
        Quantity::Between { lines, about } => {
            let [first, second] = lines.each_ref().map(line);
            match about.as_ref().map(line) {
                Some(about) => quote!(measure::turn(&#first, &#second, &#about)),
                None => quote!(measure::between(&#first, &#second)),
            }
        }
        Quantity::Length { line: ends } => {
            let line = line(ends);
            quote!(measure::length(&#line))
        }
        Quantity::Along { point, direction } => {
            let direction = vector(direction);
            quote!(points.map(|points| dot(points.#point, #direction)))
        }
    }
}

/// The value of a drive at the positions `points`.
pub(super) fn driven(drive: &Drive) -> TokenStream {
    match &drive.quantity {
        Quantity::Sum(terms) => sum_of(terms),
        Quantity::Angle {
            axis,
            line: [from, to],
        } => {
            let (axis, distance) = (ident(AXES[*axis]), &drive.angle_of);
            quote!(parts::angle(points.#to.#axis - points.#from.#axis, self.#distance.length()))
        }
        Quantity::Between { .. } => {
            let measured = measured(&drive.quantity);
            quote!({ let points = Signal::still(*points); #measured.value })
        }
        Quantity::Length { line: [from, to] } => quote!((points.#to - points.#from).norm()),
        Quantity::Along { point, direction } => {
            let direction = vector(direction);
            quote!(dot(points.#point, #direction))
        }
    }
}

/// Converts a drive to the coordinate that its equation takes; `None` if it is that coordinate.
pub(super) fn coordinate(drive: &Drive) -> Option<TokenStream> {
    let (name, of) = (&drive.named.name, drive.angle_of.as_ref()?);
    let to_coordinate = match drive.quantity {
        Quantity::Between { .. } => quote!(turn_to_coordinate),
        _ => quote!(angle_to_coordinate),
    };
    Some(quote! {
        let angle = drives.map(|drives| drives.#name);
        let coordinate = #to_coordinate(self.#of.length(), angle);
        coordinates.set(coordinate, |drives| &mut drives.#name);
    })
}

/// Writes the value of a drive into the chassis point that it moves.
pub(super) fn moves(drive: &Drive) -> Option<TokenStream> {
    let (name, point) = (&drive.named.name, &drive.moves.as_ref()?.name);
    match &drive.quantity {
        Quantity::Sum(terms) => {
            let axis = ident(AXES[terms.first()?.axis]);
            Some(quote!(fixed.#point.#axis = drives.#name;))
        }
        Quantity::Along { direction, .. } => {
            let direction = vector(direction);
            Some(quote!(fixed.#point = moved_along(fixed.#point, #direction, drives.#name);))
        }
        _ => None,
    }
}

fn vector(direction: &[f64; 3]) -> TokenStream {
    let [x, y, z] = direction.map(constant);
    quote!(Vector3::new(#x, #y, #z))
}
