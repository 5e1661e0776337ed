//! Points of one side of the vehicle that a file moves, while their images on the other side stay where the listing has them.

use nalgebra::Vector3;

use crate::mechanism::name_on_other_side;
use crate::number::rounded;
use crate::prepare::notes::listed_points::moved_points::Points;

/// The number of digits of a coordinate.
const DIGITS: usize = 9;

/// The note on such points. The first points of the pairs in `already_noted` are already named in another note.
pub(super) fn note(points: &Points<'_>, already_noted: &[[usize; 2]]) -> Option<String> {
    let is_noted = |image: usize| already_noted.iter().any(|[point, _]| *point == image);
    let all = 0..points.names.len();
    let alone = all.filter_map(|point| {
        let image = image(points, point)?;
        (!is_noted(image)).then_some((point, image))
    });
    let (moved, images): (Vec<usize>, Vec<usize>) = alone.unzip();
    let (first, image) = (*moved.first()?, *images.first()?);
    let at = mirrored(points.moved[first]?).map(|part| rounded(part + 0.0, DIGITS)); // no -0
    let line = format!("{} = [{}, {}, {}]", points.names[image], at.x, at.y, at.z);
    let (their, state) = match moved.len() {
        1 => ("its image", format!("state {line} too if they should be")),
        _ => (
            "their images",
            format!("state them too, as {line}, if they should be"),
        ),
    };
    let quoted = |numbers: &[usize]| {
        let names = numbers
            .iter()
            .map(|point| format!("`{}`", points.names[*point]));
        names.collect::<Vec<_>>().join(", ")
    };
    let (moved, images) = (quoted(&moved), quoted(&images));
    Some(format!(
        "[points] moves {moved} and not {their} {images}: the two sides of the vehicle are no longer alike; {state}"
    ))
}

/// The image of a point that the file moves, if the file does not state the image; `None` if the listing's points are
/// not images of each other.
fn image(points: &Points<'_>, point: usize) -> Option<usize> {
    points.moved[point]?;
    let name = name_on_other_side(points.names[point])?;
    let image = points.names.iter().position(|other| *other == name)?;
    let places = [mirrored(points.listed[point]?), points.unstated[image]?];
    points.are_same(places).then_some(image)
}

fn mirrored(at: Vector3<f64>) -> Vector3<f64> {
    Vector3::new(at.x, -at.y, at.z)
}
