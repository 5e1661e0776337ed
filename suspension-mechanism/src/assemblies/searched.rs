//! One part of a mechanism, with all assemblies of those before it.

use nalgebra::SVector;
use suspension_core::Listing;
use suspension_core::listing::{Kind, Part as Place, Parts};

use crate::assemblies::census::{PartTally, census};
use crate::assemblies::factors::Vector;
use crate::assemblies::family::{Drives, Family, Member};
use crate::assemblies::generic::Generic;
use crate::assemblies::limits::{MOST, Watch};
use crate::assemblies::parts::Part;
use crate::assemblies::random::Random;
use crate::assemblies::tilt::Plane;
use crate::mechanism::Suspension;

/// A part, and its results with general dimensions.
pub(crate) enum Searched<'a, G: Listing<N>, const N: usize> {
    /// Its equations are linear in its unknowns.
    Linear(Family<G, N>),
    /// All its assemblies.
    General {
        generic: Generic<'a, G, N>,
        /// The names of its points and other unknowns.
        unknowns: Vec<String>,
    },
}

impl<'a, G: Listing<N>, const N: usize> Searched<'a, G, N> {
    /// Searches the part with general dimensions, starting around `near`.
    pub(crate) fn new<L: Suspension<N, Listing = G>>(
        model: &L,
        part: Part,
        near: &SVector<f64, N>,
        drives: Drives<G, N>,
        mut random: Random,
        watch: &'a Watch<'a>,
    ) -> Self {
        let is_linear = part.is_linear;
        let unknowns = names(model, &part);
        let family = Family::new(model, part, &mut random);
        if is_linear {
            return Self::Linear(family);
        }
        Self::General {
            generic: Generic::new(family, near, drives, random, watch),
            unknowns,
        }
    }

    fn family(&self) -> &Family<G, N> {
        match self {
            Self::Linear(family) => family,
            Self::General { generic, .. } => &generic.family,
        }
    }

    /// The part put together with each assembly of those before it, and the outcome for the assemblies of a general
    /// mechanism; `None` if the search is given up.
    pub(crate) fn after(
        &mut self,
        before: &[Vector<N>],
        drives: Drives<G, N>,
    ) -> Option<(Vec<Vector<N>>, Option<PartTally>)> {
        let mut tally = self.tally();
        let mut found: Vec<(&Vector<N>, Vec<Vector<N>>)> = Vec::new();
        let mut longer = Vec::new();
        for assembly in before {
            if longer.len() > MOST {
                break;
            }
            let needed = &self.family().part.needed;
            let is_same = |other: &Vector<N>| {
                let mut needed = needed.iter();
                needed.all(|&[_, column]| other[column] == assembly[column])
            };
            let known = found.iter().position(|(other, _)| is_same(other));
            let place = match known {
                Some(place) => place,
                None => {
                    found.push((assembly, self.at(assembly, drives, &mut tally)?));
                    found.len() - 1
                }
            };
            let (_, roots) = &found[place];
            let part = &self.family().part;
            longer.extend(roots.iter().map(|root| part.put(root, *assembly)));
        }
        Some((longer, tally))
    }

    /// The part with one assembly of the parts before.
    fn at(
        &mut self,
        before: &Vector<N>,
        drives: Drives<G, N>,
        tally: &mut Option<PartTally>,
    ) -> Option<Vec<Vector<N>>> {
        let target = Member {
            fixed: self.family().own_fixed(),
            drives,
            right: self.family().part.right_hand_side(before),
            plane: Plane::default(),
        };
        match self {
            Self::Linear(family) => {
                let line = family.line(target, target);
                let correction = line.factors(before, 1.0).solve(&line.residual(before, 1.0));
                Some(correction.map(|x| before - x).into_iter().collect())
            }
            Self::General { generic, .. } => census(generic, target, tally.get_or_insert_default()),
        }
    }

    /// The tally before anything is followed; `None` if there is nothing to follow.
    fn tally(&self) -> Option<PartTally> {
        let Self::General { generic, unknowns } = self else {
            return None;
        };
        Some(PartTally {
            unknowns: unknowns.clone(),
            generic: generic.roots.len(),
            evidence: generic.evidence,
            ..PartTally::default()
        })
    }
}

/// The points of a part's unknowns, and the unknowns that are not coordinates.
fn names<L: Parts>(model: &L, part: &Part) -> Vec<String> {
    let [chassis, free] = [Kind::ChassisPoint, Kind::FreePoint].map(|kind| model.count(kind));
    let place = |column: usize| match column / 3 {
        point if point < free => Place::Point(chassis + point),
        _ => Place::Unknown(column),
    };
    let mut columns: Vec<usize> = part.columns().collect();
    columns.sort_unstable();
    let names = columns.into_iter().map(|column| model.name(place(column)));
    let mut names: Vec<String> = names.map(str::to_owned).collect();
    names.dedup();
    names
}
