//! What the equations leave free at the design position, and what they hold more than once.

use crate::kind::Kind;
use crate::name::Name;
use crate::sample::{self, MOST_SAMPLED};
use crate::system::{Body, Site, System};

/// The most names of a list in a message.
const MOST_NAMED: usize = 8;

/// Squares of parts of a unit vector: smaller ones are due to rounding.
const ROUNDING: f64 = 1e-12;

/// A name is listed if its share is at least this part of the largest one.
const SMALLEST: f64 = 2.5e-3;

/// What the equations leave free, and what they hold more than once; nothing of either by default.
#[derive(Default)]
pub(super) struct Freedom<'s> {
    /// Statements of which some are redundant.
    redundant: Vec<&'s Name>,
    /// The number of redundant equations.
    excess: usize,
    /// Points that can move, those that move farthest first.
    loose: Vec<&'s Name>,
    /// A body that can turn about the line through two of its points, and these points.
    turning: Option<(&'s Body, [&'s Name; 2])>,
}

impl<'s> Freedom<'s> {
    /// The freedom at the design position; `None` if the listing does not state all of it, if its geometry is degenerate, or
    /// beyond [`MOST_SAMPLED`], where this takes too long.
    pub(super) fn at_design(system: &'s System) -> Option<Self> {
        if system.size() > MOST_SAMPLED {
            return None;
        }
        let entries = sample::entries(system, &[system.design()?]);
        let (rows, columns) = (system.rows().len(), system.size());
        let mut by_row = vec![vec![0.0; columns]; rows];
        let mut by_column = vec![vec![0.0; rows]; columns];
        for entry in &entries {
            let value = entry.values.first()?;
            by_row[entry.row][entry.column] += value;
            by_column[entry.column][entry.row] += value;
        }
        let (free, _) = shares_outside(by_row, columns);
        let (redundant, rank) = shares_outside(by_column, rows);
        let moves = |point: usize| free[3 * point..3 * point + 3].iter().sum::<f64>();
        let points = system.free.iter().enumerate();
        let loose = points.map(|(point, stated)| (&stated.named.name, moves(point)));
        Some(Self {
            redundant: redundant_statements(system, &redundant),
            excess: rows - rank,
            loose: largest(loose.collect()),
            turning: turning(system, &moves),
        })
    }

    /// The statements of which some are redundant, as the continuation of a message; empty if there are none.
    pub(super) fn redundant(&self) -> String {
        let are = match self.excess {
            0 => return String::new(),
            1 => "one of these is".to_owned(),
            excess => format!("{excess} of these are"),
        };
        let names = listed(&self.redundant);
        format!("; at the design position {are} redundant: {names}")
    }

    /// What can still move, as the continuation of a message; empty if nothing can.
    pub(super) fn loose(&self) -> String {
        match (&self.turning, &self.loose[..]) {
            (Some((body, [first, second])), _) => format!(
                "; body `{}` can rotate about the line through `{first}` and `{second}`: an `angle` or a `plane` for another of \
                 its points prevents that",
                body.name
            ),
            (None, []) => String::new(),
            (None, loose) => format!(
                "; at the design position these points can still move: {}",
                listed(loose)
            ),
        }
    }
}

/// The statements in a dependence of equations, from the share of each equation: those that can be removed alone.
fn redundant_statements<'s>(system: &'s System, shares: &[f64]) -> Vec<&'s Name> {
    let mut of_statements: Vec<(&Name, f64)> = Vec::new();
    let mut shares = shares.iter();
    for equation in &system.equations {
        let share: f64 = shares.by_ref().take(equation.rows().len()).sum();
        let origin = &equation.origin;
        let is_rigid = [Kind::BODY, Kind::HINGE].contains(&origin.kind);
        let share = if is_rigid { 0.0 } else { share };
        match of_statements
            .iter_mut()
            .find(|(name, _)| **name == origin.statement)
        {
            Some((_, sum)) => *sum += share,
            None => of_statements.push((&origin.statement, share)),
        }
    }
    largest(of_statements)
}

/// The first body that can turn about the line through two of its points, which are at rest.
fn turning<'s>(
    system: &'s System,
    moves: &impl Fn(usize) -> f64,
) -> Option<(&'s Body, [&'s Name; 2])> {
    system.bodies.iter().find_map(|body| {
        let is_at_rest = |site: &&Site| !site.is_free() || moves(site.index) < ROUNDING;
        let at_rest: Vec<_> = body.points().filter(is_at_rest).collect();
        let [first, second] = at_rest[..] else {
            return None;
        };
        let is_hinge = !first.is_free() && !second.is_free();
        (!is_hinge).then_some((body, [&first.name, &second.name]))
    })
}

/// The names with the largest shares, in the order of their shares.
fn largest(mut shares: Vec<(&Name, f64)>) -> Vec<&Name> {
    shares.sort_by(|(_, one), (_, other)| other.total_cmp(one));
    let most = shares.first().map_or(0.0, |(_, share)| *share);
    let least = ROUNDING.max(SMALLEST * most);
    let large = shares.into_iter().take_while(|(_, share)| *share > least);
    large.map(|(name, _)| name).collect()
}

/// Names in words.
fn listed(names: &[&Name]) -> String {
    let (named, others) = names.split_at(names.len().min(MOST_NAMED));
    let named: Vec<String> = named.iter().map(|name| format!("`{name}`")).collect();
    let others = match others.len() {
        0 => String::new(),
        count => format!(" and {count} more"),
    };
    format!("{}{others}", named.join(", "))
}

/// For each coordinate of a space the square of the part of its unit vector outside of the span of some vectors, and the
/// dimension of this span: the vectors are made orthonormal, the longest that is left first.
fn shares_outside(mut vectors: Vec<Vec<f64>>, size: usize) -> (Vec<f64>, usize) {
    /// The length of a remainder that counts as zero.
    const ZERO: f64 = 1e-9;
    let mut shares = vec![1.0; size];
    let mut dimension = 0;
    let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    loop {
        let squares = vectors.iter().map(|vector| product(vector, vector));
        let longest = squares.enumerate().max_by(|(_, a), (_, b)| a.total_cmp(b));
        let Some((index, square)) = longest.filter(|(_, square)| *square > ZERO * ZERO) else {
            return (shares, dimension);
        };
        let unit = vectors.swap_remove(index);
        let unit: Vec<f64> = unit.iter().map(|x| x / square.sqrt()).collect();
        for vector in &mut vectors {
            let along = product(vector, &unit);
            for (x, of_unit) in vector.iter_mut().zip(&unit) {
                *x -= along * of_unit;
            }
        }
        for (share, x) in shares.iter_mut().zip(&unit) {
            *share -= x * x;
        }
        dimension += 1;
    }
}
