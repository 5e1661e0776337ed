//! Coordinates and lengths that an option moves together, by their names.

use nalgebra::Vector3;
use suspension_listing::did_you_mean::{did_you_mean, unknown};

use crate::failure::Failure;
use crate::kinematics::{Changes, Kinematics};
use crate::load::loaded::Loaded;
use crate::mechanism::{Description, moved_together, name_on_other_side};
use crate::quantities::Axis;
use crate::sensitivities::Change;

/// What one name moves, multiplied by its sign.
struct Part {
    /// The point that is named; `None` for a length and for a move of `[tune]`.
    point: Option<usize>,
    changes: Changes,
}

impl Part {
    /// The displacement of a point; `None` if it does not move.
    fn displacement(&self, point: usize) -> Option<Vector3<f64>> {
        let of_point = self.changes.points.iter();
        let mut each = of_point.filter(|(moved, _)| *moved == point);
        let (_, first) = each.next()?;
        Some(each.fold(*first, |sum, (_, by)| sum + by))
    }
}

impl Loaded<'_> {
    /// The change, per unit of length, of the coordinates, lengths and moves in `words`, each of which is one of
    /// [`changes`](Self::changes): `rack.z`, `tie_rod`, or several joined by commas, of which one behind a minus changes the
    /// opposite way. A point that two of them move is moved once.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] at a name that is none of them or given twice, and at a point that two of them move differently.
    pub fn change_together(
        &self,
        mechanism: &dyn Kinematics,
        words: &str,
    ) -> Result<Change, Failure> {
        let known = self.changes(mechanism)?;
        let refuse = |message: String| Failure::Input(format!("{}: {message}", self.source.name()));
        let mut names: Vec<&str> = Vec::new();
        let mut parts: Vec<Part> = Vec::new();
        for (name, sign) in moved_together(words) {
            if names.contains(&name) {
                return Err(refuse(format!("`{name}` is given twice; remove one")));
            }
            let change = find(&known, name);
            let change = change.ok_or_else(|| refuse(describe_unknown(mechanism, &known, name)))?;
            names.push(name);
            add(
                &mut parts,
                named_point(mechanism, name),
                change.per_unit.times(sign),
            );
        }
        let per_unit = merged(&parts).map_err(|point| {
            let point = &mechanism.names.points[point];
            refuse(format!(
                "`{words}` moves `{point}` in two ways: a point on a line of the chassis, as the end of a rack, takes the line and \
                 what slides on it along; leave one of the names out"
            ))
        })?;
        Ok(Change {
            name: words.to_owned(),
            per_unit,
        })
    }
}

/// A coordinate, a length without or with the word before it, or a move.
fn find<'a>(known: &'a [Change], name: &str) -> Option<&'a Change> {
    let called = |name: &str| known.iter().find(|change| change.name == name);
    called(name).or_else(|| called(&format!("length {name}")))
}

fn named_point(mechanism: &Description, name: &str) -> Option<usize> {
    let (point, _) = name.rsplit_once('.')?;
    let mut points = mechanism.names.points.iter();
    points.position(|known| known == point)
}

/// Adds a part; coordinates of the same point move it together.
fn add(parts: &mut Vec<Part>, point: Option<usize>, changes: Changes) {
    let mut others = parts.iter_mut();
    let same = others.find(|part| point.is_some() && part.point == point);
    match same {
        Some(part) => part.changes.points.extend(changes.points),
        None => parts.push(Part { point, changes }),
    }
}

/// All parts together. A point that is named moves as its own coordinates say, another as the parts that take it along say.
///
/// # Errors
///
/// The point that parts move differently.
fn merged(parts: &[Part]) -> Result<Changes, usize> {
    const ROUNDING: f64 = 1e-9;
    let mut all = Changes::default();
    for (point, _) in parts.iter().flat_map(|part| &part.changes.points) {
        if all.points.iter().any(|(done, _)| done == point) {
            continue;
        }
        let own = parts.iter().find(|part| part.point == Some(*point));
        let moved_by = |part: &Part| part.displacement(*point);
        let by = match own {
            Some(own) => moved_by(own).into_iter().collect(),
            None => parts.iter().filter_map(moved_by).collect::<Vec<_>>(),
        };
        if by.iter().any(|other| (other - by[0]).norm() > ROUNDING) {
            return Err(*point);
        }
        all.points.push((*point, by[0]));
    }
    let lengths = parts.iter().flat_map(|part| &part.changes.lengths);
    all.lengths = lengths.copied().collect();
    Ok(all)
}

/// A sentence about a name that is none of the changes.
fn describe_unknown(mechanism: &Description, known: &[Change], name: &str) -> String {
    let points = mechanism.names.points.iter().map(String::as_str);
    let points: Vec<&str> = points.collect();
    let axes = |point: &str| {
        let axes = Axis::ALL.map(|axis| format!("{point}.{axis}"));
        format!("write {}, {} or {}", axes[0], axes[1], axes[2])
    };
    match name.rsplit_once('.') {
        Some((point, axis)) if points.contains(&point) => {
            format!("`{axis}` is no axis; {}", axes(point))
        }
        Some((point, _)) => unknown("point", point, &points),
        None if points.contains(&name) => {
            format!(
                "`{name}` is a point, of which one coordinate moves; {}",
                axes(name)
            )
        }
        None => {
            let others = known.iter().filter(|change| !change.name.contains('.'));
            let others = others.map(|change| change.name.trim_start_matches("length "));
            let meant = did_you_mean(name, others.chain(points.iter().copied()));
            format!(
                "`{name}` is no coordinate of a point, as {}.z, no link and no move of [tune]{meant}",
                points.first().unwrap_or(&"POINT")
            )
        }
    }
}

/// A note on points or links of one side that a change moves, whose counterparts on the other side it does not, with the
/// names that move both.
pub fn describe_one_sided(mechanism: &Description, change: &Change) -> Option<String> {
    let names = &mechanism.names;
    let moves = |name: &str| {
        let Changes { points, lengths } = &change.per_unit;
        points.iter().any(|(point, _)| names.points[*point] == name)
            || lengths
                .iter()
                .any(|(length, _)| names.lengths[*length] == name)
    };
    let exists = |name: &str| {
        names.points.iter().any(|point| point == name)
            || names.links().any(|(link, _)| link == name)
    };
    let mut added = Vec::new();
    let mut stays = Vec::new();
    for (name, sign) in moved_together(&change.name) {
        let (part, axis) = match name.rsplit_once('.') {
            Some((point, axis)) => (point, format!(".{axis}")),
            None => (name, String::new()),
        };
        let Some(other) = name_on_other_side(part).filter(|other| exists(other) && !moves(other))
        else {
            continue;
        };
        let sign = if axis == ".y" { -sign } else { sign };
        added.push(format!(
            "{}{other}{axis}",
            if sign < 0.0 { "-" } else { "" }
        ));
        stays.push(format!("`{other}`"));
    }
    (!added.is_empty()).then(|| {
        format!(
            "`{}` moves only one side of the vehicle, and {} of the other side stays as it is; {},{} keeps both sides alike",
            change.name,
            stays.join(", "),
            change.name,
            added.join(",")
        )
    })
}
