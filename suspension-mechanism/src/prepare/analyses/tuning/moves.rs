//! The points and lengths that a motion file lets `suspension tune` move.

use nalgebra::Vector3;
use toml::Spanned;

use crate::failure::Failure;
use crate::file::{AxisName, Direction, MoveTable, NumberList};
use crate::kinematics::Changes;
use crate::prepare::analyses::tuning::named_parts::Naming;
use crate::quantities::Axis;
use crate::tune::Move;

/// The parts that moves name.
pub(crate) struct Moves<'a> {
    pub(crate) naming: Naming<'a>,
    /// Markers that are stated off another point, each with that point.
    pub(crate) followers: Vec<[usize; 2]>,
    /// The y coordinate of each point in the design position.
    pub(crate) across: Vec<f64>,
}

impl Moves<'_> {
    pub(crate) fn read_move(
        &self,
        name: &Spanned<String>,
        stated: &Spanned<MoveTable>,
    ) -> Result<Move, Failure> {
        let table = stated.get_ref();
        let NumberList(by) = *table.by.get_ref();
        if !(by[0] < by[1] && by.iter().all(|end| end.is_finite())) {
            let example = self.naming.example(0.01);
            let message = format!(
                "`by` is [least, greatest], the box of the move in the file's unit, for example {example}"
            );
            return Err(self.naming.source.refuse(&table.by.span(), message));
        }
        let has_points = !table.points.is_empty();
        if let (Some(length), Some(along)) = (&table.length, &table.along) {
            let message = format!(
                "`along` is for points; the length of link `{}` changes along the link: leave `along` out",
                length.get_ref()
            );
            return Err(self.naming.source.refuse(&along.span(), message));
        }
        let per_unit = match (&table.length, has_points) {
            (Some(length), false) => self.lengthen_links(length, &table.mirrored)?,
            (None, _) if has_points || !table.mirrored.is_empty() => {
                self.displace_points(name, table)?
            }
            _ => {
                let message = "a move has `points` with `along`, or `length`, the name of a link; `mirrored` names points beside `points` and links beside `length`";
                return Err(self.naming.source.refuse(&name.span(), message));
            }
        };
        Ok(Move {
            name: name.get_ref().clone(),
            per_unit,
            by,
        })
    }

    /// A link, and those of the other side that become longer by the same amount.
    fn lengthen_links(
        &self,
        length: &Spanned<String>,
        mirrored: &[Spanned<String>],
    ) -> Result<Changes, Failure> {
        let mut lengths: Vec<(usize, f64)> = Vec::new();
        for name in [length].into_iter().chain(mirrored) {
            let link = self.length(name)?;
            if lengths.iter().any(|(other, _)| *other == link) {
                return Err(self.refuse_repeated(name));
            }
            lengths.push((link, 1.0));
        }
        Ok(Changes {
            lengths,
            ..Changes::default()
        })
    }

    fn refuse_repeated(&self, name: &Spanned<String>) -> Failure {
        let message = format!(
            "`{}` is moved twice by one move; remove one",
            name.get_ref()
        );
        self.naming.source.refuse(&name.span(), message)
    }

    fn displace_points(
        &self,
        name: &Spanned<String>,
        table: &MoveTable,
    ) -> Result<Changes, Failure> {
        let Some(along) = &table.along else {
            let message = "`along` is missing: write \"x\", \"y\", \"z\" or a direction [x, y, z]";
            return Err(self.naming.source.refuse(&name.span(), message));
        };
        let along = self.direction(along)?;
        let mirrored = Vector3::new(along.x, -along.y, along.z);
        let ways = [(&table.points, along), (&table.mirrored, mirrored)];
        let each = ways
            .into_iter()
            .flat_map(|(points, along)| points.iter().map(move |point| (point, along)));
        let mut points: Vec<(usize, Vector3<f64>)> = Vec::new();
        for (name, along) in each {
            let point = self.naming.point(name)?;
            if points.iter().any(|(other, _)| *other == point) {
                return Err(self.refuse_repeated(name));
            }
            points.push((point, along));
        }
        self.check_sides(table)?;
        Ok(Changes {
            points: with_markers(points, &self.followers),
            ..Changes::default()
        })
    }

    /// Refuses a mirrored point on the same side as a point that it goes with.
    fn check_sides(&self, table: &MoveTable) -> Result<(), Failure> {
        let side = |name: &Spanned<String>| {
            let across = self.across[self.naming.point(name)?];
            Ok::<f64, Failure>(if across == 0.0 { 0.0 } else { across.signum() })
        };
        for mirrored in &table.mirrored {
            for point in &table.points {
                if side(mirrored)? * side(point)? > 0.0 {
                    let (mirrored_name, point) = (mirrored.get_ref(), point.get_ref());
                    let message = format!(
                        "`{mirrored_name}` is on the side of the vehicle that `{point}` is on; `mirrored` names the points of the other side, \
                         which move as in a mirror, and `points` those that move alike"
                    );
                    return Err(self.naming.source.refuse(&mirrored.span(), message));
                }
            }
        }
        Ok(())
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
            let message = "a direction must be finite and not zero";
            self.naming.source.refuse(&stated.span(), message)
        })
    }

    /// The length of a link: those of bodies are between points, which move.
    fn length(&self, name: &Spanned<String>) -> Result<usize, Failure> {
        let names = &self.naming.mechanism.names;
        let known: Vec<&str> = names.links().map(|(link, _)| link).collect();
        let link = self.naming.named("link", name, &known)?;
        Ok(names.links[link])
    }
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
