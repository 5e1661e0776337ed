//! Sample designs for a listing that states no positions; the choice of pivots uses them.
//!
//! They resemble typical corners of vehicles, x forward, y left and z up: the fewer joints there are between a point and
//! the wheel, the farther out it lies. Hinges are parallel to axes and coordinates are round
//! numbers, so that links are square to axes and arms are symmetric.

use std::collections::BTreeMap;

use super::MOST_SAMPLED;
use super::path::rates;
use crate::name::Name;
use crate::random::Lcg;
use crate::system::{Point, Positions, Site, System};
use crate::vector::Vector;

/// The number of designs, and the number tried to find them.
const DESIGNS: usize = 256;
const TRIALS: usize = 1024;

/// The best of twelve seeds for symmetric double wishbones, with and without rocker.
const SEED: u64 = 2;

/// A design with a smaller pivot than this, even with partial pivoting, is not one that an engineer would draw: it is
/// near a singularity.
const SMALLEST_PIVOT: f64 = 0.05;

/// Coordinates are multiples of this.
const GRID: f64 = 0.05;

/// Designs that may be meant; none for a system that is too large.
pub fn likely(system: &System) -> Vec<Positions> {
    if system.size() > MOST_SAMPLED {
        return Vec::new();
    }
    let (outwards, hinges, places) = (outwards(system), hinges(system), system.places());
    let mut random = Lcg::new(SEED);
    let trials = (0..TRIALS).map(|_| design(system, &outwards, &hinges, &mut random));
    let regular = |design: &Positions| rates(system, &places, design, 0, SMALLEST_PIVOT).is_some();
    trials.filter(regular).take(DESIGNS).collect()
}

/// A design, which may be singular.
fn design(
    system: &System,
    outwards: &[(&Name, f64)],
    hinges: &[(&Name, [&Name; 2])],
    random: &mut Lcg,
) -> Positions {
    let mut at: BTreeMap<&Name, Vector> = outwards
        .iter()
        .map(|(name, outwards)| (*name, point(*outwards, random)))
        .collect();
    let kingpins = system
        .wheels
        .iter()
        .filter_map(|wheel| wheel.kingpin.as_ref());
    for [low, high] in kingpins {
        // A marker gets its position from its body.
        let Some(&low) = at.get(low) else {
            continue;
        };
        at.entry(high).and_modify(|high| high[2] = low[2] + 0.3);
    }
    for (point, [from, to]) in hinges {
        let [end, place] = hinged(at[from], at[point], random);
        at.insert(to, end);
        at.insert(point, place);
    }
    let places = |points: &[Point]| points.iter().map(|point| at[&point.named.name]).collect();
    system.positions(places(&system.fixed), places(&system.free))
}

/// The other end of a hinge that starts at a position, and the position of the point that turns about it, usually
/// beside the middle or an end.
fn hinged(start: Vector, mut point: Vector, random: &mut Lcg) -> [Vector; 2] {
    let axis = random.pick([0, 0, 0, 1, 2]);
    let mut end = start;
    end[axis] += 0.2;
    if let Some(beside) = random.pick([Some(0.1), Some(0.0), Some(0.2), None, None, None]) {
        point[axis] = start[axis] + beside;
    }
    // An arm across the vehicle already points outwards.
    if axis == 1 {
        point[0] = start[0] + random.pick([-0.2, 0.2]);
    }
    [end, point]
}

/// A position for a point, from the chassis at 0 to the wheel at 1.
fn point(outwards: f64, random: &mut Lcg) -> Vector {
    let across = (0.3 + 0.4 * outwards) / GRID;
    let across = across.round() + random.pick([-1.0, 0.0, 1.0]);
    let along = random.pick([-4.0, -2.0, 0.0, 2.0, 4.0]);
    let up = random.pick([0.0, 2.0, 4.0, 6.0, 8.0]);
    [along, across, up].map(|steps| steps * GRID)
}

/// How far out each point is, from the chassis at 0 to the wheel at 1, according to the joints in between.
fn outwards(system: &System) -> Vec<(&Name, f64)> {
    let chassis = system.fixed.iter().map(|point| &point.named.name);
    let chassis = reached(system, chassis.map(|name| (name, 0)).collect());
    let carrier = system.wheels.iter().flat_map(|wheel| &wheel.carrier);
    let wheel = reached(system, carrier.map(|name| (name, 0)).collect());
    let points = system.fixed.iter().chain(&system.free);
    let share = |name: &Name| {
        let [from, to] = [&chassis, &wheel].map(|joints| joints.get(name).copied());
        let (from, to) = (from.unwrap_or(0) as f64, to.unwrap_or(0) as f64);
        if from > 0.0 { from / (from + to) } else { 0.0 }
    };
    let names = points.map(|point| &point.named.name);
    names.map(|name| (name, share(name))).collect()
}

/// The number of joints by which each point is reached from the given ones.
fn reached<'a>(
    system: &'a System,
    mut joints: BTreeMap<&'a Name, usize>,
) -> BTreeMap<&'a Name, usize> {
    let bodies = system.bodies.iter().map(|body| body.points().collect());
    let equations = system.equations.iter();
    let equations = equations.map(|equation| equation.form.equations().sites());
    let joined: Vec<Vec<&Site>> = bodies.chain(equations).collect();
    for step in 1.. {
        let is_reached = |site: &&Site| joints.contains_key(&site.name);
        let next = joined.iter().filter(|sites| sites.iter().any(is_reached));
        let next = next.flatten().filter(|site| !is_reached(site));
        let next: Vec<&Name> = next.map(|site| &site.name).collect();
        if next.is_empty() {
            break;
        }
        joints.extend(next.into_iter().map(|name| (name, step)));
    }
    joints
}

/// The free points that are held at two chassis points, with these two points: the free points turn about the line
/// through them.
fn hinges(system: &System) -> Vec<(&Name, [&Name; 2])> {
    let kept = || {
        let equations = system.equations.iter();
        equations.filter_map(|equation| equation.form.equations().keeps())
    };
    let hinge = |point: &'_ Point| {
        let chassis = kept().filter_map(|[a, b]| {
            let [chassis, free] = if a.is_free() { [b, a] } else { [a, b] };
            (!chassis.is_free() && free.name == point.named.name).then_some(&chassis.name)
        });
        chassis.take(2).collect::<Vec<_>>().try_into().ok()
    };
    let hinges = system.free.iter();
    let hinges = hinges.filter_map(|point| Some((&point.named.name, hinge(point)?)));
    hinges.collect()
}
