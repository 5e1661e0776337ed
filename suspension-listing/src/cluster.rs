//! Points that links alone make a rigid body: a triangle of lengths, and further points with a
//! length to each of its corners. Three distances leave such a point free to be mirrored in the triangle.

use std::collections::BTreeSet;

use crate::name::Name;
use crate::system::{Body, Equation, Site, SiteMotion, distance_between};

/// The clusters among the sites. Any four points belong to at most one of them.
pub fn clusters(sites: &[Site], equations: &[Equation]) -> Vec<Body> {
    let mut clusters = Vec::new();
    let mut seen = BTreeSet::new();
    for frame in triangles(sites, equations) {
        let reached = sites.iter().filter(|site| {
            let is_corner = frame.iter().any(|corner| corner.name == site.name);
            let mut corners = frame.iter();
            site.is_free() && !is_corner && corners.all(|corner| is_rigid(site, corner, equations))
        });
        let carried: Vec<Site> = reached
            .filter(|site| {
                let four = frame.iter().chain([*site]);
                seen.insert(four.map(|site| site.name.clone()).collect::<BTreeSet<_>>())
            })
            .cloned()
            .collect();
        if !carried.is_empty() {
            clusters.push(Body {
                name: name(&frame),
                frame,
                carried,
            });
        }
    }
    clusters
}

/// Three sites with rigid distances between them; not all on the chassis.
fn triangles(sites: &[Site], equations: &[Equation]) -> Vec<[Site; 3]> {
    let mut triangles = Vec::new();
    for (third, c) in sites.iter().enumerate() {
        let before: Vec<&Site> = sites[..third]
            .iter()
            .filter(|site| is_rigid(site, c, equations))
            .collect();
        for (second, b) in before.iter().enumerate() {
            for a in &before[..second] {
                if c.is_free() && is_rigid(a, b, equations) {
                    triangles.push([(*a).clone(), (*b).clone(), c.clone()]);
                }
            }
        }
    }
    triangles
}

/// Whether the distance between two sites never changes.
fn is_rigid(a: &Site, b: &Site, equations: &[Equation]) -> bool {
    let is_anchor = |site: &Site| site.motion == SiteMotion::Anchor;
    is_anchor(a) && is_anchor(b) || distance_between(equations, &a.name, &b.name).is_some()
}

fn name([a, b, c]: &[Site; 3]) -> Name {
    Name::made(format!("{}_{}_{}", a.name, b.name, c.name))
}
