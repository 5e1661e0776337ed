//! The constant lengths of a listing, in the order in which both back ends number them.

use super::{Body, System, pair_name};
use crate::name::{Name, Named};

/// A constant length.
#[derive(Clone, Debug)]
pub struct Length {
    pub named: Named,
    /// The points that it is between.
    pub between: [Name; 2],
}

impl System {
    /// The lengths of links, of bodies of two points, and of larger bodies: the frame's own, then
    /// from each carried point to the frame.
    pub fn lengths(&self) -> Vec<Length> {
        let equations = self.equations.iter();
        let kept = equations.filter_map(|equation| {
            let [from, to] = equation.form.equations().keeps()?;
            let named = equation.named.clone();
            let between = [from, to].map(|site| site.name.clone());
            Some(Length { named, between })
        });
        let of_bodies: Vec<Length> = self.bodies.iter().flat_map(lengths_of_body).collect();
        let of_links = kept.filter(|kept| {
            let mut others = of_bodies.iter();
            !others.any(|other| other.named.name == kept.named.name)
        });
        let of_links: Vec<Length> = of_links.collect();
        of_links.into_iter().chain(of_bodies).collect()
    }
}

fn lengths_of_body(body: &Body) -> Vec<Length> {
    let edges = body.frame_pairs().into_iter();
    let edges = edges.filter(|[a, b]| a.is_free() || b.is_free());
    let carried = body.carried.iter();
    let reaches = carried.flat_map(|point| body.frame.iter().map(move |corner| [point, corner]));
    let length = |[a, b]: [&super::Site; 2]| Length {
        named: Named {
            name: pair_name(&body.name, &a.name, &b.name),
            docs: Vec::new(),
        },
        between: [a.name.clone(), b.name.clone()],
    };
    edges.chain(reaches).map(length).collect()
}
