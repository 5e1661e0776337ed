//! What is read off the points, and how drives enter, as indices.

use syn::Ident;

use suspension_listing::system::{self, Measured, System, distance_between};

use super::{Sites, index, position};

/// How a drive enters.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Drive {
    pub(crate) axis: u16,
    /// Points.
    pub(crate) of: u16,
    pub(crate) minus: Option<u16>,
    /// The distance whose angle it is.
    pub(crate) angle_of: Option<u16>,
    /// The chassis point that it moves.
    pub(crate) moves: Option<u16>,
}

/// What a measure reads, by points.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Measure {
    Coordinate {
        axis: u16,
        of: u16,
        minus: Option<u16>,
    },
    Angle {
        axis: u16,
        line: [u16; 2],
    },
    Length {
        line: [u16; 2],
    },
}

/// Points that links alone make a rigid body, by sites.
#[derive(Clone, Debug)]
pub(crate) struct Cluster {
    pub(crate) frame: [u16; 3],
    pub(crate) points: Vec<u16>,
    /// The distances that keep the frame: first-second, first-third, second-third; none where both ends
    /// are on the chassis.
    pub(crate) edges: [Option<u16>; 3],
    /// Those that keep each point to the frame's.
    pub(crate) reaches: Vec<[Option<u16>; 3]>,
}

/// Where a point is among all: chassis points, free points, markers.
fn point(system: &System, name: &Ident) -> u16 {
    let points = system.fixed.iter().chain(&system.free);
    let markers = system.markers.iter().map(|marker| &marker.named);
    position(points.chain(markers).map(|point| &point.name), name)
}

fn distance(system: &System, name: &Ident) -> u16 {
    let mut names = system.equations.iter().filter_map(|equation| match equation {
        system::Equation::Distance { named, .. } => Some(&named.name),
        _ => None,
    });
    names.position(|other| other == name).map_or(u16::MAX, index)
}

pub(super) fn drives(system: &System) -> Vec<Drive> {
    let drive = |drive: &system::Drive| Drive {
        axis: index(drive.axis),
        of: point(system, &drive.of.name),
        minus: drive.minus.as_ref().map(|minus| point(system, minus)),
        angle_of: drive.angle_of.as_ref().map(|name| distance(system, name)),
        moves: (!drive.of.is_free() && drive.minus.is_none())
            .then(|| position(system.fixed.iter().map(|fixed| &fixed.name), &drive.of.name)),
    };
    system.drives.iter().map(drive).collect()
}

pub(super) fn measures(system: &System) -> Vec<Measure> {
    let point = |name: &Ident| point(system, name);
    let measure = |measure: &system::Measure| match &measure.measured {
        Measured::Coordinate { axis, of, minus } => Measure::Coordinate {
            axis: index(*axis),
            of: point(of),
            minus: minus.as_ref().map(point),
        },
        Measured::Angle { axis, line } => Measure::Angle {
            axis: index(*axis),
            line: line.each_ref().map(point),
        },
        Measured::Length { line } => Measure::Length {
            line: line.each_ref().map(point),
        },
    };
    system.measures.iter().map(measure).collect()
}

pub(super) fn markers(system: &System, sites: &Sites<'_>) -> Vec<[u16; 3]> {
    let markers = system.markers.iter();
    markers.map(|marker| marker.frame.each_ref().map(|site| sites.index(site))).collect()
}

pub(super) fn clusters(system: &System, sites: &Sites<'_>) -> Vec<Cluster> {
    let between = |a: &system::Site, b: &system::Site| {
        distance_between(&system.equations, &a.name, &b.name).map(|name| distance(system, &name))
    };
    let cluster = |cluster: &system::Body| Cluster {
        frame: cluster.frame.each_ref().map(|site| sites.index(site)),
        points: cluster.carried.iter().map(|site| sites.index(site)).collect(),
        edges: cluster.frame_pairs().map(|[a, b]| between(a, b)),
        reaches: (cluster.carried.iter())
            .map(|point| cluster.frame.each_ref().map(|corner| between(point, corner)))
            .collect(),
    };
    system.clusters.iter().map(cluster).collect()
}
