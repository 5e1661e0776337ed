//! Coordinates and lengths that an option moves together, by their names.

use nalgebra::Vector3;
use suspension_listing::did_you_mean::{did_you_mean, unknown};

use crate::failure::Failure;
use crate::kinematics::{Changes, Kinematics};
use crate::mechanism::{Description, moved_together, name_on_other_side, quoted};
use crate::prepare::loaded::Loaded;
use crate::quantities::Axis;
use crate::sensitivities::Change;

/// Smaller displacements per unit are none.
const ROUNDING: f64 = 1e-9;

/// What coordinates of one point move, multiplied by their signs: the point, and others that it takes along.
struct Part {
    point: usize,
    moved: Vec<(usize, Vector3<f64>)>,
}

impl Part {
    /// The displacement of a point; `None` if it does not move.
    fn displacement(&self, point: usize) -> Option<Vector3<f64>> {
        let each = self.moved.iter().filter(|(moved, _)| *moved == point);
        let by: Vector3<f64> = each.map(|(_, by)| by).sum();
        (by.norm() > ROUNDING).then_some(by)
    }

    /// Whether it takes a point along that another part moves too, as two points on a line take the line.
    fn shares_with(&self, other: &Part) -> bool {
        let mut points = self.moved.iter().map(|(moved, _)| *moved);
        let moves_too = |part: &Part, point| part.displacement(point).is_some();
        points.any(|point| point != self.point && moves_too(self, point) && moves_too(other, point))
    }
}

impl Loaded<'_> {
    /// The change, per unit of length, of the coordinates, lengths and moves in `words`, each of which is one of
    /// [`changes`](Self::changes): `rack.z`, `tie_rod`, or several joined by commas, of which one behind a minus changes the
    /// opposite way. A point that coordinates of two others take along is moved once; moves are added.
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
        let mut others: Vec<Changes> = Vec::new();
        for (name, sign) in moved_together(words) {
            if names.contains(&name) {
                return Err(refuse(format!("`{name}` is given twice; remove one")));
            }
            let change = find(&known, name);
            let change = change.ok_or_else(|| refuse(describe_unknown(mechanism, &known, name)))?;
            names.push(name);
            let changes = change.per_unit.times(sign);
            let coordinate = name.rsplit_once('.');
            match coordinate.and_then(|(point, _)| mechanism.names.point(point)) {
                Some(point) => add(&mut parts, point, changes.points),
                None => others.push(changes),
            }
        }
        let points = merged(&parts).map_err(|point| {
            let point = &mechanism.names.points[point];
            refuse(format!(
                "`{words}` moves `{point}` in two ways: a point on a line of the chassis, as the end of a rack, takes the line and \
                 what slides on it along; leave one of the names out"
            ))
        })?;
        others.push(Changes {
            points,
            ..Changes::default()
        });
        Ok(Change {
            name: words.to_owned(),
            per_unit: Changes::sum(others.into_iter()),
        })
    }
}

/// What is before the name of a link in that of the change of its length.
const LENGTH: &str = "length ";

/// A coordinate, a length without or with the word before it, or a move.
fn find<'a>(known: &'a [Change], name: &str) -> Option<&'a Change> {
    let called = |name: &str| known.iter().find(|change| change.name == name);
    called(name).or_else(|| called(&format!("{LENGTH}{name}")))
}

/// Adds a part; coordinates of the same point move it together.
fn add(parts: &mut Vec<Part>, point: usize, moved: Vec<(usize, Vector3<f64>)>) {
    let mut others = parts.iter_mut();
    match others.find(|part| part.point == point) {
        Some(part) => part.moved.extend(moved),
        None => parts.push(Part { point, moved }),
    }
}

/// The displacements of all parts together.
///
/// # Errors
///
/// A point that parts take along differently.
fn merged(parts: &[Part]) -> Result<Vec<(usize, Vector3<f64>)>, usize> {
    let mut all: Vec<(usize, Vector3<f64>)> = Vec::new();
    for (point, _) in parts.iter().flat_map(|part| &part.moved) {
        if !all.iter().any(|(done, _)| done == point) {
            let by = displacement(parts, *point).ok_or(*point)?;
            all.push((*point, by));
        }
    }
    Ok(all)
}

/// The displacement of a point: its own, and along the axes that its names leave out that of the parts which take it along.
/// `None` if these differ.
fn displacement(parts: &[Part], point: usize) -> Option<Vector3<f64>> {
    let (own, others): (Vec<&Part>, Vec<&Part>) =
        parts.iter().partition(|part| part.point == point);
    let mut taken = others.iter().filter_map(|part| part.displacement(point));
    let along = taken.next().unwrap_or_default();
    if taken.any(|other| (other - along).norm() > ROUNDING) {
        return None;
    }
    Some(match own.first() {
        Some(part) if others.iter().any(|other| part.shares_with(other)) => {
            part.displacement(point).unwrap_or_default()
        }
        Some(part) => {
            let own = part.displacement(point).unwrap_or_default();
            own.zip_map(&along, |own, along| if own == 0.0 { along } else { own })
        }
        None => along,
    })
}

/// A sentence about a name that is none of the changes.
fn describe_unknown(mechanism: &Description, known: &[Change], name: &str) -> String {
    let points = mechanism.names.point_names();
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
        None => describe_no_change(mechanism, known, name),
    }
}

/// The same about a name without an axis: what is near to it, or what it is instead and all that can be changed.
fn describe_no_change(mechanism: &Description, known: &[Change], name: &str) -> String {
    let names = &mechanism.names;
    let what = match (names.drive(name), names.measure(name)) {
        (Some(_), _) => "a drive, which moves the suspension and is no part of its design",
        (None, Some(_)) => "a measure, which follows from the points",
        (None, None) => "no coordinate of a point, no link and no move of [tune]",
    };
    let whole = known.iter().map(|change| change.name.as_str());
    let whole = whole.filter(|change| !change.contains('.'));
    let (links, moves): (Vec<_>, Vec<_>) = whole.partition(|change| change.starts_with(LENGTH));
    let links: Vec<&str> = links
        .into_iter()
        .map(|link| &link[LENGTH.len()..])
        .collect();
    let points = names.point_names();
    let each = links.iter().chain(&moves).chain(&points);
    let meant = did_you_mean(name, each.copied());
    if what.starts_with("no") && !meant.is_empty() {
        return format!("`{name}` is {what}{meant}");
    }
    let kinds = [
        ("the links", &links),
        ("the moves of [tune]", &moves),
        ("x, y or z of the points", &points),
    ];
    let kinds = kinds.iter().filter(|(_, names)| !names.is_empty());
    let kinds = kinds.map(|(kind, names)| format!("{kind} {}", names.join(", ")));
    let kinds: Vec<String> = kinds.collect();
    format!(
        "`{name}` is {what}; what can be varied: {}",
        kinds.join("; ")
    )
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
    let exists = |name: &str| names.point(name).is_some() || names.link(name).is_some();
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
        stays.push(other);
    }
    let stay = match stays.len() {
        0 => return None,
        1 => "stays as it is",
        _ => "stay as they are",
    };
    Some(format!(
        "`{name}` moves only one side of the vehicle, {} of the other side {stay}; {name},{} keeps both sides alike",
        quoted(stays),
        added.join(","),
        name = change.name
    ))
}
