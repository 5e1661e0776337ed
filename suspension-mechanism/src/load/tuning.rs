//! What a motion file says of tuning, by the numbers of what it names.

use nalgebra::Vector3;
use suspension_listing::did_you_mean::did_you_mean;
use suspension_runtime::Listing;
use toml::Spanned;

use crate::characteristics::columns;
use crate::failure::Failure;
use crate::file::{
    AxisName, Direction, MotionFile, MoveTable, Source, Table, TargetTable, TuneTable, Wanted,
};
use crate::kinematics::Changes;
use crate::mechanism::{self, Description, evenly_spaced};
use crate::quantities::{Axis, Column, catalogue};
use crate::tune::{self, Move, Reading, Target};

/// Places along a drive where the file states one number for all.
const PLACES: usize = 13;

/// The moves and targets of a file, in its order.
///
/// # Errors
///
/// [`Failure::Input`] at the first name that is none of the mechanism's, at what is missing, and at a box without room.
pub(super) fn tuning(
    source: &Source,
    file: &MotionFile,
    listing: &Listing,
    mechanism: &Description,
) -> Result<(Vec<Move>, Vec<Target>), Failure> {
    let Some(table) = &file.tune else {
        let message = "nothing to tune: write [tune.moves.NAME] and [tune.targets.NAME], see suspension tune --help";
        return Err(source.refuse(&(0..0), message));
    };
    let reader = Reader {
        source,
        file,
        listing,
        mechanism,
    };
    let TuneTable { moves, targets } = table.get_ref();
    let moves = in_order(moves).map(|(name, each)| reader.of_move(name, each));
    let moves: Vec<Move> = moves.collect::<Result<_, _>>()?;
    let targets = in_order(targets).map(|(name, each)| reader.of_target(name, each));
    let targets: Vec<Target> = targets.collect::<Result<_, _>>()?;
    match (moves.is_empty(), targets.is_empty()) {
        (false, false) => Ok((moves, targets)),
        (true, _) => Err(source.refuse(&table.span(), "no moves: write [tune.moves.NAME]")),
        (_, true) => Err(source.refuse(&table.span(), "no targets: write [tune.targets.NAME]")),
    }
}

fn in_order<V>(table: &Table<V>) -> impl Iterator<Item = (&Spanned<String>, &Spanned<V>)> {
    let mut stated: Vec<_> = table.get_ref().iter().collect();
    stated.sort_by_key(|(name, _)| name.span().start);
    stated.into_iter()
}

/// The points with the markers that follow them.
fn with_markers(
    mut points: Vec<(usize, Vector3<f64>)>,
    followers: &[[usize; 2]],
) -> Vec<(usize, Vector3<f64>)> {
    for [marker, from] in followers {
        let along = points
            .iter()
            .find(|(point, _)| point == from)
            .map(|(_, along)| *along);
        if !points.iter().any(|(point, _)| point == marker) {
            points.extend(along.map(|along| (*marker, along)));
        }
    }
    points
}

struct Reader<'a> {
    source: &'a Source,
    file: &'a MotionFile,
    listing: &'a Listing,
    mechanism: &'a Description,
}

impl Reader<'_> {
    fn of_move(
        &self,
        name: &Spanned<String>,
        stated: &Spanned<MoveTable>,
    ) -> Result<Move, Failure> {
        let table = stated.get_ref();
        let by = *table.by.get_ref();
        if !(by[0] < by[1] && by.iter().all(|end| end.is_finite())) {
            let message =
                "`by` is [least, greatest], how far it may be moved, as [-0.010, 0.010] in metres";
            return Err(self.source.refuse(&table.by.span(), message));
        }
        let of_points = !table.points.is_empty() || !table.mirrored.is_empty();
        if let (Some(length), Some(along)) = (&table.length, &table.along) {
            let message = format!(
                "`along` is of points; link `{}` becomes longer along itself",
                length.get_ref()
            );
            return Err(self.source.refuse(&along.span(), message));
        }
        let per_unit = match (&table.length, of_points) {
            (Some(length), false) => Changes {
                lengths: vec![(self.length(length)?, 1.0)],
                ..Changes::default()
            },
            (None, true) => self.of_points(name, table)?,
            _ => {
                let message = "a move has `points` with `along`, or `length`, the name of a link";
                return Err(self.source.refuse(&name.span(), message));
            }
        };
        Ok(Move {
            name: name.get_ref().clone(),
            per_unit,
            by,
        })
    }

    fn of_points(&self, name: &Spanned<String>, table: &MoveTable) -> Result<Changes, Failure> {
        let Some(along) = &table.along else {
            let message = "`along` is missing: write \"x\", \"y\", \"z\" or a direction [x, y, z]";
            return Err(self.source.refuse(&name.span(), message));
        };
        let along = self.direction(along)?;
        let mirrored = Vector3::new(along.x, -along.y, along.z);
        let ways = [(&table.points, along), (&table.mirrored, mirrored)];
        let each = ways
            .into_iter()
            .flat_map(|(points, along)| points.iter().map(move |point| (point, along)));
        let mut points: Vec<(usize, Vector3<f64>)> = Vec::new();
        for (name, along) in each {
            let point = self.point(name)?;
            if points.iter().any(|(other, _)| *other == point) {
                let message = format!(
                    "`{}` is moved twice by one move; remove one",
                    name.get_ref()
                );
                return Err(self.source.refuse(&name.span(), message));
            }
            points.push((point, along));
        }
        Ok(Changes {
            points: with_markers(points, &self.file.followers(&self.mechanism.names.points)),
            ..Changes::default()
        })
    }

    fn direction(&self, stated: &Spanned<Direction>) -> Result<Vector3<f64>, Failure> {
        let vector = match stated.get_ref() {
            Direction::Axis(AxisName::X) => Axis::X.vector(),
            Direction::Axis(AxisName::Y) => Axis::Y.vector(),
            Direction::Axis(AxisName::Z) => Axis::Z.vector(),
            Direction::Vector(vector) => Vector3::from(*vector),
        };
        let unit = vector.try_normalize(f64::MIN_POSITIVE);
        let unit = unit.filter(|unit| unit.iter().all(|part| part.is_finite()));
        unit.ok_or_else(|| {
            let message = "a direction is finite and not zero";
            self.source.refuse(&stated.span(), message)
        })
    }

    fn point(&self, name: &Spanned<String>) -> Result<usize, Failure> {
        let known: Vec<&str> = self
            .mechanism
            .names
            .points
            .iter()
            .map(String::as_str)
            .collect();
        self.named("point", name, &known)
    }

    /// Lengths of links: those of bodies are between points, which move.
    fn length(&self, name: &Spanned<String>) -> Result<usize, Failure> {
        let statements = self.listing.statements().into_iter();
        let links = statements.filter(|statement| statement.kind == "link");
        let links: Vec<&str> = links.map(|link| link.name).collect();
        self.named("link", name, &links)?;
        let mut lengths = self.mechanism.names.lengths.iter();
        let length = lengths.position(|length| length == name.get_ref());
        length.ok_or_else(|| {
            let message = format!("link `{}` has no length of its own", name.get_ref());
            self.source.refuse(&name.span(), message)
        })
    }

    fn drive(&self, name: &Spanned<String>) -> Result<usize, Failure> {
        self.named("drive", name, &self.mechanism.names.of_drives())
    }

    fn named(&self, what: &str, name: &Spanned<String>, known: &[&str]) -> Result<usize, Failure> {
        let wanted = name.get_ref().as_str();
        let found = known.iter().position(|each| *each == wanted);
        found.ok_or_else(|| {
            let hint = did_you_mean(wanted, known.iter().copied());
            let known = known.join(", ");
            let message = format!("unknown {what} `{wanted}`; known are {known}{hint}");
            self.source.refuse(&name.span(), message)
        })
    }

    fn of_target(
        &self,
        name: &Spanned<String>,
        stated: &Spanned<TargetTable>,
    ) -> Result<Target, Failure> {
        let table = stated.get_ref();
        let column = self.column(&table.of)?;
        let per = table.per.as_ref().map(|per| self.drive(per)).transpose()?;
        if per.is_some() && !column.has_derivatives {
            let message = format!("`{}` has no derivatives", table.of.get_ref());
            return Err(self.source.refuse(&table.of.span(), message));
        }
        let reading = Reading { column, per };
        let scale = reading.in_file(self.mechanism);
        let within = *table.within.get_ref() / scale;
        if !(within.is_finite() && within > 0.0) {
            let message = "`within` is how far the target may be off: a positive number";
            return Err(self.source.refuse(&table.within.span(), message));
        }
        let (over, wanted) = self.wanted(name, table, scale)?;
        Ok(Target {
            name: name.get_ref().clone(),
            reading,
            over,
            wanted,
            within,
        })
    }

    fn column(&self, of: &Spanned<String>) -> Result<Column, Failure> {
        let mut columns = columns(self.mechanism);
        let names: Vec<String> = columns.iter().map(Column::title).collect();
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let wanted = of.get_ref();
        if catalogue().any(|quantity| quantity.name == wanted) && !names.contains(&&**wanted) {
            let message = format!(
                "there is no `{wanted}` of this mechanism: suspension motion --help says what it needs, the wheel's name before it, \
                 an axis behind it, or a line under [vehicle]"
            );
            return Err(self.source.refuse(&of.span(), message));
        }
        if let Some(name) = names
            .iter()
            .find(|name| wanted.starts_with(&format!("{name}_")))
        {
            let message =
                format!("unknown quantity `{wanted}`; did you mean `{name}`, without a unit?");
            return Err(self.source.refuse(&of.span(), message));
        }
        let found = self.named("quantity", of, &names)?;
        Ok(columns.swap_remove(found))
    }

    /// The axes over which a target is stated, and what is wanted at each of their places.
    fn wanted(
        &self,
        name: &Spanned<String>,
        table: &TargetTable,
        scale: f64,
    ) -> Result<(Vec<mechanism::Axis>, tune::Wanted), Failure> {
        let refuse = |message: &str| Err(self.source.refuse(&name.span(), message));
        let (stated, of): (_, fn(Vec<f64>) -> tune::Wanted) = match (&table.value, &table.change) {
            (Some(value), None) => (value, tune::Wanted::Values),
            (None, Some(_)) if table.over.is_none() => {
                return refuse(
                    "`change` is from the design position: say `over` which drives, as over = { bump = [-0.060, 0.060] }",
                );
            }
            (None, Some(change)) => (change, tune::Wanted::Changes),
            _ => {
                return refuse(
                    "a target has `value`, or `change`, which is from the design position",
                );
            }
        };
        let ends = table.over.as_ref().map(in_order).into_iter().flatten();
        let ends: Vec<_> = ends.collect();
        let (per_axis, wanted) = match stated.get_ref() {
            Wanted::Everywhere(wanted) => {
                let per_axis = PLACES;
                let places = per_axis.pow(u32::try_from(ends.len()).unwrap_or(u32::MAX));
                (per_axis, vec![*wanted; places])
            }
            Wanted::Each(wanted) if ends.len() == 1 && wanted.len() > 1 => {
                (wanted.len(), wanted.clone())
            }
            Wanted::Each(_) => {
                return refuse(
                    "a number for each place needs one drive under `over`, and two places",
                );
            }
        };
        if !wanted.iter().all(|wanted| wanted.is_finite()) {
            return Err(self
                .source
                .refuse(&stated.span(), "what is wanted is not finite"));
        }
        let axes = ends.into_iter().map(|(drive, ends)| {
            let number = self.drive(drive)?;
            let kind = self.mechanism.names.drives[number].kind;
            let per = self.mechanism.unit.per_drive(kind);
            let ends = self.ends(ends)?.map(|end| end / per);
            Ok(mechanism::Axis::of(number, evenly_spaced(ends, per_axis)))
        });
        let axes = axes.collect::<Result<_, Failure>>()?;
        Ok((
            axes,
            of(wanted.iter().map(|wanted| wanted / scale).collect()),
        ))
    }

    fn ends(&self, stated: &Spanned<[f64; 2]>) -> Result<[f64; 2], Failure> {
        let ends = *stated.get_ref();
        let is_range = ends[0] < ends[1] && ends.iter().all(|end| end.is_finite());
        is_range.then_some(ends).ok_or_else(|| {
            let message = "a drive goes [from, to], from the design position, as [-0.060, 0.060]";
            self.source.refuse(&stated.span(), message)
        })
    }
}
