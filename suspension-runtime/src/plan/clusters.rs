//! Points that links alone make a rigid body, as indices.

use suspension_listing::system::{self, System};

use super::LengthNames;
use super::places::point;
use crate::site::Site;

/// Points that links alone join to a rigid body.
#[derive(Clone, Debug)]
pub(crate) struct Cluster {
    pub(crate) frame: [Site; 3],
    /// The lengths of the frame's edges: first-second, first-third, second-third; `None` if both ends are on the
    /// chassis.
    pub(crate) edges: [Option<u16>; 3],
    pub(crate) points: Vec<Clustered>,
}

/// A point of a cluster that is not in its frame.
#[derive(Clone, Debug)]
pub(crate) struct Clustered {
    pub(crate) site: Site,
    /// Its index among all points.
    pub(crate) point: u16,
    /// The lengths to the frame's points; `None` if both ends are on the chassis.
    pub(crate) reaches: [Option<u16>; 3],
}

pub(super) fn clusters(system: &System, lengths: &LengthNames<'_>) -> Vec<Cluster> {
    let cluster = |cluster: &system::Body| {
        let clustered = |site: &system::Site| Clustered {
            site: Site::from(site),
            point: point(system, &site.name),
            reaches: (cluster.frame.each_ref()).map(|corner| lengths.kept_length([site, corner])),
        };
        Cluster {
            frame: cluster.frame.each_ref().map(Site::from),
            edges: cluster.frame_pairs().map(|ends| lengths.kept_length(ends)),
            points: cluster.carried.iter().map(clustered).collect(),
        }
    };
    system.clusters.iter().map(cluster).collect()
}
