//! Points that stay where the listing has them, while the file moves the points around them.

use suspension_core::listing::{Kind, Parts};
use suspension_runtime::Listing;

use crate::file::MotionFile;
use crate::number::rounded;
use crate::prepare::notes::listed_points::moved_points::Points;

/// The displacement from the listing, in metres, above which a point belongs to a design of the user's own: such a
/// design has most points farther away, while those of one that was assembled from rough points are nearer.
const OWN: f64 = 0.01;

/// The largest change of a point beside another that is not stated, as a fraction of their distance: tuning a
/// hardpoint leaves the others where they are.
const TUNED: f64 = 0.25;

/// The number of digits of a number that tells a size.
const DIGITS_OF_A_SIZE: usize = 3;

/// The number of digits of an offset: that of coordinates, without those lost to rounding in their difference.
const DIGITS: usize = 9;

/// The points of the listing that the file does not state but probably should, each with the point that makes it
/// doubtful.
pub(super) fn kept(listing: &Listing, file: &MotionFile, points: &Points<'_>) -> Vec<[usize; 2]> {
    let far = OWN * file.length.metre();
    let all = 0..points.names.len();
    let moved = all.clone().filter_map(|point| points.moved_by_hand(point));
    let is_own = 2 * moved.filter(|off| *off > far).count() > points.names.len();
    let unstated = all.filter(|point| points.unstated[*point].is_some());
    let doubtful =
        unstated.filter_map(|point| Some([point, reason(points, listing, point, is_own)?]));
    doubtful.collect()
}

pub(super) fn note(
    kept: &[[usize; 2]],
    points: &Points<'_>,
    (listing, called): (&Listing, &str),
    file: &MotionFile,
) -> Option<String> {
    let [_, beside] = *kept.first()?;
    let quoted: Vec<String> = kept
        .iter()
        .map(|[point, _]| format!("`{}`", points.names[*point]))
        .collect();
    let (which_keep, them) = match quoted.len() {
        1 => ("which keeps its position", "it"),
        _ => ("which keep their positions", "them"),
    };
    let off = points.moved_by_hand(beside).unwrap_or_default();
    let (quoted, beside) = (quoted.join(", "), points.names[beside]);
    let (off, unit) = (rounded(off, DIGITS_OF_A_SIZE), file.length.symbol());
    let relative = relative(points, listing, kept);
    Some(format!(
        "[points] does not state {quoted}, {which_keep} of the listing `{called}`, while `{beside}` is {off} {unit} from where the \
         listing has it; state {them} too{relative}"
    ))
}

/// The changed point that makes a point doubtful that is not stated: the other point of its spin axis; a point of the
/// body that moves it, far from its position in the listing; or, in a design of the user's own, any point.
fn reason(points: &Points<'_>, listing: &Listing, point: usize, is_own: bool) -> Option<usize> {
    let most = |others: &mut dyn Iterator<Item = usize>| {
        let changed = others.filter_map(|other| Some((other, points.moved_by_hand(other)?)));
        let most = changed.max_by(|a, b| a.1.total_cmp(&b.1));
        most.map(|(other, _)| other)
    };
    let axes = wheels(listing).into_iter();
    let ends = axes.flat_map(|[inner, centre]| [[inner, centre], [centre, inner]]);
    let of_axis = ends.filter_map(|[one, other]| (one == point).then_some(other));
    let moves = point >= listing.count(Kind::ChassisPoint);
    let joined = joined(listing);
    let of_parts = joined.iter().filter(|part| moves && part.contains(&point));
    let is_far = |other: &usize| {
        let apart = points.listed[*other].zip(points.listed[point]);
        let apart = apart.map(|(other, point)| (other - point).norm());
        points
            .moved_by_hand(*other)
            .zip(apart)
            .is_some_and(|(off, apart)| off > TUNED * apart)
    };
    let of_parts = of_parts.flatten().copied().filter(is_far);
    most(&mut of_axis.chain(of_parts))
        .or_else(|| most(&mut (0..points.names.len())).filter(|_| is_own))
}

/// How to state the inner point of a spin axis, if it should be stated.
fn relative(points: &Points<'_>, listing: &Listing, kept: &[[usize; 2]]) -> String {
    let axes = wheels(listing);
    let of_axis = axes.iter().find(|[inner, centre]| {
        let is_kept = kept.iter().any(|[point, _]| point == inner);
        is_kept && points.unstated[*centre].is_none()
    });
    let offset = of_axis.and_then(|[inner, centre]| {
        let offset = points.listed[*inner]? - points.listed[*centre]?;
        let offset = offset.map(|part| rounded(part, DIGITS));
        let [inner, centre] = [points.names[*inner], points.names[*centre]];
        Some(format!(
            ", as {inner} = {{ from = \"{centre}\", offset = [{}, {}, {}] }}",
            offset.x, offset.y, offset.z
        ))
    });
    offset.unwrap_or_default()
}

/// The spin axes.
fn wheels(listing: &Listing) -> Vec<[usize; 2]> {
    let wheels = (0..).map_while(|wheel| listing.wheel(wheel));
    wheels.map(|wheel| wheel.axis).collect()
}

/// The points of each body, including those of a body with a marker that it carries.
fn joined(listing: &Listing) -> Vec<Vec<usize>> {
    let carriers = listing.carriers().into_iter();
    let carried = carriers.map(|(marker, body)| [&[marker], body.as_slice()].concat());
    carried.chain(listing.bodies()).collect()
}
