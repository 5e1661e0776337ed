//! Points that stay where the listing has them, while those that the file states around them are elsewhere.

use nalgebra::Vector3;
use suspension_core::listing::{Kind, Parts};
use suspension_runtime::Listing;

use crate::file::{MotionFile, Offset, Position};
use crate::load::points::points;
use crate::mechanism::Axes;
use crate::number::rounded;

/// Points that are nearer, in metres, are in the same place.
const SAME: f64 = 1e-6;

/// A design of the user's own has most points further, in metres, from where the listing has them; those of one that was assembled
/// from rough points are nearer.
const OWN: f64 = 0.01;

/// How far a point may be changed beside another that is not stated, as a part of their distance: a hardpoint that is tuned
/// leaves the others where they are.
const TUNED: f64 = 0.25;

/// Digits of a number that tells how large something is.
const DIGITS_OF_A_SIZE: usize = 3;

/// Digits of an offset: those of coordinates, without what their difference rounds.
const DIGITS: usize = 9;

/// What points of the listing the file does not state and, as it seems, should. `axes` are those of the listing.
pub(super) fn note(listing: &Listing, file: &MotionFile, name: &str, axes: Axes) -> Option<String> {
    let points = Points::of(listing, file, axes);
    let far = OWN * file.length.metre();
    let changed = points.changed.iter().flatten().filter(|off| **off > far);
    let is_own = 2 * changed.count() > points.names.len();
    let unstated = points.unstated.iter().enumerate();
    let unstated = unstated.filter_map(|(point, at)| at.map(|_| point));
    let kept = unstated.filter_map(|point| Some((point, points.reason(listing, point, is_own)?)));
    let kept: Vec<(usize, usize)> = kept.collect();
    let [first, ..] = kept.as_slice() else {
        return None;
    };
    let quoted: Vec<String> = kept
        .iter()
        .map(|(point, _)| format!("`{}`", points.names[*point]))
        .collect();
    let (which_keep, them) = match quoted.len() {
        1 => ("which keeps its position", "it"),
        _ => ("which keep their positions", "them"),
    };
    let (quoted, beside) = (quoted.join(", "), points.names[first.1]);
    let off = rounded(
        points.changed[first.1].unwrap_or_default(),
        DIGITS_OF_A_SIZE,
    );
    let unit = file.length.symbol();
    let relative = points.relative(listing, &kept);
    Some(format!(
        "[points] does not state {quoted}, {which_keep} of the listing `{name}`, while `{beside}` is {off} {unit} from where the \
         listing has it; state {them} too{relative}"
    ))
}

/// The points of a listing, by place.
struct Points<'a> {
    names: Vec<&'a str>,
    /// Where the listing has them.
    listed: Vec<Option<Vector3<f64>>>,
    /// How far from there the file has those that it states; `None` where that is the same place.
    changed: Vec<Option<f64>>,
    /// Where those are that the file does not state.
    unstated: Vec<Option<Vector3<f64>>>,
}

impl<'a> Points<'a> {
    fn of(listing: &'a Listing, file: &MotionFile, axes: Axes) -> Self {
        let names: Vec<&str> = points(listing).collect();
        let mut listed = vec![None; names.len()];
        for (point, at) in listing.stated() {
            listed[point] = Some(axes.turned(at));
        }
        let stated = file.points.get_ref();
        let place = |name: &str| {
            let listed = listing.point(name).and_then(|point| listed[point]);
            match stated.get(name).map(toml::Spanned::get_ref) {
                Some(Position::At(at)) => Some(Vector3::from(*at)),
                _ => listed,
            }
        };
        let same = SAME * file.length.metre();
        let each = names.iter().zip(&listed);
        let changed = each.clone().map(|(name, listed)| {
            let at = match stated.get(*name)?.get_ref() {
                Position::At(at) => Vector3::from(*at),
                Position::Off(Offset { from, offset }) => {
                    place(from.get_ref())? + Vector3::from(*offset)
                }
            };
            let off = (at - (*listed)?).norm();
            (off > same).then_some(off)
        });
        let unstated = each.map(|(name, listed)| listed.filter(|_| !stated.contains_key(*name)));
        Self {
            changed: changed.collect(),
            unstated: unstated.collect(),
            names,
            listed,
        }
    }

    /// The changed point that makes one that is not stated doubtful: the other of its spin axis; one of the body that moves it,
    /// far from where the listing has it; or in a design of the user's own any.
    fn reason(&self, listing: &Listing, point: usize, is_own: bool) -> Option<usize> {
        let most = |others: &mut dyn Iterator<Item = usize>| {
            let changed = others.filter_map(|other| Some((other, self.changed[other]?)));
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
            let apart = self.listed[*other].zip(self.listed[point]);
            let apart = apart.map(|(other, point)| (other - point).norm());
            self.changed[*other]
                .zip(apart)
                .is_some_and(|(off, apart)| off > TUNED * apart)
        };
        let of_parts = of_parts.flatten().copied().filter(is_far);
        most(&mut of_axis.chain(of_parts))
            .or_else(|| most(&mut (0..self.names.len())).filter(|_| is_own))
    }

    /// How to state the inner point of a spin axis, where it is one that should be.
    fn relative(&self, listing: &Listing, kept: &[(usize, usize)]) -> String {
        let axes = wheels(listing);
        let of_axis = axes.iter().find(|[inner, centre]| {
            let is_kept = kept.iter().any(|(point, _)| point == inner);
            is_kept && self.unstated[*centre].is_none()
        });
        let offset = of_axis.and_then(|[inner, centre]| {
            let offset = self.listed[*inner]? - self.listed[*centre]?;
            let offset = offset.map(|part| rounded(part, DIGITS));
            let [inner, centre] = [self.names[*inner], self.names[*centre]];
            Some(format!(
                ", as {inner} = {{ from = \"{centre}\", offset = [{}, {}, {}] }}",
                offset.x, offset.y, offset.z
            ))
        });
        offset.unwrap_or_default()
    }
}

/// The spin axes.
fn wheels(listing: &Listing) -> Vec<[usize; 2]> {
    let wheels = (0..).map_while(|wheel| listing.wheel(wheel));
    wheels.map(|wheel| wheel.axis).collect()
}

/// The points of each body, and of a body with a marker that it carries.
fn joined(listing: &Listing) -> Vec<Vec<usize>> {
    let carriers = listing.carriers().into_iter();
    let carried = carriers.map(|(marker, body)| [&[marker], body.as_slice()].concat());
    carried.chain(listing.bodies()).collect()
}
